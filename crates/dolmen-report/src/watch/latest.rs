//! The newest tilt readings with their limit, and earlier ones beyond it.

use super::numbers::{name, percent, slope};
use crate::document::{Finding, Tone};
use dolmen_words::{Quantity, messages};
use dolmen_work::tilts_read::TiltRead;
use dolmen_work::watched::WatchAnswer;

/// Number of tilts below which each has a place in the first lines.
const KEY_MOST: usize = 4;

messages! {
    /// Newest and earlier readings.
    pub(crate) enum Latest in "watch.latest" {
        Newest { directions: Vec<String>, read: Quantity, date: String } => {
            en: "Tilt along {directions}: last read as {read} mm/m ({date}); no «tilt_limit is given in [watch]|tilt limit is given».",
            ko: "{directions} 방향 기울기: 마지막 측정값 {read} mm/m({date}). «[watch]에 tilt_limit이|기울기 한계가» 없다.",
        },
        OfLimit { directions: Vec<String>, read: Quantity, date: String, share: Quantity, limit: Quantity } => {
            en: "Tilt along {directions}: last read as {read} mm/m ({date}), {share} of its limit of {limit} mm/m.",
            ko: "{directions} 방향 기울기: 마지막 측정값 {read} mm/m({date}), 한계 {limit} mm/m의 {share}.",
        },
        NearLimit { directions: Vec<String>, read: Quantity, date: String, share: Quantity, limit: Quantity } => {
            en: "NEAR ITS LIMIT: the tilt along {directions} was last read as {read} mm/m ({date}), {share} of its limit of {limit} mm/m.",
            ko: "한계에 가까움: {directions} 방향 기울기의 마지막 측정값은 {read} mm/m({date})로 한계 {limit} mm/m의 {share}이다.",
        },
        WasBeyond { directions: Vec<String>, read: Quantity, date: String, count: usize, limit: Quantity } => {
            en: "The tilt along {directions} was beyond its limit of {limit} mm/m before: {read} mm/m on {date} (readings beyond it: {count}), and no repair is listed since. Check what was written down; if it is right, the structure moved and came back.",
            ko: "{directions} 방향 기울기가 이전에 한계 {limit} mm/m를 넘은 적이 있으나({date}에 {read} mm/m, 한계를 넘은 측정 {count}회) 이후 보수 기록이 없다. 적은 값을 확인하고, 값이 맞다면 구조물이 움직였다가 되돌아온 것이다.",
        },
    }
}

/// Directions, with their mark if there are several.
fn directions(answer: &WatchAnswer, read: &TiltRead) -> Vec<String> {
    let mut marks = answer.watched.tilts.iter().map(|trend| &trend.series.datum);
    let has_others = marks.any(|other| *other != read.datum);
    let named = |direction: &String| match read.datum.as_ref().filter(|_| has_others) {
        Some(datum) => format!("{direction} ({datum})"),
        None => direction.clone(),
    };
    read.directions.iter().map(named).collect()
}

/// The newest readings below their limit; those beyond it are findings of the lean.
pub(super) fn latest_tilts(answer: &WatchAnswer) -> Vec<Finding> {
    let latest = answer.latest_tilts();
    let is_few = latest.len() < KEY_MOST;
    let beyond = answer.leans();
    let is_beyond = |read: &TiltRead| {
        let mut beyond = beyond.iter().filter(|lean| lean.is_beyond());
        beyond.any(|lean| lean.datum == read.datum && lean.directions == read.directions)
    };
    let below = latest.iter().filter(|read| !is_beyond(read));
    let each = below.map(|read| {
        let directions = directions(answer, read);
        let date = name(answer, read.survey);
        let (share, size) = (read.share_of_limit(), slope(read.ratio, 2));
        let limit = slope(read.limit.map_or(f64::NAN, f64::abs), 2);
        match share {
            None if is_few => Finding::key(
                Tone::Plain,
                Latest::Newest {
                    directions,
                    read: size,
                    date,
                },
            ),
            None => Finding::new(
                Tone::Plain,
                Latest::Newest {
                    directions,
                    read: size,
                    date,
                },
            ),
            Some(share) => {
                let is_near = read.is_near();
                let share = percent(share, 0);
                let read = size;
                match is_near {
                    true => Finding::key(
                        Tone::Warn,
                        Latest::NearLimit {
                            directions,
                            read,
                            date,
                            share,
                            limit,
                        },
                    ),
                    false => {
                        let said = Latest::OfLimit {
                            directions,
                            read,
                            date,
                            share,
                            limit,
                        };
                        Finding {
                            is_key: is_few,
                            ..Finding::new(Tone::Plain, said)
                        }
                    }
                }
            }
        }
    });
    each.collect()
}

/// Earlier readings beyond the limit, where the newest is below it.
pub(super) fn tilts_were_beyond(answer: &WatchAnswer) -> Vec<Finding> {
    let each = answer.tilts_were_beyond().into_iter().map(|of| {
        let said = Latest::WasBeyond {
            directions: directions(answer, &of.largest),
            read: slope(of.largest.ratio, 2),
            date: name(answer, of.largest.survey),
            count: of.count,
            limit: slope(of.largest.limit.map_or(f64::NAN, f64::abs), 2),
        };
        Finding::key(Tone::Warn, said)
    });
    each.collect()
}
