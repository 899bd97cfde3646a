//! Evidence: does the model represent the structure? Frequencies of a survey compared with those of the model.

use super::colour::Colour;
use super::in_doubt::InDoubt;
use super::measured_frequency::MeasuredFrequency;
use super::said::{EvidenceSaid, text};
use dolmen_project::{ModeKind, SurveyMode};
use dolmen_words::Language;
use dolmen_words::message::Both;
use dolmen_words::number::significant;

/// The fixed words.
#[derive(Clone, Debug, PartialEq)]
pub enum Evidence {
    /// The latest survey has the frequencies of the model.
    Agrees {
        /// The survey.
        survey: String,
    },
    /// A frequency of the latest survey contradicts the model.
    Contradicted(MeasuredFrequency),
    /// A frequency of the latest survey differs from the model, but its scatter is too large for a conclusion.
    TooRough(MeasuredFrequency),
    /// The lowest frequencies do not contradict the model, but a higher mode does, or no stiffness explains the modes of the survey.
    InDoubt(InDoubt),
    /// A survey has vibration records whose modes were not identified here.
    Unread {
        /// The survey.
        survey: String,
    },
    /// A survey measured frequencies, but the model has none because its stiffness is unknown.
    NotCompared {
        /// The survey.
        survey: String,
    },
    /// The frequencies of surveys are marked as assumed in the file, so they are no evidence.
    MarkedAssumed {
        /// The latest of them.
        survey: String,
        /// Among the latest frequencies in each direction, the one farthest from that of the model; `None` if the model has none.
        farthest: Option<MeasuredFrequency>,
    },
    /// No survey measured a comparable quantity, or only the one from which the stiffness was identified.
    NotMeasured {
        /// The survey that the stiffness was identified from.
        calibrated_to: Option<String>,
    },
}

impl Evidence {
    /// Evidence of the frequencies of the latest surveys.
    pub(super) fn of_frequencies(measured: Vec<MeasuredFrequency>) -> Evidence {
        let rough = measured.iter().find(|of| of.is_too_rough()).cloned();
        let agreeing = measured
            .iter()
            .rev()
            .find(|of| !of.differs())
            .map(|of| of.survey.clone());
        let contradicting = measured.into_iter().filter(MeasuredFrequency::contradicts);
        let worst = contradicting.max_by(|a, b| a.apart().total_cmp(&b.apart()));
        match (worst, agreeing, rough) {
            (Some(worst), ..) => Evidence::Contradicted(worst),
            (None, Some(survey), _) => Evidence::Agrees { survey },
            (None, None, Some(rough)) => Evidence::TooRough(rough),
            (None, None, None) => Evidence::none(),
        }
    }

    /// No frequency was measured.
    pub fn none() -> Evidence {
        Evidence::NotMeasured { calibrated_to: None }
    }

    /// Whether a survey contradicts the model.
    pub fn is_contradicted(&self) -> bool {
        matches!(self, Evidence::Contradicted(_))
    }

    /// Whether a survey contradicts the model or makes it doubtful.
    pub fn is_doubted(&self) -> bool {
        matches!(self, Evidence::Contradicted(_) | Evidence::InDoubt(_))
    }

    /// Its colour.
    pub fn colour(&self) -> Colour {
        match self {
            Evidence::Contradicted(_) | Evidence::InDoubt(_) => Colour::Amber,
            Evidence::Agrees { .. }
            | Evidence::TooRough(_)
            | Evidence::Unread { .. }
            | Evidence::NotCompared { .. }
            | Evidence::NotMeasured { .. } => Colour::Green,
            Evidence::MarkedAssumed { farthest, .. } => match farthest {
                Some(of) if of.differs() => Colour::Amber,
                _ => Colour::Green,
            },
        }
    }

