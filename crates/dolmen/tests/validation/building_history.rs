// SOURCE     the matrix exponential of the whole system, formed here from M, C, K.
// GOAL       Time histories of buildings with and without tuned masses are exact at the time steps and give the peaks between them.
// PARAMETERS 20 storeys, 61 coordinates with a tuned mass, El Centro 1940 NS, 40 s at 0.005 s; smaller buildings with two masses, two
//            components, P-delta, overdamped masses.
// TOLERANCE  1e-9 m.

use dolmen::comparisons::{twenty_storeys, twenty_storeys_mass};
use dolmen::dynamics::{
    BuildingHistory, BuildingRun, HistoryMethod, TunedMass, VibratingBuilding, building_history,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingDamping, Element, Floor, PDelta, PlanDirection, Storey, StoreyStiffness,
};
use dolmen_linalg::{Matrix, solve};

pub(super) fn el_centro(components: &[(Component, f64)]) -> GroundMotion {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples: Vec<f64> = text
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').unwrap().1.parse::<f64>().unwrap())
        .collect();
    let each = components
        .iter()
        .map(|&(component, g)| (component, samples.iter().map(|a| g * a).collect()));
    GroundMotion::new("El Centro 1940 NS", 0.02, each.collect()).unwrap()
}

/// e^X by its series, after halving until ‖X‖ < 1/4.
pub(super) fn exponential(x: &Matrix) -> Matrix {
    let norm = x
        .as_slice()
        .iter()
        .fold(0.0_f64, |most, value| most.max(value.abs()))
        * x.rows() as f64;
    let halvings = (4.0 * norm).log2().ceil().max(0.0) as i32;
    let small = x.scaled(0.5_f64.powi(halvings));
    let (mut sum, mut term) = (Matrix::identity(x.rows()), Matrix::identity(x.rows()));
    for k in 1..20 {
        term = (&term * &small).scaled(1.0 / f64::from(k));
        sum = &sum + &term;
    }
    (0..halvings).fold(sum, |sum, _| &sum * &sum)
}

/// The displacements and strokes at every step, from M, C, K of the whole system in plan coordinates.
fn by_exponential(
    vibrating: &VibratingBuilding,
    damping: &BuildingDamping,
    motion: &GroundMotion,
    cut: usize,
    steps: usize,
) -> Matrix {
    let building = vibrating.building();
    let n = building.coordinates();
    let size = n + vibrating.tuned_masses().len();
    let grown = |small: &Matrix| {
        Matrix::from_fn(
            size,
            size,
            |i, j| if i < n && j < n { small[(i, j)] } else { 0.0 },
        )
    };
    let mut m = grown(&building.mass_matrix());
    let mut c = grown(&building.damping_matrix(damping).unwrap());
    let mut k = grown(&building.stiffness_matrix());
    let mut shakes = [PlanDirection::X, PlanDirection::Y].map(|d| building.ground_column(d));
    let mut places = Vec::new();
    for (d, tuned) in vibrating.tuned_masses().iter().enumerate() {
        let omega = std::f64::consts::TAU * tuned.frequency_hz;
        let mut stretch = building
            .point_row(tuned.floor, tuned.x_m, tuned.y_m, tuned.direction)
            .unwrap();
        stretch.resize(size, 0.0);
        places.push(stretch.clone());
        stretch[n + d] = -1.0;
        m[(n + d, n + d)] = tuned.mass_kg;
        for i in 0..size {
            for j in 0..size {
                k[(i, j)] += tuned.mass_kg * omega * omega * stretch[i] * stretch[j];
                c[(i, j)] += 2.0 * tuned.damping_ratio * tuned.mass_kg * omega * stretch[i] * stretch[j];
            }
        }
        let unit = tuned.direction.unit();
        (0..2).for_each(|axis| shakes[axis].push(unit[axis]));
    }
    let h = motion.time_step_s() / cut as f64;
    let (mk, mc) = (solve(&m, &k).unwrap(), solve(&m, &c).unwrap());
    let fastest = mk
        .as_slice()
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()))
        .sqrt();
    // x, x'/(largest frequency), a and b − a of both axes
    let whole = 2 * size + 4;
    let mut generator = Matrix::zeros(whole, whole);
    for i in 0..size {
        generator[(i, size + i)] = h * fastest;
        for j in 0..size {
            generator[(size + i, j)] = -h * mk[(i, j)] / fastest;
            generator[(size + i, size + j)] = -h * mc[(i, j)];
        }
        for (axis, shake) in shakes.iter().enumerate() {
            generator[(size + i, 2 * size + axis)] = -h * shake[i] / fastest;
        }
    }
    generator[(2 * size, 2 * size + 2)] = 1.0;
    generator[(2 * size + 1, 2 * size + 3)] = 1.0;
    let flow = exponential(&generator);
    let mut state = vec![0.0; whole];
    let mut found = Matrix::zeros(size, steps + 1);
    for step in 0..steps {
        let (sample, part) = (step / cut, (step % cut) as f64 / cut as f64);
        for (axis, component) in [Component::X, Component::Y].into_iter().enumerate() {
            let values = if motion.has(component) {
                motion.acceleration_m_s2(component)
            } else {
                &[]
            };
            let [a, b] = match values.get(sample..sample + 2) {
                Some(pair) => [part, part + 1.0 / cut as f64].map(|at| pair[0] + at * (pair[1] - pair[0])),
                None => [0.0, 0.0],
            };
            state[2 * size + axis] = a;
            state[2 * size + 2 + axis] = b - a;
        }
        state = flow.times(&state);
        let column = found.column_mut(step + 1);
        column.copy_from_slice(&state[..size]);
        for (d, place) in places.iter().enumerate() {
            let at: f64 = place.iter().zip(&state).map(|(r, x)| r * x).sum();
            column[n + d] -= at;
        }
    }
    found
}

