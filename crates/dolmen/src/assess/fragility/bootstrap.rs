//! Bootstrap bands of a fragility curve: the scatter due to the choice of motions.

use super::curve::Fragility;
use super::fit::{fit_fragility, fit_fragility_of_motions};
use super::observation::Observation;
use crate::assess::AssessError;
use crate::numeric::{Interval, Random, quantile};
use std::collections::BTreeMap;

/// Curves of resampled observations.
#[derive(Clone, Debug, PartialEq)]
pub struct FragilityBand {
    /// The curves that could be fitted.
    pub curves: Vec<Fragility>,
    /// Resamples without a curve: none or all reached the state, or the intensity separates survivors from failures.
    pub without_curve: usize,
    /// Seed of the resamples.
    pub seed: u64,
}

impl FragilityBand {
    /// Central interval of the probabilities at an intensity that contains this fraction of the curves; `None` without a curve.
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < confidence < 1.
    pub fn probability(&self, intensity: f64, confidence: f64) -> Result<Option<Interval>, AssessError> {
        self.middle(confidence, |curve| curve.probability(intensity))
    }

    /// Bootstrap interval of θ.
    ///
    /// # Errors
    /// As [`FragilityBand::probability`].
    pub fn theta(&self, confidence: f64) -> Result<Option<Interval>, AssessError> {
        self.middle(confidence, Fragility::theta)
    }

    /// Bootstrap interval of β.
    ///
    /// # Errors
    /// As [`FragilityBand::probability`].
    pub fn beta(&self, confidence: f64) -> Result<Option<Interval>, AssessError> {
        self.middle(confidence, Fragility::beta)
    }

    fn middle(
        &self,
        confidence: f64,
        of: impl Fn(&Fragility) -> f64,
    ) -> Result<Option<Interval>, AssessError> {
        if self.curves.is_empty() {
            return Ok(None);
        }
        let values: Vec<f64> = self.curves.iter().map(of).collect();
        Ok(Some(Interval {
            lower: quantile(&values, 0.5 - 0.5 * confidence)?,
            upper: quantile(&values, 0.5 + 0.5 * confidence)?,
        }))
    }
}

/// Fits curves to resampled observations. Single motions are drawn with replacement. For each stripe, the number that reached the state is
/// drawn from a binomial distribution with the observed fraction. Resample i draws from stream i of the seed.
///
/// # Errors
/// The errors of [`fit_fragility`] for the original observations. Resamples without a curve are counted.
///
/// # Source
/// Efron, B. and Tibshirani, R. (1993) An Introduction to the Bootstrap, ch. 6 and 13.
pub fn bootstrap_fragility(
    observations: &[Observation],
    resamples: usize,
    seed: u64,
) -> Result<FragilityBand, AssessError> {
    fit_fragility(observations)?;
    let motions: Vec<usize> = (0..observations.len()).collect();
    resampled(observations, &motions, resamples, seed)
}

/// As [`bootstrap_fragility`], for several observations per motion, as in [`fit_fragility_of_motions`]: the motions are resampled, each with
/// all its observations.
///
/// # Errors
/// The errors of [`fit_fragility_of_motions`]. Resamples without a curve are counted.
pub fn bootstrap_fragility_of_motions(
    observations: &[Observation],
    motions: &[usize],
    resamples: usize,
    seed: u64,
) -> Result<FragilityBand, AssessError> {
    fit_fragility_of_motions(observations, motions)?;
    resampled(observations, motions, resamples, seed)
}

fn resampled(
    observations: &[Observation],
    motions: &[usize],
    resamples: usize,
    seed: u64,
) -> Result<FragilityBand, AssessError> {
    let mut by_motion: BTreeMap<usize, Vec<Observation>> = BTreeMap::new();
    for (motion, observation) in motions.iter().zip(observations) {
        if !matches!(observation, Observation::Stripe { .. }) {
            by_motion.entry(*motion).or_default().push(*observation);
        }
    }
    let single: Vec<Vec<Observation>> = by_motion.into_values().collect();
    let mut band = FragilityBand {
        curves: Vec::with_capacity(resamples),
        without_curve: 0,
        seed,
    };
    for resample in 0..resamples as u64 {
        let mut random = Random::new(seed, resample);
        let mut below = |n: usize| ((random.uniform() * n as f64) as usize).min(n - 1);
        let drawn = (0..single.len()).map(|_| &single[below(single.len())]);
        let mut drawn: Vec<Observation> = drawn.flatten().copied().collect();
        for observation in observations {
            if let Observation::Stripe {
                intensity,
                motions,
                reached,
            } = *observation
            {
                let reached = (0..motions).filter(|_| below(motions) < reached).count();
                drawn.push(Observation::Stripe {
                    intensity,
                    motions,
                    reached,
                });
            }
        }
        match fit_fragility(&drawn) {
            Ok(fit) => band.curves.push(fit.curve),
            Err(AssessError::NoFragility(_) | AssessError::FragilityFalls) => band.without_curve += 1,
            Err(error) => return Err(error),
        }
    }
    Ok(band)
}
