//! Runs of chains.

use super::ChainTogether;
use super::simulate::{is_damped, one_plane_only, start_rotation_rad};
use crate::at_rest::AtRest;
use crate::error::WorkError;
use crate::progress::Progress;
use crate::study::{ChainMeasures, Run, RunMeasures, RunOutcome, SWING_REST_S, acting_component};
use crate::told::told_both;
use crate::wrong::CaseRefused;
use crate::wrong::RunEnded;
use dolmen::dynamics::{
    ChainHistory, ChainModel, ChainOutcome, ChainRotations, ChainRun, TimeFunction, simulate_chain,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen_project::{ChainPart, LoadsPart, Pick, StudyPart};
use dolmen_words::message::Both;

/// Time between the samples that decide a run, s.
const SAMPLE_S: f64 = 0.02;

/// A chain that can move, with the names of its links.
pub(crate) struct MovingChain {
    /// In the direction of motion.
    pub(crate) chain: ChainModel,
    /// Across, for a chain with two directions.
    across: Option<ChainModel>,
    /// The joint that couples two components, and why.
    one_plane: Option<WorkError>,
    pub(crate) links: Vec<String>,
}

impl MovingChain {
    /// Whether a direction has neither damping nor friction.
    pub(crate) fn is_undamped(&self) -> bool {
        let mut planes = std::iter::once(&self.chain).chain(&self.across);
        planes.any(|plane| !is_damped(plane))
    }
}

/// The chain of a study, or why it is refused.
pub(crate) fn model(part: &ChainPart, loads: &LoadsPart, pick: Pick<'_>) -> Result<MovingChain, Both> {
    let mut planes = Vec::new();
    for axis in part.axes() {
        let plane = part
            .moving_towards(loads, (ChainRotations::Large, *axis), pick)
            .map_err(|why| told_both(&why))?;
        planes.push(plane.ok_or_else(|| Both::from(CaseRefused::JointsUnknown))?);
    }
    let named = part.links.iter().enumerate();
    let links = named
        .map(|(i, link)| link.name.clone().unwrap_or_else(|| format!("link {}", i + 1)))
        .collect();
    let mut planes = planes.into_iter();
    let Some(chain) = planes.next() else {
        return Err(CaseRefused::JointsUnknown.into());
    };
    Ok(MovingChain {
        chain,
        across: planes.next(),
        one_plane: one_plane_only(part),
        links,
    })
}

/// Runs a chain; `None` if it was stopped. In a chain with two directions the component x acts along and y across. A motion with one
/// component acts in each direction separately, and the worse run counts.
pub(crate) fn row(
    study: &StudyPart,
    run: Run,
    model: &MovingChain,
    acting: (&GroundMotion, &dyn Progress),
) -> Option<Run> {
    row_and_rest(study, run, model, acting).map(|(run, _)| run)
}

/// The same, with the end of the run.
pub(crate) fn row_and_rest(
    study: &StudyPart,
    run: Run,
    model: &MovingChain,
    (motion, progress): (&GroundMotion, &dyn Progress),
) -> Option<(Run, Option<AtRest>)> {
    let rest = |plane: &ChainModel, history: &Option<ChainHistory>| {
        history.as_ref().map(|history| AtRest::of_chain(plane, history))
    };
    let Some(across) = &model.across else {
        let component = acting_component(motion);
        let plane = (&model.chain, model);
        let (run, history) = row_in_plane(study, run, plane, (motion, component), progress)?;
        return Some((run, rest(&model.chain, &history)));
    };
    let both = motion.has(Component::X) && motion.has(Component::Y);
    if let (true, Some(why)) = (both, &model.one_plane) {
        let refused = Run {
            outcome: RunOutcome::Refused,
            why: told_both(why),
            ..run
        };
        return Some((refused, None));
    }
    let components = match both {
        true => [Component::X, Component::Y],
        false => [acting_component(motion); 2],
    };
    let of =
        |plane, component| row_in_plane(study, run.clone(), (plane, model), (motion, component), progress);
    let along = of(&model.chain, components[0])?;
    let other = of(across, components[1])?;
    let histories = along.1.as_ref().zip(other.1.as_ref()).filter(|_| both);
    let together = histories.and_then(|(along, across)| ChainTogether::of(&model.chain, [along, across]));
    let rests = rest(&model.chain, &along.1).zip(rest(across, &other.1));
    let (worse, better) = match severity(&other.0) > severity(&along.0) {
        true => (other.0, along.0),
        false => (along.0, other.0),
    };
    let rest = rests.map(|(along, across)| along.worse(across));
    Some((joined(worse, &better, together), rest))
}

/// Order of two directions: a fall first, the earlier of two; then no verdict; then opened beds.
fn severity(run: &Run) -> (u8, f64) {
    let rank = match run.outcome {
        RunOutcome::Fell => 4,
        RunOutcome::Diverged | RunOutcome::Refused => 3,
        RunOutcome::StillMoving => 2,
        RunOutcome::Uplifted | RunOutcome::Slid => 1,
        RunOutcome::Stood => 0,
    };
    let sooner = if run.outcome == RunOutcome::Fell {
        -run.at_s
    } else {
        0.0
    };
    (rank, sooner)
}

/// The larger measures of both, as resultants if both components act.
fn joined(worse: Run, better: &Run, together: Option<ChainTogether>) -> Run {
    let (RunMeasures::Chain(a), RunMeasures::Chain(b)) = (&worse.measures, &better.measures) else {
        return worse;
    };
    let of = |value: fn(&ChainTogether) -> f64| together.as_ref().map_or(0.0, value);
    let measures = ChainMeasures {
        peak_top_displacement_m: a
            .peak_top_displacement_m
            .max(b.peak_top_displacement_m)
            .max(of(|of| of.top_m)),
        peak_rotation_rad: a
            .peak_rotation_rad
            .max(b.peak_rotation_rad)
            .max(of(|of| of.lean_rad)),
        peak_joint_rotation_rad: a.peak_joint_rotation_rad.max(b.peak_joint_rotation_rad),
        open_share: a.open_share.max(b.open_share),
        slipped_rad: a.slipped_rad.max(b.slipped_rad),
        residual_rotation_rad: a.residual_rotation_rad.max(b.residual_rotation_rad),
        energy_left_over_ratio: a.energy_left_over_ratio.max(b.energy_left_over_ratio),
    };
    Run {
        damage_state: worse.damage_state.max(better.damage_state),
        measures: RunMeasures::Chain(measures),
        ..worse
    }
}

/// One direction, with its history; `None` if it was stopped.
fn row_in_plane(
    study: &StudyPart,
    mut run: Run,
    (chain, model): (&ChainModel, &MovingChain),
    (motion, component): (&GroundMotion, Component),
    progress: &dyn Progress,
) -> Option<(Run, Option<ChainHistory>)> {
    let load = TimeFunction::of_motion(motion, component);
    let run_s = motion.duration_s() + study.rest_s.unwrap_or(SWING_REST_S);
    let history = start_rotation_rad(chain).and_then(|start_rotation_rad| {
        let options = ChainRun {
            duration_s: Some(run_s),
            output_step_s: SAMPLE_S,
            start_rotation_rad,
            ..ChainRun::default()
        };
        simulate_chain(chain, &load, &options, &mut |_| !progress.is_cancelled())
    });
    let history = match history {
        Ok(history) => history,
        Err(why) => {
            run.outcome = RunOutcome::Diverged;
            run.why = told_both(&why);
            return Some((run, None));
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
            run.why = RunEnded::LeaningFurther.into();
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
    Some((run, Some(history)))
}
