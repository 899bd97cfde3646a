//! Cuts solids by a plane, for example a scan into stones at the planes of its joints.

use super::solid::moments_of;
use super::{Solid, StackError};
use glam::DVec3;
use std::collections::BTreeMap;

/// Smallest fraction of the solid in a part that is not empty. Our choice, because of rounding.
const NOTHING: f64 = 1e-9;

impl Solid {
    /// The part of the solid behind a plane, on the side opposite to `normal`.
    ///
    /// A mesh is cut as a mesh and closed at the plane; its contact is then the convex hull of the remaining part. Openings
    /// are cut too.
    ///
    /// # Errors
    /// [`StackError::Position`] or [`StackError::Direction`] for a plane that is not valid; [`StackError::CutAway`] if
    /// nothing remains.
    ///
    /// # Limits
    /// A drum is cut as its polygon of 32 sides with uniform mass: for a cut through the axis the error is 0.1 % in volume
    /// and 1 % in inertia.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::Solid;
    /// let lower = Solid::cuboid(1.0, 1.0, 1.0)?.cut([0.0, 0.0, 0.3], [0.0, 0.0, 1.0])?;
    /// assert!((lower.volume_m3() - 0.3).abs() < 1e-15);
    /// # Ok::<(), dolmen::structure::stack::StackError>(())
    /// ```
    pub fn cut(&self, point_m: [f64; 3], normal: [f64; 3]) -> Result<Self, StackError> {
        let (on, across) = (DVec3::from(point_m), DVec3::from(normal));
        if !on.is_finite() {
            return Err(StackError::Position {
                quantity: "a point of a cutting plane",
                given: point_m,
            });
        }
        let across = across.try_normalize().ok_or(StackError::Direction {
            quantity: "the normal of a cutting plane",
            given: normal,
        })?;
        let height = |v: DVec3| across.dot(v - on);
        if self.vertices_m().iter().all(|&v| height(DVec3::from(v)) <= 0.0) {
            return Ok(self.clone());
        }
        let away = StackError::CutAway { point_m, normal };
        if !self.pieces.is_empty() {
            let cut = self.pieces.iter().map(|piece| piece.cut(point_m, normal));
            let left: Result<Vec<Solid>, StackError> = cut
                .filter(|piece| !matches!(piece, Err(StackError::CutAway { .. })))
                .collect();
            return left.and_then(|left| match left.is_empty() {
                true => Err(away),
                false => Solid::joined(&left),
            });
        }
        let whole = if self.mesh.is_empty() {
            self.hull_triangles()
        } else {
            self.mesh.clone()
        };
        // openings are stone here and are subtracted below; a drum is larger than its polygon
        let openings: f64 = self.openings.iter().map(Solid::volume_m3).sum();
        let before = moments_of(whole.iter().copied(), on).0;
        let evenly = (self.volume_m3() + openings) / before;
        let kept = below(&whole, &height);
        let corners: Vec<[f64; 3]> = kept.iter().flatten().map(|&v| v.into()).collect();
        let Ok(hull) = Solid::convex(&corners) else {
            return Err(away);
        };
        let (volume, centroid, second) = moments_of(kept.iter().copied(), DVec3::from(hull.centroid_m()));
        if volume <= NOTHING * before {
            return Err(away);
        }
        let mut part = hull.with_moments(volume * evenly, centroid, second * evenly);
        if !self.mesh.is_empty() {
            part.mesh = kept;
        }
        for opening in &self.openings {
            match opening.cut(point_m, normal) {
                Ok(opening) => part = part.without(&opening).ok_or(away.clone())?,
                Err(StackError::CutAway { .. }) => {}
                Err(other) => return Err(other),
            }
        }
        Ok(part)
    }
}

