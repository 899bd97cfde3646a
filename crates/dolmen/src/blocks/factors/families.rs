//! Uncoupled families of modes: in a symmetric stack, sway along x, sway along y, torsion and vertical motion are independent.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | K_g | | stiffness of the springs of factor g, [6n × 6n] |
//! | P_x | `toward_x` | mass matrix of motion along x alone, [6n × 6n] |
//! | V | `basis` | eigenvectors of a mixture of all K_g and P_x, Vᵀ M V = 1 |
//!
//! Eigenvectors of a mixture with unrelated weights span the common invariant subspaces of all its matrices: Vᵀ K_g V has one block for
//! each. Within a family the frequency of each order increases with every factor (Courant–Fischer). Modes of different families may cross.

use super::super::matrices::SpringsBetween;
use super::stack_motion::StackMotion;
use super::unknowns::Unknowns;
use dolmen_linalg::{
    LinalgError, Matrix, SymmetricEigen, generalized_symmetric_eigen, symmetric_eigen, symmetric_eigenvalues,
};

/// Coupling below which motions count as uncoupled, over the geometric mean of their stiffness. Our choice: the position of rest is
/// accurate to 1e-7 of the weight, and the error of a frequency is the square of this.
const COUPLED: f64 = 1e-5;

/// Energy share above which a mode of a coupled family belongs to one motion: the larger part.
const MOSTLY: f64 = 0.5;

/// Motions that are coupled with each other and with no others.
pub(super) struct Family {
    /// Basis, [6n × d], orthonormal in M.
    pub(super) basis: Matrix,
    /// Stiffness without a factor, [d × d].
    others: Matrix,
    /// Stiffness of each factor's springs, [d × d].
    pub(super) groups: Vec<Matrix>,
    /// Kinetic energy of motion in the plane of x, in the plane of y, and of rotation about the vertical, [d × d] each.
    motions: [Matrix; 3],
}

fn index_of(motion: StackMotion) -> usize {
    match motion {
        StackMotion::X => 0,
        StackMotion::Y => 1,
        StackMotion::Torsion => 2,
    }
}

impl Family {
    fn stiffness(&self, factors: &[f64]) -> Matrix {
        let mut sum = self.others.clone();
        for (group, factor) in self.groups.iter().zip(factors) {
            for (entry, own) in sum.as_mut_slice().iter_mut().zip(group.as_slice()) {
                *entry += factor * own;
            }
        }
        sum
    }

    /// Modes in this basis, ascending, with unit modal mass.
    pub(super) fn modes(&self, factors: &[f64]) -> Result<SymmetricEigen, LinalgError> {
        symmetric_eigen(&self.stiffness(factors))
    }

    /// ω² of the mode with a given order, rad²/s².
    pub(super) fn square_of(&self, factors: &[f64], order: usize) -> Option<f64> {
        let all = symmetric_eigenvalues(&self.stiffness(factors)).ok()?;
        all.get(order).copied()
    }

    /// Fraction of the kinetic energy of a mode in a motion.
    pub(super) fn share(&self, mode: &[f64], motion: StackMotion) -> f64 {
        self.motions[index_of(motion)].form(mode, mode)
    }

    /// Orders of the modes in which a motion predominates, ascending.
    pub(super) fn orders_of(&self, modes: &SymmetricEigen, motion: StackMotion) -> Vec<usize> {
        let is_of = |order: &usize| self.share(modes.vectors.column(*order), motion) > MOSTLY;
        (0..modes.values.len()).filter(is_of).collect()
    }

    /// A mode of this basis as displacements and rotations of the stones.
    pub(super) fn displacements(&self, mode: &[f64]) -> Vec<f64> {
        self.basis.times(mode)
    }
}

