//! Sites of mass dampers: the floors of a building in plan.

use super::{AttachedDamper, DamperError, DamperKind};
use crate::structure::building::{nearest_on_floor, nearest_on_side};

/// A rigid floor that can carry dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperSite {
    /// Index of the floor's u at its reference point among the degrees of freedom of the structure; v and θ follow.
    pub first_degree_of_freedom: usize,
    /// Reference point in plan, m.
    pub reference_m: [f64; 2],
    /// Corners of the floor in order, m; dampers must be inside.
    pub corners_m: Vec<[f64; 2]>,
}

/// A mass damper or a liquid column on a floor.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlacedDamper {
    /// The site, from 0.
    #[cfg_attr(feature = "serde", serde(skip))]
    pub site: usize,
    /// x and y in plan, m.
    pub place_m: [f64; 2],
    /// Direction of its motion, counter-clockwise from x, degrees.
    pub direction_degrees: f64,
    /// Mass m, kg; the whole liquid for a liquid column.
    pub mass_kg: f64,
    /// Frequency of the damper alone, Hz.
    pub frequency_hz: f64,
    /// Damping ratio c/(2 m ω), with ω of the damper alone.
    pub damping_ratio: f64,
    /// α of a liquid column, horizontal over total length, in (0, 1); 1 for a mass on a spring, which is equivalent to a column with
    /// α = 1.
    pub length_ratio: f64,
}

impl DamperSite {
    /// cos α (u − (y − y_r) θ) + sin α (v + (x − x_r) θ): coefficients of u, v, θ in the motion of a place in direction α.
    pub fn coefficients(&self, place_m: [f64; 2], direction_degrees: f64) -> [f64; 3] {
        let [cos, sin] = unit(direction_degrees);
        let [x, y] = [0, 1].map(|i| place_m[i] - self.reference_m[i]);
        [cos, sin, sin * x - cos * y]
    }

    /// Bounding box of the floor: smallest and largest x, smallest and largest y, m.
    pub fn extent_m(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| {
            let values = self.corners_m.iter().map(|corner| corner[axis]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
                [low.min(v), high.max(v)]
            })
        })
    }

    /// The nearest point of the floor and its distance, m; a point on the floor is its own nearest point.
    pub fn nearest_m(&self, place_m: [f64; 2]) -> ([f64; 2], f64) {
        nearest_on_floor(&self.corners_m, place_m)
    }

    /// Distance to the edge, m, from inside or outside.
    pub(super) fn to_edge_m(&self, [x, y]: [f64; 2]) -> f64 {
        let sides = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        let each = sides.map(|(a, b)| {
            let side = nearest_on_side(*a, *b, [x, y]);
            (x - side[0]).hypot(y - side[1])
        });
        each.fold(f64::INFINITY, f64::min)
    }

    pub(super) fn check(&self, degrees_of_freedom: usize) -> Result<(), DamperError> {
        if self.first_degree_of_freedom + 3 > degrees_of_freedom {
            return Err(DamperError::Row {
                damper: 1,
                given: self.first_degree_of_freedom + 3,
                needed: degrees_of_freedom,
            });
        }
        if self.corners_m.len() < 3 || self.corners_m.iter().flatten().any(|c| !c.is_finite()) {
            return Err(DamperError::Argument {
                argument: "corners_m",
                given: self.corners_m.len() as f64,
                allowed: "three or more corners of finite coordinates",
            });
        }
        Ok(())
    }
}

/// cos and sin of a direction, exact along the axes.
fn unit(direction_degrees: f64) -> [f64; 2] {
    match direction_degrees.rem_euclid(360.0) {
        0.0 => [1.0, 0.0],
        90.0 => [0.0, 1.0],
        180.0 => [-1.0, 0.0],
        270.0 => [0.0, -1.0],
        degrees => {
            let (sin, cos) = degrees.to_radians().sin_cos();
            [cos, sin]
        }
    }
}

impl PlacedDamper {
    /// The damper with its coefficients for all degrees of freedom of the structure.
    ///
    /// # Errors
    /// [`DamperError::OutsideFloor`] if it is beyond the edge of its floor; [`DamperError::Argument`] for a site that does not exist.
    pub fn attached(
        &self,
        sites: &[DamperSite],
        degrees_of_freedom: usize,
    ) -> Result<AttachedDamper, DamperError> {
        let site = sites.get(self.site).ok_or(DamperError::Argument {
            argument: "site",
            given: self.site as f64,
            allowed: "one of the sites given",
        })?;
        let extent = site.extent_m();
        let size = (extent[0][1] - extent[0][0]).max(extent[1][1] - extent[1][0]);
        let (_, beyond_m) = site.nearest_m(self.place_m);
        if beyond_m.is_nan() || beyond_m > 1e-9 * size {
            return Err(DamperError::OutsideFloor {
                x_m: self.place_m[0],
                y_m: self.place_m[1],
                beyond_m,
            });
        }
        let mut row = vec![0.0; degrees_of_freedom];
        let coefficients = site.coefficients(self.place_m, self.direction_degrees);
        row[site.first_degree_of_freedom..site.first_degree_of_freedom + 3].copy_from_slice(&coefficients);
        Ok(AttachedDamper {
            kind: self.kind(),
            row,
        })
    }

    /// Type and properties of the damper.
    pub fn kind(&self) -> DamperKind {
        if self.length_ratio == 1.0 {
            return DamperKind::TunedMass {
                mass_kg: self.mass_kg,
                frequency_hz: self.frequency_hz,
                damping_ratio: self.damping_ratio,
            };
        }
        DamperKind::LiquidColumn {
            liquid_mass_kg: self.mass_kg,
            length_ratio: self.length_ratio,
            frequency_hz: self.frequency_hz,
            damping_ratio: self.damping_ratio,
        }
    }
}
