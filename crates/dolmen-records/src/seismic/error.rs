//! Why a file of a seismic station cannot be read.

use crate::limits::LimitError;
use dolmen_words::message::Both;

/// Why the bytes of a file are no channels of a seismic station. Each variant says where in the file and what to do. Lines are
/// counted from 1.
#[derive(Clone, Debug, PartialEq)]
pub enum SeismicError {
    /// The header of an AT2 file does not say how many samples and how far apart.
    At2Header {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// A file of velocities or displacements.
    Quantity {
        /// The line; 0 in a file without lines.
        line: usize,
        /// "velocities", "displacements".
        what: Both,
    },
    /// A unit that a header names is not known.
    At2Unit {
        /// The line.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A value is no number.
    NotANumber {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// Not as many samples as the header says.
    Count {
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// A line is not what the format has there.
    Line {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
        /// What must stand there.
        wanted: Both,
    },
    /// The text ends within its header or between its parts.
    EndsEarly {
        /// The line that is missing.
        line: usize,
        /// What it must be.
        wanted: Both,
    },
    /// A header does not say something.
    Missing {
        /// What is missing.
        label: &'static str,
        /// Lines that were looked through.
        lines: usize,
    },
    /// The file is not as long as its headers say.
    Bytes {
        /// The format.
        format: &'static str,
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// The header of a SAC file says something that is no motion.
    Sac {
        /// The field and what it must be.
        what: Both,
        /// Its value.
        found: f64,
    },
    /// A record of a miniSEED file is damaged.
    Damaged {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// What is wrong.
        what: Both,
    },
    /// The samples of a miniSEED record are coded in a way that is not read.
    Encoding {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// The code.
        encoding: u8,
    },
    /// Records of a channel do not follow one another.
    Gap {
        /// The channel.
        channel: String,
        /// Where it should begin, s.
        expected_s: f64,
        /// Where it begins, s.
        found_s: f64,
    },
    /// The file asks too much of the reader.
    Limit(LimitError),
    /// Raw counts of a recorder that the file does not convert.
    Counts {
        /// The line.
        line: usize,
    },
}
