//! Points of a flat joint at which pressure and friction act: Gauss–Lobatto points, which include the corners.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ξ_i, w_i | `lobatto` | points and weights on −1…1, Σw = 2 | – |
//! | x_ij | `place_m` | point in the plane of the joint | m |
//! | A_ij | `area_m2` | tributary area of the point | m² |

use crate::structure::stack::Polygon;

/// Rule for the contact points of a joint: n × n points on a quadrilateral.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ContactRule {
    /// 2 × 2: corners only, for comparison. Fast, but the rotational stiffness of a joint is three times too large,
    /// and the torsional resistance 1.85 times.
    Corners,
    /// 3 × 3: rotational stiffness exact.
    Three,
    /// 4 × 4: rotational stiffness exact, torsional resistance within 3 %. The default.
    Four,
    /// 6 × 6: torsional resistance within 1 %.
    Six,
}

/// One point of a joint.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ContactPoint {
    /// Place in the plane of the joint, m.
    pub place_m: [f64; 2],
    /// Tributary area of the point, m².
    pub area_m2: f64,
}

/// Gauss–Lobatto points and weights on −1…1.
///
/// # Source
/// Abramowitz & Stegun (1964), 25.4.32 and table 25.6: the ends and the zeros of P′_{n−1}.
fn lobatto(rule: ContactRule) -> Vec<(f64, f64)> {
    let half: Vec<(f64, f64)> = match rule {
        ContactRule::Corners => vec![(1.0, 1.0)],
        ContactRule::Three => vec![(0.0, 4.0 / 3.0), (1.0, 1.0 / 3.0)],
        ContactRule::Four => vec![(0.2_f64.sqrt(), 5.0 / 6.0), (1.0, 1.0 / 6.0)],
        ContactRule::Six => {
            let (root, seven) = (7.0_f64.sqrt(), 2.0 * 7.0_f64.sqrt());
            vec![
                (((7.0 - seven) / 21.0).sqrt(), (14.0 + root) / 30.0),
                (((7.0 + seven) / 21.0).sqrt(), (14.0 - root) / 30.0),
                (1.0, 1.0 / 15.0),
            ]
        }
    };
    let mirrored = half.iter().rev().filter(|(x, _)| *x > 0.0).map(|(x, w)| (-x, *w));
    mirrored.chain(half.iter().copied()).collect()
}

/// Contact points of a convex patch.
///
/// ```text
/// quadrilateral:  A_ij = w_i w_j det J(ξ_i, ξ_j),   J of the bilinear map from −1…1 squared
/// other polygons: divided at the centroid into one quadrilateral per corner, between the midpoints of its two edges
/// ```
///
/// Area, first and second moments are exact from 3 × 3 on, and every corner is a point. Common points of
/// quadrilaterals are merged. Empty for a patch without area.
pub fn contact_points(patch: &Polygon, rule: ContactRule) -> Vec<ContactPoint> {
    let corners = &patch.corners_m;
    let moments = patch.moments();
    if moments.area_m2 <= 0.0 {
        return Vec::new();
    }
    let mut points = Vec::new();
    if let [a, b, c, d] = corners[..] {
        spread([a, b, c, d], rule, &mut points);
        return points;
    }
    let n = corners.len();
    let middle = |a: [f64; 2], b: [f64; 2]| [0.5 * (a[0] + b[0]), 0.5 * (a[1] + b[1])];
    for i in 0..n {
        let (before, at, after) = (corners[(i + n - 1) % n], corners[i], corners[(i + 1) % n]);
        let part = [moments.centroid_m, middle(before, at), at, middle(at, after)];
        spread(part, rule, &mut points);
    }
    merged(points, 1e-9 * patch.size_m())
}

