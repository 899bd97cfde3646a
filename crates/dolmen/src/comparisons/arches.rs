//! Semicircular arches: the smallest thickness at which they stand.

use super::{Case, ValidationError};
use crate::assess::{StackCheckOptions, check_stack};
use crate::blocks::{ContactLaw, Rigid, SlowMovement, move_supports};
use crate::stability::Verdict;
use crate::stability::stack::{SupportMovementOptions, follow_support_movement};
use crate::structure::stack::{ArchFactors, JointMaterial, Stack, SupportMovement, arch};

const SOURCE: &str = "Semicircular arches";
const NOTE: &str = "Semicircular arches of flat-faced voussoirs that cannot slide, thickness over the radius of the middle line. Published: a \
                    linear programme of its own, hinges at the corners; its limit for many voussoirs is Milankovitch's 0.107478 (1907), not \
                    Heyman's 0.106.";
/// Number of voussoirs, and the smallest thickness over the radius.
const LEAST: [(u32, f64); 3] = [(9, 0.101525), (10, 0.107011), (17, 0.105463)];
/// Half of the last interval of the bisection, plus half of the sixth digit.
const TOLERANCE: f64 = 1e-5;

/// Increase of the span, over R, at which a spreading arch of 10 voussoirs and t/R 0.15 falls.
const SPREAD: f64 = 0.10924;
const SPREAD_NOTE: &str = "Arch of 10 voussoirs, t/R 0.15, one support moved slowly: the thrust line of half the arch, its hinges where the support has \
                           moved to, against limit analysis step by step, and against a run in time with rigid joints, which inertia lets stand 0.6 % \
                           longer.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let spread = |how: &str, computed: f64, tolerance: f64| Case {
        source: SOURCE,
        what: format!("increase of the span at collapse, {how}"),
        unit: "R",
        published: SPREAD,
        computed,
        tolerance,
        corrected: None,
        note: SPREAD_NOTE,
    };
    let mut all = vec![
        spread("limit analysis", spread_at_collapse()?, 1e-3 * SPREAD),
        spread("in time", spread_in_time()?, 0.01 * SPREAD),
    ];
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
    let least: Result<Vec<Case>, ValidationError> = LEAST.into_iter().map(case).collect();
    all.splice(0..0, least?);
    Ok(all)
}

/// The arch of 10 voussoirs with one support moved by a tenth of its radius.
fn spreading() -> Result<Stack, ValidationError> {
    let movement = SupportMovement {
        block: 9,
        movement_m: [0.1, 0.0, 0.0],
    };
    Ok(round(10, 0.15)?.with_support_movement(movement)?)
}

fn spread_at_collapse() -> Result<f64, ValidationError> {
    let found = follow_support_movement(&spreading()?, &SupportMovementOptions::default())?;
    Ok(0.1 * found.last.factor)
}

fn spread_in_time() -> Result<f64, ValidationError> {
    let stack = spreading()?;
    let law = ContactLaw::Rigid(Rigid {
        time_step_s: 5e-3,
        ..Rigid::default()
    });
    let slow = SlowMovement {
        factor_most: 1.2,
        ..SlowMovement::default()
    };
    let moved = move_supports(&stack, &law, &slow.of(&stack, &law)?, &mut |_| true)?;
    Ok(moved.gave_way.map_or(f64::NAN, |gave_way| 0.1 * gave_way.factor))
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

fn stands_at(voussoirs: u32, thickness_m: f64) -> Result<bool, ValidationError> {
    let check = check_stack(&round(voussoirs, thickness_m)?, &StackCheckOptions::default())?;
    Ok(check.verdict != Verdict::Unstable)
}

/// An arch of this thickness; the radius of its middle line is 1 m.
fn round(voussoirs: u32, thickness_m: f64) -> Result<Stack, ValidationError> {
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
    Ok(Stack::new(blocks, JointMaterial::with_friction(5.0), 9.81)?)
}
