//! An earthquake told from what else shakes a structure, with its times.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | q_ck | `levels` | level of channel c in window k: median of abs(x) over one second, windows half overlapping |
//! | n_c | `noise` | level of the channel's noise: median of q_ck before the arrival, else their lowest tenth |
//! | s_k | `scores` | q_ck / n_c of the channel that moves least, a quarter of the channels passed over |

use crate::numeric::quantile;
use crate::signal::{Quantity, Record};
use realfft::RealFftPlanner;

/// Length of a window, s: longer than a footfall, shorter than the strong part of an earthquake. Chosen here.
const WINDOW_S: f64 = 1.0;
/// What is slower than this is drift of a sensor, s.
const SLOW_S: f64 = 4.0;
/// Share of the channels that may miss the earthquake: dead, loose, or off by themselves.
const MISSING: f64 = 0.25;
/// Least of the largest score. Of 200 made records with lorries, gusts and footsteps the highest has 11.5 and one that swells as suddenly 9.8; of
/// 100 made earthquakes of 20 times the noise and more the least has 12.7. Chosen here.
const SCORE_LEAST: f64 = 11.0;
/// Score at which the arrival is looked for, going back from the largest, and windows in a row that end the search.
const ARRIVED: f64 = 3.0;
const STILL_WINDOWS: usize = 4;
/// Score below which the motion has ended, and windows in a row for that.
const ENDED: f64 = 2.0;
const ENDED_WINDOWS: usize = 10;
/// Least growth of the score within two seconds on the way to its peak: sudden, where a lorry or a gust swells. Chosen here.
const GROWTH_LEAST: f64 = 3.5;
const GROWTH_WINDOWS: usize = 4;
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
const REGROWN_LEAST: f64 = 0.25;
/// Share of the power in the four highest lines of the spectrum, each with two on either side, of the channel that has least there: a decay has
/// it all, ground that shakes has not. Of 33 made decays the least has 0.65, of the made earthquakes that peak early the most 0.55. Chosen here.
const IN_LINES_MOST: f64 = 0.6;
const LINES: usize = 4;
const BESIDE: usize = 2;
/// Sample over the level of the noise with which it begins: a Gaussian noise has one in 10⁵ above 3 deviations.
const BEGINS: f64 = 6.5;
/// Shares of the energy between which the motion is strong (Husid; Trifunac and Brady 1975), and how long that lasts at least and at most, s: a machine that
/// was switched on goes on.
const STRONG: [f64; 2] = [0.05, 0.95];
const STRONG_LEAST_S: f64 = 1.5;
const STRONG_MOST_S: f64 = 300.0;
/// Weakest peak that counts, m/s² and m/s: 0.2 % of g, hardly felt indoors; traffic beside a monument stays below. Chosen here.
const ACCELERATION_LEAST_M_S2: f64 = 0.02;
const VELOCITY_LEAST_M_S: f64 = 0.001;
/// Root mean square of what a digitiser rounds over its step, 1/√12: a channel whose noise lies below is no stiller than that.
const OF_STEP: f64 = 0.289;
/// Windows that a record must have.
const WINDOWS_LEAST: usize = 20;
/// Windows before the arrival that give the noise.
const NOISE_WINDOWS_LEAST: usize = 6;

/// An earthquake in a record, s from its first sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaking {
    /// It rises out of the noise.
    pub arrival_s: f64,
    /// 5 % of its energy has come.
    pub strong_from_s: f64,
    /// 95 % of its energy has come.
    pub strong_to_s: f64,
    /// It has sunk into the noise again, or the record ends.
    pub end_s: f64,
    /// Whether the record goes on behind that.
    pub ends: bool,
    /// Its largest level over that of the noise, of the channel that moves least.
    pub over_noise: f64,
    /// Largest growth of that level within two seconds.
    pub growth: f64,
}

/// What tells an earthquake from other motion, before it is judged.
#[derive(Clone, Debug)]
struct Features {
    shaking: Shaking,
    latest_peak_s: f64,
    regrowth: f64,
    in_lines: f64,
    peak_m_s2: Option<f64>,
    peak_m_s: Option<f64>,
}

