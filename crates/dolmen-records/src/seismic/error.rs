//! Errors of reading a file of a seismic station.

use crate::limits::LimitError;
use dolmen_words::message::Both;

/// Why Dolmen cannot read the bytes of a file as channels of a seismic station. Each variant gives the place in the file and what to do. Lines
/// count from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum SeismicError {
    /// The header of an AT2 file lacks the number of samples or the time step.
    At2Header {
        /// The line.
        line: usize,
        /// The first 80 characters of the content found there.
        text: String,
    },
    /// The file contains velocities or displacements.
    Quantity {
        /// The line; 0 in a file without lines.
        line: usize,
        /// "velocities", "displacements".
        what: Both,
    },
    /// The unit in a header is unknown.
    At2Unit {
        /// The line.
        line: usize,
        /// The content found there.
        text: String,
    },
    /// A value is not a number.
    NotANumber {
        /// The line.
        line: usize,
        /// The first 80 characters of the content found there.
        text: String,
    },
    /// The number of samples differs from that of the header.
    Count {
        /// Number of samples in the header.
        stated: u64,
        /// Number of samples in the file.
        found: usize,
    },
    /// A line differs from what the format requires at its place.
    Line {
        /// The line.
        line: usize,
        /// The first 80 characters of the content found there.
        text: String,
        /// The required content.
        wanted: Both,
    },
    /// The text ends within its header or between its parts.
    EndsEarly {
        /// The missing line.
        line: usize,
        /// The required content.
        wanted: Both,
    },
    /// A header lacks a value.
    Missing {
        /// The missing value.
        label: &'static str,
        /// Number of lines searched.
        lines: usize,
    },
    /// The length of the file is not that of its headers.
    Bytes {
        /// The format.
        format: &'static str,
        /// Length by the headers, bytes.
        stated: u64,
        /// Length of the file, bytes.
        found: usize,
    },
    /// A field in the header of a SAC file does not belong to a motion.
    Sac {
        /// The field, and its required value.
        what: Both,
        /// Its value.
        found: f64,
    },
    /// A record of a miniSEED file is damaged.
    Damaged {
        /// Position of the record, bytes from 0.
        at: u64,
        /// The fault.
        what: Both,
    },
    /// The samples of a miniSEED record have an encoding that Dolmen does not read.
    Encoding {
        /// Position of the record, bytes from 0.
        at: u64,
        /// The code.
        encoding: u8,
    },
    /// Records of a channel do not follow one another.
    Gap {
        /// The channel.
        channel: String,
        /// Expected start, s.
        expected_s: f64,
        /// Actual start, s.
        found_s: f64,
    },
    /// The file exceeds a limit of the reader.
    Limit(LimitError),
    /// Raw counts of a recorder that the file does not convert.
    Counts {
        /// The line.
        line: usize,
    },
}
