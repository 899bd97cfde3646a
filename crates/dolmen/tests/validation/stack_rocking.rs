// SOURCE     Housner (1963) Bull. Seism. Soc. Am. 53(2):403-417, solved exactly in known/rocking.rs and known/overturning.rs.
// GOAL       The springs engine rocks one block according to the nonlinear equation, up to the twentieth impact, and
//            overturns it at the same pulse amplitude.
// PARAMETERS block 0.4 × 1.0 × 2.0 m, released at α/2; corners only, k_n 1e10 Pa/m, damping ratio 1: these stand for
//            Housner's r, who has the block strike along its edge. Friction 5: it does not slide.
// PUBLISHED  p 2.686005, r 0.942308, T/4 0.490864 s; pulses: the nonlinear row of known/overturning.rs.
// TOLERANCE  T/4 and first impacts 0.5 %, impact 20 and amplitudes 2 %, overturning 2 %: the springs yield under an edge.

use dolmen::blocks::{ContactRule, Outcome, Springs, StackHistory, Start, simulate_springs};
use dolmen::known::overturning::{Equation, Pulse, first_overturning};
use dolmen::known::rocking::{
    amplitude_rad, frequency_parameter_rad_s, impact_times_s, quarter_period_s, slenderness_rad,
    velocity_ratio,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};

const HALF_WIDTH_M: f64 = 0.2;
const HALF_HEIGHT_M: f64 = 1.0;
const GRAVITY_M_S2: f64 = 9.81;

fn block() -> Stack {
    let material = JointMaterial {
        normal_stiffness_pa_m: 1e10,
        shear_stiffness_pa_m: 4e9,
        damping_ratio: 1.0,
        ..JointMaterial::with_friction(5.0)
    };
    let stone = Block {
        name: "stone".into(),
        solid: Solid::cuboid(2.0 * HALF_WIDTH_M, 1.0, 2.0 * HALF_HEIGHT_M).unwrap(),
        density_kg_m3: 2600.0,
    };
    Stack::new(vec![stone], material, GRAVITY_M_S2).unwrap()
}

fn options(duration_s: f64) -> Springs {
    Springs {
        contact_rule: ContactRule::Corners,
        duration_s: Some(duration_s),
        output_step_s: 1e-3,
        ..Springs::default()
    }
}

/// Rotation about y at each sample, rad.
pub(crate) fn tilts(history: &StackHistory) -> Vec<f64> {
    let samples = 0..history.time_s.len();
    samples
        .map(|sample| {
            let [w, _, y, _] = history.pose(sample, 0).rotation;
            2.0 * y.atan2(w)
        })
        .collect()
}

#[test]
fn agrees_free_rocking_to_the_twentieth_impact() {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let p = frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let (r, released) = (velocity_ratio(alpha), 0.5 * alpha);
    let mut options = options(10.0);
    options.starts = vec![Start {
        pivot_m: [HALF_WIDTH_M, 0.0, 0.0],
        turn_rad: [0.0, released, 0.0],
        ..Start::of(0)
    }];
    let history = simulate_springs(&block(), None, &options, &mut |_| true).unwrap();
    let tilts = tilts(&history);
    let (mut impacts, mut peaks, mut peak) = (Vec::new(), Vec::new(), 0.0_f64);
    for (sample, pair) in tilts.windows(2).enumerate() {
        peak = peak.max(pair[0].abs());
        if pair[0] * pair[1] < 0.0 {
            let part = pair[0] / (pair[0] - pair[1]);
            let [from, to] = [history.time_s[sample], history.time_s[sample + 1]];
            impacts.push(from + part * (to - from));
            peaks.push(peak);
            peak = 0.0;
        }
    }
    let near = |what: &str, computed: f64, exact: f64, part: f64| {
        let off = computed / exact - 1.0;
        assert!(
            off.abs() < part,
            "{what}: {computed} against {exact}, {:.3} %",
            100.0 * off
        );
    };
    near("T/4", impacts[0], quarter_period_s(alpha, p, released), 1e-4);
    let exact = impact_times_s(alpha, p, r, released, 20);
    for impact in 1..6 {
        near("first impacts", impacts[impact], exact[impact], 0.005);
    }
    near("impact 20", impacts[19], exact[19], 0.005);
    for (impacts, part) in [(1, 0.005), (5, 0.01), (20, 0.02)] {
        let exact = amplitude_rad(alpha, r, released, impacts);
        near("amplitude", peaks[impacts as usize], exact, part);
    }
    assert!(
        history.energy_made_ratio() < 1e-3,
        "{}",
        history.energy_made_ratio()
    );
}

/// Base acceleration of a pulse of a/(α g) = `amplitude`, at rest after it.
pub(crate) fn pulse(shape: Pulse, q: f64, amplitude: f64) -> GroundMotion {
    const STEP_S: f64 = 5e-4;
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let omega = q * frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let (end, wave): (f64, fn(f64) -> f64) = match shape {
        Pulse::HalfSine => (std::f64::consts::PI, f64::sin),
        Pulse::Sine => (std::f64::consts::TAU, f64::sin),
        Pulse::Cosine => (std::f64::consts::TAU, f64::cos),
    };
    let samples = (end / omega / STEP_S) as usize;
    let acceleration =
        (0..=samples).map(|i| amplitude * alpha * GRAVITY_M_S2 * wave(omega * i as f64 * STEP_S));
    GroundMotion::new("pulse", STEP_S, vec![(Component::X, acceleration.collect())]).unwrap()
}

