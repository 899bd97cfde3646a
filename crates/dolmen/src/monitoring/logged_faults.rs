//! Faults in the readings of a logger: spikes, a stuck sensor, jumps.

use super::daily::DailyReadings;
use crate::numeric::middle_mean;

/// Fewest days with a constant value at the end of a log for a stuck sensor, if neighbouring days differed before. Our choice.
const STUCK_DAYS: usize = 30;
/// Number of days on either side whose median is compared with a day, and number of standard deviations beyond which the day is a spike. Our
/// choice.
const BESIDE_DAYS: usize = 7;
const SPIKE_FROM: f64 = 8.0;
/// Number of days before and after a date whose medians are compared, and number of standard deviations beyond which the readings jumped. Our
/// choice: by chance once in several thousand logs.
const JUMP_DAYS: usize = 7;
const JUMP_FROM: f64 = 6.0;
/// Largest number of missing days among them.
const DAYS_MISSING_MOST: usize = 5;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;

/// A sudden shift.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedJump {
    /// The last day before the jump.
    pub after: f64,
    /// The first day after the jump.
    pub before: f64,
    /// Its size.
    pub by: f64,
}

/// Index from which all values are equal, if this is unusual for the sensor.
pub(super) fn stuck(values: &[f64]) -> Option<usize> {
    let last = values.last()?;
    let run = values.iter().rev().take_while(|value| *value == last).count();
    let from = values.len() - run;
    let alike = values[..from]
        .windows(2)
        .filter(|pair| pair[0] == pair[1])
        .count();
    (run >= STUCK_DAYS && from > STUCK_DAYS && 2 * alike < from).then_some(from + 1)
}

/// Indices of values far from the median of their neighbours.
pub(super) fn spikes(values: &[f64]) -> Vec<usize> {
    let n = values.len();
    if n < 4 * BESIDE_DAYS {
        return Vec::new();
    }
    let off = |i: usize| {
        let around = i.saturating_sub(BESIDE_DAYS)..(i + BESIDE_DAYS + 1).min(n);
        values[i] - middle_mean(values[around].to_vec())
    };
    let off: Vec<f64> = (0..n).map(off).collect();
    let usual = OF_MEDIAN * middle_mean(off.iter().map(|off| off.abs()).collect());
    // readings with coarse steps are often equal, and a difference of one step is not unusual
    let steps = values.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let step = steps.filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min);
    let limit = SPIKE_FROM * usual.max(step.min(f64::MAX));
    (0..n).filter(|i| off[*i].abs() > limit).collect()
}

/// The largest significant difference of medians before and after a date without a work.
pub(super) fn jump(daily: &DailyReadings, works: &[[f64; 2]]) -> Option<LoggedJump> {
    let (days, values) = (&daily.days, &daily.values);
    let n = values.len();
    if n < 8 * JUMP_DAYS {
        return None;
    }
    let by = |i: usize| {
        let median = |of: &[f64]| middle_mean(of.to_vec());
        median(&values[i..i + JUMP_DAYS]) - median(&values[i - JUMP_DAYS..i])
    };
    let all: Vec<(usize, f64)> = (JUMP_DAYS..=n - JUMP_DAYS).map(|i| (i, by(i))).collect();
    let usual = OF_MEDIAN * middle_mean(all.iter().map(|(_, by)| by.abs()).collect());
    // across a gap, slope and season cause a difference too
    let is_free = |i: usize| {
        let (from, to) = (days[i - JUMP_DAYS], days[i + JUMP_DAYS - 1]);
        let is_near = to - from <= (2 * JUMP_DAYS + DAYS_MISSING_MOST) as f64;
        is_near && !works.iter().any(|work| work[0] <= to && work[1] >= from)
    };
    let free = all.into_iter().filter(|(i, _)| is_free(*i));
    let (i, by) = free.max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()))?;
    (usual > 0.0 && by.abs() > JUMP_FROM * usual).then(|| {
        let at = split(&values[i - JUMP_DAYS..i + JUMP_DAYS]);
        LoggedJump {
            after: days[i - JUMP_DAYS + at - 1],
            before: days[i - JUMP_DAYS + at],
            by,
        }
    })
}

/// Split of a window into two levels with the smallest distances of the readings from the medians of its ends.
fn split(values: &[f64]) -> usize {
    let n = values.len();
    let quarter = (n / 4).max(1);
    let level = |of: &[f64]| middle_mean(of.to_vec());
    let (before, behind) = (level(&values[..quarter]), level(&values[n - quarter..]));
    let off = |at: usize| -> f64 {
        let left = values[..at].iter().map(|x| (x - before).abs());
        left.chain(values[at..].iter().map(|x| (x - behind).abs())).sum()
    };
    let all = (1..n).min_by(|a, b| off(*a).total_cmp(&off(*b)));
    all.unwrap_or(n / 2)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// 400 days at 3 with noise of 0.06, increased by `step` from index 200 on; `missing` days lie before this index.
    fn readings(seed: u64, step: f64, missing: f64) -> DailyReadings {
        let mut random = Random::new(seed, 0);
        let later = |i: i32| f64::from(u8::from(i >= 200));
        DailyReadings {
            days: (0..400).map(|i| f64::from(i) + missing * later(i)).collect(),
            values: (0..400)
                .map(|i| 3.0 + step * later(i) + 0.06 * random.normal())
                .collect(),
            ..DailyReadings::default()
        }
    }

    #[test]
    fn holds_a_jump_is_dated_to_the_day_and_a_gap_is_none() {
        for seed in 0..20 {
            let found = jump(&readings(seed, 0.8, 0.0), &[]).unwrap();
            assert_eq!((found.after, found.before), (199.0, 200.0), "seed {seed}");
            assert!((found.by - 0.8).abs() < 0.2, "{found:?}");
            assert!(jump(&readings(seed, 0.0, 0.0), &[]).is_none(), "seed {seed}");
            // the effect of slope and season in two years without readings
            assert!(jump(&readings(seed, 0.8, 700.0), &[]).is_none(), "seed {seed}");
        }
    }
}
