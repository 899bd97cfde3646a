//! A frame under a ground motion, in its directions of known stiffness.

use super::beside::beside;
use super::columns::alone_storeys;
use super::columns_alone::columns_in_motion;
use super::loads::static_drifts;
use super::softening::unfollowed;
use super::together::{Plane, both_directions, has_both, horizontal, lean_together};
use super::{ColumnsOnBeds, FrameSimulation, FrameTogether, UnfollowedStorey};
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
    let ChosenDirections {
        chosen,
        without_stiffness,
    } = ChosenDirections::of(part, options.direction)?;
    let run_s = options
        .duration_s
        .unwrap_or(motion.motion.duration_s() + SWING_REST_S);
    let output_step_s = motion
        .measured
        .as_ref()
        .map_or(options.output_step_s, |of| options.output_step_s.min(of.step_s));
    // under ground motion from a survey, one direction can be run alone
    let alone = motion.measured.is_some() && options.direction.is_some();
    let in_plan = has_both(&motion.motion) && !alone;
    let how = (run_s, output_step_s);
    let InMotion {
        directions,
        together,
        histories,
    } = match (in_plan, options.direction) {
        (true, Some(name)) => {
            return Err(WorkError::DirectionOfBoth {
                direction: name.to_owned(),
            });
        }
        (true, None) => in_both_directions(part, motion, how, progress)?,
        (false, _) => {
            let mut directions = Vec::new();
            for direction in chosen {
                let component = component_of(motion, direction)?;
                directions.extend(plane(part, (direction, component), motion, how)?);
            }
            InMotion {
                directions,
                together: None,
                histories: None,
            }
        }
    };
    let left_out = LeftOutOfRuns::of(version.project);
    let mut moved: Vec<Option<FrameHistory>> = match histories {
        Some(histories) => histories.into_iter().map(Some).collect(),
        None => directions.iter().map(|_| None).collect(),
    };
    let mut found = Vec::new();
    for (((direction, component), plane), moved) in directions.into_iter().zip(&mut moved) {
        let Plane { frame, load, run } = plane;
        let history = match moved.take() {
            Some(history) => history,
            None => simulating(progress, run_s, |reached| {
                simulate_frame(&frame, &load, &run, reached)
            })?,
        };
        let ground = (&load.ground_acceleration_m_s2, in_plan);
        let moved = columns_in_motion((part, &direction), ground, (run_s, options.output_step_s))?;
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
            static_drifts: static_drifts(part, &direction)?,
            loads_left_out: left_out.wind || left_out.forces,
            tilt_left_out: left_out.tilt.clone(),
            beside: beside((motion, component), &direction, &frame, &history),
            unfollowed: unfollowed_storeys(part, &direction, &history)?,
            columns: moved.columns,
            all_in_beds: moved.all_in_beds,
            columns_alone: alone_storeys(part, &direction, &mut Quantity::nominal)?,
            direction,
            frame,
            motion: motion.clone(),
            component,
            options: run,
            drift_limit: version.project.drift_limit.clone(),
            history,
        });
    }
    soften_together(&mut found);
    Ok(found)
}

/// The storeys of a direction whose softening the run does not follow.
fn unfollowed_storeys(
    part: &FramePart,
    direction: &str,
    history: &FrameHistory,
) -> Result<Vec<UnfollowedStorey>, WorkError> {
    let Some(own) = part.directions.iter().find(|own| own.name == direction) else {
        return Ok(Vec::new());
    };
    let pick = &mut Quantity::nominal;
    let frame = part.build(pick)?;
    let drifts_m: Vec<f64> = history.drift_peaks.iter().map(|peak| peak.value_m).collect();
    unfollowed((part, &frame), own, (&storey_names(part), &drifts_m), pick)
}

/// Two directions under both components: the resultant of the largest drifts of both where feet lift off.
fn soften_together(found: &mut [FrameSimulation]) {
    let [x, y] = found else { return };
    let (softened_m, all_in_beds_m) = (
        resultant_m([&*x, &*y], |_| None),
        resultant_m([&*x, &*y], |of| of.all_in_beds.as_ref().map(|of| &of.run)),
    );
    for together in [x, y].into_iter().filter_map(|run| run.together.as_mut()) {
        together.softened_m = softened_m;
        together.all_in_beds_m = all_in_beds_m.filter(|_| all_in_beds_m != softened_m);
    }
}

