//! Every measured number of `docs/stack-engine.md`, a line each: `cargo run --release -p dolmen --example stack_figures`.
//!
//! A word as argument runs only the cases whose name begins with it.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a measurement that fails loudly and reads its own processor time"
)]

use dolmen::blocks::{
    AfterFall, ContactRule, Outcome, Springs, StackHistory, Start, simulate_springs, stack_modes,
};
use dolmen::known::overturning::{Equation, Pulse, first_overturning};
use dolmen::known::rocking::{
    amplitude_rad, frequency_parameter_rad_s, impact_times_s, quarter_period_s, slenderness_rad,
    velocity_ratio,
};
use dolmen::known::sliding::{Friction, record_slip, sine_slip};
use dolmen::known::twisting::{
    disc_final_speed_ratio, rectangle_spin_deceleration_rad_s2, spin_down_angle_rad,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use dolmen::validation::p10;

const GRAVITY_M_S2: f64 = 9.81;
const STONE_M: [f64; 3] = [0.3, 0.2, 0.1];
const HALF_WIDTH_M: f64 = 0.2;
const HALF_HEIGHT_M: f64 = 1.0;

fn main() {
    let wanted = std::env::args().nth(1).unwrap_or_default();
    let cases: [(&str, fn()); 12] = [
        ("rocking", rocking),
        ("step", step),
        ("restitution", restitution),
        ("overturning", overturning),
        ("sine", sine),
        ("record", record),
        ("twist", twist),
        ("disc", disc),
        ("frequency", frequency),
        ("rest", rest),
        ("yaw", yaw),
        ("ramp", ramp),
    ];
    for (name, case) in cases.into_iter().filter(|(name, _)| name.starts_with(&wanted)) {
        println!("# {name}");
        case();
    }
    if "wall".starts_with(&wanted) {
        println!("# wall");
        wall();
    }
}

fn material(normal_stiffness_pa_m: f64, friction: f64) -> JointMaterial {
    JointMaterial {
        normal_stiffness_pa_m,
        shear_stiffness_pa_m: 0.4 * normal_stiffness_pa_m,
        ..JointMaterial::with_friction(friction)
    }
}

fn stone(size: [f64; 3], position_m: [f64; 3]) -> Block {
    let place = Placement {
        position_m,
        ..Placement::default()
    };
    Block {
        name: format!("stone at {position_m:?}"),
        solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
        density_kg_m3: 2600.0,
    }
}

fn pile(count: usize, material: JointMaterial, gravity_m_s2: f64) -> Stack {
    let blocks = (0..count).map(|i| stone(STONE_M, [0.0, 0.0, 0.1 * i as f64]));
    Stack::new(blocks.collect(), material, gravity_m_s2).unwrap()
}

fn run(stack: &Stack, motion: Option<&GroundMotion>, options: &Springs) -> StackHistory {
    simulate_springs(stack, motion, options, &mut |_| true).unwrap()
}

fn quality(history: &StackHistory) -> String {
    format!(
        "step {:.4} ms, made {:.1e}, {:?}",
        1e3 * history.time_step_s,
        history.energy_made_ratio(),
        history.outcome
    )
}

// Rocking: the block .4 × 2.0 m of Housner (1963).

fn rocker(normal_stiffness_pa_m: f64, damping_ratio: f64) -> Stack {
    let material = JointMaterial {
        damping_ratio,
        ..material(normal_stiffness_pa_m, 5.0)
    };
    Stack::new(
        vec![stone([2.0 * HALF_WIDTH_M, 1.0, 2.0 * HALF_HEIGHT_M], [0.0; 3])],
        material,
        GRAVITY_M_S2,
    )
    .unwrap()
}

fn tilts(history: &StackHistory) -> Vec<f64> {
    let samples = 0..history.time_s.len();
    samples
        .map(|sample| {
            let [w, _, y, _] = history.pose(sample, 0).rotation;
            2.0 * y.atan2(w)
        })
        .collect()
}

/// Times of the impacts, s, and the largest tilt before each and after the last, over α.
fn rocked(history: &StackHistory) -> (Vec<f64>, Vec<f64>) {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let (mut impacts, mut peaks, mut peak) = (Vec::new(), Vec::new(), 0.0_f64);
    for (sample, pair) in tilts(history).windows(2).enumerate() {
        peak = peak.max(pair[0].abs());
        if pair[0] * pair[1] < 0.0 {
            let part = pair[0] / (pair[0] - pair[1]);
            let [from, to] = [history.time_s[sample], history.time_s[sample + 1]];
            impacts.push(from + part * (to - from));
            peaks.push(peak / alpha);
            peak = 0.0;
        }
    }
    peaks.push(peak / alpha);
    (impacts, peaks)
}

fn release(rule: ContactRule, duration_s: f64) -> Springs {
    Springs {
        contact_rule: rule,
        duration_s: Some(duration_s),
        output_step_s: 1e-3,
        starts: vec![Start {
            pivot_m: [HALF_WIDTH_M, 0.0, 0.0],
            turn_rad: [0.0, 0.5 * slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M), 0.0],
            ..Start::of(0)
        }],
        ..Springs::default()
    }
}

