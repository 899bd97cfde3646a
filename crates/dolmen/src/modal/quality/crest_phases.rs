//! Phases between channels at the crests of their spectra.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S_ab | | cross spectral density of two channels | – |
//! | γ² | `coherence` | \|S_ab\|² / (S_aa S_bb) of a line | – |
//! | u | `twice` | S_ab² / \|S_ab\|² times the weight of the line: twice the phase, so that the sign of a shape has no effect | – |
//! | w | `weight` | γ² above its bias, 0 to 1 | – |

use super::shape_checks::order;
use crate::signal::{CrossSpectra, Record, Welch, cross_spectra};
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// Length of a segment, s, and fewest lengths in a record. Our choice: a delay of 2 s is short beside it.
const SEGMENT_S: f64 = 30.0;
const SEGMENTS_LEAST: f64 = 16.0;
/// A line is at a crest if its power is at least this share of the largest within this ratio of frequencies. Our choice.
const CREST: f64 = 0.5;
const AROUND: f64 = 1.12;
/// First line used, and highest frequency over half the sampling rate: sampling and filters against aliasing turn the phases above it.
const FIRST_LINE: usize = 4;
const NYQUIST_SHARE: f64 = 0.84;
/// Independent segments over segments, which overlap by half, and smallest significant γ² over its mean without coherence. Our choice.
const INDEPENDENT: f64 = 0.55;
const SIGNIFICANT: f64 = 3.0;
/// Lines at a larger distance belong to different bands: over the frequency, and Hz. Our choice.
const APART: f64 = 0.1;
const APART_HZ: f64 = 0.2;
/// Fewest fully coherent lines of a band. Our choice.
const BAND_LINES: f64 = 1.0;
/// Scatter of a mean over neighbouring lines of Hann's window, over that of independent lines: 1 + 2 (4/9) + 2 (1/36).
const NEIGHBOURS: f64 = 1.94;

/// Spectra of all channels, and the lines at their crests.
pub(super) struct Crests {
    spectra: CrossSpectra,
    lines: Vec<usize>,
    orders: Vec<Option<i32>>,
}

/// Phases of one channel relative to others, line by line.
#[derive(Clone)]
pub(super) struct Turns {
    frequency_hz: Vec<f64>,
    twice: Vec<Complex64>,
    weight: Vec<f64>,
}

impl Crests {
    /// `None` if the record is too short.
    pub(super) fn of(record: &Record) -> Option<Crests> {
        let rate_hz = record.sampling_rate_hz();
        let seconds = SEGMENT_S.min(record.duration_s() / SEGMENTS_LEAST);
        let segment_length = 2 * (0.5 * seconds * rate_hz).round() as usize;
        let spectra = cross_spectra(record, &Welch { segment_length }).ok()?;
        let power = whitened_power(&spectra);
        let last = (NYQUIST_SHARE * (power.len() - 1) as f64) as usize;
        let is_crest = |line: &usize| {
            let from = (*line as f64 / AROUND) as usize;
            let to = ((*line as f64 * AROUND) as usize + 1).min(power.len() - 1);
            power[*line] >= CREST * power[from..=to].iter().copied().fold(0.0, f64::max)
        };
        let lines = (FIRST_LINE..=last).filter(is_crest).collect();
        let orders = record.channels().iter().map(|c| order(c.quantity)).collect();
        Some(Crests {
            spectra,
            lines,
            orders,
        })
    }

    /// Phases of channel `a` relative to `b`. A known difference of their quantities is taken off.
    pub(super) fn turns(&self, a: usize, b: usize) -> Turns {
        let bias = 1.0 / (INDEPENDENT * self.spectra.segments as f64);
        let least = SIGNIFICANT * bias;
        let sign = match (self.orders[a], self.orders[b]) {
            (Some(a), Some(b)) if (a - b) % 2 != 0 => -1.0,
            _ => 1.0,
        };
        let mut all = Turns::none(self);
        for (i, &line) in self.lines.iter().enumerate() {
            let density = |a: usize, b: usize| self.spectra.density(a, b, line);
            let (cross, powers) = (density(a, b), density(a, a).re * density(b, b).re);
            let coherence = cross.norm_sqr() / powers.max(f64::MIN_POSITIVE);
            if coherence > least && coherence.is_finite() {
                all.weight[i] = (coherence - least) / (1.0 - least);
                all.twice[i] = cross * cross / cross.norm_sqr() * (sign * all.weight[i]);
            }
        }
        all
    }

    /// Sum of the phases of channel `a` relative to each of `others`.
    pub(super) fn turns_against(&self, a: usize, others: &[usize]) -> Turns {
        let mut all = Turns::none(self);
        for &b in others {
            let one = self.turns(a, b);
            for i in 0..all.weight.len() {
                all.weight[i] += one.weight[i];
                all.twice[i] += one.twice[i];
            }
        }
        all
    }
}

