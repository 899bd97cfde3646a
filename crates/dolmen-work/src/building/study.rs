//! Runs of buildings.

use super::simulate::steps_per_sample;
use crate::study::{BuildingMeasures, Run, RunMeasures, RunOutcome};
use crate::told::told_both;
use dolmen::damper::{AttachedDamper, damped_building_history};
use dolmen::dynamics::{
    BuildingHistory, BuildingRun, Histories, TunedMass, VibratingBuilding, building_history,
};
use dolmen::signal::GroundMotion;
use dolmen_project::{BuildingPart, BuiltDamper, Pick, StudyPart, strokes_of};
use dolmen_words::message::Both;

/// Longest step between samples of a motion, s: that of `dolmen simulate`.
const STEP_S: f64 = 0.01;

/// A building with its dampers, ready for runs.
pub(crate) struct BuildingModel {
    building: VibratingBuilding,
    dampers: Vec<BuiltDamper>,
    floors: Vec<String>,
}

/// The building of a study, or why it is refused.
pub(crate) fn model(part: &BuildingPart, pick: Pick<'_>) -> Result<BuildingModel, Both> {
    let words = |why: &(dyn std::error::Error + 'static)| told_both(why);
    let building = part.vibrating(pick).map_err(|why| words(&why))?;
    let dampers = part.dampers(&building, pick).map_err(|why| words(&why))?;
    let masses: Option<Vec<TunedMass>> = dampers.iter().map(BuiltDamper::tuned_mass).collect();
    let building = match masses {
        Some(masses) => building.with_tuned_masses(masses).map_err(|why| words(&why))?,
        None => building,
    };
    Ok(BuildingModel {
        building,
        dampers,
        floors: part.floor_names(),
    })
}

fn history(model: &BuildingModel, motion: &GroundMotion, run: &BuildingRun) -> Result<BuildingHistory, Both> {
    if model.building.tuned_masses().len() == model.dampers.len() {
        return building_history(&model.building, motion, run).map_err(|why| told_both(&why));
    }
    let attached: Vec<AttachedDamper> = model.dampers.iter().map(BuiltDamper::attached).collect();
    damped_building_history(&model.building, &attached, motion, run).map_err(|why| told_both(&why))
}

/// Runs a building.
pub(crate) fn row(study: &StudyPart, mut run: Run, model: &BuildingModel, motion: &GroundMotion) -> Run {
    let options = BuildingRun {
        steps_per_sample: steps_per_sample(motion, STEP_S),
        end_s: study.rest_s.map(|rest_s| motion.duration_s() + rest_s),
        histories: Histories::PeaksAlone,
        ..BuildingRun::default()
    };
    let found = match history(model, motion, &options) {
        Ok(found) => found,
        Err(why) => {
            run.outcome = RunOutcome::Refused;
            run.why = why;
            return run;
        }
    };
    let storeys = model.building.building().storeys();
    // as in `dolmen simulate`: in any direction, at a corner if there is an outline
    let drifts = found.peaks.storeys.iter().zip(storeys);
    let drifts = drifts.map(|(peak, storey)| (peak.resultant, peak.resultant.size_m / storey.height_m));
    let worst = drifts
        .enumerate()
        .reduce(|worst, own| if own.1.1 > worst.1.1 { own } else { worst });
    let Some((storey, (drift, drift_ratio))) = worst else {
        return run; // a building has at least one storey
    };
    let largest = |values: &mut dyn Iterator<Item = f64>| values.map(f64::abs).fold(0.0, f64::max);
    let peaks = &found.peaks;
    let top = peaks.floors.last().copied().unwrap_or_default();
    let pairs = strokes_of(&model.dampers).into_iter().zip(&peaks.strokes_m);
    let mut over_room = pairs.filter_map(|(of, stroke)| Some(stroke.value.abs() / of.room_m?));
    let strokes = peaks.strokes_m.iter().take(model.dampers.len());
    run.measures = RunMeasures::Building(BuildingMeasures {
        peak_top_displacement_m: largest(
            &mut [top.displacement_x_m.value, top.displacement_y_m.value].into_iter(),
        ),
        peak_drift_m: largest(
            &mut peaks
                .storeys
                .iter()
                .flat_map(|s| [s.drift_x_m.value, s.drift_y_m.value]),
        ),
        peak_corner_drift_m: drift.size_m,
        peak_corner_drift_ratio: drift_ratio,
        base_shear_x_n: peaks.base_shear_n[0].value.abs(),
        base_shear_y_n: peaks.base_shear_n[1].value.abs(),
        base_torque_n_m: peaks.base_torque_n_m.value.abs(),
        peak_stroke_m: largest(&mut strokes.map(|stroke| stroke.value)),
        stroke_over_room: largest(&mut over_room),
    });
    run.damage_state = study
        .drift_limits
        .iter()
        .filter(|limit| drift_ratio >= **limit)
        .count() as u8;
    run.outcome = RunOutcome::Stood;
    if usize::from(run.damage_state) == study.drift_limits.len() {
        run.outcome = RunOutcome::Fell;
        run.at_s = drift.at_s;
        run.part = model.floors.get(storey).cloned().unwrap_or_default();
    }
    run
}
