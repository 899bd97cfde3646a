//! Modes before, during and after an earthquake.

use super::lasting_change::LastingChange;
use super::losses::Losses;
use super::part::{Part, part_of};
use super::shaking::Shaking;
use super::track::{Tracked, tracked};
use crate::modal::identify::identify;
use crate::modal::indicators::assurance;
use crate::modal::modal_analysis::ModalAnalysis;
use crate::modal::options::Identify;
use crate::modal::{Method, Mode, Modes};
use crate::numeric::{quantile, sum_of};
use crate::signal::Record;
use dolmen_linalg::Complex64;

/// Shortest part for identifying modes, s. Our choice: in shorter parts, standard deviations from blocks of time are unreliable.
const PART_LEAST_S: f64 = 40.0;
/// Distance of quiet parts from the earthquake, s: before it the length of a window; after it the time in which a mode at 2 Hz with 2 % damping
/// decays from twice the noise.
const APART_S: f64 = 1.0;
const SETTLES_S: f64 = 5.0;
/// Number of blocks of a part after an earthquake, ratio of the power of the first block to that of the median block above which the structure still
/// decays and the block is left out, and largest share of the part that is left out. One block with a third of the power would leave two effective
/// blocks, which prove no change. Our choice.
const BLOCKS: usize = 30;
const STILL_DECAYS: f64 = 2.5;
const LEFT_OUT_MOST: f64 = 0.3;
/// Largest relative difference of the frequencies, and least likeness of the shapes, of one mode that a part shows twice. Our choice.
const TWICE_WITHIN: f64 = 0.25;
const TWICE_ALIKE: f64 = 0.9;
/// Ratio of the standard deviation in a state with little motion to that in the state with motion, above which the former is dropped. Our choice.
const LITTLE_MOVED: f64 = 4.0;
/// Shortest span for the strong phase, s. The quiet time before the earthquake fills it up, which has little weight; a record of this length can be
/// identified. Our choice.
const DRIVEN_S: f64 = 30.0;

/// Modes relative to the measured ground in one state of the structure, with the time span.
#[derive(Clone, Debug)]
pub struct DrivenPart {
    /// From and to, s from the first sample of the record.
    pub span_s: [f64; 2],
    /// The channels used as inputs.
    pub inputs: Vec<String>,
    /// The modes.
    pub analysis: ModalAnalysis,
}

/// The structure during the earthquake.
#[derive(Clone, Debug)]
pub enum During {
    /// Modes relative to the measured ground motion.
    Driven(Box<DrivenPart>),
    /// The lowest mode, window by window.
    Tracked(Tracked),
    /// No statement is possible.
    Unknown,
}

impl During {
    pub(super) fn shift(&mut self, by_s: f64) {
        match self {
            During::Driven(of) => of.span_s = of.span_s.map(|at_s| at_s + by_s),
            During::Tracked(of) => {
                of.lowest.at_s += by_s;
                of.points.iter_mut().for_each(|point| point.at_s += by_s);
            }
            During::Unknown => {}
        }
    }
}

/// Modes before the first earthquake, between successive ones, and after the last, each from the longest time without lost samples.
pub(super) fn quiet(record: &Record, options: &Identify, shakings: &[Shaking], losses: &Losses) -> Vec<Part> {
    let ends_s = record.duration_s();
    let after = |of: &Shaking| (of.end_s + SETTLES_S).min(ends_s);
    let starts = std::iter::once(0.0).chain(shakings.iter().map(after));
    let ends = shakings.iter().map(|of| (of.arrival_s - APART_S).max(0.0));
    let spans = starts.zip(ends.chain([ends_s]));
    let whole = spans.map(|(from_s, to_s)| losses.whole_within([from_s, to_s.max(from_s)]));
    let settled = whole.enumerate().map(|(at, span_s)| match at {
        0 => span_s,
        _ => settled(record, span_s),
    });
    settled.map(|span_s| part(record, options, span_s)).collect()
}

