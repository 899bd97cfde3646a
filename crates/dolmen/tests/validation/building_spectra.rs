// SOURCE     Chopra (2017) Dynamics of Structures, section 13.8.2.
// GOAL       Response spectra combine the modes and the directions of shaking as published.
// PARAMETERS Five storeys of 100 kip/g, 31.54 kip/in, 5 %, El Centro 1940 NS.
// PUBLISHED  base shear ABSSUM 98.32, SRSS 65.99, CQC 66.43, time history 73.15 kip; T = 1.99963 .68504 .43456 .33828 .29659 s.
// TOLERANCE  half a unit of the last printed digit; 0.03 % for the time history, because the source takes its peak from rounded
//            samples.

use super::building_history::{el_centro, stepped};
use dolmen::comparisons::{twenty_storeys, twenty_storeys_mass};
use dolmen::dynamics::{
    BuildingRun, DirectionalCombination, DynamicsError, ModalCombination, VibratingBuilding,
    building_history, correlation_coefficient, spectral_analysis,
};
use dolmen::signal::{Component, response_spectrum};
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingDamping, Floor, PDelta, PlanDirection, Storey, StoreyStiffness};

const KIP_IN: f64 = 386.4;

/// Chopra's shear building of five storeys, in kip, inch, s: it moves along x, and stiffly otherwise.
fn five_storeys() -> Building {
    let floor = Floor {
        mass_kg: 100.0 / KIP_IN,
        centre_m: [0.0, 0.0],
        gyration_m: 100.0,
        outline: None,
    };
    let storey = Storey {
        height_m: 144.0,
        stiffness: StoreyStiffness::at_centre(31.54, 3154.0, 31.54e6, [0.0, 0.0]),
    };
    Building::new(vec![floor; 5], vec![storey; 5], PDelta::LeftOut).unwrap()
}

