//! Findings on logs of tilts and cracks.

use super::log_limits::{near, was_at_limit};
use super::numbers::{HALF_95, YEAR_DAYS, bare_logged, label, logged, month_of, plain, slope};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{ChangeForm, LoggedCurve, LoggedScale, NoSlope, ScaleMark, TiltReach, TiltSlope};
use dolmen_project::WorkKind;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Unit, messages};
use dolmen_work::date_text;
use dolmen_work::watched::WatchAnswer;
use dolmen_work::watched_log::WatchedLog;

/// Years beyond which the answer gives no date.
const DATED_YEARS: f64 = 300.0;
/// Probability by chance below which a shift at a work is reported. Our choice.
const SHIFT_BELOW: f64 = 0.01;

messages! {
    /// Findings on logs.
    pub(crate) enum Logged in "watch.logs" {
        Beyond { label: Both, now: Quantity, limit: Quantity } => {
            en: "{label}: {now}, beyond its limit of {limit}.",
            ko: "{label}: {now}(으)로 한계 {limit}을(를) 넘었다.",
        },
        LeansBeyond { now: Quantity, limit: Quantity } => {
            en: "The logs of x and y together: it leans by {now} mm/m, beyond its limit of {limit} mm/m.",
            ko: "x와 y 방향 기록을 합성한 기울기가 {now} mm/m로 한계 {limit} mm/m를 넘었다.",
        },
        Reaches { label: Both, yearly: Quantity, half: Quantity, limit: Quantity, when: Both, earliest: Both, latest: Both } => {
            en: "{label}: {yearly} ± {half} a year, beyond chance; at that rate it reaches its limit of {limit} in {when} ({earliest} to {latest}).",
            ko: "{label}: 해마다 {yearly} ± {half}씩 유의하게 변한다. 이 속도로는 {when}({earliest}~{latest})에 한계 {limit}에 이른다.",
        },
        LeansReach { now: Quantity, limit: Quantity, when: Both } => {
            en: "The logs of x and y together: it leans by {now} mm/m; at the slopes beyond chance it reaches its limit of {limit} mm/m in {when}.",
            ko: "x·y 기록을 합성한 기울기는 {now} mm/m이다. 유의한 변화 속도가 이어지면 {when}에 한계 {limit} mm/m에 이른다.",
        },
        Grows { label: Both, yearly: Quantity, half: Quantity, now: Quantity } => {
            en: "{label}: {yearly} ± {half} a year, beyond chance; now {now}.",
            ko: "{label}: 해마다 {yearly} ± {half}씩 유의하게 변한다. 현재 {now}이다.",
        },
        SpeedsUpTo { label: Both, yearly: Quantity, half: Quantity, more: Quantity, more_half: Quantity, limit: Quantity, when: Both, earliest: Both, latest: Both, at_rate: Both } => {
            en: "{label}: IT SPEEDS UP: {yearly} ± {half} a year now, and each year {more} ± {more_half} a year more. By this law it reaches its limit of {limit} in {when} ({earliest} to {latest}), at the present rate in {at_rate}.",
            ko: "{label}: 변화가 빨라지고 있다. 현재 해마다 {yearly} ± {half}씩 변하고, 이 속도는 해마다 {more} ± {more_half}씩 커진다. 이 추세가 이어지면 {when}({earliest}~{latest})에, 현재 속도로는 {at_rate}에 한계 {limit}에 이른다.",
        },
        SpeedsUp { label: Both, yearly: Quantity, half: Quantity, more: Quantity, more_half: Quantity, now: Quantity } => {
            en: "{label}: IT SPEEDS UP: {yearly} ± {half} a year now, and each year {more} ± {more_half} a year more; now {now}.",
            ko: "{label}: 변화가 빨라지고 있다. 현재 해마다 {yearly} ± {half}씩 변하고, 이 속도는 해마다 {more} ± {more_half}씩 커진다. 현재 {now}이다.",
        },
        RateChanges { label: Both, first: Quantity, yearly: Quantity, half: Quantity } => {
            en: "{label}: its rate changes steadily: {first} a year at the beginning of the log, {yearly} ± {half} a year now. A date of the limit follows from the present rate.",
            ko: "{label}: 변화 속도가 서서히 바뀌었다. 기록 초기에는 해마다 {first}, 현재는 해마다 {yearly} ± {half}이다. 한계에 이르는 시기는 현재 속도로 구한다.",
        },
        Steady { label: Both, least: Quantity, now: Quantity, date: String } => {
            en: "{label}: no trend; a slope of {least} a year would have been seen with 80 % probability. Last {now} ({date}).",
            ko: "{label}: 경향 없음. 해마다 {least}의 변화는 80 %의 확률로 검출되었을 것이다. 마지막 값 {now}({date})이다.",
        },
        TooShort { label: Both, years: Quantity, now: Quantity, date: String } => {
            en: "{label}: {years} years of readings do not tell a trend from the season; that needs two. Last {now} ({date}).",
            ko: "{label}: {years}년의 기록으로는 경향과 계절 변화를 구별할 수 없다. 2년 이상이 필요하다. 마지막 값 {now}({date})이다.",
        },
        TooFew { label: Both, days: usize, now: Quantity, date: String } => {
            en: "{label}: {days} days with readings are too few for a trend. Last {now} ({date}).",
            ko: "{label}: 기록된 날이 {days}일로 경향을 판단하기에 부족하다. 마지막 값 {now}({date})이다.",
        },
        Wanders { label: Both, now: Quantity, date: String } => {
            en: "{label}: its months wander so far that no trend can be told from chance; look at the figure, and for what a work or event explains. Last {now} ({date}).",
            ko: "{label}: 월별 값의 변동이 커서 경향을 우연과 구별할 수 없다. 그림을 보고 보수나 사건으로 설명되는지 살펴본다. 마지막 값 {now}({date})이다.",
        },
        ZeroLost { label: Both, date: String, by: Quantity } => {
            en: "{label}: with the sensors of {date} its readings shifted by {by}, and its zero is that of the sensor before. How near it is to its limit cannot be said: enter the zero of the new sensor as a log of its own.",
            ko: "{label}: {date} 센서 교체 때 측정값이 {by} 변하였으나 영점은 이전 센서의 것이다. 한계까지의 여유를 판단할 수 없으므로 새 센서의 영점을 별도 기록으로 입력한다.",
        },
        LeansWereAtLimit { limit: Quantity, days: usize, last: String } => {
            en: "The logs of x and y together were at their limit of {limit} mm/m or beyond; days: {days}, the last one {last}.",
            ko: "x와 y 방향 기록을 합성한 기울기가 한계 {limit} mm/m에 이른 날이 {days}일 있었다(마지막 {last}).",
        },
        Shifted { label: Both, number: usize, date: String, by: Quantity, half: Quantity } => {
            en: "{label}: with work {number} ({date}) it shifted by {by} ± {half}.",
            ko: "{label}: {number}번 보수·사건({date}) 때 {by} ± {half}만큼 바뀌었다.",
        },
        Jumped { label: Both, by: Quantity, after: String, before: String } => {
            en: "{label}: it jumped by {by} between {after} and {before}, and no work says why. A trend may be of its making: look what happened, and enter it into «works of [watch]|the list of works».",
            ko: "{label}: {after}와(과) {before} 사이에 {by}만큼 급변하였으나 해당하는 보수나 사건이 없다. 추세가 이 급변 때문일 수 있으므로 원인을 확인하여 «[watch]의 works|조치 이력»에 기록한다.",
        },
        JumpedBy { label: Both, by: Quantity, half: Quantity, after: String, before: String } => {
            en: "{label}: it jumped by {by} ± {half} between {after} and {before}, and no work says why. The trend is that beside this jump: look what happened, and enter it into «works of [watch]|the list of works».",
            ko: "{label}: {after}와(과) {before} 사이에 {by} ± {half}만큼 급변하였으나 해당하는 보수나 사건이 없다. 추세는 이 급변과 함께 추정하였다. 원인을 확인하여 «[watch]의 works|조치 이력»에 기록한다.",
        },
        OtherScatter { label: Both, column: String, from: String, factor: Quantity } => {
            en: "PROBABLY A SLIP: {label}, column {column}: from {from} on its days scatter {factor} times as much as before. Were unit, range or gain changed? No trend is given: correct the file, or make two logs of it.",
            ko: "입력 오류 의심: {label}, {column} 열: {from}부터 하루하루의 변동폭이 이전의 {factor}배이다. 단위, 측정 범위나 증폭이 바뀌었는지 확인한다. 추세는 구하지 않았으므로 파일을 고치거나 두 기록으로 나눈다.",
        },
        OtherScale { label: Both, column: String, from: String, factor: Quantity } => {
            en: "PROBABLY A SLIP: {label}, column {column}: from {from} on its readings are {factor} times those before. Were unit, range or gain changed? No trend is given: correct the file, or make two logs of it.",
            ko: "입력 오류 의심: {label}, {column} 열: {from}부터 측정값이 이전의 {factor}배이다. 단위, 측정 범위나 증폭이 바뀌었는지 확인한다. 추세는 구하지 않았으므로 파일을 고치거나 두 기록으로 나눈다.",
        },
        OtherSign { label: Both, column: String, from: String } => {
            en: "PROBABLY A SLIP: {label}, column {column}: from {from} on its readings have the other sign and the same size. Was the sensor mounted the other way round? No trend is given: correct the file, or make two logs of it.",
            ko: "입력 오류 의심: {label}, {column} 열: {from}부터 측정값의 크기는 같고 부호가 반대이다. 센서의 방향이 바뀌었는지 확인한다. 추세는 구하지 않았으므로 파일을 고치거나 두 기록으로 나눈다.",
        },
        Turned { label: Both, column: String, about: String } => {
            en: "PROBABLY A SLIP: {label}, column {column}: from about {about} on season and temperature act on it the other way round. Was the sensor mounted the other way round? No trend is given: correct the file, or make two logs of it.",
            ko: "입력 오류 의심: {label}, {column} 열: {about}경부터 계절과 온도의 영향이 반대 방향으로 나타난다. 센서의 방향이 바뀌었는지 확인한다. 추세는 구하지 않았으므로 파일을 고치거나 두 기록으로 나눈다.",
        },
        LastOff { label: Both, days: usize, from: String, by: Quantity, scatter: Quantity, newest: Quantity } => {
            en: "{label}: its newest readings (days: {days}, since {from}) stand {by} off what it did before, where such differences had a standard deviation of {scatter}; the last day reads {newest}. Whether it jumped or the sensor fell out is not known yet: look at the structure and the sensor.",
            ko: "{label}: {from} 이후의 값({days}일)이 이전 거동에서 {by}만큼 벗어났다. 이전의 같은 차이는 표준편차가 {scatter}이었다. 마지막 날의 값은 {newest}이다. 급변인지 센서 이상인지 아직 알 수 없으므로 구조물과 센서를 점검한다.",
        },
        Bends { label: Both, about: String, after: String, before: String, earlier: Quantity, since: Quantity } => {
            en: "{label}: its slope changed in about {about} ({after} to {before}): {earlier} a year before, {since} since.",
            ko: "{label}: 변화 속도가 {about}경({after}~{before})에 바뀌었다. 이전에는 해마다 {earlier}, 이후에는 {since}이다.",
        },
        ReachesLate { label: Both, yearly: Quantity, half: Quantity, limit: Quantity, years: usize } => {
            en: "{label}: {yearly} ± {half} a year, beyond chance; at that rate it does not reach its limit of {limit} within {years} years.",
            ko: "{label}: 해마다 {yearly} ± {half}씩 유의하게 변하나 이 속도로는 {years}년 안에 한계 {limit}에 이르지 않는다.",
        },
        Stuck { label: Both, since: String } => {
            en: "SENSOR: {label} reads one value since {since}: look at the sensor. What followed is left out.",
            ko: "센서: {label}이(가) {since}부터 같은 값만 기록한다. 센서를 점검한다. 이후의 값은 제외하였다.",
        },
        Silent { label: Both, since: String, days: usize, newest: String } => {
            en: "SENSOR: {label} has no reading after {since}, {days} days before the newest of this structure ({newest}): look at the sensor, its power and the logger. What the log says ends on that day.",
            ko: "센서: {label}은(는) {since} 이후 측정값이 없다. 이 구조물의 가장 최근 자료({newest})보다 {days}일 앞선다. 센서, 전원, 기록계를 점검한다. 판단은 그날까지의 기록에 따른 것이다.",
        },
        ClockLast { label: Both, count: usize, last: String } => {
            en: "SENSOR: {label}: the last rows of its file are dated before those above them, as by a wrong clock; rows left out: {count}. The answer ends on {last}. If their dates are right, put the rows of the file in order.",
            ko: "센서: {label}: 파일의 마지막 행들이 그 위의 행보다 앞선 날짜이다. 기록계의 시계가 틀린 것으로 보고 {count}행을 제외하였다. 판단은 {last}까지의 기록에 따른 것이다. 날짜가 맞다면 행을 시각 순으로 정렬한다.",
        },
        NoZero { label: Both } => {
            en: "{label}: held against no limit. What the structure has when the sensor reads 0 is not known: give zero in the log.",
            ko: "{label}: 한계와 비교하지 않았다. 센서가 0을 가리킬 때의 값을 알 수 없다. 기록에 zero를 입력한다.",
        },
        Temperatures { surveys: usize } => {
            en: "Surveys with the temperature of the log: {surveys}.",
            ko: "온도 기록에서 기온을 얻은 조사: {surveys}건.",
        },
        Later { years: usize } => { en: "more than {years} years", ko: "{years}년 이상 뒤" },
    }
}

