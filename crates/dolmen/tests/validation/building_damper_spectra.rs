// SOURCE     closed forms of random vibration; CQC of well-separated modes; time histories under noise.
// GOAL       A building with dampers of all kinds in a response spectrum.
// PARAMETERS three storeys with setbacks, a mass, a liquid column, a column on a spring and a link; S_a of white noise.
// TOLERANCE  1e-8 for white noise and CQC; for histories the measured value: the mean of eight within 12 %.

use super::building_history::stepped;
use dolmen::damper::{
    AttachedDamper, DampedSystem, DamperError, DamperKind, damped_building_history, damped_spectral_analysis,
};
use dolmen::dynamics::{
    BuildingRun, DirectionalCombination, Histories, LinearSystem, ModalCombination, RandomInput, RandomLoad,
    ResponseRow, Spectrum, VibratingBuilding, rms_by_lyapunov, spectral_analysis,
};
use dolmen::signal::{Component, Noise, noise_motion, response_spectrum};
use dolmen::structure::building::{BuildingDamping, PlanDirection};
use std::f64::consts::{PI, TAU};

const X_ALONE: DirectionalCombination = DirectionalCombination::XAlone;

fn alone(ratio: f64) -> VibratingBuilding {
    VibratingBuilding::new(stepped(), &BuildingDamping::Modal(vec![ratio]), Vec::new()).unwrap()
}

/// One damper of each kind.
fn dampers(building: &VibratingBuilding, link_n_s_m: f64) -> Vec<AttachedDamper> {
    let at = |floor, x, y, degrees| {
        let direction = PlanDirection::Degrees(degrees);
        building.building().point_row(floor, x, y, direction).unwrap()
    };
    let hz = building.modes().modes[0].frequency_hz;
    let kinds = [
        DamperKind::TunedMass {
            mass_kg: 4e3,
            frequency_hz: 0.97 * hz,
            damping_ratio: 0.12,
        },
        DamperKind::LiquidColumn {
            liquid_mass_kg: 3e3,
            length_ratio: 0.7,
            frequency_hz: 1.1 * hz,
            damping_ratio: 0.1,
        },
        DamperKind::LiquidColumnMass {
            container_mass_kg: 1e3,
            liquid_mass_kg: 1.5e3,
            length_ratio: 0.6,
            frequency_hz: 0.9 * hz,
            damping_ratio: 0.12,
            liquid_frequency_hz: 1.15 * hz,
            liquid_damping_ratio: 0.08,
        },
    ];
    let rows = [
        at(3, 2.0, 0.0, 20.0),
        at(3, -1.0, 0.5, 37.0),
        at(2, 1.0, 2.0, 90.0),
    ];
    let each = kinds.into_iter().zip(rows);
    let mut all: Vec<AttachedDamper> = each.map(|(kind, row)| AttachedDamper { kind, row }).collect();
    let [upper, lower] = [at(2, 1.0, 1.0, 10.0), at(1, 1.0, 1.0, 10.0)];
    all.push(AttachedDamper::link(link_n_s_m, &upper, &lower));
    all
}

#[test]
fn exact_white_noise_leaves_the_standard_deviations_of_lyapunov() {
    let building = alone(0.03);
    let dampers = dampers(&building, 3e5);
    const DENSITY: f64 = 0.02;
    // an oscillator under white noise: σ² = π S/(2 ζ ω³)
    let white = |period_s: f64, zeta: f64| -> Result<[f64; 2], DamperError> {
        let omega = TAU / period_s;
        let sigma = (PI * DENSITY / (2.0 * zeta * omega.powi(3))).sqrt();
        Ok([sigma * omega * omega; 2])
    };
    let analysis = damped_spectral_analysis(&building, &dampers, white).unwrap();
    let of = building.building();
    let structure = LinearSystem::new(
        of.mass_matrix(),
        of.damping_matrix(&BuildingDamping::Modal(vec![0.03])).unwrap(),
        of.stiffness_matrix(),
    )
    .unwrap();
    let damped = DampedSystem::new(&structure, &dampers).unwrap();
    for (direction, combination) in [
        (PlanDirection::X, X_ALONE),
        (PlanDirection::Y, DirectionalCombination::YAlone),
    ] {
        let load = damped.load(&RandomLoad {
            input: RandomInput::Base(of.ground_column(direction)),
            spectrum: Spectrum::White { density: DENSITY },
        });
        let rms = |row: Vec<f64>| {
            let response = [ResponseRow::displacement(row)];
            rms_by_lyapunov(&damped.system, std::slice::from_ref(&load), &response).unwrap()[0]
        };
        let places = [(3, 5.0, 3.0, 0.0), (1, -4.0, 2.0, 90.0), (2, 0.5, 0.5, 37.0)];
        for (floor, x, y, degrees) in places {
            let row = of
                .point_row(floor, x, y, PlanDirection::Degrees(degrees))
                .unwrap();
            let (found, expected) = (analysis.largest(&row, combination), rms(damped.row(&row)));
            assert!(
                (found / expected - 1.0).abs() < 1e-8,
                "floor {floor}: {found} {expected}"
            );
        }
        let own = (0..4).map(|damper| damped.stroke_row(damper).unwrap());
        // the third damper is a column on a spring
        let rows = own.chain(damped.liquid_row(2));
        for (damper, row) in rows.enumerate() {
            let found = analysis.largest_strokes_m(combination)[damper];
            let expected = rms(row);
            assert!(
                (found / expected - 1.0).abs() < 1e-8,
                "damper {damper}: {found} {expected}"
            );
        }
    }
    assert_eq!(analysis.largest_strokes_m(X_ALONE).len(), 5);
    assert_eq!(analysis.modes.len(), 9 + 4);
}

