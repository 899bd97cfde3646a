//! Changes from one survey to another, mode by mode.

use super::difference::Difference;
use super::history::HistoryEffect;
use super::notes::ChangeNote;
use super::temperature::FittedTemperature;
use crate::modal::{ModePair, ObservedMode};

/// Knowledge of the temperatures of two surveys.
#[derive(Clone, Debug, PartialEq)]
pub enum TemperatureKnowledge {
    /// One or both temperatures are unknown: a change may be due to the weather.
    NotMeasured,
    /// The temperatures are equal.
    Same,
    /// The temperatures differ, and their effect is unknown: a change may be due to the weather.
    Unexplained {
        /// Temperature after minus temperature before, °C.
        step_c: f64,
    },
    /// The temperatures differ, and their effect has been removed.
    Corrected {
        /// Temperature after minus temperature before, °C.
        step_c: f64,
    },
}

impl TemperatureKnowledge {
    /// Whether a change may be due to the weather.
    pub fn leaves_doubt(&self) -> bool {
        matches!(
            self,
            TemperatureKnowledge::NotMeasured | TemperatureKnowledge::Unexplained { .. }
        )
    }
}

/// One mode in both surveys.
#[derive(Clone, Debug, PartialEq)]
pub struct ModeChange {
    /// Confidence that both are the same mode.
    pub pair: ModePair,
    /// The mode in the earlier survey.
    pub from: ObservedMode,
    /// The mode in the later survey.
    pub to: ObservedMode,
    /// Change of the frequency, without the part that temperature explains, relative to the earlier frequency.
    pub frequency: Difference,
    /// Change of the damping ratio, relative to the earlier one; `None` if one of them is unknown.
    pub damping: Option<Difference>,
    /// Relative change of the frequency that temperature explains, or the season in a history without temperatures; `None` if unknown.
    pub explained_by_temperature: Option<f64>,
    /// The fitted line over temperature, if there is one.
    pub fitted: Option<FittedTemperature>,
    /// Effect of weather from a history of many surveys, if it is used.
    pub history: Option<HistoryEffect>,
    /// Whether a history of many surveys follows the mode without knowing the weather of one of the two surveys, so that its frequency is not
    /// tested.
    pub is_undecided: bool,
    /// The temperature coefficient that would explain the whole change, relative per °C; `None` if the temperatures do not differ.
    pub explaining_per_c: Option<f64>,
    /// Relative change of the stiffness if it changed uniformly and no mass changed: (1 + r)² - 1, near 2 r.
    pub uniform_stiffness: f64,
    /// Standard deviation of `uniform_stiffness`.
    pub uniform_stiffness_sd: Option<f64>,
}

/// Changes from one survey to another.
#[derive(Clone, Debug, PartialEq)]
pub struct SurveyChange {
    /// Name of the survey before.
    pub from: String,
    /// Name of the survey after.
    pub to: String,
    /// Knowledge of the temperatures of the surveys.
    pub temperature: TemperatureKnowledge,
    /// Modes in both surveys, in the order of the earlier frequencies.
    pub modes: Vec<ModeChange>,
    /// Modes of the earlier survey without a partner.
    pub lost: Vec<ObservedMode>,
    /// Modes of the later survey without a partner.
    pub new: Vec<ObservedMode>,
    /// Probability of finding a change in any mode although there is none.
    pub significance: f64,
    /// Power for the smallest detectable changes.
    pub power: f64,
    /// Modes of the earlier survey without a partner, each with the later mode that it may have become.
    pub not_compared: Vec<NotCompared>,
    /// Frequencies before and after for an alternative pairing with more pairs; empty if there is none.
    pub other_pairing_hz: Vec<[f64; 2]>,
    /// Notes on the changes.
    pub notes: Vec<ChangeNote>,
}

/// A mode of the earlier survey without a partner.
#[derive(Clone, Debug, PartialEq)]
pub struct NotCompared {
    /// The mode.
    pub from: ObservedMode,
    /// Whether it is the lowest mode of its survey.
    pub is_lowest: bool,
    /// The mode that it may have become; `None` if no later mode is similar.
    pub may_be: Option<ObservedMode>,
    /// MAC of both modes, if their shapes are known.
    pub assurance: Option<f64>,
}

impl NotCompared {
    /// If both are the same mode: relative change of its frequency and of its stiffness, for a uniform change.
    pub fn change(&self) -> Option<[f64; 2]> {
        let r = self.may_be.as_ref()?.frequency_hz / self.from.frequency_hz - 1.0;
        Some([r, r * (2.0 + r)])
    }
}

impl SurveyChange {
    /// Number of frequencies that were tested.
    pub fn tested(&self) -> usize {
        self.modes
            .iter()
            .filter(|m| m.frequency.evidence.is_some())
            .count()
    }

    /// Modes with a significant change of frequency.
    pub fn changed(&self) -> impl Iterator<Item = &ModeChange> {
        let significant = |d: &Difference| d.evidence.as_ref().is_some_and(|e| e.significant);
        self.modes.iter().filter(move |m| significant(&m.frequency))
    }

    /// Number of damping ratios that were tested.
    pub fn damping_tested(&self) -> usize {
        let known = |m: &&ModeChange| m.damping.as_ref().is_some_and(|d| d.evidence.is_some());
        self.modes.iter().filter(known).count()
    }

    /// Modes with a significant change of the damping ratio, and the change.
    pub fn damping_changed(&self) -> impl Iterator<Item = (&ModeChange, &Difference)> {
        let known = self.modes.iter().filter_map(|m| Some((m, m.damping.as_ref()?)));
        known.filter(|(_, d)| d.evidence.as_ref().is_some_and(|e| e.significant))
    }

    /// Smallest relative change of frequency that would have been found in every tested mode; `None` if no mode was tested.
    pub fn detectable(&self) -> Option<f64> {
        let all = self.modes.iter().filter_map(|m| m.frequency.evidence.as_ref());
        all.map(|e| e.detectable).max_by(f64::total_cmp)
    }
}
