//! The place of a new survey in the history.

use crate::survey_dates::day_of_a_record;
use crate::watched::WatchAnswer;
use dolmen::monitoring::{NotJudged, SensorChange};

/// Result for a survey in its history, or for its day if the day has several.
#[derive(Clone, Debug, PartialEq)]
pub enum Verdict {
    /// It confirms an open alarm.
    Alarm {
        /// Frequencies of the modes, Hz.
        frequencies_hz: Vec<f64>,
    },
    /// Its record contains an earthquake.
    Earthquake,
    /// A mode is outside the prediction: no alarm yet.
    Outside {
        /// Frequency of the mode farthest outside, Hz.
        frequency_hz: f64,
        /// Its score; 0 equals the prediction.
        score: f64,
    },
    /// As predicted.
    AsPredicted {
        /// Number of modes compared.
        modes: usize,
        /// The score farthest from 0.
        score: f64,
    },
    /// No mode was compared.
    NotJudged(NotJudged),
    /// None of the followed modes was found.
    NoMode,
    /// There are too few surveys.
    TooFew {
        /// Number of surveys with modes.
        given: usize,
        /// Number needed.
        least: usize,
    },
}

/// Scores beyond this are outside: 1 in 370 by chance.
const OUTSIDE: f64 = 3.0;

/// Index of the survey, or of its day, in a history.
fn place(answer: &WatchAnswer, survey: &str) -> Option<usize> {
    let day = day_of_a_record(survey);
    let is_it = |name: &str| name == survey || day.is_some_and(|day| name == day);
    answer.surveys.iter().position(|of| is_it(&of.name))
}

/// The sensor that was turned, moved or exchanged before a survey, found from its shapes.
pub fn sensor_change<'a>(answer: &'a WatchAnswer, survey: &str) -> Option<&'a SensorChange> {
    let at = place(answer, survey)?;
    answer.watched.tracked.sensors.iter().find(|of| of.survey == at)
}

/// The result for one survey of a history.
pub fn verdict(answer: &WatchAnswer, survey: &str) -> Verdict {
    let Some(at) = place(answer, survey) else {
        return Verdict::NoMode;
    };
    let modes = &answer.watched.modes;
    let mut confirmed: Vec<f64> = answer
        .watched
        .alarms
        .iter()
        .filter(|alarm| alarm.alarm.survey == at && !alarm.is_answered)
        .filter_map(|alarm| Some(modes.get(alarm.mode)?.track.frequency_hz))
        .collect();
    if answer.watched.is_mode_lost() {
        let lost = answer.watched.lost.iter().filter(|lost| lost.since <= at);
        let missing = lost.filter_map(|lost| Some(&modes.get(lost.mode)?.track));
        let missing = missing.filter(|track| track.modes.get(at).is_none_or(Option::is_none));
        confirmed.extend(missing.map(|track| track.frequency_hz));
    }
    if !confirmed.is_empty() {
        return Verdict::Alarm {
            frequencies_hz: confirmed,
        };
    }
    let judged = modes.iter().flat_map(|mode| {
        let of_it = mode.judged.judged.iter().filter(|judged| judged.survey == at);
        of_it.map(|judged| (mode.track.frequency_hz, judged.score))
    });
    let (mut scores, mut why) = (Vec::new(), None);
    for (frequency_hz, score) in judged {
        match score {
            Ok(score) => scores.push((frequency_hz, score)),
            Err(reason) => why = why.or(Some(reason)),
        }
    }
    let farthest = scores
        .iter()
        .copied()
        .max_by(|a, b| a.1.abs().total_cmp(&b.1.abs()));
    match (farthest, why) {
        (Some((frequency_hz, score)), _) if score.abs() > OUTSIDE => Verdict::Outside { frequency_hz, score },
        (Some((_, score)), _) => Verdict::AsPredicted {
            modes: scores.len(),
            score,
        },
        (None, Some(why)) => Verdict::NotJudged(why),
        (None, None) => Verdict::NoMode,
    }
}
