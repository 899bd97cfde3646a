//! Published and exact tunings of a mode, and the loss by detuning.

use super::words::of_none;
use crate::building::fixed;
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::damper::{Aim, TuningRow, TuningRule};
use dolmen_words::{Sentence, Unit, messages};
use dolmen_work::building::TuneAnswer;

messages! {
    /// Tunings.
    pub(crate) enum Tunings in "tune.tunings" {
        Caption => {
            en: "Tunings of the mode, the damper where it is.",
            ko: "감쇠기 위치를 유지한 동조식 비교.",
        },
        CaptionMeaning => {
            en: "ω is the damper's own frequency, Ω that of the mode: authors divide by one or the other (Den Hartog's book and Hwang, Min & Hong by Ω).",
            ko: "ω는 감쇠기, Ω는 모드의 진동수이며 저자마다 나누는 값이 다르다(Den Hartog의 책과 황재승·민경원·홍성목은 Ω로 나눈다).",
        },
        Tuning => { en: "Tuning", ko: "동조식" },
        MadeFor => { en: "made for", ko: "목적" },
        FrequencyRatio => { en: "f / f of the mode", ko: "진동수비" },
        Goal => { en: "goal", ko: "목적함수값" },
        Exact => { en: "exact, with the mode's damping", ko: "엄밀해(모드 감쇠 포함)" },
        Literal => {
            en: "Hwang, Min & Hong, taken literally",
            ko: "황재승·민경원·홍성목, 논문 값 그대로",
        },
        ForcePeakFixed => { en: "peak under a harmonic force, fixed points", ko: "조화하중 변위의 고정점" },
        ForcePeakExact => { en: "peak under a harmonic force, exact", ko: "조화하중 최대 변위, 엄밀해" },
        ForcePeak => { en: "peak under a harmonic force", ko: "조화하중 최대 변위" },
        ForceVariance => { en: "variance under a white-noise force", ko: "백색잡음 하중의 변위 분산" },
        BaseVariance => {
            en: "variance under a white-noise base acceleration",
            ko: "백색잡음 지반가속도의 변위 분산",
        },
        BasePeakFixed => {
            en: "peak under a harmonic base acceleration, fixed points",
            ko: "조화 지반가속도 변위의 고정점",
        },
        BasePeak => { en: "peak under a harmonic base acceleration", ko: "조화 지반가속도 최대 변위" },
        EquallyDamped => { en: "two modes equally damped", ko: "두 모드의 감쇠를 같게" },
        MeanDamping => { en: "mean damping of two modes", ko: "두 모드의 평균 감쇠" },
        AsPrinted => {
            en: "as printed, on the damper's own frequency",
            ko: "논문의 값을 감쇠기 진동수 기준으로",
        },
        Off => {
            en: "What the goal grows by when the damper is out of tune, in %.",
            ko: "동조 오차에 따른 목적함수값의 증가(%).",
        },
        OffBy => { en: "Frequency off by", ko: "진동수 오차" },
        Given => { en: "as in the file", ko: "입력한 감쇠기" },
        Best => { en: "placed and tuned best", ko: "최적 위치와 동조" },
    }
}

/// Closed forms and exact optima.
pub(super) fn section(document: &mut Document<'_>, answer: &TuneAnswer) {
    let numbers = |head: Sentence| Column::numbers(head, Unit::ratio());
    let row = |row: &TuningRow| {
        let tuning = &row.tuning;
        vec![
            Cell::words(source(row.rule)),
            Cell::words(aim(row)),
            Cell::number(of_none(tuning.frequency_ratio, 6)),
            Cell::number(of_none(tuning.damping_ratio, 6)),
            Cell::number(of_none(tuning.damping_ratio_on_structure(), 6)),
            Cell::number(of_none(row.cost / answer.comparison.cost_without, 4)),
        ]
    };
    document.put(Block::Table(Table {
        caption: vec![Tunings::Caption.into(), Tunings::CaptionMeaning.into()],
        columns: vec![
            Column::words(Tunings::Tuning),
            Column::words(Tunings::MadeFor),
            numbers(Tunings::FrequencyRatio.into()),
            numbers(Sentence::of_symbol("c/(2mω)")),
            numbers(Sentence::of_symbol("c/(2mΩ)")),
            numbers(Tunings::Goal.into()),
        ],
        rows: answer.comparison.tunings.iter().map(row).collect(),
    }));
}

fn source(rule: Option<TuningRule>) -> Sentence {
    match rule {
        None => Tunings::Exact.into(),
        Some(TuningRule::HwangMinHongLiteral) => Tunings::Literal.into(),
        Some(rule) => Sentence::of_symbol(rule.source()),
    }
}

fn aim(row: &TuningRow) -> Sentence {
    let said = match (row.rule, row.aim) {
        (Some(TuningRule::DenHartog), _) => Tunings::ForcePeakFixed,
        (Some(TuningRule::NishiharaAsami), _) => Tunings::ForcePeakExact,
        (Some(TuningRule::WarburtonForce), _) | (None, Some(Aim::ForceRandom)) => Tunings::ForceVariance,
        (Some(TuningRule::WarburtonBase), _) | (None, Some(Aim::BaseRandom)) => Tunings::BaseVariance,
        (Some(TuningRule::WarburtonBaseHarmonic), _) => Tunings::BasePeakFixed,
        (Some(TuningRule::Sadek), _) => Tunings::EquallyDamped,
        (Some(TuningRule::Villaverde), _) => Tunings::MeanDamping,
        (Some(TuningRule::HwangMinHongLiteral), _) => Tunings::AsPrinted,
        (None, Some(Aim::ForceHarmonic)) => Tunings::ForcePeak,
        (None, Some(Aim::BaseHarmonic)) => Tunings::BasePeak,
        (None, None) => return Sentence::of_symbol("–"),
    };
    said.into()
}

/// The increase of the goal with a detuned frequency.
pub(super) fn out_of_tune(document: &mut Document<'_>, answer: &TuneAnswer) {
    const OFF: [(&str, f64); 6] = [
        ("−20 %", 0.8),
        ("−10 %", 0.9),
        ("−4 %", 0.96),
        ("+4 %", 1.04),
        ("+10 %", 1.1),
        ("+20 %", 1.2),
    ];
    let row = |(which, words): (usize, Tunings)| {
        let mut cells = vec![Cell::words(words)];
        cells.extend(OFF.map(|(_, factor)| {
            let grown = answer.detuned(which, factor);
            Cell::Number(grown.map(|share| fixed(share, Unit::percent(), 1)))
        }));
        cells
    };
    let mut columns = vec![Column::words(Tunings::OffBy)];
    columns.extend(OFF.map(|(head, _)| Column::numbers(Sentence::of_symbol(head), Unit::ratio())));
    document.put(Block::Table(Table {
        caption: vec![Tunings::Off.into()],
        columns,
        rows: [Tunings::Given, Tunings::Best]
            .into_iter()
            .enumerate()
            .map(row)
            .collect(),
    }));
}
