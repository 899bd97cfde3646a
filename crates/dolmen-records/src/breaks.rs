//! Gaps in the samples of a channel.

/// The end of a gap in a channel.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Break {
    /// Index of the first sample after it.
    pub(crate) at: usize,
    /// Time of that sample from the first of the channel, s.
    pub(crate) begins_s: f64,
}
