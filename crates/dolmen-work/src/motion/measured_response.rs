//! What the structure above a measured ground did.

use dolmen::signal::Component;

/// What the channels above a measured ground did.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredResponse {
    /// The survey.
    pub survey: String,
    /// From the first sample of the record to the first one here, s.
    pub from_s: f64,
    /// Whether an earthquake stands out of the record; else all of it acts, and the structure may have been moving when it began.
    pub stands_out: bool,
    /// Between samples, s.
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
    /// The axis that it points along.
    pub component: Component,
    /// Its acceleration along that, m/s².
    pub acceleration_m_s2: Vec<f64>,
}
