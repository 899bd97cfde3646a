//! Slope of the readings of a logger over the years: a tilt, the width of a crack.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | y | `values` | the reading of a day | as given |
//! | T | `temperatures_c` | the temperature of that day | °C |
//! | t | `days` | | day |

use super::MonitoringError;
use super::bends::{BentFit, DatedBreak, bent_fit, refined};
use super::daily::DailyReadings;
use super::logged_blocks::{Blocks, usual_gap};
use super::logged_curve::{LoggedCurve, curve_column, curve_of, curve_value};
use super::logged_faults::{LoggedJump, jump, spikes, stuck};
use super::logged_last::{LoggedLast, newest_off};
use super::logged_law::Law;
use super::logged_scale::{LoggedScale, Turning, scattered, stepped};
use super::logged_season::{LoggedSeason, SeasonForm};
use super::logged_shape::{SHAPE_DAYS, SPARE_LEAST, Shape, Shaped, shape};
use super::logged_steps::LoggedBreak;
use super::scan::ChangeForm;
use super::tilt::{SEASON_YEARS_LEAST, SlopeLimit, TiltSlope, slope_of};
use super::wave::amplitude;
use super::weather::YEAR_DAYS;
use crate::numeric::{middle_mean, student_two_sided};

/// Numbers of days whose medians are used in the search for a slope. Each number is tried, and the least significant result counts. Our choice: a
/// disturbance with a longer memory than neighbouring days show becomes visible in medians of weeks and months.
const BLOCKS_DAYS: [f64; 3] = [1.0, 7.0, SHAPE_DAYS];
/// Least fraction of the days with a temperature for its use. Our choice.
const TEMPERATURES_LEAST: f64 = 0.6;
/// Correlation of two neighbouring monthly medians from which they drift randomly, so that no slope is significant. Our choice.
const WANDERS_FROM: f64 = 0.9;
/// Number of columns of a wave of the whole year.
const WAVE_COLUMNS: usize = 2;
/// Number of days whose median is the current reading, if there is no slope.
const NOW_DAYS: f64 = 7.0;

/// Readings of a logger.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct LoggedSeries {
    /// One value per day.
    pub daily: DailyReadings,
    /// The temperature of each day, °C; NaN if unknown. Empty without a temperature log.
    pub temperatures_c: Vec<f64>,
}

/// Options of [`logged_trend`].
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedOptions {
    /// Probability of finding a slope although there is none; default 0.05.
    pub significance: f64,
    /// Limit of the reading.
    pub limit: Option<SlopeLimit>,
    /// The first and last day of each work or event, counted like the readings. It may have shifted the readings; those of these days, of the day
    /// before and of the day after are left out. NaN for a work without this effect.
    pub works: Vec<[f64; 2]>,
    /// The value if the sensor reads 0, in the unit of the readings; default 0.
    pub zero: f64,
}

impl Default for LoggedOptions {
    fn default() -> Self {
        LoggedOptions {
            significance: 0.05,
            limit: None,
            works: Vec::new(),
            zero: 0.0,
        }
    }
}

/// Why there is no slope.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoSlope {
    /// In less than two years, a slope cannot be separated from the season.
    TooShort {
        /// Years from the first to the last day.
        years: f64,
    },
    /// Too few days.
    TooFew {
        /// Number of these days.
        days: usize,
    },
    /// Monthly medians drift randomly, so that chance can produce any slope.
    Wanders,
    /// Some days are on another scale than the others.
    OtherScale(LoggedScale),
}

/// Shift of the readings at a work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedLevel {
    /// Index of the work.
    pub work: usize,
    /// The shift.
    pub shift: f64,
    /// Its standard deviation.
    pub sd: f64,
    /// Probability of such a shift by chance.
    pub p_value: f64,
}

/// A step or a change of slope of the monthly medians without a work.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedChange {
    /// Step or slope.
    pub form: ChangeForm,
    /// First day of the change.
    pub day: f64,
    /// Its date is between `after` and `before` with 95 % probability.
    pub after: f64,
    /// End of this interval.
    pub before: f64,
    /// Its size; for a change of slope, 1/year.
    pub size: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// Result of the analysis of a log.
