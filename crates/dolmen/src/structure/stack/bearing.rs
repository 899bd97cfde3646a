//! Determines how much of a contact between two faces is stone. The face of a convex hull also spans gaps of a mesh and
//! openings.

use super::{Polygon, Solid};
use glam::DVec3;

/// Largest depth of stone behind the face of a hull at which it is in contact, m. Our choice: dressed stone is not flatter.
const BEHIND_M: f64 = 0.001;
/// Cosine of 5°, the largest angle between the face of a hull and triangles in contact, as for two beds.
const ALIGNED: f64 = 0.996_194_7;
/// Least area of the convex outline of the stone in contact, as a fraction of the hulls' contact: a stone tips about this
/// outline. Our choice.
pub(super) const OUTLINE_LEAST: f64 = 1.0 - 1e-3;
/// Least area of stone, as a fraction of the hulls' contact. Springs and bonds use the full area: with less stone a frequency
/// would be more than 5 % too high. Our choice.
pub(super) const AREA_LEAST: f64 = 0.9;

/// The stone in a contact, as fractions of the common area of the hulls.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Bearing {
    /// Fraction within the convex outline of the stone in contact.
    pub(super) outline: f64,
    /// Fraction with stone on stone.
    pub(super) area: f64,
}

impl Bearing {
    /// Whether tipping and bearing are those of the hulls.
    pub(super) fn is_whole(&self) -> bool {
        self.outline >= OUTLINE_LEAST && self.area >= AREA_LEAST
    }
}

/// A convex piece of stone in the plane of a face. Pieces that face the other way count as negative, as in sections closed by
/// signed triangles.
struct Piece {
    polygon: Polygon,
    sign: f64,
}

/// The stone in the contact patch of two faces, in the plane of `axes` through `origin`. Without a first face, the lower body is
/// the ground.
///
/// ```text
/// area = Σ Σ s_i s_j |A_i ∩ B_j| / |patch|,   outline = |hull of all A_i ∩ B_j| / |patch|,   A_i, B_j convex pieces of the faces
/// ```
pub(super) fn bearing(
    lower: Option<(&Solid, usize)>,
    upper: (&Solid, usize),
    patch: &Polygon,
    origin: DVec3,
    axes: &[DVec3; 3],
) -> Bearing {
    let whole = Bearing {
        outline: 1.0,
        area: 1.0,
    };
    let under = lower.map(|(solid, face)| pieces(solid, face, origin, axes));
    let over = pieces(upper.0, upper.1, origin, axes);
    // without meshes and openings, faces are those of the hulls
    let (under, over) = match (under, over) {
        (None | Some(None), None) => return whole,
        (under, over) => (under.flatten(), over),
    };
    let all = || {
        vec![Piece {
            polygon: patch.clone(),
            sign: 1.0,
        }]
    };
    let (under, over) = (under.unwrap_or_else(all), over.unwrap_or_else(all));
    let (mut area, mut corners) = (0.0, Vec::new());
    for a in &under {
        let part = a.polygon.clipped(patch);
        if part.corners_m.is_empty() {
            continue;
        }
        for b in &over {
            let both = part.clipped(&b.polygon);
            let sign = a.sign * b.sign;
            area += sign * both.moments().area_m2;
            if sign > 0.0 {
                corners.extend(both.corners_m);
            }
        }
    }
    let of = patch.moments().area_m2;
    let outline = match corners.is_empty() {
        true => 0.0,
        false => Polygon::hull(corners).moments().area_m2,
    };
    Bearing {
        outline: outline / of,
        area: area / of,
    }
}

