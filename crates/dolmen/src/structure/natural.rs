//! Natural modes of a structure.

/// One natural mode of an undamped structure.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct NaturalMode {
    /// ω², (rad/s)²: negative if the structure is unstable in this shape.
    pub omega_squared: f64,
    /// Frequency, Hz; 0 if ω² is not positive.
    pub frequency_hz: f64,
    /// Lateral displacement: of the top of each link of a chain, of each level of a frame; the largest is 1.
    pub displacement: Vec<f64>,
    /// Coordinates of the structure: link rotations of a chain (rad per unit of `displacement`), Y_i of a frame.
    pub coordinates: Vec<f64>,
}

/// Frequency of the lowest mode, Hz. `None` if there is no mode, or if the structure is unstable in its shape. The
/// modes must be in ascending order.
pub fn lowest_frequency_hz(modes: &[NaturalMode]) -> Option<f64> {
    let lowest = modes.first().filter(|mode| mode.omega_squared > 0.0);
    lowest.map(|mode| mode.frequency_hz)
}
