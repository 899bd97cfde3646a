//! Beds of which a mesh shows only the corners, so that nothing shows how exact they are.

use super::{Polygon, Solid};
use glam::DVec3;
use std::collections::BTreeSet;

/// Largest distance of a vertex from the plane of an exact face, as a fraction of the size of the stone. Our choice.
const IN_FACE: f64 = 1e-6;
/// Largest distance of an edge of a patch from that of a face, as a fraction of the size of the patch: rounding.
const ON_EDGE: f64 = 1e-9;

impl Solid {
    /// Whether the mesh of a stone has no more vertices in a face than the outline of the face has corners: four corners always lie on a rectangle, or
    /// nearly so, wherever they are. False for a solid that is not a mesh.
    pub(super) fn shows_only_corners(&self, face: usize) -> bool {
        let most = self.faces()[face].len();
        let (normal, [low, high]) = (self.normal(face), self.bounds_m().map(DVec3::from));
        let on = DVec3::from(self.vertices_m()[self.faces()[face][0]]);
        let allowed_m = IN_FACE * (high - low).max_element();
        let fitted = self.scan().and_then(|scan| scan.triangles.get(face));
        let mut seen: BTreeSet<[u64; 3]> = BTreeSet::new();
        let mut is_fine = |corner: DVec3| {
            seen.insert(corner.to_array().map(f64::to_bits));
            seen.len() > most
        };
        let shows_more = match (self.scan(), fitted) {
            (Some(_), Some(own)) => own.iter().flat_map(|&t| self.mesh[t]).any(&mut is_fine),
            (Some(_), None) => return false,
            (None, _) => {
                let corners = self.mesh.iter().flatten().copied();
                let mut own = corners.filter(|corner| normal.dot(*corner - on).abs() <= allowed_m);
                own.any(&mut is_fine)
            }
        };
        !shows_more && !seen.is_empty()
    }
}

/// Whether an edge of a patch lies on an edge of one of the two faces that it belongs to.
pub(super) fn bounds(face: &Polygon, patch: &Polygon) -> bool {
    let near_m = ON_EDGE * face.size_m().max(patch.size_m());
    let corners = &patch.corners_m;
    let edges = corners.iter().zip(corners.iter().cycle().skip(1));
    edges
        .map(|(a, b)| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])])
        .any(|middle| face.depth_m(middle) <= near_m)
}
