//! Lists for other programs, written row by row without storing them.

use crate::as_json;
use dolmen_records::time_text;
use dolmen_work::kept::{ListedStructure, ListedSurvey};
use serde_json::Value;

/// A format for other programs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ListFormat {
    /// One object with a list.
    Json,
    /// A table, with the byte order mark by which Excel recognises UTF-8.
    Csv,
    /// Points of a map; structures without coordinates are left out.
    GeoJson,
}

/// Kind of list.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Listing {
    /// Structures.
    Structures,
    /// Surveys.
    Surveys,
}

const STRUCTURE_COLUMNS: &str = "name,kind,english,korean,latitude_deg,longitude_deg,surveys,first_survey,last_survey,stored,who,is_removed";
const SURVEY_COLUMNS: &str =
    "structure,survey,date,temperature_c,records,lowest_frequency_hz,has_earthquake,earthquake_peak_m_s2";

impl ListFormat {
    /// Text before the first row.
    pub fn head(self, of: Listing) -> String {
        match (self, of) {
            (ListFormat::Json, Listing::Structures) => "{\n\"structures\": [\n".to_owned(),
            (ListFormat::Json, Listing::Surveys) => "{\n\"surveys\": [\n".to_owned(),
            (ListFormat::Csv, Listing::Structures) => format!("\u{feff}{STRUCTURE_COLUMNS}\r\n"),
            (ListFormat::Csv, Listing::Surveys) => format!("\u{feff}{SURVEY_COLUMNS}\r\n"),
            (ListFormat::GeoJson, _) => "{\n\"type\": \"FeatureCollection\",\n\"features\": [\n".to_owned(),
        }
    }

    /// Text after the last row.
    pub fn tail(self) -> &'static str {
        match self {
            ListFormat::Json | ListFormat::GeoJson => "\n]\n}\n",
            ListFormat::Csv => "",
        }
    }

    /// A structure; `None` if the format has nothing for it.
    pub fn structure(self, row: &ListedStructure, is_first: bool) -> Option<String> {
        match self {
            ListFormat::Json => Some(object(&as_json!(row), is_first)),
            ListFormat::Csv => Some(line(&[
                quoted(&row.name),
                quoted(&row.kind),
                quoted(&row.english),
                quoted(&row.korean),
                number(row.latitude_deg),
                number(row.longitude_deg),
                row.surveys.to_string(),
                text(row.first_survey.as_deref()),
                text(row.last_survey.as_deref()),
                quoted(&time_text(row.stored_s)),
                quoted(&row.who),
                row.is_removed.to_string(),
            ])),
            ListFormat::GeoJson => {
                let place = [row.longitude_deg?, row.latitude_deg?]; // RFC 7946: east, then north
                let feature = as_json!({
                    "type": "Feature",
                    "geometry": { "type": "Point", "coordinates": place },
                    "properties": row,
                });
                Some(object(&feature, is_first))
            }
        }
    }

    /// A survey; `None` if the format has nothing for it.
    pub fn survey(self, row: &ListedSurvey, is_first: bool) -> Option<String> {
        match self {
            ListFormat::Json => Some(object(&as_json!(row), is_first)),
            ListFormat::Csv => Some(line(&[
                quoted(&row.structure),
                quoted(&row.survey),
                text(row.date.as_deref()),
                number(row.temperature_c),
                row.records.to_string(),
                number(row.lowest_frequency_hz),
                row.has_earthquake.to_string(),
                number(row.earthquake_peak_m_s2),
            ])),
            ListFormat::GeoJson => None,
        }
    }
}

fn object(value: &Value, is_first: bool) -> String {
    let before = if is_first { "" } else { ",\n" };
    format!("{before}{value}")
}

pub(super) fn line(cells: &[String]) -> String {
    cells.join(",") + "\r\n"
}

/// A quoted cell, which a spreadsheet never interprets as a formula.
pub(super) fn quoted(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t']);
    let mark = if is_formula { "'" } else { "" };
    format!("\"{mark}{}\"", text.replace('"', "\"\""))
}

pub(super) fn text(text: Option<&str>) -> String {
    text.map_or_else(String::new, quoted)
}

pub(super) fn number(number: Option<f64>) -> String {
    number.map_or_else(String::new, |number| number.to_string())
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(name: &str) -> ListedStructure {
        ListedStructure {
            name: name.to_owned(),
            kind: "stack".to_owned(),
            english: "Pagoda".to_owned(),
            korean: "석탑".to_owned(),
            latitude_deg: Some(35.79),
            longitude_deg: Some(129.332),
            surveys: 2,
            first_survey: Some("2010-05-12".to_owned()),
            last_survey: None,
            stored_s: 0.0,
            who: "kim".to_owned(),
            is_removed: false,
        }
    }

    #[test]
    fn exact_rows_of_each_format() {
        let csv = ListFormat::Csv.structure(&row("a \"b\""), true).unwrap();
        assert_eq!(
            csv,
            "\"a \"\"b\"\"\",\"stack\",\"Pagoda\",\"석탑\",35.79,129.332,2,\"2010-05-12\",,\"1970-01-01 00:00:00.000\",\"kim\",false\r\n"
        );
        let map = ListFormat::GeoJson.structure(&row("a"), false).unwrap();
        let feature: Value = serde_json::from_str(map.strip_prefix(",\n").unwrap()).unwrap();
        assert_eq!(feature["geometry"]["coordinates"], as_json!([129.332, 35.79]));
        let nowhere = ListedStructure {
            latitude_deg: None,
            ..row("a")
        };
        assert_eq!(ListFormat::GeoJson.structure(&nowhere, true), None);
    }

    #[test]
    fn holds_a_name_is_no_formula_in_a_spreadsheet() {
        for name in ["=1+1", "+1", "-1", "@x"] {
            let csv = ListFormat::Csv.structure(&row(name), true).unwrap();
            assert!(csv.starts_with(&format!("\"'{name}\"")), "{csv}");
        }
    }
}
