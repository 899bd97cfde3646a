//! From a record to its modes: block rows, decimation, order and modes chosen from the data, and every choice told.

use super::clusters::{Cluster, Clustering, Fate, clusters};
use super::correlations::{CLEAN_SHARE, lags_before};
use super::fdd::{Fdd, FddResult, SingularSpectrum, fdd};
use super::ssi_cov::{SsiCov, Subspace, ssi_cov};
use super::stabilization::{Criteria, Stabilization, stabilize};
use super::{Method, ModalError, Mode, Modes, Note, PoleDeviation};
use crate::signal::{ChannelFault, Record, inspect};

/// Periods of the lowest mode that the lags reach over, 2 br of them: half of this is the least of theory. Longer
/// lags tell close modes apart; much longer ones hold noise alone.
const PERIODS_REACHED: f64 = 3.0;
/// Hankel matrices of more rows take seconds and show no more.
pub(super) const HANKEL_ROWS_MOST: usize = 900;
/// Range above the highest peak that is kept free of aliases.
const RANGE_ABOVE_PEAK: f64 = 1.3;
/// Without a wish the highest model order is this many times the peaks or the channels, whichever are more: two for
/// each mode, the rest for noise and close neighbours. Far more, and poles that fit noise crowd out the modes.
const ORDER_OVER_PEAKS: usize = 6;
/// Bounds of that order: enough orders to see what comes back, and no more than a minute of work.
const ORDER_RANGE: [usize; 2] = [24, 60];

/// Options of [`identify`]. The defaults serve every record this chapter was measured on.
#[derive(Clone, Debug, PartialEq)]
pub struct Identify {
    /// Lowest frequency of interest, Hz; `None` (default): the lowest peak of the spectrum decides.
    pub frequency_low_hz: Option<f64>,
    /// Highest frequency of interest, Hz; `None` (default): the highest peak of the spectrum decides.
    pub frequency_high_hz: Option<f64>,
    /// Block rows; `None` (default): from the lowest frequency.
    pub block_rows: Option<usize>,
    /// Decimation of the correlations; `None` (default): from the highest frequency; `Some(1)`: none.
    pub decimation: Option<usize>,
    /// Highest model order; `None` (default): six times the peaks of the spectrum or the channels, whichever are more,
    /// between 24 and 60.
    pub order_most: Option<usize>,
    /// Blocks of time for the standard deviations; default 30.
    pub time_blocks: usize,
    /// Modes that must be found; `None` (default): as many as there are.
    pub modes_wanted: Option<usize>,
    /// The spectrum that is looked at first.
    pub fdd: Fdd,
    /// What a pole must fulfil; its frequency range is narrowed to the one chosen.
    pub criteria: Criteria,
    /// How poles become modes.
    pub clustering: Clustering,
}

impl Default for Identify {
    fn default() -> Self {
        Identify {
            frequency_low_hz: None,
            frequency_high_hz: None,
            block_rows: None,
            decimation: None,
            order_most: None,
            time_blocks: 30,
            modes_wanted: None,
            fdd: Fdd::default(),
            criteria: Criteria::default(),
            clustering: Clustering::default(),
        }
    }
}

/// What was chosen from the data, and from what.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Lowest peak of the spectrum (or lowest frequency asked), Hz: the block rows reach over its period.
    pub lowest_hz: f64,
    /// Highest peak of the spectrum (or highest frequency asked), Hz: the decimation keeps it.
    pub highest_hz: f64,
    /// Samples before over samples after the low-pass filter of the correlations.
    pub decimation: usize,
    /// Sampling rate after decimation, Hz.
    pub sampling_rate_hz: f64,
    /// Block rows.
    pub block_rows: usize,
    /// Least block rows for the lowest frequency: half a period.
    pub block_rows_least: usize,
    /// Highest model order.
    pub order_most: usize,
    /// Blocks of time.
    pub time_blocks: usize,
    /// Range in which modes are accepted, Hz.
    pub range_hz: [f64; 2],
}

