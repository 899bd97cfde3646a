//! TDMS, the file format of LabVIEW: segments of objects with properties, and their samples.
//!
//! | part | what |
//! |:--|:--|
//! | lead-in, 28 bytes | `TDSm`, flags, version, length of the segment and of its description |
//! | description | objects: path, where its samples lie (type, values a chunk), properties |
//! | raw data | chunks; in each the values of every object after those of the one before, or interleaved |
//!
//! Of the properties are read: `wf_increment` (s), `wf_start_time`, `wf_start_offset`, `unit_string`, `NI_ChannelName`.
//!
//! Source: National Instruments (2023) *TDMS File Format Internal Structure*.

use super::cursor::{Cursor, Number};
use super::series::{Found, Series, rate_of_step};
use super::unit::unit_of_label;
use super::{FileUnit, RecordError, RecordFormat};
use std::collections::BTreeMap;

const FORMAT: &str = "tdms";
const LEAD_IN: usize = 28;
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

fn unread(what: impl Into<String>, instead: &'static str) -> RecordError {
    RecordError::NotReadHere {
        format: FORMAT,
        what: what.into(),
        instead,
    }
}

/// The number that a type code names.
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

/// What a property holds.
#[derive(Clone, Debug, PartialEq)]
enum Value {
    Number(f64),
    Text(String),
    /// s from 1904.
    Time(f64),
}

/// Where the samples of an object lie in a chunk.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Raw {
    number: Number,
    values: usize,
}

#[derive(Default)]
struct Object {
    properties: BTreeMap<String, Value>,
    raw: Option<Raw>,
    samples: Vec<f64>,
}

#[derive(Default)]
struct File {
    paths: Vec<String>,
    objects: BTreeMap<String, Object>,
    /// Objects with samples in the segment at hand, in order.
    listed: Vec<String>,
}

pub(super) fn read(bytes: &[u8]) -> Result<Found, RecordError> {
    if bytes.starts_with(b"TDSh") {
        return Err(unread(
            "only the index of a file (.tdms_index)",
            "name the .tdms file beside it",
        ));
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
        return Err(start.damaged("no segment begins here"));
    }
    let flags = cursor.u32()?;
    let mut cursor = cursor.ordered(flags & BIG_ENDIAN != 0);
    cursor.u32()?; // version
    let (length, description) = (cursor.u64()?, cursor.u64()?);
    if length == OPEN {
        return Err(cursor.damaged("the segment was never closed: the recorder stopped while it wrote"));
    }
    if flags & DAQMX != 0 {
        return Err(unread(
            "raw data of DAQmx with its scaling",
            "export scaled values from LabVIEW",
        ));
    }
    let begin = start.at() + LEAD_IN;
    let place = |after: u64| {
        usize::try_from(after)
            .ok()
            .and_then(|after| begin.checked_add(after))
    };
    let (Some(end), Some(data)) = (place(length), place(description)) else {
        return Err(start.damaged("the length of the segment is none"));
    };
    if data > end {
        return Err(start.damaged("the description of the segment is longer than the segment"));
    }
    cursor.go(end)?;
    let next = cursor;
    cursor.go(begin)?;
    if flags & NEW_DESCRIPTION != 0 {
        if flags & NEW_LIST != 0 {
            file.listed.clear();
        }
        objects(&mut cursor, file)?;
    }
    if cursor.at() > data && flags & RAW_DATA != 0 {
        return Err(start.damaged("the description of the segment runs into its samples"));
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
        if !file.objects.contains_key(&path) {
            file.paths.push(path.clone());
        }
        let object = file.objects.entry(path.clone()).or_default();
        let has_samples = match cursor.u32()? {
            0xFFFF_FFFF => false,
            0 => {
                // as in the segment before
                if object.raw.is_none() {
                    return Err(cursor.damaged("samples lie as in the segment before, but there are none"));
                }
                true
            }
            0x1269 | 0x1369 => {
                return Err(unread(
                    "raw data of DAQmx with its scaling",
                    "export scaled values from LabVIEW",
                ));
            }
            length => {
                object.raw = Some(raw(cursor, length, &path)?);
                true
            }
        };
        let at = file.listed.iter().position(|listed| *listed == path);
        match (has_samples, at) {
            (true, None) => file.listed.push(path),
            (false, Some(at)) => drop(file.listed.remove(at)),
            _ => {}
        }
        for _ in 0..cursor.u32()? {
            let name = text(cursor)?;
            let value = value(cursor)?;
            if let Some(value) = value {
                object.properties.insert(name, value);
            }
        }
    }
    Ok(())
}

