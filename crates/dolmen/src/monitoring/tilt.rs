//! The slope of a tilt over the years, and when it would reach a limit.

use super::MonitoringError;
use super::changes::effective_correlation;
use super::critical::limit_of;
use super::regression::{Fit, restricted_likelihood};
use super::scan::{Candidate, ChangeForm, column, strongest};
use super::series::Series;
use super::weather::YEAR_DAYS;
use crate::numeric::{student_detectable, student_two_sided, student_two_sided_quantile};
use std::f64::consts::TAU;

/// Readings that a slope needs; a season beside it needs so many, over so many years. Chosen here.
const READINGS_LEAST: usize = 4;
const SEASON_READINGS_LEAST: usize = 10;
pub(super) const SEASON_YEARS_LEAST: f64 = 2.0;

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
    /// A step beyond chance, which the slope leaves out; `None` where none is shown.
    pub jump: Option<TiltJump>,
    /// Probability below which a slope is beyond chance: that of all tilts, shared among them.
    pub significance: f64,
}

/// A step of a tilt, to stay or in its last readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltJump {
    /// Index of the first reading after it.
    pub from: usize,
    /// Its size, horizontal over vertical.
    pub size: f64,
    /// Standard deviation of that.
    pub sd: f64,
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
    /// When it reaches the limit; `None` without a limit.
    pub reach: Option<TiltReach>,
}

impl TiltSlope {
    /// Tilt now over its limit, whatever their signs; `None` without a limit.
    pub fn share_of_limit(&self) -> Option<f64> {
        self.reach.map(|reach| (self.now / reach.limit).abs())
    }
}

/// When a tilt reaches its limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltReach {
    /// The limit, with the sign of the slope where that is beyond chance, else of the tilt now.
    pub limit: f64,
    /// Years from the last reading to it, at the slope; `None` where the slope is not beyond chance, or the tilt is beyond the limit.
    pub years: Option<f64>,
    /// Ends of the 95 % interval of a ratio of two estimates (Fieller 1954), the tilt now and the slope, not before the last reading.
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
            jump: None,
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
        columns.extend(season(&series.days));
    }
    if n < READINGS_LEAST.max(columns.len() + 2) {
        return Ok(TiltTrend {
            series,
            slope: None,
            jump: None,
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
            jump: None,
            significance,
        });
    };
    let jump = jump(&readings, &columns, significance);
    if let Some(of) = jump {
        columns.push(column(&readings.at, ChangeForm::Step, of.from));
    }
    let fit = match jump {
        None => Some(fit),
        Some(_) => restricted_likelihood(&readings, &columns, None)
            .and_then(|disturbance| Fit::new(&readings, &columns, disturbance)),
    };
    let Some(mut fit) = fit else {
        return Ok(TiltTrend {
            series,
            slope: None,
            jump,
            significance,
        });
    };
    if let Some(of) = jump {
        // the level is that of the last reading
        fit.coefficients[0] += of.size;
    }
    let degrees = (n - columns.len()) as f64;
    let limit = limit.map(|size| SlopeLimit {
        size,
        is_one_sided: false,
    });
    Ok(TiltTrend {
        series,
        significance,
        jump,
        slope: Some(slope_of(&fit, degrees, significance, limit)?),
    })
}

/// The strongest step beyond chance beside the slope, the season and the levels of works; that of the last one or two readings too.
fn jump(readings: &Series, columns: &[Vec<f64>], significance: f64) -> Option<TiltJump> {
    const READINGS_MORE: usize = 6; // than columns: else a step is not told from what is known
    let n = readings.len();
    if n < columns.len() + READINGS_MORE {
        return None;
    }
    let best = strongest(readings, columns, None)?;
    let step = Some(best.change).filter(|of| of.form == ChangeForm::Step);
    let larger = |a: Candidate, b: Candidate| match b.statistic.abs() > a.statistic.abs() {
        true => b,
        false => a,
    };
    let found = step.into_iter().chain(best.late).reduce(larger)?;
    let limit = limit_of(significance, n, effective_correlation(readings, best.without));
    (found.statistic.abs() > limit).then_some(TiltJump {
        from: found.from,
        size: found.size,
        sd: found.sd,
    })
}

