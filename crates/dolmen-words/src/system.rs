//! Errors of the operating system about a file, in both languages.

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
        LongName => { en: "its name is too long or not allowed", ko: "이름이 너무 길거나 쓸 수 없는 이름이다" },
        NoMemory => { en: "the memory does not suffice", ko: "메모리가 모자란다" },
        EndsEarly => { en: "it ends too early", ko: "파일이 도중에 끝난다" },
        TimedOut => { en: "no answer came in time", ko: "제때 응답이 없다" },
        Numbered { number: i32 } => { en: "error {number} of the system", ko: "시스템 오류 {number}번" },
    }
}

/// Templates of all sentences of this file.
pub const SYSTEM: &[crate::Template] = Refusal::TEMPLATES;

/// The system's error: its own text in English; in Korean its meaning, if known.
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
        ErrorKind::InvalidFilename => Refusal::LongName,
        ErrorKind::OutOfMemory => Refusal::NoMemory,
        ErrorKind::UnexpectedEof => Refusal::EndsEarly,
        ErrorKind::TimedOut => Refusal::TimedOut,
        _ => match error.raw_os_error() {
            Some(number) => Refusal::Numbered { number },
            // the text of a library
            None => return Both::from(error.to_string()),
        },
    };
    Both {
        english: error.to_string(),
        korean: Both::from(refusal).korean,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_no_english_of_the_system_stands_in_korean() {
        // error numbers of Linux: Input/output error, Too many levels of symbolic links, File name too long, No space left on
        // device
        for (number, korean) in [
            (5, "시스템 오류 5번"),
            (40, "시스템 오류 40번"),
            (36, "이름이 너무 길거나 쓸 수 없는 이름이다"),
            (28, "디스크가 가득 찼다"),
            (30, "읽기 전용 디스크이다"),
            (13, "권한이 없다"),
            (2, "그런 파일이나 폴더가 없다"),
        ] {
            let error = Error::from_raw_os_error(number);
            let said = said_by_system(&error);
            if cfg!(target_os = "linux") {
                assert_eq!(said.korean, korean);
            }
            assert_eq!(said.english, error.to_string());
        }
        let own = said_by_system(&Error::other("expected `,` or `]`"));
        assert_eq!(own.korean, own.english);
    }
}
