//! One block of a stack from what is written: its shape, and what it stands on.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::file_stack::{BlockRaw, OnRaw, OpeningRaw, ShapeRaw};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::read_stack::{bed, body, lengths, listed};
use super::reader::Reader;
use super::stack::{BlockPart, OpeningPart, ShapePart, TopPart};
use dolmen::structure::stack::Body;

/// Most sides of a prism: as the science allows; more are a drum.
const SIDES_MOST: usize = 64;

/// Keys of a block that give it its shape, and the shapes that have them.
const KEYS_OF_SHAPE: [(&str, &[ShapeRaw]); 6] = [
    ("width", &[ShapeRaw::Box, ShapeRaw::Frustum, ShapeRaw::Prism]),
    ("depth", &[ShapeRaw::Box, ShapeRaw::Frustum]),
    ("top_width", &[ShapeRaw::Frustum, ShapeRaw::Prism]),
    ("top_depth", &[ShapeRaw::Frustum]),
    ("diameter", &[ShapeRaw::Drum]),
    ("top_diameter", &[ShapeRaw::Drum]),
];

fn shape_word(shape: ShapeRaw) -> &'static str {
    match shape {
        ShapeRaw::Box => "box",
        ShapeRaw::Frustum => "frustum",
        ShapeRaw::Prism => "prism",
        ShapeRaw::Drum => "drum",
    }
}

/// One block, with what it stands on.
pub(super) fn block(
    reader: &mut Reader,
    raw: &At<BlockRaw>,
    index: usize,
    names: &[String],
) -> Option<BlockPart> {
    let path = format!("blocks[{}]", index + 1);
    reader.mark(&path, &raw.span);
    let block = &raw.value;
    let shape = shape(reader, raw, &path);
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
    let on = on(reader, block, index, names);
    let at = plan(reader, block.at.as_ref(), &format!("{path}.at"));
    let offset = plan(reader, block.offset.as_ref(), &format!("{path}.offset"));
    let rotation_path = format!("{path}.rotation");
    let rotation = reader.quantity(
        block.rotation.as_ref(),
        &rotation_path,
        Measure::Angle,
        Bound::Any,
    );
    let lean = |key: &str| {
        let lean = block.tilt.as_ref()?;
        let raw = if key == "x" { &lean.value.x } else { &lean.value.y };
        Some((raw.as_ref()?, format!("{path}.tilt.{key}")))
    };
    let tilt = ["x", "y"].map(|key| {
        lean(key).and_then(|(raw, path)| reader.quantity(Some(raw), &path, Measure::Tilt, Bound::Any))
    });
    let joint = bed(reader, block.joint.as_ref(), &format!("{path}.joint"));
    Some(BlockPart {
        name: names[index].clone(),
        shape: shape?,
        openings: openings?,
        density,
        on: on?,
        at: at?,
        offset: offset?,
        rotation,
        tilt,
        joint: joint?,
    })
}

