// SOURCE     Statics of springs in plan by hand; a stiffness matrix assembled from every wall and weight by virtual work, solved by elimination.
// GOAL       Displacements of the floors of a building under forces and torques.
// PARAMETERS shear buildings, a storey with its walls off the middle; 200 buildings drawn by a seed, one to eight floors.
// PUBLISHED  by hand: drift V/k, θ = T/k_θ, and three equations for the storey off the middle.
// TOLERANCE  1e-12 closed forms; 1e-9 of the largest displacement for drawn buildings, whose matrices have condition numbers up to 1e6.

use dolmen::numeric::Random;
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingError, Element, Floor, FloorLoad, Outline, PDelta, Storey, StoreyStiffness,
};

const G: f64 = 9.81;

fn wall(x_m: f64, y_m: f64, [along_x, along_y]: [f64; 2]) -> Element {
    Element {
        stiffness_x_n_m: along_x,
        stiffness_y_n_m: along_y,
        stiffness_rotation_n_m_rad: 0.0,
        angle_degrees: 0.0,
        x_m,
        y_m,
    }
}

fn floor(mass_kg: f64, centre_m: [f64; 2]) -> Floor {
    Floor {
        mass_kg,
        centre_m,
        gyration_m: 3.0,
        outline: Some(Outline::rectangle([0.0, 0.0], 12.0, 10.0).unwrap()),
    }
}

fn storey(height_m: f64, walls: Vec<Element>) -> Storey {
    Storey {
        height_m,
        stiffness: StoreyStiffness::of_elements(walls).unwrap(),
    }
}

fn load(floor: usize, force_n: [f64; 2], at_m: Option<[f64; 2]>, torque_n_m: f64) -> FloorLoad {
    FloorLoad {
        floor,
        force_n,
        at_m,
        torque_n_m,
    }
}

fn near(value: f64, wanted: f64) {
    assert!(
        (value - wanted).abs() <= 1e-12 * wanted.abs().max(1e-12),
        "{value} {wanted}"
    );
}

/// Four equal walls at the corners of a square of side 8 m.
fn square(k: [f64; 2]) -> Vec<Element> {
    let quarter = k.map(|k| k / 4.0);
    vec![
        wall(-4.0, -4.0, quarter),
        wall(4.0, -4.0, quarter),
        wall(-4.0, 4.0, quarter),
        wall(4.0, 4.0, quarter),
    ]
}

#[test]
fn exact_a_shear_building_drifts_by_the_shear_over_the_stiffness() {
    let stiffness = [[60e6, 40e6], [50e6, 30e6], [20e6, 10e6]];
    let floors = (0..3).map(|_| floor(2e5, [0.0, 0.0])).collect();
    let storeys = stiffness.iter().map(|k| storey(3.0, square(*k))).collect();
    let building = Building::new(floors, storeys, PDelta::LeftOut).unwrap();
    let forces = [[30e3, -5e3], [20e3, 8e3], [10e3, 4e3]];
    let loads: Vec<FloorLoad> = (0..3).map(|i| load(i + 1, forces[i], None, 0.0)).collect();
    let q = building.under_loads(&loads).unwrap();
    let mut below = [0.0; 2];
    for (i, k) in stiffness.iter().enumerate() {
        for axis in 0..2 {
            let shear: f64 = forces[i..].iter().map(|force| force[axis]).sum();
            let drift = shear / k[axis];
            assert!(
                (q[3 * i + axis] - below[axis] - drift).abs() < 1e-12 * below[0].max(1e-3),
                "{q:?}"
            );
            below[axis] = q[3 * i + axis];
        }
        assert!(q[3 * i + 2].abs() < 1e-18, "{q:?}");
    }
}

#[test]
fn exact_a_torque_turns_the_floor_by_its_torsional_stiffness() {
    // k_θ = Σ k_x y² + k_y x² = 16 (60 + 40) MN m/rad
    let walls = || square([60e6, 40e6]);
    let building = Building::new(
        vec![floor(2e5, [0.0, 0.0])],
        vec![storey(3.0, walls())],
        PDelta::LeftOut,
    )
    .unwrap();
    let q = building.under_loads(&[load(1, [0.0; 2], None, 8e5)]).unwrap();
    near(q[2], 8e5 / 1.6e9);
    // a force along y 5 m to the right turns it from x towards y, a force along x 5 m up turns it back
    let both = [
        load(1, [0.0, 100e3], Some([5.0, 0.0]), 0.0),
        load(1, [80e3, 0.0], Some([0.0, 2.5]), 0.0),
    ];
    let q = building.under_loads(&both).unwrap();
    near(q[0], 80e3 / 60e6);
    near(q[1], 100e3 / 40e6);
    near(q[2], (5.0 * 100e3 - 2.5 * 80e3) / 1.6e9);
    // drift along y at the right edge, 6 m from the centre
    let [.., right] = building.edge_drift_rows(1).unwrap().unwrap();
    let drift: f64 = right.iter().zip(&q).map(|(a, b)| a * b).sum();
    near(drift, 100e3 / 40e6 + 6.0 * 300e3 / 1.6e9);
}

