// SOURCE     microlp 0.7 (a simplex method).
// GOAL       The load that an arch bears on one of its stones agrees with a linear programme over all corners in which pyramids inside
//            and outside replace the friction cone.
// PARAMETERS arches of 9 to 25 voussoirs, 4 m wide, a load on the haunch or the crown, downwards or inclined.
// TOLERANCE  1e-6 beyond the two pyramids.

use crate::stack_loads::{DENSITY_KG_M3, GRAVITY_M_S2};
use dolmen::stability::stack::{SteadyLoads, load_factor};
use dolmen::structure::stack::{ArchFactors, Body, JointMaterial, Stack, StaticLoad, arch};
use microlp::{ComparisonOp, LinearExpr, OptimizationDirection, Problem};
use std::f64::consts::{PI, TAU};

/// λ of a load on a stack by a linear programme over all corners: friction as a pyramid of 12 sides within the cone, or around it.
fn by_simplex(stack: &Stack, load: &StaticLoad, wider: f64) -> Option<f64> {
    const SIDES: usize = 12;
    let n = stack.blocks().len();
    let weight = stack.mass_kg() * GRAVITY_M_S2;
    let mut problem = Problem::new(OptimizationDirection::Maximize);
    let factor = problem.add_var(1.0, (0.0, 1e4));
    let mut sums: Vec<LinearExpr> = (0..6 * n).map(|_| LinearExpr::empty()).collect();
    let cross = |a: [f64; 3], b: [f64; 3]| {
        [
            a[1] * b[2] - a[2] * b[1],
            a[2] * b[0] - a[0] * b[2],
            a[0] * b[1] - a[1] * b[0],
        ]
    };
    let arm = |block: usize, at: [f64; 3]| -> [f64; 3] {
        let from = stack.blocks()[block].solid.centroid_m();
        std::array::from_fn(|k| at[k] - from[k])
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
                    let moment = cross(arm(block, at), force);
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
    let moment = cross(arm(load.block, load.position_m), load.force_n);
    for k in 0..3 {
        sums[6 * load.block + k].add(factor, load.force_n[k] / weight);
        sums[6 * load.block + 3 + k].add(factor, moment[k] / weight);
    }
    for (block, stone) in stack.blocks().iter().enumerate() {
        let own = stone.mass_kg() * GRAVITY_M_S2 / weight;
        for k in 0..6 {
            let sum = std::mem::replace(&mut sums[6 * block + k], LinearExpr::empty());
            problem.add_constraint(sum, ComparisonOp::Eq, if k == 2 { own } else { 0.0 });
        }
    }
    let solution = problem.solve().ok()?.into_solution().ok()?;
    Some(solution.var_value(factor))
}

#[test]
fn agrees_with_microlp_0_7_on_arches_with_a_load() {
    for (voussoirs, on, force) in [
        (9, 2, [0.0, 0.0, -1e3]),
        (9, 4, [0.0, 0.0, -1e3]),
        (15, 3, [0.0, 0.0, -1e3]),
        (15, 5, [300.0, 0.0, -500.0]),
        (25, 6, [0.0, 0.0, -1e3]),
    ] {
        let factors = ArchFactors {
            voussoirs,
            span_m: 4.0,
            rise_m: 2.0,
            thickness_m: 0.5,
            depth_m: 1.0,
            springing_height_m: 0.0,
            abutment_m: 1.0,
            density_kg_m3: DENSITY_KG_M3,
        };
        let stack = Stack::new(
            arch(&factors).unwrap(),
            JointMaterial::with_friction(0.7),
            GRAVITY_M_S2,
        )
        .unwrap();
        let position_m = stack.blocks()[on].solid.centroid_m();
        let load = StaticLoad {
            block: on,
            position_m,
            force_n: force,
        };
        let steady = SteadyLoads {
            weight: 1.0,
            loads: &[],
        };
        let found = load_factor(&stack, &steady, &[load]).unwrap();
        let within = by_simplex(&stack, &load, 1.0).unwrap();
        let around = by_simplex(&stack, &load, 1.0 / (PI / 12.0).cos()).unwrap();
        assert!(
            within * (1.0 - 1e-6) < found.factor && found.factor < around * (1.0 + 1e-6),
            "{voussoirs} {on}: {within} {} {around}",
            found.factor
        );
        assert!(found.factor.is_finite() && found.factor > 0.0);
    }
}
