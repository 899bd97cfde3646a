//! The earlier motion of a plan: run once for each case, on first use.

use super::before::{EarlierShaking, FirstMotion, shaken_before, why_refused};
use super::combination_motions::{across_left_out, along};
use super::error::StudyError;
use super::inputs::{Drawn, drawn};
use super::kind::StudyKind;
use super::model::{NoModel, model_of};
use super::motions::{PreparedMotion, prepared};
use super::plan::Plan;
use super::state_before::StateBefore;
use crate::error::WorkError;
use crate::motion::refuse_other_components;
use dolmen::signal::motion_sequence;
use dolmen_project::{AfterPart, MotionSize, Project};
use dolmen_words::message::Both;
use rayon::prelude::*;
use std::sync::OnceLock;

impl Plan<'_> {
    /// Reads the earlier motion, and checks that every other motion can follow it.
    pub(super) fn prepare_before(&mut self) -> Result<(), WorkError> {
        let Some(after) = &self.study.after else {
            return Ok(());
        };
        if self.kind == StudyKind::Building {
            return Err(StudyError::AfterOfBuilding.into());
        }
        if self.study.scan.is_none() {
            return Err(StudyError::AfterWithoutScan.into());
        }
        let first = prepared(&self.opened.project, self.files, self.study, &after.motion)?;
        let is_named = self.motions.iter().any(|(name, _)| *name == after.motion);
        if !is_named {
            let named = [(after.motion.clone(), first.clone())];
            let across = across_left_out(self.study, &self.opened.project, &named);
            self.left_out.extend(across);
        }
        for (_, second) in &self.motions {
            motion_sequence(&first.motion, 0.0, &second.motion)?;
            if self.meets_both(&self.opened.project) {
                refuse_other_components(&first.motion, &second.motion)?;
            }
        }
        self.first = Some(first);
        self.before = (0..self.cases()).map(|_| OnceLock::new()).collect();
        Ok(())
    }

    /// The state of a case after the earlier motion; `None` for a study without one.
    pub(super) fn before(&self, case: usize) -> Option<&EarlierShaking> {
        let after = self.study.after.as_ref()?;
        let known = self.before.get(case)?;
        Some(known.get_or_init(|| match self.shaken(after, case) {
            Ok(before) => before,
            Err(why) => EarlierShaking::refused(case, why),
        }))
    }

    fn shaken(&self, after: &AfterPart, case: usize) -> Result<EarlierShaking, Both> {
        let (combination, sample) = (case / self.samples(), case % self.samples());
        let project = self.project(combination)?;
        let told = |why: WorkError| why_refused(&why);
        let motion = self.motion_before(after, &project).map_err(told)?;
        let in_plane = self.acts_in_plane(&project);
        let scale = match self.study.size_before(combination) {
            None => 1.0,
            Some(MotionSize::Scale(scale)) => scale,
            Some(MotionSize::Peak(peak_m_s2)) => peak_m_s2 / motion.peak_m_s2,
        };
        if scale == 0.0 {
            return Ok(EarlierShaking::unshaken(case));
        }
        let drawn = match self.study.samples {
            Some(_) => drawn(&project, self.study.seed, sample as u64).map_err(told)?,
            None => Drawn::default(),
        };
        let model = model_of(self.study, &project, &drawn).map_err(NoModel::why)?;
        let acting = motion.acting(scale, 0.0).map_err(told)?;
        let first = FirstMotion {
            acting,
            peak_m_s2: scale * motion.peak_m_s2,
            in_plane,
        };
        Ok(shaken_before(self.study, &model, case, first))
    }

    /// The motion of a case.
    fn motion_before(&self, after: &AfterPart, project: &Project) -> Result<PreparedMotion, WorkError> {
        let motion = prepared(project, self.files, self.study, &after.motion)?;
        match self.acts_in_plane(project) {
            true => motion.in_plane(0.0, along(self.study, project)),
            false => Ok(motion),
        }
    }

    /// Whether only one component of the motion acts, in a plane.
    fn acts_in_plane(&self, project: &Project) -> bool {
        match self.kind {
            StudyKind::Chain | StudyKind::Frame => !self.meets_both(project),
            StudyKind::Stack | StudyKind::Building => false,
        }
    }

    /// The state of every case before its runs, reusing earlier results; empty for a study without an earlier motion.
    pub(super) fn states_before(&self) -> Vec<StateBefore> {
        let each = (0..self.before.len()).into_par_iter();
        let each = each.filter_map(|case| self.before(case).map(|before| before.state().clone()));
        each.collect()
    }
}
