//! Severe damage of inspections that the model leaves out.

use crate::survey_dates::date;
use dolmen_project::{DamageKind, Inspection, Project, Severity, Survey};

/// Severe damage of an inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct SevereDamage {
    /// The survey.
    pub survey: String,
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
}

impl SevereDamage {
    /// Severe damage that the model of a project leaves out, by date. For each part, the entries of the last survey that lists it count.
    pub fn left_out(project: &Project) -> Vec<Self> {
        let mut surveys: Vec<&Survey> = project.surveys.iter().collect();
        surveys.sort_by_key(|survey| date(&survey.name).unwrap_or_default());
        let is_last = |place: usize, part: &str| {
            let mut later = surveys.iter().skip(place + 1);
            !later.any(|survey| survey.inspections.iter().any(|one| one.part == part))
        };
        let is_in_model = |survey: &Survey, one: &Inspection| {
            let mut all = project.damage.iter();
            all.any(|of| of.is_of(one) && date(&of.survey) >= date(&survey.name))
        };
        let each = surveys.iter().enumerate().flat_map(|(place, survey)| {
            let severe = survey
                .inspections
                .iter()
                .filter(move |one| one.severity == Some(Severity::Severe) && is_last(place, &one.part))
                .filter(|one| !is_in_model(survey, one));
            severe.map(|one| SevereDamage {
                survey: survey.name.clone(),
                part: one.part.clone(),
                what: one.what.clone(),
            })
        });
        each.collect()
    }
}
