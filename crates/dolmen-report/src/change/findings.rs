//! Findings of a comparison of two surveys.

use super::doubts::doubts;
use super::events_between::{between, fitted_through};
use super::forces;
use super::history;
use super::parts;
use super::quantities::{bare_percent, hertz, percent, plus, temperature};
use super::readings;
use super::temperature::known;
use crate::document::{Finding, Tone};
use dolmen::assess::{ChangeNote, Difference, ModeChange, SurveyChange, TemperatureKnowledge};
use dolmen_project::{Survey, TemperaturePart, date_of};
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::answer::CompareAnswer;
use dolmen_work::surveyed::ModesOf;

messages! {
    /// Findings on two surveys.
    pub(crate) enum Found in "change.findings" {
        NothingPaired { from: String, to: String } => {
            en: "Surveys {from} and {to}: no frequency of one was found again in the other, so nothing could be compared (other directions, or too far apart).",
            ko: "{from} 조사와 {to} 조사: 서로 대응하는 고유진동수가 없어 비교할 수 없다(방향이 다르거나 차이가 너무 크다).",
        },
        NotTested { from: String, to: String, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} the frequencies differ by {each}; whether that is beyond chance cannot be said, since no standard deviations are known.",
            ko: "{from} 조사에서 {to} 조사까지 고유진동수의 차이: {each}. 표준편차를 알 수 없어 유의한 변화인지 판단할 수 없다.",
        },
        NotDecided { from: String, to: String, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} the frequencies differ by {each}; whether that is beyond chance cannot be said, since the temperature of one of the two is not known or too few other surveys were as cold.",
            ko: "{from} 조사에서 {to} 조사까지 고유진동수의 차이: {each}. 둘 중 한 조사의 기온을 알 수 없거나 그만큼 추운 조사가 너무 적어 유의한 변화인지 판단할 수 없다.",
        },
        Differs { frequency: Quantity, sign: String, change: Quantity, stiffness: Quantity } => {
            en: "{frequency} {sign}{change} ({stiffness} of stiffness)",
            ko: "{frequency} {sign}{change}(강성 {stiffness})",
        },
        Unchanged { from: String, to: String, tested: usize, known: Sentence, least: Quantity, power: Quantity } => {
            en: "From survey {from} to {to} no change was shown in {tested} of {known}. A change of {least} would have been seen with {power} probability; smaller ones could have been missed.",
            ko: "{from} 조사에서 {to} 조사까지 {known} 중 비교한 {tested}개에서 변화가 확인되지 않았다. {least}의 변화는 {power}의 확률로 검출되었을 것이나 그보다 작은 변화는 놓쳤을 수 있다.",
        },
        Changed { from: String, to: String, changed: usize, tested: Sentence, alpha: Quantity, each: Vec<Sentence> } => {
            en: "From survey {from} to {to} {changed} of {tested} changed beyond chance ({alpha} for all together); the largest: {each}.",
            ko: "{from} 조사에서 {to} 조사까지 {tested} 중 {changed}개가 유의하게 변하였다(전체 유의수준 {alpha}). 변화가 큰 것: {each}.",
        },
        OneFrequency => { en: "1 frequency", ko: "고유진동수 1개" },
        Frequencies { count: usize } => { en: "{count} frequencies", ko: "고유진동수 {count}개" },
        Reversed { from: String, to: String } => {
            en: "THE ORDER IS REVERSED: survey {from}, which the changes count from, is later than {to}. A fall reads as a rise: exchange --from and --to.",
            ko: "순서가 반대이다: 변화의 기준으로 삼은 {from} 조사가 {to} 조사보다 나중이다. 감소가 증가로 나타나므로 --from과 --to를 바꾼다.",
        },
        ByCoefficient { frequency: Quantity, sign: String, measured: Quantity, sign_of: String, explained: Quantity, step: Quantity } => {
            en: "{frequency}: {sign}{measured} was measured, of which the coefficient of the file explains {sign_of}{explained} by the {step} between the surveys; what follows is about the rest.",
            ko: "{frequency} 모드의 측정된 변화는 {sign}{measured}이며, 그중 {sign_of}{explained}은(는) 파일의 온도 계수로 두 조사의 기온 차 {step}에 의한 것이다. 아래는 나머지에 대한 것이다.",
        },
        RisesWithHeat { per_c: Quantity } => {
            en: "The coefficient of the file, {per_c} per °C, says that frequencies rise with the temperature. Most masonry and timber do the opposite: is its sign right?",
            ko: "파일의 온도 계수 1 °C당 {per_c}은(는) 기온이 오르면 고유진동수가 커진다는 뜻이다. 석조와 목조는 대부분 반대이다. 부호가 맞는가?",
        },
        Damping { from: String, to: String, changed: usize, tested: Sentence, alpha: Quantity, each: Vec<Sentence>, why: Sentence } => {
            en: "From survey {from} to {to} {changed} of {tested} changed beyond chance ({alpha} for all together): {each}. Damping follows the strength of the motion too; {why}.",
            ko: "{from} 조사에서 {to} 조사까지 {tested} 중 {changed}개가 유의하게 변하였다(전체 유의수준 {alpha}): {each}. 감쇠비는 진동의 세기에 따라서도 변한다. {why}.",
        },
        Rose => {
            en: "at equal strength, joints or cracks that rub raise it before any frequency moves",
            ko: "세기가 같다면 접합면이나 균열의 마찰로 진동수보다 먼저 커질 수 있다",
        },
        Fell => {
            en: "a machine that runs near the frequency of a mode lowers it, joints or cracks that rub do not: --full shows the kurtosis of each mode, about 3 without a machine and 1.5 of a steady tone",
            ko: "모드의 진동수 가까이에서 운전하는 기계는 감쇠비를 낮추며 접합면이나 균열의 마찰은 그렇지 않다. --full로 각 모드의 첨도를 확인한다. 기계가 없으면 약 3, 일정한 기계 진동은 1.5이다",
        },
        RoseAndFell => {
            en: "at equal strength, joints or cracks that rub raise it before any frequency moves, and a machine that runs near the frequency of a mode lowers it",
            ko: "세기가 같다면 접합면이나 균열의 마찰로 진동수보다 먼저 커질 수 있고, 모드의 진동수 가까이에서 운전하는 기계로 작아질 수 있다",
        },
        Undated { surveys: Vec<String> } => {
            en: "Surveys whose names say no date were not looked at: {surveys}. Begin a name with its date, 2024-06-05, or name two surveys with --from and --to.",
            ko: "이름에 날짜가 없어 보지 않은 조사: {surveys}. 이름을 2024-06-05처럼 날짜로 시작하거나 --from과 --to로 두 조사를 지정한다.",
        },
        AfterEarthquake { survey: String } => {
            en: "The record of survey {survey} holds an earthquake; its modes are those of what follows it.",
            ko: "{survey} 조사의 기록에 지진이 들어 있다. 모드는 지진 이후 구간의 것이다.",
        },
        BeforeEarthquake { survey: String } => {
            en: "The record of survey {survey} holds an earthquake; what follows it is too short, and its modes are those of what came BEFORE it.",
            ko: "{survey} 조사의 기록에 지진이 들어 있다. 지진 이후 구간이 너무 짧아 모드는 지진 이전 구간의 것이다.",
        },
        BetweenEarthquakes { survey: String } => {
            en: "The record of survey {survey} holds earthquakes; what follows them is too short, and its modes are those of what came between two of them.",
            ko: "{survey} 조사의 기록에 지진이 여러 번 들어 있다. 지진 이후 구간이 너무 짧아 모드는 지진 사이 구간의 것이다.",
        },
        InEarthquake { survey: String } => {
            en: "The record of survey {survey} holds an earthquake, and its modes are those of the structure in it: in strong shaking every frequency is lower, so that a change shown here may be of the shaking and not of the structure. Compare an ambient survey.",
            ko: "{survey} 조사의 기록에 지진이 들어 있고 모드는 지진 중의 것이다. 강한 진동 중에는 고유진동수가 낮아지므로 여기에 나타난 변화는 구조물이 아니라 진동 세기에 의한 것일 수 있다. 상시진동 조사와 비교한다.",
        },
        OtherShapes { unlike: usize, of: usize, least: Quantity } => {
            en: "The shapes differ between the surveys in {unlike} of {of} modes (least MAC {least}): a sensor with another gain, place or direction, or a part that changed. Frequencies show neither; look at the shapes.",
            ko: "모드 {of}개 중 {unlike}개에서 두 조사의 모드형상이 다르다(최소 MAC {least}). 센서의 감도, 위치, 방향이 달라졌거나 일부가 변한 것이며 진동수로는 알 수 없다. 모드형상을 확인한다.",
        },
        OneRatio => { en: "1 damping ratio", ko: "감쇠비 1개" },
        Ratios { count: usize } => { en: "{count} damping ratios", ko: "감쇠비 {count}개" },
        Of { frequency: Quantity, sign: String, change: Quantity, half: Quantity } => {
            en: "{frequency} {sign}{change} ± {half}",
            ko: "{frequency} {sign}{change} ± {half}",
        },
    }
}

