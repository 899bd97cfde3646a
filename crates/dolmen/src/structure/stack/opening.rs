//! Openings: niches and cavities that reduce the mass but do not change the contact.

use super::cut::clipped;
use super::overlap::overlap_depth;
use super::{Solid, StackError};
use glam::{DMat3, DVec3};
use std::f64::consts::TAU;

/// Largest distance of an opening outside the solid, relative to its size: rounding of coordinates. Our choice.
const STICKS_OUT: f64 = 1e-9;

impl Solid {
    /// The solid without the mass of an opening, such as a niche or a relic chamber.
    ///
    /// ```text
    /// V = V₁ − V₂,   V c = V₁ c₁ − V₂ c₂,   S = S₁ + V₁ d₁d₁ᵀ − S₂ − V₂ d₂d₂ᵀ,   d = c₁ − c, c₂ − c
    /// ```
    ///
    /// # Errors
    /// [`StackError::Opening`] unless its corners are in the convex hull of the solid and the remaining solid has mass; [`StackError::Openings`] if
    /// it intersects an earlier opening; [`StackError::OpeningInMesh`] if it extends outside the mesh of the solid.
    ///
    /// # Limits
    /// The contact remains that of the whole solid, so a stack refuses a bed of which an opening removes an edge or more than a tenth. Cut such a
    /// stone into several parts.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::{Placement, Solid};
    /// let chamber = Solid::cuboid(0.4, 0.4, 0.3)?;
    /// let raised = chamber.placed(&Placement { position_m: [0.0, 0.0, 0.35], ..Placement::default() });
    /// let body = Solid::cuboid(1.0, 1.0, 1.0)?.with_opening(&raised)?;
    /// assert!((body.volume_m3() - 0.952).abs() < 1e-15);
    /// # Ok::<(), dolmen::structure::stack::StackError>(())
    /// ```
    pub fn with_opening(&self, opening: &Solid) -> Result<Self, StackError> {
        let bounds = self.bounds_m();
        let size = (0..3)
            .map(|axis| bounds[1][axis] - bounds[0][axis])
            .fold(0.0, f64::max);
        let mut out = (0.0, [0.0; 3]);
        for face in 0..self.faces().len() {
            let normal = self.normal(face);
            let on = DVec3::from(self.vertices_m()[self.faces()[face][0]]);
            for &corner in opening.vertices_m() {
                let beyond = normal.dot(DVec3::from(corner) - on);
                if beyond > out.0 {
                    out = (beyond, corner);
                }
            }
        }
        let refused = StackError::Opening {
            corner: out.1,
            beyond_m: out.0,
        };
        if out.0 > STICKS_OUT * size {
            return Err(refused);
        }
        for earlier in &self.openings {
            let depth_m = overlap_depth(earlier, opening);
            if depth_m > STICKS_OUT * size {
                return Err(StackError::Openings { depth_m });
            }
        }
        self.check_mesh(opening, STICKS_OUT * size)?;
        self.without(opening).ok_or(refused)
    }

    /// Checks that no triangle of a mesh is in the opening, and that the opening is inside the mesh.
    fn check_mesh(&self, opening: &Solid, near: f64) -> Result<(), StackError> {
        if self.mesh.is_empty() {
            return Ok(());
        }
        let mut area_m2 = 0.0;
        for triangle in &self.mesh {
            let mut part = triangle.to_vec();
            for face in 0..opening.faces().len() {
                let normal = opening.normal(face);
                let on = DVec3::from(opening.vertices_m()[opening.faces()[face][0]]);
                part = clipped(&part, &|v| normal.dot(v - on) + near);
            }
            let fan = (2..part.len()).map(|i| (part[i - 1] - part[0]).cross(part[i] - part[0]));
            area_m2 += 0.5 * fan.sum::<DVec3>().length();
        }
        let seen = solid_angle(&self.mesh, DVec3::from(opening.centroid_m()));
        if area_m2 > near * near || seen < TAU {
            return Err(StackError::OpeningInMesh { area_m2 });
        }
        Ok(())
    }

