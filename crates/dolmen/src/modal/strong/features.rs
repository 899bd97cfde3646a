//! Features of a strong motion that distinguish an earthquake from other motion.

use super::levels::{Levels, Motion, peak_of};
use super::shaking::{Shaking, ShakingKind};
use crate::signal::{Quantity, Record};
use realfft::RealFftPlanner;
use std::f64::consts::PI;

/// Number of windows over which the growth of the score is measured: two seconds.
const GROWTH_WINDOWS: usize = 4;
/// Fraction of the largest score above which renewed growth counts.
const REGROWN_LEAST: f64 = 0.25;
/// Number of highest spectral lines, and of lines on each side of them.
const LINES: usize = 4;
const BESIDE: usize = 2;
/// Ratio of a sample to the noise level at which the motion begins. Gaussian noise exceeds 3 standard deviations in one of 10⁵ samples.
const BEGINS: f64 = 6.5;
/// Fractions of the energy at the start and end of the strong phase (Husid; Trifunac and Brady 1975).
const STRONG: [f64; 2] = [0.05, 0.95];

/// Largest fraction of the channels without the motion.
const MISSING: f64 = 0.25;
/// Frequency range without traffic, Hz: wheels and axles excite the ground at 5 to 30 Hz, but an earthquake that people feel excites all lower
/// frequencies.
const LOW_HZ: [f64; 2] = [0.5, 2.0];
/// Lowest sampling rate that includes this range, Hz.
const RATE_LEAST_HZ: f64 = 5.0;
/// Least duration of the strong phase for this test; least and largest duration of the quiet part next to it, and largest distance between them,
/// s.
const STRONG_LEAST_S: f64 = 4.0;
const QUIET_LEAST_S: f64 = 8.0;
const QUIET_MOST_S: f64 = 60.0;
const APART_S: f64 = 1.0;

#[derive(Clone, Debug)]
pub(super) struct Features {
    pub(super) shaking: Shaking,
    /// Time from the first sample above the noise to the peak of the channel with the latest peak, s.
    pub(super) latest_peak_s: f64,
    /// Relative growth after the peak.
    pub(super) regrowth: f64,
    /// Fraction of the power in the highest spectral lines, for the channel with the smallest fraction.
    pub(super) in_lines: f64,
    /// Ratio of the motion from 0.5 to 2 Hz to that of the quiet part, for the channel with the smallest ratio; `None` if the record does not
    /// allow it.
    pub(super) low_growth: Option<f64>,
    pub(super) peak_m_s2: Option<f64>,
    pub(super) peak_m_s: Option<f64>,
}

/// The features of one motion; `None` for a motion without samples.
pub(super) fn features(
    record: &Record,
    levels: &Levels,
    inputs: &[usize],
    motion: &Motion,
) -> Option<Features> {
    let (rate_hz, scores) = (levels.rate_hz, &levels.scores);
    let Motion { at, windows, ends } = motion;
    let (at, arrival) = (*at, windows.start);
    let growth = (arrival.saturating_sub(GROWTH_WINDOWS)..at)
        .map(|k| scores[(k + GROWTH_WINDOWS).min(at)] / scores[k].max(1.0))
        .fold(1.0, f64::max);
    let (mut least, mut regrowth) = (f64::INFINITY, 1.0_f64);
    for score in &scores[at.min(arrival + 1)..windows.end.max(at + 1)] {
        least = least.min(*score);
        if *score >= REGROWN_LEAST * scores[at] {
            regrowth = regrowth.max(score / least);
        }
    }
    let arrival_s = levels.time_s(arrival);
    let end_s = match ends {
        true => levels.time_s(windows.end),
        false => record.duration_s(),
    };
    let [from, to] = [arrival_s, end_s].map(|at_s| ((at_s * rate_hz) as usize).min(record.length()));
    if to <= from {
        return None;
    }
    let shaken: Vec<&[f64]> = levels.steady.iter().map(|own| &own[from..to]).collect();
    let weights: Vec<(usize, f64)> = match inputs {
        [] => (0..shaken.len()).collect(),
        _ => inputs.to_vec(),
    }
    .into_iter()
    .filter(|c| levels.noise[*c] > 0.0)
    .map(|c| (c, levels.noise[c].powi(-2)))
    .collect();
    let [strong_from, strong_to] = husid(&shaken, &weights);
    let peak = |of: Quantity| {
        let own = (0..shaken.len()).filter(|c| record.channels()[*c].quantity == of);
        own.flat_map(|c| shaken[c].iter().map(|x| x.abs()))
            .reduce(f64::max)
    };
    Some(Features {
        latest_peak_s: latest_peak_s(&shaken, levels),
        regrowth,
        in_lines: in_lines(&shaken, levels),
        low_growth: low_growth(levels, [from, from + strong_to], to),
        peak_m_s2: peak(Quantity::Acceleration),
        peak_m_s: peak(Quantity::Velocity),
        shaking: Shaking {
            kind: ShakingKind::Earthquake,
            arrival_s,
            strong_from_s: arrival_s + strong_from as f64 / rate_hz,
            strong_to_s: arrival_s + strong_to as f64 / rate_hz,
            end_s,
            ends: *ends,
            over_noise: scores[at],
            growth,
        },
    })
}

