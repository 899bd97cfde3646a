// SOURCE     Choi (2021), Table 1: the stone flagpole of Naju, as five links on springs; mechanics of rigid bodies.
// GOAL       A chain moves according to its equations, with small and large rotations, until it falls.
//
//          /θ_2        Σ_j M_ij (cos(θ_i − θ_j) θ_j'' + sin(θ_i − θ_j) θ_j'²) = G_i sin θ_i − τ_i + τ_{i+1} − Γ_i a_g cos θ_i
//         o
//        /θ_1          τ_i = k_i (θ_i − θ_{i−1}), at most N_i b_i/2 in size where the joint opens
//     ==o==
//
// PARAMETERS in each test; g = 9.81 m/s², thin rods.
// AGREES     the double pendulum with Hamilton's equations in 22 digits: mpmath 1.4.1, see chain_motion_double_pendulum.py.
// TOLERANCE  1e-12 of the amplitude against closed forms, about a hundred times the measured difference; 1e-13 against the 22
//            digits, printed to 15; growth 1e-6, because samples are a millisecond apart and the push of 4e-4 rad is finite;
//            second order 1 %, because of the fourth order.

use dolmen::dynamics::{
    ChainHistory, ChainJoint, ChainModel, ChainOutcome, ChainRotations, ChainRun, DynamicsError,
    JointFriction, JointOpening, TimeFunction, chain_growth, simulate_chain,
};
use dolmen::known::choi_2021::{CENTROID_M, LENGTH_M, WEIGHT_KN, critical_stiffness};
use dolmen::known::pendulum::period_s;
use dolmen::signal::{Component, GroundMotion, response_spectrum};
use dolmen::structure::{Chain, Inertia, Link};
use dolmen_linalg::generalized_symmetric_eigen;
use std::f64::consts::{LN_2, PI, TAU};

const G: f64 = 9.81;

fn link(mass_kg: f64, length_m: f64, centroid_m: f64) -> Link {
    Link {
        mass_kg,
        length_m,
        centroid_m,
        inertia: Inertia::ThinRod,
        bed_width_m: Some(0.4),
    }
}

pub(super) fn flagpole() -> Chain {
    let each = WEIGHT_KN.iter().zip(LENGTH_M.iter().zip(CENTROID_M));
    let links = each.map(|(w, (length, centroid))| link(1e3 * w / G, *length, centroid));
    Chain::new(links.collect(), G).unwrap()
}

fn published() -> Vec<f64> {
    critical_stiffness(&WEIGHT_KN, &LENGTH_M, &CENTROID_M)
        .map(|k| 1e3 * k)
        .to_vec()
}

/// Eq. 43: weight above each joint times height above it.
pub(super) fn weight_times_height() -> Vec<f64> {
    let above = |i: usize| 1e3 * WEIGHT_KN[i..].iter().sum::<f64>() * LENGTH_M[i..].iter().sum::<f64>();
    (0..5).map(above).collect()
}

fn springs(chain: Chain, stiffness: &[f64], rotations: ChainRotations) -> ChainModel {
    let joints = stiffness.iter().map(|k| ChainJoint::spring(*k)).collect();
    ChainModel::new(chain, joints, rotations).unwrap()
}

fn run(model: &ChainModel, load: &TimeFunction, options: &ChainRun) -> ChainHistory {
    simulate_chain(model, load, options, &mut |_| true).unwrap()
}

fn from(rotation_rad: &[f64], duration_s: f64) -> ChainRun {
    ChainRun {
        duration_s: Some(duration_s),
        output_step_s: 0.01,
        start_rotation_rad: rotation_rad.to_vec(),
        ..ChainRun::default()
    }
}

