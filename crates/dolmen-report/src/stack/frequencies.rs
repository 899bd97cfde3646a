//! The natural frequencies of a stack on the springs of its joints, and the springs that surveys imply.

use super::beside::beside;
use crate::document::{Block, Cell, Column, Document, Table};
use crate::surveys_many::MANY_FROM;
use dolmen::blocks::StackMode;
use dolmen_project::Structure;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::state::{MODES_SHOWN, SpringFit, StackAnswer, StackFrequencies};

messages! {
    /// Natural frequencies of a stack.
    pub(crate) enum Frequencies in "stack.frequencies" {
        Caption => {
            en: "Natural frequencies on the springs of its joints.",
            ko: "접합면 스프링을 고려한 고유진동수.",
        },
        CaptionMeaning => {
            en: "Mass along x is the share of the whole mass that shaking along x sets in motion in that mode.",
            ko: "유효질량비 x는 x 방향 가진에 대한 그 모드의 유효질량이 전체 질량에서 차지하는 비율이다.",
        },
        Mode => { en: "Mode", ko: "모드" },
        Number { number: usize } => { en: "{number}", ko: "{number}" },
        Frequency => { en: "f", ko: "진동수 f" },
        Period => { en: "T", ko: "주기 T" },
        MassX => { en: "mass along x", ko: "유효질량비 x" },
        MassY => { en: "along y", ko: "유효질량비 y" },
        MassZ => { en: "along z", ko: "유효질량비 z" },
        NoFinding => {
            en: "They are those of the stiffness given or assumed, with the joints as their own weight leaves them (partly open where it presses outside their middle third): no finding until a survey measures them.",
            ko: "주어지거나 가정한 강성에 대한 값이며, 접합면은 자중이 작용하는 상태(합력이 중앙 1/3을 벗어나면 일부 벌어진 상태)로 보았다. 계측으로 확인하기 전에는 검토 결과가 아니다.",
        },
        Refused { why: Both } => {
            en: "Natural frequencies are not known: {why}",
            ko: "고유진동수를 구하지 못하였다: {why}",
        },
        OfHeight { frequency: Quantity } => {
            en: "By its height alone the first frequency is {frequency}, wrong by a factor of two for two of the eight pagodas to which that rule was fitted.",
            ko: "높이만으로 추정한 1차 고유진동수는 {frequency}이다. 이 추정식의 근거인 석탑 8기 중 2기는 실측값과 2배 이상 차이가 난다.",
        },
        Fits { survey: String, factor: Quantity, directions: Vec<Sentence> } => {
            en: "Survey {survey}: every joint {factor} times as stiff fits its frequencies best ({directions}).",
            ko: "{survey} 조사: 모든 접합부 강성을 {factor}배로 하면 실측 진동수와 가장 잘 맞는다({directions}).",
        },
        OtherFits { surveys: usize, least: Quantity, largest: Quantity } => {
            en: "The {surveys} surveys before it ask for {least} to {largest} times the stiffness.",
            ko: "그 이전 조사 {surveys}회에 맞는 배율은 {least}~{largest}이다.",
        },
        Direction { direction: String, measured: Quantity, computed: Quantity } => {
            en: "{direction} {measured} measured, {computed} then",
            ko: "{direction} 방향 실측 {measured} → 조정 후 {computed}",
        },
        NotComparedOne { survey: String, direction: String } => {
            en: "Survey {survey}: the frequencies in direction {direction} are not compared: a stack sways along x and y.",
            ko: "{survey} 조사: {direction} 방향의 진동수는 비교하지 않았다. 적층 구조는 x 방향과 y 방향으로 흔들린다.",
        },
        NotCompared { survey: String, directions: Vec<String> } => {
            en: "Survey {survey}: the frequencies in directions {directions} are not compared: a stack sways along x and y.",
            ko: "{survey} 조사: {directions} 방향의 진동수는 비교하지 않았다. 적층 구조는 x 방향과 y 방향으로 흔들린다.",
        },
    }
}

