//! Regression of a series of readings. The correlated disturbance of the readings is estimated from the same series.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | y | `readings` | frequency divided by its median, minus 1; or a tilt | - |
//! | X | `columns` | explanatory variables, one column each | |
//! | β | `coefficients` | regression coefficients | |
//! | k | `columns.len()` | number of columns | - |

use super::gram::{Gram, Likelihood};
use super::series::Series;
use super::whitening::{CORRELATION_MOST, Disturbance, Whitening};

/// Least disturbance in the search, relative to the noise of the readings. Our choice: its variance is then 0.04 % of that of the noise.
const SD_LEAST: f64 = 0.02;
/// Tolerance of the search in −2 ln of the likelihood. Our choice.
const LIKELIHOOD_STEP: f64 = 2e-3;
/// Largest number of evaluations of one search.
const EVALUATIONS_MOST: usize = 90;

/// A regression by generalised least squares.
///
/// ```text
/// β = (Xᵀ V⁻¹ X)⁻¹ Xᵀ V⁻¹ y        X: n × k, V: n × n
/// ```
#[derive(Clone, Debug)]
pub(super) struct Fit {
    pub(super) coefficients: Vec<f64>,
    /// Standard deviation of each coefficient.
    pub(super) sd: Vec<f64>,
    /// The Cholesky factor of Xᵀ V⁻¹ X, row by row.
    pub(super) factor: Vec<f64>,
    pub(super) whitening: Whitening,
    /// −2 ln of the likelihood at β, without the constant n ln 2π.
    pub(super) minus_two_ln_likelihood: f64,
}

impl Fit {
    /// Fits the regression; `None` if a column is a linear combination of the others.
    pub(super) fn new(series: &Series, columns: &[Vec<f64>], disturbance: Disturbance) -> Option<Self> {
        let k = columns.len();
        let whitening = Whitening::new(&series.at, &series.noise_sd, disturbance);
        let gram = Gram::new(series, columns, &whitening);
        let factor = gram.factor()?;
        let width = k + 1;
        // the last row of the factor is (Lₓ⁻¹ Xᵀ V⁻¹ y)ᵀ
        let right: Vec<f64> = (0..k).map(|j| factor[k * width + j]).collect();
        let of_columns: Vec<f64> = (0..k)
            .flat_map(|i| (0..k).map(move |j| (i, j)))
            .map(|(i, j)| factor[i * width + j])
            .collect();
        let coefficients = solve_upper(&of_columns, k, right);
        let sd = (0..k)
            .map(|j| {
                let unit = (0..k).map(|i| f64::from(u8::from(i == j))).collect();
                let column = solve_lower(&of_columns, unit);
                column.iter().map(|x| x * x).sum::<f64>().sqrt()
            })
            .collect();
        let rest = factor[k * width + k];
        Some(Fit {
            coefficients,
            sd,
            factor: of_columns,
            minus_two_ln_likelihood: gram.ln_determinant + rest * rest,
            whitening,
        })
    }

    /// The residuals y − X β.
    pub(super) fn residuals(&self, series: &Series, columns: &[Vec<f64>]) -> Vec<f64> {
        let explained = |i: usize| -> f64 {
            let parts = columns.iter().zip(&self.coefficients);
            parts.map(|(column, beta)| column[i] * beta).sum()
        };
        let readings = series.readings.iter().enumerate();
        readings.map(|(i, y)| y - explained(i)).collect()
    }

    /// hᵀ (Xᵀ V⁻¹ X)⁻¹ h. The function overwrites h.
    pub(super) fn form(&self, h: &mut [f64]) -> f64 {
        solve_lower_in_place(&self.factor, h);
        h.iter().map(|x| x * x).sum()
    }
}

pub(super) fn solve_lower(factor: &[f64], mut b: Vec<f64>) -> Vec<f64> {
    solve_lower_in_place(factor, &mut b);
    b
}

fn solve_lower_in_place(factor: &[f64], b: &mut [f64]) {
    let k = b.len();
    for i in 0..k {
        let known: f64 = (0..i).map(|j| factor[i * k + j] * b[j]).sum();
        b[i] = (b[i] - known) / factor[i * k + i];
    }
}

fn solve_upper(factor: &[f64], k: usize, mut b: Vec<f64>) -> Vec<f64> {
    for i in (0..k).rev() {
        let known: f64 = (i + 1..k).map(|j| factor[j * k + i] * b[j]).sum();
        b[i] = (b[i] - known) / factor[i * k + i];
    }
    b
}

