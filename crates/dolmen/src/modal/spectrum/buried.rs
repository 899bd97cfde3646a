//! Peaks that the strongest motion buries: smaller singular values show them, or wider averages.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | s_i(f) | | singular values of the spectral matrix, descending | unit²/Hz |
//! | r | `depth` | number of singular values that are added | – |
//! | w | `width` | number of lines that are averaged | – |
//! | ν | `averages` | independent spectra in the average of a line | – |

use super::level_peaks::{decibel, half_power_width, peaks};
use crate::modal::Mode;
use std::ops::Range;

/// Largest number of singular values that are added: the next ones rarely show a mode that these do not.
const DEPTH_MOST: usize = 6;
/// Numbers of averaged lines.
const WIDTHS: [usize; 4] = [1, 4, 16, 64];
/// Least number of averaged widths between zero frequency and a peak, so that a peak is narrow.
const WIDTHS_BELOW: usize = 8;
/// Fewest averages: the spectra of short decays have one.
const AVERAGES_LEAST: f64 = 8.0;
/// Lines between which the spectrum is independent, with Parzen's window.
const LINES_APART: f64 = 1.85;
/// Largest distance from a peak that is seen, relative.
const SAME: f64 = 0.03;
const DECIBEL: f64 = 4.342_944_819; // 10/ln 10

/// A peak of smaller singular values or wider averages, as a mode without damping.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct BuriedPeak {
    /// Shape: the vector of the singular value that adds the peak.
    pub(crate) mode: Mode,
    /// Distance between the points 3 dB below its top, Hz.
    pub(crate) width_hz: f64,
}

/// Where such a peak is.
pub(super) struct Place {
    pub(super) line: usize,
    /// Number of the singular value that adds the peak, from 0.
    pub(super) depth: usize,
    /// Distance between the points 3 dB below its top, lines.
    pub(super) width: f64,
}

/// The peaks of
///
/// ```text
/// L_r(f) = 10 log10 s_1 s_2 … s_r,   r = 1 … 6, averaged over w lines
/// ```
/// beyond `seen_hz`. Where two modes change places in the order of the singular values, each value has a kink, but the product has none; with all
/// values it is the determinant, which the units and noises of the channels only shift. A peak must rise by as many standard deviations as one of
/// the first singular value:
///
/// ```text
/// var L_r = (10/ln 10)² Σ ψ'(ν - i) ≈ (10/ln 10)² Σ 1/(ν - i - ½),  i = 0 … r - 1,   less by 1.85/w after averaging
/// ```
///
/// # Source
/// Goodman (1963) Ann. Math. Statist. 34:152-177, for the determinant of an estimated spectral matrix.
pub(super) fn buried_at(
    singular_values: &[Vec<f64>],
    (range, step_hz, averages): (Range<usize>, f64, f64),
    prominence_db: f64,
    seen_hz: &[f64],
) -> Vec<Place> {
    let l = singular_values.first().map_or(0, Vec::len);
    // a spectrum of few averages has no noise to compare with
    let most = match averages >= AVERAGES_LEAST && range.len() > *WIDTHS.last().unwrap_or(&0) {
        true => DEPTH_MOST.min(l).min((0.5 * averages) as usize),
        false => 0,
    };
    let variance = |i: usize| 1.0 / (averages - i as f64 - 0.5);
    let mut level = vec![0.0; singular_values.len()];
    let mut whole = 0.0;
    let mut found: Vec<Place> = Vec::new();
    for depth in 0..most {
        level
            .iter_mut()
            .zip(singular_values)
            .for_each(|(sum, s)| *sum += decibel(s[depth]));
        whole += variance(depth);
        for width in WIDTHS.into_iter().filter(|width| depth + width > 1) {
            let less = (LINES_APART / width as f64).min(1.0);
            let averaged = averaged(&level, width);
            let sd_db = (DECIBEL * (less * whole).sqrt()).max(scatter(&averaged[range.clone()], width));
            let least_db = prominence_db / (DECIBEL * variance(0).sqrt()) * sd_db;
            let near = |a: f64, b: f64| (a / b - 1.0).abs() < SAME;
            for peak in peaks(&averaged, range.clone(), least_db) {
                let hz = |line: usize| line as f64 * step_hz;
                let is_new = seen_hz.iter().all(|seen| !near(hz(peak.line), *seen))
                    && found.iter().all(|of| !near(hz(peak.line), hz(of.line)));
                if is_new && peak.line >= WIDTHS_BELOW * width {
                    found.push(Place {
                        line: peak.line,
                        depth,
                        width: half_power_width(&averaged, peak.line),
                    });
                }
            }
        }
    }
    found.sort_by_key(|of| of.line);
    found
}

