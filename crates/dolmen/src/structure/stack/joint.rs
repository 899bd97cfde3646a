//! Contact of two bodies of a stack.

use super::{JointMaterial, Polygon};

/// One side of a joint or tie.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Body {
    /// The ground: the plane z = 0 and everything below.
    Ground,
    /// A block by its index.
    Block(usize),
}

/// The contact of two bodies: a flat patch with its own axes.
#[derive(Clone, Debug, PartialEq)]
pub struct Joint {
    /// The lower body; the plane of the patch belongs to it.
    pub lower: Body,
    /// The upper block.
    pub upper: usize,
    /// Centroid of the patch, m.
    pub origin_m: [f64; 3],
    /// Unit vectors of the joint's axes: two in the plane, then the normal, from the lower to the upper body.
    pub axes: [[f64; 3]; 3],
    /// The patch in its own plane, about the origin, m.
    pub patch: Polygon,
    /// Friction, bond, springs, damping.
    pub material: JointMaterial,
    /// Distance from the face of the lower body up to that of the upper body at the centroid of the patch, m; taken as closed.
    /// Negative if they overlap.
    pub gap_m: f64,
    /// Accuracy from the scans of the stones; `None` if neither is a scan with noise.
    pub scanned: Option<ScannedJoint>,
    /// Whether the patch is too narrow to be known from the drawing; a stone does not stand without it.
    pub is_sliver: bool,
    /// Whether a mesh shows only the corners of a bed that bounds the patch, so that nothing shows how exact they are.
    pub only_corners: bool,
}

/// Accuracy of a joint from scans.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ScannedJoint {
    /// Area of flat stone over the area of the patch: the smaller value of both beds, at most 1.
    pub used_ratio: f64,
    /// Distance from the fitted plane of the lower bed up to that of the upper bed, m; negative if they overlap.
    pub gap_m: f64,
    /// Standard deviation of the vertices from their fitted planes, m: the larger value of both stones.
    pub roughness_m: f64,
}

/// A contact that is too narrow to be known from the drawing.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sliver {
    /// The lower body.
    pub lower: Body,
    /// The upper block.
    pub upper: usize,
    /// Its width, m.
    pub width_m: f64,
}

impl Sliver {
    pub(super) fn of(joint: &Joint) -> Self {
        Sliver {
            lower: joint.lower,
            upper: joint.upper,
            width_m: joint.patch.width_m(),
        }
    }
}