#[test]
fn exact_without_dampers_it_is_the_cqc_of_modes_that_stay_apart() {
    let building = alone(0.04);
    let read = |period_s: f64, zeta: f64| [2.0 / period_s * (0.05 / zeta).sqrt(), 3.0];
    let damped = damped_spectral_analysis(&building, &[], |t, z| Ok::<_, DamperError>(read(t, z))).unwrap();
    let plain = spectral_analysis(&building, |t, z| {
        Ok::<_, dolmen::dynamics::DynamicsError>(read(t, z))
    })
    .unwrap();
    for row in building.building().base_rows() {
        for combination in [
            X_ALONE,
            DirectionalCombination::YAlone,
            DirectionalCombination::Srss,
            DirectionalCombination::HundredThirty,
        ] {
            let expected = plain.largest(&row, ModalCombination::Cqc, combination);
            let found = damped.largest(&row, combination);
            assert!(
                (found / expected - 1.0).abs() < 1e-8,
                "{combination:?} {found} {expected}"
            );
        }
    }
}

#[test]
fn holds_beside_histories_under_motions_of_noise() {
    const MOTIONS: u64 = 8;
    let building = alone(0.02);
    let dampers = dampers(&building, 1e5);
    let row = building
        .building()
        .point_row(3, 5.0, 3.0, PlanDirection::X)
        .unwrap();
    let mut mean = [0.0_f64; 3]; // of found over computed: the point, the stroke of the mass, the elongation of the link
    for seed in 1..=MOTIONS {
        let motion = noise_motion(&Noise::default(), seed).unwrap();
        let read = |period_s: f64, zeta: f64| -> Result<[f64; 2], DamperError> {
            let found = response_spectrum(&motion, Component::X, &[period_s], zeta).unwrap();
            Ok([found[0].pseudo_acceleration_m_s2(), 0.0])
        };
        let analysis = damped_spectral_analysis(&building, &dampers, read).unwrap();
        let run = BuildingRun {
            watched: vec![row.clone()],
            histories: Histories::PeaksAlone,
            ..BuildingRun::default()
        };
        let history = damped_building_history(&building, &dampers, &motion, &run).unwrap();
        let strokes = &history.peaks.strokes_m;
        let pairs = [
            (
                analysis.largest(&row, X_ALONE),
                history.watched[0].displacement_peak_m.value,
            ),
            (analysis.largest_strokes_m(X_ALONE)[0], strokes[0].value),
            (analysis.largest_strokes_m(X_ALONE)[3], strokes[3].value),
        ];
        for (mean, (found, computed)) in mean.iter_mut().zip(pairs) {
            *mean += found / computed.abs() / MOTIONS as f64;
        }
    }
    for ratio in mean {
        assert!((ratio - 1.0).abs() < 0.12, "{mean:?}");
    }
}

#[test]
fn refuses_what_does_not_swing_and_says_what_to_do() {
    let building = alone(0.02);
    let read = |_: f64, _: f64| Ok::<_, DamperError>([1.0; 2]);
    let refused = damped_spectral_analysis(&building, &dampers(&building, 3e9), read).unwrap_err();
    let words = refused.to_string();
    assert!(
        words.contains("modes that swing") && words.contains("use a time history"),
        "{words}"
    );
    let negative = |_: f64, _: f64| Ok::<_, DamperError>([-1.0; 2]);
    let refused = damped_spectral_analysis(&building, &[], negative).unwrap_err();
    assert!(refused.to_string().contains("spectral acceleration is -1"));
}
