//! Possible forces of joints and ties in a limit analysis.

use super::cuts::{SupportRelation, carries, is_statically_determinate};
use super::limit_options::Holding;
use super::limit_toes::{JointForce, toes};
use super::loads::{Load, together};
use super::possible_force::{Law, PossibleForce};
use crate::structure::stack::{Joint, Stack};
use glam::DVec3;

/// A stack and its loads, for a limit analysis.
#[derive(Clone, Copy)]
pub(super) struct LimitProblem<'a> {
    pub(super) stack: &'a Stack,
    /// Loads on each block without shaking.
    pub(super) loads: &'a [Load],
    /// Direction of the shaking; `None` for all directions.
    pub(super) towards: Option<[f64; 2]>,
    /// Whether growing loads may press on joints; otherwise only the shaking grows.
    pub(super) grows: bool,
    /// Whether joints of finite strength are discretised coarsely, because the solver failed on the fine discretisation.
    pub(super) is_coarse: bool,
}

/// Possible forces of every corner of every joint, and of every tie; for joints of finite strength, of every stress block.
pub(super) fn acts(problem: &LimitProblem<'_>, holding: Holding) -> Vec<PossibleForce> {
    let stack = problem.stack;
    let mut acts = Vec::new();
    let crushing = Crushing::of(problem);
    for (link, joint) in stack.joints().iter().enumerate() {
        let [first, second, normal] = joint.axes.map(DVec3::from);
        let corners = &joint.patch.corners_m;
        let friction = joint.material.friction_static;
        if let Some(strength_pa) = joint.material.compressive_strength_pa {
            let towards = problem.towards.and_then(|way| in_plane(joint, way));
            for toe in toes(&joint.patch, strength_pa, crushing.pressed(link), towards) {
                acts.push(PossibleForce {
                    link,
                    at: DVec3::from(joint.origin_m) + first * toe.at_m[0] + second * toe.at_m[1],
                    axes: [normal, first, second],
                    law: Law::Toe {
                        friction,
                        capacity_n: toe.capacity_n,
                    },
                });
            }
        }
        let presses = joint.material.compressive_strength_pa.is_none();
        let cohesion = joint.material.cohesion_pa * joint.patch.moments().area_m2 / corners.len() as f64;
        for corner in corners {
            let mut act = PossibleForce {
                link,
                at: DVec3::from(joint.origin_m) + first * corner[0] + second * corner[1],
                axes: [normal, first, second],
                law: Law::Friction(friction),
            };
            if presses {
                acts.push(act);
            }
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
            let mut act = PossibleForce {
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

/// A horizontal direction projected on the plane of a joint, as a unit vector; `None` if the joint is perpendicular to it.
fn in_plane(joint: &Joint, way: [f64; 2]) -> Option<[f64; 2]> {
    let way = DVec3::new(way[0], way[1], 0.0);
    let [x, y, _] = joint.axes.map(|axis| DVec3::from(axis).dot(way));
    let length = x.hypot(y);
    (length > 1e-9).then(|| [x / length, y / length])
}

/// Forces of joints of finite strength without shaking, as far as they are known.
struct Crushing<'a> {
    problem: &'a LimitProblem<'a>,
    /// `None` if no joint crushes.
    carriers: Option<SupportRelation>,
    is_known: bool,
}

impl<'a> Crushing<'a> {
    fn of(problem: &'a LimitProblem<'a>) -> Self {
        let joints = problem.stack.joints();
        let crushes = |joint: &Joint| joint.material.compressive_strength_pa.is_some();
        let carriers = joints
            .iter()
            .any(crushes)
            .then(|| SupportRelation::of(problem.stack));
        Crushing {
            problem,
            is_known: is_statically_determinate(problem.stack),
            carriers,
        }
    }

    /// The weight of a joint's upper block and its load, shared equally among all joints that carry it.
    fn pressed(&self, link: usize) -> JointForce {
        let joints = self.problem.stack.joints();
        let joint = &joints[link];
        let force_n = match &self.carriers {
            Some(carriers) if carries(joint) => {
                let load = together(self.problem.loads, &carriers.carried(vec![joint.upper]));
                let beside = joints.iter().filter(|of| of.upper == joint.upper && carries(of));
                -load.force.dot(DVec3::from(joint.axes[2])) / beside.count() as f64
            }
            _ => 0.0,
        };
        match self.is_known {
            true => JointForce::Known {
                force_n,
                grows: self.problem.grows,
            },
            false => JointForce::About {
                force_n,
                joints: if self.problem.is_coarse {
                    usize::MAX
                } else {
                    joints.len()
                },
            },
        }
    }
}

fn across(axis: DVec3) -> [DVec3; 2] {
    let near = if axis.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - axis * near.dot(axis)).normalize();
    [first, axis.cross(first)]
}
