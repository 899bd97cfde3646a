//! Blocks of a stack by their names.

use super::file::BlockRaw;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use dolmen::structure::stack::Body;
use dolmen_words::nearest;
use std::ops::Range;

/// The word for what everything stands on in the end.
pub(super) const GROUND: &str = "ground";

/// The names of all blocks; one that is missing, empty or repeated is reported.
pub(super) fn names(reader: &mut Reader, blocks: &[At<BlockRaw>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(blocks.len());
    for (i, block) in blocks.iter().enumerate() {
        let path = format!("blocks[{}].name", i + 1);
        let Some(name) = &block.value.name else {
            names.push(String::new());
            continue;
        };
        let fault = |message: String| Fault::new(name.span.clone(), &path, message);
        if name.value.trim().is_empty() || name.value == GROUND {
            let fault = fault(format!("{path} = \"{}\" cannot be", name.value));
            reader.fault(fault.allowed("needs a name other than \"ground\""));
        } else if let Some(other) = names.iter().position(|other| *other == name.value) {
            let fault = fault(format!(
                "{path} = \"{}\" is also the name of blocks[{}]",
                name.value,
                other + 1
            ));
            reader.fault(
                fault
                    .allowed("must be unique")
                    .help("number them: \"body 1\", \"body 2\""),
            );
        }
        names.push(name.value.clone());
    }
    names
}

/// The body of a name among `known`; `place` says where it is written.
pub(super) fn body(
    reader: &mut Reader,
    name: &str,
    place: (&Range<usize>, &str),
    known: &[String],
    which: &str,
) -> Option<Body> {
    if name == GROUND {
        return Some(Body::Ground);
    }
    if let Some(index) = known.iter().position(|known| known == name) {
        return Some(Body::Block(index));
    }
    let (span, path) = place;
    let fault = Fault::new(span.clone(), path, format!("{path} = \"{name}\" is no {which}"));
    let help = match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => format!("did you mean \"{near}\"?"),
        None => format!("write the name of a block as it stands in blocks, or \"{GROUND}\""),
    };
    reader.fault(fault.allowed("unknown name").help(help));
    None
}

/// The index of a block by its name.
pub(super) fn block_index(
    reader: &mut Reader,
    name: Option<&At<String>>,
    path: &str,
    known: &[String],
) -> Option<usize> {
    let name = name?;
    match body(reader, &name.value, (&name.span, path), known, "block")? {
        Body::Block(index) => Some(index),
        Body::Ground => {
            let fault = Fault::new(name.span.clone(), path, format!("{path} is \"{GROUND}\""));
            reader.fault(fault.allowed("must be the name of a block"));
            None
        }
    }
}
