//! The history of a structure: every survey of a project in time.

use crate::change_fault::ChangeFault;
use crate::compared_readings::has_modes;
use crate::dated_works::works_by_day;
use crate::days::{Days, days};
use crate::error::WorkError;
use crate::felt::{answers, is_usable, set_answered};
use crate::inspected::{inspected, inspections};
use crate::judgement::tilt_beyond_limit;
use crate::left_out::found_without;
use crate::logs::Logs;
use crate::modes_of_survey::surveyed;
use crate::opened::Opened;
use crate::progress::Progress;
use crate::same_record::refuse_same_records;
use crate::sensor_alarms::{SensorFaults, sensor_alarms};
use crate::survey_dates::{date, day_of};
use crate::surveyed::{Earthquake, SurveyAnswer};
use crate::told::told_both;
use crate::watched::{WatchAnswer, WatchedEarthquake, WatchedSurvey};
use crate::years_parts::{EXPLAINED_MOST, years_parts};
use dolmen::assess::Surveyed;
use dolmen::modal::{ObservedMode, Pairing};
use dolmen::monitoring::{
    History, HistorySurvey, TiltReading, Tracking, WatchOptions, Watched, Work, watch as watched,
};
use dolmen_project::{EarthquakePart, LogKind, Project, Survey, WorkKind};
use dolmen_records::Files;
use std::collections::BTreeMap;

/// Fewest surveys with modes, or with tilts, for a history.
pub const SURVEYS_LEAST: usize = 3;

/// Fewest surveys for a search for changes: with fewer only two are compared, and a report has no section on the years.
pub(crate) const CHANGES_LEAST: usize = 8;

/// Fewest inspections for a section on the years in a report: with fewer two are compared.
const INSPECTIONS_REPORTED_LEAST: usize = 3;

/// Whether a project has enough surveys or inspections for a section of its report, or a log of a tilt or crack.
pub fn can_watch(project: &Project) -> bool {
    let usable = project
        .surveys
        .iter()
        .filter(|survey| date(&survey.name).is_some() && (has_modes(survey) || !survey.tilt.is_empty()));
    let has_logs = project
        .watch
        .logs
        .iter()
        .any(|log| log.kind != LogKind::Temperature);
    let is_inspected = inspections(project).count() >= INSPECTIONS_REPORTED_LEAST;
    has_logs || is_inspected || usable.count() >= CHANGES_LEAST
}

/// The history of a structure from the surveys of a project.
///
/// # Errors
/// Fewer than three surveys with a date and modes, with tilts, and with inspections, and no log; records and logs that cannot be read. Failed
/// sensors and records without modes are left out.
pub fn watch(opened: &Opened, files: &dyn Files, progress: &dyn Progress) -> Result<WatchAnswer, WorkError> {
    refuse_same_records(opened.project.surveys.iter(), files)?;
    let (mut answers, mut failed, mut without_modes) = (Vec::new(), Vec::new(), Vec::new());
    for survey in &opened.project.surveys {
        if survey.records.is_some() || !survey.setups.is_empty() {
            match found_without(survey, files, progress) {
                Ok((answer, channels)) => {
                    if !channels.is_empty() {
                        failed.push((answer.name.clone(), channels));
                    }
                    answers.push(answer);
                }
                // one record must not hide the results of the others
                Err(why) if gives_no_modes(&why) => {
                    without_modes.push((survey.name.clone(), told_both(&why)));
                }
                Err(why) => return Err(why),
            }
        }
    }
    let mut answer = watch_of(opened, &answers, files)?;
    answer.sensors_left_out = failed;
    answer.without_modes = without_modes;
    Ok(answer)
}

/// Whether a record can be read but gives no modes: too short, or no vibration.
fn gives_no_modes(why: &WorkError) -> bool {
    match why {
        WorkError::Within { cause, .. } => gives_no_modes(cause),
        why => matches!(why, WorkError::Modal(_)),
    }
}