pub(super) fn largest_difference(history: &BuildingHistory, other: &Matrix) -> f64 {
    assert_eq!(history.coordinates.columns(), other.columns());
    let pairs = history.coordinates.as_slice().iter().zip(other.as_slice());
    pairs.fold(0.0, |most, (a, b)| most.max((a - b).abs()))
}

#[test]
fn agrees_twenty_storeys_with_a_mass_by_the_matrix_exponential() {
    let damping = BuildingDamping::Modal(vec![0.02, 0.02, 0.03, 0.05]);
    let vibrating =
        VibratingBuilding::new(twenty_storeys().unwrap(), &damping, vec![twenty_storeys_mass()]).unwrap();
    let motion = el_centro(&[(Component::Y, 9.80665)]);
    let run = BuildingRun {
        steps_per_sample: 4,
        end_s: Some(40.0),
        ..BuildingRun::default()
    };
    let history = building_history(&vibrating, &motion, &run).unwrap();
    assert_eq!((history.length(), history.coordinates.rows()), (8001, 61));
    assert_eq!(history.method, HistoryMethod::ComplexModes);
    let other = by_exponential(&vibrating, &damping, &motion, 4, 8000);
    let difference = largest_difference(&history, &other);
    assert!(difference < 1e-9, "{difference}");
    let roof = history.peaks.floors[19].displacement_y_m.value.abs();
    assert!(
        roof > 0.05 && history.peaks.strokes_m[0].value.abs() > roof,
        "{:?}",
        history.peaks.strokes_m
    );
}

/// Three storeys with setbacks, with P-delta.
pub(super) fn stepped() -> Building {
    let (mut floors, mut storeys) = (Vec::new(), Vec::new());
    for i in 0..3 {
        let shift = f64::from(i);
        floors.push(Floor {
            mass_kg: 2e5 - 4e4 * shift,
            centre_m: [0.7 * shift, -0.4 * shift],
            gyration_m: 5.0 - 0.5 * shift,
            outline: None,
        });
        let wall = |x_m, y_m, angle_degrees| Element {
            x_m,
            y_m,
            stiffness_x_n_m: 8e7,
            stiffness_y_n_m: 4e6,
            stiffness_rotation_n_m_rad: 0.0,
            angle_degrees,
        };
        let walls = vec![
            wall(-4.0, 0.0, 90.0),
            wall(3.0, 1.0, 70.0),
            wall(0.0, -3.0, 0.0),
            wall(1.0, 4.0, 20.0),
        ];
        storeys.push(Storey {
            height_m: 4.0,
            stiffness: StoreyStiffness::of_elements(walls).unwrap(),
        });
    }
    Building::new(floors, storeys, PDelta::Weights { gravity_m_s2: 9.81 }).unwrap()
}

pub(super) fn mass(floor: usize, x_m: f64, degrees: f64, frequency_hz: f64, damping_ratio: f64) -> TunedMass {
    TunedMass {
        floor,
        x_m,
        y_m: 1.0,
        direction: PlanDirection::Degrees(degrees),
        mass_kg: 1.5e4,
        frequency_hz,
        damping_ratio,
    }
}

