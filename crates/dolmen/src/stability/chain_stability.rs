//! Whether a chain with known joint stiffness stands, and by how much.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | α_i | | rotation of joint i, θ_i − θ_{i−1} | rad |
//! | k_i | `stiffness` | spring of joint i | N m/rad |
//! | G_i, M_i | `g`, `necessary` | gravity moment of link i, and Σ_{j≥i} G_j | N m/rad |
//! | E_i | `e` | stiffness that joint i must exceed because of the joints above | N m/rad |
//! | λ | `load_factor` | smallest factor on gravity that makes K singular | |
//! | A | `springs`, `gravity` | K in joint rotations: springs minus gravity | N m/rad |

use super::{ChainStability, JointStability, StabilityError, Verdict};
use crate::structure::Chain;
use dolmen_linalg::{Matrix, cholesky, generalized_symmetric_eigen, solve};

/// Stability of a chain with the stiffness of each joint, lowest first.
///
/// ```text
/// stands ⇔ K positive definite ⇔ k_i > E_i for all i
/// E_n = G_n,  E_i = G_i + 1/(1/E_{i+1} − 1/k_{i+1})     from the top, until the first E_i ≥ k_i
/// k_i,min = k_i − 1/(b_iᵀ K⁻¹ b_i),  b_i = e_i − e_{i−1}
/// det(K_springs − λ K_gravity) = 0                      λ the smallest positive root
/// max M_i/k_i ≤ 1/λ ≤ Σ M_i/k_i                         Dunkerley
/// θ = K⁻¹ K_springs 1                                   rotations per unit of a common built-in tilt
/// moment ≤ N b/2                                        uplift, N the weight above the joint
/// ```
///
/// E_i is only the test above: k_i/E_i is **not** a margin. On the flagpole of the source at 1.03 P·H it would read
/// 1.98 and 2.14 at the upper joints where the true margins are 1.0125 and 1.0220.
///
/// # Errors
/// [`StabilityError::Structure`] for a wrong number of stiffnesses or one that is not positive,
/// [`StabilityError::Linalg`] if an eigenvalue iteration fails.
///
/// # Limits
/// Rotations are small, and joints carry moment in both directions. The uplift limit is separate, because a linear spring cannot show
/// overturning. The tilt is taken as built in (springs stress-free in the tilted shape); if it was measured on the standing chain, it already
/// includes the contribution of gravity. The recursion and the eigenvalues can differ by rounding where |λ − 1| < 1e-12; the verdict then is
/// "unstable".
///
/// # Source
/// Stability of a chain by LDLᵀ from the top; margins by a rank-one change of K. Differs from Choi (2021), whose
/// criterion is unsafe: see [`chain_limits`](super::chain_limits).
///
/// # Example
/// ```
/// use dolmen::{stability::{chain_stability, Verdict}, structure::{Chain, Inertia, Link}};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 2.0,
///     centroid_m: 1.0,
///     inertia: Inertia::ThinRod,
///     bed_width_m: Some(0.5),
/// };
/// let chain = Chain::new(vec![link], 10.0)?; // m g l = 10 kN m/rad
/// let stability = chain_stability(&chain, &[40_000.0])?;
/// assert!((stability.load_factor - 4.0).abs() < 1e-14);
/// assert_eq!(stability.joints[0].margin, Some(4.0));
/// assert_eq!(stability.verdict, Verdict::Stable);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn chain_stability(chain: &Chain, stiffness_n_m_rad: &[f64]) -> Result<ChainStability, StabilityError> {
    let k = stiffness_n_m_rad;
    let failing_joint = failing_joint(chain, k)?;
    let necessary = chain.necessary_n_m_rad();
    let n = k.len();

    let springs = springs_in_joint_rotations(chain, k)?;
    let gravity = Matrix::from_fn(n, n, |i, j| necessary[i.max(j)]);
    let a = &springs - &gravity;

    let factors = generalized_symmetric_eigen(&gravity, &springs)?.values;
    let stiffness_factor = factors.last().map_or(0.0, |&greatest| greatest.max(0.0));
    let least = |i: usize| lower_bracket(&springs, &gravity, i);
    let load_factor = 1.0 / stiffness_factor;
    let verdict = match failing_joint {
        Some(_) => Verdict::Unstable,
        None => Verdict::of_load_factor(load_factor),
    };
    let stands = verdict != Verdict::Unstable;

    // A α = A_springs α₀ with the common tilt α₀ = e_1
    let lean = match stands {
        true => Some(solve(&a, &springs.block(0, 0, n, 1))?),
        false => None,
    };
    let joint_tilt = lean.as_ref().map(|alpha| alpha.column(0));
    let joints = (0..n)
        .map(|i| {
            let moment = joint_tilt.map(|alpha| (k[i] * (alpha[i] - if i == 0 { 1.0 } else { 0.0 })).abs());
            joint(chain, &a, k, i, moment)
        })
        .collect();
    Ok(ChainStability {
        joints,
        load_factor,
        stiffness_factor,
        stiffness_factor_least: (0..n).map(least).fold(0.0, f64::max),
        stiffness_factor_most: (0..factors.len()).map(|i| factors[i]).sum(),
        failing_joint,
        lean_amplification: joint_tilt.map(running_sum).unwrap_or_default(),
        side_support_counted: side_support_counted(chain),
        verdict,
    })
}