/// The same; `answers` contain the results of records.
///
/// # Errors
/// [`ChangeFault`]; logs that cannot be read.
pub fn watch_of(
    opened: &Opened,
    answers: &[SurveyAnswer],
    files: &dyn Files,
) -> Result<WatchAnswer, WorkError> {
    let mut answer = history_of(opened, answers, files)?;
    (answer.parts, answer.model_off) = years_parts(&opened.project, &answer.watched.modes, EXPLAINED_MOST);
    Ok(answer)
}

/// The same without the parts that explain its changes.
///
/// # Errors
/// As [`watch_of`].
pub(crate) fn history_of(
    opened: &Opened,
    answers: &[SurveyAnswer],
    files: &dyn Files,
) -> Result<WatchAnswer, WorkError> {
    let faults = answers
        .iter()
        .map(|answer| (answer.name.clone(), answer.faults()));
    let logs = Logs::read(&opened.project, files)?;
    let own = |survey: &Survey| answers.iter().find(|answer| answer.name == survey.name);
    watch_surveys(opened, &faults.collect(), &logs, |survey| {
        let own = own(survey);
        let mut of = surveyed(survey, own);
        if own.is_some_and(SurveyAnswer::is_shaken) {
            of.modes.clear();
        }
        let felt = own.and_then(SurveyAnswer::earthquake).filter(|of| of.is_one());
        (of, felt.map(Earthquake::part))
    })
}

/// Results of the records of surveys, by the name of the survey, in the form of a store.
#[derive(Clone, Debug, Default)]
pub struct Observed {
    /// Modes.
    pub modes: BTreeMap<String, Vec<ObservedMode>>,
    /// Faults of channels.
    pub faults: SensorFaults,
    /// The earthquakes in the records.
    pub earthquakes: BTreeMap<String, EarthquakePart>,
}

/// The same from the results in a store.
///
/// # Errors
/// [`ChangeFault`].
pub fn watch_observed(opened: &Opened, observed: &Observed, logs: &Logs) -> Result<WatchAnswer, WorkError> {
    watch_surveys(opened, &observed.faults, logs, |survey| {
        let mut of = surveyed(survey, None);
        if let Some(modes) = observed.modes.get(&survey.name) {
            of.modes.clone_from(modes);
        }
        (of, observed.earthquakes.get(&survey.name).copied())
    })
}

/// The same with the part of the model that explains the strongest change.
///
/// # Errors
/// [`ChangeFault`].
pub fn watch_stored(opened: &Opened, observed: &Observed, logs: &Logs) -> Result<WatchAnswer, WorkError> {
    let mut answer = watch_observed(opened, observed, logs)?;
    (answer.parts, answer.model_off) = years_parts(&opened.project, &answer.watched.modes, 1);
    Ok(answer)
}

/// The surveys that are followed.
#[derive(Default)]
struct Followed {
    surveys: Vec<HistorySurvey>,
    left_out: Vec<String>,
    earthquakes: Vec<WatchedEarthquake>,
    /// Number of surveys whose temperature comes from a log.
    temperatures_of_log: usize,
}

impl Followed {
    fn of(
        project: &Project,
        logs: &Logs,
        of: impl Fn(&Survey) -> (Surveyed, Option<EarthquakePart>),
    ) -> Self {
        let mut followed = Followed::default();
        for survey in &project.surveys {
            let dated = date(&survey.name);
            let Some(when) = dated.filter(|_| is_usable(survey)) else {
                // surveys with only an inspection are followed as well
                if dated.is_none() || survey.inspections.is_empty() {
                    followed.left_out.push(survey.name.clone());
                }
                continue;
            };
            let (own, found) = of(survey);
            let mut own = history_survey(survey, day_of(when), own);
            if let Some(part) = survey.earthquake.or(found) {
                followed.earthquakes.push(WatchedEarthquake {
                    survey: survey.name.clone(),
                    day: own.day,
                    part,
                    is_answered: false,
                });
                // a record of an earthquake does not describe the structure at rest; frequencies given in addition to it do
                if survey.earthquake.is_some() && (survey.records.is_some() || !survey.setups.is_empty()) {
                    own.modes.clear();
                }
                if own.modes.is_empty() && own.tilts.is_empty() {
                    continue;
                }
            }
            if own.temperature_c.is_none() {
                own.temperature_c = logs.temperature_c(&survey.name);
                followed.temperatures_of_log += usize::from(own.temperature_c.is_some());
            }
            followed.surveys.push(own);
        }
        followed
    }
}