/// The disturbance that maximises the restricted likelihood (REML); `None` if a column is a linear combination of the others.
///
/// The search is that of Nelder & Mead in ln s and φ, clamped to their bounds. Clamping can collapse a simplex onto a bound, where it stays.
/// Therefore a search that ends on a bound is repeated from another start, and the better result is used.
///
/// # Source
/// Patterson & Thompson (1971) Biometrika 58:545-554; Nelder & Mead (1965) Computer Journal 7:308-313.
pub(super) fn restricted_likelihood(
    series: &Series,
    columns: &[Vec<f64>],
    start: Option<Disturbance>,
) -> Option<Disturbance> {
    let n = series.len() as f64;
    let mean = series.readings.iter().sum::<f64>() / n;
    let all = series.readings.iter().map(|y| (y - mean).powi(2)).sum::<f64>() / n;
    let noise = (series.noise_sd.iter().map(|sd| sd * sd).sum::<f64>() / n).sqrt();
    let least = (SD_LEAST * noise).max(1e-6 * all.sqrt()).max(1e-12).ln();
    let most = (10.0 * all.sqrt()).max(noise).max(1e-11).ln();
    let of = |[ln_sd, correlation]: [f64; 2]| Disturbance {
        sd: ln_sd.clamp(least, most).exp(),
        correlation: correlation.clamp(0.0, CORRELATION_MOST),
    };
    let mut likelihood = Likelihood::new(series, columns);
    let mut value = |at: [f64; 2]| likelihood.criterion(of(at));
    let usual = [(0.5 * all).sqrt().max(noise).max(1e-11).ln() - 0.7, 0.3];
    let other = [usual[0] + 0.7, 0.6];
    let (first, again) = match start {
        Some(known) => ([known.sd.ln(), known.correlation], usual),
        None => (usual, other),
    };
    let mut search =
        |from: [f64; 2]| least_of(&mut value, [from[0].clamp(least, most), from[1]], [least, most]);
    let mut best = search(first)?;
    let is_inside = |[ln_sd, correlation]: [f64; 2]| {
        ln_sd > least && ln_sd < most && correlation > 0.0 && correlation < CORRELATION_MOST
    };
    if !is_inside(best.1) {
        let second = search(again)?;
        if second.0 < best.0 {
            best = second;
        }
    }
    Some(of(best.1))
}

