//! Stability of a frame: P-delta against storey stiffness.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ | `load_factor` | factor on all axial forces at which the frame falls | – |
//! | K_E, K_G | `elastic`, `geometric` | stiffness of the springs; its reduction by P-delta | N/m |
//! | k_i | `stiffness_n_m` | spring of storey i | N/m |
//! | k_i,min | `stiffness_least_n_m` | k_i at which the frame just stands, all other springs as given | N/m |

use super::{StabilityError, Verdict};
use crate::structure::{Convention, Frame};
use dolmen_linalg::{LinalgError, Matrix, cholesky, generalized_symmetric_eigen, solve};

/// One storey of a frame with known stiffness.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct StoreyStability {
    /// k_i, N/m.
    pub stiffness_n_m: f64,
    /// N_i / l_i, the reduction by P-delta, N/m.
    pub geometric_n_m: f64,
    /// Smallest k_i at which the frame stands, with the other storeys as given; 0 if it stands without k_i, `None` if it falls for any k_i.
    pub stiffness_least_n_m: Option<f64>,
    /// k_i / k_i,min; infinite if the frame stands without k_i.
    pub margin: Option<f64>,
}

/// Stability of a frame with known storey stiffness.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FrameStability {
    /// The storeys, lowest first.
    pub storeys: Vec<StoreyStability>,
    /// λ, smallest factor on the axial forces that makes K singular; infinite without axial force.
    pub load_factor: f64,
    /// Displacements of the levels in the buckling shape at λ, the largest 1; empty without axial force, or if λ is 0.
    pub falling_shape: Vec<f64>,
    /// Whether the frame is stable, marginal or unstable.
    pub verdict: Verdict,
}

/// Stability of a frame with springs of this stiffness, and the margins of its storeys.
///
/// ```text
/// λ:        smallest λ > 0 with det(K_E − λ K_G) = 0: 1/λ is the largest μ of K_G φ = μ K_E φ
/// k_i,min:  A_ii = A_iO A_OO⁻¹ A_Oi − k_i,min,  A = K at k_i = 0 in the coordinates of the springs, O the other springs
/// drift without ties:   λ = min k_i l_i / N_i,   k_i,min = N_i / l_i
/// ```
///
/// # Errors
/// [`StabilityError::Structure`] unless there is one stiffness, 0 or positive, a storey.
///
/// # Limits
/// Drifts are small and springs linear: a storey of tenons that opens at large drift has less capacity. A margin is for one storey alone; if all
/// stiffnesses are wrong by the same factor, λ is the margin.
///
/// # Source
/// Park & Min (2010) give the matrix (eq. 7); λ, k_i,min and the verdict are not in it.
///
/// # Example
/// ```
/// use dolmen::stability::{frame_stability, Verdict};
/// use dolmen::structure::{Convention, Frame, Storey};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let stability = frame_stability(&Frame::new(storeys, Convention::Drift)?, &[32.65e6, 96.14e6])?;
/// assert!((stability.load_factor - 32.65e6 * 5.84 / 5919e3).abs() < 1e-9);
/// assert_eq!(stability.verdict, Verdict::Stable);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn frame_stability(frame: &Frame, stiffness_n_m: &[f64]) -> Result<FrameStability, StabilityError> {
    let elastic = frame.elastic_matrix(stiffness_n_m)?;
    let (load_factor, falling_shape) = load_factor(&elastic, &frame.geometric_matrix())?;
    let geometric = frame.geometric_n_m();
    let mut storeys = Vec::with_capacity(stiffness_n_m.len());
    for (i, (&stiffness_n_m_i, geometric_n_m)) in stiffness_n_m.iter().zip(geometric).enumerate() {
        let stiffness_least_n_m = least_stiffness(frame, stiffness_n_m, i)?;
        storeys.push(StoreyStability {
            stiffness_n_m: stiffness_n_m_i,
            geometric_n_m,
            stiffness_least_n_m,
            margin: stiffness_least_n_m.map(|least| {
                if least > 0.0 {
                    stiffness_n_m_i / least
                } else {
                    f64::INFINITY
                }
            }),
        });
    }
    Ok(FrameStability {
        storeys,
        load_factor,
        falling_shape,
        verdict: Verdict::of_load_factor(load_factor),
    })
}

