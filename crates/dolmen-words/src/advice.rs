//! Advice on errors and notes of the library: what to do in the project file or with the command. The library knows neither,
//! so the caller that prints adds the advice.

use crate::message::{Argument, Both};
use crate::{Sentence, messages};
use dolmen::assess::{AssessError, ChangeNote};
use dolmen::blocks::BlocksError;
use dolmen::comparisons::ValidationError;
use dolmen::modal::{ModalError, Note};
use dolmen::signal::{ChannelFault, SignalError};
use std::error::Error;
use std::fmt::Display;

messages! {
    /// What to do, with the punctuation that joins it to the sentence before.
    pub(crate) enum Advised in "science.advice" {
        GiveBegins => {
            en: ": give its begins, or starts = \"together\" if all began at one instant",
            ko: ". begins를 입력하거나, 모두 같은 순간에 시작했으면 starts = \"together\"로 한다",
        },
        CutParts => {
            en: " (conditioning = {{ cut = {{ from_s = …, to_s = … }} }}), a part a record",
            ko: "(conditioning = {{ cut = {{ from_s = …, to_s = … }} }}, 부분마다 기록 하나)",
        },
        Cut => {
            en: " (conditioning = {{ cut = {{ from_s = …, to_s = … }} }})",
            ko: "(conditioning = {{ cut = {{ from_s = …, to_s = … }} }}로 자른다)",
        },
        WriteRecords => { en: ": write one record as records", ko: ". 기록이 하나이면 records로 쓴다" },
        PoserNeedsOne => {
            en: ": merge = \"poser\" needs one with the setups before",
            ko: ". merge = \"poser\"이면 앞의 측정 배치와 공통인 센서가 하나 있으면 된다",
        },
        OneRate => {
            en: "; decimate_factor in conditioning gives it, or take merge = \"poser\"",
            ko: ". conditioning의 decimate_factor로 맞추거나 merge = \"poser\"로 한다",
        },
        CheckSays => {
            en: ". `dolmen check` says which joint cannot carry it",
            ko: ". 어느 접합면이 견디지 못하는지는 `dolmen check`로 본다",
        },
        ShortenRun => {
            en: ": shorten the run, take longer steps or softer joints, or give --yes to `dolmen simulate`",
            ko: ". 해석 시간을 줄이거나, 시간 간격을 키우거나, 접합면을 무르게 하거나, `dolmen simulate`에 --yes를 준다",
        },
        GiveModes => {
            en: ": give it frequencies, modes or records",
            ko: ". frequencies, modes 또는 records를 입력한다",
        },
        Extrapolate => { en: " (--extrapolate of `dolmen rank` or `dolmen score`)", ko: "(`dolmen rank`나 `dolmen score`의 --extrapolate)" },
        Detrend => { en: "; detrend_degree = 1 does so", ko: "(detrend_degree = 1로 한다)" },
        LowerDecimation => {
            en: "; lower decimate_factor to see more",
            ko: ". 더 보려면 decimate_factor를 낮춘다",
        },
        GiveRates => {
            en: "; give the station of each the rate in brackets as its sampling_rate, and they are in them",
            ko: ". 각 station의 sampling_rate에 괄호 안의 주파수를 입력하면 함께 분석된다",
        },
        AddDelays => {
            en: "; add the delay to the begins of the station of each (a channel among others of one file: as a station of its own), and they are in them",
            ko: ". 각 station의 begins에 지연을 더하면(한 파일의 채널이면 별도의 station으로) 함께 분석된다",
        },
        Accept => {
            en: "; if you know one to be a mode, accept = [its frequency in Hz] in the modal table of the record takes it, marked as accepted by you",
            ko: ". 모드임이 확실하면 기록의 modal 항목에 accept = [진동수(Hz)]를 쓴다. 사용자가 채택한 모드로 표시된다",
        },
        ExchangeNames => {
            en: "; if they were, exchange their names in the project file and compare again",
            ko: ". 그렇다면 프로젝트 파일에서 이름을 서로 바꾸고 다시 비교한다",
        },
        TurnRound => {
            en: "; if it was, turn its direction round in the project file and compare again",
            ko: ". 그렇다면 프로젝트 파일에서 방향을 뒤집고 다시 비교한다",
        },
    }
}

/// Templates of all advice.
pub const ADVICE: &[crate::Template] = Advised::TEMPLATES;

/// An error or note of the library that a change of the project file or the command may resolve.
pub trait Advice: Display {
    /// The advice, with the punctuation before it; `None` if the sentence needs none.
    fn advice(&self) -> Option<Both>;

    /// The sentence with its advice.
    fn advised(&self) -> String {
        let advice = self.advice().map_or_else(String::new, |advice| advice.english);
        format!("{self}{advice}")
    }