#[derive(Clone, Debug, PartialEq)]
pub struct LoggedTrend {
    /// The readings that are used.
    pub daily: DailyReadings,
    /// Days left out because they are far from the median of the surrounding fortnight: spikes.
    pub spikes: Vec<f64>,
    /// The largest significant jump without a work, if there is one. It may cause an apparent slope.
    pub jump: Option<LoggedJump>,
    /// Where the readings seem to be on another scale. There is no slope then.
    pub scale: Option<LoggedScale>,
    /// The newest days, if they differ from the earlier behaviour of the log. The structure moved, or the sensor failed.
    pub last_off: Option<LoggedLast>,
    /// The day from which the sensor shows a constant value; it and all later days are left out.
    pub stuck_since: Option<f64>,
    /// Number of days left out because their temperature is unknown.
    pub without_temperature: usize,
    /// Number of days left out because of a work on them or on an adjacent day.
    pub of_works: usize,
    /// The slope, or the reason why there is none.
    pub slope: Result<TiltSlope, NoSlope>,
    /// Number of days of each median for the slope.
    pub block_days: f64,
    /// Amplitude of the yearly wave; `None` if the days do not determine it.
    pub season: Option<f64>,
    /// The yearly wave of season and temperature together, if it is beyond chance and the days cover the year; a forecast counts it.
    pub yearly: Option<LoggedSeason>,
    /// Change per °C and its standard deviation, if temperatures are known.
    pub per_c: Option<(f64, f64)>,
    /// Shifts at works.
    pub levels: Vec<LoggedLevel>,
    /// Significant steps and changes of slope, by time. The slope is that after the last change, without steps.
    pub changes: Vec<LoggedChange>,
    /// The steady change of the rate, if it is significant. The slope is then the rate on the last day.
    pub curve: Option<LoggedCurve>,
    /// For each day, the reading without season and temperature; empty without a slope.
    pub line: Vec<f64>,
    /// The reading on the last day: from a significant slope, otherwise the median of the last seven days; `newest` if the newest days differ.
    pub now: f64,
    /// The median of the readings of the last day, independent of earlier days: the newest reading is never treated as a spike.
    pub newest: f64,
    /// Days on which the limit was reached, without spikes.
    pub at_limit: Vec<f64>,
    /// Probability by chance below which a slope is significant.
    pub significance: f64,
    /// Limit of the reading.
    pub limit: Option<SlopeLimit>,
}

impl LoggedTrend {
    /// Whether the slope is significant.
    pub fn is_beyond_chance(&self) -> bool {
        self.slope.is_ok_and(|slope| slope.p_value < self.significance)
    }

    /// Value that is compared with the limit: the reading of the last day, or the fitted value on that day if it is larger.
    pub fn size_to_judge(&self) -> f64 {
        let is_larger = match self.limit {
            Some(limit) if limit.is_one_sided => self.newest > self.now,
            _ => self.newest.abs() > self.now.abs(),
        };
        match is_larger {
            true => self.newest,
            false => self.now,
        }
    }

    /// Whether the readings have reached their limit.
    pub fn is_beyond_limit(&self) -> bool {
        self.limit
            .is_some_and(|limit| limit.is_reached(self.size_to_judge()))
    }
}

/// The slope of daily readings together with a yearly wave, the effect of temperature, and shifts at works.
///
/// ```text
/// y = y₀ + b t + c cos ωt + d sin ωt + β (T − T̄) + Σ shifts + e,   Cov e = s² φ^|Δt|
/// ```
/// It is estimated from medians of a day, a week and 30 days; the estimate with the largest standard deviation is used.
///
/// # Errors
/// [`MonitoringError::Numeric`].
///
/// # Limits
/// A shift without a work, or a drifting sensor, looks like a slope; a shift within days is a jump.
pub fn logged_trend(series: &LoggedSeries, options: &LoggedOptions) -> Result<LoggedTrend, MonitoringError> {
    let (mut trend, temperatures_c) = sound(series, options);
    trend.scale = scattered(&series.daily);
    if let Some(scale) = trend.scale {
        trend.slope = Err(NoSlope::OtherScale(scale));
        return Ok(trend);
    }
    let days = &trend.daily.days;
    let years = match (days.first(), days.last()) {
        (Some(first), Some(last)) => (last - first) / YEAR_DAYS,
        _ => 0.0,
    };
    if years < SEASON_YEARS_LEAST {
        trend.slope = Err(NoSlope::TooShort { years });
        return Ok(trend);
    }
    let usual = usual_gap(days);
    let shape = shape(&Shaped {
        daily: &trend.daily,
        temperatures_c: &temperatures_c,
        jump: trend.jump,
        works: &options.works,
        significance: options.significance,
    });
    let mut worst: Option<(f64, SlopeFit)> = None;
    let mut wanders = false;
    for block_days in BLOCKS_DAYS
        .into_iter()
        .filter(|block| *block == 1.0 || *block > usual)
    {
        let blocks = Blocks::of(&trend.daily, &temperatures_c, block_days, &shape.steps());
        let Some((fit, correlation)) = fitted_slope(&blocks, days, options, &shape)? else {
            continue;
        };
        wanders = correlation >= WANDERS_FROM;
        let sd = fit.slope.seen_from_per_year;
        if worst.as_ref().is_none_or(|(most, _)| sd > *most) {
            worst = Some((sd, SlopeFit { block_days, ..fit }));
        }
    }
    let Some((_, worst)) = worst else {
        return Ok(trend);
    };
    let scaled = |of: &LoggedChange| match of.form {
        ChangeForm::Step => stepped(&trend.daily, options.zero, of.day, of.sd),
        ChangeForm::Slope => None,
    };
    let scale = worst.changes.iter().find_map(scaled);
    let turning = Turning {
        daily: &trend.daily,
        temperatures_c: &temperatures_c,
        works: &options.works,
        breaks: shape.breaks.iter().map(|of| of.dated).collect(),
    };
    trend.scale = scale.or_else(|| turning.turned());
    if let Some(scale) = trend.scale {
        trend.slope = Err(NoSlope::OtherScale(scale));
        return Ok(trend);
    }
    if wanders {
        trend.slope = Err(NoSlope::Wanders);
        return Ok(trend);
    }
    trend.slope = Ok(worst.slope);
    if trend.is_beyond_chance() && trend.last_off.is_none() {
        trend.now = worst.slope.now;
    }
    trend.block_days = worst.block_days;
    trend.season = worst.season;
    trend.yearly = worst.yearly;
    trend.per_c = worst.per_c;
    trend.levels = worst.levels;
    trend.changes = worst.changes;
    trend.curve = worst.curve;
    trend.line = worst.line;
    Ok(trend)
}

