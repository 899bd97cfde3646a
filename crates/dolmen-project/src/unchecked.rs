//! Surveys whose modes give the stiffness of the structure and leave nothing to check it.

use crate::{ChainAxis, ModeKind, Project, Structure, Survey, SurveyMode};
use std::collections::{BTreeMap, BTreeSet};

/// What the stiffness of one direction was fitted to.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct StiffnessFit {
    /// Number of measured frequencies.
    pub frequencies: usize,
    /// Whether any of them has a measured shape.
    pub with_shapes: bool,
    /// Number of unknown stiffnesses.
    pub unknowns: usize,
}

impl StiffnessFit {
    /// Whether it fits by construction: frequencies alone, not more than unknown stiffnesses, leave nothing that could contradict it.
    pub fn is_by_construction(self) -> bool {
        !self.with_shapes && self.frequencies <= self.unknowns
    }
}

impl Project {
    /// The surveys from which stiffness was identified by frequencies alone, as many as there are unknown stiffnesses or fewer: such a fit
    /// reproduces the frequencies whatever the structure is.
    ///
    /// # Limits
    /// Of stiffness that stands in the file as identified, only surveys that state their modes are counted: records may have given shapes.
    pub fn unchecked_stiffness_from(&self) -> BTreeSet<&str> {
        let used = self.identified_from();
        let parts = self.from_surveys.iter().flat_map(|told| &told.parts);
        let mut all: BTreeSet<&str> = parts
            .filter(|part| part.is_unchecked)
            .filter_map(|part| part.survey.as_deref())
            .filter(|survey| used.contains(survey))
            .collect();
        if self.from_surveys.is_none() {
            all.extend(self.written_unchecked());
        }
        all
    }

    /// The same for stiffness written into the file.
    fn written_unchecked(&self) -> BTreeSet<&str> {
        let mut unknowns: BTreeMap<(&str, String), usize> = BTreeMap::new();
        for input in self.structure.inputs() {
            let Some(name) = &input.survey else { continue };
            let Some(survey) = self.surveys.iter().find(|survey| survey.name == *name) else {
                continue;
            };
            if input.path.contains("stiffness") {
                let entry: String = input.path.chars().filter(|of| !of.is_ascii_digit()).collect();
                *unknowns.entry((&survey.name, entry)).or_default() += 1;
            }
        }
        let own = |name: &str| self.surveys.iter().find(|survey| survey.name == name);
        let each = unknowns.into_iter();
        each.filter(|((name, entry), count)| {
            own(name).is_some_and(|survey| self.fits_by_construction(survey, entry, *count))
        })
        .map(|((name, _), _)| name)
        .collect()
    }

    fn fits_by_construction(&self, survey: &Survey, entry: &str, unknowns: usize) -> bool {
        let gives = |direction: &str| match &self.structure {
            Structure::Chain(chain) => {
                let is_across = entry.ends_with("stiffness_across");
                (chain.axis_of(direction) == ChainAxis::Across) == is_across
            }
            Structure::Frame(_) => {
                let of_entry = entry
                    .strip_prefix("direction.")
                    .and_then(|rest| rest.split_once(".stiffness"));
                let letters = direction.chars().filter(|of| !of.is_ascii_digit());
                of_entry.is_some_and(|(name, _)| letters.eq(name.chars()))
            }
            Structure::Stack(_) | Structure::Building(_) | Structure::Survey => false,
        };
        let measured = survey.modes.iter().filter(|(direction, _)| gives(direction));
        let measured: Vec<_> = measured
            .map(|(_, modes)| modes.iter().filter(|mode| mode.kind == ModeKind::Translation))
            .map(Iterator::collect::<Vec<_>>)
            .filter(|modes| !modes.is_empty())
            .collect();
        let is_bare = |modes: &Vec<&SurveyMode>| {
            let fit = StiffnessFit {
                frequencies: modes.len(),
                with_shapes: modes.iter().any(|mode| !mode.shape.is_empty()),
                unknowns,
            };
            fit.is_by_construction()
        };
        let has_records = survey.records.is_some() || !survey.setups.is_empty();
        !has_records && !measured.is_empty() && measured.iter().all(is_bare)
    }
}
