//! The load factor under uncertain inputs, and its most important inputs.

use crate::document::{Block, Cell, Column, Document, Figure, Finding, Series, Table, Tone};
use crate::figures::load_factor_distribution;
use crate::html::words::{input_words, path_words};
use dolmen::assess::{NoElasticity, Probability, Sensitivity};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::answer::CheckAnswer;
use dolmen_work::state::{Sampled, SensitivityOf, State};

/// Inputs whose elasticity is below this are not listed: less than a hundredth of a per cent for one per cent of input.
const ELASTICITY_SHOWN_LEAST: f64 = 5e-5;

messages! {
    /// Uncertain inputs.
    pub(crate) enum Scatter in "check.scatter" {
        Falls { counted: Sentence, share: Sentence } => {
            en: "With the scatter given for the inputs it falls under its own weight alone, without any shaking, in {counted}: {share}. This is a probability of the model and the stated scatter, not of the stones.",
            ko: "입력값의 변동을 고려하면 지진 없이 자중만으로 {counted}에서 안정을 잃는다: {share}. 이는 모델과 주어진 변동에 대한 확률이며 실물의 확률이 아니다.",
        },
        FallsLoaded { counted: Sentence, share: Sentence } => {
            en: "With the scatter given for the inputs it falls under its weight and static loads, without any shaking, in {counted}: {share}. This is a probability of the model and the stated scatter, not of the stones.",
            ko: "입력값의 변동을 고려하면 지진 없이 자중과 정적 하중만으로 {counted}에서 안정을 잃는다: {share}. 이는 모델과 주어진 변동에 대한 확률이며 실물의 확률이 아니다.",
        },
        FallsSlipping { counted: Sentence, share: Sentence, sticking: usize, slipping: usize } => {
            en: "With the scatter given for the inputs its load factor is 1 or less in {counted}: {share}. In {sticking} of them it falls under its weight while its joints stick, in {slipping} only once they slip: until it is shaken it stands. This is a probability of the model and the stated scatter, not of the stones.",
            ko: "입력값의 변동을 고려하면 하중배율이 1 이하인 것은 {counted}이다: {share}. 그중 {sticking}개는 접합부가 고착된 상태에서 자중으로, {slipping}개는 접합부가 미끄러진 뒤에만 안정을 잃는다(흔들리기 전에는 서 있다). 이는 모델과 주어진 변동에 대한 확률이며 실물의 확률이 아니다.",
        },
        Overloaded { counted: Sentence, share: Sentence } => {
            en: "Wind and static loads bring a joint to its limit, in one combination or more, in {counted}: {share}.",
            ko: "바람과 정적 하중의 조합에서 접합부가 한계에 이르는 것은 {counted}이다: {share}.",
        },
        Counted { count: usize, samples: usize } => {
            en: "{count} of {samples} samples",
            ko: "표본 {samples}개 중 {count}개",
        },
        Share { estimate: Quantity, confidence: Quantity, lower: Quantity, upper: Quantity } => {
            en: "{estimate}, {confidence} interval {lower} to {upper}",
            ko: "{estimate}, {confidence} 신뢰구간 {lower}–{upper}",
        },
        Most { result: Sentence, inputs: Vec<Sentence> } => {
            en: "Inputs with the largest effect on {result}, for 1 % more of each: {inputs}.",
            ko: "입력이 1 % 커질 때 {result}의 변화가 큰 순서: {inputs}.",
        },
        OfInput { input: Both, change: Sentence } => { en: "{input} {change} %", ko: "{input} {change} %" },
        Hardly { result: Sentence, inputs: usize } => {
            en: "None of the {inputs} inputs that were varied changes {result}: what decides it, such as a shape from a mesh, is none of them.",
            ko: "변화시킨 입력 {inputs}개는 {result}을(를) 거의 바꾸지 않는다. 메시로 준 형상처럼 이를 정하는 값은 변화시키지 않았다.",
        },
        Head => { en: "Uncertain inputs", ko: "입력의 불확실성" },
        Drawn(samples: usize) => {
            en: "Load factor over {samples} samples.",
            ko: "표본 {samples}개의 하중배율 분포.",
        },
        DrawnMeaning => {
            en: "Each input with a coefficient of variation is drawn from a lognormal distribution; the tinted part falls.",
            ko: "변동계수가 주어진 입력은 대수정규분포에서 추출하였으며, 바탕색 범위는 불안정을 뜻한다.",
        },
        Quantiles { low: Quantity, middle: Quantity, high: Quantity, seed: usize } => {
            en: "Load factor below which 5 %, 50 % and 95 % of the samples lie: {low}, {middle}, {high}. Seed {seed}.",
            ko: "표본의 5 %, 50 %, 95 %가 그 아래에 있는 하중배율: {low}, {middle}, {high}. 난수 초깃값 {seed}.",
        },
        Inputs(inputs: Vec<Both>) => { en: "Inputs drawn: {inputs}.", ko: "추출한 입력: {inputs}." },
        LoadFactor => { en: "λ", ko: "λ" },
        FirstMotion => { en: "acceleration of first motion", ko: "거동 시작 가속도" },
        EqualJoints => { en: "equal joint stiffness needed", ko: "모든 접합면의 강성이 같을 때의 필요 강성" },
        Sensitivity { result: Sentence, shown: usize, all: usize } => {
            en: "Sensitivity of {result}, {shown} of {all} inputs.",
            ko: "{result}의 민감도, 입력 {all}개 중 {shown}개.",
        },
        SensitivityMeaning => {
            en: "Elasticity at the values given, by central difference; inputs that change it by less are left out.",
            ko: "주어진 값에서 중앙차분으로 구한 탄성도이며, 영향이 거의 없는 입력은 생략하였다.",
        },
        OfZero(inputs: Vec<Both>) => {
            en: "Not computed for {inputs}: they are 0, of which no share can be taken.",
            ko: "민감도를 구하지 않은 입력: {inputs}. 값이 0이어서 비율로 바꿀 수 없다.",
        },
        NotAlone(inputs: Vec<Both>) => {
            en: "Not known for {inputs}: with one of them changed alone there is no such structure, or no such result. Their effect may be large.",
            ko: "민감도를 알 수 없는 입력: {inputs}. 하나만 바꾸면 구조물이 성립하지 않거나 결과가 없다. 영향이 클 수도 있다.",
        },
        Input => { en: "Input", ko: "입력" },
        InputName(input: Both) => { en: "{input}", ko: "{input}" },
        Value => { en: "value, SI", ko: "값(SI)" },
        Change(result: Sentence) => {
            en: "change of {result} (%) for +1 % of the input",
            ko: "입력 +1 %에 대한 {result}의 변화 (%)",
        },
        Signed { sign: String, value: Quantity } => { en: "{sign}{value}", ko: "{sign}{value}" },
        Cov => { en: "coefficient of variation", ko: "변동계수" },
        From(result: Sentence) => {
            en: "scatter of {result} from it",
            ko: "그로 인한 {result}의 변동",
        },
    }
}

