//! As much of HDF5 as MATLAB writes: the variables of the root group of a MAT file of version 7.3.
//!
//! | part | what |
//! |:--|:--|
//! | superblock | behind MATLAB's 512 bytes: where addresses count from, and the root group (hdf5_file.rs) |
//! | object header | messages of a group or a variable (hdf5_objects.rs) |
//! | symbol table | B-tree of nodes of names and addresses; the names stand in a heap |
//! | link | the same of one member, in newer files |
//!
//! A matrix of MATLAB stands with its sides turned round, so that its numbers follow column by column.
//!
//! Source: The HDF Group (2019) *HDF5 File Format Specification*, version 3.0.

use super::RecordError;
use super::cursor::Cursor;
use super::hdf5_data::values;
use super::hdf5_file::{FORMAT, File, NOWHERE, superblock};
use super::hdf5_objects::{Message, Object, messages};
use super::mat_elements::Matrix;

const SYMBOL_TABLE: u16 = 0x11;
const LINK: u16 = 0x06;
const LINK_INFO: u16 = 0x02;

/// The real numeric matrices of two dimensions, and the names of everything else.
pub(super) fn matrices(bytes: &[u8]) -> Result<(Vec<Matrix>, Vec<String>), RecordError> {
    let (file, root) = superblock(bytes)?;
    let (mut found, mut passed) = (Vec::new(), Vec::new());
    for (name, address) in members(&file, root)? {
        // what MATLAB keeps of cells and objects
        if name.starts_with('#') {
            continue;
        }
        let object = Object::of(&messages(&file, address)?)?;
        match variable(&file, &object)? {
            Ok((rows, columns, values)) => found.push(Matrix {
                name,
                rows,
                columns,
                values,
            }),
            Err(why) => passed.push(format!("{name} ({why})")),
        }
    }
    Ok((found, passed))
}

/// Names and addresses of the members of a group.
fn members(file: &File, group: u64) -> Result<Vec<(String, u64)>, RecordError> {
    let mut found = Vec::new();
    for Message { sort, data } in messages(file, group)? {
        let mut cursor = Cursor::new(data, FORMAT);
        match sort {
            SYMBOL_TABLE => {
                let (tree, heap) = (cursor.u64()?, cursor.u64()?);
                let mut nodes_left = file.parts_most(24);
                symbols(
                    file,
                    tree,
                    heap_data(file, heap)?,
                    None,
                    &mut nodes_left,
                    &mut found,
                )?;
            }
            LINK => found.extend(link(&mut cursor)?),
            LINK_INFO => {
                cursor.take(1)?;
                let flags = cursor.u8()?;
                cursor.take(if flags & 1 == 0 { 0 } else { 8 })?;
                if cursor.u64()? != NOWHERE {
                    return Err(RecordError::NotReadHere {
                        format: FORMAT,
                        what: "an HDF5 group with so many members that they stand apart".to_owned(),
                        instead: "save the record alone, or with save(\"file.mat\", \"-v7\")",
                    });
                }
            }
            _ => {}
        }
    }
    Ok(found)
}

/// Where the names of a group begin.
fn heap_data(file: &File, heap: u64) -> Result<u64, RecordError> {
    let mut cursor = file.at(heap)?;
    if cursor.take(4)? != b"HEAP" {
        return Err(cursor.damaged("a heap of names has no mark"));
    }
    cursor.take(20)?;
    cursor.u64()
}

/// The members below a node of the B-tree of a group; `level` is what the node above says.
fn symbols(
    file: &File,
    node: u64,
    names: u64,
    level: Option<u8>,
    nodes_left: &mut usize,
    found: &mut Vec<(String, u64)>,
) -> Result<(), RecordError> {
    let mut cursor = file.at(node)?;
    *nodes_left = nodes_left
        .checked_sub(1)
        .ok_or_else(|| cursor.damaged("the tree of names runs in a circle"))?;
    if level == Some(0) {
        if cursor.take(4)? != b"SNOD" {
            return Err(cursor.damaged("a node of names has no mark"));
        }
        cursor.take(2)?;
        for _ in 0..cursor.u16()? {
            let (name, address) = (cursor.u64()?, cursor.u64()?);
            cursor.take(24)?;
            found.push((text(file, names.saturating_add(name))?, address));
        }
        return Ok(());
    }
    let (head, own) = (cursor.take(5)?, cursor.u8()?);
    if head != b"TREE\0" || level.is_some_and(|level| own.checked_add(1) != Some(level)) {
        return Err(cursor.damaged("a node of the tree of names has no mark, or another level"));
    }
    let entries = cursor.u16()?;
    cursor.take(16 + 8)?;
    for _ in 0..entries {
        let child = cursor.u64()?;
        cursor.take(8)?;
        symbols(file, child, names, Some(own), nodes_left, found)?;
    }
    Ok(())
}

/// A text that ends with a zero.
fn text(file: &File, address: u64) -> Result<String, RecordError> {
    let mut cursor = file.at(address)?;
    let all = cursor.take(cursor.left())?;
    let end = all
        .iter()
        .position(|b| *b == 0)
        .ok_or_else(|| cursor.damaged("a name has no end"))?;
    Ok(String::from_utf8_lossy(&all[..end]).into_owned())
}

/// The member that a link leads to; `None` if it lies in another file or behind a name.
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
    let name = String::from_utf8_lossy(name).into_owned();
    Ok(if hard { Some((name, cursor.u64()?)) } else { None })
}

/// Rows, columns and numbers; or why a variable is no real numeric matrix.
type Numbers = Result<(usize, usize, Vec<f64>), &'static str>;

fn variable(file: &File, object: &Object) -> Result<Numbers, RecordError> {
    let (Some(sides), Some(number)) = (&object.sides, &object.number) else {
        return Ok(Err("struct or object"));
    };
    if object.is_empty || sides.contains(&0) {
        return Ok(Err("empty"));
    }
    if ["char", "cell"].contains(&object.class.as_str()) {
        return Ok(Err("text or cell"));
    }
    let number = match number {
        Ok(number) => *number,
        Err(why) => return Ok(Err(why)),
    };
    let (columns, rows) = match sides[..] {
        [rows] => (1, rows),
        [columns, rows] => (columns, rows),
        _ => return Ok(Err("not of two dimensions")),
    };
    Ok(Ok((
        rows,
        columns,
        values(file, object, number, [columns, rows])?,
    )))
}