/// A part after an earthquake, without its first blocks as long as the structure still decays.
fn settled(record: &Record, [from_s, to_s]: [f64; 2]) -> [f64; 2] {
    let rate_hz = record.sampling_rate_hz();
    let [from, to] = [from_s, to_s].map(|at_s| ((at_s * rate_hz) as usize).min(record.length()));
    let length = (to - from) / BLOCKS;
    if length == 0 {
        return [from_s, to_s];
    }
    let mut power = vec![0.0; BLOCKS];
    for c in 0..record.channels().len() {
        let samples = &record.samples(c)[from..to];
        let mean = samples.iter().sum::<f64>() / samples.len() as f64;
        let of = |part: &[f64]| sum_of(part, |y| (y - mean) * (y - mean));
        let own: Vec<f64> = samples.chunks_exact(length).take(BLOCKS).map(of).collect();
        let median = quantile(&own, 0.5).unwrap_or(0.0).max(f64::MIN_POSITIVE);
        for (sum, own) in power.iter_mut().zip(own) {
            *sum += own / median;
        }
    }
    let channels = record.channels().len() as f64;
    let still = power.iter().take_while(|sum| **sum > STILL_DECAYS * channels);
    let most = LEFT_OUT_MOST.min(1.0 - PART_LEAST_S / (to_s - from_s)).max(0.0);
    let left_out = still.count().min((most * BLOCKS as f64) as usize);
    [from_s + (left_out * length) as f64 / rate_hz, to_s]
}

/// Treats a part as ambient vibration: requests for inputs and for modes that must be found do not apply to it.
fn part(record: &Record, options: &Identify, span_s: [f64; 2]) -> Part {
    let ambient = Identify {
        method: match options.method {
            Method::Okid | Method::Era => Method::SsiCov,
            method => method,
        },
        inputs: Vec::new(),
        modes_wanted: None,
        pick_hz: Vec::new(),
        accept_hz: Vec::new(),
        ..options.clone()
    };
    let long = span_s[1] - span_s[0] >= PART_LEAST_S;
    let own = long.then(|| part_of(record, span_s)).flatten();
    let analysis = own.and_then(|own| identify(&own, &ambient).ok());
    Part {
        span_s,
        analysis: analysis.filter(|of| !of.modes.modes.is_empty()),
    }
}

/// The structure during an earthquake: modes relative to the measured ground, or otherwise its tracked lowest mode. `quiet` are modes at another
/// time.
pub(super) fn during(
    (record, losses): (&Record, &Losses),
    options: &Identify,
    shaking: &Shaking,
    quiet: Option<&Modes>,
) -> During {
    if let Some(found) = driven_in((record, losses), options, shaking) {
        return During::Driven(Box::new(found));
    }
    let lowest = quiet.and_then(|of| Some((of.modes.first()?, of.channels.as_slice())));
    let found = lowest.and_then(|mode| tracked((record, losses), mode, shaking));
    found.map_or(During::Unknown, During::Tracked)
}

/// Modes from the channels marked as inputs, from the strong phase of an earthquake, or otherwise from the whole motion; `None` without inputs or
/// modes.
///
/// The strong phase comes first: after it the structure stiffens again, so that the whole motion would show each mode twice.
fn driven_in(
    (record, losses): (&Record, &Losses),
    options: &Identify,
    shaking: &Shaking,
) -> Option<DrivenPart> {
    if options.inputs.is_empty() {
        return None;
    }
    let driven = Identify {
        method: Method::Okid,
        modes_wanted: None,
        pick_hz: Vec::new(),
        accept_hz: Vec::new(),
        ..options.clone()
    };
    let spans = [
        [shaking.strong_from_s, shaking.strong_to_s],
        [shaking.arrival_s, shaking.strong_to_s],
        [(shaking.strong_to_s - DRIVEN_S).max(0.0), shaking.strong_to_s],
        [shaking.arrival_s, shaking.end_s],
    ];
    let of_span = |span_s: [f64; 2]| {
        let span_s = losses.whole_within(span_s);
        let mut analysis = identify(&part_of(record, span_s)?, &driven).ok()?;
        leave_little_moved(&mut analysis);
        let inputs = analysis.driven.as_ref().map(|of| of.inputs.clone());
        (!analysis.modes.modes.is_empty()).then(|| DrivenPart {
            span_s,
            inputs: inputs.unwrap_or_default(),
            analysis,
        })
    };
    let mut first = None;
    for found in spans.into_iter().filter_map(of_span) {
        if !has_a_mode_twice(&found.analysis.modes) {
            return Some(found);
        }
        first.get_or_insert(found);
    }
    first
}