#[test]
fn agrees_masses_of_all_kinds_under_two_components() {
    let damping = BuildingDamping::Modal(vec![0.03, 0.01, 0.08]);
    let motion = el_centro(&[(Component::X, 3.0), (Component::Y, -7.0)]);
    let first_hz = stepped().modes().unwrap().modes[0].frequency_hz;
    let many = (0..4).map(|i| {
        mass(
            3,
            f64::from(i),
            30.0 * f64::from(i),
            first_hz * (0.9 + 0.05 * f64::from(i)),
            0.05,
        )
    });
    let cases = [
        (vec![], HistoryMethod::ComplexModes),
        (
            vec![mass(3, 2.0, 37.0, first_hz, 0.1)],
            HistoryMethod::ComplexModes,
        ),
        (
            vec![
                mass(2, -3.0, 90.0, 3.0 * first_hz, 0.0),
                mass(3, 2.0, 0.0, first_hz, 0.2),
            ],
            HistoryMethod::ComplexModes,
        ),
        (many.collect(), HistoryMethod::ComplexModes),
        // overdamped, and two masses with equal properties
        (
            vec![mass(3, 2.0, 37.0, first_hz, 3.0)],
            HistoryMethod::MatrixExponential,
        ),
        (
            vec![mass(3, 2.0, 90.0, first_hz, 0.1); 2],
            HistoryMethod::MatrixExponential,
        ),
    ];
    for (masses, method) in cases {
        let count = masses.len();
        let vibrating = VibratingBuilding::new(stepped(), &damping, masses).unwrap();
        let history = building_history(&vibrating, &motion, &BuildingRun::default()).unwrap();
        let other = by_exponential(&vibrating, &damping, &motion, 1, history.length() - 1);
        let difference = largest_difference(&history, &other);
        assert!(difference < 1e-11, "{count} masses: {difference}");
        assert_eq!(history.method, method, "{count} masses");
    }
}

#[test]
fn holds_a_mass_that_hardly_moves_with_a_mode_is_as_exact() {
    // along x at the centre of a floor with an asymmetry of only 1e-9 m: its y modes hardly move the mass
    for off_m in [1e-9, 1e-6, 0.0] {
        let floor = Floor {
            mass_kg: 1e5,
            centre_m: [0.0, off_m],
            gyration_m: 4.0,
            outline: None,
        };
        let storey = Storey {
            height_m: 3.0,
            stiffness: StoreyStiffness::at_centre(2e7, 2e7, 4e8, [0.0, 0.0]),
        };
        let building = Building::new(
            vec![floor.clone(), floor],
            vec![storey.clone(), storey],
            PDelta::LeftOut,
        )
        .unwrap();
        let tuned = TunedMass {
            y_m: 0.0,
            ..mass(2, 0.0, 0.0, 1.3, 0.08)
        };
        let damping = BuildingDamping::Modal(vec![0.02]);
        let vibrating = VibratingBuilding::new(building, &damping, vec![tuned]).unwrap();
        let motion = el_centro(&[(Component::X, 9.8), (Component::Y, 9.8)]);
        let history = building_history(&vibrating, &motion, &BuildingRun::default()).unwrap();
        let other = by_exponential(&vibrating, &damping, &motion, 1, history.length() - 1);
        let difference = largest_difference(&history, &other);
        assert!(difference < 1e-11, "{off_m}: {difference}");
    }
}

#[test]
fn holds_drifts_of_edges_are_those_of_the_points_there() {
    let vibrating = VibratingBuilding::new(
        twenty_storeys().unwrap(),
        &BuildingDamping::Modal(vec![0.05]),
        Vec::new(),
    )
    .unwrap();
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, 5.0)]);
    let building = vibrating.building();
    for storey in [1, 7, 20] {
        let mut most = [0.0_f64; 2];
        let mut watched = Vec::new();
        for (x, y) in [(-12.0, -8.0), (12.0, -8.0), (12.0, 8.0), (-12.0, 8.0)] {
            for (axis, direction) in [PlanDirection::X, PlanDirection::Y].into_iter().enumerate() {
                let row = |floor| building.point_row(floor, x, y, direction).unwrap();
                let mut drift = row(storey);
                if storey > 1 {
                    drift.iter_mut().zip(row(storey - 1)).for_each(|(a, b)| *a -= b);
                }
                watched.push((axis, drift));
            }
        }
        let run = BuildingRun {
            watched: watched.iter().map(|(_, row)| row.clone()).collect(),
            ..BuildingRun::default()
        };
        let history = building_history(&vibrating, &motion, &run).unwrap();
        for ((axis, _), found) in watched.iter().zip(&history.watched) {
            most[*axis] = most[*axis].max(found.displacement_peak_m.value.abs());
        }
        let peak = &history.peaks.storeys[storey - 1];
        let [x, y] = [peak.edge_drift_x_m, peak.edge_drift_y_m].map(|peak| peak.unwrap().value.abs());
        assert!((x / most[0] - 1.0).abs() < 1e-12 && (y / most[1] - 1.0).abs() < 1e-12);
        assert!(y > 1.01 * peak.drift_y_m.value.abs());
    }
}

