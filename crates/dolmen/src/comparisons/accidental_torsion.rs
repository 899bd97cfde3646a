//! Accidental torsion of EN 1998-1 and KDS 41 17 00 against two coupled modes by hand.

use super::{Case, ValidationError};
use crate::assess::demand::ACCIDENTAL_ECCENTRICITY;
use crate::damper::{DamperError, DisplacedBuilding, displaced_responses};
use crate::dynamics::VibratingBuilding;
use crate::known::STANDARD_GRAVITY_M_S2;
use crate::known::displaced_centre::DisplacedFloor;
use crate::structure::Building;
use crate::structure::building::{BuildingDamping, Floor, Outline, PDelta, Storey, StoreyStiffness};

const SOURCE: &str = "By hand: accidental torsion";
const NOTE: &str = "A floor of 60 t, 20 × 8 m, on a storey of 4.2 m (6 and 4 kN/mm, 90 MN m/rad, centred) under S_a = 0.2317 g/T, 5 % damping, P-delta. \
                    EN 1998-1:2004, 4.3.2: the centre of mass off by 5 % of the side across the shaking. Without it: 36.60 and 45.09 mm.";

/// Sides of the floor along x and y, m.
const SIDES_M: [f64; 2] = [20.0, 8.0];

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let floor = DisplacedFloor {
        mass_kg: 60e3,
        gyration_m: (SIDES_M[0].hypot(SIDES_M[1])) / 12.0_f64.sqrt(),
        stiffness: [6e6, 4e6, 90e6],
        weight_over_height_n_m: 60e3 * STANDARD_GRAVITY_M_S2 / 4.2,
        damping_ratio: 0.05,
        acceleration_times_period_m_s: 2.0 / 3.0 * 0.22 * 1.58 * STANDARD_GRAVITY_M_S2,
    };
    let by_m = SIDES_M.map(|side| ACCIDENTAL_ECCENTRICITY * side);
    let by_hand_m = floor.edge_drifts_m(by_m, SIDES_M.map(|side| 0.5 * side));
    let outline = Outline::rectangle([0.0, 0.0], SIDES_M[0], SIDES_M[1])?;
    let [x, y, rotation] = floor.stiffness;
    let storey = Storey {
        height_m: 4.2,
        stiffness: StoreyStiffness::at_centre(x, y, rotation, [0.0, 0.0]),
    };
    let p_delta = PDelta::Weights {
        gravity_m_s2: STANDARD_GRAVITY_M_S2,
    };
    let building = Building::new(
        vec![Floor::uniform(floor.mass_kg, outline)],
        vec![storey],
        p_delta,
    )?;
    let damping = BuildingDamping::Modal(vec![floor.damping_ratio]);
    let of = DisplacedBuilding {
        vibrating: &VibratingBuilding::new(building, &damping, Vec::new())?,
        damping: &damping,
        dampers: &[],
    };
    let spectrum =
        |period_s: f64, _| Ok::<_, DamperError>([floor.acceleration_times_period_m_s / period_s; 2]);
    let found = displaced_responses(&of, &[by_m], spectrum)?;
    let largest_m = found.iter().map(|case| case.edge_drift_m[0]);
    let largest_m = largest_m.fold([0.0_f64; 2], |[x, y], own| [x.max(own[0]), y.max(own[1])]);
    let row = |axis: usize| Case {
        source: SOURCE,
        what: format!("largest drift at an edge along {}", ["x", "y"][axis]),
        unit: "mm",
        published: (1e6 * by_hand_m[axis]).round() / 1e3,
        computed: 1e3 * largest_m[axis],
        tolerance: 0.000_5, // its digits
        corrected: None,
        note: NOTE,
    };
    Ok(vec![row(0), row(1)])
}
