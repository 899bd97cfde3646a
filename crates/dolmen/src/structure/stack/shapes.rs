//! Regular prisms and drums, whole and tapered.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a, b | `a`, `b` | radius at the base and at the top | m |
//! | h | `height` | height | m |
//! | S | `second` | ∫ (x − c)(x − c)ᵀ dV | m⁵ |

use super::solid::positive;
use super::{Solid, StackError};
use glam::{DMat3, DVec3};
use std::f64::consts::{PI, TAU};

/// Number of sides of the polygon that replaces the circle of a drum in contact. Our choice: its corners are on the circle,
/// so its area is 0.64 % smaller and its extent at most 0.48 %, which is conservative.
const DRUM_SIDES: u32 = 32;

/// Largest number of sides of a prism. Our choice: with more sides, use a drum.
const SIDES_MOST: u32 = 64;

impl Solid {
    /// A regular prism with its base centred on the origin; one side faces along x.
    ///
    /// `width_m` is the width across flats: twice the distance from the axis to a side, also for an odd number of sides.
    ///
    /// # Errors
    /// [`StackError::Sides`] for fewer than 3 or more than 64 sides, [`StackError::Dimension`] unless width and height are
    /// positive.
    ///
    /// # Example
    /// ```
    /// use dolmen::structure::stack::Solid;
    /// let octagon = Solid::prism(8, 1.0, 0.5)?;
    /// let area = 2.0 * (2.0_f64.sqrt() - 1.0); // of an octagon one across flats
    /// assert!((octagon.volume_m3() - 0.5 * area).abs() < 1e-15);
    /// # Ok::<(), dolmen::structure::stack::StackError>(())
    /// ```
    pub fn prism(sides: u32, width_m: f64, height_m: f64) -> Result<Self, StackError> {
        Solid::prism_frustum(sides, width_m, width_m, height_m)
    }

    /// A regular prism that tapers from one width across flats at its base to another at its top.
    ///
    /// # Errors
    /// As [`Solid::prism`].
    pub fn prism_frustum(
        sides: u32,
        width_m: f64,
        top_width_m: f64,
        height_m: f64,
    ) -> Result<Self, StackError> {
        if !(3..=SIDES_MOST).contains(&sides) {
            return Err(StackError::Sides {
                given: sides,
                most: SIDES_MOST,
            });
        }
        let to_corner = 0.5 / (PI / f64::from(sides)).cos();
        let base = to_corner * positive("width_m", width_m)?;
        let top = to_corner * positive("top_width_m", top_width_m)?;
        Ok(between_polygons(
            sides,
            base,
            top,
            positive("height_m", height_m)?,
        ))
    }

    /// A drum: an upright cylinder with its base centred on the origin.
    ///
    /// # Errors
    /// [`StackError::Dimension`] unless both are positive.
    ///
    /// # Limits
    /// Volume, centroid and inertia are those of the cylinder. Contact is that of an inscribed polygon of 32 sides: its
    /// area is 0.64 % smaller, the distance to its edge up to 0.48 %.
    pub fn drum(diameter_m: f64, height_m: f64) -> Result<Self, StackError> {
        Solid::tapered_drum(diameter_m, diameter_m, height_m)
    }

    /// A tapered drum: a frustum of a cone.
    ///
    /// ```text
    /// V = π h (a² + ab + b²)/3,   z = h (a² + 2ab + 3b²)/4(a² + ab + b²)
    /// ∫x² = π h (a⁴ + a³b + a²b² + ab³ + b⁴)/20,   ∫z² = π h³ (a² + 3ab + 6b²)/30 − V z²
    /// ```
    ///
    /// # Errors
    /// [`StackError::Dimension`] unless all are positive.
    ///
    /// # Limits
    /// As [`Solid::drum`].
    pub fn tapered_drum(diameter_m: f64, top_diameter_m: f64, height_m: f64) -> Result<Self, StackError> {
        let a = 0.5 * positive("diameter_m", diameter_m)?;
        let b = 0.5 * positive("top_diameter_m", top_diameter_m)?;
        let height = positive("height_m", height_m)?;
        let squares = a * a + a * b + b * b;
        let volume = PI * height * squares / 3.0;
        let centroid = 0.25 * height * (a * a + 2.0 * a * b + 3.0 * b * b) / squares;
        let fourths = a.powi(4) + a.powi(3) * b + (a * b).powi(2) + a * b.powi(3) + b.powi(4);
        let across = PI * height * fourths / 20.0;
        let along =
            PI * height.powi(3) * (a * a + 3.0 * a * b + 6.0 * b * b) / 30.0 - volume * centroid * centroid;
        let second = DMat3::from_diagonal(DVec3::new(across, across, along));
        let polygon = between_polygons(DRUM_SIDES, a, b, height);
        Ok(polygon.with_moments(volume, DVec3::Z * centroid, second))
    }
}

