// SOURCE     Hwang & Kim (2002), a sliding model of piled blocks with horizontal rotation; closed forms and event-by-event solutions of
//            known/sliding.rs and known/twisting.rs; the rigid law of this crate, which does not use modes and groups.
// GOAL       The second method for sliding is exact in one direction and correct in two; a perfect block does not yaw, and groups stay
//            stuck.
// PARAMETERS blocks 0.3 × 0.2 × 0.1 m of 2600 kg/m³, g 9.81 m/s²; El Centro NS scaled to .5 g along x, .6 of it backwards along y.
// TOLERANCE  1e-9 m in one direction, because the tolerance of the steps is 1e-8 m/s. Torque 1.1 %: 6 × 6 points of a bed.

use dolmen::blocks::{
    BlocksError, ContactRule, Rigid, Sliding, SlidingHistory, SlidingOutcome, simulate_rigid,
    simulate_sliding,
};
use dolmen::known::sliding::{Friction, record_slip};
use dolmen::known::twisting::{
    disc_final_speed_ratio, rectangle_spin_deceleration_rad_s2, spin_down_angle_rad, spin_down_time_s,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const GRAVITY_M_S2: f64 = 9.81;

fn stone(name: &str, solid: Solid, z: f64) -> Block {
    let place = Placement {
        position_m: [0.0, 0.0, z],
        ..Placement::default()
    };
    Block {
        name: name.into(),
        solid: solid.placed(&place),
        density_kg_m3: 2600.0,
    }
}

/// Blocks on top of each other, with the friction of each bed.
fn pile(materials: &[JointMaterial]) -> Stack {
    let solid = Solid::cuboid(0.3, 0.2, 0.1).unwrap();
    let blocks = (0..materials.len()).map(|i| stone(&format!("block {i}"), solid.clone(), 0.1 * i as f64));
    let mut stack = Stack::new(blocks.collect(), materials[0], GRAVITY_M_S2).unwrap();
    for (joint, material) in materials.iter().enumerate() {
        stack = stack.with_material(joint, *material).unwrap();
    }
    stack
}

fn frictions(mu: &[f64]) -> Stack {
    let materials: Vec<JointMaterial> = mu.iter().map(|mu| JointMaterial::with_friction(*mu)).collect();
    pile(&materials)
}

fn el_centro() -> Vec<f64> {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let values: Vec<f64> = text
        .lines()
        .skip(1)
        .map(|line| line.split_once(',').unwrap().1.parse().unwrap())
        .collect();
    let peak = values.iter().fold(0.0, |most: f64, a| most.max(a.abs()));
    values.iter().map(|a| a * (0.5 * GRAVITY_M_S2 / peak)).collect()
}

fn motion(components: Vec<(Component, Vec<f64>)>) -> GroundMotion {
    GroundMotion::new("motion", 0.02, components).unwrap()
}

fn two_axial(seconds: f64) -> GroundMotion {
    let x = el_centro();
    let y = x.iter().rev().map(|a| 0.6 * a).collect();
    let motion = motion(vec![(Component::X, x), (Component::Y, y)]);
    motion.keep_first(seconds).unwrap()
}

fn run(stack: &Stack, motion: Option<&GroundMotion>, options: &Sliding) -> SlidingHistory {
    let history = simulate_sliding(stack, motion, options, &mut |_| true).unwrap();
    assert!(
        history.energy_error_j <= 2e-8 * history.input_j.max(1.0),
        "{}",
        history.energy_error_j
    );
    history
}

#[test]
fn exact_a_record_in_one_direction() {
    let x = el_centro();
    // a joint is released with a delay of 1e-6 of its limit, which becomes visible if less friction acts afterwards
    let cases = [
        (0.2, 0.2, 1.0, 1e-9),
        (0.25, 0.2, 1.0, 1e-8),
        (0.3, 0.3, 0.6, 1e-9),
    ];
    for (static_, kinetic, weight, tolerance) in cases {
        let material = JointMaterial {
            friction_static: static_,
            friction_kinetic: kinetic,
            ..JointMaterial::default()
        };
        let lighter = vec![(weight - 1.0) * GRAVITY_M_S2; x.len()];
        let motion = motion(vec![(Component::X, x.clone()), (Component::Z, lighter)]);
        let friction = Friction {
            static_coefficient: weight * static_,
            kinetic_coefficient: weight * kinetic,
            gravity_m_s2: GRAVITY_M_S2,
        };
        let exact = record_slip(&x, 0.02, &friction).unwrap();
        let options = Sliding {
            output_step_s: 0.02,
            duration_s: Some(31.18), // what comes after has other weight
            ..Sliding::default()
        };
        let history = run(&pile(&[material]), Some(&motion), &options);
        let joint = &history.joints[0];
        assert_eq!(history.outcome, SlidingOutcome::Slid);
        assert!(
            (joint.peak_slip_m - exact.peak_m).abs() < tolerance,
            "{} {}",
            joint.peak_slip_m,
            exact.peak_m
        );
        for (seen, expected) in joint.slip_m.iter().zip(&exact.slip_m) {
            assert!(
                (seen[0] - expected).abs() < tolerance && seen[1].abs() < 1e-12,
                "{seen:?} {expected}"
            );
        }
        assert!(joint.peak_yaw_rad < 1e-12);
        assert!(history.spells.len() > 10);
    }
}

#[test]
fn exact_spin_that_dies() {
    let slows = rectangle_spin_deceleration_rad_s2(0.3, 0.2, 0.5, GRAVITY_M_S2);
    let (time, angle) = (spin_down_time_s(5.0, slows), spin_down_angle_rad(5.0, slows));
    let stack = frictions(&[0.5]);
    for (contact_rule, tolerance) in [(ContactRule::Four, 0.045), (ContactRule::Six, 0.011)] {
        let options = Sliding {
            contact_rule,
            starts: vec![[0.0, 0.0, 5.0]],
            duration_s: Some(0.5),
            ..Sliding::default()
        };
        let history = run(&stack, None, &options);
        let stopped = history.spells[0].to_s;
        assert!((stopped / time - 1.0).abs() < tolerance, "{stopped} {time}");
        assert!((history.joints[0].residual_yaw_rad() / angle - 1.0).abs() < tolerance);
    }
}

#[test]
fn agrees_a_disc_slides_and_spins_to_one_end() {
    let disc = Solid::prism(32, 0.4, 1e-3).unwrap(); // thin: a high one presses more on its front
    let stack = Stack::new(
        vec![stone("disc", disc, 0.0)],
        JointMaterial::with_friction(0.3),
        GRAVITY_M_S2,
    )
    .unwrap();
    for start in [[0.11, 0.0, 1.0], [0.16, 0.0, 1.0]] {
        let options = Sliding {
            starts: vec![start],
            duration_s: Some(0.5),
            output_step_s: 1e-5,
            ..Sliding::default()
        };
        let history = run(&stack, None, &options);
        // both speeds over the last part of the path: they decrease in proportion, and so do the remaining paths
        let joint = &history.joints[0];
        let (slip, yaw) = (joint.slip_m.last().unwrap()[0], *joint.yaw_rad.last().unwrap());
        let at = (history.spells[0].to_s / 1e-5) as usize - 20;
        let ratio = (slip - joint.slip_m[at][0]) / (0.2 * (yaw - joint.yaw_rad[at]));
        assert!((ratio - disc_final_speed_ratio()).abs() < 0.02, "{ratio}");
    }
}

#[test]
fn holds_one_perfect_block_does_not_yaw() {
    let history = run(&frictions(&[0.2]), Some(&two_axial(31.18)), &Sliding::default());
    assert!(history.joints[0].peak_slip_m > 0.02);
    assert!(
        history.joints[0].peak_yaw_rad < 1e-11,
        "{}",
        history.joints[0].peak_yaw_rad
    );
}

/// The rigid law converges to the same motion in proportion to its step, because it ends slips at the ends of steps.
#[test]
fn agrees_two_blocks_twist_as_under_the_rigid_law() {
    let (stack, shaking) = (frictions(&[0.2, 0.15]), two_axial(6.0));
    let history = run(&stack, Some(&shaking), &Sliding::default());
    let differences = |time_step_s: f64| {
        let options = Rigid {
            contact_rule: ContactRule::Six,
            time_step_s,
            ..Rigid::default()
        };
        let rigid = simulate_rigid(&stack, Some(&shaking), &options, &mut |_| true).unwrap();
        [0, 1].map(|joint| {
            let (one, other) = (&history.joints[joint], &rigid.joints[joint]);
            let slips = one.slip_m.iter().zip(&other.slip_m);
            let slip = slips.fold(0.0, |most: f64, (a, b)| {
                most.max((a[0] - b[0]).hypot(a[1] - b[1]))
            });
            [
                slip,
                (one.peak_yaw_rad - other.peak_yaw_rad).abs() / one.peak_yaw_rad,
            ]
        })
    };
    let [coarse, fine] = [1e-3, 2.5e-4].map(differences);
    for joint in [0, 1] {
        let ratio = coarse[joint][0] / fine[joint][0];
        assert!((3.0..5.0).contains(&ratio), "{ratio}");
        assert!(fine[joint][0] < 2e-4, "{fine:?}");
        assert!(fine[joint][1] < 0.03, "{fine:?}"); // 6 × 6 points, here and there with other weights
    }
    assert!(history.joints.iter().all(|joint| joint.peak_yaw_rad > 1e-4));
}

#[test]
fn holds_blocks_that_stick_move_as_one() {
    let shaking = two_axial(10.0);
    let alone = run(&frictions(&[0.2]), Some(&shaking), &Sliding::default());
    let both = run(&frictions(&[0.2, 0.2]), Some(&shaking), &Sliding::default());
    assert_eq!(both.joints[1].peak_slip_m, 0.0); // to the bit
    assert_eq!(both.joints[1].peak_yaw_rad, 0.0);
    for (one, other) in alone.joints[0].slip_m.iter().zip(&both.joints[0].slip_m) {
        assert!((one[0] - other[0]).hypot(one[1] - other[1]) < 1e-8);
    }
}

#[test]
fn holds_turned_round_it_slides_the_other_way() {
    let shaking = two_axial(6.0);
    let stack = frictions(&[0.2, 0.15]);
    let turned = shaking.clone().scaled(-1.0).unwrap();
    let [there, back] = [shaking, turned].map(|motion| run(&stack, Some(&motion), &Sliding::default()));
    for (one, other) in there.joints.iter().zip(&back.joints) {
        for (a, b) in one.slip_m.iter().zip(&other.slip_m) {
            assert!((a[0] + b[0]).abs() < 1e-9 && (a[1] + b[1]).abs() < 1e-9);
        }
    }
}

#[test]
fn exact_it_ends_where_blocks_would_rock_or_fly() {
    let slope = 5.0;
    let ramp = |component| {
        let values = (0..200).map(|i| slope * 0.02 * f64::from(i)).collect();
        motion(vec![(component, values)])
    };
    let tall = Solid::cuboid(0.1, 0.2, 0.4).unwrap();
    let stack = Stack::new(
        vec![stone("tall", tall, 0.0)],
        JointMaterial::with_friction(0.9),
        GRAVITY_M_S2,
    )
    .unwrap();
    let history = run(&stack, Some(&ramp(Component::X)), &Sliding::default());
    let SlidingOutcome::Rocks { joint: 0, at_s } = history.outcome else {
        panic!("{:?}", history.outcome);
    };
    assert!((at_s - 0.25 * GRAVITY_M_S2 / slope).abs() < 1e-6, "{at_s}"); // a/g = B/H
    let fall = ramp(Component::Z).scaled(-1.0).unwrap();
    let history = run(&frictions(&[0.2]), Some(&fall), &Sliding::default());
    let SlidingOutcome::LeftTheGround { at_s } = history.outcome else {
        panic!("{:?}", history.outcome);
    };
    assert!((at_s - GRAVITY_M_S2 / slope).abs() < 1e-6, "{at_s}");
}

#[test]
fn refuses_what_is_no_pile_of_dry_level_beds() {
    let message = |stack: &Stack, options: &Sliding| {
        simulate_sliding(stack, None, options, &mut |_| true)
            .unwrap_err()
            .to_string()
    };
    let solid = Solid::cuboid(0.3, 0.2, 0.1).unwrap();
    let beside = Placement {
        position_m: [1.0, 0.0, 0.0],
        ..Placement::default()
    };
    let other = Block {
        name: "other".into(),
        solid: solid.placed(&beside),
        density_kg_m3: 2600.0,
    };
    let two = Stack::new(
        vec![stone("one", solid, 0.0), other],
        JointMaterial::default(),
        GRAVITY_M_S2,
    )
    .unwrap();
    assert_eq!(
        message(&two, &Sliding::default()),
        "'one' cannot be followed by the sliding model: it is not one of a single pile, each block on the one below. Use the springs or the rigid law"
    );
    let bonded = JointMaterial {
        cohesion_pa: 1e5,
        ..JointMaterial::default()
    };
    assert!(message(&pile(&[bonded]), &Sliding::default()).contains("its bed is bonded"));
    let loose = Sliding {
        tolerance_m_s: 0.0,
        ..Sliding::default()
    };
    assert_eq!(
        message(&frictions(&[0.2]), &loose),
        "tolerance_m_s is 0, but must be a positive number"
    );
    let error = simulate_sliding(
        &frictions(&[0.2]),
        None,
        &Sliding {
            starts: vec![[0.0; 3]; 2],
            ..Sliding::default()
        },
        &mut |_| true,
    );
    assert!(matches!(error, Err(BlocksError::Option { option: "starts", .. })));
}