/// MAC below which the shapes of a mode differ. Our choice: chance leaves more in a mode that the records show well.
const UNLIKE: f64 = 0.9;

/// Number of changed frequencies in the sentence.
const LISTED: usize = 3;
/// Which of both surveys contain an earthquake.
fn shaken(surveys: &[(String, ModesOf)]) -> Vec<Finding> {
    let each = surveys.iter().map(|(survey, of)| {
        let survey = survey.clone();
        let said = match of {
            ModesOf::After => Found::AfterEarthquake { survey },
            ModesOf::Before => Found::BeforeEarthquake { survey },
            ModesOf::Between => Found::BetweenEarthquakes { survey },
            ModesOf::During | ModesOf::Whole => Found::InEarthquake { survey },
        };
        Finding::key(Tone::Warn, said).with_code("earthquake")
    });
    each.collect()
}

/// Surveys left out because they have no date.
pub(crate) fn undated(answer: &CompareAnswer) -> Option<Finding> {
    let is_usable = |survey: &&Survey| {
        survey.records.is_some()
            || !survey.setups.is_empty()
            || survey.modes.values().any(|modes| !modes.is_empty())
    };
    let compared = [&answer.from, &answer.to];
    let left = answer.project.surveys.iter().filter(is_usable);
    let left = left.filter(|survey| date_of(&survey.name).is_none() && !compared.contains(&&survey.name));
    let surveys: Vec<String> = left.map(|survey| survey.name.clone()).collect();
    (!surveys.is_empty()).then(|| Finding::key(Tone::Warn, Found::Undated { surveys }))
}

