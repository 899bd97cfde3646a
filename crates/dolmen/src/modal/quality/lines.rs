//! Distinguishes sines from modes by the finest spectral lines of a record: a sine keeps its phase throughout, a mode does not.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | P_i | `power` | periodogram of the whole record (Hann) along the shape, lines 1/T apart | |
//! | w | `half_width` | half of the half-power width of a mode, ζ f T | lines |
//! | m_i | `model` | expected P_i: a mode over white noise, S (1/(1 + ((i − c)/w)²) + β) | |
//! | Λ | `gain` | increase of Whittle's log-likelihood by a sine at one line | – |

use super::half_lines::of_halves;
use super::one_mode::{MODE_OVER_NOISE, MODE_WIDE, OneMode, fitted, floored, lorentz, sum_of_logarithms};
use super::sines::{BESIDE_MOST, best_sine, taper};
use crate::modal::Mode;
use crate::modal::subspace::HALF_WIDTH_LEAST;
use crate::signal::Record;
use dolmen_linalg::Complex64;
use realfft::{RealFftPlanner, RealToComplex};
use std::collections::BTreeMap;
use std::f64::consts::PI;
use std::sync::Arc;

/// Fewest and most lines on each side of the frequency.
const REACH: [usize; 2] = [64, 512];
/// Number of half widths on each side of a mode within which it exceeds the noise.
const SKIRTS: f64 = 4.0;
/// Lines on each side of a sine in the main lobe of Hann's window.
const LOBE: usize = 2;
/// A line is a sine from this gain on. Chosen on the development seeds of `unkind_modes`: neighbouring lines share two thirds of their amplitude
/// under Hann's window, so a chance excess at one line counts about three times.
const GAIN_LEAST: f64 = 30.0;
/// The same by the phases of independent lines: 8 was the largest of 160 simulated modes of 2 to 20 lines without a sine, and sines with 20 and 66 times the
/// power of a line of their mode, of 4 to 20 lines, gave 15 and 25 in the median. Of 374 modes and peaks without a sine in 250 simulated records with the
/// faults of the field 2 reach 12 with the least strength: a mode, 13, and a peak of two modes, 23. So a peak that is no mode needs more.
const PHASE_GAIN_LEAST: f64 = 12.0;
const PHASE_GAIN_AT_PEAK: f64 = 25.0;
/// The same in one half of the record, where two places are tried: in 250 simulated records with the faults of the field the largest at modes without a
/// sine is 13.4, and sines that run for 38, 69 and 78 % of the time gave 29, 20 and 58.
const PHASE_GAIN_IN_HALF: f64 = 15.0;
/// Least power of a sine over that of its mode: a weaker one takes less than a tenth of the damping ratio.
const STRENGTH_LEAST: f64 = 0.1;
/// Least number of half widths of a mode on each side where other modes leave no more room.
const SKIRTS_LEAST: f64 = 1.5;

/// A sine stands for a mode if it leaves less than this at it, over the lines beside it. On the development seeds of `unkind_modes` the sines that stand
/// for modes leave 0.2 to 1.5, and near 15 modes it is less than 2, but the gain there at most 6, or the sine 8 half widths off.
pub(super) const LEAVES_MOST: f64 = 2.0;
/// Largest distance of such a sine from the mode, half widths and lines (poles lie between the sine and what is beside it), and between the results by power
/// and by phase, lines. Our choice.
const NEAR_HALF_WIDTHS: f64 = 2.0;
const NEAR_LINES: f64 = 4.0;
const SAME_LINES: f64 = 1.5;

/// Result of the finest spectral lines for a peak or mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct LineTest {
    /// Frequency of the line with the largest excess, Hz.
    pub(crate) frequency_hz: f64,
    /// Gain Λ of a sine at this frequency.
    pub(crate) gain: f64,
    /// Gain from which it is a sine.
    pub(crate) gain_least: f64,
    /// Damping ratio of the mode that fits the lines without the sine.
    pub(crate) damping_ratio: f64,
    /// Power of the sine over that of this mode.
    pub(crate) strength: f64,
    /// Whether a mode remains without the sine.
    pub(crate) mode_remains: bool,
}

impl LineTest {
    pub(crate) fn is_sine(&self) -> bool {
        self.gain >= self.gain_least
    }
}

