//! Patterns over all floors of a building that look like a mistake.

use super::part::{BuildingPart, FloorPart, StoreyStiffnessPart};
use crate::doubted::Doubted;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::mass_kg;
use crate::usual_numbers::{hertz, metres, ratio, tonnes_per_m2};

/// Mass per area of a floor, kg/m²: from a timber pavilion with a tin roof to a stone floor on stone walls, each with a margin.
const PER_AREA_KG_M2: [f64; 2] = [150.0, 6000.0];
/// Stiffness of the top storey over the lowest, above which the list seems to begin with the top. Our choice.
const STIFFER_MOST: f64 = 1.3;
/// Lowest frequency × height, Hz m: slender towers have 8, low walls of stone 150.
const SWAYS_HZ_M: [f64; 2] = [4.0, 220.0];
/// Floors whose order is judged.
const FLOORS_LEAST: usize = 3;

pub(crate) fn doubt_building(reader: &mut Reader, part: &BuildingPart) {
    for floor in &part.floors {
        mass(reader, floor, part.gravity_m_s2);
    }
    order(reader, part);
    sways(reader, part);
}

/// Compares the lowest frequency with the height of the building.
fn sways(reader: &mut Reader, part: &BuildingPart) {
    let Ok(modes) = part
        .build(&mut Quantity::nominal)
        .and_then(|building| building.modes())
    else {
        return;
    };
    let height_m: f64 = part
        .floors
        .iter()
        .map(|floor| floor.height.value * floor.count as f64)
        .sum();
    if let Some(mode) = modes.modes.first()
        && !(SWAYS_HZ_M[0]..=SWAYS_HZ_M[1]).contains(&(mode.frequency_hz * height_m))
    {
        let (frequency, height) = (hertz(mode.frequency_hz), metres(height_m));
        reader.doubt("floors", Doubted::Sways { frequency, height });
    }
}

fn mass(reader: &mut Reader, floor: &FloorPart, gravity_m_s2: f64) {
    let Some(outline) = &floor.outline else { return };
    let per_area = mass_kg(&floor.heaviness, gravity_m_s2) / outline.area_m2();
    if !(PER_AREA_KG_M2[0]..=PER_AREA_KG_M2[1]).contains(&per_area) {
        let path = &floor.heaviness.quantity().path;
        let per_area = tonnes_per_m2(per_area);
        reader.doubt(
            path,
            Doubted::FloorMass {
                path: path.clone(),
                per_area,
            },
        );
    }
}

fn order(reader: &mut Reader, part: &BuildingPart) {
    let along_x = |floor: &FloorPart| match &floor.stiffness {
        StoreyStiffnessPart::Whole { x, .. } => Some(x.value),
        StoreyStiffnessPart::Walls(walls) => Some(
            walls
                .iter()
                .filter_map(|wall| Some(wall.stiffness_x.as_ref()?.value))
                .sum(),
        ),
        StoreyStiffnessPart::Matrix { .. } => None,
    };
    let Some(stiffness) = part.floors.iter().map(along_x).collect::<Option<Vec<f64>>>() else {
        return;
    };
    let grows = stiffness.windows(2).all(|pair| pair[1] >= pair[0]);
    if let (Some(first), Some(last)) = (stiffness.first(), stiffness.last())
        && stiffness.len() >= FLOORS_LEAST
        && grows
        && last / first > STIFFER_MOST
    {
        reader.doubt("floors", Doubted::FloorOrder(ratio(last / first)));
    }
}
