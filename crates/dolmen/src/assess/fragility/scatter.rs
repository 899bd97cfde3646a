//! Splits the scatter of capacities: differences between motions, and uncertainty of the structure.

use super::fit::fit_fragility_of_motions;
use super::observation::Observation;
use crate::assess::AssessError;
use crate::numeric::{Interval, chi_squared_quantile, variance};

/// Fewest samples with a curve for a split, and the largest share of samples without one, which are the strongest and the weakest. Our choice.
const SAMPLES_LEAST: usize = 3;
const WITHOUT_CURVE_MOST: f64 = 0.1;

/// Two parts of the scatter of ln of the capacity; their squares add up.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScatterSplit {
    /// β between motions for a given structure: the root of the mean of β² over samples, –.
    pub of_motions: f64,
    /// Standard deviation of ln of the median between samples of the uncertain inputs, –.
    pub of_inputs: f64,
    /// Number of samples with a curve.
    pub samples: usize,
    /// Number of samples without a curve.
    pub without_curve: usize,
}

impl ScatterSplit {
    /// Interval of `of_inputs` with a confidence. It covers the choice of samples, not the choice of motions.
    ///
    /// ```text
    /// s √((S − 1)/χ²),   S samples
    /// ```
    ///
    /// # Errors
    /// [`AssessError::Numeric`] unless 0 < confidence < 1.
    pub fn of_inputs_interval(&self, confidence: f64) -> Result<Interval, AssessError> {
        let free = self.samples as f64 - 1.0;
        let at = |probability: f64| -> Result<f64, AssessError> {
            Ok(self.of_inputs * (free / chi_squared_quantile(probability, free)?).sqrt())
        };
        Ok(Interval {
            lower: at(0.5 + 0.5 * confidence)?,
            upper: at(0.5 - 0.5 * confidence)?,
        })
    }
}

/// Splits the scatter of capacities if the same motions shook several samples of a structure. Observation i belongs to motion `motions[i]` and sample
/// `samples[i]`. `None` if fewer than three samples have a curve of their own, or if more than a tenth have none: the split would exclude the
/// strongest and the weakest.
///
/// ```text
/// β_motions² = mean of β_j²,   β_inputs² = variance of ln θ_j,   j the samples,   β² ≈ β_motions² + β_inputs²
/// ```
///
/// # Errors
/// The errors of [`fit_fragility_of_motions`], except those for data without a curve.
///
/// # Limits
/// All samples see the same motions, so their common effect is not in β_inputs. The effect of one motion on one sample alone is, divided by √n for n
/// motions. β is the maximum likelihood value, which is too small for few motions: by a tenth for five.
///
/// # Source
/// Ellingwood, B. and Kinali, K. (2009) Quantifying and communicating uncertainty in seismic risk assessment. Struct. Safety 31(2):179–187.
pub fn scatter_split(
    observations: &[Observation],
    motions: &[usize],
    samples: &[usize],
) -> Result<Option<ScatterSplit>, AssessError> {
    let count = samples.iter().max().map_or(0, |most| most + 1);
    let mut own = vec![(Vec::new(), Vec::new()); count];
    for ((observation, motion), sample) in observations.iter().zip(motions).zip(samples) {
        own[*sample].0.push(*observation);
        own[*sample].1.push(*motion);
    }
    let (mut logs, mut squares, mut without_curve) = (Vec::new(), 0.0, 0_usize);
    for (observations, motions) in own.iter().filter(|(observations, _)| !observations.is_empty()) {
        match fit_fragility_of_motions(observations, motions) {
            Ok(fit) => {
                logs.push(fit.curve.theta().ln());
                squares += fit.curve.beta().powi(2);
            }
            Err(AssessError::Observation {
                number,
                given,
                allowed,
            }) => {
                return Err(AssessError::Observation {
                    number,
                    given,
                    allowed,
                });
            }
            Err(_) => without_curve += 1,
        }
    }
    let all = (logs.len() + without_curve) as f64;
    if logs.len() < SAMPLES_LEAST || without_curve as f64 > WITHOUT_CURVE_MOST * all {
        return Ok(None);
    }
    Ok(Some(ScatterSplit {
        of_motions: (squares / logs.len() as f64).sqrt(),
        of_inputs: variance(&logs)?.sqrt(),
        samples: logs.len(),
        without_curve,
    }))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::{Random, mean};

    #[test]
    fn exact_the_split_of_known_capacities_is_the_analysis_of_variance() {
        let (count, of_samples) = (12, 30);
        let mut random = Random::new(5, 0);
        let shaken: Vec<f64> = (0..count).map(|_| 0.4 * random.normal()).collect();
        let (mut seen, mut motions, mut samples, mut rows) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
        for sample in 0..of_samples {
            let known = 0.25 * random.normal();
            let row: Vec<f64> = shaken
                .iter()
                .map(|a| a + known + 0.05 * random.normal())
                .collect();
            for (motion, x) in row.iter().enumerate() {
                seen.push(Observation::At(x.exp()));
                motions.push(motion);
                samples.push(sample);
            }
            rows.push(row);
        }
        let found = scatter_split(&seen, &motions, &samples).unwrap().unwrap();
        let means: Vec<f64> = rows.iter().map(|row| mean(row).unwrap()).collect();
        let within = rows
            .iter()
            .zip(&means)
            .map(|(row, m)| row.iter().map(|x| (x - m) * (x - m)).sum::<f64>() / f64::from(count));
        let within = (within.sum::<f64>() / of_samples as f64).sqrt();
        let over = variance(&means).unwrap().sqrt();
        assert!((found.of_motions - within).abs() < 1e-9, "{found:?} {within}");
        assert!((found.of_inputs - over).abs() < 1e-9, "{found:?} {over}");
        assert_eq!((found.samples, found.without_curve), (30, 0));
        let interval = found.of_inputs_interval(0.95).unwrap();
        // tabulated quantiles of χ² with 29 degrees of freedom: 16.047 and 45.722
        assert!((interval.lower / over - (29.0_f64 / 45.722).sqrt()).abs() < 1e-4);
        assert!((interval.upper / over - (29.0_f64 / 16.047).sqrt()).abs() < 1e-4);
    }

    /// Two of ten samples never reach the state: a split would exclude the strongest.
    #[test]
    fn refuses_a_split_that_leaves_out_the_strongest() {
        let (mut seen, mut motions, mut samples) = (Vec::new(), Vec::new(), Vec::new());
        for sample in 0..10 {
            for motion in 0..4 {
                let capacity = 0.2 + 0.05 * f64::from(sample) + 0.03 * f64::from(motion);
                seen.push(match sample {
                    8.. => Observation::Above(0.5),
                    _ => Observation::At(capacity),
                });
                motions.push(motion as usize);
                samples.push(sample as usize);
            }
        }
        assert_eq!(scatter_split(&seen, &motions, &samples).unwrap(), None);
        let known = scatter_split(&seen[..36], &motions[..36], &samples[..36]).unwrap();
        assert_eq!(known, None); // one of nine is more than a tenth
        assert!(
            scatter_split(&seen[..32], &motions[..32], &samples[..32])
                .unwrap()
                .is_some()
        );
    }

    #[test]
    fn refuses_a_split_of_two_samples() {
        let seen = [0.3, 0.4, 0.5, 0.2, 0.6, 0.4].map(Observation::At);
        let found = scatter_split(&seen, &[0, 1, 2, 0, 1, 2], &[0, 0, 0, 1, 1, 1]).unwrap();
        assert_eq!(found, None);
    }
}