/// Spectra of whole channels, computed at first use.
pub(crate) struct FineLines<'a> {
    record: &'a Record,
    channels: BTreeMap<usize, Vec<Complex64>>,
    /// Weight at a place from 0 to 1 of the record, these weights, and the transform, computed when needed.
    window: fn(f64) -> f64,
    weights: Vec<f64>,
    plan: Option<Arc<dyn RealToComplex<f64>>>,
}

impl<'a> FineLines<'a> {
    /// Under Hann's window, for sines and modes of any strength.
    pub(crate) fn new(record: &'a Record) -> Self {
        FineLines::under(|at| (PI * at).sin().powi(2), record)
    }

    /// Independent lines: only the ends are tapered.
    pub(crate) fn independent(record: &'a Record) -> Self {
        FineLines::under(taper, record)
    }

    fn under(window: fn(f64) -> f64, record: &'a Record) -> Self {
        FineLines {
            record,
            channels: BTreeMap::new(),
            window,
            weights: Vec::new(),
            plan: None,
        }
    }

    fn of_channel(&mut self, c: usize) -> &[Complex64] {
        let (record, window, weights, plan) = (self.record, self.window, &mut self.weights, &mut self.plan);
        self.channels.entry(c).or_insert_with(|| {
            let y = record.samples(c);
            let n = y.len();
            if weights.is_empty() {
                weights.extend((0..n).map(|t| window((t as f64 + 0.5) / n as f64)));
            }
            let plan = plan.get_or_insert_with(|| RealFftPlanner::new().plan_fft_forward(n));
            let mean = record.mean(c);
            let mut time: Vec<f64> = y.iter().zip(&*weights).map(|(y, w)| w * (y - mean)).collect();
            let mut bins = plan.make_output_vec();
            let _ = plan.process(&mut time, &mut bins); // lengths are the plan's own
            bins.into_iter().map(|z| Complex64::new(z.re, z.im)).collect()
        })
    }

    /// The lines near the middle line along a shape, and their number on each side; `None` if the record has too few.
    fn about(
        &mut self,
        shape: &[Complex64],
        channels: &[usize],
        middle: usize,
        wished: usize,
    ) -> Option<(usize, Vec<Complex64>)> {
        let last = self.record.length() / 2;
        let reach = wished
            .min(middle.saturating_sub(4))
            .min(last.saturating_sub(middle + 1));
        if reach < REACH[0] / 4 {
            return None;
        }
        let mut along = vec![Complex64::ZERO; 2 * reach + 1];
        for &c in channels {
            let weight = shape[c].conj();
            let bins = &self.of_channel(c)[middle - reach..=middle + reach];
            along.iter_mut().zip(bins).for_each(|(sum, z)| *sum += weight * z);
        }
        Some((reach, along))
    }

    /// Their powers, of as many lines as wished within bounds.
    fn power_about(
        &mut self,
        shape: &[Complex64],
        channels: &[usize],
        middle: usize,
        wished: f64,
    ) -> Option<(usize, Vec<f64>)> {
        let wished = (wished as usize).clamp(REACH[0], REACH[1]);
        let (reach, along) = self.about(shape, channels, middle, wished)?;
        Some((reach, along.iter().map(|z| z.norm_sqr()).collect()))
    }

    /// The sine that the phases of independent lines show on a mode, or on a peak that is none, if chance does not explain it and a mode remains;
    /// `nearest_hz` is the distance to the nearest other mode. Ranges grow until they hold the mode and noise beside it, as far as other modes leave room.
    pub(crate) fn sine_on(&mut self, mode: &Mode, nearest_hz: f64, is_peak: bool) -> Option<LineTest> {
        let line_hz = self.record.sampling_rate_hz() / self.record.length() as f64;
        let channels = seeing_most(mode);
        let middle = (mode.frequency_hz / line_hz).round() as usize;
        let room = ((0.5 * nearest_hz / line_hz) as usize).clamp(REACH[0] / 4, REACH[1] / 2);
        let mut wished = REACH[0];
        loop {
            let (reach, lines) = self.about(&mode.shape, &channels, middle, wished.min(room))?;
            let sine = best_sine(&lines);
            let is_whole = sine
                .as_ref()
                .is_some_and(|sine| SKIRTS * sine.half_width <= reach as f64);
            if !is_whole && reach == wished {
                wished *= 2;
                continue;
            }
            let sine = sine.filter(|sine| SKIRTS_LEAST * sine.half_width <= reach as f64)?;
            let least = phase_gain_least(is_peak);
            let is_clear = sine.mode_remains && sine.strength >= STRENGTH_LEAST && sine.gain >= least;
            return is_clear.then(|| LineTest {
                frequency_hz: ((middle - reach) as f64 + sine.line) * line_hz,
                gain: sine.gain,
                gain_least: least,
                damping_ratio: sine.half_width * line_hz / mode.frequency_hz,
                strength: sine.strength,
                mode_remains: true,
            });
        }
    }

