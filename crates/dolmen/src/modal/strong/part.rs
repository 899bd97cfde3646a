//! A part of a record outside the earthquakes.

use crate::modal::modal_analysis::ModalAnalysis;
use crate::signal::{Record, cut};

/// A part of a record outside the earthquakes.
#[derive(Clone, Debug)]
pub struct Part {
    /// From and to, s from the first sample of the record.
    pub span_s: [f64; 2],
    /// Modes of this part; `None` if it is too short or has no modes.
    pub analysis: Option<ModalAnalysis>,
}

/// The part of a record, or none of it.
pub(super) fn part_of(record: &Record, [from_s, to_s]: [f64; 2]) -> Option<Record> {
    cut(record.clone(), from_s, to_s).ok()
}
