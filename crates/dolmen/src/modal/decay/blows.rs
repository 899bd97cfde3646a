//! Detects forces within a decay: the motion grows suddenly and differs from the prediction by its past.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | y(t) | | samples of a channel, normalised to unit power |
//! | a_k, s | `weights`, `spacing` | y(t) = Σ a_k y(t - k s): a sum of decays satisfies one such equation in all
//! channels |
//! | e | `error` | prediction error, all channels together |

use crate::modal::ModalError;
use crate::numeric::middle;
use crate::signal::Record;
use dolmen_linalg::{Matrix, solve};

/// Number of prediction terms: twelve modes.
const TERMS: usize = 24;
/// Fraction of the record that the terms cover.
const REACH: f64 = 0.1;
/// Number of refits of the prediction, each with less weight for samples that it does not predict.
const ROUNDS: usize = 4;
/// Factors in power by which the prediction error must increase, relative to itself and to the motion, and by which
/// the motion must increase. Our choice.
const ERROR_RISES: f64 = 20.0;
const ERROR_SHARE: f64 = 0.02;
const MOTION_RISES: f64 = 1.5;
const SAMPLES_LEAST: usize = 240;

/// Times, s from the first sample, at which a new force excites the structure.
///
/// # Limits
/// Beats satisfy the prediction and are not blows. A blow that increases the motion at its time by less than half is
/// not detected.
pub(super) fn blows(record: &Record) -> Result<Vec<f64>, ModalError> {
    let samples = record.length();
    if samples < SAMPLES_LEAST {
        return Ok(Vec::new());
    }
    let spacing = ((REACH * samples as f64 / TERMS as f64).round() as usize).max(1);
    let first = TERMS * spacing;
    let channels: Vec<Vec<f64>> = (0..record.channels().len())
        .map(|c| {
            let y = record.samples(c);
            let power = y.iter().map(|y| y * y).sum::<f64>() / samples as f64;
            let scale = 1.0 / power.max(f64::MIN_POSITIVE).sqrt();
            y.iter().map(|y| scale * y).collect()
        })
        .collect();
    let error = foretold(&channels, spacing, first)?;
    let motion: Vec<f64> = (0..samples)
        .map(|t| channels.iter().map(|y| y[t] * y[t]).sum())
        .collect();
    Ok(rises(&error, &motion, first)
        .into_iter()
        .map(|t| t as f64 / record.sampling_rate_hz())
        .collect())
}

/// Power of the prediction error at each sample; 0 before the prediction begins.
fn foretold(channels: &[Vec<f64>], spacing: usize, first: usize) -> Result<Vec<f64>, ModalError> {
    let samples = channels[0].len();
    let mut error = vec![0.0; samples];
    let mut trust = vec![1.0; samples];
    for _ in 0..ROUNDS {
        let mut inner = Matrix::zeros(TERMS, TERMS);
        let mut towards = vec![0.0; TERMS];
        for y in channels {
            for t in first..samples {
                let before = |k: usize| y[t - (k + 1) * spacing];
                for i in 0..TERMS {
                    let x = trust[t] * before(i);
                    towards[i] += x * y[t];
                    for j in 0..=i {
                        inner[(i, j)] += x * before(j);
                    }
                }
            }
        }
        let trace: f64 = (0..TERMS).map(|i| inner[(i, i)]).sum();
        for i in 0..TERMS {
            // with more terms than modes there are many solutions; this term selects the smallest
            inner[(i, i)] += 1e-10 * trace / TERMS as f64 + f64::MIN_POSITIVE;
            for j in 0..i {
                inner[(j, i)] = inner[(i, j)];
            }
        }
        let weights = solve(&inner, &Matrix::from_column(&towards))?;
        for (t, e) in error.iter_mut().enumerate().skip(first) {
            let of = |y: &Vec<f64>| {
                let foretold: f64 = (0..TERMS)
                    .map(|k| weights[(k, 0)] * y[t - (k + 1) * spacing])
                    .sum();
                (y[t] - foretold).powi(2)
            };
            *e = channels.iter().map(of).sum();
        }
        let usual = middle(error[first..].to_vec()).max(f64::MIN_POSITIVE);
        for (w, e) in trust.iter_mut().zip(&error) {
            *w = 1.0 / (1.0 + e / usual);
        }
    }
    Ok(error)
}

