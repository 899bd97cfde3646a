//! Convex polygons in a plane: clipping, area, centroid, second moments.

/// A convex polygon in the plane of a joint, counterclockwise; coordinates in m.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Polygon {
    /// Its corners, m, counterclockwise.
    pub corners_m: Vec<[f64; 2]>,
}

/// Area, centroid and second moments of area about the centroid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PolygonMoments {
    /// Area, m².
    pub area_m2: f64,
    /// Centroid, m.
    pub centroid_m: [f64; 2],
    /// ∫x², ∫y², ∫xy about the centroid, m⁴.
    pub second_m4: [f64; 3],
}

fn cross(a: [f64; 2], b: [f64; 2]) -> f64 {
    a[0] * b[1] - a[1] * b[0]
}

fn minus(a: [f64; 2], b: [f64; 2]) -> [f64; 2] {
    [a[0] - b[0], a[1] - b[1]]
}

impl Polygon {
    /// Convex hull, counterclockwise (Andrew's monotone chain).
    pub(crate) fn hull(mut points: Vec<[f64; 2]>) -> Polygon {
        points.sort_by(|a, b| a[0].total_cmp(&b[0]).then(a[1].total_cmp(&b[1])));
        let mut corners: Vec<[f64; 2]> = Vec::with_capacity(points.len() + 1);
        for pass in 0..2 {
            let start = corners.len();
            for &point in &points {
                while corners.len() >= start + 2 {
                    let (a, b) = (corners[corners.len() - 2], corners[corners.len() - 1]);
                    let turn = (b[0] - a[0]) * (point[1] - a[1]) - (b[1] - a[1]) * (point[0] - a[0]);
                    if turn > 0.0 {
                        break;
                    }
                    corners.pop();
                }
                corners.push(point);
            }
            corners.pop();
            if pass == 0 {
                points.reverse();
            }
        }
        Polygon { corners_m: corners }.cleaned()
    }

    /// Area, centroid and second moments; all zero for fewer than three corners.
    pub fn moments(&self) -> PolygonMoments {
        let corners = &self.corners_m;
        let mut moments = PolygonMoments {
            area_m2: 0.0,
            centroid_m: corners.first().copied().unwrap_or_default(),
            second_m4: [0.0; 3],
        };
        if corners.len() < 3 {
            return moments;
        }
        // triangles from the first corner: of each, ∫x² = A/6 (a² + ab + b²) about that corner
        let origin = corners[0];
        let (mut area, mut first, mut second) = (0.0, [0.0; 2], [0.0; 3]);
        for pair in corners[1..].windows(2) {
            let (a, b) = (minus(pair[0], origin), minus(pair[1], origin));
            let triangle = 0.5 * cross(a, b);
            area += triangle;
            for axis in 0..2 {
                first[axis] += triangle * (a[axis] + b[axis]) / 3.0;
                second[axis] += triangle / 6.0 * (a[axis] * a[axis] + a[axis] * b[axis] + b[axis] * b[axis]);
            }
            second[2] +=
                triangle / 12.0 * (2.0 * a[0] * a[1] + a[0] * b[1] + b[0] * a[1] + 2.0 * b[0] * b[1]);
        }
        if area <= 0.0 {
            return moments;
        }
        let mean = [first[0] / area, first[1] / area];
        moments.area_m2 = area;
        moments.centroid_m = [origin[0] + mean[0], origin[1] + mean[1]];
        moments.second_m4 = [
            second[0] - area * mean[0] * mean[0],
            second[1] - area * mean[1] * mean[1],
            second[2] - area * mean[0] * mean[1],
        ];
        moments
    }

    /// The intersection with `other`; may be empty.
    pub fn clipped(&self, other: &Polygon) -> Polygon {
        let mut corners = self.corners_m.clone();
        let edges = other.corners_m.iter().zip(other.corners_m.iter().cycle().skip(1));
        for (&start, &end) in edges {
            let along = minus(end, start);
            corners = keep_left(&corners, start, along);
        }
        Polygon { corners_m: corners }.cleaned()
    }

    /// The part of this polygon to the left of a line through two points; may be empty.
    pub(super) fn left_of(&self, start: [f64; 2], end: [f64; 2]) -> Polygon {
        let corners_m = keep_left(&self.corners_m, start, minus(end, start));
        Polygon { corners_m }.cleaned()
    }

