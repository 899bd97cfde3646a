//! Support of a stone in plan: distance of the vertical through its centroid from the edge of the support.

use super::assembly::Assembly;
use super::patch::LANES;
use glam::{DVec2, DVec3};

/// Least upward component of a joint's normal, as cosine, for a support; a face that leans against a stone is no support. Our choice.
const CARRIES: f64 = 0.5;
/// Sine of the slope of a bed above which a stone on it also leans on others. Our choice: a friction angle of 20°, below that of dressed stone.
const LEANS: f64 = 0.342;
/// Sine of the slope of a bed, and of the angle between the faces of a stone, above which the stone is a wedge with lateral thrust. Our choice:
/// stones of a leaning tower, and of scans, have less.
const WEDGE: [f64; 2] = [0.139, 0.052];

/// Distance, in plan, from the centroid of a body to the edge of the convex hull of its support, m: negative outside; `None` if it has no support.
pub(super) fn plumb_margin(assembly: &Assembly, body: usize) -> Option<f64> {
    let mut points = Vec::new();
    for patch in assembly.patches() {
        let motion = patch.motion(&assembly.bodies);
        // the normal points out of P
        let up = motion.to_ground.z_axis.z;
        let carried =
            (patch.point_body == body && up > CARRIES) || (patch.plane_body == body && up < -CARRIES);
        if !carried {
            continue;
        }
        for group in &patch.points {
            for lane in (0..LANES).filter(|&lane| group.area[lane] > 0.0) {
                let place = motion.origin + motion.to_ground * motion.at(group.x[lane], group.y[lane]);
                points.push(place.truncate());
            }
        }
    }
    let centroid = assembly.bodies[body].position.truncate();
    (!points.is_empty()).then(|| margin(&hull(points), centroid))
}

/// For each body, the ground first, whether the position of its centroid over the support shows how close it is to tipping. It does not for the
/// stones of an arch and those that carry them, because thrust supports them.
pub(super) fn plumb_decides(assembly: &Assembly) -> Vec<bool> {
    let mut pushes: Vec<Vec<DVec3>> = vec![Vec::new(); assembly.bodies.len()];
    let mut carried: Vec<[usize; 2]> = Vec::new();
    for patch in assembly.patches() {
        let normal = patch.motion(&assembly.bodies).to_ground.z_axis;
        pushes[patch.point_body].push(normal);
        pushes[patch.plane_body].push(-normal);
        if normal.z.abs() > CARRIES {
            let (upper, lower) = match normal.z > 0.0 {
                true => (patch.point_body, patch.plane_body),
                false => (patch.plane_body, patch.point_body),
            };
            carried.push([upper, lower]);
        }
    }
    let mut decides: Vec<bool> = pushes.iter().map(|pushes| !is_wedge(pushes)).collect();
    // thrust continues down to the ground, at most through every body
    for _ in 0..assembly.bodies.len() {
        let before = decides.clone();
        for &[upper, lower] in &carried {
            decides[lower] &= decides[upper];
        }
        if decides == before {
            break;
        }
    }
    decides
}

/// Whether a body leans on others, by the normals of its joints, which point into the body.
fn is_wedge(pushes: &[DVec3]) -> bool {
    let slope = |normal: &DVec3| normal.truncate().length();
    let leans = |normal: &DVec3| slope(normal) > LEANS && normal.z.abs() > LEANS;
    let [steep, opened] = WEDGE;
    let opposes = |a: &DVec3, b: &DVec3| {
        a.dot(*b) < 0.0 && a.cross(*b).length() > opened && slope(a).max(slope(b)) > steep && a.z * b.z < 0.0
    };
    pushes.iter().any(leans) || pushes.iter().any(|a| pushes.iter().any(|b| opposes(a, b)))
}

/// Corners of the convex hull, counterclockwise.
///
/// # Source
/// Andrew, A. M. (1979) Inform. Process. Lett. 9:216-219.
fn hull(mut points: Vec<DVec2>) -> Vec<DVec2> {
    points.sort_by(|a, b| a.x.total_cmp(&b.x).then(a.y.total_cmp(&b.y)));
    let half = |points: &mut dyn Iterator<Item = DVec2>| {
        let mut chain: Vec<DVec2> = Vec::new();
        for point in points {
            while let [.., a, b] = chain[..] {
                if (b - a).perp_dot(point - a) > 0.0 {
                    break;
                }
                chain.pop();
            }
            chain.push(point);
        }
        chain.pop(); // the first point of the other half
        chain
    };
    let mut corners = half(&mut points.iter().copied());
    corners.extend(half(&mut points.iter().rev().copied()));
    if corners.is_empty() {
        corners.extend(points.first());
    }
    corners
}

/// Distance from the edge of a convex polygon, positive inside; never positive for a segment or a point.
fn margin(corners: &[DVec2], from: DVec2) -> f64 {
    let mut least = f64::INFINITY;
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let along = (b - a).normalize_or_zero();
        least = least.min(match along == DVec2::ZERO {
            true => -a.distance(from),
            false => along.perp_dot(from - a),
        });
    }
    least
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sloped(degrees: f64) -> DVec3 {
        let (sin, cos) = degrees.to_radians().sin_cos();
        DVec3::new(sin, 0.0, cos)
    }

    #[test]
    fn holds_stones_of_arches_lean_and_those_of_towers_do_not() {
        for slope in [0.0, 1.0, 5.0, 7.0] {
            assert!(
                !is_wedge(&[sloped(slope), -sloped(slope)]),
                "leaning tower {slope}"
            );
            assert!(!is_wedge(&[sloped(slope), -sloped(slope - 2.0)]), "scan {slope}");
        }
        // a leaf between two posts, and a lintel on one of them
        assert!(!is_wedge(&[sloped(0.0), DVec3::X, -DVec3::X]));
        for stones in [9.0, 17.0, 31.0, 101.0] {
            let wedge = 180.0 / stones;
            let leans = (0..stones as usize / 2).any(|stone| {
                let below = wedge * stone as f64;
                is_wedge(&[sloped(below), -sloped(below + wedge)])
            });
            assert!(leans, "arch of {stones}");
        }
    }

    #[test]
    fn exact_margin_in_a_hull() {
        let points = [
            [0.0, 0.0],
            [2.0, 0.0],
            [2.0, 1.0],
            [0.0, 1.0],
            [1.0, 0.5],
            [1.0, 0.0],
        ]
        .map(DVec2::from);
        let corners = hull(points.to_vec());
        assert_eq!(corners.len(), 4);
        assert_eq!(margin(&corners, DVec2::new(0.7, 0.4)), 0.4);
        assert_eq!(margin(&corners, DVec2::new(2.25, 0.5)), -0.25);
        assert_eq!(margin(&hull(points[..1].to_vec()), DVec2::new(3.0, 4.0)), -5.0);
        assert_eq!(margin(&hull(points[..2].to_vec()), DVec2::new(1.0, -0.5)), -0.5);
        assert_eq!(margin(&hull(points[..2].to_vec()), DVec2::new(1.0, 0.5)), -0.5);
    }
}