/// The readings without sensor faults, the results that do not need a slope, and the temperatures of the remaining days.
fn sound(series: &LoggedSeries, options: &LoggedOptions) -> (LoggedTrend, Vec<f64>) {
    let all = &series.daily;
    let stuck_from = stuck(&all.values);
    let until = stuck_from.unwrap_or(all.values.len());
    let values = &all.values[..until];
    let wild = spikes(values);
    let is_wild = |i: &usize| wild.contains(i);
    let known = series
        .temperatures_c
        .iter()
        .take(until)
        .filter(|t| t.is_finite())
        .count();
    let has_temperature = known as f64 >= TEMPERATURES_LEAST * until as f64 && known > 0;
    let is_cold = |i: &usize| has_temperature && !series.temperatures_c[*i].is_finite();
    let is_of_work = |i: &usize| {
        let day = all.days[*i];
        let mut works = options.works.iter();
        works.any(|[from, to]| day >= from - 1.0 && day <= to + 1.0)
    };
    let kept: Vec<usize> = (0..until)
        .filter(|i| !is_wild(i) && !is_cold(i) && !is_of_work(i))
        .collect();
    let of = |from: &[f64]| -> Vec<f64> { kept.iter().map(|i| from[*i]).collect() };
    let daily = DailyReadings {
        days: of(&all.days),
        values: of(&all.values),
        ..*all
    };
    let temperatures_c = match has_temperature {
        true => of(&series.temperatures_c),
        false => Vec::new(),
    };
    let read = || all.days[..until].iter().zip(values);
    let last = all.days[..until].last().copied().unwrap_or(f64::NAN);
    let newest = read().filter(|(day, _)| **day > last - NOW_DAYS);
    let calm = (0..until).filter(|i| !is_wild(i));
    let at_limit = calm.filter(|i| options.limit.is_some_and(|limit| limit.is_reached(values[*i])));
    let jump = jump(&daily, &options.works);
    let last_off = newest_off(
        (&series.daily, &series.temperatures_c),
        until,
        (&wild, &options.works),
        jump.as_ref(),
    );
    let trend = LoggedTrend {
        now: match last_off {
            Some(_) => values.last().copied().unwrap_or(f64::NAN),
            None => middle_mean(newest.map(|(_, value)| *value).collect()),
        },
        last_off,
        scale: None,
        newest: values.last().copied().unwrap_or(f64::NAN),
        at_limit: at_limit.map(|i| all.days[i]).collect(),
        slope: Err(NoSlope::TooFew {
            days: daily.days.len(),
        }),
        spikes: wild.iter().map(|i| all.days[*i]).collect(),
        jump,
        stuck_since: stuck_from.map(|from| all.days[from]),
        of_works: (0..until).filter(is_of_work).count(),
        without_temperature: (0..until).filter(is_cold).count(),
        daily,
        block_days: 1.0,
        season: None,
        yearly: None,
        per_c: None,
        levels: Vec::new(),
        changes: Vec::new(),
        curve: None,
        line: Vec::new(),
        significance: options.significance,
        limit: options.limit,
    };
    (trend, temperatures_c)
}

/// Slope from medians over blocks of one length.
struct SlopeFit {
    slope: TiltSlope,
    block_days: f64,
    season: Option<f64>,
    yearly: Option<LoggedSeason>,
    per_c: Option<(f64, f64)>,
    levels: Vec<LoggedLevel>,
    changes: Vec<LoggedChange>,
    curve: Option<LoggedCurve>,
    line: Vec<f64>,
}

