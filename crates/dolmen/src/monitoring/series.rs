//! Readings of one quantity in time.

/// Readings in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Series {
    /// When, in usual intervals between surveys, ascending.
    pub(super) at: Vec<f64>,
    /// The readings.
    pub(super) readings: Vec<f64>,
    /// Standard deviation that the survey states; 0 where it states none.
    pub(super) noise_sd: Vec<f64>,
}

impl Series {
    pub(super) fn len(&self) -> usize {
        self.at.len()
    }
}
