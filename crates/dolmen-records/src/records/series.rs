//! The channels of a file, each with its own sampling.

use super::{FileUnit, RecordError, RecordFormat};
use crate::breaks::Break;
use crate::quoted::shown;
use dolmen::signal::Quantity;
use dolmen_words::message::Both;

/// One channel of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Series {
    pub(super) name: String,
    pub(super) samples: Vec<f64>,
    pub(super) sampling_rate_hz: Option<f64>,
    pub(super) unit: FileUnit,
    /// Measured quantity, if the file states it.
    pub(super) quantity: Option<Quantity>,
    /// Time of the first sample, s from 1 January 1970 by the clock of the file.
    pub(super) begins_s: Option<f64>,
    /// Time of the first sample, s from an origin common to all channels of the file.
    pub(super) offset_s: f64,
    /// Gaps: where the samples continue after missing time.
    pub(super) breaks: Vec<Break>,
    pub(super) position_m: Option<[f64; 3]>,
    pub(super) direction: Option<[f64; 3]>,
}

impl Series {
    /// A channel with a printable name.
    pub(super) fn new(name: impl AsRef<str>, samples: Vec<f64>) -> Self {
        Series {
            name: shown(name.as_ref()),
            samples,
            sampling_rate_hz: None,
            unit: FileUnit::Silent,
            quantity: None,
            begins_s: None,
            offset_s: 0.0,
            breaks: Vec::new(),
            position_m: None,
            direction: None,
        }
    }
}

impl Series {
    /// The error that refuses gap number `i`.
    pub(super) fn gap(&self, i: usize) -> RecordError {
        let rate_hz = self.sampling_rate_hz.unwrap_or(f64::NAN);
        let mut before = Break { at: 0, begins_s: 0.0 };
        if let Some(last) = i.checked_sub(1).and_then(|i| self.breaks.get(i)) {
            before = *last;
        }
        let after = self.breaks.get(i).copied().unwrap_or(before);
        RecordError::Gap {
            channel: self.name.clone(),
            expected_s: before.begins_s + (after.at - before.at) as f64 / rate_hz,
            found_s: after.begins_s,
        }
    }

    /// Time at which the next sample would follow, s from the first.
    pub(super) fn end_s(&self) -> f64 {
        let last = self
            .breaks
            .last()
            .copied()
            .unwrap_or(Break { at: 0, begins_s: 0.0 });
        last.begins_s + (self.samples.len() - last.at) as f64 / self.sampling_rate_hz.unwrap_or(f64::NAN)
    }
}

/// All channels of a file.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FileSeries {
    pub(super) format: RecordFormat,
    pub(super) series: Vec<Series>,
    /// Notes on other contents of the file, as sentences.
    pub(super) notes: Vec<Both>,
}

/// 1/step, rounded to a whole number of hertz if that differs by less than the fraction `digits`: printed steps lose their
/// last digits.
pub(super) fn rate_of_step(step_s: f64, digits: f64) -> f64 {
    let rate = 1.0 / step_s;
    let whole = rate.round();
    if whole > 0.0 && (rate / whole - 1.0).abs() < digits {
        whole
    } else {
        rate
    }
}
