//! Patterns over all stones of a stack that look like a slip.

use super::part::{BedPart, BlockPart, ShapePart, StackPart};
use crate::doubted::Doubted;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::rounded_length;
use crate::usual_numbers::{kilonewtons, metres, ratio};
use dolmen::structure::stack::Body;

/// Stones whose order is judged.
const STONES_LEAST: usize = 5;
/// Kendall's τ of widths: the share of pairs of stones that become wider upwards less that of those that become narrower. Our choice: pagodas have -0.9 to 0.
const WIDER_PAIRS: f64 = 0.4;
/// Least friction of stone on stone if it was not measured; sliding bearings have less.
const FRICTION_LEAST: f64 = 0.15;
/// Rotation of a stone, rad, beyond which it is out of its place. Our choice: an eighth of a circle.
const TURNED_MOST_RAD: f64 = std::f64::consts::FRAC_PI_4 * 1.01;
/// Largest settlement of the lowest joint under the stones, m. Our choice: dry rubble closes by 1 mm.
const SINKS_MOST_M: f64 = 0.003;
/// Largest stone from a mesh, m, and highest stack of them. Our choice: roof stones have up to 7 m, pagodas of stone 15 m.
const MESH_MOST_M: f64 = 8.0;
const MESHES_HIGH_M: f64 = 25.0;
/// Units of a mesh, with their length in m.
const MESH_UNITS: [(&str, f64); 4] = [("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("in", 0.0254)];

/// Usual size of a load, in weights of its stone. Our choice: a roof on a post has some tens.
const LOAD_WEIGHTS: (f64, f64) = (2e-3, 200.0);
/// Share of a load that acts upwards from which it is doubted.
const UPWARDS: f64 = 0.5;
/// Distance of a load from its stone, in lengths of the stone, from which it is doubted. Our choice: a bracket reaches less far.
const LOAD_OFF: f64 = 0.5;

pub(crate) fn doubt_stack(reader: &mut Reader, part: &StackPart) {
    order(reader, part);
    let joints = part.blocks.iter().map(|block| &block.joint);
    for bed in std::iter::once(&part.joint)
        .chain(joints)
        .chain(part.contacts.iter().map(|of| &of.joint))
    {
        friction(reader, bed);
    }
    sinks(reader, part);
    large_meshes(reader, part);
    loads(reader, part);
    for rotation in part.blocks.iter().filter_map(|block| block.rotation.as_ref()) {
        if rotation.value.abs() > TURNED_MOST_RAD {
            let path = &rotation.path;
            let degrees = ratio(rotation.value.to_degrees());
            reader.doubt(
                path,
                Doubted::TurnedFar {
                    path: path.clone(),
                    degrees,
                },
            );
        }
    }
}

fn width_m(block: &BlockPart) -> Option<f64> {
    let [low, high] = block.shape.solid(&mut Quantity::nominal).ok()?.bounds_m();
    Some((high[0] - low[0]).max(high[1] - low[1]))
}

fn height_m(block: &BlockPart) -> f64 {
    match &block.shape {
        ShapePart::Box { height, .. }
        | ShapePart::Frustum { height, .. }
        | ShapePart::Prism { height, .. }
        | ShapePart::Drum { height, .. } => height.value,
        ShapePart::Points { .. } | ShapePart::Mesh(_) => 0.0,
    }
}

fn order(reader: &mut Reader, part: &StackPart) {
    let on_the_last = |(i, block): (usize, &BlockPart)| {
        let before = i.checked_sub(1).map_or(Body::Ground, Body::Block);
        block.on == [before] && !block.shape.keeps_its_place()
    };
    if part.blocks.len() < STONES_LEAST || !part.blocks.iter().enumerate().all(on_the_last) {
        return;
    }
    let Some(widths) = part.blocks.iter().map(width_m).collect::<Option<Vec<f64>>>() else {
        return;
    };
    let pairs = (0..widths.len()).flat_map(|i| (0..i).map(move |below| (below, i)));
    let signs = pairs.map(|(below, i)| {
        (widths[i] - widths[below])
            .partial_cmp(&0.0)
            .map_or(0, |order| order as i32)
    });
    let (sum, count) = signs.fold((0, 0), |(sum, count), sign| (sum + sign, count + 1));
    let tau = f64::from(sum) / f64::from(count.max(1));
    if tau > WIDER_PAIRS {
        reader.doubt("blocks", Doubted::StackOrder(ratio(100.0 * tau)));
    }
}

fn friction(reader: &mut Reader, bed: &BedPart) {
    if let Some(friction) = bed.friction.as_ref().filter(|of| of.value < FRICTION_LEAST) {
        let path = &friction.path;
        reader.doubt(
            path,
            Doubted::FrictionLow {
                path: path.clone(),
                value: ratio(friction.value),
            },
        );
    }
}

/// Meshes read in too large a unit: margins without shaking do not depend on the size, so nothing else shows it.
fn large_meshes(reader: &mut Reader, part: &StackPart) {
    let meshes = part
        .blocks
        .iter()
        .enumerate()
        .filter_map(|(i, block)| match &block.shape {
            ShapePart::Mesh(mesh) => Some((i, block, mesh)),
            _ => None,
        });
    let (mut largest, mut span_m, mut sum_m) = (None, [f64::INFINITY, f64::NEG_INFINITY], 0.0);
    for (i, block, mesh) in meshes {
        let [low, high] = mesh.solid.bounds_m();
        let extent_m = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        if largest.is_none_or(|(_, _, _, most_m)| extent_m > most_m) {
            largest = Some((i, block, mesh, extent_m));
        }
        if block.shape.keeps_its_place() {
            span_m = [span_m[0].min(low[2]), span_m[1].max(high[2])];
        } else if i == 0 || block.on == [Body::Block(i - 1)] {
            sum_m += high[2] - low[2];
        }
    }
    let Some((i, block, mesh, extent_m)) = largest else {
        return;
    };
    let height_m = sum_m.max(span_m[1] - span_m[0]);
    if extent_m <= MESH_MOST_M && height_m <= MESHES_HIGH_M {
        return;
    }
    let others = MESH_UNITS
        .iter()
        .filter(|(_, unit_m)| *unit_m < 0.999 * mesh.unit_m);
    let others: Vec<String> = others
        .map(|(name, unit_m)| {
            let [extent_m, height_m] =
                [extent_m, height_m].map(|length_m| rounded_length(length_m * unit_m / mesh.unit_m));
            format!("{extent_m} m, {height_m} m ({name})")
        })
        .collect();
    let path = format!("blocks[{}].file", i + 1);
    let doubted = Doubted::MeshLarge {
        path: path.clone(),
        name: block.name.clone(),
        extent: metres(extent_m),
        height: metres(height_m),
        others: others.join("; "),
    };
    reader.doubt(&path, doubted);
}

fn length(of: [f64; 3]) -> f64 {
    of.iter().map(|part| part * part).sum::<f64>().sqrt()
}

/// Static loads of another order than the stone on which they act, upwards, or off it.
fn loads(reader: &mut Reader, part: &StackPart) {
    if part.static_loads.is_empty() {
        return;
    }
    let Ok(stack) = part.build(&mut Quantity::nominal) else {
        return;
    };
    for (i, load) in stack.static_loads().iter().enumerate() {
        let path = format!("loads[{}]", i + 1);
        let block = &stack.blocks()[load.block];
        let stone = block.name.clone();
        let size_n = length(load.force_n);
        let weights = size_n / (block.mass_kg() * stack.gravity_m_s2());
        let force = kilonewtons(size_n);
        let ([low, high], at) = (block.solid.bounds_m(), load.position_m);
        let away = |axis: usize| (low[axis] - at[axis]).max(at[axis] - high[axis]).max(0.0);
        let away_m = length([away(0), away(1), away(2)]);
        let longest_m = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        let small = size_n > 0.0 && weights < LOAD_WEIGHTS.0;
        let (name, size) = (|| path.clone(), || (force.clone(), stone.clone()));
        let doubted = [
            small.then(|| {
                let (force, stone) = size();
                let (path, ratio) = (name(), ratio(weights));
                Doubted::LoadSmall {
                    path,
                    force,
                    stone,
                    ratio,
                }
            }),
            (weights > LOAD_WEIGHTS.1).then(|| {
                let (force, stone) = size();
                let (path, ratio) = (name(), ratio(weights));
                Doubted::LoadLarge {
                    path,
                    force,
                    stone,
                    ratio,
                }
            }),
            (load.force_n[2] > UPWARDS * size_n).then(|| {
                let (force, stone) = size();
                Doubted::LoadUpwards {
                    path: name(),
                    force,
                    stone,
                }
            }),
            (away_m > LOAD_OFF * longest_m).then(|| Doubted::LoadOff {
                path: name(),
                stone: stone.clone(),
                away: metres(away_m),
            }),
        ];
        for doubted in doubted.into_iter().flatten() {
            reader.doubt(&path, doubted);
        }
    }
}

/// ρ g H over the stiffness per area: the settlement of the lowest joint under a column of all stones.
fn sinks(reader: &mut Reader, part: &StackPart) {
    let (Some(density), Some(stiffness)) = (&part.density, &part.joint.normal_stiffness) else {
        return;
    };
    let height_m: f64 = part.blocks.iter().map(height_m).fold(0.0, f64::max).max(
        match part
            .blocks
            .iter()
            .enumerate()
            .all(|(i, block)| i == 0 || block.on == [Body::Block(i - 1)])
        {
            true => part.blocks.iter().map(height_m).sum(),
            false => 0.0,
        },
    );
    let sinks_m = density.value * part.gravity_m_s2 * height_m / stiffness.value;
    if sinks_m > SINKS_MOST_M {
        let path = &stiffness.path;
        reader.doubt(
            path,
            Doubted::SoftBed {
                path: path.clone(),
                sinks: metres(sinks_m),
            },
        );
    }
}
