//! The joint or storey that explains the changes.

use super::quantities::hertz;
use crate::document::{Block, Cell, Column, Document, Finding, Table, Tone};
use crate::limits::part_words;
use dolmen::assess::PartFit;
use dolmen_project::{Project, Structure};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::changed_part::{ChangedPart, ModelOff};

messages! {
    /// The part that explains a change.
    pub(crate) enum Parted in "change.parts" {
        One { part: Sentence, factor: Quantity, low: Quantity, high: Quantity, count: usize, next: Sentence, chance: Sentence } => {
            en: "If the model is right and one part alone changed, it is {part}: {factor} of its stiffness is left (95 %: {low} to {high}; frequencies: {count}). Inspect it first. The next best, {next}, fits with {chance}.",
            ko: "모델이 옳고 한 부위만 변하였다면 {part}이며 강성은 이전의 {factor}이다(95 % 구간 {low}–{high}, 고유진동수 {count}개). 이 부위를 먼저 점검한다. 그다음으로 잘 맞는 부위는 {next}(유의확률 {chance})이다.",
        },
        Several { parts: Vec<Sentence>, count: usize } => {
            en: "If the model is right and one part alone changed, it cannot be told which by its frequencies (compared: {count}); these explain it alike: {parts}.",
            ko: "모델이 옳고 한 부위만 변하였다면 비교한 고유진동수 {count}개로는 어느 부위인지 구별되지 않는다. 다음이 모두 설명한다: {parts}.",
        },
        Fitted { part: Sentence, factor: Quantity, low: Quantity, high: Quantity } => {
            en: "{part} ({factor} of its stiffness, {low} to {high})",
            ko: "{part}(강성 {factor}, {low}–{high})",
        },
        None { count: usize, chance: Sentence } => {
            en: "No single part of the model explains the pattern of the changes (frequencies: {count}, best {chance}): several parts, the mass or the weather changed, or the model is not that of the structure.",
            ko: "모델의 어느 한 부위의 변화로도 변화 양상이 설명되지 않는다(고유진동수 {count}개, 최대 유의확률 {chance}). 여러 부위, 질량 또는 기온이 변하였거나 모델이 실제와 다르다.",
        },
        ModelOff { measured: Quantity, model: Quantity, factor: Quantity, allowed: Quantity, verb: Sentence } => {
            en: "Which part changed is not sought: {measured} was measured, and the nearest frequency of the model is {model}, a factor of {factor} apart; beyond {allowed} it counts as another mode. {verb}",
            ko: "변한 부위는 찾지 않았다. 계측한 {measured}에 가장 가까운 모델의 고유진동수가 {model}(으)로 {factor}배 차이가 난다. {allowed}배를 넘으면 다른 모드로 본다. {verb}",
        },
        FitStack => {
            en: "Multiply «normal_stiffness and shear_stiffness|the normal and shear stiffness» of the joints by the factor that «`dolmen identify`|the identification from vibration» gives, and run this again.",
            ko: "«`dolmen identify`|진동 평가»가 주는 배율을 접합부의 «normal_stiffness와 shear_stiffness|수직강성과 전단강성»에 곱한 뒤 다시 실행한다.",
        },
        FitModel => {
            en: "Set the stiffness that «`dolmen identify`|the identification from vibration» finds in the file, and run this again.",
            ko: "«`dolmen identify`|진동 평가»로 구한 강성을 파일에 쓴 뒤 다시 실행한다.",
        },
        Alike { factor: Quantity, low: Quantity, high: Quantity } => {
            en: "All parts alike explain the changes as well: {factor} of the stiffness is left everywhere ({low} to {high}), as weather does too.",
            ko: "모든 부위가 같은 비율로 변한 경우에도 설명된다. 강성은 전체적으로 이전의 {factor}이다({low}–{high}). 날씨의 영향도 이와 같다.",
        },
        InDirection { said: Sentence, direction: String } => { en: "Direction {direction}: {said}", ko: "{direction} 방향: {said}" },
        Caption => {
            en: "Which part explains the changes of the frequencies, if the model is right and it alone changed.",
            ko: "모델이 옳고 한 부위만 변하였을 때 고유진동수의 변화를 설명하는 부위.",
        },
        Compared(pairs: Vec<Sentence>) => {
            en: "Measured frequencies before beside those of the model: {pairs}.",
            ko: "이전 조사의 고유진동수와 모델의 고유진동수: {pairs}.",
        },
        Pair { measured: Quantity, model: Quantity } => { en: "{measured} and {model}", ko: "{measured}와(과) {model}" },
        PartHead => { en: "part", ko: "부위" },
        FactorHead => { en: "stiffness left", ko: "남은 강성" },
        IntervalHead => { en: "95 %", ko: "95 %" },
        AllParts => { en: "all alike", ko: "전체가 같은 비율로 변화" },
        Chance(value: Quantity) => { en: "p = {value}", ko: "{value}" },
        Below(bound: Quantity) => { en: "< {bound}", ko: "{bound} 미만" },
        NoChance(bound: Quantity) => { en: "p < {bound}", ko: "{bound} 미만" },
        Interval { low: Quantity, high: Quantity } => { en: "{low} to {high}", ko: "{low}–{high}" },
    }
}

