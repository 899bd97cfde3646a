//! The parts before and after the sections of a report, in a language: its kind and name, the answers, method and sources.

use super::imprint::Imprint;
use super::words::{judgement_sign, thresholds};
use crate::check::{doubtful, title};
use crate::engineer::Given;
use crate::headline::{headline, over_the_years, worse as worse_words};
use crate::stack;
use dolmen::stability::Verdict;
use dolmen_project::Structure;
use dolmen_words::message::Both;
use dolmen_words::number::beside_one;
use dolmen_words::{Language, Sentence, printed_name};
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::{
    AssumedInputs, Colour, DecidedBy, Earthquake, EarthquakeFinding, Judgement, VersionJudgement, judge,
};
use dolmen_work::state::{Check, State};

/// The answers on a project.
pub(crate) struct Banner {
    pub(crate) colour: Colour,
    /// A sign for readers who cannot see colours.
    pub(crate) sign: &'static str,
    /// The words of the headline.
    pub(crate) words: String,
    /// Statements that belong with the words: worse variants, the effect of an earthquake, contradictions.
    pub(crate) first: Vec<String>,
    /// The decisive number.
    pub(crate) sentence: String,
    /// Number of assumed values, if there are any.
    pub(crate) assumed: Option<String>,
    /// The meaning of the words, with their thresholds.
    pub(crate) scale: String,
}

/// The subject of a report on a structure.
pub(crate) fn kind_words(structure: &Structure, language: Language) -> &'static str {
    match structure {
        Structure::Chain(_) => language.pick(
            "Structural safety of a flagpole (chain of links)",
            "당간의 구조안전성 검토",
        ),
        Structure::Frame(_) => language.pick(
            "Structural safety of a frame of storeys",
            "문루(골조)의 구조안전성 검토",
        ),
        Structure::Stack(_) => language.pick("Stability of a stack of stones", "적층 석조물의 안정성 검토"),
        Structure::Building(_) => language.pick(
            "Stability and twist of a building of rigid floors",
            "건물의 안정성과 비틀림 검토",
        ),
        Structure::Survey => language.pick("Modes from ambient vibration", "상시진동 계측에 의한 모드 분석"),
    }
}

/// The name of a project in a language.
pub(crate) fn project_name(answer: &ProjectReport, language: Language) -> &str {
    language.pick(answer.project.name.english(), answer.project.name.korean())
}

/// Whether there is a verdict: on a model, or on surveys over the years with an open alarm.
pub(crate) fn has_headline(answer: &ProjectReport) -> bool {
    answer.state().is_some() || judge(&answer.answers).alarming.is_any()
}

/// A project in the list: the sign of the worst colour, its headline, the reason, and worse variants.
pub(crate) fn headline_line(answer: &ProjectReport, language: Language) -> String {
    let judgement = judge(&answer.answers);
    let mut all = Vec::new();
    all.extend(over_the_years(judgement.alarming).map(|said| said.text(language)));
    all.extend(judgement.headline().map(|of| headline(of, language)));
    all.extend(worse(answer, &judgement, language));
    format!("{} {}", judgement_sign(&judgement), all.join("; "))
}

/// The effect of an earthquake on a version that is not above demand, one word each.
fn shaken(judged: &VersionJudgement, structure: &Structure, language: Language) -> Vec<String> {
    let findings = judged.earthquake.iter();
    let worse = findings.filter(|of| of.word.colour() != Colour::Green);
    let mut words = Vec::new();
    for said in worse.map(|of| reason(of, structure, language)) {
        if !words.contains(&said) {
            words.push(said);
        }
    }
    words
}

