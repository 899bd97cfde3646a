//! A motion ready to act, with its origin.

use super::measured_response::MeasuredResponse;
use dolmen::signal::{Component, GroundMotion, last_and_peak_displacement_m};
use std::sync::Arc;

/// The motion of the base and its origin.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionAnswer {
    /// The motion: read, then changed as its history says.
    pub motion: GroundMotion,
    /// The file of each component.
    pub files: Vec<(Component, String)>,
    /// Largest absolute acceleration of each component as read, m/s².
    pub peaks_read_m_s2: Vec<(Component, f64)>,
    /// The angle of rotation on the command line, rad, if given.
    pub turned_rad: Option<f64>,
    /// The response of the structure above the ground, if a survey's record has both and the motion was not changed.
    pub measured: Option<Arc<MeasuredResponse>>,
}

/// A drifting baseline: the last displacement exceeds this fraction of the largest, and this length, m. Our choice.
const DRIFT_LEAST: f64 = 0.5;
const DRIFT_LEAST_M: f64 = 0.01;

/// Whether a component of a motion ends near its largest displacement: the base line drifts, or the ground moved permanently.
pub fn base_line_drifts([last_m, peak_m]: [f64; 2]) -> bool {
    last_m.abs() > DRIFT_LEAST * peak_m && peak_m > DRIFT_LEAST_M
}

impl MotionAnswer {
    /// End of a run, s, if it is before the end of the motion.
    pub fn cut_at_s(&self, end_s: f64) -> Option<f64> {
        (end_s < self.motion.duration_s() * (1.0 - 1e-9)).then_some(end_s)
    }

    /// Components with a drifting base line, and the displacement at their end, m.
    pub fn drifting_m(&self) -> Vec<(Component, f64)> {
        let given = Component::ALL
            .into_iter()
            .filter(|component| self.motion.has(*component));
        let measured = given.filter_map(|component| {
            let travel = last_and_peak_displacement_m(&self.motion, component).ok()?;
            base_line_drifts(travel).then_some((component, travel[0]))
        });
        measured.collect()
    }
}
