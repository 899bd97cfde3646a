//! Updates the stiffness of the joints by a measured frequency, with importance weights, and computes the resulting capacity.

use super::factors::SixFactors;
use super::model::PagodaScore;
use super::stiffness::StiffnessEffect;
use crate::assess::AssessError;
use crate::numeric::{Interval, Random, normal_probability};

/// Number of bisections of an interval of ln θ, to 1e-9 of it. Our choice.
const HALVINGS: usize = 60;
/// Margin beyond every draw of the interval for a bisection, in standard deviations.
const BEYOND: f64 = 6.0;

/// Weighted draws of the common stiffness ratio κ: stiffness of all joints over that of the designs.
///
/// ```text
/// ln κ uniform over the range of the designs,   f = f₀ √κ,   w = exp(−½ ((ln f_measured − ln f)/σ)²)
/// effective number (Σ w)² / Σ w²
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct StiffnessDraws {
    /// ln κ, ascending.
    ln_ratios: Vec<f64>,
    /// Weights, with sum 1.
    weights: Vec<f64>,
}

impl StiffnessDraws {
    /// The draws before a measurement: one in each of `draws` equal parts of the range of ln κ.
    pub fn prior(range: &Interval, draws: usize, seed: u64) -> Self {
        let mut random = Random::new(seed, 0);
        let (from, to) = (range.lower.ln(), range.upper.ln());
        let count = draws.max(1) as f64;
        let ln_ratios = (0..draws.max(1)).map(|i| from + (to - from) * (i as f64 + random.uniform()) / count);
        StiffnessDraws {
            ln_ratios: ln_ratios.collect(),
            weights: vec![1.0 / count; draws.max(1)],
        }
    }

    /// The draws weighted by a measured frequency. `frequency_ratio` is relative to the pagoda with the joints of the designs;
    /// `ln_sd` is the standard deviation of its logarithm.
    ///
    /// # Errors
    /// [`AssessError::Factor`] for a ratio or deviation that is not positive, or for a ratio far from every draw.
    pub fn given(&self, frequency_ratio: f64, ln_sd: f64) -> Result<Self, AssessError> {
        for (factor, given) in [("frequency_ratio", frequency_ratio), ("ln_sd", ln_sd)] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(AssessError::Factor {
                    factor,
                    given,
                    allowed: "a positive number",
                });
            }
        }
        let weight =
            |ln_ratio: &f64| (-0.5 * ((frequency_ratio.ln() - 0.5 * ln_ratio) / ln_sd).powi(2)).exp();
        let own = self.ln_ratios.iter().zip(&self.weights);
        let weights: Vec<f64> = own.map(|(ln_ratio, prior)| prior * weight(ln_ratio)).collect();
        let sum: f64 = weights.iter().sum();
        if sum.is_nan() || sum <= 0.0 {
            return Err(AssessError::Factor {
                factor: "frequency_ratio",
                given: frequency_ratio,
                allowed: "one that the stiffness of the designs can give",
            });
        }
        Ok(StiffnessDraws {
            ln_ratios: self.ln_ratios.clone(),
            weights: weights.iter().map(|weight| weight / sum).collect(),
        })
    }

    /// Effective number of draws.
    pub fn effective(&self) -> f64 {
        1.0 / self.weights.iter().map(|weight| weight * weight).sum::<f64>()
    }

    /// Mean of a function of κ.
    pub fn mean(&self, of: impl Fn(f64) -> f64) -> f64 {
        let own = self.ln_ratios.iter().zip(&self.weights);
        own.filter(|(_, weight)| **weight > 0.0)
            .map(|(ln_ratio, weight)| weight * of(ln_ratio.exp()))
            .sum()
    }

    /// Quantile of κ.
    pub fn quantile(&self, probability: f64) -> f64 {
        let mut below = 0.0;
        for (ln_ratio, weight) in self.ln_ratios.iter().zip(&self.weights) {
            below += weight;
            if below >= probability {
                return ln_ratio.exp();
            }
        }
        self.ln_ratios.last().map_or(1.0, |ln_ratio| ln_ratio.exp())
    }
}

/// The capacity of a pagoda in one damage state, as a mean over the stiffness of its joints.
///
/// ```text
/// ln θ = score + y(κ) + ε,   P(reached at a) = Σ w_i Φ((ln a − ln θ_i) / √(β² + σ²))
/// σ² = variance of the score + variance common to all designs + variance of y
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct CapacityGiven {
    /// Weights and ln θ, m/s².
    draws: Vec<(f64, f64)>,
    /// Standard deviation σ.
    ln_capacity_sd: f64,
    /// Scatter between motions.
    beta: f64,
}

