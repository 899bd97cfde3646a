//! Artificial ground motions: filtered noise with an envelope. The same seed gives the same motion.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S(ω) | `density` | spectral density of the acceleration, up to a factor | – |
//! | ω_g, ζ_g | `ground_frequency_hz`, `ground_damping_ratio` | frequency and damping ratio of the soil | rad/s, – |
//! | ω_f, ζ_f | `corner_hz`, `corner_damping_ratio` | frequency and damping ratio of the high-pass filter | rad/s, – |
//! | t_1, t_2, c | `rise_s`, `strong_s`, `decay_per_s` | envelope: (t/t_1)², 1 for t_2, e^(−c (t − t_1 − t_2)) | s, s, 1/s |

use super::at_rest::{bring_to_rest, edges};
use super::{Component, GroundMotion, SignalError};
use crate::numeric::Random;
use num_complex::Complex64;
use realfft::RealFftPlanner;
use std::f64::consts::TAU;

const SAMPLES_MOST: f64 = 1e7;
/// Length of the ramps to zero at both ends, s. Our choice.
const EDGE_S: f64 = 0.2;

/// Filter that defines the spectral density of the noise.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum NoiseFilter {
    /// White noise, with the same density at every frequency.
    White,
    /// Kanai and Tajimi: bedrock noise, filtered by a soil that responds as an oscillator.
    KanaiTajimi {
        /// Frequency of the soil, Hz. 2.5 is usual for firm ground.
        ground_frequency_hz: f64,
        /// Damping ratio of the soil. 0.6 is usual for firm ground.
        ground_damping_ratio: f64,
    },
    /// Clough and Penzien: Kanai–Tajimi with an additional high-pass filter, which removes unrealistic slow displacements.
    CloughPenzien {
        /// Frequency of the soil, Hz.
        ground_frequency_hz: f64,
        /// Damping ratio of the soil.
        ground_damping_ratio: f64,
        /// Corner of the high-pass filter, Hz: usually a tenth of the soil frequency.
        corner_hz: f64,
        /// Damping ratio of the high-pass filter. 0.6 is usual.
        corner_damping_ratio: f64,
    },
}

impl NoiseFilter {
    /// Spectral density at a frequency, 1 for white noise.
    ///
    /// ```text
    /// S = (1 + 4ζ_g² r²)/((1 − r²)² + 4ζ_g² r²) · q⁴/((1 − q²)² + 4ζ_f² q²)        r = ω/ω_g, q = ω/ω_f
    /// ```
    pub fn density(&self, frequency_hz: f64) -> f64 {
        let ground = |hz: f64, zeta: f64| {
            let (r, damped) = (
                (frequency_hz / hz).powi(2),
                (2.0 * zeta * frequency_hz / hz).powi(2),
            );
            (1.0 + damped) / ((1.0 - r).powi(2) + damped)
        };
        match *self {
            NoiseFilter::White => 1.0,
            NoiseFilter::KanaiTajimi {
                ground_frequency_hz,
                ground_damping_ratio,
            } => ground(ground_frequency_hz, ground_damping_ratio),
            NoiseFilter::CloughPenzien {
                ground_frequency_hz,
                ground_damping_ratio,
                corner_hz,
                corner_damping_ratio,
            } => {
                let (q, damped) = (
                    (frequency_hz / corner_hz).powi(2),
                    (2.0 * corner_damping_ratio * frequency_hz / corner_hz).powi(2),
                );
                ground(ground_frequency_hz, ground_damping_ratio) * q * q / ((1.0 - q).powi(2) + damped)
            }
        }
    }

    fn parameters(&self) -> Vec<(&'static str, f64)> {
        match *self {
            NoiseFilter::White => Vec::new(),
            NoiseFilter::KanaiTajimi {
                ground_frequency_hz,
                ground_damping_ratio,
            } => {
                vec![
                    ("ground_frequency_hz", ground_frequency_hz),
                    ("ground_damping_ratio", ground_damping_ratio),
                ]
            }
            NoiseFilter::CloughPenzien {
                ground_frequency_hz,
                ground_damping_ratio,
                corner_hz,
                corner_damping_ratio,
            } => vec![
                ("ground_frequency_hz", ground_frequency_hz),
                ("ground_damping_ratio", ground_damping_ratio),
                ("corner_hz", corner_hz),
                ("corner_damping_ratio", corner_damping_ratio),
            ],
        }
    }
}

