//! TDMS, the file format of LabVIEW: segments of objects with properties, and their samples.
//!
//! | part | what |
//! |:--|:--|
//! | lead-in, 28 bytes | `TDSm`, flags, version, length of the segment and of its description |
//! | description | objects: path, position of samples (type, values per chunk), properties |
//! | raw data | chunks; in each, the values of one object after another, or interleaved |
//!
//! Only these properties are read: `wf_increment` (s), `wf_start_time`, `wf_start_offset`, `unit_string`.
//!
//! Source: National Instruments (2023) *TDMS File Format Internal Structure*.

use super::cursor::{Cursor, Number};
use super::series::{FileSeries, Series, rate_of_step};
use super::unit::unit_of_label;
use super::{FileUnit, RecordError, RecordFormat};
use crate::limits::{PARTS_MOST, refuse_channels, refuse_parts};
use crate::quoted::shown;
use crate::wrong::{Damage, Unread};
use std::collections::BTreeMap;

const FORMAT: &str = "tdms";
const LEAD_IN: usize = 28;
/// Properties in use.
const PROPERTIES: [&str; 5] = [
    "NI_Number_Of_Scales",
    "unit_string",
    "wf_increment",
    "wf_start_offset",
    "wf_start_time",
];
/// Longest path of a group or channel. Our choice: two names that fill a screen each.
const PATH_BYTES_MOST: usize = 4096;
/// Flags of a segment.
const NEW_DESCRIPTION: u32 = 1 << 1;
const NEW_LIST: u32 = 1 << 2;
const RAW_DATA: u32 = 1 << 3;
const INTERLEAVED: u32 = 1 << 5;
const BIG_ENDIAN: u32 = 1 << 6;
const DAQMX: u32 = 1 << 7;
/// Length of a segment that was never closed.
const OPEN: u64 = u64::MAX;
/// 1 January 1904 to 1 January 1970, s.
const EPOCH_S: f64 = 2_082_844_800.0;
/// Type codes.
const TEXT: u32 = 0x20;
const TIME: u32 = 0x44;

pub(super) fn is_tdms(bytes: &[u8]) -> bool {
    bytes.starts_with(b"TDSm") || bytes.starts_with(b"TDSh")
}

fn unread(what: Unread, instead: Unread) -> RecordError {
    RecordError::NotReadHere {
        format: FORMAT,
        what: what.into(),
        instead: instead.into(),
    }
}

/// The type of number for a type code.
fn number(code: u32) -> Option<Number> {
    Some(match code {
        1 => Number::I8,
        2 => Number::I16,
        3 => Number::I32,
        4 => Number::I64,
        5 => Number::U8,
        6 => Number::U16,
        7 => Number::U32,
        8 => Number::U64,
        9 | 0x19 => Number::F32,
        10 | 0x1A => Number::F64,
        _ => return None,
    })
}

/// Value of a property.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    Number(f64),
    Text(String),
    /// s from 1904.
    Time(f64),
}

/// Place of the samples of an object in a chunk.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Raw {
    number: Number,
    values: usize,
}

#[derive(Default)]
struct Object {
    path: String,
    properties: BTreeMap<String, Value>,
    raw: Option<Raw>,
    samples: Vec<f64>,
    /// Its position among the objects with samples in the current segment.
    turn: Option<u64>,
}

#[derive(Default)]
struct File {
    objects: Vec<Object>,
    /// Index of the object with a path.
    places: BTreeMap<String, usize>,
    /// Objects with samples in the current segment, in order. Those without values are left out: a chunk then has at least one byte for each,
    /// and reading it takes time in proportion to its length.
    listed: BTreeMap<u64, usize>,
    turns: u64,
}

impl File {
    /// The object of a path, in the order of the file.
    fn place(&mut self, path: String) -> Result<usize, RecordError> {
        if let Some(place) = self.places.get(&path) {
            return Ok(*place);
        }
        let place = self.objects.len();
        refuse_parts(FORMAT, Unread::GroupsAndChannels, place + 1, PARTS_MOST)?;
        self.objects.push(Object {
            path: path.clone(),
            ..Default::default()
        });
        self.places.insert(path, place);
        Ok(place)
    }

