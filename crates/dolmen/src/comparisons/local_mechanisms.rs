//! Local mechanisms by codes against closed forms, for a wall in courses and for a portal.

use super::{Case, ValidationError};
use crate::assess::demand::{CircolareFactors, circolare_capacity};
use crate::stability::stack::{LocalMechanism, local_mechanism};
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const SOURCE: &str = "Local mechanisms";
const NOTE: &str = "Mechanisms of the limit analysis by rigid parts, as Circolare 7/2019 (C8.7.1.2.1) defines M*, e* and T_SLV; its formulas have not \
                    been held against its text. Published: closed forms. A wall of eight courses, 0.4 × 4 m, is one part: summed course by course \
                    e* would be 0.75. T_SLV with FC = 1.";
const TOLERANCE: f64 = 1e-5;
const GRAVITY_M_S2: f64 = 9.81;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let courses = (0..8).map(|i| ([0.4, 2.0, 0.5], [0.0, 0.0, 0.5 * f64::from(i)]));
    let wall = along_x(courses.collect(), 0.6)?;
    let portal = along_x(
        vec![
            ([0.4, 0.4, 2.0], [-0.8, 0.0, 0.0]),
            ([0.4, 0.4, 2.0], [0.8, 0.0, 0.0]),
            ([2.0, 0.4, 0.5], [0.0, 0.0, 2.0]),
        ],
        2.0,
    )?;
    let sure = CircolareFactors {
        confidence_factor: 1.0,
        ..CircolareFactors::default()
    };
    let period_s = wall.clone().and_then(|wall| {
        let capacity = circolare_capacity(wall, GRAVITY_M_S2, &sure);
        Some(capacity.displacement?.period_s)
    });
    let of = |found: &Option<LocalMechanism>, value: fn(&LocalMechanism) -> f64| {
        found.as_ref().map_or(f64::NAN, value)
    };
    let case = |what: &str, unit: &'static str, published: f64, computed: f64, tolerance: f64| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit,
        published,
        computed,
        tolerance,
        corrected: None,
        note: NOTE,
    };
    Ok(vec![
        case(
            "wall: α0 = b/h",
            "",
            0.1,
            of(&wall, |of| of.multiplier),
            TOLERANCE,
        ),
        case("wall: e*", "", 1.0, of(&wall, |of| of.mass_ratio), TOLERANCE),
        case(
            "wall: d0* = b/2",
            "m",
            0.2,
            of(&wall, |of| of.overturning_m.unwrap_or(f64::NAN)),
            TOLERANCE,
        ),
        case("wall: T_SLV", "s", 1.9458, period_s.unwrap_or(f64::NAN), 1e-4),
        // pillars 0.32 m³ with half the displacement of the beam, 0.4 m³
        case(
            "portal: α0 = b/h",
            "",
            0.2,
            of(&portal, |of| of.multiplier),
            TOLERANCE,
        ),
        case(
            "portal: e*",
            "",
            0.72 * 0.72 / (1.04 * 0.56),
            of(&portal, |of| of.mass_ratio),
            TOLERANCE,
        ),
    ])
}

/// The local mechanism along x of boxes, each given by [width, depth, height] and the centre of its base.
fn along_x(
    sizes: Vec<([f64; 3], [f64; 3])>,
    friction: f64,
) -> Result<Option<LocalMechanism>, ValidationError> {
    let mut blocks = Vec::new();
    for (index, ([width, depth, height], position_m)) in sizes.into_iter().enumerate() {
        let place = Placement {
            position_m,
            ..Placement::default()
        };
        blocks.push(Block {
            name: format!("stone {}", index + 1),
            solid: Solid::cuboid(width, depth, height)?.placed(&place),
            density_kg_m3: 2600.0,
        });
    }
    let stack = Stack::new(blocks, JointMaterial::with_friction(friction), GRAVITY_M_S2)?;
    Ok(local_mechanism(&stack, [1.0, 0.0])?)
}