/// Options of an artificial motion.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Noise {
    /// Spectral density. Default: Clough–Penzien with firm ground, 2.5 Hz, 0.6, 0.25 Hz, 0.6.
    pub filter: NoiseFilter,
    /// Length, s. Default 20.
    pub duration_s: f64,
    /// Time between samples, s. Default 0.01.
    pub time_step_s: f64,
    /// Rise time of the envelope, s. Default 2.
    pub rise_s: f64,
    /// Duration of the strong part, s. Default 8.
    pub strong_s: f64,
    /// Decay rate after the strong part, 1/s. Default 0.3.
    pub decay_per_s: f64,
    /// Largest acceleration, m/s². Default 1.
    pub peak_acceleration_m_s2: f64,
}

impl Default for Noise {
    fn default() -> Self {
        Noise {
            filter: NoiseFilter::CloughPenzien {
                ground_frequency_hz: 2.5,
                ground_damping_ratio: 0.6,
                corner_hz: 0.25,
                corner_damping_ratio: 0.6,
            },
            duration_s: 20.0,
            time_step_s: 0.01,
            rise_s: 2.0,
            strong_s: 8.0,
            decay_per_s: 0.3,
            peak_acceleration_m_s2: 1.0,
        }
    }
}

/// An artificial motion along x: noise of the given density with fixed amplitudes and random phases. The envelope multiplies the noise; the
/// motion is then brought to rest at the end and scaled to the peak.
///
/// ```text
/// a(t) = envelope(t) Σ √S(ω_k) cos(ω_k t + φ_k)        φ_k uniform, ω_k = 2πk/(N h), N samples
/// ```
///
/// # Errors
/// [`SignalError::Argument`] for a length, step, envelope, filter or peak out of range.
///
/// # Source
/// Shinozuka, Deodatis (1991) Appl. Mech. Rev. 44(4):191-204 (random phases); Tajimi (1960) Proc. 2nd WCEE; Clough, Penzien (1975)
/// *Dynamics of Structures*; Jennings, Housner, Tsai (1968) Caltech EERL (the envelope).
///
/// # Example
/// ```
/// use dolmen::signal::{Component, Noise, noise_motion};
/// let motion = noise_motion(&Noise { peak_acceleration_m_s2: 2.0, ..Default::default() }, 7)?;
/// assert!((motion.component_peak_m_s2(Component::X) - 2.0).abs() < 1e-12);
/// assert_eq!(motion, noise_motion(&Noise { peak_acceleration_m_s2: 2.0, ..Default::default() }, 7)?);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn noise_motion(options: &Noise, seed: u64) -> Result<GroundMotion, SignalError> {
    let positive = [
        ("duration_s", options.duration_s),
        ("time_step_s", options.time_step_s),
        ("rise_s", options.rise_s),
        ("peak_acceleration_m_s2", options.peak_acceleration_m_s2),
    ];
    let allowed = "a positive number";
    for (argument, given) in positive.into_iter().chain(options.filter.parameters()) {
        if !(given > 0.0 && given.is_finite()) {
            return Err(SignalError::Argument {
                argument,
                given,
                allowed,
            });
        }
    }
    for (argument, given) in [
        ("strong_s", options.strong_s),
        ("decay_per_s", options.decay_per_s),
    ] {
        if !(given >= 0.0 && given.is_finite()) {
            return Err(SignalError::Argument {
                argument,
                given,
                allowed: "0 or a positive number",
            });
        }
    }
    let steps = (options.duration_s / options.time_step_s).round();
    if !(8.0..=SAMPLES_MOST).contains(&steps) {
        return Err(SignalError::Argument {
            argument: "duration_s",
            given: options.duration_s,
            allowed: "8 to 10 million time steps",
        });
    }
    let length = steps as usize + 1;
    let mut samples = stationary(options, length, seed);
    let ramp = ((EDGE_S / options.time_step_s) as usize).clamp(1, length / 4);
    let envelope = |i: usize| {
        let t = i as f64 * options.time_step_s;
        let shape = if t < options.rise_s {
            (t / options.rise_s).powi(2)
        } else {
            (-options.decay_per_s * (t - options.rise_s - options.strong_s).max(0.0)).exp()
        };
        shape * edges(i, length, ramp)
    };
    samples
        .iter_mut()
        .enumerate()
        .for_each(|(i, a)| *a *= envelope(i));
    bring_to_rest(&mut samples, 0, 0.5 * length as f64, envelope);
    let name = format!("noise, seed {seed}");
    let motion = GroundMotion::new(name, options.time_step_s, vec![(Component::X, samples)])?;
    motion.scaled_to_peak(Component::X, options.peak_acceleration_m_s2)
}

