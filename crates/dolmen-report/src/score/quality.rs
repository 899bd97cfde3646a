//! Accuracy of the score: weights, directions, and the order of designs that it was not trained on.

use super::words::{Words, state_cell, state_name};
use super::{effects, weights};
use crate::brief_rows::BriefText;
use crate::document::{Block, Cell, Column, Document, Table, TextStyle, document_text, heading_text};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::score::ScoreQuality;

messages! {
    /// Accuracy of the order given by a score.
    pub(crate) enum Quality in "score.quality" {
        Head => { en: "What the six-factor score is worth", ko: "여섯 인자 점수의 신뢰도" },
        Order { parts: usize } => {
            en: "Order of designs that were not seen, in {parts} parts: Kendall's τ, and share of the worst fifth found.",
            ko: "학습에 쓰지 않은 석탑의 순서({parts}개 부분으로 교차 검증): 켄달 τ와 최하위 20 % 검출 비율.",
        },
        By => { en: "by", ko: "기준" },
        Tau => { en: "τ", ko: "τ" },
        WorstFifth => { en: "worst fifth", ko: "최하위 20 %" },
        Score => { en: "the score", ko: "점수" },
        EqualWeights => { en: "equal weights", ko: "동일 가중치" },
        SlendernessAngle => { en: "tan α alone", ko: "tan α만" },
        OrderBrief { score: Vec<Sentence>, equal: Vec<Sentence> } => {
            en: "Order of designs that were not seen, Kendall's τ: {score} by the score; {equal} by equal weights.",
            ko: "학습에 쓰지 않은 석탑의 순서(켄달 τ): 점수 {score}, 동일 가중치 {equal}.",
        },
        TauOf { state: Both, tau: Quantity } => { en: "{state} {tau}", ko: "{state} {tau}" },
    }
}

/// Weights of the factors, and how well the score orders designs that it was not trained on.
pub fn score_quality_text(qualities: &[ScoreQuality], designs: usize, style: TextStyle) -> String {
    let head = heading_text(&Sentence::from(Quality::Head).text(style.language));
    match style.is_full {
        true => head + &document_text(&sections(qualities, designs), style),
        false => head + &brief(qualities, designs, style),
    }
}

fn sections(qualities: &[ScoreQuality], designs: usize) -> Document<'static> {
    let mut document = Document::default();
    weights::section(&mut document, qualities, designs);
    effects::section(&mut document, qualities);
    document.put(Block::Table(order(qualities)));
    document
}

fn brief(qualities: &[ScoreQuality], designs: usize, style: TextStyle) -> String {
    let mut brief = BriefText::new(style);
    let taus = |tau: fn(&ScoreQuality) -> f64| -> Vec<Sentence> {
        let each = qualities.iter().map(|one| Quality::TauOf {
            state: state_name(one.state),
            tau: hundredths(tau(one)),
        });
        each.map(Sentence::from).collect()
    };
    let said = Quality::OrderBrief {
        score: taus(|one| one.held_out.score.kendall_tau),
        equal: taus(|one| one.held_out.equal_weights.kendall_tau),
    };
    brief.block(Block::Paragraph(vec![said.into()]));
    let weights = weights::table(qualities, designs, false);
    brief.table(&weights, weights.rows.len());
    brief.finish()
}

fn order(qualities: &[ScoreQuality]) -> Table {
    let rows = qualities.iter().flat_map(|one| {
        let held = &one.held_out;
        let rankings = [
            (Quality::Score, held.score),
            (Quality::EqualWeights, held.equal_weights),
            (Quality::SlendernessAngle, held.slenderness_angle),
        ];
        rankings.map(|(by, ranking)| {
            vec![
                state_cell(one.state),
                Cell::words(by),
                Cell::number(hundredths(ranking.kendall_tau)),
                Cell::number(hundredths(ranking.worst_fifth_found)),
            ]
        })
    });
    let parts = qualities.first().map_or(0, |one| one.held_out.parts);
    Table {
        caption: vec![Quality::Order { parts }.into()],
        columns: vec![
            Column::words(Words::StateHead),
            Column::words(Quality::By),
            Column::numbers(Quality::Tau, Unit::ratio()),
            Column::numbers(Quality::WorstFifth, Unit::ratio()),
        ],
        rows: rows.collect(),
    }
}

fn hundredths(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), Digits::Fixed(2))
}
