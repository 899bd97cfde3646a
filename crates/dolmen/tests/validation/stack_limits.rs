// SOURCE     Kim, Koo & Hong (2018), eqs 9 and 16, section 3.4; Livesley (1978) for the limit analysis; P10 and P20 of this
//            crate, made for comparisons.
// GOAL       The least tan α over all joints names where a stack opens and when; limit analysis finds the same.
// PARAMETERS P10 and P20, friction .6 and .3, g 9.80665 m/s².
// PUBLISHED  uplift of P10 at .324 g, of P20 at .251 g; P10 with μ = .3 slides at .300 g.
// TOLERANCE  half a unit of the last digit; 1e-8 between both ways: what a solution of the limit analysis misses is 1e-9.

use dolmen::assess::{StackCheckOptions, check_stack};
use dolmen::stability::stack::{LimitAnalysisStatus, LimitKind};
use dolmen::structure::stack::{JointMaterial, Stack};
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
