// SOURCE     microlp 0.7 (a simplex method), kept for this; Livesley (1978), limit analysis of rigid blocks.
// GOAL       The limit analysis with cones, in pieces and for all directions together, agrees with a linear programme over
//            all blocks in which pyramids inside and outside replace the friction cone.
// PARAMETERS 12 sides; random towers, portals and tables of posts under a slab with a stone on it, a wall in running bond;
//            friction 0.3 to 1.2, any direction.
// TOLERANCE  1e-7, the error of the solutions, beyond the two pyramids, which differ by at most 3.5 % if friction governs.

use dolmen::numeric::Random;
use dolmen::stability::stack::{LimitAnalysis, LimitAnalysisStatus, Shaking, limit_analysis};
use dolmen::structure::stack::{Block, Body, JointMaterial, Placement, Solid, Stack};
use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem};
use std::f64::consts::{PI, TAU};

const SIDES: usize = 12;

/// Boxes: size and the middle of the base.
fn stack(boxes: &[([f64; 3], [f64; 3])], friction: f64) -> Stack {
    let blocks = boxes.iter().enumerate().map(|(i, (size, at))| Block {
        name: format!("stone {i}"),
        solid: Solid::cuboid(size[0], size[1], size[2])
            .unwrap()
            .placed(&Placement {
                position_m: *at,
                ..Placement::default()
            }),
        density_kg_m3: 2600.0,
    });
    Stack::new(blocks.collect(), JointMaterial::with_friction(friction), 9.81).unwrap()
}

/// The largest acceleration over gravity; `None` if even the weight is not balanced.
fn by_simplex(stack: &Stack, way: [f64; 2], wider: f64) -> Option<f64> {
    let n = stack.blocks().len();
    let weight = stack.mass_kg() * 9.81;
    let mut problem = Problem::new(OptimizationDirection::Maximize);
    let acceleration = problem.add_var(1.0, (0.0, 100.0));
    let mut sums: Vec<LinearExpr> = (0..6 * n).map(|_| LinearExpr::empty()).collect();
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    for joint in stack.joints() {
        let mu = wider * joint.material.friction_static;
        let [first, second, normal] = joint.axes;
        for corner in &joint.patch.corners_m {
            let at: [f64; 3] =
                std::array::from_fn(|k| joint.origin_m[k] + first[k] * corner[0] + second[k] * corner[1]);
            for side in 0..SIDES {
                let angle = TAU * side as f64 / SIDES as f64;
                let (x, y) = (mu * angle.cos(), mu * angle.sin());
                let force: [f64; 3] = std::array::from_fn(|k| normal[k] + x * first[k] + y * second[k]);
                let share = problem.add_var(0.0, (0.0, f64::INFINITY));
                let mut add = |block: usize, sign: f64| {
                    let from = stack.blocks()[block].solid.centroid_m();
                    let moment = cross(std::array::from_fn(|k| at[k] - from[k]), force);
                    for k in 0..3 {
                        sums[6 * block + k].add(share, sign * force[k]);
                        sums[6 * block + 3 + k].add(share, sign * moment[k]);
                    }
                };
                add(joint.upper, 1.0);
                if let Body::Block(lower) = joint.lower {
                    add(lower, -1.0);
                }
            }
        }
    }
    for (block, stone) in stack.blocks().iter().enumerate() {
        let own = stone.mass_kg() * 9.81 / weight;
        for k in 0..2 {
            sums[6 * block + k].add(acceleration, own * way[k]);
        }
        for k in 0..6 {
            let sum = std::mem::replace(&mut sums[6 * block + k], LinearExpr::empty());
            problem.add_constraint(sum, ComparisonOp::Eq, if k == 2 { own } else { 0.0 });
        }
    }
    let solution = problem.solve().ok()?.into_solution().ok()?;
    Some(solution.var_value(acceleration))
}

fn by_cones(stack: &Stack, shaking: Shaking) -> Option<(f64, f64)> {
    let options = LimitAnalysis {
        shaking,
        ..LimitAnalysis::default()
    };
    let result = limit_analysis(stack, &options).unwrap();
    assert!(result.residual < 1e-7, "{}", result.residual);
    match result.status {
        LimitAnalysisStatus::Limited(threshold) => Some((result.at_least_g, threshold.acceleration_g)),
        LimitAnalysisStatus::DoesNotStand => None,
        other => panic!("{other:?}"),
    }
}

