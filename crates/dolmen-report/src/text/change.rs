//! `dolmen compare` as text.

use crate::brief::notes_text;
use crate::change::{findings, sections, undated};
use crate::check::{made_up_text, project_text};
use crate::document::{Finding, TextStyle, document_text, findings_text};
use dolmen_work::answer::CompareAnswer;

/// The change between two surveys.
pub fn change_text(answer: &CompareAnswer, style: TextStyle) -> String {
    let project = &answer.project;
    let mut found: Vec<Finding> = undated(answer).into_iter().collect();
    found.extend(findings(answer));
    let said = found.iter().filter(|finding| style.is_full || finding.is_key);
    let mut out = project_text(project, &answer.file, style)
        + &made_up_text(project, style)
        + "\n"
        + &findings_text(said, style);
    if style.is_full {
        out += &document_text(&sections(answer), style);
    }
    match style.is_full {
        true => out + &notes_text(project, style),
        false => out,
    }
}
