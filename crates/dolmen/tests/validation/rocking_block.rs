// SOURCE     Housner (1963) Bull. Seism. Soc. Am. 53(2):403-417 and the exact equation, solved in known/rocking.rs and
//            known/overturning.rs; SciPy 1.17.1 for a record (rocking_block_el_centro.py).
// GOAL       One rocking block, computed from event to event: free, under pulses, under a record with a vertical component.
// PARAMETERS block 0.4 × 2.0 m, g 9.81 m/s²; record: El Centro NS scaled to 0.35 g, half of it backwards as the vertical one.
// TOLERANCE  times of impacts 1e-12 s of the closed form; 1e-9 s of SciPy, whose tolerance is 1e-13 a step; pulses 1e-6, the
//            error of linear interpolation between 4000 samples of a sine.

use dolmen::dynamics::{
    DynamicsError, Rocking, RockingBlock, RockingEquation, RockingHistory, RockingOutcome, TimeFunction,
    rock_block,
};
use dolmen::known::overturning::{Equation, Pulse, first_overturning};
use dolmen::known::rocking::{amplitude_rad, impact_times_s};
use std::f64::consts::PI;

const GRAVITY_M_S2: f64 = 9.81;

fn block() -> RockingBlock {
    RockingBlock::rectangle(0.4, 2.0, GRAVITY_M_S2).unwrap()
}

fn under(horizontal: &TimeFunction, vertical: &TimeFunction, options: &Rocking) -> RockingHistory {
    rock_block(&block(), horizontal, vertical, options).unwrap()
}

fn sampled(time_step_s: f64, values: Vec<f64>) -> TimeFunction {
    TimeFunction::Sampled { time_step_s, values }
}

#[test]
fn exact_free_rocking_until_it_rests() {
    let block = block();
    let (alpha, p) = (block.slenderness_rad, block.frequency_parameter_rad_s);
    let options = Rocking {
        start_rad: -0.5 * alpha,
        duration_s: Some(40.0),
        ..Rocking::default()
    };
    let history = under(&TimeFunction::Zero, &TimeFunction::Zero, &options);
    assert_eq!(history.outcome, RockingOutcome::Rocked);
    let times = impact_times_s(alpha, p, block.velocity_ratio, 0.5 * alpha, 20);
    for (n, (impact, expected)) in history.impacts.iter().zip(&times).enumerate() {
        assert!(
            (impact.at_s - expected).abs() < 1e-12,
            "{n} {impact:?} {expected}"
        );
        // energy: ω² = 4 p² (sin²(α/2) − sin²((α − θ)/2)), with the amplitude before the impact
        let theta = amplitude_rad(alpha, block.velocity_ratio, 0.5 * alpha, n as u32);
        let square = (0.5 * alpha).sin().powi(2) - (0.5 * (alpha - theta)).sin().powi(2);
        let velocity = 2.0 * p * square.sqrt();
        assert!((impact.velocity_rad_s.abs() - velocity).abs() < 1e-12);
        assert_eq!(impact.velocity_rad_s > 0.0, n % 2 == 0); // let go on the left, it falls back to the right
    }
    assert!(history.impacts.len() > 20 && history.impacts.len() < 1000);
    assert_eq!(*history.rotation_rad.last().unwrap(), 0.0); // it rests, whole and at last
    assert_eq!(history.time_s.len(), 4001);
    assert_eq!(history.peak_rotation_rad, 0.5 * alpha);
}

/// Smallest a/(α g) of a half sine that overturns the block, by bisection.
fn falls_at(q: f64, equation: RockingEquation) -> f64 {
    const SAMPLES: u32 = 4000;
    let block = block();
    let falls = |times_alpha: f64| {
        let peak = times_alpha * block.slenderness_rad * GRAVITY_M_S2;
        let dt = PI / (q * block.frequency_parameter_rad_s * f64::from(SAMPLES));
        let phases = (0..=SAMPLES).map(|i| PI * f64::from(i) / f64::from(SAMPLES));
        let values = phases.map(|phase| peak * phase.sin()).collect();
        let options = Rocking {
            equation,
            rest_s: 10.0,
            output_step_s: 1.0,
            ..Rocking::default()
        };
        let history = under(&sampled(dt, values), &TimeFunction::Zero, &options);
        matches!(history.outcome, RockingOutcome::Fell { .. })
    };
    let expected = match equation {
        RockingEquation::Exact => Equation::Exact,
        RockingEquation::Linear => Equation::Linear,
    };
    let near = first_overturning(Pulse::HalfSine, q, expected, block.slenderness_rad, None).unwrap();
    let (mut stands, mut fell) = (0.99 * near, 1.01 * near);
    assert!(!falls(stands) && falls(fell));
    while fell - stands > 1e-8 {
        let middle = 0.5 * (stands + fell);
        if falls(middle) {
            fell = middle;
        } else {
            stands = middle;
        }
    }
    let at = 0.5 * (stands + fell);
    assert!((at - near).abs() < 1e-6 * near, "{q}: {at} {near}");
    at
}

#[test]
fn agrees_half_sines_that_overturn() {
    for (q, nonlinear, linear) in [
        (1.0, 1.339, 1.3224),
        (2.0, 1.825, 1.8007),
        (3.0, 2.3264, 2.2939),
        (4.0, 2.832, 2.7908),
    ] {
        let exact = falls_at(q, RockingEquation::Exact);
        assert!((exact - nonlinear).abs() < 6e-4, "{q} {exact}");
        let small = falls_at(q, RockingEquation::Linear);
        assert!((small - linear).abs() < 6e-5, "{q} {small}");
    }
}

