//! Newest days of a log that differ from its earlier behaviour: the structure moved, or the sensor failed. Later days will show which.
//!
//! ```text
//! d_k(i) = mean of r over the k days that end at i − median of r over the 14 days before,   r = y − Xβ
//! ```
//! X: level, slope, yearly wave, temperature, and a step at each shift. β is from the days before the newest. The newest d_k counts if it
//! exceeds all earlier d_k and four of their standard deviations, so that chance
//! names at most one log in (earlier days)/7.

use super::daily::DailyReadings;
use super::logged_faults::LoggedJump;
use super::regression::Fit;
use super::series::Series;
use super::wave::yearly_wave;
use super::weather::YEAR_DAYS;
use super::whitening::Disturbance;
use crate::numeric::middle_mean;

/// Largest number of newest days; after as many, a lasting change is a jump.
const LAST_DAYS: usize = 7;
/// Number of days before them whose median they are compared with. Our choice.
const BEFORE_DAYS: usize = 14;
/// Number of standard deviations of the earlier differences from which the newest counts. Our choice.
const OFF_FROM: f64 = 4.0;
/// Fewest earlier differences. Our choice.
const DIFFERENCES_LEAST: usize = 60;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;

/// Newest days that differ from those before.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedLast {
    /// Number of these days.
    pub days: usize,
    /// The first of them.
    pub from: f64,
    /// Their mean difference from the days before, without season, temperature and slope.
    pub off: f64,
    /// Standard deviation of the earlier differences of as many days.
    pub scatter: f64,
}

/// Residuals of days, with the number of shifts before each.
struct Residuals {
    values: Vec<f64>,
    /// Median of the days before each comparison, by the index of the first of them.
    before: Vec<f64>,
    shifts: Vec<usize>,
    /// Number of days before the newest and those they are compared with.
    earlier: usize,
}

/// The newest days that differ from their predecessors. `shifts`: days of works and jumps, whose effect is known. `temperatures_c` is used if
/// all newest days have one.
///
/// Validated by `regress_newest_days_that_differ_are_named_and_rarely_by_chance`.
fn last_off(daily: &DailyReadings, temperatures_c: &[f64], shifts: &[f64]) -> Option<LoggedLast> {
    let (days, n) = (&daily.days, daily.days.len());
    let residuals = Residuals::of(daily, temperatures_c, shifts)?;
    let mut gaps: Vec<f64> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    let usual = gaps.get(gaps.len() / 2).copied()?;
    let size = daily
        .values
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()));
    let step = daily.values[..residuals.earlier]
        .windows(2)
        .map(|pair| (pair[1] - pair[0]).abs())
        .filter(|step| *step > 0.0)
        .fold(f64::INFINITY, f64::min);
    let each = (1..=LAST_DAYS).filter_map(|k| {
        let from = n - k;
        let off = residuals.off(from, k, 0)?;
        // earlier differences across as long a gap
        let missing = (days[from] - days[from - 1]) / usual - 1.0;
        let skip = missing.round().max(0.0) as usize;
        let last = residuals.earlier.checked_sub(k)?;
        let earlier: Vec<f64> = (0..=last)
            .filter_map(|from| residuals.off(from, k, skip))
            .map(f64::abs)
            .collect();
        if earlier.len() < DIFFERENCES_LEAST {
            return None;
        }
        let most = earlier.iter().copied().fold(0.0, f64::max);
        let scatter = OF_MEDIAN * middle_mean(earlier);
        // readings with coarse steps are often equal, and a difference of one step is not unusual
        let coarse = if step.is_finite() { 2.0 * step } else { 0.0 };
        let limit = (OFF_FROM * scatter).max(most).max(coarse).max(1e-9 * size);
        let found = LoggedLast {
            days: k,
            from: days[from],
            off,
            scatter,
        };
        (off.abs() > limit).then_some((off.abs() / scatter.max(1e-9 * size), found))
    });
    let named: Vec<(f64, LoggedLast)> = each.collect();
    let (_, strongest) = *named.iter().max_by(|a, b| a.0.total_cmp(&b.0))?;
    // the days that differ by more than half of it
    let before = residuals.before[n - strongest.days - BEFORE_DAYS];
    let newest = residuals.values.iter().rev();
    let is_off = |value: &&f64| (**value - before) / strongest.off > 0.5;
    let run = newest.take_while(is_off).count();
    let of_run = named.iter().find(|(_, of)| of.days == run);
    Some(of_run.map_or(strongest, |(_, of)| *of))
}

