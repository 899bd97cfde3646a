//! The section of wind and static loads: combinations side by side, and the joints under the worst.

use super::findings::{what, why_not};
use crate::document::{Block, Cell, Column, Document, Table};
use crate::figures::chain_moments;
use dolmen::stability::{JointUnderLoads, Verdict};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::loads::{CombinationAnswer, LoadsAnswer, WindMet};

messages! {
    /// Tables and figures of wind and static loads.
    pub(crate) enum Shown in "loads" {
        Head => { en: "Wind and static loads", ko: "풍하중과 정하중" },
        NotKnown { why: Sentence } => {
            en: "The wind is not compared: {why}.",
            ko: "풍하중을 검토하지 못하였다. {why}.",
        },
        Wind { force: Quantity, moment: Quantity, pressure: Quantity, factor: Quantity } => {
            en: "The wind pushes with {force} and a moment of {moment} about the lowest joint; its pressure at the top is {pressure}, with a factor of {factor} for gusts, size and resonance.",
            ko: "풍하중의 합력은 {force}, 최하단 접합면에 대한 모멘트는 {moment}이다. 최상단 풍압은 {pressure}이며 돌풍·규모·공진을 고려한 계수 {factor}이(가) 포함되어 있다.",
        },
        Tilt { tilt: Quantity } => {
            en: "The tilt as surveyed, 1/{tilt}, leans the same way in every combination.",
            ko: "실측 기울기 1/{tilt}을(를) 모든 하중조합에서 같은 방향으로 고려하였다.",
        },
        Combinations => { en: "Combinations.", ko: "하중조합." },
        CombinationsMeaning => {
            en: "The load factor is what wind and static loads can be multiplied by until a joint reaches its limit, the weight as it is.",
            ko: "하중계수는 자중을 그대로 두고 풍하중과 정하중에 곱하여 어느 접합면이 한계에 이르는 값이다.",
        },
        Combination => { en: "Combination", ko: "하중조합" },
        VerdictHead => { en: "verdict", ko: "판정" },
        Weight => { en: "weight ×", ko: "자중 ×" },
        WindTimes => { en: "wind ×", ko: "풍하중 ×" },
        LoadsTimes => { en: "loads ×", ko: "정하중 ×" },
        Factor => { en: "load factor", ko: "하중계수" },
        Governs => { en: "joint", ko: "지배 접합면" },
        Stable => { en: "stable", ko: "안정" },
        Marginal => { en: "marginal", ko: "여유 부족" },
        Unstable => { en: "unstable", ko: "불안정" },
        Unknown => { en: "unknown", ko: "판정 불가" },
        Joints { what: Sentence } => { en: "{what}: joints.", ko: "{what}: 접합면별 결과." },
        JointsMeaning => {
            en: "The moment upright is that of the loads alone; in the leaning shape the weight adds to it. The limit is N·b/2, less with a strength of the bed.",
            ko: "연직 상태의 모멘트는 하중만에 의한 값이고, 기울어진 상태에서는 자중에 의한 모멘트가 더해진다. 한계는 N·b/2이며 접합면 강도가 주어지면 그보다 작다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Axial => { en: "N", ko: "N" },
        Shear => { en: "shear", ko: "전단력" },
        Upright => { en: "moment upright", ko: "모멘트(연직)" },
        Leaning => { en: "leaning", ko: "모멘트(변형 후)" },
        OfTilt => { en: "of the tilt", ko: "기울기 모멘트" },
        Limit => { en: "limit", ko: "한계" },
        Top { top: Quantity } => {
            en: "The top moves by {top} under these loads.",
            ko: "이 하중에서 최상단의 변위는 {top}이다.",
        },
        Opens => {
            en: "Springs are linear here up to the limit, but a bed begins to open at a third of it and is softer from there: a load factor just above 1 is no proof.",
            ko: "여기서는 한계까지 선형 스프링으로 계산하나, 접합면은 한계의 3분의 1에서 벌어지기 시작하여 강성이 저하된다. 1을 조금 넘는 하중계수는 안전의 증거가 아니다.",
        },
        Figure => { en: "Moments against what the beds pass.", ko: "작용 모멘트와 접합면 한계." },
        FigureMeaning => {
            en: "Where a line of a moment lies to the right of the limit, the bed stands on its edge.",
            ko: "모멘트 선이 한계선의 오른쪽에 있으면 접합면은 모서리로만 지지된다.",
        },
    }
}

/// Digits in tables.
const DIGITS: usize = 4;

/// The section; nothing where nothing acts beside the weight.
pub(crate) fn sections<'a>(answer: Option<&'a LoadsAnswer>, heights_m: Vec<f64>) -> Document<'a> {
    let mut document = Document::default();
    let Some(answer) = answer else {
        return document;
    };
    document.heading(Shown::Head);
    match &answer.wind {
        Some(Err(why)) => document.note(Shown::NotKnown { why: why_not(why) }),
        Some(Ok(met)) => document.paragraph(wind(met)),
        None => {}
    }
    if answer.tilt_rad > 0.0 {
        document.paragraph(Shown::Tilt {
            tilt: Quantity::ratio(1.0 / answer.tilt_rad, 3),
        });
    }
    if let Some(worst) = answer.worst() {
        if answer.combinations.len() > 1 || worst.name.is_some() {
            document.put(Block::Table(combinations(answer)));
        }
        document.put(Block::Table(joints(answer, worst)));
        if let Some(top_m) = worst.chain.under.top_displacement_m {
            document.paragraph(Shown::Top {
                top: Quantity::engineering(top_m.abs(), "m", 3),
            });
        }
        document.note(Shown::Opens);
        let caption = vec![Shown::Figure.into(), Shown::FigureMeaning.into()];
        document.figure(caption, move |language| {
            chain_moments(&worst.chain.under, &heights_m, language)
        });
    }
    document
}

