//! Modes of a survey that stand in a file beside the project: `modes = { file = "modes.uff" }`, a universal file of another program, or a table
//! with one row per mode. Each becomes an entry of the list of its direction, as if it were written in the file.

use super::error::Fault;
use super::measure::Measure;
use super::tabled::{Tabled, checked_unit, column, quoted, tabled, written};
use super::tabled_heads::Column;
use super::tabled_surveys::{surveys_in_table, unit_factor};
use super::units::parse_unit;
use super::wrong::{Common, WrongModes, WrongTable};
use crate::wrong::said;
use dolmen::signal::{Channel, Quantity};
use dolmen::structure::ShapeMotion;
use dolmen_records::records::{UffMode, UffModes, read_modes_uff};
use dolmen_records::{Files, SHEET_BYTES_MOST, SheetCell, SheetValue, read_sheet};
use dolmen_words::message::Both;
use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write as _;
use toml::de::{DeTable, DeValue};

/// The direction of a mode with motion along neither x nor y and without twist.
const OTHER: &str = "other";
/// The direction of modes that twist.
const TORSION: &str = "torsion";
/// Endings of universal files.
const UNIVERSAL: [&str; 2] = ["uff", "unv"];
/// Keys that the table may have.
const KEYS: [&str; 3] = ["file", "sheet", "length"];

const COLUMNS: &[Column] = &[
    ("direction", &["방향"], None),
    (
        "frequency",
        &["frequency_hz", "고유진동수", "진동수"],
        Some(Measure::Frequency),
    ),
    ("frequency_sd", &["frequency_sd_hz"], Some(Measure::Frequency)),
    ("damping_ratio", &["감쇠비"], None),
    ("damping_ratio_sd", &[], None),
    // of tables that Dolmen writes; not used in a survey
    ("mode", &["모드"], None),
    ("phase_collinearity", &[], None),
    ("accepted", &[], None),
];

/// A fault with its remedy.
type Wrong = (Both, Both);

/// Every list of parts, all modes of surveys and all surveys in a file beside the project.
pub(super) fn beside_the_file(text: &str, files: &dyn Files) -> Result<Vec<Tabled>, Vec<Fault>> {
    let mut all = tabled(text, files)?;
    let (root, syntax) = DeTable::parse_recoverable(text);
    let mut faults = Vec::new();
    if syntax.is_empty() {
        modes_in_files(root.get_ref(), files, &mut all, &mut faults);
        surveys_in_table(root.get_ref(), files, &mut all, &mut faults);
    }
    match faults.is_empty() {
        true => Ok(all),
        false => Err(faults),
    }
}

/// The modes of every survey that are in a file.
fn modes_in_files(root: &DeTable<'_>, files: &dyn Files, all: &mut Vec<Tabled>, faults: &mut Vec<Fault>) {
    let surveys = root.get("survey").and_then(|value| value.get_ref().as_table());
    for (name, survey) in surveys.into_iter().flatten() {
        let Some(given) = survey.get_ref().as_table().and_then(|survey| survey.get("modes")) else {
            continue;
        };
        let DeValue::Table(table) = given.get_ref() else {
            continue;
        };
        let word = |key: &str| table.get(key).and_then(|value| value.get_ref().as_str());
        let Some(file) = word("file") else { continue };
        let name = name.get_ref().to_string();
        let path = format!("survey.{name}.modes");
        if let Some((other, _)) = table
            .iter()
            .find(|(key, _)| !KEYS.contains(&key.get_ref().as_ref()))
        {
            let message = WrongTable::HasKeyBesideFile {
                key: path.clone(),
                name: other.get_ref().to_string(),
            };
            let fault = Fault::new(other.span(), &format!("{path}.{}", other.get_ref()), message);
            faults.push(fault.allowed(WrongModes::MustBeFileSheetLength));
            continue;
        }
        let keys = Keys {
            file,
            sheet: word("sheet"),
            length: word("length"),
        };
        match listed(&keys, &path, root, files) {
            Ok(text) => all.push(Tabled::of_survey(given.span(), text, name)),
            Err((message, help)) => faults.push(Fault::new(given.span(), &path, message).help(help)),
        }
    }
}

