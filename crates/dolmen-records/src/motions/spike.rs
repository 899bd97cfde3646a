//! Samples that no ground made: codes for missing values, and a single sample far beyond all others.

use super::MotionError;

/// Numbers that tables use for a missing value, without their sign.
const CODES: [f64; 8] = [99.99, 999.0, 999.9, 999.99, 999.999, 9999.0, 99999.0, 999_999.0];
/// A code stands out if its neighbours are at most this part of it. Our choice.
const NEIGHBOUR_MOST: f64 = 0.5;
/// Factor between a spike and every other sample. Our choice: two to three samples of a recorded peak are of its size.
const SPIKE: f64 = 3.0;
/// Fewest samples of a record with a spike. Our choice: shorter ones are made by hand.
const SAMPLES_LEAST: usize = 50;

/// Whether a table also writes a code for a missing value.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Codes {
    /// A table, with the numbers as written.
    Possible,
    /// A format of a network, which has none.
    None,
}

/// Refuses samples with a code for a missing value or a spike. `line_of` gives the line of a sample, if the file has one for each.
pub(super) fn refuse_spikes(
    samples: &[f64],
    time_step_s: f64,
    codes: Codes,
    line_of: &dyn Fn(usize) -> Option<usize>,
) -> Result<(), MotionError> {
    if samples.len() < SAMPLES_LEAST {
        return Ok(());
    }
    let code = match codes {
        Codes::Possible => missing(samples),
        Codes::None => None,
    };
    if let Some(sample) = code {
        return Err(MotionError::MissingCode {
            line: line_of(sample),
            at_s: sample as f64 * time_step_s,
            value: samples[sample],
            count: samples.iter().filter(|value| **value == samples[sample]).count(),
        });
    }
    match spike(samples) {
        Some((sample, others)) => Err(MotionError::Spike {
            line: line_of(sample),
            at_s: sample as f64 * time_step_s,
            value: samples[sample],
            others,
        }),
        None => Ok(()),
    }
}

/// The first sample with a code, if the code is the largest number of the record or no other number is whole.
fn missing(samples: &[f64]) -> Option<usize> {
    let is_code = |value: f64| CODES.contains(&value.abs());
    let rest = || samples.iter().filter(|value| !is_code(**value));
    let largest = rest().fold(0.0, |most: f64, value| most.max(value.abs()));
    let whole = rest().filter(|value| value.fract() == 0.0).count();
    let has_fractions = 2 * whole < rest().count();
    let stands_out = |at: usize| {
        let code = samples[at];
        let beside = |beside: Option<&f64>| beside.is_none_or(|other| (other / code).abs() <= NEIGHBOUR_MOST);
        let before = samples[..at].iter().rev().find(|other| **other != code);
        let after = samples[at..].iter().find(|other| **other != code);
        beside(before) && beside(after)
    };
    let mut each = (0..samples.len()).filter(|at| is_code(samples[*at]));
    each.find(|at| (samples[*at].abs() > largest || has_fractions) && stands_out(*at))
}

/// A single sample beyond [`SPIKE`] times every other, and the largest of the others.
fn spike(samples: &[f64]) -> Option<(usize, f64)> {
    let (at, value) = samples
        .iter()
        .enumerate()
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    let others = samples.iter().enumerate().filter(|(other, _)| *other != at);
    let largest = others.fold(0.0, |most: f64, (_, other)| most.max(other.abs()));
    (largest > 0.0 && value.abs() > SPIKE * largest).then_some((at, largest))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A decaying sine of amplitude 200 in 400 samples, 20 samples a period.
    fn record() -> Vec<f64> {
        (0..400)
            .map(|k| f64::from(k) / 20.0)
            .map(|t| (200.0 * (-0.1 * t).exp() * (std::f64::consts::TAU * t).sin() * 1e3).round() / 1e3)
            .collect()
    }

    fn with(changes: &[(usize, f64)]) -> Vec<f64> {
        let mut samples = record();
        changes.iter().for_each(|(at, value)| samples[*at] = *value);
        samples
    }

    fn found(samples: &[f64]) -> Result<(), MotionError> {
        refuse_spikes(samples, 0.01, Codes::Possible, &|at| Some(at + 2))
    }

    #[test]
    fn refuses_codes_for_missing_values_and_lone_spikes() {
        for code in [-999.0, 9999.0, 999.9] {
            for changes in [
                vec![(100, code)],
                vec![(100, code), (300, code)],
                vec![(0, code)],
                vec![(398, code), (399, code)],
            ] {
                let first = changes[0].0;
                let Err(MotionError::MissingCode {
                    line, value, count, ..
                }) = found(&with(&changes))
                else {
                    panic!("{changes:?} passed");
                };
                assert_eq!((line, value, count), (Some(first + 2), code, changes.len()));
            }
        }
        let Err(MotionError::Spike {
            at_s, value, others, ..
        }) = found(&with(&[(250, 700.0)]))
        else {
            panic!("a spike passed");
        };
        assert_eq!((at_s, value), (2.5, 700.0));
        assert!(others < 200.0 && others > 150.0, "{others}");
    }

    #[test]
    fn holds_records_of_the_ground_pass() {
        assert_eq!(found(&record()), Ok(()));
        // a strong record passes through 999 between samples of its size
        let strong: Vec<f64> = record().iter().map(|a| 8.0 * a).collect();
        let mut passing = strong.clone();
        passing[3] = 999.0;
        assert_eq!(found(&passing), Ok(()));
        // one period within four samples
        let sharp: Vec<f64> = (0..400)
            .map(|k| f64::from(k - 200) / 2.0)
            .map(|t| 300.0 * (1.0 - 2.0 * t * t) * (-t * t).exp())
            .collect();
        assert_eq!(found(&sharp), Ok(()));
        assert_eq!(found(&[0.0, 0.0, -999.0, 0.0]), Ok(())); // made by hand
    }
}