/// The findings on each log.
pub(super) fn logs(answer: &WatchAnswer) -> Vec<Finding> {
    let mut all = Vec::new();
    let together = answer.logged_lean().filter(|lean| lean.is_beyond());
    let is_said = answer.logs.iter().any(|log| log.is_tilt() && log.is_beyond());
    if let Some(lean) = together.filter(|_| !is_said) {
        let said = Logged::LeansBeyond {
            now: slope(lean.size, 2),
            limit: slope(lean.limit.unwrap_or(f64::NAN), 2),
        };
        all.push(Finding::key(Tone::Bad, said));
    }
    let ahead = answer.logged_lean().filter(|lean| !lean.is_beyond());
    if let Some((lean, years)) = ahead.as_ref().and_then(|lean| Some((lean, lean.years?))) {
        let last = answer
            .logs
            .iter()
            .filter(|log| log.is_tilt())
            .filter_map(WatchedLog::span);
        let last = last.map(|[_, last]| last).fold(f64::NEG_INFINITY, f64::max);
        let said = Logged::LeansReach {
            now: slope(lean.size, 2),
            limit: slope(lean.limit.unwrap_or(f64::NAN), 2),
            when: month(last, years),
        };
        all.push(Finding::key(Tone::Warn, said));
    }
    let days = answer.logged_days_at_limit();
    if let (Some(lean), Some(last)) = (&ahead, days.last()) {
        let said = Logged::LeansWereAtLimit {
            limit: slope(lean.limit.unwrap_or(f64::NAN), 2),
            days: days.len(),
            last: date_text(*last),
        };
        all.push(Finding::key(Tone::Warn, said));
    }
    let are_together = answer.logged_lean().is_some_and(|lean| lean.limit.is_some());
    for log in &answer.logs {
        // the limit of the structure applies to both directions together
        let exchanged = exchanged(log, answer);
        let has_own_limit = !(are_together && log.is_tilt() && log.part.limit.is_none());
        let silent = log.silent_since(answer.newest_day());
        let found = trend(log, has_own_limit && exchanged.is_none());
        all.extend(near(log));
        // a log that ended has no information about today
        all.push(match silent {
            Some(_) if found.tone == Tone::Good => Finding {
                tone: Tone::Unknown,
                ..found
            },
            _ => found,
        });
        if let (Some(since), Some(newest)) = (silent, answer.newest_day()) {
            let said = Logged::Silent {
                label: label(log),
                since: date_text(since),
                days: (newest - since) as usize,
                newest: date_text(newest),
            };
            all.push(Finding::key(Tone::Warn, said));
        }
        all.extend(clock_last(log));
        all.extend(exchanged);
        all.extend(was_at_limit(log));
        all.extend(shifts(log, answer));
        if log.trend.scale.is_none() {
            all.extend(jumped(log));
            all.extend(last_off(log));
            all.extend(changed(log));
        }
        if let Some(since) = log.trend.stuck_since {
            let said = Logged::Stuck {
                label: label(log),
                since: date_text(since),
            };
            all.push(Finding::key(Tone::Warn, said));
        }
        let has_limit = answer.project.watch.tilt_limit.is_some() && log.is_tilt();
        if log.trend.limit.is_none() && has_limit {
            all.push(Finding::new(Tone::Unknown, Logged::NoZero { label: label(log) }));
        }
    }
    if answer.temperatures_of_log > 0 {
        let surveys = answer.temperatures_of_log;
        all.push(Finding::new(Tone::Plain, Logged::Temperatures { surveys }));
    }
    all
}

