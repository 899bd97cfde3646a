//! The parts before and after the sections of a report, in a language: its kind and name, the answers, method and sources.

use super::fronted::{Fronted, hertz, text};
use super::imprint::{Imprint, NotReported};
use super::words::{judgement_sign, thresholds};
use crate::check::{doubtful, title};
use crate::engineer::Given;
use crate::headline::{as_given, headline, over_the_years, worse as worse_words};
use crate::stack;
use crate::stack_simulation::{settled_laws, settled_scale};
use dolmen::stability::Verdict;
use dolmen_project::Structure;
use dolmen_words::message::Both;
use dolmen_words::number::beside_one;
use dolmen_words::{Language, Sentence};
use dolmen_work::answer::{FileRead, ProjectReport};
use dolmen_work::judgement::{
    AssumedInputs, Colour, DecidedBy, Earthquake, EarthquakeFinding, Judgement, VersionJudgement, judge,
};
use dolmen_work::stack::SettledSimulation;
use dolmen_work::state::{Check, State};
use dolmen_work::study::fingerprint;
use std::collections::BTreeSet;

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
            "골조의 구조안전성 검토",
        ),
        Structure::Stack(_) => language.pick("Stability of a stack of stones", "적층 석조물의 안정성 검토"),
        Structure::Building(_) => language.pick(
            "Stability and twist of a building of rigid floors",
            "건물의 안정성과 비틀림 검토",
        ),
        Structure::Survey => language.pick("What was measured", "진동·변위 계측 결과"),
    }
}

/// The name of a project in a language.
pub(crate) fn project_name(answer: &ProjectReport, language: Language) -> &str {
    language.pick(answer.project.name.english(), answer.project.name.korean())
}

/// Whether there is a verdict: on a model, or on surveys over the years with an open alarm.
pub(crate) fn has_headline(answer: &ProjectReport) -> bool {
    let has_verdict = answer.state().is_some() || answer.settled_stones().next().is_some();
    has_verdict || judge(&answer.answers).alarming.is_any()
}

/// A project in the list: the sign of the worst colour, its headline, the reason, and worse variants.
pub(crate) fn headline_line(answer: &ProjectReport, language: Language) -> String {
    let judgement = judge(&answer.answers);
    format!(
        "{} {}",
        judgement_sign(&judgement),
        headline_words(answer, &judgement, language)
    )
}

/// Several projects, each with its verdict, and those that are not reported.
pub(crate) fn listed(answers: &[ProjectReport], others: &[NotReported], language: Language) -> Vec<String> {
    let each = answers.iter().map(|answer| {
        let name = project_name(answer, language);
        match has_headline(answer) {
            true => format!(
                "{name}: {}",
                headline_words(answer, &judge(&answer.answers), language)
            ),
            false => name.to_owned(),
        }
    });
    let others = others.iter().map(|other| {
        let head = text(Fronted::NotReported, language);
        format!("{head}: {}", other.file)
    });
    each.chain(others).collect()
}

fn headline_words(answer: &ProjectReport, judgement: &Judgement, language: Language) -> String {
    let mut all = Vec::new();
    all.extend(over_the_years(judgement).map(|said| said.text(language)));
    all.extend(judgement.headline().map(|of| own_words(of, judgement, language)));
    all.extend(worse(answer, judgement.worse(), language));
    all.join("; ")
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
        (DecidedBy::Fall, Some(motion)) => {
            let motion = Both::from(motion);
            match structure {
                Structure::Stack(_) => text(Fronted::StoneFalls(motion), language),
                _ => text(Fronted::Falls(motion), language),
            }
        }
        (DecidedBy::Drift, Some(motion)) if of.word == Earthquake::BelowDemand => {
            let motion = Both::from(motion);
            text(Fronted::LeansTooFar(motion), language)
        }
        (DecidedBy::Room, motion) => {
            let word = match of.word {
                Earthquake::BelowDemand => text(Fronted::BeyondRoom, language),
                _ => word.to_owned(),
            };
            let under: Vec<&str> = [of.part.as_deref(), motion].into_iter().flatten().collect();
            format!("{word} ({})", under.join(", "))
        }
        (DecidedBy::DamageState(state), Some(motion)) => format!("{word} ({motion}, DS{state})"),
        (_, Some(motion)) => format!("{word} ({motion})"),
        (_, None) => word.to_owned(),
    }
}

/// Whether a variant gives a judgement its colour, and the structure as it is does not.
fn decides(variant: &VersionJudgement, judgement: &Judgement) -> bool {
    let own = judgement.headline().map(VersionJudgement::colour);
    variant.colour() == judgement.colour() && own < Some(variant.colour())
}

/// The words of the structure as it is; named as such where a variant is worse and decides the colour.
fn own_words(of: &VersionJudgement, judgement: &Judgement, language: Language) -> String {
    match judgement.worse().any(|variant| decides(variant, judgement)) {
        true => as_given(of).text(language),
        false => headline(of, language),
    }
}

