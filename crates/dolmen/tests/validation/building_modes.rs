// SOURCE     Hwang, Min, Hong: Control of coupled lateral torsional vibration of tall building under dynamic lateral loads,
//            Table 1 and eq. 12; closed forms of one floor.
// GOAL       Frequencies, shapes and mode centres of a floor with eccentric stiffness; laws for matrices and modes of buildings
//            with any number of floors.
// PARAMETERS 10 × 8 m, k_x = 2.2821², k_y = 0.7 k_x over the mass, centre of rigidity 1.5 m left of the middle.
// PUBLISHED  ω = 1.8471, 2.2821, 3.6056 rad/s; r_x = −23.378, –, 0.5845 m.
// TOLERANCE  half a unit of the last printed digit, but one unit for 3.6056 (3.60553) and 0.5845 (0.58459); closed forms 1e-12.

use dolmen::known::hwang_min_hong as paper;
use dolmen::numeric::Random;
use dolmen::structure::Building;
use dolmen::structure::building::{
    BuildingDamping, BuildingError, DampingAnchor, Element, Floor, Outline, PDelta, PlanDirection, Storey,
    StoreyMotion, StoreyStiffness, storey_falls,
};
use dolmen_linalg::Matrix;

fn twisting_floor() -> Building {
    dolmen::comparisons::twisting_floor(1000.0).unwrap()
}

#[test]
fn published_table_1_of_the_twisting_floor() {
    let modes = twisting_floor().modes().unwrap().modes;
    for (mode, (published, tolerance)) in modes
        .iter()
        .zip(paper::OMEGA_RAD_S.iter().zip([0.5e-4, 0.5e-4, 1e-4]))
    {
        assert!(
            (mode.omega_rad_s - published).abs() < tolerance,
            "{}",
            mode.omega_rad_s
        );
    }
    for (mode, known) in modes.iter().zip([1.84707, 2.28210, 3.60553]) {
        assert!((mode.omega_rad_s - known).abs() < 0.5e-5, "{}", mode.omega_rad_s);
    }
    let radius = |mode: usize| modes[mode].centres[0].map(|c| c.r_x_m);
    let (first, third) = (radius(0).unwrap(), radius(2).unwrap());
    assert!(
        (first + 23.3782).abs() < 0.5e-4 && (first - paper::RADIUS_M[0]).abs() < 0.5e-3,
        "{first}"
    );
    assert!(
        (third - 0.58459).abs() < 0.5e-5 && (third - paper::RADIUS_M[1]).abs() < 1e-4,
        "{third}"
    );
    assert_eq!(modes[1].centres[0], None, "mode 2 moves along x alone");
    assert!(
        (first * third + paper::GYRATION_SQUARED_M2).abs() < 1e-11,
        "{}",
        first * third
    );
    // Table 1 to its norm: 5.10 in mode 2
    let norm = 5.10 / modes[1].shape[0];
    for (mode, known) in [(0, [5.037, 0.2155]), (2, [0.7966, 1.3626])] {
        let shape = &modes[mode].shape;
        assert!(
            (norm * shape[1].abs() - known[0]).abs() < 2e-3,
            "{}",
            norm * shape[1]
        );
        assert!(
            (norm * shape[2].abs() - known[1]).abs() < 2e-4,
            "{}",
            norm * shape[2]
        );
    }
}

#[test]
fn exact_mixed_modes_of_one_floor() {
    let modes = twisting_floor().modes().unwrap().modes;
    let known = paper::mixed_modes(
        paper::STIFFNESS[1],
        paper::RIGIDITY_X_M,
        paper::rotation(),
        paper::GYRATION_SQUARED_M2,
    );
    for (mode, known) in [&modes[0], &modes[2]].into_iter().zip(known) {
        assert!((mode.omega_rad_s / known.omega_rad_s - 1.0).abs() < 1e-13);
        assert!((mode.centres[0].unwrap().r_x_m / known.radius_m - 1.0).abs() < 1e-12);
    }
    // share of energy in rotation: ρ²/(ρ² + r²)
    let share = paper::GYRATION_SQUARED_M2 / (paper::GYRATION_SQUARED_M2 + known[0].radius_m.powi(2));
    assert!((modes[0].energy_shares[2] - share).abs() < 1e-13);
    assert!((modes[0].coupling - 2.0 * share).abs() < 1e-13);
    assert!(modes[1].coupling < 1e-20 && !modes[1].repeated);
}

