//! The two surveys of a project to compare.

use crate::change_fault::ChangeFault;
use crate::compared_readings::has_modes;
use crate::survey_dates::date;
use dolmen_project::{Project, Survey, TemperaturePart};

/// Two surveys, by index, and the earlier ones for the fit of a temperature coefficient.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ComparedSurveys {
    /// The survey before.
    pub from: usize,
    /// The survey after.
    pub to: usize,
    /// Other surveys before `to` with a temperature, in their order; empty without a fit.
    pub earlier: Vec<usize>,
    /// Which of both the user named.
    pub named: NamedEnds,
}

/// Which of two surveys the user named; the others are the first and the last.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NamedEnds {
    /// The survey before.
    pub from: bool,
    /// The survey after.
    pub to: bool,
}

impl ComparedSurveys {
    fn new(project: &Project, [from, to]: [usize; 2], named: NamedEnds) -> Self {
        ComparedSurveys {
            from,
            to,
            earlier: earlier(project, [from, to]),
            named,
        }
    }

    /// The same with other surveys at its ends.
    pub(crate) fn with_ends(&self, project: &Project, ends: [usize; 2]) -> Self {
        ComparedSurveys::new(project, ends, self.named)
    }
}

/// Whether a survey has data for a comparison.
fn is_usable(survey: &Survey) -> bool {
    has_modes(survey) || !survey.tilt.is_empty() || !survey.inspections.is_empty()
}

/// The surveys to compare: those named, otherwise the first and the last whose names begin with a date, among those with modes if there are two.
///
/// # Errors
/// [`ChangeFault::NoSurvey`], [`ChangeFault::Unclear`], [`ChangeFault::Same`].
pub fn surveys_to_compare(
    project: &Project,
    named_from: Option<&str>,
    named_to: Option<&str>,
) -> Result<ComparedSurveys, ChangeFault> {
    let usable = || project.surveys.iter().enumerate().filter(|(_, s)| is_usable(s));
    let known = || {
        let names: Vec<&str> = usable().map(|(_, s)| s.name.as_str()).collect();
        if names.is_empty() {
            "none".to_owned()
        } else {
            names.join(", ")
        }
    };
    let named = |name: &str| {
        usable()
            .find(|(_, s)| s.name == name)
            .map(|(i, _)| i)
            .ok_or_else(|| ChangeFault::NoSurvey {
                given: name.to_owned(),
                known: known(),
            })
    };
    let mut dated: Vec<([u32; 3], usize)> = usable().filter_map(|(i, s)| Some((date(&s.name)?, i))).collect();
    dated.sort();
    let with_modes: Vec<([u32; 3], usize)> = dated
        .iter()
        .copied()
        .filter(|(_, i)| has_modes(&project.surveys[*i]))
        .collect();
    if with_modes.len() > 1 {
        dated = with_modes;
    }
    let unclear = || ChangeFault::Unclear { known: known() };
    let end = |name: Option<&str>, of_dated: Option<&([u32; 3], usize)>| match name {
        Some(name) => named(name),
        None => of_dated
            .filter(|_| dated.len() > 1)
            .map(|(_, i)| *i)
            .ok_or_else(unclear),
    };
    let (from, to) = (end(named_from, dated.first())?, end(named_to, dated.last())?);
    if from == to {
        return Err(ChangeFault::Same {
            given: project.surveys[from].name.clone(),
        });
    }
    let ends = NamedEnds {
        from: named_from.is_some(),
        to: named_to.is_some(),
    };
    Ok(ComparedSurveys::new(project, [from, to], ends))
}

/// Surveys before the later one with a temperature, for the fit of its coefficient.
fn earlier(project: &Project, [from, to]: [usize; 2]) -> Vec<usize> {
    let fitted = project.change.temperature == TemperaturePart::Fitted;
    // by date if the later one has one, otherwise in the order of the file
    let place = |i: usize| {
        (
            date(&project.surveys[to].name).and(date(&project.surveys[i].name)),
            i,
        )
    };
    let usable = project.surveys.iter().enumerate().filter(|(_, s)| is_usable(s));
    usable
        .filter(|(_, survey)| has_modes(survey))
        .map(|(i, _)| i)
        .filter(|i| fitted && *i != from && *i != to && place(*i) < place(to))
        .filter(|i| project.surveys[*i].temperature_c.is_some())
        .collect()
}
