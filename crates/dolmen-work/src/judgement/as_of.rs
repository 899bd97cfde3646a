//! The model as it was at each survey: a survey made before a damage measured the structure without it.

use crate::kinds;
use crate::state::Check;
use dolmen_project::{Project, Quantity, Survey};

/// A project with its check, and the same before damage in the model where a survey measured it then.
pub(super) struct AsOf<'a> {
    /// The project with the damage.
    pub(super) project: &'a Project,
    /// Its check.
    pub(super) check: &'a Check,
    before: Vec<Before>,
}

/// The project before a day, with its check; `None` where it cannot be checked.
struct Before {
    until: [u32; 3],
    project: Project,
    check: Option<Check>,
}

impl<'a> AsOf<'a> {
    /// Checks each earlier model that a survey measured, once.
    pub(super) fn new(project: &'a Project, check: &'a Check) -> Self {
        let is_measured = |survey: &&Survey| {
            !survey.modes.is_empty() || survey.records.is_some() || !survey.setups.is_empty()
        };
        let mut before: Vec<Before> = Vec::new();
        for survey in project.surveys.iter().filter(is_measured) {
            let Some(model) = project.earlier_model(&survey.name) else {
                continue;
            };
            if before.iter().all(|known| known.until != model.until) {
                let earlier = project.as_of(&survey.name).into_owned();
                before.push(Before {
                    until: model.until,
                    check: kinds::check(&earlier, &mut Quantity::nominal).ok().flatten(),
                    project: earlier,
                });
            }
        }
        AsOf {
            project,
            check,
            before,
        }
    }

    /// The project and its check as of a survey; `None` where that model cannot be checked.
    pub(super) fn of(&self, survey: &str) -> Option<(&Project, &Check)> {
        let Some(model) = self.project.earlier_model(survey) else {
            return Some((self.project, self.check));
        };
        let before = self.before.iter().find(|known| known.until == model.until)?;
        Some((&before.project, before.check.as_ref()?))
    }
}
