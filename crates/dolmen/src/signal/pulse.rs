//! Pulses: simple base motions for tests, for limits and for near-fault motions.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | T_p | `period_s` | period of the pulse | s |
//! | A | `peak_acceleration_m_s2` | its largest acceleration | m/s² |
//! | γ, ν | `gamma`, `phase_rad` | number of half cycles and phase of a Mavroeidis–Papageorgiou pulse | –, rad |

use super::{Component, GroundMotion, SignalError};
use std::f64::consts::{PI, TAU};

/// Number of samples used to find the peak of a shape.
const PEAK_SAMPLES: usize = 20_000;
/// Number of periods on either side of the centre of a Ricker wavelet: the rest is below 1e-9 of its height.
const RICKER_PERIODS: f64 = 1.5;
const SAMPLES_MOST: f64 = 1e7;

/// Shape of a pulse. Each variant states the velocity and displacement that remain after the pulse.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PulseShape {
    /// A sin(πt/(T_p/2)) for half a period; the velocity A T_p/π remains. The pulse of Housner.
    HalfSine,
    /// A sin(2πt/T_p) for one period; a displacement A T_p²/(2π) remains, but no velocity.
    OneSine,
    /// A cos(2πt/T_p) for one period, with a jump within one sample at both ends; the final velocity is zero within rounding.
    OneCosine,
    /// Second derivative of a Gaussian, even: A (1 − 2π²t²/T_p²) e^(−π²t²/T_p²); nothing remains.
    RickerEven,
    /// Third derivative of a Gaussian, odd; nothing remains.
    RickerOdd,
    /// Mavroeidis and Papageorgiou: a velocity cosine times a raised cosine.
    MavroeidisPapageorgiou {
        /// γ, above 1: 1.2 to 3 fits near-fault records.
        gamma: f64,
        /// ν, rad.
        phase_rad: f64,
    },
}

impl PulseShape {
    /// "half sine", "one sine", "one cosine", "even Ricker wavelet", "odd Ricker wavelet", "near-fault pulse".
    pub fn name(self) -> &'static str {
        match self {
            PulseShape::HalfSine => "half sine",
            PulseShape::OneSine => "one sine",
            PulseShape::OneCosine => "one cosine",
            PulseShape::RickerEven => "even Ricker wavelet",
            PulseShape::RickerOdd => "odd Ricker wavelet",
            PulseShape::MavroeidisPapageorgiou { .. } => "near-fault pulse",
        }
    }
}

/// Shortest and longest period of a pulse of this time step, s: 8 and 10⁷ steps.
pub fn pulse_periods_s(time_step_s: f64) -> [f64; 2] {
    const STEPS_LEAST: f64 = 8.0;
    [STEPS_LEAST * time_step_s, SAMPLES_MOST * time_step_s]
}

/// A pulse along x with this period and peak acceleration, sampled; its first and last samples are zero.
///
/// ```text
/// Mavroeidis–Papageorgiou   v = ½ A_v (1 + cos(2πτ/(γ T_p))) cos(2πτ/T_p + ν)        |τ| ≤ γ T_p / 2
/// ```
///
/// # Errors
/// [`SignalError::Argument`] for a period below 8 or above 10⁷ time steps, a peak that is not positive, or γ not above 1.
///
/// # Source
/// Makris, Roussos (2000) Géotechnique 50(3):243-262 (sine and cosine pulses); Ricker (1943) Geophysics 8(4):348-366; Mavroeidis,
/// Papageorgiou (2003) Bull. Seism. Soc. Am. 93(3):1099-1131, eq. 3.
///
/// # Example
/// ```
/// use dolmen::signal::{Component, PulseShape, intensity_measures, pulse};
/// let motion = pulse(PulseShape::HalfSine, 1.0, 3.0, 0.001)?;
/// let left = intensity_measures(&motion, Component::X)?.last_velocity_m_s;
/// assert!((left - 3.0 / std::f64::consts::PI).abs() < 1e-5);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn pulse(
    shape: PulseShape,
    period_s: f64,
    peak_acceleration_m_s2: f64,
    time_step_s: f64,
) -> Result<GroundMotion, SignalError> {
    let refuse = |argument, given, allowed| {
        Err(SignalError::Argument {
            argument,
            given,
            allowed,
        })
    };
    let [least_s, most_s] = pulse_periods_s(time_step_s);
    if !(least_s..=most_s).contains(&period_s) {
        return refuse("period_s", period_s, "8 to 10 million time steps");
    }
    if !(peak_acceleration_m_s2 > 0.0 && peak_acceleration_m_s2.is_finite()) {
        return refuse(
            "peak_acceleration_m_s2",
            peak_acceleration_m_s2,
            "a positive number",
        );
    }
    let half = match shape {
        PulseShape::HalfSine => 0.25,
        PulseShape::OneSine | PulseShape::OneCosine => 0.5,
        PulseShape::RickerEven | PulseShape::RickerOdd => RICKER_PERIODS,
        PulseShape::MavroeidisPapageorgiou { gamma, phase_rad } => {
            if !(gamma > 1.0 && gamma <= 100.0) {
                return refuse("gamma", gamma, "above 1 and at most 100");
            }
            if !phase_rad.is_finite() {
                return refuse("phase_rad", phase_rad, "a finite number");
            }
            0.5 * gamma
        }
    };
    let value = |x: f64| {
        if x.abs() <= half * (1.0 + 1e-12) {
            acceleration(shape, x)
        } else {
            0.0
        }
    };
    let scanned =
        (0..=PEAK_SAMPLES).map(|k| value(half * (2.0 * k as f64 / PEAK_SAMPLES as f64 - 1.0)).abs());
    let scale = peak_acceleration_m_s2 / scanned.fold(0.0, f64::max);
    let steps = (2.0 * half * period_s / time_step_s * (1.0 - 1e-12)).ceil() as usize;
    let mut samples = vec![0.0];
    samples.extend((0..=steps).map(|i| scale * value(i as f64 * time_step_s / period_s - half)));
    samples.push(0.0);
    GroundMotion::new(
        format!("{}, period {period_s} s", shape.name()),
        time_step_s,
        vec![(Component::X, samples)],
    )
}

