//! `dolmen compare` as text.

use crate::brief::notes_text;
use crate::change::{findings, sections, undated};
use crate::check::project_text;
use crate::document::{Finding, TextStyle, document_text, findings_text};
use dolmen::assess::SurveyChange;
use dolmen_project::Project;

/// What changed from one survey to another.
pub fn change_text(project: &Project, file: &str, change: &SurveyChange, style: TextStyle) -> String {
    let mut found: Vec<Finding> = undated(project, change).into_iter().collect();
    found.extend(findings(change));
    let said = found.iter().filter(|finding| style.is_full || finding.is_key);
    let mut out = project_text(project, file, style) + "\n" + &findings_text(said, style);
    if style.is_full {
        out += &document_text(&sections(project, change), style);
    }
    match style.is_full {
        true => out + &notes_text(project, style),
        false => out,
    }
}
