//! Probable slips in a stack.

use super::made_part::MadePart;
use super::part::{BedPart, BlockPart, PagodaPart, PagodaSlendernessPart, ShapePart, StackPart};
use super::slips_beside::judge_beside;
use super::slips_held::judge_held;
use crate::named_order::begins_with_top;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::soil::judge_soil;
use crate::usual::{beside_neighbour, beside_others, guess, median_of_others, odd_ones, unit_of, within};
use crate::written::short;
use crate::wrong::{Common, Slip, StackSlip};
use dolmen::structure::stack::Body;
use dolmen_words::message::Both;

/// Ratio of a dimension of a block to the median of the others, either way: a spire of 80 mm on slabs of 2 m has 1/25.
const SIZE_RATIO_MOST: f64 = 30.0;
/// Any dimension of a block, m: from a shim of 5 mm to the longest monoliths, with a margin.
const SIZE_M: (f64, f64) = (0.005, 50.0);
/// A block of usual size, m: of two unlike blocks the one further from it is doubtful.
const SIZE_USUAL_M: f64 = 1.0;
/// Largest distance of a stone from the origin, m. At 4,000 km rounding of contact forces is 1e-4 of the weight, and no rest is found; at
/// this limit it is 1e-7. Coordinates of a map grid are beyond it.
const FROM_ORIGIN_MOST_M: f64 = 20_000.0;
/// Density of a block, kg/m³: from light timber to lead, with a margin.
const DENSITY_KG_M3: (f64, f64) = (350.0, 15_000.0);
/// Friction coefficient: from a greased sliding bearing to interlocking rubble.
const FRICTION: (f64, f64) = (0.03, 2.0);
/// Angles of friction of stone on stone, with a margin: a coefficient in this range is an angle in degrees.
const FRICTION_ANGLES_DEG: std::ops::RangeInclusive<f64> = 10.0..=50.0;
/// Stiffness of a joint per area, Pa/m: from rubble in clay to ground beds of granite.
const STIFFNESS_PA_M: (f64, f64) = (1e6, 1e13);
/// Usual stiffness per area, Pa/m.
const STIFFNESS_USUAL_PA_M: f64 = 1e9;
/// Shear over normal stiffness: elastic contact has 0.3 to 1.
const STIFFNESS_RATIO: (f64, f64) = (0.01, 2.0);
/// Strength of a bond, Pa: lime mortar has 1e4 to 1e6.
const BOND_PA: (f64, f64) = (1e3, 2e7);

/// Compressive strength of a joint, Pa: a soft lime mortar has 5e5, quartzite 4e8.
const CRUSHES_PA: (f64, f64) = (1e5, 1e9);

/// Tilt of a stone on its bed: 11°, more than any pagoda leans. Our choice.
const TILT_MOST: f64 = 0.2;
/// Span and depth of an arch, a vault or a dome, m: from a model to the longest spans of stone, 146 m.
const ARCH_SPAN_M: (f64, f64) = (0.03, 200.0);
const WALL_LENGTH_M: (f64, f64) = (0.03, 1000.0);
/// Width of a tower, m: from a model to the widest keeps.
const TOWER_WIDTH_M: (f64, f64) = (0.03, 60.0);
/// Height of a post, m: from a model to obelisks.
const POST_M: (f64, f64) = (0.03, 40.0);
/// A stone of a generated structure, m.
const STONE_M: (f64, f64) = (0.01, 10.0);

/// Height of all storeys of a pagoda, m: from a model to the highest ever built.
const PAGODA_HEIGHT_M: (f64, f64) = (0.3, 60.0);

/// tan α of a pagoda: far outside any pagoda ever built.
const SLENDERNESS_ANGLE: (f64, f64) = (0.05, 1.5);

/// Width of a top stone over that of the first one, above which the list seems to begin with the top. Our choice.
const WIDER_MOST: f64 = 3.0;
/// Fewest stones of a list to judge its order.
const STONES_LEAST: usize = 4;

pub(crate) fn judge_stack(reader: &mut Reader, stack: &StackPart) {
    judge_sizes(reader, stack);
    judge_extents(reader, stack);
    judge_order(reader, stack);
    judge_beside(reader, stack);
    judge_tilts(reader, stack);
    judge_held(reader, stack);
    if let Some(made) = &stack.made {
        judge_made(reader, made);
    }
    if let Some(pagoda) = &stack.pagoda {
        judge_pagoda(reader, pagoda);
    }
    let densities = stack
        .density
        .iter()
        .chain(stack.blocks.iter().filter_map(|block| block.density.as_ref()));
    for density in densities {
        judge_density(reader, density);
    }
    if let Some(soil) = &stack.soil {
        judge_soil(reader, &soil.shear_modulus, soil.footing.as_ref(), None);
    }
    judge_bed(reader, &stack.joint);
    for block in &stack.blocks {
        judge_bed(reader, &block.joint);
    }
    for contact in &stack.contacts {
        judge_bed(reader, &contact.joint);
    }
}