#[test]
fn published_five_storeys_of_chopra() {
    let vibrating =
        VibratingBuilding::new(five_storeys(), &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let along_x: Vec<f64> = vibrating
        .modes()
        .modes
        .iter()
        .filter(|mode| mode.energy_shares[0] > 0.5)
        .map(|mode| mode.period_s())
        .collect();
    for (period, published) in along_x.iter().zip([1.99963, 0.68504, 0.43456, 0.33828, 0.29659]) {
        assert!((period - published).abs() < 0.6e-5, "{period}");
    }
    let motion = el_centro(&[(Component::X, KIP_IN)]);
    let read = |period_s: f64, zeta: f64| -> Result<[f64; 2], DynamicsError> {
        let ordinate = response_spectrum(&motion, Component::X, &[period_s], zeta).unwrap()[0];
        Ok([ordinate.pseudo_acceleration_m_s2(), 0.0])
    };
    let analysis = spectral_analysis(&vibrating, read).unwrap();
    let mut shear = vec![0.0; 15];
    shear[0] = 31.54;
    let of = |modal| analysis.largest(&shear, modal, DirectionalCombination::XAlone);
    for (modal, published) in [
        (ModalCombination::AbsoluteSum, 98.32),
        (ModalCombination::Srss, 65.99),
        (ModalCombination::Cqc, 66.43),
    ] {
        assert!((of(modal) - published).abs() < 0.02, "{modal:?} {}", of(modal));
    }
    let run = BuildingRun {
        steps_per_sample: 8,
        end_s: None,
        ..BuildingRun::default()
    };
    let history = building_history(&vibrating, &motion, &run).unwrap();
    let shear = history.peaks.base_shear_n[0].value.abs();
    assert!((shear - 73.15).abs() < 0.02, "{shear}");
}

#[test]
fn exact_correlation_of_modes() {
    let rho = correlation_coefficient([0.8, 0.02], [1.0, 0.05]);
    assert!((rho - 0.0839749).abs() < 0.5e-7, "{rho}");
    let other = correlation_coefficient([1.0, 0.05], [0.8, 0.02]);
    assert!((rho - other).abs() < 1e-16, "the same whichever comes first");
    let swapped = correlation_coefficient([0.8, 0.05], [1.0, 0.02]);
    assert!((swapped - 0.0763).abs() < 0.5e-4, "{swapped}");
    // white noise: ρ = ∫H_i H̄_n / √(∫|H_i|² ∫|H_n|²) of displacements
    let (wi, zi, wn, zn) = (0.8_f64, 0.02, 1.0_f64, 0.05);
    let steps = 4_000_000;
    let (mut cross, mut own_i, mut own_n) = (0.0, 0.0, 0.0);
    for k in 0..steps {
        let w = 10.0 * (f64::from(k) + 0.5) / f64::from(steps);
        let (ai, bi, an, bn) = (
            wi * wi - w * w,
            2.0 * zi * wi * w,
            wn * wn - w * w,
            2.0 * zn * wn * w,
        );
        let (di, dn) = (ai * ai + bi * bi, an * an + bn * bn);
        cross += (ai * an + bi * bn) / (di * dn);
        own_i += 1.0 / di;
        own_n += 1.0 / dn;
    }
    let white = cross / (own_i * own_n).sqrt();
    assert!((white - rho).abs() < 2e-5, "{white} {rho}");
}

#[test]
fn holds_combinations_of_directions_and_modes() {
    let building = twenty_storeys().unwrap();
    let vibrating =
        VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let flat = |_: f64, _: f64| -> Result<[f64; 2], Box<dyn std::error::Error>> { Ok([2.0, 1.0]) };
    let analysis = spectral_analysis(&vibrating, flat).unwrap();
    let row = vibrating
        .building()
        .point_row(20, 12.0, 8.0, PlanDirection::Y)
        .unwrap();
    let of = |directional| analysis.largest(&row, ModalCombination::Cqc, directional);
    let (x, y) = (
        of(DirectionalCombination::XAlone),
        of(DirectionalCombination::YAlone),
    );
    assert!(x > 0.0 && y > 0.0, "twist couples them");
    assert!((of(DirectionalCombination::Srss) - x.hypot(y)).abs() < 1e-15);
    assert!((of(DirectionalCombination::HundredThirty) - (x + 0.3 * y).max(y + 0.3 * x)).abs() < 1e-15);
    let masses = vec![twenty_storeys_mass()];
    let with_mass = VibratingBuilding::new(
        twenty_storeys().unwrap(),
        &BuildingDamping::Modal(vec![0.05]),
        masses,
    )
    .unwrap();
    let refused = spectral_analysis(&with_mass, |_, _| -> Result<[f64; 2], DynamicsError> {
        Ok([1.0, 1.0])
    });
    assert!(refused.unwrap_err().to_string().contains("use a time history"));
}

#[test]
fn exact_least_favourable_direction_of_shaking() {
    let vibrating =
        VibratingBuilding::new(stepped(), &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let analysis = spectral_analysis(&vibrating, |period_s, _| -> Result<[f64; 2], DynamicsError> {
        Ok([2.0 / (1.0 + period_s); 2])
    })
    .unwrap();
    let row = vibrating
        .building()
        .point_row(3, 4.0, -1.0, PlanDirection::Degrees(30.0))
        .unwrap();
    let cqc = |directional| analysis.largest(&row, ModalCombination::Cqc, directional);
    let both = analysis.least_favourable(&row, 1.0).unwrap();
    assert!((both.largest - cqc(DirectionalCombination::Srss)).abs() < 1e-14);
    // a single rotated component: every mode's response is that to the rotated shaking
    let (x, y) = (analysis.of_modes(&row, 0), analysis.of_modes(&row, 1));
    let modes = vibrating.modes().omegas_rad_s();
    let turned = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let r: Vec<f64> = x.iter().zip(&y).map(|(x, y)| cos * x + sin * y).collect();
        let mut sum = 0.0;
        for (i, a) in r.iter().enumerate() {
            for (n, b) in r.iter().enumerate() {
                sum += a * b * correlation_coefficient([modes[i], 0.05], [modes[n], 0.05]);
            }
        }
        sum.sqrt()
    };
    let one = analysis.least_favourable(&row, 0.0).unwrap();
    assert!(
        (turned(one.direction_degrees) - one.largest).abs() < 1e-13,
        "{one:?}"
    );
    for degrees in 0..180 {
        assert!(turned(f64::from(degrees)) <= one.largest + 1e-13);
    }
    let weaker = analysis.least_favourable(&row, 0.85).unwrap();
    assert!(one.largest < weaker.largest && weaker.largest < both.largest);
    assert!((weaker.direction_degrees - one.direction_degrees).abs() < 1e-9);
    let refused = analysis.least_favourable(&row, 1.5).unwrap_err().to_string();
    assert!(refused.starts_with("minor_ratio is 1.5"), "{refused}");
}

#[test]
fn agrees_one_floor_with_the_response_spectrum() {
    let floor = Floor {
        mass_kg: 3.0,
        centre_m: [1.0, 2.0],
        gyration_m: 2.0,
        outline: None,
    };
    let stiffness = StoreyStiffness::at_centre(30.0, 70.0, 1e3, [1.0, 2.0]);
    let building = Building::new(
        vec![floor],
        vec![Storey {
            height_m: 3.0,
            stiffness,
        }],
        PDelta::LeftOut,
    )
    .unwrap();
    let vibrating =
        VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.04]), Vec::new()).unwrap();
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, 5.0)]);
    let history = building_history(&vibrating, &motion, &BuildingRun::default()).unwrap();
    let peak = history.peaks.floors[0];
    for (component, k, found) in [
        (Component::X, 30.0_f64, peak.displacement_x_m),
        (Component::Y, 70.0, peak.displacement_y_m),
    ] {
        let period_s = std::f64::consts::TAU / (k / 3.0).sqrt();
        let known = response_spectrum(&motion, component, &[period_s], 0.04).unwrap()[0];
        // between the steps, as in the response spectrum
        assert!((found.value.abs() / known.displacement_m - 1.0).abs() < 1e-9);
        assert!(found.value.abs() > known.displacement_at_samples_m);
        let shear = history.peaks.base_shear_n[usize::from(component == Component::Y)]
            .value
            .abs();
        assert!((shear / (k * known.displacement_m) - 1.0).abs() < 1e-9);
    }
    assert!(peak.rotation_rad.value.abs() < 1e-16);
}
