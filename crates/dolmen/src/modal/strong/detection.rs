//! Earthquakes told from what else shakes a structure, with their times.

use super::features::{Features, features};
use super::levels::Levels;
use super::shaking::{Shaking, ShakingKind};
use crate::signal::Record;

/// Least of the largest score. Of 200 made records with lorries, gusts and footsteps the highest has 11.5 and one that swells as suddenly 9.8; of
/// 100 made earthquakes of 20 times the noise and more the least has 12.7. Chosen here.
const SCORE_LEAST: f64 = 11.0;
/// Least growth of the score within two seconds on the way to its peak: sudden, where a lorry or a gust swells. Chosen here.
const GROWTH_LEAST: f64 = 3.5;
/// Score from which it may swell, as a distant earthquake does: no traffic is so strong. Chosen here.
const SCORE_SURE: f64 = 100.0;
/// Weakest peak from which it may swell as well, m/s² and m/s: 1 % of g, what traffic hardly gives a monument; and longest strong phase, s, and not in few lines:
/// a gust shakes a structure at its lowest modes alone, and a storm lasts. Of 200 made swelling earthquakes 131 have the score; 114 of them grow as suddenly as
/// is asked, 127 count with this. Chosen here.
const SWELLS_LEAST_M_S2: f64 = 0.1;
const SWELLS_LEAST_M_S: f64 = 0.005;
const SWELLS_MOST_S: f64 = 120.0;
/// A free decay is at its largest on every channel when it begins, and close modes alone let it grow again: so long behind its first sample above
/// the noise the last channel has its peak at least, or so much it grows again. Chosen here.
const LATEST_PEAK_S: f64 = 2.0;
const REGROWTH_LEAST: f64 = 3.0;
/// So soon every channel has its peak where something is struck or let go, all power in a few lines: of 331 made earthquakes the least has 0.94 s, of nine made decays whose close modes beat
/// five of them have at most 0.11. Chosen here.
const AT_ONCE_S: f64 = 0.3;
/// Share of the power in the four highest lines of the spectrum, each with two on either side, of the channel that has least there: a decay has
/// it all, ground that shakes has not. Of 33 made decays the least has 0.65, of the made earthquakes that peak early the most 0.55. Chosen here.
const IN_LINES_MOST: f64 = 0.6;
/// How long it is strong at least and at most, s: a machine that was switched on goes on.
const STRONG_LEAST_S: f64 = 1.5;
const STRONG_MOST_S: f64 = 300.0;
/// Weakest peak that counts, m/s² and m/s: 0.2 % of g, hardly felt indoors; traffic beside a monument stays below. Chosen here.
const ACCELERATION_LEAST_M_S2: f64 = 0.02;
const VELOCITY_LEAST_M_S: f64 = 0.001;
/// How often the motion from 0.5 to 2 Hz must be that of the quiet where it is beyond doubt an earthquake: traffic close by drives the ground from 5 Hz on.
/// Chosen here, from made records: of 62 earthquakes the least has 9, of 28 trains and lorries the most 2.3.
const LOW_GROWTH_LEAST: f64 = 4.0;
/// Peak from which it needs not: 5 % of g, which neither traffic nor wind gives a monument, m/s².
pub(super) const SURE_M_S2: f64 = 0.5;
/// Motions that are looked at: a record of a swarm has so many, and is no ambient vibration anyway.
const MOTIONS_MOST: usize = 30;

/// The earthquake in a record, the strongest over its noise where there are several; `None` of ambient vibration.
///
/// # Limits
/// As [`earthquakes_in`].
pub fn earthquake_in(record: &Record, inputs: &[usize]) -> Option<Shaking> {
    let all = earthquakes_in(record, inputs, &[]).into_iter();
    let all = all.filter(|of| of.kind == ShakingKind::Earthquake);
    all.max_by(|a, b| a.over_noise.total_cmp(&b.over_noise))
}

