//! Damage of the model that a later inspection recorded as larger or more severe, without a new effect on the model.

use super::severe_damage::SevereDamage;
use crate::survey_dates::date;
use dolmen_project::{DamageKind, Inspection, ModelDamage, Project, Severity, Survey};

/// Damage of the model that has grown since.
#[derive(Clone, Debug, PartialEq)]
pub struct GrownDamage {
    /// The survey whose effect is in the model.
    pub since: String,
    /// The latest survey that lists the damage.
    pub survey: String,
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
    /// Its growth.
    pub growth: Growth,
}

/// The growth of a damage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Growth {
    /// Its size, m.
    Size {
        /// When the model took it over.
        before_m: f64,
        /// Now.
        after_m: f64,
    },
    /// Its severity, where no larger size is recorded.
    Severity {
        /// When the model took it over.
        before: Severity,
        /// Now.
        after: Severity,
    },
}

/// Relative growth of a size below which it is rounding.
const ROUNDING: f64 = 1e-9;

impl GrownDamage {
    /// Damage of the model of a project that the latest survey listing it recorded as grown. A new effect or a repair in that survey leaves
    /// nothing to say here; severe damage already named as left out is not named again.
    pub(crate) fn of(project: &Project, severe: &[SevereDamage]) -> Vec<Self> {
        let of_model = |of: &ModelDamage| -> Option<Self> {
            let found = entry(
                project.surveys.iter().find(|survey| survey.name == of.survey)?,
                of,
            )?;
            let surveys = project.surveys.iter();
            let later = surveys.filter(|survey| date(&survey.name) > date(&of.survey));
            let mut listed: Vec<(&Survey, &Inspection)> = later
                .filter_map(|survey| Some((survey, entry(survey, of)?)))
                .collect();
            listed.sort_by_key(|(survey, _)| date(&survey.name));
            let (survey, now) = listed.pop().filter(|(_, now)| now.model.is_none())?;
            let is_named =
                |one: &SevereDamage| one.survey == survey.name && one.part == of.part && one.what == of.what;
            if severe.iter().any(is_named) {
                return None;
            }
            Some(GrownDamage {
                since: of.survey.clone(),
                survey: survey.name.clone(),
                part: of.part.clone(),
                what: of.what.clone(),
                growth: growth(found, now)?,
            })
        };
        project.damage.iter().filter_map(of_model).collect()
    }
}

fn entry<'s>(survey: &'s Survey, of: &ModelDamage) -> Option<&'s Inspection> {
    survey.inspections.iter().find(|one| of.is_of(one))
}

fn growth(found: &Inspection, now: &Inspection) -> Option<Growth> {
    let sizes = found.size.as_ref().zip(now.size.as_ref());
    let sizes = sizes.map(|(found, now)| (found.value, now.value));
    if let Some((before_m, after_m)) = sizes.filter(|(before, after)| *after > before * (1.0 + ROUNDING)) {
        return Some(Growth::Size { before_m, after_m });
    }
    let (before, after) = found.severity.zip(now.severity)?;
    (after > before).then_some(Growth::Severity { before, after })
}
