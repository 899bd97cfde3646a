//! The page: head, verdict, findings, sections, method, evidence.

use super::given;
use super::style::STYLE;
use super::words::{colour_class, judgement_sign, thresholds};
use crate::check::title;
use crate::document::{document_html, findings_html};
use crate::mark::GENERATOR;
use crate::stack;
use crate::whole::{all_findings, whole_document};
use dolmen::stability::Verdict;
use dolmen_project::{Quantity, Structure};
use dolmen_words::Language;
use dolmen_words::number::beside_one;
use dolmen_work::answer::ProjectReport;
use dolmen_work::judgement::{
    Colour, DecidedBy, Earthquake, EarthquakeFinding, Judgement, VersionJudgement, judge,
};
use dolmen_work::state::{Check, State};
use maud::{DOCTYPE, Markup, PreEscaped, html as markup};

/// Who made the page, and when.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Imprint {
    /// Name and version of the program: "dolmen 0.1.0".
    pub program: String,
    /// When, as it is to be printed: "2026-05-12"; `None` leaves it out, so that the same input gives the same page.
    pub date: Option<String>,
}

/// A project that could not be reported on.
#[derive(Clone, Debug, PartialEq)]
pub struct NotReported {
    /// Its file or folder, as it was named.
    pub file: String,
    /// Why.
    pub why: String,
}

/// The report on one or more projects as a page that needs nothing else: no script, no font, no picture from outside.
///
/// Several projects begin on a page of their own in print, and a list of them stands at the top. What an answer does
/// not hold is left out or called unknown. Projects that could not be reported on are named before all others.
pub fn html(
    answers: &[ProjectReport],
    others: &[NotReported],
    language: Language,
    imprint: &Imprint,
) -> String {
    let title = match (answers, others) {
        ([one], []) => project_name(one, language).to_string(),
        _ => language.pick("Reports", "보고서 모음").to_string(),
    };
    let body = markup! {
        @if answers.len() + others.len() > 1 { (contents(answers, others, language)) }
        @for (i, answer) in answers.iter().enumerate() {
            article id=(format!("report-{}", i + 1)) { (article(answer, language, imprint)) }
        }
    };
    let page = whole(&title, language, &body);
    // the title holds no tags
    let (head, body) = page.split_at(page.find("<body>").unwrap_or(0));
    let body = body
        .replace("k_cr", "k<sub>cr</sub>")
        .replace("k_min", "k<sub>min</sub>");
    format!("{head}{body}")
}

/// What a page may load and do: its own style sheet and the styles in its figures. No script, nothing from outside, no form.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; base-uri 'none'; form-action 'none'";

/// A page that needs nothing else.
pub(super) fn whole(title: &str, language: Language, body: &Markup) -> String {
    markup! {
        (DOCTYPE)
        html lang=(language.code()) {
            head {
                meta charset="utf-8";
                meta http-equiv="Content-Security-Policy" content=(POLICY);
                meta name="generator" content=(GENERATOR);
                meta name="viewport" content="width=device-width, initial-scale=1";
                title { (title) }
                style { (PreEscaped(STYLE)) }
            }
            body { (body) }
        }
    }
    .into_string()
}

fn contents(answers: &[ProjectReport], others: &[NotReported], language: Language) -> Markup {
    markup! {
        nav {
            h1 { (language.pick("Reports", "보고서 모음")) }
            ol { @for (i, answer) in answers.iter().enumerate() {
                li {
                    a href=(format!("#report-{}", i + 1)) { (project_name(answer, language)) }
                    @if answer.state().is_some() { ": " (headline_line(answer, language)) }
                }
            } }
            @for other in others {
                p.note {
                    (language.pick("Not reported on: ", "보고서에서 제외됨: ")) code { (other.file) } ": "
                    (language.pick("", "[영문] ")) (other.why)
                }
            }
        }
    }
}

/// A project in the list: the sign of the worst colour, the words of its headline, why, and variants that are worse.
pub(crate) fn headline_line(answer: &ProjectReport, language: Language) -> String {
    let judgement = judge(&answer.answers);
    let mut all = Vec::new();
    if let Some(headline) = judgement.headline() {
        all.push(headline.words(language).join(" · "));
        let word = headline.earthquake_word().word(language);
        let reasons = shaken(headline, &answer.project.structure, language);
        all.extend(reasons.into_iter().filter(|reason| reason != word));
    }
    all.extend(worse(answer, &judgement, language));
    format!("{} {}", judgement_sign(&judgement), all.join("; "))
}