/// The slope of medians, and the correlation of neighbouring medians; `None` with too few medians.
fn fitted_slope(
    blocks: &Blocks,
    days: &[f64],
    options: &LoggedOptions,
    shape: &Shape,
) -> Result<Option<(SlopeFit, f64)>, MonitoringError> {
    let n = blocks.days.len();
    let last = days[days.len() - 1];
    let (mut columns, works) = blocks.columns(last, &options.works);
    let has_temperature = !blocks.temperatures_c.is_empty();
    let first_level = columns.len() - works.len();
    let curve_at = columns.len();
    if shape.is_curved {
        columns.push(curve_column(&blocks.days, last));
    }
    let first_break = columns.len();
    let wave = 2..first_level - usize::from(has_temperature);
    let breaks: Vec<&LoggedBreak> = shape
        .breaks
        .iter()
        .filter(|of| {
            let column = of.dated.column(&blocks.days);
            column.first() != Some(&0.0) && column.last() == Some(&0.0) && !columns.contains(&column)
        })
        .collect();
    let within: Vec<(DatedBreak, [f64; 2])> = breaks
        .iter()
        .map(|of| (of.dated, [of.after - BLOCKS_DAYS[2], of.before + BLOCKS_DAYS[2]]))
        .collect();
    let dated = refined(&blocks.series(), &columns, &blocks.days, &within);
    columns.extend(dated.iter().map(|of| of.column(&blocks.days)));
    if n < columns.len() + SPARE_LEAST {
        return Ok(None);
    }
    let Some(found) = bent_fit(&blocks.series(), &columns, &blocks.days, &dated) else {
        return Ok(None);
    };
    let (fit, degrees) = (&found.fit, found.degrees);
    let levels = levels(&found, first_level, &works)?;
    let mut slope = slope_of(fit, degrees, options.significance, options.limit)?;
    // readings of a part of the year determine no whole wave
    let season = match wave.len() == WAVE_COLUMNS {
        true => SeasonForm::of(fit, &columns, wave.start..first_level, &blocks.days, last),
        false => None,
    };
    if let (Some(season), Some(reach)) = (&season, slope.reach.as_mut()) {
        let law = Law {
            fit,
            curve_at: None,
            season: Some(season),
            to: reach.limit,
            toward: slope.per_year.signum(),
        };
        law.set_years(degrees, reach)?;
    }
    let over = (last - days[0]) / YEAR_DAYS;
    let curve = shape
        .is_curved
        .then(|| curve_of(&found, (curve_at, over), season.as_ref(), &mut slope))
        .transpose()?;
    let line = days.iter().map(|day| {
        let shifts = levels
            .iter()
            .filter(|of| *day < options.works[of.work][0])
            .map(|of| of.shift);
        let broken = dated.iter().enumerate();
        let broken = broken.map(|(i, of)| fit.coefficients[first_break + i] * of.value(*day));
        let bent = curve.map_or(0.0, |of| of.per_year2 * curve_value(*day, last));
        let straight = slope.now + slope.per_year * (day - last) / YEAR_DAYS;
        straight + bent - shifts.sum::<f64>() + broken.sum::<f64>()
    });
    let changes = breaks
        .iter()
        .zip(&dated)
        .enumerate()
        .map(|(i, (of, dated))| LoggedChange {
            form: dated.form,
            day: dated.day,
            after: of.after.min(dated.day),
            before: of.before.max(dated.day),
            // the columns are 1 before the change
            size: -fit.coefficients[first_break + i],
            sd: fit.sd[first_break + i],
        });
    let slope_fit = SlopeFit {
        curve,
        line: line.collect(),
        block_days: 1.0,
        yearly: season.map(|of| of.season),
        season: amplitude(&fit.coefficients[wave]),
        per_c: has_temperature.then(|| (fit.coefficients[first_level - 1], fit.sd[first_level - 1])),
        changes: changes.collect(),
        slope,
        levels,
    };
    Ok(Some((slope_fit, found.disturbance.correlation)))
}

/// Shifts at works, whose columns are 1 before each and begin at `first`.
fn levels(found: &BentFit, first: usize, works: &[usize]) -> Result<Vec<LoggedLevel>, MonitoringError> {
    let level = |(i, work): (usize, &usize)| {
        let (shift, sd) = (-found.fit.coefficients[first + i], found.fit.sd[first + i]);
        let p_value = match sd > 0.0 {
            true => student_two_sided(shift / sd, found.degrees)?,
            false => 1.0,
        };
        Ok(LoggedLevel {
            work: *work,
            shift,
            sd,
            p_value,
        })
    };
    works.iter().enumerate().map(level).collect()
}

