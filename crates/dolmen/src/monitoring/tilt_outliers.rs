//! Outliers among the readings of a tilt: a single wrong reading is not a step, and must neither hide nor cause a slope.

use crate::numeric::{middle, middle_mean};
use std::ops::Range;

/// Number of readings on either side for the comparison, and how many of them may agree with the reading.
const BESIDE: usize = 3;
const WITH_IT: usize = 1;
/// Number of standard deviations beyond which a reading is isolated, as for frequencies; also for the first reading, relative to the line through the
/// next ones. Our choice.
pub(super) const ALONE: f64 = 6.0;
const ALONE_FIRST: f64 = 12.0;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;
/// Part of the expected size by which a reading stands alone among readings that are all equal. Our choice: their last digit is not known here.
const ALONE_AMONG_EQUAL: f64 = 0.5;
/// Relative difference below which two readings are equal.
const EQUAL: f64 = 1e-9;
/// Fewest readings for a comparison with neighbours.
pub(super) const READINGS_LEAST: usize = 8;

/// An isolated reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltOutlier {
    /// Index of the reading.
    pub at: usize,
    /// Value expected from the neighbouring readings.
    pub expected: f64,
}

/// Readings that differ by more than six standard deviations from the six readings around them, or from all but one of these. The first reading is
/// also an outlier if it is that far from the line through the next ones. Readings on a slope are compared without it. `reading_sd` is the standard
/// deviation of a reading due to its own error; 0 if unknown.
///
/// Two adjacent outliers are found. A step is not an outlier, because the readings before it agree with each other. Neither is the first reading
/// after a step, or the last before it, if it is on the line of the three readings on its side. The last reading is never an outlier: only the next
/// reading can show whether the structure moved.
pub(super) fn tilt_outliers(days: &[f64], ratios: &[f64], reading_sd: f64) -> Vec<TiltOutlier> {
    let n = days.len();
    if n < READINGS_LEAST {
        return Vec::new();
    }
    let beside: Vec<NeighbourDistance> = (0..n - 1)
        .map(|i| NeighbourDistance::of(i, days, ratios))
        .collect();
    let is_inner = |at: usize| at >= BESIDE && at + BESIDE < n;
    let level: Vec<NeighbourDistance> = beside.iter().map(|of| of.without_slope(days, ratios)).collect();
    let spread_of = |all: &[NeighbourDistance]| {
        let inner = all.iter().filter(|of| is_inner(of.at));
        OF_MEDIAN * middle(inner.map(|of| of.middle().abs()).collect())
    };
    // a single wrong reading on a slope spreads its neighbours, unless the slope is removed
    let spread = spread_of(&beside).min(spread_of(&level));
    let each = beside.iter().zip(&level).enumerate().filter(|(i, (of, level))| {
        let with_it = match is_inner(*i) {
            true => WITH_IT,
            false => 0,
        };
        let expected = ratios[*i] - level.middle();
        let usual = spread
            .max(usual_step(ratios, *i..*i + 1, expected))
            .max(reading_sd);
        let is_alone =
            of.is_alone(ALONE * usual, with_it) || is_inner(*i) && level.is_alone(ALONE * usual, with_it);
        is_alone
            && !of.is_on_a_side(ALONE * usual, days, ratios)
            && (*i > 0 || level.is_alone(ALONE_FIRST * usual, 0))
    });
    each.map(|(at, (_, level))| TiltOutlier {
        at,
        expected: ratios[at] - level.middle(),
    })
    .collect()
}

/// The finest step between neighbouring readings, without some of them: readings with coarse steps are often equal, and a difference of one step is
/// not unusual. Where the others are all equal, it is the part of the expected size that stands alone.
pub(super) fn usual_step(ratios: &[f64], without: Range<usize>, expected: f64) -> f64 {
    let largest = ratios.iter().fold(0.0_f64, |most, ratio| most.max(ratio.abs()));
    let pairs = (1..ratios.len()).filter(|i| !without.contains(i) && !without.contains(&(i - 1)));
    let steps = pairs.map(|i| (ratios[i] - ratios[i - 1]).abs());
    let finest = steps
        .filter(|step| *step > EQUAL * largest)
        .fold(f64::INFINITY, f64::min);
    match finest.is_finite() {
        true => finest,
        false => ALONE_AMONG_EQUAL / ALONE * expected.abs(),
    }
}

struct NeighbourDistance {
    at: usize,
    near: Vec<usize>,
    off: Vec<f64>,
}