fn random_stack(random: &mut Random, case: usize) -> Stack {
    let mut between = |low: f64, high: f64| low + (high - low) * random.uniform();
    let friction = between(0.3, 1.2);
    let mut boxes = Vec::new();
    match case % 3 {
        0 => {
            let mut z = 0.0;
            for _ in 0..3 {
                let size = [between(0.6, 1.2), between(0.6, 1.2), between(0.3, 0.9)];
                // some of these stacks fall
                boxes.push((size, [between(-0.25, 0.25), between(-0.25, 0.25), z]));
                z += size[2];
            }
        }
        1 => {
            let (tall, apart) = (between(0.8, 2.0), between(0.5, 0.9));
            for side in [-1.0, 1.0] {
                let size = [between(0.3, 0.5), between(0.3, 0.6), tall];
                boxes.push((size, [side * apart, between(-0.1, 0.1), 0.0]));
            }
            let size = [between(1.9, 2.6), between(0.4, 0.7), between(0.2, 0.6)];
            boxes.push((size, [between(-0.1, 0.1), between(-0.1, 0.1), tall]));
            boxes.push((
                [0.5, 0.4, between(0.3, 1.0)],
                [between(-0.6, 0.6), 0.0, tall + size[2]],
            ));
        }
        _ => {
            let tall = between(0.6, 1.2);
            for (x, y) in [(-0.6, -0.5), (0.6, -0.5), (0.0, 0.6)] {
                boxes.push(([between(0.3, 0.5), between(0.3, 0.5), tall], [x, y, 0.0]));
            }
            boxes.push(([1.8, 1.7, 0.3], [between(-0.1, 0.1), between(-0.1, 0.1), tall]));
        }
    }
    stack(&boxes, friction)
}

#[test]
fn agrees_with_microlp_0_7_on_random_stacks() {
    let mut random = Random::new(20, 0);
    let (mut stood, mut fell, mut apart) = (0, 0, 0.0_f64);
    for case in 0..60 {
        let stack = random_stack(&mut random, case);
        let angle = TAU * random.uniform();
        let way = [angle.cos(), angle.sin()];
        let within = by_simplex(&stack, way, 1.0);
        let around = by_simplex(&stack, way, 1.0 / (PI / SIDES as f64).cos());
        let Some((_, found)) = by_cones(&stack, Shaking::Along(way)) else {
            assert_eq!(within, None, "case {case}");
            assert_eq!(by_cones(&stack, Shaking::AnyWay), None, "case {case}");
            fell += 1;
            continue;
        };
        stood += 1;
        let (Some(within), Some(around)) = (within, around) else {
            panic!("case {case}: {within:?} {around:?} {found}")
        };
        assert!(
            within - 1e-7 < found && found < around + 1e-7,
            "case {case}: {within} {found} {around}"
        );
        apart = apart.max(around / within - 1.0);
        // in all directions: a safe value is below any of them, and at most 2 % below a value that moves
        let (at_least, any) = by_cones(&stack, Shaking::AnyWay).unwrap();
        let along = (0..24).map(|k| {
            let angle = TAU * f64::from(k) / 24.0;
            by_cones(&stack, Shaking::Along([angle.cos(), angle.sin()]))
                .unwrap()
                .1
        });
        let least = along.fold(found, f64::min);
        assert!(at_least <= least + 1e-7, "case {case}: {at_least} {any} {least}");
        assert!(at_least >= 0.98 * any - 1e-7, "case {case}: {at_least} {any}");
    }
    assert!(stood > 40 && fell > 2, "{stood} {fell}");
    assert!(apart < 0.0355, "{apart}");
}

#[test]
fn agrees_with_microlp_0_7_on_a_wall_in_running_bond() {
    let mut boxes = Vec::new();
    for course in 0..4 {
        let shift = if course % 2 == 0 { 0.0 } else { 0.3 };
        for k in 0..3 {
            boxes.push((
                [0.6, 0.4, 0.3],
                [0.6 * f64::from(k) + shift, 0.0, 0.3 * f64::from(course)],
            ));
        }
    }
    let wall = stack(&boxes, 0.5);
    for way in [[1.0, 0.0], [0.0, 1.0], [-0.6, 0.8]] {
        let within = by_simplex(&wall, way, 1.0).unwrap();
        let around = by_simplex(&wall, way, 1.0 / (PI / SIDES as f64).cos()).unwrap();
        let (_, found) = by_cones(&wall, Shaking::Along(way)).unwrap();
        assert!(
            within - 1e-7 < found && found < around + 1e-7,
            "{within} {found} {around}"
        );
    }
}

#[test]
fn exact_a_wall_tips_as_one() {
    // 60 blocks in running bond, .4 thick and 1.8 m high: across it B/H
    let mut boxes = Vec::new();
    for course in 0..6 {
        let shift = if course % 2 == 0 { 0.0 } else { 0.2 };
        for k in 0..10 {
            boxes.push((
                [0.6, 0.4, 0.3],
                [0.6 * f64::from(k) + shift, 0.0, 0.3 * f64::from(course)],
            ));
        }
    }
    let wall = stack(&boxes, 0.6);
    let (at_least, found) = by_cones(&wall, Shaking::AnyWay).unwrap();
    assert!(
        (found - 0.4 / 1.8).abs() < 1e-7 && (at_least - found).abs() < 1e-6,
        "{at_least} {found}"
    );
}