#[cfg(test)]
mod tests {
    use super::super::logged_scale::ScaleMark;
    use super::*;
    use crate::numeric::Random;
    use std::f64::consts::TAU;

    /// Options of a simulated log: number of days, slope per year, correlated noise, white noise and an annual wave.
    struct SyntheticLog {
        years: f64,
        per_year: f64,
        correlation: f64,
        disturbance: f64,
        noise: f64,
        per_c: f64,
    }

    const USUAL: SyntheticLog = SyntheticLog {
        years: 4.0,
        per_year: 0.0,
        correlation: 0.7,
        disturbance: 1.0,
        noise: 0.0,
        per_c: 0.0,
    };

    impl SyntheticLog {
        fn series(&self, seed: u64) -> LoggedSeries {
            let mut random = Random::new(77, seed);
            let count = (self.years * YEAR_DAYS) as usize;
            let mut made = LoggedSeries::default();
            let (mut x, mut air) = (self.disturbance * random.normal(), 0.0);
            for day in 0..count {
                let day = 18_000.0 + day as f64;
                x = self.correlation * x
                    + self.disturbance * (1.0 - self.correlation.powi(2)).sqrt() * random.normal();
                air = 0.8 * air + 2.0 * random.normal();
                let wave = (TAU * (day - 30.0) / YEAR_DAYS).cos();
                let celsius = 12.0 - 12.0 * wave + air;
                let value = 5.0
                    + self.per_year * (day - 18_000.0) / YEAR_DAYS
                    + 6.0 * (TAU * day / YEAR_DAYS + 1.0).sin()
                    + self.per_c * celsius
                    + x
                    + self.noise * random.normal();
                made.daily.days.push(day);
                made.daily.values.push(value);
                if self.per_c != 0.0 {
                    made.temperatures_c.push(celsius);
                }
            }
            made.daily.readings = count;
            made
        }

        /// Fractions of simulated histories with the true slope inside the interval, and with a slope that is called significant.
        fn shares(&self, histories: u64) -> [f64; 2] {
            let (mut held, mut called, mut changed) = (0, 0, 0);
            for seed in 0..histories {
                let trend = logged_trend(&self.series(seed), &LoggedOptions::default()).unwrap();
                let slope = trend.slope.unwrap();
                // half width at 95 %: a slope of this size would be exactly at the 5 % limit of chance
                let degrees = self.years * YEAR_DAYS / trend.block_days - 4.0;
                let half =
                    slope.sd_per_year * crate::numeric::student_two_sided_quantile(0.05, degrees).unwrap();
                held += usize::from((slope.per_year - self.per_year).abs() <= half);
                called += usize::from(trend.is_beyond_chance());
                changed += usize::from(!trend.changes.is_empty());
                assert!(
                    trend.jump.is_none() && trend.spikes.is_empty(),
                    "{seed}: {:?}",
                    trend.jump
                );
            }
            assert!(changed <= 18, "{changed} of {histories} changed"); // 5 %: at most 18 of 200 with 99 %
            [held, called].map(|count| count as f64 / histories as f64)
        }
    }

    /// Years after the last day of four years until a trend with the season of a simulated log first reaches a limit, by trying each.
    fn first_year(limit: f64, trend: impl Fn(f64) -> f64) -> f64 {
        let wave = |years: f64| 6.0 * (TAU * (18_000.0 / YEAR_DAYS + 4.0 + years) + 1.0).sin();
        let all = (0..100_000).map(|i| f64::from(i) / 10_000.0);
        all.into_iter()
            .find(|years| trend(*years) + wave(*years) >= limit)
            .unwrap()
    }

    #[test]
    fn holds_intervals_and_false_trends_of_daily_readings_that_go_together() {
        let [held, called] = USUAL.shares(200);
        assert!(held >= 0.90 && called <= 0.07, "{held} {called}");
        let sloping = SyntheticLog {
            per_year: 0.5,
            ..USUAL
        };
        let [held, called] = sloping.shares(200);
        assert!(held >= 0.90 && called >= 0.95, "{held} {called}");
        // slow disturbance under white noise: months show it better than neighbouring days
        let slow = SyntheticLog {
            correlation: 0.95,
            noise: 1.5,
            ..USUAL
        };
        let [held, called] = slow.shares(200);
        assert!(held >= 0.90 && called <= 0.07, "{held} {called}");
    }

    #[test]
    fn holds_temperature_is_taken_out() {
        let made = SyntheticLog {
            per_c: 0.4,
            per_year: 0.3,
            ..USUAL
        };
        let mut series = made.series(5);
        let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
        let (per_c, sd) = trend.per_c.unwrap();
        assert!((per_c - 0.4).abs() < 3.0 * sd && sd < 0.06, "{per_c} {sd}");
        let slope = trend.slope.unwrap();
        assert!((slope.per_year - 0.3).abs() < 3.0 * slope.sd_per_year);
        // one month without temperatures
        series.temperatures_c[100..130].fill(f64::NAN);
        let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
        assert_eq!((trend.without_temperature, trend.per_c.is_some()), (30, true));
        // most of the time without temperatures
        series.temperatures_c[100..900].fill(f64::NAN);
        let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
        assert_eq!((trend.without_temperature, trend.per_c.is_none()), (0, true));
    }

