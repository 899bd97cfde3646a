//! A frame under wind, static loads and their combinations.

use super::lean::leaning;
use super::wind::wind_met;
use crate::error::WorkError;
use crate::loads::{
    CombinationAnswer, Combined, DirectionUnderLoads, FrameCombination, FrameWind, LoadedStorey, LoadsAnswer,
    SlippingWind,
};
use crate::state::DirectionCheck;
use dolmen::assess::FrameCheck;
use dolmen::assess::demand::DRIFT_RATIO_MOST;
use dolmen::dynamics::StoreyFriction;
use dolmen::stability::{FramePush, FreeColumns, frame_stability, frame_under_loads};
use dolmen::structure::wind::WindError;
use dolmen::structure::{Frame, lowest_frequency_hz};
use dolmen_project::{
    CombinationPart, DirectionPart, FramePart, LoadPart, LoadsPart, Pick, Quantity, WindGiven,
};

/// The response of a frame to wind and static loads; `None` without such loads.
pub(crate) fn loads(
    part: &FramePart,
    given: &LoadsPart,
    checks: &[DirectionCheck],
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    if given.is_empty() {
        return Ok(None);
    }
    let frame = part.build(pick)?;
    let mut answer = LoadsAnswer {
        has_wind: given.wind().is_some(),
        has_loads: !given.loads.is_empty(),
        carried: None,
        tilt_rad: part.lean.as_ref().map_or(0.0, |lean| lean.together),
        combinations: Vec::new(),
        wind: None,
        wind_across: None,
        frame_winds: Vec::new(),
    };
    for (direction, check) in checks.iter().enumerate() {
        let Some(wind) = given.wind() else { break };
        let met = wind_of(
            part,
            (wind, direction),
            check,
            (&frame, largest_factor(given)),
            pick,
        )?;
        match met {
            Ok(met) => answer.frame_winds.push(met),
            Err(why) => {
                answer.frame_winds.clear();
                answer.wind = Some(Err(why));
                return Ok(Some(answer));
            }
        }
    }
    answer.wind = answer.frame_winds.first().map(|of| Ok(of.met.clone()));
    for combination in &given.combinations {
        answer.combinations.push(CombinationAnswer {
            name: combination.name.clone(),
            weight: combination.weight,
            wind: combination.wind,
            loads: combination.loads,
            of: Combined::Frame(Box::new(under(
                (part, combination),
                &given.loads,
                &answer.frame_winds,
                pick,
            )?)),
        });
    }
    Ok(Some(answer))
}

/// The largest factor of a combination on the wind.
fn largest_factor(given: &LoadsPart) -> f64 {
    let each = given.combinations.iter().map(|of| of.wind.abs());
    each.fold(0.0, f64::max)
}

/// The wind along a direction, and, where its gust times `factor` slips a joint, the wind at the frequency of slipping joints.
fn wind_of(
    part: &FramePart,
    (wind, direction): (&WindGiven, usize),
    check: &DirectionCheck,
    (frame, factor): (&Frame, f64),
    pick: Pick<'_>,
) -> Result<Result<FrameWind, WindError>, WorkError> {
    let at = |check: &FrameCheck, pick: Pick<'_>| {
        let frequency_hz = lowest_frequency_hz(&check.modes);
        wind_met(part, (wind, direction), frequency_hz, frame, pick)
    };
    let mut met = match at(&check.check, pick) {
        Ok(met) => met,
        Err(why) => return Ok(Err(why)),
    };
    // without a frequency it falls while its joints slip, in any wind
    let softer = check.slipping.as_ref();
    let softer = softer.filter(|of| lowest_frequency_hz(&of.modes).is_some());
    let gust_n: Vec<f64> = met.levels_n.iter().map(|force| factor * force).collect();
    if let Some(softer) = softer
        && gust_slips(part, &part.directions[direction].name, &gust_n, pick)?
    {
        match at(softer, pick) {
            Ok(slipping) => {
                met.slipping = Some(SlippingWind {
                    met: slipping.met,
                    levels_n: slipping.levels_n,
                });
            }
            Err(why) => return Ok(Err(why)),
        }
    }
    Ok(Ok(met))
}

