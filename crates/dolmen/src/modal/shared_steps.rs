//! Steps common to all methods of identification: faults of channels, spectrum, poles to modes, picked modes.

use super::decay::{SHORT, short_spectrum};
use super::error::{references_of, refused};
use super::options::Identify;
use super::quality::{ClippedRecord, unequal};
use super::settings::passed_hz;
use super::spectrum::{Efdd, Fdd, FddResult, efdd, fdd};
use super::subspace::Deviations;
use super::subspace::{AllOrders, Criteria, Stabilization, judge_poles};
use super::subspace::{Cluster, Clustering, Fate, group_poles};
use super::{Method, ModalError, Mode, Modes, Note, PoleDeviation};
use crate::signal::{ChannelFault, Record, clipped_channels, inspect};

/// Adds a note if a requested frequency is above the pass band of the record's anti-alias filter.
pub(super) fn note_filter(record: &Record, options: &Identify, notes: &mut Vec<Note>) {
    if let (Some(asked_hz), Some(passed_hz)) = (options.frequency_high_hz, passed_hz(record))
        && asked_hz > passed_hz
    {
        notes.push(Note::FilteredAbove { asked_hz, passed_hz });
    }
}

/// Fewest equally strong blocks of time whose spectrum shows buried peaks: that of an earthquake has too few averages.
const STEADY_BLOCKS_LEAST: usize = 10;

pub(super) fn spectrum(record: &Record, options: &Identify) -> Result<FddResult, ModalError> {
    let fdd_options = Fdd {
        frequency_low_hz: options.frequency_low_hz.unwrap_or(options.fdd.frequency_low_hz),
        frequency_high_hz: [
            options.frequency_high_hz.or(options.fdd.frequency_high_hz),
            passed_hz(record),
        ]
        .into_iter()
        .flatten()
        .reduce(f64::min),
        ..options.fdd.clone()
    };
    let mut found = match options.method {
        method @ (Method::Efdd | Method::Fsdd) => efdd(
            record,
            &Efdd {
                fdd: fdd_options,
                method,
                ..Default::default()
            },
        ),
        Method::Era if record.length() < SHORT => short_spectrum(record, &fdd_options),
        _ => fdd(record, &fdd_options),
    }?;
    if unequal(record, options.time_blocks).time_blocks < STEADY_BLOCKS_LEAST {
        found.buried.clear();
    }
    Ok(found)
}

pub(super) fn note_blends(clusters: &[Cluster], notes: &mut Vec<Note>) {
    let is_blend = clusters.iter().filter(|c| c.fate == Fate::Blend);
    let blends: Vec<[f64; 2]> = is_blend
        .map(|c| [c.medoid.frequency_hz, c.medoid.damping_ratio])
        .collect();
    if !blends.is_empty() {
        notes.push(Note::Blends { blends });
    }
}

/// The diagram, and the clusters of its poles.
pub(super) fn judged(
    all: &AllOrders<'_>,
    deviations: &mut dyn Deviations,
    criteria: &Criteria,
    clustering: &Clustering,
) -> Result<(Stabilization, Vec<Cluster>), ModalError> {
    let stabilization = judge_poles(all, deviations, criteria)?;
    let clusters = group_poles(all, deviations, &stabilization, clustering)?;
    Ok((stabilization, clusters))
}