    /// Moves an object to the end of those with samples in the current segment, or removes it.
    fn list(&mut self, place: usize, has_samples: bool) {
        let object = &mut self.objects[place];
        match (has_samples, object.turn) {
            (true, None) => {
                object.turn = Some(self.turns);
                self.listed.insert(self.turns, place);
                self.turns += 1;
            }
            (false, Some(turn)) => {
                object.turn = None;
                self.listed.remove(&turn);
            }
            _ => {}
        }
    }

    fn clear_list(&mut self) {
        for place in std::mem::take(&mut self.listed).into_values() {
            self.objects[place].turn = None;
        }
    }
}

pub(super) fn read(bytes: &[u8]) -> Result<FileSeries, RecordError> {
    if bytes.starts_with(b"TDSh") {
        return Err(unread(Unread::OnlyIndex, Unread::NameTdms));
    }
    let mut file = File::default();
    let mut cursor = Cursor::new(bytes, FORMAT);
    while cursor.left() > 0 {
        cursor = segment(cursor, &mut file)?;
    }
    series(file, &cursor)
}

/// Reads one segment and returns the place of the next.
fn segment<'a>(start: Cursor<'a>, file: &mut File) -> Result<Cursor<'a>, RecordError> {
    let mut cursor = start.ordered(false);
    if cursor.take(4)? != b"TDSm" {
        return Err(start.damaged(Damage::NoSegment));
    }
    let flags = cursor.u32()?;
    let mut cursor = cursor.ordered(flags & BIG_ENDIAN != 0);
    cursor.u32()?; // version
    let (length, description) = (cursor.u64()?, cursor.u64()?);
    if length == OPEN {
        return Err(cursor.damaged(Damage::SegmentOpen));
    }
    if flags & DAQMX != 0 {
        return Err(unread(Unread::Daqmx, Unread::ExportScaled));
    }
    let begin = start.at() + LEAD_IN;
    let place = |after: u64| {
        usize::try_from(after)
            .ok()
            .and_then(|after| begin.checked_add(after))
    };
    let (Some(end), Some(data)) = (place(length), place(description)) else {
        return Err(start.damaged(Damage::SegmentLength));
    };
    if data > end {
        return Err(start.damaged(Damage::DescriptionTooLong));
    }
    cursor.go(end)?;
    let next = cursor;
    cursor.go(begin)?;
    if flags & NEW_DESCRIPTION != 0 {
        if flags & NEW_LIST != 0 {
            file.clear_list();
        }
        objects(&mut cursor, file)?;
    }
    if cursor.at() > data && flags & RAW_DATA != 0 {
        return Err(start.damaged(Damage::DescriptionRunsOn));
    }
    if flags & RAW_DATA != 0 && end > data {
        cursor.go(data)?;
        samples(&mut cursor, file, end - data, flags & INTERLEAVED != 0)?;
    }
    Ok(next)
}

fn text(cursor: &mut Cursor) -> Result<String, RecordError> {
    let length = cursor.u32()? as usize;
    Ok(String::from_utf8_lossy(cursor.take(length)?).into_owned())
}

fn objects(cursor: &mut Cursor, file: &mut File) -> Result<(), RecordError> {
    for _ in 0..cursor.u32()? {
        let path = text(cursor)?;
        if path.len() > PATH_BYTES_MOST {
            return Err(cursor.damaged(Damage::PathBytes(path.len())));
        }
        let place = file.place(path)?;
        let object = &mut file.objects[place];
        let has_samples = match cursor.u32()? {
            0xFFFF_FFFF => false,
            0 => match object.raw {
                // as in the segment before
                Some(raw) => raw.values > 0,
                None => {
                    return Err(cursor.damaged(Damage::NoneBefore));
                }
            },
            0x1269 | 0x1369 => {
                return Err(unread(Unread::Daqmx, Unread::ExportScaled));
            }
            length => {
                let raw = raw(cursor, length, &object.path)?;
                object.raw = Some(raw);
                raw.values > 0
            }
        };
        for _ in 0..cursor.u32()? {
            let name = text(cursor)?;
            let value = value(cursor)?;
            if let (Some(value), true) = (value, PROPERTIES.contains(&name.as_str())) {
                object.properties.insert(name, value);
            }
        }
        file.list(place, has_samples);
    }
    Ok(())
}

