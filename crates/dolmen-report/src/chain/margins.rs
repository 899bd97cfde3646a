//! The margins of the joints of a chain with known stiffness.

use crate::document::{Block, Cell, Column, Document, Series, Table, table_series};
use dolmen::stability::{ChainStability, JointStability};
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// Margins of the joints.
    pub(crate) enum Margins in "chain.margins" {
        Caption(factor: Quantity) => {
            en: "Margins of the joints, λ = {factor}.",
            ko: "접합면별 여유도, 하중배율 λ = {factor}.",
        },
        CaptionMeaning => {
            en: "Least k is where the chain just stands, the other joints as they are; lean is rotation under gravity per unit of an initial common tilt.",
            ko: "최소 k는 다른 접합면을 그대로 둔 안정 한계 강성이고, 기울기 증폭은 모든 부재에 같은 초기 기울기를 주었을 때 중력이 작용한 뒤의 회전각과 초기 기울기의 비이다.",
        },
        Joint => { en: "Joint", ko: "접합면" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Stiffness => { en: "k", ko: "k" },
        Least => { en: "least k", ko: "최소 k" },
        Margin => { en: "margin", ko: "여유도" },
        Lean => { en: "lean of the link", ko: "기울기 증폭" },
        Uplift => { en: "uplift moment N·b/2", ko: "들림 모멘트 N·b/2" },
        UpliftTilt => { en: "tilt at which it is reached", ko: "들림 한계 기울기" },
        Falls => { en: "falls", ko: "불안정" },
        Tilt(inverse: Quantity) => { en: "1/{inverse}", ko: "1/{inverse}" },
        Dunkerley { needed: Quantity, least: Quantity, most: Quantity } => {
            en: "All stiffnesses could be multiplied by 1/λ = {needed} and the chain would just stand; by hand, this factor lies between max M/k = {least} and Σ M/k = {most} (Dunkerley).",
            ko: "모든 강성에 1/λ = {needed}을(를) 곱하면 안정 한계에 이른다. 손계산 확인: 던컬리(Dunkerley) 공식으로 이 값은 max M/k = {least}와(과) Σ M/k = {most} 사이이다.",
        },
        SideSupport => {
            en: "Side supports without a gap are counted.",
            ko: "간격 없는 측면 지지가 반영되어 있다.",
        },
        NoCheckOfOverturning => {
            en: "A linear joint spring is no check against overturning: the uplift limit N·b/2 is the largest moment that weight alone lets a bed without tension pass, and the bed begins to open well before.",
            ko: "선형 회전 스프링은 전도 검토를 대신하지 못한다. 들림 한계 N·b/2는 인장을 받지 못하는 접합면이 자중만으로 전달할 수 있는 최대 모멘트이며, 접합면은 그보다 훨씬 전에 벌어지기 시작한다.",
        },
        NoWidths => {
            en: "A linear joint spring is no check against overturning; the width of the beds is not given, so the uplift limit of the joints is unknown.",
            ko: "선형 회전 스프링은 전도 검토를 대신하지 못한다. 접합면의 폭이 주어지지 않아 들림 한계는 알 수 없다.",
        },
    }
}

/// Margins, the effect of a common factor, and their limits.
pub(super) fn section(document: &mut Document<'_>, stability: &ChainStability) {
    let beds = stability
        .joints
        .iter()
        .any(|joint| joint.uplift_moment_n_m.is_some());
    document.put(Block::Table(table(stability, beds)));
    document.note(match beds {
        true => Margins::NoCheckOfOverturning,
        false => Margins::NoWidths,
    });
    let dunkerley = Margins::Dunkerley {
        needed: Quantity::beside_one(stability.stiffness_factor, 4),
        least: Quantity::ratio(stability.stiffness_factor_least, 4),
        most: Quantity::ratio(stability.stiffness_factor_most, 4),
    };
    let side = stability
        .side_support_counted
        .then(|| Margins::SideSupport.into());
    document.put(Block::Paragraph(
        std::iter::once(dunkerley.into()).chain(side).collect(),
    ));
}

/// The stiffness of each joint, given and required, as data of the figure.
pub(super) fn series(stability: &ChainStability) -> Vec<Series> {
    let columns = table_series(&table(stability, false));
    columns.into_iter().skip(1).take(2).collect()
}

fn table(stability: &ChainStability, beds: bool) -> Table {
    let joints = &stability.joints;
    // the number of digits depends on the softest joint
    let all = joints.iter().map(|joint| joint.stiffness_n_m_rad);
    let softest = all.fold(f64::INFINITY, f64::min);
    let moments: Vec<f64> = joints
        .iter()
        .filter_map(|joint| joint.uplift_moment_n_m)
        .collect();
    let units = [Unit::of(&[softest], "N·m/rad"), Unit::of(&moments, "N·m")];
    let mut columns = vec![
        Column::words(Margins::Joint),
        Column::numbers(Margins::Stiffness, units[0].clone()),
        Column::numbers(Margins::Least, units[0].clone()),
        Column::numbers(Margins::Margin, Unit::ratio()),
        Column::numbers(Margins::Lean, Unit::ratio()),
    ];
    if beds {
        columns.push(Column::numbers(Margins::Uplift, units[1].clone()));
        columns.push(Column::numbers(Margins::UpliftTilt, Unit::ratio()));
    }
    let row = |(i, joint): (usize, &JointStability)| {
        let mut row = vec![
            Cell::words(Margins::Number(i + 1)),
            Cell::number(significant(joint.stiffness_n_m_rad, &units[0], 4)),
        ];
        row.extend(margin(joint, &units[0]));
        let lean = stability.lean_amplification.get(i);
        row.push(Cell::Number(lean.map(|lean| Quantity::ratio(*lean, 4))));
        if beds {
            row.push(Cell::Number(
                joint
                    .uplift_moment_n_m
                    .map(|moment| significant(moment, &units[1], 4)),
            ));
            row.push(joint.uplift_tilt_rad.map_or(Cell::Number(None), tilt));
        }
        row
    };
    Table {
        caption: vec![
            Margins::Caption(Quantity::beside_one(stability.load_factor, 4)).into(),
            Margins::CaptionMeaning.into(),
        ],
        columns,
        rows: joints.iter().enumerate().map(row).collect(),
    }
}

fn significant(value_si: f64, unit: &Unit, digits: usize) -> Quantity {
    Quantity::new(value_si, unit.clone(), Digits::Significant(digits))
}

/// The required stiffness and the margin; words if the chain falls for any stiffness of that joint.
fn margin(joint: &JointStability, unit: &Unit) -> [Cell; 2] {
    let falls = || Cell::BadWords(Margins::Falls.into());
    let least = joint.stiffness_least_n_m_rad;
    [
        least.map_or_else(falls, |k| Cell::number(significant(k, unit, 4))),
        match joint.margin {
            Some(margin) if margin > 1.0 => Cell::number(Quantity::beside_one(margin, 4)),
            Some(margin) => Cell::Bad(Quantity::beside_one(margin, 4)),
            None => falls(),
        },
    ]
}

/// A tilt in the form of surveys: 1/177.
fn tilt(tilt_rad: f64) -> Cell {
    match tilt_rad > 0.0 && tilt_rad.is_finite() {
        true => Cell::words(Margins::Tilt(Quantity::ratio(1.0 / tilt_rad, 3))),
        false => Cell::number(Quantity::ratio(f64::NAN, 3)),
    }
}
