//! `dolmen watch` as text.

use crate::brief::{brief_text, notes_text};
use crate::check::{made_up_text, project_text};
use crate::document::{TextStyle, document_text, findings_text};
use crate::watch::{findings, sections};
use dolmen_work::watched::WatchAnswer;

/// The text of a history.
pub fn watch_text(answer: &WatchAnswer, style: TextStyle) -> String {
    let found = findings(answer);
    let head =
        project_text(&answer.project, &answer.file, style) + &made_up_text(&answer.project, style) + "\n";
    if !style.is_full {
        return head + &brief_text(&found, &answer.project, 0, style);
    }
    let mut out = head + &findings_text(found.iter(), style);
    out += &document_text(&sections(answer), style);
    out + &notes_text(&answer.project, style)
}
