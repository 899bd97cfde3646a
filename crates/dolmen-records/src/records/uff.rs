//! Reads UFF, the universal files of modal analysis: dataset 58 (functions), as text or binary, with nodes (15, 2411), units (164)
//! and title (151).
//!
//! ```text
//!     -1                      a dataset begins and ends with −1 in columns 1 to 6
//!     58                      58b: order of bytes, of floats, 11 lines, bytes that follow
//! five lines of text, then:
//! 6   function  number  version  load case  name  node  direction  name  node  direction
//! 7   type of the numbers (2, 4 real), their count, 1 = even steps, first, step, z
//! 8   abscissa: 17 = time, exponents, label, unit
//! 9   ordinate: 12 acceleration, 11 velocity, 8 displacement, exponents, label, unit
//! ```
//!
//! Source: University of Cincinnati, Structural Dynamics Research Laboratory, *Universal File Formats for Modal Analysis Testing*.

use super::cursor::{Cursor, Number};
use super::series::{FileSeries, Series, rate_of_step};
use super::uff_text::{FORMAT, Lines, cell, decimal, whole};
use super::unit::unit_of_label;
use super::{FileUnit, RecordError, RecordFormat};
use crate::limits::head;
use crate::number::parse_number;
use crate::quoted::{listed, shown};
use crate::unit::Unit;
use crate::wrong::{Expected, Remark, Unread};
use dolmen::signal::Quantity;
use dolmen_words::message::Both;
use std::collections::BTreeMap;

/// Codes of line 6 and line 8.
const TIME_RESPONSE: [i64; 2] = [0, 1];
const TIME: i64 = 17;
/// Codes of line 9.
const ACCELERATION: i64 = 12;
const VELOCITY: i64 = 11;
const DISPLACEMENT: i64 = 8;
/// The file prints the step with six digits, so the rate is rounded to the nearest whole number of hertz within this fraction.
const DIGITS: f64 = 1e-5;
/// Number of text lines in a dataset 58.
const LINES: usize = 11;

/// Whether the first line with content is the −1 of a dataset.
pub(super) fn is_uff(bytes: &[u8]) -> bool {
    let mut lines = Lines::new(head(bytes));
    let mut next = || lines.next().ok().flatten();
    let first = std::iter::from_fn(&mut next).find(|line| !line.trim().is_empty());
    let kind = next();
    first.is_some_and(|line| line.trim_end() == "    -1")
        && kind.is_some_and(|line| cell(&line, 0, 6).trim().parse::<u32>().is_ok())
}

/// Contents of the file other than functions.
#[derive(Default)]
pub(super) struct OtherDatasets {
    pub(super) nodes: BTreeMap<i64, [f64; 3]>,
    /// Units of length of the file per metre.
    pub(super) length: Option<f64>,
    title: Option<String>,
    pub(super) turned: bool,
    /// Other datasets: number of the dataset type, and how many.
    passed: BTreeMap<String, usize>,
}

/// A time series with its node and unit data.
struct Function {
    series: Series,
    node: i64,
    direction: i64,
    quantity: i64,
}

pub(super) fn read(bytes: &[u8]) -> Result<FileSeries, RecordError> {
    let mut functions = Vec::new();
    let beside = datasets(bytes, "58", &mut |lines, kind, beside| {
        match function(lines, kind)? {
            Some(one) => functions.push(one),
            None => beside.pass("58, not of time"),
        }
        Ok(())
    })?;
    finished(functions, beside)
}

impl OtherDatasets {
    pub(super) fn pass(&mut self, what: &str) {
        *self.passed.entry(what.to_owned()).or_default() += 1;
    }

    /// Names of the ignored datasets, as "58 (×2)".
    pub(super) fn passed_over(&self) -> Vec<String> {
        let each = self.passed.iter();
        each.map(|(what, count)| format!("{what} (×{count})")).collect()
    }
}

/// Reads one dataset, beginning after the line with its number.
type ReadDataset<'r> = dyn FnMut(&mut Lines, &str, &mut OtherDatasets) -> Result<(), RecordError> + 'r;

