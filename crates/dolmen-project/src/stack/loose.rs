//! Loose stones: what the file may say about them, and the stack that settles.

use super::fault::StackFault;
use super::loose_material::loose_material;
use super::part::StackPart;
use crate::error::Fault;
use crate::file::FileRaw;
use crate::quantity::Pick;
use crate::reader::Reader;
use crate::wrong::WrongStack;
use dolmen::structure::stack::Stack;
use std::ops::Range;

impl StackPart {
    /// The loose stones at their places of the file, each input with the value that `pick` chooses.
    ///
    /// # Errors
    /// None with the file's own values, which are checked on reading; [`StackFault`] if picked ones are impossible.
    pub fn build_loose(&self, pick: Pick<'_>) -> Result<Stack, StackFault> {
        let blocks = self.placed_blocks(pick)?;
        let material = self.joint.over(loose_material(), pick);
        Stack::loose(blocks, material, self.gravity_m_s2).map_err(|why| self.locate(why))
    }
}

/// Reports keys that need joints or a fixed place, which loose stones do not have; false if there is one.
pub(super) fn refuse_of_loose(reader: &mut Reader, raw: &FileRaw, stack: &StackPart) -> bool {
    let mut given: Vec<(String, Range<usize>)> = Vec::new();
    let mut put = |key: &str, span: Option<&Range<usize>>| {
        given.extend(span.map(|span| (key.to_owned(), span.clone())));
    };
    put("pagoda", raw.pagoda.as_ref().map(|of| &of.span));
    put("arch", raw.arch.as_ref().map(|of| &of.span));
    put("wall", raw.wall.as_ref().map(|of| &of.span));
    put("tower", raw.tower.as_ref().map(|of| &of.span));
    put("trilithon", raw.trilithon.as_ref().map(|of| &of.span));
    put("vault", raw.vault.as_ref().map(|of| &of.span));
    put("dome", raw.dome.as_ref().map(|of| &of.span));
    put("soil", raw.soil.as_ref().map(|of| &of.span));
    put("wind", raw.wind.as_ref().map(|of| &of.span));
    put("loads", raw.loads.as_ref().map(|of| &of.span));
    put(
        "contacts",
        raw.contacts.iter().flatten().next().map(|of| &of.span),
    );
    put("ties", raw.ties.iter().flatten().next().map(|of| &of.span));
    put(
        "side_supports",
        raw.side_supports.iter().flatten().next().map(|of| &of.span),
    );
    put(
        "support_movement",
        raw.support_movement.iter().flatten().next().map(|of| &of.span),
    );
    let own = stack.blocks.iter().position(|block| block.joint.says_something());
    if let Some(block) = own {
        let path = format!("blocks[{}].joint", block + 1);
        let place = reader.place(&path);
        put(&path, Some(&place));
    }
    for (path, span) in &given {
        let fault = Fault::new(
            span.clone(),
            path,
            WrongStack::OfLooseStones { path: path.clone() },
        );
        reader.fault(fault.help(WrongStack::TakeOutOrNotLoose { path: path.clone() }));
    }
    given.is_empty()
}
