//! A stack seen from the side and above: blocks in painter's order, shaded, joints coloured by their motion.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | d | `toward` | unit vector towards the eye | – |
//! | r, u | `right`, `up` | unit vectors of the picture | – |

use super::hull::hull;
use dolmen::blocks::Pose;
use dolmen::structure::stack::Stack;

type Vec3 = [f64; 3];

/// Azimuth of the eye to the right of the y axis, rad: both faces of a square stone are visible, the front more. Our choice.
const AZIMUTH_RAD: f64 = 0.60;
/// Elevation of the eye above the horizon, rad: tops are visible, and roofs hide little of the joints below them. Our choice.
const ELEVATION_RAD: f64 = 0.30;
/// Light comes from the upper left, from behind the eye: tops are brightest. Our choice.
const LIGHT: Vec3 = [-0.42, -0.45, 0.80];

fn dot(a: Vec3, b: Vec3) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn minus(a: Vec3, b: Vec3) -> Vec3 {
    [a[0] - b[0], a[1] - b[1], a[2] - b[2]]
}

fn cross(a: Vec3, b: Vec3) -> Vec3 {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// An orthogonal projection.
#[derive(Clone, Copy, Debug)]
pub(super) struct Camera {
    toward: Vec3,
    right: Vec3,
    up: Vec3,
}

impl Camera {
    pub(super) fn new() -> Self {
        let ((sin, cos), (rise, level)) = (AZIMUTH_RAD.sin_cos(), ELEVATION_RAD.sin_cos());
        Camera {
            toward: [sin * level, -cos * level, rise],
            right: [cos, sin, 0.0],
            up: [-sin * rise, cos * rise, level],
        }
    }

    /// Whether a face with this outward normal is towards the eye.
    pub(super) fn sees(&self, normal: Vec3) -> bool {
        dot(normal, self.toward) >= 0.0
    }

    /// Place in the picture, m, y up.
    pub(super) fn flat(&self, at: Vec3) -> [f64; 2] {
        [dot(self.right, at), dot(self.up, at)]
    }
}

/// A block at its drawn position.
#[derive(Clone, Debug)]
pub(super) struct Placed {
    pub(super) corners: Vec<Vec3>,
    faces: Vec<Vec<usize>>,
    normals: Vec<Vec3>,
    centre: Vec3,
    drawn_centre: Vec3,
    turn: Vec3,
}

/// A displacement to draw: from one pose of a block to another, times a factor.
#[derive(Clone, Copy, Debug)]
pub(super) struct DrawnDisplacement<'a> {
    pub(super) rest: &'a [Pose],
    pub(super) now: &'a [Pose],
    pub(super) times: f64,
}

/// The blocks of a stack as drawn, or displaced.
pub(super) fn placed(stack: &Stack, moved: Option<DrawnDisplacement<'_>>) -> Vec<Placed> {
    let each = stack.blocks().iter().enumerate();
    each.map(|(number, block)| {
        let centre = block.solid.centroid_m();
        let pose = moved.and_then(|moved| {
            let (rest, now) = (moved.rest.get(number)?, moved.now.get(number)?);
            let shift = minus(now.centroid_m, rest.centroid_m).map(|part| part * moved.times);
            let turn = rotation_vector(rest.rotation, now.rotation).map(|part| part * moved.times);
            Some((shift, turn))
        });
        let (shift, turn) = pose.unwrap_or_default();
        // pieces stand on one another: painted lowest first
        let (mut drawn, mut faces): (Vec<Vec3>, Vec<Vec<usize>>) = (Vec::new(), Vec::new());
        for piece in block.solid.drawn() {
            let from = drawn.len();
            let numbered = piece
                .faces()
                .iter()
                .map(|face| face.iter().map(|corner| from + corner).collect());
            faces.extend(numbered);
            drawn.extend(piece.vertices_m());
        }
        let mut placed = Placed {
            corners: Vec::new(),
            faces,
            normals: Vec::new(),
            centre: std::array::from_fn(|axis| centre[axis] + shift[axis]),
            drawn_centre: centre,
            turn,
        };
        placed.corners = drawn.iter().map(|corner| placed.now(*corner)).collect();
        placed.normals = placed
            .faces
            .iter()
            .map(|face| normal(&placed.corners, face))
            .collect();
        placed
    })
    .collect()
}

