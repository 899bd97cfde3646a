//! Runs of frames.

use super::inputs::{Drawn, drawn};
use super::plan::Plan;
use crate::simulate;
use anyhow::{Result, bail};
use dolmen::dynamics::{
    FrameLoad, FrameOutcome, FrameRun, FrictionFrame, TimeFunction, amplitude_dependence, harmonic_map,
    simulate_frame,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen_formats::project::{FramePart, Pick, Structure, StudyPart};
use dolmen_formats::study::{FRAME_REST_S, FrameMaps, Run, RunOutcome};
use rayon::prelude::*;

/// A frame in the direction that is shaken.
pub(super) struct FrameModel {
    pub(super) frame: FrictionFrame,
    storeys: Vec<String>,
    heights_m: Vec<f64>,
}

/// The frame of a study, or why it cannot be.
pub(super) fn model(study: &StudyPart, part: &FramePart, pick: Pick<'_>) -> Result<FrameModel, String> {
    let known = part
        .directions
        .iter()
        .filter(|direction| direction.stiffness.is_some());
    let known: Vec<&str> = known.map(|direction| direction.name.as_str()).collect();
    let direction = match (&study.direction, known.as_slice()) {
        (Some(name), _) => name.as_str(),
        (None, [only]) => only,
        (None, []) => return Err(
            "the stiffness of no direction is known: `dolmen identify` finds those that frequencies allow"
                .to_owned(),
        ),
        (None, several) => {
            return Err(format!(
                "the file has the directions {}: choose one with direction",
                several.join(", ")
            ));
        }
    };
    let frame = part
        .with_friction(direction, pick)
        .map_err(|why| why.to_string())?;
    let Some(frame) = frame else {
        return Err(format!(
            "the stiffness of direction \"{direction}\" is unknown, or there is none of this name"
        ));
    };
    let named = part.storeys.iter().enumerate();
    Ok(FrameModel {
        storeys: named
            .map(|(i, s)| s.name.clone().unwrap_or_else(|| format!("storey {}", i + 1)))
            .collect(),
        heights_m: frame
            .frame()
            .storeys()
            .iter()
            .map(|storey| storey.height_m)
            .collect(),
        frame,
    })
}

/// Runs a frame; `None` if it was stopped.
pub(super) fn row(study: &StudyPart, mut run: Run, model: &FrameModel, motion: &GroundMotion) -> Option<Run> {
    let component = match (motion.has(Component::X), motion.has(Component::Y)) {
        (false, true) => Component::Y,
        _ => Component::X,
    };
    let load = FrameLoad::of_ground(TimeFunction::of_motion(motion, component));
    let options = FrameRun {
        duration_s: Some(motion.duration_s() + study.rest_s.unwrap_or(FRAME_REST_S)),
        output_step_s: 0.02,
        ..FrameRun::default()
    };
    let history = match simulate_frame(&model.frame, &load, &options, &mut |_| !simulate::interrupted()) {
        Ok(history) => history,
        Err(why) => {
            run.outcome = RunOutcome::Refused;
            run.why = why.to_string();
            return Some(run);
        }
    };
    match history.outcome {
        FrameOutcome::Finished => run.outcome = RunOutcome::Stood,
        FrameOutcome::DriftLimit { storey, at_s } => {
            run.outcome = RunOutcome::Fell;
            run.at_s = at_s;
            run.part = model.storeys.get(storey).cloned().unwrap_or_default();
        }
        _ => return None,
    }
    let storeys = 0..model.heights_m.len();
    let most = |of: &dyn Fn(usize) -> f64| storeys.clone().map(of).fold(0.0, f64::max);
    let residual = |level: usize| history.residual_m.get(level).copied().unwrap_or(0.0);
    let below = |level: usize| level.checked_sub(1).map_or(0.0, residual);
    let top = model.heights_m.len() - 1;
    run.measures = vec![
        history.displacement_peaks[top].value_m.abs(),
        most(&|storey| history.drift_peaks[storey].value_m.abs()),
        most(&|storey| history.drift_peaks[storey].value_m.abs() / model.heights_m[storey]),
        residual(top).abs(),
        most(&|storey| (residual(storey) - below(storey)).abs()),
        most(&|storey| history.slipping_share(storey)),
        most(&|storey| history.slipped_way_m(storey)),
        history.energy_left_over_ratio(),
    ];
    run.damage_state = match run.outcome {
        RunOutcome::Fell => 4,
        _ if history.slips.is_empty() => 0,
        _ => 1,
    };
    Some(run)
}

/// Maps and releases of every case that can be, in their order.
pub(super) fn maps(plan: &Plan<'_>) -> Result<Vec<FrameMaps>> {
    let study = plan.study;
    if study.harmonic.is_none() && study.release_m.is_none() {
        return Ok(Vec::new());
    }
    let each = (0..plan.cases())
        .into_par_iter()
        .map(|case| -> Result<Option<FrameMaps>> {
            let Some(model) = case_model(plan, case)? else {
                return Ok(None);
            };
            let harmonic = match &study.harmonic {
                Some(part) => {
                    let rows = part.frequencies_hz.par_iter().map(|frequency_hz| {
                        harmonic_map(
                            &model.frame,
                            &[*frequency_hz],
                            &part.accelerations_m_s2,
                            &mut |_| !simulate::interrupted(),
                        )
                    });
                    rows.collect::<Result<Vec<_>, _>>()?.concat()
                }
                None => Vec::new(),
            };
            let release = match study.release_m {
                Some(displacement_m) => amplitude_dependence(&model.frame, displacement_m)?,
                None => Vec::new(),
            };
            Ok(Some(FrameMaps {
                case,
                label: plan.case_words(case),
                storeys: model.storeys,
                harmonic,
                release,
            }))
        });
    let found: Vec<Option<FrameMaps>> = each.collect::<Result<_>>()?;
    Ok(found.into_iter().flatten().collect())
}

/// The frame of a case; `None` if its inputs are refused and there are others.
fn case_model(plan: &Plan<'_>, case: usize) -> Result<Option<FrameModel>> {
    let project = match plan.project(case / plan.samples()) {
        Ok(project) => project,
        Err(why) if plan.cases() == 1 => bail!(why),
        Err(_) => return Ok(None),
    };
    let Structure::Frame(part) = &project.structure else {
        bail!("harmonic and release are for frames");
    };
    let sample = match plan.study.samples {
        Some(_) => drawn(&project, plan.study.seed, (case % plan.samples()) as u64)?,
        None => Drawn::default(),
    };
    match model(plan.study, part, &mut |quantity| sample.pick(quantity)) {
        Ok(model) => Ok(Some(model)),
        Err(why) if plan.cases() == 1 => bail!(why),
        Err(_) => Ok(None),
    }
}
