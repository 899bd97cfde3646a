//! Two positive random variables of which one is never above the other, each with its mean and standard deviation.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | μ, δ | `mean`, `cov` | mean and coefficient of variation of a variable |
//! | s, k | `smaller`, `larger` | the two variables, s ≤ k |
//! | z_s, z_k | `z` | their independent standard normal variables |
//! | r | `share` | s/k |
//! | h, u | `h`, `u` | Φ⁻¹ of the mean of r, and √(1 − ρ) of the normal pair that has the variance of r |

use super::elementary::exp;
use super::error::NumericError;
use super::normal::normal_probability;
use super::quadrature::nodes_15;
use super::random::{COV_MOST, lognormal_at};
use super::roots::{Bracketing, bracketed_root};
use std::f64::consts::PI;

/// Largest |h|: Φ(h) is 0 or 1 to rounding beyond it.
const H_MOST: f64 = 38.0;

/// Mean and coefficient of variation of a positive variable.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct MeanAndCov {
    /// Mean, above 0.
    pub mean: f64,
    /// Standard deviation over mean; 0 for a known value.
    pub cov: f64,
}

impl MeanAndCov {
    fn variance(self) -> f64 {
        (self.mean * self.cov).powi(2)
    }

    fn at(self, z: f64) -> Result<f64, NumericError> {
        match self.cov == 0.0 {
            true => Ok(self.mean),
            false => lognormal_at(z, self.mean, self.cov),
        }
    }
}

/// A pair s ≤ k of random variables with given means and standard deviations.
///
/// ```text
/// Sum:    var k > var s    s lognormal, k = s + d,  d lognormal with μ_k − μ_s and var k − var s
/// Share:  δ_s ≥ δ_k        k lognormal, s = r k,    r = Φ(a + b z_s) with E r = μ_s/μ_k, E r² = E s²/E k²
/// ```
/// s, d and r, k are independent, so that the means and variances of s and k are those given; s = k only for equal means. Two lognormal variables cannot serve: unless
/// their logarithms scatter alike, they cross.
///
/// # Source
/// The variance of r follows from the bivariate normal distribution, ∂Φ₂/∂ρ = φ₂ (Plackett 1954, Biometrika 41:351-360) with ρ = 1 − u²:
///
/// ```text
/// var r = (1/π) ∫ᵤ¹ exp(−h²/(2 − t²))/√(2 − t²) dt,   a = h/u,   b = √(1 − u²)/u
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OrderedPair(Pair);

#[derive(Clone, Copy, Debug, PartialEq)]
enum Pair {
    Sum {
        smaller: MeanAndCov,
        difference: MeanAndCov,
    },
    Share {
        larger: MeanAndCov,
        share: Share,
    },
}

/// A variable between 0 and 1.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Share {
    Fixed(f64),
    /// Φ(a + b z).
    Normal {
        a: f64,
        b: f64,
    },
}

impl OrderedPair {
    /// The pair with these means and covs; `None` if neither form has them.
    ///
    /// # Errors
    /// [`NumericError::Range`] unless both means are positive and the mean of `smaller` is at most that of `larger`.
    pub fn of(smaller: MeanAndCov, larger: MeanAndCov) -> Result<Option<Self>, NumericError> {
        let refused = |quantity, given, allowed| {
            Err(NumericError::Range {
                quantity,
                given,
                allowed,
            })
        };
        if !(smaller.mean > 0.0 && smaller.mean <= larger.mean && larger.mean.is_finite()) {
            return refused(
                "mean of the smaller variable",
                smaller.mean,
                "above 0, and at most that of the larger",
            );
        }
        for of in [smaller, larger] {
            if !(of.cov >= 0.0 && of.cov.is_finite()) {
                return refused("cov of a variable", of.cov, "0 or a positive number");
            }
        }
        let variance = larger.variance() - smaller.variance();
        let mean = larger.mean - smaller.mean;
        let difference = MeanAndCov {
            mean,
            cov: variance.max(0.0).sqrt() / mean,
        };
        if variance > 0.0 && difference.cov <= COV_MOST {
            return Ok(Some(OrderedPair(Pair::Sum { smaller, difference })));
        }
        let mean = smaller.mean / larger.mean;
        let squares = (1.0 + smaller.cov * smaller.cov) / (1.0 + larger.cov * larger.cov);
        let share = Share::of(mean, mean * mean * (squares - 1.0))?;
        Ok(share.map(|share| OrderedPair(Pair::Share { larger, share })))
    }

    /// The smaller and the larger variable at their standard normal ones.
    ///
    /// # Errors
    /// [`NumericError::Range`] if a cov is above 10.
    pub fn at(&self, [z_smaller, z_larger]: [f64; 2]) -> Result<[f64; 2], NumericError> {
        Ok(match self.0 {
            Pair::Sum { smaller, difference } => {
                let smaller = smaller.at(z_smaller)?;
                [smaller, smaller + difference.at(z_larger)?]
            }
            Pair::Share { larger, share } => {
                let larger = larger.at(z_larger)?;
                [share.at(z_smaller) * larger, larger]
            }
        })
    }
}

