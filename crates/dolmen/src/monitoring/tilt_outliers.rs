//! Outliers among the readings of a tilt: a single wrong reading is not a step, and must neither hide nor cause a slope.

use crate::numeric::{middle, middle_mean};

/// Number of readings on either side for the comparison, and how many of them may agree with the reading.
const BESIDE: usize = 3;
const WITH_IT: usize = 1;
/// Number of standard deviations beyond which a reading is isolated, as for frequencies; also for the first reading, relative to the line through the
/// next ones. Our choice.
const ALONE: f64 = 6.0;
const ALONE_FIRST: f64 = 12.0;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;
/// Fewest readings for a comparison with neighbours.
const READINGS_LEAST: usize = 8;

/// An isolated reading.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TiltOutlier {
    /// Index of the reading.
    pub at: usize,
    /// Value expected from the neighbouring readings.
    pub expected: f64,
}

/// Readings that differ by more than six standard deviations from the six readings around them, or from all but one of these. The first reading is
/// also an outlier if it is that far from the line through the next ones.
///
/// Two adjacent outliers are found. A step is not an outlier, because the readings before it agree with each other. Neither is the first reading
/// after a step, or the last before it, if it is on the line of the three readings on its side. The last reading is never an outlier: only the next
/// reading can show whether the structure moved.
pub(super) fn tilt_outliers(days: &[f64], ratios: &[f64]) -> Vec<TiltOutlier> {
    let n = days.len();
    if n < READINGS_LEAST {
        return Vec::new();
    }
    let beside: Vec<NeighbourDistance> = (0..n - 1)
        .map(|i| NeighbourDistance::of(i, days, ratios))
        .collect();
    let inner = beside.iter().take(n - BESIDE).skip(BESIDE);
    let spread = OF_MEDIAN * middle(inner.map(|of| of.middle().abs()).collect());
    // readings with coarse steps are often equal, and a difference of one step is not unusual
    let steps = ratios.windows(2).map(|pair| (pair[1] - pair[0]).abs());
    let finest = steps.filter(|step| *step > 0.0).fold(f64::INFINITY, f64::min);
    let usual = spread.max(finest.min(f64::MAX));
    let each = beside.iter().enumerate().filter(|(i, of)| {
        let with_it = match *i < BESIDE || i + BESIDE >= n {
            true => 0,
            false => WITH_IT,
        };
        of.is_alone(ALONE * usual, with_it)
            && !of.is_on_a_side(ALONE * usual, days, ratios)
            && (*i > 0 || of.without_slope(days, ratios).is_alone(ALONE_FIRST * usual, 0))
    });
    each.map(|(at, of)| {
        let off = match at >= BESIDE && at + BESIDE < n {
            true => of.middle(),
            false => of.without_slope(days, ratios).middle(),
        };
        TiltOutlier {
            at,
            expected: ratios[at] - off,
        }
    })
    .collect()
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
