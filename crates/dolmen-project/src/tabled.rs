//! Lists of parts that stand in a table beside the project file: `blocks = { file = "stones.xlsx", sheet = "stones" }`. Each row becomes one
//! entry of the list, as if it were written there, so that everything behind it holds for it too.

use super::error::Fault;
use super::measure::Measure;
use super::placed::place;
use super::totals::{Total, total};
use super::units::parse_unit;
use super::wrong::{Common, WrongTable};
use crate::wrong::said;
use dolmen_records::{Files, SHEET_BYTES_MOST, SheetCell, SheetValue, read_sheet};
use dolmen_words::message::Both;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;
use toml::de::{DeTable, DeValue};

/// A column: the key that it stands for, what else its head may be, and what it measures.
pub(super) type Column = (&'static str, &'static [&'static str], Option<Measure>);

const BLOCKS: &[Column] = &[
    ("name", &["이름", "부재", "부재명"], None),
    ("shape", &["형상"], None),
    ("width", &["폭", "너비"], Some(Measure::Length)),
    ("depth", &["깊이", "두께"], Some(Measure::Length)),
    ("height", &["높이"], Some(Measure::Length)),
    ("top_width", &["상부 폭", "상부폭"], Some(Measure::Length)),
    ("top_depth", &["상부 깊이", "상부깊이"], Some(Measure::Length)),
    ("diameter", &["지름", "직경"], Some(Measure::Length)),
    ("top_diameter", &["상부 지름", "상부지름"], Some(Measure::Length)),
    ("sides", &["변 수", "변수"], None),
    ("density", &["밀도"], Some(Measure::Density)),
];
const LINKS: &[Column] = &[
    ("name", &["이름", "부재", "부재명"], None),
    ("weight", &["무게", "중량"], Some(Measure::Force)),
    ("mass", &["질량"], Some(Measure::Mass)),
    ("length", &["길이", "높이"], Some(Measure::Length)),
    ("centroid", &["무게중심", "무게중심 높이"], Some(Measure::Length)),
    ("breadth", &["폭", "너비"], Some(Measure::Length)),
    ("bed_width", &["접합면 폭", "접합면폭"], Some(Measure::Length)),
];
const STOREYS: &[Column] = &[
    ("name", &["이름", "층"], None),
    ("weight", &["무게", "중량"], Some(Measure::Force)),
    ("mass", &["질량"], Some(Measure::Mass)),
    ("height", &["높이", "층고"], Some(Measure::Length)),
    ("axial_force", &["축력"], Some(Measure::Force)),
];
const LISTS: [(&str, &[Column]); 3] = [("blocks", BLOCKS), ("links", LINKS), ("storeys", STOREYS)];

/// A list that was read from a table.
pub(super) struct Tabled {
    span: Range<usize>,
    /// The list as it would be written.
    text: String,
    file: String,
    /// The cell of each value by its path, and of each row.
    places: BTreeMap<String, String>,
    /// The survey in whose table it belongs; `None` for a list of the file.
    survey: Option<String>,
}

impl Tabled {
    /// Modes of a survey.
    pub(super) fn of_survey(span: Range<usize>, text: String, survey: String) -> Self {
        Tabled {
            span,
            text,
            file: String::new(),
            places: BTreeMap::new(),
            survey: Some(survey),
        }
    }

    /// The list in place of the table that names it; its faults stand where the project file names it.
    pub(super) fn put<'i>(&'i self, root: &mut DeTable<'i>) {
        let Ok(parsed) = DeTable::parse(&self.text) else {
            return; // written here
        };
        let within = match &self.survey {
            None => Some(root),
            Some(survey) => table_in(root, "survey").and_then(|surveys| table_in(surveys, survey)),
        };
        let Some(within) = within else { return };
        for (key, mut value) in parsed.into_inner() {
            place(&mut value, &self.span);
            within.insert(key, value);
        }
    }

    /// Names the cell of what is wrong in one of the lists.
    pub(super) fn name_cells(all: &[Tabled], faults: &mut [Fault]) {
        for fault in faults {
            let found = all.iter().find_map(|tabled| {
                let exact = tabled.places.get(&fault.path);
                let row = || {
                    fault
                        .path
                        .split_once(']')
                        .and_then(|(row, _)| tabled.places.get(&format!("{row}]")))
                };
                Some((tabled, exact.or_else(row)?))
            });
            if let Some((tabled, place)) = found {
                fault.say_cell(&tabled.file, place);
            }
        }
    }
}

/// The table at a key of another.
fn table_in<'t, 'i>(table: &'t mut DeTable<'i>, key: &str) -> Option<&'t mut DeTable<'i>> {
    match table.get_mut(key)?.get_mut() {
        DeValue::Table(inner) => Some(inner),
        _ => None,
    }
}

/// Every list that stands in a table; none of a text that is not TOML.
pub(super) fn tabled(text: &str, files: &dyn Files) -> Result<Vec<Tabled>, Vec<Fault>> {
    let (root, syntax) = DeTable::parse_recoverable(text);
    let root = root.into_inner();
    if !syntax.is_empty() {
        return Ok(Vec::new());
    }
    let (mut all, mut faults) = (Vec::new(), Vec::new());
    for (key, columns) in LISTS {
        let Some(given) = root.get(key) else { continue };
        let DeValue::Table(table) = given.get_ref() else {
            continue;
        };
        let word = |name: &str| table.get(name).and_then(|value| value.get_ref().as_str());
        let Some(file) = word("file") else { continue };
        let at = |path: &str, message: Both| Fault::new(given.span(), path, message);
        if let Some((other, _)) = table
            .iter()
            .find(|(name, _)| !["file", "sheet"].contains(&name.get_ref().as_ref()))
        {
            let name = other.get_ref();
            let fault = Fault::new(
                other.span(),
                &format!("{key}.{name}"),
                WrongTable::HasKeyBesideFile {
                    key: key.to_string(),
                    name: name.to_string(),
                },
            );
            faults.push(fault.allowed(WrongTable::MustBeFileAnd));
            continue;
        }
        let bytes = match files.read(file, SHEET_BYTES_MOST) {
            Ok(bytes) => bytes,
            Err(why) => {
                faults.push(at(
                    key,
                    Both::from(WrongTable::File {
                        key: key.to_string(),
                        file: file.to_string(),
                        why: said(&why),
                    }),
                ));
                continue;
            }
        };
        let rows = match read_sheet(&bytes, file, word("sheet")) {
            Ok(rows) => rows,
            Err(why) => {
                let (file, why) = (file.to_owned(), said(&why));
                faults.push(at(key, WrongTable::Sheet { file, why }.into()));
                continue;
            }
        };
        match list(key, columns, &rows, &root, file) {
            Ok((text, places)) => all.push(Tabled {
                span: given.span(),
                text,
                file: file.to_owned(),
                places,
                survey: None,
            }),
            Err(why) => faults.extend(why.into_iter().map(|(message, help)| at(key, message).help(help))),
        }
    }
    match faults.is_empty() {
        true => Ok(all),
        false => Err(faults),
    }
}

/// The unit of bare numbers that the file gives for a measure.
fn unit_of_file<'a>(root: &'a DeTable<'_>, measure: Measure) -> Option<(&'static str, &'a str)> {
    let key = match measure {
        Measure::Length => "length",
        Measure::Force => "force",
        Measure::Mass => "mass",
        Measure::Density => "density",
        _ => return None,
    };
    let units = root.get("units")?.get_ref().as_table()?;
    Some((key, units.get(key)?.get_ref().as_str()?))
}

