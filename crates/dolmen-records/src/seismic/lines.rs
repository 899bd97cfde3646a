//! Lines of a text file with their numbers, and numbers in columns of fixed width as FORTRAN prints them.

use super::SeismicError;
use crate::limits::{LimitError, line_end};
use crate::number::parse_number;
use crate::wrong::OfStation;

/// A line: its number from 1 and its bytes without the line end.
pub(super) type Line<'a> = (usize, &'a [u8]);

/// The lines of a file, one after the other.
pub(super) struct Lines<'a> {
    rest: &'a [u8],
    read: usize,
}

impl<'a> Lines<'a> {
    pub(super) fn new(bytes: &'a [u8]) -> Self {
        Lines { rest: bytes, read: 0 }
    }

    /// The next line, or an error that states the expected content.
    pub(super) fn want(&mut self, wanted: OfStation) -> Result<Line<'a>, SeismicError> {
        let line = self.read + 1;
        self.next().ok_or(SeismicError::EndsEarly {
            line,
            wanted: wanted.into(),
        })
    }

    /// The next line, without advancing.
    pub(super) fn peek(&self) -> Option<Line<'a>> {
        Lines {
            rest: self.rest,
            read: self.read,
        }
        .next()
    }
}

impl<'a> Iterator for Lines<'a> {
    type Item = Line<'a>;

    fn next(&mut self) -> Option<Line<'a>> {
        if self.rest.is_empty() {
            return None;
        }
        let end = memchr::memchr(b'\n', self.rest);
        let line = &self.rest[..end.unwrap_or(self.rest.len())];
        self.rest = end.map_or(&[], |end| &self.rest[end + 1..]);
        self.read += 1;
        Some((self.read, line.strip_suffix(b"\r").unwrap_or(line)))
    }
}

/// Refuses a text with a line that is too long, before any of it is read.
pub(super) fn refuse_long_lines(bytes: &[u8]) -> Result<(), LimitError> {
    let (mut at, mut line) = (0, 1);
    while let Some(end) = line_end(&bytes[at..], line)? {
        (at, line) = (at + end + 1, line + 1);
    }
    Ok(())
}

/// The beginning of a text of the file, for a message.
pub(super) fn excerpt(text: &[u8]) -> String {
    const CHARACTERS: usize = 80;
    String::from_utf8_lossy(text)
        .trim()
        .chars()
        .take(CHARACTERS)
        .collect()
}

/// A line as text; invalid UTF-8 is replaced by marks.
pub(super) fn text((_, line): Line) -> String {
    String::from_utf8_lossy(line).into_owned()
}

/// The error for a line that differs from the expected one.
pub(super) fn refused((line, text): Line, wanted: OfStation) -> SeismicError {
    SeismicError::Line {
        line,
        text: excerpt(text),
        wanted: wanted.into(),
    }
}

/// A finite number, with optional white space around it.
pub(super) fn number(line: usize, cell: &[u8]) -> Result<f64, SeismicError> {
    match parse_number(cell.trim_ascii()) {
        Some(value) if value.is_finite() => Ok(value),
        _ => Err(SeismicError::NotANumber {
            line,
            text: excerpt(cell),
        }),
    }
}

/// Columns of a FORTRAN format such as "(8F10.5)" or "(10I8)": number per line and width.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Columns {
    pub(super) on_a_line: usize,
    pub(super) width: usize,
}

impl Columns {
    /// From a text with "Format=(8F10.5)" or "(8f9.6)": its last parenthesis.
    pub(super) fn of_format(text: &str) -> Option<Columns> {
        let open = text.rfind('(')?;
        let inner = text[open + 1..].split(')').next()?.trim();
        let letter = inner.find(|c: char| c.is_ascii_alphabetic())?;
        if !matches!(
            inner.as_bytes()[letter].to_ascii_uppercase(),
            b'F' | b'E' | b'I' | b'G'
        ) {
            return None;
        }
        let width = inner[letter + 1..].split('.').next()?;
        let columns = Columns {
            on_a_line: if letter == 0 {
                1
            } else {
                inner[..letter].trim().parse().ok()?
            },
            width: width.trim().parse().ok()?,
        };
        let readable = 1..=200;
        (readable.contains(&columns.on_a_line) && readable.contains(&columns.width)).then_some(columns)
    }

    /// The numbers of one line, split by column width: numbers may touch.
    pub(super) fn numbers(self, (number_of_line, line): Line) -> Result<Vec<f64>, SeismicError> {
        let line = line.trim_ascii_end();
        if line.len() > self.on_a_line * self.width {
            return Err(refused((number_of_line, line), OfStation::NumbersInColumns));
        }
        line.chunks(self.width)
            .map(|cell| number(number_of_line, cell))
            .collect()
    }

    /// This many numbers from the next lines.
    pub(super) fn read(self, lines: &mut Lines, count: usize) -> Result<Vec<f64>, SeismicError> {
        let mut values = Vec::new();
        while values.len() < count {
            let line = match lines.peek() {
                Some(line) if !line.1.trim_ascii().is_empty() => line,
                _ => {
                    return Err(SeismicError::Count {
                        stated: count as u64,
                        found: values.len(),
                    });
                }
            };
            let (on_the_line, missing) = (self.numbers(line)?, count - values.len());
            let short = on_the_line.len() < self.on_a_line.min(missing);
            if short || on_the_line.len() > missing {
                let found = values.len() + on_the_line.len();
                return Err(SeismicError::Count {
                    stated: count as u64,
                    found,
                });
            }
            values.extend(on_the_line);
            lines.next();
        }
        Ok(values)
    }
}

/// Numbers separated by white space on all remaining lines.
pub(super) fn all_numbers(lines: Lines) -> Result<Vec<f64>, SeismicError> {
    let mut values = Vec::new();
    for (line, bytes) in lines {
        for cell in bytes
            .split(u8::is_ascii_whitespace)
            .filter(|cell| !cell.is_empty())
        {
            values.push(number(line, cell)?);
        }
    }
    Ok(values)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_fortran_formats() {
        let of = |text: &str| Columns::of_format(text).map(|c| (c.on_a_line, c.width));
        assert_eq!(of("units=cm/sec2(04),Format=(8F10.5)"), Some((8, 10)));
        assert_eq!(of("Format=(1E15.6)"), Some((1, 15)));
        assert_eq!(of("in units of g.       Format: (8f9.6)  "), Some((8, 9)));
        assert_eq!(of("(10I8)"), Some((10, 8)));
        for none in [
            "",
            "(",
            "(8X10)",
            "(F)",
            "(0F10.5)",
            "(999F9.5)",
            "no parenthesis",
        ] {
            assert_eq!(of(none), None, "{none}");
        }
    }

    #[test]
    fn exact_numbers_that_touch() {
        let columns = Columns {
            on_a_line: 3,
            width: 4,
        };
        assert_eq!(columns.numbers((1, b" 1.5-2.0 3  ")).unwrap(), [1.5, -2.0, 3.0]);
        assert!(columns.numbers((7, b" 1.5-2.0 3   9")).is_err());
        assert!(
            columns
                .numbers((7, b" 1.5   x"))
                .unwrap_err()
                .to_string()
                .starts_with("line 7")
        );
    }
}
