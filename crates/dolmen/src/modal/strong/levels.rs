//! Level of each second of a record over its noise.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | q_ck | `levels` | level of channel c in window k: median of abs(x) over one second; windows overlap by half |
//! | n_c | `noise` | noise level of the channel: median of q_ck before the arrival, otherwise their 10 % quantile |
//! | s_k | `scores` | smallest q_ck / n_c of the channels, except for a quarter of them |

use crate::numeric::quantile;
use crate::signal::Record;
use std::ops::Range;

/// Length of a window, s: longer than a footfall, shorter than the strong part of an earthquake. Our choice.
const WINDOW_S: f64 = 1.0;
/// Period above which motion counts as drift of the sensor, s.
const SLOW_S: f64 = 4.0;
/// Largest share of the channels that may miss the earthquake: dead, loose, or with different motion.
const MISSING: f64 = 0.25;
/// Score at which the search for the arrival ends, backwards from the largest score, and number of successive windows below it.
const ARRIVED: f64 = 3.0;
const STILL_WINDOWS: usize = 4;
/// Score below which the motion has ended, and number of successive windows for this.
const ENDED: f64 = 2.0;
const ENDED_WINDOWS: usize = 10;
/// RMS of rounding by a digitiser over its step, 1/√12: the noise of a channel is never below this.
const OF_STEP: f64 = 0.289;
const WINDOWS_LEAST: usize = 20;
/// Fewest windows before the arrival for the noise level.
const NOISE_WINDOWS_LEAST: usize = 6;

/// The levels of a record, window by window.
#[derive(Clone, Debug)]
pub(super) struct Levels {
    pub(super) rate_hz: f64,
    /// Samples from one window to the next.
    hop: usize,
    /// Each channel without its drift, computed at first use.
    pub(super) steady: Vec<Vec<f64>>,
    pub(super) noise: Vec<f64>,
    /// Score of each window; a window with lost samples has the score of the previous one.
    pub(super) scores: Vec<f64>,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Motion {
    pub(super) at: usize,
    /// Windows from the arrival to the end of the motion, which is excluded.
    pub(super) windows: Range<usize>,
    /// Whether the motion ends before the end of the record or the next motion.
    pub(super) ends: bool,
}

impl Levels {
    /// `None` if the record is too short, or if no channel moves. Samples in `lost_s` were lost.
    pub(super) fn of(record: &Record, lost_s: &[[f64; 2]]) -> Option<Levels> {
        let rate_hz = record.sampling_rate_hz();
        let hop = ((0.5 * WINDOW_S * rate_hz).round() as usize).max(2);
        let windows = (record.length() / hop).checked_sub(1)?;
        if windows < WINDOWS_LEAST {
            return None;
        }
        let channels = record.channels().len();
        let is_lost: Vec<bool> = (0..windows)
            .map(|k| {
                let [from_s, to_s] = [k * hop, (k + 2) * hop].map(|at| at as f64 / rate_hz);
                lost_s.iter().any(|[from, to]| *from < to_s && *to > from_s)
            })
            .collect();
        let levels: Vec<Vec<f64>> = (0..channels)
            .map(|c| levels(&steady(record, c, lost_s), hop, windows))
            .collect();
        let floors: Vec<f64> = (0..channels).map(|c| OF_STEP * step(record.samples(c))).collect();
        let level = |c: usize, share: f64, until: usize| {
            let own = levels[c][..until].iter().zip(&is_lost);
            let there: Vec<f64> = own.filter(|(_, lost)| !**lost).map(|(level, _)| *level).collect();
            quantile(&there, share).unwrap_or(0.0).max(floors[c])
        };
        let quiet: Vec<f64> = (0..channels).map(|c| level(c, 0.1, windows)).collect();
        let first = scores(&levels, &quiet, &is_lost)?;
        let before = arrival_of(&first, peak_of(&first, &[])?, 0).saturating_sub(2);
        let noise = match before >= NOISE_WINDOWS_LEAST {
            true => (0..channels).map(|c| level(c, 0.5, before)).collect(),
            false => quiet,
        };
        Some(Levels {
            rate_hz,
            hop,
            scores: scores(&levels, &noise, &is_lost)?,
            steady: Vec::new(),
            noise,
        })
    }

    /// Stores each channel without its drift. Only done when needed: this takes as much memory as the record, and most records have no
    /// strong motion.
    pub(super) fn keep_steady(&mut self, record: &Record, lost_s: &[[f64; 2]]) {
        self.steady = (0..self.noise.len()).map(|c| steady(record, c, lost_s)).collect();
    }

    pub(super) fn time_s(&self, window: usize) -> f64 {
        (window * self.hop) as f64 / self.rate_hz
    }

    /// Channels with motion.
    pub(super) fn live(&self) -> impl Iterator<Item = usize> {
        (0..self.noise.len()).filter(|c| self.noise[*c] > 0.0)
    }

