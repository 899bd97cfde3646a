//! One point of a contact under the rigid law.

/// How a point takes part.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Too far away to touch in this step.
    Away,
    /// It may touch.
    Near,
}

/// One point of a contact.
#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) area: f64,
    pub(super) weight: f64,
    /// Weight along the plane: larger where the pressure is larger.
    pub(super) shear_weight: f64,
    /// Part of the force that it is expected to carry; negative if none is expected of the face.
    pub(super) share: f64,
    pub(super) friction: f64,
    /// Gap now, m.
    pub(super) gap: f64,
    /// Gap at the end of the step if it moves on as it did, m.
    pub(super) gap_ahead: f64,
    /// Along the two axes of the plane, then the normal.
    pub(super) offset: [f64; 3],
    pub(super) held: [f64; 3],
    pub(super) impulse: [f64; 3],
    /// μ |u_t| as held by a convex problem, m/s.
    pub(super) lift: f64,
    pub(super) part: Part,
    pub(super) slips: bool,
    /// Whether it slipped in the step before.
    pub(super) slid: bool,
    /// Direction along which it slipped in the last Newton step; zeros if it did not.
    pub(super) along: [f64; 2],
    /// Index in the patch; beyond it for points that are made for an impact.
    pub(super) index: usize,
}

impl Point {
    /// A point away from all.
    pub(super) fn at([x, y]: [f64; 2], area: f64) -> Self {
        Point {
            x,
            y,
            area,
            weight: 0.0,
            shear_weight: 0.0,
            share: -1.0,
            friction: 0.0,
            gap: 0.0,
            gap_ahead: 0.0,
            offset: [0.0; 3],
            held: [0.0; 3],
            impulse: [0.0; 3],
            lift: 0.0,
            part: Part::Away,
            slips: false,
            slid: false,
            along: [0.0; 2],
            index: 0,
        }
    }
}

/// Force (or impulse) and torque of one contact on S about its origin, in the axes of the plane.
pub(super) type ForceTorque = [f64; 6];