fn trend(log: &WatchedLog, has_own_limit: bool) -> Finding {
    let (is_tilt, label) = (log.is_tilt(), label(log));
    let now = logged(log.trend.now, is_tilt, 2);
    let date = log.span().map_or_else(String::new, |[_, last]| date_text(last));
    if let Some(limit) = log.trend.limit.filter(|_| log.is_beyond()) {
        let judged = log.trend.size_to_judge();
        let size = limit.size.copysign(judged);
        let now = logged(judged, is_tilt, 2);
        let limit = logged(size, is_tilt, 2);
        return Finding::key(Tone::Bad, Logged::Beyond { label, now, limit });
    }
    let slope = match log.trend.slope {
        Ok(slope) => slope,
        Err(NoSlope::TooShort { years }) => {
            let years = plain(years, 1);
            return Finding::key(
                Tone::Unknown,
                Logged::TooShort {
                    label,
                    years,
                    now,
                    date,
                },
            );
        }
        Err(NoSlope::TooFew { days }) => {
            return Finding::key(
                Tone::Unknown,
                Logged::TooFew {
                    label,
                    days,
                    now,
                    date,
                },
            );
        }
        Err(NoSlope::Wanders) => return Finding::key(Tone::Unknown, Logged::Wanders { label, now, date }),
        Err(NoSlope::OtherScale(scale)) => return other_scale(log, scale),
    };
    if !log.trend.is_beyond_chance() {
        let least = logged(slope.seen_from_per_year, is_tilt, 3);
        let said = Logged::Steady {
            label,
            least,
            now,
            date,
        };
        // without a slope there is no good news if there is a jump, or if the newest days differ
        let is_moved = log.trend.jump.is_some() || log.trend.last_off.is_some() || log.trend.curve.is_some();
        return match is_moved || !log.trend.at_limit.is_empty() {
            true => Finding::new(Tone::Plain, said),
            false => Finding::key(Tone::Good, said),
        };
    }
    let (yearly, half) = (
        bare_logged(slope.per_year, is_tilt, 3),
        logged(HALF_95 * slope.sd_per_year, is_tilt, 3),
    );
    if let Some(curve) = log.trend.curve.filter(|of| of.speeds_up(slope.per_year)) {
        return Finding::key(Tone::Warn, speeds_up(log, (&slope, &curve), has_own_limit));
    }
    let is_late = |reach: &TiltReach| reach.years_earliest.is_some_and(|years| years > DATED_YEARS);
    match reached(log, &slope).filter(|_| has_own_limit) {
        Some((reach, _)) if is_late(&reach) => {
            let said = Logged::ReachesLate {
                label,
                yearly,
                half,
                limit: logged(reach.limit, is_tilt, 2),
                years: DATED_YEARS as usize,
            };
            Finding::key(Tone::Warn, said)
        }
        Some((reach, [when, earliest, latest])) => {
            let said = Logged::Reaches {
                label,
                yearly,
                half,
                limit: logged(reach.limit, is_tilt, 2),
                when,
                earliest,
                latest,
            };
            Finding::key(Tone::Warn, said)
        }
        None => {
            let said = Logged::Grows {
                label,
                yearly,
                half,
                now,
            };
            Finding::key(Tone::Warn, said)
        }
    }
}