pub(super) fn families(unknowns: &Unknowns) -> Result<Vec<Family>, LinalgError> {
    let size = unknowns.mass.rows();
    let mut mixture = Matrix::zeros(size, size);
    for springs in &unknowns.others {
        add(&mut mixture, springs, 1.0);
    }
    for (at, group) in unknowns.groups.iter().enumerate() {
        // multiples of the golden ratio: no two are equal or related
        let weight = 0.5 + (0.618_033_988_749_895 * (at + 1) as f64).fract();
        for springs in &group.springs {
            add(&mut mixture, springs, weight);
        }
    }
    let mean_square = (0..size).map(|i| mixture[(i, i)]).sum::<f64>()
        / (0..size).map(|i| unknowns.mass[(i, i)]).sum::<f64>();
    for x in (0..size).step_by(6) {
        mixture[(x, x)] += mean_square * unknowns.mass[(x, x)];
    }
    let mixed = generalized_symmetric_eigen(&mixture, &unknowns.mass)?;
    let in_basis = |springs: &[SpringsBetween]| {
        let mut sum = Matrix::zeros(size, size);
        for one in springs {
            add_in_basis(&mut sum, one, &mixed.vectors);
        }
        sum
    };
    let others = in_basis(&unknowns.others);
    let groups: Vec<Matrix> = unknowns
        .groups
        .iter()
        .map(|group| in_basis(&group.springs))
        .collect();
    let toward_x = Matrix::from_fn(size, size, |p, q| {
        let along = |i: usize| unknowns.mass[(i, i)] * mixed.vectors[(i, p)] * mixed.vectors[(i, q)];
        mean_square * (0..size).step_by(6).map(along).sum::<f64>()
    });
    let motions =
        [vec![0, 4], vec![1, 3], vec![5]].map(|rows| energy_in(&unknowns.mass, &mixed.vectors, &rows));
    let all = || groups.iter().chain([&others, &toward_x]);
    let is_coupled = |p: usize, q: usize| {
        let scale = (mixed.values[p].abs() * mixed.values[q].abs()).sqrt();
        all().any(|matrix| matrix[(p, q)].abs() > COUPLED * scale)
    };
    let families = connected(size, is_coupled).into_iter().map(|of| {
        let part = |matrix: &Matrix| Matrix::from_fn(of.len(), of.len(), |i, j| matrix[(of[i], of[j])]);
        Family {
            basis: Matrix::from_fn(size, of.len(), |i, j| mixed.vectors[(i, of[j])]),
            others: part(&others),
            groups: groups.iter().map(part).collect(),
            motions: [0, 1, 2].map(|at| part(&motions[at])),
        }
    });
    Ok(families.collect())
}

/// Vᵀ M V restricted to these rows of every block.
fn energy_in(mass: &Matrix, vectors: &Matrix, rows: &[usize]) -> Matrix {
    let size = mass.rows();
    let momentum = mass * vectors;
    let kept: Vec<usize> = (0..size).filter(|i| rows.contains(&(i % 6))).collect();
    let of = |matrix: &Matrix| Matrix::from_fn(kept.len(), size, |i, p| matrix[(kept[i], p)]);
    of(vectors).transpose_times(&of(&momentum))
}

/// Row and column of a body in the global matrices; `None` for the ground.
fn first_row(body: usize) -> Option<usize> {
    Some(6 * body.checked_sub(1)?)
}

fn add(matrix: &mut Matrix, springs: &SpringsBetween, weight: f64) {
    for (a, row) in springs.bodies.iter().enumerate() {
        for (b, column) in springs.bodies.iter().enumerate() {
            let (Some(row), Some(column)) = (first_row(*row), first_row(*column)) else {
                continue;
            };
            for i in 0..6 {
                for j in 0..6 {
                    matrix[(row + i, column + j)] += weight * springs.stiffness[(6 * a + i, 6 * b + j)];
                }
            }
        }
    }
}

/// Adds Vᵀ K V of springs between two bodies.
fn add_in_basis(sum: &mut Matrix, springs: &SpringsBetween, vectors: &Matrix) {
    let size = vectors.columns();
    let rows = springs.bodies.map(first_row);
    let of_both = Matrix::from_fn(12, size, |i, p| {
        rows[i / 6].map_or(0.0, |row| vectors[(row + i % 6, p)])
    });
    let forces = &springs.stiffness * &of_both;
    let product = of_both.transpose_times(&forces);
    for (entry, own) in sum.as_mut_slice().iter_mut().zip(product.as_slice()) {
        *entry += own;
    }
}

/// Sets of indices that are coupled directly or indirectly, each ascending.
fn connected(size: usize, is_coupled: impl Fn(usize, usize) -> bool) -> Vec<Vec<usize>> {
    let mut left: Vec<usize> = (0..size).collect();
    let mut sets = Vec::new();
    while let Some(first) = left.first().copied() {
        left.remove(0);
        let mut set = vec![first];
        let mut at = 0;
        while at < set.len() {
            let from = set[at];
            let (with, without): (Vec<usize>, Vec<usize>) =
                left.iter().partition(|&&other| is_coupled(from, other));
            set.extend(with);
            left = without;
            at += 1;
        }
        set.sort_unstable();
        sets.push(set);
    }
    sets
}
