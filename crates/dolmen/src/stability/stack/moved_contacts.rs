//! Contacts of a stack after large displacements: the overlap of faces, and their gap.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | c, R, d | `centre`, `rotation`, `shift` | centroid as drawn, rotation since then, displacement of the centroid | m, –, m |
//! | n | `axes[2]` | mean normal of both faces, from the lower to the upper body | – |
//! | g | `gap` | distance of both faces along n at a corner | m |

use crate::structure::stack::{Body, Joint, Polygon, Solid, Stack};
use glam::{DMat3, DQuat, DVec3};

/// Smallest cosine between the normal of a face and that of its joint: 6°.
const FACES_JOINT: f64 = 0.9945;
/// Relative difference between the overlap of two faces and the patch of the joint up to which the faces are used; beyond it, the patch
/// replaces both. Our choice.
const SAME_AREA: f64 = 0.01;

#[derive(Clone, Copy, Debug)]
pub(super) struct BlockPose {
    pub(super) centre: DVec3,
    pub(super) rotation: DMat3,
    pub(super) shift: DVec3,
}

impl BlockPose {
    pub(super) fn at_rest(centre: DVec3) -> Self {
        BlockPose {
            centre,
            rotation: DMat3::IDENTITY,
            shift: DVec3::ZERO,
        }
    }

    /// Displacement of the ground.
    pub(super) fn ground(shift: DVec3) -> Self {
        BlockPose {
            shift,
            ..BlockPose::at_rest(DVec3::ZERO)
        }
    }

    /// Its current centroid.
    pub(super) fn now(&self) -> DVec3 {
        self.centre + self.shift
    }

    /// The current position of a point of the block as drawn.
    pub(super) fn point(&self, drawn: DVec3) -> DVec3 {
        self.now() + self.rotation * (drawn - self.centre)
    }

    /// The point of the block as drawn that is now at a given position.
    fn drawn(&self, now: DVec3) -> DVec3 {
        self.centre + self.rotation.transpose() * (now - self.now())
    }

    /// Angle of the rotation since another pose, rad.
    pub(super) fn turned_from(&self, other: &Self) -> f64 {
        DQuat::from_mat3(&(self.rotation * other.rotation.transpose()))
            .to_scaled_axis()
            .length()
    }

    /// Moves the block further, by a displacement of its centroid and a rotation vector.
    pub(super) fn on(&self, shift: DVec3, turn: DVec3) -> Self {
        let angle = turn.length();
        let rotation = match angle > 0.0 {
            true => DMat3::from_axis_angle(turn / angle, angle) * self.rotation,
            false => self.rotation,
        };
        BlockPose {
            rotation,
            shift: self.shift + shift,
            ..*self
        }
    }
}

/// One corner of the overlap of two faces.
#[derive(Clone, Copy, Debug)]
pub(super) struct Corner {
    /// On the lower body, m.
    pub(super) lower: DVec3,
    /// On the upper block, m.
    pub(super) upper: DVec3,
    pub(super) gap: f64,
    /// Slip of the upper block on the lower body at this corner since the stack was drawn, m.
    pub(super) slip: f64,
}

#[derive(Clone, Debug)]
pub(super) struct Contact {
    pub(super) joint: usize,
    pub(super) lower: Option<usize>,
    pub(super) upper: usize,
    pub(super) axes: [DVec3; 3],
    pub(super) friction: f64,
    pub(super) corners: Vec<Corner>,
}

/// The two faces of a joint, in its plane as drawn; a small gap or wedge is closed.
#[derive(Clone, Debug)]
pub(super) struct Faces {
    joint: usize,
    pub(super) lower: Option<usize>,
    pub(super) upper: usize,
    origin: DVec3,
    axes: [DVec3; 3],
    friction: f64,
    /// Corners as drawn, m; `None` for the ground, which is unbounded.
    lower_face: Option<Vec<DVec3>>,
    upper_face: Vec<DVec3>,
}

