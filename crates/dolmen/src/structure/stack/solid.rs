//! The shape of a stone: a convex polyhedron for contact, with volume, centroid and inertia.

use super::StackError;
use glam::{DMat3, DVec3};

/// A closed solid: its convex hull determines contact; volume, centroid and inertia are its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Solid {
    vertices_m: Vec<[f64; 3]>,
    faces: Vec<Vec<usize>>,
    volume_m3: f64,
    centroid_m: [f64; 3],
    second_m5: [[f64; 3]; 3],
    /// Openings, already subtracted from volume, centroid and second moments.
    pub(super) openings: Vec<Solid>,
    /// The pieces of a stone of several, lowest first; empty otherwise. Drawings show them; contact and moments are those of the stone.
    pub(super) pieces: Vec<Solid>,
    /// The surface of the stone if it differs from the hull: triangles, outward; otherwise empty.
    pub(super) mesh: Vec<[DVec3; 3]>,
    /// Data of a mesh with noise; its faces are then fitted planes.
    pub(super) scan: Option<Box<Scan>>,
}

/// Data of a scanned stone.
#[derive(Clone, Debug, PartialEq)]
pub struct Scan {
    /// Standard deviation of the vertices from the planes of their faces, m.
    pub noise_m: f64,
    /// Mesh triangles of each face of the solid.
    pub(super) triangles: Vec<Vec<usize>>,
    /// For each face that is part of a curved surface, its radius of curvature, m.
    pub(super) radii_m: Vec<Option<f64>>,
}

/// Position of a solid: a rotation about the origin of its coordinates, then a shift.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Placement {
    /// Rotation about the vertical axis, rad, counterclockwise seen from above; applied first.
    pub yaw_rad: f64,
    /// Slopes dx/dz and dy/dz of the vertical axis of the solid; applied second.
    pub tilt: [f64; 2],
    /// Shift, m; applied last.
    pub position_m: [f64; 3],
}

impl Placement {
    pub(crate) fn rotation(&self) -> DMat3 {
        let axis = DVec3::new(self.tilt[0], self.tilt[1], 1.0).normalize();
        let lean = DMat3::from_quat(glam::DQuat::from_rotation_arc(DVec3::Z, axis));
        lean * DMat3::from_rotation_z(self.yaw_rad)
    }
}

pub(super) fn positive(quantity: &'static str, given: f64) -> Result<f64, StackError> {
    if given > 0.0 && given.is_finite() {
        Ok(given)
    } else {
        Err(StackError::Dimension {
            quantity,
            given,
            allowed: "a positive number",
        })
    }
}

impl Solid {
    /// A box with its base centred on the origin: width along x, depth along y, height upwards.
    ///
    /// # Errors
    /// [`StackError::Dimension`] unless each is positive.
    pub fn cuboid(width_m: f64, depth_m: f64, height_m: f64) -> Result<Self, StackError> {
        Solid::frustum([width_m, depth_m], [width_m, depth_m], height_m)
    }

    /// A frustum of a pyramid: rectangles [width, depth] at its base and top, centred on the vertical axis.
    ///
    /// # Errors
    /// [`StackError::Dimension`] unless each is positive.
    pub fn frustum(base_m: [f64; 2], top_m: [f64; 2], height_m: f64) -> Result<Self, StackError> {
        let base = [positive("width_m", base_m[0])?, positive("depth_m", base_m[1])?];
        let top = [
            positive("top_width_m", top_m[0])?,
            positive("top_depth_m", top_m[1])?,
        ];
        let height = positive("height_m", height_m)?;
        let corners = |size: [f64; 2], z: f64| {
            let (x, y) = (0.5 * size[0], 0.5 * size[1]);
            [[-x, -y, z], [x, -y, z], [x, y, z], [-x, y, z]]
        };
        let vertices = [corners(base, 0.0), corners(top, height)].concat();
        Ok(Solid::of_prismatoid(vertices))
    }

    /// A solid between two polygons of n corners each, counterclockwise seen from above: base first, then top.
    pub(super) fn of_prismatoid(vertices_m: Vec<[f64; 3]>) -> Self {
        let n = vertices_m.len() / 2;
        let mut faces = vec![(0..n).rev().collect::<Vec<_>>(), (n..2 * n).collect()];
        faces.extend((0..n).map(|i| vec![i, (i + 1) % n, n + (i + 1) % n, n + i]));
        Solid::of_faces(vertices_m, faces)
    }

