//! Reads GCF files of Güralp recorders: counts stored as differences, in blocks of 1024 bytes.
//!
//! | byte | what |
//! |:--|:--|
//! | 0, 4 | names of system and stream, in base 36 |
//! | 8 | days since 17 November 1989 (15 bits), second of the day (17 bits) |
//! | 13 | samples per second, or a code; 0 marks a text of the recorder |
//! | 14 | numerator of the fraction of a second (4 bits), –, differences per word: 1, 2 or 4 (3 bits) |
//! | 15 | number of words |
//! | 16 | first sample; differences, the first of which is 0; last sample |
//!
//! All numbers are big-endian. The decoded last sample of each block must equal the stated one.
//!
//! Source: Güralp (2021) *GCF reference*, SWA-RFC-GCFR issue F.

use super::cursor::{Cursor, Number};
use super::series::{FileSeries, Series};
use super::{FileUnit, RecordError, RecordFormat};
use crate::breaks::Break;
use crate::limits::refuse_channels;
use crate::wrong::{Damage, Remark};
use std::collections::BTreeMap;

const FORMAT: &str = "gcf";
const BLOCK: usize = 1024;
const HEADER: usize = 16;
/// Largest number of words in a block: 1024 bytes minus the header and the two stated samples.
const WORDS_MOST: usize = (BLOCK - HEADER - 8) / 4;
/// 17 November 1989, in days from 1 January 1970.
const EPOCH_DAY: i64 = 7260;
const DAY_S: i64 = 86_400;
/// Codes of rates that are not whole numbers below 256: code, rate in Hz, denominator of the fraction of a second of
/// a start time.
const CODED: [(u8, f64, u32); 10] = [
    (157, 0.1, 1),
    (161, 0.125, 1),
    (162, 0.2, 1),
    (164, 0.25, 1),
    (167, 0.5, 1),
    (171, 400.0, 8),
    (174, 500.0, 2),
    (176, 1000.0, 4),
    (179, 2000.0, 8),
    (181, 4000.0, 16),
];
/// Difference between the start of a block and the end of the previous one above which there is a gap, in steps.
const GAP_STEPS: f64 = 0.5;

/// Whether the first block is valid. The format has no signature: rate, compression and last sample identify it.
pub(super) fn is_gcf(bytes: &[u8]) -> bool {
    let mut cursor = Cursor::new(bytes, FORMAT).ordered(true);
    let whole = bytes.len() >= BLOCK && bytes.len().is_multiple_of(BLOCK);
    whole
        && Block::read(&mut cursor)
            .is_ok_and(|block| block.rate_hz == 0.0 || block.samples(&mut cursor).is_ok())
}

/// Whether a block can begin at these bytes.
pub(super) fn has_header(bytes: &[u8]) -> bool {
    Block::read(&mut Cursor::new(bytes, FORMAT).ordered(true)).is_ok()
}

/// The header of a block.
struct Block {
    system: u32,
    stream: u32,
    begins_s: f64,
    rate_hz: f64,
    /// Differences per word: 1, 2 or 4.
    packed: usize,
    words: usize,
}

impl Block {
    fn read(cursor: &mut Cursor) -> Result<Self, RecordError> {
        let system = cursor.u32()?;
        let stream = cursor.u32()?;
        let date = cursor.u32()?;
        cursor.u8()?;
        let [code, compression, words] = cursor.array::<3>()?;
        let coded = CODED.iter().find(|(coded, ..)| *coded == code);
        let (rate_hz, parts) = coded.map_or((f64::from(code), 1), |(_, rate, parts)| (*rate, *parts));
        let (day, second) = (i64::from(date >> 17), i64::from(date & 0x1_FFFF));
        let part = u32::from(compression >> 4);
        let packed = usize::from(compression & 7);
        let words = usize::from(words);
        if second > DAY_S || part >= parts || !matches!(packed, 1 | 2 | 4) || words > WORDS_MOST {
            return Err(cursor.damaged(Damage::BlockHeader {
                second: second.to_string(),
                part: part.to_string(),
                parts: parts.to_string(),
                packed: packed.to_string(),
                words: words.to_string(),
            }));
        }
        Ok(Block {
            system,
            stream,
            begins_s: ((EPOCH_DAY + day) * DAY_S + second) as f64 + f64::from(part) / f64::from(parts),
            rate_hz,
            packed,
            words,
        })
    }

