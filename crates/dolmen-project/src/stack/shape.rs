//! Reads the shape of a block.

use super::file::{BlockRaw, CoordinatesRaw, ShapeRaw};
use super::part::{MeshPart, PointsFrame, ShapePart, TopPart};
use crate::error::Fault;
use crate::file_number::{At, QuantityRaw};
use crate::measure::{Bound, Measure};
use crate::needed::lengths;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::wrong::said;
use crate::wrong::{Common, WrongStack, either};
use dolmen::structure::stack::Solid;
use dolmen_records::MESH_BYTES_MOST;
use dolmen_records::meshes::read_mesh;
use dolmen_words::message::Both;
use std::ops::Range;

/// Most sides of a prism: as in the library; more are a drum.
const SIDES_MOST: usize = 64;

/// A length that belongs to a shape of a block.
#[derive(Clone, Copy)]
enum ShapeKey {
    Width,
    Depth,
    Height,
    TopWidth,
    TopDepth,
    Diameter,
    TopDiameter,
}

impl ShapeKey {
    /// All, in the order of the messages.
    const ALL: [ShapeKey; 7] = [
        ShapeKey::Width,
        ShapeKey::Height,
        ShapeKey::Depth,
        ShapeKey::TopWidth,
        ShapeKey::TopDepth,
        ShapeKey::Diameter,
        ShapeKey::TopDiameter,
    ];

    /// The key as written.
    fn word(self) -> &'static str {
        match self {
            ShapeKey::Width => "width",
            ShapeKey::Depth => "depth",
            ShapeKey::Height => "height",
            ShapeKey::TopWidth => "top_width",
            ShapeKey::TopDepth => "top_depth",
            ShapeKey::Diameter => "diameter",
            ShapeKey::TopDiameter => "top_diameter",
        }
    }

    /// The shapes that have this length.
    fn shapes(self) -> &'static [ShapeRaw] {
        match self {
            ShapeKey::Width => &[ShapeRaw::Box, ShapeRaw::Frustum, ShapeRaw::Prism],
            ShapeKey::Height => &[ShapeRaw::Box, ShapeRaw::Frustum, ShapeRaw::Prism, ShapeRaw::Drum],
            ShapeKey::Depth => &[ShapeRaw::Box, ShapeRaw::Frustum],
            ShapeKey::TopWidth => &[ShapeRaw::Frustum, ShapeRaw::Prism],
            ShapeKey::TopDepth => &[ShapeRaw::Frustum],
            ShapeKey::Diameter | ShapeKey::TopDiameter => &[ShapeRaw::Drum],
        }
    }

    /// Its value in the file.
    fn of(self, block: &BlockRaw) -> Option<&At<QuantityRaw>> {
        match self {
            ShapeKey::Width => block.width.as_ref(),
            ShapeKey::Depth => block.depth.as_ref(),
            ShapeKey::Height => block.height.as_ref(),
            ShapeKey::TopWidth => block.top_width.as_ref(),
            ShapeKey::TopDepth => block.top_depth.as_ref(),
            ShapeKey::Diameter => block.diameter.as_ref(),
            ShapeKey::TopDiameter => block.top_diameter.as_ref(),
        }
    }
}

fn shape_word(shape: ShapeRaw) -> &'static str {
    match shape {
        ShapeRaw::Box => "box",
        ShapeRaw::Frustum => "frustum",
        ShapeRaw::Prism => "prism",
        ShapeRaw::Drum => "drum",
        ShapeRaw::Points => "solid of points",
        ShapeRaw::Mesh => "mesh",
    }
}

/// The body of a mesh that carries its contact.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum MeshContact {
    /// Its convex hull, or for a mesh with noise the planes of its beds.
    Beds,
    /// Its convex hull: for loose stones, which have no beds.
    Hull,
}

