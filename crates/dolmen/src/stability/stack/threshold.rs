//! The horizontal acceleration at which something begins.

/// A horizontal acceleration at which something begins, in the direction where it begins soonest.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Threshold {
    /// Acceleration, m/s²; infinite if no acceleration reaches it.
    pub acceleration_m_s2: f64,
    /// The same over gravity.
    pub acceleration_g: f64,
    /// Direction of the inertia force, unit vector in the plane: the way the part tips or slides. The ground then
    /// accelerates the other way.
    pub direction: [f64; 2],
}

impl Threshold {
    pub(super) fn new(acceleration_m_s2: f64, gravity: f64, direction: [f64; 2]) -> Self {
        Threshold {
            acceleration_m_s2,
            acceleration_g: acceleration_m_s2 / gravity,
            direction,
        }
    }
}
