//! Holds surveys against the model: frequencies of each survey and direction, and what they say of the model.

use super::as_of::AsOf;
use super::evidence::{Evidence, lowest_measured};
use super::in_doubt::{FromRecords, InDoubt, MissedMode};
use super::measured_frequency::{MeasuredFrequency, RecordFrequency, measured_sd};
use super::modes_along::{higher_modes, natural_modes, pairs_along};
use crate::building::BuildingAnswer;
use crate::state::Check;
use crate::survey_dates::date;
use dolmen::blocks::StackMode;
use dolmen::damper::lowest_seen;
use dolmen_project::{ModeKind, Project, Quantity, Survey, SurveyMode};

/// Smallest share of the kinetic energy of a stack's mode along a direction for a mode of it, as for its first sway.
const ALONG_LEAST: f64 = 0.25;

impl Evidence {
    /// Evidence of surveys for a model, in the worst direction; for each direction the latest survey with a frequency counts.
    ///
    /// Surveys whose names begin with a date are later than those without; among equal dates the last in the file is the latest. A survey
    /// from which stiffness was identified does not confirm the model if it agrees, but contradicts it like any other survey if it does
    /// not. A survey is held against the model without the damage that was found after it.
    pub fn of(project: &Project, check: &Check) -> Evidence {
        Evidence::with_records(project, check, &FromRecords::default())
    }

    /// The same, with the results of the surveys.
    pub(crate) fn with_records(project: &Project, check: &Check, found: &FromRecords) -> Evidence {
        let as_of = AsOf::new(project, check);
        let evidence = Evidence::of_lowest(&as_of, &found.lowest);
        let survey = match &evidence {
            Evidence::Agrees { survey } => survey.clone(),
            Evidence::TooRough(of) => of.survey.clone(),
            Evidence::NotMeasured {
                calibrated_to: Some(survey),
            } => survey.clone(),
            // a contradiction is stronger; with the others nothing was compared
            Evidence::Contradicted(_)
            | Evidence::InDoubt(_)
            | Evidence::NotCompared { .. }
            | Evidence::Unread { .. }
            | Evidence::MarkedAssumed { .. }
            | Evidence::NotMeasured { calibrated_to: None } => return evidence,
        };
        let higher = higher_modes(&as_of, &latest(project, measured(&as_of)));
        match InDoubt::of(survey, higher, &found.doubts) {
            Some(doubt) => Evidence::InDoubt(doubt),
            None => evidence,
        }
    }

    /// From the lowest frequency in each direction.
    fn of_lowest(as_of: &AsOf<'_>, found: &[RecordFrequency]) -> Evidence {
        let project = as_of.project;
        let mut measured = measured(as_of);
        let is_made_up = |name: &str| {
            let mut surveys = project.surveys.iter();
            surveys.any(|survey| survey.name == name && survey.is_made_up)
        };
        let found = found.iter().filter(|of| !is_made_up(&of.survey));
        let first = |of: &RecordFrequency| first_frequency(as_of.of(&of.survey)?.1, of.direction);
        // where the other direction of the survey confirms the model, a frequency of one of its higher modes is that mode
        let is_confirmed = |of: &RecordFrequency| {
            let is_other =
                |other: &&RecordFrequency| other.survey == of.survey && other.direction != of.direction;
            let others = found.clone().filter(is_other);
            let mut others = others.filter_map(|other| other.beside(first(other)?, &[]));
            others.any(|other| !other.differs())
        };
        measured.extend(found.clone().filter_map(|of| {
            let higher_hz = match is_confirmed(of) {
                true => higher_frequencies(as_of.of(&of.survey)?.1, of.direction),
                false => Vec::new(),
            };
            of.beside(first(of)?, &higher_hz)
        }));
        if measured.is_empty() {
            return match Evidence::without(as_of) {
                // its modes are known, but not the model's
                Evidence::Unread { survey } if found.clone().any(|of| of.survey == survey) => {
                    Evidence::NotCompared { survey }
                }
                none => none,
            };
        }
        match Evidence::of_frequencies(latest(project, measured)) {
            Evidence::Agrees { survey } if project.identified_from().contains(survey.as_str()) => {
                Evidence::NotMeasured {
                    calibrated_to: Some(survey),
                }
            }
            found => found,
        }
    }

