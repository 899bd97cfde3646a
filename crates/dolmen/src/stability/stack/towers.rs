//! Towers of square boxes, and an arch, for the tests of this chapter.

use crate::structure::stack::{ArchFactors, Block, JointMaterial, Placement, Solid, Stack, arch};

pub(super) const P10: [(f64, f64); 10] = [
    (2.4, 0.5),
    (2.6, 0.25),
    (1.9, 0.9),
    (2.1, 0.25),
    (1.1, 1.1),
    (1.9, 0.5),
    (1.0, 0.45),
    (1.65, 0.45),
    (0.85, 0.40),
    (1.4, 0.40),
];

pub(super) fn p20() -> Vec<(f64, f64)> {
    let mut sizes = vec![(2.8, 0.45), (3.0, 0.25), (2.3, 0.9), (2.5, 0.25)];
    for k in 0..7 {
        let f = 1.0 - 0.085 * f64::from(k);
        sizes.push((1.25 * f, if k == 0 { 1.0 } else { 0.5 * f }));
        sizes.push((2.1 * f, 0.5 * f));
    }
    sizes.extend([(0.5, 0.3), (0.4, 0.3)]);
    sizes
}

/// Boxes (width = depth, height) bottom up, each shifted in x, 2600 kg/m³, g 9.81.
pub(super) fn shifted(sizes: &[(f64, f64)], shifts: &[f64], friction: f64) -> Stack {
    let mut z = 0.0;
    let mut blocks = Vec::new();
    for (i, &(width, height)) in sizes.iter().enumerate() {
        let place = Placement {
            position_m: [shifts.get(i).copied().unwrap_or(0.0), 0.0, z],
            ..Placement::default()
        };
        blocks.push(Block {
            name: format!("body {}", i + 1),
            solid: Solid::cuboid(width, width, height).unwrap().placed(&place),
            density_kg_m3: 2600.0,
        });
        z += height;
    }
    Stack::new(blocks, JointMaterial::with_friction(friction), 9.81).unwrap()
}

pub(super) fn tower(sizes: &[(f64, f64)], friction: f64) -> Stack {
    shifted(sizes, &[], friction)
}

/// Two boxes .4 wide, .2 and 1 high, that lean together by a slope along x: the joint between them is
/// inclined.
pub(super) fn leaning(slope: f64, friction: f64) -> Stack {
    let place = |height: f64| {
        let length = slope.hypot(1.0);
        Placement {
            tilt: [slope, 0.0],
            position_m: [height * slope / length, 0.0, height / length],
            ..Placement::default()
        }
    };
    let block = |name: &str, height: f64, at: f64| Block {
        name: name.into(),
        solid: Solid::cuboid(0.4, 0.4, height).unwrap().placed(&place(at)),
        density_kg_m3: 2600.0,
    };
    let blocks = vec![block("foot", 0.2, 0.0), block("shaft", 1.0, 0.2)];
    Stack::new(blocks, JointMaterial::with_friction(friction), 9.81).unwrap()
}

/// A round arch of three voussoirs whose joints crush.
pub(super) fn arch_that_crushes() -> Stack {
    let blocks = arch(&ArchFactors {
        span_m: 3.0,
        rise_m: 1.5,
        thickness_m: 0.45,
        depth_m: 1.0,
        voussoirs: 3,
        springing_height_m: 0.0,
        abutment_m: 0.5,
        density_kg_m3: 2500.0,
    });
    let material = JointMaterial {
        compressive_strength_pa: Some(4e5),
        ..JointMaterial::with_friction(0.6)
    };
    Stack::new(blocks.unwrap(), material, 9.81).unwrap()
}
