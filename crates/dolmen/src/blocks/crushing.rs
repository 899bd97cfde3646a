//! Joints whose stone crushes: contact points moved in from the edges, and the load that an edge or a corner bears.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f | `strength_pa` | compressive strength of the joint | Pa |
//! | N₀ | – | normal force in the joint under its own weight | N |
//! | N | `normal_n` | normal force in the joint in motion | N |
//! | r | `at` | position of the resultant of N in the plane of the joint | m |
//! | A(r) | `bearing_area_m2` | area of the bed that is symmetric about r | m² |

use super::contact_points::ContactPoint;
use super::hulls::counterclockwise;
use crate::stability::stack::{beyond, toe};
use crate::structure::stack::Polygon;

/// Largest fraction of a bed in the crushed strip. Our choice: beyond it the contact points would coincide; the ratio of load and strength, which is
/// then near 1 or above, is reported.
const SHARE_MOST: f64 = 0.9;
/// Largest factor on the distance of contact points from the centroid. Our choice: with it, nearly all points lie where they may at most.
const FACTOR_MOST: f64 = 10.0;
/// Halvings of the range of that factor: below rounding.
const HALVINGS: usize = 60;
/// Least part of a convex area that is symmetric about its centroid (Besicovitch 1948).
const SYMMETRIC_LEAST: f64 = 2.0 / 3.0;

/// Strength of a joint in a run; all zero for a joint that does not crush.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Strength {
    /// f, Pa.
    pub(super) strength_pa: f64,
    /// N₀/f, area of the strip that crushes where the stone stands on an edge, m².
    pub(super) strip_m2: f64,
}

impl Strength {
    pub(super) fn crushes(&self) -> bool {
        self.strip_m2 > 0.0
    }
}

/// A normal force and the position of its resultant in the frame of the contact points.
#[derive(Clone, Copy, Debug)]
pub(super) struct Load {
    pub(super) normal_n: f64,
    pub(super) at: [f64; 2],
}

/// A line that contact points do not cross: n · r ≤ d, with n a unit vector.
#[derive(Clone, Copy, Debug)]
struct Line {
    normal: [f64; 2],
    distance: f64,
}

impl Line {
    /// Distance of a point beyond the line; negative inside.
    fn beyond(&self, [x, y]: [f64; 2]) -> f64 {
        self.normal[0] * x + self.normal[1] * y - self.distance
    }
}

/// The bed of a joint that crushes, in the frame of its contact points.
#[derive(Clone, Debug)]
pub(super) struct Bed {
    polygon: Polygon,
    area_m2: f64,
    centroid: [f64; 2],
    edges: Vec<Line>,
}

impl Bed {
    pub(super) fn of(corners_m: Vec<[f64; 2]>) -> Self {
        let polygon = counterclockwise(corners_m);
        let moments = polygon.moments();
        let corners = &polygon.corners_m;
        let sides = corners.iter().zip(corners.iter().cycle().skip(1));
        let edges = sides.filter_map(|(a, b)| {
            let (x, y) = (b[0] - a[0], b[1] - a[1]);
            let length = x.hypot(y);
            let normal = [y / length, -x / length];
            let distance = normal[0] * a[0] + normal[1] * a[1];
            (length > 0.0).then_some(Line { normal, distance })
        });
        Bed {
            edges: edges.collect(),
            area_m2: moments.area_m2,
            centroid: moments.centroid_m,
            polygon,
        }
    }

