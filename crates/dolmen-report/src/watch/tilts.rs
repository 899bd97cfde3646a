//! Findings on the tilts of a structure: beyond their limit, jumped, growing.

use super::chance::chance;
use super::dated_changes::changes_said;
use super::numbers::{HALF_95, YEAR_DAYS, name, plain, slope};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{ChangeForm, TiltSeries, TiltTrend};
use dolmen_project::WorkKind;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::watched::{LeanNow, WatchAnswer};

messages! {
    /// Tilts.
    pub(crate) enum Tilted in "watch.tilts" {
        TiltGrows { direction: String, yearly: Quantity, half: Quantity } => {
            en: "The tilt along {direction} grows by {yearly} ± {half} mm/m a year, beyond chance.",
            ko: "{direction} 방향 기울기가 해마다 {yearly} ± {half} mm/m씩 유의하게 변한다.",
        },
        TiltReaches { direction: String, yearly: Quantity, half: Quantity, limit: Quantity, years: Quantity, earliest: Quantity, latest: Quantity } => {
            en: "The tilt along {direction} changes by {yearly} ± {half} mm/m a year, beyond chance; at that rate it reaches its limit of {limit} mm/m in {years} years ({earliest} to {latest}).",
            ko: "{direction} 방향 기울기가 해마다 {yearly} ± {half} mm/m씩 유의하게 변한다. 이 속도로는 {years}년({earliest}~{latest}년) 뒤에 한계 {limit} mm/m에 이른다.",
        },
        TiltAlone { direction: String, date: String, read: Quantity, expected: Quantity } => {
            en: "The tilt along {direction} was read as {read} mm/m on {date}, where the readings around it give {expected} mm/m: it stands alone, and is left out of trend and steps. Check sign, decimal point and unit of what was written down; if it is right, the structure moved and came back.",
            ko: "{date}의 {direction} 방향 기울기 {read} mm/m는 앞뒤 측정값에 따른 {expected} mm/m에서 홀로 벗어나 경향과 급변 검토에서 제외하였다. 적은 값의 부호, 소수점, 단위를 확인한다. 값이 맞다면 구조물이 움직였다가 되돌아온 것이다.",
        },
        TiltLastOff { direction: String, date: String, read: Quantity, expected: Quantity, sd: Quantity, chance: Sentence } => {
            en: "The newest tilt along {direction}, {read} mm/m ({date}), lies far from the {expected} ± {sd} mm/m that the readings before it predict ({chance}); trend and year of the limit are without it. Check sign, decimal point and unit of what was written down; if it is right, the structure moved: look at it and at the marks.",
            ko: "가장 최근의 {direction} 방향 기울기 {read} mm/m({date})는 이전 측정값에 따른 {expected} ± {sd} mm/m에서 크게 벗어나며({chance}), 경향과 한계에 이르는 시기는 이 값을 빼고 구하였다. 적은 값의 부호, 소수점, 단위를 확인한다. 값이 맞다면 구조물이 움직인 것이므로 구조물과 측정 기준점을 점검한다.",
        },
        TiltBends { direction: String, about: String, after: String, before: String, earlier: Quantity, since: Quantity } => {
            en: "The slope of the tilt along {direction} changed in about {about} (between {after} and {before}): {earlier} mm/m a year before, {since} since.",
            ko: "{direction} 방향 기울기의 변화 속도가 {about}경({after}~{before})에 바뀌었다. 이전에는 해마다 {earlier} mm/m, 이후에는 {since} mm/m이다.",
        },
        TiltWorked { date: String, direction: String, by: Quantity, half: Quantity } => {
            en: "With the repair of {date} the tilt along {direction} changed by {by} ± {half} mm/m.",
            ko: "{date} 보수 전후로 {direction} 방향 기울기가 {by} ± {half} mm/m 변하였다.",
        },
        TiltSame { date: String, direction: String, by: Quantity, half: Quantity } => {
            en: "With the repair of {date} the tilt along {direction} did not change beyond chance ({by} ± {half} mm/m).",
            ko: "{date} 보수 전후로 {direction} 방향 기울기는 유의하게 변하지 않았다({by} ± {half} mm/m).",
        },
        TiltJumped { direction: String, by: Quantity, half: Quantity, after: String, before: String, cause: Sentence } => {
            en: "The tilt along {direction} jumped by {by} ± {half} mm/m between {after} and {before}{cause}: look at the structure and at the marks.",
            ko: "{direction} 방향 기울기가 {after}~{before} 사이에 {by} ± {half} mm/m 급변하였다{cause}. 구조물과 측정 기준점을 점검한다.",
        },
        TiltTurned { direction: String, by: Quantity, half: Quantity, after: String, before: String } => {
            en: "The tilt along {direction} changed its sign between {after} and {before}, by {by} ± {half} mm/m, and hardly its size: was the sign written the other way round? Correct the readings that have it wrong; if it is right, look at the structure.",
            ko: "{direction} 방향 기울기가 {after}~{before} 사이에 크기는 거의 그대로이면서 부호가 바뀌었다({by} ± {half} mm/m). 부호를 반대로 적은 것은 아닌가? 잘못 적은 값을 고치고, 값이 맞다면 구조물을 점검한다.",
        },
        TiltUnit { direction: String, by: Quantity, half: Quantity, ratio: Quantity, after: String, before: String } => {
            en: "PROBABLY A SLIP: the tilt along {direction} became {ratio} times what it was between {after} and {before} ({by} ± {half} mm/m), as if written in another unit (mm/m, %, degrees, 1/n). Correct the readings that have the wrong unit; if they are right, look at the structure.",
            ko: "입력 오류 의심: {direction} 방향 기울기가 {after}~{before} 사이에 이전의 {ratio}배가 되었다({by} ± {half} mm/m). 다른 단위(mm/m, %, 도, 1/n)로 적은 값으로 보인다. 단위가 틀린 값을 고치고, 값이 맞다면 구조물을 점검한다.",
        },
        TiltEitherSign { direction: String, yearly: Quantity, limit: Quantity, years: Quantity } => {
            en: "Along {direction} no year of the limit is given until that sign is settled. If the tilt grows in size by {yearly} mm/m a year, it reaches its limit of {limit} mm/m in {years} years.",
            ko: "부호가 확인될 때까지 {direction} 방향 기울기가 한계에 이르는 해를 정하지 않는다. 크기가 해마다 {yearly} mm/m씩 커진다면 {years}년 뒤에 한계 {limit} mm/m에 이른다.",
        },
        TiltCarried { direction: String, since: String, yearly: Quantity, half: Quantity, limit: Quantity, years: Quantity, earliest: Quantity, latest: Quantity } => {
            en: "The tilt along {direction} has another mark since {since}, which shows no slope of its own yet. If it goes on at the {yearly} ± {half} mm/m a year of the mark before, it reaches its limit of {limit} mm/m in {years} years ({earliest} to {latest}).",
            ko: "{direction} 방향 기울기는 {since}부터 다른 기준점을 쓰며 그 측정값만으로는 아직 변화 속도를 알 수 없다. 이전 기준점의 속도 해마다 {yearly} ± {half} mm/m가 이어지면 {years}년({earliest}~{latest}년) 뒤에 한계 {limit} mm/m에 이른다.",
        },
        MarkApart { direction: String, by: Quantity, half: Quantity, date: String, before: String } => {
            en: "The first reading of the tilt along {direction} ({date}) is {by} ± {half} mm/m off what the mark {before} predicts for that day: the new mark was set to zero on a structure that leans, or it moved. Read what the new mark shows of a plumb structure; until then its distance to the limit is not known.",
            ko: "{direction} 방향 기울기의 첫 측정값({date})이 기준점 {before}의 예측에서 {by} ± {half} mm/m 벗어난다. 기울어진 상태에서 새 기준점의 영점을 잡았거나 구조물이 움직인 것이다. 연직일 때의 새 기준점 값을 확인한다. 그때까지 한계까지의 여유는 알 수 없다.",
        },
        TiltBeyond { direction: String, now: Quantity, limit: Quantity } => {
            en: "The tilt along {direction} is {now} mm/m, beyond its limit of {limit} mm/m.",
            ko: "{direction} 방향 기울기가 {now} mm/m로 한계 {limit} mm/m를 넘었다.",
        },
        LeansBeyond { directions: Vec<String>, now: Quantity, limit: Quantity } => {
            en: "Along {directions} together it leans by {now} mm/m, beyond its limit of {limit} mm/m.",
            ko: "{directions} 방향을 합성한 기울기가 {now} mm/m로 한계 {limit} mm/m를 넘었다.",
        },
        LeansReach { directions: Vec<String>, now: Quantity, limit: Quantity, years: Quantity } => {
            en: "Along {directions} together it leans by {now} mm/m; at the slopes beyond chance it reaches its limit of {limit} mm/m in {years} years.",
            ko: "{directions} 방향을 합성한 기울기는 {now} mm/m이다. 유의한 변화 속도가 이어지면 {years}년 뒤에 한계 {limit} mm/m에 이른다.",
        },
        NoTilt { direction: String, least: Quantity } => {
            en: "Tilt along {direction}: no trend; {least} mm/m a year would have been seen.",
            ko: "{direction} 방향 기울기: 경향 없음. 해마다 {least} mm/m의 변화는 발견되었을 것이다.",
        },
    }
}

