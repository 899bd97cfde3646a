//! Measured frequencies near those of the model: how near, and whether scatter alone explains the difference.

use crate::document::{Finding, Tone};
use crate::stack::beside;
use dolmen_project::Project;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::judgement::{MeasuredFrequency, first_sway, latest_frequencies};
use dolmen_work::state::{Check, State};

/// Standard deviations beyond which scatter does not explain a difference. As for evidence.
const DEVIATIONS_MOST: f64 = 3.0;
/// Relative difference of a frequency below which there is no finding, however small the scatter: masses and lengths are not known more
/// accurately. Our choice.
const WORTH: f64 = 0.02;

messages! {
    /// Measured frequencies near those of the model.
    pub(crate) enum Agreement in "check.agreement" {
        Off { survey: String, direction: Both, measured: Quantity, computed: Quantity, relative: Quantity, deviations: Quantity, stiffness: Quantity } => {
            en: "Survey {survey} measured {measured} in direction {direction}; this model has {computed}. That counts as agreement (10 %), but is {relative} and {deviations} standard deviations off: the stiffness of the structure over its mass may be {stiffness} of that of the model.",
            ko: "{survey} 조사의 {direction} 실측 고유진동수는 {measured}, 해석 모델은 {computed}이다. 10 % 이내이므로 일치로 보지만 {relative}, 표준편차의 {deviations}배 차이가 난다. 질량에 대한 실제 강성은 모델의 {stiffness}일 수 있다.",
        },
        Agree { each: Vec<Sentence> } => {
            en: "The lowest measured frequencies agree with this model: {each}.",
            ko: "최저 실측 고유진동수가 해석 모델과 일치한다: {each}.",
        },
        BeforeDamage(surveys: String) => {
            en: "Made before damage in the model was found: {surveys}. It is held against the model without that damage, and says nothing of the stiffness that is left.",
            ko: "모델에 반영한 손상이 발견되기 전의 조사: {surveys}. 그 손상이 없는 모델과 비교하며, 남은 강성에 대해서는 알려 주지 않는다.",
        },
        WithDampers { each: Vec<Sentence> } => {
            en: "Measured frequencies are held against those of the whole, with its dampers: {each}.",
            ko: "실측 고유진동수는 감쇠기를 포함한 전체의 값과 비교한다: {each}.",
        },
        Whole { direction: Both, whole: Quantity, without: Quantity } => {
            en: "direction {direction} {whole} ({without} without dampers)",
            ko: "{direction} {whole}(감쇠기가 없으면 {without})",
        },
        OneBefore { survey: String, direction: Both, measured: Quantity, computed: Quantity } => {
            en: "direction {direction} {measured}, model without later damage {computed} (survey {survey})",
            ko: "{direction} {measured}, 이후 손상이 없는 모델 {computed}({survey} 조사)",
        },
        One { survey: String, direction: Both, measured: Quantity, computed: Quantity } => {
            en: "direction {direction} {measured}, model {computed} (survey {survey})",
            ko: "{direction} {measured}, 모델 {computed}({survey} 조사)",
        },
    }
}

/// For each direction, the measurement of its latest survey, if it does not contradict the model.
pub(super) fn agreement(project: &Project, state: &State) -> Vec<Finding> {
    let near = latest_frequencies(project, &state.check)
        .into_iter()
        .filter(|of| !of.differs() && !project.identified_from().contains(of.survey.as_str()));
    let (off, agreeing): (Vec<MeasuredFrequency>, Vec<MeasuredFrequency>) =
        near.partition(|of| deviations(of).is_some());
    let mut all: Vec<Finding> = off.iter().filter_map(said_off).collect();
    let each: Vec<Sentence> = agreeing.iter().map(|of| one(project, of)).collect();
    if !each.is_empty() {
        all.push(Finding::key(Tone::Good, Agreement::Agree { each }));
    }
    all.extend(held_against(project, state));
    all
}

/// Properties other than its own stiffness that the model's frequencies include, if a survey is compared with them.
fn held_against(project: &Project, state: &State) -> Vec<Finding> {
    let compared = latest_frequencies(project, &state.check);
    if compared.is_empty() {
        return Vec::new();
    }
    let mut all: Vec<Finding> = before_damage(project, &compared).into_iter().collect();
    all.extend(match &state.check {
        Check::Building(answer) if answer.stands.as_ref().is_some_and(|of| !of.dampers.is_empty()) => {
            let each = compared.iter().filter_map(|of| {
                let (without, _) = first_sway(answer, &of.direction)?;
                let said = Agreement::Whole {
                    direction: direction_words(&of.direction),
                    whole: hertz(of.computed_hz),
                    without: hertz(without),
                };
                Some(said.into())
            });
            let each = each.collect();
            vec![Finding::key(Tone::Plain, Agreement::WithDampers { each })]
        }
        Check::Stack(answer) => {
            let each = beside(&answer.beside).into_iter();
            each.map(|said| Finding::key(Tone::Warn, said)).collect()
        }
        Check::Building(_) | Check::Chain(_) | Check::Frame(_) => Vec::new(),
    });
    all
}

/// The surveys compared that were made before damage in the model was found.
fn before_damage(project: &Project, compared: &[MeasuredFrequency]) -> Option<Finding> {
    let mut names: Vec<&str> = compared.iter().map(|of| of.survey.as_str()).collect();
    names.retain(|name| project.earlier_model(name).is_some());
    names.dedup();
    let surveys = names.join(", ");
    (!names.is_empty()).then(|| Finding::key(Tone::Warn, Agreement::BeforeDamage(surveys)))
}

/// Difference in standard deviations, if it is reported.
fn deviations(of: &MeasuredFrequency) -> Option<f64> {
    let apart = (of.measured_hz - of.computed_hz).abs();
    let deviations = apart / of.sd_hz?;
    (deviations > DEVIATIONS_MOST && apart > WORTH * of.computed_hz).then_some(deviations)
}

fn said_off(of: &MeasuredFrequency) -> Option<Finding> {
    let ratio = of.measured_hz / of.computed_hz;
    let said = Agreement::Off {
        survey: of.survey.clone(),
        direction: direction_words(&of.direction),
        measured: measured(of),
        computed: hertz(of.computed_hz),
        relative: Quantity::percent((ratio - 1.0).abs(), 2),
        deviations: Quantity::ratio(deviations(of)?, 2),
        stiffness: Quantity::percent(ratio * ratio, 3),
    };
    Some(Finding::key(Tone::Warn, said))
}

fn one(project: &Project, of: &MeasuredFrequency) -> Sentence {
    let (survey, direction) = (of.survey.clone(), direction_words(&of.direction));
    let (measured, computed) = (measured(of), hertz(of.computed_hz));
    match project.earlier_model(&of.survey) {
        Some(_) => Agreement::OneBefore {
            survey,
            direction,
            measured,
            computed,
        },
        None => Agreement::One {
            survey,
            direction,
            measured,
            computed,
        },
    }
    .into()
}

/// "x", "x 방향"; torsion has no direction word in Korean.
pub(super) fn direction_words(direction: &str) -> Both {
    let korean = match direction {
        "torsion" => "비틀림".to_owned(),
        other => format!("{other} 방향"),
    };
    Both {
        english: direction.to_owned(),
        korean,
    }
}

fn measured(of: &MeasuredFrequency) -> Quantity {
    Quantity {
        sd_si: of.sd_hz,
        ..hertz(of.measured_hz)
    }
}

fn hertz(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("Hz"), Digits::Significant(4))
}