/// The resultant of the largest drifts of both directions, on springs or on the columns followed, or assumed, whichever is larger; `None` where
/// no foot lifts off.
fn resultant_m(
    runs: [&FrameSimulation; 2],
    assumed: impl Fn(&FrameSimulation) -> Option<&ColumnsOnBeds>,
) -> Option<f64> {
    let softer = runs.map(|run| run.on_beds().or(assumed(run)).filter(|of| of.lifts_off()));
    let peak_m = |at: usize| {
        let own_m = runs[at].history.drift_peaks.first();
        let own_m = own_m.map_or(0.0, |peak| peak.value_m.abs());
        softer[at].map_or(own_m, |of| of.history.peak_drift_m.max(own_m))
    };
    softer
        .iter()
        .any(Option::is_some)
        .then(|| peak_m(0).hypot(peak_m(1)))
}

/// The directions of a run.
struct ChosenDirections<'a> {
    chosen: Vec<&'a str>,
    /// Directions left out because their stiffness is unknown, if no direction was requested.
    without_stiffness: Vec<String>,
}

impl<'a> ChosenDirections<'a> {
    fn of(part: &'a FramePart, requested: Option<&'a str>) -> Result<Self, WorkError> {
        let all: Vec<&str> = part.directions.iter().map(|own| own.name.as_str()).collect();
        let known = part.directions.iter().filter(|own| own.stiffness.is_some());
        let known: Vec<&str> = known.map(|own| own.name.as_str()).collect();
        match requested {
            Some(name) if known.contains(&name) => Ok(ChosenDirections {
                chosen: vec![name],
                without_stiffness: Vec::new(),
            }),
            Some(name) if all.contains(&name) => Err(WorkError::DirectionUnknown {
                direction: name.to_owned(),
            }),
            Some(name) => Err(WorkError::NoSuchDirection {
                direction: name.to_owned(),
                known: all.join(", "),
            }),
            None if known.is_empty() => Err(WorkError::NoDirectionKnown {
                directions: all.join(", "),
            }),
            None => {
                let others = all.into_iter().filter(|name| !known.contains(name));
                Ok(ChosenDirections {
                    without_stiffness: others.map(str::to_owned).collect(),
                    chosen: known,
                })
            }
        }
    }
}

/// The directions that a motion acts in.
struct InMotion {
    directions: Vec<ShakenDirection>,
    /// Both directions at once, if both components act.
    together: Option<FrameTogether>,
    /// Their histories, if they were run together.
    histories: Option<[FrameHistory; 2]>,
}

/// Runs both directions together.
fn in_both_directions(
    part: &FramePart,
    motion: &MotionAnswer,
    (run_s, output_step_s): (f64, f64),
    progress: &dyn Progress,
) -> Result<InMotion, WorkError> {
    let mut runs = Vec::new();
    let directions = both_directions(part)?;
    let components = [Component::X, Component::Y];
    for (direction, component) in directions.into_iter().zip(components) {
        let how = (run_s, output_step_s);
        runs.extend(plane(part, (direction, component), motion, how)?);
    }
    let tilt = part.lean.as_ref().map_or(0.0, |lean| lean.together);
    if let [(_, first), (_, second)] = runs.as_mut_slice() {
        lean_together([first, second], tilt);
    }
    let (mut together, mut histories) = (None, None);
    if let [(_, x), (_, y)] = runs.as_slice() {
        let moved = simulating(progress, run_s, |reached| {
            simulate_frame_in_plan(
                [&x.frame, &y.frame],
                [&x.load, &y.load],
                [&x.run, &y.run],
                reached,
            )
        })?;
        together = Some(FrameTogether::of(directions, [x, y], &moved));
        histories = Some(moved.histories);
    }
    Ok(InMotion {
        directions: runs,
        together,
        histories,
    })
}

/// The component that acts in a direction; from a survey's ground motion, the one with the same name.
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
type ShakenDirection = ((String, Component), Plane);

/// The frame and load of a direction; `None` if its stiffness is unknown.
fn plane(
    part: &FramePart,
    (direction, component): (&str, Component),
    motion: &MotionAnswer,
    how: (f64, f64),
) -> Result<Option<ShakenDirection>, WorkError> {
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
pub(super) fn is_damped(part: &FramePart, direction: &str, frame: &FrictionFrame) -> bool {
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