/// A list that begins with the top: each stone would then stand on a smaller one without any message.
fn judge_order(reader: &mut Reader, stack: &StackPart) {
    let listed = |(i, block): (usize, &BlockPart)| {
        let before = i.checked_sub(1).map_or(Body::Ground, Body::Block);
        block.on == [before] && !block.shape.keeps_its_place()
    };
    if !stack.blocks.iter().enumerate().all(listed) {
        return;
    }
    let names: Vec<&str> = stack.blocks.iter().map(|block| block.name.as_str()).collect();
    if let ([foot, .., top], true) = (names.as_slice(), begins_with_top(&names)) {
        let (foot, top) = ((*foot).to_owned(), (*top).to_owned());
        let message = StackSlip::NamesBeginWithTop { foot, top };
        return reader.slip("blocks", message, StackSlip::ListStonesLowestFirst);
    }
    if names.len() < STONES_LEAST {
        return;
    }
    let width = |block: &BlockPart| {
        let solid = block.shape.solid(&mut Quantity::nominal).ok()?;
        let [low, high] = solid.bounds_m();
        Some((high[0] - low[0]).max(high[1] - low[1]))
    };
    let (Some(first), Some(last)) = (stack.blocks.first(), stack.blocks.last()) else {
        return;
    };
    let (Some(first_m), Some(last_m)) = (width(first), width(last)) else {
        return;
    };
    if last_m > WIDER_MOST * first_m {
        let message = StackSlip::BlocksLastStoneStands {
            top: last.name.to_string(),
            last_m: short(last_m),
            foot: first.name.to_string(),
            first_m: short(first_m),
        };
        let help = StackSlip::ListStonesLowestFirst;
        reader.slip("blocks", message, help.to_owned());
    }
}

/// Tilts at which no stone stands.
fn judge_tilts(reader: &mut Reader, stack: &StackPart) {
    let tilts = stack.blocks.iter().flat_map(|block| block.tilt.iter().flatten());
    for tilt in tilts.filter(|tilt| tilt.value.abs() > TILT_MOST) {
        let message = StackSlip::LeansFar {
            path: tilt.path.clone(),
            written: tilt.written.clone(),
        };
        reader.slip(&tilt.path, message, StackSlip::IsItInDegrees);
    }
}

/// A generated structure of impossible size.
fn judge_made(reader: &mut Reader, made: &MadePart) {
    let bounds = match made {
        MadePart::Arch(arch) => vec![
            (Some(&arch.span), ARCH_SPAN_M),
            (Some(&arch.thickness), STONE_M),
            (Some(&arch.depth), ARCH_SPAN_M),
            (arch.springing_height.as_ref(), ARCH_SPAN_M),
        ],
        MadePart::Wall(wall) => vec![
            (Some(&wall.length), WALL_LENGTH_M),
            (Some(&wall.thickness), STONE_M),
            (Some(&wall.course_height), STONE_M),
            (Some(&wall.stone_length), STONE_M),
        ],
        MadePart::Tower(tower) => vec![
            (Some(&tower.width), TOWER_WIDTH_M),
            (tower.top_width.as_ref(), TOWER_WIDTH_M),
            (Some(&tower.course_height), STONE_M),
            (tower.thickness.as_ref(), STONE_M),
        ],
        MadePart::Trilithon(trilithon) => vec![
            (Some(&trilithon.span), STONE_M),
            (Some(&trilithon.post_width), STONE_M),
            (Some(&trilithon.post_height), POST_M),
            (trilithon.depth.as_ref(), STONE_M),
            (Some(&trilithon.lintel_height), STONE_M),
        ],
        MadePart::Vault(vault) => vec![
            (Some(&vault.span), ARCH_SPAN_M),
            (Some(&vault.thickness), STONE_M),
            (Some(&vault.length), WALL_LENGTH_M),
            (vault.springing_height.as_ref(), ARCH_SPAN_M),
        ],
        MadePart::Dome(dome) => vec![
            (Some(&dome.span), ARCH_SPAN_M),
            (Some(&dome.thickness), STONE_M),
            (dome.oculus.as_ref(), ARCH_SPAN_M),
            (dome.drum_height.as_ref(), ARCH_SPAN_M),
        ],
    };
    for (given, range) in bounds {
        if let Some(given) = given.filter(|given| given.value != 0.0 && !within(given.value, range)) {
            let (least, most) = range;
            let message = StackSlip::ButItIsTo {
                path: given.path.to_string(),
                written: given.written.to_string(),
                least: least.to_string(),
                most: most.to_string(),
            };
            reader.slip(
                &given.path,
                message,
                guess(given.value / SIZE_USUAL_M, unit_of(given)),
            );
        }
    }
}

