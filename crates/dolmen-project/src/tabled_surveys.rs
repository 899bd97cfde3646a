//! Surveys that stand in a table beside the project: `surveys = { file = "history.xlsx" }`, one row per date. Each becomes a `[survey.DATE]`, as if it
//! were written there.

use super::error::Fault;
use super::measure::Measure;
use super::survey::date_of;
use super::survey_heads::{Held, held, with_unit};
use super::tabled::{Tabled, quoted, written};
use super::units::parse_unit;
use super::wrong::{Common, WrongSurveys, WrongTable};
use crate::wrong::said;
use dolmen_records::{Files, SHEET_BYTES_MOST, SheetCell, SheetValue, read_dated_sheet};
use dolmen_words::message::Both;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use toml::de::DeTable;

/// The key of the file.
const KEY: &str = "surveys";
/// Keys that the table may have.
const KEYS: [&str; 3] = ["file", "sheet", "ignore"];
/// Marks for a missing reading.
const MISSING: [&str; 8] = ["-", "–", "—", "/", "n/a", "na", "결측", "미측정"];

/// A fault with its remedy.
type Wrong = (Both, Both);
/// A column: its contents, unit and head.
#[derive(Debug)]
struct Head {
    held: Held,
    unit: Option<String>,
    cell: SheetCell,
}

/// The surveys of the table that the file names.
pub(super) fn surveys_in_table(
    root: &DeTable<'_>,
    files: &dyn Files,
    all: &mut Vec<Tabled>,
    faults: &mut Vec<Fault>,
) {
    let Some(given) = root.get(KEY) else { return };
    let Some(table) = given.get_ref().as_table() else {
        return; // the schema says what is wrong
    };
    if let Some((other, _)) = table
        .iter()
        .find(|(key, _)| !KEYS.contains(&key.get_ref().as_ref()))
    {
        let name = other.get_ref().to_string();
        let path = format!("{KEY}.{name}");
        let key = KEY.to_owned();
        let fault = Fault::new(other.span(), &path, WrongTable::HasKeyBesideFile { key, name });
        faults.push(fault.allowed(WrongSurveys::MustBeFileSheetIgnore));
        return;
    }
    let word = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
    let Some(file) = word("file") else { return };
    let ignored = table.get("ignore").and_then(|value| value.get_ref().as_array());
    let ignored: Vec<&str> = ignored
        .into_iter()
        .flatten()
        .filter_map(|head| head.get_ref().as_str())
        .collect();
    let read = rows(file, word("sheet"), files)
        .map_err(|wrong| vec![wrong])
        .and_then(|rows| listed(file, &rows, &ignored, root));
    match read {
        Ok((text, places)) => all.push(Tabled::of_surveys(given.span(), text, file.to_owned(), places)),
        Err(wrong) => faults.extend(
            wrong
                .into_iter()
                .map(|(message, help)| Fault::new(given.span(), KEY, message).help(help)),
        ),
    }
}

fn rows(file: &str, sheet: Option<&str>, files: &dyn Files) -> Result<Vec<Vec<SheetCell>>, Wrong> {
    let file_name = file.to_owned();
    let bytes = files.read(file, SHEET_BYTES_MOST).map_err(|why| {
        let message = WrongTable::File {
            key: KEY.to_owned(),
            file: file.to_owned(),
            why: said(&why),
        };
        (message.into(), WrongSurveys::Columns.into())
    })?;
    read_dated_sheet(&bytes, file, sheet).map_err(|why| {
        let why = said(&why);
        let file = file_name;
        (
            WrongTable::Sheet { file, why }.into(),
            WrongSurveys::Columns.into(),
        )
    })
}

type Written = (String, BTreeMap<String, String>);

