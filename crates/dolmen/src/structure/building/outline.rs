//! The outline of a floor: a simple polygon, convex or not.

use super::error::BuildingError;

/// Points within this fraction of the floor size from an edge are on the floor, because coordinates are rounded. Our choice.
const EDGE: f64 = 1e-9;

/// The outline of a floor in plan: a polygon without crossings, counterclockwise. Construction checks it.
///
/// ```
/// use dolmen::structure::building::Outline;
/// let floor = Outline::new(vec![[-5.0, -4.0], [5.0, -4.0], [5.0, 4.0], [-5.0, 4.0]])?;
/// assert_eq!(floor.area_m2(), 80.0);
/// assert!((floor.gyration_m().powi(2) - 164.0 / 12.0).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::building::BuildingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Outline {
    corners_m: Vec<[f64; 2]>,
    area_m2: f64,
    centroid_m: [f64; 2],
    gyration_m: f64,
}

impl Outline {
    /// An outline from its corners in order, clockwise or counterclockwise.
    ///
    /// # Errors
    /// [`BuildingError::Outline`] for fewer than 3 corners, a corner that is not a number or repeats, crossing edges, or no
    /// area.
    pub fn new(mut corners_m: Vec<[f64; 2]>) -> Result<Self, BuildingError> {
        let refuse = |why: String| Err(BuildingError::Outline { why });
        let n = corners_m.len();
        if n < 3 {
            return refuse(format!("has {n} corners, but a floor has at least 3"));
        }
        if let Some(i) = corners_m
            .iter()
            .position(|c| !(c[0].is_finite() && c[1].is_finite()))
        {
            return refuse(format!("has a corner {} that is not a number", i + 1));
        }
        let size = size_m(&corners_m);
        for i in 0..n {
            let (a, b) = (corners_m[i], corners_m[(i + 1) % n]);
            if (b[0] - a[0]).hypot(b[1] - a[1]) <= EDGE * size {
                return refuse(format!(
                    "has corners {} and {} in one place",
                    i + 1,
                    (i + 1) % n + 1
                ));
            }
        }
        for i in 0..n {
            for j in i + 1..n {
                let neighbours = j == i + 1 || (i == 0 && j == n - 1);
                let first = [corners_m[i], corners_m[(i + 1) % n]];
                let second = [corners_m[j], corners_m[(j + 1) % n]];
                let crossing = if neighbours {
                    folds_back(first, second)
                } else {
                    meet(first, second)
                };
                if crossing {
                    return refuse(format!("crosses itself: sides {} and {} meet", i + 1, j + 1));
                }
            }
        }
        let mut moments = moments(&corners_m);
        if moments.area_m2 < 0.0 {
            corners_m.reverse();
            moments = self::moments(&corners_m);
        }
        if moments.area_m2 <= EDGE * size * size {
            return refuse(format!("encloses no area ({} m²)", moments.area_m2));
        }
        Ok(Outline {
            corners_m,
            area_m2: moments.area_m2,
            centroid_m: moments.centroid_m,
            gyration_m: (moments.polar_m4 / moments.area_m2).sqrt(),
        })
    }

    /// A rectangle with sides along x and y.
    ///
    /// # Errors
    /// [`BuildingError::Outline`] unless both lengths are positive.
    pub fn rectangle(centre_m: [f64; 2], length_x_m: f64, length_y_m: f64) -> Result<Self, BuildingError> {
        let (x, y) = (0.5 * length_x_m, 0.5 * length_y_m);
        let corners = [[-x, -y], [x, -y], [x, y], [-x, y]];
        Outline::new(corners.map(|c| [c[0] + centre_m[0], c[1] + centre_m[1]]).to_vec())
    }

    /// The corners, counterclockwise, m.
    pub fn corners_m(&self) -> &[[f64; 2]] {
        &self.corners_m
    }

    /// Area, m².
    pub fn area_m2(&self) -> f64 {
        self.area_m2
    }

    /// Centroid, m: the centre of mass of a uniform floor.
    pub fn centroid_m(&self) -> [f64; 2] {
        self.centroid_m
    }

    /// Radius of gyration of a uniform floor about the centroid, m: √((I_x + I_y)/A).
    pub fn gyration_m(&self) -> f64 {
        self.gyration_m
    }

    /// Distance of a point from the floor, m; 0 on the floor and its edge.
    pub fn beyond_m(&self, point_m: [f64; 2]) -> f64 {
        let (_, beyond_m) = nearest_on_floor(&self.corners_m, point_m);
        if beyond_m <= EDGE * size_m(&self.corners_m) {
            0.0
        } else {
            beyond_m
        }
    }
}

/// The nearest point of a polygon and its distance; a point inside is its own nearest point.
pub(crate) fn nearest_on_floor(corners: &[[f64; 2]], [x, y]: [f64; 2]) -> ([f64; 2], f64) {
    let mut inside = false;
    let mut nearest = ([x, y], f64::INFINITY);
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        if (a[1] > y) != (b[1] > y) && x < a[0] + (y - a[1]) / (b[1] - a[1]) * (b[0] - a[0]) {
            inside = !inside;
        }
        let point = nearest_on_side(a, b, [x, y]);
        let far = (x - point[0]).hypot(y - point[1]);
        if far < nearest.1 {
            nearest = (point, far);
        }
    }
    if inside { ([x, y], 0.0) } else { nearest }
}