/// Leans beyond their limit, counted as in the exit status and in lists; and the date at which several directions together reach it.
pub(super) fn leans(answer: &WatchAnswer) -> Vec<Finding> {
    let each = answer.leans().into_iter().filter_map(|lean| {
        let (now, limit) = (slope(lean.size, 2), slope(lean.limit?.abs(), 2));
        let own: Vec<&TiltTrend> = trends(answer, &lean).collect();
        if lean.is_beyond() {
            let mut directions = lean.directions.clone();
            own.iter()
                .zip(&mut directions)
                .for_each(|(trend, to)| *to = direction_of(answer, trend));
            let said = match own.as_slice() {
                [alone] => {
                    let side = alone
                        .slope
                        .map(|slope| slope.now)
                        .or(alone.series.ratios.last().copied());
                    let signed = |size: f64| slope(size.copysign(side.unwrap_or(size)), 2);
                    Tilted::TiltBeyond {
                        direction: direction_of(answer, alone),
                        now: signed(lean.size),
                        limit: signed(lean.limit?.abs()),
                    }
                }
                // too few readings for a trend
                [] if directions.len() == 1 => Tilted::TiltBeyond {
                    direction: directions.join(", "),
                    now,
                    limit,
                },
                _ => Tilted::LeansBeyond {
                    directions,
                    now,
                    limit,
                },
            };
            return Some(Finding::key(Tone::Bad, said));
        }
        let is_replaced = own.iter().any(|trend| answer.is_replaced(&trend.series));
        let years = lean.years.filter(|_| lean.directions.len() > 1 && !is_replaced)?;
        let said = Tilted::LeansReach {
            directions: lean.directions,
            now,
            limit,
            years: plain(years, usize::from(years < 10.0)),
        };
        Some(Finding::key(Tone::Warn, said))
    });
    each.collect()
}

