//! Readings of one quantity in time.

/// Readings in time.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Series {
    /// Times in usual intervals between surveys, ascending.
    pub(super) at: Vec<f64>,
    pub(super) readings: Vec<f64>,
    /// Standard deviation stated by the survey; 0 if none.
    pub(super) noise_sd: Vec<f64>,
}

impl Series {
    pub(super) fn len(&self) -> usize {
        self.at.len()
    }
}
