//! Distinguishes sines from modes by the finest spectral lines of a record: a sine keeps its phase throughout, a mode does not.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | P_i | `power` | periodogram of the whole record (Hann) along the shape, lines 1/T apart | |
//! | w | `half_width` | half of the half-power width of a mode, ζ f T | lines |
//! | m_i | `model` | expected P_i: a mode over white noise, S (1/(1 + ((i − c)/w)²) + β) | |
//! | Λ | `gain` | increase of Whittle's log-likelihood by a sine at one line | – |

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
/// The same against a second mode of any width down to 1.5 lines, in a wider range of lines. Our choice: sines as strong as a simulated mode of 45 lines
/// gave 20 to 25, those of a quarter of its power 9 to 13.
const STRICT_GAIN_LEAST: f64 = 15.0;
/// Least ratio of a mode at a sine to the surrounding noise, and least width of the mode in lines; below these limits there is no mode.
const MODE_OVER_NOISE: f64 = 10.0;
pub(super) const MODE_WIDE: f64 = 4.0;

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
    /// Hann's window over the record, and its transform, computed when needed.
    hann: Vec<f64>,
    plan: Option<Arc<dyn RealToComplex<f64>>>,
}

impl<'a> FineLines<'a> {
    pub(crate) fn new(record: &'a Record) -> Self {
        FineLines {
            record,
            channels: BTreeMap::new(),
            hann: Vec::new(),
            plan: None,
        }
    }

    fn of_channel(&mut self, c: usize) -> &[Complex64] {
        let (record, hann, plan) = (self.record, &mut self.hann, &mut self.plan);
        self.channels.entry(c).or_insert_with(|| {
            let y = record.samples(c);
            let n = y.len();
            if hann.is_empty() {
                hann.extend((0..n).map(|t| (PI * (t as f64 + 0.5) / n as f64).sin().powi(2)));
            }
            let plan = plan.get_or_insert_with(|| RealFftPlanner::new().plan_fft_forward(n));
            let mean = record.mean(c);
            let mut time: Vec<f64> = y.iter().zip(&*hann).map(|(y, hann)| hann * (y - mean)).collect();
            let mut bins = plan.make_output_vec();
            let _ = plan.process(&mut time, &mut bins); // lengths are the plan's own
            bins.into_iter().map(|z| Complex64::new(z.re, z.im)).collect()
        })
    }

    /// Powers of the lines near the middle line along a shape, and their number on each side; `None` if the record has too few.
    fn about(
        &mut self,
        shape: &[Complex64],
        channels: &[usize],
        middle: usize,
        wished: f64,
    ) -> Option<(usize, Vec<f64>)> {
        let last = self.record.length() / 2;
        let reach = (wished as usize)
            .clamp(REACH[0], REACH[1])
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
        Some((reach, along.iter().map(|z| z.norm_sqr()).collect()))
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
        let (mut reach, mut power) = self.about(&mode.shape, &channels, middle, 2.0 * half_width)?;
        let mut found = judged(&power, Second::Alike)?;
        if SKIRTS * found.half_width > reach as f64 {
            // the noise near a mode is visible only outside the flanks of the mode
            (reach, power) = self.about(&mode.shape, &channels, middle, SKIRTS * found.half_width)?;
            found = judged(&power, Second::Alike)?;
        }
        Some(found.about_a(mode, (middle - reach, &power), duration_s))
    }

