//! Reads AT2 files, the text files of the PEER strong motion databases, with either of their headers. The last word of the
//! second line is the direction if it is an azimuth, UP or DWN.
//!
//! ```text
//! PEER NGA STRONG MOTION DATABASE RECORD
//! Imperial Valley-02, 5/19/1940, El Centro Array #9, 180
//! ACCELERATION TIME SERIES IN UNITS OF G
//! NPTS=   5372, DT=   .0100 SEC                 or, before 2005:   4000    0.0100    NPTS, DT
//!    .9984852E-03   .9991426E-03   .9997266E-03   .1000268E-02   .1000757E-02
//! ```

use super::lines::excerpt;
use super::raw::{MotionFormat, Raw};
use super::units::acceleration_unit;
use super::{Orientation, SeismicError};
use crate::limits::head;
use crate::number::parse_number;
use crate::unit::Unit;
use crate::wrong::OfStation;

/// Number of lines in which NPTS is searched; the databases put it into the fourth.
const HEADER_LINES_MOST: usize = 10;
/// Whether one of the first lines contains NPTS.
pub(super) fn is_at2(bytes: &[u8]) -> bool {
    header_length(bytes).is_some()
}

/// Index of the line that contains NPTS.
fn header_length(bytes: &[u8]) -> Option<usize> {
    let mut lines = bytes.split(|b| *b == b'\n').take(HEADER_LINES_MOST);
    lines.position(|line| line.to_ascii_uppercase().windows(4).any(|w| w == b"NPTS"))
}

/// The samples as the file prints them.
pub(super) fn read(bytes: &[u8], unit_is_given: bool) -> Result<Vec<Raw>, SeismicError> {
    let at = header_length(head(bytes)).ok_or(SeismicError::Missing {
        label: "NPTS",
        lines: HEADER_LINES_MOST,
    })?;
    let lines: Vec<&[u8]> = bytes.split(|b| *b == b'\n').take(at + 1).collect();
    let mut unit = None;
    for (i, line) in lines.iter().enumerate() {
        unit = unit.or(unit_of(line, i + 1, unit_is_given)?);
    }
    let (stated, time_step_s) = counts(lines[at]).ok_or_else(|| SeismicError::At2Header {
        line: at + 1,
        text: excerpt(lines[at]),
    })?;
    let mut samples = Vec::new();
    for (i, line) in bytes.split(|b| *b == b'\n').enumerate().skip(at + 1) {
        for text in line.split(u8::is_ascii_whitespace).filter(|t| !t.is_empty()) {
            match parse_number(text) {
                Some(value) if value.is_finite() => samples.push(value),
                _ => {
                    return Err(SeismicError::NotANumber {
                        line: i + 1,
                        text: excerpt(text),
                    });
                }
            }
        }
    }
    if stated != samples.len() as u64 {
        return Err(SeismicError::Count {
            stated,
            found: samples.len(),
        });
    }
    let title = if at >= 2 { excerpt(lines[1]) } else { String::new() };
    let direction = title.rsplit(',').next().and_then(Orientation::of_word);
    Ok(vec![Raw {
        title,
        samples,
        unit,
        orientation: direction,
        ..Raw::new(MotionFormat::At2, time_step_s)
    }])
}

/// Unit of acceleration stated in a header line; refuses a line about velocities or displacements.
fn unit_of(line: &[u8], number: usize, unit_is_given: bool) -> Result<Option<Unit>, SeismicError> {
    let upper = String::from_utf8_lossy(line).to_uppercase();
    let Some((what, unit)) = upper.split_once("UNITS OF") else {
        return Ok(None);
    };
    let other = [
        ("VELOCITY", OfStation::Velocities),
        ("DISPLACEMENT", OfStation::Displacements),
    ];
    if let Some((_, what)) = other.iter().find(|(word, _)| what.contains(word)) {
        return Err(SeismicError::Quantity {
            line: number,
            what: what.clone().into(),
        });
    }
    let word = unit.split_whitespace().next().unwrap_or_default();
    let word = word.trim_end_matches(['.', ',']);
    match acceleration_unit(word) {
        Some(unit) => Ok(Some(unit)),
        None if unit_is_given => Ok(None),
        None => Err(SeismicError::At2Unit {
            line: number,
            text: excerpt(word.as_bytes()),
        }),
    }
}

/// NPTS and DT from their line, in either form of the header.
fn counts(line: &[u8]) -> Option<(u64, f64)> {
    let upper = String::from_utf8_lossy(line).to_uppercase();
    let words = |text: &str| -> Vec<String> {
        let parts = text.split(|c: char| c.is_whitespace() || c == ',' || c == '=');
        parts.filter(|w| !w.is_empty()).map(str::to_owned).collect()
    };
    let words = words(&upper);
    let after = |name: &str| {
        let at = words.iter().position(|word| word == name)?;
        words.get(at + 1)
    };
    let (count, step) = if upper.contains('=') {
        (after("NPTS")?, after("DT")?)
    } else {
        (words.first()?, words.get(1)?)
    };
    let step: f64 = step.parse().ok()?;
    Some((count.parse().ok()?, step)).filter(|(_, step)| step.is_finite() && *step > 0.0)
}
