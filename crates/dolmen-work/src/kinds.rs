//! The kinds of structures: one `match` for each question that every kind answers in its own way.

use crate::building::simulate::BuildingOptions;
use crate::chain::simulate::ChainOptions;
use crate::error::WorkError;
use crate::frame::simulate::FrameOptions;
use crate::loads::LoadsAnswer;
use crate::motion::MotionAnswer;
use crate::progress::Progress;
use crate::scattered_inputs::add_scatter_of_inputs;
use crate::simulation::Simulation;
use crate::stack::simulate::{StackOptions, StackOutcome};
use crate::stack::{Law, Repeating};
use crate::state::{Check, Leaning, SensitivityOf, SpringFit, TiltCheck};
use crate::stiffness::MeasuredDirection;
use crate::surveyed::StiffnessAnswer;
use crate::version::Version;
use crate::{building, chain, frame, stack};
use dolmen::blocks::ContactRule;
use dolmen::dynamics::ChainRotations;
use dolmen::modal::Modes;
use dolmen::structure::building::{StoreyFall, storey_falls};
use dolmen::structure::stack::Stack;
use dolmen::structure::{MeasuredMode, ShapeDoubt, StiffnessNote, chain_shape_doubt, frame_shape_doubt};
use dolmen_project::{Pick, Project, Quantity, Structure, Survey};

/// Checks a structure, with the value of each input that `pick` chooses; `None` without a model.
pub(crate) fn check(project: &Project, pick: Pick<'_>) -> Result<Option<Check>, WorkError> {
    Ok(match &project.structure {
        Structure::Survey => None,
        Structure::Chain(part) => Some(Check::Chain(Box::new(chain::check::check(
            part,
            &project.loads,
            pick,
        )?))),
        Structure::Frame(part) => Some(Check::Frame(frame::check::check(part, pick)?)),
        Structure::Stack(part) => Some(Check::Stack(Box::new(stack::check::check(part, pick)?))),
        Structure::Building(part) => Some(Check::Building(Box::new(building::check::check(
            project, part, pick,
        )?))),
    })
}

/// Finds the local mechanisms of a stack as codes require; other kinds have none.
pub(crate) fn add_local_mechanisms(check: &mut Check) {
    if let Check::Stack(answer) = check {
        answer.local_mechanisms = Some(stack::local_mechanisms::of(&answer.stack, &answer.check));
    }
}

/// Finds the frequencies of pagodas like that of the file, with other heights and storeys; other kinds have none.
pub(crate) fn add_frequency_by_height(check: &mut Check, project: &Project) {
    if let (Check::Stack(answer), Structure::Stack(part)) = (check, &project.structure) {
        answer.frequency_by_height = stack::frequency_by_height::grid(part, stack::frequencies::RULE);
    }
}

/// Adds the response of a building to the wind of its file; for other kinds it is part of the loads.
pub(crate) fn add_wind(check: &mut Check, project: &Project, pick: Pick<'_>) -> Result<(), WorkError> {
    match (&project.structure, check) {
        (Structure::Building(part), Check::Building(answer)) => match &mut answer.stands {
            Some(standing) => building::wind::add_wind(standing, project, part, pick),
            None => Ok(()),
        },
        _ => Ok(()),
    }
}

/// The load factor, with the value of each input that `pick` chooses: for a frame the smallest of its directions;
/// `None` unless the stiffness is known in every direction, and for stacks.
pub(crate) fn load_factor(project: &Project, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    Ok(match &project.structure {
        Structure::Survey | Structure::Stack(_) => None,
        Structure::Chain(part) => chain::check::load_factor(part, pick)?,
        Structure::Frame(part) => frame::check::load_factor(part, pick)?,
        Structure::Building(part) => {
            let (floors, storeys) = part.floors_and_storeys(pick)?;
            let falls = storey_falls(&floors, &storeys, part.gravity_m_s2)?;
            StoreyFall::first(&falls).map(|first| first.load_factor)
        }
    })
}

