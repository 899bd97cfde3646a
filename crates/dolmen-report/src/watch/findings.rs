//! Findings of a history.

use super::cause::{Cause, cause};
use super::chance::chance;
use super::doubts::{are_there, doubts, undated};
use super::earthquakes::earthquakes;
use super::exchanged::exchanged;
use super::failing::failing;
use super::inspected::inspected;
use super::last::{far_off, last_off, last_survey};
use super::latest::{latest_tilts, tilts_were_beyond};
use super::logs::logs;
use super::lost::{last_apart, lost, unseen, wandering};
use super::none_judged::none_judged;
use super::numbers::{HALF_95, bare_percent, hertz, name, percent, plain};
use super::parts::{model_apart, parts};
use super::sensors_moved::sensors;
use super::tilts::{changed, leans, mark_apart, reaches, stands_alone, tilt, worked};
use super::unsearched::{is_far, unsearched};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{ChangeForm, StructureAlarm, WatchedChange, WatchedMode, WeatherKnown, WorkEffect};
use dolmen::numeric::quantile;
use dolmen_words::message::Both;
use dolmen_words::{Language, Quantity, Sentence, Values, messages};
use dolmen_work::watched::WatchAnswer;
use std::collections::BTreeSet;

/// Number of changes with their own finding; the others are counted.
const TOLD_MOST: usize = 4;

