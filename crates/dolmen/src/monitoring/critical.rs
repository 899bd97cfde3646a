//! Distribution of the strongest change by chance: limits and probabilities from simulated series without change.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | n | `surveys` | surveys of a series |
//! | ρ | `correlation` | correlation of two successive surveys |
//! | p | `PROBABILITIES` | probability of a change at least this strong in a series without change |

use super::scan::strongest;
use super::series::Series;
use super::table::{CORRELATIONS, PROBABILITIES, QUANTILES, SURVEYS};
use super::whitening::Disturbance;
use crate::numeric::Random;

/// Series without change for a table of limits.
#[derive(Clone, Debug, PartialEq)]
pub struct NullSeries {
    /// Number of surveys of each series, 8 or more.
    pub surveys: usize,
    /// Correlation of two successive surveys.
    pub correlation: f64,
    /// Number of series.
    pub replicates: usize,
    /// Seed of the simulation.
    pub seed: u64,
}

/// The statistic |t| of the strongest change in series without change. Each has a level, a temperature through the
/// seasons and a disturbance, which are estimated from it. The table of this chapter contains quantiles of these
/// statistics (`examples/watch_limits.rs`).
pub fn null_statistics(of: &NullSeries) -> Vec<f64> {
    let n = of.surveys;
    let at: Vec<f64> = (0..n).map(|i| i as f64).collect();
    let seasons = (n as f64 / 3.0).clamp(6.0, 365.0);
    let one = |replicate: usize| {
        let mut random = Random::new(of.seed, replicate as u64);
        let begins = std::f64::consts::TAU * random.uniform();
        let warm = at
            .iter()
            .map(|t| (std::f64::consts::TAU * t / seasons + begins).sin() + 0.3 * random.normal())
            .collect();
        let columns = vec![vec![1.0; n], warm];
        let series = Series {
            readings: disturbed(
                &at,
                &vec![0.0; n],
                Disturbance {
                    sd: 1.0,
                    correlation: of.correlation,
                },
                &mut random,
            ),
            noise_sd: vec![0.0; n],
            at: at.clone(),
        };
        strongest(&series, &columns, None).map(|found| found.change.statistic.abs())
    };
    (0..of.replicates).filter_map(one).collect()
}

/// A simulated disturbance, with the noise of the readings.
pub(super) fn disturbed(at: &[f64], noise_sd: &[f64], of: Disturbance, random: &mut Random) -> Vec<f64> {
    let mut state = of.sd * random.normal();
    let mut out = Vec::with_capacity(at.len());
    for (i, noise_sd) in noise_sd.iter().enumerate() {
        if i > 0 {
            let rho = of.correlation.powf(at[i] - at[i - 1]);
            state = rho * state + of.sd * (1.0 - rho * rho).sqrt() * random.normal();
        }
        out.push(state + noise_sd * random.normal());
    }
    out
}

/// Quantiles for a number of surveys and a correlation, by linear interpolation of the table in ln n and ρ.
fn quantiles(surveys: usize, correlation: f64) -> [f64; PROBABILITIES.len()] {
    let ln_n = (surveys as f64).ln();
    let between = |grid: &[f64], value: f64| -> (usize, f64) {
        let last = grid.len() - 2;
        let i = grid.iter().rposition(|g| *g <= value).unwrap_or(0).min(last);
        (i, ((value - grid[i]) / (grid[i + 1] - grid[i])).clamp(0.0, 1.0))
    };
    let (i, a) = between(&SURVEYS.map(|n| f64::from(n).ln()), ln_n);
    let (j, b) = between(&CORRELATIONS, correlation);
    std::array::from_fn(|p| {
        let along = |i: usize| (1.0 - b) * QUANTILES[i][j][p] + b * QUANTILES[i][j + 1][p];
        (1.0 - a) * along(i) + a * along(i + 1)
    })
}

/// Interpolation and extrapolation with ln p linear in t².
fn between_probabilities(x: f64, from: &[f64], to: &[f64]) -> f64 {
    let last = from.len() - 2;
    let i = (0..last).find(|i| x <= from[i + 1]).unwrap_or(last);
    to[i] + (x - from[i]) / (from[i + 1] - from[i]) * (to[i + 1] - to[i])
}

/// Probability that the strongest change of one series without change is at least `statistic`.
pub(super) fn probability_of(statistic: f64, surveys: usize, correlation: f64) -> f64 {
    let squares = quantiles(surveys, correlation).map(|q| q * q);
    let ln_p = between_probabilities(statistic * statistic, &squares, &PROBABILITIES.map(f64::ln));
    ln_p.exp().min(1.0)
}

/// The statistic that the strongest change of a series without change exceeds with this probability.
pub(super) fn limit_of(probability: f64, surveys: usize, correlation: f64) -> f64 {
    let squares = quantiles(surveys, correlation).map(|q| q * q);
    let minus_ln_p = PROBABILITIES.map(|p| -p.ln());
    between_probabilities(-probability.ln(), &minus_ln_p, &squares)
        .max(1.0)
        .sqrt()
}
