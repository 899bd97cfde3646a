//! The lowest modes of many stones. The matrix contains only pairs in contact, and only the requested modes are computed.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | K, M | – | stiffness of the contacts, mass, [6n × 6n] |
//! | L | `by_root` | M = L Lᵀ, stone by stone |
//! | s | `SHIFT` | added to all ω² |
//! | A | [`Inverse`] | Lᵀ (K + s M)⁻¹ L: its eigenvalues are 1/(ω² + s) |

use super::assembly::Assembly;
use super::beside::add_springs_beside;
use super::block_skyline::{BlockSkyline, SIX};
use super::bodies::RigidBody;
use super::matrices::{Part, add_contacts, add_mass, closed_at_rest, within_outline};
use dolmen_linalg::{LinalgError, Matrix, qr, symmetric_eigen};
use glam::{DMat3, DVec3};

/// Number of additional vectors in the iteration. Our choice: the last requested mode then converges as fast as the others.
const BESIDE: usize = 12;
/// Largest residual of A x outside the subspace, over the eigenvalue, at which a mode has converged. Our choice: shapes to 1e-9.
const RESIDUAL_MOST: f64 = 1e-9;
/// Largest number of iterations; about 20 are usual. Our choice.
const ROUNDS: usize = 200;

/// One of the lowest modes.
pub(super) struct LowMode {
    /// ω², (rad/s)².
    pub(super) square: f64,
    /// φ with φᵀ M φ = 1.
    pub(super) shape: Vec<f64>,
}

/// The lowest modes; `None` if the matrix is singular or the modes do not converge.
///
/// # Source
/// Bathe & Wilson (1972), subspace iteration. Differs from the source: scaled by the roots of the masses, so that the vectors stay
/// orthonormal.
pub(super) fn lowest(assembly: &Assembly, count: usize) -> Result<Option<Vec<LowMode>>, LinalgError> {
    let Some(inverse) = Inverse::of(assembly) else {
        return Ok(None);
    };
    let size = 6 * (assembly.bodies.len() - 1);
    let mut x = qr(&start(size, (count + BESIDE).min(size)))?.q;
    for _ in 0..ROUNDS {
        let y = inverse.times(x.clone());
        let t = x.transpose_times(&y);
        let symmetric = Matrix::from_fn(t.rows(), t.rows(), |i, j| 0.5 * (t[(i, j)] + t[(j, i)]));
        let eigen = symmetric_eigen(&symmetric)?;
        // largest first
        let order: Vec<usize> = (0..t.rows()).rev().collect();
        let turn = Matrix::from_fn(t.rows(), t.rows(), |i, j| eigen.vectors[(i, order[j])]);
        let (at, next) = (&x * &turn, &y * &turn);
        // the component outside the subspace: inside it, rounding of the largest eigenvalue would hide the smallest
        let within = &at * &at.transpose_times(&next);
        let is_done = |mode: usize| {
            let value = eigen.values[order[mode]];
            let pairs = within.column(mode).iter().zip(next.column(mode));
            let left: f64 = pairs.map(|(within, next)| (next - within).powi(2)).sum();
            left.sqrt() <= RESIDUAL_MOST * value
        };
        if (0..count).all(is_done) {
            let modes = (0..count).map(|mode| LowMode {
                square: 1.0 / eigen.values[order[mode]] - SHIFT,
                shape: massless(assembly, at.column(mode)),
            });
            return Ok(Some(modes.collect()));
        }
        x = qr(&next)?.q;
    }
    Ok(None)
}

/// Fixed pseudo-random numbers between -1 and 1 (xorshift).
fn start(rows: usize, columns: usize) -> Matrix {
    let mut state: u64 = 0x9E37_79B9_7F4A_7C15;
    Matrix::from_fn(rows, columns, |_, _| {
        state ^= state << 13;
        state ^= state >> 7;
        state ^= state << 17;
        (state >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    })
}

/// s, (rad/s)²: rigid-body motions then have a finite eigenvalue of A. Our choice: far below the first mode of any stone.
const SHIFT: f64 = 1e-3;

/// Lᵀ (K + s M)⁻¹ L.
struct Inverse<'a> {
    assembly: &'a Assembly,
    factors: BlockSkyline,
}

impl<'a> Inverse<'a> {
    /// `None` if the matrix is singular.
    fn of(assembly: &'a Assembly) -> Option<Self> {
        let mut factors = within_outline(assembly);
        add_contacts(assembly, Part::Springs, closed_at_rest(assembly), &mut factors);
        add_springs_beside(assembly, &mut factors);
        add_mass(assembly, SHIFT, &mut factors);
        factors.factor().then_some(Inverse { assembly, factors })
    }
}

