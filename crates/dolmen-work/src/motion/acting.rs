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
    /// What cuts, corrections of the base line, filters and tapers took off, if it is much.
    pub taken_off: Option<TakenOff>,
    /// The response of the structure above the ground, if a survey's record has both and the motion was not changed.
    pub measured: Option<Arc<MeasuredResponse>>,
}

/// Shares of a motion that its changes took off, other than scaling and rotation.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TakenOff {
    /// Of the largest acceleration of a component, 0 to 1; negative if it grew.
    pub peak: f64,
    /// Of the Arias intensity of all components together, likewise.
    pub arias_intensity: f64,
}

/// Share of the peak or the Arias intensity above which an answer says what was taken off. Our choice.
const TAKEN_OFF_LEAST: f64 = 0.1;

impl TakenOff {
    /// What changes took off a motion; `None` if it is little.
    pub(super) fn between(before: &GroundMotion, after: &GroundMotion) -> Option<Self> {
        let samples = |of: &GroundMotion| -> Vec<f64> {
            let given = Component::ALL.into_iter().filter(|component| of.has(*component));
            given
                .flat_map(|component| of.acceleration_m_s2(component).to_vec())
                .collect()
        };
        let [before, after] = [before, after].map(samples);
        let peak = |of: &[f64]| of.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
        let squares = |of: &[f64]| of.iter().map(|a| a * a).sum::<f64>();
        let off = TakenOff {
            peak: 1.0 - peak(&after) / peak(&before),
            arias_intensity: 1.0 - squares(&after) / squares(&before),
        };
        (off.peak > TAKEN_OFF_LEAST || off.arias_intensity > TAKEN_OFF_LEAST).then_some(off)
    }
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
