//! Findings from all surveys of a structure, added to the comparison of two.

use super::quantities::{bare_percent, hertz, percent, plus};
use crate::document::{Block, Document, Finding, Tone};
use dolmen::assess::{ModeChange, SurveyChange};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::compared_history::{ComparedHistory, Course, LastingChange};

messages! {
    /// All surveys that a comparison uses.
    pub(crate) enum Behind in "change.history" {
        Of { whose: Sentence, lasting: Sentence } => {
            en: "{whose} {lasting}",
            ko: "{whose} {lasting}",
        },
        All { surveys: usize, first: String, last: String } => {
            en: "Weather and scatter in this are those of all {surveys} surveys ({first} to {last}), as in «`dolmen watch`|the review of all surveys».",
            ko: "기온의 영향과 산포는 «`dolmen watch`|장기 변화 검토»와 같이 전체 조사 {surveys}회({first}~{last})에서 추정하였다.",
        },
        Some { surveys: usize, first: String, last: String, modes: usize, all: usize } => {
            en: "Weather and scatter of {modes} of {all} frequencies are those of all {surveys} surveys ({first} to {last}), as in «`dolmen watch`|the review of all surveys»; the others, which fewer surveys show, are compared from these two alone.",
            ko: "고유진동수 {all}개 중 {modes}개는 기온의 영향과 산포를 «`dolmen watch`|장기 변화 검토»와 같이 전체 조사 {surveys}회({first}~{last})에서 추정하였다. 나머지는 확인된 조사가 적어 두 조사만으로 비교하였다.",
        },
        Lasting { each: Vec<Sentence> } => {
            en: "These are two dates; what lasts between them, by all surveys: {each}.",
            ko: "위의 값은 두 시점만 비교한 것이다. 전체 조사로 본 그 사이의 지속적인 변화: {each}.",
        },
        Nothing => {
            en: "These are two dates; by all surveys nothing lasting changed between them.",
            ko: "위의 값은 두 시점만 비교한 것이다. 전체 조사로 보면 그 사이에 지속적인 변화는 없다.",
        },
        PassedOver { surveys: Vec<String> } => {
            en: "Passed over as the first or the last survey, since its temperature is not known or too few others were as cold: {surveys}. With --from and --to the answer gives its differences, without a test.",
            ko: "기온을 알 수 없거나 그만큼 추운 조사가 너무 적어 처음이나 마지막 조사로 쓰지 않은 조사: {surveys}. --from과 --to로 지정하면 검정 없이 차이만 보인다.",
        },
        Unread { each: Vec<Sentence> } => {
            en: "Other surveys whose records cannot be used are left out of the weather and the scatter: {each}.",
            ko: "기록을 쓸 수 없어 기온의 영향과 산포의 추정에서 뺀 다른 조사: {each}.",
        },
        UnreadOne { survey: String, why: Both } => { en: "{survey} ({why})", ko: "{survey}({why})" },
        UnreadMore { count: usize } => { en: "{count} more", ko: "그 밖 {count}회" },
        Step { frequency: Quantity, sign: String, change: Quantity, half: Quantity, after: String, before: String } => {
            en: "{frequency} {sign}{change} ± {half} between {after} and {before}",
            ko: "{frequency} {sign}{change} ± {half}({after}~{before})",
        },
        Drift { frequency: Quantity, sign: String, change: Quantity, half: Quantity, since: String } => {
            en: "{frequency} {sign}{change} ± {half} little by little since about {since}",
            ko: "{frequency} {sign}{change} ± {half}({since}경부터 점진)",
        },
        Repair { frequency: Quantity, sign: String, change: Quantity, half: Quantity, date: String } => {
            en: "{frequency} {sign}{change} ± {half} by the repair of {date}",
            ko: "{frequency} {sign}{change} ± {half}({date} 보수)",
        },
        Others { count: usize } => { en: "{count} more« (`dolmen watch`)»", ko: "그 밖에 {count}건«(`dolmen watch`)»" },
        Line { mode: usize, per_c: Quantity, scatter: Quantity, surveys: usize } => {
            en: "Mode {mode}: {per_c} per °C (± standard deviation), from {surveys} surveys together with all lasting changes; beyond the noise of its reading one survey scatters by {scatter}.",
            ko: "모드 {mode}: 1 °C당 {per_c}(± 표준편차). 조사 {surveys}회에서 지속적인 변화와 함께 추정하였다. 측정 오차를 제외한 조사 간 산포는 {scatter}이다.",
        },
        NoLine { mode: usize, scatter: Quantity, surveys: usize } => {
            en: "Mode {mode}: from {surveys} surveys; beyond the noise of its reading one survey scatters by {scatter}.",
            ko: "모드 {mode}: 조사 {surveys}회에서 추정하였다. 측정 오차를 제외한 조사 간 산포는 {scatter}이다.",
        },
    }
}