/// Acceleration at x = (t − centre)/T_p, up to a factor.
fn acceleration(shape: PulseShape, x: f64) -> f64 {
    match shape {
        PulseShape::HalfSine => (TAU * x).cos(),
        PulseShape::OneSine => -(TAU * x).sin(),
        PulseShape::OneCosine => -(TAU * x).cos(),
        PulseShape::RickerEven => {
            let q = (PI * x).powi(2);
            (1.0 - 2.0 * q) * (-q).exp()
        }
        PulseShape::RickerOdd => {
            let q = (PI * x).powi(2);
            PI * x * (3.0 - 2.0 * q) * (-q).exp()
        }
        PulseShape::MavroeidisPapageorgiou { gamma, phase_rad } => {
            let (slow, fast) = (TAU * x / gamma, TAU * x + phase_rad);
            -(slow.sin() * fast.cos() + gamma * fast.sin() * (1.0 + slow.cos()))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::intensity_measures;

    fn left(shape: PulseShape) -> [f64; 3] {
        let motion = pulse(shape, 0.8, 2.5, 0.0005).unwrap();
        let m = intensity_measures(&motion, Component::X).unwrap();
        [
            m.peak_acceleration_m_s2,
            m.last_velocity_m_s,
            m.last_displacement_m,
        ]
    }

    #[test]
    fn exact_what_pulses_leave() {
        let near = |got: [f64; 3], velocity: f64, displacement: f64| {
            assert!((got[0] - 2.5).abs() < 1e-4, "{got:?}");
            assert!(
                (got[1] - velocity).abs() < 2e-3 && (got[2] - displacement).abs() < 2e-3,
                "{got:?}"
            );
        };
        let (a, t) = (2.5, 0.8);
        near(left(PulseShape::HalfSine), a * t / PI, a * t * t / (4.0 * PI));
        near(left(PulseShape::OneSine), 0.0, a * t * t / TAU);
        near(left(PulseShape::OneCosine), 0.0, 0.0);
        near(left(PulseShape::RickerEven), 0.0, 0.0);
        near(left(PulseShape::RickerOdd), 0.0, 0.0);
    }

    #[test]
    fn exact_mavroeidis_papageorgiou_integrates_to_its_velocity() {
        let (gamma, phase_rad, period_s) = (1.6, 0.7, 0.8);
        let h = 0.0005;
        let motion = pulse(
            PulseShape::MavroeidisPapageorgiou { gamma, phase_rad },
            period_s,
            2.5,
            h,
        )
        .unwrap();
        let a = motion.acceleration_m_s2(Component::X);
        // a is the derivative of v: their ratio is constant
        let v = |i: usize| {
            let x = (i as f64 - 1.0) * h / period_s - 0.5 * gamma;
            (1.0 + (TAU * x / gamma).cos()) * (TAU * x + phase_rad).cos()
        };
        let ratio = |i: usize| a[i] / ((v(i + 1) - v(i - 1)) / (2.0 * h));
        for i in [200, 700, 1300, 2000] {
            assert!(
                (ratio(i) / ratio(1000) - 1.0).abs() < 1e-4,
                "{i}: {} {}",
                ratio(i),
                ratio(1000)
            );
        }
    }

    #[test]
    fn refuses_pulses_that_cannot_be() {
        for (period, peak, wanted) in [
            (0.001, 1.0, "period_s is 0.001"),
            (1.0, 0.0, "peak_acceleration_m_s2 is 0"),
            (f64::NAN, 1.0, "period_s is NaN"),
        ] {
            assert!(
                pulse(PulseShape::OneSine, period, peak, 0.01)
                    .unwrap_err()
                    .to_string()
                    .starts_with(wanted)
            );
        }
    }
}
