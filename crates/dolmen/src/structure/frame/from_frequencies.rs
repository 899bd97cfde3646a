//! All sets of storey stiffnesses that give a frame exactly the measured frequencies.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | λ_j | `lambda` | ω_j² of mode j | (rad/s)² |
//! | S | `sum` | λ1 + λ2 | (rad/s)² |
//! | Q | `product` | λ1 λ2 | (rad/s)⁴ |
//! | r | `ratio` | f2 / f1 | – |
//! | g_i | `geometric` | N_i / l_i | N/m |
//! | κ_i | `kappa` | k_i − g_i, stiffness of the spring reduced by P-delta (drift) | N/m |
//! | u, v | `u` | (k1 − g1 − g2)/m1 and (k2 − g2)/m2 (grounded) | (rad/s)² |

use super::storeys::{Convention, Frame};
use crate::structure::inverse::{FrequencyRoots, Sprung, roots_by_continuation};
use crate::structure::{StiffnessNote, StructureError};

/// Largest number of storeys for which all roots are computed: n! paths are followed, 720 for six storeys.
pub(crate) const STOREYS_EXHAUSTIVE_MOST: usize = 6;

/// All sets of n storey stiffnesses with which the frame has these n natural frequencies.
///
/// ```text
/// drift, 2 storeys:     κ2² (1/m1 + 1/m2) − S κ2 + Q m2 = 0,   κ1 = Q m1 m2 / κ2,   k_i = κ_i + g_i
///                       real if r + 1/r ≥ 2 √(1 + m2/m1)
/// grounded, 2 storeys:  u + v = S,   u v = Q + g2²/(m1 m2),    k1 = m1 u + g1 + g2,   k2 = m2 v + g2
///                       real if λ2 − λ1 ≥ 2 g2 / √(m1 m2)
/// 3 to 6, or with ties: det(diag(k) − S_j) = 0, j = 1…n, followed from diagonal S_j to full ones in complex numbers
/// ```
///
/// # Input
/// * `frequencies_hz` -- frequencies of all n modes, ascending, Hz
///
/// # Errors
/// [`StructureError::Frequencies`] unless there is one frequency per storey; [`StructureError::Mode`] and
/// [`StructureError::FrequencyOrder`] unless they are positive and ascending; [`StructureError::Storeys`] above six storeys.
///
/// # Limits
/// Roots that agree to 1e-6 are reported as one. Each root reproduces every frequency to 1e-10.
///
/// # Source
/// Park & Min (2010), sec. 3.2, solve eq. 8 for one pair of stiffnesses. Differs from the source: both pairs are returned,
/// and n storeys are allowed. There are n! complex solutions: Friedland (1977) Linear Algebra Appl. 17(1):15-51,
/// doi:10.1016/0024-3795(77)90039-8. Tested by `park_min_2010`.
///
/// # Example
/// ```
/// use dolmen::structure::{Convention, Frame, Storey, stiffness_from_frequencies};
/// let storeys = vec![
///     Storey { mass_kg: 290e3, height_m: 5.84, axial_n: 5919e3 },
///     Storey { mass_kg: 314e3, height_m: 7.69, axial_n: 3077e3 },
/// ];
/// let roots = stiffness_from_frequencies(&Frame::new(storeys, Convention::Drift)?, &[1.1, 4.2])?;
/// assert_eq!(roots.stiffness.len(), 2);
/// assert!((roots.stiffness[0][0] - 32.65e6).abs() < 5e3);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn stiffness_from_frequencies(
    frame: &Frame,
    frequencies_hz: &[f64],
) -> Result<FrequencyRoots, StructureError> {
    let n = frame.storeys().len();
    if frequencies_hz.len() != n {
        return Err(StructureError::Frequencies {
            given: frequencies_hz.len(),
            needed: n,
        });
    }
    check_ascending(frequencies_hz)?;
    let lambda: Vec<f64> = frequencies_hz
        .iter()
        .map(|f| (std::f64::consts::TAU * f).powi(2))
        .collect();
    let mut roots = match (n, frame.ties().is_empty()) {
        (1, true) => one_storey(frame, lambda[0]),
        (2, true) => match frame.convention() {
            Convention::Drift => two_storeys_drift(frame, &lambda),
            Convention::Grounded => two_storeys_grounded(frame, &lambda),
        },
        (..=STOREYS_EXHAUSTIVE_MOST, _) => roots_by_continuation(&frame.model()?, &lambda)?,
        _ => {
            return Err(StructureError::Storeys {
                given: n,
                most: STOREYS_EXHAUSTIVE_MOST,
            });
        }
    };
    roots.stiffness.sort_by(|a, b| a[0].total_cmp(&b[0]));
    Ok(roots)
}

/// Refuses frequencies that are not positive, finite and strictly ascending.
pub(super) fn check_ascending(frequencies_hz: &[f64]) -> Result<(), StructureError> {
    let mut before = 0.0;
    for (j, &given) in frequencies_hz.iter().enumerate() {
        let mode = j + 1;
        if !(given > 0.0 && given.is_finite()) {
            return Err(StructureError::Mode {
                mode,
                quantity: "frequency_hz",
                given,
                allowed: "a positive number",
            });
        }
        if given <= before {
            return Err(StructureError::FrequencyOrder { mode, given, before });
        }
        before = given;
    }
    Ok(())
}

