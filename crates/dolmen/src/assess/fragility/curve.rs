//! The lognormal fragility curve.

use crate::assess::AssessError;
use crate::numeric::{normal_probability, normal_quantile};

/// A lognormal fragility curve.
///
/// ```text
/// P(state reached | IM = x) = Φ(ln(x/θ)/β)
/// ```
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Fragility {
    theta: f64,
    beta: f64,
}

impl Fragility {
    /// A curve with this median and dispersion.
    ///
    /// # Errors
    /// [`AssessError::FragilityParameter`] unless both are positive numbers.
    pub fn new(theta: f64, beta: f64) -> Result<Self, AssessError> {
        for (parameter, given) in [("theta", theta), ("beta", beta)] {
            if !(given > 0.0 && given.is_finite()) {
                return Err(AssessError::FragilityParameter { parameter, given });
            }
        }
        Ok(Fragility { theta, beta })
    }

    /// θ, the median, in the unit of the intensity.
    pub fn theta(&self) -> f64 {
        self.theta
    }

    /// β, the dispersion: standard deviation of ln of the capacity, –.
    pub fn beta(&self) -> f64 {
        self.beta
    }

    /// Probability that the damage state is reached at an intensity; 0 at intensity 0.
    pub fn probability(&self, intensity: f64) -> f64 {
        if intensity > 0.0 {
            normal_probability((intensity / self.theta).ln() / self.beta)
        } else {
            0.0
        }
    }

    /// The intensity at which the damage state is reached with this probability.
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < probability < 1.
    pub fn intensity(&self, probability: f64) -> Result<f64, AssessError> {
        Ok(self.theta * (self.beta * normal_quantile(probability)?).exp())
    }

    /// The curve with the same median and an additional, independent source of dispersion: √(β² + β_other²).
    ///
    /// # Errors
    /// As [`Fragility::new`], for the resulting dispersion.
    pub fn with_more_dispersion(&self, beta: f64) -> Result<Self, AssessError> {
        Fragility::new(self.theta, self.beta.hypot(beta))
    }
}

/// The point where two curves cross.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Crossing {
    /// The intensity.
    pub intensity: f64,
    /// The probability of both curves at this intensity.
    pub probability: f64,
}

/// The point where two fragility curves cross. Curves with equal dispersion do not cross; others cross exactly once. On one side of the crossing
/// the worse damage state seems more probable than the milder one, which is impossible. A crossing is harmless only far out in the tails.
///
/// ```text
/// ln x = (β₂ ln θ₁ − β₁ ln θ₂)/(β₂ − β₁)
/// ```
pub fn crossing(first: &Fragility, second: &Fragility) -> Option<Crossing> {
    let apart = second.beta - first.beta;
    if apart == 0.0 {
        return None;
    }
    let z = (second.theta / first.theta).ln() / -apart;
    let intensity = first.theta * (first.beta * z).exp();
    (intensity.is_finite() && intensity > 0.0).then(|| Crossing {
        intensity,
        probability: normal_probability(z),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_curves_and_their_crossing() {
        let mild = Fragility::new(0.3, 0.5).unwrap();
        let severe = Fragility::new(0.4, 0.3).unwrap();
        let found = crossing(&mild, &severe).unwrap();
        for curve in [mild, severe] {
            assert!((curve.probability(found.intensity) - found.probability).abs() < 1e-15);
        }
        // below 0.3 · (4/3)^(5/2) the milder state is more probable
        assert!((found.intensity / (0.3 * (4.0_f64 / 3.0).powf(2.5)) - 1.0).abs() < 1e-14);
        assert_eq!(crossing(&mild, &Fragility::new(0.6, 0.5).unwrap()), None);
        assert_eq!((mild.probability(0.0), mild.probability(0.3)), (0.0, 0.5));
        let x = severe.intensity(0.2).unwrap();
        assert!((severe.probability(x) - 0.2).abs() < 1e-15);
    }

    #[test]
    fn refuses_what_is_no_curve() {
        for (theta, beta) in [
            (0.0, 0.4),
            (-1.0, 0.4),
            (f64::NAN, 0.4),
            (0.3, 0.0),
            (0.3, f64::INFINITY),
        ] {
            assert!(Fragility::new(theta, beta).is_err());
        }
        assert_eq!(
            Fragility::new(0.3, 0.0).unwrap_err().to_string(),
            "beta of a fragility curve is 0, but must be a positive number"
        );
    }
}
