//! A building under a ground motion, with its dampers and without.

use super::{BuildingSimulation, WatchedPoint};
use crate::error::WorkError;
use crate::in_runs::LeftOutOfRuns;
use crate::motion::MotionAnswer;
use crate::version::Version;
use dolmen::damper::{AttachedDamper, damped_building_history};
use dolmen::dynamics::{
    BuildingHistory, BuildingRun, Histories, TunedMass, VibratingBuilding, building_history,
};
use dolmen::signal::GroundMotion;
use dolmen::structure::building::PlanDirection;
use dolmen_project::{BuildingPart, BuiltDamper, Quantity};

/// Options of a run.
pub(crate) struct BuildingOptions {
    pub(crate) duration_s: Option<f64>,
    /// Longest step, s.
    pub(crate) step_s: f64,
    /// Whether to run it without its dampers as well.
    pub(crate) compare: bool,
    /// Whether to keep every history.
    pub(crate) keep: bool,
}

/// The building under a motion; `None` if it falls under its own weight.
pub(crate) fn simulate(
    version: &Version<'_>,
    part: &BuildingPart,
    motion: &MotionAnswer,
    options: &BuildingOptions,
) -> Result<Option<BuildingSimulation>, WorkError> {
    let Some(alone) = part.as_written().cloned() else {
        return Ok(None);
    };
    let dampers = part.dampers(&alone, &mut Quantity::nominal)?;
    let run = BuildingRun {
        steps_per_sample: steps_per_sample(&motion.motion, options.step_s),
        end_s: options.duration_s,
        watched: watched(&alone, part)?,
        histories: match options.keep {
            true => Histories::Kept,
            false => Histories::PeaksAlone,
        },
    };
    let without_dampers = match !dampers.is_empty() && options.compare {
        true => Some(Box::new(building_history(&alone, &motion.motion, &run)?)),
        false => None,
    };
    let (vibrating, mut history) = moved(alone, &dampers, &motion.motion, &run)?;
    let mut along = std::mem::take(&mut history.watched).into_iter();
    let mut points = Vec::with_capacity(part.points.len());
    for point in &part.points {
        let (Some(x), Some(y)) = (along.next(), along.next()) else {
            return Err(WorkError::PointNotWatched);
        };
        points.push(WatchedPoint {
            name: point.name.clone(),
            floor: point.floor,
            place_m: [point.place[0].value, point.place[1].value],
            along: [x, y],
        });
    }
    let left_out = LeftOutOfRuns::of(version.project);
    Ok(Some(BuildingSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        variant_title: version.title.cloned(),
        floors: part.floor_names(),
        building: vibrating,
        dampers,
        motion: motion.clone(),
        drift_limit: version.project.drift_limit.clone(),
        history,
        without_dampers,
        points,
        tilt_left_out: left_out.tilt,
        without_wind: left_out.wind,
    }))
}

/// Number of steps of at most `step_s` in a sample of a motion.
pub(crate) fn steps_per_sample(motion: &GroundMotion, step_s: f64) -> usize {
    (motion.time_step_s() / step_s * (1.0 - 1e-9)).ceil().max(1.0) as usize
}

/// Rows of the points of the file, along x and along y.
fn watched(building: &VibratingBuilding, part: &BuildingPart) -> Result<Vec<Vec<f64>>, WorkError> {
    let mut rows = Vec::new();
    for point in &part.points {
        let (x, y) = (point.place[0].value, point.place[1].value);
        for direction in [PlanDirection::X, PlanDirection::Y] {
            rows.push(building.building().point_row(point.floor, x, y, direction)?);
        }
    }
    Ok(rows)
}

/// The response of the building: mode by mode if all dampers are tuned masses, otherwise all coordinates together.
pub(crate) fn moved(
    building: VibratingBuilding,
    dampers: &[BuiltDamper],
    motion: &GroundMotion,
    run: &BuildingRun,
) -> Result<(VibratingBuilding, BuildingHistory), WorkError> {
    let masses: Option<Vec<TunedMass>> = dampers.iter().map(BuiltDamper::tuned_mass).collect();
    match masses {
        Some(masses) => {
            let with = building.with_tuned_masses(masses)?;
            let history = building_history(&with, motion, run)?;
            Ok((with, history))
        }
        None => {
            let attached: Vec<AttachedDamper> = dampers.iter().map(BuiltDamper::attached).collect();
            let history = damped_building_history(&building, &attached, motion, run)?;
            Ok((building, history))
        }
    }
}
