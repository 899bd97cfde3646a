//! Contact of two convex solids: the pair of faces with the largest common patch.

use super::bearing::{AREA_LEAST, Bearing, OUTLINE_LEAST, bearing};
use super::only_corners::bounds;
use super::{Body, Joint, JointMaterial, Polygon, ScannedJoint, Solid, StackError};
use glam::DVec3;

/// Beds closer than this are in contact, m: surveyed dimensions and dressed stone are not more accurate. Our choice. The remaining gap or wedge is
/// filled (mortar, shims), so contact begins in the drawn position.
pub const BED_GAP_M: f64 = 0.005;
/// Cosine of the largest angle between faces in contact, 5°. Our choice: a stone that leans more does not rest on its bed.
const PARALLEL: f64 = 0.996_194_7;
/// Patches smaller than this fraction of the smaller face are only contact at an edge or corner. Our choice.
const PATCH_LEAST: f64 = 1e-6;

/// A contact is a sliver if it is narrower than the tolerance of drawings, [`BED_GAP_M`], and than this fraction of the narrower of
/// its two faces. Our choice: in small stones and models smaller contacts are known.
const SLIVER: f64 = 0.05;
/// Largest gap between beds of scans in contact, in standard deviations of their noise. Our choice.
const GAP_NOISE: f64 = 3.0;
/// Least fraction of a patch that is flat stone in both scans. Our choice: with less, the contact is an edge, or unknown.
const USED_LEAST: f64 = 0.3;

/// Least fraction of the area of all patches of two bodies in the largest one, which is their joint. Our choice: with less, the stones touch on a bed
/// that is not flat, and a single facet does not represent it.
const FACET_LEAST: f64 = 0.98;

pub(super) struct Bed {
    origin: DVec3,
    axes: [DVec3; 3],
    patch: Polygon,
    gap_m: f64,
    /// Area of the patch over that of all patches of the two solids.
    share: f64,
    /// The fraction of stone on stone, if it differs from 1.
    hollow: Option<Bearing>,
    scanned: Option<ScannedJoint>,
    /// Radius of curvature where the lower and the upper solid touch with a face that is no bed but part of a curved surface, m.
    radii_m: [Option<f64>; 2],
    /// Whether the patch is too narrow to be known from the drawing.
    is_sliver: bool,
    /// Whether a mesh shows only the corners of a bed that bounds the patch.
    only_corners: bool,
}

impl Bed {
    /// Radius of curvature where the lower and the upper solid touch with a face that is no bed but part of a curved surface, m.
    fn radii_m(&self) -> [Option<f64>; 2] {
        self.radii_m
    }

    /// The stone in the patch, if there is too little for bearing and tipping as the hulls do.
    fn hollow(&self) -> Option<Bearing> {
        self.hollow
    }

    /// The fraction of the patch that is flat stone, if too small for a joint.
    fn barely_used(&self) -> Option<f64> {
        let used = self.scanned?.used_ratio;
        (used < USED_LEAST).then_some(used)
    }

    /// The fraction of all patches in this one, if too small to represent them all.
    fn is_facet(&self) -> Option<f64> {
        (self.scanned.is_none() && self.share < FACET_LEAST).then_some(self.share)
    }

    /// The bed with data from the scans of its faces.
    fn scanned(mut self, faces: &[(&Solid, usize)]) -> Self {
        let scans = faces
            .iter()
            .filter_map(|(solid, face)| Some((*solid, *face, solid.scan()?)));
        let area = self.patch.moments().area_m2;
        let (mut used_ratio, mut roughness_m, mut any) = (1.0_f64, 0.0_f64, false);
        for (solid, face, scan) in scans {
            any = true;
            roughness_m = roughness_m.max(scan.noise_m);
            used_ratio = used_ratio.min(self.area_m2(solid, scan.triangles.get(face)) / area);
        }
        self.scanned = any.then_some(ScannedJoint {
            used_ratio,
            gap_m: self.gap_m,
            roughness_m,
        });
        self
    }

