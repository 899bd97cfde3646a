//! One point of a contact under the rigid law.

/// State of a point in a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Too far away for contact in this step.
    Away,
    /// Contact is possible.
    Near,
}

#[derive(Clone, Copy, Debug)]
pub(super) struct Point {
    pub(super) x: f64,
    pub(super) y: f64,
    pub(super) area: f64,
    pub(super) weight: f64,
    /// Weight along the plane; it increases with the pressure.
    pub(super) shear_weight: f64,
    /// Expected fraction of the force on the face; negative if no force is expected.
    pub(super) share: f64,
    pub(super) friction: f64,
    pub(super) gap: f64,
    /// Gap at the end of the step at unchanged velocities, m.
    pub(super) gap_ahead: f64,
    /// Components along the two axes of the plane, then along the normal.
    pub(super) offset: [f64; 3],
    pub(super) held: [f64; 3],
    pub(super) impulse: [f64; 3],
    /// μ |u_t| as fixed for a convex problem, m/s.
    pub(super) lift: f64,
    pub(super) part: Part,
    pub(super) slips: bool,
    /// Whether it slipped in the last step.
    pub(super) slid: bool,
    /// Direction of its slip in the last Newton step; zero without slip.
    pub(super) along: [f64; 2],
    /// Index in the patch; larger indices are points added for an impact.
    pub(super) index: usize,
}

impl Point {
    /// A point without contact.
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
