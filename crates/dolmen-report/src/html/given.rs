//! What was given: every input with its unit, scatter and source, and what rests on assumptions.

use super::table::{Cell, table};
use super::words::{evidence_word, input_words, unit_text};
use crate::check::title;
use crate::document::{Block, Numbers, block_html, numbered, table_label};
use crate::surveys_given::{Given, inputs_listed, surveys_table};
use crate::warned::warned;
use dolmen_project::{Quantity, Structure, Survey};
use dolmen_words::number;
use dolmen_words::{Language, Sentence, printed_name};
use dolmen_work::answer::ProjectReport;
use maud::{Markup, html};

/// The section "what was given".
pub(super) fn section(answer: &ProjectReport, language: Language, numbers: &mut Numbers) -> Markup {
    let project = &answer.project;
    let inputs = inputs_listed(project);
    html! {
        h2 { (numbered(&numbers.section(), language.pick("Appendix: What was given", "부록: 입력 자료"))) }
        @if let Some(description) = &project.description { p { (language.pick(description.english(), description.korean())) } }
        @if inputs.is_empty() {
            p { (language.pick(
                "No dimensions were given: only what was measured is reported.",
                "치수가 주어지지 않아 계측 결과만 보고한다.",
            )) }
        } @else {
            @let gravity = format!("g = {}{}m/s²", number::trimmed(project.gravity_m_s2, 6), number::NARROW_SPACE);
            @let caption = language.pick(
                format!("Inputs. Values marked as assumed are tinted; {gravity}."),
                format!("입력값. 가정한 값은 바탕색으로 표시하였다; {gravity}."),
            );
            (inputs_table(&caption, (&project.structure, &inputs), language, numbers))
        }
        @for variant in answer.variants() {
            @if !variant.own_inputs.is_empty() {
                @let inputs: Vec<&Quantity> = variant.own_inputs.iter().collect();
                @let title = title(variant);
                (inputs_table(&language.pick(
                    format!("Inputs that the variant “{}” changes; values marked as assumed are tinted.", title.text(language)),
                    format!("대안 ‘{}’에서 달라지는 입력값. 가정한 값은 바탕색으로 표시하였다.", title.text(language)),
                ), (&project.structure, &inputs), language, numbers))
            }
        }
        (surveys(answer, language, numbers))
        @if !project.warnings.is_empty() {
            h3 { (numbered(&numbers.part(), language.pick("Warnings on reading the file", "입력 파일에 대한 경고"))) }
            ul { @for warning in &project.warnings {
                li { (warned(project, warning).text(language)) }
            } }
        }
    }
}

fn inputs_table(
    caption: &str,
    (structure, inputs): (&Structure, &[&Quantity]),
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
                input_words(structure, &q.path, language).into(),
                if q.is_assumed() {
                    Cell::assumed(source)
                } else {
                    source.into()
                },
                q.written.clone().into(),
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
        &table_label(&numbers.table(), language),
        caption,
        words,
        &head,
        &rows,
    )
}

fn surveys(answer: &ProjectReport, language: Language, numbers: &mut Numbers) -> Markup {
    let project = &answer.project;
    if let Some(table) = surveys_table(project, answer.surveys()) {
        return html! {
            h3 { (numbered(&numbers.part(), &Sentence::from(Given::Surveys).text(language))) }
            (block_html(&Block::Table(table.without_empty_columns()), language, numbers))
        };
    }
    html! {
        @for survey in &project.surveys {
            h3 { (numbered(&numbers.part(), &survey_head(survey, language))) }
            ul {
                @for line in survey_lines(survey, language) { li { (line) } }
                @if let Some(records) = &survey.records {
                    li { (language.pick("Vibration records: ", "진동 기록: ")) code { (records.file) } }
                }
            }
        }
    }
}

/// The head over what was given with a survey.
pub(crate) fn survey_head(survey: &Survey, language: Language) -> String {
    let name = printed_name(&survey.name, language);
    language.pick(format!("Survey {name}"), format!("{name} 조사"))
}

/// What was given with a survey beside its records.
pub(crate) fn survey_lines(survey: &Survey, language: Language) -> Vec<String> {
    let mut lines: Vec<String> = survey.note.iter().cloned().collect();
    if let Some(source) = &survey.source {
        lines.push(format!("{}{source}", language.pick("Source: ", "출처: ")));
    }
    lines.push(match survey.temperature_c {
        Some(temperature) => format!(
            "{}{}\u{202f}°C",
            language.pick("Air temperature ", "기온 "),
            number::significant(temperature, 3)
        ),
        None => language.pick("Air temperature: unknown", "기온: 미상").to_owned(),
    });
    if let Some(datum) = &survey.datum {
        lines.push(format!("{}{datum}", language.pick("Datum: ", "기준점: ")));
    }
    if !survey.tilt.is_empty() {
        let each = survey.tilt.iter();
        let each: Vec<String> = each
            .map(|(direction, tilt)| format!("{direction} {}", tilt.written))
            .collect();
        lines.push(format!(
            "{}{}",
            language.pick("Tilt: ", "기울기: "),
            each.join(", ")
        ));
    }
    lines
}
