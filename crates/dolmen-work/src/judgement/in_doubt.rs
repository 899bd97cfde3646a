//! Doubts about a model whose lowest frequencies were measured: higher modes, modes that no stiffness explains, and another stiffness.

use super::measured_frequency::{RecordFrequency, apart, contradict};
use super::said::{DoubtSaid, text};
use dolmen_words::Language;
use dolmen_words::number::significant;

/// Results of surveys, in addition to the values in the file.
#[derive(Clone, Debug, Default)]
pub(crate) struct FromRecords {
    /// The lowest frequencies of their records.
    pub(crate) lowest: Vec<RecordFrequency>,
    /// Possible doubts about the model, one entry per survey.
    pub(crate) doubts: Vec<SurveyDoubts>,
}

/// Evidence of one survey against the model.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct SurveyDoubts {
    /// Name of the survey.
    pub(crate) survey: String,
    /// Modes of the survey paired with those of the model.
    pub(crate) modes: Vec<PairedMode>,
    /// Modes that no stiffness explains.
    pub(crate) unexplained: Option<Unexplained>,
    /// The identified stiffness that differs most from the file.
    pub(crate) stiffness: Option<OtherStiffness>,
}

/// A mode of the model without a measured partner, below the highest paired mode.
#[derive(Clone, Debug, PartialEq)]
pub struct MissedMode {
    /// The survey.
    pub survey: String,
    /// Direction of the mode.
    pub direction: String,
    /// Number of the mode of the model, from 1.
    pub number: usize,
    /// Frequency of the model, Hz.
    pub computed_hz: f64,
}

/// A measured mode and its partner in the model.
#[derive(Clone, Debug, PartialEq)]
pub struct PairedMode {
    /// The survey.
    pub survey: String,
    /// Direction of the mode; `None` if it was paired only by its shape.
    pub direction: Option<String>,
    /// Number of the model's mode, from 1, in its direction if it has one.
    pub number: usize,
    /// Measured frequency, Hz.
    pub measured_hz: f64,
    /// Standard deviation of the measured frequency, Hz; `None` if unknown.
    pub sd_hz: Option<f64>,
    /// Frequency of the model, Hz.
    pub computed_hz: f64,
}

/// Measured modes that no stiffness of the model explains.
#[derive(Clone, Debug, PartialEq)]
pub struct Unexplained {
    /// The direction; `None` for modes of all directions together.
    pub direction: Option<String>,
    /// Root mean square misfit of the best stiffness, in standard deviations; `None` if no stiffness was found.
    pub deviations: Option<f64>,
}

/// A stiffness identified from a survey that differs from the file beyond scatter.
#[derive(Clone, Debug, PartialEq)]
pub struct OtherStiffness {
    /// The direction; `None` for the stiffness in plan.
    pub direction: Option<String>,
    /// Ratio of the spring that differs most to that of the file.
    pub ratio: f64,
    /// Difference of this spring in combined standard deviations; `None` if no deviation is known.
    pub deviations: Option<f64>,
}

/// Reasons for doubt about the model: a mode, unexplained modes, another stiffness, or several of these.
#[derive(Clone, Debug, PartialEq)]
pub struct InDoubt {
    /// The survey.
    pub survey: String,
    /// The mode with the largest difference, among those that differ by more than 10 % and three standard deviations.
    pub mode: Option<PairedMode>,
    /// Number of such modes.
    pub modes: usize,
    /// Modes of the model that the survey missed, according to the pairing.
    pub missed: Vec<MissedMode>,
    /// Measured modes that no stiffness explains.
    pub unexplained: Option<Unexplained>,
    /// The identified stiffness that differs most from the file.
    pub stiffness: Option<OtherStiffness>,
}

impl InDoubt {
    /// Doubts from the higher modes of the file, from missed modes, and from the results of this survey; `None` if there is no doubt.
    pub(super) fn of(
        survey: String,
        (higher, missed): (Vec<PairedMode>, Vec<MissedMode>),
        found: &[SurveyDoubts],
    ) -> Option<InDoubt> {
        let own = found.iter().find(|of| of.survey == survey);
        let paired = own.into_iter().flat_map(|own| own.modes.clone());
        let all = higher.into_iter().chain(paired);
        let off: Vec<PairedMode> = all.filter(PairedMode::contradicts).collect();
        let modes = off.len();
        let worst = off.into_iter().max_by(|a, b| a.apart().total_cmp(&b.apart()));
        let unexplained = own.and_then(|own| own.unexplained.clone());
        let stiffness = own.and_then(|own| own.stiffness.clone());
        let is_any = worst.is_some() || unexplained.is_some() || stiffness.is_some();
        is_any.then(|| InDoubt {
            survey: worst.as_ref().map_or(survey, |mode| mode.survey.clone()),
            mode: worst,
            modes,
            missed,
            unexplained,
            stiffness,
        })
    }

    /// "mode 3 in direction x 3.60 Hz measured, 8.00 Hz modelled, −55 % (survey 2026-04-02)".
    pub fn words(&self, language: Language) -> String {
        let mode = self
            .mode
            .as_ref()
            .map(|mode| mode.words(self.modes - 1, language));
        let unexplained = self.unexplained.as_ref().map(|of| of.words(language));
        let missed = self.missed.iter().map(|of| of.words(language));
        let stiffness = self.stiffness.as_ref().map(|of| of.words(language));
        let said = mode.into_iter().chain(missed).chain(unexplained).chain(stiffness);
        let said: Vec<String> = said.collect();
        let of_survey = DoubtSaid::OfSurvey {
            said: said.join("; ").into(),
            survey: self.survey.clone(),
        };
        text(of_survey, language)
    }
}

