//! The bytes of an HDF5 file, and its addresses.

use super::RecordError;
use super::cursor::Cursor;
use crate::wrong::Damage;

pub(super) const FORMAT: &str = "mat";
const SIGNATURE: &[u8] = b"\x89HDF\r\n\x1a\n";
/// The undefined address.
pub(super) const NOWHERE: u64 = u64::MAX;

/// The bytes of a file and the origin of its addresses.
#[derive(Clone, Copy)]
pub(super) struct File<'a> {
    bytes: &'a [u8],
    base: u64,
}

impl<'a> File<'a> {
    /// A cursor at an address.
    pub(super) fn at(&self, address: u64) -> Result<Cursor<'a>, RecordError> {
        let mut cursor = Cursor::new(self.bytes, FORMAT);
        let place = address
            .checked_add(self.base)
            .and_then(|x| usize::try_from(x).ok());
        match place {
            Some(place) if address != NOWHERE => cursor.go(place)?,
            _ => {
                return Err(cursor.damaged(Damage::Address(format!("{address:#x}"))));
            }
        }
        Ok(cursor)
    }

    /// Bytes of the whole file.
    pub(super) fn length(&self) -> usize {
        self.bytes.len()
    }
}

/// Remaining amounts to visit: every byte belongs to one part, so that parts with a larger total are visited twice.
pub(super) struct Unvisited {
    /// Bytes of headers of objects.
    headers: usize,
    /// Nodes of trees and their entries.
    nodes: usize,
    /// Bytes of numbers.
    numbers: usize,
}

/// The shortest node of a tree, and its shortest entry.
const NODE_BYTES: usize = 24;

impl Unvisited {
    pub(super) fn new(file: &File) -> Self {
        Unvisited {
            headers: file.length(),
            nodes: file.length() / NODE_BYTES,
            numbers: file.length(),
        }
    }

    pub(super) fn header(&mut self, bytes: usize, here: &Cursor) -> Result<(), RecordError> {
        visit(&mut self.headers, bytes, here, Damage::HeadersOfObjects)
    }

    pub(super) fn node(&mut self, here: &Cursor) -> Result<(), RecordError> {
        visit(&mut self.nodes, 1, here, Damage::Trees)
    }

    pub(super) fn numbers(&mut self, bytes: usize, here: &Cursor) -> Result<(), RecordError> {
        visit(&mut self.numbers, bytes, here, Damage::NumbersOfVariables)
    }
}

fn visit(left: &mut usize, count: usize, here: &Cursor, what: Damage) -> Result<(), RecordError> {
    *left = left
        .checked_sub(count)
        .ok_or_else(|| here.damaged(Damage::Circle(what.into())))?;
    Ok(())
}

/// The file, and the address of the header of its root group.
pub(super) fn superblock(bytes: &[u8]) -> Result<(File<'_>, u64), RecordError> {
    let mut cursor = Cursor::new(bytes, FORMAT);
    let mut place = 512;
    // 512, 1024, 2048 …
    while bytes.get(place..place + SIGNATURE.len()) != Some(SIGNATURE) {
        cursor.go(place)?;
        place *= 2;
        if place > bytes.len() {
            return Err(cursor.damaged(Damage::NoHdf5));
        }
    }
    cursor.go(place + SIGNATURE.len())?;
    let version = cursor.u8()?;
    let sizes = match version {
        0 | 1 => {
            cursor.take(4)?;
            let sizes = cursor.array::<2>()?;
            cursor.take(if version == 0 { 9 } else { 13 })?;
            sizes
        }
        2 | 3 => {
            let sizes = cursor.array::<2>()?;
            cursor.take(1)?;
            sizes
        }
        _ => return Err(cursor.damaged(Damage::FirstBlock(version))),
    };
    if sizes != [8, 8] {
        return Err(cursor.damaged(Damage::AddressSizes));
    }
    let base = cursor.u64()?;
    cursor.u64()?;
    let end = cursor.u64()?;
    // of the whole file with MATLAB's bytes: a cut file is detected before anything is read
    let end = usize::try_from(end).unwrap_or(usize::MAX);
    Cursor::new(bytes, FORMAT).go(end)?;
    let root = if version < 2 {
        cursor.take(16)?; // driver, and the name of the root
        cursor.u64()?
    } else {
        cursor.u64()?
    };
    Ok((File { bytes, base }, root))
}