fn reason(of: &EarthquakeFinding, structure: &Structure, language: Language) -> String {
    let word = of.word.word(language);
    let motion = of.motion.as_deref();
    match (&of.decided_by, motion) {
        (DecidedBy::Fall, Some(motion)) if matches!(structure, Structure::Stack(_)) => language.pick(
            format!("a stone falls under {motion}"),
            format!("{motion} 작용 시 낙하"),
        ),
        (DecidedBy::Fall, Some(motion)) => language.pick(
            format!("it falls under {motion}"),
            format!("{motion} 작용 시 전도"),
        ),
        (DecidedBy::Drift, Some(motion)) if of.word == Earthquake::BelowDemand => language.pick(
            format!("it leans too far under {motion}"),
            format!("{motion} 작용 시 과대 변위"),
        ),
        (DecidedBy::Room, motion) => {
            let word = match of.word {
                Earthquake::BelowDemand => language.pick("beyond its room", "여유 공간 초과"),
                _ => word,
            };
            let under: Vec<&str> = [of.part.as_deref(), motion].into_iter().flatten().collect();
            format!("{word} ({})", under.join(", "))
        }
        (DecidedBy::DamageState(state), Some(motion)) => format!("{word} ({motion}, DS{state})"),
        (_, Some(motion)) => format!("{word} ({motion})"),
        (_, None) => word.to_owned(),
    }
}

/// Variants that are worse than the structure as it is, with their words.
fn worse(answer: &ProjectReport, judgement: &Judgement, language: Language) -> Vec<String> {
    let each = judgement.worse().map(|judged| {
        let name = judged.variant.as_deref().unwrap_or_default();
        let own = answer.variants().iter().find(|variant| variant.name == name);
        let title = own.map_or_else(|| Both::of(|_| name), title);
        worse_words(title, judged).text(language)
    });
    each.collect()
}

/// The answers on a project, in a language.
pub(crate) fn banner(answer: &ProjectReport, state: &State, language: Language) -> Banner {
    let verdict = state.verdict();
    let judgement = judge(&answer.answers);
    let judged = judgement.headline();
    let words = judged.map(|of| headline(of, language));
    let words: Vec<String> = over_the_years(judgement.alarming)
        .map(|said| said.text(language))
        .into_iter()
        .chain(words)
        .collect();
    let words = words.join(" · ");
    let shaken = judged.map_or_else(Vec::new, |of| shaken(of, &answer.project.structure, language));
    let stack = match &state.check {
        Check::Stack(answer) => Some(answer),
        _ => None,
    };
    let factor_words = || match state.load_factor().filter(|_| verdict != Verdict::Unknown) {
        Some(load_factor) => format!("λ = {}.", beside_one(load_factor, 4)),
        None if state.load_factor() == Some(f64::INFINITY) => language
            .pick("No gravity load is given.", "축력이 주어지지 않음.")
            .into(),
        None => language
            .pick("Stiffness is not given.", "강성이 주어지지 않음.")
            .into(),
    };
    let sentence = stack.map_or_else(factor_words, |answer| stack::banner(answer).text(language));
    let inputs = judged
        .filter(|_| verdict != Verdict::Unknown)
        .map(|of| of.basis.inputs);
    let doubtful = doubtful(&answer.project).into_iter();
    let mut first: Vec<String> = doubtful.map(|said| said.text(language)).collect();
    let worse = worse(answer, &judgement, language).into_iter();
    first.extend(worse.map(|line| format!("{line}.")));
    if !shaken.is_empty() {
        let lead = language.pick(
            "The verdict on its own weight is without shaking. With shaking: ",
            "자중에 대한 판정은 지진이 없을 때의 것이다. 지진을 고려한 판정: ",
        );
        first.push(format!("{lead}{}.", shaken.join("; ")));
    }
    let deciding = state
        .contradictions
        .iter()
        .filter(|of| !of.is_too_rough && of.superseded_by.is_none());
    first.extend(deciding.map(|c| {
        let survey = printed_name(&c.survey, language);
        language.pick(
            format!(
                "A survey contradicts this model: {} measured {:.3} Hz, the model has {:.3} Hz.",
                survey, c.measured_hz, c.computed_hz
            ),
            format!(
                "조사 결과가 이 모델과 일치하지 않는다. {} 조사의 실측 {:.3} Hz, 모델 {:.3} Hz.",
                survey, c.measured_hz, c.computed_hz
            ),
        )
    }));
    Banner {
        colour: judgement.colour(),
        sign: judgement_sign(&judgement),
        words,
        first,
        sentence,
        assumed: inputs
            .filter(|of| of.assumed > 0)
            .map(|AssumedInputs { assumed, all }| {
                language.pick(
                    format!("This rests on assumed inputs, {assumed} of {all}; see the findings."),
                    format!("입력 {all}개 중 가정값 {assumed}개에 의존한다(결과 요약 참조)."),
                )
            }),
        scale: match stack {
            Some(_) => stack::thresholds().text(language),
            None => thresholds(language),
        },
    }
}

