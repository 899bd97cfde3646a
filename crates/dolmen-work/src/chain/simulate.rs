//! A chain pushed, or on a moving ground, up to its fall.

use super::limits::link_names;
use super::{ChainSimulation, ChainTogether};
use crate::error::WorkError;
use crate::frame::together::horizontal;
use crate::in_runs::LeftOutOfRuns;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::study::SWING_REST_S;
use crate::undamped::Undamped;
use crate::version::Version;
use crate::wrong::Place;
use dolmen::dynamics::{
    ChainModel, ChainRotations, ChainRun, DynamicsError, JointOpening, TimeFunction, chain_at_rest,
    chain_growth, lowest_turning_joint, simulate_chain,
};
use dolmen::signal::Component;
use dolmen_project::{ChainAxis, ChainPart, LoadsPart, Quantity};

/// Length of a run with a push alone, s: twenty periods of a pole of 0.3 Hz. Our choice.
const PUSHED_S: f64 = 60.0;
/// Largest push, rad: a chain that leans more is a mistake in the input.
const PUSH_MOST_RAD: f64 = 0.5;

/// Options of a run.
pub(crate) struct ChainOptions {
    pub(crate) push_rad: f64,
    pub(crate) rotations: ChainRotations,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

/// A direction of a chain and the component of the motion that acts in it; `None` on a still ground.
type ShakenDirection = (ChainAxis, Option<Component>);

/// The runs: one, or for a chain with two directions one in each, also under two components.
///
/// # Errors
/// A push that is too large, no push and no motion, unknown joints, two components on joints that couple them.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &ChainPart,
    motion: Option<MotionAnswer>,
    options: &ChainOptions,
    progress: &dyn Progress,
) -> Result<Vec<ChainSimulation>, WorkError> {
    if options.push_rad.abs() > PUSH_MOST_RAD {
        return Err(WorkError::PushTooLarge {
            push_rad: options.push_rad,
            most_rad: PUSH_MOST_RAD,
        });
    }
    if motion.is_none() && options.push_rad == 0.0 {
        return Err(WorkError::NothingMovesChain);
    }
    let acting = acting(part, motion.as_ref())?;
    let mut runs = Vec::new();
    for of in &acting {
        runs.push(simulate_one(
            version,
            part,
            motion.clone(),
            (options, of),
            progress,
        )?);
    }
    let is_together = acting
        .iter()
        .any(|(_, component)| *component == Some(Component::Y))
        && acting
            .iter()
            .any(|(_, component)| *component == Some(Component::X));
    if acting.len() > 1 {
        for (run, (axis, _)) in runs.iter_mut().zip(&acting) {
            run.direction = Some(*axis);
        }
    }
    if let (true, [along, across]) = (is_together, runs.as_mut_slice()) {
        let together = ChainTogether::of(&along.model, [&along.history, &across.history]);
        along.together = together;
        across.together = together;
    }
    Ok(runs)
}

/// The load in each direction. The directions are independent if joints are linear or open at the edges of rectangular beds: the resultant
/// lies within the bed if both components do.
fn acting(part: &ChainPart, motion: Option<&MotionAnswer>) -> Result<Vec<ShakenDirection>, WorkError> {
    let each =
        |component: Option<Component>| part.axes().iter().map(move |axis| (*axis, component)).collect();
    let Some(motion) = motion else {
        return Ok(each(None));
    };
    if !(motion.motion.has(Component::X) && motion.motion.has(Component::Y)) {
        return Ok(each(Some(horizontal(motion, Place::Chain)?)));
    }
    if let Some(why) = one_plane_only(part) {
        return Err(why);
    }
    Ok(vec![
        (ChainAxis::Along, Some(Component::X)),
        (ChainAxis::Across, Some(Component::Y)),
    ])
}

