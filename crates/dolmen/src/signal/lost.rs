//! Fills short runs of lost samples by linear prediction.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | p | `order` | samples from which the next is predicted | – |
//! | a_l | `predictor` | a_0 = 1; e_t = Σ a_l x_{t−l} is the prediction error | – |
//! | b_j | `weight` | Σ_l a_l a_{l+j} | – |

use super::SignalError;
use dolmen_linalg::{Matrix, cholesky, solve_lower, solve_lower_transposed};
use std::ops::Range;

/// Longest run that is filled, samples. Our choice: the usual size of a gap in recorders, and a tenth of a period at the upper end of most
/// bands.
pub const LOST_RUN_MOST: usize = 8;
/// Largest share of a record that is filled. Our choice: at least 99 % of the samples behind any spectrum are measured.
pub const LOST_SHARE_MOST: f64 = 0.01;
/// Order of the prediction: two samples for each of 32 modes and machines.
const ORDER: usize = 64;
/// Largest number of samples from which the predictor is estimated.
const LEARNED_MOST: usize = 1 << 15;
/// Fraction of the variance below which the prediction is exact except for rounding.
const EXACT: f64 = 1e-13;

/// Fills lost samples so that the linear prediction error is smallest.
///
/// ```text
/// least Σ_t e_t²,  e_t = Σ_{l=0}^{p} a_l x_{t−l}   ⇒   Σ_j b_|i−j| x_j = 0  for every lost i               p = 64
/// ```
/// Burg's method estimates the predictor from the runs without lost samples. The values of `samples` at lost places are ignored. Lost runs
/// less than p apart are solved together.
///
/// # Errors
/// [`SignalError::Argument`] for a run that is empty, out of order or beyond the end.
///
/// # Limits
/// Valid for runs that are short compared with the periods of the signal; see [`LOST_RUN_MOST`] and [`LOST_SHARE_MOST`]. White noise cannot
/// be predicted: its lost samples become its mean. Within p samples of an end, only the samples on one side contribute.
///
/// # Source
/// Janssen, A. J. E. M., Veldhuis, R. N. J. and Vries, L. B. (1986) Adaptive interpolation of discrete-time signals that can be modeled as
/// autoregressive processes. IEEE Trans. ASSP 34(2):317-330. Differs from the source: the predictor is not estimated again from the filled
/// samples.
pub fn fill_lost(samples: &mut [f64], lost: &[Range<usize>]) -> Result<(), SignalError> {
    let n = samples.len();
    let mut after = 0;
    for run in lost {
        if run.start < after || run.is_empty() || run.end > n {
            return Err(SignalError::Argument {
                argument: "lost",
                given: run.start as f64,
                allowed: "the start of a run of samples within the series, in order and apart",
            });
        }
        after = run.end;
    }
    let whole = whole_runs(n, lost);
    let there: usize = whole.iter().map(Range::len).sum();
    if there == 0 {
        return Ok(());
    }
    let mean = whole.iter().flat_map(|run| &samples[run.clone()]).sum::<f64>() / there as f64;
    let order = ORDER.min(there / 8);
    let predictor = burg(samples, &learned(&whole, order), mean, order);
    let order = predictor.len() - 1;
    let weight: Vec<f64> = (0..=order)
        .map(|j| (0..=order - j).map(|l| predictor[l] * predictor[l + j]).sum())
        .collect();
    let mut rest = lost;
    while let Some(first) = rest.first() {
        // runs whose equations share unknowns
        let together = 1 + rest
            .windows(2)
            .take_while(|pair| pair[1].start - pair[0].end < order)
            .count();
        let (now, later) = rest.split_at(together);
        let unknown: Vec<usize> = now.iter().flat_map(Range::clone).collect();
        solve(
            samples,
            mean,
            &weight,
            &unknown,
            first.start.saturating_sub(order),
        );
        rest = later;
    }
    Ok(())
}

fn whole_runs(n: usize, lost: &[Range<usize>]) -> Vec<Range<usize>> {
    let starts = std::iter::once(0).chain(lost.iter().map(|run| run.end));
    let ends = lost.iter().map(|run| run.start).chain([n]);
    let whole = starts.zip(ends).map(|(start, end)| start..end);
    whole.filter(|run| !run.is_empty()).collect()
}