/// Number of parts in a list; the table has the others.
const LISTED: usize = 4;

fn share(of: f64) -> Quantity {
    Quantity::new(of, Unit::percent(), Digits::Fixed(0))
}

/// Smaller probabilities are given as below this: the tail of a fit is not accurate. Our choice.
const CHANCE_LEAST: f64 = 1e-3;

fn chance(of: f64) -> Sentence {
    match of < CHANCE_LEAST {
        true => Parted::NoChance(Quantity::ratio(CHANCE_LEAST, 1)),
        false => Parted::Chance(Quantity::ratio(of, 2)),
    }
    .into()
}

fn name(of: &ChangedPart, fit: &PartFit) -> Sentence {
    match fit.part.and_then(|at| of.parts.get(at)) {
        Some(part) => part_words(part),
        None => Parted::AllParts.into(),
    }
}

/// Reason why no part is sought.
pub(crate) fn off(of: &ModelOff, project: &Project) -> Finding {
    let factor = |of: f64| Quantity::new(of, Unit::ratio(), Digits::Fixed(2));
    let said = Parted::ModelOff {
        measured: hertz(of.measured_hz),
        model: hertz(of.model_hz),
        factor: factor(of.factor()),
        allowed: factor(ModelOff::allowed()),
        verb: match &project.structure {
            Structure::Stack(_) => Parted::FitStack,
            _ => Parted::FitModel,
        }
        .into(),
    };
    Finding::key(Tone::Unknown, said)
}

/// The explanation of the changes, one finding per direction.
pub(crate) fn findings(parts: &[ChangedPart]) -> Vec<Finding> {
    let each = parts.iter().flat_map(|of| {
        let candidates = of.found.candidates();
        let count = of.modes_hz.len();
        let fitted = |fit: &PartFit| -> Sentence {
            let [low, high] = fit.factor_interval.map(share);
            Parted::Fitted {
                part: name(of, fit),
                factor: share(fit.factor),
                low,
                high,
            }
            .into()
        };
        let (tone, said) = match (candidates, of.found.parts.get(candidates.len())) {
            ([], _) => {
                let best = of.found.parts.first().map_or(0.0, |fit| fit.p_value);
                let chance = chance(best);
                (Tone::Unknown, Parted::None { count, chance })
            }
            ([one], Some(next)) => {
                let [low, high] = one.factor_interval.map(share);
                let said = Parted::One {
                    part: name(of, one),
                    factor: share(one.factor),
                    low,
                    high,
                    count,
                    next: name(of, next),
                    chance: chance(next.p_value),
                };
                (Tone::Warn, said)
            }
            (several, _) => {
                let parts = several.iter().take(LISTED).map(fitted).collect();
                (Tone::Unknown, Parted::Several { parts, count })
            }
        };
        let mut all = vec![Finding::key(tone, along(of, said))];
        if of.found.is_alike_possible() {
            let alike = &of.found.alike;
            let [low, high] = alike.factor_interval.map(share);
            let said = Parted::Alike {
                factor: share(alike.factor),
                low,
                high,
            };
            all.push(Finding::key(Tone::Unknown, along(of, said)));
        }
        all
    });
    each.collect()
}

fn along(of: &ChangedPart, said: Parted) -> Sentence {
    let said = Sentence::from(said);
    match &of.direction {
        Some(direction) => Parted::InDirection {
            said,
            direction: direction.clone(),
        }
        .into(),
        None => said,
    }
}

/// The table of all parts, one per direction.
pub(crate) fn section(document: &mut Document<'_>, parts: &[ChangedPart]) {
    for of in parts {
        let pairs = of.modes_hz.iter().map(|[measured, model]| {
            Parted::Pair {
                measured: hertz(*measured),
                model: hertz(*model),
            }
            .into()
        });
        let row = |fit: &PartFit| {
            let [low, high] = fit.factor_interval.map(share);
            vec![
                Cell::words(name(of, fit)),
                Cell::number(share(fit.factor)),
                Cell::words(Parted::Interval { low, high }),
                match fit.p_value < CHANCE_LEAST {
                    true => Cell::words(Parted::Below(Quantity::ratio(CHANCE_LEAST, 1))),
                    false => Cell::number(Quantity::ratio(fit.p_value, 2)),
                },
            ]
        };
        document.put(Block::Table(Table {
            caption: vec![
                along(of, Parted::Caption),
                Parted::Compared(pairs.collect()).into(),
            ],
            columns: vec![
                Column::words(Parted::PartHead),
                Column::numbers(Parted::FactorHead, Unit::percent()),
                Column::words(Parted::IntervalHead),
                Column::numbers(Sentence::of_symbol("p"), Unit::ratio()),
            ],
            rows: of.found.parts.iter().chain([&of.found.alike]).map(row).collect(),
        }));
    }
}
