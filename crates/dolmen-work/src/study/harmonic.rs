//! Maps of harmonic motions, and releases.

use super::error::StudyError;
use super::inputs::{Drawn, drawn};
use super::maps::ResponseMaps;
use super::model::{Model, NoModel, model_of};
use super::plan::Plan;
use crate::error::WorkError;
use crate::progress::Progress;
use dolmen::dynamics::{
    DynamicsError, HarmonicPoint, HarmonicStart, amplitude_dependence, chain_harmonic_map,
    harmonic_map_of_leaning,
};
use dolmen_words::message::Both;
use rayon::prelude::*;

/// Maps and releases of every possible case, in their order.
pub(super) fn maps(plan: &Plan<'_>, progress: &dyn Progress) -> Result<Vec<ResponseMaps>, WorkError> {
    if plan.study.harmonic.is_none() && plan.study.release_m.is_none() {
        return Ok(Vec::new());
    }
    let each = (0..plan.cases())
        .into_par_iter()
        .map(|case| of_case(plan, case, progress));
    let found: Vec<Option<ResponseMaps>> = each.collect::<Result<_, WorkError>>()?;
    Ok(found.into_iter().flatten().collect())
}

/// The maps of a case; `None` if its inputs are refused and there are others.
fn of_case(plan: &Plan<'_>, case: usize, progress: &dyn Progress) -> Result<Option<ResponseMaps>, WorkError> {
    let model = match case_model(plan, case)? {
        Ok(model) => model,
        Err(why) if plan.cases() == 1 => return Err(WorkError::CaseRefused { why }),
        Err(_) => return Ok(None),
    };
    let mut maps = ResponseMaps {
        case,
        label: plan.case_words(case),
        parts: Vec::new(),
        harmonic: Vec::new(),
        release: Vec::new(),
    };
    match model {
        Model::Frame(model) => {
            let start = HarmonicStart {
                tilt: model.first.tilt,
                drift_ratio_most: model.first.drift_ratio_most,
            };
            maps.harmonic = mapped(plan, |[frequencies_hz, accelerations_m_s2]| {
                harmonic_map_of_leaning(
                    &model.first.frame,
                    start,
                    frequencies_hz,
                    accelerations_m_s2,
                    &mut |_| !progress.is_cancelled(),
                )
            })?;
            if let Some(displacement_m) = plan.study.release_m {
                maps.release = amplitude_dependence(&model.first.frame, displacement_m)?;
            }
            model.limit_to_lift_off(&mut maps.harmonic, plan.study.release_m)?;
            maps.parts = model.storeys;
        }
        Model::Chain(model) => {
            maps.harmonic = mapped(plan, |[frequencies_hz, accelerations_m_s2]| {
                chain_harmonic_map(&model.chain, frequencies_hz, accelerations_m_s2, &mut |_| {
                    !progress.is_cancelled()
                })
            })?;
            maps.parts = model.links;
        }
        Model::Stack(_) | Model::Building(_) => return Err(StudyError::HarmonicOfOther.into()),
    }
    Ok(Some(maps))
}

/// The points of a map, its frequencies side by side.
fn mapped(
    plan: &Plan<'_>,
    of: impl Fn([&[f64]; 2]) -> Result<Vec<HarmonicPoint>, DynamicsError> + Sync,
) -> Result<Vec<HarmonicPoint>, WorkError> {
    let Some(part) = &plan.study.harmonic else {
        return Ok(Vec::new());
    };
    let rows = part.frequencies_hz.par_iter();
    let rows = rows.map(|frequency_hz| of([&[*frequency_hz], &part.accelerations_m_s2]));
    Ok(rows.collect::<Result<Vec<_>, _>>()?.concat())
}

/// The structure of a case, or the reason for its absence.
fn case_model(plan: &Plan<'_>, case: usize) -> Result<Result<Model, Both>, WorkError> {
    let project = match plan.project(case / plan.samples()) {
        Ok(project) => project,
        Err(why) => return Ok(Err(why)),
    };
    let sample = match plan.study.samples {
        Some(_) => drawn(&project, plan.study.seed, (case % plan.samples()) as u64)?,
        None => Drawn::default(),
    };
    let model = model_of(plan.study, &project, &sample);
    Ok(model.map_err(NoModel::why))
}
