// SOURCE     Coulomb's law in the joints of a chain; mechanics of rigid bodies. No paper treats this case.
// GOAL       Joints stick, slip and reverse exactly according to the law, with small and large rotations.
//
//          /θ_2        M θ'' … = … − τ_i − q_i + τ_{i+1} + q_{i+1}
//         o  φ_2       q_i = f_k sign φ_i' while joint i turns; while it sticks φ_i' = 0 and |q_i| ≤ f_s
//        /θ_1
//     ==o==  φ_1
//
// PARAMETERS in each test; g = 9.81 m/s².
// AGREES     two links in four states, and three with static moments above the kinetic ones, with SciPy 1.17.1 (DOP853, rtol 3e-14 and
//            1e-13) from event to event: see chain_friction_two_links.py and chain_friction_three_links.py.
// TOLERANCE  1e-12 of the amplitude against closed forms; 1e-11 and 1e-10 against SciPy, about ten times the error of its steps.

use crate::draws::Draws;
use dolmen::dynamics::{
    ChainHistory, ChainJoint, ChainModel, ChainOutcome, ChainRotations, ChainRun, JointFriction,
    JointOpening, TimeFunction, simulate_chain,
};
use dolmen::structure::{Chain, Inertia, Link};
use std::f64::consts::{PI, TAU};

const G: f64 = 9.81;

fn link(mass_kg: f64, length_m: f64, centroid_m: f64, inertia_kg_m2: f64) -> Link {
    Link {
        mass_kg,
        length_m,
        centroid_m,
        inertia: Inertia::Given(inertia_kg_m2),
        bed_width_m: Some(0.4),
    }
}

fn one() -> Chain {
    Chain::new(vec![link(100.0, 3.0, 1.2, 80.0)], G).unwrap()
}

