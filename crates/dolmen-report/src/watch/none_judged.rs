//! Why no survey of a history was judged.

use crate::document::{Finding, Tone};
use dolmen::monitoring::NotJudged;
use dolmen_project::WorkKind;
use dolmen_words::messages;
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Findings on a history without a judged survey.
    pub(crate) enum NoneJudged in "watch.none_judged" {
        TooFew { needed: usize, surveys: usize } => {
            en: "Too few surveys to judge yet: {needed} are needed, there are {surveys}.",
            ko: "아직 판정할 수 있는 조사가 없다. 조사가 {needed}회 이상이어야 한다(지금 {surveys}회).",
        },
        Levels { repairs: usize, longest: usize, learned: usize } => {
            en: "NOTHING CAN RAISE AN ALARM: no survey was judged, since repairs ({repairs}) begin a new level each, of {longest} surveys at most, and the first {learned} of a level are needed to learn it. Enter work that leaves the structure as it is, such as cleaning, as an inspection.",
            ko: "경보가 울릴 수 없음: 보수({repairs}회)마다 조사 {longest}회 이하의 새로운 수준이 시작되고 각 수준의 처음 조사 {learned}회는 그 수준을 익히는 데 쓰여 판정한 조사가 없다. 청소처럼 구조물이 달라지지 않는 작업은 점검(inspection)으로 적는다.",
        },
        Temperatures { surveys: usize } => {
            en: "No survey was judged against those before it: surveys that were colder or warmer than nearly all before them: {surveys}. A year of surveys covers the temperatures.",
            ko: "이전 조사와 비교하여 판정한 조사가 없다. 이전의 거의 모든 조사보다 춥거나 더운 조사가 {surveys}회이다. 한 해 동안의 조사가 있으면 기온 범위가 확보된다.",
        },
        NoTemperature { surveys: usize } => {
            en: "No survey was judged against those before it: surveys without a temperature, where the others have one: {surveys}. Enter «temperature_c|the temperature» with each survey.",
            ko: "이전 조사와 비교하여 판정한 조사가 없다. 다른 조사와 달리 기온이 없는 조사가 {surveys}회이다. 조사마다 «temperature_c를|기온을» 기록한다.",
        },
        Other { training: usize } => {
            en: "No survey was judged against those before it: that needs more than {training} surveys before it, with its modes, at one level and near its temperature.",
            ko: "이전 조사와 비교하여 판정한 조사가 없다. 판정하려면 같은 모드를 같은 수준과 비슷한 기온에서 확인한 조사가 그 전에 {training}회 넘게 있어야 한다.",
        },
    }
}

/// Surveys before the first judged one, and those of a new level before its first judged one, as the alarm needs them.
const TRAINING: usize = 10;
const LEARNED: usize = 3;

/// Finding that no survey was judged, with the reason.
pub(super) fn none_judged(answer: &WatchAnswer) -> Finding {
    let surveys = answer.surveys.len();
    if surveys <= TRAINING {
        let needed = TRAINING + 1;
        return Finding::key(Tone::Unknown, NoneJudged::TooFew { needed, surveys });
    }
    let (repairs, longest) = levels(answer);
    if repairs > 0 && longest <= TRAINING {
        let learned = LEARNED;
        let said = NoneJudged::Levels {
            repairs,
            longest,
            learned,
        };
        return Finding::key(Tone::Warn, said);
    }
    let of = |reason: NotJudged| {
        let modes = answer.watched.modes.iter();
        let counts = modes.map(|mode| {
            let judged = mode.judged.judged.iter();
            judged.filter(|of| of.score == Err(reason)).count()
        });
        counts.max().unwrap_or(0)
    };
    let [temperatures, unknown] = [NotJudged::Temperature, NotJudged::NoTemperature].map(of);
    let said = match temperatures.max(unknown) {
        0 => NoneJudged::Other { training: TRAINING },
        most if most == temperatures => NoneJudged::Temperatures { surveys: most },
        most => NoneJudged::NoTemperature { surveys: most },
    };
    Finding::key(Tone::Unknown, said)
}

/// Number of repairs within the surveys, and the largest number of surveys between two of them.
fn levels(answer: &WatchAnswer) -> (usize, usize) {
    let days: Vec<f64> = answer.surveys.iter().map(|survey| survey.day).collect();
    let repairs = answer
        .works
        .iter()
        .filter(|(_, work)| work.kind == WorkKind::Repair);
    let mut starts: Vec<usize> = repairs
        .map(|(on, _)| days.partition_point(|day| day < on))
        .filter(|from| *from > 0 && *from < days.len())
        .collect();
    let repairs = starts.len();
    starts.extend([0, days.len()]);
    starts.sort_unstable();
    let longest = starts.windows(2).map(|pair| pair[1] - pair[0]).max();
    (repairs, longest.unwrap_or(0))
}
