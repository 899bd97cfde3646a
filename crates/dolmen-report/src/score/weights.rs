//! The weights of the factors.

use super::words::{Words, factor_cell, state_column, state_name};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{Factor, FactorShare};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::score::ScoreQuality;

messages! {
    /// Weights.
    pub(crate) enum Weights in "score.weights" {
        Caption { designs: usize } => {
            en: "Weights: Shapley shares of what {designs} simulated pagodas differ by in ln of their capacity, %; 90 % intervals.",
            ko: "가중치: 시뮬레이션한 석탑 {designs}기의 저항능력 자연로그 차이에 대한 섀플리 기여율(%)과 90 % 구간.",
        },
        BriefCaption { designs: usize } => {
            en: "Weights: Shapley shares of what {designs} simulated pagodas differ by.",
            ko: "가중치: 시뮬레이션한 석탑 {designs}기의 차이에 대한 섀플리 기여율.",
        },
        All => { en: "all, of designs left out", ko: "전체(학습에서 뺀 석탑 기준)" },
        Designs { each: Vec<Sentence> } => {
            en: "Designs with a curve: {each}.",
            ko: "취약도 곡선이 있는 석탑 수: {each}.",
        },
        Count { state: Both, count: usize } => { en: "{state} {count}", ko: "{state} {count}기" },
        Together { correlation: Quantity } => {
            en: "tan α and λ go together (correlation {correlation}): their shares hold what they tell together, half each.",
            ko: "tan α와 λ는 상관이 크며(상관계수 {correlation}), 공통으로 설명하는 부분은 두 인자에 절반씩 나누었다.",
        },
    }
}

/// The weights with their intervals and notes.
pub(super) fn section(document: &mut Document<'_>, qualities: &[ScoreQuality], designs: usize) {
    document.put(Block::Table(table(qualities, designs, true)));
    let count = |one: &ScoreQuality| Weights::Count {
        state: state_name(one.state),
        count: one.designs,
    };
    let each = qualities.iter().map(|one| Sentence::from(count(one)));
    document.note(Weights::Designs { each: each.collect() });
    if let Some(one) = qualities.first() {
        let correlation = Quantity::new(one.slenderness_correlation, Unit::ratio(), Digits::Fixed(2));
        document.note(Weights::Together { correlation });
    }
}

/// One row per factor, one column per state.
pub(super) fn table(qualities: &[ScoreQuality], designs: usize, has_intervals: bool) -> Table {
    let mut columns = vec![Column::words(Words::FactorHead)];
    columns.extend(
        qualities
            .iter()
            .map(|one| state_column(one.state, Unit::percent())),
    );
    let row = |(at, factor): (usize, Factor)| {
        let mut cells = vec![factor_cell(factor)];
        cells.extend(qualities.iter().map(|one| {
            let share = &one.shares.shares[at];
            match has_intervals {
                true => within(share),
                false => Cell::number(Quantity::percent(share.share, 2)),
            }
        }));
        cells
    };
    let mut rows: Vec<Vec<Cell>> = Factor::ALL.into_iter().enumerate().map(row).collect();
    let mut all = vec![Cell::words(Weights::All)];
    let explained = qualities.iter().map(|one| one.shares.explained);
    all.extend(explained.map(|share| Cell::number(Quantity::percent(share, 2))));
    rows.push(all);
    let caption = match has_intervals {
        true => Weights::Caption { designs },
        false => Weights::BriefCaption { designs },
    };
    Table {
        caption: vec![caption.into()],
        columns,
        rows,
    }
}

fn within(share: &FactorShare) -> Cell {
    let bare = |share: f64| Quantity::ratio(100.0 * share, 2);
    Cell::words(Words::Within {
        value: bare(share.share),
        lower: bare(share.interval.lower),
        upper: bare(share.interval.upper),
    })
}
