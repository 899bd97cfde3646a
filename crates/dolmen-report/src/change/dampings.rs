//! Differences of the damping ratios of two surveys.

use super::frequencies::Frequencies;
use super::quantities::difference;
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{Difference, ModeChange, SurveyChange};
use dolmen::modal::ObservedMode;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Damping ratios of two surveys.
    pub(crate) enum Dampings in "change.dampings" {
        Caption => { en: "Damping ratios, ± standard deviation.", ko: "감쇠비, ± 표준편차." },
        Meaning => {
            en: "Changes are relative. Damping ratios follow the strength of the motion too.",
            ko: "변화는 상대 변화이다. 감쇠비는 진동의 세기에 따라서도 변한다.",
        },
    }
}

/// The table; empty if no damping is known in both.
pub(super) fn section(document: &mut Document<'_>, change: &SurveyChange) {
    let modes = change.modes.iter().enumerate();
    let known = modes.filter_map(|(i, mode)| Some(row(i, mode, mode.damping.as_ref()?)));
    let rows: Vec<Vec<Cell>> = known.collect();
    if rows.is_empty() {
        return;
    }
    let percents = |head: Frequencies| Column::numbers(head, Unit::percent());
    document.put(Block::Table(Table {
        caption: vec![Dampings::Caption.into(), Dampings::Meaning.into()],
        columns: vec![
            Column::words(Frequencies::Mode),
            percents(Frequencies::Before),
            percents(Frequencies::After),
            percents(Frequencies::Change),
            percents(Frequencies::Half),
            Column::numbers(Sentence::of_symbol("p"), Unit::ratio()),
            Column::numbers(Frequencies::ChanceOfAll, Unit::ratio()),
            percents(Frequencies::SeenFrom),
        ],
        rows,
    }));
}

fn row(i: usize, mode: &ModeChange, damping: &Difference) -> Vec<Cell> {
    let mut row = vec![
        Cell::words(Frequencies::Number { number: i + 1 }),
        ratio(&mode.from),
        ratio(&mode.to),
    ];
    row.extend(difference(damping.relative, damping.evidence.as_ref(), 0));
    row
}

fn ratio(mode: &ObservedMode) -> Cell {
    Cell::Number(mode.damping_ratio.map(|ratio| Quantity {
        sd_si: mode.damping_ratio_sd,
        ..Quantity::new(ratio, Unit::percent(), Digits::Significant(4))
    }))
}