/// The earthquake in a record, the strongest where there are several; `None` of ambient vibration.
///
/// ```text
/// s_k ≥ 11 in the peak                on all channels (of four or more, a quarter may miss it): no spike, no blow beside one sensor
/// s_k of medians, not of squares      footfalls and spikes fill too little of a second
/// s_(k+4) / s_k ≥ 3.5                 within two seconds; it may swell from s_k ≥ 100 on, and where it reaches 0.1 m/s² or 5 mm/s in more than a few lines
/// none of: all channels have their peak within 2 s, none grows again by 3, all power in a few lines     a released rope, a hammer
/// nor: all channels have their peak within 0.3 s                                                       the same where close modes beat
/// 1.5 to 300 s between 5 % and 95 % of the energy; 0.02 m/s² or 1 mm/s at least
/// ```
///
/// # Limits
/// One second of median is long for a structure whose lowest mode is below 0.5 Hz: such levels waver. A blast, a collapse, a crowd that jumps,
/// several blows of a hammer in a row, a machine that runs for minutes, a train close by or a gust that rises to more than ten times the wind
/// before may be taken for an earthquake: of 200 made trains of 0.02 to 0.2 m/s² 57 are, of 200 made gusts of 3 to 30 times 108. One below 11 times the noise, or one
/// whose record has no seconds of quiet, is not found. Records of unknown unit are judged by their form alone.
///
/// # Source
/// The ratio of a short to a long average: Allen (1978) Bull. Seism. Soc. Am. 68(5):1521-1532. Differs from the source: medians over all
/// channels, and the tests of growth and decay.
pub fn earthquake_in(record: &Record, inputs: &[usize]) -> Option<Shaking> {
    let found = features(record, inputs)?;
    let of = &found.shaking;
    let lasts_s = of.strong_to_s - of.strong_from_s;
    let is_in_lines = found.in_lines > IN_LINES_MOST;
    let begins_at_once = found.latest_peak_s < AT_ONCE_S;
    let never_grows = found.latest_peak_s < LATEST_PEAK_S && found.regrowth < REGROWTH_LEAST;
    let decays = is_in_lines && (begins_at_once || never_grows);
    let is_strong = found.peak_m_s2.is_some_and(|peak| peak >= SWELLS_LEAST_M_S2)
        || found.peak_m_s.is_some_and(|peak| peak >= SWELLS_LEAST_M_S);
    let may_swell = of.over_noise >= SCORE_SURE || is_strong && !is_in_lines && lasts_s <= SWELLS_MOST_S;
    let is_weak = match (found.peak_m_s2, found.peak_m_s) {
        (None, None) => false,
        (a, v) => {
            a.is_none_or(|peak| peak < ACCELERATION_LEAST_M_S2)
                && v.is_none_or(|peak| peak < VELOCITY_LEAST_M_S)
        }
    };
    let is_one = of.over_noise >= SCORE_LEAST
        && (of.growth >= GROWTH_LEAST || may_swell)
        && (STRONG_LEAST_S..=STRONG_MOST_S).contains(&lasts_s)
        && !decays
        && !is_weak;
    is_one.then_some(found.shaking)
}

