//! Buildings with torsion, for validation, examples and benchmarks.

use super::ValidationError;
use crate::dynamics::TunedMass;
use crate::known::hwang_min_hong as paper;
use crate::structure::Building;
use crate::structure::building::{Element, Floor, Outline, PDelta, PlanDirection, Storey, StoreyStiffness};

/// The example of Hwang, Min and Hong, reconstructed from its Table 1: one floor of 10 × 8 m on four walls.
///
/// # Errors
/// No error occurs, because the numbers are fixed.
pub fn twisting_floor(mass_kg: f64) -> Result<Building, ValidationError> {
    let [kx, ky] = paper::STIFFNESS.map(|k| k * mass_kg);
    let share = 0.5 * (1.0 - paper::RIGIDITY_X_M / 5.0);
    let wall = |x_m, y_m, stiffness_x_n_m, stiffness_y_n_m| Element {
        x_m,
        y_m,
        stiffness_x_n_m,
        stiffness_y_n_m,
        stiffness_rotation_n_m_rad: 0.0,
        angle_degrees: 0.0,
    };
    let walls = vec![
        wall(0.0, -4.0, 0.5 * kx, 0.0),
        wall(0.0, 4.0, 0.5 * kx, 0.0),
        wall(-5.0, 0.0, 0.0, ky * share),
        wall(5.0, 0.0, 0.0, ky * (1.0 - share)),
    ];
    let outline = Outline::rectangle([0.0, 0.0], paper::FLOOR_M[0], paper::FLOOR_M[1])?;
    let storey = Storey {
        height_m: 3.0,
        stiffness: StoreyStiffness::of_elements(walls)?,
    };
    Ok(Building::new(
        vec![Floor::uniform(mass_kg, outline)],
        vec![storey],
        PDelta::LeftOut,
    )?)
}

/// Twenty storeys of 24 × 16 m with walls left of the middle, whose stiffness at the top is half of that at the foot. Not
/// from a source.
///
/// # Errors
/// No error occurs, because the numbers are fixed.
pub fn twenty_storeys() -> Result<Building, ValidationError> {
    let (mut floors, mut storeys) = (Vec::new(), Vec::new());
    for i in 0..20 {
        let outline = Outline::rectangle([0.0, 0.0], 24.0, 16.0)?;
        floors.push(Floor::uniform(400e3, outline));
        let k = 1.2e9 * (1.0 - 0.5 * f64::from(i) / 19.0);
        storeys.push(Storey {
            height_m: 3.2,
            stiffness: StoreyStiffness::at_centre(k, 0.9 * k, 80.0 * k, [-1.8, 0.6]),
        });
    }
    Ok(Building::new(floors, storeys, PDelta::LeftOut)?)
}

/// A mass of 120 t on the top floor of [`twenty_storeys`], right of the middle, which moves along y.
pub fn twenty_storeys_mass() -> TunedMass {
    TunedMass {
        floor: 20,
        x_m: 9.0,
        y_m: 0.0,
        direction: PlanDirection::Y,
        mass_kg: 120e3,
        frequency_hz: 0.45,
        damping_ratio: 0.12,
    }
}