/// Frequency of a fall.
pub(super) fn findings(sampled: &Sampled) -> Vec<Finding> {
    let slipping = sampled
        .falls_sticking
        .map(|sticking| (sticking, sampled.unstable.count.saturating_sub(sticking)))
        .filter(|(_, slipping)| *slipping > 0);
    let (counted, share) = said(&sampled.unstable);
    let found = match (slipping, sampled.weighs_loads) {
        (Some((sticking, slipping)), _) => Scatter::FallsSlipping {
            counted,
            share,
            sticking,
            slipping,
        },
        (None, true) => Scatter::FallsLoaded { counted, share },
        (None, false) => Scatter::Falls { counted, share },
    };
    let mut all = vec![happens(&sampled.unstable, found)];
    all.extend(sampled.under_loads.iter().map(|of| {
        let (counted, share) = said(of);
        happens(of, Scatter::Overloaded { counted, share })
    }));
    all
}

fn happens(of: &Probability, said: Scatter) -> Finding {
    let tone = match of.count {
        0 => Tone::Plain,
        _ => Tone::Warn,
    };
    Finding::key(tone, said).with_code("probability")
}

/// How many samples, and their share with its interval.
fn said(of: &Probability) -> (Sentence, Sentence) {
    let (count, samples) = (of.count, of.samples);
    let [estimate, lower, upper] = apart([of.estimate, of.lower, of.upper]);
    let share = Scatter::Share {
        estimate,
        confidence: Quantity::new(of.confidence, Unit::percent(), Digits::Trimmed(3)),
        lower,
        upper,
    };
    (Scatter::Counted { count, samples }.into(), share.into())
}