    /// Removes corners that repeat or are on the line between their neighbours, to 1e-9 of its size.
    pub fn cleaned(self) -> Polygon {
        let size = self.size_m();
        let near = 1e-9 * size; // rounding of coordinates, and no stone is cut finer
        let mut corners: Vec<[f64; 2]> = Vec::with_capacity(self.corners_m.len());
        for corner in self.corners_m {
            let repeats = |other: &[f64; 2]| (corner[0] - other[0]).hypot(corner[1] - other[1]) <= near;
            if !corners.last().is_some_and(repeats) {
                corners.push(corner);
            }
        }
        while corners.len() > 1 {
            let (first, last) = (corners[0], corners[corners.len() - 1]);
            if (first[0] - last[0]).hypot(first[1] - last[1]) > near {
                break;
            }
            corners.pop();
        }
        // one by one: if two corners nearly coincide, each of them is on the line to the other's neighbour
        let mut i = 0;
        while i < corners.len() && corners.len() > 2 {
            let n = corners.len();
            let (before, at, after) = (corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
            let chord = minus(after, before);
            if cross(minus(at, before), chord).abs() <= near * chord[0].hypot(chord[1]) {
                corners.remove(i);
                i = i.saturating_sub(1);
            } else {
                i += 1;
            }
        }
        let corners_m = corners;
        if corners_m.len() < 3 {
            return Polygon::default();
        }
        Polygon { corners_m }
    }

    /// Width, m: the least distance of two parallel lines with the polygon between them; 0 for fewer than three corners.
    pub fn width_m(&self) -> f64 {
        if self.corners_m.len() < 3 {
            return 0.0;
        }
        let edges = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        let widths = edges.map(|(&start, &end)| {
            let along = minus(end, start);
            let from_edge = self
                .corners_m
                .iter()
                .map(|&corner| cross(along, minus(corner, start)));
            from_edge.fold(0.0, f64::max) / along[0].hypot(along[1])
        });
        widths.fold(f64::INFINITY, f64::min)
    }

    /// Largest extent along an axis, m.
    pub fn size_m(&self) -> f64 {
        let extent = |axis: usize| {
            let values = self.corners_m.iter().map(|corner| corner[axis]);
            let (low, high) = values.fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), v| {
                (low.min(v), high.max(v))
            });
            (high - low).max(0.0)
        };
        extent(0).max(extent(1))
    }

    /// Distance from an inner point to the edge along a direction, m; negative if the point is outside and the
    /// edge behind it.
    ///
    /// ```text
    /// min over edges with n·d > 0 of  n·(corner − point) / n·d,   n the outward normal, d the direction (unit)
    /// ```
    pub fn reach_m(&self, point_m: [f64; 2], direction: [f64; 2]) -> f64 {
        let mut reach = f64::INFINITY;
        let edges = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        for (&start, &end) in edges {
            let along = minus(end, start);
            let outward = [along[1], -along[0]];
            let toward = outward[0] * direction[0] + outward[1] * direction[1];
            if toward > 1e-12 * along[0].hypot(along[1]) {
                let from = minus(start, point_m);
                reach = reach.min((outward[0] * from[0] + outward[1] * from[1]) / toward);
            }
        }
        reach
    }

    /// Distance of a point to the nearest edge, m; negative outside.
    pub fn depth_m(&self, point_m: [f64; 2]) -> f64 {
        let mut depth = f64::INFINITY;
        let edges = self.corners_m.iter().zip(self.corners_m.iter().cycle().skip(1));
        for (&start, &end) in edges {
            let along = minus(end, start);
            depth = depth.min(cross(along, minus(point_m, start)) / along[0].hypot(along[1]));
        }
        depth
    }
}

