//! Numbers of a binary file, each access checked against its length.

use super::RecordError;
use dolmen_words::message::Both;

/// A position in a binary file, with a byte order. Memory is allocated only after the bytes are known to exist.
#[derive(Clone, Copy, Debug)]
pub(super) struct Cursor<'a> {
    bytes: &'a [u8],
    at: usize,
    format: &'static str,
    big: bool,
}

macro_rules! numbers {
    ($($name:ident: $kind:ty),*) => {
        $(pub(super) fn $name(&mut self) -> Result<$kind, RecordError> {
            let bytes = self.array()?;
            Ok(if self.big { <$kind>::from_be_bytes(bytes) } else { <$kind>::from_le_bytes(bytes) })
        })*
    };
}

impl<'a> Cursor<'a> {
    pub(super) fn new(bytes: &'a [u8], format: &'static str) -> Self {
        Cursor {
            bytes,
            at: 0,
            format,
            big: false,
        }
    }

    /// The cursor at the same position, with big-endian or little-endian order.
    pub(super) fn ordered(self, big: bool) -> Self {
        Cursor { big, ..self }
    }

    pub(super) fn is_big(&self) -> bool {
        self.big
    }

    /// Its position, bytes from the start of the file.
    pub(super) fn at(&self) -> usize {
        self.at
    }

    /// Moves to another position, at most the end.
    pub(super) fn go(&mut self, at: usize) -> Result<(), RecordError> {
        if at > self.bytes.len() {
            return Err(self.cut(at));
        }
        self.at = at;
        Ok(())
    }

    pub(super) fn left(&self) -> usize {
        self.bytes.len() - self.at
    }

    fn cut(&self, wanted: usize) -> RecordError {
        RecordError::CutShort {
            format: self.format,
            bytes: self.bytes.len(),
            wanted: wanted as u64,
        }
    }

    /// The next `count` bytes.
    pub(super) fn take(&mut self, count: usize) -> Result<&'a [u8], RecordError> {
        let end = self.at.saturating_add(count);
        let taken = self.bytes.get(self.at..end).ok_or(self.cut(end))?;
        self.at = end;
        Ok(taken)
    }

    pub(super) fn array<const N: usize>(&mut self) -> Result<[u8; N], RecordError> {
        let mut out = [0; N];
        out.copy_from_slice(self.take(N)?);
        Ok(out)
    }

    numbers!(u8: u8, i8: i8, u16: u16, i16: i16, u32: u32, i32: i32, u64: u64, i64: i64, f32: f32, f64: f64);

    /// An error at this place.
    pub(super) fn damaged(&self, what: impl Into<Both>) -> RecordError {
        RecordError::Damaged {
            format: self.format,
            at: self.at as u64,
            what: what.into(),
        }
    }
}

/// Type of a number in a binary file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Number {
    I8,
    U8,
    I16,
    U16,
    I24,
    I32,
    U32,
    I64,
    U64,
    F32,
    F64,
}

impl Number {
    pub(super) fn bytes(self) -> usize {
        match self {
            Number::I8 | Number::U8 => 1,
            Number::I16 | Number::U16 => 2,
            Number::I24 => 3,
            Number::I32 | Number::U32 | Number::F32 => 4,
            Number::I64 | Number::U64 | Number::F64 => 8,
        }
    }

    /// The number at the cursor.
    pub(super) fn read(self, cursor: &mut Cursor) -> Result<f64, RecordError> {
        Ok(match self {
            Number::I8 => f64::from(cursor.i8()?),
            Number::U8 => f64::from(cursor.u8()?),
            Number::I16 => f64::from(cursor.i16()?),
            Number::U16 => f64::from(cursor.u16()?),
            Number::I24 => {
                let [a, b, c] = cursor.array::<3>()?;
                let word = if cursor.is_big() { [c, b, a] } else { [a, b, c] };
                f64::from(i32::from_le_bytes([0, word[0], word[1], word[2]]) >> 8)
            }
            Number::I32 => f64::from(cursor.i32()?),
            Number::U32 => f64::from(cursor.u32()?),
            Number::I64 => cursor.i64()? as f64,
            Number::U64 => cursor.u64()? as f64,
            Number::F32 => f64::from(cursor.f32()?),
            Number::F64 => cursor.f64()?,
        })
    }

    /// `count` numbers one after the other.
    pub(super) fn series(self, cursor: &mut Cursor, count: usize) -> Result<Vec<f64>, RecordError> {
        let needed = count.saturating_mul(self.bytes());
        if needed > cursor.left() {
            return Err(cursor.cut(cursor.at().saturating_add(needed)));
        }
        (0..count).map(|_| self.read(cursor)).collect()
    }
}
