//! A frame under a ground motion, in its directions of known stiffness.

use super::FrameSimulation;
use super::columns_alone::columns_in_motion;
use crate::error::WorkError;
use crate::in_runs::LeftOutOfRuns;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::study::SWING_REST_S;
use crate::undamped::Undamped;
use crate::version::Version;
use crate::wrong::Place;
use dolmen::dynamics::{FrameLoad, FrameRun, FrictionFrame, StoreyFriction, TimeFunction, simulate_frame};
use dolmen::signal::Component;
use dolmen_project::{FramePart, Quantity};

/// How a frame is run.
pub(crate) struct FrameOptions<'a> {
    pub(crate) direction: Option<&'a str>,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

/// Each direction of known stiffness, or the one that is wished.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &FramePart,
    motion: &MotionAnswer,
    options: &FrameOptions<'_>,
    progress: &dyn Progress,
) -> Result<Vec<FrameSimulation>, WorkError> {
    let known: Vec<&str> = part
        .directions
        .iter()
        .filter(|direction| direction.stiffness.is_some())
        .map(|direction| direction.name.as_str())
        .collect();
    let all: Vec<&str> = part
        .directions
        .iter()
        .map(|direction| direction.name.as_str())
        .collect();
    let chosen: Vec<&str> = match options.direction {
        Some(name) if known.contains(&name) => vec![name],
        Some(name) if all.contains(&name) => {
            return Err(WorkError::DirectionUnknown {
                direction: name.to_owned(),
            });
        }
        Some(name) => {
            return Err(WorkError::NoSuchDirection {
                direction: name.to_owned(),
                known: all.join(", "),
            });
        }
        None if known.is_empty() => {
            return Err(WorkError::NoDirectionKnown {
                directions: all.join(", "),
            });
        }
        None => known,
    };
    let without_stiffness: Vec<String> = match options.direction {
        Some(_) => Vec::new(),
        None => all
            .iter()
            .filter(|name| !chosen.contains(name))
            .map(|name| (*name).to_owned())
            .collect(),
    };
    let component = horizontal(motion, Place::Frame)?;
    let run_s = options
        .duration_s
        .unwrap_or(motion.motion.duration_s() + SWING_REST_S);
    let mut found = Vec::new();
    for direction in chosen {
        let Some(frame) = part.with_friction(direction, &mut Quantity::nominal)? else {
            continue;
        };
        let load = FrameLoad::of_ground(TimeFunction::of_motion(&motion.motion, component));
        let run = FrameRun {
            duration_s: Some(run_s),
            output_step_s: options.output_step_s,
            ..FrameRun::default()
        };
        let history = simulating(progress, run_s, |reached| {
            simulate_frame(&frame, &load, &run, reached)
        })?;
        found.push(FrameSimulation {
            file: version.file.to_owned(),
            name: version.project.name.clone(),
            variant: version.variant.map(str::to_owned),
            variant_title: version.title.cloned(),
            direction: direction.to_owned(),
            without_stiffness: without_stiffness.clone(),
            storeys: storey_names(part),
            undamped: (!is_damped(part, direction, &frame))
                .then(|| Undamped::of(&version.project.surveys, Some(direction))),
            tilt_left_out: LeftOutOfRuns::of(version.project).tilt,
            columns: columns_in_motion(
                part,
                &load.ground_acceleration_m_s2,
                run_s,
                options.output_step_s,
                &mut Quantity::nominal,
            )?,
            frame,
            motion: motion.clone(),
            component,
            options: run,
            drift_limit: version.project.drift_limit.clone(),
            history,
        });
    }
    Ok(found)
}

/// The horizontal component that acts: each direction of a frame, and a chain, is a plane of its own.
pub(crate) fn horizontal(motion: &MotionAnswer, what: Place) -> Result<Component, WorkError> {
    match (motion.motion.has(Component::X), motion.motion.has(Component::Y)) {
        (true, true) => Err(WorkError::TwoHorizontal { what: what.into() }),
        (true, false) => Ok(Component::X),
        (false, true) => Ok(Component::Y),
        (false, false) => Err(WorkError::NoHorizontal { what: what.into() }),
    }
}

/// Whether a direction of a frame has dashpots or friction.
fn is_damped(part: &FramePart, direction: &str, frame: &FrictionFrame) -> bool {
    let own = part.directions.iter().find(|own| own.name == direction);
    let ratio = own.and_then(|own| own.damping_ratio.as_ref());
    let mut friction = frame.friction().iter();
    ratio.is_some_and(|ratio| ratio.value > 0.0) || friction.any(|friction| *friction != StoreyFriction::None)
}

/// Names of the storeys, lowest first.
pub(crate) fn storey_names(part: &FramePart) -> Vec<String> {
    let each = part.storeys.iter().enumerate();
    each.map(|(i, storey)| storey.name.clone().unwrap_or_else(|| format!("storey {}", i + 1)))
        .collect()
}