impl MissedMode {
    fn words(&self, language: Language) -> String {
        let unpaired = DoubtSaid::Unpaired {
            number: self.number,
            direction: self.direction.clone(),
            computed: significant(self.computed_hz, 3),
        };
        text(unpaired, language)
    }
}

impl PairedMode {
    fn apart(&self) -> f64 {
        apart(self.measured_hz, self.computed_hz)
    }

    fn contradicts(&self) -> bool {
        contradict(self.measured_hz, self.sd_hz, self.computed_hz)
    }

    fn words(&self, further: usize, language: Language) -> String {
        let percent = 100.0 * (self.measured_hz / self.computed_hz - 1.0);
        let number = self.number;
        let mode = match &self.direction {
            Some(direction) if direction == "torsion" => DoubtSaid::OfTorsion(number),
            Some(direction) => DoubtSaid::Along {
                number,
                direction: direction.clone(),
            },
            None => DoubtSaid::OfModel(number),
        };
        let apart = DoubtSaid::Apart {
            mode: mode.into(),
            measured: significant(self.measured_hz, 3),
            computed: significant(self.computed_hz, 3),
            change: format!("{percent:+.0} %").replace('-', "−"),
        };
        match further {
            0 => text(apart, language),
            more => text(
                DoubtSaid::ApartAndMore {
                    apart: apart.into(),
                    more,
                },
                language,
            ),
        }
    }
}

impl Unexplained {
    fn words(&self, language: Language) -> String {
        let unexplained = match &self.direction {
            Some(direction) => DoubtSaid::UnexplainedAlong(direction.clone()),
            None => DoubtSaid::Unexplained,
        };
        match self.deviations {
            Some(off) => text(
                DoubtSaid::BestOff {
                    unexplained: unexplained.into(),
                    deviations: significant(off, 2),
                },
                language,
            ),
            None => text(unexplained, language),
        }
    }
}

impl OtherStiffness {
    fn words(&self, language: Language) -> String {
        let ratio = significant(self.ratio, 3);
        let found = match &self.direction {
            Some(direction) => DoubtSaid::StiffnessAlong {
                direction: direction.clone(),
                ratio,
            },
            None => DoubtSaid::StiffnessInPlan { ratio },
        };
        match self.deviations {
            Some(off) => text(
                DoubtSaid::StiffnessOff {
                    found: found.into(),
                    deviations: significant(off, 2),
                },
                language,
            ),
            None => text(found, language),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn mode(number: usize, measured_hz: f64, sd_hz: Option<f64>) -> PairedMode {
        PairedMode {
            survey: "2026-04-02".into(),
            direction: Some("x".into()),
            number,
            measured_hz,
            sd_hz,
            computed_hz: 8.0,
        }
    }

    #[test]
    fn holds_a_higher_mode_far_from_the_model_leaves_it_in_doubt() {
        let of = |modes| InDoubt::of("2026-04-02".into(), (modes, Vec::new()), &[]);
        assert_eq!(of(vec![mode(2, 8.7, None), mode(3, 10.0, Some(0.7))]), None);
        let found = of(vec![mode(2, 9.0, Some(0.1)), mode(3, 3.6, Some(0.1))]).unwrap();
        assert_eq!(
            found.words(Language::English),
            "mode 3 in direction x 3.60 Hz measured, 8.00 Hz modelled, −55 % and 1 more off (survey 2026-04-02)"
        );
        assert_eq!(
            found.words(Language::Korean),
            "2026-04-02 조사: x 방향 3차 모드 실측 3.60 Hz, 모델 8.00 Hz, −55 % 외 1개 모드"
        );
    }

    #[test]
    fn holds_modes_that_no_stiffness_explains_leave_the_model_in_doubt() {
        let found = SurveyDoubts {
            survey: "2026-04-02".into(),
            modes: Vec::new(),
            unexplained: Some(Unexplained {
                direction: None,
                deviations: Some(5.23),
            }),
            stiffness: None,
        };
        let doubt = InDoubt::of(
            "2026-04-02".into(),
            Default::default(),
            std::slice::from_ref(&found),
        )
        .unwrap();
        assert_eq!(
            doubt.words(Language::English),
            "no stiffness explains the measured modes, the best is 5.2 standard deviations off (survey 2026-04-02)"
        );
        // these doubts come from one survey; another survey has none
        assert_eq!(
            InDoubt::of("2020-01-01".into(), Default::default(), &[found]),
            None
        );
    }

    #[test]
    fn holds_another_stiffness_leaves_a_model_in_doubt_whose_lowest_frequency_agrees() {
        let found = SurveyDoubts {
            survey: "2024-05-01".into(),
            modes: Vec::new(),
            unexplained: None,
            stiffness: Some(OtherStiffness {
                direction: Some("x".into()),
                ratio: 0.882,
                deviations: Some(51.2),
            }),
        };
        let doubt = InDoubt::of("2024-05-01".into(), Default::default(), &[found]).unwrap();
        assert_eq!(
            doubt.words(Language::English),
            "the stiffness found in direction x is 0.882 times that of the file where it differs most, 51 standard deviations apart (survey \
             2024-05-01)"
        );
    }
}