    /// The same at a mode from which a strong sine may have taken its width: if the lines near it show a sine but no mode, wider ranges are tried.
    /// There the alternative is a second mode of any width, since the range may hold a neighbour.
    pub(crate) fn test_on_mode(&mut self, mode: &Mode) -> Option<LineTest> {
        let found = self.test(mode)?;
        if found.mode_remains || found.gain < STRICT_GAIN_LEAST {
            return Some(found);
        }
        let channels = seeing_most(mode);
        let duration_s = self.record.length() as f64 / self.record.sampling_rate_hz();
        let middle = (mode.frequency_hz * duration_s).round() as usize;
        let mut wished = 4 * REACH[0];
        while wished <= REACH[1] {
            let Some((reach, power)) = self.about(&mode.shape, &channels, middle, wished as f64) else {
                break;
            };
            let wider = judged(&power, Second::OfAnyWidth)
                .filter(|wider| wider.mode_remains && wider.gain >= STRICT_GAIN_LEAST);
            if let Some(wider) = wider {
                let mut of = wider.about_a(mode, (middle - reach, &power), duration_s);
                of.gain_least = STRICT_GAIN_LEAST;
                return Some(of);
            }
            wished *= 2;
        }
        Some(found)
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

/// The second mode that is the alternative to a sine.
#[derive(Clone, Copy)]
enum Second {
    /// Damped similarly to the first, as neighbouring modes are.
    Alike,
    /// Of any width.
    OfAnyWidth,
}

impl Second {
    /// Half widths to try beside a first mode of this half width.
    fn half_widths(self, first: f64) -> Vec<f64> {
        let (narrowest, times): (f64, &[f64]) = match self {
            // the damping of the second is not much less than that of the first
            Second::Alike => (HALF_WIDTH_LEAST.max(0.8 * first.min(40.0)), &[1.0, 1.5, 2.5, 4.0]),
            Second::OfAnyWidth => (
                HALF_WIDTH_LEAST,
                &[1.0, 1.5, 2.3, 3.4, 5.1, 7.6, 11.4, 17.0, 26.0],
            ),
        };
        times.iter().map(|times| times * narrowest).collect()
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

struct OneMode {
    model: Vec<f64>,
    half_width: f64,
    /// Peak value over the noise.
    over_noise: f64,
    /// S.
    top: f64,
    /// Line of its maximum.
    centre: f64,
}

fn judged(power: &[f64], second: Second) -> Option<Judged> {
    let n = power.len();
    let floor = power.iter().sum::<f64>() / n as f64 * 1e-12;
    if floor <= 0.0 {
        return None;
    }
    let power: Vec<f64> = power.iter().map(|p| p.max(floor)).collect();
    let whole = fitted(&power, &[]);
    // the largest excess over one mode, away from the edges
    let stands_out = |i: &usize| power[*i] / whole.model[*i];
    let mut line = (LOBE + 1..n - LOBE - 1).max_by(|a, b| stands_out(a).total_cmp(&stands_out(b)))?;
    let top = (LOBE + 1..n - LOBE - 1).max_by(|a, b| power[*a].total_cmp(&power[*b]))?;
    if top.abs_diff(line) <= LOBE {
        line = top;
    }
    let mut best = at_line(&power, line, &whole, second);
    if top != line {
        let other = at_line(&power, top, &whole, second);
        if other.gain > best.gain {
            best = other;
        }
    }
    Some(best)
}

fn at_line(power: &[f64], line: usize, whole: &OneMode, second: Second) -> Judged {
    let lobe: Vec<usize> = (line - LOBE..=line + LOBE).collect();
    let rest = fitted(power, &lobe);
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
    for half_width in second.half_widths(rest.half_width) {
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

/// Power of a mode `line`s from its centre, relative to its peak.
fn lorentz(line: usize, centre: f64, half_width: f64) -> f64 {
    1.0 / (1.0 + ((line as f64 - centre) / half_width).powi(2))
}

/// Σ ln v of values between 1e-36 and 1e36, from the logarithms of products of 8.
fn sum_of_logarithms(mut values: impl Iterator<Item = f64>) -> f64 {
    let mut sum = 0.0;
    loop {
        let mut product = 1.0;
        let mut taken = 0;
        for v in values.by_ref().take(8) {
            product *= v;
            taken += 1;
        }
        sum += f64::ln(product);
        if taken < 8 {
            return sum;
        }
    }
}

/// The most likely mode over white noise, fitted without the lines `without`.
fn fitted(power: &[f64], without: &[usize]) -> OneMode {
    let used: Vec<usize> = (0..power.len()).filter(|i| !without.contains(i)).collect();
    // power of the lines before each one, zero for excluded lines
    let mut before = vec![0.0];
    for (i, p) in power.iter().enumerate() {
        before.push(before[i] + if without.contains(&i) { 0.0 } else { *p });
    }
    let (mut least, mut best) = (f64::INFINITY, (0.0, HALF_WIDTH_LEAST, 1.0, 0.0));
    let mut half_width = HALF_WIDTH_LEAST;
    while half_width < power.len() as f64 {
        let smooth = half_width.ceil() as usize;
        let sum = |i: usize| before[(i + smooth + 1).min(power.len())] - before[i.saturating_sub(smooth)];
        let middle = used
            .iter()
            .copied()
            .max_by(|a, b| sum(*a).total_cmp(&sum(*b)))
            .unwrap_or(0);
        for shift in [-0.8, -0.4, 0.0, 0.4, 0.8] {
            let c = middle as f64 + shift * half_width;
            let mode: Vec<f64> = used.iter().map(|&i| lorentz(i, c, half_width)).collect();
            for step in 0..=8 {
                let beta = 10f64.powf(1.0 - 0.6 * f64::from(step));
                let shape = mode.iter().map(|mode| mode + beta);
                let s = used
                    .iter()
                    .zip(shape.clone())
                    .map(|(&i, shape)| power[i] / shape)
                    .sum::<f64>()
                    / used.len() as f64;
                let cost = used.len() as f64 * s.ln() + sum_of_logarithms(shape);
                if cost < least {
                    (least, best) = (cost, (c, half_width, beta, s));
                }
            }
        }
        half_width *= 1.5;
    }
    let (c, half_width, beta, s) = best;
    OneMode {
        model: (0..power.len())
            .map(|i| s * (lorentz(i, c, half_width) + beta))
            .collect(),
        half_width,
        over_noise: 1.0 / beta,
        top: s,
        centre: c,
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
