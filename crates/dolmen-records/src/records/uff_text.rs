//! Reads the lines and fixed-width columns of a universal file.

use super::RecordError;
use crate::limits::{LimitError, line_end};
use crate::number::parse_number;
use crate::wrong::Expected;

pub(super) const FORMAT: &str = "uff";

/// The lines of a file with possible binary data between them.
#[derive(Clone, Copy)]
pub(super) struct Lines<'a> {
    bytes: &'a [u8],
    at: usize,
    number: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Lines {
            bytes,
            at: 0,
            number: 0,
        }
    }

    /// Number of the last line that was read, from 1.
    pub(super) fn number(&self) -> usize {
        self.number
    }

    /// The next line without its line end; invalid UTF-8 is replaced by marks.
    pub(super) fn next(&mut self) -> Result<Option<String>, LimitError> {
        let Some(rest) = self.bytes.get(self.at..).filter(|rest| !rest.is_empty()) else {
            return Ok(None);
        };
        let end = line_end(rest, self.number + 1)?;
        let line = &rest[..end.unwrap_or(rest.len())];
        self.at += end.map_or(rest.len(), |end| end + 1);
        self.number += 1;
        let line = line.strip_suffix(b"\r").unwrap_or(line);
        Ok(Some(String::from_utf8_lossy(line).into_owned()))
    }

    /// The next line, without advancing.
    pub(super) fn peek(&self) -> Result<Option<String>, LimitError> {
        let mut ahead = *self;
        ahead.next()
    }

    /// The next line, or an error that states the expected line.
    pub(super) fn want(&mut self, wanted: Expected) -> Result<String, RecordError> {
        let line = self.number + 1;
        self.next()?.ok_or(RecordError::EndsBefore {
            format: FORMAT,
            line,
            wanted: wanted.into(),
        })
    }

    /// The next `count` bytes, which are binary data.
    pub(super) fn bytes(&mut self, count: usize) -> Result<&'a [u8], RecordError> {
        let end = self.at.saturating_add(count);
        let taken = self.bytes.get(self.at..end).ok_or(RecordError::CutShort {
            format: FORMAT,
            bytes: self.bytes.len(),
            wanted: end as u64,
        })?;
        self.at = end;
        // a line end may be between the bytes and the −1
        let rest = &self.bytes[self.at..];
        let ends = [b"\r\n".as_slice(), b"\n"];
        self.at += ends
            .iter()
            .find(|end| rest.starts_with(end))
            .map_or(0, |end| end.len());
        Ok(taken)
    }

    pub(super) fn is_not(&self, line: &str, wanted: Expected) -> RecordError {
        RecordError::LineIsNot {
            format: FORMAT,
            line: self.number,
            text: line.trim().chars().take(80).collect(),
            wanted: wanted.into(),
        }
    }
}

/// Columns of a line, counted from 0; blank if the line is too short.
pub(super) fn cell(line: &str, from: usize, width: usize) -> String {
    line.chars().skip(from).take(width).collect()
}

/// Parses an integer; a blank is 0.
pub(super) fn whole(text: &str) -> Option<i64> {
    match text.trim() {
        "" => Some(0),
        text => text.parse().ok(),
    }
}

/// Parses a number as FORTRAN prints it, with E or D.
pub(super) fn decimal(text: &str) -> Option<f64> {
    let text = text.trim().replace(['D', 'd'], "E");
    parse_number(text.as_bytes())
}
