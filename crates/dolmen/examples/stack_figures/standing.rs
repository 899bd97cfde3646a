//! Stacks at rest, yaw, slow ramps, and a wall.

use super::sliding::el_centro;
use super::*;

pub(crate) fn rest() {
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

pub(crate) fn yaw() {
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

pub(crate) fn ramp() {
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
pub(crate) fn cpu_s() -> f64 {
    let text = std::fs::read_to_string("/proc/self/schedstat").unwrap_or_default();
    let nanoseconds = text
        .split_whitespace()
        .next()
        .and_then(|word| word.parse::<f64>().ok());
    nanoseconds.unwrap_or(f64::NAN) * 1e-9
}

/// Ten courses of twenty stones in running bond, with half stones at the ends of every other course.
pub(crate) fn wall() {
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
