//! Chooses block rows, decimation and order from the peaks of the spectrum.

use super::correlations::{CLEAN_SHARE, lags_before};
use super::error::{references_of, refused};
use super::options::Identify;
use super::spectrum::{BuriedPeak, FddResult};
use super::subspace::HANKEL_ROWS_MOST;
use super::subspace::Ssi;
use super::{Method, ModalError, Mode, Modes, Note};
use crate::signal::{CORNER_OF_NYQUIST, Processing, Record};

/// Periods of the lowest mode within the 2 br lags; theory needs at least one. Over 200 records of two floors the scatter of the
/// frequencies is 1.20, 1.25, 1.37, 1.42 of its lower bound with 1.5, 2, 3, 4 periods; close modes need more than one.
const PERIODS_REACHED: f64 = 2.0;
/// The same for the covariance-driven method, which improves with longer lags.
const PERIODS_REACHED_BY_COVARIANCE: f64 = 3.0;
/// The same for half spectra, whose resolution depends on the lags. From 6 to 30 periods, the scatter of the two floors rises from 1.27
/// to 1.6 of its lower bound; that of close pairs stays at 1.3.
const PERIODS_REACHED_BY_LINES: f64 = 8.0;
/// Fewest polynomial degrees, each with as many orders as references: enough to see which poles recur.
const DEGREES_LEAST: usize = 12;
/// Periods of the lowest mode within the polynomials, with one sample per degree. In ten minutes of a timber building, 0.7 periods show
/// none of its first three modes; 1.1 show all three with four references, and 1.5 with two.
const PERIODS_IN_DEGREES: f64 = 1.5;
/// Largest order, references times degrees: each degree needs an eigenvalue problem of that size.
const ORDER_BY_DEGREES: usize = 160;
/// Highest line over the highest peak: more decimation spreads the lowest modes over more of the unit circle.
const RANGE_ABOVE_PEAK_BY_LINES: f64 = 1.4;
/// Frequency range without aliases over the highest peak: a mode near the end of the range is less accurate.
const RANGE_ABOVE_PEAK: f64 = 1.6;
/// Default ratio of the highest model order to the number of peaks and tones (or of channels, if larger): two orders for each mode, the
/// rest for noise and close neighbours. With a much higher order, poles that fit noise displace the modes. Tones need poles too: in ten
/// minutes of a timber building with four tones, order 36 has a mode 0.3 % too low, which is stable from order 50 on.
const ORDER_OVER_PEAKS: usize = 6;
/// Bounds of that order: enough orders to see which poles recur, and at most a minute of computation. With many channels the upper bound
/// is three times their number, so that each can have a mode of its own.
const ORDER_RANGE: [usize; 2] = [24, 60];
const ORDER_OVER_CHANNELS: usize = 3;
const ORDER_LIMIT: usize = 120;

/// Settings chosen from the data, and the values they are based on.
#[derive(Clone, Debug, PartialEq)]
pub struct Settings {
    /// Lowest peak of the spectrum (or lowest requested frequency), Hz: the block rows cover its period.
    pub lowest_hz: f64,
    /// Highest peak of the spectrum (or highest requested frequency), Hz: the decimation keeps it.
    pub highest_hz: f64,
    /// Samples before over samples after the low-pass filter of the correlations.
    pub decimation: usize,
    /// Sampling rate after decimation, Hz.
    pub sampling_rate_hz: f64,
    /// Lines of the spectrum; 0 if the modes do not come from its peaks.
    pub lines: usize,
    /// Block rows; 0 if the modes come from the peaks of the spectrum. The same holds for the next three.
    pub block_rows: usize,
    /// Least block rows for the lowest frequency: half a period.
    pub block_rows_least: usize,
    /// Highest model order.
    pub order_most: usize,
    /// Blocks of time.
    pub time_blocks: usize,
    /// Effective number of blocks with equal power, smaller in a record with gusts. Standard deviations have one degree of freedom less.
    pub time_blocks_effective: usize,
    /// Reference channels, by index; empty if the modes come from the peaks or from a decay.
    pub references: Vec<usize>,
    /// Share of the motion at the peaks that the references explain, 0 to 1, if they were chosen from the spectrum.
    pub references_keep: Option<f64>,
    /// Range in which modes are accepted, Hz.
    pub range_hz: [f64; 2],
}

