/// The horizontal acceleration of a first motion, in its direction.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Threshold {
    /// Acceleration, m/s²; infinite if no acceleration reaches it.
    pub acceleration_m_s2: f64,
    /// The acceleration over gravity.
    pub acceleration_g: f64,
    /// Direction of the inertia force, unit vector in the plane: the direction in which the part tips or slides. The ground accelerates in the
    /// opposite direction.
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
