//! Findings on failing sensors.

use crate::document::{Finding, Tone};
use dolmen_words::{Sentence, messages};
use dolmen_work::sensor_alarms::SensorFault;
use dolmen_work::watched::WatchAnswer;

messages! {
    /// What is wrong with sensors.
    pub(crate) enum Failing in "watch.sensor" {
        Fails { channel: String, fault: Sentence, since: String, records: usize } => {
            en: "SENSOR: \"{channel}\" {fault} since {since} (records: {records}). That says nothing of the structure: look at the sensor, its cable and the logger.",
            ko: "센서: \"{channel}\" {fault}({since}부터, 기록 {records}건). 구조물의 변화가 아니므로 센서, 케이블, 기록계를 점검한다.",
        },
        WorksAgain { channel: String, fault: Sentence, since: String, last: String } => {
            en: "From {since} to {last} sensor \"{channel}\" {fault}; it works again.",
            ko: "{since}부터 {last}까지 센서 \"{channel}\" {fault}. 이후 정상이다.",
        },
        Dead => { en: "is dead", ko: "신호 없음" },
        WasDead => { en: "was dead", ko: "신호 없음" },
        Faint => { en: "is far weaker than the others", ko: "다른 센서보다 매우 약함" },
        WasFaint => { en: "was far weaker than the others", ko: "다른 센서보다 매우 약함" },
        Stuck => { en: "stands still for a while in each record", ko: "기록마다 한동안 값이 멈춤" },
        WasStuck => { en: "stood still for a while in each record", ko: "기록마다 한동안 값이 멈춤" },
        Faded => { en: "changes its strength tenfold within records", ko: "기록 중 세기가 10배 이상 변함" },
        WasFaded => { en: "changed its strength tenfold within records", ko: "기록 중 세기가 10배 이상 변함" },
        Loose => { en: "is loose: its fast motion grows and falls back, again and again", ko: "고정 또는 접촉 불량(빠른 성분의 세기가 반복하여 변함)" },
        WasLoose => { en: "was loose: its fast motion grew and fell back, again and again", ko: "고정 또는 접촉 불량(빠른 성분의 세기가 반복하여 변함)" },
        Alike => { en: "shows almost the signal of another", ko: "다른 센서와 거의 같은 신호" },
        WasAlike => { en: "showed almost the signal of another", ko: "다른 센서와 거의 같은 신호" },
        Drifts => { en: "drifts by far more than it moves", ko: "운동보다 훨씬 큰 표류" },
        WasDrifting => { en: "drifted by far more than it moved", ko: "운동보다 훨씬 큰 표류" },
        Spikes => { en: "shows single wild samples", ko: "튀는 표본" },
        WasSpiky => { en: "showed single wild samples", ko: "튀는 표본" },
        Clipped => { en: "is clipped", ko: "포화(클리핑)" },
        WasClipped => { en: "was clipped", ko: "포화(클리핑)" },
        Duplicated => { en: "holds the signal of another", ko: "다른 센서와 같은 신호" },
        WasDuplicated => { en: "held the signal of another", ko: "다른 센서와 같은 신호" },
    }
}

/// The fault, present and past.
fn words(fault: SensorFault) -> [Failing; 2] {
    match fault {
        SensorFault::Dead => [Failing::Dead, Failing::WasDead],
        SensorFault::Faint => [Failing::Faint, Failing::WasFaint],
        SensorFault::Stuck => [Failing::Stuck, Failing::WasStuck],
        SensorFault::Faded => [Failing::Faded, Failing::WasFaded],
        SensorFault::Loose => [Failing::Loose, Failing::WasLoose],
        SensorFault::Alike => [Failing::Alike, Failing::WasAlike],
        SensorFault::Drifts => [Failing::Drifts, Failing::WasDrifting],
        SensorFault::Spikes => [Failing::Spikes, Failing::WasSpiky],
        SensorFault::Clipped => [Failing::Clipped, Failing::WasClipped],
        SensorFault::Duplicated => [Failing::Duplicated, Failing::WasDuplicated],
    }
}

/// A finding for each sensor that failed.
pub(super) fn failing(answer: &WatchAnswer) -> impl Iterator<Item = Finding> + '_ {
    answer.sensor_alarms.iter().map(|alarm| {
        let [now, before] = words(alarm.fault);
        let (channel, since) = (alarm.channel.clone(), alarm.since.clone());
        match alarm.is_open {
            true => Finding::key(
                Tone::Warn,
                Failing::Fails {
                    channel,
                    fault: now.into(),
                    since,
                    records: alarm.records,
                },
            ),
            false => Finding::new(
                Tone::Plain,
                Failing::WorksAgain {
                    channel,
                    fault: before.into(),
                    since,
                    last: alarm.last.clone(),
                },
            ),
        }
    })
}