/// The triangles below a plane, closed along it by a fan of signed triangles. This is exact for every integral, even if the
/// section is not convex.
fn below(triangles: &[[DVec3; 3]], height: &dyn Fn(DVec3) -> f64) -> Vec<[DVec3; 3]> {
    let mut kept = Vec::new();
    for triangle in triangles {
        let part = clipped(triangle, height);
        kept.extend((2..part.len()).map(|i| [part[0], part[i - 1], part[i]]));
    }
    // edges that belong to only one triangle, with their multiplicity
    let bits = |v: DVec3| v.to_array().map(|value| (value + 0.0).to_bits()); // −0 is 0
    let mut open = BTreeMap::new();
    for triangle in &kept {
        for i in 0..3 {
            let (from, to) = (triangle[i], triangle[(i + 1) % 3]);
            let forward = bits(from) <= bits(to);
            let (low, high) = if forward { (from, to) } else { (to, from) };
            let entry = open.entry((bits(low), bits(high))).or_insert((low, high, 0_i32));
            entry.2 += if forward { 1 } else { -1 };
        }
    }
    let Some(&(apex, ..)) = open.values().find(|edge| edge.2 != 0) else {
        return kept;
    };
    for &(low, high, times) in open.values() {
        let closing = if times > 0 {
            [high, low, apex]
        } else {
            [low, high, apex]
        };
        kept.extend((0..times.abs()).map(|_| closing));
    }
    kept
}

/// The part of a convex polygon with `height` ≤ 0. A cut edge gives the same point for both of its polygons.
pub(super) fn clipped(polygon: &[DVec3], height: &dyn Fn(DVec3) -> f64) -> Vec<DVec3> {
    let mut part = Vec::with_capacity(polygon.len() + 1);
    for (&a, &b) in polygon.iter().zip(polygon.iter().cycle().skip(1)) {
        let (at_a, at_b) = (height(a), height(b));
        if at_a <= 0.0 {
            part.push(a);
        }
        let between = |low: DVec3, at_low: f64, high: DVec3, at_high: f64| {
            low + (high - low) * (at_low / (at_low - at_high))
        };
        if at_a < 0.0 && at_b > 0.0 {
            part.push(between(a, at_a, b, at_b));
        } else if at_a > 0.0 && at_b < 0.0 {
            part.push(between(b, at_b, a, at_a));
        }
    }
    if part.len() < 3 { Vec::new() } else { part }
}

#[cfg(test)]
mod tests {
    use super::super::Placement;
    use super::*;
    use proptest::prelude::*;

    /// A U-shaped solid: a box 3 × 1 × 2 m with a notch 1 m wide and 1 m deep in the middle of its top.
    fn u_shape() -> Solid {
        let outline = [
            [0., 0.],
            [3., 0.],
            [3., 2.],
            [2., 2.],
            [2., 1.],
            [1., 1.],
            [1., 2.],
            [0., 2.],
        ];
        let ring = |y: f64| outline.iter().map(move |p| [p[0], y, p[1]]);
        let corners: Vec<[f64; 3]> = ring(0.0).chain(ring(1.0)).collect();
        let flat = [[0, 1, 4], [0, 4, 5], [1, 2, 3], [1, 3, 4], [0, 5, 6], [0, 6, 7]];
        let mut triangles: Vec<[usize; 3]> = flat.to_vec(); // seen along +y; counterclockwise is outward
        triangles.extend(flat.iter().map(|t| [t[0] + 8, t[2] + 8, t[1] + 8]));
        for i in 0..8 {
            let next = (i + 1) % 8;
            triangles.extend([[i, next + 8, next], [i, i + 8, next + 8]]);
        }
        Solid::mesh(&corners, &triangles).unwrap()
    }

