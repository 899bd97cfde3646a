//! Side supports that act as springs in small motion of a stack at rest.
//!
//! A side support acts only in compression. For motion far smaller than any gap it is linear in two cases: if it is in compression at rest, or if
//! two equal supports are opposite each other without a gap. In the second case one of them acts at every instant, and together they form one
//! spring.

use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::error::BlocksError;
use super::links::Prop;
use super::matrices::{Entries, OUTLINE_FROM, add_prop};
use super::rest::settle;
use crate::structure::stack::Stack;
use glam::DVec3;

/// Compression at rest, m, above which a side support counts as in compression: the position of rest is more accurate than this. Our choice.
const PRESSED_M: f64 = 1e-9;
/// Tolerances for two opposite side supports: distance, m, sine of the angle, and relative difference of stiffness. Our choice.
const ONE_LINE_M: f64 = 1e-3;
const ONE_LINE_SINE: f64 = 1e-3;
const ALIKE: f64 = 1e-6;

/// Action of a side support in small motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum BesideInSmallMotion {
    /// A spring: it is in compression at rest.
    Pressed,
    /// A spring, because an equally stiff support is opposite to it: neither has a gap.
    Opposite,
    /// It has no gap, but is not in compression, and no equally stiff support is opposite it. It acts in one half of each cycle only, and
    /// the frequencies lie between those without it and those with it as a spring.
    OneWay,
    /// No spring, for motion smaller than the gap.
    Gap,
}

impl BesideInSmallMotion {
    /// Whether it is included in frequencies.
    pub fn is_spring(self) -> bool {
        matches!(self, Self::Pressed | Self::Opposite)
    }
}

/// The action of each side support of a stack in small motion about its rest.
///
/// # Errors
/// [`BlocksError`] if the stack does not come to rest.
pub fn beside_in_small_motion(
    stack: &Stack,
    contact_rule: ContactRule,
) -> Result<Vec<BesideInSmallMotion>, BlocksError> {
    if stack.side_supports().is_empty() {
        return Ok(Vec::new());
    }
    let mut assembly = match stack.blocks().len() >= OUTLINE_FROM {
        true => Assembly::of_joints(stack, contact_rule),
        false => Assembly::of(stack, contact_rule),
    };
    settle(&mut assembly, stack)?;
    Ok(at_rest(&assembly))
}

fn at_rest(assembly: &Assembly) -> Vec<BesideInSmallMotion> {
    let props = assembly.props();
    let each = props.iter().map(|prop| {
        if prop.depth(&assembly.bodies[prop.body]) > PRESSED_M {
            BesideInSmallMotion::Pressed
        } else if prop.gap > 0.0 {
            BesideInSmallMotion::Gap
        } else if props.iter().any(|other| is_opposite(prop, other)) {
            BesideInSmallMotion::Opposite
        } else {
            BesideInSmallMotion::OneWay
        }
    });
    each.collect()
}

/// Whether two supports have equal stiffness, no gap, and opposite directions on one line through a body.
fn is_opposite(prop: &Prop, other: &Prop) -> bool {
    let across = |v: DVec3| v.cross(prop.direction).length();
    prop.body == other.body
        && prop.gap == 0.0
        && other.gap == 0.0
        && prop.direction.dot(other.direction) < 0.0
        && across(other.direction) < ONE_LINE_SINE
        && across(other.drawn - prop.drawn) < ONE_LINE_M
        && (other.stiffness / prop.stiffness - 1.0).abs() < ALIKE
}

/// The side supports that are springs in small motion; only one of two opposite ones.
pub(super) fn springs_beside(assembly: &Assembly) -> Vec<&Prop> {
    let props = assembly.props();
    let how = at_rest(assembly);
    let acts = |&(at, prop): &(usize, &Prop)| match how[at] {
        BesideInSmallMotion::Pressed => true,
        BesideInSmallMotion::Opposite => {
            // a support in compression represents both, otherwise the first one
            let partners = props
                .iter()
                .enumerate()
                .filter(|(_, other)| is_opposite(prop, other));
            let is_taken =
                |(other, _): (usize, &Prop)| how[other] == BesideInSmallMotion::Pressed || other < at;
            !partners.into_iter().any(is_taken)
        }
        BesideInSmallMotion::OneWay | BesideInSmallMotion::Gap => false,
    };
    props
        .iter()
        .enumerate()
        .filter(acts)
        .map(|(_, prop)| prop)
        .collect()
}

/// Adds the side supports that are springs in small motion.
pub(super) fn add_springs_beside(assembly: &Assembly, matrix: &mut impl Entries) {
    for prop in springs_beside(assembly) {
        add_prop(assembly, prop, matrix);
    }
}
