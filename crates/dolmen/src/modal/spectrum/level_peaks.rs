//! Peaks of a level over the lines of a spectrum, and their widths.

use std::ops::Range;

pub(crate) fn decibel(power: f64) -> f64 {
    10.0 * power.max(f64::MIN_POSITIVE).log10()
}

/// Distance in lines between the points 3 dB below the peak at `line`, on straight lines through the spectrum.
pub(super) fn half_power_width(level: &[f64], line: usize) -> f64 {
    const HALF_POWER_DB: f64 = 3.0103; // 10 log10 2
    let target = level[line] - HALF_POWER_DB;
    let reach = |next: &dyn Fn(usize) -> Option<usize>| {
        let (mut at, mut steps) = (line, 0.0);
        while let Some(beyond) = next(at) {
            if level[beyond] < target {
                return steps + (level[at] - target) / (level[at] - level[beyond]);
            }
            (at, steps) = (beyond, steps + 1.0);
        }
        steps
    };
    let right = |i: usize| (i + 1 < level.len()).then_some(i + 1);
    reach(&|i| i.checked_sub(1)) + reach(&right)
}

pub(crate) struct Peak {
    pub(crate) line: usize,
    /// Position of the peak between the lines, -0.5 to 0.5.
    pub(super) offset: f64,
    pub(super) prominence_db: f64,
}

/// Local maxima that rise by `prominence_db` above the higher of the two minima that separate them from higher lines.
pub(crate) fn peaks(level: &[f64], range: Range<usize>, prominence_db: f64) -> Vec<Peak> {
    let mut found = Vec::new();
    for i in range.start.max(1)..range.end.min(level.len() - 1) {
        if level[i] <= level[i - 1] || level[i] < level[i + 1] {
            continue;
        }
        let saddle = |side: &mut dyn Iterator<Item = usize>| {
            let mut least = level[i];
            for j in side {
                if level[j] > level[i] {
                    break;
                }
                least = least.min(level[j]);
            }
            least
        };
        let left = saddle(&mut (range.start..i).rev());
        let right = saddle(&mut (i + 1..range.end));
        let prominence = level[i] - left.max(right);
        if prominence >= prominence_db {
            let (a, b, c) = (level[i - 1], level[i], level[i + 1]);
            let bend = a - 2.0 * b + c;
            found.push(Peak {
                line: i,
                offset: if bend < 0.0 {
                    (0.5 * (a - c) / bend).clamp(-0.5, 0.5)
                } else {
                    0.0
                },
                prominence_db: prominence,
            });
        }
    }
    found
}
