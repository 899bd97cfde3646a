//! Evidence: is the model the structure? Frequencies of a survey against those of the model.

use super::colour::Colour;
use crate::building::BuildingAnswer;
use crate::state::{Check, FREQUENCY_RATIO_MOST};
use crate::survey_dates::date;
use dolmen_project::{Evidence as Source, ModeKind, Project, Survey, SurveyMode};
use dolmen_words::Language;

/// Standard deviations of a measured frequency within which a model may differ from it. Chosen here: 1 in 400 by chance.
const DEVIATIONS_MOST: f64 = 3.0;

/// The fixed words.
#[derive(Clone, Debug, PartialEq)]
pub enum Evidence {
    /// The latest survey has the frequencies of the model.
    Agrees {
        /// The survey.
        survey: String,
    },
    /// The latest survey has another frequency than the model.
    Contradicted(MeasuredFrequency),
    /// A survey measured frequencies, but the model has none to hold against them: its stiffness is not known.
    NotCompared {
        /// The survey.
        survey: String,
    },
    /// No survey measured what the model can be compared with, or that one is what its stiffness was identified from.
    NotMeasured {
        /// The survey that the stiffness was identified from.
        calibrated_to: Option<String>,
    },
}

/// A measured frequency beside that of the model.
#[derive(Clone, Debug, PartialEq)]
pub struct MeasuredFrequency {
    /// The survey.
    pub survey: String,
    /// Direction of the mode.
    pub direction: String,
    /// Lowest measured frequency of translation, Hz.
    pub measured_hz: f64,
    /// Its standard deviation, Hz; `None` where none was measured.
    pub sd_hz: Option<f64>,
    /// Lowest frequency of the model, Hz.
    pub computed_hz: f64,
}

impl MeasuredFrequency {
    /// ln of the larger over the smaller: 0 where they are the same.
    fn apart(&self) -> f64 {
        (self.measured_hz / self.computed_hz).ln().abs()
    }

    /// Whether they differ by more than [`FREQUENCY_RATIO_MOST`], whatever the scatter.
    pub fn differs(&self) -> bool {
        self.apart() > FREQUENCY_RATIO_MOST.ln()
    }

    /// Whether they are the same: within [`FREQUENCY_RATIO_MOST`], or three standard deviations. NaN is not.
    fn agrees(&self) -> bool {
        let within = |sd_hz: f64| (self.measured_hz - self.computed_hz).abs() <= DEVIATIONS_MOST * sd_hz;
        self.apart() <= FREQUENCY_RATIO_MOST.ln() || self.sd_hz.is_some_and(within)
    }
}

impl Evidence {
    /// What the latest survey that measured a frequency says of a model, in the worst direction.
    ///
    /// Surveys whose names begin with a date come after those without, and of the same date the last of the file is the latest.
    /// A survey that stiffness was identified from says nothing for it where it agrees, and contradicts it like any other where it does not.
    pub fn of(project: &Project, check: &Check) -> Evidence {
        let measured = project.surveys.iter().filter(|survey| {
            let mut directions = survey.modes.values();
            directions.any(|modes| lowest_measured(modes).is_some())
        });
        let Some(latest) = measured.max_by_key(|survey| date(&survey.name)) else {
            return Evidence::none();
        };
        let measured = measured_frequencies(std::slice::from_ref(latest), check);
        if measured.is_empty() {
            return Evidence::NotCompared {
                survey: latest.name.clone(),
            };
        }
        match Evidence::of_frequencies(measured) {
            Evidence::Agrees { survey } if project.identified_from().contains(survey.as_str()) => {
                Evidence::NotMeasured {
                    calibrated_to: Some(survey),
                }
            }
            found => found,
        }
    }

    /// What the frequencies of one survey say.
    fn of_frequencies(measured: Vec<MeasuredFrequency>) -> Evidence {
        let survey = measured.first().map(|of| of.survey.clone());
        let differing = measured.into_iter().filter(|of| !of.agrees());
        let worst = differing.max_by(|a, b| a.apart().total_cmp(&b.apart()));
        match (worst, survey) {
            (Some(worst), _) => Evidence::Contradicted(worst),
            (None, Some(survey)) => Evidence::Agrees { survey },
            (None, None) => Evidence::NotMeasured { calibrated_to: None },
        }
    }

    /// Nothing was measured.
    pub fn none() -> Evidence {
        Evidence::NotMeasured { calibrated_to: None }
    }

    /// Whether a survey contradicts the model.
    pub fn is_contradicted(&self) -> bool {
        matches!(self, Evidence::Contradicted(_))
    }

    /// Its colour.
    pub fn colour(&self) -> Colour {
        match self {
            Evidence::Contradicted(_) => Colour::Amber,
            Evidence::Agrees { .. } | Evidence::NotCompared { .. } | Evidence::NotMeasured { .. } => {
                Colour::Green
            }
        }
    }

