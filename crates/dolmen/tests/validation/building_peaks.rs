// SOURCE     The same simulation twice: with and without histories; tuned masses as part of the modes, and as dampers on the
//            building.
// GOAL       Peaks do not depend on which histories are stored, and the rate of a stroke is that of its history.
// TOLERANCE  peaks: exact; rates 1e-9 between methods, 1e-4 against differences at 1 ms.

use super::building_history::{el_centro, mass, stepped};
use dolmen::damper::{AttachedDamper, DamperKind, damped_building_history};
use dolmen::dynamics::{BuildingRun, Histories, VibratingBuilding, building_history};
use dolmen::signal::Component;
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingDamping, Floor, Outline, PDelta, PlanDirection, Storey, StoreyStiffness,
};

#[test]
fn holds_peaks_alone_are_those_of_a_run_that_keeps_everything() {
    let damping = BuildingDamping::Modal(vec![0.02]);
    let building = stepped();
    let hz = building.modes().unwrap().modes[0].frequency_hz;
    let row = building
        .point_row(3, 1.0, 1.0, PlanDirection::Degrees(30.0))
        .unwrap();
    let vibrating = VibratingBuilding::new(building, &damping, vec![mass(3, 2.0, 30.0, hz, 0.1)]).unwrap();
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, -5.0)]);
    let run = |histories| BuildingRun {
        steps_per_sample: 2,
        end_s: Some(33.33), // no whole number of blocks
        watched: vec![row.clone()],
        histories,
    };
    let kept = building_history(&vibrating, &motion, &run(Histories::Kept)).unwrap();
    let alone = building_history(&vibrating, &motion, &run(Histories::PeaksAlone)).unwrap();
    assert_eq!(kept.peaks, alone.peaks);
    assert_eq!((kept.length(), kept.coordinates.columns()), (3334, 3334));
    assert_eq!((alone.length(), alone.coordinates.columns()), (3334, 0));
    assert_eq!(
        kept.watched[0].displacement_peak_m,
        alone.watched[0].displacement_peak_m
    );
    assert!(alone.watched[0].displacement_m.is_empty() && kept.watched[0].displacement_m.len() == 3334);
    // stored results are those of the observed steps: no step exceeds a peak, and some step is near it
    let same = |steps: &[f64], peak: dolmen::dynamics::Peak| {
        let most = steps.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let peak = peak.value.abs();
        assert!(
            most <= peak * (1.0 + 1e-12) && most > 0.97 * peak,
            "{most} {peak}"
        );
    };
    let of_row = |i: usize| -> Vec<f64> { (0..kept.length()).map(|k| kept.coordinates[(i, k)]).collect() };
    same(&of_row(6), kept.peaks.floors[2].displacement_x_m);
    same(&of_row(9), kept.peaks.strokes_m[0]);
    same(
        &kept.watched[0].displacement_m,
        kept.watched[0].displacement_peak_m,
    );
}

#[test]
fn agrees_the_rate_of_a_stroke_by_differences_and_by_both_methods() {
    let damping = BuildingDamping::Modal(vec![0.02]);
    let building = stepped();
    let hz = building.modes().unwrap().modes[0].frequency_hz;
    let tuned = mass(3, 2.0, 30.0, hz, 0.1);
    let row = building
        .point_row(tuned.floor, tuned.x_m, tuned.y_m, tuned.direction)
        .unwrap();
    let attached = AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: tuned.mass_kg,
            frequency_hz: tuned.frequency_hz,
            damping_ratio: tuned.damping_ratio,
        },
        row,
    };
    let alone = VibratingBuilding::new(building, &damping, Vec::new()).unwrap();
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, -5.0)]);
    let run = BuildingRun {
        steps_per_sample: 20, // 1 ms
        end_s: Some(20.0),
        ..BuildingRun::default()
    };
    let whole = damped_building_history(&alone, &[attached], &motion, &run).unwrap();
    let modes = building_history(&alone.with_tuned_masses(vec![tuned]).unwrap(), &motion, &run).unwrap();
    let rate = modes.peaks.stroke_rates_m_s[0];
    let other = whole.peaks.stroke_rates_m_s[0];
    assert!((rate.value / other.value - 1.0).abs() < 1e-9 && (rate.at_s - other.at_s).abs() < 1e-6);
    let strokes: Vec<f64> = (0..modes.length()).map(|k| modes.coordinates[(9, k)]).collect();
    let differences = strokes.windows(3).map(|three| (three[2] - three[0]) / 2e-3);
    let most = differences.fold(0.0_f64, |most, rate| most.max(rate.abs()));
    assert!((most / rate.value.abs() - 1.0).abs() < 1e-4, "{most} {rate:?}");
}

