//! Steim 1 and 2: first differences of integers, packed into frames of 64 bytes.
//!
//! Word 0 of a frame contains a 2-bit code for each of its 16 words; words 1 and 2 of the first frame are the first and the
//! last sample, which verify the result.
//!
//! Source: FDSN (2012) *SEED Reference Manual*, version 2.4, appendix B.

use super::SeismicError;
use crate::wrong::OfStation;

/// Version of the encoding.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Steim {
    One,
    Two,
}

const FRAME_BYTES: usize = 64;
const WORDS: usize = 16;

/// The samples of a record from its frames.
pub(super) fn unpacked(
    data: &[u8],
    samples: usize,
    steim: Steim,
    little: bool,
    at: u64,
) -> Result<Vec<f64>, SeismicError> {
    let refuse = |what: OfStation| SeismicError::Damaged {
        at,
        what: what.into(),
    };
    let mut differences: Vec<i64> = Vec::with_capacity(samples.min(data.len()));
    let (mut first, mut last) = (0, 0);
    for (number, frame) in data.chunks_exact(FRAME_BYTES).enumerate() {
        let word = |i: usize| {
            let bytes = [frame[4 * i], frame[4 * i + 1], frame[4 * i + 2], frame[4 * i + 3]];
            if little {
                u32::from_le_bytes(bytes)
            } else {
                u32::from_be_bytes(bytes)
            }
        };
        let codes = word(0);
        let begin = if number == 0 {
            (first, last) = (i64::from(word(1) as i32), i64::from(word(2) as i32));
            3
        } else {
            1
        };
        for i in begin..WORDS {
            if differences.len() >= samples {
                break;
            }
            let code = codes >> (2 * (WORDS - 1 - i)) & 3;
            let bytes = &frame[4 * i..4 * i + 4];
            let packed = word(i);
            match (code, steim, packed >> 30) {
                (0, ..) => {}
                (1, ..) => differences.extend(bytes.iter().map(|b| i64::from(*b as i8))),
                (2, Steim::One, _) => differences.extend(bytes.chunks_exact(2).map(|pair| {
                    let pair = [pair[0], pair[1]];
                    i64::from(if little {
                        i16::from_le_bytes(pair)
                    } else {
                        i16::from_be_bytes(pair)
                    })
                })),
                (3, Steim::One, _) => differences.push(i64::from(packed as i32)),
                (2, Steim::Two, 1) => split(packed, 1, 30, &mut differences),
                (2, Steim::Two, 2) => split(packed, 2, 15, &mut differences),
                (2, Steim::Two, 3) => split(packed, 3, 10, &mut differences),
                (3, Steim::Two, 0) => split(packed, 5, 6, &mut differences),
                (3, Steim::Two, 1) => split(packed, 6, 5, &mut differences),
                (3, Steim::Two, 2) => split(packed, 7, 4, &mut differences),
                _ => {
                    return Err(refuse(OfStation::SteimCode));
                }
            }
        }
        if differences.len() >= samples {
            break;
        }
    }
    if differences.len() < samples {
        return Err(refuse(OfStation::SteimFewer));
    }
    let mut value = first;
    let mut values = Vec::with_capacity(samples);
    for (i, difference) in differences.iter().take(samples).enumerate() {
        if i > 0 {
            value += difference;
        }
        values.push(value as f64);
    }
    if value != last {
        return Err(refuse(OfStation::SteimLast));
    }
    Ok(values)
}

/// `count` signed numbers of `bits` bits, from the highest of the bits below the 2-bit code.
fn split(packed: u32, count: u32, bits: u32, differences: &mut Vec<i64>) {
    for k in (0..count).rev() {
        let raw = packed >> (k * bits) << (32 - bits);
        differences.push(i64::from(raw as i32 >> (32 - bits)));
    }
}
