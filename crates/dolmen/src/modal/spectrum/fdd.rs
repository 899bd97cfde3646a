//! Frequency domain decomposition: singular values of the spectral matrix over frequency, and its peaks.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | S(f) | `SpectralMatrices` | one-sided spectral density, channels × channels | unit²/Hz |
//! | R_k | | correlations (spectral_matrices.rs) | unit² |
//! | M | `lines` | largest lag of the window | - |

use super::buried::{BuriedPeak, Place, buried_at};
use super::level_peaks::{decibel, half_power_width, peaks};
use super::spectral_matrices::SpectralMatrices;
use crate::modal::error::refused;
use crate::modal::indicators::{normalized, phase_collinearity};
use crate::modal::{Method, ModalError, Mode, Modes};
use crate::signal::Record;
use dolmen_linalg::{Complex64, ComplexMatrix, Matrix, hermitian_eigen, hermitian_eigenvalues};

/// Largest number of spectral lines: more lines need memory and show nothing more.
const LINES_MOST: usize = 16_384;
/// Least ratio of samples to lines: with a smaller ratio there are fewer averages, and peaks of noise look like modes.
const PARTS_LEAST: usize = 16;
/// Number of lines from zero frequency that the removal of the mean and the lag window distort.
const LINES_SPOILT: usize = 4;
/// Independent spectra in the average of a line over the ratio of samples to lines, with Parzen's window.
const AVERAGES_PER_PART: f64 = 1.85;

/// Options of [`fdd`].
#[derive(Clone, Debug, PartialEq)]
pub struct Fdd {
    /// Number of lines from 0 to half the sampling rate; `None` (default): the largest power of two below 1/16 of the samples, from 64 to
    /// 16384, so that about 30 independent parts are averaged.
    pub lines: Option<usize>,
    /// Height of a peak above the higher of the two minima next to it, dB; default 8 (our choice: five standard deviations of a line that
    /// averages 30 parts, on either side).
    pub prominence_db: f64,
    /// Lowest frequency of the analysis, Hz; default 0.
    pub frequency_low_hz: f64,
    /// Highest frequency of the analysis, Hz; `None` (default): half the sampling rate.
    pub frequency_high_hz: Option<f64>,
}

impl Default for Fdd {
    fn default() -> Self {
        Fdd {
            lines: None,
            prominence_db: 8.0,
            frequency_low_hz: 0.0,
            frequency_high_hz: None,
        }
    }
}

/// Singular values of the spectral matrix, line by line.
#[derive(Clone, Debug, PartialEq)]
pub struct SingularSpectrum {
    /// Frequencies, Hz.
    pub frequency_hz: Vec<f64>,
    /// For each frequency all singular values, descending, unit²/Hz: as many as channels.
    pub singular_values: Vec<Vec<f64>>,
    /// Height of each peak above the higher minimum next to it, dB, in the order of the modes.
    pub prominence_db: Vec<f64>,
    /// Width of each peak 3 dB below its top, Hz, in the order of the modes: 2ζf, but at least 1.3/(M dt), the width of the window.
    pub half_power_width_hz: Vec<f64>,
}

/// Peaks of the spectrum as modes, with the singular values behind them.
#[derive(Clone, Debug, PartialEq)]
pub struct FddResult {
    /// Modes without damping: frequency of the line (refined by a parabola through three lines), first singular vector.
    pub modes: Modes,
    /// The spectrum of the analysis.
    pub spectrum: SingularSpectrum,
    pub(super) at_peaks: Vec<AtPeak>,
    /// Peaks of smaller singular values or wider averages alone.
    pub(crate) buried: Vec<BuriedPeak>,
}

/// Singular values and vectors of the spectral matrix at one peak.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct AtPeak {
    pub(super) frequency_hz: f64,
    /// Re S over its trace.
    real: Matrix,
}

impl FddResult {
    /// Σ Re S/tr S over the peaks that remain as modes.
    pub(crate) fn seen_at_peaks(&self) -> Matrix {
        let l = self.modes.channels.len();
        let mode = |f: f64| self.modes.modes.iter().any(|m| m.frequency_hz == f);
        let mut seen = Matrix::zeros(l, l);
        for at in self.at_peaks.iter().filter(|at| mode(at.frequency_hz)) {
            for (sum, x) in seen.as_mut_slice().iter_mut().zip(at.real.as_slice()) {
                *sum += x;
            }
        }
        seen
    }
}

/// Modes at the peaks of the first singular value of the spectral matrix.
///
/// ```text
/// S(f) = 2 dt Σ w_k R_k e^(-2πi f k dt),  k = -M … M      shape: channels × channels, Hermitian
/// S(f) = U diag(s1 ≥ s2 ≥ …) U*                           a peak of s1: frequency; first column of U: shape
/// ```
/// w is Parzen's window: its transform is positive, so no singular value is negative.
///
/// # Errors
/// [`ModalError::TooShort`], [`ModalError::Option`], [`ModalError::Linalg`]. A spectrum without peaks is not an error: `modes` is then
/// empty.
///
/// # Limits
/// Two modes closer than about 2/(M dt) have a single peak. Damping is not estimated: use `efdd` or the subspace methods.
///
/// # Source
/// Brincker, Zhang & Andersen (2001) Smart Mater. Struct. 10:441-445. Differs from the source: the spectra come from windowed correlations
/// (Blackman & Tukey), which SSI uses too, instead of averaged periodograms.
pub fn fdd(record: &Record, options: &Fdd) -> Result<FddResult, ModalError> {
    let lines = options.lines_of(record)?;
    peaks_of(record, &SpectralMatrices::of(record, lines)?, options)
}

