//! A fitted fragility curve, and the uncertainty of its parameters.

use super::curve::Fragility;
use crate::assess::AssessError;
use crate::numeric::{Interval, chi_squared_quantile, ln_normal_probability, student_two_sided_quantile};

/// Smallest number of degrees of freedom of β. Our choice.
const FREEDOM_LEAST: f64 = 0.2;

/// A fitted curve with its standard errors.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FragilityFit {
    /// The curve.
    pub curve: Fragility,
    /// Standard error of ln θ.
    pub ln_theta_error: f64,
    /// Standard error of β.
    pub beta_error: f64,
    /// Covariance of ln θ and β.
    pub covariance: f64,
    /// Logarithm of the likelihood; `None` for a fit by moments.
    pub log_likelihood: Option<f64>,
    /// Number of different motions; for stripes, the number in the largest stripe.
    pub motions: usize,
    /// Number of observations that reached the state.
    pub reached: usize,
    /// Number of all observations; a stripe counts every motion at every intensity.
    pub observations: usize,
}

impl FragilityFit {
    /// Confidence interval of θ.
    ///
    /// ```text
    /// θ exp(± t s),   s² = σ² n/(n − 1),   t of Student with n − 1 degrees of freedom, n motions
    /// ```
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < confidence < 1.
    pub fn theta_interval(&self, confidence: f64) -> Result<Interval, AssessError> {
        let half = self.times(confidence)? * self.ln_theta_error;
        Ok(Interval {
            lower: self.curve.theta() * (-half).exp(),
            upper: self.curve.theta() * half.exp(),
        })
    }

    /// Interval of β with a confidence, as for a standard deviation.
    ///
    /// ```text
    /// β √(m/χ²),   m = ½ (β/σ)²,   χ² with m − 1 degrees of freedom; if all capacities are known, m = n
    /// ```
    ///
    /// # Errors
    /// As [`FragilityFit::theta_interval`].
    pub fn beta_interval(&self, confidence: f64) -> Result<Interval, AssessError> {
        let known = 0.5 * (self.curve.beta() / self.beta_error).powi(2);
        let free = if self.is_by_moments() { known } else { known - 1.0 };
        let free = free.max(FREEDOM_LEAST);
        let at = |probability: f64| -> Result<f64, AssessError> {
            Ok(self.curve.beta() * (known / chi_squared_quantile(probability, free)?).sqrt())
        };
        Ok(Interval {
            lower: at(0.5 + 0.5 * confidence)?,
            upper: at(0.5 - 0.5 * confidence)?,
        })
    }

    /// Confidence interval of the probability at an intensity, from the covariance of both parameters.
    ///
    /// # Errors
    /// As [`FragilityFit::theta_interval`].
    pub fn probability_interval(&self, intensity: f64, confidence: f64) -> Result<Interval, AssessError> {
        let beta = self.curve.beta();
        let z = (intensity / self.curve.theta()).ln() / beta;
        // dz = −(d ln θ + z dβ)/β
        let variance =
            self.ln_theta_error.powi(2) + z * (2.0 * self.covariance + z * self.beta_error.powi(2));
        let half = self.times(confidence)? * variance.max(0.0).sqrt() / beta;
        let at = |z: f64| ln_normal_probability(z).exp();
        Ok(Interval {
            lower: at(z - half),
            upper: at(z + half),
        })
    }

    /// Standard deviation of ln θ for use in a normal distribution. It is the standard error, increased because few motions determine
    /// it, as in Student's distribution: by √(n/(n − 3)), for three motions by √(n/(n − 1)) or more.
    pub fn ln_theta_deviation(&self) -> f64 {
        let n = self.motions as f64;
        self.ln_theta_error * (n / (n - 3.0).max(1.0)).sqrt()
    }

    fn is_by_moments(&self) -> bool {
        self.log_likelihood.is_none()
    }

    /// Half width of an interval with a confidence, in standard errors.
    fn times(&self, confidence: f64) -> Result<f64, AssessError> {
        let n = self.motions as f64;
        let likeliest = if self.is_by_moments() { 1.0 } else { n / (n - 1.0) };
        Ok(student_two_sided_quantile(1.0 - confidence, n - 1.0)? * likeliest.sqrt())
    }
}
