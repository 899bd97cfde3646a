//! NPY, the file format of one NumPy array.
//!
//! Layout: `\x93NUMPY`, version (2 bytes), length of the header (2 bytes; 4 from version 2 on), header (a Python literal:
//! `{'descr': '<f8', 'fortran_order': False, 'shape': (540000, 6), }`), values.
//! Source: numpy documentation, `numpy.lib.format`, versions 1.0 to 3.0.

use super::{Axis, Column, Layout, NpyLayout, Reading, RecordError, RecordOptions};
use crate::quoted::shown;
use dolmen::signal::{Channel, Processing, Record, SignalError};

/// First bytes of each NPY file.
pub(super) const MAGIC: &[u8] = b"\x93NUMPY";
/// Longest header, bytes. Our choice: NumPy itself refuses more than 10 000 bytes by default.
const HEADER_BYTES_MOST: usize = 1 << 16;
/// Number of rows transposed to channel order at a time: 512 rows of 32 doubles fit a second-level cache.
const ROWS_AT_ONCE: usize = 512;

/// A record from the bytes of an NPY file: an array with one axis (one channel) or two axes, of which the longer is time.
///
/// Values may be `f4`, `f8`, `i2`, `i4`, `i8`, of either byte order, in C or Fortran order.
///
/// # Errors
/// [`RecordError`]: a file that is not NPY, is cut short or too long; another type or shape; no sampling rate; a sample that is not
/// finite.
///
/// # Example
/// ```
/// use dolmen_records::records::{RecordOptions, read_npy};
/// let mut bytes = b"\x93NUMPY\x01\x00\x3b\x00{'descr': '<f4', 'fortran_order': False, 'shape': (3, 2)} \n".to_vec();
/// for value in [1f32, 10.0, 2.0, 20.0, 3.0, 30.0] {
///     bytes.extend(value.to_le_bytes());
/// }
/// let options = RecordOptions { sampling_rate_hz: Some(100.0), ..Default::default() };
/// assert_eq!(read_npy(&bytes, &options)?.record.samples(1), [10.0, 20.0, 30.0]);
/// # Ok::<(), dolmen_records::records::RecordError>(())
/// ```
pub fn read_npy(bytes: &[u8], options: &RecordOptions) -> Result<Reading, RecordError> {
    let head = Head::parse(bytes)?;
    let kind = Kind::parse(&head.descr)?;
    let (rows, columns) = match head.shape[..] {
        [n] => (n, 1),
        [n, m] => (n, m),
        _ => return Err(RecordError::NpyShape { shape: head.shape }),
    };
    let values = &bytes[head.values_at..];
    let needed = rows.checked_mul(columns).and_then(|n| n.checked_mul(kind.size));
    match needed {
        Some(needed) if needed == values.len() => {}
        Some(needed) if needed < values.len() => {
            return Err(RecordError::NpyTrailing {
                shape: head.shape,
                extra: values.len() - needed,
            });
        }
        _ => {
            return Err(RecordError::NpyTruncated {
                shape: head.shape,
                held: values.len() / kind.size,
            });
        }
    }
    let time_axis = if rows >= columns {
        Axis::First
    } else {
        Axis::Second
    };
    let (length, count) = match time_axis {
        Axis::First => (rows, columns),
        Axis::Second => (columns, rows),
    };
    if length < 2 || count == 0 {
        return Err(RecordError::Signal(SignalError::Empty {
            channels: count,
            samples: length,
        }));
    }
    let rate = options.sampling_rate_hz.ok_or(RecordError::NoRateNpy)?;
    let (sources, mut channels) = pick(options, count)?;
    for channel in &mut channels {
        channel.quantity = options.unit.quantity();
    }

    // distance, in values, between neighbours in time and between neighbouring channels
    let time_runs_fastest = (time_axis == Axis::Second) != head.fortran;
    let (along, across) = if time_runs_fastest {
        (1, length)
    } else {
        (count, 1)
    };
    let mut samples = vec![0.0; sources.len() * length];
    let factor = options.unit.si();
    for from in (0..length).step_by(ROWS_AT_ONCE) {
        let to = (from + ROWS_AT_ONCE).min(length);
        for (series, source) in samples.chunks_exact_mut(length).zip(&sources) {
            for (i, sample) in series[from..to].iter_mut().enumerate() {
                let at = ((from + i) * along + source * across) * kind.size;
                *sample = factor * kind.value(&values[at..at + kind.size]);
            }
        }
    }
    let mut record = Record::from_contiguous(channels, samples, rate)?;
    record.note(Processing::Read {
        format: "npy".into(),
        unit: options.unit.symbol().into(),
    });
    Ok(Reading {
        record,
        begins_s: None,
        layout: Layout::Npy(NpyLayout {
            value_type: head.descr,
            shape: head.shape,
            time_axis,
        }),
    })
}

