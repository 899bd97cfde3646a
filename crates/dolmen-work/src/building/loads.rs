//! A building under static loads and combinations with its wind and its earthquake.

use super::check::{moved, standing};
use super::wind::add_wind;
use super::{BuildingAnswer, StandingBuilding};
use crate::error::WorkError;
use crate::loads::{
    BuildingCombination, CombinationAnswer, Combined, LoadsAnswer, StoreyCombined, UnknownMotion,
};
use dolmen::assess::demand::DriftLimit;
use dolmen_project::{BuildingPart, CombinationPart, LoadPart, Pick, Project};

/// The building under every combination of the file; `None` without any.
pub(crate) fn loads(
    project: &Project,
    part: &BuildingPart,
    answer: &BuildingAnswer,
    pick: Pick<'_>,
) -> Result<Option<LoadsAnswer>, WorkError> {
    let given = &project.loads;
    if given.combinations.is_empty() {
        return Ok(None);
    }
    let mut combinations = Vec::with_capacity(given.combinations.len());
    for combination in &given.combinations {
        combinations.push(CombinationAnswer {
            name: combination.name.clone(),
            weight: combination.weight,
            wind: combination.wind,
            loads: combination.loads,
            of: Combined::Building(Box::new(combined(
                (project, part),
                answer,
                combination,
                &mut *pick,
            )?)),
        });
    }
    Ok(Some(LoadsAnswer {
        has_wind: given.wind().is_some(),
        has_loads: !given.loads.is_empty(),
        wind: None,
        wind_across: None,
        frame_winds: Vec::new(),
        carried: None,
        tilt_rad: 0.0,
        combinations,
    }))
}

fn combined(
    (project, part): (&Project, &BuildingPart),
    answer: &BuildingAnswer,
    of: &CombinationPart,
    pick: Pick<'_>,
) -> Result<BuildingCombination, WorkError> {
    let mut combination = BuildingCombination {
        earthquake: of.earthquake,
        weight_factor: answer.load_factor() / of.weight,
        storeys: Vec::new(),
        unknown: None,
        drift_limit: drift_limit(project, of),
    };
    let Some(as_is) = &answer.stands else {
        return Ok(combination);
    };
    if combination.weight_factor.is_nan() || combination.weight_factor <= 1.0 {
        return Ok(combination);
    }
    // P-delta of another weight makes the building stiffer or softer, and its motions others
    let weighed = match of.weight == 1.0 || !part.p_delta {
        true => None,
        false => {
            let vibrating = part.vibrating_under(of.weight, &mut *pick)?;
            let mut own = standing(project, part, &vibrating, &mut *pick)?;
            if of.wind > 0.0 {
                add_wind(&mut own, project, part, &mut *pick)?;
            }
            Some(own)
        }
    };
    let moving: &StandingBuilding = weighed.as_ref().unwrap_or(as_is);
    combination.unknown = unknown(moving, of);
    combination.storeys = storeys((project, part), &answer.floors, moving, of, pick)?;
    Ok(combination)
}

/// The drift limit for a combination. Limits of codes are for earthquakes: without one only a limit that the file gives as a number holds, or
/// the one that it gives for the wind.
fn drift_limit(project: &Project, of: &CombinationPart) -> Option<f64> {
    let of_storeys = project.drift_limit.as_ref();
    let given = of_storeys.filter(|limit| of.earthquake > 0.0 || matches!(limit, DriftLimit::Given { .. }));
    let of_wind = project.loads.wind().and_then(|wind| wind.in_time.drift_limit);
    let of_wind = of_wind.filter(|_| of.wind > 0.0 && of.earthquake == 0.0);
    of_wind.or(given.map(DriftLimit::ratio))
}

/// The first motion that counts and is unknown.
fn unknown(moving: &StandingBuilding, of: &CombinationPart) -> Option<UnknownMotion> {
    if of.wind > 0.0 && moving.wind.is_none() {
        return Some(UnknownMotion::Wind);
    }
    (of.earthquake > 0.0 && moving.judged_drift_m().is_none()).then_some(UnknownMotion::Earthquake)
}

fn storeys(
    (project, part): (&Project, &BuildingPart),
    floors: &[String],
    moving: &StandingBuilding,
    of: &CombinationPart,
    pick: Pick<'_>,
) -> Result<Vec<StoreyCombined>, WorkError> {
    let building = &moving.building;
    let each = project.loads.loads.iter();
    let forces: Vec<_> = each.map(|load: &LoadPart| load.on_floor(&mut *pick)).collect();
    let q = building.under_loads(&forces)?;
    let size = |row: &[f64]| row.iter().zip(&q).map(|(a, b)| a * b).sum::<f64>().abs();
    let by_loads = moved(part, building, &size, &mut *pick)?;
    let shaken = moving.judged_drift_m();
    let winds = moving.wind.as_ref().map(|wind| wind.motions());
    let storey = |(i, floor): (usize, &String)| {
        let edge = by_loads.edge_drift_m[i];
        let drift_m = edge.unwrap_or(by_loads.centre_drift_m[i]);
        let blown = winds.map_or([0.0; 2], |along| {
            along.map(|motion| motion.floors[i].drift_m.peak())
        });
        let shaken = shaken.as_ref().map_or([0.0; 2], |drifts| drifts[i]);
        StoreyCombined {
            floor: floor.clone(),
            height_m: building.storeys()[i].height_m,
            at_centre: edge.is_none(),
            displacement_m: [q[3 * i], q[3 * i + 1]].map(|m| m * of.loads),
            rotation_rad: q[3 * i + 2] * of.loads,
            loads_m: drift_m.map(|m| m * of.loads),
            wind_m: blown.map(|m| m * of.wind),
            earthquake_m: shaken.map(|m| m * of.earthquake),
        }
    };
    Ok(floors.iter().enumerate().map(storey).collect())
}
