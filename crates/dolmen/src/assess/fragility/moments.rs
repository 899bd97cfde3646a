//! A fragility curve by the moments of known capacities, and the number of motions that it needs.

use super::curve::Fragility;
use super::fit::MOTIONS_LEAST;
use super::fitted_curve::FragilityFit;
use super::observation::Observation;
use crate::assess::AssessError;
use crate::numeric::{mean, variance};

/// Median and dispersion of capacities that are all known, by their moments.
///
/// ```text
/// ln θ = Σ ln x / n,   β² = Σ (ln x − ln θ)²/(n − 1),   σ(ln θ) = β/√n,   σ(β) = β/√(2(n − 1))
/// ```
///
/// # Errors
/// [`AssessError::TooFewMotions`] for fewer than 3; [`AssessError::Observation`]; [`AssessError::FragilityParameter`] if all are equal.
///
/// # Source
/// Ibarra, L. F. and Krawinkler, H. (2005), as method A of Baker (2015).
pub fn fit_fragility_by_moments(capacities: &[f64]) -> Result<FragilityFit, AssessError> {
    for (i, &x) in capacities.iter().enumerate() {
        Observation::At(x).check(i + 1)?;
    }
    let n = capacities.len();
    if n < MOTIONS_LEAST {
        return Err(AssessError::TooFewMotions { given: n });
    }
    let logs: Vec<f64> = capacities.iter().map(|x| x.ln()).collect();
    let beta = variance(&logs)?.sqrt();
    Ok(FragilityFit {
        curve: Fragility::new(mean(&logs)?.exp(), beta)?,
        ln_theta_error: beta / (n as f64).sqrt(),
        beta_error: beta / (2.0 * (n as f64 - 1.0)).sqrt(),
        covariance: 0.0,
        log_likelihood: None,
        motions: n,
        reached: n,
        observations: n,
        of_samples: None,
    })
}

/// Number of motions for a requested standard error of ln θ: (β/σ)².
///
/// # Errors
/// [`AssessError::FragilityParameter`] unless both are positive.
pub fn motions_needed(beta: f64, ln_theta_error: f64) -> Result<usize, AssessError> {
    for (parameter, given) in [("beta", beta), ("ln_theta_error", ln_theta_error)] {
        if !(given > 0.0 && given.is_finite()) {
            return Err(AssessError::FragilityParameter { parameter, given });
        }
    }
    Ok((beta / ln_theta_error).powi(2).ceil() as usize)
}
