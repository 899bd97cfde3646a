//! Sensors that were moved, replaced or turned, and modes that jumped.

use super::cause::cause;
use super::numbers::{hertz, name, plain};
use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, Sentence, messages};
use dolmen_work::watched::WatchAnswer;

messages! {
    /// Findings on sensors and on modes that jumped.
    pub(crate) enum Moved in "watch.sensors" {
        SensorOrStructure { survey: String, cause: Sentence } => {
            en: "Shapes and frequencies jumped on {survey}{cause}: a sensor that was moved or turned changes shapes alone, so look at both, the sensors and the structure.",
            ko: "{survey}에 모드형상과 고유진동수가 함께 급변하였다{cause}. 센서의 이동이나 방향 변경은 형상만 바꾸므로 센서와 구조물을 모두 점검한다.",
        },
        Sensor { survey: String, channel: String, cause: Sentence } => {
            en: "Shapes jumped on {survey} while frequencies did not{cause}: sensor \"{channel}\" was moved, replaced or turned, not the structure.",
            ko: "{survey}에 고유진동수는 그대로이나 모드형상이 급변하였다{cause}. 구조물의 변화가 아니라 센서 ‘{channel}’의 이동·교체 또는 방향 변경으로 판단된다.",
        },
        Sensors { survey: String, cause: Sentence } => {
            en: "Shapes jumped on {survey} while frequencies did not{cause}: sensors were moved, replaced or turned, not the structure.",
            ko: "{survey}에 고유진동수는 그대로이나 모드형상이 급변하였다{cause}. 구조물의 변화가 아니라 센서의 이동·교체 또는 방향 변경으로 판단된다.",
        },
        Jumped { from: Quantity, to: Quantity, survey: String, mac: Quantity } => {
            en: "{from} ended and {to} began on {survey} with a like shape (MAC {mac}): perhaps one mode that jumped.",
            ko: "{survey}에 {from} 모드가 사라지고 모드형상이 비슷한(MAC {mac}) {to} 모드가 나타났다. 한 모드가 급변한 것일 수 있다.",
        },
    }
}

/// Surveys between which shapes jumped, and modes that may have.
pub(super) fn sensors(answer: &WatchAnswer) -> Vec<Finding> {
    let tracked = &answer.watched.tracked;
    let sensors = tracked.sensors.iter().map(|change| {
        let survey = name(answer, change.survey);
        let day = |of: usize| answer.surveys.get(of).map_or(f64::NAN, |survey| survey.day);
        let cause = cause(answer, [day(change.survey.saturating_sub(1)), day(change.survey)]);
        let cause: Sentence = cause.into();
        let modes = answer.watched.modes.iter();
        let mut changes = modes.flat_map(|mode| &mode.changes);
        let said = match &change.channel {
            _ if changes.any(|of| (of.after..=of.before).contains(&change.survey)) => {
                Moved::SensorOrStructure { survey, cause }
            }
            Some(channel) => Moved::Sensor {
                survey,
                channel: channel.clone(),
                cause,
            },
            None => Moved::Sensors { survey, cause },
        };
        Finding::key(Tone::Warn, said)
    });
    let is_lost = |from_hz: f64| {
        let mut lost = answer.watched.lost.iter();
        lost.any(|of| {
            let own = answer.watched.modes.get(of.mode);
            of.began_hz.is_some() && own.is_some_and(|own| own.track.frequency_hz == from_hz)
        })
    };
    // modes missing in the last surveys come first
    let jumped = tracked.jumped.iter().filter(|jumped| !is_lost(jumped.from_hz));
    let jumped = jumped.map(|jumped| {
        let said = Moved::Jumped {
            from: hertz(jumped.from_hz),
            to: hertz(jumped.to_hz),
            survey: name(answer, jumped.at),
            mac: plain(jumped.assurance, 2),
        };
        Finding::key(Tone::Warn, said)
    });
    sensors.chain(jumped).collect()
}