    /// A solid with these faces, counterclockwise seen from outside. The caller ensures that they are closed, convex
    /// and outward.
    pub(super) fn of_faces(vertices_m: Vec<[f64; 3]>, faces: Vec<Vec<usize>>) -> Self {
        let near = vertices_m.first().copied().unwrap_or_default();
        let mut solid = Solid {
            vertices_m,
            faces,
            volume_m3: 0.0,
            centroid_m: near,
            second_m5: [[0.0; 3]; 3],
            openings: Vec::new(),
            pieces: Vec::new(),
            mesh: Vec::new(),
            scan: None,
        };
        let (volume, centroid, second) = moments_of(solid.hull_triangles().into_iter(), DVec3::from(near));
        (solid.volume_m3, solid.centroid_m) = (volume, centroid.into());
        solid.second_m5 = second.to_cols_array_2d();
        solid
    }

    /// Scan data, if the solid is a scan with noise.
    pub fn scan(&self) -> Option<&Scan> {
        self.scan.as_deref()
    }

    /// Radius of curvature of its lowest face, m, if that is the crown of a scanned boulder and no bed.
    pub(super) fn rounded_below_m(&self) -> Option<f64> {
        let down = |face: &usize| -self.normal(*face).z;
        let lowest = (0..self.faces().len()).max_by(|a, b| down(a).total_cmp(&down(b)))?;
        *self.scan()?.radii_m.get(lowest)?
    }

    /// Triangles of its hull, outward.
    pub(super) fn hull_triangles(&self) -> Vec<[DVec3; 3]> {
        let at = |i: usize| DVec3::from(self.vertices_m[i]);
        let triangles = self.faces.iter().flat_map(|face| {
            let fan = (1..face.len() - 1).map(move |k| [face[0], face[k], face[k + 1]]);
            fan.map(|t| t.map(at))
        });
        triangles.collect()
    }

    /// Corners of the convex hull, m.
    pub fn vertices_m(&self) -> &[[f64; 3]] {
        &self.vertices_m
    }

    /// Faces of the convex hull: indices of their corners, counterclockwise seen from outside.
    pub fn faces(&self) -> &[Vec<usize>] {
        &self.faces
    }

    /// Volume, m³.
    pub fn volume_m3(&self) -> f64 {
        self.volume_m3
    }

    /// Centroid, m.
    pub fn centroid_m(&self) -> [f64; 3] {
        self.centroid_m
    }

    /// Moment of inertia about the centroid for unit density, m⁵ (kg m² per kg/m³).
    ///
    /// ```text
    /// J = (tr S) 1 − S,   S = ∫ (x − c)(x − c)ᵀ dV          [3×3]
    /// ```
    pub fn inertia_m5(&self) -> [[f64; 3]; 3] {
        let second = DMat3::from_cols_array_2d(&self.second_m5);
        let trace = second.x_axis.x + second.y_axis.y + second.z_axis.z;
        (DMat3::from_diagonal(DVec3::splat(trace)) - second).to_cols_array_2d()
    }

    /// The solid at another position.
    pub fn placed(&self, placement: &Placement) -> Self {
        let rotation = placement.rotation();
        let shift = DVec3::from(placement.position_m);
        self.moved(rotation, shift)
    }

    /// The solid rotated about the origin, then shifted.
    pub(crate) fn moved(&self, rotation: DMat3, shift: DVec3) -> Self {
        let place = |v: &[f64; 3]| (rotation * DVec3::from(*v) + shift).into();
        let second = DMat3::from_cols_array_2d(&self.second_m5);
        Solid {
            vertices_m: self.vertices_m.iter().map(place).collect(),
            faces: self.faces.clone(),
            volume_m3: self.volume_m3,
            centroid_m: place(&self.centroid_m),
            second_m5: (rotation * second * rotation.transpose()).to_cols_array_2d(),
            openings: self.openings.iter().map(|o| o.moved(rotation, shift)).collect(),
            pieces: self.pieces.iter().map(|o| o.moved(rotation, shift)).collect(),
            mesh: self
                .mesh
                .iter()
                .map(|t| t.map(|v| rotation * v + shift))
                .collect(),
            scan: self.scan.clone(),
        }
    }

    pub(super) fn stretched(&self, stretch: DMat3, about: DVec3) -> Self {
        let place = |v: DVec3| about + stretch * (v - about);
        let second = DMat3::from_cols_array_2d(&self.second_m5);
        let bulk = stretch.determinant();
        Solid {
            vertices_m: self
                .vertices_m
                .iter()
                .map(|v| place((*v).into()).into())
                .collect(),
            faces: self.faces.clone(),
            volume_m3: bulk * self.volume_m3,
            centroid_m: place(self.centroid_m.into()).into(),
            second_m5: (stretch * second * stretch.transpose() * bulk).to_cols_array_2d(),
            openings: self
                .openings
                .iter()
                .map(|o| o.stretched(stretch, about))
                .collect(),
            pieces: self.pieces.iter().map(|o| o.stretched(stretch, about)).collect(),
            mesh: self.mesh.iter().map(|t| t.map(place)).collect(),
            scan: self.scan.clone(),
        }
    }