/// The surveys as TOML, and the cell of each value.
fn listed(
    file: &str,
    rows: &[Vec<SheetCell>],
    ignored: &[&str],
    root: &DeTable<'_>,
) -> Result<Written, Vec<Wrong>> {
    let Some((header, body)) = rows.split_first() else {
        return Ok((String::new(), BTreeMap::new()));
    };
    let heads = heads(file, header, ignored)?;
    let date_at = heads.iter().position(|head| of(head) == Some(&Held::Date));
    let Some(date_at) = date_at else {
        let file = file.to_owned();
        return Err(vec![(
            WrongSurveys::NoDates { file }.into(),
            WrongSurveys::Columns.into(),
        )]);
    };
    let (mut faults, mut text, mut places) = (Vec::new(), String::from("[survey]\n"), BTreeMap::new());
    let mut dates: BTreeMap<[u32; 3], String> = BTreeMap::new();
    for row in body {
        let survey = dated(file, row, date_at).and_then(|(date, name, cell)| {
            let other = dates.insert(date, row_of(cell));
            only_once(file, cell, (date, &name), other, root)?;
            survey(file, row, &heads, &name, &mut places).map(|own| (name, own))
        });
        match survey {
            Ok((name, own)) => {
                let _ = writeln!(text, "{} = {{ {own} }}", quoted(&name)); // into a String: cannot fail
            }
            Err(wrong) => faults.push(wrong),
        }
    }
    match faults.is_empty() {
        true => Ok((text, places)),
        false => Err(faults),
    }
}

fn of(head: &Option<Head>) -> Option<&Held> {
    head.as_ref().map(|head| &head.held)
}

/// "12" of "C12".
fn row_of(cell: &SheetCell) -> String {
    cell.place
        .trim_start_matches(|sign: char| sign.is_ascii_uppercase())
        .to_owned()
}

/// The columns; `None` for an ignored or empty one.
fn heads(file: &str, header: &[SheetCell], ignored: &[&str]) -> Result<Vec<Option<Head>>, Vec<Wrong>> {
    let (mut heads, mut faults): (Vec<Option<Head>>, Vec<Wrong>) = (Vec::new(), Vec::new());
    for cell in header {
        let SheetValue::Text(head) = &cell.value else {
            heads.push(None);
            continue;
        };
        if ignored.contains(&head.trim()) {
            heads.push(None);
            continue;
        }
        match self::head(file, cell, head) {
            Ok(own) if heads.iter().any(|other| of(other) == Some(&own.held)) => {
                let message = WrongTable::CellColumnIsThere {
                    file: file.to_owned(),
                    place: cell.place.clone(),
                    of: head.clone(),
                };
                faults.push((message.into(), Common::KeepOneOfThem.into()));
            }
            Ok(own) => heads.push(Some(own)),
            Err(wrong) => faults.push(wrong),
        }
    }
    for own in heads.iter().flatten() {
        if let Held::FrequencySd(direction, number) = &own.held {
            let whose = Held::Frequency(direction.clone(), *number);
            if !heads.iter().any(|other| of(other) == Some(&whose)) {
                let message = WrongSurveys::SdAlone {
                    file: file.to_owned(),
                    place: own.cell.place.clone(),
                    head: shown(&own.cell),
                };
                faults.push((message.into(), WrongSurveys::Columns.into()));
            }
        }
    }
    match faults.is_empty() {
        true => Ok(heads),
        false => Err(faults),
    }
}

/// The text of a cell.
fn shown(cell: &SheetCell) -> String {
    match &cell.value {
        SheetValue::Text(text) => text.clone(),
        SheetValue::Number(number) => number.to_string(),
        SheetValue::Empty => String::new(),
    }
}

/// The contents of a column, with a unit of the right kind.
fn head(file: &str, cell: &SheetCell, head: &str) -> Result<Head, Wrong> {
    let (name, unit) = with_unit(head);
    let (file, place) = (file.to_owned(), cell.place.clone());
    let Some(held) = held(name) else {
        let message = WrongTable::CellIsNoColumn {
            file,
            place,
            head: head.to_owned(),
            key: KEY.to_owned(),
        };
        return Err((message.into(), WrongSurveys::Columns.into()));
    };
    let measure = match &held {
        Held::Frequency(..) | Held::FrequencySd(..) => Some(Measure::Frequency),
        Held::Crack(..) => Some(Measure::Length),
        _ => None,
    };
    match (&held, unit, measure) {
        (Held::Temperature, Some(unit), _) if !["℃", "°C", "C", "degC", "deg C"].contains(&unit) => {
            let unit = unit.to_owned();
            Err((
                WrongSurveys::NotCelsius { file, place, unit }.into(),
                WrongSurveys::ConvertToCelsius.into(),
            ))
        }
        (Held::Crack(..) | Held::Tilt(_), None, _) => {
            let head = head.to_owned();
            Err((
                WrongSurveys::NoUnit { file, place, head }.into(),
                WrongSurveys::GiveUnit.into(),
            ))
        }
        (_, Some(unit), Some(measure)) if !is_of(unit, measure) => {
            let needs = WrongTable::ColumnNeedsButIts {
                name: name.to_owned(),
                needed: measure.dimension().said(),
                unit: unit.to_owned(),
            };
            let said = needs.into();
            let example = measure.example();
            Err((
                WrongTable::Cell { file, place, said }.into(),
                Common::UseUnitSuchAs(example).into(),
            ))
        }
        _ => Ok(Head {
            held,
            unit: unit.map(str::to_owned),
            cell: cell.clone(),
        }),
    }
}

