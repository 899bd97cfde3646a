//! miniSEED 2: records of one or several channels, each with a header of 48 bytes, blockettes and packed samples.
//!
//! | byte | what |
//! |:--|:--|
//! | 8, 13, 15, 18 | station, location, channel, network |
//! | 20 | year, day of year, hour, minute, second, 1/10000 s |
//! | 30, 32, 34 | samples, rate factor, rate multiplier |
//! | 36, 40 | activity flags, time correction (1/10000 s) |
//! | 44, 46 | positions of the samples and of the first blockette |
//! | blockette 1000 | encoding, byte order, length of the record 2ⁿ |
//!
//! The numbers are usually counts of a recorder, so that the unit and a factor must be given.
//!
//! Source: FDSN (2012) *SEED Reference Manual*, version 2.4, chapters 8 and appendix B.

use super::raw::{MotionFormat, Raw};
use super::steim::{self, Steim};
use super::{Orientation, SeismicError};
use crate::breaks::Break;
use crate::limits::refuse_channels;
use crate::start;
use crate::wrong::OfStation;
use std::collections::BTreeMap;

const HEADER_BYTES: usize = 48;
/// Exponents n of allowed record lengths 2ⁿ.
const RECORD_EXPONENTS: std::ops::RangeInclusive<u8> = 7..=20;
/// Largest deviation of a record's start from the end of the previous one, in sampling steps. Our choice: half a step decides.
const GAP_STEPS: f64 = 0.5;

/// Whether the file begins with the header of a record.
pub(super) fn is_miniseed(bytes: &[u8]) -> bool {
    bytes.len() >= HEADER_BYTES && is_header(bytes)
}

fn is_header(bytes: &[u8]) -> bool {
    let numbered = bytes[..6]
        .iter()
        .all(|b| b.is_ascii_digit() || matches!(b, b' ' | 0));
    numbered && matches!(bytes[6], b'D' | b'R' | b'Q' | b'M') && matches!(bytes[7], b' ' | 0)
}

/// Numbers of a record in its byte order. Every access checks its end.
#[derive(Clone, Copy)]
struct Bytes<'a> {
    record: &'a [u8],
    little: bool,
    at: u64,
}

impl Bytes<'_> {
    fn array<const N: usize>(&self, at: usize) -> Result<[u8; N], SeismicError> {
        let chunk = self.record.get(at..).and_then(|rest| rest.first_chunk::<N>());
        let mut bytes = *chunk.ok_or(SeismicError::Damaged {
            at: self.at,
            what: OfStation::FieldOutside.into(),
        })?;
        if !self.little {
            bytes.reverse();
        }
        Ok(bytes)
    }

    fn u16(&self, at: usize) -> Result<u16, SeismicError> {
        self.array(at).map(u16::from_le_bytes)
    }

    fn i16(&self, at: usize) -> Result<i16, SeismicError> {
        self.array(at).map(i16::from_le_bytes)
    }

    fn i32(&self, at: usize) -> Result<i32, SeismicError> {
        self.array(at).map(i32::from_le_bytes)
    }
}

/// Content of the header and blockettes of a record.
struct Record {
    name: String,
    channel: String,
    begins_s: f64,
    rate_hz: f64,
    samples: usize,
    data: usize,
    encoding: u8,
    data_is_little: bool,
    length: usize,
}

pub(super) fn read(bytes: &[u8]) -> Result<Vec<Raw>, SeismicError> {
    let mut channels = Channels::default();
    let mut at = 0;
    while at < bytes.len() {
        let rest = &bytes[at..];
        if rest.len() < HEADER_BYTES || !is_header(rest) {
            return Err(SeismicError::Damaged {
                at: at as u64,
                what: OfStation::NoDataRecord.into(),
            });
        }
        let record = header(rest, at as u64)?;
        if rest.len() < record.length {
            let stated = (at + record.length) as u64;
            return Err(SeismicError::Bytes {
                format: "miniseed",
                stated,
                found: bytes.len(),
            });
        }
        if record.samples > 0 {
            let samples = samples(&rest[..record.length], &record, at as u64)?;
            channels.join(record_of(&record), samples)?;
        }
        at += record.length;
    }
    match channels.raw.is_empty() {
        true => Err(SeismicError::Damaged {
            at: 0,
            what: OfStation::NoRecordHolds.into(),
        }),
        false => Ok(channels.raw),
    }
}

