//! A rate of a log that grows or falls steadily, and the time at which the log then reaches its limit.
//!
//! ```text
//! y = y₀ + b τ + ½ a τ² + …,   τ = t − t_last        a: `per_year2`, b: the rate on the last day
//! ```

use super::MonitoringError;
use super::bends::BentFit;
use super::critical::disturbed;
use super::logged_law::Law;
use super::logged_season::SeasonForm;
use super::regression::{Fit, restricted_likelihood};
use super::series::Series;
use super::tilt::{TiltReach, TiltSlope};
use super::weather::YEAR_DAYS;
use super::whitening::Disturbance;
use crate::numeric::{Random, student_two_sided};

/// Number of simulated series for the probability of a change by chance. Our choice.
const REPLICATES: usize = 199;
/// Correlation of neighbouring medians from which they are simulated as a random walk, and the correlation of this walk. Our choice.
const WALKS_FROM: f64 = 0.7;
const WALK: f64 = 0.999;

/// The steady change of the rate of a log.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedCurve {
    /// Change of the rate, 1/year².
    pub per_year2: f64,
    /// Its standard deviation.
    pub sd_per_year2: f64,
    /// Probability of such a change by chance, from medians whose slope has the largest standard deviation.
    pub p_value: f64,
    /// Rate on the first day, 1/year, without changes of slope.
    pub first_per_year: f64,
    /// Time at which the log reaches the limit if the rate stays as it is on the last day. The slope of a log that speeds up has the time by the law
    /// instead.
    pub at_rate: Option<TiltReach>,
}

impl LoggedCurve {
    /// Whether the size of the rate grows.
    pub fn speeds_up(&self, per_year: f64) -> bool {
        self.per_year2 * per_year > 0.0
    }
}

/// The column of a steady change of the rate: 0, with slope 0, on the last day.
pub(super) fn curve_column(days: &[f64], last: f64) -> Vec<f64> {
    days.iter().map(|day| curve_value(*day, last)).collect()
}

/// Value of the column on one day.
pub(super) fn curve_value(day: f64, last: f64) -> f64 {
    0.5 * ((day - last) / YEAR_DAYS).powi(2)
}

/// Probability of a steady change of the rate at least as strong as `statistic` by chance. Series without it, with the disturbance that is estimated
/// without it, are simulated, and the disturbance is estimated again for each. The column of the change is the last one.
///
/// Beyond the strongest simulated change, ln p is linear in ln |t| through the simulated quantiles of 10 % and 1 %: the tail of a random walk is heavy.
pub(super) fn by_chance(series: &Series, columns: &[Vec<f64>], statistic: f64, seed: u64) -> Option<f64> {
    let without = restricted_likelihood(series, columns.get(..columns.len() - 1)?, None)?;
    // at its largest correlation the estimate does not exclude a random walk
    let kept = without.correlation.powi(2);
    let wandering = Disturbance {
        sd: without.sd * ((1.0 - kept) / (1.0 - WALK * WALK)).sqrt(),
        correlation: WALK,
    };
    let by = match without.correlation >= WALKS_FROM {
        true => wandering,
        false => without,
    };
    let simulated = (0..REPLICATES).filter_map(|replicate| {
        let mut random = Random::new(seed, replicate as u64);
        let made = Series {
            readings: disturbed(&series.at, &series.noise_sd, by, &mut random),
            ..series.clone()
        };
        last_statistic(&made, columns, Some(without))
    });
    let mut sizes: Vec<f64> = simulated.map(f64::abs).collect();
    sizes.sort_by(|a, b| b.total_cmp(a));
    let (size, all) = (statistic.abs(), (sizes.len() + 1) as f64);
    let larger = sizes.iter().filter(|other| **other >= size).count();
    if larger > 0 {
        return Some((larger + 1) as f64 / all);
    }
    let at = |p: f64| sizes.get((p * all).round() as usize - 1).copied();
    let (tenth, hundredth) = (at(0.1)?, at(0.01)?);
    let beyond = (size / hundredth).ln() / (hundredth / tenth).ln();
    Some(0.01 * 0.1_f64.powf(beyond.max(0.0)))
}

/// The coefficient of the last column over its standard deviation.
pub(super) fn last_statistic(
    series: &Series,
    columns: &[Vec<f64>],
    start: Option<Disturbance>,
) -> Option<f64> {
    let disturbance = restricted_likelihood(series, columns, start)?;
    let fit = Fit::new(series, columns, disturbance)?;
    Some(fit.coefficients.last()? / fit.sd.last()?)
}

/// The curve of a fit over so many years whose column `at` is that of [`curve_column`]. If the log speeds up, `slope` receives the time at which this law reaches the
/// limit, and the curve keeps the time by the rate of the last day.
///
/// # Errors
/// [`MonitoringError::Numeric`].
pub(super) fn curve_of(
    found: &BentFit,
    (at, years): (usize, f64),
    season: Option<&SeasonForm>,
    slope: &mut TiltSlope,
) -> Result<LoggedCurve, MonitoringError> {
    let (fit, degrees) = (&found.fit, found.degrees);
    let (per_year2, sd) = (fit.coefficients[at], fit.sd[at]);
    let curve = LoggedCurve {
        per_year2,
        sd_per_year2: sd,
        p_value: match sd > 0.0 {
            true => student_two_sided(per_year2 / sd, degrees)?,
            false => 1.0,
        },
        first_per_year: slope.per_year - per_year2 * years,
        at_rate: slope.reach,
    };
    if curve.speeds_up(slope.per_year)
        && let Some(reach) = slope.reach.as_mut()
    {
        let law = Law {
            fit,
            curve_at: Some(at),
            season,
            to: reach.limit,
            toward: per_year2.signum(),
        };
        law.set_years(degrees, reach)?;
    }
    Ok(curve)
}
