//! What the caller tells the reader of a motion about its files.

use crate::records::Column;
use crate::unit::Unit;
pub(super) use dolmen::known::STANDARD_GRAVITY_M_S2;
use std::ops::RangeInclusive;

/// What is known of the files. Everything left at its default is found out from them, or refused.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionOptions {
    /// Unit of the numbers, one of acceleration. `None`: as the file says; refused if it does not. A unit that contradicts the
    /// file is refused.
    pub unit: Option<Unit>,
    /// Between samples, s. `None`: as the file says; refused if it does not.
    pub time_step_s: Option<f64>,
    /// The column of accelerations in a text of several. `None`: the only one beside the time.
    pub column: Option<Column>,
    /// The channel to read of a file of several, by its name or its number from 1; in a text also a column, by its name. `None`: the
    /// only one.
    pub channel: Option<String>,
    /// What the numbers are multiplied by to be in the unit: 1 (default), or what one count of a recorder is worth.
    pub factor: f64,
    /// Whether the peak that a header states must be that of its samples. Default: yes.
    pub stated_peak: StatedPeak,
    /// Peaks of one component that an earthquake can have, m/s²; others are refused as a mistaken unit. Default 0.001 g to
    /// 5 g, chosen here: below nothing is felt, and above nothing was recorded on the ground.
    pub plausible_peak_m_s2: RangeInclusive<f64>,
    /// What to do where the components are not equally long. Default: refuse.
    pub lengths: Lengths,
}

impl Default for MotionOptions {
    fn default() -> Self {
        MotionOptions {
            unit: None,
            time_step_s: None,
            column: None,
            channel: None,
            factor: 1.0,
            stated_peak: StatedPeak::Check,
            plausible_peak_m_s2: 0.001 * STANDARD_GRAVITY_M_S2..=5.0 * STANDARD_GRAVITY_M_S2,
            lengths: Lengths::Same,
        }
    }
}

/// What to do where the files of the components are not equally long.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Lengths {
    /// Refuse them.
    #[default]
    Same,
    /// Keep of each as much as the shortest has, from the first sample; the history says so. All must begin at one time.
    Shortest,
}

/// What to do with the peak that a header states.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum StatedPeak {
    /// Refuse samples whose peak is another by more than 1 %: they were damaged, or are in another unit.
    #[default]
    Check,
    /// Pass it over.
    Ignore,
}