/// Variants that are worse than the structure as it is, with their words.
fn worse<'a>(
    answer: &ProjectReport,
    variants: impl Iterator<Item = &'a VersionJudgement>,
    language: Language,
) -> Vec<String> {
    let each = variants.map(|judged| {
        let name = judged.variant.as_deref().unwrap_or_default();
        let own = answer.variants().iter().find(|variant| variant.name == name);
        let title = own.map_or_else(|| Both::of(|_| name), title);
        worse_words(title, judged).text(language)
    });
    each.collect()
}

/// The answers on a project, in a language; `None` without a model, alarms and changes.
pub(crate) fn banner(answer: &ProjectReport, language: Language) -> Option<Banner> {
    match (answer.state(), answer.settled_stones().next()) {
        (Some(state), _) => Some(of_state(answer, state, language)),
        (None, Some(run)) => Some(of_loose(answer, run, language)),
        (None, None) => of_years(answer, language),
    }
}

/// What surveys without a model show over the years.
fn of_years(answer: &ProjectReport, language: Language) -> Option<Banner> {
    let judgement = judge(&answer.answers);
    let words = over_the_years(&judgement)?;
    Some(Banner {
        colour: judgement.colour(),
        sign: judgement_sign(&judgement),
        words: words.text(language),
        first: Vec::new(),
        sentence: text(Fronted::NoModel, language),
        assumed: None,
        scale: text(Fronted::YearsScale, language),
    })
}

/// The answers on loose stones.
fn of_loose(answer: &ProjectReport, run: &SettledSimulation, language: Language) -> Banner {
    let judgement = judge(&answer.answers);
    let judged = judgement.headline();
    let doubtful = doubtful(&answer.project).into_iter();
    let inputs = judged.map(|of| of.basis.inputs);
    Banner {
        colour: judgement.colour(),
        sign: judgement_sign(&judgement),
        words: judged.map_or_else(String::new, |of| headline(of, language)),
        first: doubtful.map(|said| said.text(language)).collect(),
        sentence: settled_laws(run).text(language),
        assumed: inputs.and_then(|of| resting(of, language)),
        scale: settled_scale().text(language),
    }
}

/// The number of assumed inputs, if there are any.
fn resting(AssumedInputs { assumed, all }: AssumedInputs, language: Language) -> Option<String> {
    (assumed > 0).then(|| text(Fronted::RestsOnAssumed { assumed, all }, language))
}

fn of_state(answer: &ProjectReport, state: &State, language: Language) -> Banner {
    let verdict = state.verdict();
    let judgement = judge(&answer.answers);
    let judged = judgement.headline();
    let words = judged.map(|of| own_words(of, &judgement, language));
    let words: Vec<String> = over_the_years(&judgement)
        .map(|said| said.text(language))
        .into_iter()
        .chain(words)
        .collect();
    // the variants that give the box its colour stand in its heading
    let (deciding, further): (Vec<_>, Vec<_>) = judgement.worse().partition(|of| decides(of, &judgement));
    let deciding = worse(answer, deciding.into_iter(), language);
    let words: Vec<String> = [words.join(" · ")].into_iter().chain(deciding).collect();
    let words = words.join(". ");
    let shaken = judged.map_or_else(Vec::new, |of| shaken(of, &answer.project.structure, language));
    let stack = match &state.check {
        Check::Stack(answer) => Some(answer),
        _ => None,
    };
    let factor_words = || match state.load_factor().filter(|_| verdict != Verdict::Unknown) {
        Some(load_factor) => format!("λ = {}.", beside_one(load_factor, 4)),
        None if state.load_factor() == Some(f64::INFINITY) => text(Fronted::NoGravityLoad, language),
        None => text(Fronted::NoStiffness, language),
    };
    let sentence = stack.map_or_else(factor_words, |answer| stack::banner(answer).text(language));
    let inputs = judged
        .filter(|_| verdict != Verdict::Unknown)
        .map(|of| of.basis.inputs);
    let doubtful = doubtful(&answer.project).into_iter();
    let mut first: Vec<String> = doubtful.map(|said| said.text(language)).collect();
    let further = worse(answer, further.into_iter(), language).into_iter();
    first.extend(further.map(|line| format!("{line}.")));
    if !shaken.is_empty() {
        let reasons = Both::from(shaken.join("; "));
        first.push(text(Fronted::Shaken(reasons), language));
    }
    let deciding = state
        .contradictions
        .iter()
        .filter(|of| !of.is_too_rough && of.superseded_by.is_none());
    first.extend(deciding.map(|c| {
        let said = Fronted::Contradicted {
            survey: c.survey.clone(),
            measured: hertz(c.measured_hz),
            computed: hertz(c.computed_hz),
        };
        text(said, language)
    }));
    Banner {
        colour: judgement.colour(),
        sign: judgement_sign(&judgement),
        words,
        first,
        sentence,
        assumed: inputs.and_then(|of| resting(of, language)),
        scale: match stack {
            Some(_) => stack::thresholds().text(language),
            None => thresholds(language),
        },
    }
}