/// Two floors that are asymmetric about the origin, the upper one shifted.
fn lopsided() -> Building {
    let floor = |centre_m, middle_m, sides: [f64; 2]| Floor {
        mass_kg: 1e5,
        centre_m,
        gyration_m: 4.0,
        outline: Some(Outline::rectangle(middle_m, sides[0], sides[1]).unwrap()),
    };
    let storey = || Storey {
        height_m: 3.0,
        stiffness: StoreyStiffness::at_centre(3e7, 2e7, 4e8, [-1.5, 1.0]),
    };
    let floors = vec![
        floor([0.0, 0.0], [3.0, -2.0], [12.0, 10.0]),
        floor([1.0, 0.5], [-1.0, 2.5], [8.0, 9.0]),
    ];
    Building::new(floors, vec![storey(), storey()], PDelta::LeftOut).unwrap()
}

/// Largest drifts of a storey along x and y over its corners, each a row.
fn corner_drifts(building: &Building, storey: usize, middle: [f64; 2], half: [f64; 2]) -> [Vec<Vec<f64>>; 2] {
    [PlanDirection::X, PlanDirection::Y].map(|direction| {
        let corners = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)];
        let each = corners.map(|(i, j)| {
            let (x, y) = (middle[0] + i * half[0], middle[1] + j * half[1]);
            let mut row = building.point_row(storey, x, y, direction).unwrap();
            if storey == 2 {
                // of the floor below, as a plate with the same extent
                let centre = building.floors()[0].centre_m;
                match direction {
                    PlanDirection::X => (row[0], row[2]) = (-1.0, y - centre[1]),
                    _ => (row[1], row[2]) = (-1.0, -(x - centre[0])),
                }
            }
            row
        });
        each.to_vec()
    })
}