/// The trends of a lean, in its order.
fn trends<'a>(answer: &'a WatchAnswer, lean: &'a LeanNow) -> impl Iterator<Item = &'a TiltTrend> {
    lean.directions.iter().filter_map(|direction| {
        let mut all = answer.watched.tilts.iter();
        all.find(|trend| trend.series.datum == lean.datum && trend.series.direction == *direction)
    })
}

/// Whether the limit applies to this direction together with another one.
fn is_of_several(answer: &WatchAnswer, trend: &TiltTrend) -> bool {
    let own = &trend.series;
    answer.leans().iter().any(|lean| {
        lean.directions.len() > 1 && lean.datum == own.datum && lean.directions.contains(&own.direction)
    })
}

/// The direction of a tilt, with its datum if others of the direction have another.
fn direction_of(answer: &WatchAnswer, trend: &TiltTrend) -> String {
    let own = &trend.series;
    let others = answer.watched.tilts.iter().map(|other| &other.series);
    let is_other = |other: &TiltSeries| other.direction == own.direction && other.datum != own.datum;
    match &own.datum {
        Some(datum) if others.clone().any(is_other) => format!("{} ({datum})", own.direction),
        _ => own.direction.clone(),
    }
}

/// The survey of a reading.
fn survey(answer: &WatchAnswer, trend: &TiltTrend, reading: usize) -> String {
    let of = trend.series.surveys.get(reading).copied();
    of.map_or_else(String::new, |of| name(answer, of))
}

/// Isolated readings, and newest ones that are off.
pub(super) fn stands_alone(answer: &WatchAnswer, trend: &TiltTrend) -> Vec<Finding> {
    let each = trend.outliers.iter().map(|of| Tilted::TiltAlone {
        direction: direction_of(answer, trend),
        date: survey(answer, trend, of.at),
        read: slope(trend.series.ratios.get(of.at).copied().unwrap_or(f64::NAN), 2),
        expected: slope(of.expected, 2),
    });
    let last = trend.last_off.and_then(|of| {
        let at = trend.series.ratios.len().checked_sub(1)?;
        Some(Tilted::TiltLastOff {
            direction: direction_of(answer, trend),
            date: survey(answer, trend, at),
            read: slope(*trend.series.ratios.get(at)?, 2),
            expected: slope(of.expected, 2),
            sd: slope(of.half_95, 2),
            chance: chance(of.p_value),
        })
    });
    let all = each.chain(last);
    all.map(|said| Finding::key(Tone::Warn, said)).collect()
}