pub(super) fn check(record: &Record, options: &Identify) -> Result<(), ModalError> {
    let nyquist_hz = 0.5 * record.sampling_rate_hz();
    let low_hz = options.frequency_low_hz.unwrap_or(0.0);
    let high_hz = options.frequency_high_hz.unwrap_or(nyquist_hz);
    if !(low_hz >= 0.0 && low_hz < nyquist_hz) {
        return refused("frequency_low_hz", low_hz, "between 0 and half the sampling rate");
    }
    if !(high_hz > low_hz && high_hz <= nyquist_hz) {
        let allowed = "above frequency_low_hz and at most half the sampling rate";
        return refused("frequency_high_hz", high_hz, allowed);
    }
    let (inputs, channels) = (options.inputs.len(), record.channels().len());
    if (options.method == Method::Okid) == (inputs == 0) || inputs >= channels {
        let method = options.method.name();
        return Err(ModalError::Inputs {
            method,
            inputs,
            channels,
        });
    }
    references_of(&options.inputs, channels)?;
    if options.decimation == Some(0) {
        return refused("decimation", 0.0, "at least 1");
    }
    if let Some(picked) = options.pick_hz.iter().find(|f| !(**f > 0.0 && **f < nyquist_hz)) {
        return refused("pick_hz", *picked, "above 0 and below half the sampling rate");
    }
    if let Some(asked) = options
        .accept_hz
        .iter()
        .find(|f| !(**f > 0.0 && **f < nyquist_hz))
    {
        return refused("accept", *asked, "above 0 and below half the sampling rate");
    }
    if let (Method::Era, Some(asked)) = (options.method, options.accept_hz.first()) {
        return Err(ModalError::AcceptedOfDecay { given_hz: *asked });
    }
    if !(options.accept_within > 0.0 && options.accept_within < 0.5) {
        return refused("accept_within", options.accept_within, "above 0 and below 0.5");
    }
    if !(options.pick_within > 0.0 && options.pick_within < 0.5) {
        return refused("pick_within", options.pick_within, "above 0 and below 0.5");
    }
    Ok(())
}

/// Largest share of the record in which a channel may be stuck. Our choice.
const STUCK_MOST: f64 = 0.02;

/// Refuses dead and duplicated channels, and channels that are stuck for more than 2 % of the record; adds notes on all
/// other faults.
pub(super) fn judge_channels(record: &Record) -> Result<Vec<Note>, ModalError> {
    let mut notes = Vec::new();
    for fault in inspect(record) {
        match fault {
            ChannelFault::Constant { .. } | ChannelFault::Duplicated { .. } => {
                return Err(ModalError::Channel(fault));
            }
            ChannelFault::Stuck { from_s, to_s, .. } if to_s - from_s > STUCK_MOST * record.duration_s() => {
                return Err(ModalError::Channel(fault));
            }
            _ => notes.push(Note::Channel(fault)),
        }
    }
    Ok(notes)
}

/// The record with the channels that are clipped in it, or were before it was conditioned, as `notes` and `options` name them.
pub(super) fn clipped_record<'a>(
    record: &'a Record,
    options: &Identify,
    notes: &[Note],
) -> ClippedRecord<'a> {
    let faults: Vec<ChannelFault> = notes
        .iter()
        .filter_map(|note| match note {
            Note::Channel(fault) => Some(fault.clone()),
            _ => None,
        })
        .collect();
    let mut clipped = options.clipped.clone();
    let mut seen = clipped_channels(&faults, record.length());
    seen.retain(|of| clipped.iter().all(|known| known.channel != of.channel));
    clipped.extend(seen);
    ClippedRecord {
        record,
        places: (0..record.channels().len()).collect(),
        clipped,
    }
}

/// Keeps only the modes picked by hand; each pick must have exactly one mode. Returns the frequencies of the other modes,
/// Hz.
pub(super) fn pick(options: &Identify, modes: &mut Modes) -> Result<Vec<f64>, ModalError> {
    if options.pick_hz.is_empty() {
        return Ok(Vec::new());
    }
    let mut picked: Vec<Mode> = Vec::new();
    for frequency_hz in &options.pick_hz {
        let mode = modes.nearest(*frequency_hz, options.pick_within * frequency_hz)?;
        if picked.contains(mode) {
            return Err(ModalError::PickedTwice {
                given_hz: *frequency_hz,
                found_hz: mode.frequency_hz,
            });
        }
        picked.push(mode.clone());
    }
    let is_left = |mode: &&Mode| !picked.contains(mode);
    let left = modes.modes.iter().filter(is_left).map(|mode| mode.frequency_hz);
    let left_hz = left.collect();
    picked.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    modes.modes = picked;
    Ok(left_hz)
}

pub(super) fn modes_of(clusters: &[Cluster], duration_s: f64) -> Vec<Mode> {
    clusters
        .iter()
        .filter(|c| c.fate == Fate::Mode)
        .map(|c| mode_of(c, duration_s))
        .collect()
}

/// Least collinearity of what the lines may show. Our choice: a structure that moves alone has real shapes, and machines of the Palisaden record, whose
/// lines are as wide as those of modes, reach 0.42 to 0.63.
const COLLINEARITY_LEAST: f64 = 0.9;