/// The contents of the table.
struct Keys<'a> {
    file: &'a str,
    sheet: Option<&'a str>,
    /// Unit of length of a universal file without one.
    length: Option<&'a str>,
}

/// The file's modes as TOML.
fn listed(keys: &Keys<'_>, path: &str, root: &DeTable<'_>, files: &dyn Files) -> Result<String, Wrong> {
    let file = keys.file.to_owned();
    let bytes = files.read(&file, SHEET_BYTES_MOST).map_err(|why| {
        let message = WrongTable::File {
            key: path.to_owned(),
            file: file.clone(),
            why: said(&why),
        };
        (message.into(), WrongModes::FileOfModes.into())
    })?;
    let ending = file.rsplit_once('.').map_or("", |(_, ending)| ending);
    let modes = if UNIVERSAL.iter().any(|of| ending.eq_ignore_ascii_case(of)) {
        let read = read_modes_uff(&bytes).map_err(|why| {
            let message = WrongTable::Sheet {
                file: file.clone(),
                why: said(&why),
            };
            (message.into(), WrongModes::FileOfModes.into())
        })?;
        of_universal(keys, &read)?
    } else {
        let rows = read_sheet(&bytes, &file, keys.sheet).map_err(|why| {
            let message = WrongTable::Sheet {
                file: file.clone(),
                why: said(&why),
            };
            (message.into(), WrongModes::FileOfModes.into())
        })?;
        of_table(&file, &rows, root)?
    };
    let mut text = String::from("modes = { ");
    for (direction, mut modes) in modes {
        modes.sort_by(|a, b| a.0.total_cmp(&b.0));
        let listed: Vec<String> = modes.into_iter().map(|(_, mode)| mode).collect();
        let _ = write!(text, "{} = [{}], ", quoted(&direction), listed.join(", "));
    }
    text.truncate(text.trim_end_matches(", ").len());
    text.push_str(" }");
    Ok(text)
}