    /// The fixed word in English, as a key.
    pub fn key(&self) -> &'static str {
        match self {
            Evidence::Agrees { .. } => "agrees",
            Evidence::Contradicted(_) => "contradicted",
            Evidence::TooRough(_) => "too rough",
            Evidence::InDoubt(_) => "in doubt",
            Evidence::Unread { .. } => "not read",
            Evidence::NotCompared { .. } => "not compared",
            Evidence::MarkedAssumed { .. } => "marked assumed",
            Evidence::NotMeasured { .. } => "not measured",
        }
    }

    /// The fixed word: "not measured (calibrated to 2009)".
    pub fn words(&self, language: Language) -> String {
        text(self.said(), language)
    }

    fn said(&self) -> EvidenceSaid {
        match self {
            Evidence::Agrees { .. } => EvidenceSaid::Agrees,
            Evidence::Contradicted(_) => EvidenceSaid::Contradicted,
            Evidence::TooRough(of) => EvidenceSaid::TooRough(of.survey.clone()),
            Evidence::InDoubt(of) => EvidenceSaid::InDoubt(Both::of(|language| of.words(language))),
            Evidence::Unread { survey } => EvidenceSaid::Unread(survey.clone()),
            Evidence::NotCompared { survey } => EvidenceSaid::NotCompared(survey.clone()),
            Evidence::MarkedAssumed { survey, farthest } => {
                let survey = survey.clone();
                match farthest {
                    Some(of) => EvidenceSaid::MarkedAssumedApart {
                        survey,
                        direction: of.direction.clone(),
                        given: significant(of.measured_hz, 3),
                        computed: significant(of.computed_hz, 3),
                    },
                    None => EvidenceSaid::MarkedAssumed(survey),
                }
            }
            Evidence::NotMeasured {
                calibrated_to: Some(survey),
            } => EvidenceSaid::Calibrated(survey.clone()),
            Evidence::NotMeasured { calibrated_to: None } => EvidenceSaid::NotMeasured,
        }
    }
}
/// The lowest measured mode of translation.
pub fn lowest_measured(modes: &[SurveyMode]) -> Option<&SurveyMode> {
    let is_measured = |mode: &&SurveyMode| mode.kind == ModeKind::Translation && !mode.frequency.is_assumed();
    modes.iter().find(is_measured)
}

#[cfg(test)]
mod tests {
    use super::*;

    fn measured(measured_hz: f64, sd_hz: Option<f64>) -> MeasuredFrequency {
        MeasuredFrequency {
            survey: "2009".into(),
            direction: "x".into(),
            measured_hz,
            sd_hz,
            computed_hz: 2.0,
        }
    }

    #[test]
    fn holds_a_survey_contradicts_beyond_ten_per_cent_and_three_deviations() {
        for (measured_hz, sd_hz, word, colour) in [
            (2.0, None, "agrees", Colour::Green),
            (2.199, None, "agrees", Colour::Green),
            (2.201, None, "contradicted", Colour::Amber),
            (1.819, None, "agrees", Colour::Green),
            (1.817, None, "contradicted", Colour::Amber),
            (2.3, Some(0.11), "too rough", Colour::Green),
            (2.3, Some(0.09), "contradicted", Colour::Amber),
            // within ten per cent, whatever the scatter
            (2.1, Some(0.001), "agrees", Colour::Green),
            (2.3, Some(f64::NAN), "contradicted", Colour::Amber),
            (f64::NAN, None, "contradicted", Colour::Amber),
        ] {
            let found = Evidence::of_frequencies(vec![measured(measured_hz, sd_hz)]);
            assert_eq!(found.key(), word, "{measured_hz} {sd_hz:?}");
            assert_eq!(found.colour(), colour, "{measured_hz} {sd_hz:?}");
        }
    }

    #[test]
    fn holds_the_worst_direction_decides_and_nothing_compared_is_not_measured() {
        let all = vec![measured(2.0, None), measured(3.0, None), measured(2.5, None)];
        let rough = Evidence::of_frequencies(vec![measured(3.0, Some(0.5)), measured(2.1, None)]);
        assert_eq!(rough.key(), "agrees");
        assert_eq!(
            Evidence::of_frequencies(all),
            Evidence::Contradicted(measured(3.0, None))
        );
        let none = Evidence::NotMeasured {
            calibrated_to: Some("2009".into()),
        };
        assert_eq!(none.words(Language::English), "not measured (calibrated to 2009)");
        assert_eq!(none.colour(), Colour::Green);
    }
}
