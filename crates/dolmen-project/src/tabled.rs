//! Lists of parts that stand in a table beside the project file: `blocks = { file = "stones.xlsx", sheet = "stones" }`. Each row becomes one
//! entry of the list, as if it were written in the file, so that all later steps apply to it.

use super::error::Fault;
use super::measure::Measure;
use super::placed::place;
use super::tabled_heads::{Column, LISTS};
use super::totals::{Total, total};
use super::units::parse_unit;
use super::unread_columns::{Unread, unread};
use super::wrong::{Common, WrongTable};
use crate::content::{Warning, WarningKind};
use crate::doubted::Doubted;
use crate::warned::Warned;
use crate::wrong::said;
use dolmen_records::{Files, SHEET_BYTES_MOST, SheetCell, SheetValue, is_misspelt, read_sheet};
use dolmen_words::message::Both;
use std::collections::BTreeMap;
use std::fmt::Write as _;
use std::ops::Range;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A list that was read from a table.
pub(super) struct Tabled {
    span: Range<usize>,
    /// The list in TOML.
    text: String,
    file: String,
    /// The cell of each value by its path, and of each row.
    places: BTreeMap<String, String>,
    /// Heads of columns that no part uses.
    left_out: Vec<String>,
    /// Heads of those that hold numbers of unknown meaning.
    unread: Vec<String>,
    /// The survey that the list belongs to; `None` for a list of the file.
    survey: Option<String>,
}

impl Tabled {
    /// Surveys, each a separate table.
    pub(super) fn of_surveys(
        span: Range<usize>,
        text: String,
        file: String,
        places: BTreeMap<String, String>,
    ) -> Self {
        Tabled {
            span,
            text,
            file,
            places,
            left_out: Vec::new(),
            unread: Vec::new(),
            survey: None,
        }
    }

    /// Modes of a survey.
    pub(super) fn of_survey(span: Range<usize>, text: String, survey: String) -> Self {
        Tabled {
            span,
            text,
            file: String::new(),
            places: BTreeMap::new(),
            left_out: Vec::new(),
            unread: Vec::new(),
            survey: Some(survey),
        }
    }

    /// Warnings about the columns that were not read.
    pub(super) fn warnings(&self, text: &str) -> Vec<Warning> {
        let key = self.text.split(' ').next().unwrap_or_default();
        let file = || self.file.clone();
        let noted = (!self.left_out.is_empty()).then(|| {
            let heads = self.left_out.clone();
            let said = Warned::ColumnsLeftOut { file: file(), heads };
            Warning::new(WarningKind::ColumnsLeftOut, key, said.into())
        });
        let doubted = (!self.unread.is_empty()).then(|| {
            let heads = self.unread.clone();
            let said = Doubted::ColumnsUnread { file: file(), heads };
            Warning::new(WarningKind::Doubtful, key, said.into())
        });
        let line = Fault::new(self.span.clone(), "", "").locate(text).line;
        let all = doubted.into_iter().chain(noted);
        all.map(|warning| Warning { line, ..warning }).collect()
    }

    /// Replaces the table that names a file by the list; faults of the list have the place of that table.
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
            // these surveys are added to those of the file
            let known = within
                .get_mut(key.get_ref().as_ref())
                .map(|known| known.get_mut());
            match (known, value.into_inner()) {
                (Some(DeValue::Table(known)), DeValue::Table(more)) if key.get_ref() == "survey" => {
                    known.extend(more);
                }
                (_, value) => {
                    within.insert(key, Spanned::new(self.span.clone(), value));
                }
            }
        }
    }

    /// Names the cell of each fault in one of the lists.
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
                // a fault in a part of a value
                let above = || {
                    let all = tabled.places.iter();
                    all.filter(|(path, _)| fault.is_at_or_below(path))
                        .map(|(_, cell)| cell)
                        .next_back()
                };
                Some((tabled, exact.or_else(row).or_else(above)?))
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

/// Every list in a table beside the file; empty for a text that is not TOML.
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
            Ok(list) => all.push(Tabled {
                span: given.span(),
                file: file.to_owned(),
                ..list
            }),
            Err(why) => faults.extend(why.into_iter().map(|(message, help)| at(key, message).help(help))),
        }
    }
    match faults.is_empty() {
        true => Ok(all),
        false => Err(faults),
    }
}

/// The file's unit of bare numbers for a measure.
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