/// With fewer blocks of time the standard deviations are themselves known to worse than 24 %.
const TIME_BLOCKS_LEAST: usize = 10;

/// The modes of a record and everything needed to draw, to doubt and to repeat them.
#[derive(Clone, Debug)]
pub struct ModalAnalysis {
    /// The modes, by frequency.
    pub modes: Modes,
    /// Singular values of the spectral matrix over frequency.
    pub spectrum: SingularSpectrum,
    /// Peaks of the spectrum as modes: a second opinion on frequency and shape.
    pub fdd_modes: Modes,
    /// Every pole with its verdict.
    pub stabilization: Stabilization,
    /// Every cluster of poles with its fate; those with `Fate::Mode` are the modes, in order.
    pub clusters: Vec<Cluster>,
    /// Singular values of the Hankel matrix, descending.
    pub hankel_singular_values: Vec<f64>,
    /// What was chosen from the data.
    pub settings: Settings,
    /// What must be known beside the modes.
    pub notes: Vec<Note>,
}

/// Modes of an ambient record, found without a hand on it: spectrum, SSI-cov of all orders, clusters.
///
/// The lowest and the highest peak of the spectrum decide how far the correlations reach and how much they are
/// decimated; [`Settings`] tells. Two passes over the record: one of long lags for the spectrum, one for SSI.
///
/// # Errors
/// [`ModalError::Channel`], [`ModalError::NoPeak`], [`ModalError::BlockRows`],
/// [`ModalError::Order`], [`ModalError::ModesWanted`], [`ModalError::ModesMissing`], [`ModalError::TooShort`],
/// [`ModalError::Option`], [`ModalError::Linalg`].
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
    let mut peaks = fdd(
        record,
        &Fdd {
            frequency_low_hz: options.frequency_low_hz.unwrap_or(options.fdd.frequency_low_hz),
            frequency_high_hz: options.frequency_high_hz.or(options.fdd.frequency_high_hz),
            ..options.fdd.clone()
        },
    )?;
    let tones = split_tones(&mut peaks, options.criteria.damping_ratio_least);
    if !tones.is_empty() {
        notes.push(Note::Tones { frequency_hz: tones });
    }
    let settings = choose(record, options, &peaks.modes, &mut notes)?;
    let subspace = ssi_cov(
        record,
        &SsiCov {
            block_rows: settings.block_rows,
            order_most: settings.order_most,
            decimation: settings.decimation,
            time_blocks: settings.time_blocks,
        },
    )?;
    let stabilization = stabilize(
        &subspace,
        &Criteria {
            frequency_low_hz: options.criteria.frequency_low_hz.max(settings.range_hz[0]),
            frequency_high_hz: options.criteria.frequency_high_hz.min(settings.range_hz[1]),
            ..options.criteria.clone()
        },
    )?;
    let clusters = clusters(&subspace, &stabilization, &options.clustering)?;
    let modes = modes_of(record, &clusters);
    wanted(options, &modes)?;
    remark(&modes, &peaks.modes, &mut notes);
    let Subspace { singular_values, .. } = subspace;
    Ok(ModalAnalysis {
        modes,
        spectrum: peaks.spectrum,
        fdd_modes: peaks.modes,
        stabilization,
        clusters,
        hankel_singular_values: singular_values,
        settings,
        notes,
    })
}

fn check(record: &Record, options: &Identify) -> Result<(), ModalError> {
    let nyquist_hz = 0.5 * record.sampling_rate_hz();
    let low_hz = options.frequency_low_hz.unwrap_or(0.0);
    let high_hz = options.frequency_high_hz.unwrap_or(nyquist_hz);
    let refused = |option, given, allowed| {
        Err(ModalError::Option {
            option,
            given,
            allowed,
        })
    };
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
    Ok(())
}