/// Number of lasting changes that the sentence names.
const LISTED: usize = 4;
/// Number of unreadable surveys in the sentence.
const UNREAD_LISTED: usize = 3;
/// Half width of a 95 % interval, in standard deviations.
const HALF_95: f64 = 1.959963984540054;

/// The source of weather and scatter, and the lasting changes between both surveys.
pub(super) fn finding(of: &ComparedHistory, change: &SurveyChange) -> Finding {
    let [first, last] = of.span.clone();
    let decided = change.modes.iter().filter(|mode| !mode.is_undecided);
    let (surveys, all) = (of.surveys, decided.count());
    let modes = change.modes.iter().filter(|mode| mode.history.is_some()).count();
    let whose = match modes == all {
        true => Behind::All { surveys, first, last },
        false => Behind::Some {
            surveys,
            first,
            last,
            modes,
            all,
        },
    };
    let mut each: Vec<Sentence> = of.lasting.iter().take(LISTED).map(lasting).collect();
    if of.lasting.len() > LISTED {
        let count = of.lasting.len() - LISTED;
        each.push(Behind::Others { count }.into());
    }
    let lasting = match each.is_empty() {
        true => Behind::Nothing,
        false => Behind::Lasting { each },
    };
    match modes {
        0 => Finding::key(Tone::Plain, lasting),
        _ => {
            let said = Behind::Of {
                whose: whose.into(),
                lasting: lasting.into(),
            };
            Finding::key(Tone::Plain, said)
        }
    }
}

/// Surveys at both ends whose modes are not compared.
pub(super) fn passed_over(of: &ComparedHistory) -> Option<Finding> {
    let surveys = of.passed_over.clone();
    (!surveys.is_empty()).then(|| Finding::key(Tone::Unknown, Behind::PassedOver { surveys }))
}

/// Other surveys that cannot be read, with the reasons.
pub(super) fn unread(all: &[(String, Both)]) -> Option<Finding> {
    let named = all
        .iter()
        .take(UNREAD_LISTED)
        .map(|(survey, why)| Behind::UnreadOne {
            survey: survey.clone(),
            why: why.clone(),
        });
    let more = all.len().saturating_sub(UNREAD_LISTED);
    let more = (more > 0).then_some(Behind::UnreadMore { count: more });
    let each: Vec<Sentence> = named.chain(more).map(Sentence::from).collect();
    (!each.is_empty()).then(|| Finding::key(Tone::Warn, Behind::Unread { each }))
}

fn lasting(of: &LastingChange) -> Sentence {
    let (frequency, sign) = (hertz(of.frequency_hz), plus(of.ratio));
    let (change, half) = (bare_percent(of.ratio, 1), percent(HALF_95 * of.sd, 1));
    let said = match of.course.clone() {
        Course::Step { after, before } => Behind::Step {
            frequency,
            sign,
            change,
            half,
            after,
            before,
        },
        Course::Drift { since } => Behind::Drift {
            frequency,
            sign,
            change,
            half,
            since,
        },
        Course::Repair(work) => Behind::Repair {
            frequency,
            sign,
            change,
            half,
            date: work.date,
        },
    };
    said.into()
}

/// The coefficients of temperature and the scatter of each mode.
pub(super) fn section(document: &mut Document<'_>, change: &SurveyChange) {
    let each = change.modes.iter().enumerate();
    let lines: Vec<Sentence> = each.filter_map(|(i, mode)| line(i + 1, mode)).collect();
    if !lines.is_empty() {
        document.put(Block::List(lines));
    }
}

fn line(mode: usize, of: &ModeChange) -> Option<Sentence> {
    let history = of.history.as_ref()?;
    let (scatter, surveys) = (percent(history.disturbance_sd, 2), history.surveys);
    let said = match history.per_c {
        Some((per_c, sd)) => Behind::Line {
            mode,
            per_c: Quantity {
                sd_si: Some(sd),
                ..Quantity::new(per_c, Unit::percent(), Digits::Significant(3))
            },
            scatter,
            surveys,
        },
        None => Behind::NoLine {
            mode,
            scatter,
            surveys,
        },
    };
    Some(said.into())
}
