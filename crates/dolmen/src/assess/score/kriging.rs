//! A smooth surface through scattered points: ordinary kriging whose correlation lengths and noise predict left-out points best.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | z | `z` | coordinates minus their mean, over their standard deviation | 6 |
//! | ℓ_i | `lengths` | correlation length along an axis, in standard deviations | 6 |
//! | ν | `noise` | variance of one point about the surface over the variance of the smooth part | – |
//! | K | – | k(z_i, z_j) + ν δ_ij | n × n |
//! | P | `inverse`, `ones` | K⁻¹ − K⁻¹1 (1ᵀK⁻¹1)⁻¹ 1ᵀK⁻¹ | n × n |

use crate::assess::AssessError;
use crate::numeric::{normal_quantile, quantile};
use dolmen_linalg::{Matrix, SymmetricEigen, symmetric_eigen};

/// Candidate lengths, first along all axes alike, then for each axis times these factors. Our choice.
const LENGTHS: [f64; 6] = [1.0, 1.5, 2.0, 3.0, 4.5, 7.0];
const FACTORS: [f64; 5] = [0.5, 0.7, 1.4, 2.0, 4.0];
const SWEEPS: usize = 2;
/// Another length along one axis must reduce the prediction error of left-out points to this fraction; a smaller gain may be chance.
const WORTH: f64 = 0.95;
/// Candidate noises.
const NOISES: [f64; 7] = [0.001, 0.003, 0.01, 0.03, 0.1, 0.3, 1.0];
/// Standard deviation below which a coordinate counts as constant.
const SPREAD_LEAST: f64 = 1e-12;

/// Number of parts of the designs in the cross-validation that includes the choice of lengths and noise.
const PARTS: usize = 5;
/// Fraction of the designs that the widened intervals must contain.
const HELD: f64 = 0.9;

/// Parameters of a surface, which reproduce it without a search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurfaceSettings {
    /// Correlation length along each factor, in standard deviations of the designs.
    pub lengths: [f64; 6],
    /// Variance of one design about the surface over the variance of the smooth part.
    pub noise: f64,
    /// Factor on the standard deviations of left-out designs, because these designs also determined lengths and noise. With it, 90 %
    /// intervals of a surface chosen and fitted without a fifth of the designs contain nine of ten of them; 1 or more.
    pub widened: f64,
}

/// A kriged surface y(x).
///
/// ```text
/// y = μ + g(z),   cov(g, g') = s² ( z·z' + exp(−½ Σ_i (z_i − z'_i)² / ℓ_i²) ),   μ unknown
/// error at left-out point i: (P y)_i / P_ii,   s² = mean of (P y)_i² / P_ii
/// ```
///
/// # Source
/// Ordinary kriging: Cressie, N. (1993) Statistics for Spatial Data, sec. 3.2; left-out points without refitting: Dubrule, O. (1983)
/// Math. Geol. 15(6):687–699.
#[derive(Clone, Debug)]
pub(super) struct Kriging {
    frame: Frame,
    lengths: [f64; 6],
    z: Vec<[f64; 6]>,
    mean: f64,
    /// K⁻¹ (y − μ).
    weights: Vec<f64>,
    /// K⁻¹.
    inverse: Matrix,
    /// K⁻¹ 1.
    ones: Vec<f64>,
    noise: f64,
    /// s².
    scale: f64,
}

/// Prediction of y at a point.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Predicted {
    pub(super) value: f64,
    /// Standard deviation of a new observation.
    pub(super) sd: f64,
}

/// Mean and standard deviation of each axis.
#[derive(Clone, Copy, Debug)]
struct Frame {
    middle: [f64; 6],
    spread: [f64; 6],
}

impl Frame {
    fn of(x: &[[f64; 6]]) -> Self {
        let count = x.len() as f64;
        let middle: [f64; 6] =
            std::array::from_fn(|axis| x.iter().map(|point| point[axis]).sum::<f64>() / count);
        let spread = std::array::from_fn(|axis| {
            let squares = x.iter().map(|point| (point[axis] - middle[axis]).powi(2));
            (squares.sum::<f64>() / count).sqrt()
        });
        Frame { middle, spread }
    }