/// Why two components are coupled, for the first joint that couples them.
pub(super) fn one_plane_only(part: &ChainPart) -> Option<WorkError> {
    let mut joints = part.joints.iter().flatten().enumerate();
    joints.find_map(|(i, joint)| {
        let opens = joint.opening != Some(JointOpening::Held) && part.links[i].bed_width.is_some();
        let number = i + 1;
        match joint {
            _ if joint.friction.is_some() => Some(WorkError::OnePlaneFriction { joint: number }),
            _ if opens && joint.strength.is_some() => Some(WorkError::OnePlaneStrength { joint: number }),
            _ if opens && joint.bed_depth.is_none() => Some(WorkError::OnePlaneNoDepth { joint: number }),
            _ => None,
        }
    })
}

/// The run in one direction.
fn simulate_one(
    version: &Version<'_>,
    part: &ChainPart,
    motion: Option<MotionAnswer>,
    (options, (axis, component)): (&ChainOptions, &ShakenDirection),
    progress: &dyn Progress,
) -> Result<ChainSimulation, WorkError> {
    let loads = &version.project.loads;
    let Some(model) = part.moving_towards(loads, (options.rotations, *axis), &mut Quantity::nominal)? else {
        return Err(WorkError::JointsUnknown);
    };
    let both = motion
        .as_ref()
        .is_some_and(|of| of.motion.has(Component::X) && of.motion.has(Component::Y));
    let model = match &part.lean {
        Some(lean) if both => model.leaning(lean.towards_rad(*axis))?,
        _ => model,
    };
    let motion = motion.zip(*component);
    let load = match &motion {
        None => TimeFunction::Zero,
        Some((motion, component)) => TimeFunction::of_motion(&motion.motion, *component),
    };
    let run_s = options.duration_s.unwrap_or(match &motion {
        None => PUSHED_S,
        Some((motion, _)) => motion.motion.duration_s() + SWING_REST_S,
    });
    let mut run = ChainRun {
        duration_s: Some(run_s),
        output_step_s: options.output_step_s,
        start_rotation_rad: start_rotation_rad(&model)?,
        ..ChainRun::default()
    };
    let pushed_from = lowest_turning_joint(&model, &run, options.push_rad);
    for rotation_rad in run.start_rotation_rad.iter_mut().skip(pushed_from) {
        *rotation_rad += options.push_rad;
    }
    let history = simulating(progress, run_s, |reached| {
        simulate_chain(&model, &load, &run, reached)
    })?;
    let stiffness: Vec<f64> = model
        .joints()
        .iter()
        .map(|joint| joint.stiffness_n_m_rad)
        .collect();
    let modes = model.chain().natural_modes(&stiffness)?;
    let growth = chain_growth(&model, &history)?;
    let left_out = LeftOutOfRuns::of(version.project);
    Ok(ChainSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        variant_title: version.title.cloned(),
        direction: None,
        together: None,
        links: link_names(part),
        first_frequency_hz: match &growth {
            Some(_) => None,
            None => modes.first().map(|mode| mode.frequency_hz),
        },
        carried_n: carried_n(loads),
        loads_left_out: left_out.wind || left_out.forces,
        undamped: (!is_damped(&model)).then(|| Undamped::of(&version.project.surveys, None)),
        lean: part.lean.clone(),
        tilt_left_out: left_out.tilt.filter(|_| part.lean.is_none()),
        model,
        motion,
        push_rad: options.push_rad,
        pushed_from,
        options: run,
        growth,
        history,
    })
}

/// Whether a chain has dashpots or friction.
pub(super) fn is_damped(model: &ChainModel) -> bool {
    let mut joints = model.joints().iter();
    model.has_friction() || joints.any(|joint| joint.damping_n_m_s_rad > 0.0)
}

/// Weight of the static loads, N.
fn carried_n(loads: &LoadsPart) -> f64 {
    let weights = loads.loads.iter().filter_map(|load| load.weight.as_ref());
    weights.map(|weight| weight.value).sum()
}

/// Initial state of a run: at rest in the leaning shape, or, if no such state exists, the leaning shape itself.
pub(super) fn start_rotation_rad(model: &ChainModel) -> Result<Vec<f64>, DynamicsError> {
    let leaning = vec![model.lean_rad(); model.joints().len()];
    Ok(chain_at_rest(model)?.unwrap_or(leaning))
}
