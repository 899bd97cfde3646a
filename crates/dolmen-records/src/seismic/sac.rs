//! Reads SAC files, binary (either byte order) and alphanumeric, header versions 6 and 7: one channel with equal time
//! steps.
//!
//! | word | what | here |
//! |:--|:--|:--|
//! | float 0 | DELTA, s | time step; version 7 stores it in double precision after the samples |
//! | float 5 | B, s | time of the first sample after the reference time |
//! | float 57, 58 | CMPAZ, CMPINC, ° | direction: inclination 0 up, 90 horizontal, 180 down |
//! | integer 0 … 5 | NZYEAR … NZMSEC | reference time |
//! | integer 6, 9, 15, 16 | NVHDR, NPTS, IFTYPE, IDEP | version, number of samples, 1 = a time series, quantity |
//! | integer 35 | LEVEN | 1 = equal time steps |
//!
//! In practice SAC files do not state the unit of their numbers reliably, so the user must give it.
//!
//! Source: Goldstein, Snoke (2005) *SAC Availability for the IRIS Community*; the SAC data file format of its manual.

use super::lines::{Lines, all_numbers, number, refused, text};
use super::raw::{MotionFormat, Raw};
use super::{Orientation, SeismicError};
use crate::start;
use crate::wrong::OfStation;
use dolmen::signal::Quantity;

const FLOATS: usize = 70;
const INTEGERS: usize = 40;
const TEXTS: usize = 24;
/// Bytes of a header: 110 words of 4 bytes and 24 words of 8 bytes.
const HEADER_BYTES: usize = 4 * (FLOATS + INTEGERS) + 8 * TEXTS;
/// Bytes of the footer of version 7: doubles after the samples.
const FOOTER_BYTES: usize = 22 * 8;
/// Value that SAC writes for an unknown number.
const UNKNOWN: f64 = -12345.0;
const VERSIONS: [i64; 2] = [6, 7];
/// Codes: IFTYPE of a time series, IDEP of displacement and of velocity.
const TIME_SERIES: i64 = 1;
const DISPLACEMENT: i64 = 6;
const VELOCITY: i64 = 7;

/// The three parts of a header.
struct Header {
    floats: Vec<f64>,
    integers: Vec<i64>,
    texts: Vec<String>,
}

impl Header {
    fn float(&self, at: usize) -> Option<f64> {
        Some(self.floats[at]).filter(|value| value.is_finite() && *value != UNKNOWN)
    }

    fn integer(&self, at: usize) -> Option<i64> {
        Some(self.integers[at]).filter(|value| *value != UNKNOWN as i64)
    }

    fn text(&self, at: usize) -> &str {
        let word = self.texts[at].trim_matches(['\0', ' ']);
        if word == "-12345" { "" } else { word }
    }

    /// Time of the first sample: the reference time plus B.
    fn begins_s(&self) -> Option<f64> {
        let part = |at: usize| self.integer(at);
        let day =
            start::days(part(0)?, 1, 1)? + part(1)?.checked_sub(1).filter(|day| (0..366).contains(day))?;
        let (hour, minute, second, millisecond) = (part(2)?, part(3)?, part(4)?, part(5)?);
        let allowed = (0..24).contains(&hour) && (0..60).contains(&minute) && (0..=60).contains(&second);
        let second = second as f64 + millisecond as f64 / 1e3;
        // check the fields first: values that are not a time of day would overflow
        allowed.then_some(())?;
        Some(start::seconds(day, hour, minute, second) + self.float(5)?)
    }

    fn orientation(&self) -> Option<Orientation> {
        match (self.float(57), self.float(58)) {
            (_, Some(0.0)) => Some(Orientation::Up),
            (_, Some(180.0)) => Some(Orientation::Down),
            (Some(azimuth), Some(90.0)) => Orientation::horizontal(azimuth),
            _ => Orientation::of_channel_code(self.text(20)),
        }
    }

    /// Reads the header of a time series of accelerations; returns the channel without samples, and the expected
    /// number of samples.
    fn raw(&self, format: MotionFormat) -> Result<(Raw, usize), SeismicError> {
        let refuse = |what: OfStation, found: f64| SeismicError::Sac {
            what: what.into(),
            found,
        };
        if self.integers[15] != TIME_SERIES {
            return Err(refuse(OfStation::SacType, self.integers[15] as f64));
        }
        if self.integers[35] != 1 {
            return Err(refuse(OfStation::SacEven, self.integers[35] as f64));
        }
        let quantity = match self.integers[16] {
            DISPLACEMENT => Some(Quantity::Displacement),
            VELOCITY => Some(Quantity::Velocity),
            _ => None,
        };
        let step = self.float(0).filter(|step| *step > 0.0);
        let time_step_s = step.ok_or(refuse(OfStation::SacStep, self.floats[0]))?;
        let count = self.integers[9];
        let count = usize::try_from(count).map_err(|_| refuse(OfStation::SacCount, count as f64))?;
        let name = [self.text(21), self.text(0), self.text(20)]
            .into_iter()
            .filter(|part| !part.is_empty());
        let raw = Raw {
            name: name.collect::<Vec<_>>().join("."),
            title: format!("{}{}", self.texts[1], self.texts[2])
                .trim_matches(['\0', ' '])
                .replace("-12345", ""),
            orientation: self.orientation(),
            begins_s: self.begins_s(),
            quantity,
            ..Raw::new(format, time_step_s)
        };
        Ok((raw, count))
    }
}