/// The key of a column, and its unit.
type Head = (&'static str, Option<String>);
/// Modes by direction, each with its frequency to sort by.
type ByDirection = BTreeMap<String, Vec<(f64, String)>>;

/// The modes of a universal file, each in the direction of its nodes' motion.
fn of_universal(keys: &Keys<'_>, read: &UffModes) -> Result<ByDirection, Wrong> {
    let metres = metres(keys, read)?;
    let components = components(read);
    let mut channels = Vec::new();
    for (at, (node, axis)) in components.iter().enumerate() {
        let mut direction = [0.0; 3];
        direction[*axis] = 1.0;
        let position_m = match metres {
            Some(metres) => place(keys, read, *node)?.map(|x| x * metres),
            // each at its own height: their differences are not judged
            None => [0.0, 0.0, at as f64],
        };
        channels.push(Channel {
            name: node.to_string(),
            quantity: Quantity::Displacement,
            position_m: Some(position_m),
            direction: Some(direction),
        });
    }
    let mut all = ByDirection::new();
    for mode in &read.modes {
        let shape: Vec<[f64; 2]> = components
            .iter()
            .map(|(node, axis)| mode.displacements.get(node).map_or([0.0; 2], |of| of[*axis]))
            .collect();
        let motion = ShapeMotion::of(&channels, &shape);
        let direction = motion.direction().unwrap_or(OTHER).to_owned();
        let text = entry(mode, &motion, metres.is_some());
        all.entry(direction).or_default().push((mode.frequency_hz, text));
    }
    Ok(all)
}

/// A mode as an entry of its list.
fn entry(mode: &UffMode, motion: &ShapeMotion, has_heights: bool) -> String {
    let with_sd = |value: String, sd: Option<f64>| match sd {
        Some(sd) => format!("{{ value = {value}, sd = {sd:?} }}"),
        None => value,
    };
    let frequency = format!("\"{:?} Hz\"", mode.frequency_hz);
    let mut text = format!("{{ frequency = {}", with_sd(frequency, mode.frequency_sd_hz));
    if let Some(ratio) = mode.damping_ratio {
        let ratio = with_sd(format!("{ratio:?}"), mode.damping_ratio_sd);
        let _ = write!(text, ", damping_ratio = {ratio}"); // into a String: cannot fail
    }
    match motion {
        ShapeMotion::AlongX(points) | ShapeMotion::AlongY(points) if has_heights => {
            let each = points.iter().map(|point| {
                let (height_m, displacement) = (point.height_m, point.displacement);
                format!("{{ height = \"{height_m:?} m\", displacement = {displacement:?} }}")
            });
            let _ = write!(text, ", shape = [{}]", each.collect::<Vec<_>>().join(", "));
        }
        ShapeMotion::Twists => text.push_str(", kind = \"torsion\""),
        ShapeMotion::AlongX(_) | ShapeMotion::AlongY(_) | ShapeMotion::Other => {}
    }
    text.push_str(" }");
    text
}

/// Node and axis of each component that moves in any mode: programs write 0 for components that were not measured.
fn components(read: &UffModes) -> Vec<(i64, usize)> {
    let mut moving = BTreeSet::new();
    for (node, vector) in read.modes.iter().flat_map(|mode| &mode.displacements) {
        let axes = (0..3).filter(|axis| vector[*axis] != [0.0; 2]);
        moving.extend(axes.map(|axis| (*node, axis)));
    }
    moving.into_iter().collect()
}

/// Metres per unit of length of the file; `None` if no node has a place.
fn metres(keys: &Keys<'_>, read: &UffModes) -> Result<Option<f64>, Wrong> {
    if read.places.is_empty() {
        return Ok(None);
    }
    let file = keys.file.to_owned();
    match (read.lengths_a_metre, keys.length) {
        (Some(lengths), None) => Ok(Some(1.0 / lengths)),
        (Some(_), Some(length)) => {
            let length = length.to_owned();
            Err((
                WrongModes::HasItsLength { file, length }.into(),
                Common::TakeItOut.into(),
            ))
        }
        (None, None) => Err((WrongModes::NoLength(file).into(), WrongModes::GiveLength.into())),
        (None, Some(length)) => {
            let dimension = Measure::Length.dimension();
            let unit = parse_unit(length).ok().and_then(|read| read.measuring(dimension));
            let wrong = WrongModes::IsNoLength(length.to_owned());
            let unit = unit.ok_or_else(|| (wrong.into(), WrongModes::GiveLength.into()))?;
            Ok(Some(unit.factor))
        }
    }
}

/// The place of a moving node.
fn place(keys: &Keys<'_>, read: &UffModes, node: i64) -> Result<[f64; 3], Wrong> {
    let message = WrongModes::NodeWithoutPlace {
        file: keys.file.to_owned(),
        node: node.to_string(),
    };
    let place = read.places.get(&node).copied();
    place.ok_or_else(|| (message.into(), WrongModes::GiveEveryNode.into()))
}

/// The modes of a table, one per row.
fn of_table(file: &str, rows: &[Vec<SheetCell>], root: &DeTable<'_>) -> Result<ByDirection, Wrong> {
    let Some((header, body)) = rows.split_first() else {
        return Ok(ByDirection::new());
    };
    let heads = heads(file, header, root)?;
    let at = |name: &str| {
        heads
            .iter()
            .position(|head| head.as_ref().is_some_and(|of| of.0 == name))
    };
    let [Some(direction_at), Some(frequency_at)] = ["direction", "frequency"].map(at) else {
        let file = file.to_owned();
        return Err((WrongModes::NoColumns(file).into(), WrongModes::GiveColumns.into()));
    };
    let mut all = ByDirection::new();
    for row in body {
        let value = |name: &str| {
            let at = at(name)?;
            let unit = heads[at].as_ref().and_then(|(_, unit)| unit.as_deref());
            let cell = row.get(at).filter(|cell| cell.value != SheetValue::Empty)?;
            Some(written(name, &cell.value, unit))
        };
        let missing = |at: usize| {
            let cell = row.get(at).or(row.last());
            let message = WrongModes::EmptyCell {
                file: file.to_owned(),
                place: cell.map_or_else(String::new, |cell| cell.place.clone()),
            };
            (message.into(), WrongModes::GiveColumns.into())
        };
        let direction = match row.get(direction_at).map(|cell| &cell.value) {
            Some(SheetValue::Text(text)) => text.trim().to_owned(),
            _ => return Err(missing(direction_at)),
        };
        let frequency = value("frequency").ok_or_else(|| missing(frequency_at))?;
        let deviation = at("frequency_sd").and_then(|sd_at| {
            let [sd, of] = [sd_at, frequency_at].map(|at| heads[at].as_ref().and_then(|of| of.1.as_deref()));
            let units = [sd, of.or(unit_of_file(root))];
            let cell = row.get(sd_at).filter(|cell| cell.value != SheetValue::Empty)?;
            Some(in_unit_of_value(&cell.value, units))
        });
        let with_sd = |value: String, sd: Option<String>| match sd {
            Some(sd) => format!("{{ value = {value}, sd = {sd} }}"),
            None => value,
        };
        let mut text = format!("{{ frequency = {}", with_sd(frequency, deviation));
        if let Some(ratio) = value("damping_ratio") {
            let ratio = with_sd(ratio, value("damping_ratio_sd"));
            let _ = write!(text, ", damping_ratio = {ratio}");
        }
        if direction == TORSION {
            text.push_str(", kind = \"torsion\"");
        }
        text.push_str(" }");
        let frequency_hz = match row[frequency_at].value {
            SheetValue::Number(hz) => hz,
            _ => f64::MAX,
        };
        all.entry(direction).or_default().push((frequency_hz, text));
    }
    Ok(all)
}

/// The unit of bare frequencies that the project names.
fn unit_of_file<'a>(root: &'a DeTable<'_>) -> Option<&'a str> {
    let units = root.get("units")?.get_ref().as_table()?;
    units.get("frequency")?.get_ref().as_str()
}

/// A deviation in the unit of its value, which is Hz where neither the head nor the project names one; a deviation without a unit is in that already.
fn in_unit_of_value(sd: &SheetValue, [of_sd, of_value]: [Option<&str>; 2]) -> String {
    let plain = written("frequency_sd", sd, None);
    let ratio = of_sd.map_or(1.0, |_| unit_factor(of_sd) / unit_factor(of_value));
    match plain.parse::<f64>() {
        Ok(number) if ratio != 1.0 => format!("{:?}", number * ratio),
        _ => plain,
    }
}

/// Column and unit of each head; `None` for one that no survey takes, such as the components of shapes.
fn heads(file: &str, header: &[SheetCell], root: &DeTable<'_>) -> Result<Vec<Option<Head>>, Wrong> {
    let mut heads: Vec<Option<Head>> = Vec::new();
    for cell in header {
        let SheetValue::Text(head) = &cell.value else {
            heads.push(None);
            continue;
        };
        let Some((of, unit)) = column(head, COLUMNS) else {
            let is_component = [" re", " im"].iter().any(|end| head.trim_end().ends_with(end));
            if !is_component {
                let message = WrongTable::CellIsNoColumn {
                    file: file.to_owned(),
                    place: cell.place.clone(),
                    head: head.clone(),
                    key: "modes".to_owned(),
                };
                return Err((message.into(), WrongModes::GiveColumns.into()));
            }
            heads.push(None);
            continue;
        };
        let place = cell.place.clone();
        let file = file.to_owned();
        if heads.iter().flatten().any(|known| known.0 == of.0) {
            let of = of.0.to_owned();
            let message = WrongTable::CellColumnIsThere { file, place, of };
            return Err((message.into(), Common::KeepOneOfThem.into()));
        }
        let unit = checked_unit(of, unit, root)
            .map_err(|(said, help)| (WrongTable::Cell { file, place, said }.into(), help))?;
        heads.push(Some((of.0, unit)));
    }
    Ok(heads)
}
