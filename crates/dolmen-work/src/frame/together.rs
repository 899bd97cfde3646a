//! Both directions of a frame under one motion: the component in each, and their joint response.

use super::columns::{AloneStorey, alone_storeys};
use super::softening::{Softening, softening, why_springs_alone};
use crate::error::WorkError;
use crate::motion::MotionAnswer;
use crate::part_limit::{Part, PartLimit};
use crate::wrong::Place;
use dolmen::assess::demand::{DRIFT_RATIO_MOST, DriftLimit};
use dolmen::dynamics::{
    FrameHistory, FrameInPlan, FrameLoad, FrameResultant, FrameRun, FrictionFrame, SharedFriction,
    TimeFunction, resultant_drifts, storeys_that_rub_both_ways,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::stability::ColumnsBesideJoints;
use dolmen_project::{FramePart, Pick, StudyPart};

/// The joint response of two directions of a frame under two components.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameTogether {
    /// The directions, that along x first.
    pub directions: [String; 2],
    /// The largest resultant drift of each storey, lowest first.
    pub storeys: Vec<FrameResultant>,
    /// The drift of a frame of one storey, both directions together, where feet lift off: the largest drifts of both, each followed under its own
    /// component, taken at one time, m; `None` where no foot lifts off.
    pub softened_m: Option<f64>,
    /// The same with all of the stiffness in the beds, where the file does not say how beds and joints share it.
    pub all_in_beds_m: Option<f64>,
    /// Largest displacement of the top, both directions together, at the samples, m.
    pub top_m: f64,
    /// Storeys with friction in both directions, 0 the lowest.
    pub rubbing: Vec<usize>,
    /// Steps of the run with such storeys; `None` if the directions are independent, and each is exact.
    pub shared: Option<SharedFriction>,
    /// The storey with the largest resultant drift ratio, 0 the lowest.
    pub worst: usize,
    /// Its drift in each direction at the samples, m.
    pub path_m: [Vec<f64>; 2],
}

/// The part of the drift limit that a tilt leaves: both sum to the drift at which a storey has fallen.
fn left(most: f64, tilt: f64) -> f64 {
    (most - tilt.abs()).max(f64::MIN_POSITIVE)
}

/// Two directions that move together: their joint tilt reduces the drift at which either has fallen.
pub(crate) fn lean_together(planes: [&mut Plane; 2], together: f64) {
    for plane in planes {
        plane.run.drift_ratio_most = left(DRIFT_RATIO_MOST, together);
    }
}

/// A frame in one direction, ready to be run.
pub(crate) struct Plane {
    pub(crate) frame: FrictionFrame,
    pub(crate) load: FrameLoad,
    pub(crate) run: FrameRun,
}

/// A frame in one direction before it is shaken.
#[derive(Clone)]
pub(crate) struct Leaning {
    pub(crate) frame: FrictionFrame,
    /// Its lean in this direction, horizontal over vertical.
    pub(crate) tilt: f64,
    /// Drift ratio up to which the frame model is valid.
    pub(crate) drift_ratio_most: f64,
    /// The storeys that columns alone support; `None` for other storeys.
    pub(super) alone: Vec<Option<AloneStorey>>,
    /// Viscous damping ratio.
    pub(super) damping_ratio: f64,
    /// The columns of a frame of one storey whose force is followed at any drift, with the joints beside them.
    pub(super) held: Option<ColumnsBesideJoints>,
    /// The columns of a frame of one storey whose file does not say how beds and joints share its stiffness, with all of it in the beds.
    pub(super) assumed: Option<Softening>,
}

impl Leaning {
    /// The frame in a direction, as surveyed; `None` if its stiffness is unknown.
    pub(crate) fn of(part: &FramePart, direction: &str, pick: Pick<'_>) -> Result<Option<Self>, WorkError> {
        let Some(frame) = part.with_friction(direction, pick)? else {
            return Ok(None);
        };
        let alone = alone_storeys(part, direction, pick)?;
        let tilt = part.tilt(direction);
        // the force of columns depends on their drift from the lean without stress; one limit is for all storeys
        let most = match alone.as_slice() {
            [Some(alone)] => alone.most.max(f64::MIN_POSITIVE),
            _ => DRIFT_RATIO_MOST,
        };
        let own = part.directions.iter().find(|own| own.name == direction);
        let damping_ratio = own.and_then(|own| own.damping_ratio.as_ref());
        let softens = match own.filter(|own| why_springs_alone(part, own).is_none()) {
            Some(own) => softening((part, frame.frame()), own, 0, pick)?,
            None => None,
        };
        let alone_held = match alone.as_slice() {
            [Some(alone)] => Some(ColumnsBesideJoints {
                columns: alone.columns,
                joints_n_m: 0.0,
            }),
            _ => None,
        };
        let held = softens.filter(|of| of.beds.is_file()).map(|of| of.held);
        Ok(Some(Leaning {
            held: alone_held.or(held),
            assumed: softens.filter(|of| !of.beds.is_file()),
            frame,
            tilt,
            damping_ratio: damping_ratio.map_or(0.0, pick),
            drift_ratio_most: left(DRIFT_RATIO_MOST, tilt).min(most),
            alone,
        }))
    }
}

impl Plane {
    /// The frame in a direction, leaning as surveyed, under a component of a motion; `None` if its stiffness is unknown.
    pub(crate) fn of(
        part: &FramePart,
        direction: &str,
        (motion, component): (&GroundMotion, Component),
        (duration_s, output_step_s): (f64, f64),
        pick: Pick<'_>,
    ) -> Result<Option<Self>, WorkError> {
        let leaning = Leaning::of(part, direction, pick)?;
        leaning
            .map(|leaning| Plane::moving(leaning, (motion, component), (duration_s, output_step_s)))
            .transpose()
    }