    /// The sentence with its advice, in both languages.
    fn advised_both(&self) -> Both
    where
        Self: Argument,
    {
        let own = Both::from(Sentence::of_argument(self));
        match self.advice() {
            Some(advice) => Both {
                english: own.english + &advice.english,
                korean: own.korean + &advice.korean,
            },
            None => own,
        }
    }
}

/// The advice on any error of the library; `None` for other errors.
pub fn advice(error: &(dyn Error + 'static)) -> Option<Both> {
    fn of<E: Advice + Error + 'static>(error: &(dyn Error + 'static)) -> Option<Both> {
        error.downcast_ref::<E>()?.advice()
    }
    of::<SignalError>(error)
        .or_else(|| of::<ModalError>(error))
        .or_else(|| of::<BlocksError>(error))
        .or_else(|| of::<AssessError>(error))
        .or_else(|| of::<ValidationError>(error))
}

fn says(advice: Advised) -> Option<Both> {
    Some(advice.into())
}

impl Advice for SignalError {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::NoStart { .. } => says(Advised::GiveBegins),
            _ => None,
        }
    }
}

impl Advice for ModalError {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::SeveralBlows { .. } => says(Advised::CutParts),
            Self::ClippedDecay { .. } => says(Advised::Cut),
            Self::Setups { .. } => says(Advised::WriteRecords),
            Self::NoCommonReference { .. } => says(Advised::PoserNeedsOne),
            Self::SetupRate { .. } => says(Advised::OneRate),
            Self::Channel(fault) => fault.advice(),
            Self::Record(why) => why.advice(),
            _ => None,
        }
    }
}

impl Advice for BlocksError {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::NoRest { .. } => says(Advised::CheckSays),
            Self::TooLong { .. } => says(Advised::ShortenRun),
            _ => None,
        }
    }
}

impl Advice for AssessError {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::NothingToCompare { .. } => says(Advised::GiveModes),
            Self::OutsideTraining { .. } => says(Advised::Extrapolate),
            Self::Modal(why) => why.advice(),
            _ => None,
        }
    }
}

impl Advice for ValidationError {
    fn advice(&self) -> Option<Both> {
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
    fn advice(&self) -> Option<Both> {
        match self {
            Self::Drifts { .. } => says(Advised::Detrend),
            Self::Constant { .. }
            | Self::Faint { .. }
            | Self::Stuck { .. }
            | Self::Faded { .. }
            | Self::Loose { .. }
            | Self::Alike { .. }
            | Self::Spikes { .. }
            | Self::Clipped { .. }
            | Self::Duplicated { .. } => None,
        }
    }
}

impl Advice for Note {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::Channel(fault) | Self::LeftOut(fault) => fault.advice(),
            Self::FilteredAbove { .. } => says(Advised::LowerDecimation),
            Self::ClockDrift { .. } => says(Advised::GiveRates),
            Self::LateClocks { .. } | Self::EitherLate { .. } => says(Advised::AddDelays),
            Self::InSpells { .. }
            | Self::Comb { .. }
            | Self::Clipping { .. }
            | Self::Narrow { .. }
            | Self::Wandering { removed: true, .. } => says(Advised::Accept),
            Self::PeaksWithoutMode { peaks } if peaks.iter().any(|of| of.refusal.is_some()) => {
                says(Advised::Accept)
            }
            Self::BlockRowsBounded { .. }
            | Self::FewBlocks { .. }
            | Self::Tones { .. }
            | Self::TonesOnModes { .. }
            | Self::Harmonics { .. }
            | Self::Wandering { .. }
            | Self::LightModes { .. }
            | Self::NoDamping { .. }
            | Self::ClosePairs { .. }
            | Self::Blends { .. }
            | Self::InValleys { .. }
            | Self::NotFitted { .. }
            | Self::FromPeaks { .. }
            | Self::HiddenPairs { .. }
            | Self::Accepted { .. }
            | Self::AcceptedAlready { .. }
            | Self::NothingToAccept { .. }
            | Self::PeaksWithoutMode { .. }
            | Self::NotPicked { .. }
            | Self::OneQuantity { .. }
            | Self::QuarterTurn { .. }
            | Self::EitherTurned { .. }
            | Self::StandsStill { .. }
            | Self::PhaseOff { .. }
            | Self::FewCycles { .. } => None,
        }
    }
}

impl Advice for ChangeNote {
    fn advice(&self) -> Option<Both> {
        match self {
            Self::Swapped(_) => says(Advised::ExchangeNames),
            Self::Turned(_) => says(Advised::TurnRound),
            Self::NotFitted { .. }
            | Self::BeyondTheLine { .. }
            | Self::LineScatters { .. }
            | Self::LineWithTime { .. }
            | Self::OtherShapes { .. }
            | Self::DirectionsExchanged(_)
            | Self::RateRatio { .. }
            | Self::Reciprocals { .. }
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