/// The load factor of the verdict: for a frame with slipping joints the smaller of both states.
pub(crate) fn least_load_factor(project: &Project, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    let Some(factor) = load_factor(project, pick)? else {
        return Ok(None);
    };
    Ok(Some(match &project.structure {
        Structure::Frame(part) => frame::check::least_load_factor(part, factor, pick)?,
        Structure::Chain(_) | Structure::Stack(_) | Structure::Building(_) | Structure::Survey => factor,
    }))
}

/// The result for sensitivities, with the value of each input that `pick` chooses, near those of a check.
pub(crate) fn sensitive(
    project: &Project,
    of: SensitivityOf,
    check: Option<&Check>,
    pick: Pick<'_>,
) -> Result<Option<f64>, WorkError> {
    match (of, &project.structure, check) {
        (SensitivityOf::LoadFactor, ..) => load_factor(project, pick),
        (SensitivityOf::EqualJoints, Structure::Chain(part), _) => {
            Ok(Some(chain::check::equal_joints_n_m_rad(part, pick)?))
        }
        (SensitivityOf::FirstMotion, Structure::Stack(part), Some(Check::Stack(answer))) => {
            stack::check::first_motion_m_s2(part, answer, pick)
        }
        (SensitivityOf::EqualJoints | SensitivityOf::FirstMotion, ..) => Ok(None),
    }
}

/// The stack without what matters only in motion, with the value of each input that `pick` chooses; `None` for other kinds.
pub(crate) fn at_rest(project: &Project, pick: Pick<'_>) -> Result<Option<Stack>, WorkError> {
    match &project.structure {
        Structure::Stack(part) => Ok(Some(part.build(pick)?.with_usual_springs())),
        Structure::Survey | Structure::Chain(_) | Structure::Frame(_) | Structure::Building(_) => Ok(None),
    }
}

/// The tilt at which a joint of a chain or stack reaches its uplift limit; unknown for other kinds.
pub(crate) fn uplift_tilt(check: &Check) -> Option<f64> {
    match check {
        Check::Chain(chain) => chain::check::uplift_tilt(chain),
        // a lean by a slope is equivalent to a sideways force of that share of the weight
        Check::Stack(stack) => stack
            .check
            .limits
            .uplift
            .map(|first| first.threshold.acceleration_g),
        Check::Frame(_) | Check::Building(_) => None,
    }
}

/// The same for a chain with two directions towards the side to which it leans, along x and y; `None` for others.
pub(crate) fn uplift_tilt_towards(
    project: &Project,
    check: &Check,
    towards: [f64; 2],
) -> Option<chain::check::UpliftTilt> {
    match (&project.structure, check) {
        (Structure::Chain(part), Check::Chain(check)) if part.has_two_axes() => {
            chain::check::uplift_tilt_towards(part, check, towards)
        }
        _ => None,
    }
}

/// The response to wind and static loads, with the surveyed tilt; `None` without any, and if they are not supported.
pub(crate) fn loads(
    project: &Project,
    check: &Check,
    tilts: &[TiltCheck],
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    match (&project.structure, check) {
        (Structure::Chain(part), Check::Chain(check)) => {
            chain::loads::loads(part, &project.loads, check, Leaning::of_chain(part, tilts), pick)
        }
        (Structure::Frame(part), Check::Frame(checks)) => {
            frame::loads::loads(part, &project.loads, checks, pick)
        }
        (_, Check::Stack(answer)) => stack::loads::loads(&project.loads, answer, pick),
        (Structure::Building(part), Check::Building(answer)) => {
            building::loads::loads(project, part, answer, pick)
        }
        _ => Ok(None),
    }
}

/// The factor on the springs of a stack that gives the frequencies of surveys; none for other kinds.
pub(crate) fn spring_fits(check: &Check, surveys: &[Survey]) -> Result<Vec<SpringFit>, WorkError> {
    match check {
        Check::Stack(answer) => stack::frequencies::fits(answer, surveys),
        Check::Chain(_) | Check::Frame(_) | Check::Building(_) => Ok(Vec::new()),
    }
}