#[test]
fn holds_finer_steps_give_the_same_motion() {
    let damping = BuildingDamping::Modal(vec![0.02]);
    let first_hz = stepped().modes().unwrap().modes[0].frequency_hz;
    let vibrating =
        VibratingBuilding::new(stepped(), &damping, vec![mass(3, 2.0, 37.0, first_hz, 0.1)]).unwrap();
    let motion = el_centro(&[(Component::X, 3.0), (Component::Y, -7.0)]);
    let run = |steps_per_sample| BuildingRun {
        steps_per_sample,
        end_s: Some(35.0),
        ..BuildingRun::default()
    };
    let coarse = building_history(&vibrating, &motion, &run(1)).unwrap();
    let fine = building_history(&vibrating, &motion, &run(5)).unwrap();
    for step in 0..coarse.length() {
        for (a, b) in coarse
            .coordinates
            .column(step)
            .iter()
            .zip(fine.coordinates.column(5 * step))
        {
            assert!((a - b).abs() < 1e-13, "{step}: {a} {b}");
        }
    }
    let vertical = el_centro(&[(Component::Z, 3.0)]);
    let refused = building_history(&vibrating, &vertical, &run(1))
        .unwrap_err()
        .to_string();
    assert!(refused.contains("1 or 2: x, y or both"), "{refused}");
    let outside = TunedMass {
        floor: 4,
        ..mass(3, 0.0, 0.0, 1.0, 0.1)
    };
    let refused = VibratingBuilding::new(stepped(), &damping, vec![outside])
        .unwrap_err()
        .to_string();
    assert_eq!(
        refused,
        "floor 4 was asked for, but they are numbered from 1 to 3"
    );
}

#[test]
fn exact_absolute_acceleration_and_peaks_between_steps_of_one_mode() {
    // a step of the ground acceleration under a damped floor: u = −(a/ω²)(1 − e^(−ζωt)(cos ω_d t + ζ/√(1−ζ²) sin ω_d t))
    let floor = Floor {
        mass_kg: 1.0,
        centre_m: [0.0, 0.0],
        gyration_m: 2.0,
        outline: None,
    };
    let (omega, zeta) = (10.0_f64, 0.1_f64);
    let stiffness = StoreyStiffness::at_centre(omega * omega, 900.0, 3000.0, [0.0, 0.0]);
    let storey = Storey {
        height_m: 3.0,
        stiffness,
    };
    let building = Building::new(vec![floor], vec![storey], PDelta::LeftOut).unwrap();
    let damping = BuildingDamping::Modal(vec![zeta]);
    let row = building.point_row(1, 0.0, 0.0, PlanDirection::X).unwrap();
    let motion = GroundMotion::new("step", 0.05, vec![(Component::X, vec![1.0; 60])]).unwrap();
    let vibrating = VibratingBuilding::new(building, &damping, Vec::new()).unwrap();
    let run = BuildingRun {
        watched: vec![row],
        end_s: Some(2.0),
        ..BuildingRun::default()
    };
    let history = building_history(&vibrating, &motion, &run).unwrap();
    let root = (1.0 - zeta * zeta).sqrt();
    let overshoot = (-std::f64::consts::PI * zeta / root).exp();
    let peak = history.peaks.floors[0].displacement_x_m;
    assert!((peak.value + (1.0 + overshoot) / (omega * omega)).abs() < 1e-8);
    assert!(
        (peak.at_s - std::f64::consts::PI / (omega * root)).abs() < 1e-6,
        "{peak:?}"
    );
    let watched = &history.watched[0];
    assert_eq!(watched.displacement_peak_m, peak);
    // acceleration with the ground: −2ζω u′ − ω² u
    for (step, found) in watched.acceleration_m_s2.iter().enumerate() {
        let t = history.time_s(step);
        let (sin, cos) = (omega * root * t).sin_cos();
        let decay = (-zeta * omega * t).exp();
        let u = -(1.0 - decay * (cos + zeta / root * sin)) / (omega * omega);
        let rate = -decay * sin / (omega * root);
        assert!(
            (found - (-2.0 * zeta * omega * rate - omega * omega * u)).abs() < 1e-12,
            "{step}"
        );
    }
    let largest = watched
        .acceleration_m_s2
        .iter()
        .fold(0.0_f64, |most, a| most.max(a.abs()));
    let peak = watched.acceleration_peak_m_s2;
    assert!(peak.value >= largest && peak.value < 1.01 * largest);
    // zero of its rate: tan ω_d t = −√(1−ζ²)(1 − 4ζ²)/(ζ(3 − 4ζ²))… by bisection of the closed form
    let acceleration = |t: f64| {
        let (sin, cos) = (omega * root * t).sin_cos();
        let decay = (-zeta * omega * t).exp();
        2.0 * zeta * decay * sin / root + 1.0 - decay * (cos + zeta / root * sin)
    };
    let (mut low, mut high) = (0.1, 0.5);
    for _ in 0..200 {
        let (a, b) = (low + (high - low) / 3.0, high - (high - low) / 3.0);
        if acceleration(a) < acceleration(b) {
            low = a
        } else {
            high = b
        }
    }
    assert!(
        (peak.value - acceleration(low)).abs() < 1e-6,
        "{peak:?} {}",
        acceleration(low)
    );
}

