//! Runs of chains.

use super::simulate::start_rotation_rad;
use crate::progress::Progress;
use crate::study::{ChainMeasures, Run, RunMeasures, RunOutcome, SWING_REST_S, acting_component};
use crate::told::{told, told_both};
use crate::wrong::CaseRefused;
use dolmen::dynamics::{ChainModel, ChainOutcome, ChainRotations, ChainRun, TimeFunction, simulate_chain};
use dolmen::signal::GroundMotion;
use dolmen_project::{ChainPart, LoadsPart, Pick, StudyPart};
use dolmen_words::message::Both;

/// Time between the samples that a run is judged by, s.
const SAMPLE_S: f64 = 0.02;

/// A chain that can move, with the names of its links.
pub(crate) struct MovingChain {
    pub(crate) chain: ChainModel,
    pub(crate) links: Vec<String>,
}

/// The chain of a study, or why it cannot be.
pub(crate) fn model(part: &ChainPart, loads: &LoadsPart, pick: Pick<'_>) -> Result<MovingChain, Both> {
    let chain = part
        .moving(loads, ChainRotations::Large, pick)
        .map_err(|why| told_both(&why))?;
    let Some(chain) = chain else {
        return Err(CaseRefused::JointsUnknown.into());
    };
    let named = part.links.iter().enumerate();
    let links = named
        .map(|(i, link)| link.name.clone().unwrap_or_else(|| format!("link {}", i + 1)))
        .collect();
    Ok(MovingChain { chain, links })
}

/// Runs a chain; `None` if it was stopped.
pub(crate) fn row(
    study: &StudyPart,
    mut run: Run,
    model: &MovingChain,
    (motion, progress): (&GroundMotion, &dyn Progress),
) -> Option<Run> {
    let load = TimeFunction::of_motion(motion, acting_component(motion));
    let run_s = motion.duration_s() + study.rest_s.unwrap_or(SWING_REST_S);
    let history = start_rotation_rad(&model.chain).and_then(|start_rotation_rad| {
        let options = ChainRun {
            duration_s: Some(run_s),
            output_step_s: SAMPLE_S,
            start_rotation_rad,
            ..ChainRun::default()
        };
        simulate_chain(&model.chain, &load, &options, &mut |_| !progress.is_cancelled())
    });
    let history = match history {
        Ok(history) => history,
        Err(why) => {
            run.outcome = RunOutcome::Diverged;
            run.why = told(&why);
            return Some(run);
        }
    };
    let name = |link: usize| model.links.get(link).cloned().unwrap_or_default();
    match history.outcome {
        ChainOutcome::Stood => run.outcome = RunOutcome::Stood,
        ChainOutcome::Uplifted { .. } => run.outcome = RunOutcome::Uplifted,
        ChainOutcome::Fell { link, at_s } => {
            (run.outcome, run.at_s, run.part) = (RunOutcome::Fell, at_s, name(link));
        }
        ChainOutcome::StillLeaning { link, at_s } => {
            (run.outcome, run.at_s, run.part) = (RunOutcome::StillMoving, at_s, name(link));
            run.why = "a link was leaning further and further out when the run ended".to_owned();
        }
        _ => return None,
    }
    let links = 0..model.links.len();
    let most = |of: &dyn Fn(usize) -> f64| links.clone().map(of).fold(0.0, f64::max);
    let took_s = history.times_s.last().copied().unwrap_or(run_s);
    run.measures = RunMeasures::Chain(ChainMeasures {
        peak_top_displacement_m: history.top_peak_m.abs(),
        peak_rotation_rad: most(&|link| history.rotation_peaks[link].rotation_rad.abs()),
        peak_joint_rotation_rad: most(&|joint| history.joint_peaks[joint].rotation_rad.abs()),
        open_share: most(&|joint| history.open_s(joint) / took_s),
        slipped_rad: most(&|joint| history.slipped_rad(joint)),
        residual_rotation_rad: most(&|link| history.rotation_rad[link].last().map_or(0.0, |end| end.abs())),
        energy_left_over_ratio: history.energy_left_over_ratio,
    });
    run.damage_state = match run.outcome {
        RunOutcome::Fell => 4,
        _ => u8::from(!history.uplifts.is_empty() || !history.slips.is_empty()),
    };
    Some(run)
}
