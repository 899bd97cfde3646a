//! What was given: every input with its unit, scatter and source, and what rests on assumptions.

use super::fronted::{InputsGiven, text};
use super::table::{Cell, table};
use super::words::{evidence_word, input_words, set, unit_text};
use crate::check::{title, version};
use crate::document::{Block, Numbers, block_html, table_label};
use crate::other_inputs::{other_inputs, other_inputs_of};
use crate::surveys_given::{Given, inputs_listed, surveys_table};
use crate::warned::warned;
use dolmen_project::{Project, Quantity, Survey};
use dolmen_words::message::Both;
use dolmen_words::number;
use dolmen_words::{Digits, Language, Quantity as Shown, Sentence, Unit};
use dolmen_work::answer::ProjectReport;
use maud::{Markup, html};

/// The section with the given input.
pub(super) fn section(answer: &ProjectReport, language: Language, numbers: &mut Numbers) -> Markup {
    let project = &answer.project;
    let inputs = inputs_listed(project);
    html! {
        (block_html(&Block::Heading(InputsGiven::Head.into()), language, numbers))
        @if let Some(description) = &project.description { p { (language.pick(description.english(), description.korean())) } }
        @if inputs.is_empty() {
            p { (text(InputsGiven::NoDimensions, language)) }
        } @else {
            @let gravity = Shown::new(project.gravity_m_s2, Unit::si("m/s²"), Digits::Trimmed(6));
            @let caption = InputsGiven::Tinted { gravity }.into();
            (inputs_table(&caption, (project, &inputs), language, numbers))
        }
        @if let Some(table) = other_inputs(answer) { (block_html(&Block::Table(table), language, numbers)) }
        @for variant in answer.variants() {
            @if !variant.own_inputs.is_empty() {
                @let inputs: Vec<&Quantity> = variant.own_inputs.iter().collect();
                @let caption = InputsGiven::OfVariant { variant: title(variant) }.into();
                (inputs_table(&caption, (version(project, variant), &inputs), language, numbers))
            }
            @if let Some(table) = other_inputs_of(answer, variant) { (block_html(&Block::Table(table), language, numbers)) }
        }
        (surveys(answer, language, numbers))
        @if !project.warnings.is_empty() {
            (block_html(&Block::Subheading(InputsGiven::Warnings.into()), language, numbers))
            ul { @for warning in &project.warnings {
                li { (warned(project, warning).text(language)) }
            } }
        }
    }
}

fn inputs_table(
    caption: &Sentence,
    (project, inputs): (&Project, &[&Quantity]),
    language: Language,
    numbers: &mut Numbers,
) -> Markup {
    let with_cov = inputs.iter().any(|q| q.cov.is_some());
    let with_note = inputs.iter().any(|q| q.note.is_some());
    let mut head = vec![language.pick("Input", "입력"), language.pick("Source", "출처")];
    let words = head.len();
    head.extend([
        language.pick("As written", "기재값"),
        language.pick("SI value", "SI 값"),
    ]);
    if with_cov {
        head.push(language.pick("Coefficient of variation", "변동계수"));
    }
    if with_note {
        head.push(language.pick("Note", "비고"));
    }
    let head: Vec<String> = head.into_iter().map(String::from).collect();
    let rows: Vec<Vec<Cell>> = inputs
        .iter()
        .map(|q| {
            let source = evidence_word(q.source, language);
            let mut row: Vec<Cell> = vec![
                input_words(project, &q.path, language).into(),
                if q.is_assumed() {
                    Cell::assumed(source)
                } else {
                    source.into()
                },
                set(&q.written).into(),
                format!(
                    "{}{}{}",
                    number::trimmed(q.value, 6),
                    number::NARROW_SPACE,
                    unit_text(q.unit)
                )
                .into(),
            ];
            if with_cov {
                row.push(q.cov.map_or("–".into(), |cov| number::percent(cov, 2)).into());
            }
            if with_note {
                row.push(Cell::wrapping(q.note.clone().unwrap_or_default()));
            }
            row
        })
        .collect();
    table(
        &numbers.anchor(caption),
        &table_label(&numbers.table(), language),
        &caption.text(language),
        words,
        &head,
        &rows,
    )
}

fn surveys(answer: &ProjectReport, language: Language, numbers: &mut Numbers) -> Markup {
    let project = &answer.project;
    if let Some(table) = surveys_table(project, answer.surveys()) {
        return html! {
            (block_html(&Block::Subheading(Given::Surveys.into()), language, numbers))
            (block_html(&Block::Table(table.without_empty_columns()), language, numbers))
        };
    }
    html! {
        @for survey in &project.surveys {
            (block_html(&Block::Subheading(survey_head(survey)), language, numbers))
            ul {
                @for line in survey_lines(survey, language) { li { (line) } }
                @if let Some(records) = &survey.records {
                    li { (text(InputsGiven::Records, language)) ": " code { (records.file) } }
                }
            }
        }
    }
}

/// The head over what was given with a survey.
pub(crate) fn survey_head(survey: &Survey) -> Sentence {
    let name = survey.name.clone();
    InputsGiven::Survey { name }.into()
}

/// The input of a survey in addition to its records.
pub(crate) fn survey_lines(survey: &Survey, language: Language) -> Vec<String> {
    let mut lines: Vec<String> = survey.note.iter().cloned().collect();
    if let Some(source) = &survey.source {
        let source = Both::from(source.as_str());
        lines.push(text(InputsGiven::Source { source }, language));
    }
    lines.push(match survey.temperature_c {
        Some(temperature) => {
            let temperature = Shown::new(temperature, Unit::si("°C"), Digits::Significant(3));
            text(InputsGiven::Temperature { temperature }, language)
        }
        None => text(InputsGiven::NoTemperature, language),
    });
    if let Some(datum) = &survey.datum {
        let datum = Both::from(datum.as_str());
        lines.push(text(InputsGiven::Datum { datum }, language));
    }
    if !survey.tilt.is_empty() {
        let each = survey.tilt.iter();
        let each: Vec<String> = each
            .map(|(direction, tilt)| format!("{direction} {}", tilt.written))
            .collect();
        let tilt = Both::from(each.join(", "));
        lines.push(text(InputsGiven::Tilt { tilt }, language));
    }
    lines
}