    /// Contact points of this bed, moved to where the resultant can be if a strip of this area crushes. Their areas stay. All points move away from the
    /// centroid by the factor with which the polar second moment stays too, if there is room: up to a strip of about a fifth of the bed, a closed joint
    /// is as stiff as without crushing.
    ///
    /// ```text
    /// n · r ≤ n · toe(n, N₀/f)         n: the normal of each edge, and the bisectors of the normals at each corner
    /// ```
    pub(super) fn moved_in(&self, mut points: Vec<ContactPoint>, strip_m2: f64) -> Vec<ContactPoint> {
        let lines = self.lines(strip_m2.min(SHARE_MOST * self.area_m2));
        let reached = lines.iter().fold(self.polygon.clone(), |reached, line| {
            let [x, y] = line.normal;
            beyond(&reached, [-x, -y], -line.distance)
        });
        let [c_x, c_y] = self.centroid;
        let moved = |[x, y]: [f64; 2], factor: f64| {
            let at = [c_x + factor * (x - c_x), c_y + factor * (y - c_y)];
            match lines.iter().all(|line| line.beyond(at) <= 0.0) {
                true => at,
                false => nearest(&reached, at),
            }
        };
        let second = |place: &dyn Fn([f64; 2]) -> [f64; 2]| -> f64 {
            let each = points.iter().map(|point| {
                let [x, y] = place(point.place_m);
                point.area_m2 * ((x - c_x).powi(2) + (y - c_y).powi(2))
            });
            each.sum()
        };
        let wanted = second(&|place| place);
        let (mut least, mut most) = (1.0, FACTOR_MOST);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (least + most);
            match second(&|place| moved(place, middle)) < wanted {
                true => least = middle,
                false => most = middle,
            }
        }
        for point in &mut points {
            point.place_m = moved(point.place_m, least);
        }
        points
    }

    /// Lines through the centroids of the strips of this area, across the normals of the edges and their bisectors.
    fn lines(&self, strip_m2: f64) -> Vec<Line> {
        let normals = self.edges.iter().map(|edge| edge.normal);
        let next = normals.clone().cycle().skip(1);
        let all = normals.zip(next).flat_map(|(a, b)| {
            let (x, y) = (a[0] + b[0], a[1] + b[1]);
            let length = x.hypot(y);
            [a, [x / length, y / length]]
        });
        all.filter_map(|normal| {
            let at = toe(std::slice::from_ref(&self.polygon), normal, strip_m2)?;
            let distance = normal[0] * at[0] + normal[1] * at[1];
            distance.is_finite().then_some(Line { normal, distance })
        })
        .collect()
    }

    /// A(r), area of the part of the bed that is symmetric about a point, m²; 0 outside.
    ///
    /// # Limits
    /// It is at most the area that a straight line cuts off with its centroid at this point: equal to it along the axes of a rectangle, at least 8/9
    /// of it elsewhere in a rectangle, and at least 2/3 in any convex bed.
    ///
    /// # Source
    /// Meyerhof, G. G. (1953) Proc. 3rd ICSMFE 1:440-445: the effective area of a footing under an eccentric load.
    pub(super) fn bearing_area_m2(&self, [x, y]: [f64; 2]) -> f64 {
        let about = |corner: &[f64; 2]| [2.0 * x - corner[0], 2.0 * y - corner[1]];
        let opposite = Polygon {
            corners_m: self.polygon.corners_m.iter().map(about).collect(),
        };
        self.polygon.clipped(&opposite).moments().area_m2
    }

    /// A lower bound of A(r) by the nearest edge, m².
    fn bearing_area_least_m2(&self, at: [f64; 2]) -> f64 {
        let toward = self.edges.iter().map(|edge| {
            let way = -edge.beyond(self.centroid);
            1.0 + edge.beyond(at) / way
        });
        let part = 1.0 - toward.fold(0.0, f64::max);
        SYMMETRIC_LEAST * part.max(0.0).powi(2) * self.area_m2
    }

    /// The force f A(r) that the bed bears at a point, N, if a force there exceeds it by more than a ratio.
    pub(super) fn exceeded_n(&self, strength_pa: f64, load: Load, ratio: f64) -> Option<f64> {
        let Load { normal_n, at } = load;
        let exceeds = |area_m2: &f64| normal_n > ratio * strength_pa * area_m2;
        Some(self.bearing_area_least_m2(at)).filter(exceeds)?;
        let area_m2 = Some(self.bearing_area_m2(at)).filter(exceeds)?;
        Some(strength_pa * area_m2)
    }
}