/// A building of three floors with setbacks and rotations, with walls at all angles.
fn stepped(random: &mut Random, shift: [f64; 2], p_delta: PDelta) -> (Building, Vec<Vec<Element>>) {
    let (mut floors, mut storeys, mut all) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..3 {
        let reach = 6.0 - f64::from(i);
        let centre = [shift[0] + 0.7 * f64::from(i), shift[1] - 0.4 * f64::from(i)];
        let outline = Outline::rectangle(centre, 2.0 * reach, 1.5 * reach).unwrap();
        floors.push(Floor {
            centre_m: [centre[0] + 0.3, centre[1] - 0.2],
            ..Floor::uniform(2e4 * (1.0 + random.uniform()), outline)
        });
        let walls: Vec<Element> = (0..5)
            .map(|_| Element {
                x_m: centre[0] + reach * (2.0 * random.uniform() - 1.0),
                y_m: centre[1] + 0.7 * reach * (2.0 * random.uniform() - 1.0),
                stiffness_x_n_m: 2e7 * random.uniform(),
                stiffness_y_n_m: 3e6 * random.uniform(),
                stiffness_rotation_n_m_rad: 1e6 * random.uniform(),
                angle_degrees: 180.0 * random.uniform(),
            })
            .collect();
        all.push(walls.clone());
        storeys.push(Storey {
            height_m: 3.5,
            stiffness: StoreyStiffness::of_elements(walls).unwrap(),
        });
    }
    (Building::new(floors, storeys, p_delta).unwrap(), all)
}

#[test]
fn holds_stiffness_is_the_sum_of_springs_between_points() {
    // each wall is a pair of springs between a point of the floor above and the same point of the floor below
    let mut random = Random::new(31, 0);
    let (building, walls) = stepped(&mut random, [0.0, 0.0], PDelta::LeftOut);
    let open: Vec<Floor> = building
        .floors()
        .iter()
        .map(|floor| Floor {
            outline: None,
            ..floor.clone()
        })
        .collect();
    let open = Building::new(open, building.storeys().to_vec(), PDelta::LeftOut).unwrap();
    let n = open.coordinates();
    let mut sum = Matrix::zeros(n, n);
    for (s, walls) in walls.iter().enumerate() {
        for wall in walls {
            let mut spring = |upper: Vec<f64>, lower: Option<Vec<f64>>, k: f64| {
                let lower = lower.unwrap_or_else(|| vec![0.0; n]);
                let row: Vec<f64> = upper.iter().zip(&lower).map(|(a, b)| a - b).collect();
                for i in 0..n {
                    for j in 0..n {
                        sum[(i, j)] += k * row[i] * row[j];
                    }
                }
            };
            for (turn, k) in [(0.0, wall.stiffness_x_n_m), (90.0, wall.stiffness_y_n_m)] {
                let direction = PlanDirection::Degrees(wall.angle_degrees + turn);
                let row = |floor| open.point_row(floor, wall.x_m, wall.y_m, direction).unwrap();
                spring(row(s + 1), (s > 0).then(|| row(s)), k);
            }
            let row = |floor| open.rotation_row(floor).unwrap();
            spring(
                row(s + 1),
                (s > 0).then(|| row(s)),
                wall.stiffness_rotation_n_m_rad,
            );
        }
    }
    let k = building.stiffness_matrix();
    let largest = k.as_slice().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in k.as_slice().iter().zip(sum.as_slice()) {
        assert!((a - b).abs() < 1e-14 * largest, "{a} {b}");
    }
    assert_eq!(k, k.transpose());
}

#[test]
fn holds_weight_takes_what_its_columns_take() {
    // the weight of each floor distributed over four columns with the same centre and radius of gyration
    let mut random = Random::new(33, 0);
    let gravity_m_s2 = 9.81;
    let (heavy, _) = stepped(&mut random, [3.0, 4.0], PDelta::Weights { gravity_m_s2 });
    let light = Building::new(heavy.floors().to_vec(), heavy.storeys().to_vec(), PDelta::LeftOut).unwrap();
    let taken = &light.stiffness_matrix() - &heavy.stiffness_matrix();
    let open = |floor: &Floor| Floor {
        outline: None,
        ..floor.clone()
    };
    let free = Building::new(
        light.floors().iter().map(open).collect(),
        light.storeys().to_vec(),
        PDelta::LeftOut,
    )
    .unwrap();
    let n = free.coordinates();
    let mut sum = Matrix::zeros(n, n);
    for floor in free.floors().iter().enumerate() {
        let (j, part) = floor;
        for (dx, dy) in [(1.0, 0.0), (-1.0, 0.0), (0.0, 1.0), (0.0, -1.0)] {
            let at = [
                part.centre_m[0] + dx * part.gyration_m,
                part.centre_m[1] + dy * part.gyration_m,
            ];
            for s in 0..=j {
                for direction in [PlanDirection::X, PlanDirection::Y] {
                    let row = |floor| free.point_row(floor, at[0], at[1], direction).unwrap();
                    let lower = if s > 0 { row(s) } else { vec![0.0; n] };
                    let drift: Vec<f64> = row(s + 1).iter().zip(lower).map(|(a, b)| a - b).collect();
                    let k = 0.25 * part.mass_kg * gravity_m_s2 / free.storeys()[s].height_m;
                    for a in 0..n {
                        for b in 0..n {
                            sum[(a, b)] += k * drift[a] * drift[b];
                        }
                    }
                }
            }
        }
    }
    let largest = sum.as_slice().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    let stiffest = light
        .stiffness_matrix()
        .as_slice()
        .iter()
        .fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in taken.as_slice().iter().zip(sum.as_slice()) {
        assert!((a - b).abs() < 1e-13 * largest + 1e-15 * stiffest, "{a} {b}");
    }
}