#[test]
fn exact_a_storey_with_its_walls_off_the_middle() {
    // k_x 50 at y −1.5; k_y 10 at x −4 and 30 at x 4, MN/m: a spring per wall
    let walls = vec![
        wall(0.0, -1.5, [50e6, 0.0]),
        wall(-4.0, 0.0, [0.0, 10e6]),
        wall(4.0, 0.0, [0.0, 30e6]),
    ];
    let building = Building::new(
        vec![floor(2e5, [0.0, 0.0])],
        vec![storey(3.0, walls)],
        PDelta::LeftOut,
    )
    .unwrap();
    let q = building
        .under_loads(&[load(1, [100e3, 200e3], Some([2.0, -1.0]), 0.0)])
        .unwrap();
    // 50 u + 75 θ = 0.1; 40 v + 80 θ = 0.2; 75 u + 80 v + 752.5 θ = 0.5 (MN, m)
    // u = 0.002 − 1.5 θ, v = 0.005 − 2 θ: 0.15 + 0.4 + (752.5 − 112.5 − 160) θ = 0.5
    let theta = -0.05 / 480.0;
    near(q[2], theta);
    near(q[0], 0.002 - 1.5 * theta);
    near(q[1], 0.005 - 2.0 * theta);
}

#[test]
fn exact_the_weight_adds_to_the_drift() {
    let p_delta = PDelta::Weights { gravity_m_s2: G };
    let building = Building::new(
        vec![floor(2e5, [0.0, 0.0])],
        vec![storey(3.0, square([5e6, 4e6]))],
        p_delta,
    )
    .unwrap();
    let q = building.under_loads(&[load(1, [100e3, 0.0], None, 0.0)]).unwrap();
    near(q[0], 100e3 / (5e6 - 2e5 * G / 3.0));
}

#[test]
fn refuses_a_floor_that_is_not_there_and_a_force_that_is_no_number() {
    let building = Building::new(
        vec![floor(2e5, [0.0, 0.0])],
        vec![storey(3.0, square([5e6, 4e6]))],
        PDelta::LeftOut,
    )
    .unwrap();
    let above = building.under_loads(&[load(2, [1.0, 0.0], None, 0.0)]);
    assert!(
        matches!(
            above,
            Err(BuildingError::Part {
                given: 2,
                most: 1,
                ..
            })
        ),
        "{above:?}"
    );
    let nan = building.under_loads(&[load(1, [1.0, f64::NAN], None, 0.0)]);
    assert!(matches!(nan, Err(BuildingError::Argument { .. })), "{nan:?}");
}

/// The displacement of a point of floor `i` along x and y, less that of the floor below.
fn drift_rows(floors: &[Floor], i: usize, [x, y]: [f64; 2]) -> [Vec<f64>; 2] {
    [0, 1].map(|axis| {
        let mut row = vec![0.0; 3 * floors.len()];
        for (floor, sign) in [(Some(i), 1.0), (i.checked_sub(1), -1.0)] {
            let Some(floor) = floor else { continue };
            let [x_c, y_c] = floors[floor].centre_m;
            row[3 * floor + axis] += sign;
            row[3 * floor + 2] += sign * if axis == 0 { y_c - y } else { x - x_c };
        }
        row
    })
}

fn add(k: &mut [Vec<f64>], row: &[f64], stiffness: f64) {
    for (i, a) in row.iter().enumerate() {
        for (j, b) in row.iter().enumerate() {
            k[i][j] += stiffness * a * b;
        }
    }
}

/// Elimination with the largest pivot of the column.
fn eliminated(mut k: Vec<Vec<f64>>, mut f: Vec<f64>) -> Vec<f64> {
    let n = f.len();
    for p in 0..n {
        let pivot = (p..n)
            .max_by(|a, b| k[*a][p].abs().total_cmp(&k[*b][p].abs()))
            .unwrap();
        k.swap(p, pivot);
        f.swap(p, pivot);
        let (pivot_row, pivot_f) = (k[p].clone(), f[p]);
        for i in p + 1..n {
            let factor = k[i][p] / pivot_row[p];
            k[i].iter_mut()
                .zip(&pivot_row)
                .for_each(|(a, b)| *a -= factor * b);
            f[i] -= factor * pivot_f;
        }
    }
    for i in (0..n).rev() {
        let known: f64 = (i + 1..n).map(|j| k[i][j] * f[j]).sum();
        f[i] = (f[i] - known) / k[i][i];
    }
    f
}