/// The findings, doubts first, because the others depend on the pairs of modes.
pub(crate) fn findings(answer: &CompareAnswer) -> Vec<Finding> {
    let mut all = shaken(&answer.shaken);
    all.extend(readings::findings(answer));
    let Some(change) = &answer.change else {
        return all;
    };
    all.splice(0..0, doubts(change));
    all.splice(
        0..0,
        reversed(answer).into_iter().chain(by_coefficient(answer, change)),
    );
    all.extend(damping(change));
    all.push(frequencies(change));
    all.extend(forces::doubts(answer, change));
    all.extend(other_shapes(change));
    all.extend(answer.history.as_ref().map(|of| history::finding(of, change)));
    all.extend(answer.history.as_ref().and_then(history::passed_over));
    all.extend(history::unread(&answer.unread));
    all.extend(parts::findings(&answer.parts));
    all.extend(
        answer
            .model_off
            .as_ref()
            .map(|of| parts::off(of, &answer.project)),
    );
    all.extend(between(answer));
    all.extend(fitted_through(change));
    if change.temperature.leaves_doubt() {
        all.push(Finding::key(Tone::Unknown, known(change)));
    }
    all
}

/// Shapes that differ in most modes, where no note names the channel.
fn other_shapes(change: &SurveyChange) -> Option<Finding> {
    let is_named = |note: &ChangeNote| {
        matches!(
            note,
            ChangeNote::Swapped(_) | ChangeNote::Turned(_) | ChangeNote::DirectionsExchanged(_)
        )
    };
    let modes = change.modes.iter();
    let all: Vec<f64> = modes.filter_map(|mode| mode.pair.assurance).collect();
    let unlike = all.iter().filter(|mac| **mac < UNLIKE).count();
    if 2 * unlike <= all.len() || change.notes.iter().any(is_named) {
        return None;
    }
    let least = all.iter().copied().fold(f64::INFINITY, f64::min);
    let said = Found::OtherShapes {
        unlike,
        of: all.len(),
        least: Quantity::ratio(least, 2),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Finding that the survey to count from is the later one.
fn reversed(answer: &CompareAnswer) -> Option<Finding> {
    let (from, to) = (answer.from.clone(), answer.to.clone());
    let is_later = date_of(&from)
        .zip(date_of(&to))
        .is_some_and(|(from, to)| from > to);
    is_later.then(|| Finding::key(Tone::Warn, Found::Reversed { from, to }))
}

/// Least part that a coefficient of the file explains, from which the measured change has a finding. Our choice.
const EXPLAINED_FROM: f64 = 0.01;

/// What the coefficient of the file explains, in the mode in which that is most; and a question on its sign.
fn by_coefficient(answer: &CompareAnswer, change: &SurveyChange) -> Vec<Finding> {
    let TemperaturePart::Coefficient { per_c, .. } = &answer.project.change.temperature else {
        return Vec::new();
    };
    let explained = |mode: &&ModeChange| mode.explained_by_temperature.filter(|_| mode.history.is_none());
    let modes = change.modes.iter().filter(|mode| explained(mode).is_some());
    let most = modes.max_by(|a, b| {
        let of = |mode| explained(mode).unwrap_or(0.0).abs();
        of(a).total_cmp(&of(b))
    });
    let said = most.and_then(|mode| {
        let share = explained(&mode).filter(|share| share.abs() >= EXPLAINED_FROM)?;
        let TemperatureKnowledge::Corrected { step_c } = change.temperature else {
            return None;
        };
        let measured = mode.to.frequency_hz / mode.from.frequency_hz - 1.0;
        Some(Found::ByCoefficient {
            frequency: hertz(mode.from.frequency_hz),
            sign: plus(measured),
            measured: percent(measured, 1),
            sign_of: plus(share),
            explained: percent(share, 1),
            step: temperature(step_c),
        })
    });
    let is_used = said.is_some();
    let rises = (is_used && *per_c > 0.0).then(|| Found::RisesWithHeat {
        per_c: percent(*per_c, 2),
    });
    let said = said.map(|said| Finding::key(Tone::Plain, said));
    said.into_iter()
        .chain(rises.map(|said| Finding::key(Tone::Unknown, said)))
        .collect()
}

fn frequencies(change: &SurveyChange) -> Finding {
    let (from, to) = (change.from.clone(), change.to.clone());
    let (tone, said) = match (change.detectable(), change.changed().count()) {
        (None, _) if change.modes.is_empty() => (Tone::Unknown, Found::NothingPaired { from, to }),
        (None, _) => {
            let each = differences(change);
            let said = match change.modes.iter().any(|mode| mode.is_undecided) {
                true => Found::NotDecided { from, to, each },
                false => Found::NotTested { from, to, each },
            };
            (Tone::Unknown, said)
        }
        (Some(least), 0) => {
            let said = Found::Unchanged {
                from,
                to,
                tested: change.tested(),
                known: counted(change.modes.len() + change.lost.len()),
                least: Quantity::percent(least, 2),
                power: Quantity::percent(change.power, 2),
            };
            (Tone::Plain, said)
        }
        (Some(_), changed) => {
            let said = Found::Changed {
                from,
                to,
                changed,
                tested: counted(change.tested()),
                alpha: Quantity::percent(change.significance, 1),
                each: most_changed(change),
            };
            (Tone::Warn, said)
        }
    };
    Finding::key(tone, said)
}

/// The largest differences of frequencies without standard deviations.
fn differences(change: &SurveyChange) -> Vec<Sentence> {
    let mut modes: Vec<&ModeChange> = change.modes.iter().collect();
    modes.sort_by(|a, b| b.frequency.relative.abs().total_cmp(&a.frequency.relative.abs()));
    let one = |mode: &ModeChange| {
        let by = mode.frequency.relative;
        let said = Found::Differs {
            frequency: hertz(mode.from.frequency_hz),
            sign: plus(by),
            change: percent(by, 1),
            stiffness: percent(by * (2.0 + by), 0),
        };
        said.into()
    };
    modes.into_iter().take(LISTED).map(one).collect()
}

/// The frequencies that changed most, with their intervals.
fn most_changed(change: &SurveyChange) -> Vec<Sentence> {
    let mut changed: Vec<&ModeChange> = change.changed().collect();
    changed.sort_by(|a, b| b.frequency.relative.abs().total_cmp(&a.frequency.relative.abs()));
    let one = |mode: &ModeChange| {
        let half = mode.frequency.evidence.as_ref();
        let said = Found::Of {
            frequency: hertz(mode.from.frequency_hz),
            sign: plus(mode.frequency.relative),
            change: bare_percent(mode.frequency.relative, 1),
            half: percent(half.map_or(f64::NAN, |e| e.half_width_95), 1),
        };
        said.into()
    };
    changed.into_iter().take(LISTED).map(one).collect()
}

fn counted(frequencies: usize) -> Sentence {
    match frequencies {
        1 => Found::OneFrequency.into(),
        count => Found::Frequencies { count }.into(),
    }
}

/// Damping ratios that changed beyond chance.
fn damping(change: &SurveyChange) -> Option<Finding> {
    let one = |(mode, damping): (&ModeChange, &Difference)| {
        let half = damping.evidence.as_ref().map_or(f64::NAN, |e| e.half_width_95);
        let said = Found::Of {
            frequency: hertz(mode.from.frequency_hz),
            sign: plus(damping.relative),
            change: bare_percent(damping.relative, 0),
            half: percent(half, 0),
        };
        said.into()
    };
    let each: Vec<Sentence> = change.damping_changed().map(one).collect();
    let tested = match change.damping_tested() {
        1 => Found::OneRatio,
        count => Found::Ratios { count },
    };
    let fell = change
        .damping_changed()
        .filter(|(_, of)| of.relative < 0.0)
        .count();
    let why = match fell {
        0 => Found::Rose,
        fell if fell == each.len() => Found::Fell,
        _ => Found::RoseAndFell,
    };
    let said = Found::Damping {
        from: change.from.clone(),
        to: change.to.clone(),
        changed: each.len(),
        tested: tested.into(),
        alpha: Quantity::percent(change.significance, 1),
        each,
        why: why.into(),
    };
    (change.damping_changed().count() > 0).then(|| Finding::key(Tone::Warn, said))
}
