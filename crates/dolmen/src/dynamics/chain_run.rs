//! Options of a chain simulation: initial state, duration and definition of a fall.

use super::chain_model::ChainModel;
use super::frame_run::{DURATION_ALLOWED, DURATION_MOST_S, SAMPLES_MOST};
use super::{DynamicsError, TimeFunction};

/// Options of [`simulate_chain`](super::simulate_chain).
#[derive(Clone, Debug, PartialEq)]
pub struct ChainRun {
    /// Duration of the run, s. Default `None`: the duration of the load.
    pub duration_s: Option<f64>,
    /// Time between samples of the history, s. Default 0.005.
    pub output_step_s: f64,
    /// Initial rotations of the links, rad. Default empty: all zero.
    pub start_rotation_rad: Vec<f64>,
    /// Initial angular velocities of the links, rad/s. Default empty: all zero.
    pub start_velocity_rad_s: Vec<f64>,
    /// Rotation of a link from the vertical that is a fall, rad. Default 60° (our choice).
    pub fall_rad: f64,
}

impl Default for ChainRun {
    fn default() -> Self {
        ChainRun {
            duration_s: None,
            output_step_s: 0.005,
            start_rotation_rad: Vec::new(),
            start_velocity_rad_s: Vec::new(),
            fall_rad: std::f64::consts::FRAC_PI_3,
        }
    }
}

impl ChainRun {
    /// Checks the options against the model; returns the duration of the run, s.
    pub(super) fn check(&self, model: &ChainModel, load: &TimeFunction) -> Result<f64, DynamicsError> {
        load.check("ground_acceleration_m_s2")?;
        let positive = |argument, given: f64, allowed| {
            if given > 0.0 && given.is_finite() {
                return Ok(given);
            }
            Err(DynamicsError::Argument {
                argument,
                given,
                allowed,
            })
        };
        positive("output_step_s", self.output_step_s, "a positive number")?;
        positive("fall_rad", self.fall_rad, "a positive number")?;
        let needed = model.chain.links().len();
        for (argument, values, most, allowed) in [
            (
                "start_rotation_rad",
                &self.start_rotation_rad,
                self.fall_rad,
                "a number below fall_rad in size",
            ),
            (
                "start_velocity_rad_s",
                &self.start_velocity_rad_s,
                f64::INFINITY,
                "a number",
            ),
        ] {
            if !values.is_empty() && values.len() != needed {
                return Err(DynamicsError::ChainCount {
                    argument,
                    given: values.len(),
                    needed,
                });
            }
            if let Some(i) = values.iter().position(|x| x.is_nan() || x.abs() >= most) {
                return Err(DynamicsError::ChainPart {
                    part: "link",
                    number: i + 1,
                    argument,
                    given: values[i],
                    allowed,
                });
            }
        }
        let duration_s = positive(
            "duration_s",
            self.duration_s.unwrap_or(load.duration_s()),
            "a positive number: give it where no sampled load does",
        )?;
        if duration_s > DURATION_MOST_S {
            return Err(DynamicsError::Argument {
                argument: "duration_s",
                given: duration_s,
                allowed: DURATION_ALLOWED,
            });
        }
        if duration_s / self.output_step_s > SAMPLES_MOST {
            return Err(DynamicsError::Argument {
                argument: "output_step_s",
                given: self.output_step_s,
                allowed: "long enough for ten million samples at most in the run",
            });
        }
        Ok(duration_s)
    }
}
