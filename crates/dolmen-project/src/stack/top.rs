//! The top face of a block, on which the next one stands.

use super::vectors::{centroid, unit_normal};
use dolmen::structure::stack::Solid;

/// Least upward component of the normal of a top face, the cosine of 45°. Our choice; a steeper face is a side.
const TOP_RISE_LEAST: f64 = 0.7;

/// The top of a solid: the centroid of its highest top face, and that face's upward normal.
pub(super) struct Top {
    pub(super) centroid_m: [f64; 3],
    normal: [f64; 3],
}

impl Top {
    pub(super) const GROUND: Top = Top {
        centroid_m: [0.0; 3],
        normal: [0.0, 0.0, 1.0],
    };

    pub(super) fn of(solid: &Solid) -> Option<Top> {
        let tops = solid.faces().iter().filter_map(|face| {
            let corners: Vec<[f64; 3]> = face.iter().map(|&vertex| solid.vertices_m()[vertex]).collect();
            let normal = unit_normal(&corners);
            (normal[2] >= TOP_RISE_LEAST).then(|| Top {
                centroid_m: centroid(&corners),
                normal,
            })
        });
        tops.max_by(|a, b| a.centroid_m[2].total_cmp(&b.centroid_m[2]))
    }

    /// Height of its plane above a point of the plan, m.
    pub(super) fn height_m(&self, plan: [f64; 2]) -> f64 {
        let [nx, ny, nz] = self.normal;
        let [x, y, z] = self.centroid_m;
        z - (nx * (plan[0] - x) + ny * (plan[1] - y)) / nz
    }
}