/// Shares as per cent, with as many digits as keep different ones apart; two at least.
fn apart(shares: [f64; 3]) -> [Quantity; 3] {
    const DIGITS: std::ops::RangeInclusive<usize> = 2..=6;
    let shown = |digits: usize| shares.map(|share| Quantity::percent(share, digits));
    let are_apart = |digits: &usize| {
        let [a, b, c] = shown(*digits).map(|of| of.number());
        let [x, y, z] = shares;
        (a != b || x == y) && (b != c || y == z) && (a != c || x == z)
    };
    shown(DIGITS.clone().find(are_apart).unwrap_or(*DIGITS.end()))
}

/// The most important inputs of the result, if requested.
pub(super) fn sensitive(answer: &CheckAnswer) -> Option<Finding> {
    const NAMED: usize = 3;
    let mut shown = listed(answer);
    shown.sort_by(|(_, a), (_, b)| b.abs().total_cmp(&a.abs()));
    let result = result(answer);
    let inputs = shown.iter().take(NAMED).map(|(of, elasticity)| {
        let input = Both::of(|language| input_words(&answer.project, &of.input, language));
        let change = signed(*elasticity, Digits::Significant(2)).into();
        Scatter::OfInput { input, change }.into()
    });
    let said = match shown.is_empty() {
        true => hardly(answer),
        false => Scatter::Most {
            result,
            inputs: inputs.collect(),
        },
    };
    (!answer.sensitivities.is_empty()).then(|| Finding::key(Tone::Plain, said).with_code("sensitivity"))
}

/// No varied input changes the result.
fn hardly(answer: &CheckAnswer) -> Scatter {
    let (result, inputs) = (result(answer), answer.sensitivities.len());
    Scatter::Hardly { result, inputs }
}

/// The inputs that change the result, with their elasticities.
fn listed(answer: &CheckAnswer) -> Vec<(&Sensitivity, f64)> {
    let known = answer.sensitivities.iter();
    let known = known.filter_map(|of| Some((of, of.elasticity?)));
    known
        .filter(|(_, elasticity)| elasticity.abs() >= ELASTICITY_SHOWN_LEAST)
        .collect()
}

/// The inputs without an elasticity, by the reason.
fn unknown(answer: &CheckAnswer) -> Vec<Scatter> {
    let of = |why: NoElasticity| {
        let without = answer
            .sensitivities
            .iter()
            .filter(move |of| of.unknown == Some(why));
        without
            .map(|of| Both::of(|language| input_words(&answer.project, &of.input, language)))
            .collect::<Vec<_>>()
    };
    let zero = of(NoElasticity::Zero);
    let alone = of(NoElasticity::NoResult);
    let zero = (!zero.is_empty()).then_some(Scatter::OfZero(zero));
    let alone = (!alone.is_empty()).then_some(Scatter::NotAlone(alone));
    zero.into_iter().chain(alone).collect()
}

/// A change with its sign.
fn signed(change: f64, digits: Digits) -> Scatter {
    Scatter::Signed {
        sign: if change > 0.0 { "+" } else { "" }.to_owned(),
        value: Quantity::new(change, Unit::ratio(), digits),
    }
}

