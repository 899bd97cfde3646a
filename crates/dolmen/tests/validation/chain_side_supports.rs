// SOURCE     closed forms of the piecewise linear oscillator; Runge and Kutta's fourth order with steps of 0.1 ms.
// GOAL       Side supports of a chain in motion, with and without a gap: contact is exact, energy is conserved, and other
//            methods agree.
// PARAMETERS one rigid link between two stops; three links with two supports on a shaking ground.
// TOLERANCE  closed forms 1e-9; Runge and Kutta 2e-6 of the largest rotation, the error of its steps across the kinks.

use dolmen::dynamics::{
    ChainHistory, ChainJoint, ChainModel, ChainOutcome, ChainRotations, ChainRun, TimeFunction,
    chain_at_rest, simulate_chain,
};
use dolmen::structure::{Chain, Inertia, Link, SideSupport};
use dolmen_linalg::{Matrix, solve};
use std::f64::consts::{PI, TAU};

const G: f64 = 9.81;

fn link(mass_kg: f64, length_m: f64) -> Link {
    Link {
        mass_kg,
        length_m,
        centroid_m: 0.45 * length_m,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    }
}

/// m g l of the pole of one link, and its inertia about the foot.
const WEIGHT_N_M: f64 = 800.0 * G * 0.45 * 4.0;

fn inertia() -> f64 {
    800.0 * (1.8 * 1.8 + 16.0 / 12.0)
}

fn pole(stiffness_n_m_rad: f64, support: SideSupport, rotations: ChainRotations) -> ChainModel {
    let chain = Chain::new(vec![link(800.0, 4.0)], G).unwrap();
    let chain = chain.with_side_support(support).unwrap();
    ChainModel::new(chain, vec![ChainJoint::spring(stiffness_n_m_rad)], rotations).unwrap()
}

fn stop(gap_m: f64) -> SideSupport {
    SideSupport {
        height_m: 2.5,
        stiffness_n_m: 60_000.0,
        gap_m,
    }
}

fn run(model: &ChainModel, start_rad: Vec<f64>, duration_s: f64, load: &TimeFunction) -> ChainHistory {
    let options = ChainRun {
        duration_s: Some(duration_s),
        start_rotation_rad: start_rad,
        ..ChainRun::default()
    };
    simulate_chain(model, load, &options, &mut |_| true).unwrap()
}

/// Period of I θ″ + a θ = 0 within ±b, with the additional s c² beyond, from rest at A.
fn period_s(own_n_m_rad: f64, start_rad: f64) -> f64 {
    let support = stop(0.05);
    let (c, s) = (support.height_m, support.stiffness_n_m);
    let b = support.gap_m / c;
    let beyond = own_n_m_rad + s * c * c;
    let omega = (beyond / inertia()).sqrt();
    let rest = s * c * support.gap_m / beyond;
    let outside_s = ((b - rest) / (start_rad - rest)).acos() / omega;
    let rate = (start_rad - rest) * omega * (omega * outside_s).sin();
    let own = (own_n_m_rad.abs() / inertia()).sqrt();
    // from b to 0: a circle if it is stable, a hyperbola if it is not
    let inside_s = match own_n_m_rad > 0.0 {
        true => (b * own / rate).atan() / own,
        false => (b * own / rate).atanh() / own,
    };
    4.0 * (outside_s + inside_s)
}

#[test]
fn exact_period_between_two_stops_of_a_pole_that_stands_and_of_one_that_falls() {
    for own in [0.6 * WEIGHT_N_M, -0.4 * WEIGHT_N_M] {
        let model = pole(WEIGHT_N_M + own, stop(0.05), ChainRotations::Small);
        let start = 0.045;
        let period = period_s(own, start);
        let whole = run(&model, vec![start], 10.0 * period, &TimeFunction::Zero);
        let end = whole.rotation_rad[0].last().unwrap();
        assert!((end / start - 1.0).abs() < 1e-9, "{own}: {end}");
        assert!(whole.velocity_rad_s[0].last().unwrap().abs() < 1e-5 * start / period);
        // it starts outside and touches a stop twice per period
        assert_eq!(whole.touches.len(), 21, "{:?}", whole.outcome);
        let half = run(&model, vec![start], 0.5 * period, &TimeFunction::Zero);
        let end = half.rotation_rad[0].last().unwrap();
        assert!((end / start + 1.0).abs() < 1e-9, "{own}: {end}");
        let force = 60_000.0 * (2.5 * start - 0.05);
        assert!((half.support_peaks[0].force_n.abs() / force - 1.0).abs() < 1e-12);
        assert!(
            whole.energy_left_over_ratio < 1e-12,
            "{}",
            whole.energy_left_over_ratio
        );
    }
}