#[test]
fn holds_modes_are_orthonormal_and_effective_masses_sum_to_the_whole() {
    let mut random = Random::new(35, 0);
    for _ in 0..20 {
        let p_delta = PDelta::Weights { gravity_m_s2: 9.81 };
        let (building, _) = stepped(&mut random, [2.0, -7.0], p_delta);
        let modes = building.modes().unwrap();
        let unit = modes
            .shapes
            .transpose_times(&(&building.mass_matrix() * &modes.shapes));
        let apart = modes
            .shapes
            .transpose_times(&(&building.stiffness_matrix() * &modes.shapes));
        let highest = modes.modes[8].omega_rad_s.powi(2);
        for i in 0..9 {
            for j in 0..9 {
                let own = if i == j { 1.0 } else { 0.0 };
                assert!((unit[(i, j)] - own).abs() < 1e-13);
                let stiffness = own * modes.modes[i].omega_rad_s.powi(2);
                assert!((apart[(i, j)] - stiffness).abs() < 1e-12 * highest);
            }
        }
        for axis in 0..3 {
            let sum: f64 = modes.modes.iter().map(|mode| mode.effective_mass[axis]).sum();
            assert!((sum / modes.total_mass[axis] - 1.0).abs() < 1e-12);
        }
        assert!((modes.total_mass[0] / building.mass_kg() - 1.0).abs() < 1e-14);
    }
}

#[test]
fn holds_frequencies_do_not_depend_on_where_the_plan_has_its_origin() {
    let frequencies = |shift| {
        let mut random = Random::new(37, 0);
        let p_delta = PDelta::Weights { gravity_m_s2: 9.81 };
        stepped(&mut random, shift, p_delta).0.modes().unwrap()
    };
    let (near, far) = (frequencies([0.0, 0.0]), frequencies([3.2e5, 4.1e6]));
    for (a, b) in near.modes.iter().zip(&far.modes) {
        // coordinates of a map have a precision of 1e-9 m there
        assert!((a.omega_rad_s / b.omega_rad_s - 1.0).abs() < 1e-8);
        let centre = |m: &dolmen::structure::building::BuildingMode| m.centres[2].unwrap();
        assert!((centre(a).x_m + 3.2e5 - centre(b).x_m).abs() < 1e-5 * centre(a).r_x_m.abs().max(1.0));
    }
}

#[test]
fn exact_one_storey_falls_by_sway_or_by_twist() {
    // λ = k h/W along the weaker axis, and k_θ h/(W ρ²) about the centre
    let gravity_m_s2 = 10.0;
    let of = |rotation: f64| {
        let floor = Floor {
            mass_kg: 500.0,
            centre_m: [2.0, 3.0],
            gyration_m: 2.0,
            outline: None,
        };
        let stiffness = StoreyStiffness::at_centre(9e3, 6e3, rotation, [2.0, 3.0]);
        let storey = Storey {
            height_m: 4.0,
            stiffness,
        };
        let falls = storey_falls(
            std::slice::from_ref(&floor),
            std::slice::from_ref(&storey),
            gravity_m_s2,
        )
        .unwrap();
        let building = Building::new(vec![floor], vec![storey], PDelta::Weights { gravity_m_s2 });
        (falls[0], building)
    };
    let (sways, stands) = of(8e3);
    assert!((sways.load_factor - 1.6).abs() < 1e-13 && sways.motion() == StoreyMotion::Twists);
    let omega = stands.unwrap().modes().unwrap().modes[0].omega_rad_s;
    assert!((omega * omega - (8e3 - 5e3) / (500.0 * 4.0)).abs() < 1e-12); // (k_θ − W ρ²/h)/(m ρ²)
    let (sways, _) = of(8e4);
    assert!((sways.load_factor - 4.8).abs() < 1e-13 && sways.motion() == StoreyMotion::Sways);
    let (twists, falls) = of(4e3);
    assert!((twists.load_factor - 0.8).abs() < 1e-13);
    assert_eq!(
        falls.unwrap_err().to_string(),
        "the building falls: storey 1 twists under 0.8000 of the weight above it (P-delta); it needs stiffer walls there, a \
         lower weight or a lower storey"
    );
}