messages! {
    /// Findings on a history.
    pub(crate) enum Found in "watch.findings" {
        PlusMinus => {
            en: "± is half the width of an interval that holds 95 %.",
            ko: "±는 95 % 신뢰구간의 반폭이다.",
        },
        OpenAlarm { frequency: Values, since: String, confirmed: String } => {
            en: "ALARM: {frequency} left what earlier surveys predict, since {since}, confirmed on {confirmed}, and no repair or inspection followed. Look at the structure; then enter it into «works of [watch]|the list of works».",
            ko: "경보: {frequency} 모드가 {since}부터 이전 조사의 예측을 벗어났고 {confirmed}에 확정되었으나 이후 보수나 점검이 없다. 구조물을 점검하고 «[watch]의 works|조치 이력»에 기록한다.",
        },
        FurtherAlarms { count: usize, each: Vec<Sentence> } => {
            en: "Further alarms without an answer: {count} ({each}).",
            ko: "조치되지 않은 경보가 {count}건 더 있다({each}).",
        },
        ConfirmedOn { frequency: Values, confirmed: String } => {
            en: "{frequency}, confirmed on {confirmed}",
            ko: "{frequency} 모드 {confirmed} 확정",
        },
        AndMore { more: usize } => { en: "{more} more", ko: "그 밖 {more}건" },
        NoOpenAlarm { answered: usize, last: String } => {
            en: "No open alarm up to the survey of {last} (answered earlier: {answered}).",
            ko: "{last} 조사까지 조치되지 않은 경보가 없다(조치된 경보: {answered}건).",
        },
        AnsweredNotMended { answered: usize, last: String } => {
            en: "No alarm is unanswered up to the survey of {last}, but the works list inspections alone: none of the changes that raised an alarm ({answered}) was followed by a repair.",
            ko: "{last} 조사까지 점검하지 않은 경보는 없다. 그러나 경보 {answered}건은 점검으로만 확인되었으며, 그 이후 보수 기록이 없다.",
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
            ko: "{from}부터 {to}까지 추적한 모드 {modes}개에서 지속적인 변화가 확인되지 않았다. 중간 시점의 {least} 급변은 각 모드에서 80 %의 확률로 검출되었을 것이나 그보다 작은 변화는 놓쳤을 수 있다.",
        },
        TooFew { from: String, to: String } => {
            en: "Whether a frequency changed lastingly from {from} to {to} cannot be said: no mode was found in 8 surveys or more. Measure on, or compare two surveys« (`dolmen compare`)».",
            ko: "{from}부터 {to}까지 고유진동수가 지속적으로 변하였는지 판단할 수 없다. 8회 이상의 조사에서 확인된 모드가 없다. 계측을 계속하거나 두 조사를 비교한다«(`dolmen compare`)».",
        },
        Missed { frequency: Quantity, least: Quantity } => {
            en: "Beside that, a lasting step of {least} would have been seen with 80 % probability, in the mode that shows least ({frequency}).",
            ko: "이 밖에 {least} 이상의 계단형 변화가 있었다면 80 % 확률로 검출되었을 것이다(가장 불리한 모드 {frequency}).",
        },
        Worked { date: String, frequency: Quantity, sign: String, by: Quantity, half: Quantity } => {
            en: "With the repair of {date} {frequency} changed by {sign}{by} ± {half}.",
            ko: "{date} 보수 전후로 {frequency} 모드는 {sign}{by} ± {half} 변하였다.",
        },
        WithoutModes { survey: String, why: Both } => {
            en: "The records of survey {survey} give no modes, and are left out: {why}",
            ko: "{survey} 조사의 기록에서 모드를 찾지 못하여 제외하였다: {why}",
        },
        Alone { survey: String, frequency: Quantity, read: Quantity, by: Quantity } => {
            en: "The survey of {survey} alone has the mode of {frequency} at {read}, {by} off the surveys around it: left out of the search for changes. Look at its record and at what was written down.",
            ko: "{survey} 조사에서만 {frequency} 모드가 {read}(으)로, 앞뒤 조사보다 {by} 벗어나 변화 검토에서 제외하였다. 기록과 적은 값을 확인한다.",
        },
        FewTemperatures { known: usize, all: usize } => {
            en: "A temperature is known of {known} of {all} surveys: too few, or too much alike, to take the weather out by it (needed: four of five surveys, six or more, over 2 °C). They are not used, and only repeating seasons can tell a lasting change from the weather. Enter «temperature_c|the temperature» with each survey.",
            ko: "조사 {all}회 중 {known}회만 기온이 있어, 또는 기온이 서로 비슷하여 날씨의 영향을 기온으로 제거할 수 없다(조사의 5분의 4 이상, 6회 이상, 2 °C 이상의 범위가 필요하다). 적힌 기온은 쓰지 않았으며, 지속적인 변화와 날씨의 영향은 계절이 반복되는 만큼만 구별된다. 조사마다 «temperature_c를|기온을» 기록한다.",
        },
        NoTemperature => {
            en: "Temperatures are not known: only repeating seasons can tell a lasting change from the weather. Enter «temperature_c|the temperature» with each survey.",
            ko: "기온을 알 수 없어 지속적인 변화와 날씨의 영향은 계절이 반복되는 만큼만 구별된다. 조사마다 «temperature_c를|기온을» 기록한다.",
        },
        WithTime { frequency: Quantity, correlation: Quantity } => {
            en: "Temperature went with time ({frequency}: correlation {correlation}): ageing and weather can hardly be separated, and less is seen.",
            ko: "기온이 시간과 함께 변하여({frequency}: 상관계수 {correlation}) 노후와 날씨의 영향이 잘 구별되지 않으며 발견할 수 있는 변화가 줄어든다.",
        },
        FarAhead { date: String, last: String } => {
            en: "The work of {date} in «[watch]|the list of works» is dated more than a year after the last survey, {last}: no survey shows what it did, and alarms before it stay open until one does. Is the year right?",
            ko: "«[watch]|조치 이력»의 {date} 작업은 마지막 조사 {last}보다 1년 넘게 뒤여서 그 효과를 보여 주는 조사가 없다. 다음 조사까지 이전 경보는 그대로 둔다. 연도가 맞는가?",
        },
        Rate { share: Quantity } => {
            en: "An alarm can be confirmed though nothing changed (a false alarm); over these years at least one is confirmed with {share} probability.",
            ko: "구조물에 변화가 없어도 경보가 확정될 수 있다(오경보). 이 기간에 오경보가 한 번 이상 확정될 확률은 {share}이다.",
        },
    }
}

