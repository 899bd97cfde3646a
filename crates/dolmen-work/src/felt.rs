//! Earthquakes at the structure, and whether an inspection followed.

use crate::compared_readings::has_modes;
use crate::dated_works::works_by_day;
use crate::survey_dates::{date, day_of};
use crate::watched::WatchedEarthquake;
use dolmen::monitoring::ANSWERED_DAYS;
use dolmen_project::{EarthquakePart, Project, Survey, WorkKind, WorkPart};

/// Earthquakes by time: those stated in surveys, and those in `found`, from their records.
pub fn felt(project: &Project, found: impl Fn(&Survey) -> Option<EarthquakePart>) -> Vec<WatchedEarthquake> {
    let mut earthquakes = Vec::new();
    let mut last_day = f64::NEG_INFINITY;
    for survey in &project.surveys {
        let Some(day) = date(&survey.name).map(day_of) else {
            continue;
        };
        if is_usable(survey) {
            last_day = last_day.max(day);
        }
        let part = survey.earthquake.or_else(|| found(survey));
        earthquakes.extend(part.map(|part| WatchedEarthquake {
            survey: survey.name.clone(),
            day,
            part,
            is_answered: false,
        }));
    }
    set_answered(&mut earthquakes, &works_by_day(project), last_day);
    earthquakes
}

/// Whether a survey examines the structure.
pub(crate) fn is_usable(survey: &Survey) -> bool {
    has_modes(survey) || !survey.tilt.is_empty() || survey.earthquake.is_some()
}

/// Whether a work examines the structure.
pub(crate) fn answers(work: &WorkPart) -> bool {
    matches!(work.kind, WorkKind::Repair | WorkKind::Inspection)
}

/// Sorts earthquakes, and marks those followed by a repair or an inspection. A work long after `last_day`, the day of the last survey,
/// does not count: it is planned, or a mistake.
pub(crate) fn set_answered(earthquakes: &mut [WatchedEarthquake], works: &[(f64, WorkPart)], last_day: f64) {
    for own in &mut *earthquakes {
        let newest = own.day.max(last_day) + ANSWERED_DAYS;
        let mut later = works
            .iter()
            .filter(|(day, _)| (own.day.floor()..=newest).contains(day));
        own.is_answered = later.any(|(_, work)| answers(work));
    }
    earthquakes.sort_by(|a, b| a.day.total_cmp(&b.day));
}