fn raw(cursor: &mut Cursor, length: u32, path: &str) -> Result<Raw, RecordError> {
    let code = cursor.u32()?;
    let Some(number) = number(code) else {
        return Err(unread(
            Unread::SamplesOfType {
                code: format!("{code:#x}"),
                path: shown(path),
            },
            Unread::WriteNumbers,
        ));
    };
    let dimension = cursor.u32()?;
    let values = usize::try_from(cursor.u64()?).ok();
    let (20, 1, Some(values)) = (length, dimension, values) else {
        return Err(cursor.damaged(Damage::OneDimension(shown(path))));
    };
    Ok(Raw { number, values })
}

/// A property; `None` for types that are not in use.
fn value(cursor: &mut Cursor) -> Result<Option<Value>, RecordError> {
    let code = cursor.u32()?;
    if let Some(number) = number(code) {
        return number.read(cursor).map(|x| Some(Value::Number(x)));
    }
    match code {
        TEXT => Ok(Some(Value::Text(text(cursor)?))),
        TIME => {
            // in the other byte order, seconds come first
            let (parts, whole) = if cursor.is_big() {
                let whole = cursor.i64()?;
                (cursor.u64()?, whole)
            } else {
                (cursor.u64()?, cursor.i64()?)
            };
            Ok(Some(Value::Time(whole as f64 + parts as f64 / 2f64.powi(64))))
        }
        0x21 => cursor.u8().map(|_| None),
        0x0008_000C => cursor.take(8).map(|_| None),
        0x0010_000D | 0xF | 0x1B => cursor.take(16).map(|_| None),
        code => Err(cursor.damaged(Damage::PropertyType(format!("{code:#x}")))),
    }
}

/// The chunks of a segment: as many as fill it.
fn samples(cursor: &mut Cursor, file: &mut File, bytes: usize, interleaved: bool) -> Result<(), RecordError> {
    let of = |place: &usize| Some((*place, file.objects[*place].raw?));
    let listed: Vec<(usize, Raw)> = file.listed.values().filter_map(of).collect();
    let sizes = listed
        .iter()
        .map(|(_, raw)| raw.values.checked_mul(raw.number.bytes()));
    let chunk = sizes
        .into_iter()
        .try_fold(0usize, |sum, size| sum.checked_add(size?));
    let chunk = chunk
        .filter(|chunk| *chunk > 0 && bytes.is_multiple_of(*chunk))
        .ok_or_else(|| cursor.damaged(Damage::NoWholeChunks(bytes)))?;
    for _ in 0..bytes / chunk {
        if interleaved {
            let values = listed.first().map_or(0, |(_, raw)| raw.values);
            if listed.iter().any(|(_, raw)| raw.values != values) {
                return Err(cursor.damaged(Damage::InterleavedUnlike));
            }
            for _ in 0..values {
                for (place, raw) in &listed {
                    file.objects[*place].samples.push(raw.number.read(cursor)?);
                }
            }
        } else {
            for (place, raw) in &listed {
                let samples = &mut file.objects[*place].samples;
                samples.reserve(raw.values);
                for _ in 0..raw.values {
                    samples.push(raw.number.read(cursor)?);
                }
            }
        }
    }
    Ok(())
}

/// Splits "/'group'/'channel'" into its parts; quotes within are doubled.
fn parts(path: &str) -> Vec<String> {
    let inner = path.trim_start_matches('/').trim_matches('\'');
    inner.split("'/'").map(|part| part.replace("''", "'")).collect()
}

