//! Contact of two bodies of a stack.

use super::{JointMaterial, Polygon};

/// One side of a joint or tie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Body {
    /// The ground: the plane z = 0 and all below.
    Ground,
    /// A block by its index.
    Block(usize),
}

/// The contact of two bodies: a flat patch with its own axes.
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
    /// From the face of the lower body up to that of the upper at the centroid of the patch, m, which counts as closed; negative if
    /// they pass through each other.
    pub gap_m: f64,
    /// How well the scans of its stones know it; `None` if neither is a scan with noise.
    pub scanned: Option<ScannedJoint>,
}

/// Properties of a joint from scans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScannedJoint {
    /// Area of both beds that is flat stone there, over the patch: the lesser of the two, at most 1.
    pub used_ratio: f64,
    /// From the fitted plane of the lower bed up to that of the upper, m; negative if they pass through each other.
    pub gap_m: f64,
    /// Standard deviation of the vertices of both stones off their fitted planes, m: the larger.
    pub roughness_m: f64,
}