fn rubbing(stiffness_n_m_rad: f64, friction: JointFriction) -> ChainJoint {
    ChainJoint {
        friction,
        ..ChainJoint::spring(stiffness_n_m_rad)
    }
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

fn el_centro(factor: f64) -> TimeFunction {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text.lines().skip(1);
    TimeFunction::Sampled {
        time_step_s: 0.02,
        values: samples
            .map(|line| factor * 9.80665 * line.split_once(',').unwrap().1.parse::<f64>().unwrap())
            .collect(),
    }
}

#[test]
fn exact_free_decay_loses_two_f_over_kappa_every_half_cycle() {
    let (gravity, inertia) = (one().gravity_moments_n_m_rad()[0], one().mass_matrix()[(0, 0)]);
    let kappa = 4.0 * gravity;
    let (start, step) = (0.093, 0.02); // 2 f/κ = 0.02: 0.093 −0.073 0.053 −0.033 0.013 0.007: rests at −(0.013 − 0.02)
    let friction = JointFriction::coulomb(0.5 * step * kappa);
    let model = ChainModel::new(
        one(),
        vec![rubbing(kappa + gravity, friction)],
        ChainRotations::Small,
    )
    .unwrap();
    let history = run(&model, &TimeFunction::Zero, &from(&[start], 30.0));
    let half = PI / (kappa / inertia).sqrt();
    assert_eq!(history.slips.len(), 5, "{:?}", history.slips);
    let mut amplitude = start;
    for (i, slip) in history.slips.iter().enumerate() {
        let way = (2.0 * amplitude - step) * if i % 2 == 0 { -1.0 } else { 1.0 };
        assert!(
            (slip.slip_rad - way).abs() < 1e-13,
            "{i}: {} {way}",
            slip.slip_rad
        );
        assert!(
            (slip.from_s - i as f64 * half).abs() < 1e-12,
            "{i}: {}",
            slip.from_s
        );
        assert!((slip.to_s - slip.from_s - half).abs() < 1e-12);
        amplitude -= step;
    }
    let rests = *history.rotation_rad[0].last().unwrap();
    assert!((rests - 0.007).abs() < 1e-13, "{rests}");
    assert!(
        history.at_rest && history.friction_events == 6,
        "{}",
        history.friction_events
    );
    // friction balances the difference between spring and weight
    let held = *history.friction_moment_n_m[0].last().unwrap();
    assert!((held + kappa * rests).abs() < 1e-9, "{held}");
    let friction_j = history.energy.last().unwrap().friction_j;
    let way: f64 = history.slips.iter().map(|slip| slip.slip_rad.abs()).sum();
    assert!((friction_j / (0.5 * step * kappa * way) - 1.0).abs() < 1e-13);
    assert!(history.energy_left_over_ratio < 1e-13);
}

#[test]
fn exact_large_swings_turn_where_the_energy_is_spent() {
    // ½ k A² − G (1 − cos A) decreases by f times the path
    let gravity = one().gravity_moments_n_m_rad()[0];
    let (k, f) = (3.0 * gravity, 0.05 * gravity);
    let model = ChainModel::new(
        one(),
        vec![rubbing(k, JointFriction::coulomb(f))],
        ChainRotations::Large,
    )
    .unwrap();
    let history = run(&model, &TimeFunction::Zero, &from(&[0.9], 60.0));
    let stored = |a: f64| 0.5 * k * a * a - gravity * (1.0 - a.cos());
    let mut before = 0.9;
    for slip in &history.slips {
        let after = slip.slip_rad.abs() - before;
        let fault = stored(before) - stored(after) - f * slip.slip_rad.abs();
        assert!(
            fault.abs() < 1e-11 * stored(0.9),
            "{before} to {after}: {fault:e}"
        );
        before = after;
    }
    assert!(
        history.slips.len() >= 15 && history.at_rest,
        "{}",
        history.slips.len()
    );
}

#[test]
fn exact_a_stuck_joint_makes_two_links_one() {
    let (lower, upper) = (link(3000.0, 1.5, 0.7, 600.0), link(2000.0, 1.0, 0.5, 250.0));
    let mass = 5000.0;
    let centroid = (3000.0 * 0.7 + 2000.0 * 2.0) / mass;
    let inertia = 600.0 + 250.0 + 3000.0 * (centroid - 0.7_f64).powi(2) + 2000.0 * (2.0 - centroid).powi(2);
    let whole = Chain::new(vec![link(mass, 2.5, centroid, inertia)], G).unwrap();
    let k = 4.0 * whole.gravity_moments_n_m_rad()[0];
    let base = rubbing(k, JointFriction::coulomb(0.004 * k));
    let glued = rubbing(0.5 * k, JointFriction::coulomb(1e9));
    for rotations in [ChainRotations::Small, ChainRotations::Large] {
        let one = ChainModel::new(whole.clone(), vec![base], rotations).unwrap();
        let chain = Chain::new(vec![lower.clone(), upper.clone()], G).unwrap();
        let two = ChainModel::new(chain, vec![base, glued], rotations).unwrap();
        let options = ChainRun::default();
        let (one, two) = (
            run(&one, &el_centro(1.0), &options),
            run(&two, &el_centro(1.0), &options),
        );
        assert!(one.slips.len() > 20, "{}", one.slips.len());
        assert_eq!(one.slips.len(), two.slips.len());
        let apart = |rows: &[f64]| {
            let pairs = one.rotation_rad[0].iter().zip(rows);
            pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
        };
        let most = one.rotation_peaks[0].rotation_rad.abs();
        assert!(
            apart(&two.rotation_rad[0]) < 1e-11 * most,
            "{:e}",
            apart(&two.rotation_rad[0])
        );
        assert_eq!(two.rotation_rad[0], two.rotation_rad[1]);
        // only the upper link is shaken, by the motion of its foot. Its joint carries J θ'' + m l (foot'' + …), which equals the moment
        // below minus the share of the lower link, so that the balance of the whole chain holds
        let moments = one.joint_moment_n_m[0].iter().zip(&two.joint_moment_n_m[0]);
        let worst = moments.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
        assert!(worst < 1e-9 * one.joint_moment_peaks_n_m[0], "{worst:e}");
    }
}

#[test]
fn exact_joints_hold_until_the_ground_passes_their_limit() {
    // stuck and upright: q_i = −a Σ_{j≥i} Γ_j; under a = r t the joint with the least f_i/Σ Γ slips first, at f_i/(r Σ Γ)
    let links = vec![
        link(3000.0, 1.5, 0.7, 600.0),
        link(2000.0, 1.0, 0.5, 250.0),
        link(900.0, 0.8, 0.4, 60.0),
    ];
    let chain = Chain::new(links, G).unwrap();
    let gamma = chain.base_influence_kg_m();
    let above = |i: usize| gamma[i..].iter().sum::<f64>();
    let rate = 0.5;
    let load = TimeFunction::Sampled {
        time_step_s: 4.0,
        values: vec![0.0, 4.0 * rate],
    };
    for rotations in [ChainRotations::Small, ChainRotations::Large] {
        for first in 0..3 {
            let joints = (0..3).map(|i| {
                let limit_m_s2 = if i == first { 0.6 } else { 0.9 };
                rubbing(1e6, JointFriction::coulomb(limit_m_s2 * above(i)))
            });
            let model = ChainModel::new(chain.clone(), joints.collect(), rotations).unwrap();
            let history = run(&model, &load, &from(&[], 4.0));
            let slip = history
                .slips
                .iter()
                .min_by(|a, b| a.from_s.total_cmp(&b.from_s))
                .unwrap();
            assert_eq!(slip.joint, first);
            assert!((slip.from_s - 0.6 / rate).abs() < 1e-12, "{}", slip.from_s);
            let still = (0.6 / rate / 0.01) as usize;
            assert!(
                history
                    .rotation_rad
                    .iter()
                    .all(|row| row[..=still].iter().all(|x| *x == 0.0))
            );
            assert!(history.energy_left_over_ratio < 1e-12);
        }
        // all joints at once
        let joints = (0..3).map(|i| rubbing(1e6, JointFriction::coulomb(0.7 * above(i))));
        let model = ChainModel::new(chain.clone(), joints.collect(), rotations).unwrap();
        let history = run(&model, &load, &from(&[], 4.0));
        let first_s = history.slips.iter().map(|slip| slip.from_s).fold(4.0, f64::min);
        assert!((first_s - 0.7 / rate).abs() < 1e-12, "{first_s}");
        assert!(history.energy_left_over_ratio < 1e-12);
    }
}

#[test]
fn exact_static_above_kinetic_jumps() {
    // under a = −r t it slips at f_s/(r Γ) and moves with f_k: θ = (s t' + b)/κ − … in closed form until it stops
    let (gravity, inertia) = (one().gravity_moments_n_m_rad()[0], one().mass_matrix()[(0, 0)]);
    let gamma = one().base_influence_kg_m()[0];
    let kappa = 3.0 * gravity;
    let (holds, turns, rate) = (50.0, 20.0, 0.4);
    let friction = JointFriction::Coulomb {
        static_moment_n_m: holds,
        kinetic_moment_n_m: turns,
    };
    let model = ChainModel::new(
        one(),
        vec![rubbing(kappa + gravity, friction)],
        ChainRotations::Small,
    )
    .unwrap();
    let load = TimeFunction::Sampled {
        time_step_s: 8.0,
        values: vec![0.0, -8.0 * rate],
    };
    let history = run(&model, &load, &from(&[], 8.0));
    let goes = holds / (rate * gamma);
    let slip = history.slips[0];
    assert!((slip.from_s - goes).abs() < 1e-12, "{} {goes}", slip.from_s);
    // J θ'' + κ θ = Γ r (t_0 + τ) − f_k: θ = A (1 − cos ωτ) + B (τ − sin ωτ/ω)
    let omega = (kappa / inertia).sqrt();
    let (a, b) = ((holds - turns) / kappa, gamma * rate / kappa);
    for (&t, &theta) in history.times_s.iter().zip(&history.rotation_rad[0]) {
        if t > slip.from_s && t < slip.to_s {
            let tau = t - goes;
            let wanted = a * (1.0 - (omega * tau).cos()) + b * (tau - (omega * tau).sin() / omega);
            assert!((theta - wanted).abs() < 1e-13, "{t}: {theta} {wanted}");
        }
    }
    // θ' = 0: A ω sin ωτ + B (1 − cos ωτ) = 0, tan(ωτ/2) = −A ω/B
    let stops = 2.0 * (PI - (a * omega / b).atan()) / omega;
    assert!(
        (slip.to_s - goes - stops).abs() < 1e-12,
        "{} {stops}",
        slip.to_s - goes
    );
    assert!(history.slips.len() > 1 && history.energy_left_over_ratio < 1e-12);
}

#[test]
fn agrees_two_links_with_scipy_from_event_to_event() {
    let links = vec![link(3.0, 1.5, 0.7, 0.6), link(2.0, 1.0, 0.5, 0.25)];
    let chain = Chain::new(links, G).unwrap();
    let joint = |stiffness_n_m_rad, damping_n_m_s_rad, moment| ChainJoint {
        stiffness_n_m_rad,
        damping_n_m_s_rad,
        opening: JointOpening::Held,
        friction: JointFriction::coulomb(moment),
    };
    let model = ChainModel::new(
        chain,
        vec![joint(120.0, 0.4, 4.0), joint(25.0, 0.2, 1.2)],
        ChainRotations::Large,
    )
    .unwrap();
    let load = TimeFunction::Harmonic {
        amplitude: 3.0,
        frequency_hz: 0.8,
        phase_rad: 0.0,
    };
    let options = ChainRun {
        output_step_s: 1.0,
        ..from(&[], 6.0)
    };
    let history = run(&model, &load, &options);
    for (second, wanted) in TWO_LINKS.iter().enumerate() {
        for (rows, wanted) in history.rotation_rad.iter().zip(wanted) {
            let got = rows[second + 1];
            assert!(
                (got - wanted).abs() < 1e-11,
                "{} s: {got:.15e} {wanted:.15e}",
                second + 1
            );
        }
    }
    assert_eq!(history.friction_events, TWO_LINKS_EVENTS);
    assert!(history.energy_left_over_ratio < 1e-13);
}

/// Rotations at 1, 2 … 6 s, rad, and changes of a joint.
const TWO_LINKS: [[f64; 2]; 6] = [
    [-1.058359917012448e-01, -3.200615481768301e-01],
    [-1.242010428070603e-02, -8.934679238087063e-02],
    [2.681691064282055e-02, 1.703578668546155e-01],
    [2.520001273092211e-02, 1.221699216595188e-01],
    [1.516423523527322e-02, -3.521427595139745e-02],
    [-1.768_662_680_523_27e-02, -1.270503948723616e-01],
];
const TWO_LINKS_EVENTS: usize = 24;

#[test]
fn agrees_three_links_with_scipy_where_static_friction_is_above_kinetic() {
    let links = vec![
        link(3.0, 1.5, 0.7, 0.6),
        link(2.0, 1.0, 0.5, 0.25),
        link(1.0, 0.8, 0.4, 0.06),
    ];
    let joint = |stiffness_n_m_rad, damping_n_m_s_rad, static_moment_n_m, kinetic_moment_n_m| ChainJoint {
        stiffness_n_m_rad,
        damping_n_m_s_rad,
        opening: JointOpening::Held,
        friction: JointFriction::Coulomb {
            static_moment_n_m,
            kinetic_moment_n_m,
        },
    };
    let joints = vec![
        joint(160.0, 0.5, 5.0, 3.0),
        joint(50.0, 0.2, 2.5, 1.5),
        joint(10.0, 0.05, 0.6, 0.4),
    ];
    let model = ChainModel::new(Chain::new(links, G).unwrap(), joints, ChainRotations::Large).unwrap();
    let load = TimeFunction::Sampled {
        time_step_s: 0.25,
        values: (0..=24).map(|i| [0.0, 6.0, 0.0, -6.0][i % 4]).collect(),
    };
    let options = ChainRun {
        output_step_s: 1.0,
        fall_rad: 3.0,
        ..from(&[], 6.0)
    };
    let history = run(&model, &load, &options);
    for (second, wanted) in THREE_LINKS.iter().enumerate() {
        for (rows, wanted) in history.rotation_rad.iter().zip(wanted) {
            let got = rows[second + 1];
            assert!(
                (got - wanted).abs() < 1e-10,
                "{} s: {got:.15e} {wanted:.15e}",
                second + 1
            );
        }
    }
    assert_eq!(history.friction_events, THREE_LINKS_EVENTS);
    assert!(history.energy_left_over_ratio < 1e-13);
}

/// Rotations at 1, 2 … 6 s, rad, and changes of a joint.
const THREE_LINKS: [[f64; 3]; 6] = [
    [
        -7.489564048827117e-02,
        -3.871457927254392e-01,
        -1.10512285539606e+00,
    ],
    [
        -1.817349519800473e-02,
        -4.496632908824245e-01,
        -1.417910155788313e+00,
    ],
    [
        1.485553531238671e-01,
        -1.152203579056898e-01,
        -1.106729424620028e+00,
    ],
    [
        2.944568150495913e-01,
        2.384764846567087e-01,
        -6.260214673744496e-01,
    ],
    [
        3.012195332249586e-01,
        2.327974375037543e-01,
        -6.301111908201303e-01,
    ],
    [
        1.441618016038942e-01,
        -8.519510970616648e-02,
        -1.048691352935069e+00,
    ],
];
const THREE_LINKS_EVENTS: usize = 39;

/// Random chains with friction, opening and damping in the joints, under the whole record.
fn shaken(draw: &mut Draws, rotations: ChainRotations) -> ChainHistory {
    let n = 1 + (draw.between(0.0, 6.0) as usize).min(5);
    let chain = draw.chain(n);
    let necessary = chain.necessary_n_m_rad();
    let gamma = chain.base_influence_kg_m();
    let joints = (0..n).map(|i| {
        let limit = gamma[i..].iter().sum::<f64>() * draw.between(0.05, 1.5);
        let share = draw.between(0.5, 1.0);
        ChainJoint {
            stiffness_n_m_rad: necessary[i] * n as f64 * draw.between(2.0, 30.0),
            damping_n_m_s_rad: if draw.between(0.0, 1.0) < 0.5 {
                0.01 * necessary[i]
            } else {
                0.0
            },
            opening: match draw.between(0.0, 3.0) as usize {
                0 => JointOpening::AtBedEdge,
                _ => JointOpening::Held,
            },
            friction: match draw.between(0.0, 3.0) as usize {
                0 => JointFriction::None,
                1 => JointFriction::coulomb(limit),
                _ => JointFriction::Coulomb {
                    static_moment_n_m: limit,
                    kinetic_moment_n_m: share * limit,
                },
            },
        }
    });
    let model = ChainModel::new(chain, joints.collect(), rotations).unwrap();
    let history = run(&model, &el_centro(1.0), &ChainRun::default());
    for (i, joint) in model.joints().iter().enumerate() {
        let JointFriction::Coulomb {
            static_moment_n_m, ..
        } = joint.friction
        else {
            continue;
        };
        let most = history.friction_moment_n_m[i]
            .iter()
            .fold(0.0_f64, |m, q| m.max(q.abs()));
        assert!(
            most <= static_moment_n_m * (1.0 + 1e-9),
            "{most} {static_moment_n_m}"
        );
        // between its slips a joint does not rotate
        let across = history.across_rad(i);
        let own: Vec<_> = history.slips.iter().filter(|slip| slip.joint == i).collect();
        let turned: f64 = own.iter().map(|slip| slip.slip_rad).sum();
        let end = across.last().unwrap();
        assert!((turned - end).abs() < 1e-12, "{turned} {end}");
        for slip in own.windows(2) {
            assert!(slip[1].from_s >= slip[0].to_s);
        }
    }
    history
}

#[test]
fn holds_random_chains_keep_the_law_and_their_energy() {
    let mut draw = Draws::new(20);
    let (mut slips, mut fallen) = (0, 0);
    for case in 0..60 {
        let rotations = [ChainRotations::Large, ChainRotations::Small][case % 2];
        let history = shaken(&mut draw, rotations);
        assert!(
            history.energy_left_over_ratio < 1e-11,
            "{case}: {:e}",
            history.energy_left_over_ratio
        );
        slips += history.slips.len();
        fallen += usize::from(matches!(history.outcome, ChainOutcome::Fell { .. }));
    }
    assert!(slips > 3000 && fallen < 20, "{slips} {fallen}");
    let again = |seed| shaken(&mut Draws::new(seed), ChainRotations::Large);
    assert_eq!(again(3), again(3));
}

#[test]
fn exact_friction_of_no_moment_is_none() {
    let model = |friction| {
        let joints = vec![rubbing(4000.0, friction)];
        ChainModel::new(one(), joints, ChainRotations::Large).unwrap()
    };
    let (none, zero) = (model(JointFriction::None), model(JointFriction::coulomb(0.0)));
    assert!(!zero.has_friction());
    let options = from(&[0.1], TAU);
    assert_eq!(
        run(&none, &TimeFunction::Zero, &options),
        run(&zero, &TimeFunction::Zero, &options)
    );
}

#[test]
fn refuses_friction_that_cannot_be() {
    let message = |friction| {
        let joints = vec![rubbing(1.0, friction)];
        ChainModel::new(one(), joints, ChainRotations::Large)
            .unwrap_err()
            .to_string()
    };
    assert_eq!(
        message(JointFriction::coulomb(-1.0)),
        "joint 1: kinetic_moment_n_m is -1, but must be 0 or a positive number"
    );
    let low = JointFriction::Coulomb {
        static_moment_n_m: 1.0,
        kinetic_moment_n_m: 2.0,
    };
    assert_eq!(
        message(low),
        "joint 1: static_moment_n_m is 1, but must be at least the kinetic one"
    );
}
