//! Findings of a check, for all kinds.

use super::agreement::agreement;
use super::{assumed, from_surveys, measured, sampled, variants};
use crate::document::{Finding, Tone};
use crate::watch::beyond_limits;
use crate::{building, chain, demand, frame, loads, stack};
use dolmen_project::{Project, Structure};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Unit, messages};
use dolmen_work::answer::{CheckAnswer, UnreadableMotion};
use dolmen_work::inspected::inspected_beyond;
use dolmen_work::judgement::{Colour, Evidence, drift_left, missed_modes};
use dolmen_work::state::{Check, LOAD_FACTOR_USUAL_MOST, State};
use dolmen_work::survey_date;

messages! {
    /// Findings common to all kinds.
    pub(crate) enum Unusual in "check.unusual" {
        Identify => {
            en: "What to do next: measure its vibration and let «`dolmen identify`|the identification from vibration» find the stiffness.",
            ko: "다음 단계: 진동을 계측하고 «`dolmen identify`|진동 평가»로 강성을 추정한다.",
        },
        Write => {
            en: "What to do next: find the stiffness from its vibration« (`dolmen identify`); if a survey determines it uniquely, `dolmen identify PROJECT --write` puts it into the file».",
            ko: "다음 단계: 진동 기록으로 강성을 추정한다«(`dolmen identify`). 한 조사로 하나만 정해지면 `dolmen identify PROJECT --write`가 그 값을 파일에 쓴다».",
        },
        RecordsUnread { survey: String } => {
            en: "The records of survey {survey} are not compared with this model here: «`dolmen identify`|the identification from vibration» finds their modes, and «`dolmen report`|the report» holds them against it.",
            ko: "{survey} 조사의 진동 기록은 이 검토에서 모델과 비교하지 않았다. «`dolmen identify`|진동 평가»가 모드를 구하고, «`dolmen report`|보고서»가 모델과 비교한다.",
        },
        NewerUnread { survey: String, compared: String } => {
            en: "The newest survey, {survey}, has records of vibration that a check does not read; the comparison of frequencies is that of survey {compared}. «`dolmen identify`|The identification from vibration» reads them, and finds an earthquake in them if there is one; «`dolmen report`|the report» holds them against the model.",
            ko: "최근 조사 {survey}에는 이 검토에서 읽지 않는 진동 기록이 있으며, 계측 고유진동수와의 비교는 {compared} 조사의 것이다. «`dolmen identify`|진동 평가»가 기록을 읽고 지진이 들어 있는지도 찾는다. «`dolmen report`|보고서»가 모델과 비교한다.",
        },
        MarkedAssumed { survey: String, evidence: Both } => {
            en: "{evidence}.« If survey {survey} did measure them, mark them in the file as measured (`source = \"measured\"`).»",
            ko: "{evidence}.« {survey} 조사에서 실제로 계측한 값이면 입력 파일에 계측값으로 표시한다(`source = \"measured\"`).»",
        },
        InDoubt { evidence: Both } => {
            en: "The model is {evidence}. The lowest frequencies alone do not confirm it: check which modes these are, the stiffness and the masses.",
            ko: "모델 {evidence}. 최저 고유진동수만으로는 모델을 확인할 수 없으므로 모드의 차수, 강성, 질량을 확인해야 한다.",
        },
        ModeMissed { survey: String, number: usize, direction: String, computed: Quantity } => {
            en: "Survey {survey}: no measured mode is paired with mode {number} of the model in direction {direction} ({computed}), and those above are compared with the next. If the survey missed none, the model is not the structure; measured shapes decide it.",
            ko: "{survey} 조사: 모델의 {direction} 방향 {number}차 모드({computed})와 짝지은 계측 모드가 없어, 그 위의 계측 모드는 모델의 다음 모드와 비교하였다. 조사에서 빠뜨린 모드가 없다면 모델이 실제와 다르다. 모드형상을 계측하면 가릴 수 있다.",
        },
        UnreadableMotion { motion: String, why: Both } => {
            en: "Motion {motion} of the file cannot be simulated: {why}",
            ko: "파일의 지반운동 {motion}(으)로는 해석할 수 없다: {why}",
        },
        LoadFactor { factor: Quantity, most: Quantity } => {
            en: "A load factor of {factor} is far above what timber frames and stone poles have ({most} at most): are masses and stiffness in the units of the file?",
            ko: "하중배율 {factor}은(는) 목조 골조와 석조 당간의 통상 범위({most} 이하)를 크게 벗어난다. 질량과 강성의 단위가 파일의 단위와 맞는지 확인해야 한다.",
        },
    }
}