fn is_of(unit: &str, measure: Measure) -> bool {
    let read = parse_unit(unit).ok();
    read.and_then(|read| read.measuring(measure.dimension()))
        .is_some()
}

/// The date of a row, the survey's name, and its cell.
fn dated<'r>(
    file: &str,
    row: &'r [SheetCell],
    date_at: usize,
) -> Result<([u32; 3], String, &'r SheetCell), Wrong> {
    let cell = row.get(date_at).or(row.first());
    let given = cell.map(shown).unwrap_or_default();
    let found = cell.filter(|_| row.len() > date_at).zip(date_of(given.trim()));
    let Some((cell, date)) = found else {
        let message = WrongSurveys::NoDate {
            file: file.to_owned(),
            place: cell.map_or_else(String::new, |cell| cell.place.clone()),
            given,
        };
        return Err((message.into(), WrongSurveys::WriteDate.into()));
    };
    let name = match date {
        [year, 0, _] => format!("{year:04}"),
        [year, month, 0] => format!("{year:04}-{month:02}"),
        [year, month, day] => format!("{year:04}-{month:02}-{day:02}"),
    };
    Ok((date, name, cell))
}

/// Rejects a date that another row or the project file has.
fn only_once(
    file: &str,
    cell: &SheetCell,
    (date, name): ([u32; 3], &str),
    other: Option<String>,
    root: &DeTable<'_>,
) -> Result<(), Wrong> {
    let (file, place) = (file.to_owned(), cell.place.clone());
    let date_text = name.to_owned();
    if let Some(other) = other {
        let message = WrongSurveys::SameDate {
            file,
            place,
            date: date_text,
            other,
        };
        return Err((message.into(), WrongSurveys::KeepOneRow.into()));
    }
    let surveys = root.get("survey").and_then(|value| value.get_ref().as_table());
    let mut names = surveys.into_iter().flatten().map(|(name, _)| name.get_ref());
    match names.find(|name| date_of(name) == Some(date)) {
        None => Ok(()),
        Some(survey) => {
            let message = WrongSurveys::AlsoInFile {
                file,
                place,
                date: date_text,
                survey: survey.to_string(),
            };
            Err((message.into(), WrongSurveys::KeepOnePlace.into()))
        }
    }
}

/// A row as the keys of its survey.
fn survey(
    file: &str,
    row: &[SheetCell],
    heads: &[Option<Head>],
    name: &str,
    places: &mut BTreeMap<String, String>,
) -> Result<String, Wrong> {
    let path = format!("survey.{name}");
    let (mut keys, mut tilts, mut cracks): (Vec<String>, Vec<String>, Vec<String>) = Default::default();
    let mut frequencies: BTreeMap<&str, BTreeMap<u32, (&SheetCell, String)>> = BTreeMap::new();
    let mut sds: BTreeMap<(&str, u32), f64> = BTreeMap::new();
    for (at, cell) in row.iter().enumerate() {
        let Some(head) = heads.get(at).and_then(Option::as_ref).filter(|_| is_given(cell)) else {
            continue;
        };
        let value = written("", &cell.value, head.unit.as_deref());
        match &head.held {
            Held::Date => {
                places.insert(path.clone(), cell.place.clone());
            }
            Held::Temperature => {
                keys.push(format!("temperature_c = {:?}", number_of(file, cell)?));
                places.insert(format!("{path}.temperature_c"), cell.place.clone());
            }
            Held::Frequency(direction, number) => {
                frequencies
                    .entry(direction)
                    .or_default()
                    .insert(*number, (cell, value));
            }
            Held::FrequencySd(direction, number) => {
                let unit = unit_of(heads, &Held::Frequency(direction.clone(), *number));
                let own = unit_factor(head.unit.as_deref()) / unit_factor(unit);
                sds.insert((direction, *number), own * number_of(file, cell)?);
            }
            Held::Tilt(direction) => {
                tilts.push(format!("{direction} = {value}"));
                places.insert(format!("{path}.tilt.{direction}"), cell.place.clone());
            }
            Held::Crack(crack, part) => {
                let (part, crack) = (quoted(part), quoted(crack));
                cracks.push(format!(
                    "{{ part = {part}, what = \"crack\", name = {crack}, size = {value} }}"
                ));
                places.insert(
                    format!("{path}.inspections[{}]", cracks.len()),
                    cell.place.clone(),
                );
            }
            Held::Datum => keys.push(format!("datum = {}", quoted(&shown(cell)))),
            Held::Note => keys.push(format!("note = {}", quoted(&shown(cell)))),
        }
    }
    let mut of_directions = Vec::new();
    for (direction, numbered) in &frequencies {
        let mut listed = Vec::new();
        for (number, (cell, value)) in numbered {
            places.insert(
                format!("{path}.frequencies.{direction}[{}]", listed.len() + 1),
                cell.place.clone(),
            );
            listed.push(match sds.get(&(*direction, *number)) {
                Some(sd) => format!("{{ value = {value}, sd = {sd:?} }}"),
                None => value.clone(),
            });
        }
        of_directions.push(format!("{direction} = [{}]", listed.join(", ")));
    }
    for (key, all, signs) in [
        ("tilt", tilts, ["{ ", " }"]),
        ("frequencies", of_directions, ["{ ", " }"]),
        ("inspections", cracks, ["[", "]"]),
    ] {
        if !all.is_empty() {
            keys.push(format!("{key} = {}{}{}", signs[0], all.join(", "), signs[1]));
        }
    }
    Ok(keys.join(", "))
}