    /// The fixed word in English, as a key.
    pub fn key(&self) -> &'static str {
        match self {
            Evidence::Agrees { .. } => "agrees",
            Evidence::Contradicted(_) => "contradicted",
            Evidence::NotCompared { .. } => "not compared",
            Evidence::NotMeasured { .. } => "not measured",
        }
    }

    /// The fixed word: "not measured (calibrated to 2009)".
    pub fn words(&self, language: Language) -> String {
        let word = match self {
            Evidence::Agrees { .. } => language.pick("agrees", "계측과 일치"),
            Evidence::Contradicted(_) => language.pick("contradicted", "계측과 불일치"),
            Evidence::NotCompared { .. } => language.pick("not compared", "비교 불가"),
            Evidence::NotMeasured { .. } => language.pick("not measured", "계측 없음"),
        };
        match self {
            Evidence::NotCompared { survey } => language.pick(
                format!(
                    "{word} with survey {survey}: the model has no frequency, its stiffness is not given"
                ),
                format!("{word}({survey} 조사의 고유진동수는 있으나 모델의 강성이 주어지지 않음)"),
            ),
            Evidence::NotMeasured {
                calibrated_to: Some(survey),
            } => language.pick(
                format!("{word} (calibrated to {survey})"),
                format!("{word}({survey} 조사에 보정)"),
            ),
            _ => word.to_owned(),
        }
    }
}

/// The lowest measured frequency of every survey and direction that the model has a frequency for, in the order of the file.
pub fn measured_frequencies(surveys: &[Survey], check: &Check) -> Vec<MeasuredFrequency> {
    let each = surveys
        .iter()
        .flat_map(|survey| survey.modes.iter().map(move |of| (survey, of)));
    let compared = each.flat_map(|(survey, (direction, modes))| {
        let translation = lowest_measured(modes).map(|mode| (direction.as_str(), mode));
        let torsion = lowest_torsion(modes).map(|mode| ("torsion", mode));
        translation.into_iter().chain(torsion).map(move |of| (survey, of))
    });
    let compared = compared.filter_map(|(survey, (direction, mode))| {
        let measured = &mode.frequency;
        let is_measured = |sd_hz: &f64| *sd_hz > 0.0 && measured.cov_source != Some(Source::Assumed);
        Some(MeasuredFrequency {
            survey: survey.name.clone(),
            direction: direction.to_owned(),
            measured_hz: measured.value,
            sd_hz: Some(measured.standard_deviation()).filter(is_measured),
            computed_hz: first_frequency(check, direction)?,
        })
    });
    compared.collect()
}

/// The lowest mode of translation whose frequency was measured.
pub fn lowest_measured(modes: &[SurveyMode]) -> Option<&SurveyMode> {
    let is_measured = |mode: &&SurveyMode| mode.kind == ModeKind::Translation && !mode.frequency.is_assumed();
    modes.iter().find(is_measured)
}

/// The lowest mode of torsion whose frequency was measured.
fn lowest_torsion(modes: &[SurveyMode]) -> Option<&SurveyMode> {
    let is_measured = |mode: &&SurveyMode| mode.kind == ModeKind::Torsion && !mode.frequency.is_assumed();
    modes.iter().find(is_measured)
}

/// Lowest frequency of a model in a direction, Hz.
fn first_frequency(check: &Check, direction: &str) -> Option<f64> {
    match check {
        // chains and frames do not twist
        Check::Chain(_) if direction == "torsion" => None,
        Check::Chain(chain) => chain.modes.first().map(|mode| mode.frequency_hz),
        Check::Frame(all) => {
            let own = all.iter().find(|d| d.direction == direction);
            let first = own.and_then(|d| d.check.modes.first());
            first.map(|mode| mode.frequency_hz)
        }
        Check::Stack(stack) => {
            let known = stack.frequencies.as_ref();
            known.and_then(|known| known.sway(direction)).map(|(_, hz)| hz)
        }
        Check::Building(answer) => first_sway(answer, direction).map(|(frequency_hz, _)| frequency_hz),
    }
}

/// Frequency, Hz, and damping ratio of the mode of a building that has the most mass along "x" or "y", or the most moment of inertia:
/// "torsion".
pub fn first_sway(answer: &BuildingAnswer, direction: &str) -> Option<(f64, f64)> {
    let axis = match direction {
        "x" => 0,
        "y" => 1,
        "torsion" => 2,
        _ => return None,
    };
    let standing = answer.stands.as_ref()?;
    let pairs = standing.modes.modes.iter().zip(&standing.damping_ratios);
    let largest = pairs.reduce(|most, own| {
        let more = own.0.effective_mass[axis] > most.0.effective_mass[axis];
        if more { own } else { most }
    });
    largest.map(|(mode, damping_ratio)| (mode.frequency_hz, *damping_ratio))
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
            (2.3, Some(0.11), "agrees", Colour::Green),
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
