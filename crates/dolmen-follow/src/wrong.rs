//! Why records cannot be followed, in both languages.

use dolmen_report::kept::store_fault;
use dolmen_store::StoreError;
use dolmen_words::message::{Argument, Both};
use dolmen_words::{Sentence, Template, messages, sayable, sentences};
use std::error::Error;

/// Why records cannot be followed, or the program for an alarm fails.
#[derive(Debug)]
#[allow(missing_docs, reason = "the sentence says what it is")]
pub enum FollowError {
    Store {
        fault: Both,
    },
    ProgramFailed {
        program: String,
        structure: String,
        status: String,
    },
    NoProgram {
        program: String,
        why: std::io::Error,
    },
    CallsFailed {
        each: Vec<Sentence>,
    },
    TooManyOfOneSecond {
        survey: String,
        most: usize,
    },
    WhichStructure {
        count: usize,
        first: Vec<String>,
    },
}

sentences! {
    FollowError in "follow.error" {
        Store { fault } => { en: "{fault}", ko: "{fault}" },
        ProgramFailed { program, structure, status } => {
            en: "--on-alarm {program} ended with {status} for {structure}",
            ko: "--on-alarm {program}이(가) {structure}에 대해 실패하였다({status})",
        },
        NoProgram { program } => {
            en: "--on-alarm {program} could not be run; it is a program, not a line of a shell",
            ko: "--on-alarm {program}을(를) 실행할 수 없다. 셸 명령줄이 아니라 프로그램 하나를 준다",
        },
        CallsFailed { each } as { each: each.clone() } => {
            en: "{each}",
            ko: "{each}",
        },
        TooManyOfOneSecond { survey, most } => {
            en: "more than {most} different records began at {survey}: the clock of the logger stands still, or files of other loggers come into the folder",
            ko: "{survey}에 시작한 서로 다른 기록이 {most}개를 넘는다. 기록계의 시계가 멈추었거나 다른 기록계의 파일이 폴더에 들어온다",
        },
        WhichStructure { count, first } as { count, first: first.join(", ") } => {
            en: "--follow takes the records of one structure, and the store has {count} ({first}): name one with --structure, or store its project first with `dolmen survey add`",
            ko: "--follow는 구조물 하나의 기록을 받는데 저장소에 구조물이 {count}기 있다({first}). --structure로 하나를 지정하거나 `dolmen survey add`로 프로젝트를 먼저 저장한다",
        },
    }
    caused by { NoProgram: why }
}

messages! {
    /// Remarks on a file.
    pub(crate) enum Said in "follow.said" {
        OwnFault => {
            en: "this is a fault of Dolmen, not of the file: please report it with the file",
            ko: "파일이 아니라 Dolmen의 결함이다. 이 파일과 함께 알려 주기 바란다",
        },
    }
}

/// A fault of a store.
pub(crate) fn store_failure(fault: StoreError) -> anyhow::Error {
    FollowError::Store {
        fault: store_fault(&fault.fault()).into(),
    }
    .into()
}

/// The sentence for an error of this crate, of folders or of the store.
pub fn of_following<'e>(error: &'e (dyn Error + 'static)) -> Option<&'e dyn Argument> {
    sayable!(error, FollowError).or_else(|| dolmen_folder::of_folders(error))
}

/// Templates of all sentences.
pub const ERRORS: [&[Template]; 2] = [FollowError::TEMPLATES, Said::TEMPLATES];
