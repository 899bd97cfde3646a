//! Parts of a structure by name.

use crate::building::floor_words;
use dolmen_words::{Sentence, messages};
use dolmen_work::part_limit::{Part, PartLimit};

messages! {
    /// Parts by name.
    pub(crate) enum Parts in "limits.parts" {
        Storey(name: String) => { en: "storey ‘{name}’", ko: "‘{name}’ 층" },
        BelowFloor(floor: Sentence) => { en: "the storey below floor {floor}", ko: "{floor} 바닥 아래층" },
        JointBelow(name: String) => { en: "the joint below ‘{name}’", ko: "‘{name}’ 하부 접합면" },
        Damper(name: String) => { en: "damper {name}", ko: "감쇠기 {name}" },
        Along { part: Sentence, direction: String } => { en: "{part} (direction {direction})", ko: "{part}({direction} 방향)" },
    }
}

/// The part alone.
pub(crate) fn part_words(part: &Part) -> Sentence {
    match part {
        Part::Storey(name) => Parts::Storey(name.clone()).into(),
        Part::BelowFloor(name) => Parts::BelowFloor(floor_words(name)).into(),
        Part::JointBelow(name) => Parts::JointBelow(name.clone()).into(),
        Part::Damper(name) => Parts::Damper(name.clone()).into(),
    }
}

/// The part and its direction.
pub(super) fn where_words(of: &PartLimit) -> Sentence {
    let part = part_words(&of.part);
    match &of.direction {
        None => part,
        Some(direction) => Parts::Along {
            part,
            direction: direction.clone(),
        }
        .into(),
    }
}
