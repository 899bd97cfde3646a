//! The mechanism in which a stack moves: which joints open and which slide.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | v, ω | `velocity`, `spin` | velocity and spin of a body in the mechanism, to a common scale | m, – |
//! | t | – | tension that glue at every corner of every joint would have to resist for the stack to stand | N |

use super::limit_pieces::Piece;
use super::limit_programme::{AccelerationSet, least_pull};
use super::mechanism::{BodyMotion, JointMotion, Mechanism, MovingJoint};
use crate::stability::StabilityError;
use crate::structure::stack::{Body, Joint, Stack};
use glam::DVec3;

/// Fraction of the largest motion below which joints are not reported. Our choice: the solver is accurate to 1e-8.
const NAMED_LEAST: f64 = 1e-3;

/// Direction of shaking for pieces that fall without shaking.
const ANY_WAY: [f64; 2] = [1.0, 0.0];

/// The mechanism in which a piece that does not stand falls.
///
/// ```text
/// least t ≥ 0 over forces f:  balance of every block with f,  f + t n in Coulomb's cone at every corner
/// its dual: the mechanism that gains most energy while all corners together open by a given sum
/// ```
///
/// Of all mechanisms of the fall, this one opens few joints. For joints with a strength, it is the certificate of the programme. `None` if
/// the tension is only a rounding error: a piece balanced on an edge gains no energy.
pub(super) fn falling(stack: &Stack, piece: &Piece) -> Result<Option<Mechanism>, StabilityError> {
    // tension does not prevent crushing
    if piece.crushes() {
        return certified(stack, piece);
    }
    match least_pull(piece.at_rest(), piece.pushes(), &piece.units) {
        Ok(found) => Ok(found.and_then(|velocities| moving_with(stack, piece, &velocities))),
        // no pull at the corners holds it: a stone that slips down between two others
        Err(StabilityError::ConicProgramme { .. }) => certified(stack, piece),
        Err(other) => Err(other),
    }
}

/// The mechanism that certifies that a piece falls.
fn certified(stack: &Stack, piece: &Piece) -> Result<Option<Mechanism>, StabilityError> {
    let mut programme = piece.programme(AccelerationSet::Line(ANY_WAY));
    let velocities = programme.falling_velocities(ANY_WAY)?;
    Ok(velocities.and_then(|velocities| moving_with(stack, piece, &velocities)))
}

/// The mechanism of a piece from its velocities.
pub(super) fn moving_with(stack: &Stack, piece: &Piece, velocities: &[f64]) -> Option<Mechanism> {
    named(stack, &piece.motions(velocities, stack.blocks().len()))
}

/// Opening and slip at one corner of a joint.
struct Corner {
    at: DVec3,
    opens: f64,
    slips: f64,
}

pub(super) fn named(stack: &Stack, motions: &[Vec<BodyMotion>]) -> Option<Mechanism> {
    let corners: Vec<Vec<Corner>> = stack
        .joints()
        .iter()
        .map(|joint| corners_of(joint, motions))
        .collect();
    let each = corners.iter().flatten();
    let most = each.fold(0.0_f64, |most, corner| {
        most.max(corner.opens.abs()).max(corner.slips)
    });
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

/// The motion of a joint. A corner counts as closed if its opening does not exceed the dilation of its slip under associated friction.
fn moving(joint: usize, corners: &[Corner], friction: f64, least: f64) -> Option<MovingJoint> {
    let is_closed = |corner: &&Corner| corner.opens - friction * corner.slips <= least;
    let closed: Vec<&Corner> = corners.iter().filter(is_closed).collect();
    let opens = closed.len() < corners.len();
    let slides = closed.iter().any(|corner| corner.slips > least);
    let motion = match (opens, slides) {
        (false, false) if corners.iter().all(|corner| corner.opens >= -least) => return None,
        (false, false) => JointMotion::Crushes,
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