/// Findings for one version: those of its kind, its site, its surveys, and its scatter.
pub(super) fn of_state(project: &Project, state: &State) -> Vec<Finding> {
    // falling samples come first; "none falls" comes last
    let (mut all, none): (Vec<Finding>, Vec<Finding>) = state
        .sampled
        .iter()
        .flat_map(sampled::findings)
        .partition(|finding| finding.tone != Tone::Plain);
    let measured = measured::measured(project, state);
    let (before, after) = match &state.check {
        Check::Stack(_) => (measured, Vec::new()),
        Check::Chain(_) | Check::Frame(_) | Check::Building(_) => (Vec::new(), measured),
    };
    all.extend(before);
    let is_contradicted = Evidence::of(project, &state.check).is_contradicted();
    let of_model = of_kind(project, &state.check).into_iter();
    all.extend(of_model.map(|found| match found.tone {
        // a contradicted model gives no good news; a stack depends on shapes and friction
        Tone::Good if is_contradicted && !matches!(state.check, Check::Stack(_)) => Finding {
            tone: Tone::Unknown,
            ..found
        },
        _ => found,
    }));
    all.extend(none);
    all.extend(loads::findings(project, state));
    let has_moved =
        matches!(&state.check, Check::Stack(answer) if !answer.stack.support_movements().is_empty());
    all.extend(demand::findings(
        state.demand.as_ref(),
        has_moved,
        drift_left(project),
    ));
    all.extend(unusual(state));
    all.extend(marked_assumed(project, state));
    all.extend(in_doubt(project, state));
    all.extend(missed(project, state));
    all.extend(next(project, state));
    all.extend(after);
    all.extend(agreement(project, state));
    all
}

fn unreadable(of: &UnreadableMotion) -> Finding {
    let (motion, why) = (of.motion.clone(), of.why.clone());
    Finding::key(Tone::Warn, Unusual::UnreadableMotion { motion, why })
}

fn of_kind(project: &Project, check: &Check) -> Vec<Finding> {
    let found = match check {
        Check::Chain(check) => match &project.structure {
            Structure::Chain(part) => chain::findings(part, check),
            _ => Vec::new(),
        },
        Check::Frame(directions) => frame::findings(directions),
        Check::Stack(answer) => stack::findings(answer),
        Check::Building(answer) => building::findings(answer),
    };
    // a stiffness that nothing checks makes no answer good
    let is_checked = project.unchecked_stiffness_from().is_empty();
    let each = found.into_iter().map(|finding| match finding.tone {
        Tone::Good if !is_checked => Finding {
            tone: Tone::Unknown,
            ..finding
        },
        _ => finding,
    });
    each.collect()
}

fn unusual(state: &State) -> Option<Finding> {
    let said = Unusual::LoadFactor {
        factor: Quantity::beside_one(state.unusual_load_factor()?, 4),
        most: Quantity::ratio(LOAD_FACTOR_USUAL_MOST, 4),
    };
    Some(Finding::key(Tone::Warn, said).with_code("unit-slip"))
}

/// Higher modes of a survey that differ from those of the model.
fn in_doubt(project: &Project, state: &State) -> Option<Finding> {
    let evidence = Evidence::of(project, &state.check);
    let is_doubt = matches!(evidence, Evidence::InDoubt(_));
    is_doubt.then(|| {
        let evidence = Both::of(|language| evidence.words(language));
        Finding::key(Tone::Warn, Unusual::InDoubt { evidence })
    })
}

/// Modes of the model that surveys missed; the finding on a doubtful model already names them.
fn missed(project: &Project, state: &State) -> Vec<Finding> {
    if Evidence::of(project, &state.check).is_doubted() {
        return Vec::new();
    }
    let each = missed_modes(project, &state.check).into_iter().map(|of| {
        let said = Unusual::ModeMissed {
            survey: of.survey,
            number: of.number,
            direction: of.direction,
            computed: Quantity::new(of.computed_hz, Unit::si("Hz"), Digits::Significant(3)),
        };
        Finding::key(Tone::Unknown, said)
    });
    each.collect()
}