/// Clusters that recur, with a nearly real shape, but scatter or have too few orders, as modes.
pub(super) fn undecided_of(clusters: &[Cluster], duration_s: f64) -> Vec<Mode> {
    let is_undecided = |c: &&Cluster| {
        matches!(c.fate, Fate::Scattered | Fate::FewOrders)
            && c.deviation.is_some()
            && c.medoid.phase_collinearity >= COLLINEARITY_LEAST
    };
    clusters
        .iter()
        .filter(is_undecided)
        .map(|c| mode_of(c, duration_s))
        .collect()
}

/// Peaks of the spectrum with a nearly real shape at which no cluster recurs, as modes: the frequency is known to a part of the width of the peak, the
/// damping ratio hardly. Where a cluster recurs, its shape is better known than that of the peak: of a machine it is complex.
pub(super) fn undecided_peaks(peaks: &FddResult, clusters: &[Cluster]) -> Vec<Mode> {
    const SD_OF_HALF_WIDTH: f64 = 0.4; // five deviations, which a fit may move by, are the width of the peak
    let undecided = |(peak, width_hz): (&Mode, f64)| {
        let damping_ratio = 0.5 * width_hz / peak.frequency_hz;
        Mode {
            damping_ratio: Some(damping_ratio),
            frequency_sd_hz: Some(SD_OF_HALF_WIDTH * 0.5 * width_hz),
            damping_ratio_sd: Some(damping_ratio),
            ..peak.clone()
        }
    };
    let seen = peaks.modes.modes.iter();
    let seen = seen.zip(peaks.spectrum.half_power_width_hz.iter().copied());
    let buried = peaks.buried.iter().map(|of| (&of.mode, of.width_hz));
    let recurs_at = |mode: &Mode| {
        let half_width_hz = mode.frequency_hz * mode.damping_ratio.unwrap_or(0.0);
        let is_here = |c: &Cluster| (c.medoid.frequency_hz - mode.frequency_hz).abs() <= half_width_hz;
        clusters.iter().any(|c| c.deviation.is_some() && is_here(c))
    };
    seen.chain(buried)
        .map(undecided)
        .filter(|mode| mode.phase_collinearity >= COLLINEARITY_LEAST && !recurs_at(mode))
        .collect()
}

/// The mode of a cluster of poles.
pub(super) fn mode_of(c: &Cluster, duration_s: f64) -> Mode {
    Mode {
        frequency_hz: c.medoid.frequency_hz,
        frequency_sd_hz: sd(c, |d| d.frequency_sd_hz, c.frequency_spread_hz),
        frequency_changes_hz: c
            .deviation
            .as_ref()
            .map_or_else(Vec::new, |d| d.frequency_changes_hz.clone()),
        damping_ratio: Some(c.medoid.damping_ratio),
        damping_ratio_sd: sd(c, |d| d.damping_ratio_sd, c.damping_ratio_spread),
        shape: c.medoid.shape.clone(),
        shape_sd: c
            .deviation
            .as_ref()
            .map(|d| d.shape_sd.clone())
            .filter(|sd| !sd.is_empty()),
        phase_collinearity: c.medoid.phase_collinearity,
        cycles: c.medoid.frequency_hz * duration_s,
        orders: c.orders.clone(),
        kurtosis: None,
        wander: None,
        window_bias: None,
        accepted: None,
    }
}

/// Combines the scatter between blocks of time with the scatter between orders, because the choice of an order is as random
/// as that of the recorded ten minutes.
fn sd(cluster: &Cluster, of_time: fn(&PoleDeviation) -> f64, of_order: f64) -> Option<f64> {
    cluster.deviation.as_ref().map(|d| of_time(d).hypot(of_order))
}

pub(super) fn wanted(options: &Identify, modes: &Modes) -> Result<(), ModalError> {
    match options.modes_wanted {
        Some(given) if given > modes.modes.len() => Err(ModalError::ModesMissing {
            given,
            found: modes.modes.len(),
            found_hz: modes.modes.iter().map(|m| m.frequency_hz).collect(),
        }),
        _ => Ok(()),
    }
}
