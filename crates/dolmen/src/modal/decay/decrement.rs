//! Frequency and damping of one mode as functions of its amplitude, by the logarithmic decrement of a decay.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | t_k, u_k | `Swing` | time and magnitude of extremum k | s, unit of the channel |
//! | δ | `decay` | slope of ln u over t, ζω | 1/s |
//! | ω_d | `omega_d` | π times the number of extrema per second | rad/s |

use crate::modal::ModalError;
use crate::modal::error::refused;
use crate::numeric::student_two_sided_quantile;
use crate::signal::{Record, band_pass};
use std::f64::consts::PI;

const FILTER_ORDER: usize = 3;
/// Fewest extrema for one value: two full cycles.
const EXTREMA_LEAST: usize = 5;
/// Smallest ratio of an extremum to the noise. Our choice.
const ABOVE_NOISE: f64 = 5.0;

/// Options of [`decrement`].
#[derive(Clone, Debug, PartialEq)]
pub struct Decrement {
    /// Index of the channel; default 0.
    pub channel: usize,
    /// Lower and upper corner of a band that contains only this mode, Hz; `None` (default): no filter.
    pub band_hz: Option<[f64; 2]>,
    /// Number of extrema for each value; default 8 (our choice: four cycles).
    pub extrema: usize,
    /// Standard deviation of the noise in the channel; extrema below five times this value are left out; default 0.
    pub noise: f64,
}

impl Default for Decrement {
    fn default() -> Self {
        Decrement {
            channel: 0,
            band_hz: None,
            extrema: 8,
            noise: 0.0,
        }
    }
}

/// Frequency and damping at one amplitude.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct AtAmplitude {
    /// Mean time of the extrema, s from the first sample.
    pub time_s: f64,
    /// Amplitude of the cycles: exp of the mean of ln u, in the unit of the channel.
    pub amplitude: f64,
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Equivalent damping ratio.
    pub damping_ratio: f64,
    /// Standard deviation of the damping ratio, from the scatter of ln u about a straight line and the number of independent extrema in
    /// the band.
    pub damping_ratio_sd: f64,
    /// Degrees of freedom of that standard deviation: number of independent extrema minus 2; at least 1.
    pub degrees_of_freedom: f64,
}

impl AtAmplitude {
    /// Half width of the 95 % interval of the damping ratio, with Student's quantile, because a value rests on few extrema.
    ///
    /// # Errors
    /// [`ModalError::Numeric`] for degrees of freedom out of range.
    pub fn half_width_95(&self) -> Result<f64, ModalError> {
        Ok(self.damping_ratio_sd * student_two_sided_quantile(0.05, self.degrees_of_freedom)?)
    }
}

/// Frequency and damping of one mode as functions of its amplitude, largest amplitude first.
///
/// ```text
/// ln u_k = c - δ t_k,   k = ω_d t_k/π + c'                      least squares over windows of extrema, which overlap by half
/// ω = √(ω_d² + δ²),   f = ω/2π,   ζ = δ/ω,   σ_ζ = √(c r²/((n − 2) Σ (t − t̄)²))/ω,   c = 2 f/(width of the band), 1 at least
/// ```
/// A parabola through three samples refines each extremum. With a band, the extrema near both ends, within the ringing time (3 over the
/// bandwidth), are left out, because the filter distorts them.
///
/// # Errors
/// [`ModalError::Option`] for an option out of range; [`ModalError::FewSwings`] if there are fewer extrema than one value needs;
/// [`ModalError::Record`] for a band that cannot be filtered.
///
/// # Limits
/// Valid for one mode: another mode in the band causes beats. The error of the parabola in amplitude is 0.1 % at 16 samples per cycle,
/// 10⁻⁵ at 50. Each value is a mean over its extrema, so a sudden transition, for example of a joint that slips above one amplitude, is
/// smoothed.
///
/// # Source
/// Logarithmic decrement: Rayleigh (1877) *The Theory of Sound*, sec. 45; here with extrema of both signs, and in windows.
pub fn decrement(record: &Record, options: &Decrement) -> Result<Vec<AtAmplitude>, ModalError> {
    check(record, options)?;
    let rate_hz = record.sampling_rate_hz();
    let ends_s = options.band_hz.map_or(0.0, |[low, high]| 3.0 / (high - low));
    let swings = match options.band_hz {
        None => extrema(record.samples(options.channel), rate_hz),
        Some([low_hz, high_hz]) => {
            let filtered = band_pass(record.clone(), low_hz, high_hz, FILTER_ORDER)?;
            extrema(filtered.samples(options.channel), rate_hz)
        }
    };
    let last_s = record.duration_s() - ends_s;
    let swings: Vec<Swing> = swings
        .into_iter()
        .filter(|s| s.time_s >= ends_s && s.time_s <= last_s)
        .take_while(|s| s.size > ABOVE_NOISE * options.noise)
        .collect();
    if swings.len() < options.extrema {
        return Err(ModalError::FewSwings {
            extrema: swings.len(),
            needed: options.extrema,
        });
    }
    let windows = swings
        .windows(options.extrema)
        .step_by(options.extrema.div_ceil(2));
    let width_hz = options.band_hz.map(|[low, high]| high - low);
    Ok(windows.map(|swings| over(swings, width_hz)).collect())
}

