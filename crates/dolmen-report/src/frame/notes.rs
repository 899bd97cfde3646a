//! Probable mistakes in the loads of a frame.

use dolmen::assess::FrameNote;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Mistakes in the loads.
    pub(crate) enum Loads in "frame.loads" {
        NoAxialForce => {
            en: "No axial force is given: P-delta is left out, and nothing can be said of stability.",
            ko: "축력이 주어지지 않아 P-델타 효과를 고려하지 않았으며, 안정성은 판정할 수 없다.",
        },
        LevelLoad { level: usize, ratio: Quantity } => {
            en: "Level {level} loads its storey with {ratio} times the weight of its mass. If the axial forces given already hold the levels above, give them as storey forces, not as level loads: summed twice they overstate P-delta.",
            ko: "제{level}층 바닥이 층에 더하는 하중이 그 질량에 의한 자중의 {ratio}배이다. 기재한 축력에 상부 하중이 이미 누적되어 있다면 층별 하중이 아니라 층 축력(storey)으로 입력해야 한다. 두 번 누적하면 P-델타 효과가 과대평가된다.",
        },
    }
}

/// The sentence of a note.
pub(super) fn load_note(note: &FrameNote) -> Sentence {
    match note {
        FrameNote::NoAxialForce => Loads::NoAxialForce,
        FrameNote::LevelLoad { level, ratio } => Loads::LevelLoad {
            level: *level,
            ratio: Quantity::new(*ratio, Unit::ratio(), Digits::Fixed(2)),
        },
    }
    .into()
}