/// Reads all datasets of the file: `read` handles those with the number `wanted`; those with descriptions are read here; others
/// are ignored.
pub(super) fn datasets(
    bytes: &[u8],
    wanted: &str,
    read: &mut ReadDataset<'_>,
) -> Result<OtherDatasets, RecordError> {
    let mut lines = Lines::new(bytes);
    let mut beside = OtherDatasets::default();
    while let Some(line) = lines.next()? {
        if line.trim().is_empty() {
            continue;
        }
        if line.trim() != "-1" {
            return Err(lines.is_not(&line, Expected::DatasetBegins));
        }
        let Some(kind) = lines.next()? else { break };
        let number = cell(&kind, 0, 6).trim().to_owned();
        match number.as_str() {
            _ if number == wanted => read(&mut lines, &kind, &mut beside)?,
            // its samples may be binary
            "58" => {
                function(&mut lines, &kind)?;
                beside.pass("58");
            }
            "15" => nodes(&mut lines, &mut beside)?,
            "2411" => long_nodes(&mut lines, &mut beside)?,
            "164" => units(&mut lines, &mut beside)?,
            "151" => {
                let title = lines.want(Expected::Title151)?;
                beside.title =
                    Some(title.trim().to_owned()).filter(|title| !title.is_empty() && title != "NONE");
            }
            "18" | "2420" => beside.turned = true,
            _ if number.parse::<u32>().is_ok() => beside.pass(&number),
            _ => return Err(lines.is_not(&kind, Expected::DatasetNumber)),
        }
        end(&mut lines)?;
    }
    Ok(beside)
}

/// Skips the −1 that ends a dataset.
fn end(lines: &mut Lines) -> Result<(), RecordError> {
    loop {
        if lines.want(Expected::DatasetEnds)?.trim() == "-1" {
            return Ok(());
        }
    }
}

fn finished(functions: Vec<Function>, beside: OtherDatasets) -> Result<FileSeries, RecordError> {
    let mut notes: Vec<Both> = beside
        .title
        .iter()
        .map(|title| Remark::Title(shown(title)).into())
        .collect();
    let passed = beside.passed_over();
    if functions.is_empty() {
        return Err(RecordError::NotReadHere {
            format: FORMAT,
            what: Unread::NoSeries(match passed.is_empty() {
                true => Unread::WithoutAny.into(),
                false => listed(&passed),
            })
            .into(),
            instead: Unread::Dataset58.into(),
        });
    }
    if !passed.is_empty() {
        notes.push(Remark::DatasetsUnread(listed(&passed)).into());
    }
    if beside.turned {
        notes.push(Remark::TurnedAxes.into());
    }
    let placed = |function: Function| {
        let mut series = function.series;
        if series.unit == FileUnit::Silent {
            series.unit = unit_of_code(function.quantity, beside.length);
        }
        series.quantity = match function.quantity {
            ACCELERATION => Some(Quantity::Acceleration),
            VELOCITY => Some(Quantity::Velocity),
            DISPLACEMENT => Some(Quantity::Displacement),
            _ => None,
        };
        if !beside.turned {
            series.direction = way(function.direction);
            let metres = beside.length.map(|length| 1.0 / length);
            series.position_m = beside
                .nodes
                .get(&function.node)
                .zip(metres)
                .map(|(xyz, m)| xyz.map(|x| x * m));
        }
        series
    };
    Ok(FileSeries {
        format: RecordFormat::Uff,
        series: functions.into_iter().map(placed).collect(),
        notes,
    })
}

/// The unit of a quantity from the length unit of the file (dataset 164) and seconds.
fn unit_of_code(quantity: i64, length: Option<f64>) -> FileUnit {
    let near = |per_metre: f64| length.is_some_and(|length| (length / per_metre - 1.0).abs() < 1e-6);
    let units = match quantity {
        ACCELERATION => [
            Unit::MetrePerSecondSquared,
            Unit::Gal,
            Unit::MillimetrePerSecondSquared,
        ],
        VELOCITY => [
            Unit::MetrePerSecond,
            Unit::CentimetrePerSecond,
            Unit::MillimetrePerSecond,
        ],
        DISPLACEMENT => [Unit::Metre, Unit::Centimetre, Unit::Millimetre],
        _ => return FileUnit::Silent,
    };
    match () {
        () if near(1.0) => FileUnit::Known(units[0]),
        () if near(100.0) => FileUnit::Known(units[1]),
        () if near(1000.0) => FileUnit::Known(units[2]),
        () => FileUnit::Silent,
    }
}

fn way(direction: i64) -> Option<[f64; 3]> {
    let sign = direction.signum() as f64;
    match direction.abs() {
        1 => Some([sign, 0.0, 0.0]),
        2 => Some([0.0, sign, 0.0]),
        3 => Some([0.0, 0.0, sign]),
        _ => None,
    }
}

