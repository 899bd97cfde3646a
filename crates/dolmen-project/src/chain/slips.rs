//! Probable slips in a chain.

use super::part::{ChainPart, JointPart, LinkPart};
use super::side_supports::judge_side_supports;
use super::stone::judge_stone;
use crate::heaviness::Heaviness;
use crate::measure::Measure;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::soil::judge_soil;
use crate::usual::{
    beside_neighbour, beside_others, guess, mass_kg, median_of_others, odd_ones, rounded, rounded_length,
    unit_of, within,
};
use crate::written::short;
use crate::wrong::{Slip, WrongChain};
use dolmen_words::message::Both;

/// Density of stone for comparison with a link, kg/m³: granite 2600, marble 2700, sandstone 2300.
const STONE_KG_M3: f64 = 2500.0;
/// Mass per length of a stone shaft half a metre wide, kg/m: of two unlike links the one further from it is doubtful.
const SHAFT_KG_M: f64 = 600.0;
/// Ratio of the mass per length of a link to the median of the others, either way.
const LINK_RATIO_MOST: f64 = 200.0;
/// Side of a link, as a square block of stone, over the height of the whole.
const LINK_SIDE_TO_HEIGHT: (f64, f64) = (0.004, 1.5);
const LINK_LENGTH_M: (f64, f64) = (0.005, 100.0);
/// Ratio of the length of a link to the median of the others, either way.
const LENGTH_RATIO_MOST: f64 = 100.0;
/// Least height of a centre of mass above the lower joint, over the length; 0 is allowed.
const CENTROID_SHARE_LEAST: f64 = 0.02;
/// Density of a link with a breadth, assumed square in plan, kg/m³: from hollow timber to solid iron, each with a margin.
const BOX_DENSITY_KG_M3: (f64, f64) = (20.0, 50_000.0);
/// Radius of gyration over the larger of length and side as a block of stone: 0.29 for rod and block.
const GYRATION: (f64, f64) = (0.03, 3.0);
/// Width of a bed over the side of its link as a block of stone.
const BED_RATIO_MOST: f64 = 30.0;
/// Moment of friction of a joint over weight × height above it.
const FRICTION_SHARE: [f64; 2] = [1e-5, 1.0];
/// Least stiffness of a joint over weight × height above it: 1 is about what keeps a chain upright.
const JOINT_SHARE_LEAST: f64 = 0.01;
/// Ratio of this value to the median for the other joints, either way.
const JOINT_RATIO_MOST: f64 = 300.0;

pub(crate) fn judge_chain(reader: &mut Reader, chain: &ChainPart) {
    let lengths: Vec<&Quantity> = chain.links.iter().map(|link| &link.length).collect();
    if judge_lengths(reader, &lengths) {
        // Everything below divides by lengths.
        return;
    }
    let masses: Vec<f64> = chain
        .links
        .iter()
        .map(|link| mass_kg(&link.heaviness, chain.gravity_m_s2))
        .collect();
    let before = reader.faults.len();
    judge_link_masses(reader, chain, &masses);
    for (i, (link, mass_kg)) in chain.links.iter().zip(&masses).enumerate() {
        let joint = chain.joints.as_ref().and_then(|joints| joints.get(i));
        let bed_depth = joint.and_then(|joint| joint.bed_depth.as_ref());
        judge_link(reader, link, bed_depth, *mass_kg);
    }
    if judge_unit_of_weights(reader, chain, &masses, before) {
        return;
    }
    judge_joints(reader, chain, &masses);
    let weight_n = masses.iter().sum::<f64>() * chain.gravity_m_s2;
    let height_m = lengths.iter().map(|length| length.value).sum();
    judge_side_supports(reader, &chain.side_supports, weight_n, height_m);
    if let Some(stone) = &chain.stone {
        judge_stone(reader, stone);
    }
    if let Some(soil) = &chain.soil {
        let lowest = chain.links.first();
        let bed = lowest.and_then(|link| link.bed_width.as_ref().or(link.breadth.as_ref()));
        judge_soil(reader, &soil.shear_modulus, Some(&soil.footing), bed);
    }
}

