// SOURCE     the matrix exponential of the whole system, made here from M, C, K; Chopra (2017) Dynamics of Structures, section 13.8.2.
// GOAL       Time histories of buildings with and without tuned masses are exact at their steps; response spectra put modes together
//            as published.
// PARAMETERS 20 storeys, 61 coordinates with a tuned mass, El Centro 1940 NS, 40 s at 0.005 s; smaller buildings with two masses, two
//            components, P-delta, masses damped beyond swinging. Five storeys of 100 kip/g, 31.54 kip/in, 5 %.
// PUBLISHED  base shear ABSSUM 98.32, SRSS 65.99, CQC 66.43, time history 73.15 kip; T = 1.99963 .68504 .43456 .33828 .29659 s.
// TOLERANCE  1e-9 m; half a unit of the last digit printed, of the time history 0.03 %: the source takes its peak from rounded samples.

use dolmen::damper::{AttachedDamper, DamperKind, damped_building_history};
use dolmen::dynamics::{
    BuildingHistory, BuildingRun, DirectionalCombination, DynamicsError, HistoryMethod, ModalCombination,
    TunedMass, VibratingBuilding, building_history, correlation_coefficient, spectral_analysis,
};
use dolmen::signal::{Component, GroundMotion, response_spectrum};
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingDamping, Element, Floor, PDelta, PlanDirection, Storey, StoreyStiffness,
};
use dolmen::validation::{twenty_storeys, twenty_storeys_mass};
use dolmen_linalg::{Matrix, solve};

