//! Least-squares planes: of triangles, weighted by area, or of points.

use super::surface::Surface;
use glam::DVec3;

/// The plane n·x = d with its outward unit normal.
#[derive(Clone, Copy, Debug)]
pub(in crate::structure::stack) struct Plane {
    pub(in crate::structure::stack) normal: DVec3,
    pub(in crate::structure::stack) offset_m: f64,
}

impl Plane {
    /// Height of a point above the plane, m; positive outside.
    pub(in crate::structure::stack) fn height_m(&self, point: DVec3) -> f64 {
        self.normal.dot(point) - self.offset_m
    }

    /// The least-squares plane of the corners of triangles, each corner weighted by a third of the area.
    pub(super) fn of(surface: &Surface, triangles: &[usize], before: DVec3) -> Option<Plane> {
        let corners = || {
            triangles.iter().flat_map(|&t| {
                let weight = surface.areas[t].length() / 3.0;
                surface.corners(t).map(|point| (weight, point))
            })
        };
        Plane::weighted(corners, before)
    }

    /// The least-squares plane of weighted points.
    ///
    /// ```text
    /// min over a, b, c of Σ w (z − a x − b y − c)²      in axes about the earlier normal, x and y from the centroid
    /// ```
    pub(in crate::structure::stack) fn weighted<I>(points: impl Fn() -> I, before: DVec3) -> Option<Plane>
    where
        I: Iterator<Item = (f64, DVec3)>,
    {
        let (total, first) = points().fold((0.0, DVec3::ZERO), |(total, first), (w, p)| {
            (total + w, first + p * w)
        });
        if total <= 0.0 {
            return None;
        }
        let centre = first / total;
        let mut normal = before;
        for _ in 0..3 {
            let along = normal.any_orthonormal_vector();
            let across = normal.cross(along);
            let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0, 0.0, 0.0, 0.0, 0.0);
            for (w, p) in points() {
                let from = p - centre;
                let (x, y, z) = (from.dot(along), from.dot(across), from.dot(normal));
                xx += w * x * x;
                xy += w * x * y;
                yy += w * y * y;
                xz += w * x * z;
                yz += w * y * z;
            }
            let determinant = xx * yy - xy * xy;
            if determinant <= 1e-12 * xx * yy {
                return None; // a sliver has no plane
            }
            let a = (xz * yy - yz * xy) / determinant;
            let b = (yz * xx - xz * xy) / determinant;
            normal = (normal - along * a - across * b).normalize();
        }
        Some(Plane {
            normal,
            offset_m: normal.dot(centre),
        })
    }
}
