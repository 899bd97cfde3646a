//! Stones that spin, and how stacks sway.

use super::*;

pub(crate) fn twist() {
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

pub(crate) fn disc() {
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

pub(crate) fn frequency() {
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
