//! Limits of a chain's joints from weights and lengths alone: the published ones and the exact one.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | G_i | `g` | gravity moment per rotation of link i with all links above it | N m/rad |
//! | k_cr | `critical` | published critical stiffness, eqs 38–42 | N m/rad |
//! | P_i H_i | `buckling` | published buckling stiffness, eq. 43 | N m/rad |
//! | M_i | `necessary` | Σ_{j≥i} G_j | N m/rad |
//! | 1/λ | | common factor on given stiffnesses at which the chain just stands | |

use super::{ChainLimits, StabilityError};
use crate::structure::Chain;
use dolmen_linalg::{Matrix, symmetric_eigenvalues};

/// Published and exact limits of the joints, lowest first.
///
/// ```text
/// k_cr,n = G_n    k_cr,i = G_i − k_cr,i+1              published, eqs 38–42: each diagonal of K is 0
/// P_i H_i = (Σ_{j≥i} w_j)(Σ_{j≥i} L_j)                 published, eq. 43
/// M_i = Σ_{j≥i} G_j                                    exact for joint i with every other joint rigid
/// 1/λ = greatest eigenvalue of M_max(i,j) / √(k_i k_j)  common factor on stiffnesses k at which the chain just stands
/// ```
///
/// # Errors
/// [`StabilityError::Linalg`] if an eigenvalue iteration fails.
///
/// # Limits
/// None of the vectors is sufficient: each joint needs at least M_i, and all joints together need 1/λ times M_i (2.48 times for the flagpole
/// of the source).
///
/// # Source
/// Choi (2021), eqs 38–43. Differs from the source: it calls k_cr conservative. A symmetric matrix with a zero
/// diagonal and a non-zero off-diagonal is indefinite, so a chain with k_cr falls; it needs 4.74 times those
/// stiffnesses on the flagpole of the source.
///
/// # Example
/// ```
/// use dolmen::{stability::chain_limits, structure::{Chain, Inertia, Link}};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 2.0,
///     centroid_m: 1.0,
///     inertia: Inertia::ThinRod,
///     bed_width_m: None,
/// };
/// let limits = chain_limits(&Chain::new(vec![link.clone(), link], 10.0)?)?;
/// assert_eq!(limits.published_critical_n_m_rad, [20_000.0, 10_000.0]);
/// assert_eq!(limits.necessary_n_m_rad, [40_000.0, 10_000.0]);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn chain_limits(chain: &Chain) -> Result<ChainLimits, StabilityError> {
    let g = chain.gravity_moments_n_m_rad();
    let critical = published_critical(&g);
    let buckling = published_buckling(chain);
    let necessary = chain.necessary_n_m_rad();
    let published_critical_factor = match critical.iter().all(|&k| k > 0.0) {
        true => Some(stiffness_factor(&necessary, &critical)?),
        false => None,
    };
    Ok(ChainLimits {
        published_ratio: buckling.iter().zip(&critical).map(|(b, c)| b / c).collect(),
        published_eigenvalues_n_m_rad: symmetric_eigenvalues(&stiffness_without_diagonal(&critical))?,
        published_critical_factor,
        published_buckling_factor: stiffness_factor(&necessary, &buckling)?,
        necessary_factor: if necessary.iter().all(|&m| m > 0.0) {
            stiffness_factor(&necessary, &necessary)?
        } else {
            f64::INFINITY // the centre of mass of the top link lies on its joint: M_n = 0 leaves that joint free
        },
        equal_joints_n_m_rad: stiffness_factor(&necessary, &vec![1.0; g.len()])?,
        gravity_moment_n_m_rad: g,
        published_critical_n_m_rad: critical,
        published_buckling_n_m_rad: buckling,
        necessary_n_m_rad: necessary,
    })
}

/// k_cr,i = G_i − k_cr,i+1, from the top.
fn published_critical(g: &[f64]) -> Vec<f64> {
    let mut critical = g.to_vec();
    for i in (1..g.len()).rev() {
        critical[i - 1] -= critical[i];
    }
    critical
}

/// Weight above each joint times the height of the top above the joint.
fn published_buckling(chain: &Chain) -> Vec<f64> {
    let gravity = chain.gravity_m_s2();
    let (mut weight, mut height) = (0.0, 0.0);
    let mut buckling = vec![0.0; chain.links().len()];
    for (slot, link) in buckling.iter_mut().zip(chain.links()).rev() {
        weight += link.mass_kg * gravity;
        height += link.length_m;
        *slot = weight * height;
    }
    buckling
}

/// 1/λ for joint stiffnesses k > 0. In joint rotations, the springs are diagonal and gravity is M_max(i,j).
fn stiffness_factor(necessary: &[f64], k: &[f64]) -> Result<f64, StabilityError> {
    let n = k.len();
    let a = Matrix::from_fn(n, n, |i, j| necessary[i.max(j)] / (k[i] * k[j]).sqrt());
    let values = symmetric_eigenvalues(&a)?;
    Ok(values.last().copied().unwrap_or(0.0))
}

/// K with the published k_cr: its diagonal is 0 by their definition.
fn stiffness_without_diagonal(critical: &[f64]) -> Matrix {
    let n = critical.len();
    Matrix::from_fn(n, n, |i, j| {
        if i.abs_diff(j) == 1 {
            -critical[i.max(j)]
        } else {
            0.0
        }
    })
}
