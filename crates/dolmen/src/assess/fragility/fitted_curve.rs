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
    /// The choice of samples of the structure, if it is part of the errors.
    pub of_samples: Option<OfSamples>,
}

/// What few samples of an uncertain structure, shaken by the same motions, add to the errors of a curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfSamples {
    /// β between motions for a given structure.
    pub of_motions: f64,
    /// Standard deviation of ln of the median between samples.
    pub of_inputs: f64,
    /// Number of samples, 3 or more.
    pub samples: usize,
}

impl OfSamples {
    /// Standard error of ln θ due to the choice of samples.
    fn ln_theta_error(&self) -> f64 {
        self.of_inputs / (self.samples as f64).sqrt()
    }
}

impl FragilityFit {
    /// Confidence interval of θ.
    ///
    /// ```text
    /// θ exp(± t s),   s² = σ² n/(n − 1),   t of Student with n − 1 degrees of freedom, n motions
    /// ```
    ///
    /// With the choice of S samples, by two-way random effects and Satterthwaite's degrees of freedom:
    ///
    /// ```text
    /// s² = σ_m² n/(n − 1) + β_inputs²/S,   ν = s⁴ / (s_m⁴/(n − 1) + s_s⁴/(S − 1))
    /// ```
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < confidence < 1.
    pub fn theta_interval(&self, confidence: f64) -> Result<Interval, AssessError> {
        let half = self.times(confidence)? * self.ln_theta_spread();
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
    /// With the choice of S samples, for the sum of two variances, with `m ≤ n` for the first and `S` for the second:
    ///
    /// ```text
    /// β² = A + B,   L = A + B − √((A − L_A)² + (B − L_B)²),   U = A + B + √((U_A − A)² + (U_B − B)²)
    /// ```
    ///
    /// # Errors
    /// As [`FragilityFit::theta_interval`].
    ///
    /// # Source
    /// Graybill, F. A. and Wang, C.-M. (1980) Confidence intervals on nonnegative linear combinations of variances. J. Am. Stat. Assoc. 75(372):869–873;
    /// in this form Zou, G. Y. (2008) On the estimation of additive interaction. Am. J. Epidemiol. 168(2):212–224.
    pub fn beta_interval(&self, confidence: f64) -> Result<Interval, AssessError> {
        let known = 0.5 * (self.curve.beta() / self.beta_error).powi(2);
        let free = if self.is_by_moments() { known } else { known - 1.0 };
        let free = free.max(FREEDOM_LEAST);
        if let Some(of) = self.of_samples {
            let known = known.min(self.motions as f64);
            return of.beta_interval((known, free.min(self.freedom_of_motions())), confidence);
        }
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
        let variance = self.ln_theta_spread().powi(2)
            + z * self.likeliest() * (2.0 * self.covariance + z * self.beta_error.powi(2));
        let half = self.times(confidence)? * variance.max(0.0).sqrt() / beta;
        let at = |z: f64| ln_normal_probability(z).exp();
        Ok(Interval {
            lower: at(z - half),
            upper: at(z + half),
        })
    }

    /// Standard deviation of ln θ for use in a normal distribution. It is the standard error, increased because few motions determine
    /// it, as in Student's distribution: by √(n/(n − 3)), for three motions by √(n/(n − 1)) or more. With the choice of samples, by √(ν/(ν − 2)).
    pub fn ln_theta_deviation(&self) -> f64 {
        if self.of_samples.is_some() {
            let free = self.freedom();
            return self.ln_theta_spread() * (free / (free - 2.0).max(1.0)).sqrt();
        }
        let n = self.motions as f64;
        self.ln_theta_error * (n / (n - 3.0).max(1.0)).sqrt()
    }

    /// Standard error of ln θ due to the choice of motions alone.
    pub fn ln_theta_error_of_motions(&self) -> f64 {
        let of_samples = self.of_samples.map_or(0.0, |of| of.ln_theta_error());
        (self.ln_theta_error.powi(2) - of_samples * of_samples)
            .max(0.0)
            .sqrt()
    }

    fn is_by_moments(&self) -> bool {
        self.log_likelihood.is_none()
    }

    /// Unbiased over most likely variance between motions.
    fn likeliest(&self) -> f64 {
        let n = self.motions as f64;
        if self.is_by_moments() { 1.0 } else { n / (n - 1.0) }
    }

    fn freedom_of_motions(&self) -> f64 {
        self.motions as f64 - 1.0
    }

    /// Standard error of ln θ from unbiased variances.
    fn ln_theta_spread(&self) -> f64 {
        let of_samples = self.of_samples.map_or(0.0, |of| of.ln_theta_error());
        (self.likeliest().sqrt() * self.ln_theta_error_of_motions()).hypot(of_samples)
    }

    /// Degrees of freedom of this error.
    fn freedom(&self) -> f64 {
        let Some(of) = self.of_samples else {
            return self.freedom_of_motions();
        };
        let motions = self.likeliest() * self.ln_theta_error_of_motions().powi(2);
        let samples = of.ln_theta_error().powi(2);
        let spread =
            motions * motions / self.freedom_of_motions() + samples * samples / (of.samples as f64 - 1.0);
        (motions + samples).powi(2) / spread
    }

    /// Half width of an interval with a confidence, in standard errors of unbiased variances.
    fn times(&self, confidence: f64) -> Result<f64, AssessError> {
        Ok(student_two_sided_quantile(1.0 - confidence, self.freedom())?)
    }
}

impl OfSamples {
    /// Interval of β, from the number of known capacities and the degrees of freedom of the scatter between motions.
    fn beta_interval(&self, (known, free): (f64, f64), confidence: f64) -> Result<Interval, AssessError> {
        let [a, b] = [self.of_motions.powi(2), self.of_inputs.powi(2)];
        let samples = self.samples as f64 - 1.0;
        let ends = |probability: f64| -> Result<[f64; 2], AssessError> {
            Ok([
                a * known / chi_squared_quantile(probability, free)?,
                b * samples / chi_squared_quantile(probability, samples)?,
            ])
        };
        let least = ends(0.5 + 0.5 * confidence)?;
        let most = ends(0.5 - 0.5 * confidence)?;
        let below = (a - least[0]).max(0.0).hypot((b - least[1]).max(0.0));
        let above = (most[0] - a).max(0.0).hypot((most[1] - b).max(0.0));
        Ok(Interval {
            lower: (a + b - below).max(0.0).sqrt(),
            upper: (a + b + above).sqrt(),
        })
    }
}