/// The name of a project in a language.
pub(crate) fn project_name(answer: &ProjectReport, language: Language) -> &str {
    language.pick(answer.project.name.english(), answer.project.name.korean())
}

fn article(answer: &ProjectReport, language: Language, imprint: &Imprint) -> Markup {
    let project = &answer.project;
    let other = language.pick(project.name.korean(), project.name.english());
    let kind = match &project.structure {
        Structure::Chain(_) => language.pick(
            "Stability of a chain of rigid links",
            "강체 링크 체인 모델의 안정성 검토",
        ),
        Structure::Frame(_) => language.pick(
            "Stability of a frame of rigid storeys",
            "강체 층 골조 모델의 안정성 검토",
        ),
        Structure::Stack(_) => language.pick("Stability of a stack of stones", "적층 석조물의 안정성 검토"),
        Structure::Building(_) => language.pick(
            "Stability and twist of a building of rigid floors",
            "강체 바닥 건물 모델의 안정성과 비틀림 검토",
        ),
        Structure::Survey => language.pick("Modes from ambient vibration", "상시진동 계측에 의한 모드 분석"),
    };
    markup! {
        header {
            p.kicker { (kind) }
            h1 { (project_name(answer, language)) }
            @if other != project_name(answer, language) { p.sub { (other) } }
            p.sub {
                @if let Some(date) = &imprint.date { (date) " · " }
                (imprint.program)
            }
        }
        @if let Some(state) = answer.state() { (banner(answer, state, language)) }
        h2 { (language.pick("Findings", "검토 결과 요약")) }
        (findings_html(&all_findings(answer), language))
        (given::section(answer, language))
        (document_html(&whole_document(answer), language))
        (method(answer, language))
        (evidence(answer, language, imprint))
    }
}

/// What an earthquake does to a version that is not above demand, a word each.
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
        (DecidedBy::Room { part }, motion) => {
            let word = match of.word {
                Earthquake::BelowDemand => language.pick("beyond its room", "여유 공간 초과"),
                _ => word,
            };
            let under: Vec<&str> = [Some(part.as_str()), motion].into_iter().flatten().collect();
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
        let title = own.map(title);
        let title = title.as_ref().map_or(name, |title| title.text(language));
        let words = judged.words(language).join(" · ");
        language.pick(
            format!("Variant “{title}”: {words}"),
            format!("대안 ‘{title}’: {words}"),
        )
    });
    each.collect()
}

fn banner(answer: &ProjectReport, state: &State, language: Language) -> Markup {
    let verdict = state.verdict();
    let judgement = judge(&answer.answers);
    let headline = judgement.headline();
    let words = headline.map_or_else(Vec::new, |of| of.words(language));
    let shaken = headline.map_or_else(Vec::new, |of| shaken(of, &answer.project.structure, language));
    let class = colour_class(judgement.colour());
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
    // What a survey assumes touches stiffness from vibration, not this verdict.
    let structural = |q: &&Quantity| q.is_assumed() && !q.path.starts_with("survey.");
    let inputs = answer.project.inputs();
    let assumed = if verdict == Verdict::Unknown {
        0
    } else {
        inputs.into_iter().filter(structural).count()
    };
    markup! {
        div class=(format!("verdict {class}")) {
            div.word { (judgement_sign(&judgement)) " " (words.join(" · ")) }
            div {
                @for worse in worse(answer, &judgement, language) { p { b { (worse) "." } } }
                @if !shaken.is_empty() {
                    p { b { (language.pick("Without shaking only. With shaking: ", "지진이 없을 때에 한함. 지진 시: ")) (shaken.join("; ")) "." } }
                }
                @for c in &state.contradictions {
                    p { b { (language.pick(
                        format!("A survey contradicts this model: {} measured {:.3} Hz, the model has {:.3} Hz.", c.survey, c.measured_hz, c.computed_hz),
                        format!("조사 결과가 이 모델과 일치하지 않는다. {} 조사의 실측 {:.3} Hz, 모델 {:.3} Hz.", c.survey, c.measured_hz, c.computed_hz),
                    )) } }
                }
                p { b { (sentence) }
                    @if assumed > 0 { " " (language.pick(
                        format!("This rests on {assumed} assumed values; see the findings."),
                        format!("가정값 {assumed}개에 의존한다(결과 요약 참조)."),
                    )) }
                }
                p.scale { @if stack.is_some() { (stack::thresholds().text(language)) } @else { (thresholds(language)) } }
            }
        }
    }
}

