//! The elements of a MAT file of version 5: tags, matrices, compressed ones.
//!
//! | element | what |
//! |:--|:--|
//! | tag | type (4 bytes), length (4 bytes); or both in 4 bytes, with the value in the next 4 |
//! | matrix | flags and class, dimensions, name, real part, imaginary part; each padded to 8 bytes |
//! | compressed | one matrix as zlib stream |
//!
//! Source: The MathWorks (2024) *MAT-File Format*.

use super::RecordError;
use super::cursor::{Cursor, Number};
use miniz_oxide::inflate::decompress_to_vec_zlib_with_limit;

const FORMAT: &str = "mat";
const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Classes of numbers: double, single, integers of 8 to 64 bits.
const NUMERIC: std::ops::RangeInclusive<u8> = 6..=15;
const COMPLEX: u8 = 0x08;
/// Deflate packs no more into a byte: what claims to is damaged.
const INFLATION_MOST: usize = 1032;

/// A real numeric matrix, column by column.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Matrix {
    pub(super) name: String,
    pub(super) rows: usize,
    pub(super) columns: usize,
    pub(super) values: Vec<f64>,
}

/// The real numeric matrices of two dimensions, and the names of everything else.
pub(super) fn matrices(bytes: &[u8]) -> Result<(Vec<Matrix>, Vec<String>), RecordError> {
    let mut cursor = Cursor::new(bytes, FORMAT);
    cursor.take(HEADER - 4)?;
    let version = cursor.array::<2>()?;
    let big = match cursor.take(2)? {
        b"IM" => false,
        b"MI" => true,
        _ => return Err(cursor.damaged("the mark of the byte order is none")),
    };
    if version != if big { [1, 0] } else { [0, 1] } {
        return Err(cursor.damaged("the version is not that of MAT 5"));
    }
    let mut cursor = cursor.ordered(big);
    let (mut found, mut passed) = (Vec::new(), Vec::new());
    while cursor.left() > 0 {
        let tag = Tag::read(&mut cursor)?;
        let data = cursor.take(tag.length)?;
        match tag.sort {
            MATRIX => sorted(matrix(data, big)?, &mut found, &mut passed),
            COMPRESSED => {
                let most = data.len().saturating_mul(INFLATION_MOST);
                let inner = decompress_to_vec_zlib_with_limit(data, most).map_err(|why| {
                    cursor.damaged(format!("compressed data before this place do not unpack ({why})"))
                })?;
                let mut within = Cursor::new(&inner, FORMAT).ordered(big);
                let tag = Tag::read(&mut within)?;
                if tag.sort != MATRIX {
                    return Err(no_variable(&cursor, tag.sort));
                }
                sorted(matrix(within.take(tag.length)?, big)?, &mut found, &mut passed);
            }
            sort => return Err(no_variable(&cursor, sort)),
        }
        // compressed elements are not padded, others are
        if tag.sort != COMPRESSED && !tag.length.is_multiple_of(8) && cursor.left() > 0 {
            cursor.take(8 - tag.length % 8)?;
        }
    }
    Ok((found, passed))
}

/// A variable passed over in silence would make another record of the file.
fn no_variable(cursor: &Cursor, sort: u32) -> RecordError {
    cursor.damaged(format!(
        "the element before this place has type {sort}, which is no variable"
    ))
}

fn sorted(read: Result<Matrix, String>, found: &mut Vec<Matrix>, passed: &mut Vec<String>) {
    match read {
        Ok(matrix) => found.push(matrix),
        Err(name) => passed.push(name),
    }
}

/// Type and length of an element.
struct Tag {
    sort: u32,
    length: usize,
    /// Whether its value stands in the tag itself.
    small: bool,
}

impl Tag {
    fn read(cursor: &mut Cursor) -> Result<Self, RecordError> {
        let word = cursor.u32()?;
        if word >> 16 != 0 {
            let length = (word >> 16) as usize;
            return match length <= 4 {
                true => Ok(Tag {
                    sort: word & 0xFFFF,
                    length,
                    small: true,
                }),
                false => Err(cursor.damaged("an element in short form is longer than 4 bytes")),
            };
        }
        Ok(Tag {
            sort: word,
            length: cursor.u32()? as usize,
            small: false,
        })
    }
}

/// A part of a matrix: its type and its bytes.
fn part<'a>(cursor: &mut Cursor<'a>) -> Result<(u32, &'a [u8]), RecordError> {
    let tag = Tag::read(cursor)?;
    let data = cursor.take(tag.length)?;
    let unit = if tag.small { 4 } else { 8 };
    let padding = data.len().next_multiple_of(unit) - data.len();
    cursor.take(padding.min(cursor.left()))?;
    Ok((tag.sort, data))
}

fn number(sort: u32) -> Option<Number> {
    Some(match sort {
        1 => Number::I8,
        2 => Number::U8,
        3 => Number::I16,
        4 => Number::U16,
        5 => Number::I32,
        6 => Number::U32,
        7 => Number::F32,
        9 => Number::F64,
        12 => Number::I64,
        13 => Number::U64,
        _ => return None,
    })
}

/// A matrix, or the name of one that is not read with the reason.
fn matrix(data: &[u8], big: bool) -> Result<Result<Matrix, String>, RecordError> {
    let mut cursor = Cursor::new(data, FORMAT).ordered(big);
    let (_, flags) = part(&mut cursor)?;
    let mut flags = Cursor::new(flags, FORMAT).ordered(big);
    let word = flags.u32()?.to_le_bytes();
    let (class, flag) = (word[0], word[1]);
    let (sort, dimensions) = part(&mut cursor)?;
    if sort != 5 {
        return Err(cursor.damaged("the dimensions of a matrix are no integers of 32 bits"));
    }
    let mut sides = Cursor::new(dimensions, FORMAT).ordered(big);
    let count = dimensions.len() / 4;
    let mut size = Vec::with_capacity(count);
    for _ in 0..count {
        let side = sides.i32()?;
        size.push(
            usize::try_from(side).map_err(|_| cursor.damaged(format!("a side of a matrix is {side}")))?,
        );
    }
    let (_, name) = part(&mut cursor)?;
    let name = String::from_utf8_lossy(name).into_owned();
    let &[rows, columns] = size.as_slice() else {
        return Ok(Err(format!("{name} ({count} dimensions)")));
    };
    let reason = match class {
        // what MATLAB keeps of objects is an unnamed array of bytes
        _ if name.is_empty() => Some("unnamed"),
        class if NUMERIC.contains(&class) && flag & COMPLEX != 0 => Some("complex"),
        class if NUMERIC.contains(&class) => None,
        1 => Some("cell"),
        2 => Some("struct"),
        4 => Some("text"),
        5 => Some("sparse"),
        _ => Some("object"),
    };
    if let Some(reason) = reason {
        return Ok(Err(format!("{name} ({reason})")));
    }
    if rows == 0 || columns == 0 {
        return Ok(Err(format!("{name} (empty)")));
    }
    let (sort, values) = part(&mut cursor)?;
    let Some(number) = number(sort) else {
        return Err(cursor.damaged(format!("the values of {name} have type {sort}, which is none")));
    };
    if rows
        .checked_mul(columns)
        .and_then(|n| n.checked_mul(number.bytes()))
        != Some(values.len())
    {
        return Err(cursor.damaged(format!(
            "{name} is {rows} × {columns}, but holds {} bytes of values",
            values.len()
        )));
    }
    let values = number.series(&mut Cursor::new(values, FORMAT).ordered(big), rows * columns)?;
    Ok(Ok(Matrix {
        name,
        rows,
        columns,
        values,
    }))
}