fn record_of(record: &Record) -> Raw {
    Raw {
        name: record.name.clone(),
        orientation: Orientation::of_channel_code(&record.channel),
        begins_s: Some(record.begins_s),
        ..Raw::new(MotionFormat::MiniSeed, 1.0 / record.rate_hz)
    }
}

/// The channels of a file in the order of their first records.
#[derive(Default)]
struct Channels {
    raw: Vec<Raw>,
    /// Index of the channel with a name.
    places: BTreeMap<String, usize>,
}

impl Channels {
    /// Appends the samples of a record to its channel; reports a gap, and refuses an overlap.
    fn join(&mut self, mut record: Raw, samples: Vec<f64>) -> Result<(), SeismicError> {
        let next = self.raw.len();
        let place = match self.places.get(&record.name) {
            Some(place) => *place,
            None => next,
        };
        let Some(known) = self.raw.get_mut(place) else {
            refuse_channels("miniseed", next + 1)?;
            self.places.insert(record.name.clone(), next);
            record.samples = samples;
            self.raw.push(record);
            return Ok(());
        };
        let (step, first) = (known.time_step_s, known.begins_s.unwrap_or(0.0));
        let last = known
            .breaks
            .last()
            .copied()
            .unwrap_or(Break { at: 0, begins_s: 0.0 });
        let expected_s = last.begins_s + (known.samples.len() - last.at) as f64 * step;
        let found_s = record.begins_s.unwrap_or(0.0) - first;
        let other_rate = (record.time_step_s / step - 1.0).abs() > 1e-4;
        if other_rate || found_s < expected_s - GAP_STEPS * step {
            return Err(SeismicError::Gap {
                channel: record.name,
                expected_s,
                found_s,
            });
        }
        if found_s > expected_s + GAP_STEPS * step {
            known.breaks.push(Break {
                at: known.samples.len(),
                begins_s: found_s,
            });
        }
        known.samples.extend(samples);
        Ok(())
    }
}

/// Returns the channels if none has a gap.
pub(super) fn whole(channels: Vec<Raw>) -> Result<Vec<Raw>, SeismicError> {
    for channel in &channels {
        if let Some(first) = channel.breaks.first() {
            return Err(SeismicError::Gap {
                channel: channel.name.clone(),
                expected_s: first.at as f64 * channel.time_step_s,
                found_s: first.begins_s,
            });
        }
    }
    Ok(channels)
}