fn judge_pagoda(reader: &mut Reader, pagoda: &PagodaPart) {
    let height = &pagoda.body_height;
    if !within(height.value, PAGODA_HEIGHT_M) {
        let message = StackSlip::ButPagodasHaveTo {
            path: height.path.to_string(),
            written: height.written.to_string(),
        };
        reader.slip(&height.path, message, guess(height.value / 4.0, unit_of(height)));
    }
    if let Some(PagodaSlendernessPart::Angle(angle)) = &pagoda.slenderness
        && !within(angle.value, SLENDERNESS_ANGLE)
    {
        let message = StackSlip::ButPagodasHaveToOther {
            path: angle.path.to_string(),
            written: angle.written.to_string(),
        };
        let help = StackSlip::ItIsHalfWidth;
        reader.slip(&angle.path, message, help.to_owned());
    }
}

/// The numbers of one kind, "width", of all blocks that have it.
fn judge_sizes(reader: &mut Reader, stack: &StackPart) {
    let mut kinds: Vec<(String, Vec<&Quantity>)> = Vec::new();
    for block in &stack.blocks {
        let mut sizes = Vec::new();
        if !matches!(block.shape, ShapePart::Points { .. }) {
            block.shape.inputs(&mut sizes); // of points the extent is judged
        }
        for size in sizes {
            let key = size.path.rsplit('.').next().unwrap_or_default().to_owned();
            match kinds.iter_mut().find(|(kind, _)| *kind == key) {
                Some((_, all)) => all.push(size),
                None => kinds.push((key, vec![size])),
            }
        }
    }
    for (_, sizes) in &kinds {
        let values: Vec<f64> = sizes.iter().map(|size| size.value).collect();
        let odd = odd_sizes(&values);
        for (i, size) in sizes.iter().enumerate() {
            if within(size.value, SIZE_M) && !odd.contains(&i) {
                continue;
            }
            let (least, most) = SIZE_M;
            let usual = odd.contains(&i).then(|| median_of_others(&values, i)).flatten();
            let beside = usual.and_then(|_| beside_neighbour(sizes, i, Slip::Stone));
            let beside = beside.map_or_else(
                || {
                    Both::from(StackSlip::ButStonesAreTo {
                        least: least.to_string(),
                        most: most.to_string(),
                    })
                },
                Both::from,
            );
            let message = beside_others(size, beside);
            let help = guess(size.value / usual.unwrap_or(SIZE_USUAL_M), unit_of(size));
            reader.slip(&size.path, message, help);
        }
    }
}

/// Largest extent of stones given by points or meshes, because single coordinates mean nothing.
fn judge_extents(reader: &mut Reader, stack: &StackPart) {
    for (i, block) in stack.blocks.iter().enumerate() {
        let key = match &block.shape {
            ShapePart::Points { .. } => "points",
            ShapePart::Mesh(_) => "file",
            _ => continue,
        };
        let Ok(solid) = block.shape.solid(&mut Quantity::nominal) else {
            continue;
        };
        let [low, high] = solid.bounds_m();
        let extent = (0..3).map(|axis| high[axis] - low[axis]).fold(0.0, f64::max);
        if !within(extent, SIZE_M) {
            let path = format!("blocks[{}].{key}", i + 1);
            let (least, most) = SIZE_M;
            let message = StackSlip::IsMAcrossBut {
                path: path.to_string(),
                name: block.name.to_string(),
                extent: short(extent),
                least: least.to_string(),
                most: most.to_string(),
            };
            reader.slip(&path, message, guess(extent / SIZE_USUAL_M, "m"));
        }
        let far = (0..2)
            .map(|axis| low[axis].abs().max(high[axis].abs()))
            .fold(0.0, f64::max);
        if block.shape.keeps_its_place() && far > FROM_ORIGIN_MOST_M {
            let message = StackSlip::FarFromOrigin {
                name: block.name.to_string(),
                far: format!("{:.0}", far / 1000.0),
                most: format!("{:.0}", FROM_ORIGIN_MOST_M / 1000.0),
            };
            let round = |axis: usize| format!("{:.0}", (low[axis] / 10.0).floor() * 10.0);
            let help = StackSlip::TakeOff {
                x: round(0),
                y: round(1),
            };
            reader.slip(&format!("blocks[{}].{key}", i + 1), message, help);
            return; // the others lie beside it
        }
    }
}