    /// Area of the scan triangles above the patch, in its plane, m².
    fn area_m2(&self, solid: &Solid, triangles: Option<&Vec<usize>>) -> f64 {
        let [first, second, normal] = self.axes;
        let each = triangles.into_iter().flatten().map(|&number| {
            let corners = solid.mesh[number].map(|v| {
                let from = v - self.origin;
                [from.dot(first), from.dot(second)]
            });
            let [a, b, c] = solid.mesh[number];
            let up = (b - a).cross(c - a).dot(normal) >= 0.0;
            let corners_m = if up {
                corners.to_vec()
            } else {
                corners.iter().rev().copied().collect()
            };
            Polygon { corners_m }.clipped(&self.patch).moments().area_m2
        });
        each.fold(0.0, std::ops::Add::add)
    }

    /// Sine of the slope of the normal above the horizontal.
    pub(super) fn rises(&self) -> f64 {
        self.axes[2].z
    }

    /// The patch seen from the other side.
    pub(super) fn turned(self) -> Self {
        let [first, second, normal] = self.axes;
        let corners = self.patch.corners_m.iter().rev();
        Bed {
            origin: self.origin,
            axes: [first, -second, -normal],
            patch: Polygon {
                corners_m: corners.map(|corner| [corner[0], -corner[1]]).collect(),
            },
            gap_m: self.gap_m,
            share: self.share,
            hollow: self.hollow,
            scanned: self.scanned,
            radii_m: self.radii_m,
            is_sliver: self.is_sliver,
            only_corners: self.only_corners,
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
            gap_m: self.gap_m,
            scanned: self.scanned,
            is_sliver: self.is_sliver,
            only_corners: self.only_corners,
        }
    }
}

/// Whether a patch between two faces is a sliver, with the tolerance of the drawing, m.
fn is_sliver(patch: &Polygon, faces: [&Polygon; 2], tolerance_m: f64) -> bool {
    let narrower_m = faces[0].width_m().min(faces[1].width_m());
    patch.width_m() < tolerance_m.min(SLIVER * narrower_m)
}

/// Two unit vectors in the plane of a normal, the first as near to x as possible, so that (first, second, normal) is right-handed.
pub(crate) fn plane_axes(normal: DVec3) -> [DVec3; 3] {
    let near = if normal.x.abs() < 0.9 { DVec3::X } else { DVec3::Y };
    let first = (near - normal * normal.dot(near)).normalize();
    [first, normal.cross(first), normal]
}

/// A face projected on a plane, counterclockwise about its normal.
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

