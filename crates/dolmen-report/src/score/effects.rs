//! Effect of each factor alone on the capacity, and the published direction.

use super::words::{Words, factor_cell, factor_value, state_column};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{EffectVerdict, FactorEffect};
use dolmen_words::{Quantity, Sentence, Unit, messages};
use dolmen_work::score::ScoreQuality;

messages! {
    /// Factors alone.
    pub(crate) enum Effects in "score.effects" {
        Caption => {
            en: "One factor alone, from its 10 % to its 90 % quantile in the middle design: change of the capacity, %, and the published direction.",
            ko: "중앙 설계에서 한 인자만 10 % 분위수에서 90 % 분위수로 바꾼 경우: 저항능력의 변화율(%)과 발표된 방향과의 비교.",
        },
        From => { en: "from", ko: "부터" },
        To => { en: "to", ko: "까지" },
        Effect { change: Quantity, verdict: Sentence } => { en: "{change} {verdict}", ko: "{change} {verdict}" },
        Holds => { en: "holds", ko: "부합" },
        Contradicted => { en: "contradicted", ko: "반대" },
        NotSeen => { en: "not seen", ko: "불분명" },
        Together => { en: "λ takes tan α with it.", ko: "λ를 바꾸면 tan α도 함께 바뀐다." },
        Meaning => {
            en: "Published for falls under one motion; contradicted: the other way with 90 % confidence, each by itself: of twenty entries without effect two are called seen.",
            ko: "발표된 방향은 한 지반운동에 의한 낙하에 대한 것이다. ‘반대’는 항목별 90 % 신뢰수준에서 방향이 반대임을 뜻하며, 실제로 효과가 없는 항목도 스무 개 가운데 두 개는 효과가 있는 것으로 나타난다.",
        },
    }
}

/// One row per factor, one column per state.
pub(super) fn section(document: &mut Document<'_>, qualities: &[ScoreQuality]) {
    let Some(first) = qualities.first() else {
        return;
    };
    let mut columns = vec![
        Column::words(Words::FactorHead),
        Column::numbers(Effects::From, Unit::ratio()),
        Column::numbers(Effects::To, Unit::ratio()),
    ];
    columns.extend(qualities.iter().map(|one| state_column(one.state, Unit::ratio())));
    let row = |(at, of): (usize, &FactorEffect)| {
        let mut cells = vec![
            factor_cell(of.factor),
            Cell::number(factor_value(of.factor, of.from)),
            Cell::number(factor_value(of.factor, of.to)),
        ];
        let each = qualities.iter().map(|one| one.effects.get(at));
        cells.extend(each.map(|effect| effect.map_or(Cell::Number(None), effect_cell)));
        cells
    };
    document.put(Block::Table(Table {
        caption: vec![Effects::Caption.into()],
        columns,
        rows: first.effects.iter().enumerate().map(row).collect(),
    }));
    document.note(Effects::Together);
    document.note(Effects::Meaning);
}

fn effect_cell(effect: &FactorEffect) -> Cell {
    let verdict = match effect.verdict {
        EffectVerdict::Holds => Effects::Holds,
        EffectVerdict::Contradicted => Effects::Contradicted,
        EffectVerdict::NotSeen => Effects::NotSeen,
    };
    Cell::words(Effects::Effect {
        change: Quantity::percent(effect.ln_change.exp_m1(), 2),
        verdict: verdict.into(),
    })
}
