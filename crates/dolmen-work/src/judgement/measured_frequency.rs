//! A measured frequency compared with that of the model.

use crate::state::FREQUENCY_RATIO_MOST;
use dolmen_project::{Evidence as Source, Quantity};

/// Number of standard deviations within which a measured frequency agrees with the model. Our choice: chance exceeds it in 1 of 400.
const DEVIATIONS_MOST: f64 = 3.0;

/// ln of the ratio of the larger to the smaller: 0 if they are equal.
pub(super) fn apart(measured_hz: f64, computed_hz: f64) -> f64 {
    (measured_hz / computed_hz).ln().abs()
}

/// Whether two frequencies differ by more than [`FREQUENCY_RATIO_MOST`] and, if the scatter is known, by more than three standard deviations;
/// true for NaN.
pub(super) fn contradict(measured_hz: f64, sd_hz: Option<f64>, computed_hz: f64) -> bool {
    let is_same = apart(measured_hz, computed_hz) <= FREQUENCY_RATIO_MOST.ln();
    !is_same && !is_within(measured_hz, sd_hz, computed_hz)
}

fn is_within(measured_hz: f64, sd_hz: Option<f64>, computed_hz: f64) -> bool {
    sd_hz.is_some_and(|sd_hz| (measured_hz - computed_hz).abs() <= DEVIATIONS_MOST * sd_hz)
}

/// Standard deviation of a measured frequency, Hz; `None` if unknown or assumed.
pub(super) fn measured_sd(measured: &Quantity) -> Option<f64> {
    let is_measured = |sd_hz: &f64| *sd_hz > 0.0 && measured.cov_source != Some(Source::Assumed);
    Some(measured.standard_deviation()).filter(is_measured)
}

/// A measured frequency and that of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredFrequency {
    /// The survey.
    pub survey: String,
    /// Direction of the mode.
    pub direction: String,
    /// Lowest measured frequency of translation, Hz.
    pub measured_hz: f64,
    /// Its standard deviation, Hz; `None` if unknown.
    pub sd_hz: Option<f64>,
    /// Lowest frequency of the model, Hz; or that of a higher mode, if it is the only one similar to the measured shape.
    pub computed_hz: f64,
}

impl MeasuredFrequency {
    pub(super) fn apart(&self) -> f64 {
        apart(self.measured_hz, self.computed_hz)
    }

    /// Whether they differ by more than [`FREQUENCY_RATIO_MOST`], whatever the scatter.
    pub fn differs(&self) -> bool {
        self.apart() > FREQUENCY_RATIO_MOST.ln()
    }

    /// Whether they differ by more than [`FREQUENCY_RATIO_MOST`], but by no more than three standard deviations: this proves neither agreement
    /// nor contradiction.
    pub fn is_too_rough(&self) -> bool {
        self.differs() && is_within(self.measured_hz, self.sd_hz, self.computed_hz)
    }

    /// Whether they contradict each other. False for NaN.
    pub fn contradicts(&self) -> bool {
        contradict(self.measured_hz, self.sd_hz, self.computed_hz)
    }
}

/// A frequency from the records of a survey that is not written in the file.
#[derive(Clone, Debug, PartialEq)]
pub struct RecordFrequency {
    /// The survey.
    pub survey: String,
    /// Direction of the mode, "x" or "y".
    pub direction: &'static str,
    /// The lowest one, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz.
    pub sd_hz: f64,
}