/// The shortest decimal number that rounds to this 32-bit float, such as 0.01.
fn shortest(value: f32) -> f64 {
    value.to_string().parse().unwrap_or(f64::from(value))
}

/// Whether integers are stored with the least significant byte first; `None` if the file is not a SAC file.
fn is_little(bytes: &[u8]) -> Option<bool> {
    let word = bytes.get(4 * (FLOATS + 6)..4 * (FLOATS + 7))?.try_into().ok()?;
    let stands = |version: i32| VERSIONS.contains(&i64::from(version));
    match (stands(i32::from_le_bytes(word)), stands(i32::from_be_bytes(word))) {
        (true, _) => Some(true),
        (_, true) => Some(false),
        _ => None,
    }
}

pub(super) fn is_binary(bytes: &[u8]) -> bool {
    bytes.len() >= HEADER_BYTES && is_little(bytes).is_some()
}

pub(super) fn read_binary(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let (Some(little), true) = (is_little(bytes), bytes.len() >= HEADER_BYTES) else {
        return Err(SeismicError::Bytes {
            format: "sac",
            stated: HEADER_BYTES as u64,
            found: bytes.len(),
        });
    };
    let word = |at: usize| -> [u8; 4] {
        let word = &bytes[4 * at..4 * at + 4];
        let [a, b, c, d] = [word[0], word[1], word[2], word[3]];
        if little { [a, b, c, d] } else { [d, c, b, a] }
    };
    let float = |at: usize| f32::from_le_bytes(word(at));
    let texts = bytes[4 * (FLOATS + INTEGERS)..HEADER_BYTES].chunks(8);
    let header = Header {
        floats: (0..FLOATS).map(|at| shortest(float(at))).collect(),
        integers: (FLOATS..FLOATS + INTEGERS)
            .map(|at| i64::from(i32::from_le_bytes(word(at))))
            .collect(),
        texts: texts
            .map(|text| String::from_utf8_lossy(text).into_owned())
            .collect(),
    };
    let (mut raw, count) = header.raw(MotionFormat::Sac)?;
    let is_seventh = header.integers[6] == VERSIONS[1];
    let footer = if is_seventh { FOOTER_BYTES } else { 0 };
    let stated = HEADER_BYTES as u64 + 4 * count as u64 + footer as u64;
    if stated != bytes.len() as u64 {
        return Err(SeismicError::Bytes {
            format: "sac",
            stated,
            found: bytes.len(),
        });
    }
    let first = HEADER_BYTES / 4;
    raw.samples = (first..first + count).map(|at| f64::from(float(at))).collect();
    if is_seventh
        && let Some(Ok(delta)) = bytes[HEADER_BYTES + 4 * count..]
            .first_chunk()
            .map(|b: &[u8; 8]| {
                let delta = if little {
                    f64::from_le_bytes(*b)
                } else {
                    f64::from_be_bytes(*b)
                };
                (delta.is_finite() && delta > 0.0).then_some(delta).ok_or(())
            })
    {
        raw.time_step_s = delta;
    }
    Ok(vec![raw])
}

/// Numbers of lines with floats, integers and texts in an alphanumeric header.
const FLOAT_LINES: usize = 14;
const INTEGER_LINES: usize = 8;
const TEXT_LINES: usize = 8;
/// Numbers per line of the header.
const ON_A_LINE: usize = 5;

pub(super) fn is_alphanumeric(bytes: &[u8]) -> bool {
    let Ok(header) = alphanumeric_numbers(&mut Lines::new(bytes)) else {
        return false;
    };
    VERSIONS.contains(&header.1[6])
}

fn alphanumeric_numbers(lines: &mut Lines) -> Result<(Vec<f64>, Vec<i64>), SeismicError> {
    let mut part = |rows: usize| {
        let mut values = Vec::new();
        for _ in 0..rows {
            let line = lines.want(OfStation::SacNumbers)?;
            let cells = line
                .1
                .split(u8::is_ascii_whitespace)
                .filter(|cell| !cell.is_empty());
            let row = cells
                .map(|cell| number(line.0, cell))
                .collect::<Result<Vec<f64>, _>>()?;
            if row.len() != ON_A_LINE {
                return Err(refused(line, OfStation::SacNumbers));
            }
            values.extend(row);
        }
        Ok(values)
    };
    let floats = part(FLOAT_LINES)?;
    let integers = part(INTEGER_LINES)?;
    Ok((floats, integers.into_iter().map(|value| value as i64).collect()))
}

pub(super) fn read_alphanumeric(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut lines = Lines::new(bytes);
    let (floats, integers) = alphanumeric_numbers(&mut lines)?;
    let mut texts = Vec::new();
    for _ in 0..TEXT_LINES {
        let line = text(lines.want(OfStation::SacTexts)?);
        let characters: Vec<char> = line.chars().chain(std::iter::repeat(' ')).take(24).collect();
        texts.extend(characters.chunks(8).map(|word| word.iter().collect::<String>()));
    }
    let (mut raw, count) = Header {
        floats,
        integers,
        texts,
    }
    .raw(MotionFormat::SacText)?;
    raw.samples = all_numbers(lines)?;
    if raw.samples.len() != count {
        return Err(SeismicError::Count {
            stated: count as u64,
            found: raw.samples.len(),
        });
    }
    Ok(vec![raw])
}
