//! The frame of an error: the words around the problem.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// The words around a problem of a project file.
    pub(crate) enum Framed in "project.error" {
        Error(message: Both) => { en: "error: {message}", ko: "오류: {message}" },
        Help(help: Both) => { en: "help: {help}", ko: "도움말: {help}" },
        OneMore => { en: "and 1 problem more", ko: "이 밖에 오류 1건이 더 있다" },
        More(count: usize) => { en: "and {count} problems more", ko: "이 밖에 오류 {count}건이 더 있다" },
        InCell { message: Both, file: String, cell: String } => {
            en: "{message} ({file}, cell {cell})",
            ko: "{message} ({file}, {cell} 셀)",
        },
        InVariant { variant: String, message: Both } => {
            en: "in variant \"{variant}\": {message}",
            ko: "대안 \"{variant}\": {message}",
        },
    }
}
