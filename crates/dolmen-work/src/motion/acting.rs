//! A motion that is ready to act, and where it came from.

use super::measured_response::MeasuredResponse;
use dolmen::signal::{Component, GroundMotion, last_and_peak_displacement_m};
use std::sync::Arc;

/// The motion of the base and where it came from.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionAnswer {
    /// The motion as it acts: read, then changed as its history says.
    pub motion: GroundMotion,
    /// The file of each component.
    pub files: Vec<(Component, String)>,
    /// Largest absolute acceleration of each component as read, m/s².
    pub peaks_read_m_s2: Vec<(Component, f64)>,
    /// The angle it was turned by, rad, where one was typed.
    pub turned_rad: Option<f64>,
    /// What the structure did above it, where a survey's record measured both and nothing was changed since.
    pub measured: Option<Arc<MeasuredResponse>>,
}

/// A base line drifts where the last displacement is more than this part of the largest, and that more than this, m. Chosen here.
const DRIFT_LEAST: f64 = 0.5;
const DRIFT_LEAST_M: f64 = 0.01;

/// Whether a component of a motion ends near its largest displacement: a base line that drifts, or ground that moved for good.
pub fn base_line_drifts([last_m, peak_m]: [f64; 2]) -> bool {
    last_m.abs() > DRIFT_LEAST * peak_m && peak_m > DRIFT_LEAST_M
}

impl MotionAnswer {
    /// When a run ends, s, if that is before the motion does.
    pub fn cut_at_s(&self, end_s: f64) -> Option<f64> {
        (end_s < self.motion.duration_s() * (1.0 - 1e-9)).then_some(end_s)
    }

    /// How a run that ended before the motion is announced, before what it showed until then.
    pub fn cut_words(&self, end_s: f64) -> String {
        format!(
            "ENDED BEFORE THE MOTION: {end_s:.2} of its {:.2} s were run; no verdict. Until then: ",
            self.motion.duration_s()
        )
    }

    /// Components whose base line drifts, and how far away the ground ends, m.
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
