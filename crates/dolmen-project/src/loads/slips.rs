//! Probable slips in wind and loads.

use super::part::{LoadsPart, WindGiven, WindPart, WindSpeed};
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::WrongLoads;

/// Speed of a gust or of the mean in codes, m/s: from a fresh breeze to the largest measured gusts.
const SPEED_M_S: (f64, f64) = (8.0, 95.0);
/// Peak velocity pressure of such gusts, Pa.
const PRESSURE_PA: (f64, f64) = (40.0, 6000.0);
/// Force coefficient: from a smooth round section in a storm to a lattice.
const COEFFICIENT: (f64, f64) = (0.4, 4.0);
/// Horizontal force or weight of a load, N: from a rope pulled by hand to a building.
const FORCE_N: (f64, f64) = (1.0, 5e7);
/// Factor of the weight in a combination: codes have 0.8 to 1.5.
const WEIGHT_FACTOR: (f64, f64) = (0.5, 2.0);
/// Density of air, kg/m³: from 4000 m in summer to sea level in deep frost.
const DENSITY_KG_M3: (f64, f64) = (0.7, 1.5);
/// I_w of KDS 41 12 00: from temporary buildings to very tall ones.
const IMPORTANCE: (f64, f64) = (0.9, 1.1);
/// Largest comfort limit, m/s²: three times and more what codes and guides allow; people hardly stand. Our choice.
const COMFORT_MOST_M_S2: f64 = 1.0;
/// Largest drift in the wind over the height: what KDS 41 17 00 allows in an earthquake.
const DRIFT_MOST: f64 = 0.02;

pub(crate) fn judge_loads(reader: &mut Reader, loads: &LoadsPart) {
    forces(reader, loads);
    combinations(reader, loads);
    let WindPart::Given(wind) = &loads.wind else {
        return;
    };
    let quantity = wind.speed.quantity();
    let (range, help) = match &wind.speed {
        WindSpeed::Pressure(_) => (PRESSURE_PA, WrongLoads::GustOfMS),
        _ => (SPEED_M_S, WrongLoads::SpeedsAreInM),
    };
    let outside = |value: f64, (least, most): (f64, f64)| !(least..=most).contains(&value);
    if outside(quantity.value, range) {
        let message = WrongLoads::IsNoStormThat {
            path: quantity.path.to_string(),
            written: quantity.written.to_string(),
        };
        reader.slip(&quantity.path, message, help.to_owned());
    }
    let coefficients = wind
        .areas
        .iter()
        .filter_map(|area| area.force_coefficient.as_ref());
    for of in std::iter::once(&wind.force_coefficient).chain(coefficients) {
        if outside(of.value, COEFFICIENT) {
            let message = WrongLoads::IsOutsideWhatBodies {
                path: of.path.to_string(),
                written: of.written.to_string(),
            };
            reader.slip(&of.path, message, WrongLoads::SquarePrismHasOctagon);
        }
    }
    if outside(wind.air_density_kg_m3, DENSITY_KG_M3) {
        let message = WrongLoads::WindDensityIsKg(wind.air_density_kg_m3.to_string());
        reader.slip("wind.density", message, WrongLoads::AirHasKgM3);
    }
    lenient(reader, wind);
}

/// Importance and limits that make a verdict better than any code does.
fn lenient(reader: &mut Reader, wind: &WindGiven) {
    if let WindSpeed::Kds41 { importance, .. } = &wind.speed
        && !(IMPORTANCE.0..=IMPORTANCE.1).contains(importance)
    {
        let message = WrongLoads::ImportanceUnlikely(short(*importance));
        reader.slip("wind.importance_factor", message, WrongLoads::ImportanceOfCode);
    }
    if let Some(limit) = &wind.in_time.acceleration_limit
        && limit.value > COMFORT_MOST_M_S2
    {
        let message = WrongLoads::ComfortUnlikely(limit.written.clone());
        reader.slip(&limit.path, message, WrongLoads::ComfortOfCodes);
    }
    if let Some(drift) = wind.in_time.drift_limit.filter(|drift| *drift > DRIFT_MOST) {
        let message = WrongLoads::DriftUnlikely(short(drift));
        reader.slip("wind.drift_limit", message, WrongLoads::DriftOfWind);
    }
}

fn forces(reader: &mut Reader, loads: &LoadsPart) {
    let each = loads.loads.iter().flat_map(|load| {
        let components = load.components.iter().flatten();
        load.force
            .iter()
            .chain(&load.force_across)
            .chain(&load.weight)
            .chain(components)
    });
    let (least, most) = FORCE_N;
    for of in each.filter(|of| of.value != 0.0 && !(least..=most).contains(&of.value.abs())) {
        let message = WrongLoads::IsNoLoad {
            path: of.path.clone(),
            written: of.written.clone(),
        };
        reader.slip(&of.path, message, WrongLoads::LoadsAre);
    }
}

fn combinations(reader: &mut Reader, loads: &LoadsPart) {
    let (least, most) = WEIGHT_FACTOR;
    for of in &loads.combinations {
        let Some(name) = of.name.as_ref().filter(|_| !(least..=most).contains(&of.weight)) else {
            continue;
        };
        let path = format!("combination.{name}.weight");
        let message = WrongLoads::WeightFactor {
            path: path.clone(),
            factor: of.weight.to_string(),
        };
        reader.slip(&path, message, WrongLoads::FactorsOfWeight);
    }
}
