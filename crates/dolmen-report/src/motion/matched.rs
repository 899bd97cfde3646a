//! Accuracy of a matched motion.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::signal::SpectrumMisfit;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::MatchAnswer;

messages! {
    /// A match.
    pub(crate) enum Matched in "motion.matched" {
        To { demand: String, factor: Quantity, rounds: usize } => {
            en: "Matched to {demand}: seed times {factor}, then {rounds} rounds of wavelets.",
            ko: "{demand}에 부합: 원기록을 {factor}배 한 뒤 웨이블릿을 {rounds}회 더하였다.",
        },
        ToInOneRound { demand: String, factor: Quantity } => {
            en: "Matched to {demand}: seed times {factor}, then 1 round of wavelets.",
            ko: "{demand}에 부합: 원기록을 {factor}배 한 뒤 웨이블릿을 1회 더하였다.",
        },
        Misfit { mean: Quantity, lowest: Quantity, highest: Quantity } => {
            en: "Misfit of the motion {mean} (root mean square), {lowest} to {highest}.",
            ko: "부합 오차는 제곱평균제곱근 {mean}, 최소 {lowest}, 최대 {highest}이다.",
        },
        Caption => {
            en: "Misfit of the spectrum against the demand: negative where it falls short.",
            ko: "목표 스펙트럼에 대한 오차. 음의 값은 목표보다 작음을 뜻한다.",
        },
        Of => { en: "of", ko: "구분" },
        Seed => { en: "the scaled seed", ko: "배율을 적용한 원기록" },
        Motion => { en: "the motion", ko: "부합 후 지반운동" },
        Below { period: Quantity } => { en: "below {period}, not matched", ko: "주기 {period} 미만(부합 제외)" },
        Above { period: Quantity } => { en: "above {period}, not matched", ko: "주기 {period} 초과(부합 제외)" },
        Mean => { en: "root mean square", ko: "제곱평균제곱근" },
        Lowest => { en: "lowest", ko: "최소" },
        Highest => { en: "highest", ko: "최대" },
        Fails { most: Quantity, short: Quantity } => {
            en: "NOT MATCHED: more than {most} off in the mean or {short} short somewhere; take a longer seed, or one of another kind.",
            ko: "부합하지 않음: 평균 오차가 {most}을(를) 넘거나 {short}을(를) 넘게 모자라는 주기가 있다. 더 긴 기록이나 특성이 다른 기록을 사용한다.",
        },
    }
}

/// The target and the method.
pub(super) fn lead(answer: &MatchAnswer) -> Sentence {
    let demand = answer.demand.clone();
    let factor = Quantity::new(answer.matched.factor, Unit::ratio(), Digits::Fixed(3));
    match answer.matched.rounds {
        1 => Matched::ToInOneRound { demand, factor },
        rounds => Matched::To {
            demand,
            factor,
            rounds,
        },
    }
    .into()
}

/// The accuracy.
pub(super) fn nearness(answer: &MatchAnswer) -> Sentence {
    let after = &answer.matched.after;
    Matched::Misfit {
        mean: tenths(after.root_mean_square),
        lowest: tenths(after.lowest),
        highest: tenths(after.highest),
    }
    .into()
}

/// A warning if it is not accurate enough.
pub(super) fn fault(answer: &MatchAnswer) -> Option<Sentence> {
    let said = || Matched::Fails {
        most: Quantity::percent(MatchAnswer::MISFIT_MOST, 2),
        short: Quantity::percent(MatchAnswer::SHORT_MOST, 2),
    };
    (!answer.is_close()).then(|| said().into())
}

/// The match, the misfit before and after, and that outside the matched range.
pub(super) fn section(document: &mut Document<'_>, answer: &MatchAnswer) {
    document.paragraph(lead(answer));
    if let Some(fault) = fault(answer) {
        document.put(Block::Warning(fault));
    }
    let periods_s = &answer.matched.periods_s;
    let [shortest, longest] = [periods_s.first(), periods_s.last()].map(|period_s| {
        let period_s = period_s.copied().unwrap_or(0.0);
        Quantity::new(period_s, Unit::si("s"), Digits::Trimmed(3))
    });
    let [below, above] = &answer.outside;
    let rows = [
        (Matched::Seed, &answer.matched.before),
        (Matched::Motion, &answer.matched.after),
        (Matched::Below { period: shortest }, below),
        (Matched::Above { period: longest }, above),
    ];
    document.put(Block::Table(Table {
        caption: vec![Matched::Caption.into()],
        columns: vec![
            Column::words(Matched::Of),
            Column::numbers(Matched::Mean, Unit::percent()),
            Column::numbers(Matched::Lowest, Unit::percent()),
            Column::numbers(Matched::Highest, Unit::percent()),
        ],
        rows: rows.map(|(of, misfit)| row(of, misfit)).into(),
    }));
}

fn row(of: Matched, misfit: &SpectrumMisfit) -> Vec<Cell> {
    let values = [misfit.root_mean_square, misfit.lowest, misfit.highest];
    let mut cells = vec![Cell::words(of)];
    cells.extend(values.map(|value| Cell::number(tenths(value))));
    cells
}

fn tenths(share: f64) -> Quantity {
    Quantity::new(share, Unit::percent(), Digits::Fixed(1))
}
