//! P10 by Rapier: `stack_rapier MOTION SETTINGS`, the motion as `case.py` writes it (ground acceleration x y, m/s², a row a step).
//!
//! The ground does not move; its acceleration is taken from gravity at every step, which is exact for a ground that does
//! not turn. Blocks never sleep: Rapier puts a body to sleep by its velocity and would not wake it for gravity.

use rapier3d_f64::prelude::*;
use rustix::time::{ClockId, clock_gettime};

/// Side and height, m, bottom up.
const P10: [(f64, f64); 10] = [
    (2.4, 0.5),
    (2.6, 0.25),
    (1.9, 0.9),
    (2.1, 0.25),
    (1.1, 1.1),
    (1.9, 0.5),
    (1.0, 0.45),
    (1.65, 0.45),
    (0.85, 0.40),
    (1.4, 0.40),
];
const GRAVITY: f64 = 9.81;
const DENSITY: f64 = 2600.0;
const FRICTION: f64 = 0.6;
const STEP_S: f64 = 1e-3;
const SETTLE_STEPS: usize = 2_000;
const QUIET_STEPS: usize = 10_000;

fn cpu_s() -> f64 {
    let now = clock_gettime(ClockId::ProcessCPUTime);
    now.tv_sec as f64 + 1e-9 * now.tv_nsec as f64
}

fn world(parameters: IntegrationParameters) -> (PhysicsWorld, Vec<RigidBodyHandle>) {
    let mut world = PhysicsWorld::new();
    world.integration_parameters = parameters;
    world.gravity = Vector::new(0.0, 0.0, -GRAVITY);
    world.insert(
        RigidBodyBuilder::fixed().translation(Vector::new(0.0, 0.0, -1.0)),
        ColliderBuilder::cuboid(10.0, 10.0, 1.0).friction(FRICTION),
    );
    let mut base = 0.0;
    let blocks = P10.map(|(side, height)| {
        let centre = Vector::new(0.0, 0.0, base + height / 2.0);
        base += height;
        let body = RigidBodyBuilder::dynamic().translation(centre).can_sleep(false);
        let shape = ColliderBuilder::cuboid(side / 2.0, side / 2.0, height / 2.0);
        world.insert(body, shape.density(DENSITY).friction(FRICTION)).0
    });
    (world, blocks.to_vec())
}

fn run(name: &str, parameters: IntegrationParameters, motion: &[(f64, f64)]) {
    let (mut world, blocks) = world(parameters);
    let places = |world: &PhysicsWorld| -> Vec<Vector> {
        blocks.iter().map(|b| world.bodies[*b].translation()).collect()
    };
    for _ in 0..SETTLE_STEPS {
        world.step();
    }
    let settled = places(&world);
    let top = blocks[blocks.len() - 1];
    let from = settled[blocks.len() - 1];
    let mut peak = 0.0_f64;
    let began = cpu_s();
    for &(x, y) in &motion[..motion.len() - 1] {
        world.gravity = Vector::new(-x, -y, -GRAVITY);
        world.step();
        peak = peak.max((world.bodies[top].translation() - from).length());
    }
    let loop_s = cpu_s() - began;
    let shaken = places(&world);
    world.gravity = Vector::new(0.0, 0.0, -GRAVITY);
    for _ in 0..QUIET_STEPS {
        world.step();
    }
    let quiet = places(&world);

    let residual: Vec<Vector> = shaken.iter().zip(&settled).map(|(a, b)| *a - *b).collect();
    let mut below = Vector::new(0.0, 0.0, 0.0);
    let mut joint = 0.0_f64;
    for r in &residual {
        joint = joint.max((r.x - below.x).hypot(r.y - below.y));
        below = *r;
    }
    let last = blocks.len() - 1;
    println!(
        "{name} loop_cpu_s={loop_s:.6} peak_mm={:.6} residual_mm={:.6} joint_mm={:.6} creep_mm={:.6}",
        1e3 * peak,
        1e3 * residual[last].length(),
        1e3 * joint,
        1e3 * (quiet[last] - shaken[last]).length(),
    );
}

/// The settings called `name`; every value is Rapier's own but the step and what is named here.
///
/// Contact softness (natural frequency, damping ratio) is 30 Hz, 10 between blocks and 60 Hz, 10 on the ground by itself:
/// a stack this heavy then leans by centimetres. The stiffer ones are the best of 250, 1000 and 1e6 Hz, each with damping
/// 1, 5, 10 where it was tried, 1 to 8 iterations and both friction models: `fast` the cheapest with less than .05 mm left,
/// `tuned` the one with least left.
fn settings(name: &str) -> Option<IntegrationParameters> {
    let rapiers = IntegrationParameters {
        dt: STEP_S,
        ..Default::default()
    };
    let stiff = |natural_frequency, num_solver_iterations| {
        let contact_softness = SpringCoefficients {
            natural_frequency,
            damping_ratio: 5.0,
        };
        IntegrationParameters {
            contact_softness,
            static_contact_softness: contact_softness,
            num_solver_iterations,
            ..rapiers
        }
    };
    match name {
        "rapier_default" => Some(rapiers),
        "rapier_fast" => Some(stiff(250.0, 1)),
        "rapier_tuned" => Some(stiff(1000.0, 4)),
        _ => None,
    }
}

fn main() {
    let words: Vec<String> = std::env::args().skip(1).collect();
    let [file, name] = &words[..] else {
        panic!("stack_rapier MOTION SETTINGS")
    };
    let parameters = settings(name).expect("rapier_default, rapier_fast or rapier_tuned");
    let motion: Vec<(f64, f64)> = std::fs::read_to_string(file)
        .expect("the motion can be read")
        .lines()
        .map(|line| {
            let (x, y) = line.split_once(' ').expect("two numbers a row");
            (x.parse().expect("x"), y.parse().expect("y"))
        })
        .collect();
    run(name, parameters, &motion);
}