/// Newell's normal of a face, outward, of unit length.
fn normal(corners: &[Vec3], face: &[usize]) -> Vec3 {
    let mut sum = [0.0; 3];
    for pair in face.windows(2).skip(1) {
        let (a, b) = (
            minus(corners[pair[0]], corners[face[0]]),
            minus(corners[pair[1]], corners[face[0]]),
        );
        let area = cross(a, b);
        sum = std::array::from_fn(|axis| sum[axis] + area[axis]);
    }
    let length = dot(sum, sum).sqrt().max(f64::MIN_POSITIVE);
    sum.map(|part| part / length)
}

/// The rotation between two orientations as axis × angle, rad; quaternions with the scalar first.
fn rotation_vector(from: [f64; 4], to: [f64; 4]) -> Vec3 {
    // q = to · from⁻¹
    let [a, b, c, d] = to;
    let [w, x, y, z] = [from[0], -from[1], -from[2], -from[3]];
    let scalar = a * w - b * x - c * y - d * z;
    let vector = [
        a * x + b * w + c * z - d * y,
        a * y - b * z + c * w + d * x,
        a * z + b * y - c * x + d * w,
    ];
    let sign = if scalar < 0.0 { -1.0 } else { 1.0 };
    let sine = dot(vector, vector).sqrt();
    if sine < 1e-300 {
        return [0.0; 3];
    }
    let angle = 2.0 * sine.atan2(scalar.abs());
    vector.map(|part| sign * part * angle / sine)
}

/// Rodrigues' formula: a vector rotated by axis × angle.
fn turned(v: Vec3, turn: Vec3) -> Vec3 {
    let angle = dot(turn, turn).sqrt();
    if angle < 1e-300 {
        return v;
    }
    let axis = turn.map(|part| part / angle);
    let (sin, cos) = angle.sin_cos();
    let (side, along) = (cross(axis, v), dot(axis, v) * (1.0 - cos));
    std::array::from_fn(|i| v[i] * cos + side[i] * sin + axis[i] * along)
}

impl Placed {
    /// Present position of a point of the block as drawn, m.
    pub(super) fn now(&self, drawn: Vec3) -> Vec3 {
        let arm = turned(minus(drawn, self.drawn_centre), self.turn);
        std::array::from_fn(|axis| self.centre[axis] + arm[axis])
    }

    /// Faces towards the eye: outlines in the picture, m, each with its brightness 0 to 1.
    pub(super) fn seen(&self, camera: &Camera) -> Vec<(Vec<[f64; 2]>, f64)> {
        let faces = self.faces.iter().zip(&self.normals);
        let seen = faces.filter(|(_, normal)| dot(**normal, camera.toward) > 1e-9);
        let length = dot(LIGHT, LIGHT).sqrt();
        seen.map(|(face, normal)| {
            let outline = face.iter().map(|&corner| camera.flat(self.corners[corner]));
            let light = (0.5 + 0.5 * dot(*normal, LIGHT) / length).clamp(0.0, 1.0);
            (outline.collect(), light)
        })
        .collect()
    }

    /// Convex outline in the picture, m, counter-clockwise.
    fn outline(&self, camera: &Camera) -> Vec<[f64; 2]> {
        hull(self.corners.iter().map(|corner| camera.flat(*corner)).collect())
    }
}