impl Settings {
    pub(super) fn ssi(&self) -> Ssi {
        Ssi {
            block_rows: self.block_rows,
            order_most: self.order_most,
            decimation: self.decimation,
            time_blocks: self.time_blocks,
            references: self.references.clone(),
        }
    }
}

/// Share of the lowest peak at which its mode is still in range. Our choice: several times the scatter of a mode in ten minutes.
const LOWEST_SCATTERS: f64 = 0.98;

/// Highest frequency that digitisers pass, over the Nyquist frequency: their filters end at 0.9 of it or before, and what lies above is partly an
/// alias. A frequency that the user requests counts up to the Nyquist frequency.
const PASSED_SHARE: f64 = 0.9;

/// Fewest blocks of time: with fewer blocks, the error of the standard deviations exceeds 24 %.
const TIME_BLOCKS_LEAST: usize = 10;

/// Highest frequency that the filters of an earlier resampling pass, Hz; `None` without resampling. Motion above it is partly removed and
/// partly aliased: the edge of the remaining noise looks like a mode.
pub(super) fn passed_hz(record: &Record) -> Option<f64> {
    let lowered =
        |step: &Processing| matches!(step, Processing::Decimate { .. } | Processing::Resampled { .. });
    let any = record.history().iter().any(lowered);
    any.then(|| 0.5 * CORNER_OF_NYQUIST * record.sampling_rate_hz())
}

/// What the spectrum of a record shows.
pub(super) struct Seen<'a> {
    /// Its peaks.
    pub(super) peaks: &'a Modes,
    /// Peaks of smaller singular values or wider averages alone.
    pub(super) buried: &'a [BuriedPeak],
    /// Machines, Hz.
    pub(super) tones_hz: &'a [f64],
}

impl<'a> Seen<'a> {
    pub(super) fn of(found: &'a FddResult, tones_hz: &'a [f64]) -> Self {
        Seen {
            peaks: &found.modes,
            buried: &found.buried,
            tones_hz,
        }
    }

    /// Number of peaks, and of tones below a frequency, Hz. Buried peaks do not count: with more orders than the visible ones need, poles of noise recur.
    fn needing_poles_below(&self, end_hz: f64) -> usize {
        self.peaks.modes.len() + self.tones_hz.iter().filter(|f| **f < end_hz).count()
    }

    pub(super) fn peaks_alone(peaks: &'a Modes) -> Self {
        Seen {
            peaks,
            buried: &[],
            tones_hz: &[],
        }
    }
}