/// The nearest point of the side from a to b.
pub(crate) fn nearest_on_side(a: [f64; 2], b: [f64; 2], [x, y]: [f64; 2]) -> [f64; 2] {
    let along = [b[0] - a[0], b[1] - a[1]];
    let squared = along[0] * along[0] + along[1] * along[1];
    let t = (((x - a[0]) * along[0] + (y - a[1]) * along[1]) / squared).clamp(0.0, 1.0);
    [a[0] + t * along[0], a[1] + t * along[1]]
}

fn size_m(corners: &[[f64; 2]]) -> f64 {
    let extent = |axis: usize| {
        let values = corners.iter().map(|corner| corner[axis]);
        let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| {
            (l.min(v), h.max(v))
        });
        high - low
    };
    extent(0).max(extent(1))
}

/// Area, centroid and polar second moment about the centroid.
struct Moments {
    area_m2: f64,
    centroid_m: [f64; 2],
    polar_m4: f64,
}

/// Sums triangles from the first corner; the area is negative for a clockwise order.
fn moments(corners: &[[f64; 2]]) -> Moments {
    let origin = corners[0];
    let (mut area, mut first, mut polar) = (0.0, [0.0; 2], 0.0);
    for pair in corners[1..].windows(2) {
        let [a, b] = [pair[0], pair[1]].map(|c| [c[0] - origin[0], c[1] - origin[1]]);
        let triangle = 0.5 * (a[0] * b[1] - a[1] * b[0]);
        area += triangle;
        for axis in 0..2 {
            first[axis] += triangle * (a[axis] + b[axis]) / 3.0;
            polar += triangle / 6.0 * (a[axis] * a[axis] + a[axis] * b[axis] + b[axis] * b[axis]);
        }
    }
    let mean = first.map(|moment| moment / area);
    Moments {
        area_m2: area,
        centroid_m: [origin[0] + mean[0], origin[1] + mean[1]],
        polar_m4: polar - area * (mean[0] * mean[0] + mean[1] * mean[1]),
    }
}

fn turn(a: [f64; 2], b: [f64; 2], c: [f64; 2]) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}

/// Whether two segments share a point.
fn meet([a, b]: [[f64; 2]; 2], [c, d]: [[f64; 2]; 2]) -> bool {
    let apart = |axis: usize| {
        a[axis].max(b[axis]) < c[axis].min(d[axis]) || c[axis].max(d[axis]) < a[axis].min(b[axis])
    };
    !apart(0) && !apart(1) && turn(a, b, c) * turn(a, b, d) <= 0.0 && turn(c, d, a) * turn(c, d, b) <= 0.0
}

/// Whether two sides that share a corner overlap.
fn folds_back(first: [[f64; 2]; 2], second: [[f64; 2]; 2]) -> bool {
    let (shared, a, b) = if first[1] == second[0] {
        (first[1], first[0], second[1])
    } else {
        (first[0], first[1], second[0])
    };
    let along = (a[0] - shared[0]) * (b[0] - shared[0]) + (a[1] - shared[1]) * (b[1] - shared[1]);
    turn(shared, a, b) == 0.0 && along > 0.0
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_moments_of_an_l_shape() {
        // 4 × 4 without its upper right 2 × 2, piece by piece
        let corners = vec![
            [0.0, 0.0],
            [4.0, 0.0],
            [4.0, 2.0],
            [2.0, 2.0],
            [2.0, 4.0],
            [0.0, 4.0],
        ];
        let l = Outline::new(corners.clone()).unwrap();
        assert!((l.area_m2() - 12.0).abs() < 1e-13);
        let centre = (16.0 * 2.0 - 4.0 * 3.0) / 12.0;
        assert!((l.centroid_m()[0] - centre).abs() < 1e-13 && (l.centroid_m()[1] - centre).abs() < 1e-13);
        // about the origin: 2·4·4³/3 − 2·(2·(4³ − 2³)/3)
        let polar = 2.0 * 4.0 * 64.0 / 3.0 - 2.0 * 2.0 * (64.0 - 8.0) / 3.0;
        let gyration_squared = polar / 12.0 - 2.0 * centre * centre;
        assert!((l.gyration_m().powi(2) - gyration_squared).abs() < 1e-12);
        assert_eq!(l.beyond_m([1.0, 3.0]), 0.0);
        assert!((l.beyond_m([3.0, 3.0]) - 1.0).abs() < 1e-14);
        assert_eq!(l.beyond_m([3.0, 2.0]), 0.0, "the edge is on the floor");
        let reversed = Outline::new(corners.into_iter().rev().collect()).unwrap();
        assert!((reversed.gyration_m() - l.gyration_m()).abs() < 1e-13);
    }

    #[test]
    fn refuses_outlines_that_are_no_floor() {
        let why = |corners: &[[f64; 2]]| Outline::new(corners.to_vec()).unwrap_err().to_string();
        assert!(why(&[[0.0, 0.0], [1.0, 0.0]]).contains("2 corners"));
        let bow = [[0.0, 0.0], [1.0, 1.0], [1.0, 0.0], [0.0, 1.0]];
        assert_eq!(
            why(&bow),
            "the outline crosses itself: sides 1 and 3 meet: give its corners in order, each once"
        );
        assert!(
            why(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).contains("crosses itself")
                || why(&[[0.0, 0.0], [1.0, 0.0], [2.0, 0.0]]).contains("no area")
        );
        assert!(why(&[[0.0, 0.0], [1.0, 0.0], [1.0, 0.0], [0.0, 1.0]]).contains("in one place"));
        assert!(why(&[[0.0, 0.0], [f64::NAN, 0.0], [1.0, 1.0]]).contains("corner 2 that is not a number"));
        assert!(Outline::rectangle([0.0, 0.0], 3.0, 0.0).is_err());
    }
}
