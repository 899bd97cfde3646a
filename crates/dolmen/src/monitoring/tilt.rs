//! The slope of a tilt over the years, and when it would reach a limit.

use super::MonitoringError;
use super::regression::{Fit, Series, restricted_likelihood};
use super::weather::YEAR_DAYS;
use crate::numeric::{student_detectable, student_two_sided, student_two_sided_quantile};
use std::f64::consts::TAU;

/// Readings that a slope needs; a season beside it needs so many, over so many years. Chosen here.
const READINGS_LEAST: usize = 4;
const SEASON_READINGS_LEAST: usize = 10;
const SEASON_YEARS_LEAST: f64 = 2.0;

/// The readings of one tilt: one direction, one datum.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltSeries {
    /// The direction in which it leans.
    pub direction: String,
    /// The mark that it refers to.
    pub datum: Option<String>,
    /// Index of each reading's survey.
    pub surveys: Vec<usize>,
    /// Its day.
    pub days: Vec<f64>,
    /// Horizontal over vertical.
    pub ratios: Vec<f64>,
}

/// A slope of a tilt.
#[derive(Clone, Debug, PartialEq)]
pub struct TiltTrend {
    /// The readings.
    pub series: TiltSeries,
    /// The slope; `None` with fewer than four readings of one level.
    pub slope: Option<TiltSlope>,
    /// Probability below which a slope is beyond chance: that of all tilts, shared among them.
    pub significance: f64,
}

impl TiltTrend {
    /// Whether it has a slope beyond chance.
    pub fn is_beyond_chance(&self) -> bool {
        self.slope.is_some_and(|slope| slope.p_value < self.significance)
    }
}

/// By how much a tilt grows.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltSlope {
    /// Slope, 1/year.
    pub per_year: f64,
    /// Its standard deviation.
    pub sd_per_year: f64,
    /// Probability of such a slope by chance.
    pub p_value: f64,
    /// The slope that would have been seen with 80 % probability.
    pub seen_from_per_year: f64,
    /// Tilt on the day of the last reading, the season removed.
    pub now: f64,
    /// Tilt at the limit less that now, over the limit's distance; `None` without a limit.
    pub reach: Option<TiltReach>,
}

/// When a tilt reaches its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltReach {
    /// The limit, with the sign of the tilt.
    pub limit: f64,
    /// Years from the last reading to it, at the slope; `None` where the slope is not beyond chance or leads away from it.
    pub years: Option<f64>,
    /// Ends of the 95 % interval; the later infinite where the slope may be none.
    pub years_earliest: Option<f64>,
    /// The later end.
    pub years_latest: Option<f64>,
}

