//! Runs of frames.

use crate::progress::Progress;
use crate::study::{FrameMeasures, Run, RunMeasures, RunOutcome, SWING_REST_S, acting_component};
use crate::told::{told, told_both};
use crate::wrong::CaseRefused;
use dolmen::dynamics::{FrameLoad, FrameOutcome, FrameRun, FrictionFrame, TimeFunction, simulate_frame};
use dolmen::signal::GroundMotion;
use dolmen_project::{FramePart, Pick, StudyPart};
use dolmen_words::message::Both;

/// A frame in the direction that is shaken.
pub(crate) struct FrameModel {
    pub(crate) frame: FrictionFrame,
    pub(crate) storeys: Vec<String>,
    heights_m: Vec<f64>,
}

/// The frame of a study, or why it cannot be.
pub(crate) fn model(study: &StudyPart, part: &FramePart, pick: Pick<'_>) -> Result<FrameModel, Both> {
    let known = part
        .directions
        .iter()
        .filter(|direction| direction.stiffness.is_some());
    let known: Vec<&str> = known.map(|direction| direction.name.as_str()).collect();
    let direction = match (&study.direction, known.as_slice()) {
        (Some(name), _) => name.as_str(),
        (None, [only]) => only,
        (None, []) => return Err(CaseRefused::NoDirectionKnown.into()),
        (None, several) => {
            return Err(CaseRefused::ChooseDirection {
                directions: several.join(", "),
            }
            .into());
        }
    };
    let frame = part
        .with_friction(direction, pick)
        .map_err(|why| told_both(&why))?;
    let Some(frame) = frame else {
        return Err(CaseRefused::DirectionUnknown {
            direction: direction.to_owned(),
        }
        .into());
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
pub(crate) fn row(
    study: &StudyPart,
    mut run: Run,
    model: &FrameModel,
    (motion, progress): (&GroundMotion, &dyn Progress),
) -> Option<Run> {
    let load = FrameLoad::of_ground(TimeFunction::of_motion(motion, acting_component(motion)));
    let options = FrameRun {
        duration_s: Some(motion.duration_s() + study.rest_s.unwrap_or(SWING_REST_S)),
        output_step_s: 0.02,
        ..FrameRun::default()
    };
    let history = match simulate_frame(&model.frame, &load, &options, &mut |_| !progress.is_cancelled()) {
        Ok(history) => history,
        Err(why) => {
            run.outcome = RunOutcome::Refused;
            run.why = told(&why);
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
    let residual = |level: usize| history.rest_m.get(level).copied().unwrap_or(0.0);
    let below = |level: usize| level.checked_sub(1).map_or(0.0, residual);
    let top = model.heights_m.len() - 1;
    run.measures = RunMeasures::Frame(FrameMeasures {
        peak_displacement_m: history.displacement_peaks[top].value_m.abs(),
        peak_drift_m: most(&|storey| history.drift_peaks[storey].value_m.abs()),
        peak_drift_ratio: most(&|storey| history.drift_peaks[storey].value_m.abs() / model.heights_m[storey]),
        residual_displacement_m: residual(top).abs(),
        residual_drift_m: most(&|storey| (residual(storey) - below(storey)).abs()),
        slipping_share: most(&|storey| history.slipping_share(storey)),
        slipped_way_m: most(&|storey| history.slipped_way_m(storey)),
        energy_left_over_ratio: history.energy_left_over_ratio(),
    });
    run.damage_state = match run.outcome {
        RunOutcome::Fell => 4,
        _ if history.slips.is_empty() => 0,
        _ => 1,
    };
    Some(run)
}
