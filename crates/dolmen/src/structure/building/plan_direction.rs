//! Horizontal directions.

/// A horizontal direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PlanDirection {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Rotated from x, counterclockwise.
    Degrees(f64),
}

impl PlanDirection {
    /// Unit vector of the direction.
    pub fn unit(self) -> [f64; 2] {
        match self {
            PlanDirection::X => [1.0, 0.0],
            PlanDirection::Y => [0.0, 1.0],
            PlanDirection::Degrees(degrees) => {
                let (sin, cos) = sin_cos_degrees(degrees);
                [cos, sin]
            }
        }
    }
}

/// Sine and cosine, exact at multiples of 90°.
pub(super) fn sin_cos_degrees(degrees: f64) -> (f64, f64) {
    match degrees.rem_euclid(360.0) {
        0.0 => (0.0, 1.0),
        90.0 => (1.0, 0.0),
        180.0 => (0.0, -1.0),
        270.0 => (-1.0, 0.0),
        other => other.to_radians().sin_cos(),
    }
}
