//! Dimensions of a dome, and what they may be.

use super::Bond;
use super::StackError;
use super::dimension::{all_positive, refused};
use std::f64::consts::PI;

/// Largest number of stones. Our choice, as for walls.
const STONES_MOST: u32 = 600;

/// What of a dome is there.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum DomePart {
    /// All of it, its rings in this bond.
    Whole(Bond),
    /// Two opposite slices, each one stone wide, with a keystone between them: what is left of a dome that has cracked along its meridians.
    Lune,
}

/// Dimensions of a spherical dome about the vertical axis through the origin.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DomeFactors {
    /// Clear diameter of the inner sphere at the springing, between opposite corners, m.
    pub span_m: f64,
    /// Rise of the inner sphere above the springing, m, at most half the span, which makes a hemisphere.
    pub rise_m: f64,
    /// Thickness along the joints, m.
    pub thickness_m: f64,
    /// Rings above each other, 1 to 40.
    pub rings: u32,
    /// Stones in a ring, 6 to 48, an even number for a lune.
    pub stones: u32,
    /// What of the dome is there.
    pub part: DomePart,
    /// Diameter of the opening at the top, between opposite corners, m; `None` for a dome closed by a keystone.
    pub oculus_m: Option<f64>,
    /// Height of the springing above the ground, on a ring of drum stones, m. With 0 the dome stands on the ground, which is allowed only for a
    /// hemisphere.
    pub drum_height_m: f64,
    /// Thickness of the drum, m, at least that of the dome. Not used if its height is 0.
    pub drum_thickness_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

pub(super) fn check(factors: &DomeFactors) -> Result<(), StackError> {
    all_positive(&[
        ("span_m", factors.span_m),
        ("rise_m", factors.rise_m),
        ("thickness_m", factors.thickness_m),
        ("drum_thickness_m", factors.drum_thickness_m),
        ("density_kg_m3", factors.density_kg_m3),
    ])?;
    if factors.rise_m > 0.5 * factors.span_m * (1.0 + 1e-12) {
        return Err(refused("rise_m", factors.rise_m, "at most half the span"));
    }
    check_counts(factors)?;
    if let Some(oculus) = factors.oculus_m
        && !(oculus > 0.0 && oculus < factors.span_m)
    {
        return Err(refused("oculus_m", oculus, "a positive number below the span"));
    }
    let lift = factors.drum_height_m;
    if !(lift >= 0.0 && lift.is_finite()) {
        return Err(refused("drum_height_m", lift, "0 or a positive number"));
    }
    if factors.rise_m < (0.5 - 1e-9) * factors.span_m && lift == 0.0 {
        let allowed = "positive for a rise below half the span: such a dome pushes outwards and needs a drum";
        return Err(refused("drum_height_m", lift, allowed));
    }
    if lift > 0.0 && factors.drum_thickness_m < factors.thickness_m {
        let allowed = "the thickness of the dome or more";
        return Err(refused("drum_thickness_m", factors.drum_thickness_m, allowed));
    }
    let alternates = 0.5 * factors.span_m * (1.0 - (PI / f64::from(factors.stones)).cos());
    if factors.part == DomePart::Whole(Bond::Running) && factors.thickness_m < 2.0 * alternates {
        let allowed = "in running bond at least span (1 − cos(180°/stones)), so that turned rings bear on each other: give more stones or straight bond";
        return Err(refused("thickness_m", factors.thickness_m, allowed));
    }
    Ok(())
}

fn check_counts(factors: &DomeFactors) -> Result<(), StackError> {
    let (rings, stones) = (factors.rings, factors.stones);
    if !(1..=40).contains(&rings) {
        return Err(refused("rings", f64::from(rings), "1 to 40"));
    }
    if !(6..=48).contains(&stones) {
        return Err(refused("stones", f64::from(stones), "6 to 48"));
    }
    let is_lune = factors.part == DomePart::Lune;
    if is_lune && !stones.is_multiple_of(2) {
        let allowed = "even for a lune, whose slices are opposite each other";
        return Err(refused("stones", f64::from(stones), allowed));
    }
    if !is_lune && rings * stones > STONES_MOST {
        let allowed = "so few that the dome has at most 600 stones";
        return Err(refused("rings", f64::from(rings), allowed));
    }
    Ok(())
}