/// The channels of the array to read (from 0), and their properties.
fn pick(options: &RecordOptions, count: usize) -> Result<(Vec<usize>, Vec<Channel>), RecordError> {
    if options.picks.is_empty() {
        let channels = (1..=count).map(|n| Channel::named(format!("ch{n}")));
        return Ok(((0..count).collect(), channels.collect()));
    }
    let mut sources = Vec::with_capacity(options.picks.len());
    for pick in &options.picks {
        match &pick.column {
            Column::Number(n) if (1..=count).contains(n) => {
                if let Some(first) = sources.iter().position(|source| source + 1 == *n) {
                    return Err(RecordError::PickedTwice {
                        column: n.to_string(),
                        first: options.picks[first].channel.name.clone(),
                        second: pick.channel.name.clone(),
                    });
                }
                sources.push(n - 1);
            }
            Column::Number(n) => {
                return Err(RecordError::ColumnNumber {
                    given: *n,
                    columns: count,
                });
            }
            Column::Named(name) => {
                return Err(RecordError::NpyNamed {
                    given: name.clone(),
                    columns: count,
                });
            }
        }
    }
    Ok((sources, options.picks.iter().map(|p| p.channel.clone()).collect()))
}

/// Type of the values.
#[derive(Clone, Copy)]
struct Kind {
    size: usize,
    float: bool,
    big_endian: bool,
}

impl Kind {
    fn parse(descr: &str) -> Result<Self, RecordError> {
        let refused = || RecordError::NpyType {
            given: descr.to_string(),
        };
        let mut letters = descr.chars();
        let big_endian = match letters.next() {
            Some('<' | '=') => false,
            Some('>') => true,
            _ => return Err(refused()),
        };
        let (float, size) = match letters.as_str() {
            "f4" => (true, 4),
            "f8" => (true, 8),
            "i2" => (false, 2),
            "i4" => (false, 4),
            "i8" => (false, 8),
            _ => return Err(refused()),
        };
        Ok(Kind {
            size,
            float,
            big_endian,
        })
    }

    /// One value from its bytes.
    fn value(self, bytes: &[u8]) -> f64 {
        match *bytes {
            [a, b] => f64::from(self.ordered([a, b], i16::from_le_bytes, i16::from_be_bytes)),
            [a, b, c, d] => {
                let word = self.ordered([a, b, c, d], u32::from_le_bytes, u32::from_be_bytes);
                if self.float {
                    f64::from(f32::from_bits(word))
                } else {
                    f64::from(word.cast_signed())
                }
            }
            [a, b, c, d, e, f, g, h] => {
                let word = self.ordered([a, b, c, d, e, f, g, h], u64::from_le_bytes, u64::from_be_bytes);
                if self.float {
                    f64::from_bits(word)
                } else {
                    word.cast_signed() as f64
                }
            }
            _ => f64::NAN, // `parse` gives no other size
        }
    }

    fn ordered<const N: usize, T>(
        self,
        bytes: [u8; N],
        little: fn([u8; N]) -> T,
        big: fn([u8; N]) -> T,
    ) -> T {
        if self.big_endian {
            big(bytes)
        } else {
            little(bytes)
        }
    }
}

/// Header of an NPY file.
struct Head {
    descr: String,
    fortran: bool,
    shape: Vec<usize>,
    values_at: usize,
}

