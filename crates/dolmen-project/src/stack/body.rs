//! Blocks of a stack by their names.

use super::file::BlockRaw;
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::wrong::{Common, WrongStack};
use dolmen::structure::stack::Body;
use dolmen_words::message::Both;
use dolmen_words::nearest;
use std::ops::Range;

/// The word for the ground, on which everything stands in the end.
pub(super) const GROUND: &str = "ground";

/// The names of all blocks; missing, empty and repeated ones are reported.
pub(super) fn names(reader: &mut Reader, blocks: &[At<BlockRaw>]) -> Vec<String> {
    let mut names: Vec<String> = Vec::with_capacity(blocks.len());
    for (i, block) in blocks.iter().enumerate() {
        let path = format!("blocks[{}].name", i + 1);
        let Some(name) = &block.value.name else {
            names.push(String::new());
            continue;
        };
        let fault = |message: WrongStack| Fault::new(name.span.clone(), &path, message);
        if name.value.trim().is_empty() || name.value == GROUND {
            let fault = fault(WrongStack::CannotBe {
                path: path.to_string(),
                name: name.value.to_string(),
            });
            reader.fault(fault.allowed(WrongStack::NeedsNameOtherThan));
        } else if let Some(other) = names.iter().position(|other| *other == name.value) {
            let fault = fault(WrongStack::IsAlsoNameOf {
                path: path.to_string(),
                name: name.value.to_string(),
                other: (other + 1).to_string(),
            });
            reader.fault(
                fault
                    .allowed(WrongStack::MustBeUnique)
                    .help(WrongStack::NumberThemBodyBody),
            );
        }
        names.push(name.value.clone());
    }
    names
}

/// Whether a body may be the ground.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MayBeGround {
    Yes,
    No,
}

/// The body with a name among `known`; `place` is the place of the name, and `ground` whether it may be the ground.
pub(super) fn body(
    reader: &mut Reader,
    name: &str,
    place: (&Range<usize>, &str),
    known: &[String],
    ground: MayBeGround,
) -> Option<Body> {
    if name == GROUND {
        return Some(Body::Ground);
    }
    if let Some(index) = known.iter().position(|known| known == name) {
        return Some(Body::Block(index));
    }
    let (span, path) = place;
    let fault = Fault::new(
        span.clone(),
        path,
        WrongStack::IsNo {
            path: path.to_string(),
            name: name.to_string(),
            which: WrongStack::OfBlock.into(),
        },
    );
    let help: Both = match nearest(name, known.iter().map(String::as_str)) {
        Some(near) => Common::DidYouMean(near.to_string()).into(),
        None => match ground {
            MayBeGround::Yes => WrongStack::WriteNameOfBlock {
                ground: GROUND.to_string(),
            },
            MayBeGround::No => WrongStack::WriteNameOfABlock,
        }
        .into(),
    };
    reader.fault(fault.allowed(WrongStack::UnknownName).help(help));
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
    match body(reader, &name.value, (&name.span, path), known, MayBeGround::No)? {
        Body::Block(index) => Some(index),
        Body::Ground => {
            let fault = Fault::new(
                name.span.clone(),
                path,
                WrongStack::Is {
                    path: path.to_string(),
                    ground: GROUND.to_string(),
                },
            );
            reader.fault(fault.allowed(WrongStack::MustBeNameOf));
            None
        }
    }
}