/// The implausible values among sizes. The worst is removed before the rest is checked, because among few stones one mistake would make
/// its neighbours look implausible too.
fn odd_sizes(values: &[f64]) -> Vec<usize> {
    let mut left: Vec<usize> = (0..values.len()).collect();
    let mut odd = Vec::new();
    loop {
        let rest: Vec<f64> = left.iter().map(|&i| values[i]).collect();
        let distance = |&place: &usize| {
            let usual = if rest.len() == 2 {
                Some(SIZE_USUAL_M)
            } else {
                median_of_others(&rest, place)
            };
            usual.map_or(0.0, |usual| (rest[place] / usual).ln().abs())
        };
        let odd_places = odd_ones(&rest, SIZE_RATIO_MOST, SIZE_USUAL_M);
        let worst = odd_places
            .into_iter()
            .max_by(|a, b| distance(a).total_cmp(&distance(b)));
        match worst {
            Some(place) => odd.push(left.remove(place)),
            None => return odd,
        }
    }
}

fn judge_density(reader: &mut Reader, density: &Quantity) {
    if within(density.value, DENSITY_KG_M3) {
        return;
    }
    let message = StackSlip::ButStoneHasTo {
        path: density.path.to_string(),
        written: density.written.to_string(),
    };
    let in_tonnes = within(density.value * 1e3, DENSITY_KG_M3);
    let help = if in_tonnes {
        StackSlip::DidYouMeanT {
            tonnes: short(density.value),
        }
    } else {
        StackSlip::KgM3TM3
    };
    reader.slip(&density.path, message, help);
}

fn judge_bed(reader: &mut Reader, bed: &BedPart) {
    for friction in bed.friction.iter().chain(&bed.friction_kinetic) {
        if !within(friction.value, FRICTION) {
            let message = StackSlip::ButStoneOnStone {
                path: friction.path.to_string(),
                written: friction.written.to_string(),
            };
            let help = if FRICTION_ANGLES_DEG.contains(&friction.value) {
                StackSlip::IsItAngle {
                    degrees: short(friction.value),
                    tangent: short((friction.value.to_radians().tan() * 1e3).round() / 1e3),
                }
            } else if friction.value > FRICTION.1 {
                StackSlip::DidYouMean {
                    percent: short(friction.value),
                }
            } else {
                StackSlip::ItIsFrictionCoefficient
            };
            reader.slip(&friction.path, message, help);
        }
    }
    for stiffness in bed.normal_stiffness.iter().chain(&bed.shear_stiffness) {
        if !within(stiffness.value, STIFFNESS_PA_M) {
            let message = StackSlip::ButJointsHaveE6 {
                path: stiffness.path.to_string(),
                written: stiffness.written.to_string(),
            };
            let ratio = stiffness.value / STIFFNESS_USUAL_PA_M;
            let help = if ratio < 1.0 {
                StackSlip::DidYouMeanMpa
            } else {
                StackSlip::GpaMIsE9
            };
            reader.slip(&stiffness.path, message, help.to_owned());
        }
    }
    if let (Some(normal), Some(shear)) = (&bed.normal_stiffness, &bed.shear_stiffness) {
        let ratio = shear.value / normal.value;
        if within(normal.value, STIFFNESS_PA_M)
            && within(shear.value, STIFFNESS_PA_M)
            && !within(ratio, STIFFNESS_RATIO)
        {
            let message = StackSlip::IsNormalStiffnessBut {
                path: shear.path.to_string(),
                written: shear.written.to_string(),
                ratio: short(ratio),
            };
            reader.slip(&shear.path, message, StackSlip::AreBothInSame);
        }
    }
    for strength in bed.cohesion.iter().chain(&bed.tension) {
        if strength.value != 0.0 && !within(strength.value, BOND_PA) {
            let message = StackSlip::ButMortarHasKpa {
                path: strength.path.to_string(),
                written: strength.written.to_string(),
            };
            let help = match strength.value < BOND_PA.0 {
                true => StackSlip::DidYouMeanKpa,
                false => StackSlip::DidYouMeanPa,
            };
            reader.slip(&strength.path, message, help);
        }
    }
    if let Some(strength) = &bed.strength
        && !within(strength.value, CRUSHES_PA)
    {
        let message = StackSlip::ButStoneCrushesAtMpa {
            path: strength.path.to_string(),
            written: strength.written.to_string(),
        };
        reader.slip(&strength.path, message, StackSlip::IsStrengthInMpa);
    }
    let shares = [
        &bed.damping_ratio,
        &bed.normal_restitution,
        &bed.rocking_restitution,
    ];
    for share in shares.into_iter().flatten().filter(|share| share.value > 1.0) {
        let message = StackSlip::ButItIsToOther {
            path: share.path.to_string(),
            written: share.written.to_string(),
        };
        let percent = short(share.value);
        reader.slip(&share.path, message, Common::IsItPerCent(percent));
    }
}