/// The result whose sensitivities are given.
fn result(answer: &CheckAnswer) -> Sentence {
    match answer.sensitivity_of {
        SensitivityOf::LoadFactor => Scatter::LoadFactor.into(),
        SensitivityOf::FirstMotion => Scatter::FirstMotion.into(),
        SensitivityOf::EqualJoints => Scatter::EqualJoints.into(),
    }
}

/// Samples and sensitivities.
pub(crate) fn sections(answer: &CheckAnswer) -> Document<'_> {
    let mut document = Document::default();
    let sampled = answer.state.as_ref().and_then(|state| state.sampled.as_ref());
    if sampled.is_none() && answer.sensitivities.is_empty() {
        return document;
    }
    document.heading(Scatter::Head);
    document
        .blocks
        .extend(answer.state.iter().flat_map(|state| of_state(state).blocks));
    if !answer.sensitivities.is_empty() {
        match listed(answer).is_empty() {
            true => document.paragraph(hardly(answer)),
            // without scatter, two columns are empty
            false => document.put(Block::Table(table(answer).without_empty_columns())),
        }
        for why in unknown(answer) {
            document.note(why);
        }
    }
    document
}

/// The samples of one version.
pub(super) fn of_state(state: &State) -> Document<'_> {
    let mut document = Document::default();
    if let Some(sampled) = &state.sampled {
        samples(&mut document, sampled, state.load_factor());
    }
    document
}

fn samples<'a>(document: &mut Document<'a>, sampled: &'a Sampled, nominal: Option<f64>) {
    let caption = Scatter::Drawn(sampled.unstable.samples);
    let drawn = Figure::drawn(
        vec![caption.into(), Scatter::DrawnMeaning.into()],
        move |language| load_factor_distribution(&sampled.load_factors, &sampled.unstable, nominal, language),
    );
    document.charted(drawn.with_series(|| {
        let samples = sampled.load_factors.iter().copied();
        vec![Series::numbers(Scatter::LoadFactor, "", samples)]
    }));
    let [low, middle, high] = sampled.quantiles().map(|factor| Quantity::beside_one(factor, 4));
    document.paragraph(Scatter::Quantiles {
        low,
        middle,
        high,
        seed: usize::try_from(sampled.unstable.seed).unwrap_or(usize::MAX),
    });
    let input = |path: &String| Both::of(|language| path_words(path, language));
    document.paragraph(Scatter::Inputs(sampled.inputs.iter().map(input).collect()));
}

fn table(answer: &CheckAnswer) -> Table {
    let shown = listed(answer).into_iter();
    let share = |value: f64| Quantity::new(value, Unit::percent(), Digits::Significant(2));
    let rows: Vec<Vec<Cell>> = shown
        .map(|(of, elasticity)| {
            let signed = signed(elasticity, Digits::Fixed(4));
            let scatter = of.cov.map(|cov| share(cov * elasticity.abs()));
            vec![
                Cell::words(Scatter::InputName(Both::of(|language| {
                    input_words(&answer.project, &of.input, language)
                }))),
                Cell::number(Quantity::new(of.value, Unit::ratio(), Digits::Trimmed(7))),
                Cell::words(signed),
                Cell::Number(of.cov.map(share)),
                Cell::Number(scatter),
            ]
        })
        .collect();
    let numbers = |head: Scatter, unit: Unit| Column::numbers(head, unit);
    Table {
        caption: vec![
            Scatter::Sensitivity {
                result: result(answer),
                shown: rows.len(),
                all: answer.sensitivities.len(),
            }
            .into(),
            Scatter::SensitivityMeaning.into(),
        ],
        columns: vec![
            Column::words(Scatter::Input),
            numbers(Scatter::Value, Unit::ratio()),
            numbers(Scatter::Change(result(answer)), Unit::ratio()),
            numbers(Scatter::Cov, Unit::percent()),
            numbers(Scatter::From(result(answer)), Unit::percent()),
        ],
        rows,
    }
}
