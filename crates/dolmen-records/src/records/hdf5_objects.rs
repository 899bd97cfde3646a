//! Object headers of HDF5: the messages that describe a variable.
//!
//! | message | what |
//! |:--|:--|
//! | data space | the sides |
//! | data type | class (integer, float, …), bytes, order |
//! | layout | position of the numbers: in the header, in one piece, or in chunks of equal size |
//! | filters | encoding of chunks: shuffled bytes, deflate, checksum |
//! | attribute | MATLAB's class; whether it is empty |

use super::RecordError;
use super::cursor::{Cursor, Number};
use super::hdf5_file::{FORMAT, File, Unvisited};
use crate::wrong::{Damage, Unread};

const CONTINUATION: u16 = 0x10;
/// Bit of a shared message, stored elsewhere.
const SHARED: u8 = 0x02;

/// One message of an object header.
pub(super) struct Message<'a> {
    pub(super) sort: u16,
    pub(super) data: &'a [u8],
}

/// The messages of the object at an address.
pub(super) fn messages<'a>(
    file: &File<'a>,
    address: u64,
    unvisited: &mut Unvisited,
) -> Result<Vec<Message<'a>>, RecordError> {
    let mut cursor = file.at(address)?;
    let mut found = Vec::new();
    let first = cursor.array::<4>()?;
    let newer = &first == b"OHDR";
    let mut ordered = false;
    let size = if newer {
        cursor.take(1)?;
        let flags = cursor.u8()?;
        ordered = flags & 0x04 != 0;
        cursor.take(if flags & 0x20 == 0 { 0 } else { 16 } + if flags & 0x10 == 0 { 0 } else { 4 })?;
        match flags & 3 {
            0 => u64::from(cursor.u8()?),
            1 => u64::from(cursor.u16()?),
            2 => u64::from(cursor.u32()?),
            _ => cursor.u64()?,
        }
    } else {
        if first[0] != 1 {
            return Err(cursor.damaged(Damage::ObjectHeader));
        }
        cursor.take(4)?;
        let size = u64::from(cursor.u32()?);
        cursor.take(4)?;
        size
    };
    let mut blocks = vec![cursor.take(usize::try_from(size).unwrap_or(usize::MAX))?];
    let mut read = 0;
    while let Some(block) = blocks.get(read).copied() {
        read += 1;
        let mut within = Cursor::new(block, FORMAT);
        unvisited.header(block.len().max(1), &within)?;
        let head = if newer { 4 + if ordered { 2 } else { 0 } } else { 8 };
        while within.left() >= head {
            let (sort, size, flags) = if newer {
                (u16::from(within.u8()?), within.u16()?, within.u8()?)
            } else {
                (within.u16()?, within.u16()?, within.u8()?)
            };
            within.take(head - if newer { 4 } else { 5 })?;
            let data = within.take(size.into())?;
            if sort == CONTINUATION {
                blocks.push(continuation(file, data, newer)?);
            } else if sort != 0 && flags & SHARED != 0 {
                return Err(RecordError::NotReadHere {
                    format: FORMAT,
                    what: Unread::SharedMessages.into(),
                    instead: Unread::SaveV7.into(),
                });
            } else if sort != 0 {
                found.push(Message { sort, data });
            }
        }
    }
    Ok(found)
}

fn continuation<'a>(file: &File<'a>, data: &[u8], newer: bool) -> Result<&'a [u8], RecordError> {
    let mut to = Cursor::new(data, FORMAT);
    let (address, length) = (to.u64()?, to.u64()?);
    let mut there = file.at(address)?;
    let block = there.take(usize::try_from(length).unwrap_or(usize::MAX))?;
    if !newer {
        return Ok(block);
    }
    // a mark before, a checksum after
    match block
        .strip_prefix(b"OCHK")
        .and_then(|b| b.get(..b.len().checked_sub(4)?))
    {
        Some(inner) => Ok(inner),
        None => Err(there.damaged(Damage::FurtherBlock)),
    }
}

/// Place of the numbers.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Layout<'a> {
    Within(&'a [u8]),
    At {
        address: u64,
        bytes: u64,
    },
    /// Sides of a chunk, and the tree of chunks.
    Chunks {
        sides: Vec<u32>,
        tree: u64,
    },
    /// Written by newer programs than MATLAB.
    Unknown,
}

/// The filters of chunks.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Filter {
    Deflate,
    Shuffle,
    Checksum,
    Unknown(u16),
}

/// A number and its byte order.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Stored {
    pub(super) number: Number,
    pub(super) big: bool,
}

/// The data in the messages of a variable.
pub(super) struct Object<'a> {
    pub(super) sides: Option<Vec<usize>>,
    pub(super) number: Option<Result<Stored, &'static str>>,
    pub(super) layout: Option<Layout<'a>>,
    pub(super) filters: Vec<Filter>,
    pub(super) class: String,
    pub(super) is_empty: bool,
}