/// Whether forces at the levels bring the joints of a storey to their slip force, leaning as surveyed: (k − k_slip) δ of the stuck frame
/// against the static slip force.
fn gust_slips(
    part: &FramePart,
    direction: &str,
    forces_n: &[f64],
    pick: Pick<'_>,
) -> Result<bool, WorkError> {
    let (Some(slipping), Some(stuck_n_m)) = (
        part.with_friction(direction, pick)?,
        part.stiffness_n_m(direction, pick),
    ) else {
        return Ok(false);
    };
    let push = FramePush {
        forces_n,
        columns: &vec![None; forces_n.len()],
        tilt: part.tilt(direction),
        drift_ratio_most: DRIFT_RATIO_MOST,
    };
    let pushed = frame_under_loads(slipping.frame(), &stuck_n_m, &push)?;
    let mut each = pushed
        .storeys
        .iter()
        .zip(slipping.friction())
        .zip(slipping.frame().storeys());
    Ok(each.any(|((of, friction), storey)| {
        let StoreyFriction::Jenkins {
            stuck_stiffness_n_m,
            static_force_n,
            ..
        } = *friction
        else {
            return false;
        };
        // a storey that cannot resist the gust slips in any case
        let (Some(drift_m), Some(lean)) = (of.drift_m, of.lean_at_rest) else {
            return true;
        };
        let leaning_m = (lean - push.tilt.abs()) * storey.height_m;
        stuck_stiffness_n_m * (drift_m + leaning_m) >= static_force_n
    }))
}

/// The frame under a combination.
fn under(
    (part, combination): (&FramePart, &CombinationPart),
    loads: &[LoadPart],
    winds: &[FrameWind],
    pick: Pick<'_>,
) -> Result<FrameCombination, WorkError> {
    let frame = part.build_weighing([combination.weight, combination.loads], pick)?;
    let columns = columns(part, &frame, pick)?;
    let mut found = FrameCombination {
        directions: Vec::new(),
        unknown: Vec::new(),
        weight_factor: None,
    };
    for (i, direction) in part.directions.iter().enumerate() {
        let Some(stuck) = part.stiffness_n_m(&direction.name, pick) else {
            found.unknown.push(direction.name.clone());
            continue;
        };
        let still = forces_on_levels(part, direction, loads, pick);
        let slipping = part.slipping_stiffness_n_m(&direction.name, pick);
        let mut storeys: Vec<LoadedStorey> = Vec::new();
        for (slips, stiffness) in [(false, Some(stuck)), (true, slipping)] {
            let Some(stiffness) = stiffness else { continue };
            let blown = winds.get(i).map(|wind| wind.levels_in(slips));
            let factor = frame_stability(&frame, &stiffness)?.load_factor;
            found.weight_factor = Some(found.weight_factor.map_or(factor, |least| least.min(factor)));
            for way in [1.0, -1.0] {
                let level = |i: usize| {
                    let wind = blown.map_or(0.0, |levels| levels[i]);
                    combination.loads * still[i] + way * combination.wind * wind
                };
                let forces_n: Vec<f64> = (0..still.len()).map(level).collect();
                let push = FramePush {
                    forces_n: &forces_n,
                    columns: &columns,
                    tilt: part.tilt(&direction.name),
                    drift_ratio_most: DRIFT_RATIO_MOST,
                };
                let of = frame_under_loads(&frame, &stiffness, &push)?;
                let heights = frame.storeys().iter().map(|storey| storey.height_m);
                let each = of.storeys.into_iter().zip(heights);
                let each = each.map(|(under, height_m)| LoadedStorey {
                    under,
                    height_m,
                    tilt: part.tilt(&direction.name).abs(),
                    wind_reversed: way < 0.0,
                    slips,
                });
                worse(&mut storeys, each.collect());
            }
        }
        found.directions.push(DirectionUnderLoads {
            direction: direction.name.clone(),
            storeys,
        });
    }
    Ok(found)
}

