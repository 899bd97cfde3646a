//! A frame under a ground motion, in its directions of known stiffness.

use super::beside::beside;
use super::columns::alone_most;
use super::columns_alone::columns_in_motion;
use super::loads::static_drifts;
use super::together::{Plane, both_directions, has_both, horizontal, lean_together};
use super::{FrameSimulation, FrameTogether};
use crate::error::WorkError;
use crate::in_runs::LeftOutOfRuns;
use crate::motion::MotionAnswer;
use crate::progress::{Progress, simulating};
use crate::study::SWING_REST_S;
use crate::undamped::Undamped;
use crate::version::Version;
use crate::wrong::Place;
use dolmen::dynamics::{FrameHistory, FrictionFrame, StoreyFriction, simulate_frame, simulate_frame_in_plan};
use dolmen::signal::Component;
use dolmen_project::{FramePart, Quantity};

/// Options of a run.
pub(crate) struct FrameOptions<'a> {
    pub(crate) direction: Option<&'a str>,
    pub(crate) duration_s: Option<f64>,
    pub(crate) output_step_s: f64,
}

/// Runs each direction of known stiffness, or the requested one.
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
    let run_s = options
        .duration_s
        .unwrap_or(motion.motion.duration_s() + SWING_REST_S);
    let mut runs = Vec::new();
    let mut together = None;
    let output_step_s = motion
        .measured
        .as_ref()
        .map_or(options.output_step_s, |of| options.output_step_s.min(of.step_s));
    // under ground motion from a survey, one direction can be run alone
    let alone = motion.measured.is_some() && options.direction.is_some();
    let in_plan = has_both(&motion.motion) && !alone;
    if in_plan {
        if let Some(name) = options.direction {
            return Err(WorkError::DirectionOfBoth {
                direction: name.to_owned(),
            });
        }
        let directions = both_directions(part)?;
        let components = [Component::X, Component::Y];
        for (direction, component) in directions.into_iter().zip(components) {
            runs.extend(plane(
                part,
                (direction, component),
                motion,
                (run_s, output_step_s),
            )?);
        }
        let tilt = part.lean.as_ref().map_or(0.0, |lean| lean.together);
        if let [((x, _), first), ((y, _), second)] = runs.as_mut_slice() {
            lean_together([(first, part.tilt(x)), (second, part.tilt(y))], tilt);
        }
        if let [(_, x), (_, y)] = runs.as_slice() {
            let moved = simulating(progress, run_s, |reached| {
                simulate_frame_in_plan(
                    [&x.frame, &y.frame],
                    [&x.load, &y.load],
                    [&x.run, &y.run],
                    reached,
                )
            })?;
            let of = FrameTogether::of(directions, [x, y], &moved);
            together = Some((of, moved.histories));
        }
    } else {
        for direction in chosen {
            let component = component_of(motion, direction)?;
            runs.extend(plane(
                part,
                (direction, component),
                motion,
                (run_s, output_step_s),
            )?);
        }
    }
    let left_out = LeftOutOfRuns::of(version.project);
    let (together, moved) = together.map_or((None, None), |(of, moved)| (Some(of), Some(moved)));
    let mut moved: Vec<Option<FrameHistory>> = match moved {
        Some(moved) => moved.into_iter().map(Some).collect(),
        None => runs.iter().map(|_| None).collect(),
    };
    let mut found = Vec::new();
    for (((direction, component), plane), moved) in runs.into_iter().zip(&mut moved) {
        let Plane { frame, load, run } = plane;
        let history = match moved.take() {
            Some(history) => history,
            None => simulating(progress, run_s, |reached| {
                simulate_frame(&frame, &load, &run, reached)
            })?,
        };
        let ground = (!in_plan).then_some(&load.ground_acceleration_m_s2);
        found.push(FrameSimulation {
            file: version.file.to_owned(),
            name: version.project.name.clone(),
            variant: version.variant.map(str::to_owned),
            variant_title: version.title.cloned(),
            without_stiffness: without_stiffness.clone(),
            together: together.clone(),
            lean: part.lean.clone(),
            tilt: part.tilt(&direction),
            storeys: storey_names(part),
            undamped: (!is_damped(part, &direction, &frame))
                .then(|| Undamped::of(&version.project.surveys, Some(&direction))),
            carried_n: version.project.loads.weight_n(&mut Quantity::nominal),
            columns_most: alone_most(part, &direction, &mut Quantity::nominal)?,
            static_drifts: static_drifts(part, &direction)?,
            loads_left_out: left_out.wind || left_out.forces,
            tilt_left_out: left_out.tilt.clone(),
            beside: beside((motion, component), &direction, &frame, &history),
            columns: columns_in_motion(part, ground, run_s, options.output_step_s, &mut Quantity::nominal)?,
            direction,
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

/// The component that acts in a direction; from a survey's ground motion that of the same name.
fn component_of(motion: &MotionAnswer, direction: &str) -> Result<Component, WorkError> {
    let named = [Component::X, Component::Y]
        .into_iter()
        .find(|of| of.name() == direction && motion.motion.has(*of));
    match named.filter(|_| motion.measured.is_some()) {
        Some(component) => Ok(component),
        None => horizontal(motion, Place::Frame),
    }
}

/// A direction, the component along it, and its frame.
type Acting = ((String, Component), Plane);

/// The frame and load of a direction; `None` if its stiffness is unknown.
fn plane(
    part: &FramePart,
    (direction, component): (&str, Component),
    motion: &MotionAnswer,
    how: (f64, f64),
) -> Result<Option<Acting>, WorkError> {
    let plane = Plane::of(
        part,
        direction,
        (&motion.motion, component),
        how,
        &mut Quantity::nominal,
    )?;
    Ok(plane.map(|plane| ((direction.to_owned(), component), plane)))
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
