//! What a history says in plain words.

use super::earthquakes::earthquakes;
use super::failing::failing;
use super::logs::logs;
use super::lost::{last_apart, lost, wandering};
use super::numbers::{HALF_95, bare_percent, hertz, name, percent, plain};
use super::tilts::{jumped, leans, tilt};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{
    ChangeForm, LastOff, NotJudged, StructureAlarm, WatchedChange, WatchedMode, WeatherKnown, WorkEffect,
};
use dolmen_project::{WorkKind, WorkPart};
use dolmen_words::{Language, Quantity, Sentence, messages};
use dolmen_work::watched::WatchAnswer;

/// Changes that get a finding each; the others are counted.
const TOLD_MOST: usize = 4;

messages! {
    /// Findings on a history.
    pub(crate) enum Found in "watch.findings" {
        PlusMinus => {
            en: "± is half the width of an interval that holds 95 %.",
            ko: "±는 95 % 신뢰구간의 반폭이다.",
        },
        OpenAlarm { frequency: Quantity, since: String, confirmed: String } => {
            en: "ALARM: {frequency} left what earlier surveys predict, since {since}, confirmed on {confirmed}, and no repair or inspection followed. Look at the structure; then enter it into works of [watch].",
            ko: "경보: {frequency} 모드가 {since}부터 이전 조사의 예측을 벗어났고 {confirmed}에 확정되었으나 이후 보수나 점검이 없다. 구조물을 점검하고 [watch]의 works에 기록한다.",
        },
        FurtherAlarms { count: usize } => {
            en: "Further alarms without an answer: {count}.",
            ko: "조치되지 않은 경보가 {count}건 더 있다.",
        },
        NoOpenAlarm { answered: usize, last: String } => {
            en: "No open alarm up to the survey of {last} (answered earlier: {answered}).",
            ko: "{last} 조사까지 조치되지 않은 경보가 없다(조치된 경보: {answered}건).",
        },
        NoneJudged { training: usize } => {
            en: "No survey was judged against those before it: that needs more than {training} surveys.",
            ko: "이전 조사와 비교하여 판정한 조사가 없다. 판정에는 조사 {training}회를 초과하는 기록이 필요하다.",
        },
        LastNotJudged { last: String, reason: Sentence } => {
            en: "The survey of {last} was not judged: {reason}.",
            ko: "{last} 조사는 판정하지 않았다: {reason}.",
        },
        Stepped { frequency: Quantity, by: Quantity, half: Quantity, after: String, before: String, chance: Sentence, stiffness: Quantity, cause: Sentence } => {
            en: "{frequency} changed by {by} ± {half} between {after} and {before} ({chance}){cause}; if all stiffness changed alike, by {stiffness}.",
            ko: "{frequency} 모드는 {after}와(과) {before} 사이에 {by} ± {half} 변하였다({chance}){cause}. 전체가 같은 비율로 변하였다면 강성 변화는 {stiffness}이다.",
        },
        Drifted { frequency: Quantity, by: Quantity, half: Quantity, since: String, yearly: Quantity, chance: Sentence } => {
            en: "{frequency} drifts by {yearly} a year since about {since}, {by} ± {half} so far ({chance}).",
            ko: "{frequency} 모드는 {since}경부터 해마다 {yearly}씩 점진적으로 변하여 지금까지 {by} ± {half} 변하였다({chance}).",
        },
        Further { count: usize } => {
            en: "Further changes of modes: {count}.",
            ko: "그 밖의 모드 변화: {count}건.",
        },
        Unchanged { modes: usize, from: String, to: String, least: Quantity } => {
            en: "No lasting change was shown from {from} to {to}, modes followed: {modes}. A step of {least} halfway would have been seen with 80 % probability in each; smaller ones could have been missed.",
            ko: "{from}부터 {to}까지 추적한 모드 {modes}개에서 지속적인 변화가 확인되지 않았다. 중간 시점의 {least} 급변은 각 모드에서 80 %의 확률로 발견되었을 것이나 그보다 작은 변화는 놓쳤을 수 있다.",
        },
        TooFew { from: String, to: String } => {
            en: "Whether a frequency changed lastingly from {from} to {to} cannot be said: no mode was found in 8 surveys or more. Measure on, or compare two surveys (`dolmen compare`).",
            ko: "{from}부터 {to}까지 고유진동수가 지속적으로 변하였는지 판단할 수 없다. 8회 이상의 조사에서 확인된 모드가 없다. 계측을 계속하거나 두 조사를 비교한다(`dolmen compare`).",
        },
        Missed { frequency: Quantity, least: Quantity } => {
            en: "Beside that, a lasting step of {least} would have been seen with 80 % probability, in the mode that shows least ({frequency}).",
            ko: "이 밖에 {least} 이상의 계단형 변화가 있었다면 80 % 확률로 검출되었을 것이다(가장 불리한 모드 {frequency}).",
        },
        Worked { date: String, frequency: Quantity, by: Quantity, half: Quantity } => {
            en: "With the repair of {date} {frequency} changed by {by} ± {half}.",
            ko: "{date} 보수 전후로 {frequency} 모드는 {by} ± {half} 변하였다.",
        },
        SensorOrStructure { survey: String } => {
            en: "Shapes and frequencies jumped on {survey}: a sensor that was moved or turned changes shapes alone, so look at both, the sensors and the structure.",
            ko: "{survey}에 모드형상과 고유진동수가 함께 급변하였다. 센서의 이동이나 방향 변경은 형상만 바꾸므로 센서와 구조물을 모두 점검한다.",
        },
        NoTemperature => {
            en: "Temperatures are not known: only repeating seasons can tell a lasting change from the weather. Enter temperature_c with each survey.",
            ko: "기온을 알 수 없어 지속적인 변화와 날씨의 영향은 계절이 반복되는 만큼만 구별된다. 조사마다 temperature_c를 기록한다.",
        },
        WithTime { frequency: Quantity, correlation: Quantity } => {
            en: "Temperature went with time ({frequency}: correlation {correlation}): ageing and weather can hardly be separated, and less is seen.",
            ko: "기온이 시간과 함께 변하여({frequency}: 상관계수 {correlation}) 노후와 날씨의 영향이 잘 구별되지 않으며 발견할 수 있는 변화가 줄어든다.",
        },
        LastOff { frequency: Quantity, by: Quantity, half: Quantity, since: String } => {
            en: "Since {since}, {frequency} lies {by} ± {half} off what the surveys before and the weather explain: in one or two surveys, too few to call it a lasting change. Measure again soon.",
            ko: "{since}부터 {frequency} 모드가 이전 조사와 기상으로 설명되는 값에서 {by} ± {half} 벗어났다. 조사가 1~2회뿐이어서 지속적인 변화로 판정하지 않는다. 곧 다시 계측한다.",
        },
        Sensor { survey: String, channel: String } => {
            en: "Shapes jumped on {survey} while frequencies did not: sensor \"{channel}\" was moved, replaced or turned, not the structure.",
            ko: "{survey}에 고유진동수는 그대로이나 모드형상이 급변하였다. 구조물이 아니라 센서 \"{channel}\"이(가) 이동·교체되었거나 방향이 바뀌었다.",
        },
        Sensors { survey: String } => {
            en: "Shapes jumped on {survey} while frequencies did not: sensors were moved, replaced or turned, not the structure.",
            ko: "{survey}에 고유진동수는 그대로이나 모드형상이 급변하였다. 구조물이 아니라 센서가 이동·교체되었거나 방향이 바뀌었다.",
        },
        Jumped { from: Quantity, to: Quantity, survey: String, mac: Quantity } => {
            en: "{from} ended and {to} began on {survey} with a like shape (MAC {mac}): perhaps one mode that jumped.",
            ko: "{survey}에 {from} 모드가 사라지고 모드형상이 비슷한(MAC {mac}) {to} 모드가 나타났다. 한 모드가 급변한 것일 수 있다.",
        },
        FarAhead { date: String, last: String } => {
            en: "The work of {date} in [watch] is dated more than a year after the last survey, {last}: no survey shows what it did, and alarms before it stay open until one does. Is the year right?",
            ko: "[watch]의 {date} 작업은 마지막 조사 {last}보다 1년 넘게 뒤여서 그 효과를 보여 주는 조사가 없다. 다음 조사까지 이전 경보는 그대로 둔다. 연도가 맞는가?",
        },
        Rate { share: Quantity } => {
            en: "Confirmed false alarms come at the stated mean rate; over these years at least one with {share} probability.",
            ko: "확정된 오경보는 정해진 평균 빈도로 발생하며, 이 기간에 한 번 이상 발생할 확률은 {share}이다.",
        },
        Chance { p: Quantity } => { en: "p = {p}", ko: "p = {p}" },
        ChanceBelow => { en: "p < 0.001", ko: "p < 0.001" },
    }
}