/// Steps and changes of slope of a tilt.
pub(super) fn changed(answer: &WatchAnswer, trend: &TiltTrend) -> Vec<Finding> {
    let direction = direction_of(answer, trend);
    let now = trend.slope.map_or(f64::NAN, |slope| slope.per_year);
    // the slope after a change is that of today minus later changes
    let since = |from: usize| {
        let later = trend.changes.iter().skip(from + 1);
        let bends = later.filter(|of| of.form == ChangeForm::Slope);
        now - bends.map(|of| of.size).sum::<f64>()
    };
    let named = |reading: usize| survey(answer, trend, reading);
    let mut all = changes_said(answer, trend, &named, |change| match change.of.form {
        ChangeForm::Step if trend.changes_unit(change.of).is_some() => Tilted::TiltUnit {
            direction: direction.clone(),
            ratio: unit_ratio(trend.changes_unit(change.of)),
            by: slope(change.of.size, 3),
            half: slope(HALF_95 * change.of.sd, 3),
            after: change.after,
            before: change.before,
        },
        ChangeForm::Step if trend.turns_sign(change.of) => Tilted::TiltTurned {
            direction: direction.clone(),
            by: slope(change.of.size, 3),
            half: slope(HALF_95 * change.of.sd, 3),
            after: change.after,
            before: change.before,
        },
        ChangeForm::Step => Tilted::TiltJumped {
            direction: direction.clone(),
            by: slope(change.of.size, 3),
            half: slope(HALF_95 * change.of.sd, 3),
            after: change.after,
            before: change.before,
            cause: change.cause.into(),
        },
        ChangeForm::Slope => Tilted::TiltBends {
            direction: direction.clone(),
            about: change.about,
            after: change.after,
            before: change.before,
            earlier: slope(since(change.at) - change.of.size, 3),
            since: slope(since(change.at), 3),
        },
    });
    let either = either_sign(trend, &direction);
    all.extend(either.map(|said| Finding::key(Tone::Warn, said)));
    all
}

fn unit_ratio(ratio: Option<f64>) -> Quantity {
    Quantity::new(ratio.unwrap_or(f64::NAN), Unit::ratio(), Digits::Trimmed(4))
}

/// When a tilt of uncertain sign reaches its limit, if it moves away from the vertical.
fn either_sign(trend: &TiltTrend, direction: &str) -> Option<Tilted> {
    let found = trend
        .slope
        .filter(|_| trend.is_sign_in_question() && trend.is_beyond_chance())?;
    let (limit, yearly) = (found.reach?.limit.abs(), found.per_year.abs());
    // the fit shifts the readings after the step along the slope before it
    let last = trend.series.ratios.last().map_or(0.0, |ratio| ratio.abs());
    let left = limit - found.now.abs().max(last);
    let years = left / yearly;
    (left > 0.0).then(|| Tilted::TiltEitherSign {
        direction: direction.to_owned(),
        yearly: slope(yearly, 3),
        limit: slope(limit, 2),
        years: plain(years, usize::from(years < 10.0)),
    })
}