impl NeighbourDistance {
    fn of(at: usize, days: &[f64], ratios: &[f64]) -> Self {
        let from = at.saturating_sub(BESIDE).min(days.len() - 1 - 2 * BESIDE);
        let near: Vec<usize> = (from..=from + 2 * BESIDE).filter(|j| *j != at).collect();
        let off = near.iter().map(|j| ratios[at] - ratios[*j]).collect();
        NeighbourDistance { at, near, off }
    }

    /// The same after removing the median slope of all pairs of the other readings, which a single wrong reading does not change (Theil 1950, Sen
    /// 1968).
    fn without_slope(&self, days: &[f64], ratios: &[f64]) -> Self {
        let pairs = self.near.iter().enumerate();
        let pairs = pairs.flat_map(|(i, a)| self.near[i + 1..].iter().map(move |b| (*a, *b)));
        let slopes = pairs.map(|(a, b)| (ratios[b] - ratios[a]) / (days[b] - days[a]));
        let slope = middle_mean(slopes.collect());
        let both = self.near.iter().zip(&self.off);
        NeighbourDistance {
            at: self.at,
            near: self.near.clone(),
            off: both
                .map(|(j, off)| off - slope * (days[self.at] - days[*j]))
                .collect(),
        }
    }

    /// Whether the reading is beyond all other readings on one side, except for this number.
    fn is_alone(&self, limit: f64, with_it: usize) -> bool {
        let most = self.off.len() - with_it;
        let above = self.off.iter().filter(|off| **off > limit).count();
        let below = self.off.iter().filter(|off| **off < -limit).count();
        above >= most || below >= most
    }

    /// Whether it is on the line of the three readings before it, or of the three after it.
    fn is_on_a_side(&self, limit: f64, days: &[f64], ratios: &[f64]) -> bool {
        let sides = [
            self.at.checked_sub(BESIDE).map(|from| from..self.at),
            (self.at + BESIDE < days.len()).then(|| self.at + 1..self.at + 1 + BESIDE),
        ];
        sides.into_iter().flatten().any(|side| {
            let near: Vec<usize> = side.collect();
            let off = near.iter().map(|j| ratios[self.at] - ratios[*j]).collect();
            let own = NeighbourDistance {
                at: self.at,
                near,
                off,
            };
            own.without_slope(days, ratios).middle().abs() <= limit
        })
    }

    fn middle(&self) -> f64 {
        middle_mean(self.off.clone())
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    fn named(ratios: &[f64]) -> Vec<usize> {
        let days: Vec<f64> = (0..ratios.len()).map(|i| 365.25 * i as f64).collect();
        tilt_outliers(&days, ratios, 0.0).iter().map(|of| of.at).collect()
    }

    #[test]
    fn exact_a_decimal_slip_stands_alone_among_readings_without_scatter() {
        for at in 1..11 {
            let mut equal = [5e-3; 12];
            equal[at] = 0.5e-3;
            assert_eq!(named(&equal), [at]);
            let mut sloping: Vec<f64> = (0..12).map(|i| 3e-3 + 0.25e-3 * f64::from(i)).collect();
            sloping[at] *= 0.1;
            assert_eq!(named(&sloping), [at]);
        }
        // a crack of 0.3 mm, once written as 3 mm
        let mut crack = [0.3e-3; 12];
        crack[5] = 3e-3;
        assert_eq!(named(&crack), [5]);
    }

    #[test]
    fn holds_sound_readings_are_not_alone() {
        let mut alone = 0;
        for seed in 0..400 {
            let mut random = Random::new(9, seed);
            let digits = [0.0, 0.01, 0.1][(seed % 3) as usize];
            let (yearly, scatter) = ([0.0, 0.25][(seed % 2) as usize], 0.03 + 0.02 * (seed % 4) as f64);
            let read = |i: u32| {
                let read = 3.0 + yearly * f64::from(i) + scatter * random.normal();
                if digits > 0.0 {
                    (read / digits).round() * digits * 1e-3
                } else {
                    1e-3 * read
                }
            };
            alone += named(&(0..14).map(read).collect::<Vec<f64>>()).len();
        }
        assert!(alone <= 2, "{alone}");
        // one step of the last digit among equal readings
        for size in [5.0, 3.0, 0.3] {
            let mut coarse = [1e-3 * size; 12];
            coarse[6] += 0.1e-3;
            assert_eq!(named(&coarse), [] as [usize; 0]);
        }
    }
}