    #[test]
    fn holds_a_limit_is_reached_when_the_slope_takes_it_there() {
        let made = SyntheticLog {
            per_year: 1.0,
            ..USUAL
        };
        let series = made.series(9);
        let to = |size: f64| LoggedOptions {
            limit: Some(SlopeLimit {
                size,
                is_one_sided: true,
            }),
            ..LoggedOptions::default()
        };
        // the peaks of the season that follow are 14.8, 15.8, 16.8 and 17.8
        let truth = first_year(17.3, |years| 9.0 + years);
        let held = (0..40).filter(|seed| {
            let trend = logged_trend(&made.series(*seed), &to(17.3)).unwrap();
            let reach = trend.slope.unwrap().reach.unwrap();
            let [earliest, latest] = [reach.years_earliest, reach.years_latest].map(Option::unwrap);
            assert!(latest < 5.0, "{reach:?}");
            earliest <= truth && truth <= latest
        });
        // 95 % of 40 are 38; fewer than 35 have a probability of 1 %
        let held = held.count();
        assert!(held >= 35 && (2.0..3.0).contains(&truth), "{held} {truth}");
        // the reading of the last day, with season and disturbance, has reached a lower limit
        let options = to(12.0);
        let trend = logged_trend(&series, &options).unwrap();
        assert!(trend.now < 12.0 && trend.newest >= 12.0 && trend.is_beyond_limit());
        // a closing crack never reaches the limit
        let mut closing = series;
        closing.daily.values.iter_mut().for_each(|value| *value = -*value);
        let reach = logged_trend(&closing, &options)
            .unwrap()
            .slope
            .unwrap()
            .reach
            .unwrap();
        assert_eq!((reach.limit, reach.years), (12.0, None));
    }

    #[test]
    fn holds_a_shift_at_a_work_is_no_slope() {
        let mut series = USUAL.series(3);
        let at = series.daily.days[700];
        series.daily.values[700..]
            .iter_mut()
            .for_each(|value| *value += 8.0);
        let with = LoggedOptions {
            works: vec![[at, at]],
            ..LoggedOptions::default()
        };
        let blind = logged_trend(&series, &LoggedOptions::default()).unwrap();
        assert!(!blind.is_beyond_chance()); // the jump is not part of the slope
        let jump = blind.jump.unwrap();
        assert!(
            (jump.before - at).abs() <= 2.0 && (jump.by - 8.0).abs() < 2.0,
            "{jump:?}"
        );
        let trend = logged_trend(&series, &with).unwrap();
        assert!(!trend.is_beyond_chance() && trend.jump.is_none());
        let level = trend.levels[0];
        assert!(
            (level.shift - 8.0).abs() < 3.0 * level.sd && level.p_value < 1e-3,
            "{level:?}"
        );
        assert_eq!(trend.of_works, 3);
        let rise = trend.line[699] - trend.line[698];
        assert!((rise - level.shift).abs() < 0.01, "{rise}");
    }

    #[test]
    fn holds_spikes_and_a_stuck_sensor_are_left_out() {
        let mut series = USUAL.series(4);
        series.daily.values[50] = 900.0;
        series.daily.values[51] = 901.0;
        series.daily.values[1300] = -900.0;
        let stuck = series.daily.values[1380];
        series.daily.values[1381..].fill(stuck);
        let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
        assert_eq!(trend.spikes, [50, 51, 1300].map(|i| series.daily.days[i]));
        assert_eq!(trend.stuck_since, Some(series.daily.days[1381]));
        assert_eq!(trend.daily.days.len(), 1378);
        // a sensor with coarse steps shows equal values for long, but is not stuck
        let coarse = LoggedSeries {
            daily: DailyReadings {
                values: series.daily.days.iter().map(|day| (day / 90.0).floor()).collect(),
                ..series.daily.clone()
            },
            ..LoggedSeries::default()
        };
        let trend = logged_trend(&coarse, &LoggedOptions::default()).unwrap();
        assert_eq!((trend.stuck_since, trend.spikes.len()), (None, 0));
    }