    /// Why there is no comparison.
    fn without(as_of: &AsOf<'_>) -> Evidence {
        let project = as_of.project;
        let has_modes = |survey: &&Survey| {
            survey
                .modes
                .values()
                .any(|modes| lowest_measured(modes).is_some())
        };
        let has_records =
            |survey: &&Survey| !survey.is_made_up && (survey.records.is_some() || !survey.setups.is_empty());
        let last = |which: &dyn Fn(&&Survey) -> bool| {
            let surveys = project.surveys.iter().filter(which);
            surveys
                .max_by_key(|survey| date(&survey.name))
                .map(|survey| survey.name.clone())
        };
        match (last(&has_modes), last(&has_records)) {
            (Some(survey), _) => Evidence::NotCompared { survey },
            (None, Some(survey)) => match project.identified_from().last() {
                Some(&from) => Evidence::NotMeasured {
                    calibrated_to: Some(from.to_owned()),
                },
                None => Evidence::Unread { survey },
            },
            (None, None) => match last(&|survey| survey.modes.values().any(|modes| !modes.is_empty())) {
                Some(survey) => {
                    let all = latest(project, frequencies(as_of, Quantity::is_assumed));
                    let farthest = all.into_iter().max_by(|a, b| a.apart().total_cmp(&b.apart()));
                    Evidence::MarkedAssumed { survey, farthest }
                }
                None => Evidence::none(),
            },
        }
    }
}

/// The measurements of the latest survey in each direction, in the order of the surveys.
fn latest(project: &Project, measured: Vec<MeasuredFrequency>) -> Vec<MeasuredFrequency> {
    let when = |of: &MeasuredFrequency| {
        let place = project.surveys.iter().position(|survey| survey.name == of.survey);
        (date(&of.survey), place)
    };
    let mut all: Vec<MeasuredFrequency> = Vec::new();
    for of in measured {
        match all.iter_mut().find(|known| known.direction == of.direction) {
            Some(known) if when(&of) >= when(known) => *known = of,
            Some(_) => {}
            None => all.push(of),
        }
    }
    all.sort_by_key(when);
    all
}

/// For each direction of the model the measurement of the latest survey that states it.
pub fn latest_frequencies(project: &Project, check: &Check) -> Vec<MeasuredFrequency> {
    latest(project, measured_frequencies(project, check))
}

/// The later survey that also measured the direction of a measured frequency.
pub(crate) fn superseded_by(
    project: &Project,
    all: &[MeasuredFrequency],
    of: &MeasuredFrequency,
) -> Option<String> {
    let last = latest(project, all.to_vec());
    let last = last.into_iter().find(|last| last.direction == of.direction)?;
    (last.survey != of.survey).then_some(last.survey)
}

/// The lowest measured frequency of every survey and direction for which the model has one, in the order of the file.
pub fn measured_frequencies(project: &Project, check: &Check) -> Vec<MeasuredFrequency> {
    measured(&AsOf::new(project, check))
}

fn measured(as_of: &AsOf<'_>) -> Vec<MeasuredFrequency> {
    frequencies(as_of, |frequency| !frequency.is_assumed())
}

/// Modes of a chain or frame that the latest survey of a direction missed, if the model is right.
pub fn missed_modes(project: &Project, check: &Check) -> Vec<MissedMode> {
    let as_of = AsOf::new(project, check);
    higher_modes(&as_of, &latest(project, measured(&as_of))).1
}

/// The same for the frequencies that count.
fn frequencies(as_of: &AsOf<'_>, counts: impl Fn(&Quantity) -> bool + Copy) -> Vec<MeasuredFrequency> {
    let of_kind = move |modes: &[SurveyMode], kind: ModeKind| -> Vec<SurveyMode> {
        let each = modes.iter();
        each.filter(|mode| mode.kind == kind && counts(&mode.frequency))
            .cloned()
            .collect()
    };
    let surveys = as_of.project.surveys.iter();
    let each = surveys.flat_map(|survey| survey.modes.iter().map(move |of| (survey, of)));
    let compared = each.flat_map(|(survey, (direction, modes))| {
        let translation = (direction.as_str(), of_kind(modes, ModeKind::Translation));
        let torsion = ("torsion", of_kind(modes, ModeKind::Torsion));
        [translation, torsion].map(move |of| (survey, of))
    });
    let compared = compared.filter_map(|(survey, (direction, modes))| {
        let mode = modes.first()?;
        let (project, check) = as_of.of(&survey.name)?;
        Some(MeasuredFrequency {
            survey: survey.name.clone(),
            direction: direction.to_owned(),
            measured_hz: mode.frequency.value,
            sd_hz: measured_sd(&mode.frequency),
            computed_hz: first_paired(project, check, direction, &modes)?,
        })
    });
    compared.collect()
}