    /// The strongest motion outside these windows with a score of at least `least`.
    pub(super) fn motion(&self, taken: &[Range<usize>], least: f64) -> Option<Motion> {
        let at = peak_of(&self.scores, taken)?;
        if self.scores[at] < least {
            return None;
        }
        let behind = taken.iter().map(|of| of.end).filter(|end| *end <= at).max();
        let next = taken.iter().map(|of| of.start).filter(|start| *start > at).min();
        let last = next.unwrap_or(self.scores.len());
        let is_end = |k: &usize| {
            let row = &self.scores[*k..(k + ENDED_WINDOWS).min(last)];
            row.len() == ENDED_WINDOWS && row.iter().all(|score| *score < ENDED)
        };
        let end = (at..last).find(is_end);
        Some(Motion {
            at,
            windows: arrival_of(&self.scores, at, behind.unwrap_or(0))..end.map_or(last, |k| k + 1),
            ends: end.is_some() || next.is_some(),
        })
    }
}

/// A channel without its drift, and zero where samples were lost.
fn steady(record: &Record, c: usize, lost_s: &[[f64; 2]]) -> Vec<f64> {
    let rate_hz = record.sampling_rate_hz();
    let mut own = without_drift(record.samples(c), (SLOW_S * rate_hz) as usize);
    for span_s in lost_s {
        let [from, to] = span_s.map(|at_s| ((at_s * rate_hz).round() as usize).min(own.len()));
        own[from..to].fill(0.0);
    }
    own
}

/// The channel minus the average of earlier samples: a centred average would shift an arrival to an earlier time.
pub(super) fn without_drift(x: &[f64], length: usize) -> Vec<f64> {
    let mut sums = vec![0.0; x.len() + 1];
    let mut sum = 0.0;
    for (to, x) in sums[1..].iter_mut().zip(x) {
        sum += x;
        *to = sum;
    }
    // what comes first has nothing before it
    let first = (length + 1).min(x.len());
    let mean = sums[first] / first.max(1) as f64;
    let count = (length + 1) as f64;
    let (head, tail) = x.split_at(length.min(x.len()));
    let mut steady = Vec::with_capacity(x.len());
    steady.extend(head.iter().map(|x| x - mean));
    let ends = sums.iter().zip(&sums[first..]);
    steady.extend(
        tail.iter()
            .zip(ends)
            .map(|(x, (from, to))| x - (to - from) / count),
    );
    steady
}

/// The smallest difference between two unequal samples: the step of the digitiser, or almost nothing; 0 if the channel is constant.
fn step(x: &[f64]) -> f64 {
    let differences = x.windows(2).map(|two| (two[1] - two[0]).abs());
    let moves = differences.filter(|by| *by > 0.0);
    moves.reduce(f64::min).unwrap_or(0.0)
}

fn levels(x: &[f64], hop: usize, windows: usize) -> Vec<f64> {
    let mut part = Vec::with_capacity(2 * hop);
    let median = |k: usize| {
        part.clear();
        part.extend(x[k * hop..(k + 2) * hop].iter().map(|x| x.abs()));
        let (_, middle, _) = part.select_nth_unstable_by(hop, f64::total_cmp);
        *middle
    };
    (0..windows).map(median).collect()
}

/// `None` if no channel moves.
fn scores(levels: &[Vec<f64>], noise: &[f64], is_lost: &[bool]) -> Option<Vec<f64>> {
    let live: Vec<usize> = (0..levels.len()).filter(|c| noise[*c] > 0.0).collect();
    if live.is_empty() {
        return None;
    }
    let passed = (MISSING * live.len() as f64) as usize;
    let mut last = 0.0;
    let score = |(k, is_lost): (usize, &bool)| {
        if !is_lost {
            let mut each: Vec<f64> = live.iter().map(|c| levels[*c][k] / noise[*c]).collect();
            each.sort_by(f64::total_cmp);
            last = each[passed];
        }
        last
    };
    Some(is_lost.iter().enumerate().map(score).collect())
}

/// The first of the largest scores outside these windows.
pub(super) fn peak_of(scores: &[f64], taken: &[Range<usize>]) -> Option<usize> {
    let by_size = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1).then(b.0.cmp(&a.0));
    let free = scores
        .iter()
        .enumerate()
        .filter(|(k, _)| !taken.iter().any(|of| of.contains(k)));
    free.max_by(by_size).map(|(at, _)| at)
}

/// The first window of the motion that contains the peak; not before `least`.
fn arrival_of(scores: &[f64], at: usize, least: usize) -> usize {
    let (mut arrival, mut still) = (at, 0);
    for k in (least..at).rev() {
        if scores[k] >= ARRIVED {
            (arrival, still) = (k, 0);
        } else {
            still += 1;
            if still == STILL_WINDOWS {
                break;
            }
        }
    }
    arrival
}