/// Whether the block falls without striking its other edge.
fn falls_at_once(shape: Pulse, q: f64, amplitude: f64) -> bool {
    let options = Springs {
        duration_s: Some(4.0),
        ..options(4.0)
    };
    let motion = pulse(shape, q, amplitude);
    let history = simulate_springs(&block(), Some(&motion), &options, &mut |_| true).unwrap();
    fell_at_once(&history)
}

/// Whether it fell without striking its other edge.
pub(crate) fn fell_at_once(history: &StackHistory) -> bool {
    let first = tilts(history).into_iter().find(|tilt| tilt.abs() > 0.01);
    let struck = tilts(history)
        .into_iter()
        .any(|tilt| tilt * first.unwrap_or(0.0) < -1e-4);
    matches!(history.outcome, Outcome::Fell { block: 0, .. }) && !struck
}

#[test]
fn agrees_overturning_by_pulses() {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    for shape in [Pulse::HalfSine, Pulse::Sine, Pulse::Cosine] {
        for q in [1.0, 2.0, 3.0, 4.0] {
            let exact = first_overturning(shape, q, Equation::Exact, alpha, None).unwrap();
            assert!(
                falls_at_once(shape, q, 1.02 * exact),
                "{shape:?} {q}: stands at 1.02 × {exact}"
            );
            assert!(
                !falls_at_once(shape, q, 0.98 * exact),
                "{shape:?} {q}: falls at .98 × {exact}"
            );
        }
    }
}

/// Spring and dashpot that separate where their force is 0, in time steps: ratio of velocities after and before.
fn rebound_by_steps(damping_ratio: f64) -> f64 {
    let (h, mut x, mut v) = (1e-5, 0.0, 1.0);
    let force = |x: f64, v: f64| x + 2.0 * damping_ratio * v;
    while force(x, v) > 0.0 || x <= 0.0 {
        // midpoint rule
        let (x_half, v_half) = (x + 0.5 * h * v, v - 0.5 * h * force(x, v));
        (x, v) = (x + h * v_half, v - h * force(x_half, v_half));
    }
    -v
}

#[test]
fn exact_rebound_of_springs_and_dashpots() {
    for damping_ratio in [0.05, 0.3, 0.6, 0.95, 1.0, 1.5, 4.0] {
        let closed = JointMaterial::restitution_of(damping_ratio);
        let stepped = rebound_by_steps(damping_ratio);
        assert!(
            (closed - stepped).abs() < 2e-5,
            "ζ {damping_ratio}: {closed} against {stepped}"
        );
    }
    for restitution in [0.002, 0.1, 0.5, 0.9, 0.999] {
        let damping_ratio = JointMaterial::damping_ratio_of(restitution);
        assert!((JointMaterial::restitution_of(damping_ratio) - restitution).abs() < 1e-9);
    }
    assert_eq!(
        JointMaterial::damping_ratio_of(0.0),
        JointMaterial::DAMPING_RATIO_MOST
    );
}

/// Ratio of velocities after and before of a stone that falls flat.
fn rebound_on_springs(restitution: f64, fall_m: f64) -> f64 {
    let material = JointMaterial {
        normal_restitution: restitution,
        damping_ratio: JointMaterial::damping_ratio_of(restitution),
        ..JointMaterial::default()
    };
    let stone = Block {
        name: "stone".into(),
        solid: Solid::cuboid(0.3, 0.2, 0.1).unwrap(),
        density_kg_m3: 2600.0,
    };
    let stack = Stack::new(vec![stone], material, GRAVITY_M_S2).unwrap();
    let options = Springs {
        duration_s: Some(0.5),
        output_step_s: 1e-3,
        starts: vec![Start {
            shift_m: [0.0, 0.0, fall_m],
            ..Start::of(0)
        }],
        ..Springs::default()
    };
    let history = simulate_springs(&stack, None, &options, &mut |_| true).unwrap();
    let landed_s = (2.0 * fall_m / GRAVITY_M_S2).sqrt();
    let after = (0..history.time_s.len()).filter(|&sample| history.time_s[sample] > landed_s);
    let heights = after.map(|sample| history.pose(sample, 0).centroid_m[2] - 0.05);
    (heights.fold(0.0, f64::max) / fall_m).sqrt()
}

/// A stone keeps up to 2 % less velocity than stated, never more, because its weight and the steps reduce it.
#[test]
fn agrees_rebound_of_a_stone_that_falls_flat_on_springs() {
    for restitution in [0.9, 0.6, 0.45] {
        for fall_m in [0.07, 0.1, 0.131] {
            let found = rebound_on_springs(restitution, fall_m);
            let off = found / restitution - 1.0;
            assert!((-0.02..1e-3).contains(&off), "{found} for {restitution}");
        }
    }
}