#[test]
fn regress_a_short_pulse_is_followed_into_the_free_swing() {
    // 0.31 s of 3 m/s² along y on a floor with T = 3.27 s. A matrix exponential in another program gives peaks of 413.268 mm, 36.854 mrad,
    // 160.04 kN at the steps after the pulse; between the steps up to π²/(2·327²) more
    let floor = Floor {
        mass_kg: 1e5,
        centre_m: [0.0, 0.0],
        gyration_m: (164.0_f64 / 12.0).sqrt(),
        outline: Some(dolmen::structure::building::Outline::rectangle([0.0, 0.0], 10.0, 8.0).unwrap()),
    };
    let stiffness = StoreyStiffness::at_centre(4e5, 4e5, 1e7, [-1.0, 0.0]);
    let storey = Storey {
        height_m: 30.0,
        stiffness,
    };
    let building = Building::new(vec![floor], vec![storey], PDelta::LeftOut).unwrap();
    let damping = BuildingDamping::Modal(vec![0.05]);
    let mut samples = vec![3.0; 32];
    (samples[0], samples[31]) = (0.0, 0.0);
    let pulse = GroundMotion::new("pulse", 0.01, vec![(Component::Y, samples)]).unwrap();
    let vibrating = VibratingBuilding::new(building, &damping, Vec::new()).unwrap();
    let history = building_history(&vibrating, &pulse, &BuildingRun::default()).unwrap();
    let peaks = &history.peaks;
    let floor = peaks.floors[0];
    assert!(
        (floor.displacement_y_m.value.abs() - 0.413_268).abs() < 2e-5,
        "{floor:?}"
    );
    assert!(
        (floor.rotation_rad.value.abs() - 0.036_854).abs() < 2e-6,
        "{floor:?}"
    );
    assert!((peaks.storeys[0].edge_drift_y_m.unwrap().value.abs() - 0.502_473).abs() < 2.5e-5);
    assert!(
        (peaks.base_shear_n[1].value.abs() - 160.04e3).abs() < 10.0,
        "{peaks:?}"
    );
    assert!(!history.grows_at_the_end());
    let cut = BuildingRun {
        end_s: Some(0.31),
        ..BuildingRun::default()
    };
    assert!(
        building_history(&vibrating, &pulse, &cut)
            .unwrap()
            .grows_at_the_end()
    );
}

#[test]
fn exact_walls_carry_more_than_the_ground_with_p_delta() {
    // stiffness 1e6 N/m, 1e5 kg at 3 m: (k − W/h) drift is the resistance of the building, k drift the force in the walls
    let floor = Floor {
        mass_kg: 1e5,
        centre_m: [2.0, -1.0],
        gyration_m: 4.0,
        outline: None,
    };
    let storey = Storey {
        height_m: 3.0,
        stiffness: StoreyStiffness::at_centre(1e6, 1.1e6, 6e7, [1.0, 0.5]),
    };
    let p_delta = PDelta::Weights { gravity_m_s2: 9.8 };
    let building = Building::new(vec![floor], vec![storey], p_delta).unwrap();
    let rows = building.base_rows();
    // along x the line of the walls is 1.5 m in front of the mass, along y 1 m left of it
    let by_hand = [
        [1e6, 0.0, -1.5e6],
        [0.0, 1.1e6, -1.1e6],
        [-1.5e6, -1.1e6, 6e7 + 1e6 * 2.25 + 1.1e6],
    ];
    for (row, by_hand) in rows.iter().zip(by_hand) {
        for (a, b) in row.iter().zip(by_hand) {
            assert!((a - b).abs() < 1e-6 * 1e6, "{rows:?}");
        }
    }
    assert!(building.edge_drift_rows(1).unwrap().is_none());
}
