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
    /// None of the followed modes was found, although earlier surveys have them.
    NotFound {
        /// Their frequencies, Hz.
        frequencies_hz: Vec<f64>,
    },
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
        (None, None) => not_found(answer, at),
    }
}

/// The followed modes that a survey without any of them should have.
fn not_found(answer: &WatchAnswer, at: usize) -> Verdict {
    let lost = answer.watched.lost.iter().filter(|lost| lost.since <= at);
    let tracks = lost.filter_map(|lost| Some(&answer.watched.modes.get(lost.mode)?.track));
    let frequencies_hz: Vec<f64> = tracks.map(|track| track.frequency_hz).collect();
    match frequencies_hz.is_empty() {
        true => Verdict::NoMode,
        false => Verdict::NotFound { frequencies_hz },
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use crate::progress::Silent;
    use dolmen_records::NoFiles;

    /// Daily surveys of two modes; in the last one both are a quarter lower, or the upper one alone.
    fn last(of_last: [f64; 2]) -> Verdict {
        let survey = |day: usize| {
            let [a, b] = match day {
                25 => of_last,
                _ => [1.97, 4.93].map(|hz| hz * (1.0 + 1e-4 * ((7 * day) % 5) as f64)),
            };
            format!(
                "[survey.2024-07-{day:02}]\nfrequencies.x = [{{ value = {a}, sd = 0.002 }}, {{ value = {b}, sd = 0.005 }}]\n"
            )
        };
        let surveys: String = (1..=25).map(survey).collect();
        let text = format!("schema = 1\nkind = \"survey\"\nname = \"Tower\"\n{surveys}");
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        let answer = crate::watch::watch(&opened, &NoFiles, &Silent).unwrap();
        verdict(&answer, "2024-07-25")
    }

    #[test]
    fn holds_modes_that_moved_out_of_sight_are_named() {
        let Verdict::NotFound { frequencies_hz } = last([1.497, 3.894]) else {
            panic!("{:?}", last([1.497, 3.894]))
        };
        let near = |hz: f64, of: f64| (hz / of - 1.0).abs() < 1e-3;
        assert!(
            matches!(frequencies_hz.as_slice(), [a, b] if near(*a, 1.97) && near(*b, 4.93)),
            "{frequencies_hz:?}"
        );
        assert!(matches!(
            last([1.9705, 4.931]),
            Verdict::AsPredicted { modes: 2, .. }
        ));
    }
}
