//! Readings of a logger, reduced to one value per day.

use crate::numeric::middle_mean;

const DAY_S: f64 = 86_400.0;
/// Largest number of days at one end of a log that may come from a wrong clock; their least distance from the other days, in days and in
/// usual gaps. Our choice.
const STRAY_MOST: usize = 4;
const STRAY_APART_DAYS: f64 = 366.0;
const STRAY_APART_GAPS: f64 = 50.0;

/// One value per day.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct DailyReadings {
    /// Days from 1970-01-01 by the clock of the logger, ascending.
    pub days: Vec<f64>,
    /// The median of each day.
    pub values: Vec<f64>,
    /// Total number of readings.
    pub readings: usize,
    /// Number of readings that were left out at either end because their days are far from all others: the clock was wrong.
    pub stray: usize,
}

/// The median of each day, from readings with times in s since 1970-01-01.
///
/// Up to four days at either end, if they are more than a year and fifty usual gaps away from the other days, come from a wrong clock and
/// are left out.
pub fn daily_medians(times_s: &[f64], values: &[f64]) -> DailyReadings {
    let mut found = DailyReadings::default();
    let mut counts = Vec::new();
    let (mut day, mut of_day) = (f64::NAN, Vec::new());
    let mut put = |day: f64, of_day: &mut Vec<f64>| {
        if !of_day.is_empty() {
            counts.push(of_day.len());
            found.days.push(day);
            found.values.push(middle_mean(std::mem::take(of_day)));
        }
    };
    for (at, value) in times_s.iter().zip(values) {
        let own = (at / DAY_S).floor();
        if own != day {
            put(day, &mut of_day);
            day = own;
        }
        of_day.push(*value);
    }
    put(day, &mut of_day);
    let kept = kept(&found.days);
    found.readings = counts.get(kept.clone()).unwrap_or_default().iter().sum();
    found.stray = counts.iter().sum::<usize>() - found.readings;
    found.days = found.days.get(kept.clone()).unwrap_or_default().to_vec();
    found.values = found.values.get(kept).unwrap_or_default().to_vec();
    found
}

/// Range of the days that are kept.
fn kept(days: &[f64]) -> std::ops::Range<usize> {
    let mut gaps: Vec<f64> = days.windows(2).map(|pair| pair[1] - pair[0]).collect();
    gaps.sort_by(f64::total_cmp);
    let usual = gaps.get(gaps.len() / 2).copied().unwrap_or(1.0);
    let apart = STRAY_APART_DAYS.max(STRAY_APART_GAPS * usual);
    let is_apart = |at: usize| days[at] - days[at - 1] > apart;
    let (mut from, mut to) = (0, days.len());
    if to > 3 * STRAY_MOST {
        from = (1..=STRAY_MOST).rev().find(|at| is_apart(*at)).unwrap_or(0);
        to = (days.len() - STRAY_MOST..days.len())
            .find(|at| is_apart(*at))
            .unwrap_or(days.len());
    }
    from..to
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_medians_of_days_and_the_days_of_a_wrong_clock() {
        // thirty days with three readings each, one of them a spike; before them two readings of 1990, after them one of 2099
        let first = 20_000.0;
        let mut times_s = vec![7305.0 * DAY_S, 7305.5 * DAY_S];
        let mut values = vec![9.0, 9.0];
        for day in 0..30 {
            for (hour, value) in [(1.0, 2.0), (2.0, 3.0), (3.0, 1e6)] {
                times_s.push((first + f64::from(day)) * DAY_S + 3600.0 * hour);
                values.push(value + f64::from(day));
            }
        }
        times_s.push(47_117.0 * DAY_S);
        values.push(9.0);
        let daily = daily_medians(&times_s, &values);
        assert_eq!((daily.readings, daily.stray), (90, 3));
        assert_eq!(daily.days[0], first);
        let expected: Vec<f64> = (0..30).map(|day| 3.0 + f64::from(day)).collect();
        assert_eq!(daily.values, expected);
    }

    #[test]
    fn holds_readings_once_a_year_are_no_stray_ones() {
        let times_s: Vec<f64> = (0..20).map(|year| 370.0 * DAY_S * f64::from(year)).collect();
        let daily = daily_medians(&times_s, &[1.0; 20]);
        assert_eq!((daily.days.len(), daily.stray), (20, 0));
        assert!(daily_medians(&[], &[]).days.is_empty());
    }
}
