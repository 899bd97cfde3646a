//! Dependence of a free decay on amplitude.

use super::decay_remarks::decay_remarks;
use super::values::percent;
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::modal::{AtAmplitude, Decay, ModeDecay};
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// A free decay.
    pub(crate) enum Decays in "modal.decay" {
        Explained { explained: Quantity } => {
            en: "The poles found explain {explained} of the motion.",
            ko: "찾은 극점이 운동의 {explained}을(를) 설명한다.",
        },
        Caption => {
            en: "Frequency and damping by the size of the swings.",
            ko: "진폭에 따른 고유진동수와 감쇠비.",
        },
        Meaning => {
            en: "Logarithmic decrement of the channel that shows most of each mode; loose joints show as a frequency that rises while the swings die.",
            ko: "각 모드가 가장 크게 나타나는 채널의 대수감쇠율이며, 헐거운 접합면은 진폭이 줄면서 진동수가 높아지는 것으로 나타난다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        OfMode { frequency: Quantity } => { en: "{frequency}", ko: "{frequency}" },
        Time => { en: "time", ko: "시각" },
        Size => { en: "size of the swings", ko: "진폭" },
        Frequency => { en: "frequency", ko: "고유진동수" },
        Damping => { en: "damping ratio", ko: "감쇠비" },
        HalfWidth => { en: "± 95 %", ko: "± 95 %" },
    }
}

/// How well linear modes explain the decay, and each mode at its largest, middle and smallest amplitudes.
pub(super) fn section(document: &mut Document<'_>, decay: &Decay) {
    document.paragraph(Decays::Explained {
        explained: percent(decay.explained, 2),
    });
    let rows: Vec<Vec<Cell>> = decay.modes.iter().flat_map(rows_of).collect();
    if !rows.is_empty() {
        document.put(Block::Table(Table {
            caption: vec![Decays::Caption.into(), Decays::Meaning.into()],
            columns: vec![
                Column::words(Decays::Mode),
                Column::numbers(Decays::Time, Unit::si("s")),
                Column::numbers(Decays::Size, Unit::ratio()),
                Column::numbers(Decays::Frequency, Unit::si("Hz")),
                Column::numbers(Decays::Damping, Unit::percent()),
                Column::numbers(Decays::HalfWidth, Unit::percent()),
            ],
            rows,
        }));
    }
    for remark in decay_remarks(decay) {
        document.note(remark);
    }
}

fn rows_of(mode: &ModeDecay) -> Vec<Vec<Cell>> {
    let row = |at: AtAmplitude| {
        let frequency = Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Significant(4));
        let half = at.half_width_95().ok();
        vec![
            Cell::words(Decays::OfMode { frequency }),
            Cell::number(Quantity::new(at.time_s, Unit::si("s"), Digits::Fixed(2))),
            Cell::number(Quantity::ratio(at.amplitude, 4)),
            Cell::number(Quantity::ratio(at.frequency_hz, 5)),
            Cell::number(Quantity::percent(at.damping_ratio, 4)),
            Cell::Number(half.map(|half| Quantity::percent(half, 3))),
        ]
    };
    shown(&mode.swings).into_iter().map(row).collect()
}

/// The largest, the middle and the smallest.
fn shown(swings: &[AtAmplitude]) -> Vec<AtAmplitude> {
    let mut places = vec![0, swings.len() / 2, swings.len().saturating_sub(1)];
    places.dedup();
    let shown = places.into_iter().filter_map(|at| swings.get(at).copied());
    shown.collect()
}
