//! What carries a stone, seen from above: how far the plumb line through its centroid lies inside it.

use super::assembly::Assembly;
use super::patch::LANES;
use glam::DVec2;

/// Least share of a joint's normal that points up for it to carry, as cosine: what leans beside a stone does not. Chosen here.
const CARRIES: f64 = 0.5;

/// Distance from a body's plumb line to the edge of the convex hull of what lies beneath it, m: negative outside; `None` if
/// nothing lies beneath.
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
        chain.pop(); // it begins the other half
        chain
    };
    let mut corners = half(&mut points.iter().copied());
    corners.extend(half(&mut points.iter().rev().copied()));
    if corners.is_empty() {
        corners.extend(points.first());
    }
    corners
}

/// Distance from the edge of a convex polygon, positive inside; of a segment or a point never positive.
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