    /// The same for a sine that runs in one half of the record; its strength is that over the whole record if it does not run in the other.
    pub(crate) fn sine_in_half(&mut self, mode: &Mode, nearest_hz: f64) -> Option<LineTest> {
        let line_hz = self.record.sampling_rate_hz() / self.record.length() as f64;
        let at = mode.frequency_hz / line_hz;
        let half_width = mode.damping_ratio.unwrap_or(0.0) * at;
        if half_width < MODE_WIDE {
            return None; // in half of the lines it looks like a sine
        }
        let room = ((0.5 * nearest_hz / line_hz) as usize).min(REACH[1]);
        let wished = ((2.0 * SKIRTS * half_width) as usize).max(2 * REACH[0]).min(room);
        let middle = at.round() as usize;
        let (_, whole) = self.about(&mode.shape, &seeing_most(mode), middle, wished)?;
        let each = of_halves(&whole).into_iter().filter_map(|half| {
            let inner = half.lines.len() / 2;
            let sine = best_sine(&half.lines)?;
            let strength = 0.5 * sine.strength;
            let is_clear = sine.mode_remains
                && SKIRTS_LEAST * sine.half_width <= inner as f64
                && strength >= STRENGTH_LEAST;
            let from_middle = (sine.line - inner as f64) * half.apart;
            (is_clear && sine.gain >= PHASE_GAIN_IN_HALF).then(|| LineTest {
                frequency_hz: (middle as f64 + from_middle) * line_hz,
                gain: sine.gain,
                gain_least: PHASE_GAIN_IN_HALF,
                damping_ratio: sine.half_width * half.apart * line_hz / mode.frequency_hz,
                strength,
                mode_remains: true,
            })
        });
        each.max_by(|a, b| a.gain.total_cmp(&b.gain))
    }

    /// What remains of a mode, or of a peak that is none, without the sine that the power shows near it, over the lines beside it; `None` if the phases
    /// do not show the same sine.
    pub(crate) fn left_by(&mut self, by_power: &LineTest, mode: &Mode, is_peak: bool) -> Option<f64> {
        let line_hz = self.record.sampling_rate_hz() / self.record.length() as f64;
        let (at, sine_at) = (mode.frequency_hz / line_hz, by_power.frequency_hz / line_hz);
        let half_width = mode.damping_ratio.unwrap_or(0.0) * at;
        if (sine_at - at).abs() > NEAR_HALF_WIDTHS * half_width + NEAR_LINES {
            return None;
        }
        let middle = at.round() as usize;
        let wished = ((BESIDE_MOST * half_width) as usize).clamp(REACH[0], REACH[1] / 2);
        let (reach, lines) = self.about(&mode.shape, &seeing_most(mode), middle, wished)?;
        let sine = best_sine(&lines)?;
        let first = (middle - reach) as f64;
        let is_same = (first + sine.line - sine_at).abs() <= SAME_LINES;
        (is_same && sine.gain >= phase_gain_least(is_peak)).then(|| sine.leaves(at - first, half_width))
    }

