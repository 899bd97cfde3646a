//! A chain pushed, or on a moving ground, up to its fall.

use super::ChainSimulation;
use super::limits::link_names;
use crate::error::WorkError;
use crate::frame::simulate::horizontal;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::study::SWING_REST_S;
use crate::tilt_left_out::TiltLeftOut;
use crate::undamped::Undamped;
use crate::version::Version;
use crate::wrong::Place;
use dolmen::dynamics::{
    ChainModel, ChainRotations, ChainRun, DynamicsError, TimeFunction, chain_at_rest, chain_growth,
    simulate_chain,
};
use dolmen_project::{ChainPart, LoadPart, LoadsPart, Quantity};

/// Length of a run that begins with a push alone, s: a pole of 0.3 Hz swings twenty times. Chosen here.
const PUSHED_S: f64 = 60.0;
/// Largest push, rad: a chain that leans more is set up wrongly.
const PUSH_MOST_RAD: f64 = 0.5;

/// How a chain is run.
pub(crate) struct ChainOptions {
    pub(crate) push_rad: f64,
    pub(crate) rotations: ChainRotations,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

/// The run itself.
///
/// # Errors
/// Too large a push, nothing that moves it, unknown joints, two horizontal components.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &ChainPart,
    motion: Option<MotionAnswer>,
    options: &ChainOptions,
    progress: &dyn Progress,
) -> Result<ChainSimulation, WorkError> {
    if options.push_rad.abs() > PUSH_MOST_RAD {
        return Err(WorkError::PushTooLarge {
            push_rad: options.push_rad,
            most_rad: PUSH_MOST_RAD,
        });
    }
    if motion.is_none() && options.push_rad == 0.0 {
        return Err(WorkError::NothingMovesChain);
    }
    let loads = &version.project.loads;
    let Some(model) = part.moving(loads, options.rotations, &mut Quantity::nominal)? else {
        return Err(WorkError::JointsUnknown);
    };
    let motion = match motion {
        None => None,
        Some(motion) => {
            let component = horizontal(&motion, Place::Chain)?;
            Some((motion, component))
        }
    };
    let load = match &motion {
        None => TimeFunction::Zero,
        Some((motion, component)) => TimeFunction::of_motion(&motion.motion, *component),
    };
    let run_s = options.duration_s.unwrap_or(match &motion {
        None => PUSHED_S,
        Some((motion, _)) => motion.motion.duration_s() + SWING_REST_S,
    });
    let start = start_rotation_rad(&model)?;
    let run = ChainRun {
        duration_s: Some(run_s),
        output_step_s: options.output_step_s,
        start_rotation_rad: start.iter().map(|at_rest| at_rest + options.push_rad).collect(),
        ..ChainRun::default()
    };
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
    let mut joints = model.joints().iter();
    let is_damped = model.has_friction() || joints.any(|joint| joint.damping_n_m_s_rad > 0.0);
    Ok(ChainSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        variant_title: version.title.cloned(),
        links: link_names(part),
        first_frequency_hz: match &growth {
            Some(_) => None,
            None => modes.first().map(|mode| mode.frequency_hz),
        },
        carried_n: carried_n(loads),
        loads_left_out: loads.wind().is_some() || loads.loads.iter().any(LoadPart::pushes),
        undamped: (!is_damped).then(|| Undamped::of(&version.project.surveys, None)),
        model,
        motion,
        push_rad: options.push_rad,
        options: run,
        growth,
        lean: part.lean.clone(),
        tilt_left_out: match part.lean {
            Some(_) => None,
            None => TiltLeftOut::of(&version.project.surveys),
        },
        history,
    })
}

/// Weight of the static loads, N.
fn carried_n(loads: &LoadsPart) -> f64 {
    let weights = loads.loads.iter().filter_map(|load| load.weight.as_ref());
    weights.map(|weight| weight.value).sum()
}

/// Where a run begins: at rest as the chain leans, or, where it does not come to rest so, as it leans.
pub(super) fn start_rotation_rad(model: &ChainModel) -> Result<Vec<f64>, DynamicsError> {
    let leaning = vec![model.lean_rad(); model.joints().len()];
    Ok(chain_at_rest(model)?.unwrap_or(leaning))
}