/// Sum of the powers of all channels, each scaled to the same total.
fn whitened_power(spectra: &CrossSpectra) -> Vec<f64> {
    let mut sum = vec![0.0; spectra.frequency_hz.len()];
    for c in 0..spectra.channels() {
        let own = spectra.power(c);
        let total = own.iter().sum::<f64>().max(f64::MIN_POSITIVE);
        sum.iter_mut().zip(&own).for_each(|(sum, p)| *sum += p / total);
    }
    sum
}

impl Turns {
    fn none(crests: &Crests) -> Turns {
        let lines = crests.lines.len();
        let of = |line: &usize| crests.spectra.frequency_hz[*line];
        Turns {
            frequency_hz: crests.lines.iter().map(of).collect(),
            twice: vec![Complex64::ZERO; lines],
            weight: vec![0.0; lines],
        }
    }

    /// Fully coherent lines with these phases, rad, at these frequencies, Hz.
    #[cfg(test)]
    pub(super) fn made(lines: impl Iterator<Item = (f64, f64)>) -> Turns {
        let (phase, frequency_hz): (Vec<f64>, Vec<f64>) = lines.unzip();
        Turns {
            weight: vec![1.0; phase.len()],
            twice: phase
                .iter()
                .map(|phase| Complex64::from_polar(1.0, 2.0 * phase))
                .collect(),
            frequency_hz,
        }
    }

    /// Sum of the weights: the number of fully coherent lines.
    pub(super) fn total(&self) -> f64 {
        self.weight.iter().sum()
    }

    /// Mean of cos 2(φ − 2πfτ), −1 to 1: 1 if the delay τ explains every phase.
    pub(super) fn level(&self, delay_s: f64) -> f64 {
        let back = |(u, f): (&Complex64, &f64)| (u * Complex64::from_polar(1.0, -2.0 * TAU * f * delay_s)).re;
        self.twice.iter().zip(&self.frequency_hz).map(back).sum::<f64>() / self.total()
    }

    /// Levels at the delays k `step_s`, k = −`steps` … `steps`.
    pub(super) fn levels(&self, step_s: f64, steps: i64) -> Vec<f64> {
        let total = self.total();
        let seen: Vec<usize> = (0..self.weight.len()).filter(|&i| self.weight[i] > 0.0).collect();
        let turn = |i: &usize, times: f64| {
            Complex64::from_polar(1.0, -2.0 * TAU * self.frequency_hz[*i] * step_s * times)
        };
        let step: Vec<Complex64> = seen.iter().map(|i| turn(i, 1.0)).collect();
        let start = |i: &usize| self.twice[*i] * turn(i, -steps as f64);
        let mut now: Vec<Complex64> = seen.iter().map(start).collect();
        (-steps..=steps)
            .map(|_| {
                let level = now.iter().map(|u| u.re).sum::<f64>() / total;
                now.iter_mut().zip(&step).for_each(|(u, turn)| *u *= turn);
                level
            })
            .collect()
    }

    /// One step of least squares from a delay, and the standard deviation of the result, s.
    pub(super) fn refined(&self, delay_s: f64) -> [f64; 2] {
        let (mut pull, mut levers, mut square) = (0.0_f64, 0.0_f64, 0.0_f64);
        for ((u, f), w) in self.twice.iter().zip(&self.frequency_hz).zip(&self.weight) {
            if *w > 0.0 {
                let lever = 2.0 * TAU * f;
                let residual = (u * Complex64::from_polar(1.0, -lever * delay_s)).arg();
                pull += u.norm() * lever * residual;
                levers += u.norm() * lever * lever;
                square += (u.norm() * lever * residual).powi(2);
            }
        }
        [delay_s + pull / levers, (NEIGHBOURS * square).sqrt() / levers]
    }

    /// Bands of neighbouring lines.
    pub(super) fn bands(&self) -> Vec<Turns> {
        let mut all: Vec<Vec<usize>> = Vec::new();
        let mut before_hz = f64::NEG_INFINITY;
        for i in (0..self.weight.len()).filter(|&i| self.weight[i] > 0.0) {
            let hz = self.frequency_hz[i];
            match all.last_mut() {
                Some(band) if hz - before_hz <= (APART * before_hz).max(APART_HZ) => band.push(i),
                _ => all.push(vec![i]),
            }
            before_hz = hz;
        }
        let part = |band: Vec<usize>| Turns {
            frequency_hz: band.iter().map(|&i| self.frequency_hz[i]).collect(),
            twice: band.iter().map(|&i| self.twice[i]).collect(),
            weight: band.iter().map(|&i| self.weight[i]).collect(),
        };
        let bands = all.into_iter().map(part);
        bands.filter(|band| band.total() >= BAND_LINES).collect()
    }

    /// Mean frequency, Hz.
    pub(super) fn middle_hz(&self) -> f64 {
        let sum = self.weight.iter().zip(&self.frequency_hz).map(|(w, f)| w * f);
        sum.sum::<f64>() / self.total()
    }

    /// Highest frequency with a known phase, Hz.
    pub(super) fn highest_hz(&self) -> f64 {
        let known = self
            .weight
            .iter()
            .zip(&self.frequency_hz)
            .filter(|(w, _)| **w > 0.0);
        known.map(|(_, f)| *f).fold(0.0, f64::max)
    }
}
