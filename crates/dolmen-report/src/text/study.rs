//! A study, as text.

use crate::document::{TextStyle, document_text, findings_text};
use crate::study::{findings, tables};
use dolmen_work::study::StudyAnswer;

/// The text of a study.
pub fn study_text(answer: &StudyAnswer, style: TextStyle) -> String {
    let name = style.language.pick(answer.name.english(), answer.name.korean());
    let found = findings(answer);
    let said = found.iter().filter(|finding| style.is_full || finding.is_key);
    let mut out = format!("{name}\n  {} [{}]\n", answer.file, answer.study.name);
    let said = findings_text(said, style);
    if !said.is_empty() {
        out += &("\n".to_owned() + &said);
    }
    if style.is_full {
        out += &document_text(&tables(answer), style);
    }
    out
}
