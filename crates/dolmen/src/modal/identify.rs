//! From a record to its modes: spectrum, machines told from modes, subspace method, clusters, and every choice told.

use super::decay::{SHORT, of_decay, short_spectrum};
use super::error::refused;
use super::likelihood::refined;
use super::modal_analysis::{ModalAnalysis, of_peaks};
use super::options::Identify;
use super::quality::leave_out_late_clocks;
use super::quality::leave_out_other_clocks;
use super::quality::leave_out_spells;
use super::quality::note_hidden_pairs;
use super::quality::{doubt_channels, to_one_quantity};
use super::quality::{note_tones_on_modes, split_tones, test_for_machines};
use super::quality::{refusal, remark};
use super::quality::{unequal, widen};
use super::settings::{choose, passed_hz};
use super::spectrum::FractionScatter;
use super::spectrum::Plscf;
use super::spectrum::keeping_most;
use super::spectrum::plscf;
use super::spectrum::{Efdd, efdd};
use super::spectrum::{Fdd, FddResult, fdd};
use super::subspace::Deviations;
use super::subspace::{AllOrders, Criteria, Stabilization, judge_poles};
use super::subspace::{Cluster, Clustering, Fate, group_poles};
use super::subspace::{ssi_cov, ssi_data};
use super::{Method, ModalError, Mode, Modes, Note, PoleDeviation, Propagation};
use crate::signal::{ChannelFault, Record, inspect, leave_out};

/// Modes of an ambient record, found without a hand on it: spectrum, a subspace method at all orders, clusters; or the peaks
/// of the spectrum alone, as `method` says.
///
/// The lowest and the highest peak of the spectrum decide how far the correlations reach and how much they are
/// decimated; [`Settings`](super::Settings) tells. Two passes over the record: one of long lags for the spectrum, one for SSI.
///
/// # Errors
/// [`ModalError::Channel`], [`ModalError::NoPeak`], [`ModalError::BlockRows`],
/// [`ModalError::Order`], [`ModalError::ModesWanted`], [`ModalError::ModesMissing`], [`ModalError::TooShort`],
/// [`ModalError::NoModeAt`], [`ModalError::Dependent`], [`ModalError::Option`], [`ModalError::Linalg`].
///
/// # Example
/// ```
/// use dolmen::modal::{Identify, ReferenceCase, identify};
/// let record = ReferenceCase::ShearChain.made(1)?.make()?;
/// let found = identify(&record, &Identify::default())?;
/// assert_eq!(found.modes.modes.len(), 2);
/// let first = &found.modes.modes[0];
/// assert!((first.frequency_hz - 1.1).abs() < 4.0 * first.frequency_sd_hz.unwrap_or(0.0));
/// # Ok::<(), dolmen::modal::ModalError>(())
/// ```
pub fn identify(record: &Record, options: &Identify) -> Result<ModalAnalysis, ModalError> {
    check(record, options)?;
    let mut notes = judge_channels(record)?;
    note_filter(record, options, &mut notes);
    let mut peaks = spectrum(record, options)?;
    let tones_hz = split_tones(record, &mut peaks, options, &mut notes)?;
    let mut analysis = match options.method {
        Method::Fdd | Method::Efdd | Method::Fsdd => of_peaks(peaks, record, options),
        Method::Era => of_decay(record, options, peaks)?,
        Method::SsiCov | Method::SsiData | Method::Bayoma | Method::Plscf => {
            of_poles(record, options, (peaks, &tones_hz), &mut notes)?
        }
    };
    if options.method != Method::Era {
        let all = (0..record.channels().len()).collect();
        test_for_machines(&[(record, all)], options, &mut analysis.modes, &mut notes)?;
        leave_out_spells(record, &mut analysis.modes, &mut notes);
        leave_out_other_clocks(record, &mut analysis.modes, &mut notes);
        if let Some(alone) = of_one_clock(record, options, &analysis.modes, &notes) {
            return Ok(alone);
        }
    }
    to_one_quantity(&mut analysis.modes, &mut notes);
    leave_out_late_clocks(&mut analysis.modes, &mut notes);
    if let Some(alone) = of_one_clock(record, options, &analysis.modes, &notes) {
        return Ok(alone);
    }
    let not_picked_hz = pick(options, &mut analysis.modes)?;
    wanted(options, &analysis.modes)?;
    note_tones_on_modes(record, (&analysis.modes, &analysis.fdd_modes), &mut notes);
    let why = |peak_hz: f64| refusal(&analysis, peak_hz, &options.clustering);
    remark(
        &analysis.modes,
        (&analysis.fdd_modes, &why),
        not_picked_hz,
        &mut notes,
    );
    // the subspace methods tell such modes apart, where the record does
    if matches!(
        options.method,
        Method::Fdd | Method::Efdd | Method::Fsdd | Method::Plscf
    ) {
        let prominence_db = options.fdd.prominence_db;
        note_hidden_pairs(&analysis.modes, &analysis.spectrum, prominence_db, &mut notes);
    }
    doubt_channels(&analysis.modes, &mut notes);
    analysis.notes = notes;
    Ok(analysis)
}

