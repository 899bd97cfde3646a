//! What parts a text in columns: lines, delimiters, decimal signs, quotes.

/// Lines that begin with this hold no samples.
const COMMENT: u8 = b'#';

/// What stands between two cells.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Delimiter {
    /// `;`
    Semicolon,
    /// A tab; two of them hold an empty cell.
    Tab,
    /// `,`
    Comma,
    /// Any number of blanks and tabs.
    WhiteSpace,
}

/// What stands before the decimals.
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

    /// Whether cells can be parted by this byte.
    pub(super) fn is(self, byte: u8) -> bool {
        byte == self.byte() || (self == Delimiter::WhiteSpace && byte == b'\t')
    }

    /// The cells of one line, quotes kept, blanks around them taken off. A delimiter within quotes parts nothing.
    pub(super) fn cells(self, line: &[u8]) -> Vec<&[u8]> {
        let mut quoted = false;
        let cells = line.split(|b| {
            quoted ^= *b == b'"';
            !quoted && self.is(*b)
        });
        let cells = cells.map(<[u8]>::trim_ascii);
        if self == Delimiter::WhiteSpace {
            cells.filter(|cell| !cell.is_empty()).collect()
        } else {
            cells.collect()
        }
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
    /// Where it begins.
    pub(super) at: usize,
    /// Where the next line begins.
    pub(super) next: usize,
    /// Whether it has a line end.
    pub(super) ended: bool,
}

/// The line that begins at `at`; `None` at the end of the file.
#[inline]
pub(super) fn line_at(bytes: &[u8], at: usize, number: usize) -> Option<Line<'_>> {
    let rest = bytes.get(at..).filter(|r| !r.is_empty())?;
    let (text, next, ended) = match memchr::memchr(b'\n', rest) {
        Some(end) => (&rest[..end], at + end + 1, true),
        None => (rest, bytes.len(), false),
    };
    Some(Line {
        number,
        at,
        text: text.strip_suffix(b"\r").unwrap_or(text),
        next,
        ended,
    })
}

/// Whether a line holds cells: it is neither blank nor a comment.
#[inline]
pub(super) fn holds_cells(text: &[u8]) -> bool {
    // the first byte decides for nearly every line
    match text.trim_ascii_start().first() {
        None => false,
        Some(first) => *first != COMMENT,
    }
}
