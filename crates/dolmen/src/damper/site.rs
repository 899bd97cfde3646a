//! Where mass dampers may stand: the floors of a building in plan.

use super::{AttachedDamper, DamperError, DamperKind};

/// A rigid floor on which dampers may stand.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperSite {
    /// The structure's degree of freedom that is u of the floor's reference point; v and θ follow it.
    pub first_degree_of_freedom: usize,
    /// Reference point in plan, m.
    pub reference_m: [f64; 2],
    /// Corners of the floor, m, in order round it; dampers stand inside.
    pub corners_m: Vec<[f64; 2]>,
}

/// A mass damper on a floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlacedDamper {
    /// Which site, from 0.
    pub site: usize,
    /// x and y in plan, m.
    pub place_m: [f64; 2],
    /// Direction in which it moves, from x counter-clockwise, degrees.
    pub direction_degrees: f64,
    /// m, kg.
    pub mass_kg: f64,
    /// Own frequency, Hz.
    pub frequency_hz: f64,
    /// c / (2 m ω) on its own frequency.
    pub damping_ratio: f64,
}

impl DamperSite {
    /// cos α (u − (y − y_r) θ) + sin α (v + (x − x_r) θ): how much of u, v, θ a place moves along a direction.
    pub fn coefficients(&self, place_m: [f64; 2], direction_degrees: f64) -> [f64; 3] {
        let [cos, sin] = unit(direction_degrees);
        let [x, y] = [0, 1].map(|i| place_m[i] - self.reference_m[i]);
        [cos, sin, sin * x - cos * y]
    }

    /// Box around the floor: least and greatest x, least and greatest y, m.
    pub fn extent_m(&self) -> [[f64; 2]; 2] {
        [0, 1].map(|axis| {
            let values = self.corners_m.iter().map(|corner| corner[axis]);
            values.fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], v| {
                [low.min(v), high.max(v)]
            })
        })
    }

    /// The nearest point of the floor, and how far away it is, m; the point itself and 0 inside.
    pub fn nearest_m(&self, place_m: [f64; 2]) -> ([f64; 2], f64) {
        let [x, y] = place_m;
        let mut inside = false;
        let mut nearest = (place_m, f64::INFINITY);
        let sides = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        for (&a, &b) in sides {
            if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
                inside = !inside;
            }
            let along = [b[0] - a[0], b[1] - a[1]];
            let squared = along[0] * along[0] + along[1] * along[1];
            let t = (((x - a[0]) * along[0] + (y - a[1]) * along[1]) / squared).clamp(0.0, 1.0);
            let point = [a[0] + t * along[0], a[1] + t * along[1]];
            let far = (x - point[0]).hypot(y - point[1]);
            if far < nearest.1 {
                nearest = (point, far);
            }
        }
        if inside { (place_m, 0.0) } else { nearest }
    }

    /// How far the edge is, m, from within or without.
    pub(super) fn to_edge_m(&self, [x, y]: [f64; 2]) -> f64 {
        let sides = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        let each = sides.map(|(a, b)| {
            let along = [b[0] - a[0], b[1] - a[1]];
            let squared = along[0] * along[0] + along[1] * along[1];
            let t = (((x - a[0]) * along[0] + (y - a[1]) * along[1]) / squared).clamp(0.0, 1.0);
            (x - a[0] - t * along[0]).hypot(y - a[1] - t * along[1])
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
    /// As a damper on a row of the whole structure.
    ///
    /// # Errors
    /// [`DamperError::OutsideFloor`] if it stands beyond the edge of its floor; [`DamperError::Argument`] for a site that is not there.
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
            kind: DamperKind::TunedMass {
                mass_kg: self.mass_kg,
                frequency_hz: self.frequency_hz,
                damping_ratio: self.damping_ratio,
            },
            row,
        })
    }
}
