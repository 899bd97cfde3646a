//! The convex body bounded by planes: a square in each plane is clipped by all others.

use super::plane::Plane;
use crate::structure::stack::{Solid, StackError};
use glam::DVec3;

/// Corners closer than this fraction of the size are merged.
const SAME: f64 = 1e-9;

/// The body behind all planes within a box of half-size `reach_m` about `centre`.
pub(super) fn body(planes: &[Plane], centre: DVec3, reach_m: f64) -> Result<Solid, StackError> {
    let mut all = planes.to_vec();
    for axis in DVec3::AXES {
        for normal in [axis, -axis] {
            all.push(Plane {
                normal,
                offset_m: normal.dot(centre) + reach_m,
            });
        }
    }
    let mut corners: Vec<[f64; 3]> = Vec::new();
    for (number, plane) in all.iter().enumerate() {
        corners.extend(
            face(number, plane, &all, centre, reach_m)
                .into_iter()
                .map(<[f64; 3]>::from),
        );
    }
    Solid::convex(&corners)
}

/// The part of a plane behind all other planes.
fn face(number: usize, plane: &Plane, all: &[Plane], centre: DVec3, reach_m: f64) -> Vec<DVec3> {
    let along = plane.normal.any_orthonormal_vector();
    let across = plane.normal.cross(along);
    let on = centre - plane.normal * plane.height_m(centre);
    let far = 4.0 * reach_m;
    let mut corners = vec![
        on - along * far - across * far,
        on + along * far - across * far,
        on + along * far + across * far,
        on - along * far + across * far,
    ];
    for (other, behind) in all.iter().enumerate() {
        if other != number && !corners.is_empty() {
            corners = clipped(&corners, behind, SAME * reach_m);
        }
    }
    corners
}

fn clipped(corners: &[DVec3], behind: &Plane, same_m: f64) -> Vec<DVec3> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (low, high) = (behind.height_m(a) - same_m, behind.height_m(b) - same_m);
        if low <= 0.0 {
            kept.push(a);
        }
        if (low < 0.0 && high > 0.0) || (low > 0.0 && high < 0.0) {
            kept.push(a + (b - a) * (low / (low - high)));
        }
    }
    kept
}