/// Time from the first sample above the noise on any channel to the peak of the channel with the latest peak, s.
fn latest_peak_s(shaken: &[&[f64]], levels: &Levels) -> f64 {
    let noise = &levels.noise;
    let samples = shaken.first().map_or(0, |own| own.len());
    let is_above = |t: &usize| levels.live().any(|c| shaken[c][*t].abs() > BEGINS * noise[c]);
    let begins = (0..samples).find(is_above).unwrap_or(0);
    let peak_of = |c: usize| {
        let each = shaken[c][begins..].iter().map(|x| x.abs()).enumerate();
        each.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most })
            .0
    };
    levels.live().map(peak_of).max().unwrap_or(0) as f64 / levels.rate_hz
}

/// Fraction of the power in the highest spectral lines, for the channel with the smallest fraction.
fn in_lines(shaken: &[&[f64]], levels: &Levels) -> f64 {
    let length = shaken.first().map_or(0, |own| own.len()).max(2);
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let share = |c: usize| {
        let mut part = shaken[c].to_vec();
        part.resize(length, 0.0);
        let mut lines = transform.make_output_vec();
        // the buffers have the required lengths
        let _ = transform.process(&mut part, &mut lines);
        let mut power: Vec<f64> = lines.iter().map(|line| line.norm_sqr()).collect();
        let (all, mut high) = (power.iter().sum::<f64>(), 0.0);
        for _ in 0..LINES {
            let Some(at) = peak_of(&power, &[]) else { break };
            let near = at.saturating_sub(BESIDE)..(at + BESIDE + 1).min(power.len());
            high += power[near.clone()].iter().sum::<f64>();
            power[near].fill(0.0);
        }
        high / all.max(f64::MIN_POSITIVE)
    };
    levels.live().map(share).fold(1.0, f64::min)
}

/// RMS from 0.5 to 2 Hz in the strong phase over that of the quiet part before it, or otherwise after it. A quarter of the channels may have a
/// smaller ratio.
fn low_growth(levels: &Levels, [from, strong_to]: [usize; 2], end: usize) -> Option<f64> {
    let of_s = |s: f64| (s * levels.rate_hz) as usize;
    let length = levels.steady.first().map_or(0, Vec::len);
    let strong = from..strong_to.max(from + of_s(STRONG_LEAST_S)).min(length);
    let apart = of_s(APART_S);
    let before = from.saturating_sub(apart + of_s(QUIET_MOST_S))..from.saturating_sub(apart);
    let after = (end + apart).min(length)..(end + apart + of_s(QUIET_MOST_S)).min(length);
    let least = of_s(QUIET_LEAST_S).max(1);
    let quiet = [before, after].into_iter().find(|span| span.len() >= least)?;
    if levels.rate_hz < RATE_LEAST_HZ || strong.len() < 16 {
        return None;
    }
    let growth = |c: usize| {
        let [shaken, still] =
            [&strong, &quiet].map(|span| low_power(&levels.steady[c][span.clone()], levels.rate_hz));
        (still > 0.0).then(|| (shaken / still).sqrt())
    };
    let mut each: Vec<f64> = levels.live().filter_map(growth).collect();
    each.sort_by(f64::total_cmp);
    each.get((MISSING * each.len() as f64) as usize).copied()
}

/// Mean power per spectral line from 0.5 to 2 Hz (Hann window).
fn low_power(part: &[f64], rate_hz: f64) -> f64 {
    let n = part.len() as f64;
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(part.len());
    let window = |(t, x): (usize, &f64)| x * (PI * (t as f64 + 0.5) / n).sin().powi(2);
    let mut windowed: Vec<f64> = part.iter().enumerate().map(window).collect();
    let mut lines = transform.make_output_vec();
    // the buffers have the required lengths
    let _ = transform.process(&mut windowed, &mut lines);
    let [low, high] = LOW_HZ.map(|hz| hz * n / rate_hz);
    let (first, last) = (low.ceil() as usize, (high.floor() as usize).min(lines.len() - 1));
    let own = &lines[first.min(last)..=last];
    own.iter().map(|line| line.norm_sqr()).sum::<f64>() / (own.len() as f64 * n)
}

/// Samples after the start of the span at which the fractions of the energy are reached.
fn husid(shaken: &[&[f64]], weights: &[(usize, f64)]) -> [usize; 2] {
    let samples = shaken.first().map_or(0, |own| own.len());
    let mut sum = 0.0;
    let mut sums = Vec::with_capacity(samples);
    let energy = |t: usize| -> f64 {
        let each = weights.iter().map(|(c, w)| w * shaken[*c][t] * shaken[*c][t]);
        each.sum()
    };
    for t in 0..samples {
        sum += energy(t);
        sums.push(sum);
    }
    STRONG.map(|share| sums.partition_point(|of| *of < share * sum))
}
