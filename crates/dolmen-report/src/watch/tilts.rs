//! What the tilts of a structure say: beyond their limit, jumped, growing.

use super::numbers::{HALF_95, name, plain, slope};
use crate::document::{Finding, Tone};
use dolmen::monitoring::{TiltSeries, TiltTrend};
use dolmen_words::{Quantity, messages};
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
        TiltJumped { direction: String, by: Quantity, half: Quantity, after: String, before: String } => {
            en: "The tilt along {direction} jumped by {by} ± {half} mm/m between {after} and {before}: look at the structure and at the marks.",
            ko: "{direction} 방향 기울기가 {after}~{before} 사이에 {by} ± {half} mm/m 급변하였다. 구조물과 측정 기준점을 점검한다.",
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

/// Leans beyond their limit, where no trend of one direction says so already.
pub(super) fn leans(answer: &WatchAnswer) -> Vec<Finding> {
    let told = |lean: &LeanNow| {
        let mut own = answer.watched.tilts.iter().filter(|trend| {
            trend.series.datum == lean.datum && lean.directions.contains(&trend.series.direction)
        });
        own.any(|trend| {
            trend
                .slope
                .and_then(|slope| slope.share_of_limit())
                .is_some_and(|share| share >= 1.0)
        })
    };
    let each = answer.leans().into_iter().filter_map(|lean| {
        let (now, limit) = (slope(lean.size, 2), slope(lean.limit?.abs(), 2));
        if lean.is_beyond() {
            let directions = lean.directions.clone();
            let said = Tilted::LeansBeyond {
                directions,
                now,
                limit,
            };
            return (!told(&lean)).then(|| Finding::key(Tone::Bad, said));
        }
        let years = lean.years.filter(|_| lean.directions.len() > 1)?;
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

/// Whether the limit holds for this direction together with another one.
fn is_of_several(answer: &WatchAnswer, trend: &TiltTrend) -> bool {
    let own = &trend.series;
    answer.leans().iter().any(|lean| {
        lean.directions.len() > 1 && lean.datum == own.datum && lean.directions.contains(&own.direction)
    })
}

/// The direction of a tilt, with its datum where others of the direction have another.
fn direction_of(answer: &WatchAnswer, trend: &TiltTrend) -> String {
    let own = &trend.series;
    let others = answer.watched.tilts.iter().map(|other| &other.series);
    let is_other = |other: &TiltSeries| other.direction == own.direction && other.datum != own.datum;
    match &own.datum {
        Some(datum) if others.clone().any(is_other) => format!("{} ({datum})", own.direction),
        _ => own.direction.clone(),
    }
}

/// Whether a later series of the direction, of another datum, took its place.
fn is_ended(answer: &WatchAnswer, trend: &TiltTrend) -> bool {
    let own = &trend.series;
    let others = answer.watched.tilts.iter().map(|other| &other.series);
    let last = |of: &TiltSeries| of.surveys.last().copied();
    others
        .filter(|other| other.direction == own.direction)
        .any(|other| last(other) > last(own))
}

/// A step of a tilt.
pub(super) fn jumped(answer: &WatchAnswer, trend: &TiltTrend) -> Option<Finding> {
    let jump = trend.jump?;
    let survey = |i: usize| {
        let of = trend.series.surveys.get(i).copied();
        of.map_or_else(String::new, |of| name(answer, of))
    };
    let said = Tilted::TiltJumped {
        direction: direction_of(answer, trend),
        by: slope(jump.size, 3),
        half: slope(HALF_95 * jump.sd, 3),
        after: survey(jump.from.saturating_sub(1)),
        before: survey(jump.from),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// What the readings of a tilt say of its years.
pub(super) fn tilt(answer: &WatchAnswer, trend: &TiltTrend) -> Option<Finding> {
    let found = trend.slope.as_ref()?;
    let direction = direction_of(answer, trend);
    let is_ended = is_ended(answer, trend) || is_of_several(answer, trend);
    let (yearly, half) = (slope(found.per_year, 3), slope(HALF_95 * found.sd_per_year, 3));
    // the datum that took its place says what will be; so do both directions together, where the limit holds for both
    if let Some(reach) = found.reach.filter(|_| !is_ended) {
        if found.share_of_limit().is_some_and(|share| share >= 1.0) {
            let (now, limit) = (
                slope(found.now, 2),
                slope(reach.limit.abs().copysign(found.now), 2),
            );
            return Some(Finding::key(
                Tone::Bad,
                Tilted::TiltBeyond {
                    direction,
                    now,
                    limit,
                },
            ));
        }
        if let (Some(years), Some(earliest)) = (reach.years, reach.years_earliest) {
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
