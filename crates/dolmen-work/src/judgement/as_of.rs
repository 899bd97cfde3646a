//! The model as it was at each survey: a survey made before a damage measured the structure without it.

use crate::kinds;
use crate::state::Check;
use dolmen_project::{Project, Quantity};
use std::borrow::Cow;

/// A project with its check, and the same for the surveys that were made before damage in the model.
pub(super) struct AsOf<'a> {
    now: (&'a Project, &'a Check),
    /// By survey; `None` where the earlier model cannot be checked.
    before: Vec<(String, Project, Option<Check>)>,
}

impl<'a> AsOf<'a> {
    /// Checks the earlier models that surveys measured.
    pub(super) fn new(project: &'a Project, check: &'a Check) -> Self {
        let before = project.surveys.iter().filter_map(|survey| {
            let measured = !survey.modes.is_empty() || survey.records.is_some() || !survey.setups.is_empty();
            match project.as_of(&survey.name) {
                Cow::Owned(earlier) if measured => {
                    let check = kinds::check(&earlier, &mut Quantity::nominal).ok().flatten();
                    Some((survey.name.clone(), earlier, check))
                }
                Cow::Owned(_) | Cow::Borrowed(_) => None,
            }
        });
        AsOf {
            now: (project, check),
            before: before.collect(),
        }
    }

    /// The project and its check as of a survey.
    pub(super) fn of(&self, survey: &str) -> Option<(&Project, &Check)> {
        match self.before.iter().find(|(name, ..)| name == survey) {
            None => Some(self.now),
            Some((_, project, check)) => Some((project, check.as_ref()?)),
        }
    }
}
