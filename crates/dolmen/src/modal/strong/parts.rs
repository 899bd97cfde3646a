//! Modes before, in and after an earthquake, and what of it lasts.

use super::peaks::part_of;
use super::shaking::Shaking;
use super::track::{Tracked, tracked};
use crate::modal::identify::identify;
use crate::modal::indicators::assurance;
use crate::modal::modal_analysis::ModalAnalysis;
use crate::modal::options::Identify;
use crate::modal::{Method, Mode, Modes};
use crate::signal::Record;
use dolmen_linalg::Complex64;

/// Shortest part in which modes are sought, s. Chosen here: below it standard deviations from blocks of time mean little.
const PART_LEAST_S: f64 = 40.0;
/// Seconds that are kept from the earthquake: before it the length of a window; after it what a structure at 2 Hz and 2 % of damping takes to
/// forget a swing of twice the noise.
const APART_S: f64 = 1.0;
const SETTLES_S: f64 = 5.0;
/// Largest relative difference of two frequencies, and least likeness of two shapes, that are taken for one mode.
const FREQUENCY_WITHIN: f64 = 0.35;
const ALIKE: f64 = 0.8;
/// A part of the record in which the structure was not shaken.
#[derive(Clone, Debug)]
pub struct Part {
    /// From and to, s from the first sample of the record.
    pub span_s: [f64; 2],
    /// Its modes; `None` where it is too short, or no modes were found in it.
    pub analysis: Option<ModalAnalysis>,
}

/// A mode in the earthquake.
#[derive(Clone, Debug, PartialEq)]
pub struct DuringMode {
    /// Frequency, Hz: that of the linear structure that moved most alike.
    pub frequency_hz: f64,
    /// Standard deviation, Hz.
    pub frequency_sd_hz: Option<f64>,
    /// Damping ratio.
    pub damping_ratio: Option<f64>,
    /// Standard deviation of that.
    pub damping_ratio_sd: Option<f64>,
}

/// The structure in the earthquake.
#[derive(Clone, Debug)]
pub enum During {
    /// Modes on the measured ground as it moved.
    Driven {
        /// The inputs taken as given.
        inputs: Vec<String>,
        /// The modes by frequency.
        modes: Vec<DuringMode>,
    },
    /// The lowest mode, window by window.
    Tracked(Tracked),
    /// Nothing can be told.
    Unknown,
}

/// A mode before and after.
#[derive(Clone, Debug, PartialEq)]
pub struct LastingChange {
    /// Frequency before, Hz.
    pub before_hz: f64,
    /// Standard deviation of that.
    pub before_sd_hz: Option<f64>,
    /// Frequency after, Hz.
    pub after_hz: f64,
    /// Standard deviation of that.
    pub after_sd_hz: Option<f64>,
    /// After over before, less 1.
    pub ratio: f64,
    /// Standard deviation of it; `None` where one of both is not known.
    pub ratio_sd: Option<f64>,
}

impl LastingChange {
    /// Standard deviations beyond which a change is one. Chosen here: two identifications differ by as much once in 370 times.
    pub const BEYOND: f64 = 3.0;

    /// Whether it is more than both identifications scatter.
    pub fn is_beyond_chance(&self) -> bool {
        self.ratio_sd
            .is_some_and(|sd| self.ratio.abs() > Self::BEYOND * sd)
    }
}

/// Modes of the part before the earthquake.
pub(super) fn before(record: &Record, options: &Identify, shaking: &Shaking) -> Part {
    part(record, options, [0.0, (shaking.arrival_s - APART_S).max(0.0)])
}

/// Modes of the part after it.
pub(super) fn after(record: &Record, options: &Identify, shaking: &Shaking) -> Part {
    let ends_s = record.duration_s();
    part(record, options, [(shaking.end_s + SETTLES_S).min(ends_s), ends_s])
}

/// As the ambient vibration that it is: what the file says of a ground that drives, and of modes that must be found, is not asked of it.
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

/// The structure in the earthquake: above the measured ground, else its lowest mode followed; `quiet` are its modes at another time.
pub(super) fn during(
    record: &Record,
    options: &Identify,
    shaking: &Shaking,
    quiet: Option<&Modes>,
) -> During {
    if !options.inputs.is_empty() {
        let driven = Identify {
            method: Method::Okid,
            modes_wanted: None,
            pick_hz: Vec::new(),
            accept_hz: Vec::new(),
            ..options.clone()
        };
        let own = part_of(record, [shaking.arrival_s, shaking.end_s]);
        let found = own.and_then(|own| identify(&own, &driven).ok());
        if let Some(found) = found.filter(|of| !of.modes.modes.is_empty()) {
            let mode = |of: &Mode| DuringMode {
                frequency_hz: of.frequency_hz,
                frequency_sd_hz: of.frequency_sd_hz,
                damping_ratio: of.damping_ratio,
                damping_ratio_sd: of.damping_ratio_sd,
            };
            return During::Driven {
                inputs: found.driven.map(|of| of.inputs).unwrap_or_default(),
                modes: found.modes.modes.iter().map(mode).collect(),
            };
        }
    }
    let lowest = quiet.and_then(|of| Some((of.modes.first()?, of.channels.as_slice())));
    let found = lowest.and_then(|mode| tracked(record, mode, shaking));
    found.map_or(During::Unknown, During::Tracked)
}

/// Each mode before beside the one of like shape after.
pub(super) fn changes(before: &Modes, after: &Modes) -> Vec<LastingChange> {
    let mut left: Vec<&Mode> = after.modes.iter().collect();
    let mut all = Vec::new();
    for mode in &before.modes {
        let near = |of: &&Mode| (of.frequency_hz / mode.frequency_hz - 1.0).abs() <= FREQUENCY_WITHIN;
        let like = |of: &Mode| likeness((before, mode), (after, of));
        let best = left
            .iter()
            .enumerate()
            .filter(|(_, of)| near(of) && like(of) >= ALIKE)
            .max_by(|a, b| like(a.1).total_cmp(&like(b.1)))
            .map(|(at, _)| at);
        let Some(best) = best else { continue };
        let after = left.remove(best);
        let sd = |of: &Mode| of.frequency_sd_hz.map(|sd| sd / of.frequency_hz);
        let ratio = after.frequency_hz / mode.frequency_hz - 1.0;
        all.push(LastingChange {
            before_hz: mode.frequency_hz,
            before_sd_hz: mode.frequency_sd_hz,
            after_hz: after.frequency_hz,
            after_sd_hz: after.frequency_sd_hz,
            ratio,
            ratio_sd: sd(mode).zip(sd(after)).map(|(a, b)| (1.0 + ratio) * a.hypot(b)),
        });
    }
    all
}

/// Assurance over the channels that both have.
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