    /// Constant axes are left out.
    fn place(&self, x: &[f64; 6]) -> [f64; 6] {
        std::array::from_fn(|axis| {
            if self.spread[axis] > SPREAD_LEAST {
                (x[axis] - self.middle[axis]) / self.spread[axis]
            } else {
                0.0
            }
        })
    }
}

/// k(z, z').
fn kernel(a: &[f64; 6], b: &[f64; 6], lengths: &[f64; 6]) -> f64 {
    let (mut along, mut apart) = (0.0, 0.0);
    for ((a, b), length) in a.iter().zip(b).zip(lengths) {
        along += a * b;
        apart += ((a - b) / length).powi(2);
    }
    along + (-0.5 * apart).exp()
}

/// Leave-one-out errors for one choice of correlation lengths and noise.
struct CrossValidation {
    lengths: [f64; 6],
    noise: f64,
    missed: f64,
}

impl Kriging {
    /// Fits the surface to points `x` with values `y`.
    ///
    /// # Errors
    /// [`AssessError::TooFewDesigns`] for fewer than 3 points; a failed decomposition.
    pub(super) fn fit(x: &[[f64; 6]], y: &[f64]) -> Result<Self, AssessError> {
        if x.len() < 3 {
            return Err(AssessError::TooFewDesigns {
                given: x.len(),
                least: 3,
            });
        }
        let frame = Frame::of(x);
        let z: Vec<[f64; 6]> = x.iter().map(|x| frame.place(x)).collect();
        let mut best: Option<CrossValidation> = None;
        for length in LENGTHS {
            let tried = tried(&z, y, [length; 6])?;
            if best.as_ref().is_none_or(|best| tried.missed < best.missed) {
                best = Some(tried);
            }
        }
        let mut best = best.ok_or(AssessError::TooFewDesigns { given: 0, least: 3 })?;
        for _ in 0..SWEEPS {
            for axis in (0..6).filter(|axis| frame.spread[*axis] > SPREAD_LEAST) {
                let from = best.lengths;
                for factor in FACTORS {
                    let mut lengths = from;
                    lengths[axis] *= factor;
                    let tried = tried(&z, y, lengths)?;
                    if tried.missed < WORTH * best.missed {
                        best = tried;
                    }
                }
            }
        }
        Self::with(x, y, best.lengths, best.noise)
    }

    /// Lengths, noise and widening factor of the surface through these points.
    ///
    /// # Errors
    /// As [`Kriging::fit`].
    pub(super) fn settings(x: &[[f64; 6]], y: &[f64]) -> Result<SurfaceSettings, AssessError> {
        let chosen = Self::fit(x, y)?;
        let mut over = Vec::with_capacity(y.len());
        for part in 0..PARTS {
            let is_out = |i: &usize| i % PARTS == part;
            let others: Vec<usize> = (0..y.len()).filter(|i| !is_out(i)).collect();
            let own_x: Vec<[f64; 6]> = others.iter().map(|i| x[*i]).collect();
            let own_y: Vec<f64> = others.iter().map(|i| y[*i]).collect();
            let surface = Self::fit(&own_x, &own_y)?;
            for i in (0..y.len()).filter(is_out) {
                let found = surface.predict(&x[i]);
                if found.sd > 0.0 {
                    over.push(((y[i] - found.value) / found.sd).abs());
                }
            }
        }
        let needed = match over.is_empty() {
            true => 1.0,
            false => quantile(&over, HELD)? / normal_quantile(0.5 + 0.5 * HELD)?,
        };
        Ok(SurfaceSettings {
            lengths: chosen.lengths,
            noise: chosen.noise,
            widened: needed.max(1.0),
        })
    }

    /// The surface with settings from an earlier fit.
    ///
    /// # Errors
    /// A failed decomposition.
    pub(super) fn of(x: &[[f64; 6]], y: &[f64], settings: &SurfaceSettings) -> Result<Self, AssessError> {
        let mut surface = Self::with(x, y, settings.lengths, settings.noise)?;
        surface.scale *= settings.widened * settings.widened;
        Ok(surface)
    }