/// A solid between two regular polygons with these radii to their corners.
fn between_polygons(sides: u32, base: f64, top: f64, height: f64) -> Solid {
    let ring = |radius: f64, z: f64| {
        (0..sides).map(move |i| {
            let angle = TAU * (f64::from(i) - 0.5) / f64::from(sides);
            [radius * angle.cos(), radius * angle.sin(), z]
        })
    };
    Solid::of_prismatoid(ring(base, 0.0).chain(ring(top, height)).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_prism_of_four_sides_is_a_box() {
        let (prism, cuboid) = (
            Solid::prism(4, 0.6, 0.3).unwrap(),
            Solid::cuboid(0.6, 0.6, 0.3).unwrap(),
        );
        assert!((prism.volume_m3() - cuboid.volume_m3()).abs() < 1e-16);
        for (a, b) in prism
            .bounds_m()
            .iter()
            .flatten()
            .zip(cuboid.bounds_m().iter().flatten())
        {
            assert!((a - b).abs() < 1e-15);
        }
        let frustum = Solid::prism_frustum(4, 2.0, 1.0, 3.0).unwrap();
        assert!((frustum.volume_m3() - 7.0).abs() < 1e-14);
    }

    #[test]
    fn exact_mass_properties_of_a_cylinder_and_of_a_cone() {
        let drum = Solid::drum(0.8, 0.5).unwrap();
        let volume = PI * 0.16 * 0.5;
        assert!((drum.volume_m3() - volume).abs() < 1e-15 && (drum.centroid_m()[2] - 0.25).abs() < 1e-16);
        let inertia = drum.inertia_m5();
        assert!((inertia[2][2] - volume * 0.16 / 2.0).abs() < 1e-16); // m r²/2
        assert!((inertia[0][0] - volume * (3.0 * 0.16 + 0.25) / 12.0).abs() < 1e-16); // m (3r² + h²)/12
        // a cone: V = πr²h/3, centroid h/4, moments of inertia 3mr²/10 about its axis and 3m(4r² + h²)/80 across it
        let cone = Solid::tapered_drum(2.0, 1e-9, 3.0).unwrap();
        assert!((cone.volume_m3() - PI).abs() < 1e-8 && (cone.centroid_m()[2] - 0.75).abs() < 1e-8);
        assert!((cone.inertia_m5()[2][2] - 0.3 * PI).abs() < 1e-8);
        assert!((cone.inertia_m5()[1][1] - 3.0 * PI * 13.0 / 80.0).abs() < 1e-8);
    }

    /// A prism with the area of the drum approaches the drum as its number of sides grows, with an error of 1/n²:
    /// extrapolated from 32 and 64.
    #[test]
    fn exact_prisms_tend_to_the_tapered_drum() {
        let drum = Solid::tapered_drum(1.0, 0.7, 0.9).unwrap();
        let [coarse, fine] = [32, 64].map(|sides| Solid::prism_frustum(sides, 1.0, 0.7, 0.9).unwrap());
        let limit = |coarse: f64, fine: f64| fine + (fine - coarse) / 3.0;
        let volume = limit(coarse.volume_m3(), fine.volume_m3());
        assert!((volume / drum.volume_m3() - 1.0).abs() < 1e-5);
        for axis in 0..3 {
            let inertia = limit(coarse.inertia_m5()[axis][axis], fine.inertia_m5()[axis][axis]);
            assert!((inertia / drum.inertia_m5()[axis][axis] - 1.0).abs() < 1e-4);
        }
    }

    #[test]
    fn exact_contact_polygon_of_a_drum() {
        let drum = Solid::drum(2.0, 1.0).unwrap();
        let polygon = 16.0 * (TAU / 32.0).sin();
        assert!((polygon / PI - 0.9936).abs() < 1e-4 && ((PI / 32.0).cos() - 0.9952).abs() < 1e-4);
        let reach = drum.vertices_m().iter().map(|v| v[0].hypot(v[1]));
        assert!(reach.into_iter().all(|radius| (radius - 1.0).abs() < 1e-15));
        assert_eq!(drum.faces().len(), 34);
    }

    #[test]
    fn refuses_two_sides_and_no_height() {
        assert_eq!(
            Solid::prism(2, 1.0, 1.0).unwrap_err().to_string(),
            "a prism of 2 sides: it must have 3 to 64; more than that is a drum"
        );
        assert_eq!(
            Solid::drum(1.0, f64::NAN).unwrap_err().to_string(),
            "height_m is NaN, but must be a positive number"
        );
    }
}
