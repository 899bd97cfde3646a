//! Numbers of an HDF5 variable: stored in one piece, or joined from chunks.
//!
//! | part | what |
//! |:--|:--|
//! | node of chunks | a key and an address for each: bytes of the chunk, omitted filters, position |
//! | chunk | packed numbers of one part of the matrix; chunks at its ends exceed the matrix |

use super::RecordError;
use super::cursor::Cursor;
use super::hdf5_file::{FORMAT, File, NOWHERE, Unvisited};
use super::hdf5_objects::{Filter, Layout, Object, Stored};
use super::unpacked::Unpacker;
use crate::wrong::{Damage, Unread};
use std::borrow::Cow;
use std::collections::BTreeMap;

/// Largest expansion by deflate: a larger claim is damage.
const INFLATION_MOST: usize = 1032;

/// Size of the numbers of a variable in bytes, as doubles or unpacked, whichever is larger.
pub(super) fn unpacked_bytes(object: &Object, stored: Stored, whole: [usize; 2]) -> u64 {
    let [columns, rows] = whole.map(|side| side as u64);
    let numbers = columns.saturating_mul(rows);
    let doubles = numbers.saturating_mul(8);
    match &object.layout {
        Some(Layout::Chunks { sides, .. }) => {
            let chunk = match sides[..] {
                [rows, _] => [1, rows.max(1)],
                [columns, rows, _] => [columns.max(1), rows.max(1)],
                _ => return doubles,
            };
            let [chunk_columns, chunk_rows] = chunk.map(u64::from);
            let chunks = columns
                .div_ceil(chunk_columns)
                .saturating_mul(rows.div_ceil(chunk_rows));
            let of_one = chunk_columns
                .saturating_mul(chunk_rows)
                .saturating_mul(stored.number.bytes() as u64);
            doubles.max(chunks.saturating_mul(of_one))
        }
        // unpacked data must have the stated length
        _ => 0,
    }
}

/// All numbers, with the last dimension fastest.
pub(super) fn values(
    file: &File,
    object: &Object,
    stored: Stored,
    [columns, rows]: [usize; 2],
    unvisited: &mut Unvisited,
) -> Result<Vec<f64>, RecordError> {
    let here = Cursor::new(&[], FORMAT);
    let count = columns
        .checked_mul(rows)
        .ok_or_else(|| here.damaged(Damage::MatrixNumbers { rows, columns }))?;
    let refused = |what: Unread| {
        Err(RecordError::NotReadHere {
            format: FORMAT,
            what: what.into(),
            instead: Unread::SaveV7.into(),
        })
    };
    let numbers = |cursor: Cursor| stored.number.series(&mut cursor.ordered(stored.big), count);
    match &object.layout {
        Some(Layout::Within(data)) => numbers(Cursor::new(data, FORMAT)),
        Some(Layout::At { address, bytes }) => {
            let mut cursor = file.at(*address)?;
            if *bytes != (count as u64).saturating_mul(stored.number.bytes() as u64) {
                return Err(cursor.damaged(Damage::BytesHold {
                    bytes: *bytes,
                    rows,
                    columns,
                }));
            }
            let data = cursor.take(usize::try_from(*bytes).unwrap_or(usize::MAX))?;
            unvisited.numbers(data.len(), &cursor)?;
            numbers(Cursor::new(data, FORMAT))
        }
        Some(Layout::Chunks { sides, tree }) => {
            if object.filters.iter().any(|f| matches!(f, Filter::Unknown(_))) {
                return refused(Unread::OtherFilter);
            }
            if (1..object.filters.len()).any(|k| object.filters[k..].contains(&object.filters[k - 1])) {
                return Err(here.damaged(Damage::FilterTwice));
            }
            // one dimension is a matrix of one column
            let sides: Vec<usize> = sides.iter().map(|side| *side as usize).collect();
            let (chunk, rank) = match sides[..] {
                [rows, _] => ([1, rows], 1),
                [columns, rows, _] => ([columns, rows], 2),
                _ => return Err(here.damaged(Damage::ChunkSides)),
            };
            if sides.last() != Some(&stored.number.bytes()) || chunk.contains(&0) {
                return Err(here.damaged(Damage::ChunkSize));
            }
            let mut chunks = BTreeMap::new();
            chunks_below(file, *tree, rank, None, unvisited, &mut chunks)?;
            Chunked {
                file,
                filters: &object.filters,
                stored,
                whole: [columns, rows],
                chunk,
            }
            .together(&chunks, unvisited)
        }
        Some(Layout::Unknown) | None => refused(Unread::OtherLayout),
    }
}

/// Position and length of a chunk.
struct Place {
    address: u64,
    bytes: u32,
    /// Bit k: filter k was left out.
    left_out: u32,
}

