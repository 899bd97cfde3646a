//! Why a file of a seismic station cannot be read.

use crate::limits::LimitError;
use crate::quoted::shown;

/// Why the bytes of a file are no channels of a seismic station. Each variant says where in the file and what to do. Lines are
/// counted from 1.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum SeismicError {
    /// The header of an AT2 file does not say how many samples and how far apart.
    #[error(
        "line {line}: \"{text}\" does not give NPTS and DT: it must read like \"NPTS= 4000, DT= .0100 SEC\" or \
         \"4000 0.0100 NPTS, DT\"; download the file again",
        text = shown(text)
    )]
    At2Header {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// A file of velocities or displacements.
    #[error(
        "{}the file holds {what}, not accelerations: take the file of accelerations (of PEER, the one that ends in AT2)",
        if *line > 0 { format!("line {line}: ") } else { String::new() }
    )]
    Quantity {
        /// The line; 0 in a file without lines.
        line: usize,
        /// "velocities", "displacements".
        what: &'static str,
    },
    /// A unit that a header names is not known.
    #[error(
        "line {line}: the unit \"{text}\" is not known: give unit = g, gal or m/s2 if you know which is meant",
        text = shown(text)
    )]
    At2Unit {
        /// The line.
        line: usize,
        /// What stands there.
        text: String,
    },
    /// A value is no number.
    #[error(
        "line {line}: \"{text}\" is not a finite number: correct it, or download the file again",
        text = shown(text)
    )]
    NotANumber {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
    },
    /// Not as many samples as the header says.
    #[error(
        "the header says {stated} samples, but {found} follow: the file was cut short or edited; download it again"
    )]
    Count {
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// A line is not what the format has there.
    #[error(
        "line {line}: \"{text}\" is not {wanted}: the file was cut or edited; download it again",
        text = shown(text)
    )]
    Line {
        /// The line.
        line: usize,
        /// What stands there, at most 80 characters of it.
        text: String,
        /// What must stand there.
        wanted: &'static str,
    },
    /// The text ends within its header or between its parts.
    #[error("the file ends before line {line}, which must be {wanted}: it was cut short; download it again")]
    EndsEarly {
        /// The line that is missing.
        line: usize,
        /// What it must be.
        wanted: &'static str,
    },
    /// A header does not say something.
    #[error(
        "the header ({lines} lines) does not give {label}: the file was cut or edited; download it again"
    )]
    Missing {
        /// What is missing.
        label: &'static str,
        /// Lines that were looked through.
        lines: usize,
    },
    /// The file is not as long as its headers say.
    #[error(
        "the {format} file has {found} bytes, but its header says {stated}: it was cut short or edited; download it again"
    )]
    Bytes {
        /// The format.
        format: &'static str,
        /// As the header says.
        stated: u64,
        /// As there are.
        found: usize,
    },
    /// The header of a SAC file says something that is no motion.
    #[error("the SAC header says {found}, but {what}")]
    Sac {
        /// The field and what it must be.
        what: &'static str,
        /// Its value.
        found: f64,
    },
    /// A record of a miniSEED file is damaged.
    #[error("the miniSEED record at byte {at}: {what}; download the file again")]
    Damaged {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// What is wrong.
        what: &'static str,
    },
    /// The samples of a miniSEED record are coded in a way that is not read.
    #[error(
        "the miniSEED record at byte {at} has encoding {encoding}, but only 16 and 32 bit integers (1, 3), floats (4, 5) and Steim \
         1 and 2 (10, 11) are read: convert it before"
    )]
    Encoding {
        /// Where the record begins, bytes from 0.
        at: u64,
        /// The code.
        encoding: u8,
    },
    /// Records of a channel do not follow one another.
    #[error(
        "channel {channel}: a record begins {found_s} s after the first, but the samples before it end at {expected_s} s: there \
         is a gap or an overlap; cut the file there",
        channel = shown(channel)
    )]
    Gap {
        /// The channel.
        channel: String,
        /// Where it should begin, s.
        expected_s: f64,
        /// Where it begins, s.
        found_s: f64,
    },
    /// The file asks too much of the reader.
    #[error(transparent)]
    Limit(#[from] LimitError),
    /// Raw counts of a recorder that the file does not convert.
    #[error(
        "line {line}: the numbers are raw counts of the recorder (V0): take the V1 or V2 file, which holds accelerations"
    )]
    Counts {
        /// The line.
        line: usize,
    },
}
