//! Quadratic response surface by ridge regression. The penalty is the one with the smallest leave-one-out error.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | z | `z` | coordinates, standardised: minus the mean, divided by the standard deviation | d |
//! | Φ | `features` | 1, z_i, z_i z_j | n × p, p = 1 + d + d(d+1)/2 |
//! | κ | `penalty` | penalty of all terms except the constant | – |
//! | M | `inverse` | (ΦᵀΦ + κ I₀)⁻¹ | p × p |
//! | h_i | `leverage` | φ_iᵀ M φ_i | – |

use super::kriging::{dot, variance_left_out};
use crate::assess::AssessError;
use dolmen_linalg::{Matrix, solve};

/// Candidate penalties, in units of the number of points: from a negligible one to one that makes the surface flat. Our choice.
const PENALTIES: [f64; 9] = [1e-8, 1e-6, 1e-5, 1e-4, 1e-3, 1e-2, 3e-2, 1e-1, 3e-1];
/// Standard deviation below which a coordinate counts as constant.
const SPREAD_LEAST: f64 = 1e-12;

#[derive(Clone, Debug)]
pub(super) struct Surface {
    middle: Vec<f64>,
    spread: Vec<f64>,
    coefficients: Vec<f64>,
    /// Mean square of the leave-one-out prediction errors.
    left_out_variance: f64,
    /// 1 − `left_out_variance` / (leave-one-out variance of y). At 0 or below, the surface explains nothing.
    pub(super) explained: f64,
}

impl Surface {
    /// Fits the surface to points `x` (n × d, row by row) with values `y`. Constant coordinates are left out, unless `used` selects
    /// them.
    ///
    /// # Errors
    /// [`AssessError::TooFewDesigns`] for fewer than 3 points; the error of a failed solution.
    pub(super) fn fit(x: &[[f64; 6]], y: &[f64], used: u32) -> Result<Self, AssessError> {
        let n = x.len();
        if n < 3 {
            return Err(AssessError::TooFewDesigns { given: n, least: 3 });
        }
        let count = n as f64;
        let (mut middle, mut spread) = (vec![0.0; 6], vec![0.0; 6]);
        for axis in (0..6).filter(|axis| used & (1 << axis) != 0) {
            middle[axis] = x.iter().map(|point| point[axis]).sum::<f64>() / count;
            let squares = x.iter().map(|point| (point[axis] - middle[axis]).powi(2));
            let sd = (squares.sum::<f64>() / count).sqrt();
            spread[axis] = if sd > SPREAD_LEAST { sd } else { 0.0 };
        }
        let mut surface = Surface {
            middle,
            spread,
            coefficients: Vec::new(),
            left_out_variance: f64::INFINITY,
            explained: 0.0,
        };
        let rows: Vec<Vec<f64>> = x.iter().map(|point| surface.features(point)).collect();
        let fit = ridge(&rows, y)?;
        (surface.left_out_variance, surface.coefficients) = (fit.left_out_variance, fit.coefficients);
        let alone = variance_left_out(y);
        surface.explained = if alone > 0.0 {
            1.0 - surface.left_out_variance / alone
        } else {
            0.0
        };
        Ok(surface)
    }

    fn features(&self, x: &[f64; 6]) -> Vec<f64> {
        let axes = self.middle.iter().zip(&self.spread).zip(x);
        let z: Vec<f64> = axes
            .filter(|((_, spread), _)| **spread > 0.0)
            .map(|((middle, spread), x)| (x - middle) / spread)
            .collect();
        let mut features = vec![1.0];
        features.extend(&z);
        for (i, a) in z.iter().enumerate() {
            features.extend(z[i..].iter().map(|b| a * b));
        }
        features
    }

    pub(super) fn value(&self, x: &[f64; 6]) -> f64 {
        dot(&self.features(x), &self.coefficients)
    }
}

/// Coefficients with the penalty that predicts left-out points best.
pub(super) struct Ridge {
    pub(super) coefficients: Vec<f64>,
    /// Mean square of the leave-one-out prediction errors.
    pub(super) left_out_variance: f64,
}