/// Whether two convex outlines overlap by more than a touch: no edge of either separates them.
fn overlap(a: &[[f64; 2]], b: &[[f64; 2]]) -> bool {
    /// Overlap that counts as touching, over the length of an edge.
    const TOUCH: f64 = 1e-6;
    let separates = |own: &[[f64; 2]], other: &[[f64; 2]]| {
        (0..own.len()).any(|i| {
            let (from, to) = (own[i], own[(i + 1) % own.len()]);
            let (dx, dy) = (to[0] - from[0], to[1] - from[1]);
            // outward of a counter-clockwise outline
            let outward = |at: &[f64; 2]| (at[0] - from[0]) * dy - (at[1] - from[1]) * dx;
            let nearest = other.iter().map(outward).fold(f64::INFINITY, f64::min);
            nearest >= -TOUCH * (dx * dx + dy * dy)
        })
    };
    !separates(a, b) && !separates(b, a)
}

/// Smallest and largest coordinates of points in the plane.
pub(super) fn bounds(points: impl Iterator<Item = [f64; 2]>) -> [[f64; 2]; 2] {
    let mut found = [[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]];
    for point in points {
        for axis in 0..2 {
            found[0][axis] = found[0][axis].min(point[axis]);
            found[1][axis] = found[1][axis].max(point[axis]);
        }
    }
    found
}

/// Which of two convex bodies hides the other, decided by the face of either that separates them best. `Less` if `a` is behind.
fn behind(a: &Placed, b: &Placed, camera: &Camera) -> std::cmp::Ordering {
    let gap = |of: &Placed, other: &Placed| -> Option<(f64, Vec3)> {
        let each = of.faces.iter().zip(&of.normals).map(|(face, normal)| {
            let level = dot(*normal, of.corners[face[0]]);
            let nearest = other.corners.iter().map(|corner| dot(*normal, *corner) - level);
            (nearest.fold(f64::INFINITY, f64::min), *normal)
        });
        each.max_by(|p, q| p.0.total_cmp(&q.0))
    };
    let (Some((of_a, normal_a)), Some((of_b, normal_b))) = (gap(a, b), gap(b, a)) else {
        return std::cmp::Ordering::Equal;
    };
    // outward of a and towards the eye: b is in front
    let front = if of_a >= of_b {
        dot(normal_a, camera.toward)
    } else {
        -dot(normal_b, camera.toward)
    };
    if front.abs() < 1e-9 {
        return std::cmp::Ordering::Equal;
    }
    if front > 0.0 {
        std::cmp::Ordering::Less
    } else {
        std::cmp::Ordering::Greater
    }
}

/// Painting order of the blocks, farthest first. Only blocks whose outlines overlap have an order: others would close cycles that are none. If blocks
/// hide each other in a cycle, the one with the farthest centre begins.
pub(super) fn painted(blocks: &[Placed], camera: &Camera) -> Vec<usize> {
    let outlines: Vec<Vec<[f64; 2]>> = blocks.iter().map(|block| block.outline(camera)).collect();
    let boxes: Vec<[[f64; 2]; 2]> = outlines.iter().map(|of| bounds(of.iter().copied())).collect();
    let count = blocks.len();
    let mut over: Vec<Vec<usize>> = vec![Vec::new(); count];
    let mut under = vec![0usize; count];
    for i in 0..count {
        for j in 0..i {
            let (a, b) = (&boxes[i], &boxes[j]);
            let is_apart = (0..2).any(|axis| a[0][axis] >= b[1][axis] || b[0][axis] >= a[1][axis]);
            if is_apart || !overlap(&outlines[i], &outlines[j]) {
                continue;
            }
            match behind(&blocks[i], &blocks[j], camera) {
                std::cmp::Ordering::Less => {
                    over[i].push(j);
                    under[j] += 1;
                }
                std::cmp::Ordering::Greater => {
                    over[j].push(i);
                    under[i] += 1;
                }
                std::cmp::Ordering::Equal => {}
            }
        }
    }
    let depth: Vec<f64> = blocks
        .iter()
        .map(|block| dot(block.centre, camera.toward))
        .collect();
    let mut left: Vec<usize> = (0..count).collect();
    let mut order = Vec::with_capacity(count);
    while !left.is_empty() {
        let free = (0..left.len()).min_by(|&p, &q| {
            let (p, q) = (left[p], left[q]);
            under[p].cmp(&under[q]).then(depth[p].total_cmp(&depth[q]))
        });
        let block = left.remove(free.unwrap_or(0));
        for &other in &over[block] {
            under[other] = under[other].saturating_sub(1);
        }
        order.push(block);
    }
    order
}