    /// The solid without the mass of an opening that is known to be inside; `None` if nothing is left.
    pub(super) fn without(&self, opening: &Solid) -> Option<Self> {
        let volume = self.volume_m3() - opening.volume_m3();
        if volume <= STICKS_OUT * self.volume_m3() {
            return None;
        }
        let (c1, c2) = (DVec3::from(self.centroid_m()), DVec3::from(opening.centroid_m()));
        let centroid = (c1 * self.volume_m3() - c2 * opening.volume_m3()) / volume;
        let second = about(self, c1 - centroid) - about(opening, c2 - centroid);
        let mut hollow = self.clone().with_moments(volume, centroid, second);
        hollow.openings.push(opening.clone());
        Some(hollow)
    }
}

/// Solid angle of a closed surface seen from a point: 4π from inside, 0 from outside. Van Oosterom & Strackee (1983).
fn solid_angle(triangles: &[[DVec3; 3]], from: DVec3) -> f64 {
    let of = |triangle: &[DVec3; 3]| {
        let [a, b, c] = triangle.map(|v| v - from);
        let [la, lb, lc] = [a, b, c].map(DVec3::length);
        2.0 * a
            .dot(b.cross(c))
            .atan2(la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb)
    };
    triangles.iter().map(of).sum()
}

/// ∫ x xᵀ dV of a solid whose centroid lies at d.
fn about(solid: &Solid, d: DVec3) -> DMat3 {
    solid.second_m5() + DMat3::from_cols(d * d.x, d * d.y, d * d.z) * solid.volume_m3()
}

#[cfg(test)]
mod tests {
    use super::super::Placement;
    use super::*;

    fn cube(side: f64, at: [f64; 3]) -> Solid {
        let place = Placement {
            position_m: at,
            ..Placement::default()
        };
        Solid::cuboid(side, side, side).unwrap().placed(&place)
    }

    /// Compares two halves of a box with a cavity with one box whose other half is removed as an opening.
    #[test]
    fn exact_a_box_without_its_right_half_is_its_left_half() {
        let place = |x: f64| Placement {
            position_m: [x, 0.0, 0.0],
            ..Placement::default()
        };
        let half = Solid::cuboid(0.5, 0.7, 0.4).unwrap();
        let whole = Solid::cuboid(1.0, 0.7, 0.4).unwrap();
        let left = whole.with_opening(&half.placed(&place(0.25))).unwrap();
        let exact = half.placed(&place(-0.25));
        assert!((left.volume_m3() - exact.volume_m3()).abs() < 1e-15);
        for axis in 0..3 {
            assert!((left.centroid_m()[axis] - exact.centroid_m()[axis]).abs() < 1e-15);
            for other in 0..3 {
                let (a, b) = (left.inertia_m5()[axis][other], exact.inertia_m5()[axis][other]);
                assert!((a - b).abs() < 1e-15);
            }
        }
        assert_eq!(left.vertices_m(), whole.vertices_m());
    }

    #[test]
    fn refuses_an_opening_that_sticks_out_or_is_dug_twice() {
        let body = cube(1.0, [0.0, 0.0, 0.0]);
        let fault = body.with_opening(&cube(0.4, [0.5, 0.0, 0.1])).unwrap_err();
        assert!(fault.to_string().contains("0.2000 m outside"), "{fault}");
        let hollow = body.with_opening(&cube(0.4, [-0.2, 0.0, 0.1])).unwrap();
        assert!(hollow.with_opening(&cube(0.4, [0.2, 0.0, 0.1])).is_ok());
        let fault = hollow.with_opening(&cube(0.4, [0.1, 0.0, 0.1])).unwrap_err();
        assert!(fault.to_string().contains("0.1000 m"), "{fault}");
        assert!(body.with_opening(&body).is_err());
    }
}