/// The stone in a face of a hull, in convex pieces; `None` if the whole face is stone.
fn pieces(solid: &Solid, face: usize, origin: DVec3, axes: &[DVec3; 3]) -> Option<Vec<Piece>> {
    let outward = solid.normal(face);
    let on = DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
    let seen = |corners: &[DVec3]| {
        let corners = corners.iter().map(|corner| {
            let from = *corner - origin;
            [from.dot(axes[0]), from.dot(axes[1])]
        });
        let mut corners_m: Vec<[f64; 2]> = corners.collect();
        if outward.dot(axes[2]) < 0.0 {
            corners_m.reverse();
        }
        Polygon { corners_m }
    };
    let lies_in = |corner: &DVec3| outward.dot(on - *corner) <= BEHIND_M;
    let whole: Vec<DVec3> = solid.faces()[face]
        .iter()
        .map(|&vertex| DVec3::from(solid.vertices_m()[vertex]))
        .collect();
    let mut own: Option<Vec<Piece>> = None;
    // the faces of a noisy scan are fitted, and the joint stores how much of the face is flat stone
    if !solid.mesh.is_empty() && solid.scan.is_none() {
        let mut found = Vec::new();
        for triangle in solid.mesh.iter().filter(|triangle| triangle.iter().all(lies_in)) {
            let [a, b, c] = *triangle;
            let along = (b - a).cross(c - a).normalize_or_zero().dot(outward);
            if along.abs() < ALIGNED {
                continue;
            }
            let corners = if along > 0.0 { [a, b, c] } else { [a, c, b] };
            found.push(Piece {
                polygon: seen(&corners),
                sign: along.signum(),
            });
        }
        own = Some(found);
    }
    for opening in &solid.openings {
        for number in 0..opening.faces().len() {
            let corners: Vec<DVec3> = opening.faces()[number]
                .iter()
                .map(|&vertex| DVec3::from(opening.vertices_m()[vertex]))
                .collect();
            if opening.normal(number).dot(outward) < ALIGNED || !corners.iter().all(lies_in) {
                continue;
            }
            let hole = seen(&corners);
            let before = own.take().unwrap_or_else(|| {
                vec![Piece {
                    polygon: seen(&whole),
                    sign: 1.0,
                }]
            });
            let left = before.into_iter().flat_map(|piece| {
                let sign = piece.sign;
                let parts = without(&piece.polygon, &hole).into_iter();
                parts.map(move |polygon| Piece { polygon, sign })
            });
            own = Some(left.collect());
        }
    }
    own
}

/// The remainder of a convex polygon after removal of a convex hole, in convex pieces, one for each edge of the hole.
fn without(polygon: &Polygon, hole: &Polygon) -> Vec<Polygon> {
    let mut rest = polygon.clone();
    let mut left = Vec::new();
    let edges = hole.corners_m.iter().zip(hole.corners_m.iter().cycle().skip(1));
    for (&start, &end) in edges {
        let beyond = rest.left_of(end, start);
        if !beyond.corners_m.is_empty() {
            left.push(beyond);
        }
        rest = rest.left_of(start, end);
    }
    left
}

#[cfg(test)]
mod tests {
    use super::super::{Block, JointMaterial, Placement, Stack, StackError};
    use super::*;

    /// A prism from z = `low` to `high` over an outline in plan, which is given by convex parts with common whole edges.
    fn prism(outline: &[[f64; 2]], parts: &[&[usize]], [low, high]: [f64; 2]) -> Solid {
        let n = outline.len();
        let ring = |z: f64| outline.iter().map(move |p| [p[0], p[1], z]);
        let corners: Vec<[f64; 3]> = ring(low).chain(ring(high)).collect();
        let mut triangles = Vec::new();
        for part in parts {
            for k in 1..part.len() - 1 {
                let [a, b, c] = [part[0], part[k], part[k + 1]];
                triangles.extend([[a, c, b], [a + n, b + n, c + n]]);
            }
        }
        for i in 0..n {
            let next = (i + 1) % n;
            triangles.extend([[i, next, next + n], [i, next + n, i + n]]);
        }
        Solid::mesh(&corners, &triangles).unwrap()
    }

    /// An L-shaped prism of 1 × 1 m without its corner beyond (0.7, 0.7), 0.5 m high.
    fn l_shape() -> Solid {
        let outline = [[0., 0.], [1., 0.], [1., 0.7], [0.7, 0.7], [0.7, 1.], [0., 1.]];
        prism(&outline, &[&[0, 1, 2, 3], &[0, 3, 4, 5]], [0.0, 0.5])
    }

