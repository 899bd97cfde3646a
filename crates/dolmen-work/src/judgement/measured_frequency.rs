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
pub(crate) fn contradict(measured_hz: f64, sd_hz: Option<f64>, computed_hz: f64) -> bool {
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
    /// Whether its shape has a node: a first mode of a structure has none.
    pub has_node: bool,
    /// Others that may be the direction's first mode, Hz and standard deviation: more modes move along it than the model has.
    pub others: Vec<FrequencyAndDeviation>,
}

/// A frequency and its standard deviation, Hz.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyAndDeviation {
    /// The frequency.
    pub frequency_hz: f64,
    /// Its standard deviation.
    pub sd_hz: f64,
}

impl RecordFrequency {
    /// Compared with the lowest frequency of the model in its direction, the nearest if there are several; `None` if it differs, but has the
    /// shape of a higher mode, or agrees with one of `higher_hz` of the model, so that the record missed the first.
    pub(super) fn beside(&self, computed_hz: f64, higher_hz: &[f64]) -> Option<MeasuredFrequency> {
        let own = FrequencyAndDeviation {
            frequency_hz: self.frequency_hz,
            sd_hz: self.sd_hz,
        };
        let all = std::iter::once(&own).chain(&self.others);
        let off = |of: &FrequencyAndDeviation| apart(of.frequency_hz, computed_hz);
        let nearest = all.min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or(&own);
        let found = MeasuredFrequency {
            survey: self.survey.clone(),
            direction: self.direction.to_owned(),
            measured_hz: nearest.frequency_hz,
            sd_hz: Some(nearest.sd_hz).filter(|sd_hz| *sd_hz > 0.0),
            computed_hz,
        };
        let agrees = |hz: &f64| apart(self.frequency_hz, *hz) <= FREQUENCY_RATIO_MOST.ln();
        let is_higher = self.frequency_hz > computed_hz && (self.has_node || higher_hz.iter().any(agrees));
        (!is_higher || !found.differs()).then_some(found)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn record(frequency_hz: f64, has_node: bool, others: &[f64]) -> RecordFrequency {
        let sd_hz = 0.01;
        let others = others.iter().map(|hz| FrequencyAndDeviation {
            frequency_hz: *hz,
            sd_hz,
        });
        RecordFrequency {
            survey: "2024-03-05".to_owned(),
            direction: "y",
            frequency_hz,
            sd_hz,
            has_node,
            others: others.collect(),
        }
    }

    #[test]
    fn holds_a_higher_mode_never_contradicts_the_first_of_the_model() {
        assert_eq!(record(11.3, true, &[]).beside(3.62, &[]), None);
        assert_eq!(record(23.2, false, &[]).beside(3.62, &[11.3, 23.1]), None);
        assert!(
            record(11.3, false, &[])
                .beside(3.62, &[])
                .is_some_and(|of| of.contradicts())
        );
        assert!(
            record(2.5, true, &[])
                .beside(3.62, &[])
                .is_some_and(|of| of.contradicts())
        );
        assert!(
            record(3.65, true, &[])
                .beside(3.62, &[])
                .is_some_and(|of| !of.differs())
        );
    }

    #[test]
    fn holds_among_more_modes_than_the_model_has_the_nearest_counts() {
        let found = record(0.897, false, &[1.204]).beside(1.2, &[]);
        assert!(found.is_some_and(|of| of.measured_hz == 1.204 && !of.contradicts()));
    }
}
