//! What joints and ties can do in a limit analysis.

use super::limit_options::Holding;
use super::limit_pieces::{Act, Law};
use crate::structure::stack::Stack;
use glam::DVec3;

/// What every corner of every joint, and every tie, can do.
pub(super) fn acts(stack: &Stack, holding: Holding) -> Vec<Act> {
    let mut acts = Vec::new();
    for (link, joint) in stack.joints().iter().enumerate() {
        let [first, second, normal] = joint.axes.map(DVec3::from);
        let corners = &joint.patch.corners_m;
        let cohesion = joint.material.cohesion_pa * joint.patch.moments().area_m2 / corners.len() as f64;
        for corner in corners {
            let mut act = Act {
                link,
                at: DVec3::from(joint.origin_m) + first * corner[0] + second * corner[1],
                axes: [normal, first, second],
                law: Law::Friction(joint.material.friction_static),
            };
            acts.push(act);
            if holding != Holding::FrictionOnly && cohesion > 0.0 {
                act.law = Law::Shear(cohesion);
                acts.push(act);
            }
        }
    }
    if holding == Holding::CohesionAndTies {
        for (index, tie) in stack.ties().iter().enumerate() {
            let axis = DVec3::from(tie.axis).normalize();
            let [first, second] = across(axis);
            let mut act = Act {
                link: stack.joints().len() + index,
                at: DVec3::from(tie.position_m),
                axes: [axis, first, second],
                law: Law::Shear(tie.shear_strength_n),
            };
            if tie.shear_strength_n > 0.0 {
                acts.push(act);
            }
            if tie.axial_stiffness_n_m > 0.0 && tie.tension_strength_n > 0.0 {
                act.law = Law::Pull(tie.tension_strength_n);
                acts.push(act);
            }
        }
    }
    acts
}

fn across(axis: DVec3) -> [DVec3; 2] {
    let near = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - axis * near.dot(axis)).normalize();
    [first, axis.cross(first)]
}