    /// The surface with given lengths and noise.
    fn with(x: &[[f64; 6]], y: &[f64], lengths: [f64; 6], noise: f64) -> Result<Self, AssessError> {
        let n = x.len();
        let frame = Frame::of(x);
        let z: Vec<[f64; 6]> = x.iter().map(|x| frame.place(x)).collect();
        let eigen = decomposed(&z, &lengths)?;
        let over: Vec<f64> = eigen.values.iter().map(|value| 1.0 / (value + noise)).collect();
        let scaled = Matrix::from_fn(n, n, |i, j| eigen.vectors[(i, j)] * over[j]);
        let inverse = &scaled * &eigen.vectors.transpose();
        let ones = inverse.times(&vec![1.0; n]);
        let sum: f64 = ones.iter().sum();
        let mean = dot(&ones, y) / sum;
        let centred: Vec<f64> = y.iter().map(|y| y - mean).collect();
        let weights = inverse.times(&centred);
        let mut scale = 0.0;
        for (i, weight) in weights.iter().enumerate() {
            let own = inverse[(i, i)] - ones[i] * ones[i] / sum;
            scale += weight * weight / own / n as f64;
        }
        Ok(Kriging {
            frame,
            lengths,
            z,
            mean,
            weights,
            inverse,
            ones,
            noise,
            scale,
        })
    }

    /// y without its standard deviation.
    pub(super) fn value(&self, x: &[f64; 6]) -> f64 {
        self.mean + dot(&self.beside(&self.frame.place(x)), &self.weights)
    }

    /// The value y of a new observation at `x`, with its standard deviation.
    pub(super) fn predict(&self, x: &[f64; 6]) -> Predicted {
        let place = self.frame.place(x);
        let beside = self.beside(&place);
        let free = 1.0 - dot(&self.ones, &beside);
        let variance = kernel(&place, &place, &self.lengths) + self.noise
            - self.inverse.form(&beside, &beside)
            + free * free / self.ones.iter().sum::<f64>();
        Predicted {
            value: self.mean + dot(&beside, &self.weights),
            sd: (self.scale * variance.max(0.0)).sqrt(),
        }
    }

    /// Difference of y between `to` and `from`, with its standard deviation.
    pub(super) fn difference(&self, from: &[f64; 6], to: &[f64; 6]) -> Predicted {
        let [from, to] = [from, to].map(|x| self.frame.place(x));
        let pairs = self.beside(&from).into_iter().zip(self.beside(&to));
        let beside: Vec<f64> = pairs.map(|(from, to)| to - from).collect();
        let own = |a, b| kernel(a, b, &self.lengths);
        let free = dot(&self.ones, &beside);
        let variance =
            own(&from, &from) + own(&to, &to) - 2.0 * own(&from, &to) - self.inverse.form(&beside, &beside)
                + free * free / self.ones.iter().sum::<f64>();
        Predicted {
            value: dot(&beside, &self.weights),
            sd: (self.scale * variance.max(0.0)).sqrt(),
        }
    }

    /// Covariances with the points.
    fn beside(&self, place: &[f64; 6]) -> Vec<f64> {
        self.z.iter().map(|z| kernel(place, z, &self.lengths)).collect()
    }
}

fn decomposed(z: &[[f64; 6]], lengths: &[f64; 6]) -> Result<SymmetricEigen, AssessError> {
    let n = z.len();
    Ok(symmetric_eigen(&Matrix::from_fn(n, n, |i, j| {
        kernel(&z[i], &z[j], lengths)
    }))?)
}