/// What a reading must not reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SlopeLimit {
    /// Its size, above 0.
    pub size: f64,
    /// Whether it holds on the positive side alone: a crack opens.
    pub is_one_sided: bool,
}

impl SlopeLimit {
    /// Whether a reading is at it.
    pub(super) fn is_reached(&self, reading: f64) -> bool {
        match self.is_one_sided {
            true => reading >= self.size,
            false => reading.abs() >= self.size,
        }
    }
}

/// The slope of a fit whose first column is the level at the last reading and whose second is years from it.
pub(super) fn slope_of(
    fit: &Fit,
    degrees: f64,
    significance: f64,
    limit: Option<SlopeLimit>,
) -> Result<TiltSlope, MonitoringError> {
    let (per_year, sd, now) = (fit.coefficients[1], fit.sd[1], fit.coefficients[0]);
    let p_value = match sd > 0.0 {
        true => student_two_sided(per_year / sd, degrees)?,
        false => 1.0,
    };
    let quantile = student_two_sided_quantile(0.05, degrees)?;
    let reach = limit.map(|limit| {
        let is_seen = p_value < significance;
        let side = if is_seen { per_year } else { now };
        let size = limit.size.abs();
        let limit = if limit.is_one_sided {
            size
        } else {
            size.copysign(side)
        };
        let left = limit - now;
        let is_ahead = is_seen && left * per_year > 0.0 && now.abs() < size;
        let [earliest, latest] = fieller(fit, left, quantile).unwrap_or([0.0, f64::INFINITY]);
        TiltReach {
            limit,
            years: is_ahead.then(|| left / per_year),
            years_earliest: is_ahead.then_some(earliest.max(0.0)),
            years_latest: is_ahead.then_some(latest),
        }
    });
    Ok(TiltSlope {
        per_year,
        sd_per_year: sd,
        p_value,
        seen_from_per_year: sd * student_detectable(significance, 0.8, degrees)?,
        now,
        reach,
    })
}

/// A wave of one year: its two columns.
pub(super) fn season(days: &[f64]) -> [Vec<f64>; 2] {
    [0.0, -0.25 * TAU].map(|shift| {
        let wave = |day: &f64| (TAU * day / YEAR_DAYS + shift).cos();
        days.iter().map(wave).collect()
    })
}

