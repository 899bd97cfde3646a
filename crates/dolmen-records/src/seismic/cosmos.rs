//! COSMOS V1 and V2, format 1.20: one or several channels, each with a text, an integer and a real header.
//!
//! ```text
//! Corrected acceleration    (Format v01.20 with 13 text lines)      V2; V1 says "Uncorrected acceleration"
//!  100 Integer-header values follow on  10 lines, Format= (10I8)    the 54th: azimuth, 400 up, 401 down
//!  100 Real-header values follow on  20 lines, Format= (5F15.6)     the 62nd: time step, ms; the 64th: peak
//!    6 Comment line(s) follow, each starting with a "|":
//!    42000 acceleration pts, approx  210 secs, units=cm/sec2(04),Format=(1E15.6)
//! End-of-data for Chan  1 acceleration                              then velocity and displacement, if at all
//! ```
//!
//! Source: COSMOS (2001) *Strong Motion Data Format*, version 1.20.

use super::lines::{Columns, Line, Lines, refused, text};
use super::raw::{MotionFormat, Raw};
use super::units::acceleration_unit;
use super::{Orientation, SeismicError};
use crate::limits::refuse_channels;
use crate::unit::Unit;
use crate::wrong::OfStation;

/// Spelling of an unknown value.
const UNKNOWN: f64 = -999.0;
/// Values of the real header, from 0: time step, ms; peak in the unit of the samples.
const TIME_STEP_MS: usize = 61;
const PEAK: usize = 63;
/// Value of the integer header, from 0: azimuth.
const AZIMUTH: usize = 53;
/// Largest number of values or lines in a header.
const HEADER_MOST: usize = 10_000;

pub(super) fn is_cosmos(bytes: &[u8]) -> bool {
    let first = Lines::new(bytes).next();
    first.is_some_and(|line| is_first(&text(line)))
}

fn is_first(line: &str) -> bool {
    line.contains("(Format v") && line.contains("text lines)")
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut lines = Lines::new(bytes);
    let mut channels = Vec::new();
    while let Some(line) = lines.peek() {
        if line.1.trim_ascii().is_empty() {
            lines.next();
        } else if is_first(&text(line)) {
            refuse_channels("cosmos", channels.len() + 1)?;
            channels.push(channel(&mut lines, channels.len())?);
        } else {
            return Err(refused(line, OfStation::CosmosTitle));
        }
    }
    Ok(channels)
}

/// The first number of a line.
fn leading(line: Line, wanted: OfStation) -> Result<usize, SeismicError> {
    let text = text(line);
    let count = text.split_whitespace().next().and_then(|word| word.parse().ok());
    count.ok_or_else(|| refused(line, wanted))
}

/// The values of an integer or real header.
fn values(lines: &mut Lines, wanted: OfStation) -> Result<Vec<f64>, SeismicError> {
    let line = lines.want(wanted.clone())?;
    let count = leading(line, wanted.clone())?;
    let columns = Columns::of_format(&text(line)).filter(|_| count <= HEADER_MOST);
    columns.ok_or_else(|| refused(line, wanted))?.read(lines, count)
}

fn channel(lines: &mut Lines, index: usize) -> Result<Raw, SeismicError> {
    let first = lines.want(OfStation::CosmosFirst)?;
    let told = text(first);
    let mut words = told.split_whitespace().skip_while(|word| *word != "with").skip(1);
    let text_lines = words.next().and_then(|word| word.parse::<usize>().ok());
    let text_lines = text_lines
        .filter(|count| (6..=HEADER_MOST).contains(count))
        .ok_or_else(|| refused(first, OfStation::CosmosFirst))?;
    let mut head = vec![told];
    while head.len() < text_lines {
        head.push(text(lines.want(OfStation::CosmosText)?));
    }
    let integers = values(lines, OfStation::CosmosIntegers)?;
    let reals = values(lines, OfStation::CosmosReals)?;
    let wanted = OfStation::CosmosComments;
    let comments = leading(lines.want(wanted.clone())?, wanted)?;
    for _ in 0..comments {
        lines.want(OfStation::CosmosComment)?;
    }
    let line = lines.want(OfStation::CosmosData)?;
    let (count, told) = (leading(line, OfStation::CosmosData)?, text(line));
    let columns = Columns::of_format(&told).ok_or_else(|| refused(line, OfStation::CosmosData))?;
    let lower = told.to_lowercase();
    if !lower.contains("acceleration") {
        let what = if lower.contains("velocity") {
            OfStation::Velocities
        } else {
            OfStation::NoAccelerations
        };
        return Err(SeismicError::Quantity {
            line: line.0,
            what: what.into(),
        });
    }
    let units = told.split("units=").nth(1).unwrap_or_default();
    let word = units.split(['(', ',']).next().unwrap_or_default().trim();
    if word == "counts" {
        return Err(SeismicError::Counts { line: line.0 });
    }
    let unit: Unit = acceleration_unit(word).ok_or_else(|| SeismicError::At2Unit {
        line: line.0,
        text: word.to_owned(),
    })?;
    let samples = columns.read(lines, count)?;
    let end = lines.want(OfStation::CosmosEnd)?;
    if !end.1.trim_ascii_start().starts_with(b"End-of-data") {
        return Err(refused(end, OfStation::CosmosEnd));
    }
    passed_over(lines)?;
    let known = |values: &[f64], at: usize| values.get(at).copied().filter(|value| *value != UNKNOWN);
    let step_ms = known(&reals, TIME_STEP_MS).filter(|step| *step > 0.0);
    let time_step_s = step_ms.ok_or(SeismicError::Missing {
        label: "the time step (the 62nd real value)",
        lines: text_lines,
    })? / 1e3;
    let azimuth = known(&integers, AZIMUTH).unwrap_or(0.0);
    let orientation = match azimuth as i64 {
        1..=360 => Orientation::horizontal(azimuth),
        400 => Some(Orientation::Up),
        401 => Some(Orientation::Down),
        _ => None,
    };
    let brief = |at: usize| {
        head.get(at)
            .map(|line| line.split_whitespace().collect::<Vec<_>>().join(" "))
            .unwrap_or_default()
    };
    Ok(Raw {
        name: format!("channel {}", index + 1),
        title: format!("{}; {}", brief(1), brief(4)),
        samples,
        unit: Some(unit),
        orientation,
        stated_peak: known(&reals, PEAK).map(f64::abs).filter(|peak| *peak > 0.0),
        ..Raw::new(MotionFormat::Cosmos, time_step_s)
    })
}

/// Skips velocities and displacements after the accelerations of a channel.
fn passed_over(lines: &mut Lines) -> Result<(), SeismicError> {
    while let Some(line) = lines.peek() {
        let told = text(line).to_lowercase();
        let other = told.contains("velocity pts")
            || told.contains("displacement pts")
            || told.contains("displace pts");
        if !other {
            break;
        }
        let wanted = OfStation::CosmosOther;
        let (count, columns) = (
            leading(line, wanted.clone())?,
            Columns::of_format(&told).ok_or_else(|| refused(line, wanted))?,
        );
        lines.next();
        columns.read(lines, count)?;
        lines.want(OfStation::CosmosOtherEnd)?;
    }
    Ok(())
}
