//! P20 and P10 that rock under El Centro, by both laws, and towers in motion: the tables of `docs/stack-engine.md`.
//!
//! `rigid_pagodas MOTION180.AT2 MOTION270.AT2 [p20|spread|towers]`: the motions are PEER's RSN6, 180 along x and 270 along y, first
//! 30 s with .1 s of taper, scaled together so that 180 has the peak said.
#![allow(
    clippy::print_stdout,
    clippy::unwrap_used,
    clippy::disallowed_methods,
    reason = "a measurement that fails loudly and reads its own processor time"
)]

use dolmen::blocks::{ContactLaw, ContactRule, Outcome, Rigid, Springs, StackHistory, simulate_stack};
use dolmen::comparisons::{p10, p20};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

/// Prints a table, of motions by their peak, g.
type Case = fn(&dyn Fn(f64) -> GroundMotion);

const GRAVITY_M_S2: f64 = 9.81;
const RULES: [(&str, ContactRule); 4] = [
    ("corners", ContactRule::Corners),
    ("3 × 3", ContactRule::Three),
    ("4 × 4", ContactRule::Four),
    ("6 × 6", ContactRule::Six),
];

fn main() {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let [x, y] = [at2(&arguments[0]), at2(&arguments[1])];
    let wanted = arguments.get(2).map_or("", String::as_str);
    let motion = |peak_g: f64| el_centro(&x, &y, peak_g);
    let cases: [(&str, Case); 3] = [("p20", table), ("spread", spread), ("towers", towers)];
    for (name, case) in cases {
        if name.starts_with(wanted) {
            println!("# {name}");
            case(&motion);
        }
    }
}

/// Step and samples of an AT2 file, in g.
fn at2(path: &str) -> (f64, Vec<f64>) {
    let text = std::fs::read_to_string(path).unwrap();
    let header = text.lines().nth(3).unwrap();
    let step = header.split("DT=").nth(1).unwrap();
    let samples = text.lines().skip(4).flat_map(str::split_whitespace);
    (
        step.split_whitespace().next().unwrap().parse().unwrap(),
        samples.map(|word| word.parse().unwrap()).collect(),
    )
}

fn el_centro((step_s, x): &(f64, Vec<f64>), (_, y): &(f64, Vec<f64>), peak_g: f64) -> GroundMotion {
    let peak = x.iter().fold(0.0_f64, |most, a| most.max(a.abs()));
    let length = x.len().min(y.len());
    let scaled = |series: &[f64]| -> Vec<f64> {
        let series = series[..length].iter();
        series.map(|a| a / peak * peak_g * GRAVITY_M_S2).collect()
    };
    let series = vec![(Component::X, scaled(x)), (Component::Y, scaled(y))];
    let motion = GroundMotion::new("El Centro", *step_s, series).unwrap();
    motion.keep_first(30.0).unwrap().tapered(0.1).unwrap()
}

/// Seconds that this process has computed.
fn cpu_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let word = text.split_whitespace().next();
    word.and_then(|word| word.parse::<f64>().ok()).unwrap_or(f64::NAN) * 1e-9
}

fn run(stack: &Stack, motion: &GroundMotion, law: &ContactLaw) -> (StackHistory, f64) {
    let before = cpu_s();
    let history = simulate_stack(stack, Some(motion), law, &mut |_| true).unwrap();
    (history, cpu_s() - before)
}

fn rigid(contact_rule: ContactRule, step_ms: f64, duration_s: f64) -> ContactLaw {
    ContactLaw::Rigid(Rigid {
        contact_rule,
        time_step_s: 1e-3 * step_ms,
        duration_s: Some(duration_s),
        ..Rigid::default()
    })
}

/// Way of the highest stone, seen from above: the farthest, and at the end, mm.
fn away_mm(history: &StackHistory) -> [f64; 2] {
    let top = history.blocks - 1;
    let start = history.pose(0, top).centroid_m;
    let away = |sample: usize| {
        let now = history.pose(sample, top).centroid_m;
        1e3 * (now[0] - start[0]).hypot(now[1] - start[1])
    };
    let samples = 0..history.time_s.len();
    [
        samples.map(away).fold(0.0, f64::max),
        away(history.time_s.len() - 1),
    ]
}

fn line(law: &str, rule: &str, step: &str, history: &StackHistory, loop_s: f64) {
    let [peak, left] = away_mm(history);
    let evidence = match history.rigid {
        Some(rigid) => format!(
            "{} impacts, {} solutions, law obeyed to {:.0e} m/s, {:.0e} m deep",
            rigid.impacts, rigid.solutions, rigid.residual_most_m_s, rigid.penetration_most_m
        ),
        None => format!("step {:.3} ms", 1e3 * history.time_step_s),
    };
    let outcome = match history.outcome {
        Outcome::Uplifted { at_s, .. } => format!("opens at {at_s:.3} s"),
        ref other => format!("{other:?}"),
    };
    println!(
        "| {law} | {rule} | {step} | {peak:.2} | {left:.2} | {loop_s:.2} s, {outcome}, {evidence}, made {:.0e}",
        history.energy_made_ratio()
    );
}