/// The program, the seed, the input and the papers behind a report.
pub(crate) fn sources(answer: &ProjectReport, language: Language, imprint: &Imprint) -> Vec<String> {
    let program = Both::from(imprint.program.as_str());
    let mut all = vec![text(Fronted::ComputedBy(program), language)];
    let variants = answer.check().into_iter().flat_map(|check| &check.variants);
    let mut states = answer
        .state()
        .into_iter()
        .chain(variants.map(|variant| &variant.state));
    if let Some(sampled) = states.find_map(|state| state.sampled.as_ref()) {
        let (samples, seed) = (sampled.unstable.samples, sampled.unstable.seed);
        all.push(text(Fronted::SamplesFrom { samples, seed }, language));
    }
    if !answer.fingerprint.is_empty() {
        let print = answer.fingerprint.clone();
        all.push(Sentence::from(Given::Fingerprint(print)).text(language));
    }
    all.extend(files_read(&answer.files).map(|said| said.text(language)));
    if let Some(source) = &answer.project.source {
        let source = Both::from(source.as_str());
        all.push(text(Fronted::InputFrom(source), language));
    }
    let codes = codes(answer).into_iter().map(Both::from);
    all.extend(codes.map(|code| text(Fronted::SiteCode(code), language)));
    all.extend(papers(&answer.project.structure, language));
    all
}

/// The codes of the sites, each once.
fn codes(answer: &ProjectReport) -> BTreeSet<String> {
    let versions = judge(&answer.answers).versions;
    let sources = versions.into_iter().filter_map(|version| version.demand_source);
    sources.map(|(code, _)| code).collect()
}

/// The other files behind a report, each with its fingerprint; of many one fingerprint of all.
fn files_read(files: &[FileRead]) -> impl Iterator<Item = Sentence> {
    /// Most files with a line of their own. Our choice: half a page.
    const LISTED_MOST: usize = 30;
    let each = files.iter().map(|of| Given::FileRead {
        name: of.name.clone(),
        bytes: of.bytes.to_string(),
        print: of.fingerprint.clone(),
    });
    let together = || {
        let all: Vec<String> = files
            .iter()
            .map(|of| format!("{} {}", of.name, of.fingerprint))
            .collect();
        Given::FilesRead {
            count: files.len(),
            print: fingerprint(all.join("\n").as_bytes()),
        }
    };
    let said: Vec<Given> = match files.len() {
        0..=LISTED_MOST => each.collect(),
        _ => vec![together()],
    };
    said.into_iter().map(Sentence::from)
}

/// The works that a kind of structure rests on.
const CHAIN_WORK: &str = "최재성 (2021) 5개의 연결부를 가지는 역진자형 석조문화재의 동적 해석모델 및 안정성 연구 / Choi, J.-S. (2021) A study on dynamic analysis model and stability of stone cultural properties of inverted pendulum type with 5 joints.";
const FRAME_WORK: &str = "박성아, 민경원 (2010) 흥인지문의 쿨롱 마찰력을 도입한 단순 해석모델 / Park, S.-A., Min, K.-W. (2010) Simple structural model of Heunginjimun with Coulomb friction.";
const STACK_WORK: &str = "Kim, N., Koo, I. Y. & Hong, S. G. (2018) Assessment factors for seismic performance of multi-block stone pagodas.";
const ROCKING_WORK: &str = "Housner, G. W. (1963) The behavior of inverted pendulum structures during earthquakes. Bull. Seism. Soc. Am. 53(2):403–417.";
const LIMIT_WORK: &str = "Livesley, R. K. (1978) Limit analysis of structures formed from rigid blocks. Int. J. Numer. Methods Eng. 12:1853–1871.";
const BUILDING_WORK: &str = "황재승, 민경원, 홍성목: 동적 하중을 받는 횡-비틀림 방향이 조합된 고층건물의 진동 제어에 관한 연구 / Hwang, J.-S., Min, K.-W. & Hong, S.-M. Control of coupled lateral torsional vibration of tall building under dynamic lateral loads.";
const RANDOM_VIBRATION_WORK: &str = "Der Kiureghian, A. (1981) A response spectrum method for random vibration analysis of MDF systems. Earthquake Engng Struct. Dyn. 9:419–435.";

fn papers(structure: &Structure, language: Language) -> Vec<String> {
    let (said, further): (Fronted, &[&str]) = match structure {
        Structure::Chain(_) => (Fronted::ChainPaper(CHAIN_WORK.into()), &[]),
        Structure::Frame(_) => (Fronted::FramePaper(FRAME_WORK.into()), &[]),
        Structure::Stack(part) if part.is_loose => return Vec::new(),
        Structure::Stack(_) => (
            Fronted::StackPaper(STACK_WORK.into()),
            &[ROCKING_WORK, LIMIT_WORK],
        ),
        Structure::Building(_) => (
            Fronted::BuildingPaper(BUILDING_WORK.into()),
            &[RANDOM_VIBRATION_WORK],
        ),
        Structure::Survey => return Vec::new(),
    };
    let own = text(said, language);
    let further = further.iter().map(|work| (*work).to_owned());
    [own].into_iter().chain(further).collect()
}

/// The closing text of every report.
pub(crate) fn closing(language: Language) -> String {
    text(Fronted::Closing, language)
}
