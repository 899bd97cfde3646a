//! Probable slips in wind and loads.

use super::part::{LoadsPart, WindPart, WindSpeed};
use crate::reader::Reader;
use crate::wrong::WrongLoads;

/// Speed of a gust or of the mean that codes take, m/s: a fresh breeze to the largest gusts measured.
const SPEED_M_S: (f64, f64) = (8.0, 95.0);
/// Peak velocity pressure, Pa: of such gusts.
const PRESSURE_PA: (f64, f64) = (40.0, 6000.0);
/// Force coefficient: a streamlined section to a lattice.
const COEFFICIENT: (f64, f64) = (0.2, 4.0);
/// Density of air, kg/m³: at 4000 m in summer, at the sea in deep frost.
const DENSITY_KG_M3: (f64, f64) = (0.7, 1.5);

pub(crate) fn judge_loads(reader: &mut Reader, loads: &LoadsPart) {
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
        let message = WrongLoads::WindDensityIsKg {
            density: wind.air_density_kg_m3.to_string(),
        };
        reader.slip("wind.density", message, WrongLoads::AirHasKgM3);
    }
}