/// The program, the seed, the input and the papers behind a report.
pub(crate) fn sources(answer: &ProjectReport, language: Language, imprint: &Imprint) -> Vec<String> {
    let mut all = vec![format!(
        "{}{}",
        language.pick("Computed by ", "계산 프로그램: "),
        imprint.program
    )];
    if let Some(sampled) = answer.state().and_then(|state| state.sampled.as_ref()) {
        let lead = language.pick("Seed of the samples: ", "표본 추출 시드: ");
        all.push(format!("{lead}{}", sampled.unstable.seed));
    }
    if !answer.fingerprint.is_empty() {
        let print = answer.fingerprint.clone();
        all.push(Sentence::from(Given::Fingerprint { print }).text(language));
    }
    if let Some(source) = &answer.project.source {
        all.push(format!("{}{source}", language.pick("Input: ", "입력 자료: ")));
    }
    all.extend(papers(&answer.project.structure, language));
    all
}

fn papers(structure: &Structure, language: Language) -> Vec<String> {
    match structure {
        Structure::Chain(_) => vec![["최재성 (2021) 5개의 연결부를 가지는 역진자형 석조문화재의 동적 해석모델 및 안정성 연구 / Choi, J.-S. (2021) A study on dynamic analysis model and stability of stone cultural properties of inverted pendulum type with 5 joints. ", language.pick("The published criterion: eqs 38–43, Tables 1–3.", "발표된 기준: 식 38–43, 표 1–3.")].concat()],
        Structure::Frame(_) => vec![["박성아, 민경원 (2010) 흥인지문의 쿨롱 마찰력을 도입한 단순 해석모델 / Park, S.-A., Min, K.-W. (2010) Simple structural model of Heunginjimun with Coulomb friction. ", language.pick("The printed stiffness: eq. 7.", "논문의 강성: 식 7.")].concat()],
        Structure::Stack(_) => vec![["Kim, N., Koo, I. Y. & Hong, S. G. (2018) Assessment factors for seismic performance of multi-block stone pagodas. ", language.pick("Rocking and sliding of joints: sec. 3, Figs 10 and 12; joint stiffness: Fig. 17.", "접합면의 로킹과 미끄러짐: 3절, 그림 10, 12; 접합면 강성: 그림 17.")].concat(), "Housner, G. W. (1963) The behavior of inverted pendulum structures during earthquakes. Bull. Seism. Soc. Am. 53(2):403–417.".to_owned()],
        Structure::Building(_) => vec![["황재승, 민경원, 홍성목: 동적 하중을 받는 횡-비틀림 방향이 조합된 고층건물의 진동 제어에 관한 연구 / Hwang, J.-S., Min, K.-W. & Hong, S.-M. Control of coupled lateral torsional vibration of tall building under dynamic lateral loads. ", language.pick("Mode centre: eq. 12.", "모드 중심: 식 12.")].concat(), "Der Kiureghian, A. (1981) A response spectrum method for random vibration analysis of MDF systems. Earthquake Engng Struct. Dyn. 9:419–435.".to_owned()],
        Structure::Survey => Vec::new(),
    }
}

/// The closing text of every report.
pub(crate) fn closing(language: Language) -> &'static str {
    language.pick(
            "The same input gives the same numbers. This page supports the judgement of an engineer; it does not replace it.",
            "입력이 같으면 결과도 같다. 이 보고서는 기술자의 판단을 돕기 위한 것이며 이를 대신하지 않는다.",
        )
}