/// The sentence on a log that speeds up.
fn speeds_up(log: &WatchedLog, (slope, curve): (&TiltSlope, &LoggedCurve), has_own_limit: bool) -> Logged {
    let (is_tilt, label) = (log.is_tilt(), label(log));
    let yearly = bare_logged(slope.per_year, is_tilt, 3);
    let half = logged(HALF_95 * slope.sd_per_year, is_tilt, 3);
    let more = bare_logged(curve.per_year2, is_tilt, 3);
    let more_half = logged(HALF_95 * curve.sd_per_year2, is_tilt, 3);
    let at_rate = log.span().zip(curve.at_rate.and_then(|reach| reach.years));
    let found = reached(log, slope).zip(at_rate).filter(|_| has_own_limit);
    match found {
        Some(((reach, [when, earliest, latest]), ([_, last], years))) => Logged::SpeedsUpTo {
            label,
            yearly,
            half,
            more,
            more_half,
            limit: logged(reach.limit, is_tilt, 2),
            when,
            earliest,
            latest,
            at_rate: month(last, years),
        },
        None => Logged::SpeedsUp {
            label,
            yearly,
            half,
            more,
            more_half,
            now: logged(log.trend.now, is_tilt, 2),
        },
    }
}

/// The question on days on another scale.
fn other_scale(log: &WatchedLog, scale: LoggedScale) -> Finding {
    let label = label(log);
    let column = log.part.column.clone().unwrap_or_else(|| log.part.file.clone());
    let from = date_text(scale.from);
    let times = |factor| Quantity::new(factor, Unit::ratio(), Digits::Significant(2));
    let said = match scale.mark {
        ScaleMark::Scatter(factor) => Logged::OtherScatter {
            label,
            column,
            from,
            factor: times(factor),
        },
        ScaleMark::Readings(factor) => Logged::OtherScale {
            label,
            column,
            from,
            factor: times(factor),
        },
        ScaleMark::OtherSign => Logged::OtherSign { label, column, from },
        ScaleMark::Turned => Logged::Turned {
            label,
            column,
            about: month_of(scale.from),
        },
    };
    Finding::key(Tone::Warn, said)
}