/// Adds the points of one quadrilateral, corners counterclockwise.
fn spread(corners: [[f64; 2]; 4], rule: ContactRule, points: &mut Vec<ContactPoint>) {
    let line = lobatto(rule);
    for &(xi, weight_xi) in &line {
        for &(eta, weight_eta) in &line {
            let shape = [
                0.25 * (1.0 - xi) * (1.0 - eta),
                0.25 * (1.0 + xi) * (1.0 - eta),
                0.25 * (1.0 + xi) * (1.0 + eta),
                0.25 * (1.0 - xi) * (1.0 + eta),
            ];
            let slope_xi = [
                -0.25 * (1.0 - eta),
                0.25 * (1.0 - eta),
                0.25 * (1.0 + eta),
                -0.25 * (1.0 + eta),
            ];
            let slope_eta = [
                -0.25 * (1.0 - xi),
                -0.25 * (1.0 + xi),
                0.25 * (1.0 + xi),
                0.25 * (1.0 - xi),
            ];
            let sum = |weights: [f64; 4], axis: usize| -> f64 {
                weights
                    .iter()
                    .zip(&corners)
                    .map(|(w, corner)| w * corner[axis])
                    .sum()
            };
            let jacobian = sum(slope_xi, 0) * sum(slope_eta, 1) - sum(slope_xi, 1) * sum(slope_eta, 0);
            points.push(ContactPoint {
                place_m: [sum(shape, 0), sum(shape, 1)],
                area_m2: weight_xi * weight_eta * jacobian,
            });
        }
    }
}

/// Merges points closer than `near` and adds their areas.
fn merged(points: Vec<ContactPoint>, near: f64) -> Vec<ContactPoint> {
    let mut kept: Vec<ContactPoint> = Vec::with_capacity(points.len());
    for point in points {
        let same = kept.iter_mut().find(|other| {
            (other.place_m[0] - point.place_m[0]).hypot(other.place_m[1] - point.place_m[1]) <= near
        });
        match same {
            Some(other) => other.area_m2 += point.area_m2,
            None => kept.push(point),
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    fn moments(points: &[ContactPoint]) -> [f64; 6] {
        let mut sums = [0.0; 6];
        for ContactPoint {
            place_m: [x, y],
            area_m2,
        } in points
        {
            for (sum, term) in sums.iter_mut().zip([1.0, *x, *y, x * x, y * y, x * y]) {
                *sum += area_m2 * term;
            }
        }
        sums
    }

    #[test]
    fn exact_area_and_moments_of_any_convex_patch() {
        let patches = [
            vec![[-1.0, -0.5], [1.0, -0.5], [1.0, 0.5], [-1.0, 0.5]],
            vec![[0.0, 0.0], [2.0, 0.1], [1.7, 1.3], [0.2, 0.9]],
            vec![[0.0, 0.0], [1.0, 0.0], [0.3, 0.8]],
            vec![[0.0, 0.0], [1.0, -0.2], [1.6, 0.5], [0.9, 1.4], [-0.3, 0.8]],
        ];
        for corners_m in patches {
            let patch = Polygon { corners_m };
            let exact = patch.moments();
            let [x, y] = exact.centroid_m;
            let a = exact.area_m2;
            let expected = [
                a,
                a * x,
                a * y,
                exact.second_m4[0] + a * x * x,
                exact.second_m4[1] + a * y * y,
                exact.second_m4[2] + a * x * y,
            ];
            for rule in [ContactRule::Three, ContactRule::Four, ContactRule::Six] {
                let points = contact_points(&patch, rule);
                for (sum, exact) in moments(&points).iter().zip(expected) {
                    assert!((sum - exact).abs() < 1e-13, "{rule:?}: {sum} against {exact}");
                }
                for corner in &patch.corners_m {
                    assert!(
                        points.iter().any(|p| p.place_m == *corner),
                        "{corner:?} is no point"
                    );
                }
                assert!(points.iter().all(|p| p.area_m2 > 0.0));
            }
        }
    }

    #[test]
    fn exact_corners_alone_are_three_times_too_stiff() {
        let corners_m = vec![[-0.5, -0.5], [0.5, -0.5], [0.5, 0.5], [-0.5, 0.5]];
        let patch = Polygon { corners_m };
        let second = moments(&contact_points(&patch, ContactRule::Corners))[3];
        assert!((second - 3.0 / 12.0).abs() < 1e-15);
    }
}
