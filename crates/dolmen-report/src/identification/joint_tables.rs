//! Tables of the joints of a stack: factors, the resulting springs, and the strain energy of each mode.

use super::joint_modes::Modes;
use crate::document::{Cell, Column, Table};
use dolmen::blocks::JointFactor;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::stack::FactorsAnswer;

messages! {
    /// Tables of joints.
    pub(crate) enum Tables in "identification.joint-tables" {
        Caption => { en: "Factors on the springs of the file.", ko: "파일의 접합부 강성에 대한 배율." },
        Meaning => {
            en: "K_n and K_s: best where it is determined, else over the range.",
            ko: "K_n, K_s는 최적값이 정해지면 그 값, 아니면 범위에 해당하는 값이다.",
        },
        EnergyCaption => {
            en: "Strain energy of each mode by joint, with the common factor.",
            ko: "공통 배율에서 각 모드의 접합면별 변형에너지 비율.",
        },
        EnergyMeaning => {
            en: "The share is also how much ω² changes with the stiffness of the joint: a mode sees the joints where it has its energy.",
            ko: "이 비율은 접합부 강성에 대한 ω²의 변화율과 같다. 모드는 변형에너지가 있는 접합면만 알려 준다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        On { upper: String, lower: Sentence } => { en: "{upper} on {lower}", ko: "{upper} / {lower}" },
        OnSeveral { upper: String, more: usize, lower: Sentence } => {
            en: "{upper} and {more} more on {lower}",
            ko: "{upper} 외 {more}개 / {lower}",
        },
        OnMany { upper: String, lower: String, more: usize } => {
            en: "{upper} on {lower} and {more} more",
            ko: "{upper} / {lower} 외 {more}개",
        },
        OnMost { upper: String, above: usize, lower: String, more: usize } => {
            en: "{upper} and {above} more on {lower} and {more} more",
            ko: "{upper} 외 {above}개 / {lower} 외 {more}개",
        },
        Ground => { en: "the ground", ko: "지반" },
        Named(name: String) => { en: "{name}", ko: "{name}" },
        Range => { en: "range", ko: "범위" },
        NotSeen => { en: "not seen", ko: "알 수 없음" },
        AtLeast(low: Quantity) => { en: "over {low}", ko: "{low} 이상" },
        AtMost(high: Quantity) => { en: "below {high}", ko: "{high} 이하" },
        From { low: Quantity, high: Quantity } => { en: "{low} to {high}", ko: "{low}~{high}" },
        Value(value: Quantity) => { en: "{value}", ko: "{value}" },
        NotSought => { en: "–", ko: "–" },
        Normal(unit: String) => { en: "K_n ({unit})", ko: "수직강성 K_n ({unit})" },
        Shear(unit: String) => { en: "K_s ({unit})", ko: "전단강성 K_s ({unit})" },
        Least => { en: "least", ko: "최소" },
        Best => { en: "best", ko: "최적" },
    }
}

/// A factor with its deviation.
pub(super) fn factor(value: f64, relative_sd: Option<f64>) -> Quantity {
    Quantity {
        sd_si: relative_sd.map(|sd| sd * value),
        ..Quantity::new(value, Unit::ratio(), Digits::Significant(3))
    }
}

/// Upper and lower stone.
pub(super) fn name(answer: &FactorsAnswer, at: usize) -> Sentence {
    let [upper, lower] = answer.names(at);
    let first = |names: &[&str]| names.first().map_or_else(String::new, |name| (*name).to_owned());
    let one = |name: &str| match name {
        "ground" => Tables::Ground.into(),
        name => Tables::Named(name.to_owned()).into(),
    };
    let (above, below) = (upper.len().saturating_sub(1), lower.len().saturating_sub(1));
    match (above, below) {
        (0, 0) => Tables::On {
            upper: first(&upper),
            lower: one(&first(&lower)),
        },
        (more, 0) => Tables::OnSeveral {
            upper: first(&upper),
            more,
            lower: one(&first(&lower)),
        },
        (0, more) => Tables::OnMany {
            upper: first(&upper),
            lower: first(&lower),
            more,
        },
        (above, more) => Tables::OnMost {
            upper: first(&upper),
            above,
            lower: first(&lower),
            more,
        },
    }
    .into()
}

/// The range of a factor times a stiffness, in words.
fn range_words(one: &JointFactor, times: f64, unit: &Unit) -> Tables {
    let value = |value: f64| {
        let bare = Unit {
            symbol: String::new(),
            factor: unit.factor,
        };
        Quantity::new(value * times, bare, Digits::Significant(3))
    };
    match one.range {
        None => Tables::NotSought,
        Some(range) => match (range.is_lower_of_band, range.is_upper_of_band) {
            (true, true) => Tables::NotSeen,
            (false, true) => Tables::AtLeast(value(range.lower)),
            (true, false) => Tables::AtMost(value(range.upper)),
            (false, false) => Tables::From {
                low: value(range.lower),
                high: value(range.upper),
            },
        },
    }
}

/// Smallest factor, range, best, and the resulting springs, one row per joint.
pub(super) fn factors(answer: &FactorsAnswer) -> Table {
    let drawn: Vec<Option<[f64; 2]>> = (0..answer.found.factors.len())
        .map(|at| answer.drawn_stiffness_pa_m(at))
        .collect();
    let largest = drawn
        .iter()
        .flatten()
        .flatten()
        .fold(0.0_f64, |most, value| most.max(*value));
    let unit = Unit::of(&[largest * answer.found.common.factor], "Pa/m");
    let row = |(at, one): (usize, &JointFactor)| {
        let springs = |which: usize| match (drawn[at], one.best) {
            (Some(drawn), Some(best)) => Cell::words(Tables::Value(Quantity {
                sd_si: one.relative_sd.map(|sd| sd * best * drawn[which]),
                ..Quantity::new(
                    best * drawn[which],
                    Unit {
                        symbol: String::new(),
                        factor: unit.factor,
                    },
                    Digits::Significant(3),
                )
            })),
            (Some(drawn), None) => Cell::words(range_words(one, drawn[which], &unit)),
            (None, _) => Cell::words(Tables::NotSought),
        };
        vec![
            Cell::words(name(answer, at)),
            Cell::words(range_words(one, 1.0, &Unit::ratio())),
            springs(0),
            springs(1),
            Cell::Number(one.least.map(|least| factor(least, None))),
            Cell::Number(one.best.map(|best| factor(best, one.relative_sd))),
        ]
    };
    let symbol = || unit.symbol.clone();
    Table {
        caption: vec![Tables::Caption.into(), Tables::Meaning.into()],
        columns: vec![
            Column::words(Tables::Joint),
            Column::words(Tables::Range),
            Column::words(Tables::Normal(symbol())),
            Column::words(Tables::Shear(symbol())),
            Column::numbers(Tables::Least, Unit::ratio()),
            Column::numbers(Tables::Best, Unit::ratio()),
        ],
        rows: answer.found.factors.iter().enumerate().map(row).collect(),
    }
}

/// Share of the strain energy of each mode, one row per joint.
pub(super) fn energy(answer: &FactorsAnswer) -> Table {
    let modes = &answer.found.modes;
    let row = |at: usize| {
        let share = |share: f64| Cell::number(Quantity::new(share, Unit::percent(), Digits::Fixed(1)));
        let mut cells = vec![Cell::words(name(answer, at))];
        cells.extend(modes.iter().map(|mode| share(mode.energy_shares[at])));
        cells
    };
    let mut columns = vec![Column::words(Tables::Joint)];
    columns.extend(
        modes
            .iter()
            .map(|mode| Column::numbers(Modes::short(mode), Unit::percent())),
    );
    Table {
        caption: vec![Tables::EnergyCaption.into(), Tables::EnergyMeaning.into()],
        columns,
        rows: (0..answer.found.factors.len()).map(row).collect(),
    }
}