    fn post(side: f64, at: [f64; 3]) -> Solid {
        Solid::cuboid(side, side, 0.8).unwrap().placed(&Placement {
            position_m: at,
            ..Placement::default()
        })
    }

    fn stack(solids: [Solid; 2]) -> Result<Stack, StackError> {
        let named = solids.into_iter().zip(["base", "post"]);
        let blocks = named.map(|(solid, name)| Block {
            name: name.into(),
            solid,
            density_kg_m3: 2500.0,
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81)
    }

    /// Contacts away from the missing corner, half over it, and around it, where the convex outline of the remaining L spans the
    /// corner.
    #[test]
    fn exact_share_of_stone_below_a_post_on_an_l() {
        for (side, [x, y], [area, outline]) in [
            (0.14, [0.78, 0.78], [0.0, 0.0]),
            (0.2, [0.7, 0.8], [0.5, 0.5]),
            (0.2, [0.75, 0.75], [0.4375, 0.718_75]),
        ] {
            let fault = stack([l_shape(), post(side, [x, y, 0.5])]).unwrap_err();
            let StackError::JointHollow {
                upper,
                lower,
                area: found,
                outline: spans,
                ..
            } = &fault
            else {
                panic!("{fault}")
            };
            assert_eq!((upper.as_str(), lower.as_str()), ("post", "base"));
            assert!(
                (found - area).abs() < 1e-9 && (spans - outline).abs() < 1e-9,
                "{x} {y}: {found} {spans}"
            );
        }
        let stands = stack([l_shape(), post(0.2, [0.5, 0.3, 0.5])]).unwrap();
        assert!((stands.joints()[1].patch.moments().area_m2 - 0.04).abs() < 1e-12);
        // the foot of the L: 0.91 m² of the hull's 0.955 m²
        assert!((stands.joints()[0].patch.moments().area_m2 - 0.955).abs() < 1e-12);
    }

    /// A box of 1 × 1 × 1.5 m with an opening from its floor up: the remaining part of the foot decides.
    #[test]
    fn exact_share_of_stone_below_an_opening_through_the_foot() {
        let shrine = |depth: f64, y: f64| {
            let hole = Solid::cuboid(1.0, depth, 1.2).unwrap().placed(&Placement {
                position_m: [0.0, y, 0.0],
                ..Placement::default()
            });
            let whole = Solid::cuboid(1.0, 1.0, 1.5).unwrap();
            let lid = post(0.4, [0.0, 0.0, 1.5]);
            stack([whole.with_opening(&hole).unwrap(), lid])
        };
        // opening at the front: a strip of 0.2 m remains, and its outline is the strip
        let Err(StackError::JointHollow { outline, area, .. }) = shrine(0.8, -0.1) else {
            panic!("a stone on a fifth of its foot")
        };
        assert!(
            (outline - 0.2).abs() < 1e-9 && (area - 0.2).abs() < 1e-9,
            "{outline} {area}"
        );
        // opening through the middle: two strips, whose outline is the whole foot
        let Err(StackError::JointHollow { outline, area, .. }) = shrine(0.8, 0.0) else {
            panic!("a stone on two strips")
        };
        assert!(
            (outline - 1.0).abs() < 1e-9 && (area - 0.2).abs() < 1e-9,
            "{outline} {area}"
        );
        // with a small opening the stone tips and bears as without it
        assert!(shrine(0.05, 0.0).is_ok());
    }

    #[test]
    fn holds_a_hole_leaves_the_rest_of_a_polygon() {
        let square = |half: f64, x: f64| Polygon {
            corners_m: vec![
                [x - half, -half],
                [x + half, -half],
                [x + half, half],
                [x - half, half],
            ],
        };
        for (half, x, left) in [(0.5, 0.0, 3.0), (0.5, 1.0, 3.5), (0.5, 2.0, 4.0), (2.0, 0.0, 0.0)] {
            let parts = without(&square(1.0, 0.0), &square(half, x));
            let area: f64 = parts.iter().map(|part| part.moments().area_m2).sum();
            assert!((area - left).abs() < 1e-12, "{half} {x}: {area}");
        }
    }
}
