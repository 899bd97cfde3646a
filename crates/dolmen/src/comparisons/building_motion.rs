//! Buildings and dampers in time: comparisons with closed forms and between two methods.

use super::{Case, ValidationError, twisting_floor};
use crate::damper::{
    AttachedDamper, DampedSystem, DamperKind, damped_building_history, damped_spectral_analysis,
};
use crate::dynamics::{
    BuildingHistory, BuildingRun, DirectionalCombination, LinearSystem, RandomInput, RandomLoad, ResponseRow,
    Spectrum, TunedMass, VibratingBuilding, building_history, rms_by_lyapunov,
};
use crate::signal::{Component, GroundMotion};
use crate::structure::Building;
use crate::structure::building::{
    BuildingDamping, Floor, Outline, PDelta, PlanDirection, Storey, StoreyStiffness,
};
use std::f64::consts::{PI, TAU};

const BETWEEN: &str = "A step of the ground under one mode, ω = 10 rad/s, ζ = .1, in steps of .05 s: the overshoot 1 + e^(−πζ/√(1−ζ²)) lies between them.";
const FREE: &str = "0.31 s of 3 m/s² under a floor of 3.27 s: the peak comes after the motion. By the matrix exponential of another program at steps of \
                    .01 s; between the steps up to π²/(2·327²) more.";
const SPECTRUM: &str = "A floor with a mass and a liquid column in the spectrum of white noise, complex modes put together by CQC: its standard deviation over that of \
                        Lyapunov's equation.";
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
    for (what, [by_lyapunov, by_modes]) in ["point of the floor", "stroke of the mass", "rise of the liquid"]
        .into_iter()
        .zip(white_noise()?)
    {
        case(
            "Two methods: dampers in a spectrum",
            what,
            "",
            [1.0, by_modes / by_lyapunov, 1e-8],
            SPECTRUM,
        );
    }
    Ok(cases)
}

/// Standard deviations under white noise along y, by Lyapunov's equation and by superposition of complex modes.
fn white_noise() -> Result<[[f64; 2]; 3], ValidationError> {
    let damping = BuildingDamping::Modal(vec![0.02]);
    let alone = VibratingBuilding::new(twisting_floor(1e5)?, &damping, Vec::new())?;
    let building = alone.building();
    let at = |x: f64| building.point_row(1, x, 1.0, PlanDirection::Y);
    let dampers = [
        AttachedDamper {
            kind: DamperKind::TunedMass {
                mass_kg: 5e3,
                frequency_hz: 0.28,
                damping_ratio: 0.13,
            },
            row: at(4.0)?,
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumn {
                liquid_mass_kg: 2e3,
                length_ratio: 0.6,
                frequency_hz: 0.55,
                damping_ratio: 0.08,
            },
            row: at(-4.0)?,
        },
    ];
    // an oscillator under white noise of density 1: σ² = π/(2 ζ ω³)
    let read = |period_s: f64, zeta: f64| -> Result<[f64; 2], ValidationError> {
        let omega = TAU / period_s;
        Ok([0.0, omega * omega * (PI / (2.0 * zeta * omega.powi(3))).sqrt()])
    };
    let analysis = damped_spectral_analysis(&alone, &dampers, read)?;
    let structure = LinearSystem::new(
        building.mass_matrix(),
        building.damping_matrix(&damping)?,
        building.stiffness_matrix(),
    )?;
    let damped = DampedSystem::new(&structure, &dampers)?;
    let load = damped.load(&RandomLoad {
        input: RandomInput::Base(building.ground_column(PlanDirection::Y)),
        spectrum: Spectrum::White { density: 1.0 },
    });
    let point = at(5.0)?;
    let along = DirectionalCombination::YAlone;
    let strokes = analysis.largest_strokes_m(along);
    let stroke = |damper: usize| strokes.get(damper).copied().unwrap_or(f64::NAN);
    let found = [analysis.largest(&point, along), stroke(0), stroke(1)];
    let strokes = [0, 1].map(|damper| damped.stroke_row(damper).unwrap_or_default());
    let [first, second] = strokes;
    let rows = [damped.row(&point), first, second].map(ResponseRow::displacement);
    let expected = rms_by_lyapunov(&damped.system, &[load], &rows)?;
    Ok([0, 1, 2].map(|i| [expected[i], found[i]]))
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
