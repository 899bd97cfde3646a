//! Positions of sensors in another unit of length than that of the file: all very near the origin, or far beyond the structure.

use super::content::Structure;
use super::measure::Measure;
use super::quantity::Quantity;
use super::reader::Reader;
use super::survey::Survey;
use super::written::short;
use super::wrong::WrongRecords;

/// Least distance of the farthest sensor over the height of the structure. Our choice: a slip between m and mm is a factor of 1000.
const NEAR: f64 = 0.01;
/// Largest distance of the nearest two sensors over that height. Our choice.
const FAR: f64 = 100.0;
/// Largest distance of a single place from the origin over that height: larger, because a height above the sea is no slip of unit.
const FAR_ALONE: f64 = 500.0;

pub(super) fn judge_sensors(reader: &mut Reader, structure: Option<&Structure>, surveys: &[Survey]) {
    let has_places = |survey: &Survey| {
        let sources = survey.records.iter().chain(&survey.setups);
        sources
            .flat_map(|source| &source.channels)
            .any(|channel| channel.position_m.is_some())
    };
    if !surveys.iter().any(has_places) {
        return;
    }
    let Some(height_m) = structure.and_then(height_m).filter(|height_m| *height_m > 0.0) else {
        return;
    };
    for survey in surveys {
        let sources = survey.records.iter().chain(&survey.setups);
        let places: Vec<[f64; 3]> = sources
            .flat_map(|source| &source.channels)
            .filter_map(|channel| channel.position_m)
            .collect();
        let key = if survey.records.is_some() {
            "records"
        } else {
            "setups"
        };
        let path = format!("survey.{}.{key}", survey.name);
        judge(reader, path, &places, height_m);
    }
}

fn judge(reader: &mut Reader, path: String, places: &[[f64; 3]], height_m: f64) {
    let apart =
        |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| (a - b).powi(2)).sum::<f64>().sqrt();
    let farthest = places
        .iter()
        .map(|place| apart(place, &[0.0; 3]))
        .fold(0.0, f64::max);
    let pairs = (0..places.len()).flat_map(|i| (0..i).map(move |j| (i, j)));
    let distances = pairs
        .map(|(i, j)| apart(&places[i], &places[j]))
        .filter(|distance| *distance > 0.0);
    let nearest = distances.min_by(f64::total_cmp);
    let is_far = match nearest {
        Some(distance) => distance > FAR * height_m,
        None => farthest > FAR_ALONE * height_m,
    };
    let is_near = farthest > 0.0 && farthest < NEAR * height_m;
    if !is_far && !is_near {
        return;
    }
    let (unit, factor) = reader.bare_unit(Measure::Length);
    let unit = unit.to_owned();
    let written = |value: f64| short((value * 1e6).round() / 1e6);
    let coordinates = places.iter().flatten().map(|of| of.abs());
    let in_unit = written(coordinates.fold(0.0, f64::max) / factor);
    let message = match is_far {
        true => WrongRecords::SensorsBeyond {
            path: path.clone(),
            away: format!("{} m", written(nearest.unwrap_or(farthest))),
            height: format!("{} m", written(height_m)),
        },
        false => WrongRecords::SensorsAtOrigin {
            path: path.clone(),
            away: format!("{} m", written(farthest)),
            height: format!("{} m", written(height_m)),
        },
    };
    let meant = if is_far { "mm" } else { "m" };
    let help = match unit == meant {
        true => WrongRecords::PositionsFromFoot(unit),
        false => WrongRecords::PositionsAreIn {
            meant: format!("\"{in_unit} {meant}\""),
            unit,
        },
    };
    reader.slip(&path, message, help);
}

/// Height of a structure with the file's own values, m.
fn height_m(structure: &Structure) -> Option<f64> {
    match structure {
        Structure::Chain(part) => Some(part.links.iter().map(|link| link.length.value).sum()),
        Structure::Frame(part) => Some(part.storeys.iter().map(|storey| storey.height.value).sum()),
        Structure::Building(part) => Some(part.floors.iter().map(|floor| floor.height.value).sum()),
        Structure::Stack(part) => part
            .build(&mut Quantity::nominal)
            .ok()
            .map(|stack| stack.height_m()),
        Structure::Survey => None,
    }
}