#[test]
fn holds_drifts_of_lopsided_edges_are_those_of_the_corners() {
    let building = lopsided();
    let vibrating =
        VibratingBuilding::new(building.clone(), &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let places = [([3.0, -2.0], [6.0, 5.0]), ([-1.0, 2.5], [4.0, 4.5])];
    for motion in [[9.8, 0.0], [0.0, 9.8], [9.8, -5.0]] {
        let motion = el_centro(&[(Component::X, motion[0]), (Component::Y, motion[1])]);
        for (storey, (middle, half)) in (1..).zip(places) {
            let corners = corner_drifts(&building, storey, middle, half);
            let run = BuildingRun {
                watched: corners.concat(),
                ..BuildingRun::default()
            };
            let history = building_history(&vibrating, &motion, &run).unwrap();
            let most = |from: usize| {
                let own = &history.watched[from..from + 4];
                let sizes = own.iter().map(|one| one.displacement_peak_m.value.abs());
                sizes.fold(0.0, f64::max)
            };
            let peak = &history.peaks.storeys[storey - 1];
            let [x, y] = [peak.edge_drift_x_m, peak.edge_drift_y_m].map(|one| one.unwrap().value.abs());
            let (x_there, y_there) = (most(0), most(4));
            assert!(
                (x / x_there - 1.0).abs() < 1e-12 && (y / y_there - 1.0).abs() < 1e-12,
                "storey {storey}: {x} {x_there}, {y} {y_there}"
            );
            // and the rows used in response spectra: front, back, left, right
            let edges = building.edge_drift_rows(storey).unwrap().unwrap();
            let [along_x, along_y] = &corners;
            let pairs = [
                (&edges[0], &along_x[0]),
                (&edges[1], &along_x[2]),
                (&edges[2], &along_y[0]),
                (&edges[3], &along_y[1]),
            ];
            for (edge, corner) in pairs {
                let apart = edge.iter().zip(corner).map(|(a, b)| (a - b).abs());
                assert!(apart.fold(0.0, f64::max) < 1e-12, "{edge:?} {corner:?}");
            }
        }
    }
}

#[test]
fn agrees_the_resultant_drift_is_the_longest_of_the_corners_at_any_instant() {
    let building = lopsided();
    let vibrating =
        VibratingBuilding::new(building.clone(), &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, -5.0)]);
    let places = [([3.0, -2.0], [6.0, 5.0]), ([-1.0, 2.5], [4.0, 4.5])];
    for (storey, (middle, half)) in (1..).zip(places) {
        let run = |steps_per_sample| BuildingRun {
            steps_per_sample,
            end_s: Some(12.0),
            watched: corner_drifts(&building, storey, middle, half).concat(),
            histories: Histories::Kept,
        };
        let coarse = building_history(&vibrating, &motion, &run(1)).unwrap();
        let fine = building_history(&vibrating, &motion, &run(40)).unwrap();
        let (mut most, mut at, mut toward) = (0.0, (0, 0), 0.0);
        for corner in 0..4 {
            let [x, y] = [corner, corner + 4].map(|row| &fine.watched[row].displacement_m);
            for (step, (x, y)) in x.iter().zip(y).enumerate() {
                if x.hypot(*y) > most {
                    (most, at, toward) = (x.hypot(*y), (corner, step), y.atan2(*x).to_degrees());
                }
            }
        }
        let [coarse, fine] = [&coarse, &fine].map(|history| history.peaks.storeys[storey - 1].resultant);
        let above = fine.size_m / most - 1.0;
        assert!((-1e-12..1e-5).contains(&above), "{} {most}", fine.size_m);
        assert!(
            (coarse.size_m / fine.size_m - 1.0).abs() < 1e-5,
            "{coarse:?} {fine:?}"
        );
        assert!((coarse.at_s - fine.at_s).abs() < 1e-3 && (fine.at_s - 5e-4 * at.1 as f64).abs() < 5e-4);
        assert!((fine.direction_degrees - toward).abs() < 0.5, "{fine:?} {toward}");
        let (i, j) = [(-1.0, -1.0), (1.0, -1.0), (1.0, 1.0), (-1.0, 1.0)][at.0];
        assert_eq!(fine.place_m, [middle[0] + i * half[0], middle[1] + j * half[1]]);
    }
}

#[test]
fn exact_the_resultant_drift_of_a_round_building_does_not_ask_whence_it_is_shaken() {
    let floor = Floor {
        mass_kg: 1e5,
        centre_m: [0.0, 0.0],
        gyration_m: 4.0,
        outline: Some(Outline::rectangle([0.0, 0.0], 12.0, 8.0).unwrap()),
    };
    let storey = Storey {
        height_m: 3.0,
        stiffness: StoreyStiffness::at_centre(3e7, 3e7, 9e8, [0.0, 0.0]),
    };
    let building = Building::new(vec![floor], vec![storey], PDelta::LeftOut).unwrap();
    let vibrating =
        VibratingBuilding::new(building, &BuildingDamping::Modal(vec![0.05]), Vec::new()).unwrap();
    let shaken = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let motion = el_centro(&[(Component::X, 9.8 * cos), (Component::Y, 9.8 * sin)]);
        let history = building_history(&vibrating, &motion, &BuildingRun::default()).unwrap();
        history.peaks.storeys[0]
    };
    let along = shaken(0.0);
    let size_m = along.drift_x_m.value.abs();
    for degrees in [0.0, 30.0, 45.0, 90.0, 200.0] {
        let found = shaken(degrees).resultant;
        assert!(
            (found.size_m / size_m - 1.0).abs() < 1e-9,
            "{degrees}: {found:?} {size_m}"
        );
        let line = (found.direction_degrees - degrees).rem_euclid(180.0);
        assert!(line.min(180.0 - line) < 1e-9, "{degrees}: {found:?}");
    }
    // along x and along y alone it is smaller
    assert!(shaken(45.0).edge_drift_x_m.unwrap().value.abs() < 0.71 * size_m);
}