fn raw(cursor: &mut Cursor, length: u32, path: &str) -> Result<Raw, RecordError> {
    let code = cursor.u32()?;
    let Some(number) = number(code) else {
        return Err(unread(
            format!("samples of type {code:#x} in {path}"),
            "write integers or floats of up to 64 bits",
        ));
    };
    let dimension = cursor.u32()?;
    let values = usize::try_from(cursor.u64()?).ok();
    let (20, 1, Some(values)) = (length, dimension, values) else {
        return Err(cursor.damaged(format!(
            "the samples of {path} are not described as numbers of one dimension"
        )));
    };
    Ok(Raw { number, values })
}

/// A property; `None` for types that say nothing here.
fn value(cursor: &mut Cursor) -> Result<Option<Value>, RecordError> {
    let code = cursor.u32()?;
    if let Some(number) = number(code) {
        return number.read(cursor).map(|x| Some(Value::Number(x)));
    }
    match code {
        TEXT => Ok(Some(Value::Text(text(cursor)?))),
        TIME => {
            // in the other byte order seconds stand first
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
        code => Err(cursor.damaged(format!("a property has type {code:#x}, which is none"))),
    }
}

/// The chunks of a segment: as many as fill it.
fn samples(cursor: &mut Cursor, file: &mut File, bytes: usize, interleaved: bool) -> Result<(), RecordError> {
    let listed: Vec<(String, Raw)> = file
        .listed
        .iter()
        .filter_map(|path| Some((path.clone(), file.objects.get(path)?.raw?)))
        .collect();
    let sizes = listed
        .iter()
        .map(|(_, raw)| raw.values.checked_mul(raw.number.bytes()));
    let chunk = sizes
        .into_iter()
        .try_fold(0usize, |sum, size| sum.checked_add(size?));
    let chunk = chunk
        .filter(|chunk| *chunk > 0 && bytes.is_multiple_of(*chunk))
        .ok_or_else(|| {
            cursor.damaged(format!(
                "{bytes} bytes of samples are no whole chunks of the objects described: was it cut short?"
            ))
        })?;
    for _ in 0..bytes / chunk {
        if interleaved {
            let values = listed.first().map_or(0, |(_, raw)| raw.values);
            if listed.iter().any(|(_, raw)| raw.values != values) {
                return Err(cursor.damaged("interleaved objects differ in their number of samples"));
            }
            for _ in 0..values {
                for (path, raw) in &listed {
                    let value = raw.number.read(cursor)?;
                    if let Some(object) = file.objects.get_mut(path) {
                        object.samples.push(value);
                    }
                }
            }
        } else {
            for (path, raw) in &listed {
                let values = raw.number.series(cursor, raw.values)?;
                if let Some(object) = file.objects.get_mut(path) {
                    object.samples.extend(values);
                }
            }
        }
    }
    Ok(())
}

/// "/'group'/'channel'" in its parts; a quote within is doubled.
fn parts(path: &str) -> Vec<String> {
    let inner = path.trim_start_matches('/').trim_matches('\'');
    inner.split("'/'").map(|part| part.replace("''", "'")).collect()
}

fn series(file: File, cursor: &Cursor) -> Result<Found, RecordError> {
    let with_samples = |path: &&String| {
        file.objects
            .get(*path)
            .is_some_and(|object| !object.samples.is_empty())
    };
    let paths: Vec<&String> = file.paths.iter().filter(with_samples).collect();
    let short: Vec<String> = paths
        .iter()
        .map(|path| parts(path).last().cloned().unwrap_or_default())
        .collect();
    let mut found = Vec::new();
    for (path, name) in paths.iter().zip(&short) {
        let Some(object) = file.objects.get(*path) else {
            continue;
        };
        let property = |name: &str| object.properties.get(name);
        if let Some(Value::Number(scales)) = property("NI_Number_Of_Scales")
            && *scales > 0.0
        {
            return Err(unread(
                format!("channel {path} with {scales} scalings of its own"),
                "export scaled values from LabVIEW",
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
                    parts(path).join("/")
                },
                object.samples.clone(),
            )
        });
    }
    if found.is_empty() {
        return Err(cursor.damaged("no channel holds samples"));
    }
    Ok(Found {
        format: RecordFormat::Tdms,
        series: found,
        notes: Vec::new(),
    })
}
