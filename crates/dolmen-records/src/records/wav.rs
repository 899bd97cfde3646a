//! WAV: channels of a sound recorder, as fractions of full scale.
//!
//! | chunk | what |
//! |:--|:--|
//! | `RIFF` | length of the file − 8, `WAVE` |
//! | `fmt ` | 1 = integers, 3 = floats, 0xFFFE = told by the first two bytes of the sub-format; channels, rate, –, bytes a frame, bits |
//! | `data` | frames; within each, one sample per channel |
//!
//! Source: Microsoft and IBM (1991) *Multimedia Programming Interface and Data Specifications 1.0*, with the later
//! WAVEFORMATEXTENSIBLE.

use super::cursor::{Cursor, Number};
use super::series::{FileSeries, Series};
use super::{FileUnit, RecordError, RecordFormat, RecordOptions};
use crate::limits::refuse_channels;
use crate::wrong::{Damage, Unread};

const FORMAT: &str = "wav";
const INTEGERS: u16 = 1;
const FLOATS: u16 = 3;
const EXTENSIBLE: u16 = 0xFFFE;

pub(super) fn is_wav(bytes: &[u8]) -> bool {
    let sort = bytes.get(..4);
    (sort == Some(b"RIFF") || sort == Some(b"RF64") || sort == Some(b"RIFX"))
        && bytes.get(8..12) == Some(b"WAVE")
}

/// Content of the chunk `fmt `.
struct Frames {
    number: Number,
    channels: usize,
    rate_hz: f64,
    /// Reciprocal of full scale.
    unit: f64,
}

pub(super) fn read(bytes: &[u8], options: &RecordOptions) -> Result<FileSeries, RecordError> {
    let unread = |what: Unread, instead: Unread| RecordError::NotReadHere {
        format: FORMAT,
        what: what.into(),
        instead: instead.into(),
    };
    if !bytes.starts_with(b"RIFF") {
        return Err(unread(Unread::Riff, Unread::PlainWav));
    }
    let mut cursor = Cursor::new(bytes, FORMAT);
    cursor.take(4)?;
    let stated = cursor.u32()? as usize;
    if stated.saturating_add(8) > bytes.len() {
        return Err(RecordError::CutShort {
            format: FORMAT,
            bytes: bytes.len(),
            wanted: stated as u64 + 8,
        });
    }
    cursor.take(4)?;
    let mut told = None;
    let mut data = None;
    while cursor.left() >= 8 && data.is_none() {
        let name = cursor.array::<4>()?;
        let length = cursor.u32()? as usize;
        match &name {
            b"fmt " => told = Some(frames(&mut Cursor::new(cursor.take(length)?, FORMAT))?),
            b"data" => data = Some(cursor.take(length)?),
            _ => drop(cursor.take(length)?),
        }
        if length % 2 == 1 && cursor.left() > 0 {
            cursor.take(1)?;
        }
    }
    let (Some(told), Some(data)) = (told, data) else {
        return Err(cursor.damaged(Damage::NoChunks));
    };
    let frame = told.number.bytes() * told.channels;
    if !data.len().is_multiple_of(frame) {
        return Err(cursor.damaged(Damage::NoWholeFrames {
            bytes: data.len(),
            frame,
        }));
    }
    let scaled = options.scale.is_some()
        || (!options.picks.is_empty() && options.picks.iter().all(|pick| pick.scale.is_some()));
    if !scaled {
        return Err(RecordError::NoFullScale);
    }
    refuse_channels(FORMAT, told.channels)?;
    let mut samples: Vec<Vec<f64>> = (0..told.channels)
        .map(|_| Vec::with_capacity(data.len() / frame))
        .collect();
    let mut cursor = Cursor::new(data, FORMAT);
    for _ in 0..data.len() / frame {
        for channel in &mut samples {
            channel.push(told.unit * told.number.read(&mut cursor)?);
        }
    }
    let series = samples.into_iter().enumerate().map(|(j, samples)| Series {
        sampling_rate_hz: Some(told.rate_hz),
        unit: FileUnit::Other("full scale".to_owned()),
        ..Series::new(format!("ch{}", j + 1), samples)
    });
    Ok(FileSeries {
        format: RecordFormat::Wav,
        series: series.collect(),
        notes: Vec::new(),
    })
}

fn frames(cursor: &mut Cursor) -> Result<Frames, RecordError> {
    let mut sort = cursor.u16()?;
    let channels = usize::from(cursor.u16()?);
    let rate_hz = f64::from(cursor.u32()?);
    cursor.u32()?; // bytes per second
    let frame = usize::from(cursor.u16()?);
    let bits = cursor.u16()?;
    if sort == EXTENSIBLE {
        cursor.take(8)?; // length of the rest, valid bits, loudspeaker positions
        sort = cursor.u16()?;
    }
    let (number, unit) = match (sort, bits) {
        (INTEGERS, 16) => (Number::I16, 1.0 / 32_768.0),
        (INTEGERS, 24) => (Number::I24, 1.0 / 8_388_608.0),
        (INTEGERS, 32) => (Number::I32, 1.0 / 2_147_483_648.0),
        (FLOATS, 32) => (Number::F32, 1.0),
        (FLOATS, 64) => (Number::F64, 1.0),
        (sort, bits) => {
            return Err(RecordError::NotReadHere {
                format: FORMAT,
                what: Unread::CodedSamples {
                    bits: bits.to_string(),
                    sort: sort.to_string(),
                }
                .into(),
                instead: Unread::WavNumbers.into(),
            });
        }
    };
    if channels == 0 || frame != channels * number.bytes() || rate_hz <= 0.0 {
        return Err(cursor.damaged(Damage::FramesDisagree {
            channels,
            rate_hz,
            frame,
        }));
    }
    Ok(Frames {
        number,
        channels,
        rate_hz,
        unit,
    })
}