type Written = (String, BTreeMap<String, String>);

/// The rows as a list in TOML, and the place of each value; or what is wrong, with what to do.
fn list(
    key: &'static str,
    columns: &[Column],
    rows: &[Vec<SheetCell>],
    root: &DeTable<'_>,
    file: &str,
) -> Result<Written, Vec<(Both, Both)>> {
    let (header, body) = rows.split_first().unwrap_or((&rows[0], &[]));
    let heads = heads(key, columns, header, root, file)?;
    refuse_total(&heads, body, file)?;
    let mut faults = Vec::new();
    let mut text = format!("{key} = [");
    let mut places = BTreeMap::new();
    for (number, row) in (1..).zip(body) {
        text.push_str("{ ");
        let path = format!("{key}[{number}]");
        for (at, cell) in row.iter().enumerate() {
            let head = heads.get(at).and_then(Option::as_ref);
            if cell.value == SheetValue::Empty {
                // where a value is missing, its cell is what must be filled
                places.extend(head.map(|(name, _)| (format!("{path}.{name}"), cell.place.clone())));
                continue;
            }
            let Some((name, unit)) = head else {
                let message = WrongTable::CellStandsUnderNo {
                    file: file.to_string(),
                    place: cell.place.to_string(),
                };
                faults.push((message.into(), WrongTable::NameColumnInFirst.into()));
                continue;
            };
            let value = written(name, &cell.value, unit.as_deref());
            let _ = write!(text, "{name} = {value}, "); // into a String: cannot fail
            places.entry(path.clone()).or_insert_with(|| cell.place.clone());
            places.insert(format!("{path}.{name}"), cell.place.clone());
        }
        text.push_str("}, ");
        if row.iter().all(|cell| cell.value == SheetValue::Empty) {
            let place = row.first().map_or("", |cell| cell.place.as_str());
            faults.push((
                WrongTable::CellRowIsEmpty {
                    file: file.to_string(),
                    place: place.to_string(),
                }
                .into(),
                WrongTable::DeleteRow.into(),
            ));
        }
    }
    text.push(']');
    match faults.is_empty() {
        true => Ok((text, places)),
        false => Err(faults),
    }
}

