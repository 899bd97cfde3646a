//! How the frequencies of two surveys differ.

use super::quantities::{bare_percent, difference, hertz, percent};
use crate::document::{Block, Cell, Column, Document, Table};
use dolmen::assess::{ModeChange, SurveyChange};
use dolmen::modal::ObservedMode;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Frequencies of two surveys.
    pub(crate) enum Frequencies in "change.frequencies" {
        Caption => { en: "Frequencies, ± standard deviation.", ko: "고유진동수, ± 표준편차." },
        Meaning { power: Quantity } => {
            en: "The change is relative and without what temperature explains, ± the half width of its 95 % interval; p is the probability of such a change by chance alone, p of all that any of these changes would look so by chance (Holm); changes from “seen from” on are found with {power} probability; stiffness: its change, were it alike everywhere.",
            ko: "변화는 기온의 영향을 뺀 상대 변화와 95 % 신뢰구간의 반폭이다. p는 우연만으로 이러한 변화가 나타날 확률, 전체 p는 모든 모드 중 하나라도 그렇게 나타날 확률(Holm)이며, 검출 한계는 {power}의 확률로 검출되는 최소 변화, 강성은 전체가 같은 비율로 변하였다고 볼 때의 변화이다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        NumberAccepted { number: usize } => { en: "{number} (accepted)", ko: "{number}(채택)" },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Before => { en: "before", ko: "이전" },
        After => { en: "after", ko: "이후" },
        Explained => { en: "explained by temperature", ko: "기온 영향" },
        Change => { en: "change", ko: "변화" },
        Half => { en: "± 95 %", ko: "± 95 %" },
        ChanceOfAll => { en: "p of all", ko: "전체 p" },
        SeenFrom => { en: "seen from", ko: "검출 한계" },
        Stiffness => { en: "stiffness", ko: "강성" },
        Fell { frequency: Quantity, by: Quantity, half: Quantity, stiffness: Quantity, stiffness_half: Quantity } => {
            en: "{frequency} fell by {by} ± {half}: {stiffness} ± {stiffness_half} of stiffness, if it changed alike everywhere and no mass did.",
            ko: "{frequency} 모드는 {by} ± {half} 낮아졌다. 강성이 전체에서 같은 비율로 변하고 질량이 변하지 않았다면 강성의 변화는 {stiffness} ± {stiffness_half}이다.",
        },
        Rose { frequency: Quantity, by: Quantity, half: Quantity, stiffness: Quantity, stiffness_half: Quantity } => {
            en: "{frequency} rose by {by} ± {half}: {stiffness} ± {stiffness_half} of stiffness, if it changed alike everywhere and no mass did.",
            ko: "{frequency} 모드는 {by} ± {half} 높아졌다. 강성이 전체에서 같은 비율로 변하고 질량이 변하지 않았다면 강성의 변화는 {stiffness} ± {stiffness_half}이다.",
        },
        WouldExplain { frequency: Quantity, per_c: Quantity } => {
            en: "A coefficient of {per_c} per °C would explain the change of {frequency}.",
            ko: "기온 계수가 1 °C당 {per_c}이면 {frequency} 모드의 변화를 설명할 수 있다.",
        },
        Detectable { least: Quantity, power: Quantity } => {
            en: "A change of {least} of any one frequency would have been seen with {power} probability; smaller ones could have been missed.",
            ko: "어느 한 고유진동수라도 {least} 변하였다면 {power}의 확률로 검출되었을 것이나 그보다 작은 변화는 놓쳤을 수 있다.",
        },
    }
}

/// The table, the significant changes, and the changes that could have been missed.
pub(super) fn section(document: &mut Document<'_>, change: &SurveyChange) {
    document.put(Block::Table(table(change)));
    let changed: Vec<Sentence> = change
        .changed()
        .flat_map(|mode| changed(mode, change.temperature.leaves_doubt()))
        .collect();
    if !changed.is_empty() {
        document.put(Block::List(changed));
    }
    if let Some(least) = change.detectable() {
        document.paragraph(Frequencies::Detectable {
            least: percent(least, 2),
            power: Quantity::percent(change.power, 2),
        });
    }
}

pub(super) fn table(change: &SurveyChange) -> Table {
    let power = Quantity::percent(change.power, 2);
    let percents = |head: Frequencies| Column::numbers(head, Unit::percent());
    let hertzs = |head: Frequencies| Column::numbers(head, Unit::si("Hz"));
    let ratios = |head: Frequencies| Column::numbers(head, Unit::ratio());
    Table {
        caption: vec![Frequencies::Caption.into(), Frequencies::Meaning { power }.into()],
        columns: vec![
            Column::words(Frequencies::Mode),
            hertzs(Frequencies::Before),
            hertzs(Frequencies::After),
            percents(Frequencies::Explained),
            percents(Frequencies::Change),
            percents(Frequencies::Half),
            Column::numbers(Sentence::of_symbol("p"), Unit::ratio()),
            ratios(Frequencies::ChanceOfAll),
            percents(Frequencies::SeenFrom),
            percents(Frequencies::Stiffness),
            Column::numbers(Sentence::of_symbol("MAC"), Unit::ratio()),
        ],
        rows: change.modes.iter().enumerate().map(row).collect(),
    }
}

fn row((i, mode): (usize, &ModeChange)) -> Vec<Cell> {
    let explained = mode.explained_by_temperature;
    let mut row = vec![
        Cell::words(match mode.from.accepted || mode.to.accepted {
            true => Frequencies::NumberAccepted { number: i + 1 },
            false => Frequencies::Number { number: i + 1 },
        }),
        Cell::number(frequency(&mode.from)),
        Cell::number(frequency(&mode.to)),
        Cell::Number(explained.map(|share| percent(share, 2))),
    ];
    row.extend(difference(
        mode.frequency.relative,
        mode.frequency.evidence.as_ref(),
        2,
    ));
    row.push(Cell::number(percent(mode.uniform_stiffness, 1)));
    let assurance = mode.pair.assurance;
    row.push(Cell::Number(
        assurance.map(|mac| Quantity::new(mac, Unit::ratio(), Digits::Fixed(3))),
    ));
    row
}

fn frequency(mode: &ObservedMode) -> Quantity {
    Quantity {
        sd_si: mode.frequency_sd_hz,
        ..hertz(mode.frequency_hz)
    }
}

/// The change of a frequency, and the coefficient that would explain it.
fn changed(mode: &ModeChange, leaves_doubt: bool) -> Vec<Sentence> {
    let relative = mode.frequency.relative;
    let width = mode
        .frequency
        .evidence
        .as_ref()
        .map_or(f64::NAN, |e| e.half_width_95);
    let frequency = hertz(mode.from.frequency_hz);
    let (by, half) = (bare_percent(relative.abs(), 2), percent(width, 2));
    let stiffness = bare_percent(mode.uniform_stiffness, 1);
    let stiffness_half = percent(2.0 * (1.0 + relative).abs() * width, 1);
    let moved = match relative < 0.0 {
        true => Frequencies::Fell {
            frequency: frequency.clone(),
            by,
            half,
            stiffness,
            stiffness_half,
        },
        false => Frequencies::Rose {
            frequency: frequency.clone(),
            by,
            half,
            stiffness,
            stiffness_half,
        },
    };
    let coefficient = mode.explaining_per_c.filter(|_| leaves_doubt);
    let explains = coefficient.map(|per_c| Frequencies::WouldExplain {
        frequency,
        per_c: percent(per_c, 3),
    });
    std::iter::once(moved)
        .chain(explains)
        .map(Sentence::from)
        .collect()
}
