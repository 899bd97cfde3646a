//! A chain with two directions: findings of its check for each.

use super::{margins, modes};
use crate::document::{Document, Finding, Tone};
use crate::load_factor::{Falls, load_factor_finding};
use dolmen::assess::{ChainAcross, ChainCheck, StiffnessTaken};
use dolmen::stability::{ChainStability, Verdict};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits of stiffness and shares.
const DIGITS: usize = 3;
/// Shares with a smaller relative difference are printed as equal.
const ALIKE: f64 = 5e-4;

messages! {
    /// A chain in its direction of motion and across.
    pub(crate) enum Across in "chain.across" {
        TowardsX(said: Sentence) => { en: "Direction x, along: {said}", ko: "x 방향(운동 방향): {said}" },
        TowardsY(said: Sentence) => { en: "Direction y, across: {said}", ko: "y 방향(직각 방향): {said}" },
        Unknown => {
            en: "whether it stands is unknown: the stiffness of the joints is not given.",
            ko: "접합부 강성이 주어지지 않아 안정 여부를 판정할 수 없다.",
        },
        LowestMode(frequency: Quantity) => {
            en: "the lowest natural frequency is {frequency}.",
            ko: "최저 고유진동수는 {frequency}이다.",
        },
        LowestFalls => {
            en: "it does not vibrate in its lowest shape, it falls in it.",
            ko: "최저차 형상에서는 진동하지 않고 안정을 잃는다.",
        },
        Taken { joints: Vec<Sentence>, least: Quantity, most: Quantity } => {
            en: "How stiff joints {joints} are across is not given, and was assumed: that of the direction of motion times («bed_depth / bed_width|depth / width of the bed»)², as of a bed of equal springs, at most 1; {least} to {most} of it.« Give stiffness_across, or measure frequencies in y.»",
            ko: "접합면 {joints}의 직각 방향 강성이 주어지지 않아 가정하였다. 균일한 스프링 위의 접합면처럼 운동 방향 강성에 («bed_depth / bed_width|접합면 깊이 / 폭»)²을 곱하고 1을 넘지 않게 하였으며, 그 비는 {least}~{most}이다.« stiffness_across를 입력하거나 y 방향 고유진동수를 계측해야 한다.»",
        },
        TakenAlike { joints: Vec<Sentence>, share: Quantity } => {
            en: "How stiff joints {joints} are across is not given, and was assumed: that of the direction of motion times («bed_depth / bed_width|depth / width of the bed»)², as of a bed of equal springs, at most 1; {share} of it.« Give stiffness_across, or measure frequencies in y.»",
            ko: "접합면 {joints}의 직각 방향 강성이 주어지지 않아 가정하였다. 균일한 스프링 위의 접합면처럼 운동 방향 강성에 («bed_depth / bed_width|접합면 깊이 / 폭»)²을 곱하고 1을 넘지 않게 하였으며, 그 비는 {share}이다.« stiffness_across를 입력하거나 y 방향 고유진동수를 계측해야 한다.»",
        },
        Joint(number: usize) => { en: "{number}", ko: "{number}" },
        Soil(soil: Quantity) => {
            en: "the soil under the footing has a rocking stiffness of {soil}.",
            ko: "기초 아래 지반의 회전강성은 {soil}이다.",
        },
        Supported { count: usize, without: Quantity } => {
            en: "side supports without a gap are counted ({count}); without them the load factor is {without}.",
            ko: "간격 없는 측면 지지(지주) {count}개를 반영하였다. 지지가 없으면 하중배율은 {without}이다.",
        },
        NoOneStone => {
            en: "Limits from weights and lengths hold in both directions; what lowering centres of mass does, and the pole as one stone, are those of the direction of motion.",
            ko: "무게와 길이로 정한 한계는 두 방향에 공통이며, 무게중심을 낮춘 효과와 단일 부재 당간의 값은 운동 방향의 것이다.",
        },
        Head => { en: "Across, direction y", ko: "직각 방향(y)" },
        Meaning => {
            en: "The widths of the beds are those across; the bed between both directions passes what its edge there allows.",
            ko: "접합면의 폭은 직각 방향 값이다. 두 방향 사이로 기울 때는 그 방향의 밑면 끝까지 지지한다.",
        },
    }
}

