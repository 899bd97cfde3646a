//! Reads the elements of a MAT file of version 5: tags, matrices and compressed matrices.
//!
//! | element | what |
//! |:--|:--|
//! | tag | type (4 bytes), length (4 bytes); or both in 4 bytes, with the value in the next 4 |
//! | matrix | flags and class, dimensions, name, real part, imaginary part; each padded to 8 bytes |
//! | compressed | one matrix as a zlib stream |
//!
//! Source: The MathWorks (2024) *MAT-File Format*.

use super::RecordError;
use super::cursor::{Cursor, Number};
use super::unpacked::Unpacker;
use crate::limits::{LimitError, PARTS_MOST, expanded_most, refuse_parts};
use crate::quoted::shown;
use crate::wrong::{Damage, Unread};

const FORMAT: &str = "mat";
const HEADER: usize = 128;
const MATRIX: u32 = 14;
const COMPRESSED: u32 = 15;
/// Classes of numbers: double, single, integers of 8 to 64 bits.
const NUMERIC: std::ops::RangeInclusive<u8> = 6..=15;
const COMPLEX: u8 = 0x08;
/// Number of bytes of a compressed matrix that are unpacked to identify it. Our choice: a name in MATLAB has at most 63 letters, and all
/// fields before it take 40 bytes.
const HEAD_BYTES: usize = 1024;

/// A real numeric matrix, stored column by column.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Matrix {
    pub(super) name: String,
    pub(super) rows: usize,
    pub(super) columns: usize,
    /// Empty for a matrix that is not needed.
    pub(super) values: Vec<f64>,
}

/// Whether a record with this number of samples needs a matrix: a scalar, or a matrix with a side of that length.
pub(super) fn is_wanted([rows, columns]: [usize; 2], samples: usize) -> bool {
    rows.max(columns) == samples || rows.max(columns) == 1
}

/// Refuses matrices whose unpacked size is too large for a file of this size.
pub(super) fn refuse_expansion(file: usize, unpacked: u64) -> Result<(), LimitError> {
    match expanded_most(file) {
        most if unpacked <= most => Ok(()),
        most => Err(LimitError::Expands {
            format: FORMAT,
            packed: file,
            unpacked,
            most,
            instead: Unread::SaveV6.into(),
        }),
    }
}

