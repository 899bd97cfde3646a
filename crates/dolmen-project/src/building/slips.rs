//! Probable slips in a building.

use super::part::{BuildingPart, FloorPart, StoreyStiffnessPart, WallPart};
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::{guess, mass_kg, rounded_length, unit_of, within};
use crate::wrong::{Common, WrongBuilding};

const FLOOR_MASS_KG: (f64, f64) = (1e3, 2e7);
const STOREY_HEIGHT_M: (f64, f64) = (0.1, 50.0);
/// Usual storey height, for comparison, m.
const STOREY_HEIGHT_USUAL_M: f64 = 3.5;
/// √(k/m)/2π of a storey with its own floor only, Hz. Our choice: the lowest storey of a 100-storey building that sways at 0.1 Hz has 6
/// Hz, low stone walls have 20.
const STOREY_FREQUENCY_HZ: (f64, f64) = (0.1, 40.0);

/// Longest side of a floor, m.
const FLOOR_SIDE_MOST_M: f64 = 300.0;
/// Largest distance of walls and of a centre of rigidity from the floor, as a share of its longer side.
const OFF_FLOOR_MOST: f64 = 0.25;

pub(crate) fn judge_building(reader: &mut Reader, building: &BuildingPart) {
    for floor in &building.floors {
        judge_plan(reader, floor);
        let height = &floor.height;
        if !within(height.value, STOREY_HEIGHT_M) {
            let (least, most) = STOREY_HEIGHT_M;
            let message = Common::StoreyHeight {
                path: height.path.to_string(),
                written: height.written.to_string(),
                least: least.to_string(),
                most: most.to_string(),
            };
            let help = guess(height.value / STOREY_HEIGHT_USUAL_M, unit_of(height));
            reader.slip(&height.path, message, help);
        }
        let mass = mass_kg(&floor.heaviness, building.gravity_m_s2);
        let given = floor.heaviness.quantity();
        if !within(mass, FLOOR_MASS_KG) {
            let message = WrongBuilding::ButFloorsHaveT {
                path: given.path.to_string(),
                written: given.written.to_string(),
            };
            let ratio = if mass > 1e5 { 1000.0 } else { 0.001 };
            reader.slip(&given.path, message, guess(ratio, unit_of(given)));
            continue; // stiffness is compared with masses
        }
        let each = match &floor.stiffness {
            StoreyStiffnessPart::Walls(walls) => {
                let sum = |of: fn(&WallPart) -> &Option<Quantity>| {
                    let values = walls.iter().filter_map(|wall| of(wall).as_ref());
                    values.map(|given| given.value).sum::<f64>()
                };
                let largest = walls
                    .iter()
                    .flat_map(|wall| [&wall.stiffness_x, &wall.stiffness_y])
                    .flatten()
                    .max_by(|a, b| a.value.total_cmp(&b.value));
                let whole = sum(|wall| &wall.stiffness_x).max(sum(|wall| &wall.stiffness_y));
                largest.map(|quantity| (quantity, whole))
            }
            StoreyStiffnessPart::Whole { x, .. } => Some((&**x, x.value)),
            StoreyStiffnessPart::Matrix { .. } => None,
        };
        if let Some((quantity, stiffness)) = each {
            let frequency_hz = (stiffness / mass).sqrt() / std::f64::consts::TAU;
            if !within(frequency_hz, STOREY_FREQUENCY_HZ) {
                let (least, most) = STOREY_FREQUENCY_HZ;
                let message = WrongBuilding::StoreyWithItsOwn {
                    path: quantity.path.to_string(),
                    written: quantity.written.to_string(),
                    frequency_hz: rounded_length(frequency_hz),
                    least: least.to_string(),
                    most: most.to_string(),
                };
                reader.slip(&quantity.path, message, Common::StiffnessUnit);
            }
        }
    }
}

/// Places in plan: walls and centres of rigidity far from the floor, floors of impossible size.
fn judge_plan(reader: &mut Reader, floor: &FloorPart) {
    let Some(outline) = &floor.outline else { return };
    let extent = |axis: usize| {
        let values = outline.corners_m().iter().map(|corner| corner[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), x| {
            (low.min(x), high.max(x))
        });
        high - low
    };
    let side_m = extent(0).max(extent(1));
    if side_m > FLOOR_SIDE_MOST_M {
        let path = floor.height.path.replace(".height", "");
        let message = WrongBuilding::IsMLongBut {
            path: path.to_string(),
            side_m: rounded_length(side_m),
            most: FLOOR_SIDE_MOST_M.to_string(),
        };
        reader.slip(&path, message, WrongBuilding::AreItsSidesIn);
        return;
    }
    let mut places = Vec::new();
    match &floor.stiffness {
        StoreyStiffnessPart::Walls(walls) => places.extend(walls.iter().map(|wall| [&wall.x, &wall.y])),
        StoreyStiffnessPart::Whole { centre, .. } => places.push([&centre[0], &centre[1]]),
        // about any point
        StoreyStiffnessPart::Matrix { .. } => {}
    }
    for [x, y] in places {
        let beyond_m = outline.beyond_m([x.value, y.value]);
        if beyond_m > OFF_FLOOR_MOST * side_m {
            let given = if x.value.abs() > y.value.abs() { x } else { y };
            let message = WrongBuilding::LiesMOffIts {
                path: given.path.to_string(),
                written: given.written.to_string(),
                beyond_m: rounded_length(beyond_m),
                side_m: rounded_length(side_m),
            };
            reader.slip(&given.path, message, WrongBuilding::IsItInM);
        }
    }
}