impl Residuals {
    fn of(daily: &DailyReadings, temperatures_c: &[f64], shifts: &[f64]) -> Option<Self> {
        let (days, n) = (&daily.days, daily.days.len());
        let earlier = n.checked_sub(LAST_DAYS + BEFORE_DAYS)?;
        let last = days.last()?;
        let mut columns = vec![vec![1.0; n]];
        if last - days[0] > YEAR_DAYS {
            columns.push(days.iter().map(|day| (day - last) / YEAR_DAYS).collect());
            let wave = yearly_wave(days, &columns);
            columns.extend(wave);
        }
        let is_known = |of: &&[f64]| of.len() == n && of.iter().all(|t| t.is_finite());
        if let Some(known) = Some(temperatures_c).filter(is_known) {
            columns.push(known.to_vec());
        }
        for at in shifts {
            let behind: Vec<f64> = days.iter().map(|day| f64::from(u8::from(day >= at))).collect();
            let is_seen = behind[..earlier].contains(&0.0) && behind[..earlier].contains(&1.0);
            if is_seen && !columns.contains(&behind) {
                columns.push(behind);
            }
        }
        let fitted = |columns: &[Vec<f64>]| {
            let own: Vec<Vec<f64>> = columns.iter().map(|column| column[..earlier].to_vec()).collect();
            let series = Series {
                at: (0..earlier).map(|i| i as f64).collect(),
                readings: daily.values[..earlier].to_vec(),
                noise_sd: vec![0.0; earlier],
            };
            let alone = Disturbance {
                sd: 1.0,
                correlation: 0.0,
            };
            Fit::new(&series, &own, alone).map(|fit| fit.coefficients)
        };
        let coefficients = fitted(&columns).or_else(|| fitted(&columns[..1]))?;
        let explained = |i: usize| -> f64 {
            let parts = columns.iter().zip(&coefficients);
            parts.map(|(column, beta)| column[i] * beta).sum()
        };
        let values: Vec<f64> = (0..n).map(|i| daily.values[i] - explained(i)).collect();
        let before = values.windows(BEFORE_DAYS);
        Some(Residuals {
            before: before.map(|days| middle_mean(days.to_vec())).collect(),
            values,
            shifts: days
                .iter()
                .map(|day| shifts.iter().filter(|at| *day >= **at).count())
                .collect(),
            earlier,
        })
    }

    /// Mean of `k` days less the median of the days before, `skip` days apart; `None` with a shift in between.
    fn off(&self, from: usize, k: usize, skip: usize) -> Option<f64> {
        let to = from.checked_sub(skip)?;
        let begin = to.checked_sub(BEFORE_DAYS)?;
        (self.shifts[begin] == self.shifts[from + k - 1]).then(|| {
            let own = self.values[from..from + k].iter().sum::<f64>() / k as f64;
            own - self.before[begin]
        })
    }
}

