//! Options of the reader of a motion.

use crate::records::Column;
use crate::seismic::Response;
use crate::unit::Unit;
pub(super) use dolmen::known::STANDARD_GRAVITY_M_S2;
use std::ops::RangeInclusive;

/// Properties of the files. Defaults are detected from the files, or the file is refused.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionOptions {
    /// Unit of the numbers, one of acceleration. `None`: that of the file; refused if it has none. A unit that contradicts the
    /// file is refused.
    pub unit: Option<Unit>,
    /// Time between samples, s. `None`: that of the file; refused if it has none.
    pub time_step_s: Option<f64>,
    /// The column of accelerations in a text with several. `None`: the only one besides the time.
    pub column: Option<Column>,
    /// The channel to read from a file with several, by its name or its number from 1; in a text also a column, by its name. `None`:
    /// the only one.
    pub channel: Option<String>,
    /// Factor from the numbers to the unit: 1 (default), or the value of one count of a recorder.
    pub factor: f64,
    /// Instrument responses published by the network. They give unit and factor of a count for the channels that they name. If there are any, a
    /// channel in counts without a response is refused.
    pub responses: Vec<Response>,
    /// Whether the peak in a header must equal that of its samples. Default: yes.
    pub stated_peak: StatedPeak,
    /// Range of peaks of one component, m/s²; others are refused as a mistaken unit. Default 0.001 g to 5 g, our choice: smaller ones are not
    /// felt, and larger ones were never recorded on the ground.
    pub plausible_peak_m_s2: RangeInclusive<f64>,
    /// What to do if the components differ in length. Default: refuse.
    pub lengths: Lengths,
    /// Use of the motion. Default: to look at.
    pub read_for: ReadFor,
}

impl Default for MotionOptions {
    fn default() -> Self {
        MotionOptions {
            unit: None,
            time_step_s: None,
            column: None,
            channel: None,
            factor: 1.0,
            responses: Vec::new(),
            stated_peak: StatedPeak::Check,
            plausible_peak_m_s2: 0.001 * STANDARD_GRAVITY_M_S2..=5.0 * STANDARD_GRAVITY_M_S2,
            lengths: Lengths::Same,
            read_for: ReadFor::Looking,
        }
    }
}

/// Use of a motion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ReadFor {
    /// Measures and figures: any record.
    #[default]
    Looking,
    /// To shake a structure: a vertical record as x or y, and a record from a borehole, are refused.
    Shaking,
}

/// Treatment of components with different lengths.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lengths {
    /// Refuse them.
    #[default]
    Same,
    /// Cut all to the length of the shortest, from the first sample; the history records it. All must begin at the same time.
    Shortest,
}

/// Treatment of the peak in a header.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StatedPeak {
    /// Refuse samples whose peak differs by more than 1 %: they were damaged, or have another unit.
    #[default]
    Check,
    /// Ignore it.
    Ignore,
}
