//! What an error of the corners of beds would change, where a mesh shows only those corners.

use super::AssessError;
use super::least_motion::{first_motion, governing_joint};
use super::stack_notes::StackNote;
use crate::stability::stack::{
    LimitAnalysisResult, LimitKind, StackLimitStates, StackLimits, Threshold, stack_limits,
};
use crate::structure::stack::Stack;

/// Error of corners that the answer states the effect of, m. Our choice: what a survey by hand or a coarse scan misses.
const CORNERS_OFF_M: f64 = 1e-3;
/// Relative difference within which the limit of single joints is the capacity; the solver of the limit analysis loses 1e-8. Our choice.
const SAME: f64 = 1e-4;

/// The first motion of a check.
pub(super) struct Found<'a> {
    pub(super) limits: &'a StackLimitStates,
    pub(super) analysis: Option<&'a LimitAnalysisResult>,
    pub(super) capacity: Option<Threshold>,
}

/// The joints that decide the capacity.
struct Deciding {
    joints: Vec<usize>,
    slides: bool,
}

/// The note on the first joint that decides the capacity and of which a mesh shows only the corners; `None` without such a joint.
///
/// ```text
/// rocking:  every such bed ends 1 mm further in      a block b × h:  (b/2 − 1 mm) / (b/2) − 1 = −2 mm / b
/// sliding:  every such bed is also inclined, one end 1 mm up and the other 1 mm down:  tan(φ − 2 mm/b) / tan φ − 1
/// ```
pub(super) fn note(
    stack: &Stack,
    options: &StackLimits,
    found: &Found<'_>,
) -> Result<Option<StackNote>, AssessError> {
    let unseen = stack.joints_of_only_corners();
    let (Some(capacity), false) = (found.capacity, unseen.is_empty()) else {
        return Ok(None);
    };
    let joints = governing_joint(found.limits)
        .filter(|joints| joints.acceleration_m_s2 <= (1.0 + SAME) * capacity.acceleration_m_s2);
    let (by_joints, whole) = (joints.is_some(), joints.unwrap_or(capacity));
    let deciding = deciding(found, by_joints);
    let Some(&joint) = deciding.joints.iter().find(|joint| unseen.contains(joint)) else {
        return Ok(None);
    };
    let limit = |other: &Stack| -> Result<Option<Threshold>, AssessError> {
        match by_joints {
            true => Ok(governing_joint(&stack_limits(other, options)?)),
            false => first_motion(other, options),
        }
    };
    let mut others = vec![stack.with_edges_inside(&unseen, CORNERS_OFF_M)];
    if deciding.slides {
        others.push(Some(stack.with_beds_inclined(
            &unseen,
            whole.direction,
            CORNERS_OFF_M,
        )));
    }
    let mut change = 0.0_f64;
    for other in others {
        let least = match other {
            Some(other) => limit(&other)?,
            None => None,
        };
        let left = least.map_or(0.0, |least| least.acceleration_m_s2 / whole.acceleration_m_s2);
        change = change.max(1.0 - left);
    }
    let of = &stack.joints()[joint];
    Ok(Some(StackNote::OnlyCorners {
        lower: of.lower,
        upper: of.upper,
        off_m: CORNERS_OFF_M,
        change,
    }))
}

/// The joints of the first motion: of the cut that governs, or else of the mechanism of the limit analysis.
fn deciding(found: &Found<'_>, by_joints: bool) -> Deciding {
    let limits = found.limits;
    let both = [limits.uplift, limits.sliding].into_iter().flatten();
    let first = both.min_by(|a, b| {
        let (a, b) = (a.threshold.acceleration_m_s2, b.threshold.acceleration_m_s2);
        a.total_cmp(&b)
    });
    if let (true, Some(first)) = (by_joints, first) {
        return Deciding {
            joints: limits.cuts[first.cut].cut.joints.clone(),
            slides: first.kind == LimitKind::Sliding,
        };
    }
    let mechanism = found.analysis.and_then(|analysis| analysis.mechanism.as_ref());
    let moving = mechanism.map_or(&[][..], |mechanism| &mechanism.joints);
    Deciding {
        joints: moving.iter().map(|moving| moving.joint).collect(),
        slides: moving.iter().any(|moving| moving.motion.slides()),
    }
}
