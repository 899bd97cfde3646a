//! Closed forms of beds with a strength or damage: crushing edges, a bed that is partly lost, soft soil.

use super::{Case, ValidationError};
use crate::assess::{StackCheckOptions, check_stack};
use crate::structure::stack::{Block, JointMaterial, LostBed, SoilBelow, Solid, Stack, without_bed};

const SOURCE: &str = "Edges, beds and soil";
const NOTE: &str = "A block 0.5 × 0.8 × 2.4 m. Published: closed forms. An edge crushes over the strip N/(f l), so that the pivot lies half of it inside: \
                    (b/2 − N/(2 f l)) / h. A bed of which a fifth is lost at one side has its pivot at b/2 − b/5. \
                    On soil without tension whose rocking stiffness is K its footing lifts off and overturns at (b/(2 h)) (1 − (W h/K)^⅓), h the height of \
                    its centroid.";
const TOLERANCE: f64 = 1e-6;
const GRAVITY_M_S2: f64 = 9.81;
const DENSITY_KG_M3: f64 = 2600.0;
const SIZE_M: [f64; 3] = [0.5, 0.8, 2.4];

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let [width_m, depth_m, height_m] = SIZE_M;
    let block = || -> Result<Vec<Block>, ValidationError> {
        Ok(vec![Block {
            name: "block".to_owned(),
            solid: Solid::cuboid(width_m, depth_m, height_m)?,
            density_kg_m3: DENSITY_KG_M3,
        }])
    };
    let half_m = 0.5 * height_m;
    let pressure_pa = height_m * DENSITY_KG_M3 * GRAVITY_M_S2;
    let mut found = Vec::new();
    for times in [1.5, 4.0, 30.0] {
        let strength_pa = times * pressure_pa;
        let material = JointMaterial {
            compressive_strength_pa: Some(strength_pa),
            ..JointMaterial::with_friction(0.9)
        };
        let lever_m = 0.5 * width_m - 0.5 * width_m / times;
        found.push((
            format!("block, strength {times} times the pressure on its bed: first motion"),
            lever_m / half_m,
            first_motion_g(block()?, material)?,
        ));
    }
    let lost = LostBed {
        block: 0,
        share: 0.2,
        outward: [1.0, 0.0],
    };
    found.push((
        "block, a fifth of its bed lost at one side: first motion".to_owned(),
        (0.5 - 0.2) * width_m / half_m,
        first_motion_g(without_bed(block()?, &lost)?, JointMaterial::with_friction(0.9))?,
    ));
    let fall_n_m = pressure_pa * width_m * depth_m * half_m;
    for times in [5.0, 50.0] {
        let soil = SoilBelow {
            rocking_stiffness_n_m_rad: times * fall_n_m,
            normal_stiffness_pa_m: times * fall_n_m * 12.0 / (depth_m * width_m.powi(3)),
            shear_stiffness_pa_m: 1e8,
        };
        let stack = Stack::new(block()?, JointMaterial::with_friction(0.9), GRAVITY_M_S2)?.with_soil(soil)?;
        let check = check_stack(&stack, &StackCheckOptions::default())?;
        found.push((
            format!("block on soil, K of {times} W h: first motion"),
            0.5 * width_m / half_m * (1.0 - (1.0_f64 / times).cbrt()),
            check.capacity.map_or(f64::NAN, |of| of.acceleration_g),
        ));
    }
    let case = |(what, published, computed): (String, f64, f64)| Case {
        source: SOURCE,
        what,
        unit: "g",
        published,
        computed,
        tolerance: TOLERANCE,
        corrected: None,
        note: NOTE,
    };
    Ok(found.into_iter().map(case).collect())
}

/// Smallest acceleration at which a stone begins to move.
fn first_motion_g(blocks: Vec<Block>, material: JointMaterial) -> Result<f64, ValidationError> {
    let stack = Stack::new(blocks, material, GRAVITY_M_S2)?;
    let check = check_stack(&stack, &StackCheckOptions::default())?;
    Ok(check.capacity.map_or(f64::NAN, |of| of.acceleration_g))
}
