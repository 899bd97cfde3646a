//! Semicircular arches: the least thickness at which they stand.

use super::{Case, ValidationError};
use crate::assess::{StackCheckOptions, check_stack};
use crate::stability::Verdict;
use crate::structure::stack::{ArchFactors, JointMaterial, Stack, arch};

const SOURCE: &str = "Semicircular arches";
const NOTE: &str = "Semicircular arches of flat-faced voussoirs that cannot slide, thickness over the radius of the middle line. Published: a \
                    linear programme of its own, hinges at the corners; its limit for many voussoirs is Milankovitch's 0.107478 (1907), not \
                    Heyman's 0.106.";
/// Voussoirs, and the least thickness over the radius.
const LEAST: [(u32, f64); 3] = [(9, 0.101525), (10, 0.107011), (17, 0.105463)];
/// Half of the last interval of the bisection, and of the sixth digit.
const TOLERANCE: f64 = 1e-5;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let case = |(voussoirs, published): (u32, f64)| {
        Ok(Case {
            source: SOURCE,
            what: format!("{voussoirs} voussoirs: least thickness"),
            unit: "R",
            published,
            computed: least_thickness(voussoirs)?,
            tolerance: TOLERANCE,
            corrected: None,
            note: NOTE,
        })
    };
    LEAST.into_iter().map(case).collect()
}

fn least_thickness(voussoirs: u32) -> Result<f64, ValidationError> {
    let (mut falls, mut stands) = (0.09, 0.12);
    while stands - falls > TOLERANCE {
        let middle = 0.5 * (falls + stands);
        match stands_at(voussoirs, middle)? {
            true => stands = middle,
            false => falls = middle,
        }
    }
    Ok(0.5 * (falls + stands))
}

/// Whether an arch of this thickness stands, the radius of its middle line 1 m.
fn stands_at(voussoirs: u32, thickness_m: f64) -> Result<bool, ValidationError> {
    let inner_m = 1.0 - 0.5 * thickness_m;
    let blocks = arch(&ArchFactors {
        span_m: 2.0 * inner_m,
        rise_m: inner_m,
        thickness_m,
        depth_m: 0.3,
        voussoirs,
        springing_height_m: 0.0,
        abutment_m: 1.0,
        density_kg_m3: 2600.0,
    })?;
    let stack = Stack::new(blocks, JointMaterial::with_friction(5.0), 9.81)?;
    let check = check_stack(&stack, &StackCheckOptions::default())?;
    Ok(check.verdict != Verdict::Unstable)
}