#[test]
fn exact_frequency_with_a_support_without_a_gap() {
    let model = pole(1.2 * WEIGHT_N_M, stop(0.0), ChainRotations::Small);
    let own = 0.2 * WEIGHT_N_M + 60_000.0 * 2.5 * 2.5;
    let omega = (own / inertia()).sqrt();
    let modes = model.chain().natural_modes(&[1.2 * WEIGHT_N_M]).unwrap();
    assert!((modes[0].frequency_hz * TAU / omega - 1.0).abs() < 1e-12);
    let history = run(&model, vec![0.01], 7.25 * TAU / omega, &TimeFunction::Zero);
    let end = history.rotation_rad[0].last().unwrap();
    assert!(end.abs() < 1e-12, "{end}");
    // it is in contact from the start to the end
    assert_eq!((history.touches.len(), history.touches[0].from_s), (1, 0.0));
}

#[test]
fn exact_a_pole_that_falls_comes_to_rest_against_its_post() {
    // (k − m g l) θ + s c (c θ − g) = 0
    let own = -0.4 * WEIGHT_N_M;
    let support = stop(0.05);
    let (c, s) = (support.height_m, support.stiffness_n_m);
    let rest = s * c * support.gap_m / (own + s * c * c);
    let chain = Chain::new(vec![link(800.0, 4.0)], G).unwrap();
    let joint = ChainJoint {
        damping_n_m_s_rad: 4000.0,
        ..ChainJoint::spring(WEIGHT_N_M + own)
    };
    let of = |chain: Chain| ChainModel::new(chain, vec![joint], ChainRotations::Small).unwrap();
    let held = of(chain.clone().with_side_support(support).unwrap());
    let history = run(&held, vec![1e-4], 120.0, &TimeFunction::Zero);
    assert_eq!(history.outcome, ChainOutcome::Stood);
    let end = history.rotation_rad[0].last().unwrap();
    assert!((end / rest - 1.0).abs() < 1e-9, "{end} {rest}");
    // without a support it falls
    let history = run(&of(chain), vec![1e-4], 120.0, &TimeFunction::Zero);
    assert!(
        matches!(history.outcome, ChainOutcome::Fell { .. }),
        "{:?}",
        history.outcome
    );
    // the rest position of a leaning pole against its post, with gaps measured from the lean
    let lean = 0.03;
    for rotations in [ChainRotations::Small, ChainRotations::Large] {
        let leaning = pole(1.3 * WEIGHT_N_M, stop(0.05), rotations)
            .leaning(lean)
            .unwrap();
        let theta = chain_at_rest(&leaning).unwrap().unwrap()[0];
        let k = 1.3 * WEIGHT_N_M;
        let [sin, cos, of_lean] = match rotations {
            ChainRotations::Small => [theta, 1.0, lean],
            ChainRotations::Large => [theta.sin(), theta.cos(), lean.sin()],
        };
        let pressed = c * (sin - of_lean) - 0.05;
        assert!(pressed > 0.0, "{pressed}");
        let left = k * (theta - lean) + s * pressed * c * cos - WEIGHT_N_M * sin;
        assert!(left.abs() < 1e-9 * WEIGHT_N_M, "{left}");
        let still = run(&leaning, vec![theta], 5.0, &TimeFunction::Zero);
        assert!((still.rotation_peaks[0].rotation_rad - theta).abs() < 1e-10);
    }
}

