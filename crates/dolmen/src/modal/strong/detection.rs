//! Detects earthquakes in a record, with their times, and distinguishes them from other strong motion.

use super::features::{Features, features};
use super::levels::Levels;
use super::part::part_of;
use super::shaking::{Shaking, ShakingKind};
use crate::modal::decay::decays_in;
use crate::numeric::inner;
use crate::signal::{Record, leave_out};

/// Least value of the largest score. Among 200 simulated records with lorries, gusts and footsteps the highest score is 11.5, and 9.8 for those with
/// an equally sudden onset. Among 100 simulated earthquakes of at least 20 times the noise the lowest is 12.7. Our choice.
const SCORE_LEAST: f64 = 11.0;
/// Least growth of the score within two seconds before its peak: an earthquake begins suddenly, a lorry or a gust gradually. Our choice.
const GROWTH_LEAST: f64 = 3.5;
/// Score that needs no sudden onset, as for a distant earthquake: no traffic is so strong. Our choice.
const SCORE_SURE: f64 = 100.0;
/// Conditions for a gradual onset at a lower score: least peak, m/s² and m/s (1 % of g, which traffic hardly causes in a monument); longest strong
/// phase, s, because a storm lasts longer; and power in more than a few lines, because a gust shakes a structure only in its lowest modes. Among 200
/// simulated earthquakes with a gradual onset 131 have the score; 114 of them grow suddenly enough, and 127 are accepted with these conditions. Our
/// choice.
const SWELLS_LEAST_M_S2: f64 = 0.1;
const SWELLS_LEAST_M_S: f64 = 0.005;
const SWELLS_MOST_S: f64 = 120.0;
/// In a free decay every channel has its peak at the beginning, and grows again only if close modes beat. So an earthquake must either have its
/// latest channel peak at least this long after the first sample above the noise, or grow again by this ratio. Our choice.
const LATEST_PEAK_S: f64 = 2.0;
const REGROWTH_LEAST: f64 = 3.0;
/// Time within which every channel reaches its peak after a blow or a release, with all power in a few lines. The smallest value of 331 simulated
/// earthquakes is 0.94 s; five of nine simulated decays with beating close modes have at most 0.11 s. Our choice.
const AT_ONCE_S: f64 = 0.3;
/// Fraction of the power in the four highest lines of the spectrum, each with two on either side, for the channel with the smallest fraction. A decay
/// has all its power there, but an earthquake does not. The lowest of 33 simulated decays has 0.65; the highest of the simulated earthquakes with an
/// early peak has 0.55. Our choice.
const IN_LINES_MOST: f64 = 0.6;
/// Least and largest duration of the strong phase, s: a machine that is switched on runs longer.
const STRONG_LEAST_S: f64 = 1.5;
const STRONG_MOST_S: f64 = 300.0;
/// Weakest peak of an earthquake, m/s² and m/s: 0.2 % of g, hardly felt indoors; traffic near a monument stays below. Our choice.
const ACCELERATION_LEAST_M_S2: f64 = 0.02;
const VELOCITY_LEAST_M_S: f64 = 0.001;
/// Ratio of the motion from 0.5 to 2 Hz to that of the quiet part, above which a motion is certainly an earthquake: nearby traffic excites the ground
/// above 5 Hz. Our choice, from simulated records: the lowest of 62 earthquakes has 9, the highest of 28 trains and lorries 2.3.
const LOW_GROWTH_LEAST: f64 = 4.0;
/// Peak above which this ratio is not required, m/s²: 5 % of g, which neither traffic nor wind causes in a monument.
pub(super) const SURE_M_S2: f64 = 0.5;
/// Largest number of motions that are examined. A record of a swarm may have as many; it is not ambient vibration in any case.
const MOTIONS_MOST: usize = 30;
/// Least cosine between two sensors along one axis, and fewest sensors along it that can show an earthquake by themselves. Our choice.
const ALONG: f64 = 0.99;
const ALONG_LEAST: usize = 2;

/// The earthquake in a record; the strongest relative to the noise if there are several. `None` for ambient vibration.
///
/// # Limits
/// As [`earthquakes_in`].
pub fn earthquake_in(record: &Record, inputs: &[usize]) -> Option<Shaking> {
    let all = earthquakes_in(record, inputs, &[]).into_iter();
    let all = all.filter(|of| of.kind == ShakingKind::Earthquake);
    all.max_by(|a, b| a.over_noise.total_cmp(&b.over_noise))
}

