//! Buildings and dampers in time: closed forms, and one method beside another.

use super::{Case, ValidationError, twisting_floor};
use crate::damper::{AttachedDamper, DamperKind, damped_building_history};
use crate::dynamics::{BuildingHistory, BuildingRun, TunedMass, VibratingBuilding, building_history};
use crate::signal::{Component, GroundMotion};
use crate::structure::Building;
use crate::structure::building::{
    BuildingDamping, Floor, Outline, PDelta, PlanDirection, Storey, StoreyStiffness,
};

const BETWEEN: &str = "A step of the ground under one mode, ω = 10 rad/s, ζ = .1, in steps of .05 s: the overshoot 1 + e^(−πζ/√(1−ζ²)) lies between them.";
const FREE: &str = "0.31 s of 3 m/s² under a floor of 3.27 s: the peak comes after the motion. By the matrix exponential of another program at steps of \
                    .01 s; between the steps up to π²/(2·327²) more.";
const COLUMN: &str = "A liquid column of α = 1 by the matrix exponential of everything, beside the same tuned mass mode by mode: largest motion of the floor.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let mut case = |source, what: &str, unit, [published, computed, tolerance]: [f64; 3], note| {
        cases.push(Case {
            source,
            what: what.to_owned(),
            unit,
            published,
            computed,
            tolerance,
            corrected: None,
            note,
        });
    };
    let overshoot = {
        let zeta = 0.1_f64;
        1.0 + (-std::f64::consts::PI * zeta / (1.0 - zeta * zeta).sqrt()).exp()
    };
    let stepped = step_of_the_ground()?;
    let peak = stepped.peaks.floors[0].displacement_x_m.value.abs();
    case(
        "Closed form: step of the ground",
        "largest displacement over the static one, between the steps",
        "",
        [overshoot, 100.0 * peak, 1e-6],
        BETWEEN,
    );
    let freed = pulse()?;
    let floor = freed.peaks.floors[0];
    for (what, unit, published, computed, tolerance) in [
        (
            "displacement y after a pulse",
            "mm",
            413.268,
            1e3 * floor.displacement_y_m.value.abs(),
            0.02,
        ),
        (
            "rotation after a pulse",
            "mrad",
            36.854,
            1e3 * floor.rotation_rad.value.abs(),
            0.002,
        ),
        (
            "shear of the walls after a pulse",
            "kN",
            160.04,
            1e-3 * freed.peaks.base_shear_n[1].value.abs(),
            0.01,
        ),
    ] {
        let source = "Computed apart: a short pulse under a slow floor";
        case(source, what, unit, [published, computed, tolerance], FREE);
    }
    let [column, mass] = column_and_mass()?.map(|history| history.peaks.floors[0].displacement_y_m.value);
    case(
        "Two methods: dampers in time",
        "displacement with a liquid column of α = 1 over that with a tuned mass",
        "",
        [1.0, column / mass, 1e-9],
        COLUMN,
    );
    Ok(cases)
}

fn one_floor(stiffness: StoreyStiffness, mass_kg: f64, height_m: f64) -> Result<Building, ValidationError> {
    let floor = Floor::uniform(mass_kg, Outline::rectangle([0.0, 0.0], 10.0, 8.0)?);
    let storey = Storey { height_m, stiffness };
    Ok(Building::new(vec![floor], vec![storey], PDelta::LeftOut)?)
}

fn step_of_the_ground() -> Result<BuildingHistory, ValidationError> {
    let building = one_floor(
        StoreyStiffness::at_centre(100.0, 900.0, 3e4, [0.0, 0.0]),
        1.0,
        3.0,
    )?;
    let vibrating = VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.1]), Vec::new())?;
    let step = GroundMotion::new("step", 0.05, vec![(Component::X, vec![1.0; 60])])?;
    let run = BuildingRun {
        end_s: Some(2.0),
        ..BuildingRun::default()
    };
    Ok(building_history(&vibrating, &step, &run)?)
}

fn pulse() -> Result<BuildingHistory, ValidationError> {
    let building = one_floor(StoreyStiffness::at_centre(4e5, 4e5, 1e7, [-1.0, 0.0]), 1e5, 30.0)?;
    let vibrating = VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.05]), Vec::new())?;
    let mut samples = vec![3.0; 32];
    (samples[0], samples[31]) = (0.0, 0.0);
    let pulse = GroundMotion::new("pulse", 0.01, vec![(Component::Y, samples)])?;
    Ok(building_history(&vibrating, &pulse, &BuildingRun::default())?)
}

fn column_and_mass() -> Result<[BuildingHistory; 2], ValidationError> {
    let tuned = TunedMass {
        floor: 1,
        x_m: 4.0,
        y_m: 1.0,
        direction: PlanDirection::Y,
        mass_kg: 5e3,
        frequency_hz: 0.28,
        damping_ratio: 0.13,
    };
    let alone = VibratingBuilding::new(
        twisting_floor(1e5)?,
        &BuildingDamping::Modal(vec![0.02]),
        Vec::new(),
    )?;
    let column = AttachedDamper {
        kind: DamperKind::LiquidColumn {
            liquid_mass_kg: tuned.mass_kg,
            length_ratio: 1.0,
            frequency_hz: tuned.frequency_hz,
            damping_ratio: tuned.damping_ratio,
        },
        row: alone
            .building()
            .point_row(1, tuned.x_m, tuned.y_m, tuned.direction)?,
    };
    // a swept sine through mode 1
    let samples = (0..1000).map(|i| {
        let t = 0.02 * f64::from(i);
        (std::f64::consts::TAU * (0.15 + 0.01 * t) * t).sin()
    });
    let motion = GroundMotion::new("sweep", 0.02, vec![(Component::Y, samples.collect())])?;
    let run = BuildingRun::default();
    let by_exponential = damped_building_history(&alone, &[column], &motion, &run)?;
    let by_modes = building_history(&alone.with_tuned_masses(vec![tuned])?, &motion, &run)?;
    Ok([by_exponential, by_modes])
}