/// Frequencies, the one from the height alone, and the springs that surveys imply.
pub(super) fn section(
    document: &mut Document<'_>,
    structure: &Structure,
    answer: &StackAnswer,
    fits: &[SpringFit],
) {
    match &answer.frequencies {
        Some(StackFrequencies::Known { modes, .. }) => {
            document.put(Block::Table(table(modes)));
            document.note(Frequencies::NoFinding);
            for said in beside(&answer.beside) {
                document.note(said);
            }
        }
        Some(StackFrequencies::Refused(why)) => document.note(Frequencies::Refused { why: why.clone() }),
        None => {}
    }
    // the rule was fitted to pagodas: no arch, wall, tower or trilithon follows it
    if matches!(structure, Structure::Stack(part) if part.made.is_none()) {
        let frequency = 1.0 / answer.check.period_of_thumb.period_s;
        document.note(Frequencies::OfHeight {
            frequency: Quantity::new(frequency, Unit::si("Hz"), Digits::Significant(2)),
        });
    }
    let (others, detailed) = fits.split_at(if fits.len() < MANY_FROM { 0 } else { fits.len() - 1 });
    let of_detailed = detailed.iter().filter_map(fitted);
    for sentence in of_detailed
        .chain(of_others(others))
        .chain(fits.iter().filter_map(not_compared))
    {
        document.note(sentence);
    }
}

/// The range of the factors of several surveys.
fn of_others(fits: &[SpringFit]) -> Option<Frequencies> {
    let mut factors: Vec<f64> = fits.iter().filter_map(|fit| fit.factor).collect();
    factors.sort_by(f64::total_cmp);
    let [least, .., largest] = factors[..] else {
        return None;
    };
    Some(Frequencies::OtherFits {
        surveys: factors.len(),
        least: Quantity::beside_one(least, 4),
        largest: Quantity::beside_one(largest, 4),
    })
}

fn table(modes: &[StackMode]) -> Table {
    let row = |(i, mode): (usize, &StackMode)| {
        let number = |value, unit| Cell::number(Quantity::new(value, unit, Digits::Significant(4)));
        let mass = |share| Cell::number(Quantity::new(share, Unit::percent(), Digits::Fixed(1)));
        let mut cells = vec![
            Cell::words(Frequencies::Number { number: i + 1 }),
            number(mode.frequency_hz, Unit::si("Hz")),
            number(1.0 / mode.frequency_hz, Unit::si("s")),
        ];
        cells.extend(mode.effective_mass_ratio.map(mass));
        cells
    };
    Table {
        caption: vec![Frequencies::Caption.into(), Frequencies::CaptionMeaning.into()],
        columns: vec![
            Column::words(Frequencies::Mode),
            Column::numbers(Frequencies::Frequency, Unit::si("Hz")),
            Column::numbers(Frequencies::Period, Unit::si("s")),
            Column::numbers(Frequencies::MassX, Unit::percent()),
            Column::numbers(Frequencies::MassY, Unit::percent()),
            Column::numbers(Frequencies::MassZ, Unit::percent()),
        ],
        rows: modes.iter().take(MODES_SHOWN).enumerate().map(row).collect(),
    }
}

/// The springs that give the measured frequencies.
fn fitted(fit: &SpringFit) -> Option<Frequencies> {
    let hertz = |value| Quantity::new(value, Unit::si("Hz"), Digits::Significant(4));
    let each = fit.frequencies.iter().map(|(direction, found)| {
        Frequencies::Direction {
            direction: direction.clone(),
            measured: hertz(found.measured_hz),
            computed: hertz(found.computed_hz),
        }
        .into()
    });
    Some(Frequencies::Fits {
        survey: fit.survey.clone(),
        factor: Quantity::beside_one(fit.factor?, 4),
        directions: each.collect(),
    })
}

fn not_compared(fit: &SpringFit) -> Option<Frequencies> {
    let survey = fit.survey.clone();
    match fit.not_compared.as_slice() {
        [] => None,
        [one] => Some(Frequencies::NotComparedOne {
            survey,
            direction: one.clone(),
        }),
        several => Some(Frequencies::NotCompared {
            survey,
            directions: several.to_vec(),
        }),
    }
}