fn el_centro(components: &[(Component, f64)]) -> GroundMotion {
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

/// e^X by its series, ‖X‖ brought below 1/4 by halving.
fn exponential(x: &Matrix) -> Matrix {
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

/// The displacements and strokes at every step, from M, C, K of everything in coordinates of the plan.
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
    // x, x'/fastest, a and b − a of both axes
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

fn largest_difference(history: &BuildingHistory, other: &Matrix) -> f64 {
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

/// Three storeys that step back, with P-delta.
fn stepped() -> Building {
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

fn mass(floor: usize, x_m: f64, degrees: f64, frequency_hz: f64, damping_ratio: f64) -> TunedMass {
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
        // damped beyond swinging, and two masses that are one
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
    // along x at the middle of a floor that is symmetric but for 1e-9 m: its modes of y move the mass by next to nothing
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
        // between the steps, as the response spectrum finds it there
        assert!((found.value.abs() / known.displacement_m - 1.0).abs() < 1e-9);
        assert!(found.value.abs() > known.displacement_at_samples_m);
        let shear = history.peaks.base_shear_n[usize::from(component == Component::Y)]
            .value
            .abs();
        assert!((shear / (k * known.displacement_m) - 1.0).abs() < 1e-9);
    }
    assert!(peak.rotation_rad.value.abs() < 1e-16);
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
    // a step of the ground under a damped floor: u = −(a/ω²)(1 − e^(−ζωt)(cos ω_d t + ζ/√(1−ζ²) sin ω_d t))
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
    // its rate 1·(…)=0: tan ω_d t = −√(1−ζ²)(1 − 4ζ²)/(ζ(3 − 4ζ²))… by bisection of the closed form
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
    // 0.31 s of 3 m/s² along y on a floor of T = 3.27 s: at steps 413.268 mm, 36.854 mrad, 160.04 kN come after it, by a matrix exponential
    // in another program; between the steps up to π²/(2·327²) more
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
    // stiffness 1e6 N/m, 1e5 kg 3 m up: (k − W/h) drift holds the building, k drift is in the walls
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
    // along x the walls' line is 1.5 m in front of the mass, along y 1 m left of it
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
    // one component alone, turned: every mode's response is that to the turned shaking
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

/// The same by matrices in coordinates of the plan, all made here: rows, masses, M, C, K of a column and a column mass by their
/// kinetic and potential energy.
#[test]
fn agrees_dampers_of_all_kinds_in_time_by_the_matrix_exponential() {
    let damping = BuildingDamping::Modal(vec![0.02]);
    let building = stepped();
    let n = building.coordinates();
    let at = |floor, x, y, degrees| {
        building
            .point_row(floor, x, y, PlanDirection::Degrees(degrees))
            .unwrap()
    };
    let hz = building.modes().unwrap().modes[0].frequency_hz;
    let (tube, tank) = (at(3, 2.0, 0.0, 90.0), at(3, -1.0, 0.5, 37.0));
    let [upper, lower] = [at(2, 1.0, 1.0, 10.0), at(1, 1.0, 1.0, 10.0)];
    let (m1, a1, w1, z1) = (2e3, 0.7, 0.95 * hz, 0.1);
    let (mc, ml, a2, w2, z2, w3, z3) = (1e3, 1.5e3, 0.6, 0.9 * hz, 0.12, 1.1 * hz, 0.08);
    let c4 = 3e5;
    let dampers = [
        AttachedDamper {
            kind: DamperKind::LiquidColumn {
                liquid_mass_kg: m1,
                length_ratio: a1,
                frequency_hz: w1,
                damping_ratio: z1,
            },
            row: tube.clone(),
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumnMass {
                container_mass_kg: mc,
                liquid_mass_kg: ml,
                length_ratio: a2,
                frequency_hz: w2,
                damping_ratio: z2,
                liquid_frequency_hz: w3,
                liquid_damping_ratio: z3,
            },
            row: tank.clone(),
        },
        AttachedDamper::link(c4, &upper, &lower),
    ];
    let motion = el_centro(&[(Component::X, 9.8), (Component::Y, -5.0)]);
    let vibrating = VibratingBuilding::new(building.clone(), &damping, Vec::new()).unwrap();
    let steps = 1200;
    let run = BuildingRun {
        end_s: Some(steps as f64 * 0.02),
        watched: vec![tube.clone()],
        ..BuildingRun::default()
    };
    let history = damped_building_history(&vibrating, &dampers, &motion, &run).unwrap();
    assert_eq!(history.coordinates.rows(), n + 4);
    // own: x, w1, z2, w3
    let size = n + 3;
    let wide = |row: &[f64], own: [f64; 3]| -> Vec<f64> { row.iter().copied().chain(own).collect() };
    let none = vec![0.0; n];
    let tau = std::f64::consts::TAU;
    let mut m = Matrix::zeros(size, size);
    let mut c = m.clone();
    let mut k = m.clone();
    for i in 0..n {
        for j in 0..n {
            m[(i, j)] = building.mass_matrix()[(i, j)];
            c[(i, j)] = building.damping_matrix(&damping).unwrap()[(i, j)];
            k[(i, j)] = building.stiffness_matrix()[(i, j)];
        }
    }
    let add = |matrix: &mut Matrix, factor: f64, a: &[f64], b: &[f64]| {
        for i in 0..size {
            for j in 0..size {
                matrix[(i, j)] += 0.5 * factor * (a[i] * b[j] + b[i] * a[j]);
            }
        }
    };
    let (carried, w_1) = (wide(&tube, [0.0; 3]), wide(&none, [1.0, 0.0, 0.0]));
    add(&mut m, m1, &carried, &carried);
    add(&mut m, 2.0 * m1 * a1, &carried, &w_1);
    add(&mut m, m1, &w_1, &w_1);
    add(&mut k, m1 * (tau * w1).powi(2), &w_1, &w_1);
    add(&mut c, 2.0 * m1 * z1 * tau * w1, &w_1, &w_1);
    let (z_2, w_3) = (wide(&none, [0.0, 1.0, 0.0]), wide(&none, [0.0, 0.0, 1.0]));
    let apart: Vec<f64> = z_2
        .iter()
        .zip(wide(&tank, [0.0; 3]))
        .map(|(z, x)| z - x)
        .collect();
    add(&mut m, mc + ml, &z_2, &z_2);
    add(&mut m, 2.0 * ml * a2, &z_2, &w_3);
    add(&mut m, ml, &w_3, &w_3);
    add(&mut k, (mc + ml) * (tau * w2).powi(2), &apart, &apart);
    add(&mut c, 2.0 * (mc + ml) * z2 * tau * w2, &apart, &apart);
    add(&mut k, ml * (tau * w3).powi(2), &w_3, &w_3);
    add(&mut c, 2.0 * ml * z3 * tau * w3, &w_3, &w_3);
    let pulled: Vec<f64> = upper.iter().zip(&lower).map(|(a, b)| a - b).collect();
    let pulled = wide(&pulled, [0.0; 3]);
    add(&mut c, c4, &pulled, &pulled);
    let (mk, mc_) = (solve(&m, &k).unwrap(), solve(&m, &c).unwrap());
    let e = [PlanDirection::X, PlanDirection::Y].map(|direction| {
        let ground = building.ground_column(direction);
        let moves: f64 = tank.iter().zip(&ground).map(|(a, b)| a * b).sum();
        wide(&ground, [0.0, moves, 0.0])
    });
    let h = 0.02;
    let fastest = 400.0;
    let whole = 2 * size + 4;
    let mut generator = Matrix::zeros(whole, whole);
    for i in 0..size {
        generator[(i, size + i)] = h * fastest;
        for j in 0..size {
            generator[(size + i, j)] = -h * mk[(i, j)] / fastest;
            generator[(size + i, size + j)] = -h * mc_[(i, j)];
        }
        for axis in 0..2 {
            generator[(size + i, 2 * size + axis)] = -h * e[axis][i] / fastest;
        }
    }
    generator[(2 * size, 2 * size + 2)] = 1.0;
    generator[(2 * size + 1, 2 * size + 3)] = 1.0;
    let flow = exponential(&generator);
    let mut state = vec![0.0; whole];
    let mut worst = 0.0_f64;
    for step in 0..steps {
        for (axis, component) in [Component::X, Component::Y].into_iter().enumerate() {
            let values = motion.acceleration_m_s2(component);
            state[2 * size + axis] = values[step];
            state[2 * size + 2 + axis] = values[step + 1] - values[step];
        }
        state = flow.times(&state);
        let found = history.coordinates.column(step + 1);
        let dot = |row: &[f64]| -> f64 { row.iter().zip(&state).map(|(a, b)| a * b).sum() };
        let mut expected = state[..n].to_vec();
        expected.extend([dot(&w_1), dot(&apart), dot(&pulled), dot(&w_3)]);
        for (a, b) in found.iter().zip(expected) {
            worst = worst.max((a - b).abs());
        }
        // what stands on the floor feels −M⁻¹(C q′ + K q) there, by the equation of motion
        let (q, v) = (
            &state[..size],
            state[size..2 * size]
                .iter()
                .map(|v| v * fastest)
                .collect::<Vec<f64>>(),
        );
        let all: Vec<f64> = mk
            .times(q)
            .iter()
            .zip(mc_.times(&v))
            .map(|(a, b)| -a - b)
            .collect();
        let felt: f64 = carried.iter().zip(&all).map(|(a, b)| a * b).sum();
        assert!((felt - history.watched[0].acceleration_m_s2[step + 1]).abs() < 1e-8);
    }
    assert!(worst < 1e-11, "{worst}");
    let strokes = &history.peaks.strokes_m;
    assert!(
        strokes.len() == 4 && strokes.iter().all(|peak| peak.value.abs() > 1e-4),
        "{strokes:?}"
    );
    // masses alone: as mode by mode
    let tuned = mass(3, 2.0, 37.0, hz, 0.1);
    let only = [AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: tuned.mass_kg,
            frequency_hz: tuned.frequency_hz,
            damping_ratio: tuned.damping_ratio,
        },
        row: building
            .point_row(3, tuned.x_m, tuned.y_m, tuned.direction)
            .unwrap(),
    }];
    let one = damped_building_history(&vibrating, &only, &motion, &run).unwrap();
    let with = vibrating.clone().with_tuned_masses(vec![tuned]).unwrap();
    let other = building_history(&with, &motion, &run).unwrap();
    assert!(largest_difference(&one, &other.coordinates) < 1e-11);
    let refused = damped_building_history(&with, &only, &motion, &run).unwrap_err();
    assert!(
        refused.to_string().contains("give every damper in the list"),
        "{refused}"
    );
}