/// The findings: alarms, changes, changes that could have been missed, tilts, doubts.
pub(crate) fn findings(answer: &WatchAnswer) -> Vec<Finding> {
    // no alarm is not good news if there was a change without a response
    let mut all = earthquakes(answer);
    all.extend(lost(answer));
    all.extend(unseen(answer));
    all.extend(undated(answer));
    all.extend(doubts(answer));
    all.extend(model_apart(answer));
    all.extend(far_off(answer));
    let alarms = alarms(answer);
    let is_news = alarms.iter().any(|of| of.tone == Tone::Bad) || !answer.has_unanswered_change();
    let (before, after) = match is_news {
        true => (alarms, Vec::new()),
        false => (Vec::new(), alarms),
    };
    all.extend(before);
    all.extend(latest_tilts(answer));
    all.extend(tilts_were_beyond(answer));
    all.extend(
        answer
            .watched
            .tilts
            .iter()
            .filter_map(|of| mark_apart(answer, of)),
    );
    // the date at which a limit is reached matters more than past changes
    let tilts = &answer.watched.tilts;
    let tilted = tilts
        .iter()
        .filter_map(|trend| Some((reaches(answer, trend), tilt(answer, trend)?)));
    let (reaching, tilted): (Vec<_>, Vec<_>) = tilted.partition(|(reaches, _)| *reaches);
    all.extend(reaching.into_iter().map(|(_, found)| found));
    all.extend(far_ahead(answer));
    all.extend(last_survey(answer));
    all.extend(exchanged(answer));
    all.extend(changes(answer));
    all.extend(parts(answer));
    all.extend(after);
    all.extend(unsearched(answer));
    all.extend(weather(answer));
    all.extend(leans(answer));
    all.extend(tilts.iter().flat_map(|trend| stands_alone(answer, trend)));
    all.extend(tilts.iter().flat_map(|trend| changed(answer, trend)));
    all.extend(tilted.into_iter().map(|(_, found)| found));
    all.extend(logs(answer));
    all.extend(alone(answer));
    all.extend(works(answer));
    all.extend(
        answer
            .watched
            .tilts
            .iter()
            .flat_map(|trend| worked(answer, trend)),
    );
    all.extend(failing(answer));
    all.extend(sensors(answer));
    all.extend(inspected(answer));
    let without = answer
        .without_modes
        .iter()
        .map(|(survey, why)| Found::WithoutModes {
            survey: survey.clone(),
            why: why.clone(),
        });
    all.extend(without.map(|said| Finding::key(Tone::Warn, said)));
    // findings that require action come first
    all.sort_by_key(|of| of.tone != Tone::Bad);
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

/// Whether the last surveys have too few data on the modes, or a repair loosened something, so that "no alarm" is not good news.
fn is_doubtful(answer: &WatchAnswer) -> bool {
    let mut effects = answer.watched.modes.iter().flat_map(|mode| &mode.works);
    let watched = &answer.watched;
    !watched.lost.is_empty()
        || !watched.unseen.is_empty()
        || last_survey(answer).is_some()
        || effects.any(loosens)
        || are_there(answer)
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
                let tone = match answer.has_unanswered_change() || is_doubtful(answer) {
                    true => Tone::Plain,
                    false => Tone::Good,
                };
                let finding = match answer.is_mended() {
                    true => Finding::key(tone, Found::NoOpenAlarm { answered, last }),
                    false => Finding::key(Tone::Warn, Found::AnsweredNotMended { answered, last }),
                };
                vec![finding]
            }
            false if answer.watched.modes.is_empty() => Vec::new(),
            false => vec![none_judged(answer)],
        };
    };
    let of_day = |day: usize| {
        let own = open.iter().filter(move |alarm| alarm.alarm.survey == day);
        Values(own.map(|alarm| mode_hz(answer, alarm.mode)).collect())
    };
    let mut all = vec![Finding::key(
        Tone::Bad,
        Found::OpenAlarm {
            frequency: of_day(first.alarm.survey),
            since: name(answer, first.alarm.since),
            confirmed: name(answer, first.alarm.survey),
        },
    )];
    // changes of one day are one
    let days: BTreeSet<usize> = open.iter().map(|alarm| alarm.alarm.survey).collect();
    if days.len() > 1 {
        let count = days.len() - 1;
        let further = days.iter().filter(|day| **day != first.alarm.survey);
        let named = further.take(TOLD_MOST).map(|day| Found::ConfirmedOn {
            frequency: of_day(*day),
            confirmed: name(answer, *day),
        });
        let mut each: Vec<Sentence> = named.map(Sentence::from).collect();
        let more = count - each.len();
        each.extend((more > 0).then(|| Found::AndMore { more }.into()));
        all.push(Finding::key(Tone::Bad, Found::FurtherAlarms { count, each }));
    }
    all
}

