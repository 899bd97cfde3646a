//! Runs of frames.

use super::columns_alone::on_beds;
use super::simulate::{is_damped, storey_names};
use super::together::{Leaning, Plane, both_directions, has_both, is_in_plan, lean_together};
use super::{AloneStorey, FrameTogether};
use crate::at_rest::AtRest;
use crate::error::WorkError;
use crate::progress::Progress;
use crate::study::{FrameMeasures, Run, RunMeasures, RunOutcome, SWING_REST_S, acting_component};
use crate::told::told_both;
use crate::wrong::CaseRefused;
use dolmen::dynamics::{
    ColumnOutcome, DynamicsError, FrameHistory, FrameOutcome, FrictionFrame, HarmonicPoint, TimeFunction,
    simulate_frame, simulate_frame_in_plan,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen_project::{FramePart, Pick, StudyPart};
use dolmen_words::message::Both;

/// Time between the samples that decide a run, s.
const SAMPLE_S: f64 = 0.02;

/// A frame and its directions of motion.
pub(crate) struct FrameModel {
    /// In the requested direction; with two directions and no choice in the study, that along x.
    pub(crate) first: Leaning,
    /// In the direction along y, if both move.
    across: Option<Leaning>,
    /// Its lean in both directions together.
    together: f64,
    directions: [String; 2],
    pub(crate) storeys: Vec<String>,
    heights_m: Vec<f64>,
}

impl FrameModel {
    /// Whether a direction has neither damping nor friction.
    pub(crate) fn is_undamped(&self, part: &FramePart) -> bool {
        let planes = std::iter::once(&self.first).chain(&self.across);
        let mut planes = planes.zip(&self.directions);
        planes.any(|(plane, direction)| !is_damped(part, direction, &plane.frame))
    }

    /// Whether columns alone support a storey.
    pub(crate) fn stands_on_columns(&self) -> bool {
        let mut planes = std::iter::once(&self.first).chain(&self.across);
        planes.any(|plane| plane.alone.iter().any(Option::is_some))
    }

    /// The largest lean of a storey from which its runs start, as a run measures it without shaking: the surveyed tilt and the drift of its
    /// weight on it, –.
    ///
    /// # Errors
    /// [`WorkError`] if the range of values exceeds the precision of the numbers.
    pub(crate) fn lean_at_rest(&self) -> Result<f64, WorkError> {
        let drift_ratios = |of: &Leaning| -> Result<Vec<f64>, WorkError> {
            let rest_m = of.frame.leaning(of.tilt)?.start_displacement_m;
            let below_m = std::iter::once(&0.0).chain(&rest_m);
            let drifts_m = rest_m.iter().zip(below_m).map(|(own, below)| own - below);
            Ok(drifts_m
                .zip(&self.heights_m)
                .map(|(drift_m, height_m)| drift_m / height_m)
                .collect())
        };
        let largest = |drifts: &[f64]| drifts.iter().fold(0.0, |most: f64, own| most.max(own.abs()));
        let first = drift_ratios(&self.first)?;
        let along = leaning(largest(&first), self.first.tilt, self.together);
        let Some(second) = &self.across else {
            return Ok(along);
        };
        let across = drift_ratios(second)?;
        let both: Vec<f64> = first.iter().zip(&across).map(|(x, y)| x.hypot(*y)).collect();
        let across = leaning(largest(&across), second.tilt, self.together);
        Ok(along.max(across).max(largest(&both) + self.together))
    }
}

/// The lean of a storey with this drift ratio in a direction that leans by `tilt`, with the tilt across it; `together` is that of all directions.
fn leaning(drift_ratio: f64, tilt: f64, together: f64) -> f64 {
    let across = (together * together - tilt * tilt).max(0.0).sqrt();
    (drift_ratio + tilt.abs()).hypot(across)
}

impl FrameModel {
    /// Counts points of a map as fallen where columns that alone support a storey lift off: springs of beds do not represent them beyond.
    ///
    /// # Errors
    /// [`DynamicsError::SwingFalls`] for a release from beyond the lift-off.
    pub(crate) fn limit_to_lift_off(
        &self,
        points: &mut [HarmonicPoint],
        release_m: Option<f64>,
    ) -> Result<(), DynamicsError> {
        for point in points {
            point.fell |= lifts_off(self, &self.first, &point.deformation);
        }
        let each = self.first.alone.iter().zip(&self.heights_m).enumerate();
        for (storey, (alone, height_m)) in each {
            let beyond = |displacement_m: &f64| {
                alone
                    .as_ref()
                    .is_some_and(|alone| displacement_m / height_m > alone.uplift)
            };
            if let Some(displacement_m) = release_m.filter(beyond) {
                return Err(DynamicsError::SwingFalls {
                    displacement_m,
                    storey: storey + 1,
                    at_s: 0.0,
                });
            }
        }
        Ok(())
    }
}

/// The frame of a study, or why it is refused.
pub(crate) fn model(study: &StudyPart, part: &FramePart, pick: Pick<'_>) -> Result<FrameModel, Both> {
    let known = part
        .directions
        .iter()
        .filter(|direction| direction.stiffness.is_some());
    let known: Vec<&str> = known.map(|direction| direction.name.as_str()).collect();
    let both = both_directions(part).ok().filter(|_| is_in_plan(study, part));
    let direction = match (&study.direction, both, known.as_slice()) {
        (Some(name), ..) => name.as_str(),
        (None, Some([x, _]), _) => x,
        (None, None, [only]) => only,
        (None, None, []) => return Err(CaseRefused::NoDirectionKnown.into()),
        (None, None, several) => {
            return Err(CaseRefused::ChooseDirection(several.join(", ")).into());
        }
    };
    let mut leaning = |direction: &str| -> Result<Option<Leaning>, Both> {
        Leaning::of(part, direction, pick).map_err(|why| told_both(&why))
    };
    let Some(first) = leaning(direction)? else {
        return Err(CaseRefused::DirectionUnknown(direction.to_owned()).into());
    };
    let across = match both {
        Some([_, y]) => leaning(y)?,
        None => None,
    };
    Ok(FrameModel {
        storeys: storey_names(part),
        heights_m: first
            .frame
            .frame()
            .storeys()
            .iter()
            .map(|storey| storey.height_m)
            .collect(),
        directions: both.unwrap_or([direction; 2]).map(str::to_owned),
        first,
        across,
        together: part.lean.as_ref().map_or(0.0, |lean| lean.together),
    })
}

/// Runs a frame; `None` if it was stopped. If both of its directions move, x acts along the first and y along the second; a motion with one
/// component acts in each separately, and the worse run counts.
pub(crate) fn row(
    study: &StudyPart,
    run: Run,
    model: &FrameModel,
    acting: (&GroundMotion, &dyn Progress),
) -> Option<Run> {
    row_and_rest(study, run, model, acting).map(|(run, _)| run)
}

/// The same, with the end of the run.
pub(crate) fn row_and_rest(
    study: &StudyPart,
    run: Run,
    model: &FrameModel,
    (motion, progress): (&GroundMotion, &dyn Progress),
) -> Option<(Run, Option<AtRest>)> {
    let mut goes_on = |_: f64| !progress.is_cancelled();
    let span_s = (
        motion.duration_s() + study.rest_s.unwrap_or(SWING_REST_S),
        SAMPLE_S,
    );
    let plane = |of: &Leaning, component| Plane::moving(of.clone(), (motion, component), span_s);
    let refused = |why: Both| Run {
        outcome: RunOutcome::Refused,
        why,
        ..run.clone()
    };
    let both = has_both(motion);
    let first = &model.first;
    let (along, across) = match (&model.across, both) {
        (None, _) => (acting_component(motion), None),
        (Some(across), true) => (Component::X, Some((across, Component::Y))),
        (Some(across), false) => (acting_component(motion), Some((across, acting_component(motion)))),
    };
    let planes = plane(first, along).and_then(|first| {
        let second = across.map(|(across, component)| plane(across, component));
        Ok((first, second.transpose()?))
    });
    let (mut first, mut second) = match planes {
        Ok(planes) => planes,
        Err(why) => return Some((refused(told_both(&why)), None)),
    };
    let tilt_y = model.across.as_ref().map_or(0.0, |across| across.tilt);
    if let (Some(second), true) = (&mut second, both) {
        lean_together([&mut first, second], model.together);
        let found = both_at_once(&run, model, [&first, second], (span_s, &mut goes_on))?;
        return Some(match found {
            Ok((both, rest)) => (both, Some(rest)),
            Err(why) => (refused(why), None),
        });
    }
    let (mut all, mut rest) = (Vec::new(), None);
    let tilts = [model.first.tilt, tilt_y];
    let leanings = std::iter::once(&model.first).chain(&model.across);
    let planes = [Some(first), second].into_iter().flatten();
    for ((plane, tilt), leaning) in planes.zip(tilts).zip(leanings) {
        match simulate_frame(&plane.frame, &plane.load, &plane.run, &mut goes_on) {
            Ok(history) => {
                let of_springs = measured(run.clone(), (model, tilt), (&plane.frame, &history))?;
                let ground = &plane.load.ground_acceleration_m_s2;
                match on_columns(of_springs, (model, leaning), &history, (ground, span_s)) {
                    Ok(measured) => all.push(measured),
                    Err(why) => return Some((refused(why), None)),
                }
                let own = AtRest::of_frame(&history);
                rest = Some(rest.map_or(own, |other: AtRest| other.worse(own)));
            }
            Err(why) => return Some((refused(told_both(&WorkError::from(why))), None)),
        }
    }
    match <[Run; 2]>::try_from(all) {
        Ok(each) => Some((joined(each, model, None), rest)),
        Err(one) => Some((one.into_iter().next()?, rest)),
    }
}

/// Both directions under x and y at once; `None` if it was stopped.
fn both_at_once(
    run: &Run,
    model: &FrameModel,
    planes: [&Plane; 2],
    (span_s, goes_on): ((f64, f64), &mut dyn FnMut(f64) -> bool),
) -> Option<Result<(Run, AtRest), Both>> {
    let moved = simulate_frame_in_plan(
        planes.map(|plane| &plane.frame),
        planes.map(|plane| &plane.load),
        planes.map(|plane| &plane.run),
        goes_on,
    );
    let moved = match moved {
        Ok(moved) => moved,
        Err(why) => return Some(Err(told_both(&WorkError::from(why)))),
    };
    let directions = model.directions.each_ref().map(String::as_str);
    let together = FrameTogether::of(directions, planes, &moved);
    let leanings = [&model.first, model.across.as_ref()?];
    let (mut each, mut softens) = (Vec::new(), false);
    for ((leaning, plane), history) in leanings.into_iter().zip(planes).zip(&moved.histories) {
        let own = measured(run.clone(), (model, leaning.tilt), (&plane.frame, history))?;
        let ground = &plane.load.ground_acceleration_m_s2;
        // columns without joints are not followed under both
        let softer = match leaning.alone.iter().any(Option::is_some) {
            true => Ok(None),
            false => softened(&own, (model, leaning), (ground, span_s)),
        };
        match softer {
            Ok(softer) => {
                softens |= softer.is_some();
                each.push(softer.unwrap_or(own));
            }
            Err(why) => return Some(Err(why)),
        }
    }
    let each = <[Run; 2]>::try_from(each).ok()?;
    let drifts_m: Vec<f64> = together.storeys.iter().map(|of| of.drift_m).collect();
    let mut leanings = leanings.into_iter();
    let lifts_off = leanings.any(|of| lifts_off(model, of, &drifts_m));
    if lifts_off && each.iter().all(|of| of.outcome != RunOutcome::Fell) {
        return Some(Err(CaseRefused::FeetLiftOff.into()));
    }
    let [x, y] = &moved.histories;
    let rest = AtRest::of_frame(x).worse(AtRest::of_frame(y));
    let peaks_m = each.each_ref().map(peak_drift_m);
    let mut both = joined(each, model, Some(&together));
    if softens {
        drifts_by(&mut both, (model, model.together), peaks_m[0].hypot(peaks_m[1]));
    }
    Some(Ok((both, rest)))
}

/// Whether a storey on columns alone drifts beyond the lift-off of their feet.
fn lifts_off(model: &FrameModel, of: &Leaning, drifts_m: &[f64]) -> bool {
    let ratios = drifts_m.iter().zip(&model.heights_m);
    let mut each = ratios.zip(&of.alone);
    each.any(|((drift_m, height_m), alone)| {
        let beyond = |alone: &AloneStorey| drift_m.abs() / height_m > alone.uplift;
        alone.as_ref().is_some_and(beyond)
    })
}

/// The worse of a run on springs and of one on the force of columns over drift, where columns support a frame of one storey, alone or beside joints.
/// An error gives the reason for no result: feet that lift off are not followed with several storeys, or in too irregular a motion.
fn on_columns(
    run: Run,
    (model, leaning): (&FrameModel, &Leaning),
    history: &FrameHistory,
    (ground, span_s): (&TimeFunction, (f64, f64)),
) -> Result<Run, Both> {
    if leaning.held.is_none() {
        let drifts_m: Vec<f64> = history.drift_peaks.iter().map(|peak| peak.value_m).collect();
        return match run.outcome != RunOutcome::Fell && lifts_off(model, leaning, &drifts_m) {
            true => Err(CaseRefused::FeetLiftOff.into()),
            false => Ok(run),
        };
    }
    let softer = softened(&run, (model, leaning), (ground, span_s))?;
    Ok(softer.unwrap_or(run))
}

/// The worse of a run on springs and of one on the force of columns over drift; `None` where no foot lifts off.
fn softened(
    run: &Run,
    (model, leaning): (&FrameModel, &Leaning),
    (ground, span_s): (&TimeFunction, (f64, f64)),
) -> Result<Option<Run>, Both> {
    let Some(columns) = on_beds(leaning, ground, span_s).map_err(|why| told_both(&why))? else {
        return Ok(None);
    };
    let mut run = run.clone();
    match columns.history.outcome {
        ColumnOutcome::Stood => return Ok(None),
        ColumnOutcome::Rocked => {}
        ColumnOutcome::NotConverged => return Err(CaseRefused::Irregular.into()),
        ColumnOutcome::Fell { at_s } => {
            run.at_s = match run.outcome {
                RunOutcome::Fell => run.at_s.min(at_s),
                _ => at_s,
            };
            run.outcome = RunOutcome::Fell;
            run.damage_state = 4;
            run.part = model.storeys.first().cloned().unwrap_or_default();
        }
    }
    drifts_by(&mut run, (model, 0.0), columns.history.peak_drift_m);
    Ok(Some(run))
}

/// The largest drift of a run, m; 0 of a run without measures of a frame.
fn peak_drift_m(run: &Run) -> f64 {
    match &run.measures {
        RunMeasures::Frame(of) => of.peak_drift_m,
        _ => 0.0,
    }
}

/// Raises the measures of a frame of one storey to a drift, if it is larger; the lean is at least that of the drift with the tilt `beside`.
fn drifts_by(run: &mut Run, (model, beside): (&FrameModel, f64), drift_m: f64) {
    let (RunMeasures::Frame(of), [height_m]) = (&mut run.measures, model.heights_m.as_slice()) else {
        return;
    };
    let ratio = drift_m / height_m;
    let more = (ratio - of.peak_drift_ratio).max(0.0);
    of.peak_displacement_m = of.peak_displacement_m.max(drift_m);
    of.peak_drift_m = of.peak_drift_m.max(drift_m);
    of.peak_drift_ratio += more;
    of.peak_lean_ratio = (of.peak_lean_ratio + more).max(ratio + beside);
}

/// The worse of two runs, with the larger measures of both, as resultants if both components act.
fn joined([a, b]: [Run; 2], model: &FrameModel, together: Option<&FrameTogether>) -> Run {
    let (mut worse, better) = match (a.outcome, b.outcome) {
        (RunOutcome::Fell, RunOutcome::Fell) if b.at_s < a.at_s => (b, a),
        (RunOutcome::Fell, _) => (a, b),
        (_, RunOutcome::Fell) => (b, a),
        _ => (a, b),
    };
    let (RunMeasures::Frame(one), RunMeasures::Frame(other)) = (&worse.measures, &better.measures) else {
        return worse;
    };
    let mut measures = FrameMeasures {
        peak_displacement_m: one.peak_displacement_m.max(other.peak_displacement_m),
        peak_drift_m: one.peak_drift_m.max(other.peak_drift_m),
        peak_drift_ratio: one.peak_drift_ratio.max(other.peak_drift_ratio),
        peak_lean_ratio: one.peak_lean_ratio.max(other.peak_lean_ratio),
        residual_displacement_m: one.residual_displacement_m.max(other.residual_displacement_m),
        residual_drift_m: one.residual_drift_m.max(other.residual_drift_m),
        slipping_share: one.slipping_share.max(other.slipping_share),
        slipped_way_m: one.slipped_way_m.max(other.slipped_way_m),
        crushed_depth_m: one.crushed_depth_m.max(other.crushed_depth_m),
        energy_left_over_ratio: one.energy_left_over_ratio.max(other.energy_left_over_ratio),
    };
    for (of, height_m) in together
        .iter()
        .flat_map(|together| together.storeys.iter().zip(&model.heights_m))
    {
        measures.peak_drift_m = measures.peak_drift_m.max(of.drift_m);
        let drift = of.drift_m / height_m;
        measures.peak_drift_ratio = measures.peak_drift_ratio.max(drift);
        measures.peak_lean_ratio = measures.peak_lean_ratio.max(drift + model.together);
    }
    if let Some(together) = together {
        measures.residual_displacement_m = one.residual_displacement_m.hypot(other.residual_displacement_m);
        measures.residual_drift_m = one.residual_drift_m.hypot(other.residual_drift_m);
        measures.peak_displacement_m = measures.peak_displacement_m.max(together.top_m);
    }
    worse.measures = RunMeasures::Frame(measures);
    worse.damage_state = worse.damage_state.max(better.damage_state);
    worse
}

/// Deepest crushing of a face of a tenon, m; NaN without tenons that can crush.
fn crushed_depth_m(frame: &FrictionFrame, history: &FrameHistory) -> f64 {
    let each = frame.tenons().iter().zip(&history.tenons);
    let crushable = each.filter(|(tenon, _)| tenon.is_some_and(|of| of.crushing_force_n.is_some()));
    let depths_m = crushable.flat_map(|(_, faces)| faces.iter().flatten());
    depths_m.map(|face| face.crushed_m).fold(f64::NAN, f64::max)
}

/// The results of a history of a frame in a direction with this tilt; `None` if it was stopped.
fn measured(
    mut run: Run,
    (model, tilt): (&FrameModel, f64),
    (frame, history): (&FrictionFrame, &FrameHistory),
) -> Option<Run> {
    match history.outcome {
        FrameOutcome::Finished => run.outcome = RunOutcome::Stood,
        FrameOutcome::DriftLimit { storey, at_s } => {
            run.outcome = RunOutcome::Fell;
            run.at_s = at_s;
            run.part = model.storeys.get(storey).cloned().unwrap_or_default();
        }
        _ => return None,
    }
    let storeys = 0..model.heights_m.len();
    let most = |of: &dyn Fn(usize) -> f64| storeys.clone().map(of).fold(0.0, f64::max);
    let residual = |level: usize| history.rest_m.get(level).copied().unwrap_or(0.0);
    let below = |level: usize| level.checked_sub(1).map_or(0.0, residual);
    let top = model.heights_m.len() - 1;
    let peak_drift_ratio =
        most(&|storey| history.drift_peaks[storey].value_m.abs() / model.heights_m[storey]);
    let crushed_depth_m = crushed_depth_m(frame, history);
    let crushes = crushed_depth_m > 0.0; // false for NaN
    run.measures = RunMeasures::Frame(FrameMeasures {
        peak_displacement_m: history.displacement_peaks[top].value_m.abs(),
        peak_drift_m: most(&|storey| history.drift_peaks[storey].value_m.abs()),
        peak_drift_ratio,
        peak_lean_ratio: leaning(peak_drift_ratio, tilt, model.together),
        residual_displacement_m: residual(top).abs(),
        residual_drift_m: most(&|storey| (residual(storey) - below(storey)).abs()),
        slipping_share: most(&|storey| history.slipping_share(storey)),
        slipped_way_m: most(&|storey| history.slipped_way_m(storey)),
        crushed_depth_m,
        energy_left_over_ratio: history.energy_left_over_ratio(),
    });
    run.damage_state = match run.outcome {
        RunOutcome::Fell => 4,
        _ if history.slips.is_empty() && !crushes => 0,
        _ => 1,
    };
    Some(run)
}
