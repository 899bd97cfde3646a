//! Options of the motion of a frame with dry friction.

use super::DynamicsError;
use super::excitation::FrameLoad;
use super::frame_friction::FrictionFrame;

/// Longest run, s: somewhat more than a day. Our choice: a frame of two storeys needs a minute or two for it.
pub(super) const DURATION_MOST_S: f64 = 1e5;
/// The allowed range, for the error of a longer run.
pub(super) const DURATION_ALLOWED: &str = "at most 100 000 s, which is more than a day";
/// Largest number of samples of a history: more would exhaust the memory and are probably a wrong unit. Our choice.
pub(super) const SAMPLES_MOST: f64 = 1e7;

/// Options of [`simulate_frame`](super::simulate_frame).
#[derive(Clone, Debug, PartialEq)]
pub struct FrameRun {
    /// Length of the run, s. Default `None`: the length of the load.
    pub duration_s: Option<f64>,
    /// Time between samples of the history, s. Default 0.005.
    pub output_step_s: f64,
    /// Displacements at the start, m. Default empty: all zero.
    pub start_displacement_m: Vec<f64>,
    /// Velocities at the start, m/s. Default empty: all zero.
    pub start_velocity_m_s: Vec<f64>,
    /// Ratio of drift to storey height at which the run ends, because the model is valid only for small drifts. Default 0.1 (our choice): sin
    /// and tan differ from the angle by 0.2 and 0.3 % there. For a leaning frame, subtract the lean.
    pub drift_ratio_most: f64,
}

impl Default for FrameRun {
    fn default() -> Self {
        FrameRun {
            duration_s: None,
            output_step_s: 0.005,
            start_displacement_m: Vec::new(),
            start_velocity_m_s: Vec::new(),
            drift_ratio_most: 0.1,
        }
    }
}

impl FrameRun {
    pub(super) fn check(&self, frame: &FrictionFrame, load: &FrameLoad) -> Result<f64, DynamicsError> {
        let n = frame.frame.storeys().len();
        let refuse = |argument, given, allowed| {
            Err(DynamicsError::Argument {
                argument,
                given,
                allowed,
            })
        };
        load.ground_acceleration_m_s2.check("ground_acceleration_m_s2")?;
        for force in &load.forces_n {
            force.check("forces_n")?;
        }
        for (argument, given) in [
            ("forces_n", load.forces_n.len()),
            ("start_displacement_m", self.start_displacement_m.len()),
            ("start_velocity_m_s", self.start_velocity_m_s.len()),
        ] {
            if given != 0 && given != n {
                return Err(DynamicsError::Count {
                    argument,
                    given,
                    needed: n,
                });
            }
        }
        for (argument, values) in [
            ("start_displacement_m", &self.start_displacement_m),
            ("start_velocity_m_s", &self.start_velocity_m_s),
        ] {
            if let Some(&given) = values.iter().find(|x| !x.is_finite()) {
                return refuse(argument, given, "a number");
            }
        }
        let positive = |x: f64| x > 0.0 && x.is_finite();
        if !positive(self.output_step_s) {
            return refuse("output_step_s", self.output_step_s, "a positive number");
        }
        if !positive(self.drift_ratio_most) {
            return refuse("drift_ratio_most", self.drift_ratio_most, "a positive number");
        }
        let duration_s = self.duration_s.unwrap_or(load.duration_s());
        if !positive(duration_s) {
            return refuse(
                "duration_s",
                duration_s,
                "a positive number: give it where no sampled load does",
            );
        }
        if duration_s > DURATION_MOST_S {
            return refuse("duration_s", duration_s, DURATION_ALLOWED);
        }
        if duration_s / self.output_step_s > SAMPLES_MOST {
            return refuse(
                "output_step_s",
                self.output_step_s,
                "long enough for ten million samples at most in the run",
            );
        }
        Ok(duration_s)
    }
}