    /// A frame that leans, under a component of a motion.
    pub(crate) fn moving(
        Leaning {
            frame,
            tilt,
            drift_ratio_most,
            ..
        }: Leaning,
        (motion, component): (&GroundMotion, Component),
        (duration_s, output_step_s): (f64, f64),
    ) -> Result<Self, WorkError> {
        let leaning = match tilt == 0.0 {
            true => None,
            false => Some(frame.leaning(tilt)?),
        };
        let mut load = FrameLoad::of_ground(TimeFunction::of_motion(motion, component));
        let mut run = FrameRun {
            duration_s: Some(duration_s),
            output_step_s,
            drift_ratio_most,
            ..FrameRun::default()
        };
        if let Some(leaning) = leaning {
            load.forces_n = leaning.forces_n;
            run.start_displacement_m = leaning.start_displacement_m;
        }
        Ok(Plane { frame, load, run })
    }
}

/// The directions along x and along y, each with a component of the motion.
///
/// # Errors
/// A frame with one direction, or whose file does not say which component each direction lies along.
pub(crate) fn both_directions(part: &FramePart) -> Result<[&str; 2], WorkError> {
    if let [only] = part.directions.as_slice() {
        return Err(WorkError::FrameOfOneDirection {
            direction: only.name.clone(),
        });
    }
    let along = |component| part.along(component).map(|own| own.name.as_str());
    match (along(Component::X), along(Component::Y), part.directions.len()) {
        (Some(x), Some(y), 2) => Ok([x, y]),
        _ => {
            let names: Vec<&str> = part.directions.iter().map(|own| own.name.as_str()).collect();
            Err(WorkError::DirectionsNotAlong {
                directions: names.join(", "),
            })
        }
    }
}

/// Whether a study moves both directions of a frame: it names no direction, has no maps, and both have a known stiffness.
pub(crate) fn is_in_plan(study: &StudyPart, part: &FramePart) -> bool {
    let is_known = |direction: &str| {
        let mut own = part.directions.iter();
        own.any(|own| own.name == direction && own.stiffness.is_some())
    };
    let maps = study.harmonic.is_some() || study.release_m.is_some();
    let is_free = study.direction.is_none() && !maps;
    is_free && both_directions(part).is_ok_and(|both| both.into_iter().all(is_known))
}

/// Whether a motion shakes along x and along y.
pub(crate) fn has_both(motion: &GroundMotion) -> bool {
    motion.has(Component::X) && motion.has(Component::Y)
}

/// The only horizontal component that acts: each direction of a frame, and a chain, moves in one plane.
pub(crate) fn horizontal(motion: &MotionAnswer, what: Place) -> Result<Component, WorkError> {
    match (motion.motion.has(Component::X), motion.motion.has(Component::Y)) {
        (true, true) => Err(WorkError::TwoHorizontal { what: what.into() }),
        (true, false) => Ok(Component::X),
        (false, true) => Ok(Component::Y),
        (false, false) => Err(WorkError::NoHorizontal { what: what.into() }),
    }
}

/// Largest displacement of the top, never less than in one direction.
fn top_m(histories: [&FrameHistory; 2]) -> f64 {
    let [x, y] = histories.map(|of| of.displacement_m.last());
    let samples = x.into_iter().flatten().zip(y.into_iter().flatten());
    let peaks = histories
        .into_iter()
        .filter_map(|of| Some(of.displacement_peaks.last()?.value_m.abs()));
    samples.map(|(x, y)| x.hypot(*y)).chain(peaks).fold(0.0, f64::max)
}

impl FrameTogether {
    /// From the motion of two planes.
    pub(crate) fn of(directions: [&str; 2], planes: [&Plane; 2], moved: &FrameInPlan) -> Self {
        let [x, y] = &moved.histories;
        let storeys = resultant_drifts([x, y]);
        let heights = planes[0].frame.frame().storeys().iter();
        let ratios = storeys
            .iter()
            .zip(heights)
            .map(|(of, storey)| of.drift_m / storey.height_m);
        let worst = ratios
            .enumerate()
            .max_by(|a, b| a.1.total_cmp(&b.1))
            .map_or(0, |(storey, _)| storey);
        let drift = |history: &FrameHistory| history.drift_m(worst);
        FrameTogether {
            directions: directions.map(str::to_owned),
            softened_m: None,
            all_in_beds_m: None,
            storeys,
            top_m: top_m([x, y]),
            rubbing: storeys_that_rub_both_ways([&planes[0].frame, &planes[1].frame]),
            shared: moved.shared,
            worst,
            path_m: [drift(x), drift(y)],
        }
    }

    /// The directions in one word: "x+y".
    pub fn direction(&self) -> String {
        self.directions.join("+")
    }

    /// The resultant of both directions of each storey, compared with its allowable drift; the lean before the motion is `tilt`.
    pub(crate) fn parts(
        &self,
        (names, heights_m): (&[String], &[f64]),
        tilt: f64,
        limit: Option<&DriftLimit>,
    ) -> Vec<PartLimit> {
        let direction = self.direction();
        let storeys = names.iter().zip(heights_m).zip(&self.storeys);
        let softened_m = self.softened_m.unwrap_or(0.0);
        let each = storeys.map(|((name, height_m), of)| {
            let part = Part::Storey(name.clone());
            let drift = of.drift_m.max(softened_m) / height_m;
            PartLimit::of_drift(part, &direction, drift, limit).taking([tilt, 0.0])
        });
        each.collect()
    }
}
