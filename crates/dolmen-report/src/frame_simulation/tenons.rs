//! Response of the tenons of a simulated frame.

use super::friction::kilonewtons_a_millimetre;
use super::title::title;
use crate::document::{Cell, Column, Finding, Table, Tone};
use crate::simulated::{kilo, milli, millimetres};
use dolmen::dynamics::{Tenon, TenonFace};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::frame::FrameSimulation;

messages! {
    /// Tenons of simulated frames.
    pub(crate) enum Tenons in "frame.simulation.tenons" {
        Crushed { of: Sentence, name: String, before: Quantity, after: Quantity } => {
            en: "{of}: the tenons of ‘{name}’ crush: their play, both sides together, grows from {before} to {after} of drift.",
            ko: "{of}: ‘{name}’의 장부가 압괴하여 양쪽 유격의 합이 층간변위로 {before}에서 {after}(으)로 늘어난다.",
        },
        CrushedSofter { of: Sentence, name: String, before: Quantity, after: Quantity, left: Quantity } => {
            en: "{of}: the tenons of ‘{name}’ crush: their play, both sides together, grows from {before} to {after} of drift, and {left} of their stiffness is left.",
            ko: "{of}: ‘{name}’의 장부가 압괴하여 양쪽 유격의 합이 층간변위로 {before}에서 {after}(으)로 늘어나고 강성은 {left}만 남는다.",
        },
        Caption => { en: "What the tenons went through.", ko: "장부의 이력." },
        Meaning => {
            en: "Tenons bear only beyond their slack, beside spring and friction; the face of either side crushes at the force named and its slack grows; a crushed face is softer from when it next opens.",
            ko: "장부는 유격이 닫힌 뒤에만 스프링·마찰과 나란히 힘을 받는다. 정해진 힘에서 각 접촉면이 압괴하여 유격이 늘어나며, 압괴한 면은 다음에 벌어질 때부터 강성이 낮아진다.",
        },
        Storey => { en: "Storey", ko: "층" },
        Name { name: String } => { en: "{name}", ko: "{name}" },
        Slack => { en: "slack as built", ko: "초기 유격" },
        Spring => { en: "stiffness", ko: "강성" },
        Force => { en: "crushes at", ko: "압괴 힘" },
        CrushedPositive => { en: "crushed, + drift", ko: "압괴 깊이(+)" },
        CrushedNegative => { en: "crushed, − drift", ko: "압괴 깊이(−)" },
        Left => { en: "stiffness left", ko: "남은 강성" },
    }
}

/// Fraction of the stiffness that remains at the worse face.
fn left(tenon: &Tenon, faces: &[TenonFace; 2]) -> f64 {
    faces[0].stiffness_n_m.min(faces[1].stiffness_n_m) / tenon.stiffness_n_m
}

/// Storeys with tenons: their names, the tenons as built and the faces at the end.
fn each(simulation: &FrameSimulation) -> impl Iterator<Item = (&String, &Tenon, &[TenonFace; 2])> {
    let built = simulation.frame.tenons().iter().zip(&simulation.history.tenons);
    let named = simulation.storeys.iter().zip(built);
    named.filter_map(|(name, (tenon, faces))| Some((name, tenon.as_ref()?, faces.as_ref()?)))
}

/// Storeys whose tenons crushed.
pub(super) fn findings(simulation: &FrameSimulation) -> Vec<Finding> {
    let of = title(simulation);
    let crushed = each(simulation).filter(|(_, _, faces)| faces.iter().any(|face| face.crushed_m > 0.0));
    let said = crushed.map(|(name, tenon, faces)| {
        let name = name.clone();
        let before = millimetres(2.0 * tenon.slack_m);
        let after = millimetres(faces[0].gap_m + faces[1].gap_m);
        let left = left(tenon, faces);
        let said = match left < 1.0 {
            false => Tenons::Crushed {
                of: of.clone(),
                name,
                before,
                after,
            },
            true => Tenons::CrushedSofter {
                of: of.clone(),
                name,
                before,
                after,
                left: Quantity::percent(left, 2),
            },
        };
        Finding::key(Tone::Warn, said)
    });
    said.collect()
}

/// The tenons, one row per storey; `None` without tenons.
pub(super) fn table(simulation: &FrameSimulation) -> Option<Table> {
    let stiffness = kilonewtons_a_millimetre();
    let force = kilo("N");
    let row = |(name, tenon, faces): (&String, &Tenon, &[TenonFace; 2])| {
        let crushing_n = tenon.crushing_force_n;
        vec![
            Cell::words(Tenons::Name { name: name.clone() }),
            Cell::number(millimetres(tenon.slack_m)),
            Cell::number(Quantity::new(
                tenon.stiffness_n_m,
                stiffness.clone(),
                Digits::Trimmed(6),
            )),
            Cell::Number(crushing_n.map(|n| Quantity::new(n, force.clone(), Digits::Significant(4)))),
            Cell::number(millimetres(faces[0].crushed_m)),
            Cell::number(millimetres(faces[1].crushed_m)),
            Cell::number(Quantity::percent(left(tenon, faces), 3)),
        ]
    };
    let rows: Vec<Vec<Cell>> = each(simulation).map(row).collect();
    (!rows.is_empty()).then(|| Table {
        caption: vec![Tenons::Caption.into(), Tenons::Meaning.into()],
        columns: vec![
            Column::words(Tenons::Storey),
            Column::numbers(Tenons::Slack, milli("m")),
            Column::numbers(Tenons::Spring, stiffness.clone()),
            Column::numbers(Tenons::Force, force.clone()),
            Column::numbers(Tenons::CrushedPositive, milli("m")),
            Column::numbers(Tenons::CrushedNegative, milli("m")),
            Column::numbers(Tenons::Left, Unit::percent()),
        ],
        rows,
    })
}