fn shape(reader: &mut Reader, raw: &At<BlockRaw>, path: &str) -> Option<ShapePart> {
    let block = &raw.value;
    let shape = block.shape.as_ref().map_or(ShapeRaw::Box, |shape| shape.value);
    let written = |key: &str| match key {
        "width" => &block.width,
        "depth" => &block.depth,
        "height" => &block.height,
        "top_width" => &block.top_width,
        "top_depth" => &block.top_depth,
        "diameter" => &block.diameter,
        _ => &block.top_diameter,
    };
    for (key, shapes) in KEYS_OF_SHAPE {
        if let Some(quantity) = written(key)
            && !shapes.contains(&shape)
        {
            let key_path = format!("{path}.{key}");
            let message = format!("{key_path} has no meaning in a {}", shape_word(shape));
            let others: Vec<String> = shapes
                .iter()
                .map(|shape| format!("shape = \"{}\"", shape_word(*shape)))
                .collect();
            let fault = Fault::new(quantity.span.clone(), &key_path, message);
            reader.fault(fault.help(format!("take it out, or write {}", others.join(" or "))));
        }
    }
    if let Some(sides) = &block.sides
        && shape != ShapeRaw::Prism
    {
        let key_path = format!("{path}.sides");
        let message = format!("{key_path} has no meaning in a {}", shape_word(shape));
        let fault = Fault::new(sides.span.clone(), &key_path, message);
        reader.fault(fault.help("take it out, or write shape = \"prism\""));
    }
    let needs = |reader: &mut Reader, key: &str| {
        let key_path = format!("{path}.{key}");
        if written(key).is_none() && !reader.is_reported(&key_path) {
            let message = format!("{path} has no \"{key}\", but a {} needs it", shape_word(shape));
            let fault = Fault::new(raw.span.clone(), &key_path, message);
            reader.fault(fault.help(format!("write {key} = …")));
        }
        reader.quantity(written(key).as_ref(), &key_path, Measure::Length, Bound::Positive)
    };
    let may = |reader: &mut Reader, key: &str| {
        let key_path = format!("{path}.{key}");
        let before = reader.faults.len();
        let read = reader.quantity(written(key).as_ref(), &key_path, Measure::Length, Bound::Positive);
        (reader.faults.len() == before).then_some(read)
    };
    let height = needs(reader, "height");
    match shape {
        ShapeRaw::Box => {
            let (width, depth) = (needs(reader, "width"), may(reader, "depth"));
            Some(ShapePart::Box {
                width: width?,
                depth: depth?,
                height: height?,
            })
        }
        ShapeRaw::Frustum => {
            let (width, depth) = (needs(reader, "width"), may(reader, "depth"));
            let (top_width, top_depth) = (needs(reader, "top_width"), may(reader, "top_depth"));
            Some(ShapePart::Frustum {
                width: width?,
                depth: depth?,
                top: Box::new(TopPart {
                    width: top_width?,
                    depth: top_depth?,
                }),
                height: height?,
            })
        }
        ShapeRaw::Prism => {
            let sides_path = format!("{path}.sides");
            if block.sides.is_none() {
                let message = format!("{path} has no \"sides\", but a prism needs it");
                let fault = Fault::new(raw.span.clone(), &sides_path, message);
                reader.fault(fault.help("write sides = …"));
            }
            let sides = reader.count(block.sides.as_ref(), &sides_path, 3, SIDES_MOST);
            let (width, top_width) = (needs(reader, "width"), may(reader, "top_width"));
            Some(ShapePart::Prism {
                sides: sides.and_then(|sides| u32::try_from(sides).ok())?,
                width: width?,
                top_width: top_width?,
                height: height?,
            })
        }
        ShapeRaw::Drum => {
            let (diameter, top_diameter) = (needs(reader, "diameter"), may(reader, "top_diameter"));
            Some(ShapePart::Drum {
                diameter: diameter?,
                top_diameter: top_diameter?,
                height: height?,
            })
        }
    }
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

/// What a block stands on: what it says, else the block before it, else the ground.
fn on(reader: &mut Reader, block: &BlockRaw, index: usize, names: &[String]) -> Option<Vec<Body>> {
    let Some(on) = &block.on else {
        return Some(vec![index.checked_sub(1).map_or(Body::Ground, Body::Block)]);
    };
    let path = format!("blocks[{}].on", index + 1);
    let given: Vec<&str> = match &on.value {
        OnRaw::One(name) => vec![name],
        OnRaw::Several(names) => names.iter().map(String::as_str).collect(),
    };
    if given.is_empty() {
        let fault = Fault::new(on.span.clone(), &path, format!("{path} is empty"));
        reader.fault(fault.allowed("needs the name of a block, or \"ground\""));
        return None;
    }
    let mut bodies = Vec::with_capacity(given.len());
    for name in given {
        let later = names[index..].iter().any(|later| later == name);
        if later && !names[..index].iter().any(|before| before == name) {
            let message = format!("{path} = \"{name}\" does not stand before it in the list");
            let fault = Fault::new(on.span.clone(), &path, message);
            reader.fault(
                fault
                    .allowed("must be a block before it")
                    .help("list the blocks lowest first"),
            );
            return None;
        }
        bodies.push(body(
            reader,
            name,
            (&on.span, &path),
            &names[..index],
            "block before it",
        )?);
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