/// A head of the table: the key that its column stands for, and its unit.
type Head = (&'static str, Option<String>);

/// The heads of a table, `None` over a column without one.
fn heads(
    key: &'static str,
    columns: &[Column],
    header: &[SheetCell],
    root: &DeTable<'_>,
    file: &str,
) -> Result<Vec<Option<Head>>, Vec<(Both, Both)>> {
    let mut faults = Vec::new();
    let mut heads: Vec<Option<Head>> = Vec::new();
    for cell in header {
        let SheetValue::Text(head) = &cell.value else {
            // an empty head over an empty column is no column
            heads.push(None);
            continue;
        };
        match column(head, columns) {
            Some((of, _)) if heads.iter().flatten().any(|(known, _)| *known == of.0) => {
                let message = WrongTable::CellColumnIsThere {
                    file: file.to_string(),
                    place: cell.place.to_string(),
                    of: of.0.to_string(),
                };
                faults.push((message.into(), Common::KeepOneOfThem.into()));
            }
            Some((of, unit)) => match checked_unit(of, unit, root) {
                Ok(unit) => heads.push(Some((of.0, unit))),
                Err((said, help)) => faults.push((
                    Both::from(WrongTable::Cell {
                        file: file.to_string(),
                        place: cell.place.to_string(),
                        said,
                    }),
                    help,
                )),
            },
            None => {
                let known: Vec<&str> = columns.iter().map(|(known, ..)| *known).collect();
                let message = WrongTable::CellIsNoColumn {
                    file: file.to_string(),
                    place: cell.place.to_string(),
                    head: head.to_string(),
                    key: key.to_string(),
                };
                let help = WrongTable::NameItOneOf {
                    known: known.join(", "),
                };
                faults.push((message.into(), help.into()));
            }
        }
    }
    match faults.is_empty() {
        true => Ok(heads),
        false => Err(faults),
    }
}

/// Refuses a row that is the total of the others.
fn refuse_total(
    heads: &[Option<Head>],
    body: &[Vec<SheetCell>],
    file: &str,
) -> Result<(), Vec<(Both, Both)>> {
    let name_at = heads
        .iter()
        .position(|head| head.as_ref().is_some_and(|(name, _)| *name == "name"));
    if let Some(total) = total(body, name_at) {
        let file = file.to_owned();
        let message = match total {
            Total::Named(cell) => WrongTable::RowIsTotal {
                file,
                place: cell.place.clone(),
                name: match &cell.value {
                    SheetValue::Text(text) => text.clone(),
                    SheetValue::Number(_) | SheetValue::Empty => String::new(),
                },
            },
            Total::Sums(cell) => WrongTable::RowIsSum {
                file,
                place: cell.place.clone(),
            },
        };
        return Err(vec![(message.into(), WrongTable::DeleteTotal.into())]);
    }
    Ok(())
}

/// "width (mm)" → the column and its unit.
pub(super) fn column<'a>(head: &'a str, columns: &'a [Column]) -> Option<(&'a Column, Option<&'a str>)> {
    let (name, unit) = match head.split_once(['(', '[']) {
        Some((name, unit)) => (name, Some(unit.trim_end_matches([')', ']', ' ']).trim())),
        None => (head, None),
    };
    let name = name.trim().to_lowercase();
    let key = name.replace([' ', '-'], "_");
    let found = columns
        .iter()
        .find(|(known, others, _)| *known == key || others.contains(&name.as_str()));
    found.map(|column| (column, unit.filter(|unit| !unit.is_empty())))
}

