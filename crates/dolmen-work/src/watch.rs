//! The record of a structure over the years: every survey of a project in time.

use crate::change_fault::ChangeFault;
use crate::compare::surveyed;
use crate::days::{Days, days};
use crate::error::WorkError;
use crate::identify;
use crate::opened::Opened;
use crate::progress::Progress;
use crate::sensor_alarms::{SensorFaults, sensor_alarms};
use crate::survey_dates::{date, day_of};
use crate::surveyed::SurveyAnswer;
use crate::watched::{WatchAnswer, WatchedSurvey};
use dolmen::assess::Surveyed;
use dolmen::modal::{ObservedMode, Pairing};
use dolmen::monitoring::{
    History, HistorySurvey, TiltReading, Tracking, WatchOptions, Work, watch as watched,
};
use dolmen_project::{Project, Survey, WorkKind, WorkPart};
use dolmen_records::Files;
use std::collections::BTreeMap;

/// Surveys with modes, or with tilts, that a history needs.
pub const SURVEYS_LEAST: usize = 3;

/// Surveys from which on a report has a section on the years: with fewer no change is sought, and two are compared.
const REPORTED_LEAST: usize = 8;

/// Whether a project has surveys enough for a section of its report.
pub fn can_watch(project: &Project) -> bool {
    let usable = project
        .surveys
        .iter()
        .filter(|survey| date(&survey.name).is_some() && has_modes(survey));
    usable.count() >= REPORTED_LEAST
}

fn has_modes(survey: &Survey) -> bool {
    survey.records.is_some()
        || !survey.setups.is_empty()
        || survey.modes.values().any(|modes| !modes.is_empty())
}

/// What the surveys of a project say of its structure over the years.
///
/// # Errors
/// Fewer than three surveys with a date and modes, and with tilts; records that cannot be read.
pub fn watch(opened: &Opened, files: &dyn Files, progress: &dyn Progress) -> Result<WatchAnswer, WorkError> {
    let answers: Vec<SurveyAnswer> = opened
        .project
        .surveys
        .iter()
        .filter(|survey| survey.records.is_some() || !survey.setups.is_empty())
        .map(|survey| identify::found_in(survey, files, progress))
        .collect::<Result<_, _>>()?;
    watch_of(opened, &answers)
}

/// The same; `answers` hold what records gave.
///
/// # Errors
/// [`ChangeFault`].
pub fn watch_of(opened: &Opened, answers: &[SurveyAnswer]) -> Result<WatchAnswer, WorkError> {
    let faults = answers
        .iter()
        .map(|answer| (answer.name.clone(), answer.faults()));
    watch_surveys(opened, &faults.collect(), |survey| {
        surveyed(survey, answers.iter().find(|answer| answer.name == survey.name))
    })
}

/// The same; `observed` holds the modes of surveys with records and `faults` what was wrong with their channels, as a store keeps them.
///
/// # Errors
/// [`ChangeFault`].
pub fn watch_observed(
    opened: &Opened,
    observed: &BTreeMap<String, Vec<ObservedMode>>,
    faults: &SensorFaults,
) -> Result<WatchAnswer, WorkError> {
    watch_surveys(opened, faults, |survey| {
        let mut of = surveyed(survey, None);
        if let Some(modes) = observed.get(&survey.name) {
            of.modes.clone_from(modes);
        }
        of
    })
}