/// Name of a channel, such as "12+X", "12-RZ" or "12".
fn name(node: i64, direction: i64) -> String {
    const AXES: [&str; 7] = ["", "X", "Y", "Z", "RX", "RY", "RZ"];
    let sign = match direction.signum() {
        -1 => "-",
        1 => "+",
        _ => "",
    };
    let axis = usize::try_from(direction.unsigned_abs())
        .ok()
        .and_then(|at| AXES.get(at).copied());
    format!("{node}{sign}{}", axis.unwrap_or("?"))
}

/// Encoding of a binary dataset 58.
struct Binary {
    big: bool,
    bytes: usize,
}

fn binary(lines: &Lines, kind: &str) -> Result<Option<Binary>, RecordError> {
    if cell(kind, 6, 1) != "b" {
        return Ok(None);
    }
    // the columns before may contain blanks of several bytes
    let behind: String = kind.chars().skip(7).collect();
    let words: Vec<usize> = behind
        .split_whitespace()
        .filter_map(|word| word.parse().ok())
        .collect();
    let &[order, floats, LINES, bytes, ..] = words.as_slice() else {
        return Err(lines.is_not(kind, Expected::Header58b));
    };
    let big = match order {
        1 => false,
        2 => true,
        _ => return Err(lines.is_not(kind, Expected::ByteOrder58b)),
    };
    if floats != 2 {
        return Err(RecordError::NotReadHere {
            format: FORMAT,
            what: Unread::BinaryNumbers(floats.to_string()).into(),
            instead: Unread::Ieee754.into(),
        });
    }
    Ok(Some(Binary { big, bytes }))
}

/// Reads one dataset 58 to its end; `None` if it is not a time series.
fn function(lines: &mut Lines, kind: &str) -> Result<Option<Function>, RecordError> {
    let binary = binary(lines, kind)?;
    let mut text = Vec::with_capacity(LINES);
    for _ in 0..LINES {
        text.push(lines.want(Expected::Lines58)?);
    }
    let (sixth, seventh, eighth, ninth) = (&text[5], &text[6], &text[7], &text[8]);
    let wanted = || Expected::Codes58;
    let code = |line: &str, from: usize, width: usize| {
        whole(&cell(line, from, width)).ok_or_else(|| lines.is_not(line, wanted()))
    };
    let real =
        |line: &str, from: usize| decimal(&cell(line, from, 13)).ok_or_else(|| lines.is_not(line, wanted()));
    let sort = code(sixth, 0, 5)?;
    let (node, direction) = (code(sixth, 41, 10)?, code(sixth, 51, 4)?);
    let kind_of_numbers = code(seventh, 0, 10)?;
    let count = usize::try_from(code(seventh, 10, 10)?)
        .map_err(|_| lines.is_not(seventh, Expected::CountOfSamples))?;
    let even = code(seventh, 20, 10)? == 1;
    let (first, step) = (real(seventh, 30)?, real(seventh, 43)?);
    let is_time = TIME_RESPONSE.contains(&sort) && code(eighth, 0, 10)? == TIME;
    let size = match kind_of_numbers {
        2 => 4,
        4 => 8,
        5 => 8,
        6 => 16,
        _ => return Err(lines.is_not(seventh, Expected::NumberKind)),
    };
    if !is_time {
        if let Some(binary) = &binary {
            lines.bytes(binary.bytes)?;
        }
        return Ok(None);
    }
    if kind_of_numbers > 4 || !even {
        return Err(RecordError::NotReadHere {
            format: FORMAT,
            what: Unread::SeriesOf {
                numbers: match even {
                    true => Unread::ComplexNumbers.into(),
                    false => Unread::UnevenSteps.into(),
                },
                line: lines.number(),
            }
            .into(),
            instead: Unread::Resample.into(),
        });
    }
    if !(step > 0.0 && step.is_finite() && first.is_finite()) {
        return Err(lines.is_not(seventh, Expected::FirstTimeAndStep));
    }
    let quantity = code(ninth, 0, 10)?;
    let samples = match &binary {
        Some(binary) => packed(lines, binary, count, size)?,
        None => {
            let width = if size == 4 { 13 } else { 20 };
            printed(
                lines,
                (count, width),
                [Expected::Samples58, Expected::LineOfSamples],
            )?
        }
    };
    let label = cell(ninth, 47, 20);
    let unit = match label.trim() {
        "" | "NONE" => FileUnit::Silent,
        label => unit_of_label(label),
    };
    Ok(Some(Function {
        series: Series {
            sampling_rate_hz: Some(rate_of_step(step, DIGITS)),
            unit,
            offset_s: first,
            ..Series::new(name(node, direction), samples)
        },
        node,
        direction,
        quantity,
    }))
}