/// One element with a matrix.
enum Element<'a> {
    Plain(&'a [u8]),
    /// A compressed element; the size of its unpacked bytes, including the tag.
    Packed(&'a [u8], usize),
}

/// Header of a matrix; or the name of another variable, with the reason why it is not read.
type Head = Result<Matrix, String>;

/// The real numeric matrices of two dimensions, and the names of all other variables. All headers are read first. Only needed matrices are
/// unpacked, after a check of their total size.
pub(super) fn matrices(bytes: &[u8]) -> Result<(Vec<Matrix>, Vec<String>), RecordError> {
    let mut cursor = Cursor::new(bytes, FORMAT);
    cursor.take(HEADER - 4)?;
    let version = cursor.array::<2>()?;
    let big = match cursor.take(2)? {
        b"IM" => false,
        b"MI" => true,
        _ => return Err(cursor.damaged(Damage::ByteOrder)),
    };
    if version != if big { [1, 0] } else { [0, 1] } {
        return Err(cursor.damaged(Damage::NotMat5));
    }
    let mut cursor = cursor.ordered(big);
    let mut unpacker = Unpacker::new();
    let mut elements = Vec::new();
    while cursor.left() > 0 {
        elements.push(element(&mut cursor, &mut unpacker)?);
        refuse_parts(FORMAT, Unread::Variables, elements.len(), PARTS_MOST)?;
    }
    let longest = |head: &Head| head.as_ref().map_or(0, |m| m.rows.max(m.columns));
    let samples = elements.iter().map(|(_, head)| longest(head)).max().unwrap_or(0);
    let wanted = |head: &Head| {
        head.as_ref()
            .is_ok_and(|m| is_wanted([m.rows, m.columns], samples))
    };
    let unpacked = |(element, head): &(Element, Head)| match (element, head) {
        (Element::Plain(_), _) => 0,
        (Element::Packed(_, length), Ok(m)) if wanted(head) => {
            // as doubles; a header with more numbers than bytes is refused below
            let numbers = m.rows.saturating_mul(m.columns).min(*length);
            (*length as u64).max(8 * numbers as u64)
        }
        (Element::Packed(_, length), _) => *length as u64,
    };
    refuse_expansion(bytes.len(), elements.iter().map(unpacked).sum())?;
    let (mut found, mut passed) = (Vec::new(), Vec::new());
    for (element, head) in elements {
        let is_wanted = wanted(&head);
        let unpacked = |why: Damage| {
            cursor.damaged(Damage::VariableDoesNotUnpack {
                name: name(&head).to_owned(),
                why: why.into(),
            })
        };
        let read = match element {
            Element::Plain(data) => matrix(data, big, is_wanted)?,
            Element::Packed(data, length) if is_wanted => {
                let inner = unpacker.whole(data, length).map_err(unpacked)?;
                let mut within = Cursor::new(&inner, FORMAT).ordered(big);
                let tag = Tag::read(&mut within)?;
                matrix(within.take(tag.length)?, big, true)?
            }
            Element::Packed(data, length) => {
                unpacker.verified(data, length).map_err(unpacked)?;
                head
            }
        };
        match read {
            Ok(matrix) => found.push(matrix),
            Err(name) => passed.push(name),
        }
    }
    Ok((found, passed))
}

fn name(head: &Head) -> &str {
    match head {
        Ok(matrix) => &matrix.name,
        Err(name) => name,
    }
}

/// The element at the cursor, and the header of its matrix.
fn element<'a>(cursor: &mut Cursor<'a>, unpacker: &mut Unpacker) -> Result<(Element<'a>, Head), RecordError> {
    let big = cursor.is_big();
    let tag = Tag::read(cursor)?;
    let data = cursor.take(tag.length)?;
    let read = match tag.sort {
        MATRIX => (
            Element::Plain(data),
            head(&mut Cursor::new(data, FORMAT).ordered(big))?,
        ),
        COMPRESSED => {
            let first = unpacker
                .head(data, HEAD_BYTES)
                .map_err(|why: Damage| cursor.damaged(Damage::BeforeDoesNotUnpack(why.into())))?;
            let mut within = Cursor::new(&first, FORMAT).ordered(big);
            let tag = Tag::read(&mut within)?;
            if tag.sort != MATRIX {
                return Err(no_variable(cursor, tag.sort));
            }
            let head = head(&mut within).map_err(|_| cursor.damaged(Damage::NoWholeHead))?;
            (
                // padding may follow
                Element::Packed(data, within_tag(tag.length)),
                head,
            )
        }
        sort => return Err(no_variable(cursor, sort)),
    };
    // compressed elements are not padded, others are
    if tag.sort != COMPRESSED && !tag.length.is_multiple_of(8) && cursor.left() > 0 {
        cursor.take(8 - tag.length % 8)?;
    }
    Ok(read)
}

/// Size of an element with its tag and padding, bytes.
fn within_tag(length: usize) -> usize {
    length.next_multiple_of(8) + 8
}

/// to ignore a variable without a note would change the record
fn no_variable(cursor: &Cursor, sort: u32) -> RecordError {
    cursor.damaged(Damage::ElementType(sort))
}

/// Type and length of an element.
struct Tag {
    sort: u32,
    length: usize,
    /// Whether the tag itself contains the value.
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
                false => Err(cursor.damaged(Damage::ShortForm)),
            };
        }
        Ok(Tag {
            sort: word,
            length: cursor.u32()? as usize,
            small: false,
        })
    }
}

/// A part of a matrix: type and bytes.
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