#[test]
fn agrees_with_runge_and_kutta_for_three_links_and_two_supports() {
    let links = vec![link(1500.0, 2.0), link(900.0, 1.8), link(500.0, 1.5)];
    let supports = [
        SideSupport {
            height_m: 1.4,
            stiffness_n_m: 4e6,
            gap_m: 0.004,
        },
        SideSupport {
            height_m: 3.0,
            stiffness_n_m: 1e6,
            gap_m: 0.012,
        },
    ];
    let stiffness = [6e5, 4e5, 2e5];
    let alone = Chain::new(links.clone(), G).unwrap();
    let chain = supports
        .into_iter()
        .try_fold(alone, Chain::with_side_support)
        .unwrap();
    let joints = stiffness.map(|k| ChainJoint {
        damping_n_m_s_rad: 0.004 * k,
        ..ChainJoint::spring(k)
    });
    let model = ChainModel::new(chain.clone(), joints.to_vec(), ChainRotations::Large).unwrap();
    let (amplitude, hz) = (3.0, 1.3);
    let ground = TimeFunction::Harmonic {
        amplitude,
        frequency_hz: hz,
        phase_rad: 0.0,
    };
    let history = run(&model, vec![0.0; 3], 4.0, &ground);
    assert!(history.touches.iter().any(|touch| touch.support == 0));
    assert!(history.touches.iter().any(|touch| touch.support == 1));
    // M_ij of the straight chain, computed again: Σ over links of m x_i x_j, where x is the displacement
    let n = links.len();
    let arm = |i: usize, j: usize| match i.cmp(&j) {
        std::cmp::Ordering::Less => links[i].length_m,
        std::cmp::Ordering::Equal => links[i].centroid_m,
        std::cmp::Ordering::Greater => 0.0,
    };
    let mass = |a: usize, b: usize| {
        let moved: f64 = (0..n).map(|j| links[j].mass_kg * arm(a, j) * arm(b, j)).sum();
        let own = links[a].mass_kg * links[a].length_m.powi(2) / 12.0;
        if a == b { moved + own } else { moved }
    };
    let first = |a: usize| -> f64 { (0..n).map(|j| links[j].mass_kg * arm(a, j)).sum() };
    let lever = [[1.4, 0.0, 0.0], [2.0, 1.0, 0.0]];
    let rate = |t: f64, state: &[f64]| -> Vec<f64> {
        let (theta, omega) = state.split_at(n);
        let shaken = amplitude * (TAU * hz * t).sin();
        let below = |i: usize, of: &[f64]| if i == 0 { of[0] } else { of[i] - of[i - 1] };
        let moment = |i: usize| match i < n {
            true => stiffness[i] * below(i, theta) + 0.004 * stiffness[i] * below(i, omega),
            false => 0.0,
        };
        let mut right: Vec<f64> = (0..n)
            .map(|i| {
                let (sin, cos) = theta[i].sin_cos();
                let spun: f64 = (0..n)
                    .map(|j| mass(i, j) * (theta[i] - theta[j]).sin() * omega[j] * omega[j])
                    .sum();
                first(i) * (G * sin - shaken * cos) - moment(i) + moment(i + 1) - spun
            })
            .collect();
        for (support, lever) in supports.iter().zip(lever) {
            let beside: f64 = (0..n).map(|i| lever[i] * theta[i].sin()).sum();
            let pressed = (beside.abs() - support.gap_m).max(0.0) * beside.signum();
            for i in 0..n {
                right[i] -= support.stiffness_n_m * pressed * lever[i] * theta[i].cos();
            }
        }
        let turned = Matrix::from_fn(n, n, |i, j| mass(i, j) * (theta[i] - theta[j]).cos());
        let faster = solve(&turned, &Matrix::from_column(&right)).unwrap();
        omega.iter().chain(faster.column(0)).copied().collect()
    };
    let h = 1e-4;
    let moved = |state: &[f64], by: f64, rate: &[f64]| -> Vec<f64> {
        state.iter().zip(rate).map(|(x, r)| x + by * r).collect()
    };
    let mut state = vec![0.0; 2 * n];
    let mut apart: f64 = 0.0;
    for k in 0..40_000 {
        if k % 50 == 0 {
            for (i, row) in history.rotation_rad.iter().enumerate() {
                apart = apart.max((row[k / 50] - state[i]).abs());
            }
        }
        let t = h * k as f64;
        let a = rate(t, &state);
        let b = rate(t + 0.5 * h, &moved(&state, 0.5 * h, &a));
        let c = rate(t + 0.5 * h, &moved(&state, 0.5 * h, &b));
        let d = rate(t + h, &moved(&state, h, &c));
        for i in 0..2 * n {
            state[i] += h / 6.0 * (a[i] + 2.0 * b[i] + 2.0 * c[i] + d[i]);
        }
    }
    let most = history
        .rotation_peaks
        .iter()
        .fold(0.0_f64, |most, peak| most.max(peak.rotation_rad.abs()));
    assert!(most < 0.5 * PI && apart < 2e-6 * most, "{apart} of {most}");
    assert!(
        history.energy_left_over_ratio < 1e-10,
        "{}",
        history.energy_left_over_ratio
    );
}

#[test]
fn holds_a_stiff_support_with_a_wide_gap_changes_nothing() {
    let ground = TimeFunction::Harmonic {
        amplitude: 0.5,
        frequency_hz: 0.7,
        phase_rad: 0.3,
    };
    let far = pole(1.5 * WEIGHT_N_M, stop(1.0), ChainRotations::Large);
    let chain = far.chain().without_side_supports();
    let bare = ChainModel::new(chain, far.joints().to_vec(), ChainRotations::Large).unwrap();
    let (with, without) = (
        run(&far, vec![0.01], 5.0, &ground),
        run(&bare, vec![0.01], 5.0, &ground),
    );
    for (a, b) in with.rotation_rad[0].iter().zip(&without.rotation_rad[0]) {
        assert!((a - b).abs() < 1e-13, "{a} {b}");
    }
    assert!(with.touches.is_empty() && with.support_peaks[0].force_n == 0.0);
}
