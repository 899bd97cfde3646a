//! Loads on a structure: functions of time with known Taylor series.

use super::DynamicsError;
use crate::signal::{Component, GroundMotion};
use std::f64::consts::TAU;

/// A scalar function of time: an acceleration of the ground, m/s², or a force, N.
#[derive(Clone, Debug, PartialEq)]
pub enum TimeFunction {
    /// No load.
    Zero,
    /// A constant.
    Constant(f64),
    /// Samples from time 0, with linear interpolation; 0 after the last sample.
    Sampled {
        /// Time between samples dt, s.
        time_step_s: f64,
        /// The values at 0, dt, 2 dt, …
        values: Vec<f64>,
    },
    /// amplitude · sin(2π f t + phase), for all times.
    Harmonic {
        /// Largest value.
        amplitude: f64,
        /// Frequency f, Hz.
        frequency_hz: f64,
        /// Phase at time 0, rad.
        phase_rad: f64,
    },
}

impl TimeFunction {
    /// One component of a ground motion.
    pub fn of_motion(motion: &GroundMotion, component: Component) -> Self {
        TimeFunction::Sampled {
            time_step_s: motion.time_step_s(),
            values: motion.acceleration_m_s2(component).to_vec(),
        }
    }

    /// End of the load, s; 0 for a constant or harmonic load, which has no end.
    pub fn duration_s(&self) -> f64 {
        match self {
            TimeFunction::Zero | TimeFunction::Constant(_) | TimeFunction::Harmonic { .. } => 0.0,
            TimeFunction::Sampled { time_step_s, values } => {
                *time_step_s * values.len().saturating_sub(1) as f64
            }
        }
    }

    pub(super) fn check(&self, argument: &'static str) -> Result<(), DynamicsError> {
        let refuse = |given, allowed| {
            Err(DynamicsError::Argument {
                argument,
                given,
                allowed,
            })
        };
        match self {
            TimeFunction::Zero => Ok(()),
            TimeFunction::Constant(value) if value.is_finite() => Ok(()),
            TimeFunction::Constant(value) => refuse(*value, "a number"),
            TimeFunction::Sampled { time_step_s, values } => {
                if !(*time_step_s > 0.0 && time_step_s.is_finite()) {
                    return refuse(*time_step_s, "sampled with a positive time step");
                }
                match values.iter().find(|v| !v.is_finite()) {
                    Some(&bad) => refuse(bad, "a finite number at every sample"),
                    None => Ok(()),
                }
            }
            TimeFunction::Harmonic {
                amplitude,
                frequency_hz,
                phase_rad,
            } => {
                if !(*frequency_hz > 0.0 && frequency_hz.is_finite()) {
                    return refuse(*frequency_hz, "of a positive frequency");
                }
                match [amplitude, phase_rad].into_iter().find(|v| !v.is_finite()) {
                    Some(&bad) => refuse(bad, "of finite amplitude and phase"),
                    None => Ok(()),
                }
            }
        }
    }

    pub(super) fn constant(&self) -> f64 {
        match self {
            TimeFunction::Constant(value) => *value,
            _ => 0.0,
        }
    }

    /// Value at a time, with linear interpolation between samples.
    pub(super) fn value(&self, at_s: f64) -> f64 {
        match self {
            TimeFunction::Zero => 0.0,
            TimeFunction::Constant(value) => *value,
            TimeFunction::Sampled { time_step_s, values } => {
                let place = at_s / time_step_s;
                let before = place.floor();
                let at = |i: usize| values.get(i).copied().unwrap_or(0.0);
                match values.get(before as usize + 1) {
                    Some(after) => at(before as usize) + (place - before) * (after - at(before as usize)),
                    None if place == before => at(before as usize),
                    None => 0.0,
                }
            }
            TimeFunction::Harmonic {
                amplitude,
                frequency_hz,
                phase_rad,
            } => amplitude * (TAU * frequency_hz * at_s + phase_rad).sin(),
        }
    }

    /// Times up to `until_s` at which the series changes, ascending.
    pub(super) fn breaks_s(&self, until_s: f64) -> Vec<f64> {
        match self {
            TimeFunction::Zero | TimeFunction::Constant(_) | TimeFunction::Harmonic { .. } => Vec::new(),
            TimeFunction::Sampled { time_step_s, values } => (0..=values.len())
                .map(|i| i as f64 * time_step_s)
                .take_while(|t| *t < until_s)
                .collect(),
        }
    }

