//! The spectral demand on a structure without a computed capacity.

use super::words::{gravities, in_g};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::SpectralAt;

/// Digits of periods, accelerations and damping.
const DIGITS: usize = 4;

messages! {
    /// The spectrum at the first periods.
    pub(crate) enum Periods in "demand.periods" {
        Caption => { en: "The spectrum at the first periods.", ko: "1차 주기에서의 응답스펙트럼." },
        CaptionMeaning => {
            en: "S_a is the spectral acceleration at the first period T1 of that direction and this damping.",
            ko: "S_a는 해당 방향의 1차 주기 T1과 감쇠비에 대한 응답 가속도이다.",
        },
        Direction => { en: "Direction", ko: "방향" },
        Named(name: String) => { en: "{name}", ko: "{name}" },
        Any => { en: "all", ko: "모든 방향" },
        Damping => { en: "damping", ko: "감쇠비" },
    }
}

/// One row per direction with a known period.
pub(super) fn section(document: &mut Document<'_>, spectral: &[SpectralAt]) {
    if spectral.is_empty() {
        return;
    }
    document.put(Block::Table(Table {
        caption: vec![Periods::Caption.into(), Periods::CaptionMeaning.into()],
        columns: vec![
            Column::words(Periods::Direction),
            Column::numbers(Sentence::of_symbol("T1"), Unit::si("s")),
            Column::numbers(Periods::Damping, Unit::percent()),
            Column::numbers(Sentence::of_symbol("S_a"), gravities()),
        ],
        rows: spectral.iter().map(row).collect(),
    }));
}

fn row(at: &SpectralAt) -> Vec<Cell> {
    let digits = Digits::Significant(DIGITS);
    let direction = match at.direction.as_str() {
        "all" => Periods::Any,
        name => Periods::Named(name.to_owned()),
    };
    vec![
        Cell::words(direction),
        Cell::number(Quantity::new(at.period_s, Unit::si("s"), digits)),
        Cell::number(Quantity::new(
            at.damping_ratio,
            Unit::percent(),
            Digits::Trimmed(DIGITS),
        )),
        Cell::number(in_g(at.acceleration_m_s2, digits)),
    ]
}
