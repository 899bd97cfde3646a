//! The sections of a ranking.

use super::{remarks, table};
use crate::document::{Block, Document, Figure, table_series};
use crate::figures::ranking;
use dolmen_words::messages;
use dolmen_work::portfolio::PortfolioAnswer;

messages! {
    /// Heads and method of a ranking.
    pub(crate) enum Rank in "rank" {
        FigureCaption => {
            en: "Capacities with 90 % of what is not known, the worst on top.",
            ko: "저항능력과 90 % 불확실 구간, 위쪽이 가장 취약.",
        },
        How => { en: "How", ko: "방법" },
        Basis(designs: usize) => {
            en: "A structure rests on its own study where it has one, else on the six-factor score, trained on {designs} simulated pagodas.",
            ko: "개별 해석이 있는 구조물은 그 결과를, 없는 구조물은 석탑 {designs}기의 해석으로 학습한 여섯 인자 점수를 근거로 한다.",
        },
        Intervals(draws: usize) => {
            en: "Places have intervals from {draws} draws of what is not known of each capacity, independent from structure to structure.",
            ko: "순위 구간은 각 저항능력의 불확실성을 서로 독립으로 {draws}회 추출하여 구하였다.",
        },
        Bounds => {
            en: "Where a bound stands in place of a capacity, the structure is ranked at the bound; its interval is open on the side that is not known, and its rate is a bound too.",
            ko: "저항능력 대신 한계값만 아는 구조물은 그 값으로 순위를 매긴다. 순위 구간은 알 수 없는 쪽으로 열려 있으며 초과율도 한계값이다.",
        },
        NoProof => {
            en: "The score puts pagodas into order; it is no proof that one stands.",
            ko: "점수는 석탑의 우선순위를 정하는 데 쓸 뿐, 안전성을 보증하지 않는다.",
        },
    }
}

/// The ranking, its warnings, and its basis.
pub(crate) fn sections(answer: &PortfolioAnswer) -> Document<'_> {
    let mut document = Document::default();
    remarks::before(&mut document, answer);
    let drawn = Figure::drawn(vec![Rank::FigureCaption.into()], |language| {
        ranking(answer, language)
    });
    document.charted(drawn.with_series(|| table_series(&table::table(answer, false))));
    table::section(&mut document, answer);
    remarks::left_out(&mut document, answer);
    document.heading(Rank::How);
    let basis = Rank::Basis(answer.designs);
    let intervals = Rank::Intervals(answer.draws);
    let method = [basis, intervals, Rank::Bounds, Rank::NoProof];
    document.put(Block::Paragraph(method.map(Into::into).into()));
    document
}