#[cfg(test)]
mod tests {
    use super::*;
    use dolmen::structure::stack::{Block, JointMaterial, Placement, Solid};

    fn stack(boxes: &[[f64; 6]]) -> Stack {
        let blocks = boxes.iter().enumerate().map(|(i, [x, y, z, w, d, h])| Block {
            name: format!("{i}"),
            solid: Solid::cuboid(*w, *d, *h).unwrap().placed(&Placement {
                position_m: [*x, *y, *z],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap()
    }

    #[test]
    fn exact_painters_order_of_posts_under_a_slab() {
        // the slab is over both posts, the far post (y = 2) is behind the near one
        let stack = stack(&[
            [0.0, 0.0, 0.0, 0.5, 0.5, 2.0],
            [0.0, 2.0, 0.0, 0.5, 0.5, 2.0],
            [0.0, 1.0, 2.0, 0.6, 3.0, 0.3],
        ]);
        assert_eq!(painted(&placed(&stack, None), &Camera::new()), [1, 0, 2]);
    }

    #[test]
    fn exact_no_stone_of_a_hollow_tower_is_painted_over_by_one_behind_or_below() {
        // courses of four stones like a pinwheel, 1.9 and 0.5 m long, turned the other way in every second course
        let course = |k: usize| {
            let side = if k.is_multiple_of(2) { 1.0 } else { -1.0 };
            let z = 0.5 * k as f64;
            [
                [side * -0.25, -0.95, z, 1.9, 0.5, 0.5],
                [side * 0.95, -0.25, z, 0.5, 1.9, 0.5],
                [side * 0.25, 0.95, z, 1.9, 0.5, 0.5],
                [side * -0.95, 0.25, z, 0.5, 1.9, 0.5],
            ]
        };
        let boxes: Vec<[f64; 6]> = (0..6).flat_map(course).collect();
        let blocks = placed(&stack(&boxes), None);
        let camera = Camera::new();
        let order = painted(&blocks, &camera);
        let rank = |block: usize| order.iter().position(|own| *own == block);
        for a in 0..boxes.len() {
            for b in 0..boxes.len() {
                let hides = overlap(&blocks[a].outline(&camera), &blocks[b].outline(&camera))
                    && behind(&blocks[a], &blocks[b], &camera) == std::cmp::Ordering::Less;
                assert!(!hides || rank(a) < rank(b), "{a} {b} {order:?}");
            }
        }
    }

    #[test]
    fn exact_a_turn_of_any_size_comes_back_as_its_vector() {
        for angle in [1e-9, 0.3, 3.0] {
            let (sin, cos) = (0.5_f64 * angle).sin_cos();
            let turn = rotation_vector([1.0, 0.0, 0.0, 0.0], [cos, 0.0, 0.0, sin]);
            assert!((turn[2] - angle).abs() < 1e-15 * angle.max(1.0) && turn[0] == 0.0);
            let at = turned([1.0, 0.0, 0.0], turn);
            assert!((at[0] - angle.cos()).abs() < 1e-15 && (at[1] - angle.sin()).abs() < 1e-15);
        }
    }

    #[test]
    fn holds_three_faces_of_a_box_are_seen_and_they_differ_in_light() {
        let stack = stack(&[[0.0, 0.0, 0.0, 1.0, 1.0, 1.0]]);
        let seen = placed(&stack, None)[0].seen(&Camera::new());
        assert_eq!(seen.len(), 3);
        assert!((seen[0].1 - seen[1].1).abs() > 0.1 && (seen[1].1 - seen[2].1).abs() > 0.1);
    }
}
