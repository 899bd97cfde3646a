//! The limit of an exponentially weighted moving average for a given rate of false alarms.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | L | `limit` | limit over the standard deviation of the average, √(λ/(2 − λ)) | - |
//! | L | `limit` | limit over the average's own deviation √(λ/(2 − λ)) | - |
//! | | `run_length` | mean number of surveys until a false alarm | - |

use super::MonitoringError;
use crate::numeric::normal_probability;
use dolmen_linalg::{Matrix, solve};

/// Number of cells of the Markov chain between 0 and the limit. With 40 cells, the run lengths agree with
/// published tables to 1 %.
const CELLS: usize = 40;
/// Range of the limits in the search.
const LIMIT_LEAST: f64 = 1.0;
const LIMIT_MOST: f64 = 6.0;
/// Number of steps between them: the tolerance of a limit is one step, 6e-4.
const LIMIT_STEPS: usize = 8192;
/// Largest number of secant steps before the search bisects; about five are usual.
const LINES_MOST: usize = 12;

/// Mean number of surveys until the average of independent normal scores exceeds its limit on either side.
///
/// ```text
/// E_i = (1 − λ) E_{i−1} + λ u_i,   beyond: |E_i| > L √(λ/(2 − λ))
/// ```
/// A Markov chain follows E between cells of equal width; positive and negative values are combined.
///
/// # Errors
/// [`MonitoringError::Option`] for a weight or limit out of range.
///
/// # Source
/// Brook & Evans (1972) Biometrika 59:539-549; run lengths in Lucas & Saccucci (1990) Technometrics 32:1-12.
pub fn ewma_run_length(weight: f64, limit: f64) -> Result<f64, MonitoringError> {
    let refused = |option, given, allowed| {
        Err(MonitoringError::Option {
            option,
            given,
            allowed,
        })
    };
    if !(weight > 0.0 && weight <= 1.0) {
        return refused("weight", weight, "above 0 and at most 1");
    }
    if !(limit > 0.0 && limit <= 10.0) {
        return refused("limit", limit, "above 0 and at most 10");
    }
    // from −h to h an odd number of cells, one of them about 0; the states are |E|
    let h = limit * (weight / (2.0 - weight)).sqrt();
    let width = 2.0 * h / (2 * CELLS + 1) as f64;
    // for each cell, the probabilities of an average below the edges of all cells, from the lowest on
    let below: Vec<Vec<f64>> = (0..=CELLS)
        .map(|i| {
            let at = i as f64 * width;
            let edges = (0..2 * CELLS + 2).map(|edge| edge as f64 - CELLS as f64 - 0.5);
            edges
                .map(|edge| normal_probability((edge * width - (1.0 - weight) * at) / weight))
                .collect()
        })
        .collect();
    let transition = |i: usize, j: usize| {
        let reach = |cell: usize| below[i][cell + 1] - below[i][cell];
        let other_side = if j == 0 { 0.0 } else { reach(CELLS - j) };
        reach(CELLS + j) + other_side
    };
    let chain = Matrix::from_fn(CELLS + 1, CELLS + 1, |i, j| {
        f64::from(u8::from(i == j)) - transition(i, j)
    });
    let ones = Matrix::from_column(&[1.0; CELLS + 1]);
    match solve(&chain, &ones) {
        Ok(lengths) => Ok(lengths.column(0)[0]),
        Err(_) => Ok(f64::INFINITY),
    }
}

/// The limit with one false alarm in `run_length` surveys, between 1 and 6.
///
/// # Errors
/// As [`ewma_run_length`].
pub fn ewma_limit(weight: f64, run_length: f64) -> Result<f64, MonitoringError> {
    let limit_at = |step: f64| LIMIT_LEAST + (LIMIT_MOST - LIMIT_LEAST) * step / LIMIT_STEPS as f64;
    let (mut low, mut high) = (0, LIMIT_STEPS);
    // ln of the run length is nearly linear in L²: secant steps through the last two points
    let mut asked: [Option<(f64, f64)>; 2] = [None, None];
    let mut next = LIMIT_STEPS / 2;
    let mut lines = 0;
    while high - low > 1 {
        let limit = limit_at(next as f64);
        let reached = ewma_run_length(weight, limit)?;
        if reached < run_length {
            low = next;
        } else {
            high = next;
        }
        asked = [asked[1], Some((limit * limit, (reached / run_length).ln()))];
        let sought = match asked {
            [Some((from, over)), Some((to, by))] => to - by * (to - from) / (by - over),
            [_, Some((to, by))] => to - 2.0 * by,
            _ => f64::NAN,
        };
        let step = (sought.sqrt() - LIMIT_LEAST) / (LIMIT_MOST - LIMIT_LEAST) * LIMIT_STEPS as f64;
        lines += 1;
        let beyond = usize::from(reached < run_length);
        next = match step.is_finite() && lines < LINES_MOST {
            true => (step.max(0.0) as usize + beyond).max(low + 1).min(high - 1),
            false => low.midpoint(high),
        };
    }
    Ok(0.5 * (limit_at(low as f64) + limit_at(high as f64)))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn published_run_lengths_of_lucas_and_saccucci() {
        // Lucas & Saccucci (1990) table 3, no shift: run lengths of about 500
        for (weight, limit) in [(0.4, 3.054), (0.25, 2.998), (0.2, 2.962), (0.1, 2.814)] {
            let found = ewma_run_length(weight, limit).unwrap();
            assert!((found / 500.0 - 1.0).abs() < 0.02, "{weight} {limit}: {found}");
        }
        assert!((ewma_limit(0.2, 500.0).unwrap() - 2.962).abs() < 0.01);
        // λ = 1 is Shewhart's chart: 1/P(|u| > 3) = 370.4
        assert!((ewma_run_length(1.0, 3.0).unwrap() / 370.398 - 1.0).abs() < 1e-3);
    }

    #[test]
    fn agrees_with_halving_at_every_rate() {
        for weight in [0.01, 0.1, 0.2, 0.5, 1.0] {
            for run_length in [1.0, 5.0, 60.0, 487.3, 1e4, 1e7, 1e12] {
                let (mut low, mut high) = (LIMIT_LEAST, LIMIT_MOST);
                while high - low > 1e-3 {
                    let middle = 0.5 * (low + high);
                    if ewma_run_length(weight, middle).unwrap() < run_length {
                        low = middle;
                    } else {
                        high = middle;
                    }
                }
                let found = ewma_limit(weight, run_length).unwrap();
                assert_eq!(found, 0.5 * (low + high), "{weight} {run_length}");
            }
        }
    }

    #[test]
    fn agrees_with_runs_that_are_drawn() {
        let (weight, limit) = (0.2_f64, 2.5);
        let h = limit * (weight / (2.0 - weight)).sqrt();
        let mut random = Random::new(11, 0);
        let runs = 4000;
        let mut surveys = 0.0;
        for _ in 0..runs {
            let mut average = 0.0_f64;
            while average.abs() <= h {
                average = (1.0 - weight) * average + weight * random.normal();
                surveys += 1.0;
            }
        }
        let found = ewma_run_length(weight, limit).unwrap();
        // a mean of nearly exponential lengths: 1/√4000 = 1.6 %
        assert!((surveys / f64::from(runs) / found - 1.0).abs() < 0.05, "{found}");
    }
}