/// Settings of the subspace methods for a record with these peaks and tones.
pub(super) fn choose(
    record: &Record,
    options: &Identify,
    seen: &Seen<'_>,
    notes: &mut Vec<Note>,
) -> Result<Settings, ModalError> {
    let (l, rate_hz) = (record.channels().len(), record.sampling_rate_hz());
    let [lowest_hz, highest_hz] = peak_range_hz(options, seen, rate_hz)?;
    let range_above = match options.method {
        Method::Plscf => RANGE_ABOVE_PEAK_BY_LINES,
        _ => RANGE_ABOVE_PEAK,
    };
    let free = 0.5 * CLEAN_SHARE * rate_hz / (range_above * highest_hz);
    let decimation = options.decimation.unwrap_or((free as usize).max(1));
    let sampling_rate_hz = rate_hz / decimation as f64;
    let block_rows_least = (0.5 * sampling_rate_hz / lowest_hz).ceil() as usize;
    let highest = ORDER_RANGE[1].max((ORDER_OVER_CHANNELS * l).min(ORDER_LIMIT) / 2 * 2);
    let poles = seen.needing_poles_below(0.5 * sampling_rate_hz);
    let sought = (ORDER_OVER_PEAKS * poles.max(l)).clamp(ORDER_RANGE[0], highest);
    let periods = match options.method {
        Method::SsiCov | Method::Bayoma => PERIODS_REACHED_BY_COVARIANCE,
        Method::Plscf => PERIODS_REACHED_BY_LINES,
        _ => PERIODS_REACHED,
    };
    let references = match options.references.len() {
        0 => l,
        some => some,
    };
    let wished =
        ((0.5 * periods * sampling_rate_hz / lowest_hz).ceil() as usize).max(sought.div_ceil(references) + 1);
    let most = match options.method {
        Method::Plscf => usize::MAX,
        _ => (HANKEL_ROWS_MOST / l).max(block_rows_least),
    };
    let taken = wished.min(most);
    if options.block_rows.is_none() && taken < wished {
        notes.push(Note::BlockRowsBounded { wished, taken });
    }
    let block_rows = options.block_rows.unwrap_or(taken);
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
    let order_most = order_most(
        options,
        OrderBounds {
            sought,
            references,
            block_rows,
            rows: l * (block_rows.max(2) - 1),
            degrees: (PERIODS_IN_DEGREES * sampling_rate_hz / lowest_hz).ceil() as usize,
        },
    )?;
    let clean_hz = match decimation {
        1 if options.frequency_high_hz.is_some() => 0.5 * rate_hz,
        1 => 0.5 * PASSED_SHARE * rate_hz,
        _ => 0.5 * CLEAN_SHARE * sampling_rate_hz,
    };
    let clean_hz = clean_hz.min(passed_hz(record).unwrap_or(clean_hz));
    // below this the lags cover less than a period; with the fewest block rows the lowest mode itself scatters about it
    let seen_hz = (0.5 * sampling_rate_hz / block_rows as f64).min(LOWEST_SCATTERS * lowest_hz);
    Ok(Settings {
        lowest_hz,
        highest_hz,
        decimation,
        sampling_rate_hz,
        lines: 0,
        block_rows,
        block_rows_least,
        order_most,
        time_blocks,
        time_blocks_effective: time_blocks,
        references: references_of(&options.references, l)?,
        references_keep: None,
        range_hz: [
            options.frequency_low_hz.unwrap_or(0.0).max(seen_hz),
            options.frequency_high_hz.unwrap_or(f64::INFINITY).min(clean_hz),
        ],
    })
}

/// The lowest and highest requested frequencies, or otherwise those of the peaks, Hz.
fn peak_range_hz(options: &Identify, seen: &Seen<'_>, rate_hz: f64) -> Result<[f64; 2], ModalError> {
    let hz = |mode: &Mode| mode.frequency_hz;
    let visible = seen.peaks.modes.iter().map(hz);
    let buried = seen.buried.iter().map(|of| hz(&of.mode));
    // low noise has peaks of its own, and its lags would be too long for the modes above
    let lowest = visible
        .clone()
        .chain(buried.clone().filter(|_| seen.peaks.modes.is_empty()));
    let lowest = lowest.reduce(f64::min);
    let highest = visible.chain(buried).reduce(f64::max);
    let peak = |peak_hz: Option<f64>, asked: Option<f64>| {
        asked.or(peak_hz).ok_or(ModalError::NoPeak {
            prominence_db: options.fdd.prominence_db,
            low_hz: options.frequency_low_hz.unwrap_or(0.0),
            high_hz: options.frequency_high_hz.unwrap_or(0.5 * rate_hz),
        })
    };
    let lowest_hz = peak(lowest, options.frequency_low_hz.filter(|f| *f > 0.0))?;
    Ok([lowest_hz, peak(highest, options.frequency_high_hz)?])
}

struct OrderBounds {
    /// Order needed for the peaks and tones.
    sought: usize,
    references: usize,
    block_rows: usize,
    /// Rows of the shifted observability matrix.
    rows: usize,
    /// Degree that covers enough periods of the lowest peak.
    degrees: usize,
}

