//! Tracks the lowest mode through an earthquake whose ground motion was not measured.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | y | `y` | motion along the shape of the mode before the earthquake | |
//! | f_0 | `expected_hz` | frequency before the earthquake | Hz |
//! | W | `length` | window: twelve periods, overlapping by half | s |

use super::levels::without_drift;
use super::losses::Losses;
use super::shaking::Shaking;
use crate::modal::Mode;
use crate::signal::{Channel, Record};
use std::f64::consts::PI;

/// Number of periods in a window. Our choice.
const PERIODS: f64 = 12.0;
/// Range of the searched frequencies, relative to the frequency before: a structure softens in an earthquake, and hardly stiffens.
const BAND: [f64; 2] = [0.45, 1.15];
/// Least ratio of the level in a window to the level before the arrival.
const OVER_NOISE: f64 = 4.0;
/// Standard deviation of the frequency in a window, over 1/W, because the excitation is not white. From simulated earthquakes with known
/// stiffness: see the test.
const RESOLUTION: f64 = 0.45;
/// Number of search steps within 1/W.
const STEPS: f64 = 8.0;

/// The frequency in one window.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrackPoint {
    /// Middle of the window, s from the first sample of the record.
    pub at_s: f64,
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation, Hz.
    pub frequency_sd_hz: f64,
    /// Power of the motion.
    pub power: f64,
}

/// The lowest mode during the earthquake.
#[derive(Clone, Debug, PartialEq)]
pub struct Tracked {
    /// Frequency in each window.
    pub points: Vec<TrackPoint>,
    /// Mean over the windows of the strong phase, weighted by power, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the mean, Hz.
    pub frequency_sd_hz: f64,
    /// The window with the lowest frequency.
    pub lowest: TrackPoint,
}

/// Tracks a mode through the earthquake; `None` if no window has enough motion.
pub(super) fn tracked(
    (record, losses): (&Record, &Losses),
    (mode, channels): (&Mode, &[Channel]),
    shaking: &Shaking,
) -> Option<Tracked> {
    let (rate_hz, expected_hz) = (record.sampling_rate_hz(), mode.frequency_hz);
    let y = along(record, mode, channels);
    let y = without_drift(&y, (2.0 * rate_hz / expected_hz) as usize);
    let length = ((PERIODS / expected_hz * rate_hz) as usize).max(16);
    let hop = length / 2;
    let arrival = (shaking.arrival_s * rate_hz) as usize;
    let end = ((shaking.end_s * rate_hz) as usize).min(y.len());
    let still = &y[..arrival.saturating_sub(rate_hz as usize)];
    let power = |y: &[f64]| y.iter().map(|y| y * y).sum::<f64>() / y.len().max(1) as f64;
    let least = OVER_NOISE * OVER_NOISE * if still.len() > length { power(still) } else { 0.0 };
    let length_s = length as f64 / rate_hz;
    let mut points = Vec::new();
    let mut from = arrival;
    while from + length <= end {
        let part = &y[from..from + length];
        let is_whole = !losses.is_lost([from, from + length].map(|at| at as f64 / rate_hz));
        if is_whole && power(part) > least {
            let at_hz = peak_hz(part, rate_hz, BAND.map(|of| of * expected_hz));
            points.extend(at_hz.map(|frequency_hz| TrackPoint {
                at_s: (from as f64 + 0.5 * length as f64) / rate_hz,
                frequency_hz,
                frequency_sd_hz: RESOLUTION / length_s,
                power: power(part),
            }));
        }
        from += hop;
    }
    let lowest = points
        .iter()
        .copied()
        .min_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz))?;
    let is_strong = |of: &&TrackPoint| {
        of.at_s + 0.5 * length_s > shaking.strong_from_s && of.at_s - 0.5 * length_s < shaking.strong_to_s
    };
    let strong: Vec<&TrackPoint> = points.iter().filter(is_strong).collect();
    let sum: f64 = strong.iter().map(|of| of.power).sum();
    let mean = |value: &dyn Fn(&TrackPoint) -> f64| {
        strong.iter().map(|of| of.power * value(of)).sum::<f64>() / sum.max(f64::MIN_POSITIVE)
    };
    let frequency_hz = mean(&|of| of.frequency_hz);
    // windows that overlap by half share samples: two count as one
    let effective = sum * sum
        / strong
            .iter()
            .map(|of| of.power * of.power)
            .sum::<f64>()
            .max(f64::MIN_POSITIVE);
    let effective = (0.5 * effective).max(1.0);
    let scatter = mean(&|of| (of.frequency_hz - frequency_hz).powi(2));
    let own = (RESOLUTION / length_s).powi(2);
    (!strong.is_empty()).then(|| Tracked {
        frequency_hz,
        frequency_sd_hz: (own.max(scatter) / effective).sqrt(),
        lowest,
        points,
    })
}

/// The motion along the shape of a mode, from the channels of the mode.
fn along(record: &Record, mode: &Mode, channels: &[Channel]) -> Vec<f64> {
    let mut along = vec![0.0; record.length()];
    for (channel, component) in channels.iter().zip(&mode.shape) {
        let at = record.channels().iter().position(|of| of.name == channel.name);
        let Some(at) = at else { continue };
        for (sum, x) in along.iter_mut().zip(record.samples(at)) {
            *sum += component.re * x;
        }
    }
    along
}

/// The highest peak in the spectrum of a window (Hann) within a band, but not at the edge of the band.
fn peak_hz(part: &[f64], rate_hz: f64, [low_hz, high_hz]: [f64; 2]) -> Option<f64> {
    let n = part.len() as f64;
    let step_hz = rate_hz / n / STEPS;
    let hann: Vec<f64> = part
        .iter()
        .enumerate()
        .map(|(t, y)| y * (PI * (t as f64 + 0.5) / n).sin().powi(2))
        .collect();
    let count = ((high_hz - low_hz) / step_hz).ceil() as usize;
    let power = |k: usize| {
        let turn = 2.0 * PI * (low_hz + k as f64 * step_hz) / rate_hz;
        let twice = 2.0 * turn.cos();
        let (mut last, mut before) = (0.0, 0.0);
        for y in &hann {
            (last, before) = (y + twice * last - before, last);
        }
        last * last + before * before - twice * last * before
    };
    let powers: Vec<f64> = (0..=count).map(power).collect();
    let inner = 1..count;
    let is_peak = |k: &usize| powers[*k] >= powers[k - 1] && powers[*k] > powers[k + 1];
    let at = inner
        .filter(is_peak)
        .max_by(|a, b| powers[*a].total_cmp(&powers[*b]))?;
    let [a, b, c] = [powers[at - 1], powers[at], powers[at + 1]].map(|p| p.max(f64::MIN_POSITIVE).ln());
    let off = 0.5 * (a - c) / (a - 2.0 * b + c);
    Some(low_hz + (at as f64 + if off.is_finite() { off } else { 0.0 }) * step_hz)
}
