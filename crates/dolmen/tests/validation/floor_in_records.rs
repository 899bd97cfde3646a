// SOURCE     Rigid motion of a floor by hand, u - θ y, v + θ x; the forward modes of `Building`; random floors by random rotations.
// GOAL       The modes of a record give stiffness and centre of rigidity of a storey in plan; without shapes, the bounds contain every
//            storey with these frequencies.
//
//        A   o-----------o B      sensors along x and y at A, B, along y at C:
//            |     e     |        φ = u d_x + v d_y + θ (d_y x − d_x y)
//            o-----------o C
//
// PARAMETERS 200 floors: 10 to 1000 t, ρ 2 to 12 m, centre of rigidity up to ρ/2 off, frequencies 0.5 to 5 Hz.
// PUBLISHED  Nothing.
// TOLERANCE  1e-7 times the amplification of a storey: rounding of shapes. Bounds 4 %: 40,000 draws do not fill a corner completely.

use crate::made_mode::made_mode;
use dolmen::modal::{Method, Mode, Modes};
use dolmen::numeric::Random;
use dolmen::signal::{Channel, Quantity};
use dolmen::structure::Building;
use dolmen::structure::building::{
    EccentricityFrom, Floor, FloorPlace, PDelta, PlanMode, PlanMotion, PlanStorey, Storey, StoreyStiffness,
    floor_modes, plan_bounds, plan_stiffness,
};
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

const HEIGHT_M: f64 = 4.5;
const CENTRE_M: [f64; 2] = [3.0, -2.0];

fn channel(name: &str, [x, y]: [f64; 2], direction: [f64; 3]) -> Channel {
    Channel {
        name: name.into(),
        quantity: Quantity::Acceleration,
        position_m: Some([x, y, HEIGHT_M]),
        direction: Some(direction),
    }
}

/// Two sensors at A, two at B, one at C; the second at B points the opposite way.
fn channels() -> Vec<Channel> {
    let (a, b, c) = ([-4.0, 2.0], [10.0, 2.5], [9.0, -6.0]);
    vec![
        channel("ax", a, [1.0, 0.0, 0.0]),
        channel("ay", a, [0.0, 1.0, 0.0]),
        channel("bx", b, [1.0, 0.0, 0.0]),
        channel("by", b, [0.0, -1.0, 0.0]),
        channel("cy", c, [0.0, 1.0, 0.0]),
    ]
}

/// The sensor record of a floor that moves by u, v and rotates by θ about its centre of mass; each shape has its own phase.
fn record(frequencies_hz: &[f64], motions: &[[f64; 3]], channels: &[Channel]) -> Modes {
    let mode = |(at, (frequency_hz, [u, v, theta])): (usize, (&f64, &[f64; 3]))| {
        let seen = channels.iter().map(|of| {
            let ([x, y, _], [d_x, d_y, _]) = (of.position_m.unwrap(), of.direction.unwrap());
            let (x, y) = (x - CENTRE_M[0], y - CENTRE_M[1]);
            d_x * (u - theta * y) + d_y * (v + theta * x)
        });
        let phase = Complex64::from_polar(1.0, 0.4 + at as f64);
        Mode {
            frequency_sd_hz: Some(0.001 * frequency_hz),
            shape_sd: Some(vec![0.01; channels.len()]),
            ..made_mode(*frequency_hz, seen.map(|x| phase * x).collect())
        }
    };
    Modes {
        modes: frequencies_hz.iter().zip(motions).enumerate().map(mode).collect(),
        channels: channels.to_vec(),
        method: Method::SsiCov,
        duration_s: 600.0,
        history: vec![],
    }
}

struct Drawn {
    storey: PlanStorey,
    stiffness: [f64; 3],
    frequencies_hz: [f64; 3],
    /// u, v, θ by mode.
    motions: [[f64; 3]; 3],
}

