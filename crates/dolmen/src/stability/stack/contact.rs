//! The contact below a part of a stack: the patches of a cut in one plane.

use super::Cut;
use crate::structure::stack::{Body, Polygon, Stack};
use glam::DVec3;

/// The contact of a cut, in the axes of its plane.
pub(super) struct Contact {
    pub(super) origin: DVec3,
    pub(super) axes: [DVec3; 3],
    pub(super) patches: Vec<Polygon>,
    pub(super) hull: Polygon,
}

impl Contact {
    pub(super) fn at(&self, point: [f64; 2]) -> DVec3 {
        self.origin + self.axes[0] * point[0] + self.axes[1] * point[1]
    }

    /// Area of the patches, m².
    pub(super) fn area_m2(&self) -> f64 {
        self.patches.iter().map(|patch| patch.moments().area_m2).sum()
    }

    pub(super) fn along(&self, direction: [f64; 2]) -> DVec3 {
        self.axes[0] * direction[0] + self.axes[1] * direction[1]
    }
}

/// The patches of a cut, in the plane of the largest patch, with their convex hull.
pub(super) fn contact(stack: &Stack, cut: &Cut) -> Contact {
    let joints = stack.joints();
    let area = |joint: &usize| joints[*joint].patch.moments().area_m2;
    let mut largest = cut.joints[0];
    for joint in &cut.joints {
        if area(joint) > area(&largest) {
            largest = *joint;
        }
    }
    let origin = DVec3::from(joints[largest].origin_m);
    let axes = joints[largest].axes.map(DVec3::from);
    let patches: Vec<Polygon> = cut
        .joints
        .iter()
        .map(|&joint| {
            let joint = &joints[joint];
            let own = joint.axes.map(DVec3::from);
            let corners_m = joint.patch.corners_m.iter().map(|corner| {
                let at = DVec3::from(joint.origin_m) + own[0] * corner[0] + own[1] * corner[1] - origin;
                [at.dot(axes[0]), at.dot(axes[1])]
            });
            Polygon {
                corners_m: corners_m.collect(),
            }
        })
        .collect();
    let hull = match patches.as_slice() {
        [only] => only.clone(),
        several => Polygon::hull(several.iter().flat_map(|patch| patch.corners_m.clone()).collect()),
    };
    Contact {
        origin,
        axes,
        patches,
        hull,
    }
}

/// The bodies below a cut, in words.
pub(super) fn names_below(stack: &Stack, cut: &Cut) -> String {
    let mut bodies: Vec<Body> = cut
        .joints
        .iter()
        .map(|&joint| stack.joints()[joint].lower)
        .collect();
    bodies.sort_unstable();
    bodies.dedup();
    let words = bodies.into_iter().map(|body| match body {
        Body::Ground => "the ground".to_owned(),
        Body::Block(_) => format!("'{}'", stack.name(body)),
    });
    words.collect::<Vec<_>>().join(", ")
}
