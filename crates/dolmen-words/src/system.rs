//! What the operating system says of a file, in both languages.

use crate::message::Both;
use crate::messages;
use std::io::{Error, ErrorKind};

messages! {
    /// Why the system refuses a file.
    pub(crate) enum Refusal in "system" {
        NotFound => { en: "there is no such file or folder", ko: "그런 파일이나 폴더가 없다" },
        NotPermitted => { en: "it is not permitted", ko: "권한이 없다" },
        Exists => { en: "it is there already", ko: "이미 있다" },
        IsFolder => { en: "it is a folder", ko: "폴더이다" },
        NotFolder => { en: "a part of its path is no folder", ko: "경로의 일부가 폴더가 아니다" },
        DiskFull => { en: "the disk is full", ko: "디스크가 가득 찼다" },
        TooLarge => { en: "the file becomes too large", ko: "파일이 너무 커진다" },
        ReadOnly => { en: "the disk may only be read", ko: "읽기 전용 디스크이다" },
        Busy => { en: "another program uses it", ko: "다른 프로그램이 쓰고 있다" },
    }
}

/// All sentences of this file.
pub const SYSTEM: &[crate::Template] = Refusal::TEMPLATES;

/// What the system says, in its own words in English; in Korean what it means, where that is known.
pub fn said_by_system(error: &Error) -> Both {
    let refusal = match error.kind() {
        ErrorKind::NotFound => Refusal::NotFound,
        ErrorKind::PermissionDenied => Refusal::NotPermitted,
        ErrorKind::AlreadyExists => Refusal::Exists,
        ErrorKind::IsADirectory => Refusal::IsFolder,
        ErrorKind::NotADirectory => Refusal::NotFolder,
        ErrorKind::StorageFull | ErrorKind::QuotaExceeded => Refusal::DiskFull,
        ErrorKind::FileTooLarge => Refusal::TooLarge,
        ErrorKind::ReadOnlyFilesystem => Refusal::ReadOnly,
        ErrorKind::ResourceBusy | ErrorKind::WouldBlock => Refusal::Busy,
        _ => return Both::from(error.to_string()),
    };
    Both {
        english: error.to_string(),
        korean: Both::from(refusal).korean,
    }
}
