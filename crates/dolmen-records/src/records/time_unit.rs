//! Determines the unit of a time column if its name does not state it: seconds, milliseconds, or days of a spreadsheet.

use super::RecordError;
use super::csv_start::Start;
use super::date_text::{DAY_S, SERIAL_DAYS};
use super::dialect::{holds_cells, unquoted};
use crate::number::parse_cell;

/// Number of lines that are examined for the first steps.
const LINES: usize = 20;
/// Fewest steps for a decision.
const LINES_LEAST: usize = 5;
/// Steps below this, read as seconds, are in days: no structure is recorded above 10 kHz. Our choice.
const DAYS_BELOW_S: f64 = 1e-4;
/// Steps from this value on, read as seconds, are too long for vibration: such stamps are usually milliseconds, or number the samples. Our choice.
const SLOW_FROM_S: f64 = 1.0;
/// Largest relative difference between the first steps and the given rate in some unit, for a gap or a coarse last digit.
const NEAR: f64 = 0.05;
const SMALLER_S: [f64; 2] = [1e-3, 1e-6];
/// Units that a given rate can identify: s, ms, µs, min, h, days.
const UNITS_S: [f64; 6] = [1.0, 1e-3, 1e-6, 60.0, 3600.0, DAY_S];

/// Index of the time column, from 0, and its unit.
#[derive(Clone, Copy, Debug)]
pub(super) struct Time {
    pub(super) column: usize,
    pub(super) unit_s: f64,
    /// Whether the column name states the unit.
    pub(super) said: UnitSaid,
}

/// What the name of a time column states about its unit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum UnitSaid {
    /// The unit is stated, or the user named the column, which is then in seconds.
    Clearly,
    /// No unit is stated: seconds, if the steps are possible for vibration.
    Not,
    /// The unit is unknown or ambiguous: 시.
    Unclearly,
}

/// Length of one unit of the column, s, from its first steps and the given rate.
///
/// # Errors
/// [`RecordError::SlowStamps`] if the stamps are a second or more apart, and the rate, if given, does not confirm it;
/// [`RecordError::TimeUnit`] if the name has an unknown unit and the rate, if given, agrees with no unit.
pub(super) fn unit_s(
    bytes: &[u8],
    start: &Start,
    (time, column): (Time, &str),
    given_hz: Option<f64>,
) -> Result<f64, RecordError> {
    let lines = bytes[start.samples_at..].split(|b| *b == b'\n');
    let lines = lines.map(|line| line.strip_suffix(b"\r").unwrap_or(line));
    let stamp = |line: &[u8]| {
        let cells = start.delimiter.cells(line);
        let cell = unquoted(cells.get(time.column)?);
        Some(parse_cell(cell, start.decimal.byte())?.value)
    };
    let first: Option<Vec<f64>> = lines
        .filter(|line| holds_cells(line))
        .take(LINES)
        .map(stamp)
        .collect();
    // text that is not a number is refused when it is read
    let unclear = || RecordError::TimeUnit {
        column: column.to_owned(),
    };
    let Some(first) = first.filter(|all| all.len() >= LINES_LEAST) else {
        return match time.said {
            UnitSaid::Unclearly => Err(unclear()),
            UnitSaid::Clearly | UnitSaid::Not => Ok(time.unit_s),
        };
    };
    let (begin, end) = (first[0], first[first.len() - 1]);
    let steps = (first.len() - 1) as f64;
    let step_s = time.unit_s * (end - begin) / steps;
    if SERIAL_DAYS.contains(&begin) && step_s > 0.0 && step_s < DAYS_BELOW_S {
        return Ok(DAY_S);
    }
    if time.said == UnitSaid::Unclearly {
        let fits = |unit_s: &f64| given_hz.is_some_and(|rate| (rate * unit_s * step_s - 1.0).abs() < NEAR);
        return UNITS_S.into_iter().find(fits).ok_or_else(unclear);
    }
    if step_s < SLOW_FROM_S || !step_s.is_finite() {
        return Ok(time.unit_s);
    }
    let fits = |unit_s: &f64| given_hz.is_some_and(|rate| (rate * unit_s * step_s - 1.0).abs() < NEAR);
    if fits(&1.0) {
        return Ok(time.unit_s);
    }
    let is_stated = time.said == UnitSaid::Clearly;
    let mut smaller = SMALLER_S.into_iter().filter(|_| !is_stated);
    smaller.find(fits).ok_or_else(|| RecordError::SlowStamps {
        column: column.to_owned(),
        step: step_s,
        milliseconds_hz: 1e3 / step_s,
    })
}
