//! What must be known beside the modes, as sentences.

use super::identify::HANKEL_ROWS_MOST;
use crate::signal::ChannelFault;

/// What must be known beside the modes.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Note {
    /// A channel that is faint or clipped: it was used all the same.
    Channel(ChannelFault),
    /// The block rows are fewer than wished, so as to keep the matrices in bounds.
    BlockRowsBounded {
        /// Wished.
        wished: usize,
        /// Taken.
        taken: usize,
    },
    /// The record is too short for the blocks of time asked.
    FewBlocks {
        /// Taken.
        time_blocks: usize,
    },
    /// Peaks too narrow for a structure: they decide neither block rows nor decimation, and are no modes.
    Tones {
        /// Their frequencies, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Peaks of the spectrum at which no stable mode was found.
    PeaksWithoutMode {
        /// Their frequencies, Hz.
        frequency_hz: Vec<f64>,
    },
    /// A mode seen for so few cycles that its damping ratio is hardly known.
    FewCycles {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Long-record floor of the relative standard deviation of its damping ratio.
        damping_floor: f64,
    },
}

impl std::fmt::Display for Note {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Note::Channel(fault) => write!(f, "{fault} (it was used all the same)"),
            Note::BlockRowsBounded { wished, taken } => write!(
                f,
                "{taken} block rows instead of {wished}, to keep the Hankel matrix below {HANKEL_ROWS_MOST} rows: modes \
                 that lie close together are told apart less well"
            ),
            Note::FewBlocks { time_blocks } => write!(
                f,
                "the record is short: standard deviations come from {time_blocks} blocks of time, and are themselves known \
                 to ± {:.0} %",
                100.0 / (2.0 * (*time_blocks as f64 - 1.0)).sqrt()
            ),
            Note::Tones { frequency_hz } => {
                write!(f, "the spectrum has lines too narrow for a structure, at ")?;
                list(f, frequency_hz)?;
                write!(f, " Hz: machines")
            }
            Note::PeaksWithoutMode { frequency_hz } => {
                write!(f, "the spectrum has peaks that no stable mode explains, at ")?;
                list(f, frequency_hz)?;
                write!(f, " Hz: machines, or modes too weak for this record")
            }
            Note::FewCycles {
                frequency_hz,
                damping_floor,
            } => write!(
                f,
                "the mode at {frequency_hz:.3} Hz was seen for so few cycles that its damping ratio cannot be known better \
                 than ± {:.0} %",
                100.0 * damping_floor
            ),
        }
    }
}

fn list(f: &mut std::fmt::Formatter<'_>, frequency_hz: &[f64]) -> std::fmt::Result {
    for (i, frequency_hz) in frequency_hz.iter().enumerate() {
        let comma = if i > 0 { ", " } else { "" };
        write!(f, "{comma}{frequency_hz:.3}")?;
    }
    Ok(())
}