/// The rows as a list in TOML, and the place of each value; or the error and its remedy.
fn list(
    key: &'static str,
    columns: &[Column],
    rows: &[Vec<SheetCell>],
    root: &DeTable<'_>,
    file: &str,
) -> Result<Tabled, Vec<(Both, Both)>> {
    let (header, body) = rows.split_first().unwrap_or((&rows[0], &[]));
    let heads = heads(key, columns, (header, body), root, file)?;
    refuse_total(&heads, body, file)?;
    let mut faults = Vec::new();
    let mut text = format!("{key} = [");
    let mut places = BTreeMap::new();
    for (number, row) in (1..).zip(body) {
        text.push_str("{ ");
        let path = format!("{key}[{number}]");
        for (at, cell) in row.iter().enumerate() {
            let (name, unit) = match heads.get(at).unwrap_or(&Head::Missing) {
                Head::LeftOut(..) => continue,
                // the cell of a missing value must be filled
                Head::Of(name, _) if cell.value == SheetValue::Empty => {
                    places.insert(format!("{path}.{name}"), cell.place.clone());
                    continue;
                }
                Head::Of(name, unit) => (name, unit),
                Head::Missing if cell.value == SheetValue::Empty => continue,
                Head::Missing => {
                    let message = WrongTable::CellStandsUnderNo {
                        file: file.to_string(),
                        place: cell.place.to_string(),
                    };
                    faults.push((message.into(), WrongTable::NameColumnInFirst.into()));
                    continue;
                }
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
    let left_out = |which: Unread| -> Vec<String> {
        let heads = heads.iter().filter_map(move |head| match head {
            Head::LeftOut(head, of) if *of == which => Some(head.clone()),
            Head::LeftOut(..) | Head::Of(..) | Head::Missing => None,
        });
        heads.collect()
    };
    match faults.is_empty() {
        true => Ok(Tabled {
            span: 0..0,
            text,
            file: String::new(),
            places,
            left_out: left_out(Unread::Note),
            unread: left_out(Unread::Numbers),
            survey: None,
        }),
        false => Err(faults),
    }
}

/// The head of a column.
enum Head {
    /// The key of the column, and its unit.
    Of(&'static str, Option<String>),
    /// A column that no part uses.
    LeftOut(String, Unread),
    /// None.
    Missing,
}

impl Head {
    fn is_of(&self, key: &str) -> bool {
        matches!(self, Head::Of(known, _) if *known == key)
    }
}

/// The heads of a table.
fn heads(
    key: &'static str,
    columns: &[Column],
    (header, body): (&[SheetCell], &[Vec<SheetCell>]),
    root: &DeTable<'_>,
    file: &str,
) -> Result<Vec<Head>, Vec<(Both, Both)>> {
    let mut faults = Vec::new();
    let mut heads: Vec<Head> = Vec::new();
    for (at, cell) in header.iter().enumerate() {
        let SheetValue::Text(head) = &cell.value else {
            // an empty head over an empty column is not a column
            heads.push(Head::Missing);
            continue;
        };
        match column(head, columns) {
            Some((of, _)) if heads.iter().any(|head| head.is_of(of.0)) => {
                let message = WrongTable::CellColumnIsThere {
                    file: file.to_string(),
                    place: cell.place.to_string(),
                    of: of.0.to_string(),
                };
                faults.push((message.into(), Common::KeepOneOfThem.into()));
            }
            Some((of, unit)) => match checked_unit(of, unit, root) {
                Ok(unit) => heads.push(Head::Of(of.0, unit)),
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
                let below = body.iter().filter_map(|row| row.get(at));
                let below: Vec<&SheetValue> = below.map(|cell| &cell.value).collect();
                let of = unread(head, &below);
                if of != Unread::Missed && !is_misspelt_in(head, columns) {
                    heads.push(Head::LeftOut(head.clone(), of));
                    continue;
                }
                let known: Vec<&str> = columns.iter().map(|(known, ..)| *known).collect();
                let known = known.join(", ");
                let message = WrongTable::CellIsNoColumn {
                    file: file.to_string(),
                    place: cell.place.to_string(),
                    head: head.to_string(),
                    key: key.to_string(),
                };
                let help = match of {
                    Unread::Missed => WrongTable::WriteItInProject { known },
                    Unread::Numbers | Unread::Note => WrongTable::NameItOneOf { known },
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

/// Whether an unknown head seems to be that of a column.
fn is_misspelt_in(head: &str, columns: &[Column]) -> bool {
    let name = head.split_once(['(', '[']).map_or(head, |(name, _)| name).trim();
    columns.iter().any(|(known, others, _)| {
        is_misspelt(name, known) || others.iter().any(|other| is_misspelt(name, other))
    })
}

/// Rejects a row that is the total of the others.
fn refuse_total(heads: &[Head], body: &[Vec<SheetCell>], file: &str) -> Result<(), Vec<(Both, Both)>> {
    let name_at = heads.iter().position(|head| head.is_of("name"));
    let mut body = body.to_vec();
    for (at, _) in heads
        .iter()
        .enumerate()
        .filter(|(_, head)| matches!(head, Head::LeftOut(..)))
    {
        let cells = body.iter_mut().filter_map(|row| row.get_mut(at));
        cells.for_each(|cell| cell.value = SheetValue::Empty);
    }
    if let Some(total) = total(&body, name_at) {
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

/// The unit of a column, if its head has one: of the right dimension, and equal to that of the file if the file has one.
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
        return Err((said.into(), Common::UseUnitSuchAs(measure.example()).into()));
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

/// A value in TOML: names and shapes are words, numbers have the unit of their head.
pub(super) fn written(name: &str, value: &SheetValue, unit: Option<&str>) -> String {
    let is_words = ["name", "shape"].contains(&name);
    match value {
        SheetValue::Number(number) if is_words => quoted(&number.to_string()),
        SheetValue::Number(number) => match unit {
            Some(unit) => quoted(&format!("{number} {unit}")),
            None => number.to_string(),
        },
        // a spreadsheet stores numbers as text in cells of that format
        SheetValue::Text(text) if !is_words && is_number(text) => match unit {
            Some(unit) => quoted(&format!("{} {unit}", plain(text))),
            None => plain(text),
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

/// A number in TOML syntax: without leading zeros.
fn plain(text: &str) -> String {
    let text = text.trim();
    text.parse::<f64>()
        .map_or_else(|_| text.to_owned(), |number| number.to_string())
}

pub(super) fn quoted(text: &str) -> String {
    let mut said = String::from("\"");
    for sign in text.chars() {
        match sign {
            '"' | '\\' => said.extend(['\\', sign]),
            // a control character is not part of a name
            sign if sign.is_control() => said.push(' '),
            sign => said.push(sign),
        }
    }
    said.push('"');
    said
}