#[test]
fn agrees_200_buildings_drawn_by_a_seed() {
    let mut random = Random::new(20261128, 1);
    let mut within = |low: f64, high: f64| low + (high - low) * random.uniform();
    let mut twisted = 0;
    for case in 0..200 {
        let n = 1 + case % 8;
        let has_p_delta = case % 3 != 0;
        let floors: Vec<Floor> = (0..n)
            .map(|_| floor(within(5e4, 4e5), [within(-2.0, 2.0), within(-1.5, 1.5)]))
            .collect();
        let walls: Vec<Vec<Element>> = (0..n)
            .map(|_| {
                let each = (0..4 + case % 3).map(|corner| {
                    let side = |bit: usize| if corner >> bit & 1 == 0 { -1.0 } else { 1.0 };
                    let place = [side(0) * within(2.0, 6.0), side(1) * within(2.0, 5.0)];
                    Element {
                        angle_degrees: within(-60.0, 60.0),
                        stiffness_rotation_n_m_rad: within(0.0, 1e7),
                        ..wall(place[0], place[1], [within(3e7, 3e8), within(3e7, 3e8)])
                    }
                });
                each.collect()
            })
            .collect();
        let heights: Vec<f64> = (0..n).map(|_| within(2.5, 5.0)).collect();
        let mut k = vec![vec![0.0; 3 * n]; 3 * n];
        for i in 0..n {
            for of in &walls[i] {
                let [along_x, along_y] = drift_rows(&floors, i, [of.x_m, of.y_m]);
                let (sin, cos) = of.angle_degrees.to_radians().sin_cos();
                let turned = |a: f64, b: f64| -> Vec<f64> {
                    along_x.iter().zip(&along_y).map(|(x, y)| a * x + b * y).collect()
                };
                add(&mut k, &turned(cos, sin), of.stiffness_x_n_m);
                add(&mut k, &turned(-sin, cos), of.stiffness_y_n_m);
                let mut turn = vec![0.0; 3 * n];
                turn[3 * i + 2] = 1.0;
                if i > 0 {
                    turn[3 * i - 1] = -1.0;
                }
                add(&mut k, &turn, of.stiffness_rotation_n_m_rad);
            }
            // a quarter of the weight of each floor above at four points, its radius of gyration from its centre
            for above in floors[i..].iter().filter(|_| has_p_delta) {
                for [x, y] in [[3.0, 0.0], [-3.0, 0.0], [0.0, 3.0], [0.0, -3.0]] {
                    let at = [above.centre_m[0] + x, above.centre_m[1] + y];
                    let softening = -0.25 * above.mass_kg * G / heights[i];
                    drift_rows(&floors, i, at)
                        .iter()
                        .for_each(|row| add(&mut k, row, softening));
                }
            }
        }
        let mut f = vec![0.0; 3 * n];
        let loads: Vec<FloorLoad> = (0..1 + case % 4)
            .map(|l| {
                let index = (case * 7 + l * 3) % n;
                let force = [within(-2e5, 2e5), within(-2e5, 2e5)];
                let at = (l % 2 == 0).then(|| [within(-6.0, 6.0), within(-5.0, 5.0)]);
                let torque = within(-5e5, 5e5);
                let [x, y] = at.unwrap_or(floors[index].centre_m);
                let centre = floors[index].centre_m;
                f[3 * index] += force[0];
                f[3 * index + 1] += force[1];
                f[3 * index + 2] += torque + (x - centre[0]) * force[1] - (y - centre[1]) * force[0];
                load(index + 1, force, at, torque)
            })
            .collect();
        let storeys = walls
            .iter()
            .zip(&heights)
            .map(|(walls, height)| storey(*height, walls.clone()));
        let p_delta = match has_p_delta {
            true => PDelta::Weights { gravity_m_s2: G },
            false => PDelta::LeftOut,
        };
        let building = Building::new(floors.clone(), storeys.collect(), p_delta).unwrap();
        let q = building.under_loads(&loads).unwrap();
        let wanted = eliminated(k, f);
        let most = wanted.iter().fold(0.0_f64, |most, of| most.max(of.abs()));
        for (value, wanted) in q.iter().zip(&wanted) {
            assert!(
                (value - wanted).abs() < 1e-9 * most,
                "case {case}: {q:?} {wanted:?}"
            );
        }
        twisted += usize::from(q[3 * n - 1].abs() > 1e-3 * most);
    }
    assert!(twisted > 150, "{twisted}");
}
