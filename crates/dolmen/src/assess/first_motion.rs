//! The acceleration at which a stack begins to move, beside one that is checked already.

use super::AssessError;
use super::least_motion::{governing_joint, sooner};
use super::stack::{StackCheck, StackCheckOptions, check_stack};
use super::stack_on_soil::on_soil;
use crate::stability::stack::{
    Holding, LimitAnalysis, LimitAnalysisStatus, OnSoil, Shaking, limit_analysis, stack_limits,
};
use crate::structure::stack::Stack;

/// Least acceleration at which a stack begins to move, m/s², if it differs little from a stack that is checked already; `None` if it does not
/// stand.
///
/// ```text
/// λ(p) = min over directions ν and mechanisms of λ(p, ν);    dλ/dp = ∂λ/∂p at the ν that governs
/// ```
///
/// It is the capacity of [`check_stack`] to first order in the difference, where no bed slides: the limit analysis examines only the directions
/// that govern the checked stack, and leaves out friction in the same joints. Beds that slide dilate here: compare with the result for the checked
/// stack itself.
///
/// # Errors
/// Those of [`check_stack`].
///
/// # Limits
/// Crossings of direction within the difference are not seen: where two directions differ by less than it and by more than 1e-6, the better one
/// alone counts.
pub fn first_motion_beside(
    stack: &Stack,
    options: &StackCheckOptions,
    checked: (&Stack, &StackCheck),
) -> Result<Option<f64>, AssessError> {
    let (checked_stack, check) = checked;
    let (Some(analysis), true) = (&check.analysis, have_same_joints(stack, checked_stack)) else {
        let capacity = check_stack(stack, options)?.capacity;
        return Ok(capacity.map(|least| least.acceleration_m_s2));
    };
    let limits = stack_limits(stack, &options.limits)?;
    if !limits.standing.stands() {
        return Ok(None);
    }
    let mut smoother = stack.clone();
    for &joint in &analysis.frictionless {
        let mut material = stack.joints()[joint].material;
        (material.friction_static, material.friction_kinetic) = (0.0, 0.0);
        smoother = smoother.with_material(joint, material)?;
    }
    let overturns = limits.footing.map(|footing| footing.overturns);
    let joints = sooner(governing_joint(&limits), overturns).map(|least| least.acceleration_m_s2);
    let shaking = match analysis.directions.as_slice() {
        [] => return Ok(joints),
        // forces that equilibrium determines are known in one direction
        [only] if check.limits.statically_determinate => Shaking::Along(*only),
        several => Shaking::Near(several.to_vec()),
    };
    let near = LimitAnalysis {
        loads: options.limits.loads.clone(),
        shaking,
        holding: Holding::Cohesion,
        ..LimitAnalysis::default()
    };
    Ok(match limit_analysis(&smoother, &near)?.status {
        LimitAnalysisStatus::DoesNotStand => None,
        LimitAnalysisStatus::Unlimited => joints,
        LimitAnalysisStatus::Limited(found) => {
            let soil = OnSoil::of(&smoother, &options.limits.loads)?;
            let found = on_soil(&smoother, &soil, &near, &found)?.acceleration_m_s2;
            Some(joints.map_or(found, |least| least.min(found)))
        }
    })
}

/// Whether two stacks have joints between the same bodies, in the same order.
fn have_same_joints(one: &Stack, other: &Stack) -> bool {
    let ends = |stack: &Stack| -> Vec<_> {
        let joints = stack.joints().iter();
        joints.map(|joint| (joint.lower, joint.upper)).collect()
    };
    ends(one) == ends(other)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::stability::stack::without_upright_friction;
    use crate::structure::stack::{JointMaterial, TowerFactors, TowerPlan, tower};

    /// A hollow tower of six courses in bond; stones share their load, and upright joints slide.
    fn hollow(width_m: f64, friction: f64) -> Stack {
        let blocks = tower(&TowerFactors {
            plan: TowerPlan::Square,
            width_m,
            top_width_m: 1.8,
            courses: 6,
            course_height_m: 0.5,
            thickness_m: Some(0.4),
            density_kg_m3: 2600.0,
        })
        .unwrap();
        Stack::new(blocks, JointMaterial::with_friction(friction), 9.81).unwrap()
    }

    #[test]
    fn agrees_with_the_whole_check_of_the_changed_stack() {
        let options = StackCheckOptions::default();
        let stack = hollow(2.0, 0.9);
        let check = check_stack(&stack, &options).unwrap();
        assert!(!check.analysis.as_ref().unwrap().frictionless.is_empty());
        for changed in [hollow(2.002, 0.9), hollow(2.0, 0.8991)] {
            let analysis = LimitAnalysis {
                holding: Holding::Cohesion,
                ..LimitAnalysis::default()
            };
            let (whole, _) = without_upright_friction(&changed, &analysis).unwrap();
            let LimitAnalysisStatus::Limited(whole) = whole.analysis.status else {
                panic!("no limit")
            };
            let found = first_motion_beside(&changed, &options, (&stack, &check))
                .unwrap()
                .unwrap();
            assert!(
                (found / whole.acceleration_m_s2 - 1.0).abs() < 1e-6,
                "{found} {whole:?}"
            );
            let same = first_motion_beside(&stack, &options, (&stack, &check))
                .unwrap()
                .unwrap();
            assert!((found / same - 1.0).abs() > 1e-5);
        }
    }
}
