//! The part of HDF5 that MATLAB writes: the variables of the root group of a MAT file of version 7.3.
//!
//! | part | what |
//! |:--|:--|
//! | superblock | after MATLAB's 512 bytes: origin of addresses, and the root group (hdf5_file.rs) |
//! | object header | messages of a group or a variable (hdf5_objects.rs) |
//! | symbol table | B-tree of nodes with names and addresses; the names are in a heap |
//! | link | the same for one member, in newer files |
//!
//! MATLAB stores matrices transposed, so that their numbers are in column order.
//!
//! Source: The HDF Group (2019) *HDF5 File Format Specification*, version 3.0.

use super::RecordError;
use super::cursor::Cursor;
use super::hdf5_data::{unpacked_bytes, values};
use super::hdf5_file::{FORMAT, File, NOWHERE, Unvisited, superblock};
use super::hdf5_objects::{Message, Object, Stored, messages};
use super::mat_elements::{Matrix, is_wanted, refuse_expansion};
use crate::limits::{PARTS_MOST, refuse_parts};
use crate::quoted::shown;
use crate::wrong::{Damage, Unread};

const SYMBOL_TABLE: u16 = 0x11;
const LINK: u16 = 0x06;
const LINK_INFO: u16 = 0x02;
/// Longest name, bytes. Our choice: MATLAB's have 63 letters.
const NAME_BYTES: usize = 4096;

/// A variable whose numbers are not read yet.
struct Variable<'a> {
    name: String,
    rows: usize,
    columns: usize,
    stored: Stored,
    object: Object<'a>,
}

/// The real numeric matrices of two dimensions, and the names of everything else. Only the data of a record are read.
pub(super) fn matrices(bytes: &[u8]) -> Result<(Vec<Matrix>, Vec<String>), RecordError> {
    let (file, root) = superblock(bytes)?;
    let mut unvisited = Unvisited::new(&file);
    let (mut variables, mut passed) = (Vec::new(), Vec::new());
    for (name, address) in members(&file, root, &mut unvisited)? {
        // MATLAB's data of cells and objects
        if name.starts_with('#') {
            continue;
        }
        let object = Object::of(&messages(&file, address, &mut unvisited)?)?;
        match shape(&object) {
            Ok((rows, columns, stored)) => variables.push(Variable {
                name,
                rows,
                columns,
                stored,
                object,
            }),
            Err(why) => passed.push(format!("{name} ({why})")),
        }
    }
    let samples = variables.iter().map(|v| v.rows.max(v.columns)).max().unwrap_or(0);
    let wanted = |v: &Variable| is_wanted([v.rows, v.columns], samples);
    let unpacked = variables
        .iter()
        .filter(|v| wanted(v))
        .map(|v| unpacked_bytes(&v.object, v.stored, [v.columns, v.rows]));
    refuse_expansion(bytes.len(), unpacked.fold(0, u64::saturating_add))?;
    let mut found = Vec::with_capacity(variables.len());
    for variable in variables {
        let values = match wanted(&variable) {
            true => {
                let Variable {
                    rows,
                    columns,
                    stored,
                    object,
                    ..
                } = &variable;
                values(&file, object, *stored, [*columns, *rows], &mut unvisited)?
            }
            false => Vec::new(),
        };
        found.push(Matrix {
            name: variable.name,
            rows: variable.rows,
            columns: variable.columns,
            values,
        });
    }
    Ok((found, passed))
}

/// Names and addresses of the members of a group.
fn members(file: &File, group: u64, unvisited: &mut Unvisited) -> Result<Vec<(String, u64)>, RecordError> {
    let mut found = Vec::new();
    for Message { sort, data } in messages(file, group, unvisited)? {
        let mut cursor = Cursor::new(data, FORMAT);
        match sort {
            SYMBOL_TABLE => {
                let (tree, heap) = (cursor.u64()?, cursor.u64()?);
                let names = heap_data(file, heap)?;
                symbols(file, tree, names, None, unvisited, &mut found)?;
            }
            LINK => {
                found.extend(link(&mut cursor)?);
                refuse_parts(FORMAT, Unread::Variables, found.len(), PARTS_MOST)?;
            }
            LINK_INFO => {
                cursor.take(1)?;
                let flags = cursor.u8()?;
                cursor.take(if flags & 1 == 0 { 0 } else { 8 })?;
                if cursor.u64()? != NOWHERE {
                    return Err(RecordError::NotReadHere {
                        format: FORMAT,
                        what: Unread::LargeGroup.into(),
                        instead: Unread::SaveAlone.into(),
                    });
                }
            }
            _ => {}
        }
    }
    Ok(found)
}

/// Position of the names of a group.
fn heap_data(file: &File, heap: u64) -> Result<u64, RecordError> {
    let mut cursor = file.at(heap)?;
    if cursor.take(4)? != b"HEAP" {
        return Err(cursor.damaged(Damage::HeapOfNames));
    }
    cursor.take(20)?;
    cursor.u64()
}

/// The members below a node of the B-tree of a group; `level` is stated by the node above.
fn symbols(
    file: &File,
    node: u64,
    names: u64,
    level: Option<u8>,
    unvisited: &mut Unvisited,
    found: &mut Vec<(String, u64)>,
) -> Result<(), RecordError> {
    let mut cursor = file.at(node)?;
    unvisited.node(&cursor)?;
    if level == Some(0) {
        if cursor.take(4)? != b"SNOD" {
            return Err(cursor.damaged(Damage::NodeOfNames));
        }
        cursor.take(2)?;
        for _ in 0..cursor.u16()? {
            let (name, address) = (cursor.u64()?, cursor.u64()?);
            cursor.take(24)?;
            found.push((text(file, names.saturating_add(name))?, address));
            refuse_parts(FORMAT, Unread::Variables, found.len(), PARTS_MOST)?;
        }
        return Ok(());
    }
    let (head, own) = (cursor.take(5)?, cursor.u8()?);
    if head != b"TREE\0" || level.is_some_and(|level| own.checked_add(1) != Some(level)) {
        return Err(cursor.damaged(Damage::TreeOfNames));
    }
    let entries = cursor.u16()?;
    cursor.take(16 + 8)?;
    for _ in 0..entries {
        let child = cursor.u64()?;
        cursor.take(8)?;
        symbols(file, child, names, Some(own), unvisited, found)?;
    }
    Ok(())
}