    #[test]
    fn refuses_a_slope_where_none_can_be_told() {
        let short = SyntheticLog { years: 1.5, ..USUAL };
        let trend = logged_trend(&short.series(1), &LoggedOptions::default()).unwrap();
        assert!(matches!(trend.slope, Err(NoSlope::TooShort { years }) if (years - 1.5).abs() < 0.01));
        assert!(trend.now.is_finite());
        // a random walk: each day adds to the day before
        let mut walk = USUAL.series(1);
        let mut random = Random::new(5, 5);
        let mut at = 0.0;
        for value in &mut walk.daily.values {
            at += random.normal();
            *value = at;
        }
        let trend = logged_trend(&walk, &LoggedOptions::default()).unwrap();
        assert_eq!(trend.slope, Err(NoSlope::Wanders));
        let none = logged_trend(&LoggedSeries::default(), &LoggedOptions::default()).unwrap();
        assert!(none.slope.is_err());
    }

    #[test]
    fn holds_a_rise_that_begins_in_mid_record_is_a_trend_of_its_recent_slope() {
        let still = SyntheticLog {
            disturbance: 0.3,
            ..USUAL
        };
        for seed in 0..20 {
            let mut series = still.series(seed);
            let begins = 18_000.0 + 2.0 * YEAR_DAYS;
            for (day, value) in series.daily.days.iter().zip(&mut series.daily.values) {
                *value += 4.0 * ((day - begins) / YEAR_DAYS).max(0.0);
            }
            let options = LoggedOptions {
                limit: Some(SlopeLimit {
                    size: 5.0 + 8.0 + 8.0, // two years after the last of four
                    is_one_sided: false,
                }),
                ..LoggedOptions::default()
            };
            let trend = logged_trend(&series, &options).unwrap();
            let slope = trend.slope.unwrap();
            assert!(
                trend.is_beyond_chance() && (slope.per_year - 4.0).abs() < 4.0 * slope.sd_per_year,
                "{seed} {slope:?}"
            );
            let bend = trend.changes[0];
            assert!(
                bend.form == ChangeForm::Slope && (bend.day - begins).abs() < 120.0,
                "{seed} {bend:?}"
            );
            // the mean of the year two years after the last day, its peak earlier
            let (years, truth) = (
                slope.reach.unwrap().years.unwrap(),
                first_year(21.0, |years| 13.0 + 4.0 * years),
            );
            assert!(
                (years - truth).abs() < 0.1 && truth < 1.0,
                "{seed} {years} {truth}"
            );
            let (first, last) = (trend.line[0], trend.line[trend.line.len() - 1]);
            assert!((last - first - 8.0).abs() < 0.6, "{seed} {first} {last}");
        }
    }

    #[test]
    fn regress_changes_of_slope_make_no_more_trends_of_walks() {
        let mut called = 0;
        for seed in 0..100 {
            let mut walk = USUAL.series(1);
            let mut random = Random::new(6, seed);
            let mut at = 0.0;
            for value in &mut walk.daily.values {
                at += random.normal();
                *value = at;
            }
            let trend = logged_trend(&walk, &LoggedOptions::default()).unwrap();
            called += usize::from(trend.is_beyond_chance());
        }
        assert!(called <= 17, "{called} of 100 walks"); // 17 without changes of slope
    }

    /// Three years of days at 3.3 with a wave, temperature and a disturbance of 0.15, correlation 0.7; `law` is added, of the time in years.
    fn lawful(seed: u64, law: impl Fn(f64) -> f64) -> LoggedSeries {
        let mut random = Random::new(123, seed);
        let mut made = LoggedSeries::default();
        let (mut x, mut air) = (random.normal(), 0.0);
        for day in 0..1095 {
            let day = 18_000.0 + f64::from(day);
            x = 0.7 * x + 0.51_f64.sqrt() * random.normal();
            air = 0.8 * air + 1.8 * random.normal();
            let warm = air - 12.0 * (TAU * (day - 30.0) / YEAR_DAYS).cos();
            let wave = 0.3 * (TAU * day / YEAR_DAYS + 1.0).sin();
            made.daily.days.push(day);
            made.daily
                .values
                .push(3.3 + law((day - 18_000.0) / YEAR_DAYS) + wave + 0.02 * warm + 0.15 * x);
            made.temperatures_c.push(12.0 + warm);
        }
        made
    }

    /// Whether the 95 % interval of the slope holds the truth.
    fn holds_slope(trend: &LoggedTrend, per_year: f64) -> bool {
        let half = |sd: f64| sd * crate::numeric::student_two_sided_quantile(0.05, 30.0).unwrap();
        trend
            .slope
            .is_ok_and(|slope| (slope.per_year - per_year).abs() <= half(slope.sd_per_year))
    }