fn rocking() {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let p = frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let (r, released) = (velocity_ratio(alpha), 0.5 * alpha);
    let history = run(&rocker(1e10, 1.0), None, &release(ContactRule::Corners, 10.0));
    let (impacts, peaks) = rocked(&history);
    let off = |computed: f64, exact: f64| 100.0 * (computed / exact - 1.0);
    println!("{}", quality(&history));
    println!(
        "T/4 {:+.4} %",
        off(impacts[0], quarter_period_s(alpha, p, released))
    );
    let exact = impact_times_s(alpha, p, r, released, 20);
    let first: Vec<String> = (1..6)
        .map(|i| format!("{:+.3}", off(impacts[i], exact[i])))
        .collect();
    println!("impacts 2 to 6 {} %", first.join(" "));
    println!(
        "impact 20 {:+.3} % of {:.4} s",
        off(impacts[19], exact[19]),
        exact[19]
    );
    for impacts in [1, 5, 20] {
        let exact = amplitude_rad(alpha, r, released, impacts) / alpha;
        println!(
            "amplitude after {impacts}: {:.4} α, {:+.3} %",
            peaks[impacts as usize],
            off(peaks[impacts as usize], exact)
        );
    }
}

fn step() {
    let mut times = Vec::new();
    for step_s in [160e-6, 80e-6, 40e-6, 20e-6, 10e-6, 5e-6, 2.5e-6] {
        let options = Springs {
            time_step_s: Some(step_s),
            ..release(ContactRule::Corners, 10.0)
        };
        let history = run(&rocker(1e10, 1.0), None, &options);
        times.push((step_s, rocked(&history).0[19]));
    }
    let [.., (_, before), (_, last)] = times[..] else {
        return;
    };
    let limit = 2.0 * last - before; // first order
    for (step_s, time) in &times {
        println!(
            "{:.1} µs: impact 20 at {time:.5} s, {:+.5} s from {limit:.5}",
            1e6 * step_s,
            time - limit
        );
    }
    for step_s in [400e-6, 200e-6, 100e-6, 50e-6, 25e-6] {
        let history = sine_history(1e9, Some(step_s));
        println!(
            "{:.0} µs: peak slip {:.5} mm",
            1e6 * step_s,
            1e3 * history.joints[0].peak_slip_m
        );
    }
}

fn restitution() {
    for (rule, k, damping) in [
        (ContactRule::Corners, 1e10, 1.0),
        (ContactRule::Four, 1e9, 1.0),
        (ContactRule::Four, 1e9, 0.3),
        (ContactRule::Four, 1e9, 0.05),
        (ContactRule::Four, 1e10, 1.0),
        (ContactRule::Four, 1e10, 0.3),
        (ContactRule::Four, 1e10, 0.05),
        (ContactRule::Four, 1e9, 20.0),
    ] {
        let history = run(&rocker(k, damping), None, &release(rule, 1.6));
        let (_, peaks) = rocked(&history);
        println!(
            "{rule:?} k_n {k:.0e} damping {damping}: {:.4} α after one impact; {}",
            peaks[1],
            quality(&history)
        );
    }
}