    /// Whether there is a sine at a mode, along its shape; `None` if the record has too few lines there.
    ///
    /// ```text
    /// Λ = max_(S, A, w') Σ (ln p₀ of lines under two modes)  against  Σ (ln p₁ of lines under one mode and a sine),  w, w' ≥ 1.5
    /// ```
    /// Under random forces P_i/m_i is exponential with mean 1, also in gusts. The alternative to a sine is a second mode, so two close modes are not
    /// taken for a sine.
    ///
    /// # Source
    /// Whittle (1953) Ark. Mat. 2:423-434 for the likelihood; Fisher (1929) Proc. R. Soc. A 125:54-59 for a line that is too strong for chance.
    /// Differs from Fisher: the surrounding spectrum is that of a mode instead of white.
    pub(crate) fn test(&mut self, mode: &Mode) -> Option<LineTest> {
        let duration_s = self.record.length() as f64 / self.record.sampling_rate_hz();
        let channels = seeing_most(mode);
        let middle = (mode.frequency_hz * duration_s).round() as usize;
        let half_width = mode.damping_ratio.unwrap_or(0.0) * mode.frequency_hz * duration_s;
        let (mut reach, mut power) = self.power_about(&mode.shape, &channels, middle, 2.0 * half_width)?;
        let mut found = judged(&power)?;
        if SKIRTS * found.half_width > reach as f64 {
            // the noise near a mode is visible only outside the flanks of the mode
            (reach, power) = self.power_about(&mode.shape, &channels, middle, SKIRTS * found.half_width)?;
            found = judged(&power)?;
        }
        Some(found.about_a(mode, (middle - reach, &power), duration_s))
    }
}

fn phase_gain_least(is_peak: bool) -> f64 {
    match is_peak {
        true => PHASE_GAIN_AT_PEAK,
        false => PHASE_GAIN_LEAST,
    }
}

/// Position of a sine between two lines, from Hann's main lobe: the neighbouring amplitudes are 1 and (1 + δ)/(2 − δ).
fn offset(power: &[f64], line: usize) -> f64 {
    let amplitude = |i: usize| power.get(i).copied().unwrap_or(0.0).sqrt();
    let (before, at, after) = (
        line.checked_sub(1).map_or(0.0, amplitude),
        amplitude(line),
        amplitude(line + 1),
    );
    let ratio = after.max(before) / at.max(f64::MIN_POSITIVE);
    let delta = ((2.0 * ratio - 1.0) / (ratio + 1.0)).clamp(0.0, 0.5);
    if after > before { delta } else { -delta }
}

struct Judged {
    line: usize,
    gain: f64,
    half_width: f64,
    strength: f64,
    mode_remains: bool,
}

impl Judged {
    /// The result for a mode; `first` is the number of the first line of `power`.
    fn about_a(&self, mode: &Mode, (first, power): (usize, &[f64]), duration_s: f64) -> LineTest {
        let line_hz = 1.0 / duration_s;
        LineTest {
            frequency_hz: (first as f64 + self.line as f64 + offset(power, self.line)) * line_hz,
            gain: self.gain,
            gain_least: GAIN_LEAST,
            damping_ratio: self.half_width * line_hz / mode.frequency_hz,
            strength: self.strength,
            mode_remains: self.mode_remains,
        }
    }
}

/// The sensors with the largest motion in a mode.
pub(super) fn seeing_most(mode: &Mode) -> Vec<usize> {
    const CHANNELS: usize = 4;
    let mut channels: Vec<usize> = (0..mode.shape.len()).collect();
    channels.sort_by(|&a, &b| mode.shape[b].norm().total_cmp(&mode.shape[a].norm()));
    channels.truncate(CHANNELS);
    channels
}

fn judged(power: &[f64]) -> Option<Judged> {
    let n = power.len();
    let power = floored(power.to_vec())?;
    let whole = fitted(&power, &[], HALF_WIDTH_LEAST);
    // the largest excess over one mode, away from the edges
    let stands_out = |i: &usize| power[*i] / whole.model[*i];
    let mut line = (LOBE + 1..n - LOBE - 1).max_by(|a, b| stands_out(a).total_cmp(&stands_out(b)))?;
    let top = (LOBE + 1..n - LOBE - 1).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    if top.abs_diff(line) <= LOBE {
        line = top;
    }
    let mut best = at_line(&power, line, &whole);
    if top != line {
        let other = at_line(&power, top, &whole);
        if other.gain > best.gain {
            best = other;
        }
    }
    Some(best)
}

