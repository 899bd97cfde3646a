//! The moving joints of a mechanism.

use glam::DVec3;

/// Motion of a joint in a mechanism.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum JointMotion {
    /// It opens, about an edge or as a whole.
    Opens,
    /// It slides and stays closed.
    Slides,
    /// It slides on an edge or corner and opens elsewhere.
    OpensAndSlides,
    /// The joint crushes, without opening or sliding.
    Crushes,
}

impl JointMotion {
    /// Whether it slides, as a whole or on an edge.
    pub fn slides(self) -> bool {
        matches!(self, JointMotion::Slides | JointMotion::OpensAndSlides)
    }

    /// Whether it opens, as a whole or about an edge.
    pub fn opens(self) -> bool {
        matches!(self, JointMotion::Opens | JointMotion::OpensAndSlides)
    }
}

/// A joint that moves in a mechanism.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MovingJoint {
    /// Index of the joint.
    pub joint: usize,
    /// Its motion.
    pub motion: JointMotion,
    /// Middle of the corners that stay closed, m: the joint rotates about it, or slides on it. `None` if the whole joint
    /// opens.
    pub closed_at_m: Option<[f64; 3]>,
}

/// The mechanism in which a stack begins to move: the joints between its rigid parts, ascending.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Mechanism {
    /// Every joint that opens, slides or crushes; the others do not move.
    pub joints: Vec<MovingJoint>,
}

#[derive(Clone, Copy)]
pub(super) struct BodyMotion {
    pub(super) velocity: DVec3,
    pub(super) spin: DVec3,
    pub(super) about: DVec3,
}

impl BodyMotion {
    pub(super) fn at(&self, point: DVec3) -> DVec3 {
        self.velocity + self.spin.cross(point - self.about)
    }
}
