//! What the results of a plan are compared with: the allowable drift, the hazard, the lean of each case before it is shaken.

use super::inputs::{Drawn, ReadCombination, drawn};
use super::kind::StudyKind;
use super::model::lean_at_rest;
use super::plan::Plan;
use crate::wrong::OfRuns;
use rayon::prelude::*;

impl Plan<'_> {
    /// Takes the allowable drift and the hazard that all combinations share; differing ones are left out.
    pub(super) fn take_limits(&mut self, read: &[ReadCombination]) {
        // of refused combinations nothing is known
        let known: Vec<&ReadCombination> = read.iter().filter(|read| !read.model.is_empty()).collect();
        if let Some(first) = known.first() {
            match known.iter().all(|own| own.drift_limit == first.drift_limit) {
                true => self.drift_limit = first.drift_limit,
                false => self.left_out.push(OfRuns::LimitsDiffer.into()),
            }
            match known.iter().all(|own| own.hazard == first.hazard) {
                true => self.hazard = first.hazard.clone(),
                false => self.left_out.push(OfRuns::HazardsDiffer.into()),
            }
        }
    }

    /// The largest lean of a storey of each case at rest, –, where it leans as surveyed; empty unless the file allows a drift of a frame.
    pub(super) fn leans_at_rest(&self) -> Vec<Option<f64>> {
        if self.kind != StudyKind::Frame || self.drift_limit.is_none() {
            return Vec::new();
        }
        let each = (0..self.study.combinations()).into_par_iter();
        let each = each.flat_map_iter(|combination| {
            let project = self.project(combination).ok();
            (0..self.samples()).map(move |sample| {
                let project = project.as_ref()?;
                let drawn = match self.study.samples {
                    Some(_) => drawn(project, self.study.seed, sample as u64).ok()?,
                    None => Drawn::default(),
                };
                lean_at_rest(self.study, project, &drawn)
            })
        });
        each.collect()
    }
}