/// Refuses dead and duplicated channels; notes faint and clipped ones.
fn judge_channels(record: &Record) -> Result<Vec<Note>, ModalError> {
    let mut notes = Vec::new();
    for fault in inspect(record) {
        match fault {
            ChannelFault::Constant { .. } | ChannelFault::Duplicated { .. } => {
                return Err(ModalError::Channel(fault));
            }
            _ => notes.push(Note::Channel(fault)),
        }
    }
    Ok(notes)
}

/// Takes the peaks out whose half-power width is that of a smaller damping ratio than any structure has, where the
/// lines are fine enough to tell; returns their frequencies.
fn split_tones(peaks: &mut FddResult, damping_ratio_least: f64) -> Vec<f64> {
    let width_hz = std::mem::take(&mut peaks.spectrum.half_power_width_hz);
    let prominence_db = std::mem::take(&mut peaks.spectrum.prominence_db);
    let modes = std::mem::take(&mut peaks.modes.modes);
    let mut tones = Vec::new();
    for ((mode, width_hz), prominence_db) in modes.into_iter().zip(width_hz).zip(prominence_db) {
        if width_hz < 2.0 * damping_ratio_least * mode.frequency_hz {
            tones.push(mode.frequency_hz);
        } else {
            peaks.modes.modes.push(mode);
            peaks.spectrum.half_power_width_hz.push(width_hz);
            peaks.spectrum.prominence_db.push(prominence_db);
        }
    }
    tones
}

fn choose(
    record: &Record,
    options: &Identify,
    peaks: &Modes,
    notes: &mut Vec<Note>,
) -> Result<Settings, ModalError> {
    let (l, rate_hz) = (record.channels().len(), record.sampling_rate_hz());
    let peak = |mode: Option<&Mode>, asked: Option<f64>| {
        asked.or(mode.map(|m| m.frequency_hz)).ok_or(ModalError::NoPeak {
            prominence_db: options.fdd.prominence_db,
            low_hz: options.frequency_low_hz.unwrap_or(0.0),
            high_hz: options.frequency_high_hz.unwrap_or(0.5 * rate_hz),
        })
    };
    let lowest_hz = peak(peaks.modes.first(), options.frequency_low_hz.filter(|f| *f > 0.0))?;
    let highest_hz = peak(peaks.modes.last(), options.frequency_high_hz)?;
    let free = 0.5 * CLEAN_SHARE * rate_hz / (RANGE_ABOVE_PEAK * highest_hz);
    let decimation = options.decimation.unwrap_or((free as usize).max(1));
    let sampling_rate_hz = rate_hz / decimation as f64;
    let block_rows_least = (0.5 * sampling_rate_hz / lowest_hz).ceil() as usize;
    let sought = (ORDER_OVER_PEAKS * peaks.modes.len().max(l)).clamp(ORDER_RANGE[0], ORDER_RANGE[1]);
    let wished =
        ((0.5 * PERIODS_REACHED * sampling_rate_hz / lowest_hz).ceil() as usize).max(sought.div_ceil(l) + 1);
    let block_rows = options.block_rows.unwrap_or_else(|| {
        let taken = wished.min((HANKEL_ROWS_MOST / l).max(block_rows_least));
        if taken < wished {
            notes.push(Note::BlockRowsBounded { wished, taken });
        }
        taken
    });
    if block_rows < block_rows_least {
        return Err(ModalError::BlockRows {
            given: block_rows,
            least: block_rows_least,
            frequency_hz: lowest_hz,
            sampling_rate_hz,
        });
    }
    let lags = lags_before(2 * block_rows - 1, decimation);
    let time_blocks = options
        .time_blocks
        .min(record.length().saturating_sub(lags) / lags.max(1));
    if time_blocks < TIME_BLOCKS_LEAST.min(options.time_blocks) {
        return Err(ModalError::TooShort {
            samples: record.length(),
            lags,
            blocks: TIME_BLOCKS_LEAST,
            needed: (TIME_BLOCKS_LEAST + 1) * lags,
        });
    }
    if time_blocks < options.time_blocks {
        notes.push(Note::FewBlocks { time_blocks });
    }
    let order_most = options
        .order_most
        .unwrap_or(sought.min(l * (block_rows.max(2) - 1) / 2 * 2));
    if let Some(given) = options.modes_wanted.filter(|wanted| 2 * wanted > order_most) {
        return Err(ModalError::ModesWanted {
            given,
            order_most,
            most: order_most / 2,
        });
    }
    let clean_hz = if decimation > 1 {
        0.5 * CLEAN_SHARE * sampling_rate_hz
    } else {
        0.5 * rate_hz
    };
    // below the least the block rows reach over less than half a period
    let seen_hz = 0.5 * sampling_rate_hz / block_rows as f64;
    Ok(Settings {
        lowest_hz,
        highest_hz,
        decimation,
        sampling_rate_hz,
        block_rows,
        block_rows_least,
        order_most,
        time_blocks,
        range_hz: [
            options.frequency_low_hz.unwrap_or(0.0).max(seen_hz),
            options.frequency_high_hz.unwrap_or(f64::INFINITY).min(clean_hz),
        ],
    })
}

