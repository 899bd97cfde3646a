//! The history of all surveys, for a comparison of two.

use crate::change_fault::ChangeFault;
use crate::compared_history::{ComparedHistory, Course, LastingChange};
use crate::compared_readings::has_modes;
use crate::compared_surveys::ComparedSurveys;
use crate::error::WorkError;
use crate::opened::Opened;
use crate::survey_dates::{date, day_of};
use crate::surveyed::SurveyAnswer;
use crate::watch::{CHANGES_LEAST, history_of};
use crate::watched::{WatchAnswer, WatchedSurvey};
use dolmen::assess::HistoryEffect;
use dolmen::monitoring::{ChangeForm, WatchedMode};
use dolmen_project::{Project, Survey};
use dolmen_records::Files;

/// The history of all surveys, for a comparison of two.
pub(crate) struct Behind {
    pub(crate) told: ComparedHistory,
    /// The two surveys whose modes are compared: those asked for, or the first and the last whose weather is known.
    pub(crate) ends: [usize; 2],
    /// Its result for each mode found in both surveys.
    pub(crate) effects: Vec<HistoryEffect>,
    /// Frequencies in both surveys, Hz, of modes with unknown weather in one of them.
    pub(crate) undecided_hz: Vec<[f64; 2]>,
    /// Temperatures of both, from the file or its log.
    pub(crate) temperatures_c: [Option<f64>; 2],
}

/// Whether there is a history for two surveys: both have a date, and enough others have a date and modes.
pub(crate) fn has_history(project: &Project, both: [usize; 2]) -> bool {
    let day = |at: usize| date(&project.surveys[at].name);
    let dated = project
        .surveys
        .iter()
        .filter(|survey| date(&survey.name).is_some() && has_modes(survey));
    let [from, to] = both.map(day);
    from.is_some() && to.is_some() && from != to && dated.count() >= CHANGES_LEAST
}

/// The history for two surveys; `None` if it follows none of their modes.
///
/// # Errors
/// Logs that cannot be read; [`ChangeFault`].
pub(crate) fn behind(
    opened: &Opened,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
    files: &dyn Files,
) -> Result<Option<Behind>, WorkError> {
    let project = &opened.project;
    let both = [compared.from, compared.to];
    if !has_history(project, both) {
        return Ok(None);
    }
    let answer = match history_of(opened, answers, files) {
        Err(WorkError::Change(why)) if matches!(*why, ChangeFault::TooFewToWatch { .. }) => return Ok(None),
        answer => answer?,
    };
    let place = |at: usize| {
        let day = day_of(date(&project.surveys[at].name)?);
        answer.surveys.iter().position(|survey| survey.day == day)
    };
    let (Some(first), Some(last)) = (place(both[0]), place(both[1])) else {
        return Ok(None);
    };
    let [from, to] = comparable(&answer, [first, last], compared);
    let at = |place: usize, own: usize| match place == own {
        true => None,
        false => survey_at(project, &answer.surveys[place]),
    };
    let ends = [
        at(from, first).unwrap_or(both[0]),
        at(to, last).unwrap_or(both[1]),
    ];
    let passed_over = [first..from, to + 1..last + 1].into_iter().flatten();
    let passed_over = passed_over
        .map(|place| answer.surveys[place].name.clone())
        .collect();
    let effects = answer.watched.between(from, to);
    let undecided_hz = answer.watched.undecided_between(from, to);
    // a history whose record cannot be used has no information on weather and scatter
    let with_modes = || {
        answer
            .surveys
            .iter()
            .filter(|survey| !survey.frequencies_hz.is_empty())
    };
    let (Some(first), Some(last)) = (with_modes().next(), with_modes().next_back()) else {
        return Ok(None);
    };
    let told = ComparedHistory {
        surveys: with_modes().count(),
        span: [first.name.clone(), last.name.clone()],
        lasting: lasting(&answer, [from.min(to), from.max(to)]),
        passed_over,
    };
    let is_followed = !effects.is_empty() || !undecided_hz.is_empty();
    Ok(is_followed.then(|| Behind {
        told,
        ends,
        effects,
        undecided_hz,
        temperatures_c: [from, to].map(|at| answer.surveys[at].temperature_c),
    }))
}

/// The two surveys to compare, by their places in the history. An end that nobody named moves inwards to a survey whose weather is known.
fn comparable(answer: &WatchAnswer, [first, last]: [usize; 2], compared: &ComparedSurveys) -> [usize; 2] {
    let is_known = |place: &usize| answer.watched.is_weather_known(*place);
    let from = match compared.named.from {
        true => Some(first),
        false => (first..last).find(is_known),
    };
    let Some(from) = from else {
        return [first, last];
    };
    let to = match compared.named.to {
        true => Some(last),
        false => (from + 1..=last).rev().find(is_known),
    };
    to.map_or([first, last], |to| [from, to])
}

/// The survey of a place in the history: by its name, or one of its day if several of that day are combined.
fn survey_at(project: &Project, of: &WatchedSurvey) -> Option<usize> {
    let with_modes = |(i, survey): (usize, &Survey)| has_modes(survey).then_some((i, survey.name.clone()));
    let all: Vec<(usize, String)> = project
        .surveys
        .iter()
        .enumerate()
        .filter_map(with_modes)
        .collect();
    let by_name = all.iter().find(|(_, name)| *name == of.name);
    let by_day = || {
        all.iter()
            .find(|(_, name)| date(name).map(day_of) == Some(of.day))
    };
    by_name.or_else(by_day).map(|(i, _)| *i)
}

/// Lasting changes and effects of repairs after one survey and until another, by time.
fn lasting(answer: &WatchAnswer, [from, to]: [usize; 2]) -> Vec<LastingChange> {
    let mut all: Vec<(f64, LastingChange)> = Vec::new();
    for mode in &answer.watched.modes {
        all.extend(of_mode(answer, mode, [from, to]));
    }
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    all.into_iter().map(|(_, change)| change).collect()
}

fn of_mode(answer: &WatchAnswer, mode: &WatchedMode, [from, to]: [usize; 2]) -> Vec<(f64, LastingChange)> {
    let frequency_hz = mode.track.frequency_hz;
    let name = |survey: usize| answer.surveys[survey].name.clone();
    let changes = mode.changes.iter().filter(|change| match change.form {
        ChangeForm::Step => change.from > from && change.from <= to,
        ChangeForm::Slope => change.from < to,
    });
    let changes = changes.map(|change| {
        let course = match change.form {
            ChangeForm::Step => Course::Step {
                after: name(change.after),
                before: name(change.before),
            },
            ChangeForm::Slope => Course::Drift {
                since: name(change.after),
            },
        };
        let of = LastingChange {
            frequency_hz,
            course,
            ratio: change.ratio,
            sd: change.sd,
        };
        (answer.surveys[change.from].day, of)
    });
    let works = mode.works.iter().filter_map(|effect| {
        let (day, work) = answer.works.get(effect.work)?;
        let is_between = *day > answer.surveys[from].day && *day <= answer.surveys[to].day;
        is_between.then(|| {
            let of = LastingChange {
                frequency_hz,
                course: Course::Repair(work.clone()),
                ratio: effect.ratio,
                sd: effect.sd,
            };
            (*day, of)
        })
    });
    changes.chain(works).collect()
}