/// The load factor of both directions, the worse first, and findings only for across; `None` for a chain with one direction.
pub(super) fn findings(check: &ChainCheck) -> Vec<Finding> {
    let Some(across) = &check.across else {
        return Vec::new();
    };
    let mut all = stands(check, across);
    all.extend(taken(&across.taken));
    all.extend(lowest_mode(across).map(of_across));
    all.extend(across.soil_n_m_rad.map(|soil| {
        let soil = Quantity::engineering(soil, "N·m/rad", DIGITS);
        of_across(Finding::new(Tone::Plain, Across::Soil(soil)))
    }));
    all.extend(supported(across).map(of_across));
    all.push(Finding::new(Tone::Plain, Across::NoOneStone));
    all
}

/// Marks a finding as across.
pub(super) fn of_across(finding: Finding) -> Finding {
    Finding {
        sentence: Across::TowardsY(finding.sentence).into(),
        ..finding
    }
}

/// Marks a finding as along, for a chain with two directions.
pub(super) fn of_along(check: &ChainCheck, finding: Finding) -> Finding {
    match check.across {
        None => finding,
        Some(_) => Finding {
            sentence: Across::TowardsX(finding.sentence).into(),
            ..finding
        },
    }
}

fn stands(check: &ChainCheck, across: &ChainAcross) -> Vec<Finding> {
    let of = |stability: &ChainStability| {
        load_factor_finding(stability.load_factor, stability.verdict, Falls::Over)
    };
    match (&check.stability, &across.stability) {
        (Some(along), Some(other)) => {
            let mut both = vec![of_along(check, of(along)), of_across(of(other))];
            if other.load_factor < along.load_factor {
                both.reverse();
            }
            both
        }
        _ => vec![of_across(Finding::new(Tone::Unknown, Across::Unknown))],
    }
}

fn taken(all: &[StiffnessTaken]) -> Option<Finding> {
    let shares = || all.iter().map(|of| of.of_along);
    let percent = |share: f64| Quantity::percent(share, DIGITS);
    let [least, most] = [
        shares().fold(f64::INFINITY, f64::min),
        shares().fold(0.0, f64::max),
    ];
    let numbers = all.iter().map(|of| Across::Joint(of.joint).into());
    let joints = numbers.collect();
    let said = match most - least < ALIKE * most {
        true => Across::TakenAlike {
            joints,
            share: percent(most),
        },
        false => Across::Taken {
            joints,
            least: percent(least),
            most: percent(most),
        },
    };
    (!all.is_empty()).then(|| Finding::key(Tone::Warn, said).with_code("assumed-input"))
}

fn lowest_mode(across: &ChainAcross) -> Option<Finding> {
    let mode = across.modes.first()?;
    Some(match mode.omega_squared <= 0.0 {
        true => Finding::new(Tone::Bad, Across::LowestFalls),
        false => {
            let frequency = Quantity::new(mode.frequency_hz, Unit::si("Hz"), Digits::Significant(DIGITS));
            Finding::new(Tone::Plain, Across::LowestMode(frequency))
        }
    })
}

fn supported(across: &ChainAcross) -> Option<Finding> {
    let count = across
        .side_supports
        .iter()
        .filter(|of| of.acts_linearly())
        .count();
    let factor = across.load_factor_without_supports?;
    let without = Quantity::beside_one(factor, DIGITS);
    let tone = Tone::of(Verdict::of_load_factor(factor));
    Some(Finding::key(tone, Across::Supported { count, without }))
}

/// Margins and natural frequencies across.
pub(super) fn section(document: &mut Document<'_>, check: &ChainCheck) {
    let Some(across) = &check.across else { return };
    let Some(stability) = &across.stability else {
        return;
    };
    document.heading(Across::Head);
    document.paragraph(Across::Meaning);
    margins::section(document, stability);
    modes::table_alone(document, &across.modes);
}