/// The best noise for these lengths by leave-one-out error; one decomposition serves all noises.
fn tried(z: &[[f64; 6]], y: &[f64], lengths: [f64; 6]) -> Result<CrossValidation, AssessError> {
    let n = z.len();
    let eigen = decomposed(z, &lengths)?;
    let turned = |v: &[f64]| -> Vec<f64> { (0..n).map(|j| dot(eigen.vectors.column(j), v)).collect() };
    let (ones, values) = (turned(&vec![1.0; n]), turned(y));
    let mut best = CrossValidation {
        lengths,
        noise: NOISES[0],
        missed: f64::INFINITY,
    };
    for noise in NOISES {
        let mut diagonal = vec![0.0; n];
        let (mut of_ones, mut of_values) = (vec![0.0; n], vec![0.0; n]);
        for j in 0..n {
            let over = 1.0 / (eigen.values[j] + noise);
            let column = eigen.vectors.column(j);
            for (((q, diagonal), of_ones), of_values) in column
                .iter()
                .zip(&mut diagonal)
                .zip(&mut of_ones)
                .zip(&mut of_values)
            {
                *diagonal += q * q * over;
                *of_ones += q * ones[j] * over;
                *of_values += q * values[j] * over;
            }
        }
        let sum: f64 = of_ones.iter().sum();
        let mean = of_values.iter().sum::<f64>() / sum;
        let missed = diagonal.iter().zip(&of_ones).zip(&of_values);
        let missed: f64 = missed
            .map(|((own, one), value)| ((value - mean * one) / (own - one * one / sum)).powi(2))
            .sum();
        if missed < best.missed {
            (best.noise, best.missed) = (noise, missed);
        }
    }
    Ok(best)
}

/// Mean square of the difference between each value and the mean of the others.
pub(super) fn variance_left_out(y: &[f64]) -> f64 {
    let count = y.len() as f64;
    let mean = y.iter().sum::<f64>() / count;
    let own = y.iter().map(|y| ((y - mean) * count / (count - 1.0)).powi(2));
    own.sum::<f64>() / count
}

