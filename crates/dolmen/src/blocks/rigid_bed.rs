//! Distribution of a normal force over the points of a face, as on a uniform bed without tension.

use super::rigid_point::{ForceTorque, Part, Point};

/// Newton steps for the pressure of a bed.
const BED_STEPS: usize = 30;

/// Pressure of a bed at a point, never below 0.
#[inline]
pub(super) fn on_bed(bed: &[f64; 3], point: &Point) -> f64 {
    (bed[0] + bed[1] * point.y - bed[2] * point.x).max(0.0)
}

/// Pressure of a uniform elastic bed without tension at the near points, under a normal force and two moments. Returns false
/// if there is none, because the force is outside the points. Starts from `bed`; `near` is the relative tolerance of the
/// force balance.
///
/// ```text
/// Σ a max(c · e, 0) e = (N, M_x, M_y),   e = (1, y, −x),   by Newton steps over the points with pressure
/// ```
pub(super) fn fit_bed(points: &[Point], wrench: &ForceTorque, bed: &mut [f64; 3], near: f64) -> bool {
    let wanted = [wrench[2], wrench[3], wrench[4]];
    if wanted[0] <= 0.0 {
        return false;
    }
    let size = points
        .iter()
        .fold(0.0_f64, |most, p| most.max(p.x.abs()).max(p.y.abs()));
    let mut first = bed.iter().all(|value| *value == 0.0);
    for _ in 0..BED_STEPS {
        let mut k = [0.0; 6];
        let mut left = wanted;
        for point in points.iter().filter(|point| point.part == Part::Near) {
            let pressure = bed[0] + bed[1] * point.y - bed[2] * point.x;
            if pressure > 0.0 || first {
                let (a, x, y) = (point.area, point.x, point.y);
                let p = a * pressure;
                left[0] -= p;
                left[1] -= y * p;
                left[2] += x * p;
                k[0] += a;
                k[1] += a * y;
                k[2] -= a * x;
                k[3] += a * y * y;
                k[4] -= a * x * y;
                k[5] += a * x * x;
            }
        }
        first = false;
        let off = left[0].abs().max(left[1].abs().max(left[2].abs()) / size);
        if off < near * wanted[0] {
            return true;
        }
        let Some(step) = solve_3(&k, &left) else {
            *bed = [0.0; 3];
            return false;
        };
        for (bed, step) in bed.iter_mut().zip(step) {
            *bed += step;
        }
    }
    *bed = [0.0; 3];
    false
}

/// Solves a symmetric 3 × 3 system (00, 01, 02, 11, 12, 22). It is singular if the points lie on a line or coincide; the
/// undetermined component is then 0.
fn solve_3(k: &[f64; 6], right: &[f64; 3]) -> Option<[f64; 3]> {
    if k[0] <= 0.0 {
        return None;
    }
    const RANK: f64 = 1e-12;
    let (a, b) = (k[1] / k[0], k[2] / k[0]);
    let (c, d, e) = (k[3] - a * k[1], k[4] - a * k[2], k[5] - b * k[2]);
    let (r_1, r_2) = (right[1] - a * right[0], right[2] - b * right[0]);
    let scale = k[3].max(k[5]);
    let (y, z) = if c.max(e) <= RANK * scale {
        (0.0, 0.0)
    } else if c >= e {
        let ratio = d / c;
        let rest = e - ratio * d;
        let z = if rest > RANK * scale {
            (r_2 - ratio * r_1) / rest
        } else {
            0.0
        };
        ((r_1 - d * z) / c, z)
    } else {
        let ratio = d / e;
        let rest = c - ratio * d;
        let y = if rest > RANK * scale {
            (r_1 - ratio * r_2) / rest
        } else {
            0.0
        };
        (y, (r_2 - d * y) / e)
    };
    Some([(right[0] - k[1] * y - k[2] * z) / k[0], y, z])
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::blocks::{ContactRule, contact_points};
    use crate::structure::stack::Polygon;

    /// Points of a face of 2 × 2 m relative to its centre.
    fn points() -> Vec<Point> {
        let corners_m = vec![[-1.0, -1.0], [1.0, -1.0], [1.0, 1.0], [-1.0, 1.0]];
        let points = contact_points(&Polygon { corners_m }, ContactRule::Four);
        let near = |point: &crate::blocks::ContactPoint| Point {
            part: Part::Near,
            ..Point::at(point.place_m, point.area_m2)
        };
        points.iter().map(near).collect()
    }

    #[test]
    fn exact_pressure_of_a_force_within_the_kernel() {
        // N at (e, 0): p = N/A (1 + 3 e x) on a square of side 2
        let mut bed = [0.0; 3];
        assert!(fit_bed(
            &points(),
            &[0.0, 0.0, 8.0, 0.0, -8.0 * 0.2, 0.0],
            &mut bed,
            1e-12
        ));
        for point in points() {
            let exact = 2.0 * (1.0 + 0.6 * point.x);
            assert!((on_bed(&bed, &point) - exact).abs() < 1e-12, "{bed:?}");
        }
    }

    #[test]
    fn exact_balance_where_part_of_the_face_opens() {
        for (x, y) in [(0.6, 0.0), (0.9, 0.5), (-0.99, 0.99), (1.0, 0.0)] {
            let mut bed = [0.0; 3];
            let wrench = [0.0, 0.0, 5.0, 5.0 * y, -5.0 * x, 0.0];
            assert!(fit_bed(&points(), &wrench, &mut bed, 1e-9), "{x} {y}");
            let mut sums = [0.0; 3];
            for point in points() {
                let p = point.area * on_bed(&bed, &point);
                for (sum, arm) in sums.iter_mut().zip([1.0, point.x, point.y]) {
                    *sum += p * arm;
                }
            }
            for (sum, exact) in sums.iter().zip([5.0, 5.0 * x, 5.0 * y]) {
                assert!((sum - exact).abs() < 1e-8, "{sums:?} at {x} {y}");
            }
        }
        let mut bed = [0.0; 3];
        assert!(!fit_bed(
            &points(),
            &[0.0, 0.0, 5.0, 0.0, -5.01, 0.0],
            &mut bed,
            1e-9
        ));
    }
}