fn features(record: &Record, inputs: &[usize]) -> Option<Features> {
    let rate_hz = record.sampling_rate_hz();
    let hop = ((0.5 * WINDOW_S * rate_hz).round() as usize).max(2);
    let windows = (record.length() / hop).checked_sub(1)?;
    if windows < WINDOWS_LEAST {
        return None;
    }
    let channels = record.channels().len();
    let steady = |c: usize| without_drift(record.samples(c), (SLOW_S * rate_hz) as usize);
    let levels: Vec<Vec<f64>> = (0..channels).map(|c| levels(&steady(c), hop, windows)).collect();
    let floors: Vec<f64> = (0..channels).map(|c| OF_STEP * step(record.samples(c))).collect();
    let level = |c: usize, q: &[f64], share: f64| quantile(q, share).unwrap_or(0.0).max(floors[c]);
    let quiet: Vec<f64> = (0..channels).map(|c| level(c, &levels[c], 0.1)).collect();
    let first = scores(&levels, &quiet)?;
    let noise_of = |arrival: usize| -> Vec<f64> {
        let before = arrival.saturating_sub(2);
        match before >= NOISE_WINDOWS_LEAST {
            true => (0..channels)
                .map(|c| level(c, &levels[c][..before], 0.5))
                .collect(),
            false => quiet.clone(),
        }
    };
    let noise = noise_of(arrival_of(&first));
    let scores = scores(&levels, &noise)?;
    let at = peak_of(&scores);
    if scores[at] < SCORE_LEAST {
        return None;
    }
    let arrival = arrival_of(&scores);
    let growth = (arrival.saturating_sub(GROWTH_WINDOWS)..at)
        .map(|k| scores[(k + GROWTH_WINDOWS).min(at)] / scores[k].max(1.0))
        .fold(1.0, f64::max);
    let (mut least, mut regrowth) = (f64::INFINITY, 1.0_f64);
    for score in &scores[at.min(arrival + 1)..] {
        least = least.min(*score);
        if *score >= REGROWN_LEAST * scores[at] {
            regrowth = regrowth.max(score / least);
        }
    }
    let end = (at..windows)
        .find(|k| {
            let next = &scores[*k..(k + ENDED_WINDOWS).min(windows)];
            next.len() == ENDED_WINDOWS && next.iter().all(|score| *score < ENDED)
        })
        .map_or(windows, |k| k + 1);
    let ends = end < windows;
    let time_s = |window: usize| (window * hop) as f64 / rate_hz;
    let (arrival_s, end_s) = (
        time_s(arrival),
        match ends {
            true => time_s(end),
            false => record.duration_s(),
        },
    );
    let weights: Vec<(usize, f64)> = match inputs {
        [] => (0..channels).collect(),
        _ => inputs.to_vec(),
    }
    .into_iter()
    .filter(|c| noise[*c] > 0.0)
    .map(|c| (c, 1.0 / (noise[c] * noise[c])))
    .collect();
    let span = (arrival * hop)..((end_s * rate_hz) as usize).min(record.length());
    let shaken: Vec<Vec<f64>> = (0..channels).map(|c| steady(c)[span.clone()].to_vec()).collect();
    let [from, to] = husid(&shaken, &weights);
    let peak = |of: Quantity| {
        let own = (0..channels).filter(|c| record.channels()[*c].quantity == of);
        own.flat_map(|c| shaken[c].iter().map(|x| x.abs()))
            .reduce(f64::max)
    };
    Some(Features {
        latest_peak_s: latest_peak_s(&shaken, &noise, rate_hz),
        regrowth,
        in_lines: in_lines(&shaken, &noise),
        peak_m_s2: peak(Quantity::Acceleration),
        peak_m_s: peak(Quantity::Velocity),
        shaking: Shaking {
            arrival_s,
            strong_from_s: arrival_s + from as f64 / rate_hz,
            strong_to_s: arrival_s + to as f64 / rate_hz,
            end_s,
            ends,
            over_noise: scores[at],
            growth,
        },
    })
}

/// The channel less the average of what came before: a centred one would carry an arrival forward in time.
pub(super) fn without_drift(x: &[f64], length: usize) -> Vec<f64> {
    let mut sums = Vec::with_capacity(x.len() + 1);
    sums.push(0.0);
    for x in x {
        sums.push(sums[sums.len() - 1] + x);
    }
    let mean = |t: usize| {
        let (from, to) = match t < length {
            true => (0, (length + 1).min(x.len())), // what comes first has nothing before it
            false => (t - length, t + 1),
        };
        (sums[to] - sums[from]) / (to - from) as f64
    };
    x.iter().enumerate().map(|(t, x)| x - mean(t)).collect()
}

/// The smallest difference of two samples that are not alike: the step of the digitiser, or next to nothing; 0 of a channel that stands.
fn step(x: &[f64]) -> f64 {
    let differences = x.windows(2).map(|two| (two[1] - two[0]).abs());
    let moves = differences.filter(|by| *by > 0.0);
    moves.reduce(f64::min).unwrap_or(0.0)
}

fn levels(x: &[f64], hop: usize, windows: usize) -> Vec<f64> {
    let mut part = Vec::with_capacity(2 * hop);
    let median = |k: usize| {
        part.clear();
        part.extend(x[k * hop..(k + 2) * hop].iter().map(|x| x.abs()));
        let (_, middle, _) = part.select_nth_unstable_by(hop, f64::total_cmp);
        *middle
    };
    (0..windows).map(median).collect()
}

