//! The mechanism in which a stack moves: which joints open and which slide.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | v, ω | `velocity`, `spin` | of a body in the mechanism, to a common scale | m, – |
//! | t | – | pull that glue at every corner of every joint would have to bear for the stack to stand | N |

use super::limit_pieces::Piece;
use super::limit_programme::{Within, least_pull};
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Joint, Stack};
use glam::DVec3;

/// Motions of a joint below this part of the largest are not named. Chosen here: what the solver loses is 1e-8.
const NAMED_LEAST: f64 = 1e-3;

/// What a joint does in a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum JointMotion {
    /// It opens, about an edge or as a whole.
    Opens,
    /// It slides and stays closed.
    Slides,
    /// It slides on an edge or corner and opens elsewhere.
    OpensAndSlides,
}

/// A joint that moves in a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MovingJoint {
    /// Which joint of the stack.
    pub joint: usize,
    /// What it does.
    pub motion: JointMotion,
    /// Middle of the corners that stay closed, m: about it the joint turns, or on it it slides. `None` if it opens as a whole.
    pub closed_at_m: Option<[f64; 3]>,
}

/// How a stack begins to move: the joints between its rigid parts, ascending.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Mechanism {
    /// Every joint that opens or slides; the others stay as they are.
    pub joints: Vec<MovingJoint>,
}

/// How a body moves in a mechanism.
#[derive(Clone, Copy)]
pub(super) struct BodyMotion {
    pub(super) velocity: DVec3,
    pub(super) spin: DVec3,
    pub(super) about: DVec3,
}

impl BodyMotion {
    fn at(&self, point: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(point - self.about)
    }
}

/// The mechanism in which a piece that does not stand falls.
///
/// ```text
/// least t ≥ 0 over forces f:  balance of every block with f,  f + t n in Coulomb's cone at every corner
/// its dual: the mechanism that gains most energy while all corners together open by a given sum
/// ```
///
/// Of the many mechanisms that fall this one opens few joints. `None` where the pull is rounding: what is balanced on an edge gains nothing.
pub(super) fn falling(stack: &Stack, piece: &Piece) -> Result<Option<Mechanism>, StabilityError> {
    let found = least_pull(piece.at_rest(), piece.pushes(), piece.units())?;
    Ok(found.and_then(|velocities| named(stack, &piece.motions(&velocities, stack.blocks().len()))))
}

/// The mechanism in which a piece begins to move when shaken one way.
pub(super) fn swaying(
    stack: &Stack,
    piece: &Piece,
    way: [f64; 2],
) -> Result<Option<Mechanism>, StabilityError> {
    let velocities = piece.programme(Within::Line(way))?.mechanism(way)?;
    Ok(velocities.and_then(|velocities| named(stack, &piece.motions(&velocities, stack.blocks().len()))))
}

/// Opening and slip at one corner of a joint.
struct Corner {
    at: DVec3,
    opens: f64,
    slips: f64,
}

fn named(stack: &Stack, motions: &[Vec<BodyMotion>]) -> Option<Mechanism> {
    let corners: Vec<Vec<Corner>> = stack
        .joints()
        .iter()
        .map(|joint| corners_of(joint, motions))
        .collect();
    let each = corners.iter().flatten();
    let most = each.fold(0.0_f64, |most, corner| most.max(corner.opens).max(corner.slips));
    let least = NAMED_LEAST * most;
    let joints: Vec<MovingJoint> = corners
        .iter()
        .enumerate()
        .filter_map(|(joint, corners)| {
            let friction = stack.joints().get(joint)?.material.friction_static;
            moving(joint, corners, friction, least)
        })
        .collect();
    (!joints.is_empty()).then_some(Mechanism { joints })
}

fn corners_of(joint: &Joint, motions: &[Vec<BodyMotion>]) -> Vec<Corner> {
    let [first, second, normal] = joint.axes.map(DVec3::from);
    let corners = joint.patch.corners_m.iter();
    corners
        .map(|corner| {
            let at = DVec3::from(joint.origin_m) + first * corner[0] + second * corner[1];
            let of = |block: usize| motions[block].iter().map(|motion| motion.at(at)).sum::<DVec3>();
            let below = match joint.lower {
                Body::Ground => DVec3::ZERO,
                Body::Block(block) => of(block),
            };
            let apart = of(joint.upper) - below;
            let opens = apart.dot(normal);
            Corner {
                at,
                opens,
                slips: (apart - normal * opens).length(),
            }
        })
        .collect()
}

/// A corner is closed where it opens no more than friction taken as associated lets a slip dilate.
fn moving(joint: usize, corners: &[Corner], friction: f64, least: f64) -> Option<MovingJoint> {
    let is_closed = |corner: &&Corner| corner.opens - friction * corner.slips <= least;
    let closed: Vec<&Corner> = corners.iter().filter(is_closed).collect();
    let opens = closed.len() < corners.len();
    let slides = closed.iter().any(|corner| corner.slips > least);
    let motion = match (opens, slides) {
        (false, false) => return None,
        (true, false) => JointMotion::Opens,
        (false, true) => JointMotion::Slides,
        (true, true) => JointMotion::OpensAndSlides,
    };
    let middle = closed.iter().map(|corner| corner.at).sum::<DVec3>() / closed.len() as f64;
    Some(MovingJoint {
        joint,
        motion,
        closed_at_m: (!closed.is_empty()).then(|| middle.into()),
    })
}