/// A text that ends with a zero.
fn text(file: &File, address: u64) -> Result<String, RecordError> {
    let mut cursor = file.at(address)?;
    let all = cursor.take(cursor.left().min(NAME_BYTES))?;
    let end = all
        .iter()
        .position(|b| *b == 0)
        .ok_or_else(|| cursor.damaged(Damage::NameWithoutEnd))?;
    Ok(shown(&String::from_utf8_lossy(&all[..end])))
}

/// The target of a link; `None` if it is in another file, or is a symbolic link.
fn link(cursor: &mut Cursor) -> Result<Option<(String, u64)>, RecordError> {
    cursor.take(1)?;
    let flags = cursor.u8()?;
    let hard = flags & 0x08 == 0 || cursor.u8()? == 0;
    cursor.take(if flags & 0x04 == 0 { 0 } else { 8 } + if flags & 0x10 == 0 { 0 } else { 1 })?;
    let length = match flags & 3 {
        0 => u64::from(cursor.u8()?),
        1 => u64::from(cursor.u16()?),
        2 => u64::from(cursor.u32()?),
        _ => cursor.u64()?,
    };
    let name = cursor.take(usize::try_from(length).unwrap_or(usize::MAX))?;
    let name = shown(&String::from_utf8_lossy(name));
    Ok(if hard { Some((name, cursor.u64()?)) } else { None })
}

/// Rows, columns and encoding of numbers; or why a variable is not a real numeric matrix.
fn shape(object: &Object) -> Result<(usize, usize, Stored), &'static str> {
    let (Some(sides), Some(number)) = (&object.sides, &object.number) else {
        return Err("struct or object");
    };
    if object.is_empty || sides.contains(&0) {
        return Err("empty");
    }
    if ["char", "cell"].contains(&object.class.as_str()) {
        return Err("text or cell");
    }
    let stored = (*number)?;
    match sides[..] {
        [rows] => Ok((rows, 1, stored)),
        [columns, rows] => Ok((rows, columns, stored)),
        _ => Err("not of two dimensions"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    const PACKED: &[u8] = include_bytes!("../../tests/data/records/hdf5_packed.mat");

    /// The file with another length of its longest variables.
    fn stated(samples: u64) -> Vec<u8> {
        let mut bytes = PACKED.to_vec();
        let sides = [2u64.to_le_bytes(), 96u64.to_le_bytes()].concat();
        let places: Vec<usize> = (0..bytes.len() - 16)
            .filter(|at| bytes[*at..at + 16] == sides)
            .collect();
        for at in places {
            bytes[at + 8..at + 16].copy_from_slice(&samples.to_le_bytes());
        }
        bytes
    }

    #[test]
    fn refuses_a_variable_that_states_gigabytes() {
        assert!(matrices(PACKED).is_ok());
        let said = matrices(&stated(1 << 40)).unwrap_err().to_string();
        assert!(
            said.starts_with(&format!("the mat file of {} bytes unpacks to 1759", PACKED.len()))
                && said.contains("but at most 104857600 are unpacked of it"),
            "{said}"
        );
        // within the limit, there must be as many chunks
        let said = matrices(&stated(1 << 20)).unwrap_err().to_string();
        assert!(said.contains("a part was never written"), "{said}");
    }

    #[test]
    fn refuses_a_chunk_that_unpacks_to_more_than_its_sides_say() {
        // the first chunk of each tree replaced by 64 MiB of zeros, packed, at the end of the file
        let bomb = miniz_oxide::deflate::compress_to_vec_zlib(&vec![0; 64 << 20], 9);
        assert!(bomb.len() < 100_000);
        let mut bytes = PACKED.to_vec();
        let trees: Vec<usize> = (0..bytes.len() - 6)
            .filter(|at| bytes[*at..at + 6] == *b"TREE\x01\0")
            .collect();
        assert!(!trees.is_empty());
        let address = (bytes.len() - 512) as u64;
        for at in trees {
            let entry = at + 24; // bytes, omitted filters, position, element, address
            bytes[entry..entry + 4].copy_from_slice(&(bomb.len() as u32).to_le_bytes());
            bytes[entry + 32..entry + 40].copy_from_slice(&address.to_le_bytes());
        }
        bytes.extend(&bomb);
        let said = matrices(&bytes).unwrap_err().to_string();
        assert!(said.contains("it holds more than it says"), "{said}");
    }

    #[test]
    fn refuses_parts_that_lie_on_one_another() {
        let (file, _) = superblock(PACKED).unwrap();
        let here = file.at(0).unwrap();
        let mut unvisited = Unvisited::new(&file);
        assert!(unvisited.numbers(PACKED.len(), &here).is_ok());
        let said = unvisited.numbers(1, &here).unwrap_err().to_string();
        assert!(
            said.contains("numbers of variables run in a circle, or lie on one another"),
            "{said}"
        );
        assert!(unvisited.header(PACKED.len() + 1, &here).is_err());
        assert!((0..PACKED.len()).any(|_| unvisited.node(&here).is_err()));
    }
}