fn overturning() {
    const STEP_S: f64 = 5e-4;
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let p = frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let falls = |shape: Pulse, q: f64, amplitude: f64| {
        let omega = q * p;
        let (end, wave): (f64, fn(f64) -> f64) = match shape {
            Pulse::HalfSine => (std::f64::consts::PI, f64::sin),
            Pulse::Sine => (std::f64::consts::TAU, f64::sin),
            Pulse::Cosine => (std::f64::consts::TAU, f64::cos),
        };
        let samples = (end / omega / STEP_S) as usize;
        let series =
            (0..=samples).map(|i| amplitude * alpha * GRAVITY_M_S2 * wave(omega * i as f64 * STEP_S));
        let motion = GroundMotion::new("pulse", STEP_S, vec![(Component::X, series.collect())]).unwrap();
        let options = Springs {
            contact_rule: ContactRule::Corners,
            duration_s: Some(4.0),
            output_step_s: 1e-3,
            ..Springs::default()
        };
        let history = run(&rocker(1e10, 1.0), Some(&motion), &options);
        let tilts = tilts(&history);
        let first = tilts
            .iter()
            .find(|tilt| tilt.abs() > 0.01)
            .copied()
            .unwrap_or(0.0);
        let struck = tilts.iter().any(|tilt| tilt * first < -1e-4);
        matches!(history.outcome, Outcome::Fell { .. }) && !struck
    };
    for shape in [Pulse::HalfSine, Pulse::Sine, Pulse::Cosine] {
        let mut off = Vec::new();
        for q in [1.0, 2.0, 3.0, 4.0] {
            let exact = first_overturning(shape, q, Equation::Exact, alpha, None).unwrap();
            let (mut stands, mut fallen) = (0.96 * exact, 1.04 * exact);
            for _ in 0..7 {
                let middle = 0.5 * (stands + fallen);
                match falls(shape, q, middle) {
                    true => fallen = middle,
                    false => stands = middle,
                }
            }
            off.push(format!("{:+.2}", 100.0 * (0.5 * (stands + fallen) / exact - 1.0)));
        }
        println!("{shape:?}, ω/p 1 to 4: {} %", off.join(" "));
    }
}

// Sliding and twisting: the stone of 300 × 200 × 100 mm.

fn sine_history(k: f64, time_step_s: Option<f64>) -> StackHistory {
    let (g, step_s) = (9.80665, 2e-4);
    let wave = (0..=50_000).map(|i| 0.5 * g * (std::f64::consts::TAU * 2.0 * f64::from(i) * step_s).sin());
    let motion = GroundMotion::new("sine", step_s, vec![(Component::X, wave.collect())]).unwrap();
    let options = Springs {
        time_step_s,
        ..Springs::default()
    };
    run(&pile(1, material(k, 0.3), g), Some(&motion), &options)
}

fn slip_line(k: f64, history: &StackHistory, peak_m: f64, residual_m: f64) {
    let joint = &history.joints[0];
    let residual = joint.slip_m.last().unwrap()[0];
    println!(
        "k_n {k:.0e}: peak {:.4} mm ({:+.4} %), residual {:.4} mm ({:+.4} % of the peak); {}",
        1e3 * joint.peak_slip_m,
        100.0 * (joint.peak_slip_m / peak_m - 1.0),
        1e3 * residual,
        100.0 * (residual - residual_m) / peak_m,
        quality(history)
    );
}

fn sine() {
    let g = 9.80665;
    let exact = sine_slip(0.5 * g, 2.0, 10.0, 0.01, &Friction::single(0.3, g)).unwrap();
    println!(
        "exact {:.5} mm, {:.5} mm",
        1e3 * exact.peak_m,
        1e3 * exact.residual_m
    );
    for k in [1e9, 1e10, 1e11, 1e12] {
        slip_line(k, &sine_history(k, None), exact.peak_m, exact.residual_m);
    }
}