/// Samples at which error and motion increase together: the clearest are selected first; the result is by time.
fn rises(error: &[f64], motion: &[f64], first: usize) -> Vec<usize> {
    let samples = error.len();
    let (short, long) = ((samples / 40).max(4), (samples / 20).max(8));
    let sums = |x: &[f64]| -> Vec<f64> {
        let mut total = 0.0;
        std::iter::once(0.0)
            .chain(x.iter().map(|x| {
                total += x;
                total
            }))
            .collect()
    };
    let (of_error, of_motion) = (sums(error), sums(motion));
    let mean = |sums: &[f64], from: usize, to: usize| (sums[to] - sums[from]) / (to - from) as f64;
    let mut found: Vec<(f64, usize)> = Vec::new();
    for t in first + short..samples.saturating_sub(long) {
        let before = mean(&of_error, t - short, t);
        let after = mean(&of_error, t, t + short);
        let motion_before = mean(&of_motion, t.saturating_sub(long), t);
        let motion_after = mean(&of_motion, t, t + long);
        if after > ERROR_RISES * before
            && after > ERROR_SHARE * motion_after
            && motion_after > MOTION_RISES * motion_before
        {
            found.push((after / before.max(f64::MIN_POSITIVE), t));
        }
    }
    found.sort_by(|a, b| b.0.total_cmp(&a.0));
    let apart = first;
    let mut taken: Vec<usize> = Vec::new();
    for (_, t) in found {
        if taken.iter().all(|other| other.abs_diff(t) > apart) {
            taken.push(t);
        }
    }
    taken.sort_unstable();
    taken
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;
    use std::f64::consts::PI;

    /// Two channels of three modes, 20 s at 100 Hz, with blows at these times.
    fn record(modes: &[(f64, f64, [f64; 2])], struck_s: &[f64], noise: f64) -> Record {
        let mut random = Random::new(3, 0);
        let mut at = |c: usize, i: u32| -> f64 {
            let t = 0.01 * f64::from(i);
            let swing = |(f, zeta, shape): &(f64, f64, [f64; 2])| {
                let omega = 2.0 * PI * f;
                let since = struck_s.iter().filter(|s| **s <= t).map(|s| t - s);
                let all: f64 = since.map(|t| (-zeta * omega * t).exp() * (omega * t).sin()).sum();
                shape[c] * all
            };
            modes.iter().map(swing).sum::<f64>() + noise * random.normal()
        };
        let samples = (0..2).map(|c| (0..2000).map(|i| at(c, i)).collect()).collect();
        let names = vec![Channel::named("a"), Channel::named("b")];
        Record::new(names, samples, 100.0).unwrap()
    }

    #[test]
    fn holds_a_second_blow_is_found_at_its_time_and_a_beat_is_none() {
        let modes = [(1.6, 0.012, [1.0, 0.7]), (4.4, 0.015, [-0.4, 0.4])];
        for noise in [0.0, 0.02] {
            let found = blows(&record(&modes, &[0.0, 11.0], noise)).unwrap();
            assert!(found.len() == 1 && (found[0] - 11.0).abs() < 0.3, "{found:?}");
            assert!(blows(&record(&modes, &[0.0], noise)).unwrap().is_empty());
        }
        // two modes that beat: the motion vanishes and grows again without a force
        let close = [(1.6, 0.002, [1.0, 0.7]), (1.75, 0.002, [1.0, 0.7])];
        for noise in [0.0, 0.02] {
            assert!(blows(&record(&close, &[0.0], noise)).unwrap().is_empty());
        }
    }
}
