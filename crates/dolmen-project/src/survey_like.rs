//! A survey with the settings of another survey and its own record, in the syntax of a project file.

use crate::survey::EarthquakePart;
use toml::{Table, Value};

/// Key of a file in the table of a record.
const FILE: &str = "file";

/// The values of the survey that differ from the other one.
#[derive(Clone, Copy, Debug)]
pub struct LikeSurvey<'a> {
    /// Its name.
    pub name: &'a str,
    /// The file of its record.
    pub file: &'a str,
    /// A note.
    pub note: &'a str,
    /// The temperature of the air, °C.
    pub temperature_c: Option<f64>,
    /// Names of channels to leave out in addition to those of the other survey; columns for channels without a name.
    pub left_out: &'a [String],
    /// The earthquake in its record.
    pub earthquake: Option<EarthquakePart>,
}

/// The table of a survey with the record settings of the survey `like` in `text`, to be appended to the text. It takes nothing else from
/// the other survey. `None` where that survey has no record in one file.
pub fn survey_like(text: &str, like: &str, own: &LikeSurvey<'_>) -> Option<String> {
    let root = text.parse::<Table>().ok()?;
    let mut records = root.get("survey")?.get(like)?.get("records")?.as_table()?.clone();
    records.get(FILE)?.as_str()?;
    let channels = records.get_mut("channels").and_then(Value::as_array_mut);
    for channel in channels.into_iter().flatten().filter_map(Value::as_table_mut) {
        let named = channel.get("name").or_else(|| channel.get("column"));
        let is_out = named
            .and_then(Value::as_str)
            .is_some_and(|name| own.left_out.iter().any(|out| out == name));
        if is_out {
            channel.insert("leave_out".to_owned(), Value::Boolean(true));
        }
    }
    records.insert(FILE.to_owned(), Value::String(own.file.to_owned()));
    let temperature = own
        .temperature_c
        .map(|celsius| format!("temperature_c = {celsius:?}\n"));
    let earthquake = own.earthquake.map(earthquake_text);
    Some(format!(
        "\n[survey.{}]\nnote = {}\n{}{}records = {}\n",
        Value::String(own.name.to_owned()),
        Value::String(own.note.to_owned()),
        temperature.unwrap_or_default(),
        earthquake.unwrap_or_default(),
        Value::Table(records)
    ))
}

/// The earthquake as a line of a survey; numbers have only significant digits.
fn earthquake_text(of: EarthquakePart) -> String {
    let peak = of.peak_m_s2.map(|peak| format!("peak = \"{peak:.5} m/s2\""));
    let number = |key: &str, value: Option<f64>| value.map(|value| format!("{key} = {value:.5}"));
    let at_least = of.is_at_least.then(|| "at_least = true".to_owned());
    let keys = [
        peak,
        at_least,
        number("changed", of.changed),
        number("changed_sd", of.changed_sd),
    ];
    let keys: Vec<String> = keys.into_iter().flatten().collect();
    format!("earthquake = {{ {} }}\n", keys.join(", "))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::parse_project;

    const TEXT: &str = r#"
schema = 1
kind = "survey"
name = "Gate"
[survey.2024-05-01]
temperature_c = 9
tilt = { x = "1/300" }
[survey.2024-05-01.records]
file = "first.csv"   # by hand
sampling_rate = "100 Hz"
unit = "mg"
channels = [{ column = "a \"b\"", direction = "x", position = [0, 0, "3 m"] }]
"#;

    #[test]
    fn holds_a_survey_like_another_is_read_with_its_settings() {
        let like = |text: &str, name: &str, file: &str| {
            let own = LikeSurvey {
                name,
                file,
                note: "as \"x\\\ny\" '''",
                temperature_c: file.contains('b').then_some(-3.0),
                left_out: &[],
                earthquake: file.contains('b').then_some(EarthquakePart {
                    peak_m_s2: Some(0.5),
                    is_at_least: true,
                    changed: Some(-0.02),
                    changed_sd: None,
                }),
            };
            survey_like(text, "2024-05-01", &own).unwrap()
        };
        let first = TEXT.to_owned() + &like(TEXT, "2026-11-25T10:00:00", "followed/a.csv");
        let both = first.clone() + &like(&first, "2026-11-25T11:00:00", "followed/b.csv");
        let project = parse_project(&both, "project.toml").unwrap();
        let [before, one, two] = project.surveys.as_slice() else {
            panic!("{both}")
        };
        assert_eq!(one.name, "2026-11-25T10:00:00");
        assert_eq!(one.note.as_deref(), Some("as \"x\\\ny\" '''"));
        assert_eq!((one.temperature_c, one.tilt.len()), (None, 0));
        assert_eq!(two.temperature_c, Some(-3.0));
        let shaken = two.earthquake.unwrap();
        assert_eq!((one.earthquake, shaken.peak_m_s2), (None, Some(0.5)));
        assert!(shaken.is_at_least);
        assert_eq!((shaken.changed, shaken.changed_sd), (Some(-0.02), None));
        let (given, own, last) = (
            before.records.clone().unwrap(),
            one.records.clone().unwrap(),
            two.records.clone().unwrap(),
        );
        assert_eq!(own.file, "followed/a.csv");
        assert_eq!(last.file, "followed/b.csv");
        let file = given.file.clone();
        assert_eq!(dolmen_record_with(own, &file), given);
    }

    fn dolmen_record_with(mut source: crate::RecordSource, file: &str) -> crate::RecordSource {
        file.clone_into(&mut source.file);
        source
    }

    #[test]
    fn holds_channels_are_left_out_by_name_or_column() {
        let own = LikeSurvey {
            name: "2026",
            file: "a.csv",
            note: "",
            temperature_c: None,
            earthquake: None,
            left_out: &["a \"b\"".to_owned(), "top".to_owned()],
        };
        let more = TEXT.replace(
            "\"3 m\"] }]",
            "\"3 m\"] }, { column = 2, name = \"top\" }, { column = \"top\", name = \"low\" }]",
        );
        let text = more.clone() + &survey_like(&more, "2024-05-01", &own).unwrap();
        let project = parse_project(&text, "project.toml").unwrap();
        let left_out = |at: usize| -> Vec<bool> {
            let channels = project.surveys[at]
                .records
                .iter()
                .flat_map(|records| &records.channels);
            channels.map(|channel| channel.leave_out).collect()
        };
        assert_eq!(
            (left_out(0), left_out(1)),
            (vec![false; 3], vec![true, true, false])
        );
    }

    #[test]
    fn refuses_a_survey_without_one_record() {
        for (text, like) in [
            (TEXT, "2024-05-02"),
            (
                &TEXT.replace("\"first.csv\"", "[\"a.csv\", \"b.csv\"]"),
                "2024-05-01",
            ),
            ("[", "2024-05-01"),
        ] {
            let own = LikeSurvey {
                name: "a",
                file: "b",
                note: "c",
                earthquake: None,
                temperature_c: None,
                left_out: &[],
            };
            assert_eq!(survey_like(text, like, &own), None);
        }
    }
}
