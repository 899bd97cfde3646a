//! A mesh of two stones that is cut at their bed: volumes and first motion against values by hand.

use super::{Case, ValidationError};
use crate::assess::{StackCheckOptions, check_stack};
use crate::structure::stack::{Block, JointMaterial, Sliced, Solid, Stack, slice};

const SOURCE: &str = "A scan cut into stones";
const NOTE: &str = "One closed mesh of a frustum, 0.8 m wide below and 0.4 m above, 0.3 m high, and on it a post of 0.4 × 0.4 × 0.8 m that has moved by 30 mm; \
                    the bed is given 4 mm too high. Published: arithmetic; the post tips over the edge of the frustum at 0.17 m / 0.4 m.";
/// Half widths, heights and centres of the rings of corners, m.
const RINGS: [[f64; 3]; 4] = [
    [0.4, 0.0, 0.0],
    [0.2, 0.3, 0.0],
    [0.2, 0.3, 0.03],
    [0.2, 1.1, 0.03],
];
/// Height of the bed as measured with a tape, m.
const NAMED_M: f64 = 0.304;
/// Largest difference: the cut is 1 µm away from a step.
const TOLERANCE: f64 = 1e-5;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let (vertices, triangles) = mesh();
    let sliced = slice(&vertices, &triangles, &[NAMED_M])?;
    let case = |what: &str, unit: &'static str, published: f64, computed: f64| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit,
        published,
        computed,
        tolerance: TOLERANCE,
        corrected: None,
        note: NOTE,
    };
    let bed_m = sliced.beds.first().map_or(f64::NAN, |bed| bed.at_m);
    let volume = |number: usize| {
        sliced
            .stones
            .get(number)
            .map_or(f64::NAN, |stone| stone.volume_m3)
    };
    Ok(vec![
        case("height of the bed", "m", 0.3, bed_m),
        case("volume of the frustum", "m³", 0.112, volume(0)),
        case("volume of the post", "m³", 0.128, volume(1)),
        case("all stones over the whole", "", 1.0, sliced.volume_ratio),
        case("first motion", "g", 0.425, first_motion_g(&sliced)?),
    ])
}

/// Surface mesh of both stones: rings of four corners, connected, with a lid at the bottom and at the
/// top.
fn mesh() -> (Vec<[f64; 3]>, Vec<[usize; 3]>) {
    let corners = [[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
    let ring = |[half, z, off]: [f64; 3]| corners.map(|[x, y]| [off + half * x, half * y, z]);
    let vertices = RINGS.into_iter().flat_map(ring).collect();
    let mut triangles = vec![[0, 2, 1], [0, 3, 2], [12, 13, 14], [12, 14, 15]];
    for low in [0, 4, 8] {
        for at in 0..4 {
            let (here, next) = (low + at, low + (at + 1) % 4);
            triangles.extend([[here, next, next + 4], [here, next + 4, here + 4]]);
        }
    }
    (vertices, triangles)
}

fn first_motion_g(sliced: &Sliced) -> Result<f64, ValidationError> {
    let mut blocks = Vec::new();
    for stone in &sliced.stones {
        blocks.push(Block {
            name: format!("stone {}", stone.course + 1),
            solid: Solid::mesh(&stone.vertices_m, &stone.triangles)?,
            density_kg_m3: 2600.0,
        });
    }
    let material = JointMaterial::with_friction(3.0); // so large that the stone tips before it slides
    let stack = Stack::new(blocks, material, 9.806_65)?;
    let check = check_stack(&stack, &StackCheckOptions::default())?;
    Ok(check
        .limits
        .governing
        .map_or(f64::NAN, |first| first.threshold.acceleration_g))
}
