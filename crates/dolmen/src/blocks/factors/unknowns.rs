//! Grouping of the springs of a stack at rest, by joint or by bed; each group has one factor.

use super::super::assembly::Assembly;
use super::super::beside::{add_springs_beside, springs_beside};
use super::super::bodies::index_of;
use super::super::contact_points::ContactRule;
use super::super::error::BlocksError;
use super::super::matrices::{
    Part, SpringsBetween, closed_at_rest, contact_matrix, mass_matrix, springs_between, springs_of_prop,
};
use super::super::rest::settle;
use super::result::StiffnessOf;
use crate::structure::stack::{Joint, Stack};
use dolmen_linalg::Matrix;
use glam::DVec3;

/// Distance between the planes of two joints below which they belong to one bed, m. Our choice: files give the beds of a course to a
/// millimetre.
const ONE_BED_M: f64 = 1e-3;
/// Sine of the largest angle between normals of one bed. Our choice: a millimetre per metre.
const ONE_BED_SINE: f64 = 1e-3;

/// Springs that one factor multiplies.
pub(super) struct Group {
    pub(super) joints: Vec<usize>,
    pub(super) springs: Vec<SpringsBetween>,
}

/// The springs and masses of a stack at rest.
pub(super) struct Unknowns {
    pub(super) of: StiffnessOf,
    pub(super) groups: Vec<Group>,
    /// Springs without a factor: dowels, clamps, side supports, and contacts without a drawn joint.
    pub(super) others: Vec<SpringsBetween>,
    pub(super) open_joints: Vec<usize>,
    pub(super) mass: Matrix,
}

/// Groups the springs by joint, or by bed if more than `joints_most` joints have springs.
pub(super) fn unknowns(
    stack: &Stack,
    rule: ContactRule,
    joints_most: usize,
) -> Result<Unknowns, BlocksError> {
    let mut assembly = Assembly::of(stack, rule);
    settle(&mut assembly, stack)?;
    let (mut groups, mut others): (Vec<Group>, Vec<SpringsBetween>) = (Vec::new(), Vec::new());
    for springs in springs_between(&assembly, closed_at_rest(&assembly)) {
        let is_none = springs.stiffness.as_slice().iter().all(|entry| *entry == 0.0);
        match joint_between(stack, &springs) {
            _ if is_none => {}
            Some(joint) => groups.push(Group {
                joints: vec![joint],
                springs: vec![springs],
            }),
            None => others.push(springs),
        }
    }
    let beside = springs_beside(&assembly).into_iter();
    others.extend(beside.map(|prop| springs_of_prop(&assembly, prop)));
    groups.sort_by_key(|group| group.joints[0]);
    let has_springs = |joint: &usize| groups.iter().any(|group| group.joints[0] == *joint);
    let open_joints = (0..stack.joints().len()).filter(|joint| !has_springs(joint));
    let open_joints = open_joints.collect();
    let of = match groups.len() <= joints_most {
        true => StiffnessOf::Joint,
        false => StiffnessOf::Bed,
    };
    if of == StiffnessOf::Bed {
        groups = by_bed(stack, groups);
    }
    Ok(Unknowns {
        of,
        groups,
        others,
        open_joints,
        mass: mass_matrix(&assembly),
    })
}

/// The joint to which these springs belong, as paired by the assembly.
fn joint_between(stack: &Stack, springs: &SpringsBetween) -> Option<usize> {
    let [a, b] = springs.bodies;
    let joins = |joint: &Joint| {
        let ends = (index_of(joint.lower), joint.upper + 1);
        ends == (a, b) || ends == (b, a)
    };
    match springs.is_link {
        true => None,
        false => stack.joints().iter().position(joins),
    }
}

fn by_bed(stack: &Stack, single: Vec<Group>) -> Vec<Group> {
    let mut beds: Vec<Group> = Vec::new();
    for group in single {
        let same = beds.iter_mut().find(|bed| {
            let [first, joint] = [bed.joints[0], group.joints[0]].map(|at| &stack.joints()[at]);
            in_one_plane(first, joint)
        });
        match same {
            Some(bed) => {
                bed.joints.extend(group.joints);
                bed.springs.extend(group.springs);
            }
            None => beds.push(group),
        }
    }
    beds
}

fn in_one_plane(a: &Joint, b: &Joint) -> bool {
    let [normal, other] = [a, b].map(|joint| DVec3::from(joint.axes[2]));
    let between = DVec3::from(b.origin_m) - DVec3::from(a.origin_m);
    normal.cross(other).length() < ONE_BED_SINE && between.dot(normal).abs() < ONE_BED_M
}

/// Stiffness of a stack after settling again on other springs, [6n × 6n].
pub(super) fn resettled_stiffness(stack: &Stack, rule: ContactRule) -> Result<Matrix, BlocksError> {
    let mut assembly = Assembly::of(stack, rule);
    settle(&mut assembly, stack)?;
    let mut stiffness = contact_matrix(&assembly, Part::Springs, closed_at_rest(&assembly));
    add_springs_beside(&assembly, &mut stiffness);
    Ok(stiffness)
}

/// The stack with the springs of each group multiplied by its factor.
pub(super) fn multiplied(stack: &Stack, groups: &[Group], factors: &[f64]) -> Result<Stack, BlocksError> {
    let mut scaled = stack.clone();
    for (group, factor) in groups.iter().zip(factors) {
        for &joint in &group.joints {
            let mut material = stack.joints()[joint].material;
            material.normal_stiffness_pa_m *= factor;
            material.shear_stiffness_pa_m *= factor;
            scaled = scaled.with_material(joint, material)?;
        }
    }
    Ok(scaled)
}