#[test]
fn exact_rayleigh_and_caughey_are_of_mass_and_stiffness() {
    let mut random = Random::new(39, 0);
    let (building, _) = stepped(&mut random, [0.0, 0.0], PDelta::LeftOut);
    let modes = building.modes().unwrap();
    let anchor = |mode: usize, damping_ratio| DampingAnchor {
        frequency_hz: modes.modes[mode].frequency_hz,
        damping_ratio,
    };
    let rayleigh = BuildingDamping::Rayleigh([anchor(0, 0.02), anchor(4, 0.03)]);
    let (w, v) = (modes.modes[0].omega_rad_s, modes.modes[4].omega_rad_s);
    // Chopra (2017), eq. 11.4.9
    let determinant = 0.25 * (v / w - w / v);
    let mass = (0.02 * v - 0.03 * w) * 0.5 / determinant;
    let stiff = (0.03 / w - 0.02 / v) * 0.5 / determinant;
    let expected = &building.mass_matrix().scaled(mass) + &building.stiffness_matrix().scaled(stiff);
    let c = building.damping_matrix(&rayleigh).unwrap();
    let largest = c.as_slice().iter().fold(0.0_f64, |most, x| most.max(x.abs()));
    for (a, b) in c.as_slice().iter().zip(expected.as_slice()) {
        assert!((a - b).abs() < 1e-12 * largest, "{a} {b}");
    }
    // Caughey damping through two modes equals Rayleigh damping through the same modes
    let caughey = modes
        .damping_ratios(&BuildingDamping::Caughey(vec![0.02, 0.025]))
        .unwrap();
    let rayleigh = BuildingDamping::Rayleigh([anchor(0, 0.02), anchor(1, 0.025)]);
    for (a, b) in caughey.iter().zip(modes.damping_ratios(&rayleigh).unwrap()) {
        assert!((a / b - 1.0).abs() < 1e-10, "{a} {b}");
    }
    let four = vec![0.02, 0.02, 0.02, 0.02];
    let refused = modes.damping_ratios(&BuildingDamping::Caughey(four)).unwrap_err();
    assert!(matches!(refused, BuildingError::Damping { .. }), "{refused}");
    assert!(refused.to_string().contains("runs away"), "{refused}");
    let percent = modes
        .damping_ratios(&BuildingDamping::Modal(vec![2.0]))
        .unwrap_err();
    assert_eq!(
        percent.to_string(),
        "damping_ratio is 2, but must be 0 to 0.95: is it in percent?"
    );
}

#[test]
fn refuses_what_is_no_building() {
    let building = twisting_floor();
    let (floors, storeys) = (building.floors().to_vec(), building.storeys().to_vec());
    let message = |floors: Vec<Floor>, storeys: Vec<Storey>| {
        Building::new(floors, storeys, PDelta::LeftOut)
            .unwrap_err()
            .to_string()
    };
    assert!(message(Vec::new(), Vec::new()).contains("no floors"));
    assert!(message(floors.clone(), Vec::new()).contains("0 storeys and 1 floors"));
    let mut heavy = floors.clone();
    heavy[0].mass_kg = -1.0;
    assert_eq!(
        message(heavy, storeys.clone()),
        "floor 1: mass_kg is -1, but must be a positive number"
    );
    let mut off = floors.clone();
    off[0].centre_m = [9.0, 0.0];
    assert!(message(off, storeys.clone()).contains("4.000 m outside the outline of floor 1"));
    let mut wide = floors;
    wide[0].gyration_m = 7.0;
    assert!(message(wide, storeys).contains("gyration_m is 7"));
    let outside = building.point_row(1, 5.0, 4.5, PlanDirection::X).unwrap_err();
    assert_eq!(
        outside.to_string(),
        "the point (5, 4.5) m lies 0.500 m outside the outline of floor 1: give a point on the floor"
    );
    assert!(building.point_row(2, 0.0, 0.0, PlanDirection::X).is_err());
    let row = building
        .point_row(1, -5.0, 4.0, PlanDirection::Degrees(90.0))
        .unwrap();
    assert_eq!(row, [0.0, 1.0, -5.0]);
    assert_eq!(
        building.point_row(1, -5.0, 4.0, PlanDirection::X).unwrap(),
        [1.0, 0.0, -4.0]
    );
}
