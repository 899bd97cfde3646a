//! The inputs of many surveys, as one table.

use crate::document::{Cell, Column, Table};
use crate::html::words::evidence_word;
use crate::surveys_many::are_tabled;
use dolmen_project::{Evidence, Project, Quantity as Input, Survey, SurveyMode};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::surveyed::SurveyAnswer;

/// Number of surveys from which a table is better than a list for each. Our choice.
const TABLE_FROM: usize = 4;

messages! {
    /// The table of surveys.
    pub(crate) enum Given in "given.surveys" {
        Caption(surveys: usize) => {
            en: "Surveys: {surveys}. Tilts as written, horizontal over vertical; frequencies that the file states, ± standard deviation; a dash stands for what was not recorded.",
            ko: "조사 {surveys}회. 기울기는 입력한 그대로(수평/연직), 진동수는 파일에 기재된 값 ± 표준편차이며, 기록되지 않은 항목은 –로 표시하였다.",
        },
        Further(surveys: usize) => {
            en: "Surveys: {surveys}, what else the file states of them; a dash stands for what was not recorded.",
            ko: "조사 {surveys}회. 그 밖에 입력된 사항이며, 기록되지 않은 항목은 –로 표시하였다.",
        },
        Surveys => { en: "Surveys", ko: "조사" },
        Survey => { en: "Survey", ko: "조사" },
        Temperature => { en: "air", ko: "기온" },
        Datum => { en: "Datum", ko: "기준점" },
        Tilt => { en: "Tilt", ko: "기울기" },
        Records => { en: "Records", ko: "진동 기록" },
        Frequencies(direction: String) => { en: "{direction}, Hz", ko: "{direction}, Hz" },
        Evidence => { en: "Frequencies from", ko: "진동수 출처" },
        Said(text: Both) => { en: "{text}", ko: "{text}" },
        Remarks => { en: "Note, source", ko: "비고, 출처" },
        Text(text: String) => { en: "{text}", ko: "{text}" },
    }
}

/// The inputs listed one by one; those of many surveys are in their table instead.
pub(crate) fn inputs_listed(project: &Project) -> Vec<&Input> {
    match is_tabled(project) {
        true => project.structure_inputs(),
        false => project.inputs(),
    }
}

/// Whether there are enough surveys for a table.
pub(crate) fn is_tabled(project: &Project) -> bool {
    project.surveys.len() >= TABLE_FROM
}

/// One row per survey; `None` where there are few. Air, tilts and frequencies of the file that the table of results contains appear only there.
pub(crate) fn surveys_table(project: &Project, answers: &[SurveyAnswer]) -> Option<Table> {
    let surveys = &project.surveys;
    let has_answer = |survey: &Survey| answers.iter().any(|answer| answer.name == survey.name);
    let is_tabled_before = are_tabled(project, answers) && surveys.iter().all(has_answer);
    let mut directions: Vec<&str> = surveys
        .iter()
        .flat_map(|survey| survey.modes.keys().map(String::as_str))
        .collect();
    directions.sort_unstable();
    directions.dedup();
    let mut table = Table {
        caption: vec![caption(surveys.len(), is_tabled_before)],
        columns: columns(&directions),
        rows: surveys.iter().map(|survey| row(survey, &directions)).collect(),
    };
    if is_tabled_before {
        let first = match surveys.iter().all(is_stated_alone) {
            true => 2 + directions.len(),
            false => 2,
        };
        let last = table.columns.len() - 1;
        let kept = |at: usize| at == 0 || (first..last).contains(&at);
        table.columns = (0..)
            .zip(table.columns)
            .filter(|of| kept(of.0))
            .map(|of| of.1)
            .collect();
        for row in &mut table.rows {
            *row = (0..)
                .zip(std::mem::take(row))
                .filter(|of| kept(of.0))
                .map(|of| of.1)
                .collect();
        }
    }
    is_tabled(project).then_some(table)
}

fn caption(surveys: usize, is_tabled_before: bool) -> Sentence {
    match is_tabled_before {
        true => Given::Further(surveys).into(),
        false => Given::Caption(surveys).into(),
    }
}

/// Whether the table of results has all that the file states of its modes.
fn is_stated_alone(survey: &Survey) -> bool {
    let mut modes = survey.modes.values().flatten();
    let has_records = survey.records.is_some() || !survey.setups.is_empty();
    survey.modes.is_empty() || (!has_records && modes.all(|mode| mode.damping_ratio.is_none()))
}

fn columns(directions: &[&str]) -> Vec<Column> {
    let along = directions.iter().map(|direction| {
        let direction = (*direction).to_owned();
        Column::words(Given::Frequencies(direction))
    });
    let mut columns = vec![Column::words(Given::Survey), Column::words(Given::Tilt)];
    columns.extend(along);
    columns.extend([Given::Evidence, Given::Datum, Given::Records, Given::Remarks].map(Column::words));
    columns.push(Column::numbers(Given::Temperature, Unit::si("°C")));
    columns
}

fn row(survey: &Survey, directions: &[&str]) -> Vec<Cell> {
    let text = |text: String| {
        let text = if text.is_empty() { "–".to_owned() } else { text };
        Cell::Words(Given::Text(text).into())
    };
    let tilts = survey
        .tilt
        .iter()
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written));
    let along = |direction: &&str| {
        let modes = survey.modes.get(*direction).into_iter().flatten();
        text(modes.map(mode).collect::<Vec<_>>().join("; "))
    };
    let records = survey.records.iter().chain(&survey.setups);
    let records: Vec<&str> = records.map(|record| record.file.as_str()).collect();
    let remarks: Vec<&str> = survey
        .note
        .iter()
        .chain(&survey.source)
        .map(String::as_str)
        .collect();
    let air = survey
        .temperature_c
        .map(|air| Quantity::new(air, Unit::si("°C"), Digits::Trimmed(3)));
    let mut cells = vec![
        text(survey.name.clone()),
        text(tilts.collect::<Vec<_>>().join(", ")),
    ];
    cells.extend(directions.iter().map(along));
    cells.extend([
        evidence(survey),
        text(survey.datum.clone().unwrap_or_default()),
        text(records.join(", ")),
        text(remarks.join("; ")),
        Cell::Number(air),
    ]);
    cells
}

/// A frequency with its deviation, and the damping ratio if stated.
fn mode(mode: &SurveyMode) -> String {
    let frequency = Quantity {
        sd_si: Some(mode.frequency.standard_deviation()).filter(|sd| *sd > 0.0),
        ..Quantity::new(mode.frequency.value, Unit::si("Hz"), Digits::Trimmed(6))
    };
    match &mode.damping_ratio {
        None => frequency.number(),
        Some(ratio) => format!("{} (ζ {})", frequency.number(), ratio.written),
    }
}

/// Sources of the modes, without duplicates.
fn evidence(survey: &Survey) -> Cell {
    let modes = survey.modes.values().flatten();
    let mut sources: Vec<Option<Evidence>> = modes.map(|mode| mode.frequency.source).collect();
    sources.dedup();
    match sources.is_empty() {
        true => Cell::Words(Given::Text("–".to_owned()).into()),
        false => {
            let text = Both::of(|language| {
                let words: Vec<&str> = sources.iter().map(|of| evidence_word(*of, language)).collect();
                words.join(", ")
            });
            Cell::Words(Given::Said(text).into())
        }
    }
}