/// The first joint from the top at which the recursion fails, numbered from 1 at the bottom; `None` if the chain stands. This is the fastest
/// exact test, because it computes no eigenvalue.
///
/// ```text
/// E_n = G_n,  E_i = G_i + 1/(1/E_{i+1} − 1/k_{i+1}),  fails at the first E_i ≥ k_i
/// ```
///
/// # Errors
/// [`StabilityError::Structure`] for a wrong number of stiffnesses or one that is not positive.
///
/// # Limits
/// E below the first failure is meaningless, and k_i/E_i is not a margin. With a side support that counts, the pivots of the whole K from the
/// top replace k_i − E_i.
pub fn failing_joint(chain: &Chain, stiffness_n_m_rad: &[f64]) -> Result<Option<usize>, StabilityError> {
    chain.check_stiffness(stiffness_n_m_rad)?;
    if side_support_counted(chain) {
        let k = chain.stiffness_matrix(stiffness_n_m_rad)?;
        return Ok(first_pivot_not_positive_from_the_top(k));
    }
    let each = chain.gravity_moments_n_m_rad().into_iter().zip(stiffness_n_m_rad);
    let mut from_above = 0.0; // E k / (E − k) inverted: 1/(1/E − 1/k) without a division by E = 0
    for (i, (g, &k)) in each.enumerate().rev() {
        let e = g + from_above;
        if e >= k {
            return Ok(Some(i + 1));
        }
        from_above = e * k / (k - e);
    }
    Ok(None)
}

fn side_support_counted(chain: &Chain) -> bool {
    chain
        .side_supports()
        .iter()
        .any(|support| support.acts_linearly())
}

/// LDLᵀ from the last row up, without pivoting: the signs of the pivots are those of the eigenvalues.
fn first_pivot_not_positive_from_the_top(mut k: Matrix) -> Option<usize> {
    for p in (0..k.rows()).rev() {
        let pivot = k[(p, p)];
        if pivot <= 0.0 {
            return Some(p + 1);
        }
        for j in 0..p {
            let factor = k[(p, j)] / pivot;
            for i in 0..p {
                k[(i, j)] -= factor * k[(i, p)];
            }
        }
    }
    None
}

/// Tᵀ K_springs T with θ = T α: θ_i = Σ_{j≤i} α_j. Diagonal except for side supports.
fn springs_in_joint_rotations(chain: &Chain, k: &[f64]) -> Result<Matrix, StabilityError> {
    let mut springs = Matrix::from_diagonal(k);
    for support in chain
        .side_supports()
        .iter()
        .filter(|support| support.acts_linearly())
    {
        let mut lever = chain.lever_m_rad(support.height_m)?;
        for i in (1..lever.len()).rev() {
            lever[i - 1] += lever[i]; // Tᵀ c: all links above joint i rotate with it
        }
        let s = support.stiffness_n_m;
        springs = &springs + &Matrix::from_fn(k.len(), k.len(), |i, j| s * lever[i] * lever[j]);
    }
    Ok(springs)
}

/// Rayleigh quotient for a rotation of joint i only: M_i/k_i, with the stiffness of a side support if it counts.
fn lower_bracket(springs: &Matrix, gravity: &Matrix, i: usize) -> f64 {
    gravity[(i, i)] / springs[(i, i)]
}

fn joint(chain: &Chain, a: &Matrix, k: &[f64], i: usize, lean_moment: Option<f64>) -> JointStability {
    let least = stiffness_least(a, k[i], i);
    let above = chain.links().iter().skip(i);
    let weight_n = chain.gravity_m_s2() * above.map(|link| link.mass_kg).sum::<f64>();
    let uplift = chain.links()[i].bed_width_m.map(|width| 0.5 * weight_n * width);
    JointStability {
        stiffness_n_m_rad: k[i],
        stiffness_least_n_m_rad: least,
        margin: least.map(|least| k[i] / least),
        lean_moment_n_m_rad: lean_moment,
        uplift_moment_n_m: uplift,
        uplift_tilt_rad: uplift.zip(lean_moment).map(|(limit, moment)| limit / moment),
    }
}

/// Smallest k_i with the other joints as given; `None` if the chain falls even with joint i rigid.
///
/// In joint rotations k_i appears only on the diagonal. So K is positive definite if and only if the remaining matrix R is, and k_i exceeds
/// k_i − (A_ii − a_iᵀ R⁻¹ a_i). This equals k_i − 1/(b_iᵀ K⁻¹ b_i), but avoids cancellation and also holds if K is singular or indefinite.
fn stiffness_least(a: &Matrix, k_i: f64, i: usize) -> Option<f64> {
    let rest = a.rows() - 1;
    let others = |j: usize| if j < i { j } else { j + 1 };
    let mut needed = k_i - a[(i, i)];
    if rest > 0 {
        let r = Matrix::from_fn(rest, rest, |p, q| a[(others(p), others(q))]);
        let lower = cholesky(&r).ok()?;
        let mut y: Vec<f64> = (0..rest).map(|p| a[(others(p), i)]).collect();
        for p in 0..rest {
            let known: f64 = (0..p).map(|q| lower[(p, q)] * y[q]).sum();
            y[p] = (y[p] - known) / lower[(p, p)];
        }
        needed += y.iter().map(|x| x * x).sum::<f64>(); // aᵀ R⁻¹ a = ‖L⁻¹ a‖²
    }
    Some(needed.max(0.0)) // below 0 only where a side support holds the chain: no stiffness of this joint is needed
}

fn running_sum(alpha: &[f64]) -> Vec<f64> {
    let add = |theta: &mut f64, a: &f64| {
        *theta += a;
        Some(*theta)
    };
    alpha.iter().scan(0.0, add).collect()
}