messages! {
    /// Why, or what stands near in time.
    pub(crate) enum Cause in "watch.cause" {
        Nothing => { en: "", ko: "" },
        Event { number: usize, what: String } => { en: ", as event {number} fell into that time ({what})", ko: ", 이 기간에 사건 {number}({what})이 있었다" },
        Training => { en: "too few surveys before it", ko: "이전 조사가 너무 적다" },
        NewLevel => { en: "the level after a repair or alarm is still being learned", ko: "보수 또는 경보 이후의 수준을 아직 익히는 중이다" },
        Temperature { temperature: Quantity } => { en: "too few earlier surveys near {temperature}", ko: "{temperature} 부근에서 실시한 이전 조사가 너무 적다" },
        NoTemperature => { en: "its temperature is not known", ko: "기온을 알 수 없다" },
        NotFound => { en: "none of the modes that are followed was found", ko: "추적 중인 모드가 확인되지 않았다" },
    }
}

pub(super) fn chance(p: f64) -> Sentence {
    match p < 0.001 {
        true => Found::ChanceBelow.into(),
        false => Found::Chance { p: plain(p, 3) }.into(),
    }
}

/// The findings: alarms, changes, what could have been missed, tilts, what is doubtful.
pub(crate) fn findings(answer: &WatchAnswer) -> Vec<Finding> {
    // no alarm is no good news where something changed and nobody answered it
    let mut all = earthquakes(answer);
    all.extend(lost(answer));
    let alarms = alarms(answer);
    let is_news = alarms.iter().any(|of| of.tone == Tone::Bad) || !has_unanswered(answer);
    let (before, after) = match is_news {
        true => (alarms, Vec::new()),
        false => (Vec::new(), alarms),
    };
    all.extend(before);
    all.extend(far_ahead(answer));
    all.extend(last_survey(answer));
    all.extend(changes(answer));
    all.extend(after);
    all.extend(weather(answer));
    all.extend(leans(answer));
    all.extend(
        answer
            .watched
            .tilts
            .iter()
            .filter_map(|trend| jumped(answer, trend)),
    );
    all.extend(
        answer
            .watched
            .tilts
            .iter()
            .filter_map(|trend| tilt(answer, trend)),
    );
    all.extend(logs(answer));
    all.extend(works(answer));
    all.extend(failing(answer));
    all.extend(sensors(answer));
    let has_interval = all
        .iter()
        .any(|of| of.is_key && of.sentence.text(Language::English).contains('±'));
    all.extend(has_interval.then(|| Finding::key(Tone::Plain, Found::PlusMinus)));
    // tilts alone give no alarm of the structure
    if answer.watched.false_alarm_probability > 0.0 && !answer.watched.modes.is_empty() {
        all.push(Finding::new(
            Tone::Plain,
            Found::Rate {
                share: percent(answer.watched.false_alarm_probability, 0),
            },
        ));
    }
    all
}