fn wind(met: &WindMet) -> Shown {
    Shown::Wind {
        force: Quantity::engineering(met.force_n, "N", DIGITS),
        moment: Quantity::engineering(met.moment_n_m, "N·m", DIGITS),
        pressure: Quantity::engineering(met.pressure_at_top_pa, "Pa", DIGITS),
        factor: Quantity::ratio(met.response_factor, 3),
    }
}

fn verdict_word(verdict: Verdict) -> Shown {
    match verdict {
        Verdict::Stable => Shown::Stable,
        Verdict::Marginal => Shown::Marginal,
        Verdict::Unstable => Shown::Unstable,
        Verdict::Unknown => Shown::Unknown,
    }
}

fn combinations(answer: &LoadsAnswer) -> Table {
    let row = |of: &CombinationAnswer| {
        let verdict = of.verdict();
        let word = Sentence::from(verdict_word(verdict));
        let factor = of.factor().map(|factor| Quantity::beside_one(factor, DIGITS));
        vec![
            Cell::words(what(answer, of)),
            match verdict {
                Verdict::Unstable => Cell::BadWords(word),
                _ => Cell::Words(word),
            },
            Cell::number(Quantity::ratio(of.weight, 3)),
            Cell::number(Quantity::ratio(of.wind, 3)),
            Cell::number(Quantity::ratio(of.loads, 3)),
            match (verdict, factor) {
                (Verdict::Unstable, Some(factor)) => Cell::Bad(factor),
                (_, factor) => Cell::Number(factor),
            },
            Cell::Number(
                of.chain
                    .under
                    .governing_joint
                    .map(|joint| Quantity::new(joint as f64, Unit::ratio(), Digits::Fixed(0))),
            ),
        ]
    };
    Table {
        caption: vec![Shown::Combinations.into(), Shown::CombinationsMeaning.into()],
        columns: vec![
            Column::words(Shown::Combination),
            Column::words(Shown::VerdictHead),
            Column::numbers(Shown::Weight, Unit::ratio()),
            Column::numbers(Shown::WindTimes, Unit::ratio()),
            Column::numbers(Shown::LoadsTimes, Unit::ratio()),
            Column::numbers(Shown::Factor, Unit::ratio()),
            Column::numbers(Shown::Governs, Unit::ratio()),
        ],
        rows: answer.combinations.iter().map(row).collect(),
    }
}

fn joints(answer: &LoadsAnswer, worst: &CombinationAnswer) -> Table {
    let all = &worst.chain.under.joints;
    let largest = |value: fn(&JointUnderLoads) -> f64| -> f64 {
        all.iter().map(value).map(f64::abs).fold(0.0, f64::max)
    };
    let newton = Unit::of(&[largest(|joint| joint.axial_n)], "N");
    let moment = Unit::of(
        &[largest(|joint| {
            joint.moment_n_m.unwrap_or(joint.rigid_moment_n_m)
        })],
        "N·m",
    );
    let has_tilt = answer.tilt_rad > 0.0;
    let number = |value: f64, unit: &Unit| Quantity::new(value, unit.clone(), Digits::Significant(DIGITS));
    let row = |(i, joint): (usize, &JointUnderLoads)| {
        let cell = |value: Option<f64>| Cell::Number(value.map(|value| number(value, &moment)));
        let mut row = vec![
            Cell::words(Shown::Number { number: i + 1 }),
            Cell::number(number(joint.axial_n, &newton)),
            Cell::number(number(joint.shear_n, &newton)),
            cell(Some(joint.rigid_moment_n_m)),
            cell(joint.moment_n_m),
        ];
        if has_tilt {
            row.push(cell(Some(joint.tilt_moment_n_m)));
        }
        row.push(cell(joint.limit_n_m));
        let factor = joint.factor.filter(|factor| factor.is_finite());
        row.push(
            match factor.map(|factor| (factor, Quantity::beside_one(factor, DIGITS))) {
                Some((factor, shown)) if factor <= 1.0 => Cell::Bad(shown),
                Some((_, shown)) => Cell::number(shown),
                None => Cell::Number(None),
            },
        );
        row
    };
    let mut columns = vec![
        Column::words(Shown::Joint),
        Column::numbers(Shown::Axial, newton.clone()),
        Column::numbers(Shown::Shear, newton.clone()),
        Column::numbers(Shown::Upright, moment.clone()),
        Column::numbers(Shown::Leaning, moment.clone()),
    ];
    if has_tilt {
        columns.push(Column::numbers(Shown::OfTilt, moment.clone()));
    }
    columns.push(Column::numbers(Shown::Limit, moment.clone()));
    columns.push(Column::numbers(Shown::Factor, Unit::ratio()));
    let what = what(answer, worst);
    Table {
        caption: vec![Shown::Joints { what }.into(), Shown::JointsMeaning.into()],
        columns,
        rows: all.iter().enumerate().map(row).collect(),
    }
}