/// `None` where no channel moves.
fn scores(levels: &[Vec<f64>], noise: &[f64]) -> Option<Vec<f64>> {
    let live: Vec<usize> = (0..levels.len()).filter(|c| noise[*c] > 0.0).collect();
    let windows = levels.first()?.len();
    let passed = (MISSING * live.len() as f64) as usize;
    let score = |k: usize| {
        let mut each: Vec<f64> = live.iter().map(|c| levels[*c][k] / noise[*c]).collect();
        each.sort_by(f64::total_cmp);
        each[passed]
    };
    (!live.is_empty()).then(|| (0..windows).map(score).collect())
}

fn peak_of(scores: &[f64]) -> usize {
    let by_size = |a: &(usize, &f64), b: &(usize, &f64)| a.1.total_cmp(b.1).then(b.0.cmp(&a.0));
    scores.iter().enumerate().max_by(by_size).map_or(0, |(at, _)| at)
}

/// The first window of the motion that holds the peak.
fn arrival_of(scores: &[f64]) -> usize {
    let (mut arrival, mut still) = (peak_of(scores), 0);
    for k in (0..arrival).rev() {
        if scores[k] >= ARRIVED {
            (arrival, still) = (k, 0);
        } else {
            still += 1;
            if still == STILL_WINDOWS {
                break;
            }
        }
    }
    arrival
}

/// From the first sample above the noise on any channel to the peak of the channel that has its own last, s.
fn latest_peak_s(shaken: &[Vec<f64>], noise: &[f64], rate_hz: f64) -> f64 {
    let live = || (0..shaken.len()).filter(|c| noise[*c] > 0.0);
    let samples = shaken.first().map_or(0, Vec::len);
    let is_above = |t: &usize| live().any(|c| shaken[c][*t].abs() > BEGINS * noise[c]);
    let begins = (0..samples).find(is_above).unwrap_or(0);
    let peak_of = |c: usize| {
        let each = shaken[c][begins..].iter().map(|x| x.abs()).enumerate();
        each.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most })
            .0
    };
    live().map(peak_of).max().unwrap_or(0) as f64 / rate_hz
}

/// Share of the power in the highest lines, of the channel that has least there.
fn in_lines(shaken: &[Vec<f64>], noise: &[f64]) -> f64 {
    let length = shaken.first().map_or(0, Vec::len).max(2);
    let transform = RealFftPlanner::<f64>::new().plan_fft_forward(length);
    let share = |c: usize| {
        let mut part = shaken[c].clone();
        part.resize(length, 0.0);
        let mut lines = transform.make_output_vec();
        // the lengths are those it asked for
        let _ = transform.process(&mut part, &mut lines);
        let mut power: Vec<f64> = lines.iter().map(|line| line.norm_sqr()).collect();
        let (all, mut high) = (power.iter().sum::<f64>(), 0.0);
        for _ in 0..LINES {
            let at = peak_of(&power);
            let near = at.saturating_sub(BESIDE)..(at + BESIDE + 1).min(power.len());
            high += power[near.clone()].iter().sum::<f64>();
            power[near].fill(0.0);
        }
        high / all.max(f64::MIN_POSITIVE)
    };
    let live = (0..shaken.len()).filter(|c| noise[*c] > 0.0);
    live.map(share).fold(1.0, f64::min)
}

/// Samples behind the start of the span at which the shares of the energy have come.
fn husid(shaken: &[Vec<f64>], weights: &[(usize, f64)]) -> [usize; 2] {
    let samples = shaken.first().map_or(0, Vec::len);
    let mut sum = 0.0;
    let mut sums = Vec::with_capacity(samples);
    let energy = |t: usize| -> f64 {
        let each = weights.iter().map(|(c, w)| w * shaken[*c][t] * shaken[*c][t]);
        each.sum()
    };
    for t in 0..samples {
        sum += energy(t);
        sums.push(sum);
    }
    STRONG.map(|share| sums.partition_point(|of| *of < share * sum))
}