fn mode_hz(answer: &WatchAnswer, mode: usize) -> Quantity {
    hertz(
        answer
            .watched
            .modes
            .get(mode)
            .map_or(f64::NAN, |mode| mode.track.frequency_hz),
    )
}

/// Whether the last surveys say too little of the modes, or a repair loosened something: no alarm is no good news then.
fn is_doubtful(answer: &WatchAnswer) -> bool {
    let mut effects = answer.watched.modes.iter().flat_map(|mode| &mode.works);
    !answer.watched.lost.is_empty() || last_survey(answer).is_some() || effects.any(loosens)
}

/// Whether a frequency fell with a repair.
fn loosens(effect: &WorkEffect) -> bool {
    effect.ratio < -FALLS_FROM * effect.sd
}

fn alarms(answer: &WatchAnswer) -> Vec<Finding> {
    let watched = &answer.watched;
    let open: Vec<&StructureAlarm> = watched.alarms.iter().filter(|alarm| !alarm.is_answered).collect();
    let is_judged = watched
        .modes
        .iter()
        .any(|mode| mode.judged.judged.iter().any(|judged| judged.score.is_ok()));
    let Some(first) = open.first() else {
        let last = name(answer, answer.surveys.len().saturating_sub(1));
        let answered = watched.alarms.len();
        if watched.is_mode_lost() || answer.open_earthquakes().next().is_some() {
            return Vec::new();
        }
        return match is_judged {
            true => {
                let tone = match has_unanswered(answer) || is_doubtful(answer) {
                    true => Tone::Plain,
                    false => Tone::Good,
                };
                vec![Finding::key(tone, Found::NoOpenAlarm { answered, last })]
            }
            false if answer.watched.modes.is_empty() => Vec::new(),
            false => vec![Finding::key(Tone::Unknown, Found::NoneJudged { training: 10 })],
        };
    };
    let mut all = vec![Finding::key(
        Tone::Bad,
        Found::OpenAlarm {
            frequency: mode_hz(answer, first.mode),
            since: name(answer, first.alarm.since),
            confirmed: name(answer, first.alarm.survey),
        },
    )];
    if open.len() > 1 {
        all.push(Finding::key(
            Tone::Bad,
            Found::FurtherAlarms {
                count: open.len() - 1,
            },
        ));
    }
    all
}