/// The point of the outline of a polygon that is nearest to a point.
fn nearest(polygon: &Polygon, [x, y]: [f64; 2]) -> [f64; 2] {
    let corners = &polygon.corners_m;
    let sides = corners.iter().zip(corners.iter().cycle().skip(1));
    let each = sides.map(|(a, b)| {
        let (along_x, along_y) = (b[0] - a[0], b[1] - a[1]);
        let square = (along_x * along_x + along_y * along_y).max(f64::MIN_POSITIVE);
        let part = ((x - a[0]) * along_x + (y - a[1]) * along_y) / square;
        let part = part.clamp(0.0, 1.0);
        [a[0] + part * along_x, a[1] + part * along_y]
    });
    let distance = |place: &[f64; 2]| (place[0] - x).hypot(place[1] - y);
    each.min_by(|a, b| distance(a).total_cmp(&distance(b)))
        .unwrap_or([x, y])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{ContactRule, contact_points};
    use crate::stability::BedEdge;

    fn rectangle(b: f64, l: f64) -> Vec<[f64; 2]> {
        vec![[-b, -l], [b, -l], [b, l], [-b, l]]
            .into_iter()
            .map(|[x, y]| [0.5 * x, 0.5 * y])
            .collect()
    }

    #[test]
    fn exact_the_outermost_points_lie_on_the_middle_of_the_crushed_strips() {
        let (b, l) = (0.6, 0.9);
        for share in [0.02, 0.1, 0.25, 0.5, 0.8] {
            let bed = Bed::of(rectangle(b, l));
            let moved = bed.moved_in(contact_points(&bed.polygon, ContactRule::Four), share * b * l);
            let most = |axis: usize| moved.iter().map(|p| p.place_m[axis]).fold(0.0, f64::max);
            assert!(
                (most(0) - 0.5 * b * (1.0 - share)).abs() < 1e-12,
                "{share}: {}",
                most(0)
            );
            assert!(
                (most(1) - 0.5 * l * (1.0 - share)).abs() < 1e-12,
                "{share}: {}",
                most(1)
            );
            // towards the corner of a square, as far as a stress block reaches
            let square = Bed::of(rectangle(1.0, 1.0));
            let moved = square.moved_in(contact_points(&square.polygon, ContactRule::Four), share);
            let diagonal = |p: &ContactPoint| (p.place_m[0] + p.place_m[1]) * 0.5_f64.sqrt();
            let most = moved.iter().map(diagonal).fold(0.0, f64::max);
            let edge = BedEdge {
                width_m: 1.0,
                depth_m: Some(1.0),
                strength_pa: Some(1.0 / share),
            };
            let exact = edge.moment_towards_n_m(1.0, [1.0, 1.0]);
            assert!((most - exact).abs() < 1e-9, "{share}: {most} {exact}");
        }
    }

    #[test]
    fn holds_area_and_stiffness_of_the_bed_stay_while_points_move_in() {
        let hexagon = (0..6).map(|i| f64::from(i) * std::f64::consts::FRAC_PI_3);
        let hexagon: Vec<[f64; 2]> = hexagon.map(|a| [0.4 * a.cos(), 0.4 * a.sin()]).collect();
        for (corners, share) in [
            (rectangle(0.6, 0.9), 0.1),
            (rectangle(0.6, 0.9), 0.18),
            (hexagon, 0.12),
        ] {
            let bed = Bed::of(corners);
            let points = contact_points(&bed.polygon, ContactRule::Four);
            let sum = |points: &[ContactPoint], of: fn([f64; 2]) -> f64| -> f64 {
                points.iter().map(|p| p.area_m2 * of(p.place_m)).sum()
            };
            let moved = bed.moved_in(points.clone(), share * bed.area_m2);
            assert_ne!(moved, points);
            let lines = bed.lines(share * bed.area_m2);
            assert!(
                moved
                    .iter()
                    .all(|p| lines.iter().all(|line| line.beyond(p.place_m) < 1e-12))
            );
            for of in [
                |_| 1.0,
                |r: [f64; 2]| r[0],
                |r: [f64; 2]| r[1],
                |r: [f64; 2]| r[0] * r[0] + r[1] * r[1],
            ] {
                let (now, then) = (sum(&moved, of), sum(&points, of));
                assert!((now - then).abs() < 1e-12, "{share}: {now} {then}");
            }
        }
    }

    #[test]
    fn exact_bearing_area_of_a_rectangle_and_its_bounds() {
        let (b, l) = (0.6, 0.9);
        let bed = Bed::of(rectangle(b, l));
        for (x, y) in [(0.0, 0.0), (0.2, 0.0), (0.0, -0.4), (-0.27, 0.4), (0.1, 0.1)] {
            let area = bed.bearing_area_m2([x, y]);
            let exact = (b - 2.0 * f64::abs(x)) * (l - 2.0 * f64::abs(y));
            assert!((area - exact).abs() < 1e-12, "{area} {exact}");
            assert!(bed.bearing_area_least_m2([x, y]) <= area);
            // by a stress block of that area the resultant can be at least as far out
            let edge = BedEdge {
                width_m: b,
                depth_m: Some(l),
                strength_pa: Some(1.0),
            };
            let reach = |area: f64| edge.moment_towards_n_m(area, [x, y]) / area;
            if x != 0.0 || y != 0.0 {
                let wanted = x.hypot(y);
                assert!(reach(area) >= wanted - 1e-12, "{x} {y}");
                assert!(reach(area * 9.0 / 8.0) <= wanted + 1e-9, "{x} {y}");
            }
        }
        // a triangle about its centroid: two thirds
        let triangle = Bed::of(vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]]);
        let third = [1.0 / 3.0; 2];
        assert!((triangle.bearing_area_m2(third) - 1.0 / 3.0).abs() < 1e-12);
        assert!((triangle.bearing_area_least_m2(third) - 1.0 / 3.0).abs() < 1e-12);
        assert_eq!(bed.bearing_area_m2([0.31, 0.0]), 0.0);
    }
}
