//! The wedge between a stone and the one below it, if their beds meet but are not parallel.

use super::Solid;
use super::beds::{face_in_plane, gap_allowed_m, plane_axes};
use glam::DVec3;

/// Least |z| of the normal of a bed. Our choice: 45°.
const LEVEL: f64 = std::f64::consts::FRAC_1_SQRT_2;

/// Two beds that meet at one edge or corner.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Wedge {
    /// Angle between the beds, °.
    pub(super) angle_deg: f64,
    /// Height of the upper bed over the plane of the lower one at the farthest corner, m.
    pub(super) far_m: f64,
}

/// The wedge between the largest lower face of `upper` and the largest upper face of `lower` (the ground if `None`); `None` if the faces do
/// not meet, or are parallel within the allowed gap.
pub(super) fn wedge(lower: Option<&Solid>, upper: &Solid) -> Option<Wedge> {
    let down = largest(upper, -1.0)?;
    let (up, origin) = match lower {
        Some(lower) => {
            let face = largest(lower, 1.0)?;
            (lower.normal(face), corner(lower, face))
        }
        None => (DVec3::Z, DVec3::ZERO),
    };
    let allowed_m = lower.map_or(0.0, gap_allowed_m).max(gap_allowed_m(upper));
    let corners = upper.faces()[down]
        .iter()
        .map(|&vertex| upper.vertices_m()[vertex]);
    let heights = corners.map(|corner| up.dot(DVec3::from(corner) - origin));
    let [near_m, far_m] = heights.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], at| {
        [low.min(at), high.max(at)]
    });
    let is_wedge = near_m.abs() <= 2.0 * allowed_m && far_m - near_m > allowed_m;
    is_wedge.then(|| Wedge {
        angle_deg: (-up.dot(upper.normal(down))).clamp(-1.0, 1.0).acos().to_degrees(),
        far_m,
    })
}

fn corner(solid: &Solid, face: usize) -> DVec3 {
    DVec3::from(solid.vertices_m()[solid.faces()[face][0]])
}

/// The largest face towards ±z.
fn largest(solid: &Solid, side: f64) -> Option<usize> {
    let area = |face: usize| {
        let axes = plane_axes(solid.normal(face));
        face_in_plane(solid, face, corner(solid, face), &axes)
            .moments()
            .area_m2
    };
    (0..solid.faces().len())
        .filter(|&face| side * solid.normal(face).z > LEVEL)
        .max_by(|&a, &b| area(a).total_cmp(&area(b)))
}
