//! Barrel vaults and domes: the smallest thickness at which they stand.

use super::{Case, ValidationError};
use crate::stability::stack::{LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use crate::structure::stack::{
    Block, Bond, DomeFactors, DomePart, JointMaterial, Stack, VaultFactors, dome, vault,
};

const SOURCE: &str = "Vaults and domes";
const NOTE: &str = "Stones that cannot slide, thickness over the radius of the middle surface. Published: linear programmes of its own, of the section of a \
                    barrel and of one slice of a hemisphere, with and without hoop forces. Many thin slices need 0.0428.";
/// Half of the last interval of the bisection, plus half of the sixth digit.
const TOLERANCE: f64 = 1e-5;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let slices = |thickness| hemisphere(thickness, [8, 12], DomePart::Lune, None);
    let whole = |thickness| hemisphere(thickness, [4, 8], DomePart::Whole(Bond::Straight), Some(0.4));
    let case = |what: &str, published: f64, computed: f64| Case {
        source: SOURCE,
        what: format!("{what}: least thickness"),
        unit: "R",
        published,
        computed,
        tolerance: TOLERANCE,
        corrected: None,
        note: NOTE,
    };
    Ok(vec![
        case(
            "barrel of 9 courses, 2 stones each, in running bond",
            0.101525,
            least_thickness([0.095, 0.11], barrel)?,
        ),
        case(
            "two slices of a hemisphere, 8 rings of 12 stones",
            0.042778,
            least_thickness([0.04, 0.046], slices)?,
        ),
        case(
            "hemisphere with an oculus of 0.4 R, 4 rings of 8 stones",
            0.038438,
            least_thickness([0.036, 0.041], whole)?,
        ),
    ])
}

fn least_thickness(
    [mut falls, mut stands]: [f64; 2],
    made: impl Fn(f64) -> Result<Vec<Block>, ValidationError>,
) -> Result<f64, ValidationError> {
    let options = LimitAnalysis {
        shaking: Shaking::Along([1.0, 0.0]),
        ..LimitAnalysis::default()
    };
    while stands - falls > TOLERANCE {
        let middle = 0.5 * (falls + stands);
        let stack = Stack::new(made(middle)?, JointMaterial::with_friction(5.0), 9.81)?;
        match limit_analysis(&stack, &options)?.status {
            LimitAnalysisStatus::DoesNotStand => falls = middle,
            LimitAnalysisStatus::Limited(_) | LimitAnalysisStatus::Unlimited => stands = middle,
        }
    }
    Ok(0.5 * (falls + stands))
}

/// A round barrel; the radius of its middle surface is 1 m.
fn barrel(thickness_m: f64) -> Result<Vec<Block>, ValidationError> {
    let inner_m = 1.0 - 0.5 * thickness_m;
    Ok(vault(&VaultFactors {
        span_m: 2.0 * inner_m,
        rise_m: inner_m,
        thickness_m,
        length_m: 0.8,
        voussoirs: 9,
        stones: 2,
        bond: Bond::Running,
        springing_height_m: 0.0,
        abutment_m: 1.0,
        density_kg_m3: 2600.0,
    })?)
}

/// A hemisphere of these rings and stones; the radius of its middle surface is 1 m.
fn hemisphere(
    thickness_m: f64,
    [rings, stones]: [u32; 2],
    part: DomePart,
    oculus_m: Option<f64>,
) -> Result<Vec<Block>, ValidationError> {
    let inner_m = 1.0 - 0.5 * thickness_m;
    Ok(dome(&DomeFactors {
        span_m: 2.0 * inner_m,
        rise_m: inner_m,
        thickness_m,
        rings,
        stones,
        part,
        oculus_m,
        drum_height_m: 0.0,
        drum_thickness_m: 1.0,
        density_kg_m3: 2600.0,
    })?)
}