/// The bed between `lower` (the ground if `None`) and `upper`; the normal points from lower to upper.
pub(super) fn bed(lower: Option<&Solid>, upper: &Solid) -> Option<Bed> {
    let mut best: Option<(f64, Bed, [Option<usize>; 2])> = None;
    let (mut total, mut radii_m) = (0.0, [None, None]);
    let radius = |solid: &Solid, face: usize| *solid.scan()?.radii_m.get(face)?;
    let mut offer = |area: f64, bed: Bed, faces: [Option<usize>; 2]| {
        total += area;
        let own = [lower.zip(faces[0]), faces[1].map(|face| (upper, face))];
        for (all, own) in radii_m.iter_mut().zip(own) {
            *all = all.or(own.and_then(|(solid, face)| radius(solid, face)));
        }
        if best.as_ref().is_none_or(|(most, ..)| area > *most) {
            best = Some((area, bed, faces));
        }
    };
    let allowed_m = lower.map_or(0.0, gap_allowed_m).max(gap_allowed_m(upper));
    for below in 0..upper.faces().len() {
        let down = upper.normal(below);
        let Some(lower) = lower else {
            if -down.z >= PARALLEL {
                // the filling of the wedge below a leaning stone has the slope of the stone's bed
                let axes = plane_axes(levelled(-down));
                let corner = DVec3::from(upper.vertices_m()[upper.faces()[below][0]]);
                let patch = face_in_plane(upper, below, corner, &axes);
                let area = patch.moments().area_m2;
                let mut bed = bed_of(patch, corner, axes);
                bed.gap_m = bed.origin.z;
                if bed.gap_m.abs() <= allowed_m {
                    offer(area, bed, [None, Some(below)]);
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
            if gap.abs() <= allowed_m {
                let lift = axes[2] * height_over(lower, above, &patch, origin, &axes);
                let is_sliver = is_sliver(&patch, [&low, &high], allowed_m);
                let mut bed = bed_of(patch, origin + lift, axes);
                (bed.gap_m, bed.is_sliver) = (gap, is_sliver);
                offer(area, bed, [Some(above), Some(below)]);
            }
        }
    }
    let (area, mut bed, [above, below]) = best?;
    bed.share = area / total;
    let found = below.map(|below| {
        let under = lower.zip(above);
        bearing(under, (upper, below), &bed.patch, bed.origin, &bed.axes)
    });
    bed.hollow = found.filter(|found| !found.is_whole());
    bed.radii_m = radii_m;
    let faces: Vec<(&Solid, usize)> = lower
        .zip(above)
        .into_iter()
        .chain(below.map(|b| (upper, b)))
        .collect();
    bed.only_corners = faces.iter().any(|(solid, face)| {
        solid.shows_only_corners(*face)
            && bounds(&face_in_plane(solid, *face, bed.origin, &bed.axes), &bed.patch)
    });
    Some(bed.scanned(&faces))
}

/// Largest gap of a bed in contact, m.
pub(super) fn gap_allowed_m(solid: &Solid) -> f64 {
    solid
        .scan()
        .map_or(BED_GAP_M, |scan| BED_GAP_M.max(GAP_NOISE * scan.noise_m))
}

/// The exact vertical, for a normal that differs from it only by rounding.
fn levelled(normal: DVec3) -> DVec3 {
    const ROUND_OFF: f64 = 1e-9;
    match normal.truncate().length() < ROUND_OFF {
        true => DVec3::Z * normal.z.signum(),
        false => normal,
    }
}

/// The normal of the joint between two nearly level faces: that of the steeper face, on which a stone slides first. For upright faces the mean of
/// both.
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
        gap_m: 0.0,
        share: 1.0,
        hollow: None,
        scanned: None,
        radii_m: [None, None],
        is_sliver: false,
        only_corners: false,
    }
}

/// The refusal of a joint on a rounded face.
pub(super) fn rounded(upper: &str, lower: &str, rounded: &str, radius_m: f64) -> StackError {
    StackError::JointRounded {
        upper: upper.to_owned(),
        lower: lower.to_owned(),
        rounded: rounded.to_owned(),
        radius_m,
    }
}

/// Refuses a joint that is not one flat patch of stone on stone, and of scans flat stone for the most part.
pub(super) fn check_used(bed: &Bed, lower: &str, upper: &str) -> Result<(), StackError> {
    for (name, radius_m) in [upper, lower].into_iter().zip(bed.radii_m().into_iter().rev()) {
        if let Some(radius_m) = radius_m {
            return Err(rounded(upper, lower, name, radius_m));
        }
    }
    if let Some(found) = bed.hollow() {
        return Err(StackError::JointHollow {
            upper: upper.to_owned(),
            lower: lower.to_owned(),
            area: found.area,
            area_allowed: AREA_LEAST,
            outline: found.outline,
            outline_allowed: OUTLINE_LEAST,
        });
    }
    if let Some(share) = bed.is_facet() {
        return Err(StackError::JointFacets {
            upper: upper.to_owned(),
            lower: lower.to_owned(),
            share,
            allowed: FACET_LEAST,
        });
    }
    match bed.barely_used() {
        None => Ok(()),
        Some(used) => Err(StackError::JointUsed {
            upper: upper.to_owned(),
            lower: lower.to_owned(),
            used,
            allowed: USED_LEAST,
        }),
    }
}
