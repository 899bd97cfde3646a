//! V1 and V2 of the California Strong Motion Instrumentation Program (CSMIP, CDMG), older than COSMOS: several channels.
//!
//! ```text
//! Uncorrected Accelerogram Data …                                                 V2: "Corrected accelerogram …" before it
//! Chan  1:  90 Deg
//!  31932 Accelerogram points at 100 pts/sec in units of g.       Format: (8f9.6)                 V1
//!  12000 points of accel data equally spaced at  .005 sec, in cm/sec2. (8f10.6)                  V2
//! ```
//! V2 continues with velocities and displacements, which are ignored.

use super::lines::{Columns, Line, Lines, refused, text};
use super::raw::{MotionFormat, Raw};
use super::units::acceleration_unit;
use super::{Orientation, SeismicError};
use crate::limits::refuse_channels;
use crate::quoted::shown;
use crate::wrong::OfStation;

/// Length of the shortest line with information: "Chan 1:".
const LINE_LEAST: usize = 7;
/// The first line begins with one of these, in lower or upper case.
const FIRST: [&str; 3] = [
    "uncorrected accelerogram",
    "corrected accelerogram",
    "raw accelerogram",
];

pub(super) fn is_csmip(bytes: &[u8]) -> bool {
    let first = Lines::new(bytes).next();
    first.is_some_and(|line| {
        FIRST
            .iter()
            .any(|begin| text(line).to_lowercase().starts_with(begin))
    })
}

/// Content of the line before a series.
struct Series {
    count: usize,
    time_step_s: f64,
    unit: String,
    columns: Columns,
    is_acceleration: bool,
}

/// The line before a series, of either version; `None` for any other line.
fn series(line: Line) -> Result<Option<Series>, SeismicError> {
    let told = text(line).to_lowercase();
    let first = told.contains("accelerogram points at");
    let second = told.contains("data equally spaced at");
    if !first && !second {
        return Ok(None);
    }
    let refuse = || refused(line, OfStation::CsmipData);
    let words: Vec<&str> = told.split_whitespace().collect();
    let number_after = |word: &str| {
        let at = words.iter().position(|w| *w == word)?;
        let value = words.get(at + 1)?.parse::<f64>().ok()?;
        (value.is_finite() && value > 0.0).then_some(value)
    };
    let given = number_after("at").ok_or_else(refuse)?;
    let unit = told
        .split(if first { "in units of" } else { ", in" })
        .nth(1)
        .unwrap_or_default();
    Ok(Some(Series {
        count: words
            .first()
            .and_then(|word| word.parse().ok())
            .ok_or_else(refuse)?,
        time_step_s: if first { 1.0 / given } else { given },
        unit: unit
            .split_whitespace()
            .next()
            .unwrap_or_default()
            .trim_end_matches(['.', ','])
            .to_owned(),
        columns: Columns::of_format(&told).ok_or_else(refuse)?,
        is_acceleration: first || told.contains("accel"),
    }))
}

/// "360" of "Chan  1: 360 Deg", "Up" of "Chan  2: Up".
fn direction(line: &str) -> Option<(String, Option<Orientation>)> {
    let at = line.find("Chan ")?;
    let (channel, rest) = line[at + 5..].split_once(':')?;
    channel.trim().parse::<u32>().ok()?;
    let word = rest.split_whitespace().next().unwrap_or_default();
    Some((
        shown(&format!("Chan {}", channel.trim())),
        Orientation::of_word(word),
    ))
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut channels: Vec<Raw> = Vec::new();
    let mut named: Option<(String, Option<Orientation>)> = None;
    let mut title = String::new();
    let mut lines = Lines::new(bytes);
    while let Some(line) = lines.next() {
        if line.1.len() < LINE_LEAST {
            continue;
        }
        let Some(series) = series(line)? else {
            let told = text(line);
            named = direction(&told).or(named);
            let station = told.to_lowercase();
            if station.starts_with("station id") || station.starts_with("station no") {
                title = shown(&told.split_whitespace().collect::<Vec<_>>().join(" "));
            }
            continue;
        };
        let samples = series.columns.read(&mut lines, series.count)?;
        if !series.is_acceleration {
            continue;
        }
        let unknown = || SeismicError::At2Unit {
            line: line.0,
            text: series.unit.clone(),
        };
        let unit = acceleration_unit(&series.unit).ok_or_else(unknown)?;
        refuse_channels("csmip", channels.len() + 1)?;
        let (name, orientation) = named
            .take()
            .unwrap_or((format!("channel {}", channels.len() + 1), None));
        channels.push(Raw {
            name,
            title: title.clone(),
            samples,
            unit: Some(unit),
            orientation,
            ..Raw::new(MotionFormat::Csmip, series.time_step_s)
        });
    }
    if channels.is_empty() {
        return Err(SeismicError::Missing {
            label: "\"… points of accel data equally spaced at …\"",
            lines: 0,
        });
    }
    Ok(channels)
}
