//! The axis about which a part rotates when the stone at its edge crushes: the centroid of a stress block.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | ν | `outward` | direction in the plane, unit | – |
//! | t | `depth` | depth of the compressed strip behind the outermost corner along ν | m |
//! | A(t) | `area` | area of the patches within the strip; A f = N | m² |

use crate::structure::stack::Polygon;

/// Centroid, in the plane of the patches, of their outermost strip along a direction with the given area; `None` if their total area is
/// smaller.
///
/// ```text
/// ∫ over {r : ν·r ≥ max ν·r − t} = A = N / f        rectangle b × l: t = N/(f b), pivot t/2 inside the edge
/// ```
pub(crate) fn toe(patches: &[Polygon], outward: [f64; 2], area: f64) -> Option<[f64; 2]> {
    let along = |corner: &[f64; 2]| corner[0] * outward[0] + corner[1] * outward[1];
    let corners = || patches.iter().flat_map(|patch| &patch.corners_m);
    let most = corners().map(along).fold(f64::NEG_INFINITY, f64::max);
    let least = corners().map(along).fold(f64::INFINITY, f64::min);
    let whole: f64 = patches.iter().map(|patch| patch.moments().area_m2).sum();
    if area > whole {
        return None;
    }
    if area <= 0.0 {
        return corners()
            .max_by(|a, b| along(a).total_cmp(&along(b)))
            .map(|corner| [outward[0] * along(corner), outward[1] * along(corner)]);
    }
    // A(t) increases with t: false position, with half the weight for an end that stays (Illinois)
    let (mut low, mut high) = (0.0, most - least);
    let (mut below, mut above) = (-area, whole - area);
    for _ in 0..100 {
        let depth = if above - below > 0.0 {
            (low * above - high * below) / (above - below)
        } else {
            0.5 * (low + high)
        };
        let (at, _) = strip(patches, outward, most - depth);
        let difference = at - area;
        if difference.abs() <= 1e-13 * whole || high - low <= 1e-15 * (most - least) {
            high = depth;
            break;
        }
        if difference > 0.0 {
            (high, above, below) = (depth, difference, 0.5 * below);
        } else {
            (low, below, above) = (depth, difference, 0.5 * above);
        }
    }
    Some(strip(patches, outward, most - high).1)
}

/// Area and centroid of the part beyond a line.
fn strip(patches: &[Polygon], outward: [f64; 2], from: f64) -> (f64, [f64; 2]) {
    let (mut area, mut first) = (0.0, [0.0; 2]);
    for patch in patches {
        let moments = beyond(patch, outward, from).moments();
        area += moments.area_m2;
        first[0] += moments.area_m2 * moments.centroid_m[0];
        first[1] += moments.area_m2 * moments.centroid_m[1];
    }
    if area > 0.0 {
        (area, [first[0] / area, first[1] / area])
    } else {
        (0.0, [outward[0] * from, outward[1] * from])
    }
}

/// The part of a convex polygon with ν·r ≥ from.
pub(crate) fn beyond(patch: &Polygon, outward: [f64; 2], from: f64) -> Polygon {
    let corners = &patch.corners_m;
    let mut kept = Vec::with_capacity(corners.len() + 1);
    for (&a, &b) in corners.iter().zip(corners.iter().cycle().skip(1)) {
        let side = |corner: [f64; 2]| corner[0] * outward[0] + corner[1] * outward[1] - from;
        let (side_a, side_b) = (side(a), side(b));
        if side_a >= 0.0 {
            kept.push(a);
        }
        if (side_a > 0.0 && side_b < 0.0) || (side_a < 0.0 && side_b > 0.0) {
            let t = side_a / (side_a - side_b);
            kept.push([a[0] + t * (b[0] - a[0]), a[1] + t * (b[1] - a[1])]);
        }
    }
    Polygon { corners_m: kept }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_toe_of_a_rectangle_and_of_a_triangle() {
        let rectangle = Polygon {
            corners_m: vec![[-0.5, -1.0], [0.5, -1.0], [0.5, 1.0], [-0.5, 1.0]],
        };
        let pivot = toe(std::slice::from_ref(&rectangle), [1.0, 0.0], 0.4).unwrap();
        assert!((pivot[0] - 0.4).abs() < 1e-12 && pivot[1].abs() < 1e-12);
        assert_eq!(toe(&[rectangle], [1.0, 0.0], 2.1), None);
        // right triangle, tip at (1, 0) along x: area s² / 2 of the strip, centroid s / 3 above its base
        let triangle = Polygon {
            corners_m: vec![[0.0, -1.0], [1.0, 0.0], [0.0, 1.0]],
        };
        let pivot = toe(&[triangle], [1.0, 0.0], 0.09).unwrap();
        assert!((pivot[0] - (1.0 - 0.3 * 2.0 / 3.0)).abs() < 1e-12, "{pivot:?}");
    }
}
