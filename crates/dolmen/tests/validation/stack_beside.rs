// SOURCE     The plane motion of one block on a bed with a spring beside it, with its two equations written here.
// GOAL       Natural frequencies, the factor on all springs and the factors on joints of a stack with side supports.
// PARAMETERS a stone of 0.6 × 0.5 × 1.6 m on its bed, springs beside it of 10 MN/m, 0.5 m above its middle.
// TOLERANCE  frequencies 1e-6 (the stone settles by 1e-5 of its height); factors 1e-4, the effect of a new settlement; with one factor per
//            joint 1e-3.

use dolmen::blocks::{
    BesideInSmallMotion, ContactRule, JointFactorsOptions, MeasuredStackMode, StackMotion,
    beside_in_small_motion, calibrate_springs, first_sway, joint_factors, lowest_stack_modes, stack_modes,
};
use dolmen::structure::MeasuredMode;
use dolmen::structure::stack::{Block, JointMaterial, Placement, SideSupport, Solid, Stack};
use std::f64::consts::TAU;

const SIZE_M: [f64; 3] = [0.6, 0.5, 1.6];
const DENSITY: f64 = 2600.0;
const BESIDE_N_M: f64 = 1e7;
const ABOVE_MIDDLE_M: f64 = 0.5;
const RULE: ContactRule = ContactRule::Four;

fn bare() -> Stack {
    let [width, depth, height] = SIZE_M;
    let block = Block {
        name: "stone".into(),
        solid: Solid::cuboid(width, depth, height)
            .unwrap()
            .placed(&Placement::default()),
        density_kg_m3: DENSITY,
    };
    Stack::new(vec![block], JointMaterial::default(), 9.81).unwrap()
}

fn support(stack: &Stack, sign: f64, gap_m: f64, stiffness_n_m: f64) -> SideSupport {
    let [x, y, z] = stack.blocks()[0].solid.centroid_m();
    SideSupport {
        block: 0,
        position_m: [x + sign * 0.5 * SIZE_M[0], y, z + ABOVE_MIDDLE_M],
        direction: [sign, 0.0, 0.0],
        gap_m,
        stiffness_n_m,
    }
}

fn held(supports: &[(f64, f64, f64)]) -> Stack {
    let stack = bare();
    supports.iter().fold(stack, |stack, (sign, gap_m, k)| {
        let support = support(&stack, *sign, *gap_m, *k);
        stack.with_side_support(support).unwrap()
    })
}

fn first_x(stack: &Stack) -> f64 {
    let modes = stack_modes(stack, RULE).unwrap();
    modes[first_sway(&modes, 0).unwrap()].frequency_hz
}

/// The lower frequency of u and θ: k_s A (u − θ h/2)², k_n I θ², k (u + θ c)².
fn by_hand(factor: f64, beside_n_m: f64) -> f64 {
    let [b, d, h] = SIZE_M;
    let material = JointMaterial::default();
    let (shear, turn) = (
        factor * material.shear_stiffness_pa_m * b * d,
        factor * material.normal_stiffness_pa_m * d * b.powi(3) / 12.0,
    );
    let mass = DENSITY * b * d * h;
    let inertia = mass * (b * b + h * h) / 12.0;
    let k = [
        shear + beside_n_m,
        -shear * h / 2.0 + beside_n_m * ABOVE_MIDDLE_M,
        shear * h * h / 4.0 + turn + beside_n_m * ABOVE_MIDDLE_M.powi(2),
    ];
    // m J λ² − (k_uu J + k_θθ m) λ + det k = 0
    let (sum, det) = (
        k[0] / mass + k[2] / inertia,
        (k[0] * k[2] - k[1] * k[1]) / (mass * inertia),
    );
    let lowest = 0.5 * (sum - (sum * sum - 4.0 * det).sqrt());
    lowest.sqrt() / TAU
}

#[test]
fn exact_two_opposite_supports_without_a_gap_are_one_spring() {
    let (free, both) = (by_hand(1.0, 0.0), by_hand(1.0, BESIDE_N_M));
    assert!(both > 1.1 * free, "{free} {both}");
    let pair = held(&[(1.0, 0.0, BESIDE_N_M), (-1.0, 0.0, BESIDE_N_M)]);
    for (stack, hz) in [(bare(), free), (pair, both)] {
        let found = first_x(&stack);
        assert!((found / hz - 1.0).abs() < 1e-6, "{found} {hz}");
    }
}