impl<'a> Object<'a> {
    pub(super) fn of(messages: &[Message<'a>]) -> Result<Self, RecordError> {
        let mut object = Object {
            sides: None,
            number: None,
            layout: None,
            filters: Vec::new(),
            class: String::new(),
            is_empty: false,
        };
        for Message { sort, data } in messages {
            let mut cursor = Cursor::new(data, FORMAT);
            match sort {
                0x01 => object.sides = Some(sides(&mut cursor)?),
                0x03 => object.number = Some(number(&mut cursor)?),
                0x08 => object.layout = Some(layout(&mut cursor)?),
                0x0B => object.filters = filters(&mut cursor)?,
                0x0C => {
                    let (name, value) = attribute(&mut cursor)?;
                    match name.as_str() {
                        "MATLAB_class" => {
                            object.class = String::from_utf8_lossy(value).trim_end_matches('\0').to_owned();
                        }
                        "MATLAB_empty" => object.is_empty = value.iter().any(|b| *b != 0),
                        _ => {}
                    }
                }
                _ => {}
            }
        }
        Ok(object)
    }
}

fn sides(cursor: &mut Cursor) -> Result<Vec<usize>, RecordError> {
    let (version, rank) = (cursor.u8()?, cursor.u8()?);
    cursor.take(if version == 1 { 6 } else { 2 })?;
    let mut sides = Vec::new();
    for _ in 0..rank {
        let side = cursor.u64()?;
        sides.push(usize::try_from(side).map_err(|_| cursor.damaged(Damage::Side(side.to_string())))?);
    }
    Ok(sides)
}

/// Integers of 1 to 8 bytes and floats of 4 and 8; or a description of another type.
fn number(cursor: &mut Cursor) -> Result<Result<Stored, &'static str>, RecordError> {
    let class = cursor.u8()? & 0x0F;
    let bits = cursor.array::<3>()?;
    let bytes = cursor.u32()?;
    let big = bits[0] & 1 != 0;
    let stored = |number| Ok(Ok(Stored { number, big }));
    match class {
        0 => {
            let (offset, precision) = (cursor.u16()?, cursor.u16()?);
            if offset != 0 || u64::from(precision) != 8 * u64::from(bytes) {
                return Ok(Err("of odd integers"));
            }
            match (bytes, bits[0] & 0x08 != 0) {
                (1, true) => stored(Number::I8),
                (1, false) => stored(Number::U8),
                (2, true) => stored(Number::I16),
                (2, false) => stored(Number::U16),
                (4, true) => stored(Number::I32),
                (4, false) => stored(Number::U32),
                (8, true) => stored(Number::I64),
                (8, false) => stored(Number::U64),
                _ => Ok(Err("of odd integers")),
            }
        }
        1 => {
            let parts = cursor.array::<8>()?; // offset, precision, position and bits of exponent, position and bits of mantissa
            let bias = cursor.u32()?;
            match (bytes, parts, bias, bits[0] & 0x40) {
                (4, [0, 0, 32, 0, 23, 8, 0, 23], 127, 0) => stored(Number::F32),
                (8, [0, 0, 64, 0, 52, 11, 0, 52], 1023, 0) => stored(Number::F64),
                _ => Ok(Err("of odd floats")),
            }
        }
        3 => Ok(Err("text")),
        6 => Ok(Err("complex or struct")),
        7 => Ok(Err("cell")),
        _ => Ok(Err("no numbers")),
    }
}

fn layout<'a>(cursor: &mut Cursor<'a>) -> Result<Layout<'a>, RecordError> {
    let (version, class) = (cursor.u8()?, cursor.u8()?);
    // version 4 equals version 3, except for chunks
    Ok(match (version, class) {
        (3 | 4, 0) => {
            let length = cursor.u16()?;
            Layout::Within(cursor.take(length.into())?)
        }
        (3 | 4, 1) => Layout::At {
            address: cursor.u64()?,
            bytes: cursor.u64()?,
        },
        (3, 2) => {
            let rank = cursor.u8()?;
            let tree = cursor.u64()?;
            let sides = (0..rank).map(|_| cursor.u32()).collect::<Result<_, _>>()?;
            Layout::Chunks { sides, tree }
        }
        _ => Layout::Unknown,
    })
}

fn filters(cursor: &mut Cursor) -> Result<Vec<Filter>, RecordError> {
    let (version, count) = (cursor.u8()?, cursor.u8()?);
    let older = version == 1;
    cursor.take(if older { 6 } else { 0 })?;
    let mut found = Vec::new();
    for _ in 0..count {
        let id = cursor.u16()?;
        let name = usize::from(if older || id >= 256 { cursor.u16()? } else { 0 });
        cursor.take(2)?;
        let values = usize::from(cursor.u16()?);
        let name = if older { name.next_multiple_of(8) } else { name };
        let padding = if older && values % 2 == 1 { 4 } else { 0 };
        cursor.take(name + 4 * values + padding)?;
        found.push(match id {
            1 => Filter::Deflate,
            2 => Filter::Shuffle,
            3 => Filter::Checksum,
            other => Filter::Unknown(other),
        });
    }
    Ok(found)
}

/// Name and bytes of the value.
fn attribute<'a>(cursor: &mut Cursor<'a>) -> Result<(String, &'a [u8]), RecordError> {
    let version = cursor.u8()?;
    cursor.take(1)?;
    let sizes = [cursor.u16()?, cursor.u16()?, cursor.u16()?].map(usize::from);
    cursor.take(if version == 3 { 1 } else { 0 })?;
    let [name, of_type, space] = sizes.map(|size| match version {
        1 => size.next_multiple_of(8),
        _ => size,
    });
    let name = String::from_utf8_lossy(cursor.take(name)?)
        .trim_end_matches('\0')
        .to_owned();
    cursor.take(of_type + space)?;
    Ok((name, cursor.take(cursor.left())?))
}
