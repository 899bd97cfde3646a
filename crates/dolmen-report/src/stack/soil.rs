//! Effect of the soil under a stack.

use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, messages};
use dolmen_work::state::StackAnswer;

/// Fraction of the rocking stiffness lost to gravity from which it is a warning. Our choice.
const TAKES_MUCH: f64 = 0.1;
/// Digits of the stiffness and of the fraction.
const DIGITS: usize = 3;

messages! {
    /// A stack on soil.
    pub(crate) enum OnSoil in "stack.soil" {
        Takes { soil: Quantity, takes: Quantity } => {
            en: "The footing rocks on the soil with {soil}: as it turns, gravity takes {takes} of every acceleration below. The modes hold the soil's stiffness, not what gravity takes of it.",
            ko: "기초는 지반 위에서 회전강성 {soil}(으)로 회전한다. 회전하면 중력 때문에 아래의 모든 한계 가속도가 {takes} 줄어든다. 고유진동수에는 지반강성을 반영하되 중력에 의한 감소는 반영하지 않았다.",
        },
    }
}

/// The reduction of every threshold by the soil, if there is soil.
pub(super) fn finding(answer: &StackAnswer) -> Option<Finding> {
    let below = answer.stack.soil()?;
    let takes = 1.0 - answer.check.limits.soil_factor;
    let said = OnSoil::Takes {
        soil: Quantity::engineering(below.rocking_stiffness_n_m_rad, "N·m/rad", DIGITS),
        takes: Quantity::percent(takes, DIGITS),
    };
    let tone = if takes >= TAKES_MUCH {
        Tone::Warn
    } else {
        Tone::Plain
    };
    Some(Finding::key(tone, said))
}