impl Head {
    fn parse(bytes: &[u8]) -> Result<Self, RecordError> {
        if !bytes.starts_with(MAGIC) {
            return Err(RecordError::NotNpy);
        }
        let cut = RecordError::NpyHeaderTruncated { bytes: bytes.len() };
        let rest = &bytes[MAGIC.len()..];
        let (length, prefix) = match *rest {
            [1, _, a, b, ..] => (usize::from(u16::from_le_bytes([a, b])), 4),
            [2 | 3, _, a, b, c, d, ..] => (u32::from_le_bytes([a, b, c, d]) as usize, 6),
            [major, ..] if major > 3 => return Err(RecordError::NpyVersion { major }),
            [0, ..] => return Err(RecordError::NpyVersion { major: 0 }),
            _ => return Err(cut),
        };
        let text = rest.get(prefix..length.saturating_add(prefix)).ok_or(cut)?;
        if text.len() > HEADER_BYTES_MOST {
            return Err(RecordError::NpyHeader {
                text: format!("({length} bytes)"),
            });
        }
        let text = String::from_utf8_lossy(text);
        let unclear = || RecordError::NpyHeader {
            text: shown(text.trim_end()),
        };
        let after = |key: &str| {
            let at = text
                .find(&format!("'{key}'"))
                .or_else(|| text.find(&format!("\"{key}\"")))?;
            Some(
                text[at + key.len() + 2..]
                    .trim_start()
                    .strip_prefix(':')?
                    .trim_start(),
            )
        };
        let descr = after("descr").ok_or_else(unclear)?;
        let descr = match descr.chars().next() {
            Some(quote @ ('\'' | '"')) => descr[1..].split(quote).next().unwrap_or_default().to_string(),
            // a structured type: a list of fields
            _ => descr.split(']').next().unwrap_or_default().to_string() + "]",
        };
        let fortran = after("fortran_order").ok_or_else(unclear)?;
        let fortran = match (fortran.starts_with("True"), fortran.starts_with("False")) {
            (true, _) => true,
            (_, true) => false,
            _ => return Err(unclear()),
        };
        let shape = after("shape")
            .and_then(|s| s.strip_prefix('('))
            .and_then(|s| s.split_once(')'));
        let shape = shape
            .ok_or_else(unclear)?
            .0
            .split(',')
            .map(str::trim)
            .filter(|n| !n.is_empty())
            .map(|n| n.parse().map_err(|_| unclear()))
            .collect::<Result<Vec<usize>, _>>()?;
        Ok(Head {
            descr,
            fortran,
            shape,
            values_at: MAGIC.len() + prefix + length,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::records::Pick;

    fn file(shape: &str, values: usize) -> Vec<u8> {
        let header = format!("{{'descr': '<f4', 'fortran_order': False, 'shape': ({shape})}}");
        let mut bytes = [MAGIC, b"\x02\x00", &(header.len() as u32).to_le_bytes()].concat();
        bytes.extend(header.as_bytes());
        bytes.resize(bytes.len() + 4 * values, 1);
        bytes
    }

    #[test]
    fn refuses_a_header_of_megabytes_and_lists_no_endless_shape() {
        let said = |bytes: &[u8]| {
            read_npy(bytes, &RecordOptions::default())
                .unwrap_err()
                .to_string()
        };
        let long = said(&file(&"1,".repeat(1_000_000), 1));
        assert_eq!(
            long,
            "the header of the NPY file cannot be understood: \"(2000053 bytes)\"; save it again with numpy.save"
        );
        let axes = said(&file(&"1,".repeat(30), 1));
        assert!(
            axes.contains("has shape [1, 1, ") && axes.contains(" and 10 more], but"),
            "{axes}"
        );
    }

    #[test]
    fn refuses_a_column_read_twice() {
        let pick = |name: &str| Pick {
            column: Column::Number(2),
            channel: Channel::named(name),
            scale: None,
        };
        let options = RecordOptions {
            sampling_rate_hz: Some(100.0),
            picks: vec![pick("x"), pick("y")],
            ..Default::default()
        };
        assert_eq!(
            read_npy(&file("3, 2", 6), &options).unwrap_err().to_string(),
            "column \"2\" is read twice, as \"x\" and as \"y\": give each channel its own column"
        );
    }
}
