//! What can be done in the project file or with the command about an error or a note of the science. The science says what is
//! wrong in its own words and names neither; who prints adds this.

use dolmen::assess::{AssessError, ChangeNote};
use dolmen::blocks::BlocksError;
use dolmen::modal::{ModalError, Note};
use dolmen::signal::{ChannelFault, SignalError};
use dolmen::validation::ValidationError;
use std::error::Error;
use std::fmt::Display;

/// An error or note of the science of which a project file or the command can do something.
pub trait Advice: Display {
    /// What to do, with the punctuation that joins it to the sentence; `None` where the sentence says all.
    fn advice(&self) -> Option<String>;

    /// The sentence with its advice.
    fn advised(&self) -> String {
        match self.advice() {
            Some(advice) => format!("{self}{advice}"),
            None => self.to_string(),
        }
    }
}

/// The advice on an error of the science, whichever it is; `None` for any other error.
pub fn advice(error: &(dyn Error + 'static)) -> Option<String> {
    fn of<E: Advice + Error + 'static>(error: &(dyn Error + 'static)) -> Option<String> {
        error.downcast_ref::<E>()?.advice()
    }
    of::<SignalError>(error)
        .or_else(|| of::<ModalError>(error))
        .or_else(|| of::<BlocksError>(error))
        .or_else(|| of::<AssessError>(error))
        .or_else(|| of::<ValidationError>(error))
}

fn says(text: &str) -> Option<String> {
    Some(text.to_owned())
}

impl Advice for SignalError {
    fn advice(&self) -> Option<String> {
        match self {
            Self::NoStart { .. } => {
                says(": give its begins, or starts = \"together\" if all began at one instant")
            }
            _ => None,
        }
    }
}

impl Advice for ModalError {
    fn advice(&self) -> Option<String> {
        match self {
            Self::SeveralBlows { .. } => {
                says(" (conditioning = { cut = { from_s = …, to_s = … } }), a part a record")
            }
            Self::ClippedDecay { .. } => says(" (conditioning = { cut = { from_s = …, to_s = … } })"),
            Self::Setups { .. } => says(": write one record as records"),
            Self::NoCommonReference { .. } => says(": merge = \"poser\" needs one with the setups before"),
            Self::SetupRate { .. } => {
                says("; decimate_factor in conditioning gives it, or take merge = \"poser\"")
            }
            Self::Channel(fault) => fault.advice(),
            Self::Record(why) => why.advice(),
            _ => None,
        }
    }
}

impl Advice for BlocksError {
    fn advice(&self) -> Option<String> {
        match self {
            Self::NoRest { .. } => says(". `dolmen check` says which joint cannot carry it"),
            Self::TooLong { .. } => says(
                ": shorten the run, take longer steps or softer joints, or give --yes to `dolmen simulate`",
            ),
            _ => None,
        }
    }
}

impl Advice for AssessError {
    fn advice(&self) -> Option<String> {
        match self {
            Self::NothingToCompare { .. } => says(": give it frequencies, modes or records"),
            Self::OutsideTraining { .. } => says(" (`dolmen study`, --extrapolate)"),
            Self::Modal(why) => why.advice(),
            _ => None,
        }
    }
}

impl Advice for ValidationError {
    fn advice(&self) -> Option<String> {
        match self {
            Self::Signal(why) => why.advice(),
            Self::Modal(why) => why.advice(),
            Self::Blocks(why) => why.advice(),
            Self::Assess(why) => why.advice(),
            _ => None,
        }
    }
}

impl Advice for ChannelFault {
    fn advice(&self) -> Option<String> {
        match self {
            Self::Drifts { .. } => says("; detrend_degree = 1 does so"),
            Self::Constant { .. }
            | Self::Faint { .. }
            | Self::Stuck { .. }
            | Self::Faded { .. }
            | Self::Alike { .. }
            | Self::Spikes { .. }
            | Self::Clipped { .. }
            | Self::Duplicated { .. } => None,
        }
    }
}

impl Advice for Note {
    fn advice(&self) -> Option<String> {
        match self {
            Self::Channel(fault) => fault.advice(),
            Self::FilteredAbove { .. } => says("; lower decimate_factor to see more"),
            Self::ClockDrift { .. } => says(
                "; give the station of each the rate in brackets as its sampling_rate, and they are in them",
            ),
            Self::LateClocks { .. } => says(
                "; add the delay to the begins of the station of each (a channel among others of one file: as a station of its own), and they are in \
                 them",
            ),
            Self::BlockRowsBounded { .. }
            | Self::FewBlocks { .. }
            | Self::Tones { .. }
            | Self::Narrow { .. }
            | Self::TonesOnModes { .. }
            | Self::Harmonics { .. }
            | Self::NoDamping { .. }
            | Self::ClosePairs { .. }
            | Self::Blends { .. }
            | Self::NotFitted { .. }
            | Self::FromPeaks { .. }
            | Self::HiddenPairs { .. }
            | Self::PeaksWithoutMode { .. }
            | Self::NotPicked { .. }
            | Self::OneQuantity { .. }
            | Self::StandsStill { .. }
            | Self::PhaseOff { .. }
            | Self::FewCycles { .. } => None,
        }
    }
}

impl Advice for ChangeNote {
    fn advice(&self) -> Option<String> {
        match self {
            Self::Swapped(_) => {
                says("; if they were, exchange their names in the project file and compare again")
            }
            Self::Turned(_) => {
                says("; if it was, turn its direction round in the project file and compare again")
            }
            Self::NotFitted { .. }
            | Self::BeyondTheLine { .. }
            | Self::LineScatters { .. }
            | Self::LineWithTime { .. }
            | Self::OtherShapes { .. }
            | Self::OneFactor { .. } => None,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_advice_follows_the_sentence_and_is_found_within_other_errors() {
        let blows = || ModalError::SeveralBlows { times_s: vec![11.0] };
        let said = blows().advised();
        assert!(
            said.ends_with(
                "before the next (conditioning = { cut = { from_s = …, to_s = … } }), a part a record"
            ),
            "{said}"
        );
        assert_eq!(advice(&AssessError::Modal(blows())), blows().advice());
        assert_eq!(
            advice(&AssessError::Scale { given: 0.0 }),
            None,
            "the sentence says all"
        );
        assert_eq!(advice(&std::fmt::Error), None);
    }
}
