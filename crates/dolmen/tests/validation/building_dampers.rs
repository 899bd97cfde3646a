// SOURCE     the matrix exponential of building and dampers, with M, C, K derived here from their kinetic and potential
//            energy.
// GOAL       Time histories with liquid columns, column masses, links and tuned masses together are exact at the time
//            steps.
// TOLERANCE  1e-11 m, 1e-8 m/s².

use super::building_history::{el_centro, exponential, largest_difference, mass, stepped};
use dolmen::damper::{AttachedDamper, DamperKind, damped_building_history};
use dolmen::dynamics::{BuildingRun, VibratingBuilding, building_history};
use dolmen::signal::Component;
use dolmen::structure::building::{BuildingDamping, PlanDirection};
use dolmen_linalg::{Matrix, solve};

/// Matrices in plan coordinates, all computed here: rows, masses, M, C, K of a column and a column mass.
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
    // own coordinates: x, w1, z2, w3
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
        // dampers on a floor also feel the base acceleration −M⁻¹(C q′ + K q), from the equation of motion
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
    // with masses only: the same as mode by mode
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