/// Every stiffness that explains measured modes, for chains and frames.
pub(crate) fn stiffness(
    project: &Project,
    direction: &str,
    modes: &[MeasuredMode],
    notes: &[StiffnessNote],
) -> Result<Vec<StiffnessAnswer>, WorkError> {
    let measured = MeasuredDirection {
        direction,
        modes,
        notes,
        loads: &project.loads,
    };
    let found = |pick: Pick<'_>| match &project.structure {
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => Ok(Vec::new()),
        Structure::Chain(part) => chain::stiffness::stiffness(part, &measured, pick),
        Structure::Frame(part) => frame::stiffness::stiffness(part, &measured, pick),
    };
    let nominal = found(&mut Quantity::nominal)?;
    Ok(add_scatter_of_inputs(project, nominal, found))
}

/// Contradictions between the shapes of a record and a chain or frame; other kinds check floors or faces.
pub(crate) fn shape_doubt(project: &Project, modes: &Modes) -> Option<ShapeDoubt> {
    match &project.structure {
        Structure::Stack(_) | Structure::Building(_) | Structure::Survey => None,
        Structure::Chain(part) => chain_shape_doubt(&part.build(&mut Quantity::nominal).ok()?, modes),
        Structure::Frame(part) => frame_shape_doubt(&part.build(&mut Quantity::nominal).ok()?, modes),
    }
}

/// Whether a version can be simulated: its stiffness is known.
pub(crate) fn can_move(project: &Project) -> bool {
    match &project.structure {
        Structure::Chain(part) => part.joints.is_some(),
        Structure::Frame(part) => part
            .directions
            .iter()
            .any(|direction| direction.stiffness.is_some()),
        Structure::Stack(_) | Structure::Building(_) => true,
        Structure::Survey => false,
    }
}

/// Time between the samples of histories in a report, s.
const REPORT_STEP_S: f64 = 0.01;

/// A version under a motion, for a report.
pub(crate) fn simulated_for_report(
    version: &Version<'_>,
    motion: MotionAnswer,
    progress: &dyn Progress,
) -> Result<Vec<Simulation>, WorkError> {
    Ok(match &version.project.structure {
        Structure::Survey => Vec::new(),
        Structure::Chain(part) => {
            let how = ChainOptions {
                push_rad: 0.0,
                rotations: ChainRotations::Large,
                duration_s: None,
                output_step_s: REPORT_STEP_S,
            };
            let runs = chain::simulate::simulate(version, part, Some(motion), &how, progress)?;
            let runs = runs.into_iter();
            runs.map(|run| Simulation::Chain(Box::new(run))).collect()
        }
        Structure::Frame(part) => {
            let how = FrameOptions {
                direction: None,
                duration_s: None,
                output_step_s: REPORT_STEP_S,
            };
            let runs = frame::simulate::simulate(version, part, &motion, &how, progress)?;
            runs.into_iter()
                .map(|run| Simulation::Frame(Box::new(run)))
                .collect()
        }
        Structure::Stack(part) => {
            let how = StackOptions {
                law: Law::AsKnown,
                contact_rule: ContactRule::Four,
                step_s: None,
                duration_s: None,
                output_step_s: REPORT_STEP_S,
                to_the_end: false,
                however_long: false,
                repeats: Repeating::WHOLE,
            };
            match stack::simulate::simulate(version, part, motion, &how, progress)? {
                StackOutcome::Simulated(run) => vec![Simulation::Stack(run)],
                StackOutcome::DoesNotStand(_) => Vec::new(),
            }
        }
        Structure::Building(part) => {
            let how = BuildingOptions {
                duration_s: None,
                step_s: REPORT_STEP_S,
                compare: true,
                keep: true,
            };
            let run = building::simulate::simulate(version, part, &motion, &how)?;
            run.into_iter()
                .map(|run| Simulation::Building(Box::new(run)))
                .collect()
        }
    })
}