fn method(answer: &ProjectReport, language: Language) -> Markup {
    let lines: Vec<&str> = match answer.project.structure {
        Structure::Chain(_) => vec![
            language.pick(
                "Rigid links on linear rotational springs, small rotations, static gravity. The chain stands if and only if its stiffness matrix with gravity is positive definite.",
                "강체 부재와 선형 회전 스프링, 미소 회전, 정적 중력을 가정하였다. 중력을 포함한 강성행렬이 양정부호일 때, 그리고 그때에만 안정하다.",
            ),
            language.pick(
                "λ is the smallest factor on gravity that makes this matrix singular. The margin of a joint is its stiffness over the least one at which the chain stands, the other joints as they are.",
                "λ는 이 행렬을 특이하게 만드는 가장 작은 중력 배수이다. 접합면의 여유도는 다른 접합면을 그대로 두었을 때 안정을 유지하는 최소 강성에 대한 현재 강성의 비이다.",
            ),
            language.pick(
                "Not covered by λ: earthquake and wind, strength and ageing of stone, slipping, opening of joints, foundations other than the lowest spring, and plan directions other than the one modelled.",
                "λ의 검토 범위 밖: 지진과 바람, 석재의 강도와 노후, 미끄러짐, 접합면의 벌어짐, 최하단 스프링 외의 지반, 모델링하지 않은 방향.",
            ),
        ],
        Structure::Frame(_) => vec![
            language.pick(
                "Rigid storeys on linear lateral springs; gravity enters as P-delta. Each direction is a frame of its own; twisting modes are reported and kept out.",
                "강체 층과 선형 횡방향 스프링, 중력은 P-델타 효과로 고려하였다. 각 방향은 독립된 골조이며 비틀림모드는 보고하되 추정에서 제외하였다.",
            ),
            language.pick(
                "λ is the smallest factor on all axial forces that makes the stiffness matrix singular.",
                "λ는 강성행렬을 특이하게 만드는 가장 작은 축력 배수이다.",
            ),
            language.pick(
                "Not covered by λ: friction and its loss under strong shaking, earthquake (where one was simulated, it has a section of its own) and wind, strength and decay of timber. Stiffness from ambient vibration is that of very small motion and falls as motion grows.",
                "λ의 검토 범위 밖: 마찰과 강한 진동에서의 마찰 저하, 지진(시뮬레이션한 경우 별도의 절 참조)과 바람, 목재의 강도와 부후. 상시진동으로 얻은 강성은 극히 작은 진폭의 값이며 진폭이 커지면 감소한다.",
            ),
        ],
        Structure::Stack(_) => vec![
            language.pick(
                "Rigid stones on joints that bear pressure and friction and, unless a bond is given, no tension. Every edge of every joint is tried for the acceleration at which what stands on it tips or slides; where stones share their load, a limit analysis decides.",
                "부재는 강체이며 접합면은 압축과 마찰에만 저항하고, 부착이 주어지지 않으면 인장에 저항하지 않는다. 모든 접합면의 모든 모서리에 대하여 상부가 전도되거나 미끄러지는 가속도를 구하였다. 하중을 나누어 받는 부재가 있으면 한계해석으로 판정한다.",
            ),
            language.pick(
                "Simulated earthquakes: the same stones on contact springs with Coulomb friction and dashpots, in three dimensions with large turns; the ground is a rigid plane.",
                "지진응답 시뮬레이션: 동일한 부재를 쿨롱 마찰과 감쇠를 가진 접촉 스프링 위에 놓고 큰 회전을 포함하여 3차원으로 해석하였다. 지반은 강체 평면이다.",
            ),
            language.pick(
                "Not covered: cracking and crushing of stone, settlement and softness of the ground under shaking, ageing. The thresholds are those of first motion, not of collapse.",
                "검토 범위 밖: 석재의 균열과 압괴, 지진 중 지반의 침하와 변형, 노후. 한계 가속도는 최초 거동의 값이며 붕괴의 값이 아니다.",
            ),
        ],
        Structure::Building(_) => vec![
            language.pick(
                "Floors are rigid in their plane and rest on linear walls and columns: two displacements and a rotation each. The weight acts where the mass is (P-delta), straight down.",
                "바닥은 면내 강체이고 선형의 벽체와 기둥이 지지하며, 층마다 두 변위와 한 회전을 가진다. 무게는 질량이 있는 위치에서 연직으로 작용한다(P-델타).",
            ),
            language.pick(
                "λ is the smallest factor on the weight at which a storey sways or twists without end; storeys fall one by one.",
                "λ는 어느 한 층이 횡변위 또는 비틀림으로 무너지는 가장 작은 무게의 배수이다.",
            ),
            language.pick(
                "Not covered: walls that bend over several storeys as one, floors that are soft in their plane, rocking of the foundation, yielding and cracking, strength.",
                "검토 범위 밖: 여러 층에 걸친 벽체의 휨, 면내로 유연한 바닥, 기초의 회전, 항복과 균열, 강도.",
            ),
        ],
        Structure::Survey => vec![language.pick(
            "Only what was measured is reported; no model was made, so that nothing is said about stability.",
            "계측 결과만 보고한다. 해석 모델이 없으므로 안정성은 판단하지 않는다.",
        )],
    };
    markup! {
        h2 { (language.pick("Method and limits", "방법과 한계")) }
        ul { @for line in lines { li { (line) } } }
    }
}