    #[test]
    fn exact_prongs_of_a_u_above_its_notch() {
        let u = u_shape();
        assert!((u.volume_m3() - 5.0).abs() < 1e-14);
        let prongs = u.cut([0.0, 0.0, 1.25], [0.0, 0.0, -1.0]).unwrap();
        assert!((prongs.volume_m3() - 1.5).abs() < 1e-14 && (prongs.hull_volume_m3() - 2.25).abs() < 1e-14);
        assert!(
            (prongs.centroid_m()[0] - 1.5).abs() < 1e-14 && (prongs.centroid_m()[2] - 1.625).abs() < 1e-14
        );
        // two boxes 1 × 1 × 0.75 m, 1 m from the middle: about the vertical axis, m (1/6 + 1)
        assert!((prongs.inertia_m5()[2][2] - 1.5 * (1.0 / 6.0 + 1.0)).abs() < 1e-13);
        // one prong, by a second cut
        let prong = prongs.cut([1.5, 0.0, 0.0], [1.0, 0.0, 0.0]).unwrap();
        assert!((prong.volume_m3() - 0.75).abs() < 1e-14 && (prong.centroid_m()[0] - 0.5).abs() < 1e-14);
        // a cut in the plane of the notch's floor
        let foot = u.cut([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).unwrap();
        assert!((foot.volume_m3() - 3.0).abs() < 1e-14 && foot.faces().len() == 6);
    }

    #[test]
    fn exact_opening_is_cut_along() {
        let chamber = Solid::cuboid(0.4, 0.4, 0.4).unwrap();
        let place = Placement {
            position_m: [0.0, 0.0, 0.3],
            ..Placement::default()
        };
        let hollow = Solid::cuboid(1.0, 1.0, 1.0)
            .unwrap()
            .with_opening(&chamber.placed(&place))
            .unwrap();
        let lower = hollow.cut([0.0, 0.0, 0.4], [0.0, 0.0, 1.0]).unwrap();
        assert!((lower.volume_m3() - (0.4 - 0.016)).abs() < 1e-14);
        let foot = hollow.cut([0.0, 0.0, 0.25], [0.0, 0.0, 1.0]).unwrap();
        assert!((foot.volume_m3() - 0.25).abs() < 1e-14);
    }

    #[test]
    fn refuses_an_opening_outside_of_the_mesh_but_inside_its_hull() {
        let chamber = |x: f64| {
            let position_m = [x, 0.5, 1.2];
            let place = Placement {
                position_m,
                ..Placement::default()
            };
            Solid::cuboid(0.5, 0.5, 0.5).unwrap().placed(&place)
        };
        let u = u_shape();
        assert!((u.with_opening(&chamber(0.5)).unwrap().volume_m3() - 4.875).abs() < 1e-14);
        for x in [1.5, 1.0] {
            let fault = u.with_opening(&chamber(x)).unwrap_err(); // in the notch, and in its wall
            assert!(matches!(fault, StackError::OpeningInMesh { .. }), "{fault}");
        }
    }

    #[test]
    fn exact_half_of_a_drum() {
        let half = Solid::drum(2.0, 1.0)
            .unwrap()
            .cut([0.0; 3], [1.0, 0.0, 0.0])
            .unwrap();
        let exact = std::f64::consts::FRAC_PI_2;
        assert!((half.volume_m3() / exact - 1.0).abs() < 1e-12);
        assert!((half.centroid_m()[0] / (-4.0 / (3.0 * std::f64::consts::PI)) - 1.0).abs() < 4e-3);
        assert!(
            (half.inertia_m5()[2][2] / (exact * (0.5 - (4.0 / (3.0 * std::f64::consts::PI)).powi(2))) - 1.0)
                .abs()
                < 1e-2
        );
    }

    proptest! {
        /// The parts behind and in front of a plane add up to the whole: volume, first and second moments.
        #[test]
        fn holds_two_parts_make_the_whole(
            at in [0.2..2.8_f64, 0.1..0.9_f64, 0.1..1.9_f64],
            normal in [-1.0..1.0_f64, -1.0..1.0_f64, -1.0..1.0_f64],
        ) {
            prop_assume!(DVec3::from(normal).length() > 0.1);
            let whole = u_shape();
            let parts = [normal, normal.map(|v| -v)].map(|normal| whole.cut(at, normal));
            let [Ok(a), Ok(b)] = parts else { return Ok(()) };
            prop_assert!((a.volume_m3() + b.volume_m3() - whole.volume_m3()).abs() < 1e-12);
            let mut third = 0.0;
            for part in [&a, &b] {
                let d = DVec3::from(part.centroid_m()) - DVec3::from(whole.centroid_m());
                third += part.inertia_m5()[2][2] + part.volume_m3() * (d.x * d.x + d.y * d.y);
            }
            prop_assert!((third - whole.inertia_m5()[2][2]).abs() < 1e-11);
        }
    }

    #[test]
    fn refuses_to_leave_nothing() {
        let cube = Solid::cuboid(1.0, 1.0, 1.0).unwrap();
        let fault = cube.cut([0.0, 0.0, -0.1], [0.0, 0.0, 1.0]).unwrap_err();
        assert!(fault.to_string().starts_with("nothing is left"), "{fault}");
        assert_eq!(cube.cut([0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).unwrap(), cube);
        assert!(matches!(
            cube.cut([0.0; 3], [0.0; 3]),
            Err(StackError::Direction { .. })
        ));
    }
}