/// El Centro 1940 north-south scaled to a peak, m/s² every 0.02 s.
fn el_centro(peak_m_s2: f64) -> Vec<f64> {
    let text = include_str!("../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').nth(1)?.parse().ok());
    let samples: Vec<f64> = samples.collect();
    let peak = samples.iter().fold(0.0_f64, |most, a: &f64| most.max(a.abs()));
    samples.iter().map(|a| a / peak * peak_m_s2).collect()
}

fn record() {
    let base = el_centro(0.5 * GRAVITY_M_S2);
    let exact = record_slip(&base, 0.02, &Friction::single(0.2, GRAVITY_M_S2)).unwrap();
    let motion = GroundMotion::new("record", 0.02, vec![(Component::X, base)]).unwrap();
    println!(
        "exact {:.5} mm, {:.5} mm",
        1e3 * exact.peak_m,
        1e3 * exact.residual_m
    );
    for k in [1e9, 1e10, 1e11, 1e12] {
        let history = run(
            &pile(1, material(k, 0.2), GRAVITY_M_S2),
            Some(&motion),
            &Springs::default(),
        );
        slip_line(k, &history, exact.peak_m, exact.residual_m);
    }
}

fn twist() {
    let deceleration = rectangle_spin_deceleration_rad_s2(STONE_M[0], STONE_M[1], 0.5, GRAVITY_M_S2);
    let angle = spin_down_angle_rad(5.0, deceleration);
    for rule in [
        ContactRule::Corners,
        ContactRule::Three,
        ContactRule::Four,
        ContactRule::Six,
    ] {
        let options = Springs {
            contact_rule: rule,
            duration_s: Some(0.2),
            output_step_s: 5e-4,
            starts: vec![Start {
                spin_rad_s: [0.0, 0.0, 5.0],
                ..Start::of(0)
            }],
            ..Springs::default()
        };
        let history = run(&pile(1, material(1e9, 0.5), GRAVITY_M_S2), None, &options);
        println!(
            "{rule:?}: {:+.2} % of {:.3}°",
            100.0 * (history.joints[0].peak_yaw_rad / angle - 1.0),
            angle.to_degrees()
        );
    }
}

fn disc() {
    let disc = Block {
        name: "disc".into(),
        solid: Solid::drum(0.4, 0.1).unwrap(),
        density_kg_m3: 2600.0,
    };
    let stack = Stack::new(vec![disc], JointMaterial::with_friction(0.3), GRAVITY_M_S2).unwrap();
    let options = Springs {
        duration_s: Some(0.6),
        output_step_s: 1e-3,
        starts: vec![Start {
            velocity_m_s: [1.0, 0.0, 0.0],
            spin_rad_s: [0.0, 0.0, 5.0],
            ..Start::of(0)
        }],
        ..Springs::default()
    };
    let history = run(&stack, None, &options);
    let joint = &history.joints[0];
    let mut ratios = (1..history.time_s.len()).filter_map(|i| {
        let slid = joint.slip_m[i][0] - joint.slip_m[i - 1][0];
        let time = history.time_s[i] - history.time_s[i - 1];
        (slid / time > 0.02).then(|| slid / (0.2 * (joint.yaw_rad[i] - joint.yaw_rad[i - 1])))
    });
    let last = ratios.next_back().unwrap();
    println!(
        "v/(ωR) at a fiftieth of the speed {last:.4}, exact {:.4}",
        disc_final_speed_ratio()
    );
}

// Pagodas, rest, yaw, ramp, walls.

fn frequency() {
    let stack = p10(JointMaterial::default(), GRAVITY_M_S2).unwrap();
    for rule in [
        ContactRule::Corners,
        ContactRule::Three,
        ContactRule::Four,
        ContactRule::Six,
    ] {
        println!(
            "P10, {rule:?}: {:.5} Hz",
            stack_modes(&stack, rule).unwrap()[0].frequency_hz
        );
    }
}

fn rest() {
    let motion = GroundMotion::new(
        "push",
        0.01,
        vec![(Component::X, vec![0.29 * GRAVITY_M_S2; 6001])],
    )
    .unwrap();
    let options = Springs {
        duration_s: Some(60.0),
        output_step_s: 0.5,
        ..Springs::default()
    };
    let history = run(
        &pile(1, material(1e9, 0.3), GRAVITY_M_S2),
        Some(&motion),
        &options,
    );
    let slip = &history.joints[0].slip_m;
    println!(
        "stuck for 60 s: {:.1e} m; {}",
        slip.last().unwrap()[0] - slip[10][0],
        quality(&history)
    );
    let stack = p10(JointMaterial::default(), GRAVITY_M_S2).unwrap();
    let options = Springs {
        duration_s: Some(600.0),
        output_step_s: 5.0,
        ..Springs::default()
    };
    let history = run(&stack, None, &options);
    let mut farthest = 0.0_f64;
    for sample in 0..history.time_s.len() {
        for block in 0..10 {
            let (start, now) = (history.pose(0, block), history.pose(sample, block));
            for axis in 0..3 {
                farthest = farthest.max((now.centroid_m[axis] - start.centroid_m[axis]).abs());
            }
        }
    }
    println!("P10 for 600 s: {farthest:.1e} m; {}", quality(&history));
}

fn yaw() {
    let x = el_centro(0.5 * GRAVITY_M_S2);
    let mut y: Vec<f64> = vec![0.0; 50];
    y.extend(x.iter().take(x.len() - 50).map(|a| 0.7 * a));
    let motion = GroundMotion::new("two", 0.02, vec![(Component::X, x), (Component::Y, y)]).unwrap();
    let hole = Solid::cuboid(0.06, 0.1, 0.1).unwrap().placed(&Placement {
        position_m: [0.045, 0.0, 0.0],
        ..Placement::default()
    });
    for k in [1e9, 1e10] {
        let mut eccentric = stone(STONE_M, [0.0; 3]);
        eccentric.solid = eccentric.solid.with_opening(&hole).unwrap();
        let eccentric = Stack::new(vec![eccentric], material(k, 0.2), GRAVITY_M_S2).unwrap();
        for (name, stack) in [
            ("one stone", pile(1, material(k, 0.2), GRAVITY_M_S2)),
            ("mass 5 mm off", eccentric),
            ("two stones", pile(2, material(k, 0.2), GRAVITY_M_S2)),
        ] {
            let history = run(&stack, Some(&motion), &Springs::default());
            let joint = &history.joints[0];
            println!(
                "{name}, k_n {k:.0e}: yaw {:.1e} rad, slip {:.1} mm; {}",
                joint.peak_yaw_rad,
                1e3 * joint.peak_slip_m,
                quality(&history)
            );
        }
    }
}

fn ramp() {
    const RATE_G_S: f64 = 0.02;
    for kinetic in [0.8, 0.7, 0.6] {
        for rule in [ContactRule::Four, ContactRule::Six] {
            let material = JointMaterial {
                friction_kinetic: kinetic,
                ..material(1e9, 0.8)
            };
            let push = (0..=100).map(|i| 0.01 * f64::from(i) * GRAVITY_M_S2);
            let motion =
                GroundMotion::new("ramp", 0.01 / RATE_G_S, vec![(Component::X, push.collect())]).unwrap();
            let options = Springs {
                contact_rule: rule,
                duration_s: Some(42.0),
                output_step_s: 0.01,
                after_fall: AfterFall::Stop,
                ..Springs::default()
            };
            let history = run(&pile(1, material, GRAVITY_M_S2), Some(&motion), &options);
            let slid = history.joints[0]
                .slip_m
                .iter()
                .position(|slip| slip[0].hypot(slip[1]) > 1e-3);
            let at = slid.map(|i| RATE_G_S * history.time_s[i]);
            println!(
                "μ .8 and {kinetic}, {rule:?}: slides a millimetre at {at:.3?} g; {}",
                quality(&history)
            );
        }
    }
}

/// Seconds that this process has computed.
fn cpu_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = text
        .split_whitespace()
        .next()
        .and_then(|word| word.parse::<f64>().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

/// Ten courses of twenty stones in running bond, with half stones at the ends of every other course.
fn wall() {
    let mut blocks = Vec::new();
    for course in 0..10 {
        let z = 0.2 * f64::from(course);
        if course % 2 == 0 {
            blocks.extend((0..20).map(|i| stone([0.4, 0.3, 0.2], [0.4 * f64::from(i), 0.0, z])));
        } else {
            blocks.extend([-0.1, 7.7].map(|x| stone([0.2, 0.3, 0.2], [x, 0.0, z])));
            blocks.extend((0..19).map(|i| stone([0.4, 0.3, 0.2], [0.4 * f64::from(i) + 0.2, 0.0, z])));
        }
    }
    let count = blocks.len();
    let stack = Stack::new(blocks, JointMaterial::default(), GRAVITY_M_S2).unwrap();
    let across: Vec<f64> = el_centro(0.3 * GRAVITY_M_S2).into_iter().take(101).collect();
    let motion = GroundMotion::new("record", 0.02, vec![(Component::Y, across)]).unwrap();
    let options = |duration_s| Springs {
        duration_s: Some(duration_s),
        ..Springs::default()
    };
    let before = cpu_s();
    let _ = run(&stack, Some(&motion), &options(0.001));
    let settling = cpu_s() - before;
    let history = run(&stack, Some(&motion), &options(2.0));
    let loop_s = cpu_s() - before - 2.0 * settling;
    println!(
        "{count} stones, {} joints, {} points: {settling:.2} s to settle, {:.2} s a simulated second, {:.2} µs a stone and step; {}",
        stack.joints().len(),
        history.contact_points,
        0.5 * loop_s,
        1e6 * loop_s / (history.steps * count) as f64,
        quality(&history)
    );
}
