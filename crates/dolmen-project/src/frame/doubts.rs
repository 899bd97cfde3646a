//! Patterns over all storeys of a frame that look like a slip.

use super::part::{Axial, FramePart, SlipForces};
use crate::doubted::Doubted;
use crate::reader::Reader;
use crate::usual::mass_kg;
use crate::usual_numbers::ratio;
use dolmen::known::STANDARD_GRAVITY_M_S2;

/// Relative distance from gravity, or its inverse, within which the ratio of axial forces and weights suggests tf for kN. Our choice.
const NEAR: f64 = 0.35;

/// Compares axial forces with weights, of all storeys together: each axial force is the sum of the forces in the storey's columns.
pub(crate) fn doubt_frame(reader: &mut Reader, part: &FramePart) {
    let forces: Vec<f64> = part
        .storeys
        .iter()
        .filter_map(|storey| Some(storey.axial_force.as_ref()?.value))
        .collect();
    doubt_friction(reader, part);
    if part.axial == Axial::FromMasses || forces.len() != part.storeys.len() {
        return;
    }
    let masses: Vec<f64> = part
        .storeys
        .iter()
        .map(|storey| mass_kg(&storey.heaviness, part.gravity_m_s2))
        .collect();
    let above = |values: &[f64], i: usize| values[i..].iter().sum::<f64>();
    let shares: Vec<f64> = (0..forces.len())
        .map(|i| {
            let force = match part.axial {
                Axial::Level => above(&forces, i),
                Axial::Storey | Axial::FromMasses => forces[i],
            };
            force / (above(&masses, i) * part.gravity_m_s2)
        })
        .collect();
    let near = |factor: f64| {
        shares
            .iter()
            .all(|share| *share > 0.0 && (share / factor).ln().abs() < NEAR)
    };
    if near(STANDARD_GRAVITY_M_S2) || near(1.0 / STANDARD_GRAVITY_M_S2) {
        let mean = shares.iter().sum::<f64>() / shares.len() as f64;
        reader.doubt("storeys", Doubted::AxialFactor(ratio(mean)));
    }
}

/// Friction that depends on an axial force of 0.
fn doubt_friction(reader: &mut Reader, part: &FramePart) {
    let forces = part
        .storeys
        .iter()
        .filter_map(|storey| storey.axial_force.as_ref());
    let Some(none) = forces.clone().find(|force| force.value == 0.0) else {
        return;
    };
    let is_whole = match part.axial {
        Axial::Storey => true,
        Axial::Level => forces.clone().all(|force| force.value == 0.0),
        Axial::FromMasses => false,
    };
    let frictions = part
        .directions
        .iter()
        .filter_map(|direction| direction.friction.as_ref());
    for friction in frictions.filter(|_| is_whole) {
        let SlipForces::Coefficient { kinetic, .. } = &friction.slip else {
            continue;
        };
        let (path, coefficient) = (none.path.clone(), kinetic.path.clone());
        reader.doubt(
            &kinetic.path,
            Doubted::FrictionWithoutWeight { path, coefficient },
        );
    }
}