    fn samples(&self, cursor: &mut Cursor) -> Result<Vec<f64>, RecordError> {
        let number = match self.packed {
            1 => Number::I32,
            2 => Number::I16,
            _ => Number::I8,
        };
        let mut value = f64::from(cursor.i32()?); // whole numbers: doubles hold them and their sums exactly
        let mut samples = number.series(cursor, self.words * self.packed)?;
        if samples.first().is_some_and(|first| *first != 0.0) {
            return Err(cursor.damaged(Damage::FirstDifference));
        }
        for sample in &mut samples {
            value += *sample;
            *sample = value;
        }
        let last = f64::from(cursor.i32()?);
        if last != value {
            return Err(cursor.damaged(Damage::BlockEnd {
                value: value.to_string(),
                last: last.to_string(),
            }));
        }
        Ok(samples)
    }
}

/// Decodes a name in base 36.
fn letters(mut code: u32) -> String {
    const DIGITS: &[u8; 36] = b"0123456789ABCDEFGHIJKLMNOPQRSTUVWXYZ";
    let mut text = Vec::new();
    while code > 0 {
        text.push(DIGITS[(code % 36) as usize]);
        code /= 36;
    }
    text.reverse();
    String::from_utf8_lossy(&text).into_owned()
}

pub(super) fn read(bytes: &[u8]) -> Result<FileSeries, RecordError> {
    let mut cursor = Cursor::new(bytes, FORMAT).ordered(true);
    let mut streams = Streams::default();
    let mut texts = 0usize;
    while cursor.left() > 0 {
        let at = cursor.at();
        let block = Block::read(&mut cursor)?;
        if block.rate_hz == 0.0 {
            texts += 1;
        } else {
            let samples = block.samples(&mut cursor)?;
            streams.join(&block, samples)?;
        }
        cursor.go(at + BLOCK)?;
    }
    if streams.series.is_empty() {
        return Err(cursor.damaged(Damage::NoBlockHolds));
    }
    let note = (texts > 0).then(|| Remark::TextBlocks(texts).into());
    Ok(FileSeries {
        format: RecordFormat::Gcf,
        series: streams.series,
        notes: note.into_iter().collect(),
    })
}

/// The streams of a file in the order of their first blocks.
#[derive(Default)]
struct Streams {
    series: Vec<Series>,
    /// Index of the stream with this system and name.
    places: BTreeMap<(u32, u32), usize>,
}

impl Streams {
    /// Appends a block to its stream; records a gap, and refuses an overlap.
    fn join(&mut self, block: &Block, samples: Vec<f64>) -> Result<(), RecordError> {
        let place = *self
            .places
            .entry((block.system, block.stream))
            .or_insert(self.series.len());
        let Some(known) = self.series.get_mut(place) else {
            refuse_channels(FORMAT, place + 1)?;
            self.series.push(Series {
                sampling_rate_hz: Some(block.rate_hz),
                unit: FileUnit::Other("counts".to_owned()),
                begins_s: Some(block.begins_s),
                ..Series::new(letters(block.stream), samples)
            });
            return Ok(());
        };
        let expected_s = known.end_s();
        let found_s = block.begins_s - known.begins_s.unwrap_or(block.begins_s);
        let most_s = GAP_STEPS / block.rate_hz;
        if found_s < expected_s - most_s || known.sampling_rate_hz != Some(block.rate_hz) {
            return Err(RecordError::Gap {
                channel: known.name.clone(),
                expected_s,
                found_s,
            });
        }
        if found_s > expected_s + most_s {
            known.breaks.push(Break {
                at: known.samples.len(),
                begins_s: found_s,
            });
        }
        known.samples.extend(samples);
        Ok(())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn refuses_more_streams_than_a_recorder_has() {
        let block = |stream: u32| {
            let mut block = vec![0; BLOCK];
            block[4..8].copy_from_slice(&stream.to_be_bytes());
            block[13..16].copy_from_slice(&[100, 1, 1]);
            block
        };
        let bytes: Vec<u8> = (0..5000).flat_map(block).collect();
        assert!(
            read(&bytes)
                .unwrap_err()
                .to_string()
                .starts_with("the gcf file holds more than 4096 channels")
        );
    }
}