/// Works dated long after the last survey.
fn far_ahead(answer: &WatchAnswer) -> Vec<Finding> {
    let last = name(answer, answer.surveys.len().saturating_sub(1));
    let far = answer.works.iter().filter(|(day, _)| answer.is_far_ahead(*day));
    let said = far.map(|(_, work)| Found::FarAhead {
        date: work.date.clone(),
        last: last.clone(),
    });
    said.map(|said| Finding::key(Tone::Warn, said)).collect()
}

/// A fall of a frequency at a repair by at least this many standard deviations comes first. Our choice.
const FALLS_FROM: f64 = 3.0;

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
    // modes that were not seen to the end have their own finding
    let unseen = |mode: &usize| watched.unseen.iter().any(|of| of.mode == *mode);
    let to_the_end = || {
        let modes = watched.modes.iter().enumerate();
        modes.filter(|(i, _)| !unseen(i)).map(|(_, mode)| mode)
    };
    let least = to_the_end()
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
        .filter_map(|mode| last_off(answer, mode))
        .collect();
    let wandering = wandering(answer);
    if listed.is_empty() {
        let said = Found::Unchanged {
            modes: to_the_end().count(),
            from,
            to,
            least: percent(least, 2),
        };
        let unchanged = match off.is_empty()
            && wandering.is_empty()
            && !is_doubtful(answer)
            && !is_far(answer)
            && !answer.has_unanswered_change()
        {
            true => Finding::key(Tone::Good, said),
            false => Finding::new(Tone::Plain, said),
        };
        // the weather of the last survey is unknown or unique, but its difference from the others is still informative
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
    all.extend(first.map(|(mode, change)| Finding::key(Tone::Warn, finding_of_change(answer, mode, change))));
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

fn finding_of_change(answer: &WatchAnswer, mode: &WatchedMode, change: &WatchedChange) -> Found {
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

/// An event, or work on the sensors, within the interval of the date.
fn event(answer: &WatchAnswer, change: &WatchedChange) -> Cause {
    let day = |survey: usize| answer.surveys.get(survey).map_or(f64::NAN, |survey| survey.day);
    cause(answer, [day(change.after), day(change.before)])
}

/// Isolated surveys of a mode.
fn alone(answer: &WatchAnswer) -> Vec<Finding> {
    let each = answer.watched.modes.iter().flat_map(|mode| {
        let read = |survey: usize| {
            let at = (*mode.track.modes.get(survey)?)?;
            answer.surveys.get(survey)?.frequencies_hz.get(at).copied()
        };
        mode.outliers.iter().filter_map(move |survey| {
            let before = (0..*survey).rev().filter_map(read).take(2);
            let behind = (survey + 1..answer.surveys.len()).filter_map(read).take(2);
            let around: Vec<f64> = before.chain(behind).collect();
            let (own, usual) = (read(*survey)?, quantile(&around, 0.5).ok()?);
            let said = Found::Alone {
                survey: name(answer, *survey),
                frequency: hertz(mode.track.frequency_hz),
                read: hertz(own),
                by: percent(own / usual - 1.0, 1),
            };
            Some(Finding::key(Tone::Warn, said))
        })
    });
    each.collect()
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
        let with_modes = || answer.surveys.iter().filter(|of| !of.frequencies_hz.is_empty());
        let known = with_modes().filter(|of| of.temperature_c.is_some()).count();
        let said = match known {
            0 => Found::NoTemperature,
            known => Found::FewTemperatures {
                known,
                all: with_modes().count(),
            },
        };
        all.push(Finding::key(Tone::Unknown, said));
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
                sign: if effect.ratio > 0.0 { "+" } else { "" }.to_owned(),
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