/// Whether a length of a link is a probable slip.
fn judge_lengths(reader: &mut Reader, lengths: &[&Quantity]) -> bool {
    let values: Vec<f64> = lengths.iter().map(|length| length.value).collect();
    let odd = odd_ones(&values, LENGTH_RATIO_MOST, 1.0);
    let before = reader.faults.len();
    for (i, length) in lengths.iter().enumerate() {
        let (least, most) = LINK_LENGTH_M;
        if within(length.value, LINK_LENGTH_M) && !odd.contains(&i) {
            continue;
        }
        let beside = beside_neighbour(lengths, i, Slip::Link).map(Both::from);
        let beside = beside.unwrap_or_else(|| {
            Both::from(WrongChain::LinksAreToM {
                least: least.to_string(),
                most: most.to_string(),
            })
        });
        let message = beside_others(length, beside);
        let ratio = if length.value > 1.0 { 1000.0 } else { 0.001 };
        reader.slip(&length.path, message, guess(ratio, unit_of(length)));
    }
    reader.faults.len() > before
}

fn judge_link_masses(reader: &mut Reader, chain: &ChainPart, masses: &[f64]) {
    let height_m: f64 = chain.links.iter().map(|link| link.length.value).sum();
    let per_length: Vec<f64> = masses
        .iter()
        .zip(&chain.links)
        .map(|(mass, link)| mass / link.length.value)
        .collect();
    let odd = odd_ones(&per_length, LINK_RATIO_MOST, SHAFT_KG_M);
    let given: Vec<&Quantity> = chain.links.iter().map(|link| link.heaviness.quantity()).collect();
    for (i, quantity) in given.iter().enumerate() {
        let side_m = (per_length[i] / STONE_KG_M3).sqrt();
        let share = side_m / height_m;
        if odd.contains(&i) {
            let median = median_of_others(&per_length, i).unwrap_or(SHAFT_KG_M);
            let beside = beside_neighbour(&given, i, Slip::Link).map_or_else(|| Both::from(""), Both::from);
            let message = beside_others(quantity, beside);
            reader.slip(
                &quantity.path,
                message,
                guess(per_length[i] / median, unit_of(quantity)),
            );
        } else if !within(share, LINK_SIDE_TO_HEIGHT) {
            let message = WrongChain::AsStoneLinkWould {
                path: quantity.path.to_string(),
                written: quantity.written.to_string(),
                side_m: rounded_length(side_m),
                height_m: rounded_length(height_m),
            };
            let ratio = if share > 1.0 { 1000.0 } else { 0.001 };
            reader.slip(&quantity.path, message, guess(ratio, unit_of(quantity)));
        }
    }
}

/// Whether all weights, or all masses, have a mistake in the unit that the file gives for them. It is then reported once, in place of the
/// faults found since `before`.
fn judge_unit_of_weights(reader: &mut Reader, chain: &ChainPart, masses: &[f64], before: usize) -> bool {
    let (key, measure) = match chain.links.first().map(|link| &link.heaviness) {
        Some(Heaviness::Weight(_)) => ("units.force", Measure::Force),
        Some(Heaviness::Mass(_)) => ("units.mass", Measure::Mass),
        None => return false,
    };
    let unit = reader.bare_unit(measure).0.to_owned();
    let given: Vec<&Quantity> = chain.links.iter().map(|link| link.heaviness.quantity()).collect();
    let is_refused = |of: &Quantity| reader.faults[before..].iter().any(|fault| fault.path == of.path);
    let are_all = given.len() > 1 && given.iter().all(|of| unit_of(of) == unit && is_refused(of));
    // a key that is not written cannot be wrong
    if !are_all || reader.place(key).is_empty() {
        return false;
    }
    let height_m: f64 = chain.links.iter().map(|link| link.length.value).sum();
    let mass_kg: f64 = masses.iter().sum();
    let side_m = (mass_kg / (STONE_KG_M3 * height_m)).sqrt();
    let ratio = if side_m > height_m { 1000.0 } else { 0.001 };
    reader.faults.truncate(before);
    let message = WrongChain::AllWeights {
        key: key.to_owned(),
        unit: unit.clone(),
        side_m: rounded_length(side_m),
        height_m: rounded_length(height_m),
    };
    reader.slip(key, message, guess(ratio, &unit));
    true
}