/// The options of a watch, as the file gives them.
fn options_of(project: &Project) -> WatchOptions {
    let usual = WatchOptions::default();
    WatchOptions {
        tracking: Tracking {
            frequency_within: project
                .change
                .frequency_within
                .unwrap_or(Pairing::default().frequency_within),
            ..Tracking::default()
        },
        years_between_false_alarms: project
            .watch
            .years_between_false_alarms
            .unwrap_or(usual.years_between_false_alarms),
        tilt_limit: project.watch.tilt_limit,
        ..usual
    }
}

fn watch_surveys(
    opened: &Opened,
    faults: &SensorFaults,
    logs: &Logs,
    of: impl Fn(&Survey) -> (Surveyed, Option<EarthquakePart>),
) -> Result<WatchAnswer, WorkError> {
    let project = &opened.project;
    let Followed {
        surveys,
        mut left_out,
        mut earthquakes,
        temperatures_of_log,
    } = Followed::of(project, logs, of);
    let options = options_of(project);
    let Days {
        surveys: kept,
        several,
        left_out: of_one_day,
    } = days(surveys, &options.tracking).map_err(ChangeFault::from)?;
    left_out.extend(of_one_day);
    let with_modes = kept.iter().filter(|survey| !survey.modes.is_empty()).count();
    let with_tilts = kept.iter().filter(|survey| !survey.tilts.is_empty()).count();
    let are_too_few = with_modes.max(with_tilts) < SURVEYS_LEAST;
    let works = works_by_day(project);
    let last_survey = kept.last().map(|last| last.day);
    let inspected = inspected(project, &works, last_survey).map_err(ChangeFault::from)?;
    // one tilt suffices for a comparison with its limit, and so does one crack
    let is_beyond = tilt_beyond_limit(project).is_some() || inspected.beyond().next().is_some();
    let are_inspected = is_beyond || inspected.inspections.len() >= SURVEYS_LEAST;
    if are_too_few && !logs.are_watched() && !are_inspected && earthquakes.is_empty() {
        return Err(ChangeFault::TooFewToWatch {
            given: with_modes.max(with_tilts).max(inspected.inspections.len()),
            least: SURVEYS_LEAST,
        }
        .into());
    }
    let last_day = kept.last().map_or(f64::INFINITY, |last| last.day);
    set_answered(&mut earthquakes, &works, last_day);
    let history = History {
        works: works
            .iter()
            .map(|(day, work)| Work {
                day: *day,
                splits: work.kind == WorkKind::Repair,
                answers: answers(work),
            })
            .collect(),
        surveys: kept,
    };
    let watched = match are_too_few {
        true => Watched::nothing(options.significance),
        false => watched(&history, &options).map_err(ChangeFault::from)?,
    };
    let logs = logs.watched(&works, project.watch.tilt_limit)?;
    Ok(WatchAnswer {
        file: opened.file.clone(),
        project: opened.project.clone(),
        surveys: history.surveys.iter().map(watched_survey).collect(),
        left_out,
        several,
        works,
        earthquakes,
        sensor_alarms: sensor_alarms(project, faults),
        sensors_left_out: Vec::new(),
        without_modes: Vec::new(),
        temperatures_of_log,
        logs,
        inspected,
        parts: Vec::new(),
        model_off: None,
        watched,
    })
}

fn watched_survey(survey: &HistorySurvey) -> WatchedSurvey {
    WatchedSurvey {
        name: survey.name.clone(),
        day: survey.day,
        temperature_c: survey.temperature_c,
        frequencies_hz: survey.modes.iter().map(|mode| mode.frequency_hz).collect(),
        frequency_sds_hz: survey.modes.iter().map(|mode| mode.frequency_sd_hz).collect(),
        accepted: survey.modes.iter().map(|mode| mode.accepted).collect(),
    }
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