/// The earthquakes in a record, by time; none of ambient vibration. What lies in `lost_s`, s, was lost and is not looked at.
///
/// ```text
/// s_k ≥ 11 in the peak                on all channels (of four or more, a quarter may miss it): no spike, no blow beside one sensor
/// s_k of medians, not of squares      footfalls and spikes fill too little of a second
/// s_(k+4) / s_k ≥ 3.5                 within two seconds; it may swell from s_k ≥ 100 on, and where it reaches 0.1 m/s² or 5 mm/s in more than a few lines
/// none of: all channels have their peak within 2 s, none grows again by 3, all power in a few lines     a released rope, a hammer
/// nor: all channels have their peak within 0.3 s                                                       the same where close modes beat
/// 1.5 to 300 s between 5 % and 95 % of the energy; 0.02 m/s² or 1 mm/s at least
/// ```
/// Where one such motion is found, every other one of s_k ≥ 11 that lasts is given as well, suddenly as it may not grow: what a main shock and its
/// aftershocks leave is no ambient vibration. One whose motion from 0.5 to 2 Hz is not 4 times that of the quiet, below 0.5 m/s², and one that does not
/// grow suddenly, is an earthquake or traffic close by.
///
/// # Limits
/// One second of median is long for a structure whose lowest mode is below 0.5 Hz: such levels waver. A blast, a collapse, a crowd that jumps,
/// several blows of a hammer in a row, a machine that runs for minutes or a gust that rises to more than ten times the wind
/// before may be taken for an earthquake: of 200 made gusts of 3 to 30 times 97 are, before the modes at rest tell 67 of them. One below 11 times the noise, or one
/// whose record has no seconds of quiet, is not found. An aftershock before the motion has sunk to twice the noise for five seconds is one with what came
/// before it. Records of unknown unit are judged by their form alone.
///
/// # Source
/// The ratio of a short to a long average: Allen (1978) Bull. Seism. Soc. Am. 68(5):1521-1532. Differs from the source: medians over all
/// channels, and the tests of growth and decay.
pub fn earthquakes_in(record: &Record, inputs: &[usize], lost_s: &[[f64; 2]]) -> Vec<Shaking> {
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
        all.extend(features(record, &levels, inputs, &motion).filter(lasts));
        windows.push(motion.windows);
    }
    if !all.iter().any(is_earthquake) {
        return Vec::new();
    }
    let kind = |of: &Features| match is_earthquake(of) && is_low(of) {
        true => ShakingKind::Earthquake,
        false => ShakingKind::EarthquakeOrTraffic,
    };
    let mut found: Vec<Shaking> = all
        .into_iter()
        .map(|of| Shaking {
            kind: kind(&of),
            ..of.shaking
        })
        .collect();
    found.sort_by(|a, b| a.arrival_s.total_cmp(&b.arrival_s));
    found
}

/// Whether it is strong and long enough, and no free decay.
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

/// Whether it shakes at frequencies that traffic does not, or more strongly.
fn is_low(found: &Features) -> bool {
    found.low_growth.is_none_or(|growth| growth >= LOW_GROWTH_LEAST)
        || found.peak_m_s2.is_some_and(|peak| peak >= SURE_M_S2)
}

/// Whether it comes as suddenly as an earthquake, or is strong enough to swell.
fn is_earthquake(found: &Features) -> bool {
    let of = &found.shaking;
    let is_strong = found.peak_m_s2.is_some_and(|peak| peak >= SWELLS_LEAST_M_S2)
        || found.peak_m_s.is_some_and(|peak| peak >= SWELLS_LEAST_M_S);
    let is_short = of.strong_to_s - of.strong_from_s <= SWELLS_MOST_S;
    of.growth >= GROWTH_LEAST
        || of.over_noise >= SCORE_SURE
        || is_strong && is_short && found.in_lines <= IN_LINES_MOST
}
