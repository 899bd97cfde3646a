//! Finding on a history without damping.

use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, messages};
use dolmen_work::Undamped;

messages! {
    /// Histories without damping.
    pub(crate) enum NoDamping in "simulated.undamped" {
        Zero => {
            en: "Without damping: no damping ratio is given, and 0 % was taken, so that it swings more and longer than it would. «Give damping_ratio; stone|Stone» poles and timber frames have 1 to 5 %.",
            ko: "무감쇠 해석: 감쇠비가 주어지지 않아 0 %로 계산하였으므로 실제보다 크고 오래 흔들린다. «damping_ratio를 준다. »석조 당간과 목조 골조는 1~5 %이다.",
        },
        Identified { survey: String, ratio: Quantity } => {
            en: "Without damping: no damping ratio is given, and 0 % was taken, so that it swings more and longer than it would. Survey {survey} identified {ratio}.« Write damping_ratio = \"{ratio}\".»",
            ko: "무감쇠 해석: 감쇠비가 주어지지 않아 0 %로 계산하였으므로 실제보다 크고 오래 흔들린다. {survey} 조사의 감쇠비는 {ratio}이다.« damping_ratio = \"{ratio}\"로 준다.»",
        },
    }
}

/// The finding; `None` if it was damped.
pub(crate) fn undamped(of: Option<&Undamped>) -> Option<Finding> {
    let said = match &of?.identified {
        None => NoDamping::Zero,
        Some(identified) => NoDamping::Identified {
            survey: identified.survey.clone(),
            ratio: Quantity::percent(identified.damping_ratio, 2),
        },
    };
    Some(Finding::key(Tone::Warn, said))
}