/// The chunks below a node, by their positions.
fn chunks_below(
    file: &File,
    node: u64,
    rank: usize,
    level: Option<u8>,
    unvisited: &mut Unvisited,
    found: &mut BTreeMap<[u64; 2], Place>,
) -> Result<(), RecordError> {
    if node == NOWHERE {
        return Ok(()); // no data were written
    }
    let mut cursor = file.at(node)?;
    unvisited.node(&cursor)?;
    let (head, own) = (cursor.take(5)?, cursor.u8()?);
    if head != b"TREE\x01" || level.is_some_and(|level| own.checked_add(1) != Some(level)) {
        return Err(cursor.damaged(Damage::ChunkTree));
    }
    let entries = cursor.u16()?;
    cursor.take(16)?;
    for _ in 0..entries {
        unvisited.node(&cursor)?;
        let (bytes, left_out) = (cursor.u32()?, cursor.u32()?);
        let begins = match rank {
            1 => [0, cursor.u64()?],
            _ => [cursor.u64()?, cursor.u64()?],
        };
        cursor.take(8)?;
        let address = cursor.u64()?;
        if own > 0 {
            chunks_below(file, address, rank, Some(own), unvisited, found)?;
        } else if found
            .insert(
                begins,
                Place {
                    address,
                    bytes,
                    left_out,
                },
            )
            .is_some()
        {
            return Err(cursor.damaged(Damage::ChunksMeet));
        }
    }
    Ok(())
}

/// A matrix in chunks; slower dimension first.
struct Chunked<'a> {
    file: &'a File<'a>,
    filters: &'a [Filter],
    stored: Stored,
    whole: [usize; 2],
    chunk: [usize; 2],
}

impl Chunked<'_> {
    fn together(
        &self,
        chunks: &BTreeMap<[u64; 2], Place>,
        unvisited: &mut Unvisited,
    ) -> Result<Vec<f64>, RecordError> {
        let here = Cursor::new(&[], FORMAT);
        let [columns, rows] = self.whole;
        let needed = columns
            .div_ceil(self.chunk[0])
            .checked_mul(rows.div_ceil(self.chunk[1]));
        if needed != Some(chunks.len()) {
            return Err(here.damaged(Damage::ChunksMissing {
                rows,
                columns,
                chunks: chunks.len(),
                high: self.chunk[1],
                wide: self.chunk[0],
            }));
        }
        for place in chunks.values() {
            unvisited.numbers(place.bytes as usize, &here)?;
        }
        let mut unpacker = Unpacker::new();
        let mut out = vec![0.0; columns * rows];
        for (begins, place) in chunks {
            let [from_column, from_row] = begins.map(|x| usize::try_from(x).unwrap_or(usize::MAX));
            let aligned = from_column % self.chunk[0] == 0 && from_row % self.chunk[1] == 0;
            if !aligned || from_column >= columns || from_row >= rows {
                return Err(here.damaged(Damage::ChunkPlace));
            }
            let numbers = self.numbers(place, &mut unpacker)?;
            let count = self.chunk[1].min(rows - from_row);
            let targets = out.chunks_exact_mut(rows).skip(from_column);
            for (target, part) in targets.zip(numbers.chunks_exact(self.chunk[1])) {
                target[from_row..from_row + count].copy_from_slice(&part[..count]);
            }
        }
        Ok(out)
    }

    /// The numbers of one chunk.
    fn numbers(&self, place: &Place, unpacker: &mut Unpacker) -> Result<Vec<f64>, RecordError> {
        let mut cursor = self.file.at(place.address)?;
        let packed = cursor.take(place.bytes as usize)?;
        let size = self.stored.number.bytes();
        let count = self.chunk[0].saturating_mul(self.chunk[1]);
        let whole = count.saturating_mul(size);
        if whole > packed.len().saturating_mul(INFLATION_MOST) {
            return Err(cursor.damaged(Damage::ChunkPacked {
                whole,
                packed: packed.len(),
            }));
        }
        let mut data = Cow::Borrowed(packed);
        for (k, filter) in self.filters.iter().enumerate().rev() {
            if k < 32 && place.left_out >> k & 1 == 1 {
                continue;
            }
            data = match filter {
                Filter::Checksum => {
                    // the last four bytes are a checksum that is not needed
                    let kept = data.len().saturating_sub(4);
                    match data {
                        Cow::Borrowed(data) => Cow::Borrowed(&data[..kept]),
                        Cow::Owned(mut data) => {
                            data.truncate(kept);
                            Cow::Owned(data)
                        }
                    }
                }
                Filter::Deflate => Cow::Owned(
                    unpacker
                        .whole(&data, whole + 4)
                        .map_err(|why| cursor.damaged(Damage::ChunkDoesNotUnpack(why.into())))?,
                ),
                Filter::Shuffle => Cow::Owned(unshuffled(&data, size)),
                Filter::Unknown(_) => data,
            };
        }
        if data.len() != whole {
            return Err(cursor.damaged(Damage::ChunkUnpacks {
                whole,
                unpacked: data.len(),
            }));
        }
        let mut numbers = Cursor::new(&data, FORMAT).ordered(self.stored.big);
        self.stored.number.series(&mut numbers, count)
    }
}

/// Restores numbers from bytes in the order: all first bytes, then all second ones …
fn unshuffled(data: &[u8], size: usize) -> Vec<u8> {
    let count = data.len() / size;
    let mut out = data.to_vec();
    for (k, bytes) in data.chunks_exact(count.max(1)).take(size).enumerate() {
        for (target, byte) in out.iter_mut().skip(k).step_by(size).zip(bytes) {
            *target = *byte;
        }
    }
    out
}