/// The unit of a column, if its head has one: of the right kind, and that of the file where that has one.
pub(super) fn checked_unit(
    column: &Column,
    unit: Option<&str>,
    root: &DeTable<'_>,
) -> Result<Option<String>, (Both, Both)> {
    let (name, _, measure) = column;
    let Some(unit) = unit else { return Ok(None) };
    let Some(measure) = measure else {
        return Err((
            WrongTable::ColumnHasNoUnit {
                name: name.to_string(),
                unit: unit.to_string(),
            }
            .into(),
            Common::TakeItOut.into(),
        ));
    };
    let needed = measure.dimension();
    let read = parse_unit(unit).ok().and_then(|read| read.measuring(needed));
    let Some(read) = read else {
        let said = WrongTable::ColumnNeedsButIts {
            name: name.to_string(),
            needed: needed.said(),
            unit: unit.to_string(),
        };
        return Err((
            said.into(),
            Common::UseUnitSuchAs {
                example: measure.example(),
            }
            .into(),
        ));
    };
    if let Some((key, of_file)) = unit_of_file(root, *measure)
        && parse_unit(of_file).is_ok_and(|own| own.factor != read.factor)
    {
        let said = WrongTable::ColumnIsInBut {
            name: name.to_string(),
            unit: unit.to_string(),
            key: key.to_string(),
            of_file: of_file.to_string(),
        };
        return Err((said.into(), WrongTable::SayOneUnitIn.into()));
    }
    Ok(Some(unit.to_owned()))
}

/// A value as TOML: names and shapes are words, numbers carry the unit of their head.
pub(super) fn written(name: &str, value: &SheetValue, unit: Option<&str>) -> String {
    let is_words = ["name", "shape"].contains(&name);
    match value {
        SheetValue::Number(number) if is_words => quoted(&number.to_string()),
        SheetValue::Number(number) => match unit {
            Some(unit) => quoted(&format!("{number} {unit}")),
            None => number.to_string(),
        },
        // a spreadsheet keeps numbers as text where a cell was formatted so
        SheetValue::Text(text) if !is_words && is_number(text) => match unit {
            Some(unit) => quoted(&format!("{} {unit}", text.trim())),
            None => text.trim().to_owned(),
        },
        SheetValue::Text(text) => quoted(text),
        SheetValue::Empty => quoted(""),
    }
}

fn is_number(text: &str) -> bool {
    let text = text.trim();
    text.starts_with(|sign: char| sign.is_ascii_digit() || sign == '-')
        && text.ends_with(|sign: char| sign.is_ascii_digit())
        && text.parse::<f64>().is_ok()
}

pub(super) fn quoted(text: &str) -> String {
    let mut said = String::from("\"");
    for sign in text.chars() {
        match sign {
            '"' | '\\' => said.extend(['\\', sign]),
            // what steers a terminal is no part of a name
            sign if sign.is_control() => said.push(' '),
            sign => said.push(sign),
        }
    }
    said.push('"');
    said
}
