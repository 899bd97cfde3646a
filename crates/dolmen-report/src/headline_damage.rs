//! The states of damage of a stack in the words of the headline.

use dolmen_words::{Sentence, Template, messages};

messages! {
    /// States of damage.
    pub(crate) enum HeadlineDamage in "headline.damage" {
        Unmoved => { en: "nothing moved", ko: "거동 없음" },
        Begun => { en: "joints moved, DS1", ko: "접합면 거동 시작, DS1" },
        Offset => { en: "offsets left, DS2", ko: "잔류 어긋남, DS2" },
        Severe => { en: "severe damage, DS3", ko: "심한 손상, DS3" },
        Fallen => { en: "a stone fell, DS4", ko: "낙하, DS4" },
    }
}

/// The sentences as they are written.
pub(crate) const TEMPLATES: &[Template] = HeadlineDamage::TEMPLATES;

/// The words for a state by its number, 0 to 4.
pub(crate) fn damage_state(state: u8) -> Sentence {
    match state {
        0 => HeadlineDamage::Unmoved,
        1 => HeadlineDamage::Begun,
        2 => HeadlineDamage::Offset,
        3 => HeadlineDamage::Severe,
        _ => HeadlineDamage::Fallen,
    }
    .into()
}
