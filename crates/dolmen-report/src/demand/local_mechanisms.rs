//! Local mechanisms of a stack by Circolare 7/2019, compared with the site.

use super::words::{gravities, in_g};
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::stack::direction;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::{DemandAnswer, LocalMechanismAgainstSite};

/// Digits of all numbers.
const DIGITS: usize = 3;

messages! {
    /// Local mechanisms of a code against the site.
    pub(crate) enum Local in "demand.local_mechanisms" {
        Both { by_force: Quantity, by_displacement: Quantity } => {
            en: "Beside that, local mechanisms by Circolare 7/2019: they bear {by_force} times the earthquake of the site by forces and {by_displacement} times by displacements (the least of all directions; the formulas have not been held against the text). That decides nothing.",
            ko: "이와 별도로 Circolare 7/2019의 국부 메커니즘은 부지 지진의 {by_force}배(힘에 의한 검토), {by_displacement}배(변위에 의한 검토)까지 견딘다(모든 방향의 최솟값, 식은 원문과 대조하지 않음). 판정에는 쓰지 않는다.",
        },
        ByForce { by_force: Quantity } => {
            en: "Beside that, local mechanisms by Circolare 7/2019: they bear {by_force} times the earthquake of the site by forces (the least of all directions; the formulas have not been held against the text); by displacements that is not known. That decides nothing.",
            ko: "이와 별도로 Circolare 7/2019의 국부 메커니즘은 부지 지진의 {by_force}배(힘에 의한 검토)까지 견딘다(모든 방향의 최솟값, 식은 원문과 대조하지 않음). 변위에 의한 검토 값은 알 수 없다. 판정에는 쓰지 않는다.",
        },
        Caption => {
            en: "Local mechanisms by Circolare 7/2019 against the site.",
            ko: "Circolare 7/2019의 국부 메커니즘과 부지의 요구 수준.",
        },
        CaptionMeaning => {
            en: "By forces: 2 a0* over the peak of the ground. By displacements: d_SLV over what the spectrum asks for at T_SLV. The spectrum of the site is taken as that of the life-safety state (SLV), whatever its return period.",
            ko: "힘: 2 a0* / 최대지반가속도. 변위: d_SLV / T_SLV에서의 스펙트럼 변위. 재현주기와 관계없이 부지의 스펙트럼을 인명안전 한계상태(SLV)의 것으로 본다.",
        },
        Towards => { en: "Towards", ko: "방향" },
        Bears => { en: "ground borne", ko: "허용 지반 가속도" },
        Ground => { en: "ground", ko: "지반 가속도" },
        Forces => { en: "by forces", ko: "힘" },
        Asked => { en: "asked for", ko: "요구 변위" },
        Displacements => { en: "by displacements", ko: "변위" },
        Damping => { en: "damping", ko: "감쇠비" },
    }
}

/// The smallest of all directions, in one line; `None` if no direction has a check.
pub(super) fn finding(all: &[LocalMechanismAgainstSite]) -> Option<Finding> {
    let least = |of: &dyn Fn(&LocalMechanismAgainstSite) -> Option<f64>| {
        let least = all.iter().filter_map(of).min_by(f64::total_cmp)?;
        Some(Quantity::ratio(least, DIGITS))
    };
    let by_force = least(&|of| of.demand.by_force)?;
    let said = match least(&|of| Some(of.demand.by_displacement?.ratio)) {
        Some(by_displacement) => Local::Both {
            by_force,
            by_displacement,
        },
        None => Local::ByForce { by_force },
    };
    Some(Finding::new(Tone::Plain, said))
}

/// Each direction compared with the site.
pub(super) fn section(document: &mut Document<'_>, answer: &DemandAnswer) {
    let all = &answer.local_mechanisms;
    let has_check =
        |of: &LocalMechanismAgainstSite| of.demand.by_force.is_some() || of.demand.by_displacement.is_some();
    if !all.iter().any(has_check) {
        return;
    }
    let millimetres = || Unit {
        symbol: "mm".to_owned(),
        factor: 1e3,
    };
    document.put(Block::Table(Table {
        caption: vec![Local::Caption.into(), Local::CaptionMeaning.into()],
        columns: vec![
            Column::words(Local::Towards),
            Column::numbers(Local::Bears, gravities()),
            Column::numbers(Local::Ground, gravities()),
            Column::numbers(Local::Forces, Unit::ratio()),
            Column::numbers(Sentence::of_symbol("T_SLV"), Unit::si("s")),
            Column::numbers(Sentence::of_symbol("d_SLV"), millimetres()),
            Column::numbers(Local::Asked, millimetres()),
            Column::numbers(Local::Displacements, Unit::ratio()),
            Column::numbers(Local::Damping, Unit::ratio()),
        ],
        rows: all.iter().map(row).collect(),
    }));
}

fn row(of: &LocalMechanismAgainstSite) -> Vec<Cell> {
    let digits = Digits::Significant(DIGITS);
    let ratio = |value: f64| Quantity::ratio(value, DIGITS);
    let millimetres = |value: f64| {
        let unit = Unit {
            symbol: "mm".to_owned(),
            factor: 1e3,
        };
        Quantity::new(value, unit, digits)
    };
    let (borne, asked) = (of.capacity.displacement, of.demand.by_displacement);
    vec![
        Cell::words(direction(of.capacity.mechanism.direction)),
        Cell::Number(of.capacity.by_force_m_s2.map(|m_s2| in_g(m_s2, digits))),
        Cell::number(in_g(of.demand.ground_m_s2, digits)),
        Cell::Number(of.demand.by_force.map(ratio)),
        Cell::Number(borne.map(|borne| Quantity::new(borne.period_s, Unit::si("s"), digits))),
        Cell::Number(borne.map(|borne| millimetres(borne.limit_m))),
        Cell::Number(asked.map(|asked| millimetres(asked.displacement_m))),
        Cell::Number(asked.map(|asked| ratio(asked.ratio))),
        Cell::Number(asked.map(|asked| ratio(asked.damping_ratio))),
    ]
}
