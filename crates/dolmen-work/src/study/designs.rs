//! Simulated designs from a study, for the score.

use super::engine::missing;
use super::error::StudyError;
use super::plan::Plan;
use super::results::{JournalText, merged};
use super::scans::ALLOWED_DRIFT;
use crate::error::WorkError;
use crate::opened::Opened;
use crate::score::{ScoreDesign, ScoreDesigns, factors};
use crate::wrong::CaseRefused;
use dolmen::assess::ScoreModel;
use dolmen_records::Files;
use rayon::prelude::*;
use std::collections::BTreeSet;

/// Share of usable scans that a design needs. Our choice.
const USABLE_LEAST: f64 = 0.75;

/// Simulated designs of a study.
#[derive(Clone, Debug, PartialEq)]
pub struct StudyDesigns {
    /// The designs.
    pub designs: ScoreDesigns,
    /// Number of combinations without enough usable scans.
    pub left_out: usize,
}

/// The pagodas of a study with their fragilities, from its journals.
///
/// # Errors
/// An unknown study, journals of another one, a project without a pagoda of six factors.
pub fn study_designs(
    opened: &Opened,
    name: &str,
    journals: impl FnOnce() -> Result<Vec<JournalText>, WorkError>,
    files: &dyn Files,
) -> Result<StudyDesigns, WorkError> {
    let studies = &opened.project.studies;
    let Some(study) = studies.iter().find(|study| study.name == name) else {
        return Err(StudyError::NoStudyIn {
            name: name.to_owned(),
            file: opened.file.clone(),
        }
        .into());
    };
    if let Some(after) = &study.after {
        let why = CaseRefused::AfterMotion {
            study: study.name.clone(),
            motion: after.motion.clone(),
        };
        return Err(WorkError::CaseRefused { why: why.into() });
    }
    let plan = Plan::of(opened, study, files)?;
    let runs = merged(&plan, &journals()?)?;
    let missing = missing(&plan, (1, 1), &runs);
    let unfinished: BTreeSet<usize> = missing
        .iter()
        .map(|job| job * study.combinations() / plan.jobs().max(1))
        .collect();
    let answer = plan.answer(runs, missing);
    let enough = (USABLE_LEAST * answer.motions.len() as f64).ceil() as usize;
    let mut designs = Vec::new();
    for found in answer.fragilities() {
        // a design with samples that fall by their own weight has no lognormal capacity
        let falls_alone = found.states.iter().any(|state| state.fell_alone > 0);
        if unfinished.contains(&found.combination) || found.usable < enough || falls_alone {
            continue;
        }
        let project = plan
            .project(found.combination)
            .map_err(|why| WorkError::CaseRefused { why })?;
        let Some(factors) = factors(&project)? else {
            return Err(StudyError::StudyWithoutPagoda {
                name: name.to_owned(),
            }
            .into());
        };
        let mut states = [None; 4];
        for state in found.states.iter().filter(|state| state.state != ALLOWED_DRIFT) {
            states[state.state] = state.by_acceleration.as_ref().ok().map(|fit| fit.curve);
        }
        designs.push(ScoreDesign { factors, states });
    }
    Ok(StudyDesigns {
        left_out: study.combinations() - designs.len(),
        designs: ScoreDesigns {
            designs,
            motions: Some(answer.motions.len()),
            ..ScoreDesigns::default()
        },
    })
}

/// Chooses the settings of the score for designs of a study.
pub fn trained(mut found: StudyDesigns) -> StudyDesigns {
    let own = &found.designs;
    let settings: Vec<_> = (0..4)
        .into_par_iter()
        .map(|state| ScoreModel::settings(&own.of_state(state)).ok())
        .collect();
    for (place, settings) in found.designs.settings.iter_mut().zip(settings) {
        *place = settings;
    }
    found
}