/// Header of the matrix at the cursor.
fn head(cursor: &mut Cursor) -> Result<Head, RecordError> {
    let big = cursor.is_big();
    let (_, flags) = part(cursor)?;
    let mut flags = Cursor::new(flags, FORMAT).ordered(big);
    let word = flags.u32()?.to_le_bytes();
    let (class, flag) = (word[0], word[1]);
    let (sort, dimensions) = part(cursor)?;
    if sort != 5 {
        return Err(cursor.damaged(Damage::Dimensions));
    }
    let mut sides = Cursor::new(dimensions, FORMAT).ordered(big);
    let count = dimensions.len() / 4;
    let mut size = Vec::with_capacity(count);
    for _ in 0..count {
        let side = sides.i32()?;
        size.push(usize::try_from(side).map_err(|_| cursor.damaged(Damage::Side(side.to_string())))?);
    }
    let (_, name) = part(cursor)?;
    let name = shown(&String::from_utf8_lossy(name));
    let &[rows, columns] = size.as_slice() else {
        return Ok(Err(format!("{name} ({count} dimensions)")));
    };
    let reason = match class {
        // MATLAB stores the content of objects as an unnamed array of bytes
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
    let values = Vec::new();
    Ok(Ok(Matrix {
        name,
        rows,
        columns,
        values,
    }))
}

/// A matrix, with its values only if needed; or the name of a matrix that is not read, with the reason.
fn matrix(data: &[u8], big: bool, is_wanted: bool) -> Result<Head, RecordError> {
    let mut cursor = Cursor::new(data, FORMAT).ordered(big);
    let mut matrix = match head(&mut cursor)? {
        Ok(matrix) => matrix,
        Err(name) => return Ok(Err(name)),
    };
    let Matrix {
        name, rows, columns, ..
    } = &matrix;
    let (sort, values) = part(&mut cursor)?;
    let Some(number) = number(sort) else {
        return Err(cursor.damaged(Damage::ValueType {
            name: name.clone(),
            sort,
        }));
    };
    if rows
        .checked_mul(*columns)
        .and_then(|n| n.checked_mul(number.bytes()))
        != Some(values.len())
    {
        return Err(cursor.damaged(Damage::ValueBytes {
            name: name.clone(),
            rows: *rows,
            columns: *columns,
            bytes: values.len(),
        }));
    }
    if is_wanted {
        matrix.values = number.series(&mut Cursor::new(values, FORMAT).ordered(big), rows * columns)?;
    }
    Ok(Ok(matrix))
}

#[cfg(test)]
mod tests {
    use super::*;
    use miniz_oxide::deflate::compress_to_vec_zlib;

    fn header() -> Vec<u8> {
        let mut bytes = b"MATLAB 5.0 MAT-file".to_vec();
        bytes.resize(HEADER - 4, b' ');
        bytes.extend(b"\x00\x01IM");
        bytes
    }

    fn tagged(sort: u32, data: &[u8]) -> Vec<u8> {
        let mut bytes = sort.to_le_bytes().to_vec();
        bytes.extend((data.len() as u32).to_le_bytes());
        bytes.extend(data);
        bytes.resize(bytes.len().next_multiple_of(8), 0);
        bytes
    }

    /// A matrix of 8-bit numbers, all 1.
    fn ones(name: &str, rows: u32, columns: u32) -> Vec<u8> {
        let sides: Vec<u8> = [rows, columns]
            .iter()
            .flat_map(|side| side.to_le_bytes())
            .collect();
        let parts = [
            tagged(6, &[6, 0, 0, 0, 0, 0, 0, 0]),
            tagged(5, &sides),
            tagged(1, name.as_bytes()),
            tagged(1, &vec![1; (rows * columns) as usize]),
        ];
        tagged(MATRIX, &parts.concat())
    }

    fn packed(element: &[u8]) -> Vec<u8> {
        let data = compress_to_vec_zlib(element, 1);
        let mut bytes = COMPRESSED.to_le_bytes().to_vec();
        bytes.extend((data.len() as u32).to_le_bytes());
        bytes.extend(data);
        bytes
    }

    #[test]
    fn refuses_matrices_that_unpack_to_gigabytes() {
        let mut bytes = header();
        bytes.extend(packed(&ones("acc", 4_000_000, 1)).repeat(100));
        let said = matrices(&bytes).unwrap_err().to_string();
        let length = bytes.len();
        assert_eq!(
            said,
            format!(
                "the mat file of {length} bytes unpacks to 3200000000, but at most 104857600 are unpacked of it, since no record of vibrations \
                 packs so tightly: save it with save(\"file.mat\", \"-v6\"), which packs nothing"
            )
        );
    }

    #[test]
    fn holds_only_what_a_record_needs_becomes_numbers() {
        let mut bytes = header();
        for element in [ones("acc", 1000, 2), ones("other", 30, 10), ones("fs", 1, 1)] {
            bytes.extend(packed(&element));
        }
        let (found, passed) = matrices(&bytes).unwrap();
        let held: Vec<(&str, usize)> = found.iter().map(|m| (m.name.as_str(), m.values.len())).collect();
        assert_eq!(
            (held, passed.len()),
            (vec![("acc", 2000), ("other", 0), ("fs", 1)], 0)
        );
        // parts that are not needed are checked as well
        let at = header().len() + packed(&ones("acc", 1000, 2)).len() + packed(&ones("other", 30, 10)).len();
        bytes[at - 1] ^= 1;
        assert_eq!(
            matrices(&bytes).unwrap_err().to_string().split(": ").nth(2),
            Some("its sum is wrong; copy it again")
        );
    }

    #[test]
    fn refuses_more_variables_than_anyone_saves() {
        let mut bytes = header();
        bytes.extend(ones("a", 1, 1).repeat(PARTS_MOST + 1));
        assert!(
            matrices(&bytes)
                .unwrap_err()
                .to_string()
                .starts_with("the mat file holds more than 65536 variables")
        );
    }
}
