//! Probable slips in wind and loads.

use super::part::{LoadsPart, WindPart, WindSpeed};
use crate::reader::Reader;

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
        WindSpeed::Pressure(_) => (PRESSURE_PA, "a gust of 30 m/s has 560 Pa; is it in Pa or kPa?"),
        _ => (
            SPEED_M_S,
            "speeds are in m/s: 100 km/h is 28 m/s, 50 knots are 26 m/s",
        ),
    };
    let outside = |value: f64, (least, most): (f64, f64)| !(least..=most).contains(&value);
    if outside(quantity.value, range) {
        let message = format!(
            "{} = {} is no storm that people design for",
            quantity.path, quantity.written
        );
        reader.slip(&quantity.path, message, help.to_owned());
    }
    let coefficients = wind
        .areas
        .iter()
        .filter_map(|area| area.force_coefficient.as_ref());
    for of in std::iter::once(&wind.force_coefficient).chain(coefficients) {
        if outside(of.value, COEFFICIENT) {
            let message = format!("{} = {} is outside what bodies have", of.path, of.written);
            reader.slip(
                &of.path,
                message,
                "a square prism has 2.0, an octagon 1.3 to 1.45, a circle 0.7 to 1.2".to_owned(),
            );
        }
    }
    if outside(wind.air_density_kg_m3, DENSITY_KG_M3) {
        let message = format!("wind.density is {} kg/m3", wind.air_density_kg_m3);
        reader.slip("wind.density", message, "air has 1.2 kg/m3".to_owned());
    }
}