/// Impacts by SciPy 1.17.1: time, s; angular velocity, rad/s.
const SCIPY: [(f64, f64); 12] = [
    (1.915754615213, 0.074755529447),
    (2.266281010814, -0.301273040665),
    (2.772276932014, 0.178625436461),
    (2.984613482132, -0.163599353584),
    (3.179924885498, 0.191963647434),
    (3.515893596484, -0.239217992654),
    (3.957820097286, 0.358555137162),
    (4.750580459924, -0.456523473492),
    (5.573707463993, 0.339732763177),
    (6.556492683413, -0.436832264746),
    (7.357493713947, 0.419666567704),
    (8.222837349696, -0.464627551748),
];

fn el_centro() -> [TimeFunction; 2] {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let values: Vec<f64> = text
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').unwrap().1.parse().unwrap())
        .collect();
    let peak = values.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    let x: Vec<f64> = values.iter().map(|a| a * (0.35 * GRAVITY_M_S2 / peak)).collect();
    let z = x.iter().rev().map(|a| 0.5 * a).collect();
    [sampled(0.02, x), sampled(0.02, z)]
}

#[test]
fn agrees_el_centro_with_a_vertical_component() {
    let [x, z] = el_centro();
    let history = under(&x, &z, &Rocking::default());
    for (impact, (at_s, velocity_rad_s)) in history.impacts.iter().zip(SCIPY) {
        assert!((impact.at_s - at_s).abs() < 1e-9, "{impact:?} {at_s}");
        assert!(
            (impact.velocity_rad_s - velocity_rad_s).abs() < 1e-9,
            "{impact:?}"
        );
    }
    assert_eq!(history.outcome, RockingOutcome::Rocked);
    assert!((history.peak_rotation_rad - 0.127_709_605).abs() < 1e-6); // SciPy's is of its steps
    assert!(history.friction_needed > 0.2 && history.friction_needed < 1.0);
    // the reversed motion is the mirror image, bit for bit
    let TimeFunction::Sampled { values, .. } = &x else {
        unreachable!()
    };
    let turned = sampled(0.02, values.iter().map(|a| -a).collect());
    let back = under(&turned, &z, &Rocking::default());
    assert!(
        history
            .rotation_rad
            .iter()
            .zip(&back.rotation_rad)
            .all(|(a, b)| *a == -*b)
    );
}

#[test]
fn holds_forces_at_the_edge() {
    // released at rest, the centre of mass falls about the edge with the angular acceleration p² sin φ
    let block = block();
    let options = Rocking {
        start_rad: 0.5 * block.slenderness_rad,
        duration_s: Some(1e-9),
        ..Rocking::default()
    };
    let history = under(&TimeFunction::Zero, &TimeFunction::Zero, &options);
    let (sin, cos) = (0.5 * block.slenderness_rad).sin_cos();
    let friction = 0.75 * sin * cos / (1.0 - 0.75 * sin * sin);
    assert!(
        (history.friction_needed - friction).abs() < 1e-12,
        "{}",
        history.friction_needed
    );
    assert!((history.least_pressure_ratio - (1.0 - 0.75 * sin * sin)).abs() < 1e-12);
}

#[test]
fn exact_it_lifts_off_where_the_moment_says() {
    let ramp = |peak_g: f64| sampled(1.0, vec![0.0, peak_g * GRAVITY_M_S2, 0.0]);
    let stood = under(&ramp(0.199_999), &TimeFunction::Zero, &Rocking::default());
    assert_eq!(stood.outcome, RockingOutcome::Stood);
    let vertical = sampled(1.0, vec![-0.5 * GRAVITY_M_S2; 3]);
    let rocked = under(&ramp(0.2), &vertical, &Rocking::default());
    assert!((rocked.uplift_s.unwrap() - 0.5).abs() < 1e-14); // at half of g, half the acceleration
    let thrown = under(
        &ramp(0.0),
        &sampled(1.0, vec![0.0, -2.0 * GRAVITY_M_S2]),
        &Rocking::default(),
    );
    assert_eq!(thrown.outcome, RockingOutcome::LeftTheGround { at_s: 0.5 });
}

#[test]
fn refuses_what_is_no_block() {
    let message = |error: DynamicsError| error.to_string();
    assert_eq!(
        message(RockingBlock::rectangle(0.4, 0.0, 9.81).unwrap_err()),
        "height_m is 0, but must be a positive number"
    );
    let lively = RockingBlock {
        velocity_ratio: 1.1,
        ..block()
    };
    let zero = TimeFunction::Zero;
    assert_eq!(
        message(rock_block(&lively, &zero, &zero, &Rocking::default()).unwrap_err()),
        "velocity_ratio is 1.1, but must be between 0 and 1"
    );
    let fallen = Rocking {
        start_rad: -2.0,
        ..Rocking::default()
    };
    assert_eq!(
        message(rock_block(&block(), &zero, &zero, &fallen).unwrap_err()),
        "start_rad is -2, but must be less than π/2 to either side"
    );
    // gal instead of m/s², and larger: the motion cannot be computed, but the loop must end
    let huge = sampled(0.01, vec![0.0, 1e30, 0.0]);
    let outcome = rock_block(&block(), &huge, &zero, &Rocking::default());
    assert!(outcome.is_ok_and(|h| matches!(h.outcome, RockingOutcome::Fell { .. })));
}
