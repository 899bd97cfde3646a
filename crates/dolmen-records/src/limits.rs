//! Limits for readers, so that a small file cannot use much memory or time.

use crate::wrong::Unread;
use dolmen_words::message::Both;

/// Largest number of columns of a text, and of channels of any file. Our choice: more than any recorder has.
pub(crate) const CHANNELS_MOST: usize = 4096;
/// Longest line of a text, bytes. Our choice: 4096 columns of 20 digits are 90 kB.
pub(crate) const LINE_BYTES_MOST: usize = 1 << 20;
/// Largest number of variables, groups and channels in a binary file. Our choice: files of recorders have some hundred.
pub(crate) const PARTS_MOST: usize = 65_536;
/// Bytes of numbers allowed for any file, however small; twice that is in memory during reading. Our choice: six hours of six
/// channels at 100 Hz.
const EXPANDED_FREE: u64 = 100 << 20;
/// Largest number of bytes of numbers for each byte of a larger file. Our choice: a quiet 16-bit record, in which three bits change, packs
/// as doubles to a twentieth.
const EXPANSION_MOST: u64 = 20;
/// Number of first bytes that identify a format. Our choice: the longest header examined, 200 lines, has 15 kB.
const HEAD_BYTES: usize = 1 << 16;

/// A limit of a reader was exceeded.
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
    /// A line has too many cells.
    Columns {
        /// The line, from 1.
        line: usize,
        /// Number of its cells.
        found: usize,
        /// The limit.
        most: usize,
    },
    /// A binary file has too many parts.
    Parts {
        /// Its format.
        format: &'static str,
        /// "channels", "variables".
        what: Both,
        /// The limit.
        most: usize,
    },
    /// A small file would need much memory.
    Expands {
        /// Its format.
        format: &'static str,
        /// Bytes of the file.
        packed: usize,
        /// Bytes of its numbers, as stated by the file.
        unpacked: u64,
        /// The limit.
        most: u64,
        /// What to do.
        instead: Both,
    },
}

/// Largest number of bytes of numbers for a file of this size.
pub(crate) fn expanded_most(packed: usize) -> u64 {
    EXPANSION_MOST.saturating_mul(packed as u64).max(EXPANDED_FREE)
}

/// Refuses more channels than any recorder has.
pub(crate) fn refuse_channels(format: &'static str, channels: usize) -> Result<(), LimitError> {
    refuse_parts(format, Unread::Channels, channels, CHANNELS_MOST)
}

/// Refuses a file with more parts than `most`.
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

/// The beginning of a file, enough to identify its format.
pub(crate) fn head(bytes: &[u8]) -> &[u8] {
    &bytes[..bytes.len().min(HEAD_BYTES)]
}

/// Index of the line end of the first line of `rest`; `None` for a last line without one.
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
        assert_eq!(expanded_most(1000), 100 << 20);
        assert_eq!(expanded_most(5_000_000), 100 << 20);
        assert_eq!(expanded_most(100_000_000), 2_000_000_000);
    }
}