fn at_line(power: &[f64], line: usize, whole: &OneMode) -> Judged {
    let lobe: Vec<usize> = (line - LOBE..=line + LOBE).collect();
    let rest = fitted(power, &lobe, HALF_WIDTH_LEAST);
    let near = |i: usize| i.abs_diff(line) <= 24;
    let cost = |p: f64, m: f64| m.ln() + p / m;
    let with_sine: f64 = (0..power.len())
        .filter(|i| near(*i))
        .map(|i| {
            if lobe.contains(&i) {
                rest.model[i].ln() + 1.0
            } else {
                cost(power[i], rest.model[i])
            }
        })
        .sum();
    let around: Vec<usize> = (0..power.len()).filter(|i| near(*i)).collect();
    let ln_rest: f64 = around.iter().map(|&i| rest.model[i].ln()).sum();
    let mut with_mode = f64::INFINITY;
    for times in [1.0, 1.5, 2.5, 4.0] {
        // the damping of the second is not much less than that of the first
        let half_width = times * HALF_WIDTH_LEAST.max(0.8 * rest.half_width.min(40.0));
        for shift in [-1.0, -0.5, 0.0, 0.5, 1.0] {
            let second: Vec<f64> = around
                .iter()
                .map(|&i| lorentz(i, line as f64 + shift, half_width) / rest.model[i])
                .collect();
            for step in 0..=20 {
                let size = power[line] * 10f64.powf(0.4 - 0.125 * f64::from(step));
                let over_rest = second.iter().map(|second| 1.0 + size * second);
                let share: f64 = around
                    .iter()
                    .zip(over_rest.clone())
                    .map(|(&i, over)| power[i] / (rest.model[i] * over))
                    .sum();
                with_mode = with_mode.min(ln_rest + sum_of_logarithms(over_rest) + share);
            }
        }
    }
    let alone: f64 = around.iter().map(|&i| cost(power[i], whole.model[i])).sum();
    // Hann's window spreads a line of power P over lines with the sum 1.5 P
    let sine: f64 = lobe.iter().map(|&i| (power[i] - rest.model[i]).max(0.0)).sum();
    Judged {
        line,
        gain: with_mode.min(alone) - with_sine,
        half_width: rest.half_width,
        strength: sine / (PI * rest.half_width * rest.top).max(f64::MIN_POSITIVE),
        mode_remains: rest.over_noise >= MODE_OVER_NOISE
            && rest.half_width >= MODE_WIDE
            && (rest.centre - line as f64).abs() <= 1.5 * rest.half_width.max(3.0),
    }
}

#[cfg(test)]
mod tests {
    use crate::modal::{Identify, MadeMode, MadeRecord, Note, identify};
    use crate::signal::Record;
    use std::f64::consts::PI;

    /// Ten minutes of four floors; a sine at 6.2 Hz along the shape of the mode at 6.233 Hz, with `strength` times its power.
    fn named_hz(strength: f64, seed: u64) -> Option<f64> {
        let mode = |(frequency_hz, shape): (f64, [f64; 4])| MadeMode {
            frequency_hz,
            damping_ratio: 0.012,
            shape: shape.to_vec(),
        };
        let second = [0.79, 1.0, 0.22, -0.98];
        let all = [
            (2.312, [0.28, 0.57, 0.83, 1.0]),
            (6.233, second),
            (9.498, [-0.84, -0.09, 1.0, -0.54]),
        ];
        let made = MadeRecord {
            modes: all.map(mode).to_vec(),
            duration_s: 600.0,
            seed,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let alone = MadeRecord {
            modes: made.modes[1..2].to_vec(),
            noise_ratio: 0.0,
            ..made
        };
        let size = (2.0 * strength * alone.make().unwrap().mean_square(1)).sqrt();
        let rate_hz = record.sampling_rate_hz();
        let samples = second.iter().enumerate().map(|(c, share)| {
            let sine = |t: usize| size * share * (2.0 * PI * 6.2 * t as f64 / rate_hz).sin();
            let all = record.samples(c).iter().enumerate();
            all.map(|(t, y)| y + sine(t)).collect()
        });
        let record = Record::new(record.channels().to_vec(), samples.collect(), rate_hz).unwrap();
        let found = identify(&record, &Identify::default()).unwrap();
        found.notes.iter().find_map(|note| match note {
            Note::TonesOnModes { tones } => Some(tones[0].frequency_hz),
            _ => None,
        })
    }

    #[test]
    fn holds_a_sine_that_takes_the_width_of_its_mode_is_named() {
        let named = (0..4).filter_map(|seed| named_hz(1.5, seed));
        let named: Vec<f64> = named.collect();
        assert!(
            named.len() >= 3 && named.iter().all(|hz| (hz - 6.2).abs() < 5e-4),
            "{named:?}"
        );
        assert_eq!((4..8).find_map(|seed| named_hz(0.0, seed)), None);
    }
}
