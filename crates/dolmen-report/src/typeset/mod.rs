//! A report as the source of a Typst document: calls to functions of its prelude, and figures as separate files.

mod blocks;
mod equation;
mod literal;
mod parts;

#[cfg(test)]
pub(crate) mod tests;

use crate::engineer::date_of;
use crate::html::{Imprint, NotReported, day, project_name};
use dolmen_words::Language;
use dolmen_work::answer::ProjectReport;
use literal::literal;
use parts::Parts;

/// The prelude: functions that define the layout.
const PRELUDE: &str = include_str!("prelude.typ");

/// The source of a Typst document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Typeset {
    /// The main file.
    pub main: String,
    /// Other files with their bytes: the prelude, and figures as SVG.
    pub files: Vec<(String, Vec<u8>)>,
}

/// The report on one or more projects as the source of a Typst document, which needs the fonts Pretendard Regular, SemiBold and Bold.
///
/// Each project begins with a cover and the answers; a report on one project has contents. The same input gives the same source. A date in
/// another form than 2026-05-12 is printed, but not stored as the document's date.
pub fn typeset(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
) -> Typeset {
    let title = match (answers, others) {
        ([one], []) => project_name(one, language),
        _ => language.pick("Reports", "보고서 모음"),
    };
    let date = match answers {
        [one] => date_of(one, imprint),
        _ => imprint.date.as_deref(),
    };
    let mut parts = Parts::new(language);
    parts.line("#import \"prelude.typ\": *");
    parts.line(&format!(
        "#show: report.with(language: {}, title: {}, kind: {}, program: {}, date: {})",
        literal(language.code()),
        literal(title),
        literal(parts::running_head(answers, language)),
        literal(&imprint.program),
        document_date(date),
    ));
    if answers.len() > 1 {
        parts.several(answers, others);
    }
    for answer in answers {
        parts.project(answer, imprint, answers.len() == 1);
    }
    parts.not_reported(others);
    let mut files = vec![("prelude.typ".to_owned(), PRELUDE.as_bytes().to_vec())];
    let (main, figures) = parts.finish();
    files.extend(figures);
    Typeset { main, files }
}

/// A day as Typst's date.
fn document_date(date: Option<&str>) -> String {
    match day(date) {
        Some([year, month, day]) => format!("datetime(year: {year}, month: {month}, day: {day})"),
        None => "none".to_owned(),
    }
}