fn check(record: &Record, options: &Decrement) -> Result<(), ModalError> {
    if options.channel >= record.channels().len() {
        return refused("channel", options.channel as f64, "below the number of channels");
    }
    if options.extrema < EXTREMA_LEAST {
        return refused("extrema", options.extrema as f64, "at least 5");
    }
    if options.noise.is_nan() || options.noise < 0.0 {
        return refused("noise", options.noise, "0 or more");
    }
    if options.noise > 0.0 && options.band_hz.is_none() {
        return refused(
            "noise",
            options.noise,
            "0 without band_hz: noise makes changes of sign that are no swings",
        );
    }
    if let Some([low, high]) = options
        .band_hz
        .filter(|[low, high]| low.partial_cmp(high) != Some(std::cmp::Ordering::Less))
    {
        return refused("band_hz", high - low, "from a lower to a higher frequency");
    }
    Ok(())
}

#[derive(Clone, Copy)]
struct Swing {
    time_s: f64,
    size: f64,
}

/// Extrema of alternating sign: the largest magnitude between two changes of sign.
fn extrema(y: &[f64], rate_hz: f64) -> Vec<Swing> {
    let mut found: Vec<Swing> = Vec::new();
    let mut start = 0;
    while start < y.len() {
        let positive = y[start] > 0.0;
        let end = (start..y.len())
            .find(|&i| (y[i] > 0.0) != positive)
            .unwrap_or(y.len());
        let most = (start..end).reduce(|best, i| if y[i].abs() > y[best].abs() { i } else { best });
        // a half cycle at an end of the record may not contain its extremum
        if let Some(i) = most.filter(|&i| i > 0 && i + 1 < y.len() && start > 0 && end < y.len()) {
            let (a, b, c) = (y[i - 1].abs(), y[i].abs(), y[i + 1].abs());
            let bend = a - 2.0 * b + c;
            let shift = if bend < 0.0 { 0.5 * (a - c) / bend } else { 0.0 };
            found.push(Swing {
                time_s: (i as f64 + shift) / rate_hz,
                size: b - 0.25 * (a - c) * shift,
            });
        }
        start = end;
    }
    found
}