impl CapacityGiven {
    /// Combines the score of the pagoda with the effect of stiffness in the same state.
    ///
    /// # Errors
    /// [`AssessError::Factor`] for factors that are not positive.
    ///
    /// # Limits
    /// The stiffness of all joints of the pagoda differs from that of the designs by one factor.
    pub fn of(
        factors: &SixFactors,
        score: &PagodaScore,
        effect: &StiffnessEffect,
        stiffness: &StiffnessDraws,
    ) -> Result<Self, AssessError> {
        let place = factors.coordinates()?;
        let own = stiffness.ln_ratios.iter().zip(&stiffness.weights);
        let draws = own
            .filter(|(_, weight)| **weight > 0.0)
            .map(|(ln_ratio, weight)| (*weight, score.capacity_m_s2.ln() + effect.at(&place, *ln_ratio)));
        Ok(CapacityGiven {
            draws: draws.collect(),
            ln_capacity_sd: score
                .ln_capacity_sd
                .hypot(score.ln_shared_sd)
                .hypot(effect.ln_change_sd),
            beta: score.beta,
        })
    }

    /// Probability that one motion with this peak ground acceleration, m/s², brings the pagoda to the state.
    pub fn probability(&self, peak_m_s2: f64) -> f64 {
        self.below(peak_m_s2.ln(), self.beta.hypot(self.ln_capacity_sd))
    }

    /// Quantile of θ, m/s².
    pub fn quantile_m_s2(&self, probability: f64) -> f64 {
        let beyond = BEYOND * self.ln_capacity_sd;
        let ln_thetas = || self.draws.iter().map(|(_, ln_theta)| *ln_theta);
        let mut from = ln_thetas().fold(f64::INFINITY, f64::min) - beyond;
        let mut to = ln_thetas().fold(f64::NEG_INFINITY, f64::max) + beyond;
        for _ in 0..HALVINGS {
            let middle = 0.5 * (from + to);
            match self.below(middle, self.ln_capacity_sd) < probability {
                true => from = middle,
                false => to = middle,
            }
        }
        (0.5 * (from + to)).exp()
    }

    fn below(&self, ln_value: f64, sd: f64) -> f64 {
        let parts = self.draws.iter();
        parts
            .map(|(weight, ln_theta)| weight * normal_probability((ln_value - ln_theta) / sd))
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::normal_probability;

    const RANGE: Interval = Interval {
        lower: 0.1,
        upper: 10.0,
    };

    /// Far from both ends, ln κ is normal about 2 ln(f/f₀) with 2 σ, so that a capacity κ^s with scatter β has a closed form.
    #[test]
    fn exact_far_from_the_ends() {
        let prior = StiffnessDraws::prior(&RANGE, 20_000, 1);
        let (ratio, sd, slope, beta) = (1.2_f64, 0.05, 0.3, 0.4);
        let given = prior.given(ratio, sd).unwrap();
        let middle = 2.0 * ratio.ln();
        assert!((given.mean(f64::ln) - middle).abs() < 1e-5);
        let variance = given.mean(|k| (k.ln() - middle).powi(2));
        assert!((variance.sqrt() - 2.0 * sd).abs() < 1e-5);
        for ln_peak in [-0.5, 0.0, 0.4] {
            let found = given.mean(|k| normal_probability((ln_peak - slope * k.ln()) / beta));
            let all = beta.hypot(2.0 * sd * slope);
            let exact = normal_probability((ln_peak - slope * middle) / all);
            assert!((found - exact).abs() < 1e-5, "{found} {exact}");
        }
        // a normal density of 2σ over a uniform density of width ln 100: 2 √π 2σ n/ln 100
        let exact = 2.0 * std::f64::consts::PI.sqrt() * 2.0 * sd * 20_000.0 / 100.0_f64.ln();
        assert!(
            (given.effective() / exact - 1.0).abs() < 1e-3,
            "{}",
            given.effective()
        );
        assert!((prior.effective() - 20_000.0).abs() < 1e-6);
        assert!((given.quantile(0.5).ln() - middle).abs() < 1e-3);
    }

    #[test]
    fn refuses_what_no_draw_comes_near() {
        let prior = StiffnessDraws::prior(&RANGE, 100, 1);
        assert!(prior.given(100.0, 0.01).is_err());
        assert!(prior.given(f64::NAN, 0.05).is_err());
        assert!(prior.given(1.0, 0.0).is_err());
    }
}