/// Lean of each storey at rest under static loads as given, the larger of sticking and slipping joints, in a direction with a given lean
/// without them; `None` if it cannot resist them.
pub(super) fn with_loads(
    part: &FramePart,
    frame: &Frame,
    direction: &DirectionPart,
    without: Vec<f64>,
) -> Result<Option<Vec<f64>>, WorkError> {
    let pick: Pick<'_> = &mut Quantity::nominal;
    let forces_n = forces_on_levels(part, direction, &part.static_loads, pick);
    if forces_n.iter().all(|force| *force == 0.0) {
        return Ok(Some(without));
    }
    let columns = columns(part, frame, pick)?;
    let push = FramePush {
        forces_n: &forces_n,
        columns: &columns,
        tilt: part.tilt(&direction.name),
        drift_ratio_most: DRIFT_RATIO_MOST,
    };
    let stuck = part.stiffness_n_m(&direction.name, pick);
    let slipping = part.slipping_stiffness_n_m(&direction.name, pick);
    let mut leans = without;
    for stiffness in [stuck, slipping].into_iter().flatten() {
        let of = frame_under_loads(frame, &stiffness, &push)?;
        for ((lean, storey), of) in leans.iter_mut().zip(frame.storeys()).zip(of.storeys) {
            let (Some(at_rest), Some(drift_m)) = (of.lean_at_rest, of.drift_m) else {
                return Ok(None);
            };
            *lean = lean.abs().max(at_rest + drift_m / storey.height_m);
        }
    }
    Ok(Some(leans))
}

/// The additional lean of each storey at rest from forces of static loads; infinite if it cannot resist them.
pub(super) fn static_drifts(part: &FramePart, direction: &str) -> Result<Vec<f64>, WorkError> {
    let none = vec![0.0; part.storeys.len()];
    let Some(own) = part.directions.iter().find(|own| own.name == direction) else {
        return Ok(none);
    };
    let frame = part.build(&mut Quantity::nominal)?;
    let leans = leaning(part, &frame, own, &mut Quantity::nominal)?.unwrap_or(none);
    Ok(match with_loads(part, &frame, own, leans.clone())? {
        None => vec![f64::INFINITY; leans.len()],
        Some(pushed) => {
            let each = pushed.iter().zip(&leans);
            each.map(|(pushed, lean)| pushed.abs() - lean.abs()).collect()
        }
    })
}

/// Each storey in the worse of two cases; in the first if they are equal.
fn worse(storeys: &mut Vec<LoadedStorey>, others: Vec<LoadedStorey>) {
    if storeys.is_empty() {
        *storeys = others;
        return;
    }
    for (own, other) in storeys.iter_mut().zip(others) {
        if other.under.factor < own.under.factor {
            *own = other;
        }
    }
}

/// The free-standing columns of each storey, under the weight of the frame.
fn columns(part: &FramePart, frame: &Frame, pick: Pick<'_>) -> Result<Vec<Option<FreeColumns>>, WorkError> {
    let each = part.storeys.iter().zip(frame.storeys());
    let each = each.map(|(given, storey)| {
        let columns = given.columns.as_ref();
        columns.map(|columns| columns.build(storey, pick)).transpose()
    });
    Ok(each.collect::<Result<_, _>>()?)
}

/// Forces of static loads on each level in a direction, lowest first, N; both ends of columns share a force between levels.
pub(super) fn forces_on_levels(
    part: &FramePart,
    direction: &DirectionPart,
    loads: &[LoadPart],
    pick: Pick<'_>,
) -> Vec<f64> {
    let mut levels_n = vec![0.0; part.storeys.len()];
    let mut levels_m = Vec::with_capacity(levels_n.len() + 1);
    levels_m.push(0.0);
    for storey in &part.storeys {
        levels_m.push(levels_m[levels_m.len() - 1] + pick(&storey.height));
    }
    for load in loads {
        let Some(force_n) = part.force_of(load, direction).map(&mut *pick) else {
            continue;
        };
        let [bottom_m, top_m] = [levels_m[load.part], levels_m[load.part + 1]];
        let share = load.height.as_ref().map_or(1.0, |height| {
            ((pick(height) - bottom_m) / (top_m - bottom_m)).clamp(0.0, 1.0)
        });
        levels_n[load.part] += share * force_n;
        if let Some(below) = load.part.checked_sub(1) {
            levels_n[below] += (1.0 - share) * force_n;
        }
    }
    levels_n
}
