//! The measured response of a structure above a measured ground.

use dolmen::signal::Component;

/// The channels above a measured ground.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredResponse {
    /// The survey.
    pub survey: String,
    /// Time of the first sample here, s from the first sample of the record.
    pub from_s: f64,
    /// Whether the record contains an earthquake. Otherwise the whole record acts, and the structure may have been moving at its start.
    pub stands_out: bool,
    /// Time between samples, s.
    pub step_s: f64,
    /// Channels that measured accelerations at a known place along a known axis.
    pub channels: Vec<MeasuredChannel>,
    /// Names of the others.
    pub left_out: Vec<String>,
}

/// A channel above a measured ground.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredChannel {
    /// Its name.
    pub name: String,
    /// Its height, m.
    pub height_m: f64,
    /// Its axis.
    pub component: Component,
    /// Its acceleration along the axis, m/s².
    pub acceleration_m_s2: Vec<f64>,
}
