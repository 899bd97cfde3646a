// SOURCE     numpy 2 `linalg.eig` of the first-order form of a floor with a tuned mass, written independently of Dolmen.
// GOAL       Frequencies and damping ratios of a building with its dampers, and those found by a survey.
// PARAMETERS 120 t, 12 × 7 m, k_x 60 MN/m, k_y 42 MN/m, k_θ 900 MN·m/rad, e 1.2 and −0.8 m, storey 4 m with P-delta, 3 % in every mode; a mass of
//            2040.4983910992244 kg at x = −4 m along y, 2.6174114727020172 Hz, Den Hartog's damping for 3 %.
// TOLERANCE  1e-8 for frequencies, 1e-7 for damping ratios: the stored digits.

use dolmen::damper::{AttachedDamper, DamperKind, damped_modes, lowest_seen};
use dolmen::dynamics::VibratingBuilding;
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingDamping, Floor, PDelta, PlanDirection, Storey, StoreyStiffness};

fn floor() -> VibratingBuilding {
    let floor = Floor {
        mass_kg: 120e3,
        centre_m: [0.0, 0.0],
        gyration_m: ((144.0 + 49.0) / 12.0_f64).sqrt(),
        outline: None,
    };
    let below = Storey {
        height_m: 4.0,
        stiffness: StoreyStiffness::at_centre(60e6, 42e6, 900e6, [1.2, -0.8]),
    };
    let p_delta = PDelta::Weights {
        gravity_m_s2: 9.80665,
    };
    let building = Building::new(vec![floor], vec![below], p_delta).unwrap();
    VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.03]), Vec::new()).unwrap()
}

#[test]
fn agrees_numpy_modes_of_a_floor_with_its_tuned_mass() {
    let alone = floor();
    let zeta = (3.0 * 0.03 / (8.0 * 1.03_f64)).sqrt();
    let mass = AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: 2_040.498_391_099_224_4,
            frequency_hz: 2.617_411_472_702_017_2,
            damping_ratio: zeta,
        },
        row: alone
            .building()
            .point_row(1, -4.0, 0.0, PlanDirection::Y)
            .unwrap(),
    };
    let modes = damped_modes(&alone, std::slice::from_ref(&mass)).unwrap();
    let numpy = [
        (2.455_904_240, 0.065_069_720),
        (2.869_225_481, 0.069_961_792),
        (3.353_015_170, 0.030_012_139),
        (3.998_476_414, 0.030_738_714),
    ];
    assert_eq!(modes.len(), 4);
    for (mode, (hz, ratio)) in modes.iter().zip(numpy) {
        assert!((mode.frequency_hz / hz - 1.0).abs() < 1e-8, "{mode:?} {hz}");
        assert!(
            (mode.damping_ratio / ratio - 1.0).abs() < 1e-7,
            "{mode:?} {ratio}"
        );
    }
    // the mode along y is split in two, of which the lower is identified; the others remain single
    for (own, hz) in [(0, numpy[0].0), (1, numpy[2].0), (2, numpy[3].0)] {
        let seen = lowest_seen(&modes, own).unwrap();
        assert!((seen.frequency_hz / hz - 1.0).abs() < 1e-8, "{own}: {seen:?}");
    }
}

#[test]
fn holds_without_dampers_each_mode_has_all_of_itself() {
    let alone = floor();
    let modes = damped_modes(&alone, &[]).unwrap();
    for (at, (mode, own)) in modes.iter().zip(&alone.modes().modes).enumerate() {
        assert!((mode.frequency_hz / own.frequency_hz - 1.0).abs() < 1e-10);
        for (other, share) in mode.share.iter().enumerate() {
            // over the damped frequency, 1/√(1 − ζ²)
            let whole = if other == at {
                1.0 / (1.0 - 0.03_f64 * 0.03).sqrt()
            } else {
                0.0
            };
            assert!((share - whole).abs() < 1e-8, "{at} {other}: {share}");
        }
        assert_eq!(lowest_seen(&modes, at), Some(mode));
    }
}