    /// Longest step, s, on which the series converges as fast as that of a sine over one radian.
    pub(super) fn step_most_s(&self) -> f64 {
        match self {
            TimeFunction::Harmonic { frequency_hz, .. } => 1.0 / (TAU * frequency_hz),
            _ => f64::INFINITY,
        }
    }

    /// Taylor coefficients at `at_s` in σ = (t − at_s)/h, valid up to the next change. Returns the number of nonzero coefficients.
    pub(super) fn series(&self, at_s: f64, h: f64, coefficients: &mut [f64]) -> usize {
        coefficients.fill(0.0);
        match self {
            TimeFunction::Zero => 0,
            TimeFunction::Constant(value) => {
                coefficients[0] = *value;
                1
            }
            TimeFunction::Sampled { time_step_s, values } => {
                // select the interval at the middle of the step: rounding of at_s could select its neighbour
                let interval = ((at_s + 0.5 * h) / time_step_s).floor() as usize;
                let (Some(&start), Some(&end)) = (values.get(interval), values.get(interval + 1)) else {
                    return 0;
                };
                let slope = (end - start) / time_step_s;
                coefficients[0] = start + slope * (at_s - interval as f64 * time_step_s);
                coefficients[1] = slope * h;
                2
            }
            TimeFunction::Harmonic {
                amplitude,
                frequency_hz,
                phase_rad,
            } => {
                let omega = TAU * frequency_hz;
                let (sin, cos) = (omega * at_s + phase_rad).sin_cos();
                let mut size = *amplitude;
                for (k, c) in coefficients.iter_mut().enumerate() {
                    let derivative = [sin, cos, -sin, -cos][k % 4];
                    *c = size * derivative;
                    size *= omega * h / (k + 1) as f64;
                }
                coefficients.len()
            }
        }
    }
}

/// Load on a frame: the acceleration of the ground and a force at each level.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameLoad {
    /// Acceleration of the ground, m/s².
    pub ground_acceleration_m_s2: TimeFunction,
    /// Forces at the levels, lowest first, N; empty without forces.
    pub forces_n: Vec<TimeFunction>,
}

impl FrameLoad {
    /// No load: free motion.
    pub fn none() -> Self {
        FrameLoad::of_ground(TimeFunction::Zero)
    }

    /// A load by ground motion only.
    pub fn of_ground(ground_acceleration_m_s2: TimeFunction) -> Self {
        FrameLoad {
            ground_acceleration_m_s2,
            forces_n: Vec::new(),
        }
    }

    /// End of the last load, s; 0 without a load, or with harmonic loads only.
    pub fn duration_s(&self) -> f64 {
        self.forces_n
            .iter()
            .chain([&self.ground_acceleration_m_s2])
            .map(TimeFunction::duration_s)
            .fold(0.0, f64::max)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn value(f: &TimeFunction, at_s: f64, h: f64, sigma: f64) -> f64 {
        let mut c = [0.0; 24];
        f.series(at_s, h, &mut c);
        c.iter().rev().fold(0.0, |sum, c| sum * sigma + c)
    }

    #[test]
    fn exact_series_of_lines_and_sines() {
        let samples = TimeFunction::Sampled {
            time_step_s: 0.1,
            values: vec![1.0, 3.0, 2.0],
        };
        assert!((value(&samples, 0.05, 0.05, 0.5) - 2.5).abs() < 1e-15);
        assert!((value(&samples, 0.1, 0.1, 0.25) - 2.75).abs() < 1e-15);
        assert_eq!(value(&samples, 0.2, 0.1, 0.5), 0.0);
        assert_eq!(samples.breaks_s(1.0).len(), 4);
        assert!((samples.duration_s() - 0.2).abs() < 1e-15);
        let sine = TimeFunction::Harmonic {
            amplitude: 2.0,
            frequency_hz: 1.5,
            phase_rad: 0.4,
        };
        let wanted = 2.0 * (TAU * 1.5 * (0.3 + 0.7 * 0.1) + 0.4).sin();
        assert!((value(&sine, 0.3, 0.1, 0.7) - wanted).abs() < 1e-14);
    }

    #[test]
    fn refuses_what_is_no_function() {
        let samples = |time_step_s, value| TimeFunction::Sampled {
            time_step_s,
            values: vec![0.0, value],
        };
        let message = |f: TimeFunction| f.check("ground_acceleration_m_s2").unwrap_err().to_string();
        assert_eq!(
            message(samples(0.0, 1.0)),
            "ground_acceleration_m_s2 is 0, but must be sampled with a positive time step"
        );
        assert_eq!(
            message(samples(0.1, f64::NAN)),
            "ground_acceleration_m_s2 is NaN, but must be a finite number at every sample"
        );
    }
}