/// The runs used for the estimate: each is long enough, and in total they hold no more samples than needed.
fn learned(whole: &[Range<usize>], order: usize) -> Vec<Range<usize>> {
    let mut left = LEARNED_MOST;
    let mut taken = Vec::new();
    for run in whole.iter().filter(|run| run.len() > 2 * order) {
        let run = run.start..run.end.min(run.start + left);
        left -= run.len();
        taken.push(run);
        // the shortened run is too short
        if left <= 2 * order {
            break;
        }
    }
    taken
}

/// The coefficients a_0 = 1, a_1 … of the predictor. Burg's method minimises the forward and backward errors of all runs together.
fn burg(samples: &[f64], runs: &[Range<usize>], mean: f64, order: usize) -> Vec<f64> {
    let mut errors: Vec<[Vec<f64>; 2]> = runs
        .iter()
        .map(|run| {
            let forward: Vec<f64> = samples[run.clone()].iter().map(|x| x - mean).collect();
            [forward.clone(), forward]
        })
        .collect();
    let whole: f64 = errors
        .iter()
        .flat_map(|[forward, _]| forward)
        .map(|e| e * e)
        .sum();
    let mut left = whole;
    let mut a = vec![1.0];
    for m in 1..=order {
        let (mut product, mut squares) = (0.0, 0.0);
        for [forward, backward] in &errors {
            for (f, b) in forward[m..].iter().zip(&backward[m - 1..]) {
                product += f * b;
                squares += f * f + b * b;
            }
        }
        if squares <= 0.0 || left <= EXACT * whole {
            break; // nothing is left to predict
        }
        let reflection = -2.0 * product / squares;
        a.push(0.0);
        let before = a.clone();
        for (l, a) in a.iter_mut().enumerate() {
            *a += reflection * before[m - l];
        }
        for [forward, backward] in &mut errors {
            for t in (m..forward.len()).rev() {
                let (f, b) = (forward[t], backward[t - 1]);
                forward[t] = f + reflection * b;
                backward[t] = b + reflection * f;
            }
        }
        left *= 1.0 - reflection * reflection;
    }
    a
}

/// Solves Σ_j b_|i−j| x_j = 0 for the unknown x. If the system is nearly singular, straight lines replace its solution.
fn solve(samples: &mut [f64], mean: f64, weight: &[f64], unknown: &[usize], from: usize) {
    let order = weight.len() - 1;
    let near = |i: usize, j: usize| weight.get(i.abs_diff(j)).copied().unwrap_or(0.0);
    let matrix = Matrix::from_fn(unknown.len(), unknown.len(), |r, c| near(unknown[r], unknown[c]));
    let end = (unknown[unknown.len() - 1] + order + 1).min(samples.len());
    let mut is_known = vec![true; end - from];
    unknown.iter().for_each(|i| is_known[i - from] = false);
    let right: Vec<f64> = unknown
        .iter()
        .map(|&i| {
            let around = i.saturating_sub(order).max(from)..(i + order + 1).min(end);
            -around
                .filter(|j| is_known[j - from])
                .map(|j| near(i, j) * (samples[j] - mean))
                .sum::<f64>()
        })
        .collect();
    let found = cholesky(&matrix)
        .and_then(|lower| Ok((solve_lower(&lower, Matrix::from_column(&right))?, lower)))
        .and_then(|(half, lower)| solve_lower_transposed(&lower, half));
    match found {
        Ok(found) if found.column(0).iter().all(|x| x.is_finite()) => {
            for (&i, x) in unknown.iter().zip(found.column(0)) {
                samples[i] = mean + x;
            }
        }
        _ => straight(samples, mean, unknown),
    }
}