/// Whether two modes have similar shapes and frequencies: then they are one mode of a structure whose stiffness changed.
fn has_a_mode_twice(of: &Modes) -> bool {
    let twice = |(at, one): (usize, &Mode)| {
        let mut later = of.modes.iter().skip(at + 1);
        later.any(|other| is_one_mode(of, one, other))
    };
    of.modes.iter().enumerate().any(twice)
}

fn is_one_mode(of: &Modes, one: &Mode, other: &Mode) -> bool {
    let is_near = (other.frequency_hz / one.frequency_hz - 1.0).abs() <= TWICE_WITHIN;
    is_near && likeness((of, one), (of, other)) >= TWICE_ALIKE
}

/// If a mode is found in two states of the structure, keeps the one in the state with motion.
fn leave_little_moved(analysis: &mut ModalAnalysis) {
    let all = &analysis.modes;
    let is_weak = |weak: &Mode| {
        let beside = |mode: &Mode| match (weak.frequency_sd_hz, mode.frequency_sd_hz) {
            (Some(large), Some(sd)) => large >= LITTLE_MOVED * sd && is_one_mode(all, mode, weak),
            _ => false,
        };
        all.modes.iter().any(beside)
    };
    let (weak, kept): (Vec<Mode>, Vec<Mode>) = all.modes.iter().cloned().partition(is_weak);
    analysis.modes.modes = kept;
    if let Some(driven) = &mut analysis.driven {
        let is_kept = |hz: f64| weak.iter().all(|of| of.frequency_hz != hz);
        driven.modes.retain(|of| is_kept(of.frequency_hz));
    }
}

/// Whether a whole record shows the structure in one state, that of the strong phase: no mode occurs twice, and each mode of the strong phase is
/// found with the same frequency. The whole record may show more modes: a short strong phase has too few cycles of the lowest ones.
pub fn is_of_one_state(whole: &Modes, strong: &Modes) -> bool {
    let is_same = |one: &Mode, other: &Mode| {
        let sds = [one, other].map(|of| of.frequency_sd_hz.unwrap_or(0.0));
        let off = (one.frequency_hz - other.frequency_hz).abs();
        off <= LastingChange::BEYOND * sds[0].hypot(sds[1])
    };
    let is_found = |one: &Mode| whole.modes.iter().any(|other| is_same(one, other));
    !strong.modes.is_empty() && strong.modes.iter().all(is_found) && !has_a_mode_twice(whole)
}

/// MAC over the channels that both have.
fn likeness((a, one): (&Modes, &Mode), (b, other): (&Modes, &Mode)) -> f64 {
    let both = a.channels.iter().enumerate().filter_map(|(at, channel)| {
        let place = b.channels.iter().position(|of| of.name == channel.name)?;
        Some((one.shape[at], other.shape[place]))
    });
    let (x, y): (Vec<Complex64>, Vec<Complex64>) = both.unzip();
    if x.is_empty() {
        return 0.0;
    }
    assurance(&x, &y)
}

#[cfg(test)]
mod tests {
    use super::settled;
    use crate::numeric::Random;
    use crate::signal::{Channel, Record};

    #[test]
    fn exact_a_part_begins_when_the_structure_has_settled() {
        let record = |decay: f64| {
            let mut random = Random::new(2, 0);
            let of = |t: usize| (1.0 + decay * (-(t as f64) / 400.0).exp()) * random.normal();
            Record::new(
                vec![Channel::named("a")],
                vec![(0..12_000).map(of).collect()],
                100.0,
            )
            .unwrap()
        };
        assert_eq!(settled(&record(0.0), [0.0, 120.0]), [0.0, 120.0]);
        // amplitude 6 e^(-t/4 s): twice that of the noise at 4 s, a fifth of it at 14 s
        let [from_s, to_s] = settled(&record(6.0), [0.0, 120.0]);
        assert!((8.0..=12.0).contains(&from_s) && to_s == 120.0, "{from_s}");
        // 40 s are left at least
        assert_eq!(settled(&record(6.0), [0.0, 41.0])[0], 0.0);
    }
}