/// Minimum found by a search from one start, and its position. ln s is clamped to its bounds, φ to 0 and its largest value.
fn least_of(
    value: &mut impl FnMut([f64; 2]) -> Option<f64>,
    start: [f64; 2],
    [least, most]: [f64; 2],
) -> Option<(f64, [f64; 2])> {
    let corners = [
        start,
        [start[0] - 0.6, start[1]],
        [start[0], start[1] + if start[1] > 0.5 { -0.3 } else { 0.3 }],
    ];
    let mut simplex = Vec::with_capacity(3);
    for corner in corners {
        simplex.push((value(corner)?, corner));
    }
    let mut evaluations = simplex.len();
    while evaluations < EVALUATIONS_MOST {
        simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
        if simplex[2].0 - simplex[0].0 < LIKELIHOOD_STEP {
            break;
        }
        let middle = [0, 1].map(|i| 0.5 * (simplex[0].1[i] + simplex[1].1[i]));
        let away = |by: f64| {
            let moved = [0, 1].map(|i| middle[i] + by * (simplex[2].1[i] - middle[i]));
            [moved[0].clamp(least, most), moved[1].clamp(0.0, CORRELATION_MOST)]
        };
        let mut tried = |by: f64| {
            evaluations += 1;
            Some((value(away(by))?, away(by)))
        };
        let reflected = tried(-1.0)?;
        if reflected.0 < simplex[0].0 {
            let further = tried(-2.0)?;
            simplex[2] = if further.0 < reflected.0 {
                further
            } else {
                reflected
            };
        } else if reflected.0 < simplex[1].0 {
            simplex[2] = reflected;
        } else {
            let inner = tried(if reflected.0 < simplex[2].0 { -0.5 } else { 0.5 })?;
            if inner.0 < simplex[2].0.min(reflected.0) {
                simplex[2] = inner;
            } else {
                let best = simplex[0].1;
                for corner in simplex.iter_mut().skip(1) {
                    let shrunk = [0, 1].map(|i| 0.5 * (best[i] + corner.1[i]));
                    evaluations += 1;
                    *corner = (value(shrunk)?, shrunk);
                }
            }
        }
    }
    simplex.sort_by(|a, b| a.0.total_cmp(&b.0));
    Some(simplex[0])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn agrees_with_a_grid_wherever_the_search_begins() {
        for seed in 0..40 {
            let mut random = Random::new(11, seed);
            let at: Vec<f64> = (0..40).map(f64::from).collect();
            let mut x = 0.0;
            let readings = at.iter().map(|t| {
                x = 0.3 * x + 1e-3 * (1.0_f64 - 0.09).sqrt() * random.normal();
                x + 1.2e-3 * random.normal() - if *t < 22.0 { 0.0 } else { 0.013 }
            });
            let series = Series {
                readings: readings.collect(),
                noise_sd: vec![1.2e-3; 40],
                at: at.clone(),
            };
            let step = at.iter().map(|t| f64::from(u8::from(*t >= 22.0))).collect();
            let columns = vec![vec![1.0; 40], step];
            let mut likelihood = Likelihood::new(&series, &columns);
            let mut value = |of| likelihood.criterion(of).unwrap();
            let mut least = f64::INFINITY;
            for i in 0..60 {
                for j in 0..=38 {
                    least = least.min(value(Disturbance {
                        sd: 5e-5 * 1.1_f64.powi(i),
                        correlation: 0.025 * f64::from(j),
                    }));
                }
            }
            // without the step, the fit ends at this bound: the disturbance explains the whole step
            let without = Disturbance {
                sd: 6e-3,
                correlation: 0.95,
            };
            for start in [None, Some(without)] {
                let found = restricted_likelihood(&series, &columns, start).unwrap();
                let above = value(found) - least;
                assert!(above < 0.1, "{seed} {start:?}: {found:?} {above}");
            }
        }
    }

    #[test]
    fn exact_without_disturbance_it_is_the_variance_of_a_sample() {
        // readings far apart are uncorrelated, and no noise is stated: REML of s² is Σ(y − mean)²/(n − 1)
        let readings = vec![1.0, 3.0, 2.0, 7.0, 4.0];
        let series = Series {
            at: (0..5).map(|i| 1e3 * f64::from(i)).collect(),
            noise_sd: vec![0.0; 5],
            readings,
        };
        let ones = vec![vec![1.0; 5]];
        let found = restricted_likelihood(&series, &ones, None).unwrap();
        let exact = (((1.0_f64 - 3.4).powi(2) + 0.16 + 1.96 + 3.6_f64.powi(2) + 0.36) / 4.0).sqrt();
        assert!((found.sd / exact - 1.0).abs() < 0.02, "{found:?} {exact}");
        let fit = Fit::new(&series, &ones, found).unwrap();
        assert!((fit.coefficients[0] - 3.4).abs() < 1e-12);
        assert!((fit.sd[0] - found.sd / 5.0_f64.sqrt()).abs() < 1e-12);
    }

    #[test]
    fn holds_noise_and_disturbance_are_told_apart() {
        let (n, phi, sd, noise) = (4000, 0.7_f64, 0.8, 0.5);
        let mut random = Random::new(3, 0);
        let mut x = sd * random.normal();
        let mut readings = Vec::new();
        for _ in 0..n {
            readings.push(x + noise * random.normal());
            x = phi * x + sd * (1.0 - phi * phi).sqrt() * random.normal();
        }
        let series = Series {
            at: (0..n).map(f64::from).collect(),
            noise_sd: vec![noise; n as usize],
            readings,
        };
        let found = restricted_likelihood(&series, &[vec![1.0; n as usize]], None).unwrap();
        assert!(
            (found.sd / sd - 1.0).abs() < 0.06 && (found.correlation - phi).abs() < 0.04,
            "{found:?}"
        );
    }

    #[test]
    fn refuses_a_column_that_follows_from_the_others() {
        let series = Series {
            at: vec![0.0, 1.0, 2.0],
            readings: vec![1.0, 2.0, 4.0],
            noise_sd: vec![0.1; 3],
        };
        let disturbance = Disturbance {
            sd: 0.1,
            correlation: 0.0,
        };
        assert!(Fit::new(&series, &[vec![1.0; 3], vec![2.0; 3]], disturbance).is_none());
    }
}