fn drawn(random: &mut Random) -> Drawn {
    let mut within = |low: f64, high: f64| low + (high - low) * random.uniform();
    let mass_kg = 10_f64.powf(within(4.0, 6.0));
    let gyration_m = within(2.0, 12.0);
    let mut k = || mass_kg * (TAU * within(0.5, 5.0)).powi(2);
    let stiffness = [k(), k(), k() * gyration_m * gyration_m];
    let e = [0, 1].map(|_| gyration_m * within(-0.5, 0.5));
    let floor = Floor {
        mass_kg,
        centre_m: CENTRE_M,
        gyration_m,
        outline: None,
    };
    let centre = [0, 1].map(|axis| CENTRE_M[axis] + e[axis]);
    let below = Storey {
        height_m: HEIGHT_M,
        stiffness: StoreyStiffness::at_centre(stiffness[0], stiffness[1], stiffness[2], centre),
    };
    let modes = Building::new(vec![floor], vec![below], PDelta::LeftOut)
        .unwrap()
        .modes()
        .unwrap()
        .modes;
    Drawn {
        storey: PlanStorey {
            mass_kg,
            gyration_m,
            weight_takes_n_m: 0.0,
            eccentricity_m: e,
        },
        stiffness,
        frequencies_hz: [0, 1, 2].map(|j| modes[j].frequency_hz),
        motions: [0, 1, 2].map(|j| [0, 1, 2].map(|i| modes[j].shape[i])),
    }
}

fn place(storey: &PlanStorey) -> FloorPlace {
    FloorPlace {
        height_m: HEIGHT_M,
        centre_m: CENTRE_M,
        gyration_m: storey.gyration_m,
    }
}

#[test]
fn holds_a_record_gives_back_stiffness_and_centre_of_rigidity_of_200_storeys() {
    let mut random = Random::new(20261126, 1);
    let mut alone = 0;
    for case in 0..200 {
        let of = drawn(&mut random);
        let found = floor_modes(
            &record(&of.frequencies_hz, &of.motions, &channels()),
            &place(&of.storey),
        )
        .unwrap();
        assert!(found.sensors == 5 && found.unexplained() < 1e-12, "{case}");
        // an unknown centre of rigidity
        let unknown = PlanStorey {
            eccentricity_m: [0.0; 2],
            ..of.storey
        };
        let plan = plan_stiffness(&unknown, &found.plan_modes()).unwrap();
        assert_eq!(plan.eccentricity_from, EccentricityFrom::Twists);
        let accepted: Vec<_> = plan.accepted().collect();
        let is_truth = |one: &&&dolmen::structure::building::PlanSolution| {
            let k = one.stiffness.iter().zip(&of.stiffness);
            let e = one.eccentricity_m.iter().zip(&of.storey.eccentricity_m);
            if let (true, Some(k_sd), Some(e_sd)) = (one.roots_meet, one.stiffness_sd, one.eccentricity_sd_m)
            {
                // it represents two solutions that coincide within the scatter: its interval contains the true value
                return k.zip(&k_sd).all(|((a, b), sd)| (a - b).abs() <= 1.96 * sd)
                    && e.zip(&e_sd).all(|((a, b), sd)| (a - b).abs() <= 1.96 * sd);
            }
            let most = 1e-7 * one.amplification.max(1.0);
            k.into_iter().all(|(a, b)| (a / b - 1.0).abs() < most)
                && e.into_iter()
                    .all(|(a, b)| (a - b).abs() < most * of.storey.gyration_m)
        };
        assert!(accepted.iter().any(|one| is_truth(&one)), "{case}: {accepted:?}");
        alone += usize::from(accepted.len() == 1);
    }
    assert!(alone >= 195, "{alone} of 200 have one accepted solution");
}

#[test]
fn holds_a_sensor_turned_round_is_seen_and_three_on_a_line_say_nothing() {
    let mut random = Random::new(20261126, 2);
    let mut seen = 0;
    for _ in 0..50 {
        let of = drawn(&mut random);
        let mut modes = record(&of.frequencies_hz, &of.motions, &channels());
        modes
            .modes
            .iter_mut()
            .for_each(|mode| mode.shape[3] = -mode.shape[3]);
        let unexplained = floor_modes(&modes, &place(&of.storey)).unwrap().unexplained();
        assert!(unexplained > 1e-6, "{unexplained}");
        seen += usize::from(unexplained > 0.05);
    }
    assert!(seen >= 25, "{seen} of 50");
    let of = drawn(&mut random);
    let along = [0.0, 4.0, 8.0].map(|x| channel("y", [x, 1.0], [0.0, 1.0, 0.0]));
    let line = record(&of.frequencies_hz, &of.motions, &along);
    assert_eq!(floor_modes(&line, &place(&of.storey)), None);
    let mut low = channels();
    low.iter_mut()
        .for_each(|of| of.position_m = of.position_m.map(|[x, y, _]| [x, y, 1.0]));
    let below = record(&of.frequencies_hz, &of.motions, &low);
    assert_eq!(floor_modes(&below, &place(&of.storey)), None);
}