/// Frequency of the model for the lowest of these modes, Hz: its lowest, unless the shape says otherwise.
fn first_paired(project: &Project, check: &Check, direction: &str, modes: &[SurveyMode]) -> Option<f64> {
    let model = natural_modes(check, direction);
    if direction == "torsion" || model.is_empty() {
        return first_frequency(check, direction);
    }
    let measured: Vec<&SurveyMode> = modes.iter().collect();
    let first = pairs_along(project, model, &measured).first().copied()?;
    model.get(first).map(|mode| mode.frequency_hz)
}

/// Lowest frequency of a model in a direction, Hz.
fn first_frequency(check: &Check, direction: &str) -> Option<f64> {
    match check {
        // chains and frames have no torsion
        Check::Chain(_) if direction == "torsion" => None,
        // the weights of loads move as well
        Check::Chain(chain) if chain.loaded.is_some() => {
            let loaded = chain.loaded.as_ref()?;
            match (&chain.across, direction) {
                (None, _) | (Some(_), "x") => loaded.frequency_hz,
                (Some(_), "y") => loaded.frequency_across_hz,
                (Some(_), _) => None,
            }
        }
        Check::Chain(_) | Check::Frame(_) => {
            let first = natural_modes(check, direction).first();
            first.map(|mode| mode.frequency_hz)
        }
        Check::Stack(stack) => {
            let known = stack.frequencies.as_ref();
            known.and_then(|known| known.sway(direction)).map(|(_, hz)| hz)
        }
        Check::Building(answer) => of_whole(answer, direction),
    }
}

/// Frequencies of the higher modes of a chain, frame or stack in a direction, Hz.
fn higher_frequencies(check: &Check, direction: &str) -> Vec<f64> {
    match check {
        Check::Chain(_) | Check::Frame(_) => {
            let higher = natural_modes(check, direction).iter().skip(1);
            higher.map(|mode| mode.frequency_hz).collect()
        }
        Check::Stack(stack) => {
            let known = stack.frequencies.as_ref();
            let first = known.and_then(|known| Some((known.sway(direction)?.0, known.modes()?)));
            let Some((first, modes)) = first else {
                return Vec::new();
            };
            let axis = usize::from(direction == "y");
            let along = |mode: &&StackMode| mode.kinetic_energy_ratio[axis] >= ALONG_LEAST;
            let higher = modes.iter().skip(first + 1).filter(along);
            higher.map(|mode| mode.frequency_hz).collect()
        }
        Check::Building(_) => Vec::new(),
    }
}

/// Frequency of a building with its dampers, as a survey measures it, Hz; without dampers that of [`first_sway`].
fn of_whole(answer: &BuildingAnswer, direction: &str) -> Option<f64> {
    let standing = answer.stands.as_ref()?;
    match standing.dampers.is_empty() {
        true => first_sway(answer, direction).map(|(frequency_hz, _)| frequency_hz),
        false => {
            let own = largest_in(answer, direction)?;
            lowest_seen(&standing.damped_modes, own).map(|mode| mode.frequency_hz)
        }
    }
}

/// Frequency, Hz, and damping ratio of the building's own mode, without dampers, with the most mass along "x" or "y", or the most moment of
/// inertia for "torsion".
pub fn first_sway(answer: &BuildingAnswer, direction: &str) -> Option<(f64, f64)> {
    let standing = answer.stands.as_ref()?;
    let at = largest_in(answer, direction)?;
    let frequency_hz = standing.modes.modes.get(at)?.frequency_hz;
    Some((frequency_hz, *standing.damping_ratios.get(at)?))
}

/// Index of that mode.
fn largest_in(answer: &BuildingAnswer, direction: &str) -> Option<usize> {
    let axis = match direction {
        "x" => 0,
        "y" => 1,
        "torsion" => 2,
        _ => return None,
    };
    let modes = answer.stands.as_ref()?.modes.modes.iter().enumerate();
    let largest = modes.reduce(|most, own| {
        let more = own.1.effective_mass[axis] > most.1.effective_mass[axis];
        if more { own } else { most }
    });
    largest.map(|(at, _)| at)
}
