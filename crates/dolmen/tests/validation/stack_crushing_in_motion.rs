// SOURCE     Rectangular stress block: an edge under the force N crushes over a strip of area N/f, and the block rotates about the middle of this strip.
// GOAL       Both laws begin to rock, fall and name crushed joints as the check of the same stack does.
//
//          │ N = m g             b × l:  strip N/(f l), pivot a = N/(2 f l) inside the edge
//        ┌─┴─────┐               begins to rock at (b/2 − a)/h g, h the height of the centroid
//        └──────┤┊░│             falls from a tilt above atan((b/2 − a)/h)
//                a               under the horizontal acceleration α g: bears f (b − 2 α h) l
//
// PARAMETERS a block of 0.5 × 0.8 × 2.4 m with a = 0.1 b/2; towers of three stones; joints of 1e11 Pa/m for springs.
// TOLERANCE  Start of rocking 2 %: the acceleration grows by 2 % of it in a second, and an opening of 0.1 mm takes 0.4 s. Ratios of the rigid law at rest
//            1e-9, because statics give them; on springs 1 %, for the vibration at the start.

use crate::stack_loads::{DENSITY_KG_M3, GRAVITY_M_S2, boxes};
use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::blocks::{
    ContactLaw, Outcome, PeakBearing, Rigid, Springs, StackHistory, StackRun, Start, simulate_springs,
    simulate_springs_many, simulate_stack,
};
use dolmen::signal::{Component, GroundMotion};
use dolmen::structure::stack::{JointMaterial, Stack};
use std::f64::consts::PI;

const WIDTH_M: f64 = 0.5;
const DEPTH_M: f64 = 0.8;
const HALF_HEIGHT_M: f64 = 1.2;
/// a, as a fraction of half the width.
const SET_BACK: f64 = 0.1;

fn with_joints(stack: &Stack, strength_pa: Option<f64>) -> Stack {
    let mut changed = stack.clone();
    for (index, joint) in stack.joints().iter().enumerate() {
        let material = JointMaterial {
            compressive_strength_pa: strength_pa,
            normal_stiffness_pa_m: 1e11,
            shear_stiffness_pa_m: 4e10,
            ..joint.material
        };
        changed = changed.with_material(index, material).unwrap();
    }
    changed
}

fn block(strength_pa: Option<f64>) -> Stack {
    let size = [WIDTH_M, DEPTH_M, 2.0 * HALF_HEIGHT_M];
    with_joints(&boxes(&[(size, [0.0; 3])], 0.9), strength_pa)
}

/// The strength at which the pivot lies `SET_BACK` b/2 inside the edge.
fn strength_pa() -> f64 {
    2.0 * HALF_HEIGHT_M * DENSITY_KG_M3 * GRAVITY_M_S2 / SET_BACK
}

/// Acceleration at which the block begins to rock, in g.
fn rocks_at_g(strength_pa: Option<f64>) -> f64 {
    let set_back = strength_pa.map_or(0.0, |_| SET_BACK);
    0.5 * WIDTH_M * (1.0 - set_back) / HALF_HEIGHT_M
}

fn laws(starts: &[Start]) -> [ContactLaw; 2] {
    let starts = starts.to_vec();
    let springs = Springs {
        starts: starts.clone(),
        rest_s: 0.0,
        ..Springs::default()
    };
    let rigid = Rigid {
        starts,
        rest_s: 0.0,
        ..Rigid::default()
    };
    [ContactLaw::Springs(springs), ContactLaw::Rigid(rigid)]
}

fn run(stack: &Stack, motion: Option<&GroundMotion>, law: &ContactLaw) -> StackHistory {
    simulate_stack(stack, motion, law, &mut |_| true).unwrap()
}

fn motion(component: Component, duration_s: f64, acceleration_m_s2: impl Fn(f64) -> f64) -> GroundMotion {
    let times = (0..=(duration_s * 100.0) as u32).map(|i| f64::from(i) / 100.0);
    GroundMotion::new(
        "pull",
        0.01,
        vec![(component, times.map(acceleration_m_s2).collect())],
    )
    .unwrap()
}

/// A smooth growth to a part of an acceleration in 2 s, then slowly to 1.03 times that acceleration, in g at a time.
fn pull_g(at_g: f64, time_s: f64) -> f64 {
    let part = match time_s < 2.0 {
        true => 0.425 * (1.0 - (0.5 * PI * time_s).cos()),
        false => 0.85 + 0.18 * (time_s - 2.0) / 8.0,
    };
    part * at_g
}

#[test]
fn exact_a_run_begins_to_rock_where_the_check_says() {
    for strength_pa in [Some(strength_pa()), None] {
        let stack = block(strength_pa);
        let exact_g = rocks_at_g(strength_pa);
        let check = check_stack(&stack, &StackCheckOptions::default()).unwrap();
        let checked_g = check.capacity.unwrap().acceleration_g;
        assert!((checked_g / exact_g - 1.0).abs() < 1e-8, "{checked_g} {exact_g}");
        for law in laws(&[]) {
            let pull = motion(Component::X, 10.0, |time_s| {
                pull_g(exact_g, time_s) * GRAVITY_M_S2
            });
            let history = run(&stack, Some(&pull), &law);
            let opening_m = &history.joints[0].opening_m;
            let opened = opening_m.iter().position(|m| *m > StackHistory::UPLIFT_LEAST_M);
            let at_s = history.time_s[opened.unwrap()];
            let began_g = pull_g(exact_g, at_s);
            assert!(
                (began_g / exact_g - 1.0).abs() < 0.02,
                "{}: {began_g} {exact_g}",
                law.name()
            );
            assert_eq!(history.joints[0].bearing.is_some(), strength_pa.is_some());
        }
    }
}

