//! `dolmen simulate --wind`: a building in histories of the wind of its file, with and without its dampers.

use super::wind::{BuildingInWind, wind_drift_limit};
use super::wind_answer::WIND_DURATION_S;
use super::wind_history_answer::{HistoriesAlong, MotionInTime, WindSimulation};
use super::wind_rows::WindRows;
use super::wind_seen::{RequestedRows, WindOutputs};
use crate::error::WorkError;
use crate::version::Version;
use dolmen::damper::{AttachedDamper, DamperError, gust_history, gust_motion, gust_times};
use dolmen::structure::Building;
use dolmen::structure::wind::{GustDraw, GustTimes};
use dolmen_project::{BuildingPart, Quantity};
use std::ops::Range;

/// Default number of histories of each wind: they give the mean peak to a third of its scatter. Our choice.
const REPEATS: usize = 10;
/// Longest default step, s. Our choice.
const STEP_MOST_S: f64 = 0.02;
/// Fewest steps in a period of the lowest mode: spectral lines reach a quarter of the sampling rate, so eight times its frequency. Our choice.
const STEPS_A_PERIOD: f64 = 32.0;
/// Fewest steps in a period of the third mode, the last one that sways or twists without a node: lines reach twice its frequency. Our choice.
const STEPS_A_THIRD_PERIOD: f64 = 8.0;

/// Options of the histories.
pub(crate) struct WindOptions {
    /// Length of each history, s; by default the ten minutes of the mean wind.
    pub(crate) duration_s: Option<f64>,
    /// Time between samples, s.
    pub(crate) step_s: Option<f64>,
    /// Seed of the first history.
    pub(crate) seed: u64,
    /// Number of histories of each wind.
    pub(crate) repeats: Option<usize>,
}

/// The building in histories of its wind; `None` if it falls under its own weight.
pub(crate) fn simulate_wind(
    version: &Version<'_>,
    part: &BuildingPart,
    options: &WindOptions,
) -> Result<Option<WindSimulation>, WorkError> {
    let Some(given) = version.project.loads.wind() else {
        return Err(WorkError::NoWindGiven);
    };
    let Some(alone) = part.as_written().cloned() else {
        return Ok(None);
    };
    let pick = &mut Quantity::nominal;
    let dampers = part.dampers(&alone, pick)?;
    let building = alone.building();
    let blown = BuildingInWind::new((building, &dampers), part, given, pick)?;
    let (step_most_s, mode_hz) = step_most(alone.modes().modes.iter().map(|mode| mode.frequency_hz));
    if let Some(step_s) = options.step_s.filter(|step_s| *step_s > step_most_s) {
        return Err(WorkError::WindStepTooLong {
            step_s,
            most_s: step_most_s,
            mode_hz,
        });
    }
    let duration_s = options.duration_s.unwrap_or(WIND_DURATION_S);
    let own_step_s = STEP_MOST_S.min(step_most_s);
    let step_s = options.step_s.unwrap_or(own_step_s).min(duration_s);
    let times = gust_times(&blown.structure, &blown.dampers, duration_s, step_s)?;
    let repeats = options.repeats.unwrap_or(REPEATS) as u64;
    let seeds: Vec<u64> = (0..repeats).map(|k| options.seed.wrapping_add(k)).collect();
    let along = |axis| histories_along(&blown, building, axis, (&times, &seeds));
    let mut run = WindSimulation {
        file: version.file.to_owned(),
        name: version.project.name.clone(),
        variant: version.variant.map(str::to_owned),
        variant_title: version.title.cloned(),
        floors: part.floor_names(),
        acceleration_limit_m_s2: given.in_time.acceleration_limit.as_ref().map(Quantity::nominal),
        drift_limit: given.in_time.drift_limit,
        eccentricity: given.in_time.eccentricity,
        duration_s,
        time_step_s: times.time_step_s,
        period_s: times.period_s(),
        seeds: seeds.clone(),
        along: [along(0)?, along(1)?],
        building: building.clone(),
        dampers,
    };
    let drift = run.largest_drift().map(|drift| drift.of_height);
    run.drift_limit = wind_drift_limit(version.project, run.drift_limit, drift);
    Ok(Some(run))
}

/// The longest step with which gusts reach the modes that they excite, s, and the frequency of the governing mode, Hz.
fn step_most(frequencies_hz: impl Iterator<Item = f64>) -> (f64, f64) {
    let mut all: Vec<f64> = frequencies_hz.collect();
    all.sort_by(f64::total_cmp);
    let lowest = all.first().map(|hz| (1.0 / (STEPS_A_PERIOD * hz), *hz));
    let third = all.get(2).map(|hz| (1.0 / (STEPS_A_THIRD_PERIOD * hz), *hz));
    let each = lowest.into_iter().chain(third);
    each.min_by(|a, b| a.0.total_cmp(&b.0))
        .unwrap_or((STEP_MOST_S, 0.0))
}

fn histories_along(
    blown: &BuildingInWind<'_>,
    building: &Building,
    axis: usize,
    (times, seeds): (&GustTimes, &[u64]),
) -> Result<HistoriesAlong, WorkError> {
    let face = blown.face(axis)?;
    face.check().map_err(DamperError::from)?;
    let draws = seeds.iter().map(|seed| GustDraw {
        seed: *seed,
        stream: axis as u64,
    });
    let draws: Vec<GustDraw> = draws.collect();
    let gusts = face.histories(times, &draws).map_err(DamperError::from)?;
    let moved = |dampers: &[AttachedDamper]| -> Result<MotionInTime, WorkError> {
        let columns = blown.columns(axis);
        let duration_s = (times.looked_at - 1) as f64 * times.time_step_s;
        let all = gust_motion(&blown.structure, dampers, &face, &columns, duration_s)?;
        let wanted = RequestedRows::of(WindRows::of(building, axis, &all)?);
        let mut seen = WindOutputs::new(&wanted.rows, &all);
        for gusts in &gusts {
            let history = gust_history(&blown.structure, dampers, &columns, &wanted.rows, gusts)?;
            seen.see(history);
        }
        let of = |candidates: &Range<usize>| seen.rows(candidates.clone());
        Ok(MotionInTime {
            top_displacement_m: of(&wanted.top_displacement),
            drifts_m: wanted.drifts.iter().map(of).collect(),
            top_acceleration_m_s2: of(&wanted.top_acceleration),
            corner_m_s2: of(&wanted.corner),
            base_shear_n: of(&wanted.base_shear),
            base_torque_n_m: of(&wanted.base_torque),
            strokes_m: (0..all[0].strokes.len()).map(|k| seen.stroke(k)).collect(),
        })
    };
    let breadths_m = face.strips.iter().map(|strip| strip.breadth_m);
    Ok(HistoriesAlong {
        breadth_m: breadths_m.sum::<f64>() / face.strips.len() as f64,
        without: moved(&[])?,
        with: match blown.dampers.is_empty() {
            true => None,
            false => Some(moved(&blown.dampers)?),
        },
    })
}
