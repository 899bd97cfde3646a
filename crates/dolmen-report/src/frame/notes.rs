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
        LevelLoadHigh { level: usize, ratio: Quantity } => {
            en: "Level {level} loads its storey with {ratio} times the weight of its mass, so the load factor is over these forces, not over the weight. Forces that already hold the levels above «belong under axial = \"storey\"|are those of the storey»; as level loads they would be summed twice, and overstate P-delta. Without «axial_force|the axial force» they follow from the masses.",
            ko: "제{level}층 바닥이 층에 더하는 하중이 그 질량에 의한 자중의 {ratio}배이므로, 하중배율은 자중이 아니라 입력한 축력에 대한 값이다. 상부 하중이 이미 누적된 축력은 «axial = \"storey\"|층의 축력으»로 입력한다. 층별 하중으로 입력하면 두 번 누적되어 P-델타 효과가 과대평가된다. «axial_force가|축력이» 없으면 질량에서 구한다.",
        },
        LevelLoadLow { level: usize, ratio: Quantity } => {
            en: "Level {level} loads its storey with only {ratio} times the weight of its mass: P-delta is understated, and the load factor is over these forces, not over the weight. Check «axial_force|the axial force» and its unit; without it the forces follow from the masses.",
            ko: "제{level}층 바닥이 층에 더하는 하중이 그 질량에 의한 자중의 {ratio}배뿐이다. P-델타 효과가 과소평가되며, 하중배율은 자중이 아니라 입력한 축력에 대한 값이다. «axial_force와|축력과» 단위를 확인한다. «axial_force가|축력이» 없으면 질량에서 구한다.",
        },
    }
}

/// The sentence of a note.
pub(super) fn load_note(note: &FrameNote) -> Sentence {
    match note {
        FrameNote::NoAxialForce => Loads::NoAxialForce,
        FrameNote::LevelLoad { level, ratio } => {
            let (level, is_low) = (*level, *ratio < 1.0);
            let ratio = Quantity::new(*ratio, Unit::ratio(), Digits::Fixed(2));
            match is_low {
                true => Loads::LevelLoadLow { level, ratio },
                false => Loads::LevelLoadHigh { level, ratio },
            }
        }
    }
    .into()
}