pub(super) fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
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

    /// Simple points that another program can reproduce.
    fn plain(count: usize) -> (Vec<[f64; 6]>, Vec<f64>) {
        let x: Vec<[f64; 6]> = (0..count)
            .map(|i| std::array::from_fn(|axis| ((i + 1) as f64 * (axis as f64 + 1.3)).sin()))
            .collect();
        let y = x.iter().map(|x| x[0] - 2.0 * x[1] * x[2] + x[5].exp()).collect();
        (x, y)
    }

    const LENGTHS_OF_TEST: [f64; 6] = [1.0, 2.0, 1.5, 4.0, 3.0, 2.5];

    /// scikit-learn 1.9.1, GaussianProcessRegressor with ConstantKernel(1e8) + DotProduct(0) + RBF(lengths), alpha .02, no optimiser.
    #[test]
    fn agrees_with_another_program() {
        let (x, y) = plain(12);
        let surface = Kriging::with(&x, &y, LENGTHS_OF_TEST, 0.02).unwrap();
        let found = surface.predict(&[0.2, -0.4, 0.5, 0.1, -0.3, 0.6]);
        assert!((found.value - 4.876_728_6).abs() < 1e-6, "{found:?}");
        let sd_over_scale = found.sd / surface.scale.sqrt();
        // standard deviation of the surface: without the noise of one observation
        let own = (sd_over_scale.powi(2) - 0.02).sqrt();
        assert!((own - 2.464_452).abs() < 1e-6, "{own}");
    }

    /// Leave-one-out predictions by the formula without refitting.
    fn left_out(surface: &Kriging, y: &[f64]) -> Vec<f64> {
        let sum: f64 = surface.ones.iter().sum();
        let own = |i: usize| surface.inverse[(i, i)] - surface.ones[i].powi(2) / sum;
        let points = y.iter().zip(&surface.weights).enumerate();
        points.map(|(i, (y, weight))| y - weight / own(i)).collect()
    }

    /// Explained fraction of the variance, by leave-one-out predictions.
    fn explained(surface: &Kriging, y: &[f64]) -> f64 {
        let missed = left_out(surface, y)
            .into_iter()
            .zip(y)
            .map(|(out, y)| (out - y).powi(2));
        1.0 - missed.sum::<f64>() / y.len() as f64 / variance_left_out(y)
    }

    #[test]
    fn holds_left_out_points_are_what_a_fit_without_them_predicts() {
        let (x, y) = plain(25);
        let surface = Kriging::with(&x, &y, LENGTHS_OF_TEST, 0.05).unwrap();
        for out in [0, 7, 24] {
            // scaled by all points, so that the lengths have the same meaning
            let others: Vec<usize> = (0..25).filter(|i| *i != out).collect();
            let k = Matrix::from_fn(24, 24, |i, j| {
                let noise = if i == j { 0.05 } else { 0.0 };
                kernel(&surface.z[others[i]], &surface.z[others[j]], &LENGTHS_OF_TEST) + noise
            });
            let right = Matrix::from_fn(24, 2, |i, j| if j == 0 { 1.0 } else { y[others[i]] });
            let solved = dolmen_linalg::solve(&k, &right).unwrap();
            let mean = solved.column(1).iter().sum::<f64>() / solved.column(0).iter().sum::<f64>();
            let own: f64 = others
                .iter()
                .enumerate()
                .map(|(row, i)| {
                    let weight = solved.column(1)[row] - mean * solved.column(0)[row];
                    weight * kernel(&surface.z[*i], &surface.z[out], &LENGTHS_OF_TEST)
                })
                .sum();
            assert!((mean + own - left_out(&surface, &y)[out]).abs() < 1e-10);
        }
        let found = tried(&surface.z, &y, LENGTHS_OF_TEST).unwrap();
        let chosen = Kriging::with(&x, &y, LENGTHS_OF_TEST, found.noise).unwrap();
        let outs = left_out(&chosen, &y);
        let missed: f64 = outs.iter().zip(&y).map(|(out, y)| (out - y).powi(2)).sum();
        assert!((missed / found.missed - 1.0).abs() < 1e-9);
    }

    #[test]
    fn holds_smooth_laws_are_found_and_noise_is_not() {
        let of = |x: &[f64; 6]| 2.0 - x[0] + 3.0 * x[1] * x[4] - 0.5 * x[3] * x[3];
        let x = points(90);
        let y: Vec<f64> = x.iter().map(of).collect();
        let surface = Kriging::fit(&x, &y).unwrap();
        assert!(explained(&surface, &y) > 0.99);
        let place = [0.3, 0.7, 0.1, 0.9, 0.5, 0.4];
        let found = surface.predict(&place);
        assert!(
            (found.value - of(&place)).abs() < 3.0 * found.sd && found.sd < 0.1,
            "{found:?}"
        );
        assert_eq!(surface.value(&place), found.value);
        // the difference between a point and itself is zero; between two points it is the difference of their values
        let other = [0.6, 0.2, 0.5, 0.3, 0.8, 0.1];
        assert!(surface.difference(&place, &place).sd < 1e-6);
        let apart = surface.difference(&place, &other);
        assert!((apart.value - surface.value(&other) + found.value).abs() < 1e-10);
        assert!(
            (apart.value - of(&other) + of(&place)).abs() < 3.0 * apart.sd,
            "{apart:?}"
        );
        let mut random = Random::new(5, 0);
        let y: Vec<f64> = (0..90).map(|_| random.normal()).collect();
        let surface = Kriging::fit(&x, &y).unwrap();
        assert!(explained(&surface, &y) < 0.15);
        assert!(Kriging::fit(&x[..2], &y[..2]).is_err());
    }

    /// The intervals hold for new points, over many draws of the noise.
    #[test]
    fn holds_nine_of_ten_new_observations_lie_within_their_intervals() {
        let of = |x: &[f64; 6]| (3.0 * x[0]).sin() + x[1] * x[2];
        let x = points(400);
        let (mut inside, mut narrow) = (0, 0);
        const DRAWS: u64 = 3;
        for draw in 0..DRAWS {
            let mut random = Random::new(8, draw);
            let y: Vec<f64> = x.iter().map(|x| of(x) + 0.1 * random.normal()).collect();
            let settings = Kriging::settings(&x[..90], &y[..90]).unwrap();
            let surface = Kriging::of(&x[..90], &y[..90], &settings).unwrap();
            let bare = Kriging::fit(&x[..90], &y[..90]).unwrap();
            for (x, y) in x[90..].iter().zip(&y[90..]) {
                let within = |surface: &Kriging| {
                    let found = surface.predict(x);
                    usize::from((found.value - y).abs() <= 1.645 * found.sd)
                };
                inside += within(&surface);
                narrow += within(&bare);
            }
        }
        let [share, bare] = [inside, narrow].map(|count| count as f64 / (310.0 * DRAWS as f64));
        assert!((0.87..=0.96).contains(&share), "{share}");
        assert!(bare <= share, "{bare} {share}");
    }
}