pub(super) fn el_centro() -> GroundMotion {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .map(|line| 9.80665 * line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    GroundMotion::new("El Centro 1940 NS", 0.02, vec![(Component::X, samples.collect())]).unwrap()
}

/// The first time at which a link leans by more than `angle`, interpolated linearly in the logarithm.
fn reaches(history: &ChainHistory, link: usize, angle: f64) -> f64 {
    let rows = &history.rotation_rad[link];
    let i = rows.iter().position(|x| x.abs() >= angle).unwrap();
    let (low, high) = (rows[i - 1].abs().ln(), rows[i].abs().ln());
    let step = history.times_s[i] - history.times_s[i - 1];
    history.times_s[i - 1] + step * (angle.ln() - low) / (high - low)
}

#[test]
fn published_critical_stiffness_lets_the_pole_fall_and_weight_times_height_holds_it() {
    let chain = flagpole();
    let modes = generalized_symmetric_eigen(
        &chain.stiffness_matrix(&published()).unwrap(),
        &chain.mass_matrix(),
    )
    .unwrap();
    let growth = (-modes.values[0]).sqrt();
    let model = springs(chain.clone(), &published(), ChainRotations::Large);
    let history = run(&model, &TimeFunction::Zero, &from(&[1e-4; 5], 60.0));
    assert!(
        matches!(history.outcome, ChainOutcome::Fell { .. }),
        "{:?}",
        history.outcome
    );
    assert!(history.energy_left_over_ratio < 1e-12);
    // for any push, the fastest growing shape grows by the linear equations
    let found = chain_growth(&model, &history).unwrap().unwrap();
    let measured = found.measured.unwrap();
    assert!((found.linear_rate_per_s / growth - 1.0).abs() < 1e-12);
    let rate = measured.rate_per_s / growth;
    // cosh from 10 to 100: ln 10/(acosh 100 − acosh 10)
    let wanted = 10.0_f64.ln() / (100.0_f64.acosh() - 10.0_f64.acosh());
    assert!((rate - wanted).abs() < 1e-4, "{rate} {wanted}");
    // pushed along the fastest growing mode: from 2e-4 to 4e-4 as e^(growth t)
    let mode = modes.vectors.column(0);
    let most = mode
        .iter()
        .fold(0.0_f64, |a, b| if b.abs() > a.abs() { *b } else { a });
    let push: Vec<f64> = mode.iter().map(|x| 1e-4 * x / most).collect();
    let options = ChainRun {
        start_velocity_rad_s: push.iter().map(|x| growth * x).collect(),
        output_step_s: 0.001,
        ..from(&push, 60.0)
    };
    let history = run(&model, &TimeFunction::Zero, &options);
    let ChainOutcome::Fell { at_s, .. } = history.outcome else {
        panic!("{:?}", history.outcome)
    };
    let largest = mode.iter().position(|x| *x == most).unwrap();
    let doubling = reaches(&history, largest, 2e-4);
    assert!(
        (LN_2 / doubling / growth - 1.0).abs() < 1e-6,
        "{doubling} s, rate {growth}"
    );
    assert!(at_s > doubling);

    let stiffness: Vec<f64> = weight_times_height().iter().map(|k| 1.03 * k).collect();
    let held = springs(chain, &stiffness, ChainRotations::Large);
    let history = run(&held, &TimeFunction::Zero, &from(&[1e-4; 5], 100.0));
    assert_eq!(history.outcome, ChainOutcome::Stood);
    assert_eq!(chain_growth(&held, &history).unwrap(), None);
    let peak = history
        .rotation_peaks
        .iter()
        .map(|p| p.rotation_rad.abs())
        .fold(0.0, f64::max);
    assert!(peak < 5e-3, "{peak}");
}

#[test]
fn holds_energy_over_100_s_without_damping() {
    let chain = flagpole();
    let stiffness: Vec<f64> = chain.necessary_n_m_rad().iter().map(|k| 5.0 * k).collect();
    let model = springs(chain, &stiffness, ChainRotations::Large);
    let history = run(
        &model,
        &TimeFunction::Zero,
        &from(&[0.05, 0.1, 0.05, 0.1, 0.2], 100.0),
    );
    assert_eq!(history.outcome, ChainOutcome::Stood);
    assert!(
        history.energy_left_over_ratio < 1e-12,
        "{:e}",
        history.energy_left_over_ratio
    );
}

#[test]
fn exact_small_rotations_are_a_sum_of_modes() {
    let chain = flagpole();
    let stiffness: Vec<f64> = chain.necessary_n_m_rad().iter().map(|k| 5.0 * k).collect();
    let mass = chain.mass_matrix();
    let modes = generalized_symmetric_eigen(&chain.stiffness_matrix(&stiffness).unwrap(), &mass).unwrap();
    let start = [0.1, 0.25, -0.2, 0.3, -0.3];
    let (amplitude, frequency_hz) = (0.7, 0.9);
    let load = TimeFunction::Harmonic {
        amplitude,
        frequency_hz,
        phase_rad: 0.0,
    };
    let drive = TAU * frequency_hz;
    let gamma = chain.base_influence_kg_m();
    let model = springs(chain, &stiffness, ChainRotations::Small);
    let history = run(&model, &load, &from(&start, 20.0));
    let mut worst: f64 = 0.0;
    for (row, &t) in history.times_s.iter().enumerate() {
        let mut wanted = [0.0; 5];
        for (j, &square) in modes.values.iter().enumerate() {
            let (shape, omega) = (modes.vectors.column(j), square.sqrt());
            let held: f64 = mass.form(shape, &start);
            let pushed: f64 = gamma.iter().zip(shape).map(|(g, s)| g * s).sum();
            let forced = -pushed * amplitude / (square - drive * drive)
                * ((drive * t).sin() - drive / omega * (omega * t).sin());
            for (wanted, shape) in wanted.iter_mut().zip(shape) {
                *wanted += shape * (held * (omega * t).cos() + forced);
            }
        }
        for (i, wanted) in wanted.iter().enumerate() {
            worst = worst.max((history.rotation_rad[i][row] - wanted).abs());
        }
    }
    assert!(worst < 1e-12, "{worst:e}");
    assert!(
        history.energy_left_over_ratio < 1e-12,
        "{:e}",
        history.energy_left_over_ratio
    );
}

#[test]
fn exact_one_link_is_the_pendulum() {
    // from 1 rad from upright through hanging and back, without a spring
    let chain = Chain::new(vec![link(100.0, 3.0, 1.2)], G).unwrap();
    let omega = (chain.gravity_moments_n_m_rad()[0] / chain.mass_matrix()[(0, 0)]).sqrt();
    let period = period_s(PI - 1.0, omega);
    let model = springs(chain, &[0.0], ChainRotations::Large);
    let options = ChainRun {
        fall_rad: 10.0,
        ..from(&[1.0], 5.0 * period)
    };
    let history = run(&model, &TimeFunction::Zero, &options);
    assert!((history.rotation_peaks[0].rotation_rad - (TAU - 1.0)).abs() < 1e-11);
    // after full periods it is back: near the turning point only the rate shows the time
    let end = |rows: &[Vec<f64>]| rows[0][rows[0].len() - 1];
    assert!((end(&history.rotation_rad) - 1.0).abs() < 1e-10);
    assert!(end(&history.velocity_rad_s).abs() < 1e-10);
    // a quarter period earlier it hangs
    let options = ChainRun {
        duration_s: Some(4.75 * period),
        ..options
    };
    let history = run(&model, &TimeFunction::Zero, &options);
    assert!((end(&history.rotation_rad) - PI).abs() < 1e-10);
}

#[test]
fn exact_first_mode_has_the_damping_ratio_asked_for() {
    // for one link it is an exact oscillator: ln of two successive extrema is 2π ζ/√(1 − ζ²)
    let chain = Chain::new(vec![link(1000.0, 3.0, 1.5)], G).unwrap();
    let stiffness = 5.0 * chain.gravity_moments_n_m_rad()[0];
    let model = springs(chain, &[stiffness], ChainRotations::Small);
    let ratio = 0.03;
    let damped = model.clone().with_first_mode_damping(ratio).unwrap();
    let omega = ((stiffness - damped.chain().gravity_moments_n_m_rad()[0])
        / damped.chain().mass_matrix()[(0, 0)])
        .sqrt();
    let half_s = PI / (omega * (1.0 - ratio * ratio).sqrt());
    let history = run(&damped, &TimeFunction::Zero, &from(&[0.01], 2.0 * half_s));
    let last = *history.rotation_rad[0].last().unwrap();
    let wanted = 0.01 * (-TAU * ratio / (1.0 - ratio * ratio).sqrt()).exp();
    assert!((last - wanted).abs() < 1e-14, "{last} {wanted}");
    // for five links the first mode is its share of the motion: the ratio is accurate to a thousandth
    let stiffness: Vec<f64> = flagpole().necessary_n_m_rad().iter().map(|k| 5.0 * k).collect();
    let model = springs(flagpole(), &stiffness, ChainRotations::Small).with_first_mode_damping(ratio);
    let model = model.unwrap();
    let mass = model.chain().mass_matrix();
    let eigen =
        generalized_symmetric_eigen(&model.chain().stiffness_matrix(&stiffness).unwrap(), &mass).unwrap();
    let shape: Vec<f64> = eigen.vectors.column(0).iter().map(|x| 1e-3 * x).collect();
    let taken: f64 = (0..5)
        .map(|i| {
            let across = shape[i] - if i == 0 { 0.0 } else { shape[i - 1] };
            model.joints()[i].damping_n_m_s_rad * across * across
        })
        .sum();
    let wanted = 2.0 * ratio * eigen.values[0].sqrt() * mass.form(&shape, &shape);
    assert!((taken / wanted - 1.0).abs() < 1e-12, "{taken} {wanted}");
    let falls = springs(flagpole(), &published(), ChainRotations::Large);
    assert_eq!(
        falls.with_first_mode_damping(0.02).unwrap_err().to_string(),
        "damping_ratio is 0.02, but must be left out: the chain falls by itself and has no first mode; give dashpots instead"
    );
}

#[test]
fn holds_small_swings_are_linear_to_second_order() {
    let stiffness: Vec<f64> = flagpole().necessary_n_m_rad().iter().map(|k| 5.0 * k).collect();
    let at = |size: f64, rotations| {
        let start = [0.3, 0.6, 1.0, 0.5, -0.4].map(|x| size * x);
        let history = run(
            &springs(flagpole(), &stiffness, rotations),
            &TimeFunction::Zero,
            &from(&start, 2.0),
        );
        history.rotation_rad
    };
    let apart = |size: f64| {
        let (large, small) = (at(size, ChainRotations::Large), at(size, ChainRotations::Small));
        let rows = large.iter().flatten().zip(small.iter().flatten());
        rows.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) / size
    };
    let order = (apart(2e-2) / apart(1e-2)).log2();
    assert!((order - 2.0).abs() < 0.02, "{order}");
}

