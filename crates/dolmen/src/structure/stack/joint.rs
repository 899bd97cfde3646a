//! Where two bodies of a stack touch.

use super::{JointMaterial, Polygon};

/// What a joint or tie connects.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Body {
    /// The ground: the plane z = 0 and all below.
    Ground,
    /// A block by its index.
    Block(usize),
}

/// Where two bodies touch: a flat patch with a frame of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The lower body, which the patch's plane belongs to.
    pub lower: Body,
    /// The upper block.
    pub upper: usize,
    /// Centroid of the patch, m.
    pub origin_m: [f64; 3],
    /// Unit vectors of its frame: two in the plane, then the normal, from the lower to the upper body.
    pub axes: [[f64; 3]; 3],
    /// The patch in its own plane, about the origin, m.
    pub patch: Polygon,
    /// Friction, bond, springs, damping.
    pub material: JointMaterial,
}
