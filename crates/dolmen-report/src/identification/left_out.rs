//! Why a mode of a record is not used for the stiffness.

use dolmen::structure::LeftOut;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Modes left out.
    pub(crate) enum ModeLeftOut in "identification.left-out" {
        OtherDirection { frequency: Quantity, share: Quantity, needed: Quantity } => {
            en: "The mode at {frequency} is left out: only {share} of its motion is in this direction, {needed} are needed.",
            ko: "{frequency} 모드는 제외하였다. 이 방향의 운동 성분이 {share}에 불과하다({needed} 필요).",
        },
        Twists { frequency: Quantity, height: Quantity, difference: Quantity } => {
            en: "The mode at {frequency} is left out: at {height} its sensors differ by {difference} of the largest, so it twists.",
            ko: "{frequency} 모드는 제외하였다. 높이 {height}의 센서들이 최대 변위의 {difference}만큼 서로 달라 비틀림 모드로 본다.",
        },
        Doubtful { frequency: Quantity, above: usize } => {
            en: "The mode at {frequency} is left out: the setups may not show one mode there. Modes above it that are left out too, since a fit counts modes from the lowest: {above}.",
            ko: "{frequency} 모드는 제외하였다. 측정 배치들이 같은 모드를 보인다고 단정할 수 없다. 가장 낮은 모드부터 세어 맞추므로 그 위의 모드 {above}개도 제외하였다.",
        },
        Turns(frequency: Quantity) => {
            en: "The mode at {frequency} is left out: its sensors turn about the vertical axis through the origin, as in torsion, and without it the direction has as many modes as the model.",
            ko: "{frequency} 모드는 제외하였다. 센서의 움직임이 원점을 지나는 연직축에 대한 회전이므로 비틀림 모드로 보며, 이를 빼면 이 방향의 모드 수가 모델과 같다.",
        },
        Beyond { frequency: Quantity, modes: usize } => {
            en: "The mode at {frequency} moves along this direction and is left out: the model has only {modes} there.",
            ko: "{frequency} 모드도 이 방향으로 움직이나 제외하였다. 모델은 이 방향에 모드가 {modes}개뿐이다.",
        },
    }
}

/// The sentence of a mode left out.
pub(super) fn left_out(why: &LeftOut) -> Sentence {
    let hertz = |value: f64| Quantity::new(value, Unit::si("Hz"), Digits::Fixed(3));
    let percent = |share: f64| Quantity::new(share, Unit::percent(), Digits::Fixed(0));
    match why {
        LeftOut::OtherDirection { frequency_hz, share } => ModeLeftOut::OtherDirection {
            frequency: hertz(*frequency_hz),
            share: percent(*share),
            needed: percent(LeftOut::SHARE_LEAST),
        },
        LeftOut::Twists {
            frequency_hz,
            height_m,
            difference,
        } => ModeLeftOut::Twists {
            frequency: hertz(*frequency_hz),
            height: Quantity::new(*height_m, Unit::si("m"), Digits::Fixed(2)),
            difference: percent(*difference),
        },
        LeftOut::Doubtful { frequency_hz, above } => ModeLeftOut::Doubtful {
            frequency: hertz(*frequency_hz),
            above: *above,
        },
        LeftOut::Turns { frequency_hz } => ModeLeftOut::Turns(hertz(*frequency_hz)),
        LeftOut::Beyond { frequency_hz, modes } => ModeLeftOut::Beyond {
            frequency: hertz(*frequency_hz),
            modes: *modes,
        },
    }
    .into()
}