#[test]
fn agrees_double_pendulum_with_hamilton_in_22_digits() {
    let body = |mass_kg, length_m, centroid_m, inertia| Link {
        inertia: Inertia::Given(inertia),
        ..link(mass_kg, length_m, centroid_m)
    };
    let chain = Chain::new(vec![body(3.0, 1.5, 0.7, 0.6), body(2.0, 1.0, 0.5, 0.25)], G).unwrap();
    let model = springs(chain, &[40.0, 15.0], ChainRotations::Large);
    let wanted = [(1.0, PENDULUM[0]), (2.0, PENDULUM[1]), (3.0, PENDULUM[2])];
    for (duration_s, wanted) in wanted {
        let options = ChainRun {
            fall_rad: 10.0,
            ..from(&[0.9, -0.6], duration_s)
        };
        let history = run(&model, &TimeFunction::Zero, &options);
        for (rows, wanted) in history.rotation_rad.iter().zip(wanted) {
            let got = rows[rows.len() - 1];
            assert!((got - wanted).abs() < 1e-13, "{got} for {wanted}");
        }
    }
}

/// Rotations at 1, 2 and 3 s, rad.
const PENDULUM: [[f64; 2]; 3] = [
    [1.02861937106672, 1.09063956277908],
    [1.89820746873177, 2.23647878371381],
    [1.35144017620124, 0.556080878792203],
];