/// Standard deviation of the level where it is flat, from the differences of lines one width apart.
fn scatter(averaged: &[f64], width: usize) -> f64 {
    const NORMAL: f64 = 1.4826; // standard deviation over the median of the modulus
    let mut steps: Vec<f64> = averaged
        .windows(width.max(2) + 1)
        .map(|lines| (lines[width.max(2)] - lines[0]).abs())
        .collect();
    if steps.is_empty() {
        return f64::INFINITY;
    }
    let middle = steps.len() / 2;
    let (_, middle, _) = steps.select_nth_unstable_by(middle, f64::total_cmp);
    NORMAL * *middle / 2f64.sqrt()
}

/// Mean of the `width` lines about each line, fewer at the ends.
fn averaged(level: &[f64], width: usize) -> Vec<f64> {
    let mut sums = vec![0.0];
    for (i, x) in level.iter().enumerate() {
        sums.push(sums[i] + x);
    }
    let n = level.len();
    (0..n)
        .map(|i| {
            let (from, to) = (i.saturating_sub(width / 2), (i + width.div_ceil(2)).min(n));
            (sums[to] - sums[from]) / (to - from) as f64
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Fdd, Identify, MadeMode, MadeRecord, fdd, identify};
    use crate::numeric::Random;
    use crate::signal::{Channel, Record};

    fn mode(frequency_hz: f64, damping_ratio: f64, shape: [f64; 3]) -> MadeMode {
        MadeMode {
            frequency_hz,
            damping_ratio,
            shape: shape.to_vec(),
        }
    }

    /// A mode whose acceleration above its frequency hides another one, 25 dB above the rest in a second direction.
    fn hiding(seed: u64) -> Record {
        let made = MadeRecord {
            modes: vec![
                mode(4.7, 0.06, [1.0, 0.8, -0.6]),
                mode(11.3, 0.025, [-0.03, 0.05, 0.02]),
            ],
            noise_ratio: 0.005,
            seed,
            ..MadeRecord::default()
        };
        made.make().unwrap()
    }

    #[test]
    fn holds_a_mode_that_the_second_singular_value_alone_shows_is_found() {
        for seed in 0..3 {
            let record = hiding(seed);
            let seen = fdd(&record, &Fdd::default()).unwrap();
            assert_eq!(seen.modes.modes.len(), 1, "{seed}");
            // the wide peak of the first may appear again
            let buried: Vec<f64> = seen.buried.iter().map(|of| of.mode.frequency_hz).collect();
            assert!(
                (buried.last().unwrap() / 11.3 - 1.0).abs() < 0.02,
                "{seed} {buried:?}"
            );
            let found = identify(&record, &Identify::default()).unwrap().modes.modes;
            let last = found.last().unwrap();
            assert!(
                found.len() == 2 && (last.frequency_hz / 11.3 - 1.0).abs() < 0.01,
                "{seed} {found:?}"
            );
        }
    }

    #[test]
    fn holds_noise_has_no_peaks_at_any_depth_or_width() {
        for (seed, l) in [(1, 2), (2, 5), (3, 12)] {
            let mut random = Random::new(seed, 0);
            let samples = (0..l * 60_000).map(|_| random.normal()).collect();
            let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
            let record = Record::from_contiguous(names, samples, 100.0).unwrap();
            let seen = fdd(&record, &Fdd::default()).unwrap();
            assert!(seen.buried.is_empty(), "{l} {:?}", seen.buried);
        }
    }

    /// Where a falling and a rising density cross, the second singular value has a maximum, and their product none.
    #[test]
    fn exact_a_crossing_is_no_peak() {
        let singular_values: Vec<Vec<f64>> = (0..1000)
            .map(|line| {
                let x = f64::from(line) / 100.0;
                let (a, b) = ((-x).exp(), (x - 10.0).exp());
                vec![a.max(b), a.min(b)]
            })
            .collect();
        let second: Vec<f64> = singular_values.iter().map(|s| decibel(s[1])).collect();
        assert_eq!(peaks(&second, 4..999, 8.0).len(), 1);
        assert!(buried_at(&singular_values, (4..999, 0.1, 30.0), 8.0, &[]).is_empty());
    }
}