fn header(record: &[u8], at: u64) -> Result<Record, SeismicError> {
    let refuse = |what: OfStation| SeismicError::Damaged {
        at,
        what: what.into(),
    };
    let big = Bytes {
        record,
        little: false,
        at,
    };
    // the byte order that gives a plausible year and day of the year
    let dated = |bytes: &Bytes| -> Result<bool, SeismicError> {
        Ok((1900..=2500).contains(&bytes.u16(20)?) && (1..=366).contains(&bytes.u16(22)?))
    };
    let little = Bytes { little: true, ..big };
    let bytes = match (dated(&big)?, dated(&little)?) {
        (true, _) => big,
        (_, true) => little,
        _ => {
            return Err(refuse(OfStation::YearAndDay));
        }
    };
    let [hour, minute, second] = [24, 25, 26].map(|at| i64::from(record[at]));
    let day = start::days(i64::from(bytes.u16(20)?), 1, 1).ok_or(refuse(OfStation::Year))?;
    let mut begins_s = start::seconds(day + i64::from(bytes.u16(22)?) - 1, hour, minute, second as f64)
        + f64::from(bytes.u16(28)?) * 1e-4;
    const CORRECTED: u8 = 2;
    if record[36] & CORRECTED == 0 {
        begins_s += f64::from(bytes.i32(40)?) * 1e-4;
    }
    let mut rate_hz = rate(bytes.i16(32)?, bytes.i16(34)?);
    let mut coded = None;
    let mut blockette = usize::from(bytes.u16(46)?);
    for _ in 0..record[39] {
        if blockette < HEADER_BYTES {
            break;
        }
        match bytes.u16(blockette)? {
            100 => rate_hz = f64::from(f32::from_le_bytes(bytes.array(blockette + 4)?)),
            1000 => {
                coded = Some(
                    Bytes {
                        little: true,
                        ..bytes
                    }
                    .array::<3>(blockette + 4)?,
                )
            }
            1001 => {
                begins_s += f64::from(
                    Bytes {
                        little: true,
                        ..bytes
                    }
                    .array::<1>(blockette + 5)?[0] as i8,
                ) * 1e-6
            }
            _ => {}
        }
        let next = usize::from(bytes.u16(blockette + 2)?);
        if next != 0 && next <= blockette {
            return Err(refuse(OfStation::Blockettes));
        }
        blockette = next;
    }
    let [encoding, order, exponent] = coded.ok_or(refuse(OfStation::NoBlockette1000))?;
    if !RECORD_EXPONENTS.contains(&exponent) {
        return Err(refuse(OfStation::RecordLength));
    }
    let samples = usize::from(bytes.u16(30)?);
    if samples > 0 && !(rate_hz.is_finite() && rate_hz > 0.0) {
        return Err(refuse(OfStation::RateNotPositive));
    }
    let code = |range: std::ops::Range<usize>| {
        String::from_utf8_lossy(&record[range])
            .trim_matches([' ', '\0'])
            .to_owned()
    };
    let (station, location, channel, network) = (code(8..13), code(13..15), code(15..18), code(18..20));
    Ok(Record {
        name: [network, station, location, channel.clone()].join("."),
        channel,
        begins_s,
        rate_hz,
        samples,
        data: usize::from(bytes.u16(44)?),
        encoding,
        data_is_little: order == 0,
        length: 1 << exponent,
    })
}

/// Hz from factor and multiplier; negative values divide.
fn rate(factor: i16, multiplier: i16) -> f64 {
    let part = |value: i16| {
        if value < 0 {
            -1.0 / f64::from(value)
        } else {
            f64::from(value)
        }
    };
    part(factor) * part(multiplier)
}

fn samples(record: &[u8], told: &Record, at: u64) -> Result<Vec<f64>, SeismicError> {
    let refuse = |what: OfStation| SeismicError::Damaged {
        at,
        what: what.into(),
    };
    let outside = refuse(OfStation::SamplesOutside);
    let data = record
        .get(told.data..)
        .filter(|_| told.data >= HEADER_BYTES)
        .ok_or(outside)?;
    let bytes = Bytes {
        record: data,
        little: told.data_is_little,
        at,
    };
    let plain = |width: usize, value: &dyn Fn(usize) -> Result<f64, SeismicError>| {
        if told.samples * width > data.len() {
            return Err(refuse(OfStation::RecordTooShort));
        }
        (0..told.samples).map(|i| value(i * width)).collect()
    };
    match told.encoding {
        1 => plain(2, &|at| bytes.i16(at).map(f64::from)),
        3 => plain(4, &|at| bytes.i32(at).map(f64::from)),
        4 => plain(4, &|at| bytes.array(at).map(|b| f64::from(f32::from_le_bytes(b)))),
        5 => plain(8, &|at| bytes.array(at).map(f64::from_le_bytes)),
        10 => steim::unpacked(data, told.samples, Steim::One, told.data_is_little, at),
        11 => steim::unpacked(data, told.samples, Steim::Two, told.data_is_little, at),
        encoding => Err(SeismicError::Encoding { at, encoding }),
    }
}