#[test]
fn exact_free_rocking_falls_beyond_the_reduced_critical_angle() {
    let fallen = |strength_pa: Option<f64>, pivot_m: f64, tilt_rad: f64| {
        let start = Start {
            pivot_m: [pivot_m, 0.0, 0.0],
            turn_rad: [0.0, tilt_rad, 0.0],
            ..Start::of(0)
        };
        laws(&[start]).map(|mut law| {
            match &mut law {
                ContactLaw::Springs(springs) => springs.duration_s = Some(6.0),
                ContactLaw::Rigid(rigid) => rigid.duration_s = Some(6.0),
            }
            let history = run(&block(strength_pa), None, &law);
            matches!(history.outcome, Outcome::Fell { .. })
        })
    };
    let reduced_rad = rocks_at_g(Some(strength_pa())).atan();
    let full_rad = rocks_at_g(None).atan();
    let [inside_m, edge_m] = [0.5 * WIDTH_M * (1.0 - SET_BACK), 0.5 * WIDTH_M];
    assert_eq!(
        fallen(Some(strength_pa()), inside_m, 0.98 * reduced_rad),
        [false; 2]
    );
    assert_eq!(
        fallen(Some(strength_pa()), inside_m, 1.02 * reduced_rad),
        [true; 2]
    );
    assert_eq!(fallen(None, edge_m, 1.02 * reduced_rad), [false; 2]);
    assert_eq!(fallen(None, edge_m, 0.98 * full_rad), [false; 2]);
    assert_eq!(fallen(None, edge_m, 1.02 * full_rad), [true; 2]);
}

#[test]
fn exact_a_bed_bears_less_the_nearer_the_force_is_to_its_edge() {
    let stack = block(Some(strength_pa()));
    // nine tenths of the acceleration at which it begins to rock
    let most_g = 0.9 * rocks_at_g(Some(strength_pa()));
    let pull = motion(Component::X, 4.0, |time_s| {
        0.5 * most_g * GRAVITY_M_S2 * (1.0 - (0.25 * PI * time_s).cos())
    });
    let [springs, rigid] = laws(&[]).map(|law| {
        let history = run(&stack, Some(&pull), &law);
        history.joints[0].bearing.unwrap()
    });
    let off_m = most_g * HALF_HEIGHT_M;
    let weight_n = WIDTH_M * DEPTH_M * 2.0 * HALF_HEIGHT_M * DENSITY_KG_M3 * GRAVITY_M_S2;
    let bears_n = strength_pa() * (WIDTH_M - 2.0 * off_m) * DEPTH_M;
    let is_near = |found: &PeakBearing, tolerance: f64| {
        assert!(
            (found.ratio / (weight_n / bears_n) - 1.0).abs() < tolerance,
            "{found:?}"
        );
        assert!((found.force_n / weight_n - 1.0).abs() < tolerance, "{found:?}");
        // the ground moves to +x: the stone leans to −x
        assert!(
            (found.place_m[0] + off_m).abs() < tolerance * WIDTH_M,
            "{found:?}"
        );
        assert!(
            found.place_m[1].abs() < tolerance && found.place_m[2].abs() < tolerance,
            "{found:?}"
        );
        assert!(!found.crushes() && found.at_s > 3.9, "{found:?}");
    };
    is_near(&rigid, 1e-9);
    is_near(&springs, 0.01);
}

#[test]
fn exact_only_the_lowest_joint_of_a_tower_crushes_under_a_vertical_shake() {
    let heights = [0.0, 0.5, 1.0].map(|z| ([0.6, 0.6, 0.5], [0.0, 0.0, z]));
    let tower = boxes(&heights, 0.7);
    let pressure_pa = 1.5 * DENSITY_KG_M3 * GRAVITY_M_S2;
    let stack = with_joints(&tower, Some(1.25 * pressure_pa));
    let shake = motion(Component::Z, 2.0, |time_s| {
        0.4 * GRAVITY_M_S2 * (1.0 - (PI * time_s).cos()) * 0.5
    });
    for (law, tolerance) in laws(&[]).iter().zip([0.01, 1e-9]) {
        let history = run(&stack, Some(&shake), law);
        for (joint, stones) in [3.0, 2.0, 1.0].into_iter().enumerate() {
            let found = history.joints[joint].bearing.unwrap();
            let exact = 0.8 * 1.4 * stones / 3.0;
            assert!(
                (found.ratio / exact - 1.0).abs() < tolerance,
                "{}: {found:?}",
                law.name()
            );
            assert!((found.at_s - 1.0).abs() < 0.05, "{found:?}");
            assert_eq!(found.crushes(), joint == 0, "{found:?}");
        }
    }
}

#[test]
fn holds_runs_side_by_side_crush_as_a_run_alone() {
    let stack = block(Some(strength_pa()));
    let pull = motion(Component::X, 1.0, |time_s| 4.0 * (2.0 * PI * time_s).sin());
    let options = Springs {
        rest_s: 0.0,
        ..Springs::default()
    };
    let alone = simulate_springs(&stack, Some(&pull), &options, &mut |_| true).unwrap();
    assert!(alone.joints[0].bearing.unwrap().crushes());
    let given = StackRun {
        stack: &stack,
        motion: Some(&pull),
        options: &options,
    };
    let mut seen = 0;
    simulate_springs_many(&[given; 2], &mut |_, _| true, &mut |_, history| {
        assert_eq!(history.unwrap(), alone);
        seen += 1;
    });
    assert_eq!(seen, 2);
}