#[test]
fn exact_open_joint_closes_when_the_closed_form_says() {
    let chain = Chain::new(vec![link(1000.0, 3.0, 1.5)], G).unwrap();
    let (gravity, inertia) = (chain.gravity_moments_n_m_rad()[0], chain.mass_matrix()[(0, 0)]);
    let stiffness = 20.0 * gravity;
    let joint = ChainJoint {
        opening: JointOpening::AtBedEdge,
        ..ChainJoint::spring(stiffness)
    };
    let model = |rotations| ChainModel::new(chain.clone(), vec![joint], rotations).unwrap();
    let most = 1000.0 * G * 0.2;
    assert!((model(ChainRotations::Small).moment_most_n_m()[0] - most).abs() < 1e-9);
    // θ − m/G = (θ_0 − m/G) cosh(p t) until θ = m/k
    let (p, start) = ((gravity / inertia).sqrt(), 0.1);
    let closes = ((most / gravity - most / stiffness) / (most / gravity - start)).acosh() / p;
    let history = run(
        &model(ChainRotations::Small),
        &TimeFunction::Zero,
        &from(&[start], 20.0),
    );
    assert!(
        (history.uplifts[0].to_s - closes).abs() < 1e-12,
        "{} {closes}",
        history.uplifts[0].to_s
    );
    assert_eq!(history.outcome, ChainOutcome::Uplifted { joint: 0, at_s: 0.0 });
    // no energy is lost: it opens as far on the other side, and returns
    assert!(history.uplifts.len() > 10 && history.energy_left_over_ratio < 1e-12);
    assert!((history.rotation_peaks[0].rotation_rad.abs() - start).abs() < 1e-11);
    assert_eq!(
        history.joint_moment_peaks_n_m[0],
        model(ChainRotations::Small).moment_most_n_m()[0]
    );
    // it overturns where sin θ = m/G
    let edge = (most / gravity).asin();
    for (part, falls) in [(0.999, false), (1.001, true)] {
        let history = run(
            &model(ChainRotations::Large),
            &TimeFunction::Zero,
            &from(&[part * edge], 30.0),
        );
        assert_eq!(
            matches!(history.outcome, ChainOutcome::Fell { link: 0, .. }),
            falls,
            "{part}"
        );
        assert!(history.energy_left_over_ratio < 1e-12);
    }
}

