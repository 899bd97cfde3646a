//! Findings on records and modes.

use super::cautions::cautions;
use super::driven;
use super::earthquake;
use super::faults::fault_words;
use super::notes::note_words;
use super::setup_remarks::setup_faults;
use super::steps::step_words;
use super::values::{all_hertz, frequency, hertz};
use crate::document::{Finding, Tone};
use dolmen::modal::{DrivenMode, Mode, Note, PartialMode, Refusal, RefusedPeak, SensorDoubt};
use dolmen::signal::{Channel, Processing};
use dolmen_words::{Digits, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::surveyed::{RecordAnswer, SetupsAnswer, SurveyAnswer};

/// Largest share in all modes below which a channel probably has another unit: that of g among gal, 1/981, up to three times as large.
/// Our choice: sensors on the ground, which some surveys have, move by more than the noise of those above.
const OTHER_UNIT: f64 = 0.003;

messages! {
    /// Findings on modes.
    pub(crate) enum Found in "modal.findings" {
        Twins { first: String, second: String, likeness: Quantity } => {
            en: "PROBABLY A SLIP: {first} and {second} stand at one place in one direction and move differently (likeness {likeness}, 1 for the same motion): one direction, place or scale is wrong, or one sensor is.",
            ko: "입력 오류 의심: {first}와(과) {second}은(는) 같은 위치와 방향의 센서이나 움직임이 다르다(유사도 {likeness}, 같으면 1). 방향, 위치 또는 배율 중 하나가 틀렸거나 센서 하나가 불량이다.",
        },
        Turned { channel: String, unexplained: Quantity, changed: Quantity } => {
            en: "PROBABLY A SLIP: {unexplained} % of the lowest mode shapes is no motion of a rigid floor, and {changed} % with the sign of {channel} changed: is that sensor mounted the other way round?",
            ko: "입력 오류 의심: 저차 모드형상의 {unexplained} %가 강체 바닥의 운동이 아니며 {channel}의 부호를 바꾸면 {changed} %이다. 이 센서의 방향이 반대가 아닌가?",
        },
        Swapped { first: String, second: String, unexplained: Quantity, changed: Quantity } => {
            en: "PROBABLY A SLIP: {unexplained} % of the lowest mode shapes is no motion of a rigid floor, and {changed} % with {first} and {second} exchanged: are their columns, places or cables exchanged?",
            ko: "입력 오류 의심: 저차 모드형상의 {unexplained} %가 강체 바닥의 운동이 아니며 {first}와(과) {second}을(를) 맞바꾸면 {changed} %이다. 두 센서의 열, 위치 또는 케이블이 바뀐 것이 아닌가?",
        },
        StationTurned { channels: Vec<String>, unexplained: Quantity, changed: Quantity } => {
            en: "PROBABLY A SLIP: {unexplained} % of the lowest mode shapes is no motion of a rigid floor, and {changed} % with the signs of {channels} changed: is that station turned by 180°?",
            ko: "입력 오류 의심: 저차 모드형상의 {unexplained} %가 강체 바닥의 운동이 아니며 {channels}의 부호를 모두 바꾸면 {changed} %이다. 이 측점의 센서가 180° 돌아가 있지 않은가?",
        },
        StationsSwapped { first: Vec<String>, second: Vec<String>, unexplained: Quantity, changed: Quantity } => {
            en: "PROBABLY A SLIP: {unexplained} % of the lowest mode shapes is no motion of a rigid floor, and {changed} % with {first} exchanged for {second}: are the places of these two stations exchanged, or is another sensor not where the file has it?",
            ko: "입력 오류 의심: 저차 모드형상의 {unexplained} %가 강체 바닥의 운동이 아니며 {first}을(를) {second}와(과) 맞바꾸면 {changed} %이다. 두 측점의 위치가 바뀌었거나 다른 센서의 위치가 파일과 다르지 않은가?",
        },
        OfSurvey { survey: String, said: Sentence } => { en: "Survey {survey}: {said}", ko: "{survey} 조사: {said}" },
        None { minutes: Quantity, channels: Sentence } => {
            en: "No mode was found in {minutes} minutes of {channels}.",
            ko: "{minutes}분, {channels}의 기록에서 모드를 찾지 못하였다.",
        },
        One { minutes: Quantity, channels: Sentence, how: Sentence, values: Sentence } => {
            en: "1 mode was found in {minutes} minutes of {channels}, {how}: {values}.",
            ko: "{minutes}분, {channels}의 기록에서 모드 1개를 {how} 찾았다: {values}.",
        },
        Several { modes: usize, minutes: Quantity, channels: Sentence, how: Sentence, values: Sentence } => {
            en: "{modes} modes were found in {minutes} minutes of {channels}, {how}: {values}.",
            ko: "{minutes}분, {channels}의 기록에서 모드 {modes}개를 {how} 찾았다: {values}.",
        },
        WithDeviations { values: Values } => {
            en: "{values} (± standard deviation)",
            ko: "{values}(± 표준편차)",
        },
        WithoutDeviations { values: Values } => {
            en: "{values} (standard deviation not known)",
            ko: "{values}(표준편차 미상)",
        },
        Accepted { values: Sentence } => {
            en: "Accepted by the user, not found by the tests: {values}. With the record stands what refused it.",
            ko: "사용자가 채택한 모드로, 판정 기준으로 찾은 것이 아니다: {values}. 기준에서 제외된 이유는 기록 항목에 있다.",
        },
        AcceptedSeveral { values: Sentence } => {
            en: "Accepted by the user, not found by the tests: {values}. With the record stands what refused each.",
            ko: "사용자가 채택한 모드로, 판정 기준으로 찾은 것이 아니다: {values}. 각각이 기준에서 제외된 이유는 기록 항목에 있다.",
        },
        Follows { mode: Quantity, from: Quantity, to: Quantity } => {
            en: "The mode at {mode} has no single frequency: {from} in the largest swings and {to} in the smallest. Loose joints do that.",
            ko: "{mode} 모드의 진동수는 하나로 정해지지 않는다. 가장 큰 진폭에서 {from}, 가장 작은 진폭에서 {to}이다. 헐거운 접합면에서 나타나는 현상이다.",
        },
        Falls { mode: Quantity, from: Quantity, to: Quantity } => {
            en: "The mode at {mode} has no single frequency: {from} in the largest swings and {to} in the smallest. Loose joints do the opposite: are these two modes close together?",
            ko: "{mode} 모드의 진동수는 하나로 정해지지 않는다. 가장 큰 진폭에서 {from}, 가장 작은 진폭에서 {to}이다. 헐거운 접합면에서는 반대로 나타나므로 가까운 두 모드일 수 있다.",
        },
        OneChannel => { en: "1 channel", ko: "1채널" },
        Channels { count: usize } => { en: "{count} channels", ko: "{count}채널" },
        ByHand => {
            en: "picked by hand of those that the record shows",
            ko: "기록의 모드 중 직접 선택하여",
        },
        ByItself => { en: "no peak picked by hand", ko: "자동으로" },
        OnHeldBase { inputs: Vec<String> } => {
            en: "with {inputs} taken as given (where that is a ground's motion, on a base that is held there)",
            ko: "{inputs}을(를) 주어진 입력으로 보고(지반의 운동이면 그곳의 기초가 고정된 상태로)",
        },
        FollowsLittle { frequency: Quantity, share: Quantity } => {
            en: "Only {share} % of the motion at {frequency} follows the measured input: wind, people or noise move the rest, and clocks that differ or noise of the input would show as this too. Is it a mode of what the input drives?",
            ko: "{frequency}의 운동 중 계측한 입력을 따르는 것은 {share} %뿐이다. 나머지는 바람, 사람, 잡음에 의한 것이며, 시계가 다르거나 입력에 잡음이 많아도 이렇게 나타난다. 그 입력으로 움직이는 모드인지 확인한다.",
        },
        InSpells { at: Values } => {
            en: "Left out, since nothing stands there while the structure moves little: {at}. Steps or a machine that ran for a while, which shift modes near them too; or, in gusts, modes that noise hides in calm« (conditioning.cut takes a windy part alone)».",
            ko: "구조물이 작게 움직이는 동안에는 나타나지 않아 제외한 진동수: {at}. 발걸음이나 잠시 가동한 기계이면 가까운 모드의 값도 그 영향을 받는다. 바람이 약할 때 잡음에 가려지는 모드일 수도 있다«(conditioning.cut으로 바람이 강한 구간만 쓴다)».",
        },
        PeaksAbove { peaks: Values } => {
            en: "The spectrum has further peaks that a test on their scatter refused: {peaks}. They may be modes, so those found may not be all; the section of the record says how far off each is, and what admits it.",
            ko: "산포 기준에서 제외된 피크가 더 있다: {peaks}. 모드일 수 있으므로 찾은 모드가 전부가 아닐 수 있다. 기준과의 차이와 채택 방법은 기록 항목에 있다.",
        },
        PeaksBelow { peaks: Values, lowest: Quantity } => {
            en: "Below the lowest mode found, {lowest}, the spectrum has peaks that a test refused: {peaks}. The first mode may be among them; the section of the record says which test, and what admits it.",
            ko: "찾은 최저차 모드 {lowest} 아래에 판정 기준에서 제외된 피크가 있다: {peaks}. 1차 모드일 수 있다. 제외 사유와 채택 방법은 기록 항목에 있다.",
        },
        OneMoreFault { first: Sentence } => {
            en: "{first} One more fault of its channels is named with the record.",
            ko: "{first} 그 외 채널 이상 1건은 기록 항목에 있다.",
        },
        MoreFaults { first: Sentence, more: usize } => {
            en: "{first} {more} more faults of its channels are named with the record.",
            ko: "{first} 그 외 채널 이상 {more}건은 기록 항목에 있다.",
        },
        Unconfirmed { file: String, column: String } => {
            en: "Record {file}: column \"{column}\" could not be read as times, so nothing in the file confirms the sampling rate given. If that is wrong, every frequency is wrong by the same factor.",
            ko: "기록 {file}: \"{column}\" 열을 시각으로 읽지 못해, 입력한 샘플링 주파수를 확인할 자료가 파일에 없다. 그 값이 틀리면 모든 진동수가 같은 비율로 틀린다.",
        },
        ClocksDiffer { first: String, second: String, dates: Quantity, given: Quantity } => {
            en: "By the dates in the files, {second} begins {dates} after {first}; by the project file, {given} after it. A wrong start turns the shapes across the two files, and their signs: give each file the begins of its first date, unless its clock was wrong.",
            ko: "파일의 시각으로는 {second}이(가) {first}보다 {dates} 늦게 시작하지만 프로젝트 파일에는 {given} 늦게 시작하는 것으로 되어 있다. 시작 시각이 틀리면 두 파일에 걸친 모드형상과 그 부호가 틀린다. 기록계의 시계가 틀린 것이 아니면 각 파일의 begins에 첫 시각을 입력한다.",
        },
        Still { channel: String, share: Quantity } => {
            en: "PROBABLY A SLIP: {channel} moves by less than {share} % of the largest in every mode. If it does not stand on firm ground, is it connected, and in the same unit as the others (g read as gal is 981 times too small, m/s² as mm/s² 1000 times)?",
            ko: "입력 오류 의심: {channel}은(는) 모든 모드에서 최대 성분의 {share} % 미만으로 움직인다. 단단한 지반 위의 센서가 아니라면, 연결되어 있고 단위가 다른 채널과 같은가(g를 gal로 읽으면 981배, m/s²를 mm/s²로 읽으면 1000배 작다)?",
        },
        Lost { file: String, said: Sentence } => { en: "Record {file}: {said}.", ko: "기록 {file}: {said}." },
        Setups { setups: usize, modes: usize, sensors: usize, values: Sentence, differing: usize, left_out: Sentence } => {
            en: "{setups} setups together ({sensors} sensors) show modes: {modes}; {values}. Modes in which the setups differ beyond chance: {differing}.{left_out}",
            ko: "측정 배치 {setups}개를 합성하여 센서 {sensors}개에서 모드 {modes}개를 찾았다: {values}. 이 중 {differing}개에서 배치 사이의 차이가 유의하다.{left_out}",
        },
        NoneLeftOut => { en: "", ko: "" },
        LeftOut { count: usize } => {
            en: " Frequencies left out, since their shapes at the references differ between the setups: {count}. If these are many, look for a sensor that was turned or exchanged.",
            ko: " 기준 센서에서의 형상이 배치마다 달라 제외한 진동수: {count}개. 여럿이면 돌아갔거나 바뀐 센서가 있는지 확인한다.",
        },
        SetupsNone { setups: usize, sensors: usize } => {
            en: "{setups} setups together ({sensors} sensors) show no mode.",
            ko: "측정 배치 {setups}개를 합성하였으나 센서 {sensors}개에서 공통된 모드를 찾지 못하였다.",
        },
    }
}

/// Findings on the records of all surveys, with their names if several have records.
pub(crate) fn findings(surveys: &[SurveyAnswer]) -> Vec<Finding> {
    let are_several = surveys.iter().filter(|survey| survey.modes().is_some()).count() > 1;
    let each = surveys.iter().flat_map(|survey| {
        of_survey(survey).into_iter().map(move |found| match are_several {
            false => found,
            true => Finding {
                sentence: Found::OfSurvey {
                    survey: survey.name.clone(),
                    said: found.sentence,
                }
                .into(),
                ..found
            },
        })
    });
    each.collect()
}

/// Findings on the records of a survey.
fn of_survey(survey: &SurveyAnswer) -> Vec<Finding> {
    let mut all: Vec<Finding> = survey.records.iter().flat_map(of_record).collect();
    if let Some(setups) = &survey.setups {
        all.push(of_setups(setups));
        let faults = setup_faults(setups).into_iter();
        all.extend(faults.map(|said| Finding::key(Tone::Warn, said).with_code("setups")));
        all.extend(accepted(&setups.modes().modes));
        let quakes = setups.records.iter().flat_map(|record| &record.earthquake);
        all.extend(quakes.clone().flat_map(earthquake::findings));
        all.extend(quakes.map(earthquake::modes_of));
        all.extend(setups.records.iter().flat_map(doubts));
    }
    all
}

fn of_record(record: &RecordAnswer) -> Vec<Finding> {
    let modes = &record.analysis.modes;
    let minute = Unit {
        symbol: String::new(),
        factor: 1.0 / 60.0,
    };
    let minutes = Quantity::new(modes.duration_s, minute, Digits::Significant(2));
    let channels = match modes.channels.len() {
        1 => Found::OneChannel,
        count => Found::Channels { count },
    }
    .into();
    let by_hand = |note: &Note| matches!(note, Note::NotPicked { .. });
    let how = match (record.analysis.notes.iter().any(by_hand), &record.analysis.driven) {
        (_, Some(driven)) => Found::OnHeldBase {
            inputs: driven.inputs.clone(),
        },
        (true, None) => Found::ByHand,
        (false, None) => Found::ByItself,
    }
    .into();
    let found: Vec<&Mode> = modes.modes.iter().filter(|mode| mode.is_found()).collect();
    let values = frequencies(&found);
    let first = match found.len() {
        0 => Finding::answer(Tone::Unknown, Found::None { minutes, channels }),
        1 => Finding::answer(
            Tone::Plain,
            Found::One {
                minutes,
                channels,
                how,
                values,
            },
        ),
        count => Finding::answer(
            Tone::Plain,
            Found::Several {
                modes: count,
                minutes,
                channels,
                how,
                values,
            },
        ),
    };
    let mut all: Vec<Finding> = record.earthquake.iter().flat_map(earthquake::findings).collect();
    all.push(first);
    all.extend(record.earthquake.iter().map(earthquake::modes_of));
    all.extend(following(record));
    all.extend(cautions(record));
    all.extend(refused_peaks(record, &found));
    all.extend(in_spells(record));
    all.extend(accepted(&modes.modes));
    all.extend(doubts(record));
    all
}

/// Modes of a free decay whose frequency depends on the amplitude.
fn following(record: &RecordAnswer) -> Vec<Finding> {
    let decay = record.analysis.decay.iter();
    // with a single channel, it may also be two modes
    let each = decay.filter(|of| of.channels > 1).flat_map(|of| &of.modes);
    let bent = each.filter(|mode| mode.poles_hz.len() > 1);
    let said = bent.filter_map(|mode| {
        let (first, last) = (mode.swings.first()?, mode.swings.last()?);
        let rises = last.frequency_hz > first.frequency_hz;
        let [from, to] =
            [first, last].map(|at| Quantity::new(at.frequency_hz, Unit::si("Hz"), Digits::Significant(3)));
        let mode = hertz(mode.frequency_hz);
        let said = match rises {
            true => Found::Follows { mode, from, to },
            false => Found::Falls { mode, from, to },
        };
        Some(Finding::key(Tone::Warn, said))
    });
    said.collect()
}

/// Peaks of the spectrum that no test admits: below the lowest mode, where one may be the first mode, and those above that scatter too much.
fn refused_peaks(record: &RecordAnswer, found: &[&Mode]) -> Vec<Finding> {
    let frequencies = found.iter().map(|mode| mode.frequency_hz);
    let Some(lowest_hz) = frequencies.min_by(f64::total_cmp) else {
        return Vec::new();
    };
    let peaks = record.analysis.notes.iter().find_map(|note| match note {
        Note::PeaksWithoutMode { peaks } => Some(peaks.as_slice()),
        _ => None,
    });
    let is_scattered = |peak: &&RefusedPeak| matches!(peak.refusal, Some(Refusal::Scattered { .. }));
    let (below, above): (Vec<&RefusedPeak>, Vec<&RefusedPeak>) = peaks
        .unwrap_or_default()
        .iter()
        .partition(|peak| peak.frequency_hz < lowest_hz);
    let above = above.into_iter().filter(is_scattered);
    let hz = |peak: &RefusedPeak| peak.frequency_hz;
    let below: Vec<f64> = below.into_iter().map(hz).collect();
    let above: Vec<f64> = above.map(hz).collect();
    let below = (!below.is_empty()).then(|| Found::PeaksBelow {
        peaks: all_hertz(&below),
        lowest: hertz(lowest_hz),
    });
    let above = (!above.is_empty()).then(|| Found::PeaksAbove {
        peaks: all_hertz(&above),
    });
    let all = below.into_iter().chain(above);
    all.map(|said| Finding::qualifies(Tone::Warn, said).with_code("mode-missing"))
        .collect()
}

/// Lines that stand out only while the structure moves more.
fn in_spells(record: &RecordAnswer) -> Option<Finding> {
    let modes = record.analysis.notes.iter().find_map(|note| match note {
        Note::InSpells { modes } => Some(modes),
        _ => None,
    })?;
    let at: Vec<f64> = modes.iter().map(|of| of.frequency_hz).collect();
    let at = all_hertz(&at);
    Some(Finding::qualifies(Tone::Warn, Found::InSpells { at }))
}

/// The frequencies, and whether they have deviations.
fn frequencies(modes: &[&Mode]) -> Sentence {
    let values = Values(modes.iter().map(|mode| frequency(mode)).collect());
    let said = match modes.iter().any(|mode| mode.frequency_sd_hz.is_some()) {
        true => Found::WithDeviations { values },
        false => Found::WithoutDeviations { values },
    };
    said.into()
}

/// The modes that the user accepted.
fn accepted(modes: &[Mode]) -> Option<Finding> {
    let all: Vec<&Mode> = modes.iter().filter(|mode| !mode.is_found()).collect();
    let values = frequencies(&all);
    match all.len() {
        0 => None,
        1 => Some(Finding::key(Tone::Warn, Found::Accepted { values })),
        _ => Some(Finding::key(Tone::Warn, Found::AcceptedSeveral { values })),
    }
}

/// Contradictions between sensors, and the likely fix.
fn sensor(doubt: &SensorDoubt) -> Found {
    let share = |of: f64| Quantity::ratio(100.0 * of, 2);
    match doubt {
        SensorDoubt::Twins {
            channels: [first, second],
            likeness,
        } => Found::Twins {
            first: first.clone(),
            second: second.clone(),
            likeness: Quantity::ratio(*likeness, 2),
        },
        SensorDoubt::Turned {
            channel,
            unexplained,
            changed,
        } => Found::Turned {
            channel: channel.clone(),
            unexplained: share(*unexplained),
            changed: share(*changed),
        },
        SensorDoubt::StationTurned {
            channels,
            unexplained,
            changed,
        } => Found::StationTurned {
            channels: channels.clone(),
            unexplained: share(*unexplained),
            changed: share(*changed),
        },
        SensorDoubt::StationsSwapped {
            channels: [first, second],
            unexplained,
            changed,
        } => Found::StationsSwapped {
            first: first.clone(),
            second: second.clone(),
            unexplained: share(*unexplained),
            changed: share(*changed),
        },
        SensorDoubt::Swapped {
            channels: [first, second],
            unexplained,
            changed,
        } => Found::Swapped {
            first: first.clone(),
            second: second.clone(),
            unexplained: share(*unexplained),
            changed: share(*changed),
        },
    }
}

/// Coherence with the measured input below which the input explains little of a mode. Our choice.
const FOLLOWS_LITTLE: f64 = 0.3;

fn follows_little(mode: &DrivenMode) -> Option<Finding> {
    let share = mode.explained.filter(|share| *share < FOLLOWS_LITTLE)?;
    let found = Found::FollowsLittle {
        frequency: hertz(mode.frequency_hz),
        share: Quantity::ratio(100.0 * share, 2),
    };
    Some(Finding::key(Tone::Warn, found))
}

/// A channel whose values are so small compared with the others that its unit is probably wrong, or that stands still among moving ones.
fn still(record: &RecordAnswer, note: &Note) -> Option<Finding> {
    match note {
        Note::StandsStill { channel, share } if *share < OTHER_UNIT || stands_among(record, channel) => {
            let found = Found::Still {
                channel: channel.clone(),
                share: Quantity::ratio(100.0 * share.max(0.001), 1),
            };
            Some(Finding::key(Tone::Warn, found).with_code("sensor-slip"))
        }
        _ => None,
    }
}

/// Whether a channel stands above the ground, and not below any channel that moves: it cannot be on firm ground.
fn stands_among(record: &RecordAnswer, name: &str) -> bool {
    let height_m = |of: &Channel| of.position_m.map(|[_, _, z]| z);
    let channels = &record.analysis.modes.channels;
    let own = channels.iter().find(|of| of.name == name).and_then(height_m);
    let is_still = |other: &Channel| {
        let mut notes = record.analysis.notes.iter();
        notes.any(|note| matches!(note, Note::StandsStill { channel, .. } if *channel == other.name))
    };
    own.is_some_and(|own| {
        let mut moving = channels.iter().filter(|of| !is_still(of)).filter_map(height_m);
        own > 0.0 && moving.any(|z| z <= own)
    })
}

/// Whether a channel at rest in the modes moved in an earthquake of the record as much as its unit implies. It is then connected, and
/// stands on the ground.
fn has_felt(record: &RecordAnswer, note: &Note) -> bool {
    let Note::StandsStill { channel, .. } = note else {
        return false;
    };
    let events = record.earthquake.iter().flat_map(|of| &of.found.events);
    events.into_iter().any(|event| {
        let most = event.channels.iter().map(|of| of.peak).fold(0.0, f64::max);
        let own = event.channels.iter().find(|of| of.name == *channel);
        own.is_some_and(|own| own.peak > OTHER_UNIT * most)
    })
}

/// Lost samples and faults of channels.
fn doubts(record: &RecordAnswer) -> Vec<Finding> {
    let lost =
        |step: &Processing| matches!(step, Processing::LongestSpan { .. } | Processing::Bridged { .. });
    let steps = record.analysis.modes.history.iter().filter(|step| lost(step));
    let mut all: Vec<Finding> = steps
        .map(|step| {
            let found = Found::Lost {
                file: record.file.clone(),
                said: step_words(step),
            };
            Finding::key(Tone::Warn, found).with_code("lost-samples")
        })
        .collect();
    all.extend(record.unread_stamps.iter().map(|column| {
        let found = Found::Unconfirmed {
            file: record.file.clone(),
            column: column.clone(),
        };
        Finding::key(Tone::Warn, found)
    }));
    all.extend(record.clock_doubts.iter().map(|doubt| {
        let seconds = |value_s| Quantity::new(value_s, Unit::si("s"), Digits::Trimmed(6));
        let found = Found::ClocksDiffer {
            first: doubt.first.clone(),
            second: doubt.second.clone(),
            dates: seconds(doubt.by_dates_s),
            given: seconds(doubt.as_given_s),
        };
        Finding::key(Tone::Warn, found)
    }));
    let faults = match record.faults.as_slice() {
        [] => None,
        [one] => Some(fault_words(one)),
        [first, _] => {
            let first = fault_words(first);
            Some(Found::OneMoreFault { first }.into())
        }
        [first, more @ ..] => {
            let (first, more) = (fault_words(first), more.len());
            Some(Found::MoreFaults { first, more }.into())
        }
    };
    all.extend(faults.map(|found| Finding::key(Tone::Warn, found).with_code("channel-fault")));
    all.extend(
        record
            .doubts
            .iter()
            .map(|doubt| Finding::key(Tone::Warn, sensor(doubt)).with_code("sensor-slip")),
    );
    let still = record
        .analysis
        .notes
        .iter()
        .filter(|note| !has_felt(record, note));
    all.extend(still.filter_map(|note| self::still(record, note)));
    let off = record.analysis.driven.iter().flat_map(|of| &of.off_ground);
    all.extend(off.map(|of| Finding::key(Tone::Warn, driven::off_ground(of)).with_code("sensor-slip")));
    let driven = record.analysis.driven.iter().flat_map(|of| &of.modes);
    all.extend(driven.filter_map(follows_little));
    let weighs = |note: &&Note| {
        matches!(
            note,
            Note::ClockDrift { .. }
                | Note::LateClocks { .. }
                | Note::EitherLate { .. }
                | Note::QuarterTurn { .. }
                | Note::EitherTurned { .. }
                | Note::Wandering { removed: false, .. }
                | Note::TonesOnModes { .. }
                | Note::Comb { .. }
        )
    };
    let weighing = record.analysis.notes.iter().filter(weighs);
    let nothing = |note: &&Note| matches!(note, Note::NothingToAccept { .. });
    let in_vain = record.analysis.notes.iter().filter(nothing);
    all.extend(in_vain.map(|note| Finding::key(Tone::Warn, note_words(note))));
    all.extend(weighing.map(|note| Finding::key(Tone::Warn, note_words(note))));
    all
}

fn of_setups(setups: &SetupsAnswer) -> Finding {
    let modes = setups.modes().modes.iter().filter(|mode| mode.is_found());
    let modes: Vec<&Mode> = modes.collect();
    let sensors = setups.merged.modes.channels.len();
    if modes.is_empty() {
        let found = Found::SetupsNone {
            setups: setups.records.len(),
            sensors,
        };
        return Finding::key(Tone::Unknown, found);
    }
    let differing = setups.merged.merged.iter().filter(|of| of.frequency.differs());
    let differing = differing.count();
    let tone = match differing {
        0 => Tone::Plain,
        _ => Tone::Warn,
    };
    let found = Found::Setups {
        setups: setups.records.len(),
        modes: modes.len(),
        sensors,
        values: frequencies(&modes),
        differing,
        left_out: match unlike_frequencies(&setups.merged.partial) {
            0 => Found::NoneLeftOut,
            count => Found::LeftOut { count },
        }
        .into(),
    };
    Finding::key(tone, found).with_code("setups")
}

/// Number of different frequencies at which the setups have different shapes.
fn unlike_frequencies(partial: &[PartialMode]) -> usize {
    const ONE: f64 = 0.01; // relative; the setups show one mode within less
    let unlike = partial.iter().filter(|mode| !mode.unlike_in.is_empty());
    let mut frequency_hz: Vec<f64> = unlike.map(|mode| mode.frequency_hz).collect();
    frequency_hz.sort_by(f64::total_cmp);
    frequency_hz.dedup_by(|later, first| *later / *first - 1.0 <= ONE);
    frequency_hz.len()
}
