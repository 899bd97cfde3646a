//! A list for people: the first rows, and how many more there are.

use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text};
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::kept::{ListedStructure, ListedSurvey};

/// Number of rows shown; other formats give all.
const ROWS_MOST: usize = 500;

messages! {
    /// The list of a store.
    pub(crate) enum Listed in "store.list" {
        Structures(count: usize) => { en: "{count} structures.", ko: "구조물 {count}기." },
        Surveys(count: usize) => { en: "{count} surveys.", ko: "계측 조사 {count}건." },
        Nothing => { en: "Nothing was found.", ko: "해당하는 자료가 없다." },
        Structure => { en: "structure", ko: "구조물" },
        Text(text: String) => { en: "{text}", ko: "{text}" },
        Removed(text: String) => { en: "{text} (out of use)", ko: "{text}(사용 중지)" },
        Kind => { en: "kind", ko: "종류" },
        SurveyCount => { en: "surveys", ko: "조사 수" },
        First => { en: "first", ko: "최초" },
        Last => { en: "last", ko: "최근" },
        Survey => { en: "survey", ko: "계측 조사" },
        Records => { en: "records", ko: "기록" },
        Temperature => { en: "air", ko: "기온" },
        Earthquake => { en: "earthquake", ko: "지진" },
        PeakOf(peak: Quantity) => { en: "{peak}", ko: "{peak}" },
        OfUnknownPeak => { en: "yes", ko: "있음" },
        Lowest => { en: "lowest frequency", ko: "최저 고유진동수" },
        More(count: usize) => {
            en: "{count} more: --csv and --json give all.",
            ko: "나머지 {count}건은 --csv 또는 --json으로 본다.",
        },
    }
}

fn text(text: &str) -> Cell {
    Cell::words(Listed::Text(text.to_owned()))
}

fn date(text: Option<&str>) -> Cell {
    self::text(text.unwrap_or("–"))
}

fn count(value: i64) -> Cell {
    Cell::number(Quantity::new(value as f64, Unit::ratio(), Digits::Fixed(0)))
}

/// Known data of an earthquake.
pub(super) fn earthquake(is_there: bool, peak_m_s2: Option<f64>) -> Cell {
    match (is_there, peak_m_s2) {
        (false, _) => text("–"),
        (true, None) => Cell::words(Listed::OfUnknownPeak),
        (true, Some(peak)) => Cell::words(Listed::PeakOf(Quantity::new(
            peak,
            Unit::si("m/s²"),
            Digits::Significant(3),
        ))),
    }
}

fn shown(table: Table, left_out: usize, style: TextStyle) -> String {
    if table.rows.is_empty() {
        let mut document = Document::default();
        document.paragraph(Listed::Nothing);
        return document_text(&document, style);
    }
    if !style.is_full {
        let mut brief = BriefText::new(style);
        brief.table(&table, table.rows.len());
        return brief.finish();
    }
    let mut document = Document::default();
    document.put(Block::Table(table));
    if left_out > 0 {
        document.note(Listed::More(left_out));
    }
    document_text(&document, style)
}

/// A list of structures that stores only a limited number of rows.
#[derive(Debug, Default)]
pub struct StructureList {
    rows: Vec<ListedStructure>,
    count: usize,
}

impl StructureList {
    /// Takes a row.
    pub fn push(&mut self, row: ListedStructure) {
        self.count += 1;
        if self.rows.len() < ROWS_MOST {
            self.rows.push(row);
        }
    }

    /// The first rows, and how many more there are.
    pub fn text(&self, style: TextStyle) -> String {
        let rows = self.rows.iter().map(|row| {
            let name = match row.is_removed {
                true => Cell::words(Listed::Removed(row.name.clone())),
                false => text(&row.name),
            };
            vec![
                name,
                text(&row.kind),
                date(row.first_survey.as_deref()),
                date(row.last_survey.as_deref()),
                count(row.surveys),
            ]
        });
        let table = Table {
            caption: vec![Listed::Structures(self.count).into()],
            columns: vec![
                Column::words(Listed::Structure),
                Column::words(Listed::Kind),
                Column::words(Listed::First),
                Column::words(Listed::Last),
                Column::numbers(Listed::SurveyCount, Unit::ratio()),
            ],
            rows: rows.collect(),
        };
        shown(table, self.count - self.rows.len(), style)
    }
}

/// A list of surveys that stores only a limited number of rows.
#[derive(Debug, Default)]
pub struct SurveyList {
    rows: Vec<ListedSurvey>,
    count: usize,
}

impl SurveyList {
    /// Takes a row.
    pub fn push(&mut self, row: ListedSurvey) {
        self.count += 1;
        if self.rows.len() < ROWS_MOST {
            self.rows.push(row);
        }
    }

    /// The first rows, and how many more there are.
    pub fn text(&self, style: TextStyle) -> String {
        let number = |value: Option<f64>, unit: &str, digits| {
            Cell::Number(value.map(|value| Quantity::new(value, Unit::si(unit), digits)))
        };
        let any = self.rows.iter().any(|row| row.has_earthquake);
        let rows = self.rows.iter().map(|row| {
            let mut cells = vec![
                text(&row.structure),
                text(&row.survey),
                count(row.records),
                number(row.temperature_c, "°C", Digits::Trimmed(3)),
                number(row.lowest_frequency_hz, "Hz", Digits::Significant(4)),
            ];
            if any {
                cells.push(earthquake(row.has_earthquake, row.earthquake_peak_m_s2));
            }
            cells
        });
        let mut columns = vec![
            Column::words(Listed::Structure),
            Column::words(Listed::Survey),
            Column::numbers(Listed::Records, Unit::ratio()),
            Column::numbers(Listed::Temperature, Unit::si("°C")),
            Column::numbers(Listed::Lowest, Unit::si("Hz")),
        ];
        if any {
            columns.push(Column::words(Listed::Earthquake));
        }
        let table = Table {
            caption: vec![Listed::Surveys(self.count).into()],
            columns,
            rows: rows.collect(),
        };
        shown(table, self.count - self.rows.len(), style)
    }
}