/// Whether a cell holds a reading.
fn is_given(cell: &SheetCell) -> bool {
    match &cell.value {
        SheetValue::Empty => false,
        SheetValue::Number(_) => true,
        SheetValue::Text(text) => !MISSING.contains(&text.trim().to_lowercase().as_str()),
    }
}

fn unit_of<'h>(heads: &'h [Option<Head>], held: &Held) -> Option<&'h str> {
    let mut heads = heads.iter().flatten();
    heads.find(|head| head.held == *held)?.unit.as_deref()
}

/// Hz of a unit of frequency.
pub(super) fn unit_factor(unit: Option<&str>) -> f64 {
    unit.and_then(|unit| parse_unit(unit).ok()?.measuring(Measure::Frequency.dimension()))
        .map_or(1.0, |unit| unit.factor)
}

fn number_of(file: &str, cell: &SheetCell) -> Result<f64, Wrong> {
    let number = match &cell.value {
        SheetValue::Number(number) => Some(*number),
        SheetValue::Text(text) => text.trim().parse().ok(),
        SheetValue::Empty => None,
    };
    let message = WrongSurveys::NoNumber {
        file: file.to_owned(),
        place: cell.place.clone(),
        given: shown(cell),
    };
    let wrong = (message.into(), WrongSurveys::WriteNumber.into());
    number.filter(|number| number.is_finite()).ok_or(wrong)
}

#[cfg(test)]
mod tests {
    use crate::read::parse_project_with;
    use crate::{Project, ProjectError};
    use dolmen_records::{FileError, Files};

    #[derive(Debug)]
    struct One(&'static str);

    impl Files for One {
        fn read(&self, _name: &str, _most: u64) -> Result<Vec<u8>, FileError> {
            Ok(self.0.as_bytes().to_vec())
        }
    }

    fn read(table: &'static str, more: &str) -> Result<Project, ProjectError> {
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Tower\"\nsurveys = {{ file = \"list.csv\", ignore = [\"조사자\"] }}\n{more}"
        );
        parse_project_with(&text, "p.toml", &One(table))
    }

    fn refused(table: &'static str, more: &str) -> [String; 2] {
        let why = read(table, more).unwrap_err();
        let problem = &why.problems[0];
        let help = problem
            .help
            .as_ref()
            .map_or_else(String::new, |help| help.english.clone());
        [problem.message.english.clone(), help]
    }