fn evidence(answer: &ProjectReport, language: Language, imprint: &Imprint) -> Markup {
    let chain = matches!(answer.project.structure, Structure::Chain(_));
    let frame = matches!(answer.project.structure, Structure::Frame(_));
    let stack = matches!(answer.project.structure, Structure::Stack(_));
    let building = matches!(answer.project.structure, Structure::Building(_));
    markup! {
        h2 { (language.pick("Evidence and sources", "근거와 출처")) }
        ul {
            li { (language.pick("Computed by ", "계산 프로그램: ")) (imprint.program) }
            @if let Some(sampled) = answer.state().and_then(|s| s.sampled.as_ref()) {
                li { (language.pick("Seed of the samples: ", "표본 추출 시드: ")) (sampled.unstable.seed) }
            }
            @if let Some(source) = &answer.project.source { li { (language.pick("Input: ", "입력 자료: ")) (source) } }
            @if chain {
                li { "최재성 (2021) 5개의 연결부를 가지는 역진자형 석조문화재의 동적 해석모델 및 안정성 연구 / Choi, J.-S. (2021) A study on dynamic analysis model and stability of stone cultural properties of inverted pendulum type with 5 joints. "
                    (language.pick("The published criterion: eqs 38–43, Tables 1–3.", "발표된 기준: 식 38–43, 표 1–3.")) }
            }
            @if stack {
                li { "Kim, N., Koo, I. Y. & Hong, S. G. (2018) Assessment factors for seismic performance of multi-block stone pagodas. "
                    (language.pick("Rocking and sliding of joints: sec. 3, Figs 10 and 12; joint stiffness: Fig. 17.", "접합면의 로킹과 미끄러짐: 3절, 그림 10, 12; 접합면 강성: 그림 17.")) }
                li { "Housner, G. W. (1963) The behavior of inverted pendulum structures during earthquakes. Bull. Seism. Soc. Am. 53(2):403–417." }
            }
            @if building {
                li { "황재승, 민경원, 홍성목: 동적 하중을 받는 횡-비틀림 방향이 조합된 고층건물의 진동 제어에 관한 연구 / Hwang, J.-S., Min, K.-W. & Hong, S.-M. Control of coupled lateral torsional vibration of tall building under dynamic lateral loads. "
                    (language.pick("Mode centre: eq. 12.", "모드 중심: 식 12.")) }
                li { "Der Kiureghian, A. (1981) A response spectrum method for random vibration analysis of MDF systems. Earthquake Engng Struct. Dyn. 9:419–435." }
            }
            @if frame {
                li { "박성아, 민경원 (2010) 흥인지문의 쿨롱 마찰력을 도입한 단순 해석모델 / Park, S.-A., Min, K.-W. (2010) Simple structural model of Heunginjimun with Coulomb friction. "
                    (language.pick("The printed stiffness: eq. 7.", "논문의 강성: 식 7.")) }
            }
        }
        footer { (language.pick(
            "The same input gives the same numbers. This page supports the judgement of an engineer; it does not replace it.",
            "같은 입력은 같은 결과를 준다. 이 보고서는 기술자의 판단을 돕기 위한 것이며 이를 대신하지 않는다.",
        )) }
    }
}