fn watch_surveys(
    opened: &Opened,
    faults: &SensorFaults,
    of: impl Fn(&Survey) -> Surveyed,
) -> Result<WatchAnswer, WorkError> {
    let project = &opened.project;
    let mut left_out = Vec::new();
    let mut surveys: Vec<HistorySurvey> = Vec::new();
    for survey in &project.surveys {
        let Some(when) = date(&survey.name).filter(|_| has_modes(survey) || !survey.tilt.is_empty()) else {
            left_out.push(survey.name.clone());
            continue;
        };
        surveys.push(history_survey(survey, day_of(when), of(survey)));
    }
    let tracking = Tracking {
        frequency_within: project
            .change
            .frequency_within
            .unwrap_or(Pairing::default().frequency_within),
        ..Tracking::default()
    };
    let Days {
        surveys: kept,
        several,
        left_out: of_one_day,
    } = days(surveys, &tracking).map_err(ChangeFault::from)?;
    left_out.extend(of_one_day);
    let with_modes = kept.iter().filter(|survey| !survey.modes.is_empty()).count();
    let with_tilts = kept.iter().filter(|survey| !survey.tilts.is_empty()).count();
    if with_modes.max(with_tilts) < SURVEYS_LEAST {
        return Err(ChangeFault::TooFewToWatch {
            given: with_modes.max(with_tilts),
            least: SURVEYS_LEAST,
        }
        .into());
    }
    let mut works: Vec<(f64, WorkPart)> = project
        .watch
        .works
        .iter()
        .filter_map(|work| Some((day_of(date(&work.date)?), work.clone())))
        .collect();
    works.sort_by(|a, b| a.0.total_cmp(&b.0));
    let history = History {
        works: works
            .iter()
            .map(|(day, work)| Work {
                day: *day,
                splits: work.kind == WorkKind::Repair,
                answers: matches!(work.kind, WorkKind::Repair | WorkKind::Inspection),
            })
            .collect(),
        surveys: kept,
    };
    let usual = WatchOptions::default();
    let options = WatchOptions {
        tracking,
        years_between_false_alarms: project
            .watch
            .years_between_false_alarms
            .unwrap_or(usual.years_between_false_alarms),
        tilt_limit: project.watch.tilt_limit,
        ..usual
    };
    let watched = watched(&history, &options).map_err(ChangeFault::from)?;
    Ok(WatchAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        surveys: history
            .surveys
            .iter()
            .map(|survey| WatchedSurvey {
                name: survey.name.clone(),
                day: survey.day,
                temperature_c: survey.temperature_c,
                frequencies_hz: survey.modes.iter().map(|mode| mode.frequency_hz).collect(),
                frequency_sds_hz: survey.modes.iter().map(|mode| mode.frequency_sd_hz).collect(),
            })
            .collect(),
        left_out,
        several,
        works,
        sensor_alarms: sensor_alarms(project, faults),
        watched,
    })
}

fn history_survey(survey: &Survey, day: f64, of: Surveyed) -> HistorySurvey {
    let tilts = survey.tilt.iter();
    HistorySurvey {
        name: of.name,
        day,
        temperature_c: of.temperature_c,
        modes: of.modes,
        tilts: tilts
            .map(|(direction, tilt)| TiltReading {
                direction: direction.clone(),
                datum: survey.datum.clone(),
                ratio: tilt.ratio,
            })
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen_records::NoFiles;

    fn leaning(x: [&str; 4], y: &str) -> WatchAnswer {
        let survey = |(i, x): (usize, &&str)| {
            format!(
                "[survey.202{i}-05-01]\ntilt = {{ x = \"{x}\", y = \"{y}\" }}\nfrequencies.x = [{{ value = 2.{i}, cov = 0.01 }}]\n"
            )
        };
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Pole\"\n[watch]\ntilt_limit = \"1/200\"\n{}",
            x.iter().enumerate().map(survey).collect::<String>()
        );
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        watch(&opened, &NoFiles, &crate::progress::Silent).unwrap()
    }

    #[test]
    fn exact_two_directions_lean_together() {
        // 1/250 along x and y are 1/177 together
        let answer = leaning(["1/250"; 4], "-1/250");
        let [lean] = answer.leans().try_into().unwrap();
        assert!(
            (lean.size - 2f64.sqrt() / 250.0).abs() < 1e-12 && answer.is_tilt_beyond(),
            "{lean:?}"
        );
        assert!(!leaning(["1/250"; 4], "1/900").is_tilt_beyond());
    }

    #[test]
    fn holds_readings_too_few_for_a_trend_count() {
        let mut answer = leaning(["1/900", "1/900", "1/900", "1/190"], "0");
        answer
            .watched
            .tilts
            .iter_mut()
            .for_each(|trend| trend.slope = None);
        assert!(answer.is_tilt_beyond());
    }
}