/// λ with its shape; λ = 0 if the frame falls without axial force.
fn load_factor(elastic: &Matrix, geometric: &Matrix) -> Result<(f64, Vec<f64>), StabilityError> {
    match cholesky(elastic) {
        Ok(_) => {}
        Err(LinalgError::NotPositiveDefinite { .. }) => return Ok((0.0, Vec::new())),
        Err(fault) => return Err(fault.into()),
    }
    if geometric.as_slice().iter().all(|&x| x == 0.0) {
        return Ok((f64::INFINITY, Vec::new()));
    }
    let eigen = match generalized_symmetric_eigen(geometric, elastic) {
        Ok(eigen) => eigen,
        Err(LinalgError::NotPositiveDefinite { .. }) => return Ok((0.0, Vec::new())),
        Err(fault) => return Err(fault.into()),
    };
    let last = eigen.values.len() - 1; // ascending; positive, since K_G is not 0
    let shape = eigen.vectors.column(last);
    let largest = shape
        .iter()
        .fold(0.0_f64, |most, &y| if y.abs() > most.abs() { y } else { most });
    let shape = shape.iter().map(|y| y / largest).collect();
    Ok((1.0 / eigen.values[last], shape))
}

/// k_i,min by the Schur complement of the other springs; `None` if their matrix is not positive definite.
fn least_stiffness(frame: &Frame, stiffness: &[f64], i: usize) -> Result<Option<f64>, StabilityError> {
    let n = stiffness.len();
    let mut without = stiffness.to_vec();
    without[i] = 0.0;
    let k = frame.stiffness_matrix(&without)?;
    let a = match frame.convention() {
        Convention::Grounded => k,
        // Y = C δ, C = 1 on and below the diagonal: Cᵀ K C acts on the drifts
        Convention::Drift => {
            let c = Matrix::from_fn(n, n, |row, column| if column <= row { 1.0 } else { 0.0 });
            c.transpose_times(&(&k * &c))
        }
    };
    let others: Vec<usize> = (0..n).filter(|&j| j != i).collect();
    if others.is_empty() {
        return Ok(Some((-a[(i, i)]).max(0.0)));
    }
    let a_oo = Matrix::from_fn(n - 1, n - 1, |r, c| a[(others[r], others[c])]);
    let a_oi = Matrix::from_fn(n - 1, 1, |r, _| a[(others[r], i)]);
    match dolmen_linalg::cholesky(&a_oo) {
        Ok(_) => {}
        Err(LinalgError::NotPositiveDefinite { .. }) => return Ok(None),
        Err(fault) => return Err(fault.into()),
    }
    let complement = a[(i, i)] - a_oi.transpose_times(&solve(&a_oo, &a_oi)?)[(0, 0)];
    Ok(Some((-complement).max(0.0)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::structure::{Storey, Tie};
    use dolmen_linalg::symmetric_eigenvalues;

    fn frame(axial_n: &[f64], convention: Convention) -> Frame {
        let storeys = axial_n.iter().map(|&axial_n| Storey {
            mass_kg: 3e5,
            height_m: 5.0,
            axial_n,
        });
        Frame::new(storeys.collect(), convention).unwrap()
    }

    #[test]
    fn exact_drift_frame_falls_storey_by_storey() {
        let frame = frame(&[6e6, 4e6, 1e6], Convention::Drift);
        let s = frame_stability(&frame, &[2.4e6, 1e6, 9e6]).unwrap();
        // k l / N = 2, 1.25, 45
        assert!((s.load_factor - 1.25).abs() < 1e-14);
        assert_eq!(s.verdict, Verdict::Marginal);
        for (storey, margin) in s.storeys.iter().zip([2.0, 1.25, 45.0]) {
            assert!((storey.stiffness_least_n_m.unwrap() / storey.geometric_n_m - 1.0).abs() < 1e-9);
            assert!((storey.margin.unwrap() / margin - 1.0).abs() < 1e-9);
        }
        for (y, expected) in s.falling_shape.iter().zip([0.0, 1.0, 1.0]) {
            assert!((y - expected).abs() < 1e-9, "{:?}", s.falling_shape);
        }
    }

    #[test]
    fn exact_grounded_two_storeys_by_determinant() {
        // k1,min = g1 + g2 + g2² / (k2 − g2), k2,min = g2 + g2² / (k1 − g1 − g2)
        let frame = frame(&[6e6, 4e6], Convention::Grounded);
        let [g1, g2, k1, k2] = [1.2e6, 0.8e6, 3e6, 1.5e6];
        let s = frame_stability(&frame, &[k1, k2]).unwrap();
        let least = [g1 + g2 + g2 * g2 / (k2 - g2), g2 + g2 * g2 / (k1 - g1 - g2)];
        for (storey, least) in s.storeys.iter().zip(least) {
            assert!((storey.stiffness_least_n_m.unwrap() / least - 1.0).abs() < 1e-12);
        }
        // det(K_E − λ K_G) = g1 g2 λ² − (k1 g2 + k2 (g1 + g2)) λ + k1 k2
        let (a, b, c) = (g1 * g2, k1 * g2 + k2 * (g1 + g2), k1 * k2);
        let exact = 2.0 * c / (b + (b * b - 4.0 * a * c).sqrt());
        assert!((s.load_factor / exact - 1.0).abs() < 1e-12);
    }

    #[test]
    fn holds_load_factor_and_least_stiffness_agree_with_eigenvalues() {
        let mut random = Random::new(20, 0);
        for case in 0..2000 {
            let n = 1 + case % 6;
            let mut axial: Vec<f64> = (0..n).map(|_| 6e6 * random.uniform()).collect();
            axial.sort_by(|a, b| b.total_cmp(a));
            let convention = [Convention::Drift, Convention::Grounded][case / 6 % 2];
            let mut frame = frame(&axial, convention);
            if case % 3 == 0 {
                let ties = vec![Tie {
                    lower: 0,
                    upper: n,
                    stiffness_n_m: 1e6 * random.uniform(),
                }];
                frame = frame.with_ties(ties).unwrap();
            }
            let k: Vec<f64> = (0..n).map(|_| 4e6 * random.uniform()).collect();
            let s = frame_stability(&frame, &k).unwrap();
            let least = |k: &[f64]| symmetric_eigenvalues(&frame.stiffness_matrix(k).unwrap()).unwrap()[0];
            assert_eq!(s.load_factor > 1.0, least(&k) > 0.0, "case {case}");
            for (i, storey) in s.storeys.iter().enumerate() {
                let at = |value: f64| {
                    let mut changed = k.clone();
                    changed[i] = value;
                    least(&changed)
                };
                match storey.stiffness_least_n_m {
                    None => assert!(at(1e12) < 0.0, "case {case}"),
                    Some(0.0) => assert!(at(0.0) >= 0.0, "case {case}"),
                    Some(least) => {
                        assert!(at(least * (1.0 + 1e-6)) > 0.0, "case {case}");
                        assert!(at(least * (1.0 - 1e-6)) < 0.0, "case {case}");
                    }
                }
            }
        }
    }

    #[test]
    fn holds_without_axial_force_nothing_is_said_of_stability() {
        let s = frame_stability(&frame(&[0.0, 0.0], Convention::Drift), &[1.0, 1.0]).unwrap();
        assert_eq!((s.load_factor, s.verdict), (f64::INFINITY, Verdict::Unknown));
        assert_eq!(s.storeys[0].margin, Some(f64::INFINITY));
        assert!(s.falling_shape.is_empty());
    }

    #[test]
    fn exact_without_a_spring_it_falls() {
        let s = frame_stability(&frame(&[1.0, 1.0], Convention::Drift), &[1.0, 0.0]).unwrap();
        assert_eq!((s.load_factor, s.verdict), (0.0, Verdict::Unstable));
        assert_eq!(s.storeys[0].stiffness_least_n_m, None);
        assert_eq!(s.storeys[1].margin, Some(0.0));
    }

    #[test]
    fn refuses_the_wrong_number_of_stiffnesses() {
        let fault = frame_stability(&frame(&[1.0, 1.0], Convention::Drift), &[1.0]).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "stiffness_n_m has 1 values, but the frame has 2 storeys"
        );
    }
}
