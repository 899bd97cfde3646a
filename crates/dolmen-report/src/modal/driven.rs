//! What a measured input shows beside the modes: the same modes with the ground as it gives way, and what follows the input.

use super::tables::nth;
use super::values::{percent, plain};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::modal::{Driven, DrivenMode};
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// Modes above a measured ground.
    pub(crate) enum Drivens in "modal.driven" {
        Taken { inputs: Vec<String>, lags: usize } => {
            en: "The motion of {inputs} is taken as given (observer of {lags} samples): the modes are those of the structure on a base that is held there. What these channels do not measure is not held: on a base that rocks without a sensor for it, the modes are those of the structure that rocks.",
            ko: "{inputs}의 운동을 입력으로 보았다(관측기 차수 {lags}). 따라서 모드는 그 위치의 기초가 고정된 구조물의 것이다. 이 채널이 재지 않는 운동은 고정되지 않는다. 기초의 회전을 재는 센서가 없으면 기초가 회전하는 구조물의 모드이다.",
        },
        Caption => {
            en: "The base held, and as it gives way.",
            ko: "기초를 고정한 경우와 지반과 함께 움직이는 경우.",
        },
        Meaning => {
            en: "Together: the mode of like shape that the record has without regard to the input, structure and ground as one. Follows the input: share of the motion at the frequency of the held base, by coherence; the rest comes from wind, people, traffic and noise.",
            ko: "지반과 함께: 입력을 고려하지 않고 같은 기록에서 찾은, 형상이 닮은 모드(구조물과 지반의 연성계). 입력을 따르는 비율: 고정 기초 고유진동수에서 입력과 상관된 운동의 비율(기여도 함수)이며 나머지는 바람, 사람, 교통, 잡음이다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        Held => { en: "base held", ko: "기초 고정" },
        Together => { en: "together", ko: "지반과 함께" },
        Ratio => { en: "held over together", ko: "고정/연성 비" },
        Follows => { en: "follows the input", ko: "입력을 따르는 비율" },
    }
}

/// What is held, and each mode beside that of structure and ground together.
pub(super) fn section(document: &mut Document<'_>, driven: &Driven) {
    document.paragraph(Drivens::Taken {
        inputs: driven.inputs.clone(),
        lags: driven.lags,
    });
    if driven.modes.is_empty() {
        return;
    }
    document.put(Block::Table(Table {
        caption: vec![Drivens::Caption.into(), Drivens::Meaning.into()],
        columns: vec![
            Column::words(Drivens::Mode),
            Column::numbers(Drivens::Held, Unit::si("Hz")),
            Column::numbers(Drivens::Together, Unit::si("Hz")),
            Column::numbers(Drivens::Ratio, Unit::ratio()),
            Column::numbers(Drivens::Follows, Unit::percent()),
        ],
        rows: driven.modes.iter().enumerate().map(row).collect(),
    }));
}

fn row((at, mode): (usize, &DrivenMode)) -> Vec<Cell> {
    let together = mode.with_base_hz.map(|(hz, sd_si)| Quantity {
        sd_si,
        ..Quantity::new(hz, Unit::si("Hz"), Digits::Significant(5))
    });
    let ratio = mode
        .with_base_hz
        .map(|(hz, _)| plain((mode.frequency_hz / hz * 1e3).round() / 1e3));
    vec![
        nth(at),
        Cell::number(Quantity::new(
            mode.frequency_hz,
            Unit::si("Hz"),
            Digits::Significant(5),
        )),
        Cell::Number(together),
        Cell::Number(ratio),
        Cell::Number(mode.explained.map(|share| percent(share, 0))),
    ]
}
