//! Tenons with slack: stiffness before and after they bear.

use super::storeys::significant;
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::simulated::{kilo, milli, millimetres};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::frame::{SECANT_DRIFT_RATIO, StoreyTenons, TenonsCheck};

messages! {
    /// Tenons with slack.
    pub(crate) enum Tenons in "frame.tenons" {
        Initial { slack: Quantity, storey: usize, within: Quantity, bearing: Quantity } => {
            en: "its tenons bear only after a slack, of {slack} of the height in storey {storey}: load factor and frequencies are those within it. With all tenons bearing the lowest frequency would be {bearing} in place of {within}.",
            ko: "장부는 유격({storey}층에서 층고의 {slack})이 닫힌 뒤에야 힘을 받으므로 하중배율과 진동수는 유격 안의 값이다. 모든 장부가 닿으면 최저 고유진동수는 {within}에서 {bearing}(으)로 커진다.",
        },
        Falls { slack: Quantity, storey: usize } => {
            en: "its tenons bear only after a slack, of {slack} of the height in storey {storey}, and within it the frame does not hold itself upright: it leans until they bear.",
            ko: "장부는 유격({storey}층에서 층고의 {slack})이 닫힌 뒤에야 힘을 받으며, 유격 안에서는 골조가 스스로 서지 못하여 장부가 닿을 때까지 기운다.",
        },
        Caption => { en: "Storeys whose tenons have slack.", ko: "장부에 유격이 있는 층." },
        Meaning(share: Quantity) => {
            en: "k within the slack is the stiffness of the file, on which load factor, frequencies and loads rest; the tangent is that with the tenons bearing; the secant is force over drift at {share} of the height, nothing crushed before.",
            ko: "유격 안의 k는 파일의 강성이며 하중배율·진동수·하중 검토가 이에 따른다. 접선 강성은 장부가 닿은 뒤의 값이고, 할선 강성은 압괴가 없던 상태에서 층고의 {share}만큼 변위한 때의 힘을 변위로 나눈 값이다.",
        },
        Storey => { en: "Storey", ko: "층" },
        Number(number: usize) => { en: "{number}", ko: "{number}" },
        Slack => { en: "slack", ko: "유격" },
        Within => { en: "k within the slack", ko: "유격 안의 k" },
        Tangent => { en: "tangent, bearing", ko: "닿은 뒤 접선 강성" },
        Secant => { en: "secant", ko: "할선 강성" },
        Crushing => { en: "crushes at", ko: "압괴 힘" },
        CrushingDrift => { en: "at a drift of", ko: "압괴 층간변위" },
        Frequencies(frequencies: Values) => {
            en: "Natural frequencies with all tenons bearing: {frequencies}.",
            ko: "모든 장부가 닿은 상태의 고유진동수: {frequencies}.",
        },
    }
}

fn hertz(frequency_hz: f64) -> Quantity {
    Quantity::new(frequency_hz, Unit::si("Hz"), Digits::Significant(4))
}

/// The stiffness that the check of a direction uses.
pub(super) fn finding(check: &TenonsCheck, lowest_hz: Option<f64>) -> Option<Finding> {
    let share = |of: &StoreyTenons| of.tenon.slack_m / of.height_m;
    let most = check
        .storeys
        .iter()
        .max_by(|a, b| share(a).total_cmp(&share(b)))?;
    let slack = Quantity::percent(share(most), 2);
    let storey = most.storey + 1;
    let bearing = check
        .bearing
        .modes
        .first()
        .filter(|mode| mode.omega_squared > 0.0);
    Some(match (lowest_hz, bearing) {
        (Some(within_hz), Some(bearing)) => Finding::key(
            Tone::Plain,
            Tenons::Initial {
                slack,
                storey,
                within: hertz(within_hz),
                bearing: hertz(bearing.frequency_hz),
            },
        ),
        _ => Finding::key(Tone::Warn, Tenons::Falls { slack, storey }),
    })
}

/// The table of the storeys with tenons, and the frequencies with all of them bearing.
pub(super) fn section(document: &mut Document<'_>, check: &TenonsCheck) {
    let all = check.storeys.iter().map(StoreyTenons::bearing_n_m);
    let unit = Unit::of(&all.collect::<Vec<f64>>(), "N/m");
    let force = kilo("N");
    let row = |of: &StoreyTenons| {
        let crushing_n = of.tenon.crushing_force_n;
        vec![
            Cell::words(Tenons::Number(of.storey + 1)),
            Cell::number(millimetres(of.tenon.slack_m)),
            Cell::number(significant(of.within_slack_n_m, &unit, 4)),
            Cell::number(significant(of.bearing_n_m(), &unit, 4)),
            Cell::number(significant(of.secant_n_m(), &unit, 4)),
            Cell::Number(crushing_n.map(|n| Quantity::new(n, force.clone(), Digits::Significant(4)))),
            Cell::Number(of.crushing_drift_m().map(millimetres)),
        ]
    };
    let share = Quantity::new(SECANT_DRIFT_RATIO, Unit::percent(), Digits::Trimmed(2));
    document.put(Block::Table(Table {
        caption: vec![Tenons::Caption.into(), Tenons::Meaning(share).into()],
        columns: vec![
            Column::words(Tenons::Storey),
            Column::numbers(Tenons::Slack, milli("m")),
            Column::numbers(Tenons::Within, unit.clone()),
            Column::numbers(Tenons::Tangent, unit.clone()),
            Column::numbers(Tenons::Secant, unit.clone()),
            Column::numbers(Tenons::Crushing, force.clone()),
            Column::numbers(Tenons::CrushingDrift, milli("m")),
        ],
        rows: check.storeys.iter().map(row).collect(),
    }));
    let swaying = check.bearing.modes.iter().filter(|mode| mode.omega_squared > 0.0);
    let frequencies = Values(swaying.map(|mode| hertz(mode.frequency_hz)).collect());
    document.put(Block::Paragraph(vec![Sentence::from(Tenons::Frequencies(
        frequencies,
    ))]));
}