/// The earthquakes in a record, by time; none in ambient vibration. Lost parts, `lost_s`, s, are not examined.
///
/// ```text
/// s_k ≥ 11 in the peak                on all channels (of four or more, a quarter may miss it), or on those along one axis, if there are two of
///                                     them: no spike, no blow beside one sensor
/// s_k of medians, not of squares      footfalls and spikes fill too little of a second
/// s_(k+4) / s_k ≥ 3.5                 within two seconds; not required for s_k ≥ 100, or for 0.1 m/s² or 5 mm/s in more than a few lines
/// not: all channels have their peak within 2 s, none grows again by 3, all power in a few lines     a released rope, a hammer
/// not: all channels have their peak within 0.3 s                                                     the same with beating close modes
/// not: modes that decay from the beginning of each blow explain 90 % of its motion                    one hammer blow, or several
/// 1.5 to 300 s between 5 % and 95 % of the energy; 0.02 m/s² or 1 mm/s at least
/// ```
/// If one such motion is found, all other motions with s_k ≥ 11 that are long enough are returned too, even with a gradual onset, because a record of
/// a main shock and its aftershocks is not ambient vibration. A motion may be an earthquake or nearby traffic if its amplitude from 0.5 to 2 Hz is
/// below 4 times that of the quiet part and its peak is below 0.5 m/s², or if its onset is gradual.
///
/// # Limits
/// A median over one second fluctuates if the lowest mode of the structure is below 0.5 Hz. A blast, a collapse, a jumping crowd, several hammer
/// blows in a row, a machine that runs for minutes, or a gust of more than ten times the previous wind may be classified as an earthquake. This
/// happens for 97 of 200 simulated gusts of 3 to 30 times the wind, before the modes at rest identify 67 of them. A motion below 11 times the noise,
/// or in a record without several quiet seconds, is not found. An aftershock belongs to the previous motion until the level stays below twice the
/// noise for five seconds. Records of unknown unit are classified by their form alone.
///
/// # Source
/// Ratio of a short to a long average: Allen (1978) Bull. Seism. Soc. Am. 68(5):1521-1532. Differs from the source: medians over all channels, and
/// the tests of growth and decay.
pub fn earthquakes_in(record: &Record, inputs: &[usize], lost_s: &[[f64; 2]]) -> Vec<Shaking> {
    let mut found = motions_in(record, inputs, lost_s);
    for along in axes(record) {
        let is_other = |c: &usize| !along.contains(c);
        let others = (0..record.channels().len()).filter(is_other);
        let others: Vec<&str> = others.map(|c| record.channels()[c].name.as_str()).collect();
        let Ok(alone) = leave_out(record.clone(), &others) else {
            continue;
        };
        let place = |c: &usize| along.iter().position(|own| own == c);
        let inputs: Vec<usize> = inputs.iter().filter_map(place).collect();
        for motion in motions_in(&alone, &inputs, lost_s) {
            let meets = |of: &&mut Shaking| motion.arrival_s < of.end_s && of.arrival_s < motion.end_s;
            match found
                .iter_mut()
                .filter(meets)
                .max_by(|a, b| a.end_s.total_cmp(&b.end_s))
            {
                Some(same) if same.end_s < motion.end_s => {
                    (same.end_s, same.ends) = (motion.end_s, motion.ends);
                }
                Some(_) => {}
                None => found.push(motion),
            }
        }
    }
    found.sort_by(|a, b| a.arrival_s.total_cmp(&b.arrival_s));
    // what still moves along one axis ends where the next motion begins
    for at in 1..found.len() {
        let next_s = found[at].arrival_s;
        if found[at - 1].end_s > next_s {
            (found[at - 1].end_s, found[at - 1].ends) = (next_s, true);
        }
    }
    found
}