/// Frequencies of surveys that the file marks as assumed, compared with the model.
fn marked_assumed(project: &Project, state: &State) -> Option<Finding> {
    let evidence = Evidence::of(project, &state.check);
    let Evidence::MarkedAssumed { survey, .. } = &evidence else {
        return None;
    };
    let said = Unusual::MarkedAssumed {
        survey: survey.clone(),
        evidence: Both::of(|language| match language {
            Language::English => first_large(evidence.words(language)),
            Language::Korean => evidence.words(language),
        }),
    };
    let is_apart = evidence.colour() != Colour::Green;
    Some(match is_apart {
        true => Finding::key(Tone::Warn, said),
        false => Finding::new(Tone::Unknown, said),
    })
}

/// The text with a capital first letter.
fn first_large(words: String) -> String {
    let mut signs = words.chars();
    let first = signs.next().map(|sign| sign.to_uppercase().to_string());
    first.unwrap_or_default() + signs.as_str()
}

/// The next step that would make an unknown verdict known.
fn next(project: &Project, state: &State) -> Option<Finding> {
    let unknown = match &state.check {
        Check::Chain(check) => check.stability.is_none(),
        Check::Frame(directions) => directions.iter().any(|of| of.check.stability.is_none()),
        Check::Stack(_) | Check::Building(_) => false,
    };
    let is_measured = project
        .surveys
        .iter()
        .any(|survey| !survey.modes.is_empty() || survey.records.is_some() || !survey.setups.is_empty());
    let what = match is_measured {
        true => Unusual::Write,
        false => Unusual::Identify,
    };
    unknown.then(|| Finding::key(Tone::Plain, what))
}

/// Finding that a survey has records that a check does not read; `None` if none has, or if the file states their modes.
pub(super) fn unread(answer: &CheckAnswer) -> Option<Finding> {
    let state = answer.state.as_ref()?;
    let compared = match Evidence::of(&answer.project, &state.check) {
        Evidence::Unread { survey } => {
            return Some(Finding::key(Tone::Unknown, Unusual::RecordsUnread { survey }));
        }
        Evidence::Agrees { survey } => survey,
        Evidence::Contradicted(of) | Evidence::TooRough(of) => of.survey,
        Evidence::InDoubt(of) => of.survey,
        Evidence::MarkedAssumed { .. } | Evidence::NotCompared { .. } | Evidence::NotMeasured { .. } => {
            return None;
        }
    };
    let unread =
        answer.project.surveys.iter().filter(|survey| {
            survey.modes.is_empty() && (survey.records.is_some() || !survey.setups.is_empty())
        });
    let newest = unread.max_by_key(|survey| survey_date(&survey.name))?;
    (survey_date(&newest.name) > survey_date(&compared)).then(|| {
        let survey = newest.name.clone();
        Finding::key(Tone::Warn, Unusual::NewerUnread { survey, compared })
    })
}

/// All findings of a check, the worst first.
pub(crate) fn findings(answer: &CheckAnswer) -> Vec<Finding> {
    let mut all: Vec<Finding> = inspected_beyond(&answer.project)
        .iter()
        .flat_map(beyond_limits)
        .collect();
    all.extend(measured::severe_damage(&answer.project));
    all.extend(assumed::cap_left_out(&answer.project));
    all.extend(from_surveys::findings(&answer.project));
    let states = answer.state.iter();
    all.extend(states.flat_map(|state| of_state(&answer.project, state)));
    all.extend(sampled::sensitive(answer));
    let checks = answer.state.iter().map(|state| &state.check);
    all.extend(checks.flat_map(|check| measured::other_directions(&answer.project, check)));
    all.extend(measured::against_its_limit(&answer.project));
    all.extend(measured::undated(&answer.project));
    all.extend(measured::against_drift(&answer.project));
    all.extend(measured::felt_since(&answer.project));
    all.extend(measured::over_the_years(&answer.project));
    all.extend(answer.unreadable_motions.iter().map(unreadable));
    all.extend(variants::findings(answer));
    all.extend(building::variant_findings(&answer.variants));
    all.extend(assumed::findings(answer));
    all.sort_by_key(|finding| finding.tone != Tone::Bad);
    all
}
