//! The last sections of a report: input data and sources.

use crate::document::{Block, Document};
use crate::html::Imprint;
use crate::html::front::sources;
use crate::html::fronted::{Fronted, InputsGiven};
use crate::html::given::{survey_head, survey_lines};
use crate::inputs_by_part::by_part;
use crate::surveys_given::{inputs_listed, is_tabled};
use crate::warned::warned;
use crate::whole::Appended;
use crate::xlsx::{Workbook, inputs_tables};
use dolmen_words::message::Both;
use dolmen_words::{Language, Sentence};
use dolmen_work::answer::ProjectReport;

/// The last sections of a report.
pub(crate) fn behind_document(answer: &ProjectReport, imprint: &Imprint) -> Document<'static> {
    let mut document = Document::default();
    given(&mut document, answer);
    document.heading(Fronted::Sources);
    document.put(list(|language| sources(answer, language, imprint)));
    document.note(Fronted::Closing);
    document
}

fn given(document: &mut Document<'_>, answer: &ProjectReport) {
    let project = &answer.project;
    let head = Appended::Given.into();
    document.heading(Appended::Appendix { head });
    if let Some(description) = &project.description {
        document.paragraph(said(|language| {
            language.pick(description.english(), description.korean())
        }));
    }
    let (tables, others) = by_part(project, &inputs_listed(project));
    for table in tables {
        document.put(Block::Table(table));
    }
    for headed in inputs_tables(answer, &others) {
        document.put(Block::Table(headed.table.without_empty_columns()));
    }
    // many surveys are already in a table above
    if !is_tabled(project) {
        for survey in &project.surveys {
            document.subheading(survey_head(survey));
            document.put(list(|language| survey_lines(survey, language)));
        }
    }
    if !project.warnings.is_empty() {
        document.subheading(InputsGiven::Warnings);
        let warnings = project.warnings.iter();
        document.put(Block::List(
            warnings.map(|warning| warned(project, warning)).collect(),
        ));
    }
}

fn said<T: Into<String>>(words: impl Fn(Language) -> T) -> Sentence {
    let text = Both::of(words);
    Workbook::Verbatim(text).into()
}

/// A list with one text in both languages for each point; both have the same number of points.
fn list(points: impl Fn(Language) -> Vec<String>) -> Block<'static> {
    let both = points(Language::English)
        .into_iter()
        .zip(points(Language::Korean));
    let each = both.map(|(english, korean)| Both { english, korean });
    Block::List(each.map(|text| Workbook::Verbatim(text).into()).collect())
}