/// The channels along each axis, where there are several axes and several channels along one: a blow beside one sensor moves one channel of each
/// axis.
fn axes(record: &Record) -> Vec<Vec<usize>> {
    let mut all: Vec<Vec<usize>> = Vec::new();
    let channels = record.channels();
    for (c, channel) in channels.iter().enumerate() {
        let Some(own) = channel.direction else { continue };
        let is_along = |of: &Vec<usize>| {
            let other = channels[of[0]].direction.unwrap_or(own);
            inner(&own, &other).abs() >= ALONG * (inner(&own, &own) * inner(&other, &other)).sqrt()
        };
        match all.iter_mut().find(|of| is_along(of)) {
            Some(along) => along.push(c),
            None => all.push(vec![c]),
        }
    }
    all.retain(|along| along.len() >= ALONG_LEAST && along.len() < channels.len());
    all
}

/// The earthquakes that move all channels of a record, in any order.
fn motions_in(record: &Record, inputs: &[usize], lost_s: &[[f64; 2]]) -> Vec<Shaking> {
    let Some(mut levels) = Levels::of(record, lost_s) else {
        return Vec::new();
    };
    if levels.motion(&[], SCORE_LEAST).is_none() {
        return Vec::new();
    }
    levels.keep_steady(record, lost_s);
    let mut windows = Vec::new();
    let mut all: Vec<Features> = Vec::new();
    while windows.len() < MOTIONS_MOST
        && let Some(motion) = levels.motion(&windows, SCORE_LEAST)
    {
        let found = features(record, &levels, inputs, &motion).filter(lasts);
        all.extend(found.filter(|of| !is_free(record, &of.shaking)));
        windows.push(motion.windows);
    }
    if !all.iter().any(is_earthquake) {
        return Vec::new();
    }
    let kind = |of: &Features| match is_earthquake(of) && is_low(of) {
        true => ShakingKind::Earthquake,
        false => ShakingKind::EarthquakeOrTraffic,
    };
    let found = all.into_iter().map(|of| Shaking {
        kind: kind(&of),
        ..of.shaking
    });
    found.collect()
}

/// Whether the motion is strong and long enough, and not a free decay.
fn lasts(found: &Features) -> bool {
    let of = &found.shaking;
    let begins_at_once = found.latest_peak_s < AT_ONCE_S;
    let never_grows = found.latest_peak_s < LATEST_PEAK_S && found.regrowth < REGROWTH_LEAST;
    let decays = found.in_lines > IN_LINES_MOST && (begins_at_once || never_grows);
    let is_weak = match (found.peak_m_s2, found.peak_m_s) {
        (None, None) => false,
        (a, v) => {
            a.is_none_or(|peak| peak < ACCELERATION_LEAST_M_S2)
                && v.is_none_or(|peak| peak < VELOCITY_LEAST_M_S)
        }
    };
    (STRONG_LEAST_S..=STRONG_MOST_S).contains(&(of.strong_to_s - of.strong_from_s)) && !decays && !is_weak
}

/// Whether free decays make up the motion: a blow ends at once, and an earthquake goes on moving the structure.
fn is_free(record: &Record, of: &Shaking) -> bool {
    let part = part_of(record, [of.arrival_s, of.end_s]);
    part.is_some_and(|part| decays_in(&part).is_some())
}

/// Whether it has low frequencies that traffic does not excite, or is stronger than traffic.
fn is_low(found: &Features) -> bool {
    found.low_growth.is_none_or(|growth| growth >= LOW_GROWTH_LEAST)
        || found.peak_m_s2.is_some_and(|peak| peak >= SURE_M_S2)
}

/// Whether its onset is as sudden as that of an earthquake: wind grows over seconds.
pub(super) fn is_sudden(of: &Shaking) -> bool {
    of.growth >= GROWTH_LEAST
}

/// Whether its onset is as sudden as that of an earthquake, or it is strong enough for a gradual onset.
fn is_earthquake(found: &Features) -> bool {
    let of = &found.shaking;
    let is_strong = found.peak_m_s2.is_some_and(|peak| peak >= SWELLS_LEAST_M_S2)
        || found.peak_m_s.is_some_and(|peak| peak >= SWELLS_LEAST_M_S);
    let is_short = of.strong_to_s - of.strong_from_s <= SWELLS_MOST_S;
    is_sudden(of) || of.over_noise >= SCORE_SURE || is_strong && is_short && found.in_lines <= IN_LINES_MOST
}
