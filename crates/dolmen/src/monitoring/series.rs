//! Readings of one quantity in time.

#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct Series {
    /// Times in units of the usual interval between surveys, ascending.
    pub(super) at: Vec<f64>,
    pub(super) readings: Vec<f64>,
    /// Standard deviations stated by the surveys; 0 if not stated.
    pub(super) noise_sd: Vec<f64>,
}

impl Series {
    pub(super) fn len(&self) -> usize {
        self.at.len()
    }
}
