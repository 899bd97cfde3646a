//! Probability of an event from seeded samples, with its confidence interval; distribution of a sampled result.

use super::AssessError;
use crate::numeric::{Random, clopper_pearson, mean, quantile, variance};

/// Default confidence level of an interval.
const CONFIDENCE: f64 = 0.95;

/// Frequency of an event among independent samples.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Probability {
    /// Number of samples with the event.
    pub count: usize,
    /// Number of samples.
    pub samples: usize,
    /// count / samples.
    pub estimate: f64,
    /// Lower end of the Clopper–Pearson interval.
    pub lower: f64,
    /// Upper end of the Clopper–Pearson interval.
    pub upper: f64,
    /// Confidence level of the interval, 0.95 by default.
    pub confidence: f64,
    /// Seed of the samples.
    pub seed: u64,
}

impl Probability {
    /// The probability and its interval from a count of events.
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 1 ≤ samples, count ≤ samples and 0 < confidence < 1.
    pub fn of_count(count: usize, samples: usize, confidence: f64, seed: u64) -> Result<Self, AssessError> {
        let interval = clopper_pearson(count, samples, confidence)?;
        Ok(Probability {
            count,
            samples,
            estimate: count as f64 / samples as f64,
            lower: interval.lower,
            upper: interval.upper,
            confidence,
            seed,
        })
    }
}

/// One value per sample. Sample i uses random stream i of the seed, so its value does not depend on the number of
/// samples.
///
/// # Errors
/// The first error of `draw`.
///
/// # Example
/// ```
/// use dolmen::{assess::sampled, numeric::NumericError};
/// let three = sampled(3, 1, |random| random.lognormal(2e8, 0.1))?;
/// assert_eq!(three, sampled(5, 1, |random| random.lognormal(2e8, 0.1))?[..3]);
/// # Ok::<(), NumericError>(())
/// ```
pub fn sampled<T, E>(
    samples: usize,
    seed: u64,
    mut draw: impl FnMut(&mut Random) -> Result<T, E>,
) -> Result<Vec<T>, E> {
    (0..samples as u64)
        .map(|stream| draw(&mut Random::new(seed, stream)))
        .collect()
}

/// Probability that `happens` is true among samples, with its Clopper–Pearson interval at 95 %.
///
/// # Errors
/// [`AssessError::Numeric`] for 0 samples; the first error of `happens`.
///
/// # Limits
/// The interval covers the scatter of the count only. It does not cover errors in the distributions of the inputs.
///
/// # Example
/// ```
/// use dolmen::assess::{probability, AssessError};
/// let below = probability(2000, 1, |random| Ok::<_, AssessError>(random.lognormal(1.2, 0.1)? < 1.0))?;
/// assert!(below.lower < 0.0379 && 0.0379 < below.upper); // Φ((ln(1/1.2) + σ²/2)/σ)
/// # Ok::<(), AssessError>(())
/// ```
pub fn probability<E: From<AssessError>>(
    samples: usize,
    seed: u64,
    happens: impl FnMut(&mut Random) -> Result<bool, E>,
) -> Result<Probability, E> {
    let count = sampled(samples, seed, happens)?
        .into_iter()
        .filter(|&yes| yes)
        .count();
    Ok(Probability::of_count(count, samples, CONFIDENCE, seed)?)
}

/// Distribution of a sampled result.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Distribution {
    /// Number of samples.
    pub samples: usize,
    /// Mean.
    pub mean: f64,
    /// Standard deviation.
    pub standard_deviation: f64,
    /// Value below which 5 % of the samples lie.
    pub quantile_05: f64,
    /// Value below which half of the samples lie.
    pub median: f64,
    /// Value below which 95 % of the samples lie.
    pub quantile_95: f64,
}

impl Distribution {
    /// The distribution of sampled values, in any order.
    ///
    /// # Errors
    /// [`AssessError::Numeric`] for fewer than 2 values or a value that is not finite.
    pub fn of(values: &[f64]) -> Result<Self, AssessError> {
        Ok(Distribution {
            samples: values.len(),
            mean: mean(values)?,
            standard_deviation: variance(values)?.sqrt(),
            quantile_05: quantile(values, 0.05)?,
            median: quantile(values, 0.5)?,
            quantile_95: quantile(values, 0.95)?,
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn tail(samples: usize, seed: u64) -> Probability {
        probability(samples, seed, |random| {
            Ok::<_, AssessError>(random.normal() > 1.281_551_565_544_600_4)
        })
        .unwrap()
    }

    #[test]
    fn holds_the_interval_covers_the_truth_as_often_as_it_says() {
        // P(z > 1.2816) = 0.1; 400 studies of 200 samples: coverage at least 95 % minus 4 standard errors
        let covered = (0..400)
            .map(|seed| tail(200, seed))
            .filter(|p| p.lower <= 0.1 && 0.1 <= p.upper)
            .count();
        assert!(
            covered as f64 / 400.0 > 0.95 - 4.0 * (0.95 * 0.05 / 400.0_f64).sqrt(),
            "{covered} of 400"
        );
        assert!(covered < 400, "an interval that never misses is too wide");
    }

    #[test]
    fn holds_same_seed_same_bits() {
        assert_eq!(tail(100, 3), tail(100, 3));
        assert_ne!(tail(100, 3).count, tail(100, 4).count);
        let p = tail(100, 3);
        assert_eq!((p.samples, p.confidence, p.seed), (100, 0.95, 3));
        assert_eq!(p.estimate, p.count as f64 / 100.0);
    }

    #[test]
    fn exact_distribution_of_a_ramp() {
        let ramp: Vec<f64> = (0..=100).rev().map(f64::from).collect();
        let d = Distribution::of(&ramp).unwrap();
        assert_eq!(
            (d.samples, d.mean, d.quantile_05, d.median, d.quantile_95),
            (101, 50.0, 5.0, 50.0, 95.0)
        );
        assert!((d.standard_deviation - (101.0 * 102.0 / 12.0_f64).sqrt()).abs() < 1e-12);
    }

    #[test]
    fn refuses_no_samples_and_passes_errors_on() {
        let none = probability(0, 1, |_| Ok::<_, AssessError>(true)).unwrap_err();
        assert_eq!(
            none.to_string(),
            "samples is 0, but must be between 1 and 1000000000"
        );
        let fault = probability(5, 1, |random| {
            Ok::<_, AssessError>(random.lognormal(-1.0, 0.1)? > 0.0)
        })
        .unwrap_err();
        assert!(
            fault
                .to_string()
                .starts_with("mean of a lognormal variable is -1")
        );
        assert!(Distribution::of(&[1.0, f64::INFINITY]).is_err());
    }
}
