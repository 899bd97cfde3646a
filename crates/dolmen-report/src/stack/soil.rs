//! Effect of the soil under a stack.

use super::words::in_g;
use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, messages};
use dolmen_work::state::StackAnswer;

/// Fraction of the overturning push lost to the soil from which it is a warning. Our choice.
const TAKES_MUCH: f64 = 0.1;
/// Digits of the stiffness and of the fraction.
const DIGITS: usize = 3;

messages! {
    /// A stack on soil.
    pub(crate) enum OnSoil in "stack.soil" {
        Overturns { soil: Quantity, at: Quantity, left: Quantity } => {
            en: "The footing rocks on the soil with {soil} until it lifts off, then ever softer, and overturns at {at}: {left} of what overturns it on rigid ground. All limits below count it, except the local mechanisms by codes. The modes hold the soil's stiffness in full contact.",
            ko: "기초는 지반 위에서 회전강성 {soil}(으)로 회전하다가 들리면 점점 약해져 {at}에서 전도된다. 이는 강체 지반에서 전도되는 값의 {left}이다. 기준에 따른 국부 메커니즘을 제외한 아래의 모든 한계에 이를 반영하였다. 고유진동수에는 전면 접촉 상태의 지반강성을 반영하였다.",
        },
    }
}

/// Where the footing overturns on the soil, if there is soil and it stands.
pub(super) fn finding(answer: &StackAnswer) -> Option<Finding> {
    let below = answer.stack.soil()?;
    let footing = answer.check.limits.footing?;
    let left = footing.factor();
    let said = OnSoil::Overturns {
        soil: Quantity::engineering(below.rocking_stiffness_n_m_rad, "N·m/rad", DIGITS),
        at: in_g(footing.overturns.acceleration_g),
        left: Quantity::percent(left, DIGITS),
    };
    let tone = if left <= 1.0 - TAKES_MUCH {
        Tone::Warn
    } else {
        Tone::Plain
    };
    Some(Finding::key(tone, said))
}
