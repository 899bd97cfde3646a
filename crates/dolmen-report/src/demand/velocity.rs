//! The part of a stack that lifts first, compared with the spectral velocity of the site.

use crate::document::{Block, Cell, Column, Document, Table};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::VelocityDemand;

messages! {
    /// Rocking against spectral velocity.
    pub(crate) enum ByVelocity in "demand.velocity" {
        Said { velocity: Quantity, period: Quantity, slenderness: Quantity, ratio: Quantity } => {
            en: "By spectral velocity (Housner): S_v is {velocity}, from {period} on; the part that lifts first has α = {slenderness}, {ratio} times what S_v overturns in half of all cases. It decides nothing here: that it overturns is a matter of the single motion.",
            ko: "스펙트럼 속도에 의한 검토(Housner): S_v = {velocity}(주기 {period}부터). 가장 먼저 들리는 부분의 세장각 α = {slenderness}은 S_v가 절반의 경우에 전도시키는 세장각의 {ratio}배이다. 전도 여부는 개별 지반운동에 달렸으므로 판정에는 쓰지 않는다.",
        },
        Caption => { en: "Slenderness that the spectral velocity overturns.", ko: "스펙트럼 속도로 전도되는 세장각." },
        Meaning => {
            en: "Kim, Koo and Hong (2018), eqs 2 and 3: eq. 2a lacks 1/g, so that it is no angle; eq. 2b must read M R²; eq. 3 takes M R²/I₀ for 1, on the safe side.",
            ko: "김남희·구인영·홍성걸(2018)의 식 (2), (3): 식 (2a)에는 1/g이 빠져 각도가 아니며, 식 (2b)의 (MR)²은 M R²이어야 한다. 식 (3)은 M R²/I₀을 1로 보아 안전측이다.",
        },
        Form => { en: "form", ko: "식" },
        Right => { en: "right: S_v p/g", ko: "올바른 식, S_v p/g" },
        PublishedThree => { en: "eq. 3 as published, S_v/√(g R)", ko: "논문 식 (3), S_v/√(g R)" },
        PublishedTwo => { en: "eq. 2a as published, S_v p (m/s²)", ko: "논문 식 (2a), S_v p (m/s²)" },
        Critical => { en: "α_crit", ko: "α_crit" },
        Ratio => { en: "α / α_crit", ko: "α / α_crit" },
    }
}

/// The demand by S_v, and the published forms.
pub(super) fn section(document: &mut Document<'_>, of: &VelocityDemand) {
    let radians = |angle: f64| Quantity::new(angle, Unit::si("rad"), Digits::Significant(3));
    document.put(Block::Paragraph(vec![Sentence::from(ByVelocity::Said {
        velocity: Quantity::new(of.velocity.velocity_m_s, Unit::si("m/s"), Digits::Significant(3)),
        period: Quantity::new(of.velocity.period_s, Unit::si("s"), Digits::Significant(3)),
        slenderness: radians(of.block.slenderness_rad),
        ratio: Quantity::beside_one(of.ratio(), 3),
    })]));
    let row = |form: ByVelocity, critical: f64, is_angle: bool| {
        let ratio = of.block.slenderness_rad / critical;
        vec![
            Cell::words(form),
            Cell::number(Quantity::ratio(critical, 4)),
            Cell::Number(is_angle.then(|| Quantity::beside_one(ratio, 3))),
        ]
    };
    document.put(Block::Table(Table {
        caption: vec![ByVelocity::Caption.into(), ByVelocity::Meaning.into()],
        columns: vec![
            Column::words(ByVelocity::Form),
            Column::numbers(ByVelocity::Critical, Unit::ratio()),
            Column::numbers(ByVelocity::Ratio, Unit::ratio()),
        ],
        rows: vec![
            row(ByVelocity::Right, of.critical_slenderness_rad, true),
            row(ByVelocity::PublishedThree, of.published_3_rad, true),
            row(ByVelocity::PublishedTwo, of.published_2a_m_s2, false),
        ],
    }));
}