fn series(file: File, cursor: &Cursor) -> Result<FileSeries, RecordError> {
    let mut objects = file.objects;
    objects.retain(|object| !object.samples.is_empty());
    refuse_channels(FORMAT, objects.len())?;
    let short: Vec<String> = objects
        .iter()
        .map(|object| parts(&object.path).last().cloned().unwrap_or_default())
        .collect();
    let mut found = Vec::new();
    for (object, name) in objects.into_iter().zip(&short) {
        let property = |name: &str| object.properties.get(name);
        if let Some(Value::Number(scales)) = property("NI_Number_Of_Scales")
            && *scales > 0.0
        {
            return Err(unread(
                Unread::ScalingsOfChannel {
                    path: shown(&object.path),
                    scales: scales.to_string(),
                },
                Unread::ExportScaled,
            ));
        }
        let seconds = |name: &str| match property(name) {
            Some(Value::Number(x)) if x.is_finite() => Some(*x),
            _ => None,
        };
        let begins_s = match property("wf_start_time") {
            Some(Value::Time(at)) if *at > 0.0 => Some(at - EPOCH_S),
            _ => None,
        };
        let unit = match property("unit_string") {
            Some(Value::Text(label)) => unit_of_label(label),
            _ => FileUnit::Silent,
        };
        let step = seconds("wf_increment").filter(|step| *step > 0.0);
        let alone = short.iter().filter(|other| *other == name).count() == 1;
        found.push(Series {
            sampling_rate_hz: step.map(|step| rate_of_step(step, 1e-12)),
            unit,
            begins_s,
            offset_s: seconds("wf_start_offset").unwrap_or(0.0),
            ..Series::new(
                if alone {
                    name.clone()
                } else {
                    parts(&object.path).join("/")
                },
                object.samples,
            )
        });
    }
    if found.is_empty() {
        return Err(cursor.damaged(Damage::NoChannelHolds));
    }
    Ok(FileSeries {
        format: RecordFormat::Tdms,
        series: found,
        notes: Vec::new(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    fn segment(flags: u32, description: &[u8], samples: &[u8]) -> Vec<u8> {
        let mut bytes = b"TDSm".to_vec();
        bytes.extend(flags.to_le_bytes());
        bytes.extend(4713u32.to_le_bytes());
        bytes.extend(((description.len() + samples.len()) as u64).to_le_bytes());
        bytes.extend((description.len() as u64).to_le_bytes());
        bytes.extend(description);
        bytes.extend(samples);
        bytes
    }

    /// An object with this many bytes per chunk.
    fn object(path: &str, values: u64) -> Vec<u8> {
        let mut bytes = (path.len() as u32).to_le_bytes().to_vec();
        bytes.extend(path.as_bytes());
        for word in [20u32, 1, 1] {
            bytes.extend(word.to_le_bytes());
        }
        bytes.extend(values.to_le_bytes());
        bytes.extend(0u32.to_le_bytes());
        bytes
    }

    fn described(objects: impl Iterator<Item = Vec<u8>>) -> Vec<u8> {
        let objects: Vec<Vec<u8>> = objects.collect();
        let mut bytes = (objects.len() as u32).to_le_bytes().to_vec();
        bytes.extend(objects.concat());
        bytes
    }

    const ALL_NEW: u32 = NEW_DESCRIPTION | NEW_LIST | RAW_DATA;

    /// Each of a million chunks and segments would visit each of 4000 objects without a value.
    #[test]
    fn exact_samples_beside_thousands_of_objects_without_any() {
        let silent = (0..4000).map(|i| object(&format!("/'g'/'silent {i}'"), 0));
        let description = described(silent.chain([object("/'g'/'a'", 1)]));
        let mut bytes = segment(ALL_NEW, &description, &[5; 700_000]);
        bytes.extend(segment(RAW_DATA, &[], &[7]).repeat(100_000));
        let found = read(&bytes).unwrap();
        assert_eq!(found.series.len(), 1);
        let samples = &found.series[0].samples;
        assert_eq!(
            (samples.len(), samples[699_999], samples[799_999]),
            (800_000, 5.0, 7.0)
        );
    }

    #[test]
    fn refuses_more_objects_and_channels_than_a_recorder_writes() {
        let many = |count: usize| described((0..count).map(|i| object(&format!("{i}"), 1)));
        let said = |count: usize| {
            read(&segment(ALL_NEW, &many(count), &vec![0; count]))
                .unwrap_err()
                .to_string()
        };
        assert_eq!(
            said(70_000),
            "the tdms file holds more than 65536 groups and channels, which no recorder writes: save the channels that are needed alone"
        );
        assert!(said(5000).starts_with("the tdms file holds more than 4096 channels"));
        let path = described([object(&"x".repeat(5000), 1)].into_iter());
        let said = read(&segment(ALL_NEW, &path, &[0])).unwrap_err().to_string();
        assert!(said.contains("a path has 5000 bytes"), "{said}");
    }
}