#[test]
fn agrees_one_link_with_the_response_spectrum_of_el_centro() {
    let motion = el_centro();
    let chain = Chain::new(vec![link(1000.0, 3.0, 1.5)], G).unwrap();
    let (gravity, inertia) = (chain.gravity_moments_n_m_rad()[0], chain.mass_matrix()[(0, 0)]);
    let gamma = chain.base_influence_kg_m()[0];
    let load = TimeFunction::of_motion(&motion, Component::X);
    for period in [0.3, 1.0, 2.0] {
        let omega = TAU / period;
        let joint = ChainJoint {
            stiffness_n_m_rad: omega * omega * inertia + gravity,
            damping_n_m_s_rad: 2.0 * 0.02 * omega * inertia,
            opening: JointOpening::Held,
            friction: JointFriction::None,
        };
        let model = ChainModel::new(chain.clone(), vec![joint], ChainRotations::Small).unwrap();
        let history = run(&model, &load, &ChainRun::default());
        let wanted = response_spectrum(&motion, Component::X, &[period], 0.02).unwrap()[0].displacement_m;
        let got = history.rotation_peaks[0].rotation_rad.abs() * inertia / gamma;
        assert!((got / wanted - 1.0).abs() < 1e-12, "{got} for {wanted}");
        assert!(
            history.energy_left_over_ratio < 1e-12,
            "{:e}",
            history.energy_left_over_ratio
        );
    }
}