#[test]
fn holds_a_gap_and_a_push_of_one_side_are_no_springs() {
    use BesideInSmallMotion::{Gap, OneWay, Opposite, Pressed};
    let free = by_hand(1.0, 0.0);
    for (supports, kinds, hz) in [
        (vec![(1.0, 0.0, 1e7)], vec![OneWay], free),
        (vec![(1.0, 1e-3, 1e7), (-1.0, 1e-3, 1e7)], vec![Gap; 2], free),
        (vec![(1.0, 0.0, 1e7), (-1.0, 0.0, 2e7)], vec![OneWay; 2], free),
        (vec![(1.0, 0.0, 1e7), (-1.0, 1e-3, 1e7)], vec![OneWay, Gap], free),
        (
            vec![(1.0, 0.0, 1e7), (-1.0, 0.0, 1e7)],
            vec![Opposite; 2],
            by_hand(1.0, 1e7),
        ),
    ] {
        let stack = held(&supports);
        assert_eq!(beside_in_small_motion(&stack, RULE).unwrap(), kinds);
        let found = first_x(&stack);
        assert!((found / hz - 1.0).abs() < 1e-6, "{kinds:?} {found} {hz}");
    }
    // pushed against one support, it is held by that one only
    let load = dolmen::structure::stack::StaticLoad {
        block: 0,
        position_m: bare().blocks()[0].solid.centroid_m(),
        force_n: [500.0, 0.0, 0.0],
    };
    let pressed = |supports: &[(f64, f64, f64)]| held(supports).with_static_load(load).unwrap();
    for (supports, kinds) in [
        (vec![(1.0, 0.0, 1e7)], vec![Pressed]),
        (vec![(1.0, 0.0, 1e7), (-1.0, 0.0, 1e7)], vec![Pressed, Opposite]),
        (vec![(-1.0, 0.0, 1e7), (1.0, 0.0, 1e7)], vec![Opposite, Pressed]),
    ] {
        let stack = pressed(&supports);
        assert_eq!(beside_in_small_motion(&stack, RULE).unwrap(), kinds);
        let (found, hz) = (first_x(&stack), by_hand(1.0, 1e7));
        assert!((found / hz - 1.0).abs() < 1e-3, "{kinds:?} {found} {hz}");
    }
}

#[test]
fn exact_the_stiffness_of_supports_is_not_written_to_the_joints() {
    let stack = held(&[(1.0, 0.0, BESIDE_N_M), (-1.0, 0.0, BESIDE_N_M)]);
    for factor in [0.6, 1.0, 1.7] {
        let hz = by_hand(factor, BESIDE_N_M);
        let modes = stack_modes(&stack, RULE).unwrap();
        let first = first_sway(&modes, 0).unwrap();
        let all = calibrate_springs(&stack, RULE, &[(first, hz)], None).unwrap();
        assert!(
            (all.factor / factor - 1.0).abs() < 1e-4,
            "{factor}: {}",
            all.factor
        );
        let measured = MeasuredStackMode {
            motion: StackMotion::X,
            mode: MeasuredMode {
                frequency_hz: hz,
                frequency_sd_hz: 1e-4 * hz,
                frequency_changes_hz: Vec::new(),
                shape: Vec::new(),
            },
        };
        let found = joint_factors(&stack, &[measured], &JointFactorsOptions::default()).unwrap();
        assert!(
            (found.common.factor / factor - 1.0).abs() < 1e-3,
            "{factor}: {}",
            found.common.factor
        );
    }
}

#[test]
fn agrees_lowest_modes_of_many_stones_with_those_of_the_full_matrix() {
    let mut z = 0.0;
    let blocks = (0..48).map(|i| {
        let place = Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        z += 0.3;
        Block {
            name: format!("stone {i}"),
            solid: Solid::cuboid(3.0 - 0.02 * f64::from(i), 2.6 - 0.015 * f64::from(i), 0.3)
                .unwrap()
                .placed(&place),
            density_kg_m3: DENSITY,
        }
    });
    let free = Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap();
    let middle = free.blocks()[30].solid.centroid_m();
    let mut stack = free.clone();
    for sign in [1.0, -1.0] {
        let support = SideSupport {
            block: 30,
            position_m: middle,
            direction: [sign, 0.0, 0.0],
            gap_m: 0.0,
            stiffness_n_m: 1e9,
        };
        stack = stack.with_side_support(support).unwrap();
    }
    let all = stack_modes(&stack, RULE).unwrap();
    let lowest = lowest_stack_modes(&stack, RULE, 10).unwrap();
    for (full, found) in all.iter().zip(&lowest).take(10) {
        assert!((found.frequency_hz / full.frequency_hz - 1.0).abs() < 1e-8);
    }
    assert!(
        first_x(&stack) > 1.05 * first_x(&free),
        "{} {}",
        first_x(&stack),
        first_x(&free)
    );
}
