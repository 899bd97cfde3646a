//! Reads ESM ASCII files (DYNA 1.2): one component of the Engineering Strong Motion database or of ITACA.
//!
//! ```text
//! SAMPLING_INTERVAL_S: 0.005000                 KEY: value, a line each; then one number a line
//! NDATA: 19128
//! STREAM: HNE
//! UNITS: cm/s^2
//! DATA_TYPE: ACCELERATION
//! PGA_CM/S^2: 0.300022
//! ```

use super::lines::{Lines, all_numbers, number};
use super::raw::{MotionFormat, Raw};
use super::units::acceleration_unit;
use super::{Orientation, SeismicError};
use crate::start;
use crate::wrong::OfStation;

/// Largest number of header lines; DYNA 1.2 has 64.
const HEADER_LINES_MOST: usize = 200;

/// Key and value of a header line; `None` for a line with a sample.
fn entry(line: &[u8]) -> Option<(String, String)> {
    let text = String::from_utf8_lossy(line).into_owned();
    let (key, value) = text.split_once(':')?;
    let plain = |c: char| c.is_ascii_uppercase() || c.is_ascii_digit() || "_/^".contains(c);
    let is_key = key.starts_with(|c: char| c.is_ascii_uppercase()) && key.chars().all(plain);
    is_key.then(|| (key.to_owned(), value.trim().to_owned()))
}

pub(super) fn is_esm(bytes: &[u8]) -> bool {
    let mut keys = Lines::new(bytes)
        .take(HEADER_LINES_MOST)
        .map_while(|(_, line)| entry(line));
    keys.any(|(key, _)| key == "SAMPLING_INTERVAL_S")
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut lines = Lines::new(bytes);
    let mut header = Vec::new();
    while let Some(line) = lines.peek()
        && let Some((key, value)) = entry(line.1)
        && header.len() < HEADER_LINES_MOST
    {
        header.push((line.0, key, value));
        lines.next();
    }
    let find = |label: &'static str| {
        let found = header.iter().find(|(_, key, _)| key == label);
        found.map(|(line, _, value)| (*line, value.as_str()))
    };
    let want = |label: &'static str| {
        find(label).ok_or(SeismicError::Missing {
            label,
            lines: header.len(),
        })
    };
    let positive = |label: &'static str, wanted: OfStation| {
        let (line, text) = want(label)?;
        let value = number(line, text.as_bytes())?;
        let bad = || SeismicError::Line {
            line,
            text: text.to_owned(),
            wanted: wanted.into(),
        };
        (value > 0.0).then_some(value).ok_or_else(bad)
    };
    let time_step_s = positive("SAMPLING_INTERVAL_S", OfStation::EsmStep)?;
    let stated = positive("NDATA", OfStation::EsmCount)?;
    // capital letters in the database, small letters in files of its partners
    let data_type = find("DATA_TYPE").map(|(line, text)| (line, text, text.to_ascii_uppercase()));
    match data_type
        .as_ref()
        .map(|(line, text, word)| (*line, *text, word.as_str()))
    {
        None | Some((_, _, "ACCELERATION")) => {}
        Some((line, _, "VELOCITY")) => {
            return Err(SeismicError::Quantity {
                line,
                what: OfStation::Velocities.into(),
            });
        }
        Some((line, _, "DISPLACEMENT")) => {
            return Err(SeismicError::Quantity {
                line,
                what: OfStation::Displacements.into(),
            });
        }
        Some((line, other, _)) => {
            let wanted = OfStation::EsmType;
            return Err(SeismicError::Line {
                line,
                text: other.to_owned(),
                wanted: wanted.into(),
            });
        }
    }
    let unit = match find("UNITS") {
        None | Some((_, "")) => None,
        Some((line, text)) => {
            let unknown = || SeismicError::At2Unit {
                line,
                text: text.to_owned(),
            };
            Some(acceleration_unit(text).ok_or_else(unknown)?)
        }
    };
    let samples = all_numbers(lines)?;
    if stated != samples.len() as f64 {
        return Err(SeismicError::Count {
            stated: stated as u64,
            found: samples.len(),
        });
    }
    let value = |label: &'static str| find(label).map_or("", |(_, value)| value);
    let stream = value("STREAM");
    let name = [value("NETWORK"), value("STATION_CODE"), stream].join(".");
    let peak = find("PGA_CM/S^2").and_then(|(_, peak)| peak.parse::<f64>().ok());
    let title = [
        value("EVENT_NAME"),
        value("EVENT_DATE_YYYYMMDD"),
        value("STATION_NAME"),
    ];
    Ok(vec![Raw {
        name,
        title: title.join(", "),
        samples,
        unit,
        orientation: Orientation::of_channel_code(stream),
        begins_s: start::start_of_text(value("DATE_TIME_FIRST_SAMPLE_YYYYMMDD_HHMMSS")),
        stated_peak: peak
            .filter(|_| unit == Some(crate::unit::Unit::Gal))
            .map(f64::abs),
        ..Raw::new(MotionFormat::Esm, time_step_s)
    }])
}
