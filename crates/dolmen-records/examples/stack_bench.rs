//! P10 under El Centro, both horizontal components, for bench/stack: CPU seconds of the stepping loop.
//!
//! `stack_bench MOTION180.AT2 MOTION270.AT2 [PEAK_G]`: prints one line per contact rule.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    reason = "a measurement that fails loudly"
)]

use dolmen::blocks::{
    ContactLaw, ContactRule, Outcome, Rigid, Springs, StackRun, simulate_springs_many, simulate_stack,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{JointMaterial, Stack};

const GRAVITY_M_S2: f64 = 9.81;

/// CPU seconds of this process.
fn cpu_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = text
        .split_whitespace()
        .next()
        .and_then(|word| word.parse::<f64>().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

/// Time step and samples of an AT2 file, in g.
fn at2(path: &str) -> (f64, Vec<f64>) {
    let text = std::fs::read_to_string(path).unwrap();
    let header = text.lines().nth(3).unwrap();
    let step = header
        .split("DT=")
        .nth(1)
        .unwrap()
        .split_whitespace()
        .next()
        .unwrap();
    let samples = text.lines().skip(4).flat_map(str::split_whitespace);
    (
        step.parse().unwrap(),
        samples.map(|word| word.parse().unwrap()).collect(),
    )
}

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let peak_g = arguments.get(2).map_or(0.3, |word| word.parse().unwrap());
    let ((step_s, x), (_, y)) = (at2(&arguments[0]), at2(&arguments[1]));
    let peak = x.iter().fold(0.0_f64, |most, a| most.max(a.abs()));
    let scaled = |series: &[f64]| -> Vec<f64> {
        let length = x.len().min(y.len());
        series[..length]
            .iter()
            .map(|a| a / peak * peak_g * GRAVITY_M_S2)
            .collect()
    };
    let series = vec![(Component::X, scaled(&x)), (Component::Y, scaled(&y))];
    let motion = GroundMotion::new("El Centro", step_s, series).unwrap();
    let motion = motion.keep_first(30.0).unwrap().tapered(0.1).unwrap();
    let stack = dolmen::comparisons::p10(JointMaterial::default(), GRAVITY_M_S2).unwrap();
    let springs = |contact_rule| {
        ContactLaw::Springs(Springs {
            contact_rule,
            duration_s: Some(30.0),
            output_step_s: 0.02,
            ..Springs::default()
        })
    };
    let rigid = ContactLaw::Rigid(Rigid {
        duration_s: Some(30.0),
        output_step_s: 0.02,
        ..Rigid::default()
    });
    for (name, law) in [
        ("dolmen_4_points", springs(ContactRule::Corners)),
        ("dolmen_16_points", springs(ContactRule::Four)),
        ("dolmen_rigid", rigid),
    ] {
        let before = cpu_s();
        let history = simulate_stack(&stack, Some(&motion), &law, &mut |_| true).unwrap();
        let loop_cpu_s = cpu_s() - before;
        let top = stack.blocks().len() - 1;
        let start = history.pose(0, top).centroid_m;
        let away = |sample: usize| {
            let now = history.pose(sample, top).centroid_m;
            (now[0] - start[0]).hypot(now[1] - start[1]) * 1e3
        };
        let samples = 0..history.time_s.len();
        let peak_mm = samples.map(away).fold(0.0, f64::max);
        let residual_mm = away(history.time_s.len() - 1);
        let joint_mm = history
            .joints
            .iter()
            .map(|joint| joint.residual_slip_m())
            .fold(0.0, f64::max)
            * 1e3;
        println!(
            "{name} loop_cpu_s={loop_cpu_s:.4} peak_mm={peak_mm:.3} residual_mm={residual_mm:.3} joint_mm={joint_mm:.3}"
        );
    }
    ensemble(&stack, &motion, peak_g);
}

/// Many runs in parallel, at half to one and a half times the peak, 4 points: block-steps per second and core.
fn ensemble(stack: &Stack, motion: &GroundMotion, peak_g: f64) {
    const RUNS: usize = 64;
    let options = Springs {
        contact_rule: ContactRule::Corners,
        duration_s: Some(30.0),
        output_step_s: 0.1,
        ..Springs::default()
    };
    let peak = |run: usize| peak_g * GRAVITY_M_S2 * (0.5 + run as f64 / (RUNS - 1) as f64);
    let motions: Vec<GroundMotion> = (0..RUNS)
        .map(|run| motion.clone().scaled_to_peak(Component::X, peak(run)).unwrap())
        .collect();
    let runs: Vec<StackRun<'_>> = motions
        .iter()
        .map(|motion| StackRun {
            stack,
            motion: Some(motion),
            options: &options,
        })
        .collect();
    let (mut block_steps, mut fell, mut step_s) = (0, 0, 0.0);
    let before = cpu_s();
    simulate_springs_many(&runs, &mut |_, _| true, &mut |_, history| {
        let history = history.unwrap();
        block_steps += history.steps * history.blocks;
        fell += usize::from(matches!(history.outcome, Outcome::Fell { .. }));
        step_s = history.time_step_s;
    });
    let loop_cpu_s = cpu_s() - before;
    let each_s = loop_cpu_s / RUNS as f64;
    let speed = block_steps as f64 / loop_cpu_s * 1e-6;
    println!(
        "dolmen_ensemble loop_cpu_s={each_s:.4} runs={RUNS} fell={fell} step_ms={:.4} mega_block_steps_a_s={speed:.2}",
        1e3 * step_s
    );
}