    #[test]
    fn holds_a_rate_that_grows_is_seen_with_its_rate_now_and_its_limit() {
        let last = 1094.0 / YEAR_DAYS;
        let options = LoggedOptions {
            limit: Some(SlopeLimit {
                size: 3.3 + 0.5 * (last + 2.0).powi(2), // two years ahead by the law
                is_one_sided: false,
            }),
            ..LoggedOptions::default()
        };
        let (mut rates, mut limits) = (0, 0);
        for seed in 0..6 {
            let trend = logged_trend(&lawful(seed, |t| 0.5 * t * t), &options).unwrap();
            let (curve, slope) = (trend.curve.unwrap(), trend.slope.unwrap());
            assert!(
                curve.speeds_up(slope.per_year) && trend.is_beyond_chance(),
                "{seed} {curve:?}"
            );
            assert!(
                (curve.per_year2 - 1.0).abs() < 4.0 * curve.sd_per_year2,
                "{seed} {curve:?}"
            );
            rates += usize::from(holds_slope(&trend, last));
            let (law, rate) = (slope.reach.unwrap(), curve.at_rate.unwrap());
            assert!(
                law.years.unwrap() < rate.years.unwrap(),
                "{seed} {law:?} {rate:?}"
            );
            let [from, to] = [law.years_earliest, law.years_latest].map(Option::unwrap);
            limits += usize::from(from <= 2.0 && (2.0..3.0).contains(&to));
        }
        assert!(rates >= 5 && limits >= 5, "{rates} {limits}");
    }

    #[test]
    fn exact_the_law_reaches_its_limit_at_the_root_of_its_parabola() {
        let options = LoggedOptions {
            limit: Some(SlopeLimit {
                size: 12.0,
                is_one_sided: false,
            }),
            ..LoggedOptions::default()
        };
        let trend = logged_trend(&lawful(1, |t| 0.5 * t * t), &options).unwrap();
        let (slope, curve) = (trend.slope.unwrap(), trend.curve.unwrap());
        let (season, last) = (
            trend.yearly.unwrap(),
            trend.daily.days[trend.daily.days.len() - 1],
        );
        let at = |years: f64, a: f64| {
            let straight = slope.now + slope.per_year * years;
            straight + 0.5 * a * years * years + season.at(last + YEAR_DAYS * years)
        };
        for (reach, a) in [(slope.reach, curve.per_year2), (curve.at_rate, 0.0)] {
            let years = reach.unwrap().years.unwrap();
            assert!((at(years, a) - 12.0).abs() < 1e-6, "{reach:?}");
            let mut before = (0..(1000.0 * years) as usize).map(|i| at(i as f64 / 1000.0, a));
            assert!(before.all(|value| value < 12.0), "{reach:?}");
        }
    }

    #[test]
    fn holds_a_step_is_dated_by_the_days_and_makes_no_slope() {
        let (mut dated, mut held) = (0, 0);
        for seed in 0..10 {
            let at = 18_000.0 + 300.0 + 47.0 * seed as f64;
            let step = |t: f64| f64::from(u8::from(18_000.0 + t * YEAR_DAYS > at - 0.5));
            let series = lawful(seed, |t| 0.6 * step(t));
            let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
            let near = trend.changes.iter().find(|of| (of.day - at).abs() <= 2.0);
            dated += usize::from(near.is_some_and(|of| {
                of.form == ChangeForm::Step && (of.size - 0.6).abs() < 4.0 * of.sd && of.after < at
            }));
            held += usize::from(holds_slope(&trend, 0.0));
        }
        assert!(dated >= 9 && held >= 9, "{dated} {held}");
    }

    #[test]
    fn holds_days_on_another_scale_have_a_question_and_no_slope() {
        let asked = |seed: u64, other: &dyn Fn(f64) -> f64| {
            let mut series = lawful(seed, |_| 0.0);
            series.daily.values[500..]
                .iter_mut()
                .for_each(|value| *value = other(*value));
            let trend = logged_trend(&series, &LoggedOptions::default()).unwrap();
            assert_eq!(
                trend.scale.map(NoSlope::OtherScale).map(Err),
                trend.scale.map(|_| trend.slope)
            );
            trend.scale
        };
        for seed in 0..4 {
            assert_eq!(asked(seed, &|value| value), None, "{seed}");
            for factor in [10.0, 16.0, 0.1] {
                let scale = asked(seed, &|value| factor * value).unwrap();
                let ScaleMark::Scatter(found) = scale.mark else {
                    panic!("{scale:?}")
                };
                assert!((found / factor - 1.0).abs() < 0.3, "{seed} {scale:?}");
                assert!((scale.from - 18_500.0).abs() <= 10.0, "{seed} {scale:?}");
            }
            let scale = asked(seed, &|value| -value).unwrap();
            assert_eq!((scale.from, scale.mark), (18_500.0, ScaleMark::OtherSign));
            // only season and temperature show it
            let scale = asked(seed, &|value| 6.6 - value).unwrap();
            assert_eq!(scale.mark, ScaleMark::Turned, "{seed}");
        }
    }
}
