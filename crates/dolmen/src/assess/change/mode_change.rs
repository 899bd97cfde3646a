//! Changes from one survey to another, mode by mode.

use super::difference::Difference;
use super::history::HistoryEffect;
use super::notes::ChangeNote;
use super::temperature::FittedTemperature;
use crate::modal::{ModePair, ObservedMode};

/// Knowledge of the temperatures of two surveys.
#[derive(Clone, Debug, PartialEq)]
pub enum TemperatureKnowledge {
    /// One of them, or both, are unknown: a change may be the weather's.
    NotMeasured,
    /// The temperatures are equal.
    Same,
    /// The temperatures differ, and their effect is unknown: a change may be due to the weather.
    Unexplained {
        /// After less before, °C.
        step_c: f64,
    },
    /// The temperatures differ, and their effect has been removed.
    Corrected {
        /// After less before, °C.
        step_c: f64,
    },
}

impl TemperatureKnowledge {
    /// Whether a change may be the weather's.
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
    /// Confidence that they are one mode.
    pub pair: ModePair,
    /// Before.
    pub from: ObservedMode,
    /// After.
    pub to: ObservedMode,
    /// Change of the frequency, without the part that temperature explains, relative to the earlier frequency.
    pub frequency: Difference,
    /// Change of the damping ratio, relative to the earlier one; `None` if one of them is unknown.
    pub damping: Option<Difference>,
    /// Relative change of the frequency that temperature explains, or the season in a history without temperatures; `None` where it is unknown.
    pub explained_by_temperature: Option<f64>,
    /// The line over temperature, where one was fitted.
    pub fitted: Option<FittedTemperature>,
    /// Its difference by a history of many surveys, if in use.
    pub history: Option<HistoryEffect>,
    /// The coefficient that would explain the whole change, relative per °C; `None` where temperatures do not differ.
    pub explaining_per_c: Option<f64>,
    /// Relative change of the stiffness, were it the same everywhere and the mass as it was: (1 + r)² - 1, near 2 r.
    pub uniform_stiffness: f64,
    /// Standard deviation of that.
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
    /// Modes in both, by their frequency before.
    pub modes: Vec<ModeChange>,
    /// Modes before without a partner.
    pub lost: Vec<ObservedMode>,
    /// Modes after without a partner.
    pub new: Vec<ObservedMode>,
    /// Probability of a false finding: of any change although there is none.
    pub significance: f64,
    /// Power of the least detectable changes.
    pub power: f64,
    /// Modes before without a partner, and what each may be after, however far it moved.
    pub not_compared: Vec<NotCompared>,
    /// Frequencies before and after for an alternative pairing with more pairs; empty if there is none.
    pub other_pairing_hz: Vec<[f64; 2]>,
    /// Notes on the changes.
    pub notes: Vec<ChangeNote>,
}

/// A mode before without a partner.
#[derive(Clone, Debug, PartialEq)]
pub struct NotCompared {
    /// The mode before.
    pub from: ObservedMode,
    /// Whether it is the lowest of its survey.
    pub is_lowest: bool,
    /// The mode that it may have become; `None` if no later mode is similar.
    pub may_be: Option<ObservedMode>,
    /// Their MAC, where shapes are known.
    pub assurance: Option<f64>,
}

impl NotCompared {
    /// Relative change of the frequency, and of a stiffness that is the same everywhere, if the two are one mode.
    pub fn change(&self) -> Option<[f64; 2]> {
        let r = self.may_be.as_ref()?.frequency_hz / self.from.frequency_hz - 1.0;
        Some([r, r * (2.0 + r)])
    }
}

impl SurveyChange {
    /// Frequencies that were tested.
    pub fn tested(&self) -> usize {
        self.modes
            .iter()
            .filter(|m| m.frequency.evidence.is_some())
            .count()
    }

    /// Modes whose frequency changed beyond chance.
    pub fn changed(&self) -> impl Iterator<Item = &ModeChange> {
        let significant = |d: &Difference| d.evidence.as_ref().is_some_and(|e| e.significant);
        self.modes.iter().filter(move |m| significant(&m.frequency))
    }

    /// Damping ratios that were tested.
    pub fn damping_tested(&self) -> usize {
        let known = |m: &&ModeChange| m.damping.as_ref().is_some_and(|d| d.evidence.is_some());
        self.modes.iter().filter(known).count()
    }

    /// Modes whose damping ratio changed beyond chance, with the change.
    pub fn damping_changed(&self) -> impl Iterator<Item = (&ModeChange, &Difference)> {
        let known = self.modes.iter().filter_map(|m| Some((m, m.damping.as_ref()?)));
        known.filter(|(_, d)| d.evidence.as_ref().is_some_and(|e| e.significant))
    }

    /// Least relative change of frequency that would have been found in every mode tested; `None` if none was.
    pub fn detectable(&self) -> Option<f64> {
        let all = self.modes.iter().filter_map(|m| m.frequency.evidence.as_ref());
        all.map(|e| e.detectable).max_by(f64::total_cmp)
    }
}
