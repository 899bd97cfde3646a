//! How much a file may ask of its reader: a few bytes must not become much memory or time.

use crate::wrong::Unread;
use dolmen_words::message::Both;

/// Most columns of a text and channels of any file. Chosen here: more than any recorder has.
pub(crate) const CHANNELS_MOST: usize = 4096;
/// Most bytes of one line of a text. Chosen here: 4096 columns of 20 digits are 90 kB.
pub(crate) const LINE_BYTES_MOST: usize = 1 << 20;
/// Most variables, groups and channels that a binary file describes. Chosen here: files of recorders describe some hundred.
pub(crate) const PARTS_MOST: usize = 65_536;
/// Most bytes of numbers that come out of one byte of a packed file. Chosen here: vibrations of 16 bits pack to a fiftieth at most,
/// and are held in four times as many bytes.
const EXPANSION_MOST: u64 = 200;
/// Bytes of numbers that come out of any file, however small. Chosen here: a constant channel packs to a thousandth, and does no harm.
const EXPANDED_FREE: u64 = 64 << 20;
/// From so many bytes of numbers on, a file must hold a part of them. Chosen here: an hour of 30 channels at 1 kHz.
const LARGE: u64 = 1 << 30;
/// Most bytes of numbers that come out of one byte of a packed file above that. Chosen here: a quiet record of 16 bits, of which three
/// move, packs as doubles to a twentieth.
const EXPANSION_OF_LARGE_MOST: u64 = 20;
/// So many of its first bytes tell a format. Chosen here: the longest header that is looked through, 200 lines, has 15 kB.
const HEAD_BYTES: usize = 1 << 16;

/// More than a file may ask of its reader.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum LimitError {
    /// A line is too long.
    Line {
        /// The line, from 1.
        line: usize,
        /// Its bytes.
        bytes: usize,
        /// The limit.
        most: usize,
    },
    /// A line holds too many cells.
    Columns {
        /// The line, from 1.
        line: usize,
        /// Its cells.
        found: usize,
        /// The limit.
        most: usize,
    },
    /// A binary file describes too much.
    Parts {
        /// Its format.
        format: &'static str,
        /// "channels", "variables".
        what: Both,
        /// The limit.
        most: usize,
    },
    /// A small file becomes much memory.
    Expands {
        /// Its format.
        format: &'static str,
        /// Bytes of the file.
        packed: usize,
        /// Bytes of its numbers, as the file says.
        unpacked: u64,
        /// The limit.
        most: u64,
        /// What to do.
        instead: Both,
    },
}

/// Most bytes of numbers that may come out of a file of so many bytes.
pub(crate) fn expanded_most(packed: usize) -> u64 {
    let times = |most: u64| most.saturating_mul(packed as u64);
    times(EXPANSION_MOST)
        .min(LARGE)
        .max(times(EXPANSION_OF_LARGE_MOST))
        .max(EXPANDED_FREE)
}

/// Refuses more channels than any recorder has.
pub(crate) fn refuse_channels(format: &'static str, channels: usize) -> Result<(), LimitError> {
    refuse_parts(format, Unread::Channels, channels, CHANNELS_MOST)
}

/// Refuses a file that describes more of something than `most`.
pub(crate) fn refuse_parts(
    format: &'static str,
    what: impl Into<Both>,
    found: usize,
    most: usize,
) -> Result<(), LimitError> {
    match found <= most {
        true => Ok(()),
        false => Err(LimitError::Parts {
            format,
            what: what.into(),
            most,
        }),
    }
}

/// As much of a file as tells its format.
pub(crate) fn head(bytes: &[u8]) -> &[u8] {
    &bytes[..bytes.len().min(HEAD_BYTES)]
}

/// Where the line that `rest` begins with ends, from its begin; its length where it is the last.
///
/// # Errors
/// [`LimitError::Line`].
#[inline]
pub(crate) fn line_end(rest: &[u8], line: usize) -> Result<Option<usize>, LimitError> {
    let looked_at = &rest[..rest.len().min(LINE_BYTES_MOST + 1)];
    match memchr::memchr(b'\n', looked_at) {
        None if rest.len() > LINE_BYTES_MOST => Err(too_long(rest, line)),
        end => Ok(end),
    }
}

#[cold]
fn too_long(rest: &[u8], line: usize) -> LimitError {
    LimitError::Line {
        line,
        bytes: memchr::memchr(b'\n', rest).unwrap_or(rest.len()),
        most: LINE_BYTES_MOST,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_where_a_line_ends() {
        assert_eq!(line_end(b"1,2\n3", 1), Ok(Some(3)));
        assert_eq!(line_end(b"1,2", 1), Ok(None));
        let mut long = vec![b'1'; LINE_BYTES_MOST];
        assert_eq!(line_end(&long, 7), Ok(None));
        long.push(b'\n');
        assert_eq!(line_end(&long, 7), Ok(Some(LINE_BYTES_MOST)));
        long.insert(0, b'1');
        assert_eq!(
            line_end(&long, 7).map_err(|fault| fault.to_string()),
            Err(
                "line 7 has 1048577 bytes, but at most 1048576 are read: write one line a sample, or a face of a mesh; are rows and columns swapped?"
                    .to_owned()
            )
        );
    }

    #[test]
    fn exact_how_much_may_come_out_of_a_file() {
        assert_eq!(expanded_most(1000), 64 << 20);
        assert_eq!(expanded_most(1_000_000), 200_000_000);
        assert_eq!(expanded_most(10_000_000), 1 << 30);
        assert_eq!(expanded_most(100_000_000), 2_000_000_000);
    }
}