pub(super) fn faces_of(stack: &Stack) -> Vec<Faces> {
    let joints = stack.joints().iter().enumerate();
    joints
        .map(|(index, joint)| {
            let lower = match joint.lower {
                Body::Ground => None,
                Body::Block(block) => Some(block),
            };
            let [first, second, normal] = joint.axes.map(DVec3::from);
            let solid = |block: usize| &stack.blocks()[block].solid;
            let place = |polygon: &Polygon| -> Vec<DVec3> {
                let corners = polygon.corners_m.iter();
                corners
                    .map(|corner| DVec3::from(joint.origin_m) + first * corner[0] + second * corner[1])
                    .collect()
            };
            let under = lower.map(|block| face(solid(block), joint, normal));
            let over = face(solid(joint.upper), joint, -normal);
            let both = match (&under, over) {
                (None, Some(over)) => Some((None, over)),
                (Some(Some(under)), Some(over)) => Some((Some(under.clone()), over)),
                _ => None,
            };
            let both = both.filter(|(under, over)| {
                let covered = under
                    .as_ref()
                    .map_or_else(|| over.clone(), |under| over.clipped(under));
                let area = joint.patch.moments().area_m2;
                (covered.moments().area_m2 - area).abs() <= SAME_AREA * area
            });
            let (under, over) =
                both.unwrap_or_else(|| (lower.map(|_| joint.patch.clone()), joint.patch.clone()));
            Faces {
                joint: index,
                lower,
                upper: joint.upper,
                origin: joint.origin_m.into(),
                axes: [first, second, normal],
                friction: joint.material.friction_static,
                lower_face: under.as_ref().map(place),
                upper_face: place(&over),
            }
        })
        .collect()
}

/// The face of a solid in the plane of a joint with normal `outward`, about the joint's origin.
fn face(solid: &Solid, joint: &Joint, outward: DVec3) -> Option<Polygon> {
    let [first, second, normal] = joint.axes.map(DVec3::from);
    let origin = DVec3::from(joint.origin_m);
    let corner = |face: usize| DVec3::from(solid.vertices_m()[solid.faces()[face][0]]);
    let away = |face: &usize| normal.dot(corner(*face) - origin).abs();
    let looks = (0..solid.faces().len()).filter(|&face| solid.normal(face).dot(outward) > FACES_JOINT);
    let nearest = looks.min_by(|a, b| away(a).total_cmp(&away(b)))?;
    let corners = solid.faces()[nearest].iter().map(|&vertex| {
        let from = DVec3::from(solid.vertices_m()[vertex]) - origin;
        [from.dot(first), from.dot(second)]
    });
    Some(counterclockwise(corners.collect()))
}

fn counterclockwise(mut corners_m: Vec<[f64; 2]>) -> Polygon {
    let next = corners_m.iter().cycle().skip(1);
    let twice_area: f64 = corners_m
        .iter()
        .zip(next)
        .map(|(a, b)| a[0] * b[1] - a[1] * b[0])
        .sum();
    if twice_area < 0.0 {
        corners_m.reverse();
    }
    Polygon { corners_m }
}

impl Faces {
    /// The contact between two bodies in their current positions; `None` without overlap.
    ///
    /// ```text
    /// both faces are projected along their mean normal n; corners of their common area; g = distance of both planes along n at each corner
    /// ```
    pub(super) fn contact(&self, below: &BlockPose, above: &BlockPose) -> Option<Contact> {
        let [first, _, normal] = self.axes;
        let (under, over) = (below.rotation * normal, above.rotation * normal);
        let mean = (under + over).normalize();
        let along = below.rotation * first;
        let along = (along - mean * along.dot(mean)).normalize();
        let axes = [along, mean.cross(along), mean];
        let (low, high) = (below.point(self.origin), above.point(self.origin));
        let middle = 0.5 * (low + high);
        let seen = |of: &BlockPose, face: &[DVec3]| {
            let corners = face.iter().map(|corner| {
                let from = of.point(*corner) - middle;
                [from.dot(axes[0]), from.dot(axes[1])]
            });
            counterclockwise(corners.collect())
        };
        let covered = match &self.lower_face {
            None => seen(above, &self.upper_face),
            Some(face) => seen(above, &self.upper_face).clipped(&seen(below, face)),
        };
        let corners: Vec<Corner> = covered
            .corners_m
            .iter()
            .map(|at| {
                let at = middle + axes[0] * at[0] + axes[1] * at[1];
                let to = |plane: DVec3, normal: DVec3| normal.dot(plane - at) / normal.dot(mean);
                let (down, up) = (to(low, under), to(high, over));
                let (lower, upper) = (at + mean * down, at + mean * up);
                let apart = above.drawn(upper) - below.drawn(lower);
                Corner {
                    lower,
                    upper,
                    gap: up - down,
                    slip: (apart - normal * apart.dot(normal)).length(),
                }
            })
            .collect();
        (!corners.is_empty()).then_some(Contact {
            joint: self.joint,
            lower: self.lower,
            upper: self.upper,
            axes,
            friction: self.friction,
            corners,
        })
    }
}