/// Works that are dated far behind the last survey.
fn far_ahead(answer: &WatchAnswer) -> Vec<Finding> {
    let last = name(answer, answer.surveys.len().saturating_sub(1));
    let far = answer.works.iter().filter(|(day, _)| answer.is_far_ahead(*day));
    let said = far.map(|(_, work)| Found::FarAhead {
        date: work.date.clone(),
        last: last.clone(),
    });
    said.map(|said| Finding::key(Tone::Warn, said)).collect()
}

/// Whether a mode changed, or its last surveys lie off, and no repair and no inspection followed.
fn has_unanswered(answer: &WatchAnswer) -> bool {
    let answers = |(day, work): &&(f64, WorkPart)| {
        matches!(work.kind, WorkKind::Repair | WorkKind::Inspection) && !answer.is_far_ahead(*day)
    };
    let answered_until = answer.works.iter().rev().find(answers).map(|(day, _)| *day);
    let is_open = |survey: usize| {
        let day = answer.surveys.get(survey).map(|of| of.day);
        day.zip(answered_until).is_none_or(|(day, until)| until < day)
    };
    answer.watched.modes.iter().any(|mode| {
        let off = mode.last_off.map(|off| off.from);
        mode.changes
            .iter()
            .map(|change| change.before)
            .chain(off)
            .any(is_open)
    })
}

/// Standard deviations by which a frequency falls with a repair from which that stands first. Chosen here.
const FALLS_FROM: f64 = 3.0;