    #[test]
    fn exact_rows_are_the_surveys_that_they_would_be_in_the_file() {
        let table = "조사일,조사자,기온(℃),X 진동수(Hz),X 진동수 표준편차(Hz),Y 진동수(Hz),기울기 X(mm/m),비고\n\
            2016. 5. 3.,김,24.1,2.938,0.006,3.125,11.15,맑음\n\
            2016-11-05,이,-,2.981,0.006,결측,11.19,\n\
            20170518,,28,2.946,,3.11,,\n";
        let own = "[survey.2018-05-01]\ntemperature_c = 20\n";
        let by_hand = r#"
            [survey.2016-05-03]
            temperature_c = 24.1
            frequencies = { x = [{ value = "2.938 Hz", sd = 0.006 }], y = ["3.125 Hz"] }
            tilt = { x = "11.15 mm/m" }
            note = "맑음"
            [survey.2016-11-05]
            frequencies = { x = [{ value = "2.981 Hz", sd = 0.006 }] }
            tilt = { x = "11.19 mm/m" }
            [survey.2017-05-18]
            temperature_c = 28
            frequencies = { x = ["2.946 Hz"], y = ["3.11 Hz"] }
            "#;
        let tabled = read(table, own).unwrap();
        let text = format!("schema = 1\nkind = \"survey\"\nname = \"Tower\"\n{by_hand}{own}");
        let written = parse_project_with(&text, "p.toml", &One("")).unwrap();
        assert_eq!(tabled.surveys, written.surveys);
        assert_eq!(tabled.surveys.len(), 4);
    }

    #[test]
    fn exact_heads_in_radians_per_second_become_hertz() {
        let table =
            "date,frequency x 1 (rad/s),frequency x 1 sd (Hz),frequency y (deg/s)\n2016-05-03,12,0.01,720\n";
        let project = read(table, "").unwrap();
        let modes = &project.surveys[0].modes;
        let [x, y] = ["x", "y"].map(|axis| &modes[axis][0].frequency);
        let hertz = 12.0 / std::f64::consts::TAU;
        assert!((x.value / hertz - 1.0).abs() < 1e-14, "{}", x.value);
        assert!((x.cov.unwrap() * hertz / 0.01 - 1.0).abs() < 1e-12, "{:?}", x.cov);
        assert!((y.value - 2.0).abs() < 1e-14, "{}", y.value);
        assert_eq!(x.written, "12 rad/s");
    }

    #[test]
    fn refuses_a_date_twice_and_names_the_rows() {
        let table = "date,frequency x\n2016-05-03,2.9\n2016. 5. 3.,2.8\n";
        let [said, help] = refused(table, "");
        assert_eq!(said, "list.csv, cell A3: 2016-05-03 is in row 2 already");
        assert!(help.contains("one row is one survey"), "{help}");
        let [said, _] = refused(
            "date,frequency x\n2016-05-03,2.9\n",
            "[survey.2016-05-03]\ntemperature_c = 3\n",
        );
        assert_eq!(
            said,
            "list.csv, cell A2: 2016-05-03 is also [survey.\"2016-05-03\"] of the project file"
        );
    }

    #[test]
    fn refuses_what_is_no_reading_with_its_cell() {
        for (table, cell, word) in [
            ("date,frequency x\nspring,2.9\n", "cell A2", "no date"),
            ("date,frequency x\n,2.9\n", "cell A2", "no date"),
            ("date,weather\n2016-05-03,2.9\n", "cell B1", "no column"),
            ("frequency x,tilt x (mm/m)\n2.9,3\n", "list.csv", "no column date"),
            ("date,frequency x,fx\n2016-05-03,2.9,3\n", "cell C1", "twice"),
            (
                "date,frequency x 1 sd\n2016-05-03,2.9\n",
                "cell B1",
                "no column of its frequency",
            ),
            ("date,frequency x (mm)\n2016-05-03,2.9\n", "cell B1", "needs"),
            ("date,temperature (°F)\n2016-05-03,70\n", "cell B1", "°C"),
            ("date,temperature\n2016-05-03,warm\n", "cell B2", "no number"),
            ("date,tilt x\n2016-05-03,11\n", "cell B1", "no unit"),
            // errors of the file's reader
            ("date,temperature\n2016-05-03,240\n", "cell B2", "240"),
            ("date,frequency x\n2016-05-03,-2.9\n", "cell B2", "-2.9"),
            ("date,tilt x (mm/m)\n2016-05-03,900\n", "cell B2", "fallen"),
            ("date,f x 1,f x 2\n2016-05-03,2.9,2.8\n", "cell C2", "above"),
        ] {
            let [said, help] = refused(table, "");
            assert!(said.contains(cell) && said.contains(word), "{table:?}: {said}");
            assert!(!help.is_empty() || word.len() < 7, "{table:?}: no help");
        }
    }
}