fn one_storey(frame: &Frame, lambda: f64) -> FrequencyRoots {
    let k = lambda * frame.storeys()[0].mass_kg + frame.geometric_n_m()[0];
    FrequencyRoots {
        stiffness: vec![vec![k]],
        solutions_complex: 1,
        complete: true,
        notes: Vec::new(),
    }
}

/// Real roots of x² − b x + c = 0, computed without cancellation; one root if both are equal, none if they are complex.
fn quadratic(b: f64, c: f64) -> Vec<f64> {
    let discriminant = 0.25 * b * b - c;
    if discriminant < 0.0 {
        return Vec::new();
    }
    let large = 0.5 * b + discriminant.sqrt(); // b > 0 here
    if discriminant == 0.0 {
        vec![large]
    } else {
        vec![c / large, large]
    }
}

fn two_storeys_drift(frame: &Frame, lambda: &[f64]) -> FrequencyRoots {
    let [m1, m2] = [0, 1].map(|i| frame.storeys()[i].mass_kg);
    let geometric = frame.geometric_n_m();
    let (sum, product) = (lambda[0] + lambda[1], lambda[0] * lambda[1]);
    let compliance = 1.0 / m1 + 1.0 / m2;
    let kappas = quadratic(sum / compliance, product * m2 / compliance);
    let mut notes = Vec::new();
    if kappas.is_empty() {
        let ratio = (lambda[1] / lambda[0]).sqrt();
        notes.push(StiffnessNote::RatioBelowLeast {
            ratio,
            ratio_least: (1.0 + m2 / m1).sqrt() + (m2 / m1).sqrt(),
        });
    }
    let stiffness = |kappa2: f64| {
        let kappa1 = product * m1 * m2 / kappa2;
        vec![kappa1 + geometric[0], kappa2 + geometric[1]]
    };
    FrequencyRoots {
        stiffness: kappas.into_iter().map(stiffness).collect(),
        solutions_complex: 2,
        complete: true,
        notes,
    }
}

fn two_storeys_grounded(frame: &Frame, lambda: &[f64]) -> FrequencyRoots {
    let [m1, m2] = [0, 1].map(|i| frame.storeys()[i].mass_kg);
    let geometric = frame.geometric_n_m();
    let (sum, product) = (lambda[0] + lambda[1], lambda[0] * lambda[1]);
    let coupling = geometric[1] / (m1 * m2).sqrt();
    let us = quadratic(sum, product + coupling * coupling);
    let mut notes = Vec::new();
    if us.is_empty() {
        notes.push(StiffnessNote::DifferenceBelowLeast {
            difference_rad2_s2: lambda[1] - lambda[0],
            difference_least_rad2_s2: 2.0 * coupling,
        });
    }
    let stiffness = |u: f64| {
        vec![
            m1 * u + geometric[0] + geometric[1],
            m2 * (sum - u) + geometric[1],
        ]
    };
    FrequencyRoots {
        stiffness: us.into_iter().map(stiffness).collect(),
        solutions_complex: 2,
        complete: true,
        notes,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::structure::{Storey, Tie};

    fn random_frame(n: usize, convention: Convention, random: &mut Random) -> Frame {
        let mut axial_n = 0.0;
        let mut storeys: Vec<Storey> = (0..n)
            .map(|_| {
                let mass_kg = 1e5 * (1.0 + 4.0 * random.uniform());
                axial_n += mass_kg * 9.81;
                Storey {
                    mass_kg,
                    height_m: 3.0 + 5.0 * random.uniform(),
                    axial_n,
                }
            })
            .collect();
        storeys.reverse();
        Frame::new(storeys, convention).unwrap()
    }

    #[test]
    fn holds_every_root_reproduces_the_frequencies_and_the_truth_is_among_them() {
        let mut random = Random::new(1, 0);
        for (n, cases) in [(1, 10), (2, 300), (3, 100), (4, 12)] {
            for case in 0..cases {
                let convention = [Convention::Drift, Convention::Grounded][case % 2];
                let mut frame = random_frame(n, convention, &mut random);
                if case % 4 >= 2 {
                    let ties = vec![Tie {
                        lower: case % n,
                        upper: n,
                        stiffness_n_m: 5e6 * random.uniform(),
                    }];
                    frame = frame.with_ties(ties).unwrap();
                }
                let k: Vec<f64> = (0..n)
                    .map(|_| 3e7 * random.lognormal(1.0, 1.5).unwrap())
                    .collect();
                let modes = frame.natural_modes(&k).unwrap();
                if modes[0].omega_squared <= 0.0 {
                    continue;
                }
                let f: Vec<f64> = modes.iter().map(|m| m.frequency_hz).collect();
                let roots = stiffness_from_frequencies(&frame, &f).unwrap();
                let what = format!("{n} storeys, {convention:?}, case {case}");
                assert!(
                    roots.complete && roots.notes.is_empty(),
                    "{what}: {:?}",
                    roots.notes
                );
                let truth = |root: &Vec<f64>| root.iter().zip(&k).all(|(a, b)| (a / b - 1.0).abs() < 1e-6);
                assert_eq!(
                    roots.stiffness.iter().filter(|root| truth(root)).count(),
                    1,
                    "{what}"
                );
                for root in &roots.stiffness {
                    for (mode, f) in frame.natural_modes(root).unwrap().iter().zip(&f) {
                        assert!((mode.frequency_hz / f - 1.0).abs() < 1e-9, "{what}");
                    }
                }
            }
        }
    }
}