fn over(swings: &[Swing], width_hz: Option<f64>) -> AtAmplitude {
    let n = swings.len() as f64;
    let mean = |of: &dyn Fn(usize, &Swing) -> f64| -> f64 {
        swings.iter().enumerate().map(|(k, s)| of(k, s)).sum::<f64>() / n
    };
    let time_s = mean(&|_, s| s.time_s);
    let ln_size = mean(&|_, s| s.size.ln());
    let middle = 0.5 * (n - 1.0);
    let square = mean(&|_, s| (s.time_s - time_s).powi(2));
    let decay = -mean(&|_, s| (s.time_s - time_s) * (s.size.ln() - ln_size)) / square;
    let omega_d = PI * mean(&|k, s| (s.time_s - time_s) * (k as f64 - middle)) / square;
    let omega = omega_d.hypot(decay);
    let left = mean(&|_, s| (s.size.ln() - ln_size + decay * (s.time_s - time_s)).powi(2)) * n;
    // extrema of noise in a narrow band are correlated
    let alike = width_hz.map_or(1.0, |width_hz| (omega / PI / width_hz).max(1.0));
    let free = (n / alike - 2.0).max(1.0);
    let damping_ratio_sd = (left / n * (n / alike) / free / (n / alike) / square).sqrt() / omega;
    AtAmplitude {
        time_s,
        amplitude: ln_size.exp(),
        frequency_hz: omega / (2.0 * PI),
        damping_ratio: decay / omega,
        damping_ratio_sd,
        degrees_of_freedom: free,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    fn record(y: impl Fn(f64) -> f64, seconds: f64, rate_hz: f64) -> Record {
        let n = (seconds * rate_hz) as usize;
        let y = (0..n).map(|i| y(i as f64 / rate_hz)).collect();
        Record::new(vec![Channel::named("y")], vec![y], rate_hz).unwrap()
    }

    #[test]
    fn exact_decay_has_one_frequency_and_one_damping_at_every_size() {
        let (f, zeta) = (2.0_f64, 0.02);
        let omega = 2.0 * PI * f;
        let y = |t: f64| (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).sin();
        let found = decrement(&record(y, 12.0, 200.0), &Decrement::default()).unwrap();
        assert!(found.len() > 8, "{}", found.len());
        for at in &found {
            assert!((at.frequency_hz / f - 1.0).abs() < 1e-4, "{at:?}");
            assert!((at.damping_ratio / zeta - 1.0).abs() < 1e-3, "{at:?}");
        }
        let ratio = found[0].amplitude / found[1].amplitude;
        let between = found[1].time_s - found[0].time_s;
        assert!((ratio.ln() / (zeta * omega * between) - 1.0).abs() < 1e-3);
    }

    #[test]
    fn exact_frequency_that_follows_the_amplitude() {
        // phase by integration: f(u) = 2 (1 - 0.1 u), u = e^(-0.2 t): φ = 4π (t - 0.5 (1 - e^(-0.2 t)))
        let y = |t: f64| {
            let u = (-0.2 * t).exp();
            u * (4.0 * PI * (t - 0.5 * (1.0 - u))).sin()
        };
        let found = decrement(&record(y, 15.0, 400.0), &Decrement::default()).unwrap();
        for at in &found {
            let truth = 2.0 * (1.0 - 0.1 * at.amplitude);
            assert!((at.frequency_hz / truth - 1.0).abs() < 1e-3, "{at:?} {truth}");
        }
        assert!(
            found[0].frequency_hz < 1.84 && found.last().unwrap().frequency_hz > 1.97,
            "{found:?}"
        );
    }

    #[test]
    fn holds_a_band_takes_another_mode_out() {
        let swing = |f: f64, zeta: f64, t: f64| {
            let omega = 2.0 * PI * f;
            (-zeta * omega * t).exp() * (omega * (1.0 - zeta * zeta).sqrt() * t).sin()
        };
        let y = |t: f64| swing(2.0, 0.01, t) + 0.5 * swing(7.0, 0.01, t);
        let options = Decrement {
            band_hz: Some([1.0, 4.0]),
            ..Decrement::default()
        };
        for at in decrement(&record(y, 20.0, 100.0), &options).unwrap() {
            assert!((at.frequency_hz / 2.0 - 1.0).abs() < 2e-3, "{at:?}");
            assert!((at.damping_ratio / 0.01 - 1.0).abs() < 0.03, "{at:?}");
        }
    }

    #[test]
    fn refuses_too_few_swings_and_options_out_of_range() {
        let short = record(|t| (12.0 * t).sin(), 1.0, 100.0);
        let message = decrement(&short, &Decrement::default()).unwrap_err().to_string();
        assert!(message.contains("swings, but one value needs 8"), "{message}");
        let options = Decrement {
            channel: 1,
            ..Decrement::default()
        };
        let message = decrement(&short, &options).unwrap_err().to_string();
        assert_eq!(message, "channel is 1, but must be below the number of channels");
    }
}