/// Places each lost sample on the straight line between the samples next to its run.
fn straight(samples: &mut [f64], mean: f64, unknown: &[usize]) {
    let mut at = 0;
    while at < unknown.len() {
        let mut end = at + 1;
        while end < unknown.len() && unknown[end] == unknown[end - 1] + 1 {
            end += 1;
        }
        let (first, last) = (unknown[at], unknown[end - 1]);
        let before = first.checked_sub(1).map(|i| samples[i]);
        let after = samples.get(last + 1).copied();
        let [from, to] = match (before, after) {
            (Some(before), Some(after)) => [before, after],
            (Some(one), None) | (None, Some(one)) => [one, one],
            (None, None) => [mean, mean],
        };
        let steps = (last + 2 - first) as f64;
        for (i, sample) in samples[first..=last].iter_mut().enumerate() {
            *sample = from + (to - from) * (i + 1) as f64 / steps;
        }
        at = end;
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn holds_sines_come_back() {
        // six exact coefficients predict three sines exactly; coefficients estimated from a finite record have a small error
        let whole: Vec<f64> = (0..4000)
            .map(|i| {
                let t = f64::from(i) * 0.01;
                (11.0 * t).sin() + 0.5 * (43.0 * t + 0.4).cos() + 0.2 * (97.0 * t).sin() + 3.0
            })
            .collect();
        let mut holed = whole.clone();
        let lost = [500..501, 1200..1208, 1215..1219, 3990..3993];
        lost.iter().cloned().flatten().for_each(|i| holed[i] = f64::NAN);
        fill_lost(&mut holed, &lost).unwrap();
        for (a, b) in whole.iter().zip(&holed) {
            approx::assert_abs_diff_eq!(a, b, epsilon = 3e-2);
        }
    }

    #[test]
    fn holds_what_is_left_of_a_run_to_learn_from_is_never_shorter_than_the_predictor() {
        let mut random = Random::new(11, 0);
        let whole: Vec<f64> = (0..2 * LEARNED_MOST).map(|_| random.normal()).collect();
        // the first run leaves this number of samples for the estimate of the predictor
        for left in [1, 31, ORDER, 2 * ORDER, 2 * ORDER + 1] {
            let mut holed = whole.clone();
            let lost = LEARNED_MOST - left..LEARNED_MOST - left + 1;
            holed[lost.start] = f64::NAN;
            fill_lost(&mut holed, std::slice::from_ref(&lost)).unwrap();
            assert!(holed[lost.start].abs() < 1.0, "{left}: {}", holed[lost.start]); // white noise: its mean
        }
    }

    #[test]
    fn exact_one_sample_of_a_first_order_process_has_the_least_error_that_there_is() {
        // x_t = φ x_{t−1} + e: the best estimate is φ/(1 + φ²)(x_{t−1} + x_{t+1}); its error has variance 1/(1 + φ²)
        let (phi, mut random) = (0.9, Random::new(7, 0));
        let mut x = vec![0.0; 30_000];
        for t in 1..x.len() {
            x[t] = phi * x[t - 1] + random.normal();
        }
        let lost: Vec<Range<usize>> = (1..148).map(|i| 200 * i..200 * i + 1).collect();
        let mut filled = x.clone();
        fill_lost(&mut filled, &lost).unwrap();
        let at: Vec<usize> = lost.iter().map(|run| run.start).collect();
        let squares: f64 = at.iter().map(|&t| (filled[t] - x[t]).powi(2)).sum();
        let variance = squares / at.len() as f64;
        // the standard deviation of the variance of 147 errors is 12 %
        assert!((variance * (1.0 + phi * phi) - 1.0).abs() < 0.35, "{variance}");
        let off = |t: &usize| filled[*t] - phi / (1.0 + phi * phi) * (x[t - 1] + x[t + 1]);
        let squares: f64 = at.iter().map(|t| off(t).powi(2)).sum();
        let rms = (squares / at.len() as f64).sqrt();
        assert!(rms < 0.15, "{rms}"); // of a deviation of 2.3
    }

    #[test]
    fn refuses_runs_out_of_order_or_beyond_the_end() {
        let mut x = vec![1.0; 50];
        for lost in [[40..41, 10..11], [0..1, 49..51], [0..1, 5..5]] {
            assert!(fill_lost(&mut x, &lost).is_err(), "{lost:?}");
        }
        let mut all = vec![f64::NAN; 4];
        fill_lost(&mut all, &[0..2, 2..4]).unwrap(); // nothing to estimate from: left alone
        let mut constant = vec![2.0; 100];
        constant[50] = f64::NAN;
        constant[53] = f64::NAN;
        fill_lost(&mut constant, &[50..51, 53..54]).unwrap();
        assert!((constant[50] - 2.0).abs() < 1e-12);
    }
}