/// Why the last survey was not judged, where no mode of it was.
fn last_survey(answer: &WatchAnswer) -> Option<Finding> {
    let last = answer.surveys.len().checked_sub(1)?;
    if answer.watched.modes.is_empty() {
        return None; // tilts alone are watched
    }
    let of_last = answer.watched.modes.iter().filter_map(|mode| {
        let found = mode.judged.judged.last()?;
        (found.survey == last).then_some(found)
    });
    let mut reason = Some(Cause::NotFound);
    for judged in of_last {
        match judged.score {
            Ok(_) => return None,
            Err(NotJudged::Training) => return None, // said of the whole history
            Err(NotJudged::NewLevel) => reason = Some(Cause::NewLevel),
            Err(NotJudged::NoTemperature) => reason = Some(Cause::NoTemperature),
            Err(NotJudged::Temperature) => {
                let temperature_c = answer.surveys[last].temperature_c.unwrap_or(f64::NAN);
                let unit = dolmen_words::Unit::si("°C");
                let temperature = Quantity::new(temperature_c, unit, dolmen_words::Digits::Trimmed(3));
                reason = Some(Cause::Temperature { temperature });
            }
        }
    }
    let reason: Sentence = reason?.into();
    let last = name(answer, last);
    Some(Finding::key(Tone::Unknown, Found::LastNotJudged { last, reason }))
}

fn changes(answer: &WatchAnswer) -> Vec<Finding> {
    let watched = &answer.watched;
    let listed: Vec<(&WatchedMode, &WatchedChange)> = watched
        .modes
        .iter()
        .flat_map(|mode| mode.changes.iter().map(move |change| (mode, change)))
        .collect();
    let (from, to) = (
        name(answer, 0),
        name(answer, answer.surveys.len().saturating_sub(1)),
    );
    let least = watched
        .modes
        .iter()
        .filter_map(|mode| Some((mode.seen_from_ratio?, mode.track.frequency_hz)))
        .max_by(|a, b| a.0.total_cmp(&b.0));
    let Some((least, of_hz)) = least else {
        let has_modes = !watched.modes.is_empty();
        let too_few = has_modes.then(|| Finding::key(Tone::Unknown, Found::TooFew { from, to }));
        return last_apart(answer).into_iter().chain(too_few).collect();
    };
    let off: Vec<Finding> = watched
        .modes
        .iter()
        .filter_map(|mode| Some(last_off(answer, mode, mode.last_off?)))
        .collect();
    let wandering = wandering(answer);
    if listed.is_empty() {
        let said = Found::Unchanged {
            modes: watched.modes.len(),
            from,
            to,
            least: percent(least, 2),
        };
        let unchanged = match off.is_empty() && wandering.is_empty() && !is_doubtful(answer) {
            true => Finding::key(Tone::Good, said),
            false => Finding::new(Tone::Plain, said),
        };
        // the weather of the last survey is not known, or of no other: how far it is off all others says something all the same
        let apart = match last_survey(answer).is_some() {
            true => last_apart(answer),
            false => Vec::new(),
        };
        return apart
            .into_iter()
            .chain(off)
            .chain(wandering)
            .chain([unchanged])
            .collect();
    }
    let mut strongest = listed.clone();
    strongest.sort_by(|a, b| (b.1.ratio / b.1.sd).abs().total_cmp(&(a.1.ratio / a.1.sd).abs()));
    let mut all = off;
    let first = strongest.iter().take(TOLD_MOST);
    all.extend(first.map(|(mode, change)| Finding::key(Tone::Warn, told(answer, mode, change))));
    if listed.len() > TOLD_MOST {
        let count = listed.len() - TOLD_MOST;
        all.push(Finding::key(Tone::Warn, Found::Further { count }));
    }
    all.push(Finding::new(
        Tone::Plain,
        Found::Missed {
            frequency: hertz(of_hz),
            least: percent(least, 2),
        },
    ));
    all
}

/// What the last one or two surveys alone show.
fn last_off(answer: &WatchAnswer, mode: &WatchedMode, off: LastOff) -> Finding {
    let said = Found::LastOff {
        frequency: hertz(mode.track.frequency_hz),
        by: bare_percent(off.ratio, 2),
        half: percent(HALF_95 * off.sd, 2),
        since: name(answer, off.from),
    };
    Finding::key(Tone::Warn, said)
}