/// The shape of a block; `name` is that of the block.
pub(super) fn shape(
    reader: &mut Reader,
    raw: &At<BlockRaw>,
    path: &str,
    name: &str,
    contact: MeshContact,
) -> Option<ShapePart> {
    let block = &raw.value;
    let unsaid = match (&block.points, &block.file) {
        (Some(_), _) => ShapeRaw::Points,
        (None, Some(_)) => ShapeRaw::Mesh,
        (None, None) => ShapeRaw::Box,
    };
    let shape = block.shape.as_ref().map_or(unsaid, |shape| shape.value);
    refuse_foreign(reader, block, path, shape);
    match shape {
        ShapeRaw::Points => return points(reader, raw, path),
        ShapeRaw::Mesh => return mesh(reader, raw, path, name, contact),
        ShapeRaw::Box | ShapeRaw::Frustum | ShapeRaw::Prism | ShapeRaw::Drum => {}
    }
    let needs = |reader: &mut Reader, key: ShapeKey| {
        let key_path = format!("{path}.{}", key.word());
        if key.of(block).is_none() && !reader.is_reported(&key_path) {
            let message = WrongStack::HasNoButNeeds {
                path: path.to_string(),
                key: key.word().to_owned(),
                shape: shape_word(shape).into(),
            };
            let fault = Fault::new(raw.span.clone(), &key_path, message);
            reader.fault(fault.help(WrongStack::Write {
                key: key.word().to_owned(),
            }));
        }
        reader.quantity(key.of(block), &key_path, Measure::Length, Bound::Positive)
    };
    let may = |reader: &mut Reader, key: ShapeKey| {
        let key_path = format!("{path}.{}", key.word());
        let before = reader.faults.len();
        let read = reader.quantity(key.of(block), &key_path, Measure::Length, Bound::Positive);
        (reader.faults.len() == before).then_some(read)
    };
    let height = needs(reader, ShapeKey::Height);
    match shape {
        ShapeRaw::Box => {
            let (width, depth) = (needs(reader, ShapeKey::Width), may(reader, ShapeKey::Depth));
            Some(ShapePart::Box {
                width: width?,
                depth: depth?,
                height: height?,
            })
        }
        ShapeRaw::Frustum => {
            let (width, depth) = (needs(reader, ShapeKey::Width), may(reader, ShapeKey::Depth));
            let (top_width, top_depth) = (needs(reader, ShapeKey::TopWidth), may(reader, ShapeKey::TopDepth));
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
                let message = WrongStack::HasNoSidesBut {
                    path: path.to_string(),
                };
                let fault = Fault::new(raw.span.clone(), &sides_path, message);
                reader.fault(fault.help(WrongStack::WriteSides));
            }
            let sides = reader.count(block.sides.as_ref(), &sides_path, 3, SIDES_MOST);
            let (width, top_width) = (needs(reader, ShapeKey::Width), may(reader, ShapeKey::TopWidth));
            Some(ShapePart::Prism {
                sides: sides.and_then(|sides| u32::try_from(sides).ok())?,
                width: width?,
                top_width: top_width?,
                height: height?,
            })
        }
        ShapeRaw::Drum => {
            let (diameter, top_diameter) = (
                needs(reader, ShapeKey::Diameter),
                may(reader, ShapeKey::TopDiameter),
            );
            Some(ShapePart::Drum {
                diameter: diameter?,
                top_diameter: top_diameter?,
                height: height?,
            })
        }
        ShapeRaw::Points | ShapeRaw::Mesh => None, // read above
    }
}

/// Rejects keys that have no meaning in a shape.
fn refuse_foreign(reader: &mut Reader, block: &BlockRaw, path: &str, shape: ShapeRaw) {
    for key in ShapeKey::ALL {
        let shapes = key.shapes();
        if let Some(quantity) = key.of(block)
            && !shapes.contains(&shape)
        {
            let key_path = format!("{path}.{}", key.word());
            let message = WrongStack::HasNoMeaningIn {
                key_path: key_path.to_string(),
                shape: shape_word(shape).into(),
            };
            let others: Vec<String> = shapes
                .iter()
                .map(|shape| format!("shape = \"{}\"", shape_word(*shape)))
                .collect();
            let fault = Fault::new(quantity.span.clone(), &key_path, message);
            reader.fault(fault.help(Common::TakeItOutOr(either(&others))));
        }
    }
    for (key, span, shapes) in other_keys(block) {
        if let (Some(span), false) = (span, shapes.contains(&shape)) {
            let key_path = format!("{path}.{key}");
            let message = WrongStack::HasNoMeaningIn {
                key_path: key_path.to_string(),
                shape: shape_word(shape).into(),
            };
            let others: Vec<&str> = shapes.iter().map(|shape| word_of(*shape)).collect();
            let fault = Fault::new(span, &key_path, message);
            reader.fault(fault.help(Common::TakeItOutOr(either(&others))));
        }
    }
}

/// `shape = "prism"`.
fn word_of(shape: ShapeRaw) -> &'static str {
    match shape {
        ShapeRaw::Box => "shape = \"box\"",
        ShapeRaw::Frustum => "shape = \"frustum\"",
        ShapeRaw::Prism => "shape = \"prism\"",
        ShapeRaw::Drum => "shape = \"drum\"",
        ShapeRaw::Points => "shape = \"points\"",
        ShapeRaw::Mesh => "shape = \"mesh\"",
    }
}

type OtherKey = (&'static str, Option<Range<usize>>, &'static [ShapeRaw]);

/// Keys that are not lengths, with their places and the shapes that have them. Keys that `coordinates = "site"` excludes are
/// among them: a stone at its coordinates has no other place.
fn other_keys(block: &BlockRaw) -> [OtherKey; 5] {
    fn span<T>(key: &Option<At<T>>) -> Option<Range<usize>> {
        key.as_ref().map(|at| at.span.clone())
    }
    const PRISM: &[ShapeRaw] = &[ShapeRaw::Prism];
    const POINTS: &[ShapeRaw] = &[ShapeRaw::Points];
    const MESH: &[ShapeRaw] = &[ShapeRaw::Mesh];
    const BOTH: &[ShapeRaw] = &[ShapeRaw::Points, ShapeRaw::Mesh];
    [
        ("sides", span(&block.sides), PRISM),
        ("points", span(&block.points), POINTS),
        ("file", span(&block.file), MESH),
        ("unit", span(&block.unit), MESH),
        ("coordinates", span(&block.coordinates), BOTH),
    ]
}

