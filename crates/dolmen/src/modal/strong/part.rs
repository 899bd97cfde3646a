//! A part of a record in which the structure was not shaken.

use crate::modal::modal_analysis::ModalAnalysis;
use crate::signal::{Record, cut};

/// A part of the record in which the structure was not shaken.
#[derive(Clone, Debug)]
pub struct Part {
    /// From and to, s from the first sample of the record.
    pub span_s: [f64; 2],
    /// Its modes; `None` where it is too short, or no modes were found in it.
    pub analysis: Option<ModalAnalysis>,
}

/// The part of a record, or none of it.
pub(super) fn part_of(record: &Record, [from_s, to_s]: [f64; 2]) -> Option<Record> {
    cut(record.clone(), from_s, to_s).ok()
}