fn told(answer: &WatchAnswer, mode: &WatchedMode, change: &WatchedChange) -> Found {
    let frequency = hertz(mode.track.frequency_hz);
    let (by, half) = (bare_percent(change.ratio, 2), percent(HALF_95 * change.sd, 2));
    match change.form {
        ChangeForm::Step => Found::Stepped {
            frequency,
            by,
            half,
            after: name(answer, change.after),
            before: name(answer, change.before),
            chance: chance(change.p_value),
            stiffness: percent(change.ratio * (2.0 + change.ratio), 1),
            cause: event(answer, change).into(),
        },
        ChangeForm::Slope => Found::Drifted {
            frequency,
            by,
            half,
            since: name(answer, change.from),
            yearly: percent(change.per_year.unwrap_or(f64::NAN), 2),
            chance: chance(change.p_value),
        },
    }
}

/// An event that the interval of the date holds.
fn event(answer: &WatchAnswer, change: &WatchedChange) -> Cause {
    let day = |survey: usize| answer.surveys.get(survey).map_or(f64::NAN, |survey| survey.day);
    let within = answer.works.iter().enumerate().find(|(_, (when, work))| {
        work.kind == WorkKind::Event && (day(change.after)..=day(change.before)).contains(when)
    });
    within.map_or(Cause::Nothing, |(i, (_, work))| Cause::Event {
        number: i + 1,
        what: work.what.clone().unwrap_or_else(|| work.date.clone()),
    })
}

fn weather(answer: &WatchAnswer) -> Vec<Finding> {
    let of_modes = || {
        let modes = answer.watched.modes.iter();
        modes.filter_map(|mode| Some((mode, mode.weather.as_ref()?)))
    };
    let mut all = Vec::new();
    let blind = |known| {
        matches!(
            known,
            WeatherKnown::Season | WeatherKnown::TwoSeasons(_) | WeatherKnown::Nothing
        )
    };
    if of_modes().any(|(_, weather)| blind(weather.known)) {
        all.push(Finding::key(Tone::Unknown, Found::NoTemperature));
    }
    let with_time = of_modes().find_map(|(mode, weather)| Some((mode, weather.with_time?)));
    if let Some((mode, correlation)) = with_time {
        let said = Found::WithTime {
            frequency: hertz(mode.track.frequency_hz),
            correlation: plain(correlation, 2),
        };
        all.push(Finding::key(Tone::Unknown, said));
    }
    all
}

fn works(answer: &WatchAnswer) -> Vec<Finding> {
    let each = answer.watched.modes.iter().flat_map(|mode| {
        mode.works.iter().map(move |effect| {
            let date = answer
                .works
                .get(effect.work)
                .map_or_else(String::new, |(_, work)| work.date.clone());
            let said = Found::Worked {
                date,
                frequency: hertz(mode.track.frequency_hz),
                by: bare_percent(effect.ratio, 2),
                half: percent(HALF_95 * effect.sd, 2),
            };
            // a repair that loosens
            match loosens(effect) {
                true => Finding::key(Tone::Warn, said),
                false => Finding::new(Tone::Plain, said),
            }
        })
    });
    each.collect()
}

fn sensors(answer: &WatchAnswer) -> Vec<Finding> {
    let tracked = &answer.watched.tracked;
    let sensors = tracked.sensors.iter().map(|change| {
        let survey = name(answer, change.survey);
        let modes = answer.watched.modes.iter();
        let mut changes = modes.flat_map(|mode| &mode.changes);
        let said = match &change.channel {
            _ if changes.any(|of| (of.after..=of.before).contains(&change.survey)) => {
                Found::SensorOrStructure { survey }
            }
            Some(channel) => Found::Sensor {
                survey,
                channel: channel.clone(),
            },
            None => Found::Sensors { survey },
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
    // those that the last surveys miss come first
    let jumped = tracked.jumped.iter().filter(|jumped| !is_lost(jumped.from_hz));
    let jumped = jumped.map(|jumped| {
        let said = Found::Jumped {
            from: hertz(jumped.from_hz),
            to: hertz(jumped.to_hz),
            survey: name(answer, jumped.at),
            mac: plain(jumped.assurance, 2),
        };
        Finding::key(Tone::Warn, said)
    });
    sensors.chain(jumped).collect()
}