impl Share {
    /// A share with this mean and variance; `None` if none has them.
    fn of(mean: f64, variance: f64) -> Result<Option<Self>, NumericError> {
        if variance == 0.0 {
            return Ok(Some(Share::Fixed(mean)));
        }
        if !(variance > 0.0 && variance < mean * (1.0 - mean)) {
            return Ok(None);
        }
        let search = Bracketing::default();
        let h = bracketed_root(|h| normal_probability(h) - mean, -H_MOST, H_MOST, &search)?;
        let density = |t: f64| {
            let w = 2.0 - t * t;
            exp(-h * h / w) / (PI * w.sqrt())
        };
        let excess = |u: f64| {
            let nodes = nodes_15(u, 1.0).into_iter();
            nodes.map(|node| node.weight * density(node.x)).sum::<f64>() - variance
        };
        if excess(0.0) <= 0.0 {
            return Ok(None);
        }
        let u = bracketed_root(excess, 0.0, 1.0, &search)?;
        Ok((u > 0.0).then(|| Share::Normal {
            a: h / u,
            b: (1.0 - u * u).sqrt() / u,
        }))
    }

    fn at(self, z: f64) -> f64 {
        match self {
            Share::Fixed(share) => share,
            // Φ rounds to 1 from 8.3 on
            Share::Normal { a, b } => normal_probability(a + b * z).min(1.0 - f64::EPSILON),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn pair(smaller: (f64, f64), larger: (f64, f64)) -> Option<OrderedPair> {
        let [smaller, larger] = [smaller, larger].map(|(mean, cov)| MeanAndCov { mean, cov });
        OrderedPair::of(smaller, larger).unwrap()
    }

    /// Means and squared covs of both, by the trapezoidal rule over both normal variables, and whether the smaller is ever as large as the larger.
    fn moments(pair: OrderedPair) -> ([[f64; 2]; 2], bool) {
        const STEP: f64 = 0.05;
        let (mut sums, mut weights, mut is_crossed) = ([[0.0; 2]; 2], 0.0, false);
        let grid = || (-200..=200).map(|i| STEP * f64::from(i));
        for (x, y) in grid().flat_map(|x| grid().map(move |y| (x, y))) {
            let weight = (-0.5 * (x * x + y * y)).exp();
            let both = pair.at([x, y]).unwrap();
            is_crossed |= both[0] >= both[1] && x.hypot(y) < 8.0;
            weights += weight;
            for (sum, own) in sums.iter_mut().zip(both) {
                sum[0] += weight * own;
                sum[1] += weight * own * own;
            }
        }
        let each = sums.map(|[mean, square]| {
            let (mean, square) = (mean / weights, square / weights);
            [mean, square / (mean * mean) - 1.0]
        });
        (each, is_crossed)
    }

    #[test]
    fn exact_both_keep_their_means_and_covs_and_never_cross() {
        for (smaller, larger) in [
            ((0.9, 0.3), (1.2, 0.3)),
            ((0.9, 0.2), (1.2, 0.2)),
            ((0.9, 0.0), (1.2, 0.3)),
            ((0.9, 0.3), (1.2, 0.2)),  // var s > var k
            ((0.9, 0.25), (1.2, 0.0)), // k known
            ((0.1, 0.6), (1.2, 0.04)),
            ((1.15, 0.1), (1.2, 0.05)),
            ((1.199, 0.3), (1.2, 0.3)), // the difference would scatter too far
        ] {
            let (found, is_crossed) = moments(pair(smaller, larger).unwrap());
            for (found, (mean, cov)) in found.iter().zip([smaller, larger]) {
                assert!(
                    (found[0] / mean - 1.0).abs() < 1e-9,
                    "{smaller:?} {larger:?} {found:?}"
                );
                assert!(
                    (found[1] - cov * cov).abs() < 1e-9,
                    "{smaller:?} {larger:?} {found:?}"
                );
            }
            assert!(!is_crossed, "{smaller:?} {larger:?}");
        }
    }

    #[test]
    fn refuses_scatter_that_no_ordered_pair_has() {
        // a share of 0.75 of a known value scatters by √(0.25/0.75) of itself at most
        let most = (0.25_f64 / 0.75).sqrt();
        assert!(pair((0.9, 0.99 * most), (1.2, 0.0)).is_some());
        assert_eq!(pair((0.9, 1.01 * most), (1.2, 0.0)), None);
        assert_eq!(pair((1.199, 0.1), (1.2, 0.3)), None);
        let [smaller, larger] = [1.2, 0.9].map(|mean| MeanAndCov { mean, cov: 0.1 });
        let message = OrderedPair::of(smaller, larger).unwrap_err().to_string();
        assert!(
            message.contains("mean of the smaller variable is 1.2"),
            "{message}"
        );
    }
}