impl Fdd {
    /// Smallest number of lines that can show a peak.
    pub(crate) const LINES_LEAST: usize = 64;

    /// Number of spectral lines for this record; checks all options.
    pub(crate) fn lines_of(&self, record: &Record) -> Result<usize, ModalError> {
        if !(self.prominence_db > 0.0 && self.prominence_db.is_finite()) {
            return refused("prominence_db", self.prominence_db, "a positive number");
        }
        if record.length() < PARTS_LEAST * Self::LINES_LEAST {
            return Err(ModalError::TooShort {
                samples: record.length(),
                lags: Self::LINES_LEAST,
                blocks: PARTS_LEAST,
                needed: PARTS_LEAST * Self::LINES_LEAST,
            });
        }
        let automatic = (record.length() / PARTS_LEAST + 1).next_power_of_two() / 2;
        Ok(self
            .lines
            .unwrap_or(automatic.clamp(Self::LINES_LEAST, LINES_MOST)))
    }
}

/// Singular values of every line, and the modes at their peaks.
pub(crate) fn peaks_of(
    record: &Record,
    matrices: &SpectralMatrices,
    options: &Fdd,
) -> Result<FddResult, ModalError> {
    let (l, lines) = (matrices.channels, matrices.lines);
    let step_hz = 0.5 * record.sampling_rate_hz() / lines as f64;
    let mut singular_values = Vec::with_capacity(lines + 1);
    let mut lower = ComplexMatrix::zeros(l, l);
    for line in 0..=lines {
        matrices.lower_into(line, &mut lower);
        let mut s = hermitian_eigenvalues(&lower)?;
        s.reverse();
        s.iter_mut().for_each(|s| *s = s.max(0.0));
        singular_values.push(s);
    }
    let last = options
        .frequency_high_hz
        .map_or(lines, |f| (f / step_hz) as usize);
    let first = ((options.frequency_low_hz / step_hz).ceil() as usize).max(LINES_SPOILT);
    let level: Vec<f64> = singular_values.iter().map(|s| decibel(s[0])).collect();
    let range = first..last.min(lines);
    let peaks = peaks(&level, range.clone(), options.prominence_db);
    let mut modes = Vec::with_capacity(peaks.len());
    let mut at_peaks = Vec::with_capacity(peaks.len());
    for peak in &peaks {
        let s = matrices.at(peak.line);
        let e = hermitian_eigen(&s)?;
        let frequency_hz = (peak.line as f64 + peak.offset) * step_hz;
        let share = 1.0 / (0..l).map(|c| s[(c, c)].re).sum::<f64>();
        at_peaks.push(AtPeak {
            frequency_hz,
            real: Matrix::from_fn(l, l, |i, j| share * s[(i, j)].re),
        });
        modes.push(mode_at(
            frequency_hz,
            e.vectors.column(l - 1),
            record.duration_s(),
        ));
    }
    let seen_hz: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
    let averages = AVERAGES_PER_PART * record.length() as f64 / lines as f64;
    let buried_peak = |at: Place| {
        let e = hermitian_eigen(&matrices.at(at.line))?;
        let vector = e.vectors.column(l - 1 - at.depth);
        Ok(BuriedPeak {
            mode: mode_at(at.line as f64 * step_hz, vector, record.duration_s()),
            width_hz: at.width * step_hz,
        })
    };
    let found = (range, step_hz, averages);
    let buried = buried_at(&singular_values, found, options.prominence_db, &seen_hz)
        .into_iter()
        .map(buried_peak)
        .collect::<Result<_, ModalError>>()?;
    Ok(FddResult {
        modes: Modes {
            modes,
            channels: record.channels().to_vec(),
            method: Method::Fdd,
            duration_s: record.duration_s(),
            history: record.history().to_vec(),
        },
        spectrum: SingularSpectrum {
            frequency_hz: (0..=lines).map(|i| i as f64 * step_hz).collect(),
            singular_values,
            prominence_db: peaks.iter().map(|p| p.prominence_db).collect(),
            half_power_width_hz: peaks
                .iter()
                .map(|p| half_power_width(&level, p.line) * step_hz)
                .collect(),
        },
        at_peaks,
        buried,
    })
}

/// A mode without damping, at a peak.
fn mode_at(frequency_hz: f64, vector: &[Complex64], duration_s: f64) -> Mode {
    let shape = normalized(vector);
    Mode {
        frequency_hz,
        frequency_sd_hz: None,
        frequency_changes_hz: Vec::new(),
        damping_ratio: None,
        damping_ratio_sd: None,
        phase_collinearity: phase_collinearity(&shape),
        shape,
        shape_sd: None,
        cycles: frequency_hz * duration_s,
        orders: Vec::new(),
        kurtosis: None,
        wander: None,
        window_bias: None,
        accepted: None,
    }
}