/// When a tilt with a new mark reaches its limit, with the slope of the previous mark.
fn carried(answer: &WatchAnswer, trend: &TiltTrend) -> Option<Finding> {
    let found = trend.carried.filter(|_| !is_of_several(answer, trend))?;
    let reach = found.reach?;
    let (years, earliest) = (reach.years?, reach.years_earliest?);
    let decimals = usize::from(years < 10.0);
    let said = Tilted::TiltCarried {
        direction: direction_of(answer, trend),
        since: survey(answer, trend, 0),
        yearly: slope(found.per_year, 3),
        half: slope(HALF_95 * found.sd_per_year, 3),
        limit: slope(reach.limit, 2),
        years: plain(years, decimals),
        earliest: plain(earliest, decimals),
        latest: plain(reach.years_latest.unwrap_or(f64::INFINITY), decimals),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Deviations by which the first reading of a new mark differs from what the mark before predicts. Our choice.
const MARK_APART: f64 = 4.0;

/// Finding that a new mark begins elsewhere than the mark before it ends, without a repair between them.
pub(super) fn mark_apart(answer: &WatchAnswer, trend: &TiltTrend) -> Option<Finding> {
    let (own, first) = (&trend.series, *trend.series.ratios.first()?);
    let day = *own.days.first()?;
    let ended = |of: &&TiltTrend| of.series.days.last().copied().filter(|last| *last < day);
    let others = answer.watched.tilts.iter();
    let before = others
        .filter(|of| of.series.direction == own.direction && of.series.datum != own.datum)
        .filter(|of| ended(of).is_some())
        .max_by(|a, b| ended(a).unwrap_or(0.0).total_cmp(&ended(b).unwrap_or(0.0)))?;
    let (last, slope_before) = (ended(&before)?, before.slope?);
    let mut repairs = answer
        .works
        .iter()
        .filter(|(_, work)| work.kind == WorkKind::Repair);
    if repairs.any(|(on, _)| (last..=day).contains(on)) {
        return None;
    }
    let years = (day - last) / YEAR_DAYS;
    let by = first - (slope_before.now + slope_before.per_year * years);
    let sd = before
        .scatter
        .hypot(trend.scatter)
        .hypot(before.scatter)
        .hypot(slope_before.sd_per_year * years);
    let said = Tilted::MarkApart {
        direction: direction_of(answer, trend),
        by: slope(by, 2),
        half: slope(HALF_95 * sd, 2),
        date: survey(answer, trend, 0),
        before: before.series.datum.clone().unwrap_or_default(),
    };
    (by.abs() > MARK_APART * sd).then(|| Finding::key(Tone::Warn, said))
}

/// Effect of repairs on a tilt.
pub(super) fn worked(answer: &WatchAnswer, trend: &TiltTrend) -> Vec<Finding> {
    let each = trend.works.iter().filter_map(|of| {
        let (_, work) = answer.works.get(of.work)?;
        let (date, direction) = (work.date.clone(), direction_of(answer, trend));
        let (by, half) = (slope(of.size, 3), slope(HALF_95 * of.sd, 3));
        let said = match of.size.abs() > HALF_95 * of.sd {
            true => Tilted::TiltWorked {
                date,
                direction,
                by,
                half,
            },
            false => Tilted::TiltSame {
                date,
                direction,
                by,
                half,
            },
        };
        Some(Finding::new(Tone::Plain, said))
    });
    each.collect()
}

/// Whether a year of the limit follows from the slope of a tilt.
pub(super) fn reaches(answer: &WatchAnswer, trend: &TiltTrend) -> bool {
    let reach = trend.slope.as_ref().and_then(|slope| slope.reach);
    let is_ended = answer.is_replaced(&trend.series) || is_of_several(answer, trend);
    !is_ended && reach.is_some_and(|reach| reach.years.is_some() && reach.years_earliest.is_some())
}

/// Findings from the readings of a tilt over the years.
pub(super) fn tilt(answer: &WatchAnswer, trend: &TiltTrend) -> Option<Finding> {
    if let Some(said) = carried(answer, trend) {
        return Some(said);
    }
    let found = trend.slope.as_ref()?;
    let direction = direction_of(answer, trend);
    let is_ended = answer.is_replaced(&trend.series) || is_of_several(answer, trend);
    let (yearly, half) = (slope(found.per_year, 3), slope(HALF_95 * found.sd_per_year, 3));
    // if a newer datum exists, it determines the forecast; so do both directions together, if the limit applies to both
    if let Some(reach) = found.reach.filter(|_| !is_ended)
        && let (Some(years), Some(earliest)) = (reach.years, reach.years_earliest)
    {
        let decimals = usize::from(years < 10.0);
        let said = Tilted::TiltReaches {
            direction,
            yearly,
            half,
            limit: slope(reach.limit, 2),
            years: plain(years, decimals),
            earliest: plain(earliest, decimals),
            latest: plain(reach.years_latest.unwrap_or(f64::INFINITY), decimals),
        };
        return Some(Finding::key(Tone::Warn, said));
    }
    Some(match trend.is_beyond_chance() {
        true => Finding::key(
            Tone::Warn,
            Tilted::TiltGrows {
                direction,
                yearly,
                half,
            },
        ),
        false => {
            let least = slope(found.seen_from_per_year, 3);
            Finding::new(Tone::Plain, Tilted::NoTilt { direction, least })
        }
    })
}