    /// Outward unit normal of a face.
    pub(crate) fn normal(&self, face: usize) -> DVec3 {
        // Newell: correct for any planar polygon
        let corners = &self.faces[face];
        let at = |i: usize| DVec3::from(self.vertices_m[corners[i % corners.len()]]);
        let origin = at(0);
        let sum: DVec3 = (1..corners.len() - 1)
            .map(|i| (at(i) - origin).cross(at(i + 1) - origin))
            .sum();
        sum.normalize_or_zero()
    }

    /// Smallest and largest coordinates of the corners, m.
    pub fn bounds_m(&self) -> [[f64; 3]; 2] {
        let mut bounds = [[f64::INFINITY; 3], [f64::NEG_INFINITY; 3]];
        for vertex in &self.vertices_m {
            for axis in 0..3 {
                bounds[0][axis] = bounds[0][axis].min(vertex[axis]);
                bounds[1][axis] = bounds[1][axis].max(vertex[axis]);
            }
        }
        bounds
    }

    /// The solid with the same contact geometry but other mass properties, for meshes and openings.
    pub(super) fn with_moments(mut self, volume_m3: f64, centroid_m: DVec3, second_m5: DMat3) -> Self {
        self.volume_m3 = volume_m3;
        self.centroid_m = centroid_m.into();
        self.second_m5 = second_m5.to_cols_array_2d();
        self
    }

    /// ∫ (x − c)(x − c)ᵀ dV about the centroid c, m⁵.
    pub(super) fn second_m5(&self) -> DMat3 {
        DMat3::from_cols_array_2d(&self.second_m5)
    }
}

/// Volume, centroid and ∫(x − c)(x − c)ᵀ dV within outward triangles; `near` is a point close to them, which avoids
/// cancellation. Tetrahedra from `near`: ∫ x xᵀ = V/20 (Σ vᵢvᵢᵀ + s sᵀ), s = Σ vᵢ.
pub(super) fn moments_of(triangles: impl Iterator<Item = [DVec3; 3]>, near: DVec3) -> (f64, DVec3, DMat3) {
    let outer = |v: DVec3| DMat3::from_cols(v * v.x, v * v.y, v * v.z);
    let (mut volume, mut first, mut second) = (0.0, DVec3::ZERO, DMat3::ZERO);
    for triangle in triangles {
        let [a, b, c] = triangle.map(|v| v - near);
        let tetrahedron = a.dot(b.cross(c)) / 6.0;
        let sum = a + b + c;
        volume += tetrahedron;
        first += sum * (0.25 * tetrahedron);
        second += (outer(a) + outer(b) + outer(c) + outer(sum)) * (tetrahedron / 20.0);
    }
    let mean = first / volume;
    (volume, near + mean, second - outer(mean) * volume)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_mass_properties_of_a_box_and_of_a_pyramid_frustum() {
        let solid = Solid::cuboid(0.3, 0.2, 0.1).unwrap();
        assert!((solid.volume_m3() - 0.006).abs() < 1e-17);
        assert!((solid.centroid_m()[2] - 0.05).abs() < 1e-16);
        let inertia = solid.inertia_m5();
        assert!((inertia[0][0] - 0.006 * (0.04 + 0.01) / 12.0).abs() < 1e-18);
        assert!((inertia[2][2] - 0.006 * (0.09 + 0.04) / 12.0).abs() < 1e-18);
        // square frustum a = 2, b = 1, h = 3: V = h/3 (a² + ab + b²) = 7; centroid h/4 (a²+2ab+3b²)/(a²+ab+b²)
        let solid = Solid::frustum([2.0, 2.0], [1.0, 1.0], 3.0).unwrap();
        assert!((solid.volume_m3() - 7.0).abs() < 1e-14);
        assert!((solid.centroid_m()[2] - 0.75 * 11.0 / 7.0).abs() < 1e-14);
    }

    #[test]
    fn holds_mass_properties_turn_with_the_solid() {
        let placement = Placement {
            yaw_rad: std::f64::consts::FRAC_PI_2,
            tilt: [0.0, 0.0],
            position_m: [5.0, 6.0, 7.0],
        };
        let turned = Solid::cuboid(0.3, 0.2, 0.1).unwrap().placed(&placement);
        let crosswise = Solid::cuboid(0.2, 0.3, 0.1).unwrap().inertia_m5();
        for (row, other) in turned.inertia_m5().iter().zip(crosswise) {
            for (a, b) in row.iter().zip(other) {
                assert!((a - b).abs() < 1e-17);
            }
        }
        assert!((turned.centroid_m()[2] - 7.05).abs() < 1e-14);
    }

    #[test]
    fn refuses_a_dimension_that_is_not_positive() {
        let fault = Solid::cuboid(0.3, -0.2, 0.1).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "depth_m is -0.2, but must be a positive number"
        );
    }
}
