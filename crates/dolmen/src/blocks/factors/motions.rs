//! Motion of a stack in a computed mode: along an axis, or about the vertical.

use super::stack_motion::StackMotion;
use crate::structure::stack::{Block, Stack};
use dolmen_linalg::Matrix;

/// Smallest fraction of kinetic energy along an axis for a sway mode, as for the first sway.
const SWAY_LEAST: f64 = 0.25;
/// Smallest fraction of kinetic energy in rotation about the vertical for a torsion mode. Our choice: half.
const TWIST_LEAST: f64 = 0.5;
/// Difference below which heights count as equal, m. Our choice: far below the height of any stone.
const AT_BED_M: f64 = 1e-6;

/// Whether a mode of unit modal mass has this motion. `displacements` has six values per block: displacement of the centroid, then rotation.
pub(super) fn moves(stack: &Stack, mass: &Matrix, displacements: &[f64], motion: StackMotion) -> bool {
    match motion.axis() {
        Some(axis) => sway_share(mass, displacements, axis) >= SWAY_LEAST,
        None => twist_share(stack, mass, displacements) >= TWIST_LEAST,
    }
}

fn sway_share(mass: &Matrix, displacements: &[f64], axis: usize) -> f64 {
    let along = (axis..displacements.len()).step_by(6);
    along.map(|i| mass[(i, i)] * displacements[i].powi(2)).sum()
}

/// Fraction of the kinetic energy in rotation of the blocks about the vertical through the centroid of the stack.
fn twist_share(stack: &Stack, mass: &Matrix, displacements: &[f64]) -> f64 {
    let whole = stack.mass_kg();
    let centre = [0, 1].map(|axis| {
        let of = |block: &Block| block.mass_kg() * block.solid.centroid_m()[axis];
        stack.blocks().iter().map(of).sum::<f64>() / whole
    });
    let each = stack.blocks().iter().enumerate().map(|(at, block)| {
        let moved = &displacements[6 * at..6 * at + 6];
        let [x, y] = [0, 1].map(|axis| block.solid.centroid_m()[axis] - centre[axis]);
        let (m, polar) = (block.mass_kg(), mass[(6 * at + 5, 6 * at + 5)]);
        let inertia = m * (x * x + y * y) + polar;
        let momentum = m * (x * moved[1] - y * moved[0]) + polar * moved[5];
        momentum * momentum / inertia
    });
    each.sum()
}

/// Row vector that gives the displacement along an axis at a height from the displacements of the blocks: the mean, by mass, of the stones there. At
/// the height of a bed, the stones below it count.
pub(super) fn displacement_row(stack: &Stack, height_m: f64, axis: usize) -> Vec<f64> {
    let blocks = stack.blocks();
    let mut row = vec![0.0; 6 * blocks.len()];
    if height_m <= AT_BED_M {
        return row; // the ground
    }
    let reaches = |block: &Block| {
        let [low, high] = block.solid.bounds_m();
        low[2] < height_m - AT_BED_M && height_m <= high[2] + AT_BED_M
    };
    let there: Vec<usize> = (0..blocks.len()).filter(|&at| reaches(&blocks[at])).collect();
    let whole: f64 = there.iter().map(|&at| blocks[at].mass_kg()).sum();
    for at in there {
        let weight = blocks[at].mass_kg() / whole;
        let above = height_m - blocks[at].solid.centroid_m()[2];
        row[6 * at + axis] = weight;
        // u + θ × r: θ_y z along x, −θ_x z along y
        match axis {
            0 => row[6 * at + 4] = weight * above,
            _ => row[6 * at + 3] = -weight * above,
        }
    }
    row
}