/// The jump of a log without a slope. With a slope, it is one of its changes.
fn jumped(log: &WatchedLog) -> Option<Finding> {
    let jump = log.trend.jump.filter(|_| log.trend.slope.is_err())?;
    let said = Logged::Jumped {
        label: label(log),
        by: logged(jump.by, log.is_tilt(), 2),
        after: date_text(jump.after),
        before: date_text(jump.before),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Steps, changes of slope, and a rate that changes without growing.
fn changed(log: &WatchedLog) -> Vec<Finding> {
    let (is_tilt, changes) = (log.is_tilt(), &log.trend.changes);
    let Ok(slope) = log.trend.slope else {
        return Vec::new();
    };
    let last = log.span().map_or(f64::NAN, |[_, last]| last);
    // the rate on the day of a change of slope, after it
    let since = |from: usize| {
        let later = changes.iter().skip(from + 1);
        let bends = later.filter(|of| of.form == ChangeForm::Slope);
        let bent = log
            .trend
            .curve
            .map_or(0.0, |of| of.per_year2 * (changes[from].day - last) / YEAR_DAYS);
        slope.per_year + bent - bends.map(|of| of.size).sum::<f64>()
    };
    let each = changes.iter().enumerate().map(|(i, of)| match of.form {
        ChangeForm::Step => Logged::JumpedBy {
            label: label(log),
            by: bare_logged(of.size, is_tilt, 2),
            half: logged(HALF_95 * of.sd, is_tilt, 2),
            after: date_text(of.after),
            before: date_text(of.before),
        },
        ChangeForm::Slope => Logged::Bends {
            label: label(log),
            about: month_of(of.day),
            after: month_of(of.after),
            before: month_of(of.before),
            earlier: logged(since(i) - of.size, is_tilt, 3),
            since: logged(since(i), is_tilt, 3),
        },
    });
    let is_told = log.trend.is_beyond_chance() && !log.is_beyond();
    let curve = log
        .trend
        .curve
        .filter(|of| !(is_told && of.speeds_up(slope.per_year)));
    let steadily = curve.map(|of| Logged::RateChanges {
        label: label(log),
        first: logged(of.first_per_year, is_tilt, 3),
        yearly: bare_logged(slope.per_year, is_tilt, 3),
        half: logged(HALF_95 * slope.sd_per_year, is_tilt, 3),
    });
    let all = each.chain(steadily);
    all.map(|said| Finding::key(Tone::Warn, said)).collect()
}

/// Finding that the newest days differ from those before.
fn last_off(log: &WatchedLog) -> Option<Finding> {
    let (off, is_tilt) = (log.trend.last_off?, log.is_tilt());
    let said = Logged::LastOff {
        label: label(log),
        days: off.days,
        from: date_text(off.from),
        by: logged(off.off, is_tilt, 2),
        scatter: logged(off.scatter, is_tilt, 2),
        newest: logged(log.trend.newest, is_tilt, 2),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Finding that the last rows of the file were left out.
fn clock_last(log: &WatchedLog) -> Option<Finding> {
    let [_, last] = log.span().filter(|_| log.rows.ends_misdated)?;
    let said = Logged::ClockLast {
        label: label(log),
        count: log.rows.misdated,
        last: date_text(last),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Finding that the zero of the log belongs to an earlier sensor, so that its current reading is not
/// the total movement.
fn exchanged(log: &WatchedLog, answer: &WatchAnswer) -> Option<Finding> {
    let shifted = log
        .trend
        .levels
        .iter()
        .filter(|level| level.p_value < SHIFT_BELOW);
    let mut of_sensors = shifted.filter_map(|level| {
        let (_, work) = answer.works.get(level.work)?;
        (work.kind == WorkKind::Sensors).then_some((work, level))
    });
    let (work, level) = of_sensors.next_back()?;
    let said = Logged::ZeroLost {
        label: label(log),
        date: work.date.clone(),
        by: logged(level.shift, log.is_tilt(), 2),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// The month a number of years after a day.
pub(super) fn month(last: f64, years: f64) -> Both {
    match years <= DATED_YEARS {
        true => month_of(last + years * YEAR_DAYS).into(),
        false => Logged::Later {
            years: DATED_YEARS as usize,
        }
        .into(),
    }
}

/// The month in which a limit is reached, and the ends of its interval.
fn reached(log: &WatchedLog, slope: &TiltSlope) -> Option<(TiltReach, [Both; 3])> {
    let (reach, [_, last]) = (slope.reach?, log.span()?);
    let month = |years: f64| month(last, years);
    let each = [reach.years?, reach.years_earliest?, reach.years_latest?];
    Some((reach, each.map(month)))
}

fn shifts(log: &WatchedLog, answer: &WatchAnswer) -> Vec<Finding> {
    let told = log
        .trend
        .levels
        .iter()
        .filter(|level| level.p_value < SHIFT_BELOW);
    let each = told.filter_map(|level| {
        let (_, work) = answer.works.get(level.work)?;
        let is_tilt = log.is_tilt();
        let said = Logged::Shifted {
            label: label(log),
            number: level.work + 1,
            date: work.date.clone(),
            by: bare_logged(level.shift, is_tilt, 2),
            half: logged(HALF_95 * level.sd, is_tilt, 2),
        };
        Some(Finding::key(Tone::Warn, said))
    });
    each.collect()
}