/// The highest order: the requested one, or otherwise the one that the peaks need, limited by the block rows.
fn order_most(options: &Identify, bounds: OrderBounds) -> Result<usize, ModalError> {
    let OrderBounds {
        sought,
        references,
        block_rows,
        ..
    } = bounds;
    let orders_least = 2 * options.clustering.orders_least;
    if let Some(given) = options.order_most
        && options.method != Method::Plscf
        && given < orders_least
    {
        return refused(
            "order_most",
            given as f64,
            "8 or more: a mode must come back at four orders, 2, 4, 6 and 8",
        );
    }
    let order_most = options.order_most.unwrap_or(match options.method {
        Method::Plscf => {
            let held = (ORDER_BY_DEGREES / references).min(block_rows / 2);
            references
                * bounds
                    .degrees
                    .min(held)
                    .max(sought.div_ceil(references))
                    .max(DEGREES_LEAST)
        }
        _ => sought.min(bounds.rows.min(references * block_rows) / 2 * 2),
    });
    match options.modes_wanted.filter(|wanted| 2 * wanted > order_most) {
        Some(given) => Err(ModalError::ModesWanted {
            given,
            order_most,
            most: order_most / 2,
        }),
        None => Ok(order_most),
    }
}

#[cfg(test)]
mod tests {
    use super::super::{Identify, MadeMode, MadeRecord, Method, Note, ReferenceCase, identify};
    use super::LOWEST_SCATTERS;
    use crate::signal::decimate;

    #[test]
    fn holds_the_lowest_mode_is_in_range_with_the_fewest_block_rows() {
        let record = ReferenceCase::ShearChain.made(1).unwrap().make().unwrap();
        let whole = Identify {
            decimation: Some(1),
            ..Identify::default()
        };
        let settings = identify(&record, &whole).unwrap().settings;
        let fewest = Identify {
            block_rows: Some(settings.block_rows_least),
            ..whole
        };
        let found = identify(&record, &fewest).unwrap();
        let low_hz = found.settings.range_hz[0];
        assert!(
            (low_hz / (LOWEST_SCATTERS * settings.lowest_hz) - 1.0).abs() < 1e-12,
            "{low_hz}"
        );
    }

    #[test]
    fn holds_no_mode_is_found_at_the_edge_of_the_filter_of_a_lower_rate() {
        // a chain of four floors, with two modes above the new Nyquist frequency
        let shapes = [
            [0.428, 0.657, 0.228],
            [0.577, 0.0, 0.577],
            [-0.657, -0.228, 0.428],
            [-0.228, 0.577, -0.657],
        ];
        let mode = |(frequency_hz, shape): (f64, [f64; 3])| MadeMode {
            frequency_hz,
            damping_ratio: 0.03,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: [3.0, 8.64, 13.23, 16.23]
                .into_iter()
                .zip(shapes)
                .map(mode)
                .collect(),
            sampling_rate_hz: 200.0,
            noise_ratio: 0.2,
            ..MadeRecord::default()
        };
        let record = decimate(made.make().unwrap(), 10).unwrap();
        for method in [Method::SsiCov, Method::SsiData, Method::Plscf, Method::Efdd] {
            let options = Identify {
                method,
                ..Identify::default()
            };
            let found = identify(&record, &options).unwrap();
            assert_eq!(found.modes.modes.len(), 1, "{method:?} {:?}", found.modes.modes);
            assert!((found.modes.modes[0].frequency_hz / 3.0 - 1.0).abs() < 0.02);
            assert_eq!(found.settings.range_hz[1], 8.0);
        }
        let asked = Identify {
            frequency_high_hz: Some(9.5),
            ..Identify::default()
        };
        let found = identify(&record, &asked).unwrap();
        let told = Note::FilteredAbove {
            asked_hz: 9.5,
            passed_hz: 8.0,
        };
        assert!(found.notes.contains(&told), "{:?}", found.notes);
    }
}
