//! What was given with many surveys, as one table.

use crate::document::{Cell, Column, Table};
use dolmen_project::{Project, Survey};
use dolmen_words::{Digits, Quantity, Unit, messages};

/// Surveys from which on a table says more than a list for each. Chosen here.
const TABLE_FROM: usize = 4;

messages! {
    /// The table of surveys.
    pub(crate) enum Given in "given.surveys" {
        Caption { surveys: usize } => {
            en: "Surveys: {surveys}. Tilts as written, horizontal over vertical; a dash stands for what was not recorded.",
            ko: "조사 {surveys}회. 기울기는 입력한 그대로(수평/연직)이며, 기록되지 않은 항목은 –로 표시하였다.",
        },
        Surveys => { en: "Surveys", ko: "조사" },
        Survey => { en: "Survey", ko: "조사" },
        Temperature => { en: "air", ko: "기온" },
        Datum => { en: "Datum", ko: "기준점" },
        Tilt => { en: "Tilt", ko: "기울기" },
        Records => { en: "Records", ko: "진동 기록" },
        Remarks => { en: "Note, source", ko: "비고, 출처" },
        Text { text: String } => { en: "{text}", ko: "{text}" },
    }
}

/// One row a survey; `None` where they are few.
pub(crate) fn surveys_table(project: &Project) -> Option<Table> {
    let surveys = &project.surveys;
    (surveys.len() >= TABLE_FROM).then(|| Table {
        caption: vec![
            Given::Caption {
                surveys: surveys.len(),
            }
            .into(),
        ],
        columns: columns(),
        rows: surveys.iter().map(row).collect(),
    })
}

fn columns() -> Vec<Column> {
    let words = [
        Given::Survey,
        Given::Datum,
        Given::Tilt,
        Given::Records,
        Given::Remarks,
    ];
    let words = words.map(|head| Column {
        head: head.into(),
        unit: Unit::ratio(),
        is_words: true,
    });
    let air = Column {
        head: Given::Temperature.into(),
        unit: Unit::si("°C"),
        is_words: false,
    };
    words.into_iter().chain([air]).collect()
}

fn row(survey: &Survey) -> Vec<Cell> {
    let text = |text: String| {
        let text = if text.is_empty() { "–".to_owned() } else { text };
        Cell::Words(Given::Text { text }.into())
    };
    let tilts = survey
        .tilt
        .iter()
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written));
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
    vec![
        text(survey.name.clone()),
        text(survey.datum.clone().unwrap_or_default()),
        text(tilts.collect::<Vec<_>>().join(", ")),
        text(records.join(", ")),
        text(remarks.join("; ")),
        Cell::Number(air),
    ]
}