/// The newest days that differ from those before. None of them is a spike, and none is left out for its temperature: without it, the temperature
/// is not used.
pub(super) fn newest_off(
    (all, temperatures_c): (&DailyReadings, &[f64]),
    until: usize,
    (wild, works): (&[usize], &[[f64; 2]]),
    jump: Option<&LoggedJump>,
) -> Option<LoggedLast> {
    let newest = until.saturating_sub(LAST_DAYS);
    let celsius = |i: usize| temperatures_c.get(i).copied().unwrap_or(f64::NAN);
    let is_known = (newest..until).all(|i| celsius(i).is_finite());
    let of_work = |day: f64| {
        let mut works = works.iter();
        works.any(|[from, to]| day >= from - 1.0 && day <= to + 1.0)
    };
    let kept: Vec<usize> = (0..until)
        .filter(|i| *i >= newest || !wild.contains(i))
        .filter(|i| !of_work(all.days[*i]) && (!is_known || celsius(*i).is_finite()))
        .collect();
    let daily = DailyReadings {
        days: kept.iter().map(|i| all.days[*i]).collect(),
        values: kept.iter().map(|i| all.values[*i]).collect(),
        ..*all
    };
    let temperatures_c: Vec<f64> = kept.iter().map(|i| celsius(*i)).collect();
    let works = works.iter().map(|[from, _]| *from);
    let shifts: Vec<f64> = works.chain(jump.map(|jump| jump.before)).collect();
    last_off(&daily, &temperatures_c, &shifts)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use std::f64::consts::TAU;

    /// Three years of days with a yearly wave of 6, a disturbance of correlation 0.7 and standard deviation 1, 5 % of the days missing and
    /// two gaps of 20 and 9 days; `newest` is added to the last days.
    fn made(seed: u64, correlation: f64, newest: &[f64]) -> (DailyReadings, Vec<f64>) {
        let mut random = Random::new(91, seed);
        let (mut x, mut air) = (random.normal(), 0.0);
        let (mut daily, mut temperatures_c) = (DailyReadings::default(), Vec::new());
        for i in 0..1096 {
            let day = 18_000.0 + f64::from(i);
            x = correlation * x + (1.0 - correlation * correlation).sqrt() * random.normal();
            air = 0.9 * air + 1.3 * random.normal();
            let celsius = 12.0 - 12.0 * (TAU * (day - 30.0) / YEAR_DAYS).cos() + air;
            // the gap of nine days is near the end in some of the logs
            let gap = 1080 - 40 * (seed as i32 % 4);
            let is_missing =
                random.uniform() < 0.05 || (500..520).contains(&i) || (gap..gap + 9).contains(&i);
            if !is_missing {
                daily.days.push(day);
                daily
                    .values
                    .push(5.0 + 6.0 * (TAU * day / YEAR_DAYS + 1.0).sin() + 0.3 * celsius + x);
                temperatures_c.push(celsius);
            }
        }
        let n = daily.values.len();
        for (value, by) in daily.values[n - newest.len()..].iter_mut().zip(newest) {
            *value += by;
        }
        (daily, temperatures_c)
    }

    /// Of 200 logs, those whose newest days the trend reports.
    fn named(correlation: f64, newest: &[f64]) -> usize {
        let sum = newest.iter().sum::<f64>();
        let is_named = |seed: &u64| {
            let (daily, temperatures_c) = made(*seed, correlation, newest);
            let found = last_off(&daily, &temperatures_c, &[]);
            let is_right = newest.is_empty() || found.is_none_or(|of| of.off * sum > 0.0);
            assert!(is_right, "{seed} {found:?}");
            found.is_some()
        };
        (0..200).filter(is_named).count()
    }

    #[test]
    fn regress_newest_days_that_differ_are_named_and_rarely_by_chance() {
        for correlation in [0.0, 0.7, 0.95] {
            let by_chance = named(correlation, &[]);
            assert!(by_chance <= 2, "{correlation}: {by_chance} by chance");
            let last = named(correlation, &[10.0]);
            assert!(last >= 190, "{correlation}: {last}");
        }
        for newest in [&[10.0; 6][..], &[-2.0, -4.0, -6.0, -8.0, -10.0]] {
            assert!(named(0.7, newest) >= 190, "{newest:?}");
        }
    }

    #[test]
    fn holds_a_step_at_a_work_is_not_named_and_a_constant_gauge_that_moves_is() {
        let (mut daily, temperatures_c) = made(3, 0.7, &[10.0; 3]);
        let n = daily.days.len();
        let found = last_off(&daily, &temperatures_c, &[]).unwrap();
        assert!((found.off - 10.0).abs() < 2.5, "{found:?}");
        assert_eq!(last_off(&daily, &temperatures_c, &[daily.days[n - 3]]), None);
        daily.values = vec![0.3; n];
        assert_eq!(last_off(&daily, &[], &[]), None);
        daily.values[n - 2..].fill(1.0);
        let found = last_off(&daily, &[], &[]).unwrap();
        assert!(found.days == 2 && (found.off - 0.7).abs() < 1e-9, "{found:?}");
    }
}