/// A random rotation, from a quaternion.
fn rotation(random: &mut Random) -> [[f64; 3]; 3] {
    let q = [0; 4].map(|_| random.normal());
    let norm = q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = q.map(|c| c / norm);
    [
        [
            1.0 - 2.0 * (y * y + z * z),
            2.0 * (x * y - z * w),
            2.0 * (x * z + y * w),
        ],
        [
            2.0 * (x * y + z * w),
            1.0 - 2.0 * (x * x + z * z),
            2.0 * (y * z - x * w),
        ],
        [
            2.0 * (x * z - y * w),
            2.0 * (y * z + x * w),
            1.0 - 2.0 * (x * x + y * y),
        ],
    ]
}

#[test]
fn agrees_bounds_with_storeys_drawn_by_rotations_of_their_modes() {
    // any rotation Q gives K = Q Λ Qᵀ; rotating u, v to the axes of their own stiffness makes K_uv 0 and does not change the frequencies
    let mut random = Random::new(20261126, 3);
    let storey = PlanStorey {
        mass_kg: 150e3,
        gyration_m: 5.4467,
        weight_takes_n_m: 0.0,
        eccentricity_m: [0.0; 2],
    };
    let mode = |frequency_hz, motion| PlanMode {
        frequency_hz,
        frequency_sd_hz: 0.0,
        motion: Some(motion),
        twist: None,
        shape: None,
    };
    let modes = [
        mode(3.7, PlanMotion::Y),
        mode(4.63, PlanMotion::X),
        mode(7.31, PlanMotion::Torsion),
    ];
    let reach = [[-8.0, 8.0], [-5.0, 5.0]];
    let bounds = plan_bounds(&storey, &modes, Some(reach)).unwrap();
    let lambda = modes.map(|mode| (TAU * mode.frequency_hz).powi(2));
    let mut seen = [[f64::INFINITY, f64::NEG_INFINITY]; 5];
    let mut members = 0;
    for _ in 0..40_000 {
        let q = rotation(&mut random);
        let k = |i: usize, j: usize| (0..3).map(|m| lambda[m] * q[i][m] * q[j][m]).sum::<f64>();
        // axes of the 2 × 2 block of u and v, in either order
        let turn = 0.5 * (2.0 * k(0, 1)).atan2(k(0, 0) - k(1, 1));
        for turn in [turn, turn + 0.25 * TAU] {
            let (sin, cos) = turn.sin_cos();
            let shape = |m: usize| {
                [
                    cos * q[0][m] + sin * q[1][m],
                    -sin * q[0][m] + cos * q[1][m],
                    q[2][m],
                ]
            };
            let own = |i: usize, j: usize| (0..3).map(|m| lambda[m] * shape(m)[i] * shape(m)[j]).sum::<f64>();
            // the mode along y, along x and of torsion: no other motion has more than twice the energy of the named motion
            let moves = [1, 0, 2].iter().enumerate().all(|(m, axis)| {
                let energy = shape(m).map(|x| x * x);
                energy.iter().all(|other| *other <= 2.0 * energy[*axis])
            });
            let (m, rho) = (storey.mass_kg, storey.gyration_m);
            let e = [rho * own(1, 2) / own(1, 1), -rho * own(0, 2) / own(0, 0)];
            let is_on = e
                .iter()
                .zip(reach)
                .all(|(e, [least, most])| (least..=most).contains(e));
            if !moves || !is_on {
                continue;
            }
            members += 1;
            let theta = own(2, 2) - own(0, 2).powi(2) / own(0, 0) - own(1, 2).powi(2) / own(1, 1);
            let values = [m * own(0, 0), m * own(1, 1), m * rho * rho * theta, e[0], e[1]];
            for (seen, value) in seen.iter_mut().zip(values) {
                *seen = [seen[0].min(value), seen[1].max(value)];
            }
        }
    }
    assert!(members > 2000, "{members}");
    let all = bounds.stiffness.iter().chain(&bounds.eccentricity_m);
    for (at, (bound, seen)) in all.zip(&seen).enumerate() {
        let width = bound[1] - bound[0];
        assert!(
            seen[0] >= bound[0] - 1e-6 * width && seen[1] <= bound[1] + 1e-6 * width,
            "{at}: {seen:?} outside {bound:?}"
        );
        assert!(
            seen[0] - bound[0] < 0.04 * width && bound[1] - seen[1] < 0.04 * width,
            "{at}: {seen:?} reaches not {bound:?}"
        );
    }
}