/// Five links with dashpots and opening beds, under the whole record.
fn shaken_flagpole(factor: f64) -> ChainHistory {
    let chain = flagpole();
    let joints = weight_times_height().into_iter().map(|k| ChainJoint {
        stiffness_n_m_rad: 5.0 * k,
        damping_n_m_s_rad: 0.02 * k,
        opening: JointOpening::AtBedEdge,
        friction: JointFriction::None,
    });
    let model = ChainModel::new(chain, joints.collect(), ChainRotations::Large).unwrap();
    let motion = el_centro();
    let samples: Vec<f64> = motion
        .acceleration_m_s2(Component::X)
        .iter()
        .map(|a| factor * a)
        .collect();
    let load = TimeFunction::Sampled {
        time_step_s: 0.02,
        values: samples,
    };
    run(&model, &load, &ChainRun::default())
}

#[test]
fn holds_energy_and_bits_through_an_earthquake_with_joints_that_open() {
    let (weak, strong, whole) = (shaken_flagpole(0.02), shaken_flagpole(0.3), shaken_flagpole(1.0));
    assert_eq!(weak.outcome, ChainOutcome::Stood);
    assert!(weak.uplifts.is_empty());
    assert!(
        matches!(strong.outcome, ChainOutcome::Uplifted { .. }),
        "{:?}",
        strong.outcome
    );
    assert!(strong.uplifts.len() > 10);
    assert!(
        matches!(whole.outcome, ChainOutcome::Fell { .. }),
        "{:?}",
        whole.outcome
    );
    for history in [&weak, &strong, &whole] {
        assert!(
            history.energy_left_over_ratio < 1e-12,
            "{:e}",
            history.energy_left_over_ratio
        );
        // also at every sample, which lies inside steps
        let kinetic = history.energy.iter().map(|e| e.kinetic_j).fold(0.0, f64::max);
        assert!(
            history
                .energy
                .iter()
                .all(|e| e.left_over_j().abs() < 1e-12 * kinetic)
        );
    }
    assert_eq!(strong, shaken_flagpole(0.3));
}

#[test]
fn refuses_what_cannot_move() {
    let chain = flagpole();
    let message = |error: DynamicsError| error.to_string();
    let few = ChainModel::new(
        chain.clone(),
        vec![ChainJoint::spring(1.0)],
        ChainRotations::Large,
    );
    assert_eq!(
        message(few.unwrap_err()),
        "joints has 1 entries, but the chain has 5 links: give one for each"
    );
    let bad = ChainModel::new(
        chain.clone(),
        vec![ChainJoint::spring(-1.0); 5],
        ChainRotations::Large,
    );
    assert_eq!(
        message(bad.unwrap_err()),
        "joint 5: stiffness_n_m_rad is -1, but must be 0 or a positive number"
    );
    let model = springs(chain, &published(), ChainRotations::Large);
    let refused = |options: &ChainRun| {
        message(simulate_chain(&model, &TimeFunction::Zero, options, &mut |_| true).unwrap_err())
    };
    assert_eq!(
        refused(&from(&[0.0, f64::NAN, 0.0, 0.0, 0.0], 1.0)),
        "link 2: start_rotation_rad is NaN, but must be a number below fall_rad in size"
    );
    assert_eq!(
        refused(&ChainRun::default()),
        "duration_s is 0, but must be a positive number: give it where no sampled load does"
    );
    let endless = ChainRun {
        output_step_s: 1e-6,
        ..from(&[], 1e4)
    };
    assert_eq!(
        refused(&endless),
        "output_step_s is 0.000001, but must be long enough for ten million samples at most in the run"
    );
    assert_eq!(
        refused(&from(&[], 1e12)),
        "duration_s is 1000000000000, but must be at most 100 000 s, which is more than a day"
    );
    let stiffness: Vec<f64> = weight_times_height().iter().map(|k| 2.0 * k).collect();
    let held = springs(flagpole(), &stiffness, ChainRotations::Large);
    let options = from(&[1e-3; 5], 100.0);
    let stopped = simulate_chain(&held, &TimeFunction::Zero, &options, &mut |at_s| at_s < 5.0).unwrap();
    let ChainOutcome::Stopped { at_s } = stopped.outcome else {
        panic!("{:?}", stopped.outcome)
    };
    assert!((5.0..100.0).contains(&at_s) && stopped.times_s.last() == Some(&at_s));
}