impl Inverse<'_> {
    /// A X.
    fn times(&self, mut x: Matrix) -> Matrix {
        let bodies = || self.assembly.bodies.iter().skip(1);
        for column in 0..x.columns() {
            let all: &mut [[f64; SIX]] = x.column_mut(column).as_chunks_mut().0;
            for (block, body) in all.iter_mut().zip(bodies()) {
                *block = by_root(body, block, |root, part| root * part);
            }
            self.factors.solve(all);
            for (block, body) in all.iter_mut().zip(bodies()) {
                *block = by_root(body, block, |root, part| root.transpose() * part);
            }
        }
        x
    }
}

/// Root of the mass times the displacement, and the root of the inertia, transformed by `turn`, times the rotation.
fn by_root(body: &RigidBody, six: &[f64; SIX], turn: impl Fn(DMat3, DVec3) -> DVec3) -> [f64; SIX] {
    let root = body.mass.sqrt();
    let turned = turn(inertia_root(body), DVec3::new(six[3], six[4], six[5]));
    [
        root * six[0],
        root * six[1],
        root * six[2],
        turned.x,
        turned.y,
        turned.z,
    ]
}

/// φ = L⁻ᵀ y, so that φᵀ M φ = 1.
fn massless(assembly: &Assembly, y: &[f64]) -> Vec<f64> {
    let blocks = y.chunks_exact(6).zip(assembly.bodies.iter().skip(1));
    blocks
        .flat_map(|(six, body)| {
            let root = body.mass.sqrt();
            let turned = inertia_root(body).transpose().inverse() * DVec3::new(six[3], six[4], six[5]);
            [
                six[0] / root,
                six[1] / root,
                six[2] / root,
                turned.x,
                turned.y,
                turned.z,
            ]
        })
        .collect()
}

/// The lower Cholesky factor of the inertia about the current axes.
fn inertia_root(body: &RigidBody) -> DMat3 {
    let j = body.rotation * body.inertia * body.rotation.transpose();
    let xx = j.x_axis.x.sqrt();
    let (xy, xz) = (j.x_axis.y / xx, j.x_axis.z / xx);
    let yy = (j.y_axis.y - xy * xy).sqrt();
    let yz = (j.y_axis.z - xz * xy) / yy;
    let zz = (j.z_axis.z - xz * xz - yz * yz).sqrt();
    DMat3::from_cols(
        DVec3::new(xx, xy, xz),
        DVec3::new(0.0, yy, yz),
        DVec3::new(0.0, 0.0, zz),
    )
}

#[cfg(test)]
mod tests {
    use super::super::contact_points::ContactRule;
    use super::super::matrices::{contact_matrix, mass_matrix};
    use super::super::rest::settle;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

    #[test]
    fn agrees_the_inverse_within_its_outline_with_the_full_matrix() {
        let mut z = 0.0;
        let blocks = (0..6).map(|i| {
            let place = Placement {
                yaw_rad: 0.1 * f64::from(i),
                position_m: [0.01 * f64::from(i % 3), 0.0, z],
                ..Placement::default()
            };
            z += 0.3;
            Block {
                name: format!("stone {i}"),
                solid: Solid::cuboid(1.2 - 0.05 * f64::from(i), 0.9, 0.3)
                    .unwrap()
                    .placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        let stack = Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap();
        let mut assembly = Assembly::of(&stack, ContactRule::Four);
        settle(&mut assembly, &stack).unwrap();
        let inverse = Inverse::of(&assembly).unwrap();
        let (full, mass) = (
            contact_matrix(&assembly, Part::Springs, closed_at_rest(&assembly)),
            mass_matrix(&assembly),
        );
        let size = full.rows();
        // K (M^-1/2 A x) = (L x), except for s
        let x: Vec<f64> = (0..size).map(|i| ((i * i) as f64).sin()).collect();
        let y = inverse.times(Matrix::from_column(&x));
        let shape = massless(&assembly, y.column(0));
        let pushed = Matrix::from_fn(size, size, |i, j| full[(i, j)] + SHIFT * mass[(i, j)]).times(&shape);
        let blocks = x.as_chunks::<SIX>().0.iter().zip(assembly.bodies.iter().skip(1));
        let exact = blocks.flat_map(|(six, body)| by_root(body, six, |root, part| root * part));
        for (i, (found, exact)) in pushed.iter().zip(exact).enumerate() {
            assert!(
                (found - exact).abs() < 1e-6 * exact.abs().max(1.0),
                "{i}: {found} {exact}"
            );
        }
    }
}
