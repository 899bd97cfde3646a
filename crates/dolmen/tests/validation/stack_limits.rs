// SOURCE     Kim, Koo & Hong (2018), eqs 9 and 16, section 3.4; Livesley (1978) for the limit analysis; P10 and P20 of this
//            crate, made for comparisons.
// GOAL       The least tan α over all joints names where a stack opens and when; limit analysis finds the same.
// PARAMETERS P10 and P20, friction .6 and .3, g 9.80665 m/s².
// PUBLISHED  uplift of P10 at .324 g, of P20 at .251 g; P10 with μ = .3 slides at .300 g.
// TOLERANCE  half a unit of the last digit; 1e-8 between both ways: what a solution of the limit analysis misses is 1e-9.

use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::stability::stack::{LimitAnalysisStatus, LimitKind};
use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};
use dolmen::validation::{p10, p20};

fn thresholds(stack: &Stack) -> (LimitKind, f64, f64) {
    let check = check_stack(stack, &StackCheckOptions::default()).unwrap();
    let governing = check.limits.governing.unwrap();
    let LimitAnalysisStatus::Limited(analysis) = check.analysis.unwrap().status else {
        panic!("no limit")
    };
    (
        governing.kind,
        governing.threshold.acceleration_g,
        analysis.acceleration_g,
    )
}

#[test]
fn published_thresholds_of_p10_and_p20() {
    let rough = JointMaterial::with_friction(0.6);
    let smooth = JointMaterial::with_friction(0.3);
    for (stack, kind, known) in [
        (p10(rough, 9.80665), LimitKind::Uplift, 0.324),
        (p20(rough, 9.80665), LimitKind::Uplift, 0.251),
        (p10(smooth, 9.80665), LimitKind::Sliding, 0.300),
    ] {
        let (found, joints, analysis) = thresholds(&stack.unwrap());
        assert_eq!(found, kind);
        assert!((joints - known).abs() < 5e-4, "{joints}");
        assert!((joints - analysis).abs() < 1e-8, "{joints} {analysis}");
    }
}

#[test]
fn exact_a_leaning_stone_slides_and_tips_down_its_own_bed() {
    // on the ground and on a level stone: the bed leans by β, so that it tips at tan(α − β) and slides at tan(φ − β)
    let block = |name: &str, [width, height]: [f64; 2], tilt: f64, z: f64| Block {
        name: name.into(),
        solid: Solid::cuboid(width, 2.0 * width, height)
            .unwrap()
            .placed(&Placement {
                tilt: [tilt, 0.0],
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            }),
        density_kg_m3: 2600.0,
    };
    for degrees in [1.0_f64, 3.0, 4.9] {
        let beta = degrees.to_radians();
        for (size, friction, kind) in [
            ([0.5_f64, 1.5], 0.6, LimitKind::Uplift),
            ([1.0, 0.5], 0.6, LimitKind::Sliding),
        ] {
            let alpha = match kind {
                LimitKind::Uplift => (size[0] / size[1]).atan(),
                _ => f64::atan(friction),
            };
            let known = (alpha - beta).tan();
            let material = JointMaterial::with_friction(friction);
            let alone = vec![block("leans", size, beta.tan(), 0.0)];
            let on_stone = vec![
                block("level", [3.0, 0.5], 0.0, 0.0),
                block("leans", size, beta.tan(), 0.5),
            ];
            for blocks in [alone, on_stone] {
                let (found, joints, analysis) = thresholds(&Stack::new(blocks, material, 9.80665).unwrap());
                assert_eq!(found, kind, "{degrees}");
                assert!((joints - known).abs() < 1e-9, "{degrees}: {joints} {known}");
                assert!((analysis - known).abs() < 1e-7, "{degrees}: {analysis} {known}");
            }
        }
    }
}