fn judge_link(reader: &mut Reader, link: &LinkPart, bed_depth: Option<&Quantity>, mass_kg: f64) {
    let length_m = link.length.value;
    let side_m = (mass_kg / (STONE_KG_M3 * length_m)).sqrt();
    let share = link.centroid.value / length_m;
    if share > 0.0 && share < CENTROID_SHARE_LEAST {
        let centroid = &link.centroid;
        let message = WrongChain::IsOfLinkS {
            path: centroid.path.to_string(),
            written: centroid.written.to_string(),
            share: rounded(share),
        };
        reader.slip(&centroid.path, message, guess(0.001, unit_of(centroid)));
    }
    if let Some(breadth) = &link.breadth {
        let depth = link.depth.as_ref().unwrap_or(breadth);
        let density = mass_kg / (length_m * breadth.value * depth.value);
        if !within(density, BOX_DENSITY_KG_M3) {
            let message = WrongChain::LinkSDensityWould {
                path: breadth.path.to_string(),
                written: breadth.written.to_string(),
                density: rounded(density),
            };
            reader.slip(
                &breadth.path,
                message,
                guess((STONE_KG_M3 / density).sqrt(), unit_of(breadth)),
            );
        }
    }
    if let Some(inertia) = &link.inertia {
        let gyration = (inertia.value / mass_kg).sqrt() / length_m.max(side_m);
        if !within(gyration, GYRATION) {
            let radius_m = (inertia.value / mass_kg).sqrt();
            let message = WrongChain::LinkSRadiusOf {
                path: inertia.path.to_string(),
                written: inertia.written.to_string(),
                radius_m: rounded_length(radius_m),
                length_m: short(length_m),
            };
            let help = WrongChain::ThinRodOfThis(
                ({
                    let (unit, factor) = reader.bare_unit(Measure::Inertia);
                    format!(
                        "{} {unit}",
                        rounded_length(mass_kg * length_m * length_m / 12.0 / factor)
                    )
                })
                .to_string(),
            );
            reader.slip(&inertia.path, message, help);
        }
    }
    for bed in link.bed_width.iter().chain(bed_depth) {
        let ratio = bed.value / side_m;
        if !within(ratio, (1.0 / BED_RATIO_MOST, BED_RATIO_MOST)) {
            let message = WrongChain::LinkWouldBeM {
                path: bed.path.to_string(),
                written: bed.written.to_string(),
                side_m: rounded_length(side_m),
            };
            reader.slip(&bed.path, message, guess(ratio, unit_of(bed)));
        }
    }
}

fn judge_joints(reader: &mut Reader, chain: &ChainPart, masses: &[f64]) {
    let Some(joints) = &chain.joints else {
        return;
    };
    let above = |i: usize| {
        let weight_n = masses[i..].iter().sum::<f64>() * chain.gravity_m_s2;
        let height_m = chain.links[i..].iter().map(|link| link.length.value).sum::<f64>();
        weight_n * height_m
    };
    let count = joints.len().min(masses.len());
    judge_friction(reader, &joints[..count], &above);
    let shares: Vec<f64> = (0..count).map(|i| joints[i].stiffness.value / above(i)).collect();
    let odd = odd_ones(&shares, JOINT_RATIO_MOST, 1.0);
    let along = (0..count).map(|i| (i, &joints[i].stiffness, !odd.contains(&i)));
    // across a joint is beside itself along
    let across = (0..count).filter_map(|i| {
        let across = joints[i].stiffness_across.as_ref()?;
        let ratio = across.value / joints[i].stiffness.value;
        Some((
            i,
            across,
            within(ratio, (1.0 / JOINT_RATIO_MOST, JOINT_RATIO_MOST)),
        ))
    });
    for (i, stiffness, is_usual) in along.chain(across) {
        let share = stiffness.value / above(i);
        if share >= JOINT_SHARE_LEAST && is_usual {
            continue;
        }
        let product = reader.echo(above(i), Measure::JointStiffness);
        let message = WrongChain::IsWeightTimesHeight {
            path: stiffness.path.to_string(),
            written: stiffness.written.to_string(),
            share: rounded(share),
            product: product.to_string(),
        };
        let help = WrongChain::JointThatKeepsChain;
        reader.slip(&stiffness.path, message, help.to_owned());
    }
}

fn judge_friction(reader: &mut Reader, joints: &[JointPart], above: &dyn Fn(usize) -> f64) {
    for (i, joint) in joints.iter().enumerate() {
        let Some(friction) = &joint.friction else {
            continue;
        };
        for moment in [Some(&friction.kinetic), friction.fixed.as_ref()]
            .into_iter()
            .flatten()
        {
            let share = moment.value / above(i);
            if moment.value == 0.0 || (FRICTION_SHARE[0]..=FRICTION_SHARE[1]).contains(&share) {
                continue;
            }
            let product = reader.echo(above(i), Measure::Moment);
            let message = WrongChain::IsWeightTimesHeightAbove {
                path: moment.path.to_string(),
                written: moment.written.to_string(),
                share: rounded(share),
                product: product.to_string(),
            };
            let help = WrongChain::FrictionHoldsSmallPart;
            reader.slip(&moment.path, message, help.to_owned());
        }
    }
}