/// Noise before envelope and scaling.
fn stationary(options: &Noise, length: usize, seed: u64) -> Vec<f64> {
    let transform = RealFftPlanner::<f64>::new().plan_fft_inverse(length);
    let mut spectrum = transform.make_input_vec();
    let mut random = Random::new(seed, 0);
    let bins = spectrum.len();
    for (k, value) in spectrum.iter_mut().enumerate() {
        let phase = TAU * random.uniform();
        let frequency_hz = k as f64 / (length as f64 * options.time_step_s);
        let is_real = k == 0 || (length.is_multiple_of(2) && k + 1 == bins);
        if !is_real {
            *value = Complex64::from_polar(options.filter.density(frequency_hz).sqrt(), phase);
        }
    }
    let mut samples = transform.make_output_vec();
    let made = transform.process(&mut spectrum, &mut samples);
    debug_assert!(made.is_ok(), "the lengths are those it asked for");
    samples
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::intensity_measures;

    #[test]
    fn holds_the_same_seed_gives_the_same_bits_and_rest_at_the_end() {
        let one = noise_motion(&Noise::default(), 3).unwrap();
        assert_eq!(one, noise_motion(&Noise::default(), 3).unwrap());
        let other = noise_motion(&Noise::default(), 4).unwrap();
        assert_ne!(
            one.acceleration_m_s2(Component::X),
            other.acceleration_m_s2(Component::X)
        );
        let m = intensity_measures(&one, Component::X).unwrap();
        assert!(
            m.last_velocity_m_s.abs() < 1e-12 && m.last_displacement_m.abs() < 1e-11,
            "{m:?}"
        );
        assert!((m.peak_acceleration_m_s2 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn exact_the_density_of_kanai_and_tajimi() {
        let filter = NoiseFilter::KanaiTajimi {
            ground_frequency_hz: 2.5,
            ground_damping_ratio: 0.6,
        };
        assert!((filter.density(2.5) - (1.0 + 1.44) / 1.44).abs() < 1e-14);
        assert!((filter.density(1e-9) - 1.0).abs() < 1e-14 && filter.density(250.0) < 2e-4);
    }

    #[test]
    fn holds_the_samples_have_the_density_asked_for() {
        // mean periodogram over many seeds, in two bands, with an almost constant envelope
        let filter = Noise::default().filter;
        let options = Noise {
            rise_s: 0.02,
            strong_s: 100.0,
            duration_s: 40.0,
            ..Default::default()
        };
        let power = |from_hz: f64, to_hz: f64| {
            let mut sum = 0.0;
            for seed in 0..10 {
                let samples = stationary(&options, 4000, seed);
                for k in (from_hz * 40.0) as usize..(to_hz * 40.0) as usize {
                    let turn = |i: usize| Complex64::from_polar(1.0, -TAU * (k * i % 4000) as f64 / 4000.0);
                    sum += samples
                        .iter()
                        .enumerate()
                        .map(|(i, a)| turn(i) * *a)
                        .sum::<Complex64>()
                        .norm_sqr();
                }
            }
            sum
        };
        let wanted = |from_hz: f64, to_hz: f64| {
            ((from_hz * 40.0) as usize..(to_hz * 40.0) as usize)
                .map(|k| filter.density(k as f64 / 40.0))
                .sum::<f64>()
        };
        let (low, high) = ((0.5, 1.0), (6.0, 6.5));
        let ratio = power(low.0, low.1) / power(high.0, high.1);
        assert!((ratio / (wanted(low.0, low.1) / wanted(high.0, high.1)) - 1.0).abs() < 1e-9);
    }

    #[test]
    fn refuses_noise_that_cannot_be() {
        let bad = Noise {
            duration_s: 0.05,
            ..Default::default()
        };
        assert!(
            noise_motion(&bad, 1)
                .unwrap_err()
                .to_string()
                .starts_with("duration_s is 0.05")
        );
        let bad = Noise {
            rise_s: f64::NAN,
            ..Default::default()
        };
        assert!(
            noise_motion(&bad, 1)
                .unwrap_err()
                .to_string()
                .starts_with("rise_s is NaN")
        );
    }
}