/// The part of a convex polygon to the left of a line.
fn keep_left(corners: &[[f64; 2]], start: [f64; 2], along: [f64; 2]) -> Vec<[f64; 2]> {
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let (side_a, side_b) = (cross(along, minus(a, start)), cross(along, minus(b, start)));
        if side_a >= 0.0 {
            kept.push(a);
        }
        if (side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0) {
            let t = side_a / (side_a - side_b);
            kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn rectangle(low: [f64; 2], high: [f64; 2]) -> Polygon {
        Polygon {
            corners_m: vec![low, [high[0], low[1]], high, [low[0], high[1]]],
        }
    }

    #[test]
    fn exact_moments_of_a_rectangle_and_a_triangle() {
        let m = rectangle([1.0, 2.0], [4.0, 4.0]).moments();
        assert!((m.area_m2 - 6.0).abs() < 1e-14);
        assert!((m.centroid_m[0] - 2.5).abs() < 1e-14 && (m.centroid_m[1] - 3.0).abs() < 1e-14);
        let exact = [2.0 * 27.0 / 12.0, 3.0 * 8.0 / 12.0, 0.0];
        for (computed, exact) in m.second_m4.iter().zip(exact) {
            assert!((computed - exact).abs() < 1e-13);
        }
        // right triangle with legs 1: ∫x² = 1/36, ∫xy = −1/72 about its centroid
        let triangle = Polygon {
            corners_m: vec![[0.0, 0.0], [1.0, 0.0], [0.0, 1.0]],
        };
        let m = triangle.moments();
        assert!((m.second_m4[0] - 1.0 / 36.0).abs() < 1e-15 && (m.second_m4[2] + 1.0 / 72.0).abs() < 1e-15);
    }

    #[test]
    fn exact_clip_of_crossed_rectangles() {
        let cross = rectangle([-3.0, -1.0], [3.0, 1.0]).clipped(&rectangle([-1.0, -3.0], [1.0, 3.0]));
        assert!((cross.moments().area_m2 - 4.0).abs() < 1e-14);
        assert_eq!(cross.corners_m.len(), 4);
        let apart = rectangle([0.0, 0.0], [1.0, 1.0]).clipped(&rectangle([2.0, 0.0], [3.0, 1.0]));
        assert!(apart.corners_m.is_empty());
        let same = rectangle([0.0, 0.0], [1.0, 1.0]);
        assert_eq!(same.clipped(&same).corners_m.len(), 4);
    }

    #[test]
    fn exact_corners_that_nearly_coincide_keep_one() {
        // two corners 3e-9 apart on a unit square: each is on the line to the other's neighbour
        let square = Polygon {
            corners_m: vec![[0.0, 0.0], [1.0, -1.5e-9], [1.0, 1.5e-9], [1.0, 1.0], [0.0, 1.0]],
        };
        let near_corner = square.cleaned();
        assert_eq!(near_corner.corners_m.len(), 4);
        assert!((near_corner.moments().area_m2 - 1.0).abs() < 1e-8);
        let diamond = Polygon {
            corners_m: vec![
                [0.0, -1.0],
                [1.0, -1.5e-9],
                [1.0, 1.5e-9],
                [0.0, 1.0],
                [-1.0, 0.0],
            ],
        };
        assert!((diamond.cleaned().moments().area_m2 - 2.0).abs() < 1e-8);
    }

    #[test]
    fn exact_reach_to_the_edge() {
        let square = rectangle([-1.0, -1.0], [1.0, 1.0]);
        let diagonal = [0.5_f64.sqrt(), 0.5_f64.sqrt()];
        assert!((square.reach_m([0.0, 0.0], diagonal) - 2.0_f64.sqrt()).abs() < 1e-14);
        assert!((square.reach_m([1.12, 0.0], [1.0, 0.0]) + 0.12).abs() < 1e-14);
        assert!((square.depth_m([0.75, 0.0]) - 0.25).abs() < 1e-15);
    }

    #[test]
    fn exact_width_of_a_triangle_and_a_turned_rectangle() {
        // height over the longest edge of 3, 4, 5: 12/5
        let corners_m = vec![[0.0, 0.0], [4.0, 0.0], [0.0, 3.0]];
        assert!((Polygon { corners_m }.width_m() - 2.4).abs() < 1e-15);
        let (sin, cos) = 0.7_f64.sin_cos();
        let turned = |x: f64, y: f64| [cos * x - sin * y, sin * x + cos * y];
        let corners_m = vec![
            turned(0.0, 0.0),
            turned(2.0, 0.0),
            turned(2.0, 1e-5),
            turned(0.0, 1e-5),
        ];
        assert!((Polygon { corners_m }.width_m() - 1e-5).abs() < 1e-15);
        assert!(Polygon::default().width_m() == 0.0);
    }
}