/// When a line with the fitted tilt now and slope has gone so far: the ends of the interval that holds the truth with the probability of the quantile.
///
/// ```text
/// (d − b T)² ≤ q² Var(a + b T),   Var = v_aa + 2 T v_ab + T² v_bb
/// ```
/// `None` where the slope may be none, so that the interval has no end.
///
/// # Source
/// Fieller (1954) J. R. Stat. Soc. B 16(2):175-185.
fn fieller(fit: &Fit, left: f64, quantile: f64) -> Option<[f64; 2]> {
    let k = fit.coefficients.len();
    let variance = |a: f64, b: f64| {
        let mut h = vec![0.0; k];
        (h[0], h[1]) = (a, b);
        quantile * quantile * fit.form(&mut h)
    };
    let (of_now, of_slope) = (variance(1.0, 0.0), variance(0.0, 1.0));
    let both = 0.5 * (variance(1.0, 1.0) - of_now - of_slope);
    let slope = fit.coefficients[1];
    let [c, half_b, a] = [
        left * left - of_now,
        left * slope + both,
        slope * slope - of_slope,
    ];
    let root = (half_b * half_b - a * c).max(0.0).sqrt();
    (a > 0.0).then(|| [(half_b - root) / a, (half_b + root) / a])
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
    fn holds_the_interval_of_years_holds_the_truth_as_often_as_it_says() {
        // 40 half years that end short of the limit by what the slope does in 2, 5 and 20 years
        for years_left in [2.0, 5.0, 20.0] {
            let mut held = 0;
            let drawn = 400;
            for seed in 0..drawn {
                let mut random = Random::new(21, seed);
                let days: Vec<f64> = (0..40).map(|i| 182.625 * f64::from(i)).collect();
                let per_year = -2e-4; // towards the negative limit, from a tilt that is positive at first
                let end = -5e-3 - per_year * years_left;
                let last = days[39];
                let series = TiltSeries {
                    direction: "x".into(),
                    datum: None,
                    surveys: (0..40).collect(),
                    ratios: days
                        .iter()
                        .map(|day| end + per_year * (day - last) / YEAR_DAYS + 1.5e-4 * random.normal())
                        .collect(),
                    days,
                };
                let found = tilt_trend(series, &[], 0.05, Some(5e-3)).unwrap().slope.unwrap();
                let reach = found.reach.unwrap();
                assert_eq!(reach.limit, -5e-3);
                // no forecast, where noise looked like a jump, holds nothing
                let of = reach.years_earliest.zip(reach.years_latest);
                held += usize::from(of.is_some_and(|(from, to)| from <= years_left && years_left <= to));
            }
            let share = held as f64 / drawn as f64;
            assert!((0.90..=0.99).contains(&share), "{years_left} years: {share}");
        }
    }

    #[test]
    fn exact_a_negative_tilt_is_held_against_its_own_limit() {
        let mirrored = |sign: f64| {
            let series = made(1e-4, 5e-5);
            let ratios = series.ratios.iter().map(|ratio| sign * ratio).collect();
            let found = tilt_trend(TiltSeries { ratios, ..series }, &[], 0.05, Some(1.0 / 150.0));
            found.unwrap().slope.unwrap()
        };
        let [right, left] = [1.0, -1.0].map(mirrored);
        assert!((right.share_of_limit().unwrap() - left.share_of_limit().unwrap()).abs() < 1e-9);
        assert!(left.share_of_limit().unwrap() < 1.0);
        let years = |of: TiltSlope| of.reach.unwrap().years.unwrap();
        assert!((years(right) - years(left)).abs() < 1e-6);
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

    /// Monthly readings of 4 years: a season, noise of 5e-5, and a step of `size` from reading `from` on.
    fn monthly(seed: u64, from: usize, size: f64) -> TiltSeries {
        let mut random = Random::new(seed, 1);
        let days: Vec<f64> = (0..48).map(|i| 30.4 * f64::from(i)).collect();
        let wave = |day: f64| 1e-4 * (TAU * day / YEAR_DAYS).cos();
        let ratios = days.iter().enumerate().map(|(i, day)| {
            let step = if i >= from { size } else { 0.0 };
            3e-3 + wave(*day) + step + 5e-5 * random.normal()
        });
        TiltSeries {
            direction: "x".into(),
            datum: None,
            surveys: (0..48).collect(),
            ratios: ratios.collect(),
            days,
        }
    }

    #[test]
    fn holds_a_jump_is_found_where_it_is_and_the_level_after_it_is_the_tilt_now() {
        for from in [20, 45, 47] {
            let found = tilt_trend(monthly(1, from, 8e-4), &[], 0.05, Some(5e-3)).unwrap();
            let jump = found.jump.unwrap();
            assert_eq!(jump.from, from);
            assert!((jump.size - 8e-4).abs() < 3.0 * jump.sd, "{jump:?}");
            let slope = found.slope.unwrap();
            assert!((slope.now - 3.8e-3).abs() < 1.5e-4, "{from} {}", slope.now);
            assert!(!found.is_beyond_chance(), "{from}");
        }
    }

    #[test]
    fn holds_jumps_of_noise_are_as_rare_as_stated() {
        const RUNS: u64 = 200;
        let found = |seed: &u64| {
            tilt_trend(monthly(100 + seed, 48, 0.0), &[], 0.05, None)
                .unwrap()
                .jump
                .is_some()
        };
        let jumps = (0..RUNS).filter(found).count();
        assert!(jumps <= 18, "{jumps} of {RUNS}"); // 5 %: at most 18 with 99 %; 10 were
    }
}
