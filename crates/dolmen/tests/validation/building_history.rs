// SOURCE     the matrix exponential of the whole system, made here from M, C, K; Chopra (2017) Dynamics of Structures, section 13.8.2.
// GOAL       Time histories of buildings with and without tuned masses are exact at their steps; response spectra put modes together
//            as published.
// PARAMETERS 20 storeys, 61 coordinates with a tuned mass, El Centro 1940 NS, 40 s at 0.005 s; smaller buildings with two masses, two
//            components, P-delta, masses damped beyond swinging. Five storeys of 100 kip/g, 31.54 kip/in, 5 %.
// PUBLISHED  base shear ABSSUM 98.32, SRSS 65.99, CQC 66.43, time history 73.15 kip; T = 1.99963 .68504 .43456 .33828 .29659 s.
// TOLERANCE  1e-9 m; half a unit of the last digit printed, of the time history 0.03 %: the source takes its peak from rounded samples.

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
        assert!((found.value.abs() / known.displacement_at_samples_m - 1.0).abs() < 1e-12);
        let shear = history.peaks.base_shear_n[usize::from(component == Component::Y)]
            .value
            .abs();
        assert!((shear / (k * known.displacement_at_samples_m) - 1.0).abs() < 1e-12);
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
    let history = building_history(&vibrating, &motion, &BuildingRun::default()).unwrap();
    let building = vibrating.building();
    for storey in [1, 7, 20] {
        let mut most = [0.0_f64; 2];
        for (x, y) in [(-12.0, -8.0), (12.0, -8.0), (12.0, 8.0), (-12.0, 8.0)] {
            for (axis, direction) in [PlanDirection::X, PlanDirection::Y].into_iter().enumerate() {
                let row = |floor| building.point_row(floor, x, y, direction).unwrap();
                let upper = history.along(&row(storey));
                let lower = if storey > 1 {
                    history.along(&row(storey - 1))
                } else {
                    vec![0.0; upper.len()]
                };
                let drift = upper
                    .iter()
                    .zip(lower)
                    .fold(0.0_f64, |most, (a, b)| most.max((a - b).abs()));
                most[axis] = most[axis].max(drift);
            }
        }
        let peak = &history.peaks.storeys[storey - 1];
        assert!((peak.edge_drift_x_m.value.abs() / most[0] - 1.0).abs() < 1e-12);
        assert!((peak.edge_drift_y_m.value.abs() / most[1] - 1.0).abs() < 1e-12);
        assert!(peak.edge_drift_y_m.value.abs() > 1.01 * peak.drift_y_m.value.abs());
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
