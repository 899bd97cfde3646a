//! Reads one block of a stack: its shape and its supports.

use super::attached::{cornice, mast};
use super::bed::bed;
use super::body::{MayBeGround, body};
use super::file::{BlockRaw, OnRaw, OpeningRaw};
use super::part::{BlockPart, OpeningPart, ShapePart};
use super::shape::{MeshContact, shape};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::{lengths, listed};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::{Common, WrongStack};
use dolmen::structure::stack::Body;

/// One block with its supports.
pub(super) fn block(
    reader: &mut Reader,
    raw: &At<BlockRaw>,
    index: usize,
    names: &[String],
    contact: MeshContact,
) -> Option<BlockPart> {
    let path = format!("blocks[{}]", index + 1);
    reader.mark(&path, &raw.span);
    let block = &raw.value;
    let shape = shape(reader, raw, &path, &names[index], contact);
    let density_path = format!("{path}.density");
    let density = reader.quantity(
        block.density.as_ref(),
        &density_path,
        Measure::Density,
        Bound::Positive,
    );
    let openings = listed(
        reader,
        block.openings.as_deref(),
        &format!("{path}.openings"),
        opening,
    );
    let cornice = cornice(reader, block, &path, shape.as_ref());
    let mast = mast(reader, block.mast.as_ref(), &path);
    let on = on(
        reader,
        block,
        index,
        names,
        shape.as_ref().is_some_and(ShapePart::keeps_its_place),
    );
    let at = plan(reader, block.at.as_ref(), &format!("{path}.at"));
    let offset = plan(reader, block.offset.as_ref(), &format!("{path}.offset"));
    let rotation_path = format!("{path}.rotation");
    let rotation = reader.quantity(
        block.rotation.as_ref(),
        &rotation_path,
        Measure::Angle,
        Bound::Any,
    );
    let lean = block.tilt.as_ref().map(|lean| &lean.value);
    let along_x = lean.and_then(|lean| lean.x.as_ref());
    let along_y = lean.and_then(|lean| lean.y.as_ref());
    let tilt = [("x", along_x), ("y", along_y)].map(|(key, raw)| {
        let path = format!("{path}.tilt.{key}");
        reader.quantity(raw, &path, Measure::Tilt, Bound::Any)
    });
    let joint = bed(reader, block.joint.as_ref(), &format!("{path}.joint"));
    Some(BlockPart {
        name: names[index].clone(),
        shape: shape?,
        openings: openings?,
        cornice: cornice?,
        mast: mast?,
        density,
        on: on?,
        at: at?,
        offset: offset?,
        rotation,
        tilt,
        joint: joint?,
    })
}

fn opening(reader: &mut Reader, raw: &At<OpeningRaw>, path: &str) -> Option<OpeningPart> {
    let opening = &raw.value;
    let before = reader.faults.len();
    let mut of = |raw: &Option<At<QuantityRaw>>, key: &str| {
        let path = format!("{path}.{key}");
        reader.quantity(raw.as_ref(), &path, Measure::Length, Bound::Positive)
    };
    let (width, depth, height) = (
        of(&opening.width, "width"),
        of(&opening.depth, "depth"),
        of(&opening.height, "height"),
    );
    let position_path = format!("{path}.position");
    let position = opening
        .position
        .as_ref()
        .and_then(|raw| lengths(reader, raw, &position_path, "[x, y, z]"));
    (reader.faults.len() == before).then_some(())?;
    Some(OpeningPart {
        width: width?,
        depth,
        height: height?,
        position: position?,
    })
}

/// The supports of a block: those of the file, else the block before it, else the ground; a block that keeps its place
/// stands on whatever it touches.
fn on(
    reader: &mut Reader,
    block: &BlockRaw,
    index: usize,
    names: &[String],
    keeps_its_place: bool,
) -> Option<Vec<Body>> {
    let Some(on) = &block.on else {
        return Some(match keeps_its_place {
            true => Vec::new(),
            false => vec![index.checked_sub(1).map_or(Body::Ground, Body::Block)],
        });
    };
    let path = format!("blocks[{}].on", index + 1);
    let given: Vec<&str> = match &on.value {
        OnRaw::One(name) => vec![name],
        OnRaw::Several(names) => names.iter().map(String::as_str).collect(),
    };
    if given.is_empty() {
        let fault = Fault::new(on.span.clone(), &path, Common::IsEmpty(path.to_string()));
        reader.fault(fault.allowed(WrongStack::NeedsNameOfBlock));
        return None;
    }
    let mut bodies = Vec::with_capacity(given.len());
    for name in given {
        if name == names[index] {
            let message = WrongStack::IsBlockItself {
                path: path.to_string(),
                name: name.to_string(),
            };
            let fault = Fault::new(on.span.clone(), &path, message);
            reader.fault(fault.allowed(WrongStack::NeedsNameOfAnother));
            return None;
        }
        bodies.push(body(reader, name, (&on.span, &path), names, MayBeGround::Yes)?);
    }
    Some(bodies)
}

/// Two lengths in plan; `None` if they are wrong, `Some(None)` if they are not given.
fn plan(
    reader: &mut Reader,
    raw: Option<&At<Vec<At<QuantityRaw>>>>,
    path: &str,
) -> Option<Option<[Quantity; 2]>> {
    let Some(raw) = raw else { return Some(None) };
    lengths(reader, raw, path, "[x, y]").map(Some)
}