/// The slope through the readings, the disturbance estimated with it; `levels` are the days of works that changed the structure.
///
/// # Errors
/// [`MonitoringError::Numeric`].
pub(super) fn tilt_trend(
    series: TiltSeries,
    levels: &[f64],
    significance: f64,
    limit: Option<f64>,
) -> Result<TiltTrend, MonitoringError> {
    let n = series.days.len();
    let (Some(first), Some(last)) = (series.days.first().copied(), series.days.last().copied()) else {
        return Ok(TiltTrend {
            series,
            slope: None,
            significance,
        });
    };
    let years: Vec<f64> = series.days.iter().map(|day| (day - last) / YEAR_DAYS).collect();
    let mut columns = vec![vec![1.0; n], years];
    for level in levels {
        let step: Vec<f64> = series
            .days
            .iter()
            .map(|day| f64::from(u8::from(day < level)))
            .collect();
        if step.contains(&1.0) && step.contains(&0.0) {
            columns.push(step);
        }
    }
    if n >= SEASON_READINGS_LEAST && last - first >= SEASON_YEARS_LEAST * YEAR_DAYS {
        for shift in [0.0, -0.25 * TAU] {
            columns.push(
                series
                    .days
                    .iter()
                    .map(|day| (TAU * day / YEAR_DAYS + shift).cos())
                    .collect(),
            );
        }
    }
    if n < READINGS_LEAST.max(columns.len() + 2) {
        return Ok(TiltTrend {
            series,
            slope: None,
            significance,
        });
    }
    let mut gaps: Vec<f64> = series.days.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    let gap = gaps[gaps.len() / 2].max(f64::MIN_POSITIVE);
    let readings = Series {
        at: series.days.iter().map(|day| (day - first) / gap).collect(),
        readings: series.ratios.clone(),
        noise_sd: vec![0.0; n],
    };
    let fit = restricted_likelihood(&readings, &columns, None)
        .and_then(|disturbance| Fit::new(&readings, &columns, disturbance));
    let Some(fit) = fit else {
        return Ok(TiltTrend {
            series,
            slope: None,
            significance,
        });
    };
    let degrees = (n - columns.len()) as f64;
    let (per_year, sd, now) = (fit.coefficients[1], fit.sd[1], fit.coefficients[0]);
    let p_value = match sd > 0.0 {
        true => student_two_sided(per_year / sd, degrees)?,
        false => 1.0,
    };
    let quantile = student_two_sided_quantile(0.05, degrees)?;
    let reach = limit.map(|limit| {
        let limit = if now < 0.0 { -limit.abs() } else { limit.abs() };
        let left = limit - now;
        let until = |slope: f64| (slope * left > 0.0).then(|| left / slope);
        let toward = per_year * left.signum();
        let is_seen = p_value < significance && toward > 0.0;
        TiltReach {
            limit,
            years: until(per_year).filter(|_| is_seen),
            years_earliest: until(per_year + left.signum() * quantile * sd).filter(|_| is_seen),
            years_latest: until(per_year - left.signum() * quantile * sd).filter(|_| is_seen),
        }
    });
    Ok(TiltTrend {
        series,
        significance,
        slope: Some(TiltSlope {
            per_year,
            sd_per_year: sd,
            p_value,
            seen_from_per_year: sd * student_detectable(significance, 0.8, degrees)?,
            now,
            reach,
        }),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn made(per_year: f64, noise: f64) -> TiltSeries {
        let mut random = Random::new(4, 0);
        let days: Vec<f64> = (0..24).map(|i| 182.0 * f64::from(i)).collect();
        TiltSeries {
            direction: "x".into(),
            datum: None,
            surveys: (0..24).collect(),
            ratios: days
                .iter()
                .map(|day| {
                    0.004
                        + per_year * day / YEAR_DAYS
                        + 2e-4 * (TAU * day / YEAR_DAYS).sin()
                        + noise * random.normal()
                })
                .collect(),
            days,
        }
    }

    #[test]
    fn holds_a_true_slope_is_found_and_reaches_its_limit() {
        let found = tilt_trend(made(1e-4, 5e-5), &[], 0.05, Some(1.0 / 150.0))
            .unwrap()
            .slope
            .unwrap();
        assert!(
            (found.per_year - 1e-4).abs() < 2.5 * found.sd_per_year && found.p_value < 1e-4,
            "{found:?}"
        );
        let reach = found.reach.unwrap();
        // 23 half years at 1e-4 from 0.004: 0.0015 below 1/150 in 2026.5
        let truth = (1.0 / 150.0 - 0.004 - 1e-4 * 23.0 * 182.0 / YEAR_DAYS) / 1e-4;
        assert!(
            reach.years_earliest.unwrap() < truth && truth < reach.years_latest.unwrap(),
            "{reach:?} {truth}"
        );
    }

    #[test]
    fn holds_no_slope_gives_no_date() {
        let found = tilt_trend(made(0.0, 1e-4), &[], 0.05, Some(1.0 / 150.0))
            .unwrap()
            .slope
            .unwrap();
        assert!(
            found.p_value > 0.05 && found.reach.unwrap().years.is_none(),
            "{found:?}"
        );
        assert!(found.seen_from_per_year > 2.5 * found.sd_per_year);
    }
}
