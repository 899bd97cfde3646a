//! The load factor under uncertain inputs, and which input it answers to.

use super::finding::{Finding, Tone};
use super::table::{Cell, figure, table};
use super::words::{listed, path_words};
use crate::figures::load_factor_distribution;
use dolmen::assess::Sensitivity;
use dolmen_words::Language;
use dolmen_words::number::{self, beside_one, percent};
use dolmen_work::answer::ProjectReport;
use dolmen_work::state::{Sampled, SensitivityOf, State};
use maud::{Markup, html};

/// Inputs shown in the table of sensitivities.
const INPUTS_SHOWN: usize = 12;

pub(super) fn findings(sampled: Option<&Sampled>, language: Language) -> Vec<Finding> {
    let Some(sampled) = sampled else {
        return Vec::new();
    };
    let falls = &sampled.unstable;
    let (estimate, lower, upper) = (
        percent(falls.estimate, 2),
        percent(falls.lower, 2),
        percent(falls.upper, 2),
    );
    let confidence = format!(
        "{}{}%",
        number::trimmed(100.0 * falls.confidence, 3),
        number::NARROW_SPACE
    );
    let tone = if falls.count == 0 { Tone::Plain } else { Tone::Warn };
    vec![Finding::new(
        tone,
        language.pick(
            format!(
                "With the scatter given for the inputs it falls under its own weight alone, without any shaking, in {} of {} samples: {estimate}, {confidence} interval \
                 {lower} to {upper}. This is a probability of the model and the stated scatter, not of the stones.",
                falls.count, falls.samples
            ),
            format!(
                "입력값의 변동을 고려하면 지진 없이 자중만으로 표본 {total}개 중 {count}개에서 전도된다: {estimate}, {confidence} 신뢰구간 {lower}–{upper}. \
                 이는 모델과 주어진 변동에 대한 확률이며 실물의 확률이 아니다.",
                total = falls.samples,
                count = falls.count
            ),
        ),
    )]
}

/// The sections on samples and sensitivities.
pub(super) fn sections(answer: &ProjectReport, language: Language) -> Markup {
    let state = answer.state();
    let sensitivities = answer.check().map_or(&[][..], |check| &check.sensitivities);
    let sensitivity_of = answer
        .check()
        .map(|check| check.sensitivity_of)
        .unwrap_or_default();
    let sampled = state.and_then(|s| s.sampled.as_ref());
    let nominal = state.and_then(State::load_factor);
    if sampled.is_none() && sensitivities.is_empty() {
        return html! {};
    }
    html! {
        h2 { (language.pick("Uncertain inputs", "입력의 불확실성")) }
        @if let Some(sampled) = sampled {
            (figure(
                &load_factor_distribution(&sampled.load_factors, &sampled.unstable, nominal, language),
                &language.pick(
                    format!("Load factor over {} samples. Each input with a coefficient of variation is drawn from a lognormal distribution; the tinted part falls.", sampled.unstable.samples),
                    format!("표본 {}개의 하중배율 분포. 변동계수가 주어진 입력은 대수정규분포에서 추출하였으며, 바탕색 범위는 전도를 뜻한다.", sampled.unstable.samples),
                ),
            ))
            @let drawn: Vec<String> = sampled.inputs.iter().map(|path| path_words(path, language)).collect();
            p { (language.pick("Inputs drawn: ", "추출한 입력: ")) (listed(&drawn, language)) "." }
        }
        @if !sensitivities.is_empty() { (sensitivity_table(sensitivities, sensitivity_of, language)) }
    }
}

fn sensitivity_table(sensitivities: &[Sensitivity], of: SensitivityOf, language: Language) -> Markup {
    let result = match of {
        SensitivityOf::LoadFactor => "λ",
        SensitivityOf::FirstMotion => language.pick("acceleration of first motion", "최초 거동 가속도"),
        SensitivityOf::EqualJoints => language.pick("equal joint stiffness needed", "균등 접합부 필요 강성"),
    };
    let head = [
        language.pick("Input", "입력").to_string(),
        language.pick(
            format!("change of {result} (%) for +1 % of the input"),
            format!("입력 +1 %에 대한 {result}의 변화 (%)"),
        ),
        language.pick("coefficient of variation", "변동계수").to_string(),
        language.pick(
            format!("scatter of {result} from it"),
            format!("그로 인한 {result}의 변동"),
        ),
    ];
    let rows: Vec<Vec<Cell>> = sensitivities
        .iter()
        .take(INPUTS_SHOWN)
        .map(|s| {
            vec![
                path_words(&s.input, language).into(),
                signed(s.elasticity).into(),
                s.cov.map_or("–".into(), |cov| percent(cov, 2)).into(),
                s.cov
                    .map_or("–".into(), |cov| percent(cov * s.elasticity.abs(), 2))
                    .into(),
            ]
        })
        .collect();
    let shown = rows.len();
    let caption = language.pick(
        format!("Sensitivity of {result}, {shown} of {} inputs. Elasticity at the values given, by central difference.", sensitivities.len()),
        format!("{result}의 민감도, 입력 {total}개 중 {shown}개. 주어진 값에서 중앙차분으로 구한 탄성도이다.", total = sensitivities.len()),
    );
    table(&caption, 1, &head, &rows)
}

fn signed(value: f64) -> String {
    let plus = if value > 0.0 { "+" } else { "" };
    format!("{plus}{}", number::fixed(value, 3))
}

/// λ with so many digits as findings show.
pub(super) fn lambda_text(load_factor: Option<f64>, language: Language) -> String {
    load_factor.map_or(language.pick("unknown", "미상").into(), |l| beside_one(l, 4))
}
