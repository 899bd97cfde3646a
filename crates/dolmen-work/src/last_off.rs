//! The last survey compared with the prediction from those before it.

use crate::watched::WatchAnswer;
use dolmen::monitoring::SurveyTSquared;
use dolmen_project::{WorkKind, WorkPart};

/// Scores beyond this are off: 1 in 370 by chance, as for the alarm.
const OFF_FROM: f64 = 3.0;

/// A mode of the last survey that is off its prediction.
#[derive(Clone, Copy, Debug, PartialEq, serde::Serialize)]
pub struct LastFarOff {
    /// Index of the mode.
    pub mode: usize,
    /// Its median frequency through the years, Hz.
    pub frequency_hz: f64,
    /// Relative difference from the predicted frequency.
    pub ratio: f64,
    /// Normal score of the difference: beyond ±3, 1 in 370 by chance.
    pub score: f64,
}

impl WatchAnswer {
    /// Modes of the last survey that are off their prediction, without a later repair or inspection; the farthest first.
    pub fn last_far_off(&self) -> Vec<LastFarOff> {
        let Some(last) = self
            .surveys
            .len()
            .checked_sub(1)
            .filter(|last| self.is_unanswered(*last))
        else {
            return Vec::new();
        };
        let each = self.watched.modes.iter().enumerate().filter_map(|(mode, of)| {
            let judged = of.judged.judged.last().filter(|judged| judged.survey == last)?;
            let score = judged.score.ok().filter(|score| score.abs() > OFF_FROM)?;
            let (expected, _) = judged.predicted?;
            let at = (*of.track.modes.get(last)?)?;
            let read_hz = *self.surveys[last].frequencies_hz.get(at)?;
            let predicted_hz = of.track.frequency_hz * (1.0 + expected);
            Some(LastFarOff {
                mode,
                frequency_hz: of.track.frequency_hz,
                ratio: read_hz / predicted_hz - 1.0,
                score,
            })
        });
        let mut all: Vec<LastFarOff> = each.collect();
        all.sort_by(|a, b| b.score.abs().total_cmp(&a.score.abs()));
        all
    }

    /// T² of all modes of the last survey, if it is beyond its limit without a later repair or inspection.
    pub fn last_t_squared(&self) -> Option<&SurveyTSquared> {
        let last = self.surveys.len().checked_sub(1)?;
        let found = self.watched.t_squared.last()?;
        (found.survey == last && found.value > found.limit && self.is_unanswered(last)).then_some(found)
    }

    /// Whether no repair or inspection is dated after a survey.
    pub fn is_unanswered(&self, survey: usize) -> bool {
        let answers = |(day, work): &&(f64, WorkPart)| {
            matches!(work.kind, WorkKind::Repair | WorkKind::Inspection) && !self.is_far_ahead(*day)
        };
        let answered_until = self.works.iter().rev().find(answers).map(|(day, _)| *day);
        let day = self.surveys.get(survey).map(|of| of.day);
        day.zip(answered_until).is_none_or(|(day, until)| until < day)
    }

    /// Whether a mode changed, or its last surveys are off, without a later repair or inspection.
    pub fn has_unanswered_change(&self) -> bool {
        let changed = self.watched.modes.iter().any(|mode| {
            let off = mode.last_off.map(|off| off.from);
            let changes = mode.changes.iter().map(|change| change.before);
            changes.chain(off).any(|survey| self.is_unanswered(survey))
        });
        changed || !self.last_far_off().is_empty() || self.last_t_squared().is_some()
    }
}
