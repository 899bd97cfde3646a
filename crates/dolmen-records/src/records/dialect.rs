//! The parts of a text in columns: lines, delimiters, decimal signs, quotes.

use crate::limits::{CHANNELS_MOST, LimitError, line_end};

/// Beginning of comment lines.
const COMMENT: u8 = b'#';
/// Largest number of cells in a line: the columns, and an empty one after the delimiter that ends every line in some files.
const CELLS_MOST: usize = CHANNELS_MOST + 1;

/// Separator of cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// `;`
    Semicolon,
    /// A tab; two tabs enclose an empty cell.
    Tab,
    /// `,`
    Comma,
    /// Any number of blanks and tabs.
    WhiteSpace,
}

/// Decimal sign.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Decimal {
    /// `.`
    Point,
    /// `,`
    Comma,
}

impl Delimiter {
    pub(super) fn byte(self) -> u8 {
        match self {
            Delimiter::Semicolon => b';',
            Delimiter::Tab => b'\t',
            Delimiter::Comma => b',',
            Delimiter::WhiteSpace => b' ',
        }
    }

    /// Whether this byte can separate cells.
    pub(super) fn is(self, byte: u8) -> bool {
        byte == self.byte() || (self == Delimiter::WhiteSpace && byte == b'\t')
    }

    /// The cells of one line, with quotes and without blanks around them, up to the limit. A delimiter within quotes does not separate.
    pub(super) fn cells(self, line: &[u8]) -> Vec<&[u8]> {
        self.parted(line).take(CELLS_MOST).collect()
    }

    /// Number of cells in a line.
    pub(super) fn count(self, line: &[u8]) -> usize {
        self.parted(line).count()
    }

    fn parted(self, line: &[u8]) -> impl Iterator<Item = &[u8]> {
        let mut quoted = false;
        let cells = line.split(move |b| {
            quoted ^= *b == b'"';
            !quoted && self.is(*b)
        });
        let empty_ones = self != Delimiter::WhiteSpace;
        cells
            .map(<[u8]>::trim_ascii)
            .filter(move |cell| empty_ones || !cell.is_empty())
    }
}

impl Decimal {
    pub(super) fn byte(self) -> u8 {
        match self {
            Decimal::Point => b'.',
            Decimal::Comma => b',',
        }
    }
}

/// A cell without the quotes around it.
pub(super) fn unquoted(cell: &[u8]) -> &[u8] {
    cell.strip_prefix(b"\"")
        .and_then(|c| c.strip_suffix(b"\""))
        .unwrap_or(cell)
        .trim_ascii()
}

/// One line of a file, without its line end.
#[derive(Clone, Copy, Debug)]
pub(super) struct Line<'a> {
    /// Counted from 1.
    pub(super) number: usize,
    pub(super) text: &'a [u8],
    /// Its position in the file.
    pub(super) at: usize,
    /// Start of the next line.
    pub(super) next: usize,
    /// Whether it has a line end.
    pub(super) ended: bool,
}

/// The line that begins at `at`; `None` at the end of the file.
///
/// # Errors
/// [`LimitError::Line`].
#[inline]
pub(super) fn line_at(bytes: &[u8], at: usize, number: usize) -> Result<Option<Line<'_>>, LimitError> {
    let Some(rest) = bytes.get(at..).filter(|r| !r.is_empty()) else {
        return Ok(None);
    };
    let (text, next, ended) = match line_end(rest, number)? {
        Some(end) => (&rest[..end], at + end + 1, true),
        None => (rest, bytes.len(), false),
    };
    Ok(Some(Line {
        number,
        at,
        text: text.strip_suffix(b"\r").unwrap_or(text),
        next,
        ended,
    }))
}

/// Whether a line has cells: it is neither blank nor a comment.
#[inline]
pub(super) fn holds_cells(text: &[u8]) -> bool {
    // the first byte decides for nearly every line
    match text.trim_ascii_start().first() {
        None => false,
        Some(first) => *first != COMMENT,
    }
}