/// The origin of the coordinates; a stone at its coordinates has no other place.
fn frame(reader: &mut Reader, block: &BlockRaw, path: &str) -> PointsFrame {
    let site = block
        .coordinates
        .as_ref()
        .is_some_and(|given| given.value == CoordinatesRaw::Site);
    if !site {
        return PointsFrame::Own;
    }
    let given = [
        ("at", block.at.as_ref().map(|at| &at.span)),
        ("offset", block.offset.as_ref().map(|at| &at.span)),
        ("rotation", block.rotation.as_ref().map(|at| &at.span)),
        ("tilt", block.tilt.as_ref().map(|at| &at.span)),
    ];
    for (key, span) in given {
        if let Some(span) = span {
            let key_path = format!("{path}.{key}");
            let message = WrongStack::HasNoMeaningWith {
                key_path: key_path.to_string(),
            };
            let fault = Fault::new(span.clone(), &key_path, message);
            reader.fault(fault.help(WrongStack::TakeItOutOr));
        }
    }
    PointsFrame::Site
}

fn points(reader: &mut Reader, raw: &At<BlockRaw>, path: &str) -> Option<ShapePart> {
    let frame = frame(reader, &raw.value, path);
    let points_path = format!("{path}.points");
    let Some(list) = &raw.value.points else {
        if !reader.is_reported(&points_path) {
            let message = WrongStack::HasNoPointsBut {
                path: path.to_string(),
            };
            let fault = Fault::new(raw.span.clone(), &points_path, message);
            reader.fault(fault.help(WrongStack::WritePointsXY));
        }
        return None;
    };
    reader.mark(&points_path, &list.span);
    let mut points = Vec::with_capacity(list.value.len());
    for (i, point) in list.value.iter().enumerate() {
        points.push(lengths(
            reader,
            point,
            &format!("{points_path}[{}]", i + 1),
            "[x, y, z]",
        ));
    }
    let points: Vec<[Quantity; 3]> = points.into_iter().collect::<Option<_>>()?;
    let part = ShapePart::Points { points, frame };
    if let Err(why) = part.solid(&mut Quantity::nominal) {
        let fault = Fault::new(list.span.clone(), &points_path, format!("{points_path}: {why}"));
        reader.fault(fault);
        return None;
    }
    Some(part)
}

fn mesh(
    reader: &mut Reader,
    raw: &At<BlockRaw>,
    path: &str,
    name: &str,
    contact: MeshContact,
) -> Option<ShapePart> {
    let frame = frame(reader, &raw.value, path);
    let file_path = format!("{path}.file");
    let Some(file) = &raw.value.file else {
        if !reader.is_reported(&file_path) {
            let message = WrongStack::HasNoFileBut {
                path: path.to_string(),
            };
            let fault = Fault::new(raw.span.clone(), &file_path, message);
            reader.fault(fault.help(WrongStack::WriteFileStoneObj));
        }
        return None;
    };
    reader.mark(&file_path, &file.span);
    let metres = match &raw.value.unit {
        Some(unit) => {
            let unit_path = format!("{path}.unit");
            reader
                .unit(&unit.value, &unit.span, &unit_path, Measure::Length, &unit_path)?
                .factor
        }
        None => reader.bare_unit(Measure::Length).1,
    };
    let refuse = |reader: &mut Reader, why: Both| {
        let message = WrongStack::MeshOf {
            file_path: file_path.to_string(),
            file: file.value.to_string(),
            name: name.to_string(),
            why,
        };
        reader.fault(Fault::new(file.span.clone(), &file_path, message));
    };
    let read = reader.files.read(&file.value, MESH_BYTES_MOST);
    let mesh = read
        .map_err(|why| said(&why))
        .and_then(|bytes| read_mesh(&bytes).map_err(|why| said(&why)));
    let mesh = match mesh {
        Ok(mesh) => mesh.merged().scaled(metres),
        Err(why) => {
            refuse(reader, why);
            return None;
        }
    };
    let solid = match contact {
        MeshContact::Beds => Solid::mesh(&mesh.vertices, &mesh.triangles),
        MeshContact::Hull => Solid::loose_mesh(&mesh.vertices, &mesh.triangles),
    };
    match solid {
        Ok(solid) => Some(ShapePart::Mesh(Box::new(MeshPart {
            file: file.value.clone(),
            triangles: mesh.triangles.len(),
            unit_m: metres,
            solid: frame.of(solid),
            frame,
        }))),
        Err(why) => {
            refuse(reader, said(&why));
            None
        }
    }
}