fn modes_of(record: &Record, clusters: &[Cluster]) -> Modes {
    let modes = clusters
        .iter()
        .filter(|c| c.fate == Fate::Mode)
        .map(|c| Mode {
            frequency_hz: c.medoid.frequency_hz,
            frequency_sd_hz: sd(c, |d| d.frequency_sd_hz, c.frequency_spread_hz),
            damping_ratio: Some(c.medoid.damping_ratio),
            damping_ratio_sd: sd(c, |d| d.damping_ratio_sd, c.damping_ratio_spread),
            shape: c.medoid.shape.clone(),
            shape_sd: c.deviation.as_ref().map(|d| d.shape_sd.clone()),
            phase_collinearity: c.medoid.phase_collinearity,
            cycles: c.medoid.frequency_hz * record.duration_s(),
            orders: c.orders.clone(),
        })
        .collect();
    Modes {
        modes,
        channels: record.channels().to_vec(),
        method: Method::SsiCov,
        duration_s: record.duration_s(),
        history: record.history().to_vec(),
    }
}

/// Scatter between blocks of time and scatter between orders, together: which order is looked at is as much chance as
/// which ten minutes were recorded.
fn sd(cluster: &Cluster, of_time: fn(&PoleDeviation) -> f64, of_order: f64) -> Option<f64> {
    cluster.deviation.as_ref().map(|d| of_time(d).hypot(of_order))
}

fn wanted(options: &Identify, modes: &Modes) -> Result<(), ModalError> {
    match options.modes_wanted {
        Some(given) if given > modes.modes.len() => Err(ModalError::ModesMissing {
            given,
            found: modes.modes.len(),
            found_hz: modes.modes.iter().map(|m| m.frequency_hz).collect(),
        }),
        _ => Ok(()),
    }
}

fn remark(modes: &Modes, peaks: &Modes, notes: &mut Vec<Note>) {
    const NEAR: f64 = 0.03; // relative; a line of the spectrum lies so near its mode
    const DAMPING_FLOOR: f64 = 0.3; // relative: a damping ratio known worse is a guess
    let explained = |peak: &Mode| {
        let near = |m: &Mode| (m.frequency_hz / peak.frequency_hz - 1.0).abs() <= NEAR;
        modes.modes.iter().any(near)
    };
    let frequency_hz: Vec<f64> = peaks
        .modes
        .iter()
        .filter(|peak| !explained(peak))
        .map(|peak| peak.frequency_hz)
        .collect();
    if !frequency_hz.is_empty() {
        notes.push(Note::PeaksWithoutMode { frequency_hz });
    }
    for mode in &modes.modes {
        let damping_floor = mode.damping_floor();
        if damping_floor > DAMPING_FLOOR {
            notes.push(Note::FewCycles {
                frequency_hz: mode.frequency_hz,
                damping_floor,
            });
        }
    }
}
