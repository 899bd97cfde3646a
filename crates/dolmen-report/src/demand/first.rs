//! First failure of a stack on elastic joints.

use crate::stack::place;
use dolmen::assess::demand::ModalRatio;
use dolmen::stability::stack::LimitKind;
use dolmen_words::{Sentence, messages};

messages! {
    /// What gives way first.
    pub(crate) enum First in "demand.first" {
        Tips(below: Sentence) => {
            en: "what stands on {below} tips first",
            ko: "{below} 위의 부분이 먼저 들린다",
        },
        Slides(below: Sentence) => {
            en: "what stands on {below} slides first",
            ko: "{below} 위의 부분이 먼저 미끄러진다",
        },
        Shared => {
            en: "stones that share their load move first, with the largest forces on all at once",
            ko: "모든 돌에 최대 하중이 동시에 작용할 때 하중을 나누어 받는 돌이 먼저 움직인다",
        },
    }
}

/// The first failure.
pub(super) fn first(by_modes: &ModalRatio) -> Sentence {
    let Some((kind, above)) = &by_modes.first else {
        return First::Shared.into();
    };
    let below = place(above);
    match kind {
        LimitKind::Uplift => First::Tips(below),
        LimitKind::Sliding => First::Slides(below),
    }
    .into()
}
