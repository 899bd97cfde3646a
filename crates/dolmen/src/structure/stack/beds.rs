//! Where two convex solids touch: the pair of faces with the largest common patch.

use super::{Body, Joint, JointMaterial, Polygon, Solid};
use glam::DVec3;

/// Beds closer than this touch, m: surveyed dimensions and dressed stone are not better. Chosen here. What is left of a
/// gap or wedge counts as bedded (mortar, shims): contact begins as drawn.
pub const BED_GAP_M: f64 = 0.005;
/// Cosine of the largest angle between faces that still count as bedded, 5°. Chosen here: a stone that leans more does
/// not lie on its bed.
const PARALLEL: f64 = 0.996_194_7;
/// Patches smaller than this part of the smaller face are an edge or corner that touches. Chosen here.
const PATCH_LEAST: f64 = 1e-6;

/// A common patch of two solids.
pub(super) struct Bed {
    origin: DVec3,
    axes: [DVec3; 3],
    patch: Polygon,
}

impl Bed {
    /// Rise of its normal, as sine.
    pub(super) fn rises(&self) -> f64 {
        self.axes[2].z
    }

    /// The same patch seen from the other side.
    pub(super) fn turned(self) -> Self {
        let [first, second, normal] = self.axes;
        let corners = self.patch.corners_m.iter().rev();
        Bed {
            origin: self.origin,
            axes: [first, -second, -normal],
            patch: Polygon {
                corners_m: corners.map(|corner| [corner[0], -corner[1]]).collect(),
            },
        }
    }

    pub(super) fn joint(self, lower: Body, upper: usize, material: JointMaterial) -> Joint {
        Joint {
            lower,
            upper,
            origin_m: self.origin.into(),
            axes: self.axes.map(Into::into),
            patch: self.patch,
            material,
        }
    }
}

/// Two unit vectors in the plane of a normal, the first as near to x as can be, so that (first, second, normal) is right
/// handed.
pub(crate) fn plane_axes(normal: DVec3) -> [DVec3; 3] {
    let near = if normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - normal * normal.dot(near)).normalize();
    [first, normal.cross(first), normal]
}

/// A face seen in a plane, counterclockwise about its normal.
pub(crate) fn face_in_plane(solid: &Solid, face: usize, origin: DVec3, axes: &[DVec3; 3]) -> Polygon {
    let corners = solid.faces()[face].iter().map(|&vertex| {
        let from = DVec3::from(solid.vertices_m()[vertex]) - origin;
        [from.dot(axes[0]), from.dot(axes[1])]
    });
    let mut corners_m: Vec<[f64; 2]> = corners.collect();
    if solid.normal(face).dot(axes[2]) < 0.0 {
        corners_m.reverse();
    }
    Polygon { corners_m }
}

/// The bed between `lower` (the ground if `None`) and `upper`, its normal from the first to the second.
pub(super) fn bed(lower: Option<&Solid>, upper: &Solid) -> Option<Bed> {
    let mut best: Option<(f64, Bed)> = None;
    let mut offer = |area: f64, bed: Bed| {
        if best.as_ref().is_none_or(|(most, _)| area > *most) {
            best = Some((area, bed));
        }
    };
    for below in 0..upper.faces().len() {
        let down = upper.normal(below);
        let Some(lower) = lower else {
            if -down.z >= PARALLEL {
                // what fills the wedge below a stone that leans has the slope of the stone's bed
                let axes = plane_axes(levelled(-down));
                let corner = DVec3::from(upper.vertices_m()[upper.faces()[below][0]]);
                let patch = face_in_plane(upper, below, corner, &axes);
                let area = patch.moments().area_m2;
                let bed = bed_of(patch, corner, axes);
                if bed.origin.z.abs() <= BED_GAP_M {
                    offer(area, bed);
                }
            }
            continue;
        };
        for above in 0..lower.faces().len() {
            let up = lower.normal(above);
            if -up.dot(down) < PARALLEL {
                continue;
            }
            let axes = plane_axes(steeper(up, -down));
            let origin = DVec3::from(lower.vertices_m()[lower.faces()[above][0]]);
            let low = face_in_plane(lower, above, origin, &axes);
            let high = face_in_plane(upper, below, origin, &axes);
            let patch = high.clipped(&low);
            let area = patch.moments().area_m2;
            let smaller = low.moments().area_m2.min(high.moments().area_m2);
            if area <= PATCH_LEAST * smaller {
                continue;
            }
            let gap = height_over(upper, below, &patch, origin, &axes)
                - height_over(lower, above, &patch, origin, &axes);
            if gap.abs() <= BED_GAP_M {
                let lift = axes[2] * height_over(lower, above, &patch, origin, &axes);
                offer(area, bed_of(patch, origin + lift, axes));
            }
        }
    }
    best.map(|(_, bed)| bed)
}

/// The vertical itself for what differs from it by round-off.
fn levelled(normal: DVec3) -> DVec3 {
    const ROUND_OFF: f64 = 1e-9;
    match normal.truncate().length() < ROUND_OFF {
        true => DVec3::Z * normal.z.signum(),
        false => normal,
    }
}

/// The normal of the joint between two faces that are nearly level: that of the one with the steeper slope, down which a stone slides first; of upright ones
/// the mean.
fn steeper(below: DVec3, above: DVec3) -> DVec3 {
    const LEVEL: f64 = 0.5;
    let (below, above) = (levelled(below), levelled(above));
    if below.z.abs().min(above.z.abs()) < LEVEL {
        (below + above).normalize()
    } else if below.z.abs() < above.z.abs() {
        below
    } else {
        above
    }
}

/// Height of a face's plane over the plane of `axes` through `origin`, at the centroid of a patch, m.
fn height_over(solid: &Solid, face: usize, patch: &Polygon, origin: DVec3, axes: &[DVec3; 3]) -> f64 {
    let centroid = patch.moments().centroid_m;
    let at = origin + axes[0] * centroid[0] + axes[1] * centroid[1];
    let normal = solid.normal(face);
    let corner = DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
    normal.dot(corner - at) / normal.dot(axes[2])
}

/// The bed with its origin at the patch's centroid.
fn bed_of(patch: Polygon, origin: DVec3, axes: [DVec3; 3]) -> Bed {
    let centroid = patch.moments().centroid_m;
    let corners = patch.corners_m.iter();
    let corners_m = corners
        .map(|corner| [corner[0] - centroid[0], corner[1] - centroid[1]])
        .collect();
    Bed {
        origin: origin + axes[0] * centroid[0] + axes[1] * centroid[1],
        axes,
        patch: Polygon { corners_m },
    }
}