/// Ridge regression of `y` on `rows`; the first feature is not penalised.
///
/// # Errors
/// A failed solution.
pub(super) fn ridge(rows: &[Vec<f64>], y: &[f64]) -> Result<Ridge, AssessError> {
    let (n, p) = (rows.len(), rows.first().map_or(0, Vec::len));
    let count = n as f64;
    let features = Matrix::from_fn(n, p, |i, j| rows[i][j]);
    let gram = features.transpose_times(&features);
    let right = features.transpose_times(&Matrix::from_column(y));
    let mut best = Ridge {
        coefficients: Vec::new(),
        left_out_variance: f64::INFINITY,
    };
    for penalty in PENALTIES {
        let penalised = Matrix::from_fn(p, p, |i, j| {
            let extra = if i == j && i > 0 { penalty * count } else { 0.0 };
            gram[(i, j)] + extra
        });
        let inverse = solve(&penalised, &Matrix::identity(p))?;
        let coefficients = inverse.times(right.column(0));
        let missed = rows.iter().zip(y).map(|(row, y)| {
            let leverage = inverse.form(row, row).min(1.0 - 1e-9);
            ((y - dot(row, &coefficients)) / (1.0 - leverage)).powi(2)
        });
        let left_out_variance = missed.sum::<f64>() / count;
        if left_out_variance < best.left_out_variance {
            best = Ridge {
                coefficients,
                left_out_variance,
            };
        }
    }
    Ok(best)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn points(count: usize) -> Vec<[f64; 6]> {
        let mut random = Random::new(3, 0);
        (0..count)
            .map(|_| std::array::from_fn(|_| random.uniform()))
            .collect()
    }

    #[test]
    fn exact_quadratics_are_found_again() {
        let of = |x: &[f64; 6]| 2.0 - x[0] + 3.0 * x[1] * x[4] - 0.5 * x[3] * x[3];
        let x = points(60);
        let y: Vec<f64> = x.iter().map(of).collect();
        let surface = Surface::fit(&x, &y, 0b11_1111).unwrap();
        assert!(surface.explained > 1.0 - 1e-8, "{}", surface.explained);
        let place = [0.3, 0.7, 0.1, 0.9, 0.5, 0.4];
        assert!((surface.value(&place) - of(&place)).abs() < 1e-4);
    }

    #[test]
    fn holds_left_out_points_are_what_a_fit_without_them_predicts() {
        let x = points(40);
        let mut random = Random::new(4, 0);
        let y: Vec<f64> = x.iter().map(|x| x[0] + 0.1 * random.normal()).collect();
        let surface = Surface::fit(&x, &y, 0b11).unwrap();
        // reference: the fit with the same features is solved again without each point in turn
        let rows: Vec<Vec<f64>> = x.iter().map(|point| surface.features(point)).collect();
        let p = rows[0].len();
        let missed = |penalty: f64, out: usize| {
            let without: Vec<usize> = (0..40).filter(|i| *i != out).collect();
            let features = Matrix::from_fn(39, p, |i, j| rows[without[i]][j]);
            let mut gram = features.transpose_times(&features);
            for i in 1..p {
                gram[(i, i)] += penalty * 40.0;
            }
            let right: Vec<f64> = without.iter().map(|i| y[*i]).collect();
            let right = features.transpose_times(&Matrix::from_column(&right));
            let solved = solve(&gram, &right).unwrap();
            (dot(&rows[out], solved.column(0)) - y[out]).powi(2)
        };
        let variances = PENALTIES.map(|penalty| (0..40).map(|out| missed(penalty, out)).sum::<f64>() / 40.0);
        let least = variances.into_iter().fold(f64::INFINITY, f64::min);
        assert!((least - surface.left_out_variance).abs() < 1e-10);
    }

    #[test]
    fn holds_noise_is_not_explained() {
        let x = points(120);
        let mut random = Random::new(5, 0);
        let y: Vec<f64> = (0..120).map(|_| random.normal()).collect();
        let surface = Surface::fit(&x, &y, 0b11_1111).unwrap();
        assert!(surface.explained < 0.1, "{}", surface.explained);
        assert!(Surface::fit(&x[..2], &y[..2], 1).is_err());
    }
}