/// P20 at .3 g over points, steps and laws.
fn table(motion: &dyn Fn(f64) -> GroundMotion) {
    let motion = motion(0.3);
    let stack = p20(JointMaterial::default(), GRAVITY_M_S2).unwrap();
    for (name, rule) in RULES {
        for step_ms in [1.0, 0.5, 0.25] {
            let (history, loop_s) = run(&stack, &motion, &rigid(rule, step_ms, 30.0));
            line("rigid", name, &format!("{step_ms} ms"), &history, loop_s);
        }
    }
    for stiffness in [1e9, 1e10, 1e11] {
        let material = JointMaterial {
            normal_stiffness_pa_m: stiffness,
            shear_stiffness_pa_m: 0.4 * stiffness,
            damping_ratio: 1.0,
            ..JointMaterial::default()
        };
        let stack = p20(material, GRAVITY_M_S2).unwrap();
        for (name, rule) in RULES {
            let springs = ContactLaw::Springs(Springs {
                contact_rule: rule,
                duration_s: Some(30.0),
                ..Springs::default()
            });
            let (history, loop_s) = run(&stack, &motion, &springs);
            line(
                &format!("springs {stiffness:.0e}"),
                name,
                "chosen",
                &history,
                loop_s,
            );
        }
    }
}

/// P10 at .5 g and P20 at .3 and .36 g, the motion scaled by a little more or less: how runs part.
fn spread(motion: &dyn Fn(f64) -> GroundMotion) {
    let stacks = [
        ("P10", 0.5, p10(JointMaterial::default(), GRAVITY_M_S2).unwrap()),
        ("P20", 0.3, p20(JointMaterial::default(), GRAVITY_M_S2).unwrap()),
        ("P20", 0.36, p20(JointMaterial::default(), GRAVITY_M_S2).unwrap()),
    ];
    for (name, peak_g, stack) in stacks {
        for step_ms in [1.0, 0.5, 0.25] {
            let peaks = [0.0, 1e-12, 1e-9, -1e-9, 1e-6, -1e-6, 1e-3, -1e-3].map(|more| {
                let motion = motion(peak_g * (1.0 + more));
                let (history, _) = run(&stack, &motion, &rigid(ContactRule::Four, step_ms, 8.0));
                format!("{:.2}", away_mm(&history)[0])
            });
            println!(
                "{name} at {peak_g} g, {step_ms} ms, scaled by 1, 1 + 1e-12, 1 ± 1e-9, 1 ± 1e-6, 1 ± 1e-3: {} mm",
                peaks.join(" ")
            );
        }
    }
}

/// Towers of equal stones that rock and slide: instructions are better counted with valgrind.
fn towers(motion: &dyn Fn(f64) -> GroundMotion) {
    for (count, size, peak_g, duration_s) in [
        (10, [0.8, 0.3], 0.3, 2.2),
        (50, [0.8, 0.06], 0.3, 2.2),
        (200, [0.8, 0.015], 0.3, 2.2),
        (10, [0.4, 0.6], 0.6, 5.0),
        (20, [0.4, 0.3], 0.6, 3.0),
        (50, [0.4, 0.12], 0.6, 2.6),
    ] {
        let [width, height] = size;
        let stone = |i: usize| Block {
            name: format!("stone {i}"),
            density_kg_m3: 2600.0,
            solid: Solid::cuboid(width, width, height).unwrap().placed(&Placement {
                position_m: [0.0, 0.0, height * i as f64],
                ..Placement::default()
            }),
        };
        let stack = Stack::new(
            (0..count).map(stone).collect(),
            JointMaterial::default(),
            GRAVITY_M_S2,
        )
        .unwrap();
        let (history, loop_s) = run(
            &stack,
            &motion(peak_g),
            &rigid(ContactRule::Four, 1.0, duration_s),
        );
        let evidence = history.rigid.unwrap();
        let moving = (history.steps - evidence.steps_at_rest).max(1);
        println!(
            "{count} stones of {width} × {height} m at {peak_g} g: {:?}, {loop_s:.2} s, {:.1} µs a stone and step in motion, {:.1} Newton \
             steps a solution, {evidence:?}, made {:.0e}",
            history.outcome,
            1e6 * loop_s / (moving * count) as f64,
            evidence.newton_steps as f64 / evidence.solutions.max(1) as f64,
            history.energy_made_ratio()
        );
    }
}
