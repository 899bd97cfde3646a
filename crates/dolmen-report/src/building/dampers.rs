//! The dampers of a building, with all their numbers.

use super::words::{direction_words, fixed, name, number, significant, tonnes};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::damper::DamperKind;
use dolmen_project::BuiltDamper;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Dampers.
    pub(crate) enum Dampers in "building.dampers" {
        Caption => { en: "Dampers.", ko: "감쇠기." },
        CaptionKinds => {
            en: "tmd, a mass on a spring; tlcd, a liquid column; tlcmd, such a column on a spring; link, a dashpot.",
            ko: "tmd 동조질량감쇠기, tlcd 동조액체기둥감쇠기, tlcmd 그 혼합형, link 점성감쇠기.",
        },
        CaptionRatios => {
            en: "The mass ratio is of the modal mass at the damper's place, the damping ratio on its own frequency.",
            ko: "질량비는 장치 위치에서의 모드질량에 대한 값이고 감쇠비는 장치 자신의 진동수에 대한 값이다.",
        },
        Damper => { en: "Damper", ko: "감쇠기" },
        Kind => { en: "kind", ko: "종류" },
        Floor => { en: "floor", ko: "층" },
        Direction => { en: "along", ko: "방향" },
        ForMode => { en: "for mode", ko: "대상 모드" },
        MassRatio => { en: "mass ratio", ko: "질량비" },
        Mass => { en: "mass", ko: "질량" },
        Frequency => { en: "f", ko: "진동수" },
        Damping => { en: "damping", ko: "감쇠비" },
        Besides { damper: String, rest: Sentence } => { en: "{damper}: {rest}.", ko: "{damper}: {rest}." },
        TunedBy { damper: String, rule: Sentence } => {
            en: "{damper}: frequency and damping by {rule}.",
            ko: "{damper}: 진동수와 감쇠비는 동조식 {rule}에 따른 값.",
        },
        LengthRatio(ratio: Quantity) => {
            en: "length ratio {ratio}",
            ko: "길이비(수평 길이/전체 길이) {ratio}",
        },
        LiquidApart { share: Quantity, frequency: Quantity, damping: Quantity, ratio: Quantity } => {
            en: "liquid {share} of the mass at {frequency}, damping {damping}, length ratio {ratio}",
            ko: "액체 질량비 {share}, 진동수 {frequency}, 감쇠비 {damping}, 길이비(수평 길이/전체 길이) {ratio}",
        },
        ToGround(coefficient: Quantity) => {
            en: "{coefficient} to the ground",
            ko: "지반에 연결, 감쇠계수 {coefficient}",
        },
        ToFloor { coefficient: Quantity, floor: usize, x: Quantity, y: Quantity } => {
            en: "{coefficient} to floor {floor} at x = {x}, y = {y}",
            ko: "{floor}번 바닥 x = {x}, y = {y}에 연결, 감쇠계수 {coefficient}",
        },
    }
}

/// A table of the dampers; nothing without dampers.
pub(super) fn section(document: &mut Document<'_>, dampers: &[BuiltDamper]) {
    if dampers.is_empty() {
        return;
    }
    let words = [
        Dampers::Damper,
        Dampers::Kind,
        Dampers::Floor,
        Dampers::Direction,
        Dampers::ForMode,
    ];
    let mut columns: Vec<Column> = words.into_iter().map(Column::words).collect();
    let symbol = |head: &str| Column::numbers(Sentence::of_symbol(head), Unit::si("m"));
    columns.extend([
        symbol("x"),
        symbol("y"),
        Column::numbers(Dampers::MassRatio, Unit::percent()),
        Column::numbers(Dampers::Mass, tonnes()),
        Column::numbers(Dampers::Frequency, Unit::si("Hz")),
        Column::numbers(Dampers::Damping, Unit::percent()),
    ]);
    document.put(Block::Table(Table {
        caption: vec![
            Dampers::Caption.into(),
            Dampers::CaptionKinds.into(),
            Dampers::CaptionRatios.into(),
        ],
        columns,
        rows: dampers.iter().map(row).collect(),
    }));
    let besides: Vec<Sentence> = dampers.iter().flat_map(besides).collect();
    if !besides.is_empty() {
        document.put(Block::List(besides));
    }
}

/// The tuning rule, and properties that do not fit a table.
fn besides(damper: &BuiltDamper) -> impl Iterator<Item = Sentence> {
    let tuned = damper.tuning.map(|rule| Dampers::TunedBy {
        damper: damper.name.clone(),
        rule: Sentence::of_symbol(rule.name()),
    });
    let rest = rest(damper).map(|rest| Dampers::Besides {
        damper: damper.name.clone(),
        rest,
    });
    tuned.into_iter().chain(rest).map(Sentence::from)
}

fn row(damper: &BuiltDamper) -> Vec<Cell> {
    let tuned = damper.tuned_to;
    let own = damper.own();
    let [cos, sin] = damper.direction.unit();
    let metres = |value: f64| Cell::number(fixed(value, Unit::si("m"), 3));
    vec![
        Cell::words(name(&damper.name)),
        Cell::words(Sentence::of_symbol(damper.word())),
        Cell::words(number(damper.floor)),
        Cell::words(direction_words(sin.atan2(cos).to_degrees())),
        tuned.map_or(Cell::Number(None), |tuned| Cell::words(number(tuned.mode))),
        metres(damper.place_m[0]),
        metres(damper.place_m[1]),
        Cell::Number(tuned.map(|tuned| Quantity::percent(tuned.mass_ratio, 4))),
        Cell::Number(tuned.map(|_| significant(damper.kind.mass_kg(), tonnes(), 4))),
        Cell::Number(own.map(|[hz, _]| significant(hz, Unit::si("Hz"), 5))),
        Cell::Number(own.map(|[_, ratio]| fixed(ratio, Unit::percent(), 3))),
    ]
}

/// Properties of a damper in addition to mass, frequency and damping; `None` for a mass on a spring.
pub(crate) fn rest(damper: &BuiltDamper) -> Option<Sentence> {
    let as_given = |value: f64| Quantity::new(value, Unit::ratio(), Digits::Trimmed(6));
    let said = match damper.kind {
        DamperKind::TunedMass { .. } => return None,
        DamperKind::LiquidColumn { length_ratio, .. } => Dampers::LengthRatio(as_given(length_ratio)),
        DamperKind::LiquidColumnMass {
            liquid_mass_kg,
            length_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
            ..
        } => Dampers::LiquidApart {
            share: fixed(liquid_mass_kg / damper.kind.mass_kg(), Unit::ratio(), 2),
            frequency: fixed(liquid_frequency_hz, Unit::si("Hz"), 5),
            damping: fixed(liquid_damping_ratio, Unit::percent(), 3),
            ratio: as_given(length_ratio),
        },
        DamperKind::Viscous { coefficient_n_s_m } => {
            let unit = super::words::scaled("kN·s/m", 1e-3);
            let coefficient = fixed(coefficient_n_s_m, unit, 4);
            match damper.to {
                None | Some((0, _)) => Dampers::ToGround(coefficient),
                Some((floor, [x, y])) => Dampers::ToFloor {
                    coefficient,
                    floor,
                    x: fixed(x, Unit::si("m"), 3),
                    y: fixed(y, Unit::si("m"), 3),
                },
            }
        }
    };
    Some(said.into())
}