fn packed(lines: &mut Lines, binary: &Binary, count: usize, size: usize) -> Result<Vec<f64>, RecordError> {
    let at = lines.number();
    let data = lines.bytes(binary.bytes)?;
    if count.checked_mul(size) != Some(data.len()) {
        return Err(RecordError::SampleCount {
            format: FORMAT,
            stated: count as u64,
            found: data.len() / size,
        });
    }
    let number = if size == 4 { Number::F32 } else { Number::F64 };
    let samples = number.series(&mut Cursor::new(data, FORMAT).ordered(binary.big), count)?;
    match samples.iter().position(|x| !x.is_finite()) {
        Some(sample) => Err(RecordError::NotFinite {
            line: at,
            column: format!("sample {sample}"),
            text: samples[sample].to_string(),
        }),
        None => Ok(samples),
    }
}

/// Numbers in a text, separated by blanks or in columns of fixed width.
pub(super) fn printed(
    lines: &mut Lines,
    (count, width): (usize, usize),
    [all, a_line]: [Expected; 2],
) -> Result<Vec<f64>, RecordError> {
    let mut samples = Vec::new();
    while samples.len() < count {
        let line = lines.want(all.clone())?;
        let words: Vec<&str> = line.split_whitespace().collect();
        let apart: Option<Vec<f64>> = words.iter().map(|word| decimal(word)).collect();
        let row = apart.or_else(|| {
            let cells = line.trim_end().as_bytes().chunks(width);
            cells.map(|cell| parse_number(cell.trim_ascii())).collect()
        });
        match row {
            Some(row) if !row.is_empty() && row.iter().all(|x| x.is_finite()) => samples.extend(row),
            _ if line.trim() == "-1" => break,
            _ => return Err(lines.is_not(&line, a_line)),
        }
    }
    if samples.len() != count {
        return Err(RecordError::SampleCount {
            format: FORMAT,
            stated: count as u64,
            found: samples.len(),
        });
    }
    Ok(samples)
}

/// Dataset 15: one line per node.
fn nodes(lines: &mut Lines, beside: &mut OtherDatasets) -> Result<(), RecordError> {
    while let Some(line) = lines.peek()?.filter(|line| line.trim() != "-1") {
        lines.next()?;
        let wanted = || Expected::Node;
        let label = whole(&cell(&line, 0, 10)).ok_or_else(|| lines.is_not(&line, wanted()))?;
        let mut xyz = [0.0; 3];
        for (k, place) in xyz.iter_mut().enumerate() {
            *place = decimal(&cell(&line, 40 + 13 * k, 13)).ok_or_else(|| lines.is_not(&line, wanted()))?;
        }
        beside.nodes.insert(label, xyz);
    }
    Ok(())
}

/// Dataset 2411: two lines per node.
fn long_nodes(lines: &mut Lines, beside: &mut OtherDatasets) -> Result<(), RecordError> {
    while let Some(line) = lines.peek()?.filter(|line| line.trim() != "-1") {
        lines.next()?;
        let label = whole(&cell(&line, 0, 10)).ok_or_else(|| lines.is_not(&line, Expected::NodeLabel))?;
        let places = lines.want(Expected::NodeCoordinates)?;
        let xyz: Vec<f64> = places.split_whitespace().filter_map(decimal).collect();
        let xyz = <[f64; 3]>::try_from(xyz).map_err(|_| lines.is_not(&places, Expected::NodePlace))?;
        beside.nodes.insert(label, xyz);
    }
    Ok(())
}

/// Dataset 164: length units of the file per metre.
fn units(lines: &mut Lines, beside: &mut OtherDatasets) -> Result<(), RecordError> {
    lines.want(Expected::UnitsCode)?;
    let line = lines.want(Expected::UnitFactors)?;
    let factor = decimal(&cell(&line, 0, 25)).or_else(|| line.split_whitespace().next().and_then(decimal));
    let factor = factor.filter(|length| *length > 0.0 && length.is_finite());
    beside.length = Some(factor.ok_or_else(|| lines.is_not(&line, Expected::UnitFactors))?);
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_odd_blanks_and_lines_without_end() {
        // wide blanks before the number: columns are not bytes
        let odd = "    -1\n\u{2003}\u{2003}\u{2003} 58b\n    -1\n";
        assert!(
            read(odd.as_bytes())
                .unwrap_err()
                .to_string()
                .starts_with("line 2: \"58b\" is not \"58b\", order")
        );
        let long = "    -1\n    58\n".to_owned() + &"1 ".repeat(1_000_000);
        assert!(
            read(long.as_bytes())
                .unwrap_err()
                .to_string()
                .starts_with("line 3 has 2000000 bytes, but at most 1048576")
        );
    }
}