/// The same of the channels of one clock, where others were left out: the others' phases make two modes of one, or none.
fn of_one_clock(record: &Record, options: &Identify, modes: &Modes, notes: &[Note]) -> Option<ModalAnalysis> {
    const CHANNELS_LEAST: usize = 2; // one alone has no shape, and modes with a node there are lost
    let is_off = |name: &&str| modes.channels.iter().all(|kept| kept.name != **name);
    let off: Vec<&str> = record.channels().iter().map(|c| c.name.as_str()).collect();
    let off: Vec<&str> = off.into_iter().filter(is_off).collect();
    if off.is_empty() || modes.channels.len() < CHANNELS_LEAST || !options.references.is_empty() {
        return None;
    }
    let mut alone = identify(&leave_out(record.clone(), &off).ok()?, options).ok()?;
    let of_clocks = |note: &&Note| matches!(note, Note::ClockDrift { .. } | Note::LateClocks { .. });
    alone.notes.extend(notes.iter().filter(of_clocks).cloned());
    Some(alone)
}

/// Says where a frequency that was asked for lies beyond what the record's own anti-alias filter lets pass.
pub(super) fn note_filter(record: &Record, options: &Identify, notes: &mut Vec<Note>) {
    if let (Some(asked_hz), Some(passed_hz)) = (options.frequency_high_hz, passed_hz(record))
        && asked_hz > passed_hz
    {
        notes.push(Note::FilteredAbove { asked_hz, passed_hz });
    }
}

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
    match options.method {
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
    }
}

/// Poles of all orders, judged and grouped.
fn of_poles(
    record: &Record,
    options: &Identify,
    (peaks, tones_hz): (FddResult, &[f64]),
    notes: &mut Vec<Note>,
) -> Result<ModalAnalysis, ModalError> {
    let few = (options.method == Method::Plscf && options.references.is_empty())
        .then(|| keeping_most(&peaks.seen_at_peaks()));
    let with_few = Identify {
        references: few
            .as_ref()
            .map_or_else(|| options.references.clone(), |few| few.channels.clone()),
        ..options.clone()
    };
    let mut settings = choose(record, &with_few, (&peaks.modes, tones_hz), notes)?;
    settings.references_keep = few.map(|few| few.kept);
    let criteria = options.criteria.within(settings.range_hz);
    let mut hankel_singular_values = Vec::new();
    let (stabilization, clusters) = if options.method == Method::Plscf {
        let found = plscf(
            record,
            &Plscf {
                lags: 2 * settings.block_rows - 1,
                order_most: settings.order_most,
                decimation: settings.decimation,
                time_blocks: settings.time_blocks,
                references: settings.references.clone(),
                frequency_low_hz: settings.range_hz[0],
                frequency_high_hz: settings.range_hz[1],
                ..Plscf::default()
            },
        )?;
        settings.lines = found.lines;
        let all = AllOrders {
            poles: &found.poles,
            duration_s: found.duration_s,
            order_most: found.order_most,
            order_step: found.references.len(),
        };
        judged(
            &all,
            &mut FractionScatter::new(&found),
            &criteria,
            &options.clustering,
        )?
    } else {
        let ssi = settings.ssi();
        let found = match options.method {
            Method::SsiData => ssi_data(record, &ssi)?,
            _ => ssi_cov(record, &ssi)?,
        };
        hankel_singular_values.clone_from(&found.singular_values);
        judged(
            &AllOrders::of(&found),
            &mut Propagation::new(&found),
            &criteria,
            &options.clustering,
        )?
    };
    note_blends(&clusters, notes);
    let mut modes = modes_of(&clusters, record.duration_s());
    if options.method == Method::Bayoma {
        modes = refined(record, modes, (&peaks, tones_hz), (&settings, &criteria), notes);
    }
    let unequal = unequal(record, settings.time_blocks);
    widen(&mut modes, unequal.widening);
    settings.time_blocks_effective = unequal.time_blocks;
    Ok(ModalAnalysis {
        modes: Modes {
            modes,
            channels: record.channels().to_vec(),
            method: options.method,
            duration_s: record.duration_s(),
            history: record.history().to_vec(),
        },
        spectrum: peaks.spectrum,
        fdd_modes: peaks.modes,
        stabilization,
        clusters,
        hankel_singular_values,
        settings,
        decay: None,
        notes: Vec::new(),
    })
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

/// The diagram, and the groups of its poles.
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
    if options.decimation == Some(0) {
        return refused("decimation", 0.0, "at least 1");
    }
    if let Some(picked) = options.pick_hz.iter().find(|f| !(**f > 0.0 && **f < nyquist_hz)) {
        return refused("pick_hz", *picked, "above 0 and below half the sampling rate");
    }
    if !(options.pick_within > 0.0 && options.pick_within < 0.5) {
        return refused("pick_within", options.pick_within, "above 0 and below 0.5");
    }
    Ok(())
}

/// Share of the record that a channel may stand still. Chosen here.
const STUCK_MOST: f64 = 0.02;

/// Refuses dead and duplicated channels, and those that stand still for more than a fiftieth of the record; notes all else.
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

/// Keeps the modes picked by hand, each of which must be there once; returns the frequencies of the others, Hz.
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
        .map(|c| Mode {
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
            window_bias: None,
        })
        .collect()
}

/// Scatter between blocks of time and scatter between orders, together: which order is looked at is as much chance as
/// which ten minutes were recorded.
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
