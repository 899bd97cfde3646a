//! Whether the Fourier lines of a record need a mode: likelihood of the lines with and without it.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L₁, L₀ | `with`, `without` | likelihood of the lines of the band under a model with the mode, and under the same without it |
//! | Λ | `gain` | ln L₁ − ln L₀ |

use super::band::{Band, Tilt};
use super::band_fit::{BandFit, PROMISE_LEAST, fit, maximum};
use super::band_lines::{BandLines, Lines, band_of, with_nearest};
use super::hermitian::{plus, scaled};
use crate::modal::indicators::assurance;
use crate::modal::modes::Mode;
use crate::modal::subspace::Criteria;
use crate::signal::Record;
use dolmen_linalg::ComplexMatrix;

/// Least gain that shows a mode. Without a mode 2Λ has the distribution χ² with 4 to 9 degrees of freedom: chance exceeds this gain once in 10⁹ bands.
/// Blows are not Gaussian and reach more, which `quality/spells.rs` tests.
const GAIN_LEAST: f64 = 30.0;
/// The search without the mode ends when its next step promises less than this share of what the gain exceeds the least one by. Our choice.
const DECIDED: f64 = 0.01;
/// Rounds in which undecided modes are taken: one with those taken before may show the next.
const ROUNDS: usize = 3;
/// Similarity (MAC) of the shapes of two modes within their bandwidths from which one is the other again.
const ALIKE: f64 = 0.8;
/// Density of the prior of other motion over that of the quiet lines, which modes may still move. Our choice.
const QUIET: f64 = 0.1;

/// What the fits need beside the modes.
pub(crate) struct Question<'a> {
    /// Range in which modes are accepted, Hz.
    pub(crate) range_hz: [f64; 2],
    /// Criteria for damping ratios of modes.
    pub(crate) criteria: &'a Criteria,
    /// Largest standard deviation of a frequency over its lower bound, as for clusters of poles.
    pub(crate) deviation_over_floor_most: f64,
    /// Frequencies of machines, whose lines are removed, Hz.
    pub(crate) tones_hz: &'a [f64],
    /// Number of blocks of time.
    pub(crate) time_blocks: usize,
}

/// A mode among others, by frequency.
struct Asked {
    modes: Vec<Mode>,
    which: usize,
}

/// A mode as the lines show it.
struct Shown {
    mode: Mode,
    /// Λ.
    gain: f64,
}

/// The undecided modes that the lines show beside the `known` ones, as fitted to the lines.
///
/// ```text
/// Λ = max ln L(mode, neighbour, noise) − max ln L(neighbour, noise) ≥ 30
/// ```
/// The noise of both models is a free spectral matrix times a power of the frequency, in the coordinates of the shapes, so that only a peak with the
/// shape of the mode shows it.
///
/// # Source
/// Likelihood: Whittle (1953) Ark. Mat. 2:423-434; distribution of its ratio: Wilks (1938) Ann. Math. Stat. 9:60-62.
pub(crate) fn shown_by_lines(
    record: &Record,
    known: &[Mode],
    mut undecided: Vec<Mode>,
    how: &Question<'_>,
) -> Vec<Mode> {
    let mut taken: Vec<Mode> = Vec::new();
    for _ in 0..ROUNDS {
        let all: Vec<Mode> = known.iter().chain(&taken).cloned().collect();
        undecided.retain(|mode| !all.iter().any(|other| is_again(mode, other)));
        if undecided.is_empty() {
            break;
        }
        let mut shown = shown(record, (&all, &undecided), how);
        shown.sort_by(|a, b| b.gain.total_cmp(&a.gain));
        let before = taken.len();
        for Shown { mode, .. } in shown {
            if !taken[before..].iter().any(|other| other.overlaps(&mode)) {
                taken.push(mode);
            }
        }
        if taken.len() == before {
            break;
        }
    }
    taken
}

/// Whether a mode is another one again: within their bandwidths, and with a similar shape.
fn is_again(mode: &Mode, other: &Mode) -> bool {
    mode.overlaps(other) && assurance(&mode.shape, &other.shape) >= ALIKE
}

/// The undecided modes of which each, alone beside the known ones, is shown.
fn shown(record: &Record, (known, undecided): (&[Mode], &[Mode]), how: &Question<'_>) -> Vec<Shown> {
    let lines = Lines::of(record);
    let asked: Vec<Asked> = undecided.iter().map(|mode| among(known, mode)).collect();
    let of = |asked: &Asked| {
        let group = with_nearest(&asked.modes, asked.which);
        band_of(&asked.modes, group, how.range_hz, &lines)
    };
    let mut bands: Vec<BandLines> = asked.iter().map(of).collect();
    lines.fill(record, &mut bands);
    let each = bands.iter_mut().zip(&asked);
    each.filter_map(|(band, asked)| {
        band.look_along_shapes();
        band.gather(&lines, how.tones_hz);
        in_band(band, asked, (&lines, how))
    })
    .collect()
}

fn among(known: &[Mode], mode: &Mode) -> Asked {
    let mut modes = known.to_vec();
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    let which = modes.partition_point(|other| other.frequency_hz < mode.frequency_hz);
    modes.insert(which, mode.clone());
    Asked { modes, which }
}

/// The mode, if its band shows it.
fn in_band(band: &BandLines, asked: &Asked, (lines, how): (&Lines, &Question<'_>)) -> Option<Shown> {
    let i = asked.which - band.modes.start;
    let start = band.start(lines)?;
    let tilt = Tilt {
        exponent: 0.0,
        quiet: scaled(&start.noise, QUIET),
    };
    // steps of people move all modes at once: a fit that ends with one force for two modes is repeated with independent ones
    let with = [false, true].into_iter().find_map(|independent| {
        let start = Band {
            independent,
            tilt: Some(tilt.clone()),
            ..start.clone()
        };
        fit(&band.cells, start, lines.recorded).filter(|with| band.is_the_same(with, &asked.modes, i))
    })?;
    let found = with.band.oscillators[i];
    let least = how
        .criteria
        .damping_estimate_least_at(found.frequency_hz, lines.recorded.duration_s);
    if !(least..=how.criteria.damping_ratio_most).contains(&found.damping_ratio) {
        return None;
    }
    let above = |log_likelihood: f64| with.log_likelihood() - log_likelihood;
    // a model that lacks a mode creeps towards its maximum, and need not reach it where what it can still gain changes nothing
    let promise_least = |reached: f64| (DECIDED * (above(reached) - GAIN_LEAST)).max(PROMISE_LEAST);
    let start = without_mode(band, &with, i);
    let without = maximum(&band.cells, start, lines.recorded, &promise_least)?;
    let gain = above(without.log_likelihood);
    if gain < GAIN_LEAST {
        return None;
    }
    let mut mode = asked.modes[asked.which].clone();
    let answer = band.answers(&with, how.time_blocks)?.into_iter().nth(i)?;
    answer.put(&mut mode);
    let most_hz = how.deviation_over_floor_most * mode.frequency_floor_hz();
    let is_known = mode.frequency_sd_hz.is_some_and(|sd_hz| sd_hz <= most_hz);
    is_known.then_some(Shown { mode, gain })
}

/// Start of the fit without mode `i`: its motion joins the noise.
fn without_mode(band: &BandLines, with: &BandFit, i: usize) -> Band {
    let spectra = with.spectra();
    let with = &with.band;
    let kept: Vec<usize> = (0..with.oscillators.len()).filter(|k| *k != i).collect();
    let (r, force) = (with.shapes.rows(), with.forces[(i, i)].re);
    let [mut motion, mut count] = [0.0; 2];
    for cell in &band.cells {
        let density = spectra.at(cell.frequency_hz)[(i, i)].re;
        motion += cell.lines * density * with.risen(cell.frequency_hz);
        count += cell.lines;
    }
    let shape = with.shapes.column(i);
    let own = ComplexMatrix::from_fn(r, r, |a, b| shape[a] * shape[b].conj());
    Band {
        oscillators: kept.iter().map(|k| with.oscillators[*k]).collect(),
        shapes: ComplexMatrix::from_fn(r, kept.len(), |a, k| with.shapes[(a, kept[k])]),
        forces: ComplexMatrix::from_fn(kept.len(), kept.len(), |a, b| with.forces[(kept[a], kept[b])]),
        noise: plus(&with.noise, &scaled(&own, force * motion / count)),
        ..with.clone()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::{Identify, MadeMode, MadeRecord, identify};
    use dolmen_linalg::Complex64;

    #[test]
    fn holds_lines_show_a_mode_and_none_where_none_is() {
        let mode = |frequency_hz, shape: [f64; 3]| MadeMode {
            frequency_hz,
            damping_ratio: 0.02,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: vec![
                mode(1.1, [0.4, 0.7, 1.0]),
                mode(1.2, [1.0, -0.2, -0.6]),
                mode(4.2, [1.0, 0.5, -0.8]),
            ],
            seed: 7,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let found = identify(&record, &Identify::default()).unwrap().modes.modes;
        assert_eq!(found.len(), 3);
        let criteria = Criteria::default();
        let how = Question {
            range_hz: [0.3, 8.0],
            criteria: &criteria,
            deviation_over_floor_most: 3.5,
            tones_hz: &[],
            time_blocks: 30,
        };
        for which in 0..3 {
            let mut known = found.clone();
            let own = known.remove(which);
            // as a pole that scatters, off by two of its deviations
            let sd_hz = 4.0 * own.frequency_sd_hz.unwrap();
            let scattered = Mode {
                frequency_hz: own.frequency_hz + 2.0 * sd_hz,
                frequency_sd_hz: Some(sd_hz),
                damping_ratio_sd: own.damping_ratio_sd.map(|sd| 4.0 * sd),
                ..own.clone()
            };
            let shown = shown_by_lines(&record, &known, vec![scattered.clone(), scattered], &how);
            assert_eq!(shown.len(), 1, "{which}");
            let off_hz = shown[0].frequency_hz - made.modes[which].frequency_hz;
            assert!(
                off_hz.abs() < 3.0 * shown[0].frequency_sd_hz.unwrap(),
                "{which} {off_hz}"
            );
        }
        let noise = [0.7, 2.1, 2.9, 6.0].map(|frequency_hz| Mode {
            frequency_hz,
            frequency_sd_hz: Some(0.02 * frequency_hz),
            damping_ratio_sd: Some(0.02),
            shape: [0.9, -0.6, 1.0].map(Complex64::from).to_vec(),
            ..found[0].clone()
        });
        let shown = shown_by_lines(&record, &found, noise.to_vec(), &how);
        assert!(shown.is_empty(), "{shown:?}");
    }
    /// Asked from a peak ten times as wide as the mode, in a band that the mode fills: its noise shows nowhere.
    #[test]
    fn holds_lines_show_a_light_mode_asked_from_a_wide_peak() {
        let mode = |frequency_hz, shape: [f64; 3]| MadeMode {
            frequency_hz,
            damping_ratio: 0.0015,
            shape: shape.to_vec(),
        };
        let made = MadeRecord {
            modes: vec![mode(3.1, [0.4, 0.7, 1.0]), mode(8.1, [1.0, -0.2, -0.6])],
            noise_ratio: 1e-3,
            seed: 3,
            ..MadeRecord::default()
        };
        let record = made.make().unwrap();
        let found = identify(&record, &Identify::default()).unwrap().modes.modes;
        let how = Question {
            range_hz: [0.3, 20.0],
            criteria: &Criteria::default(),
            deviation_over_floor_most: 3.5,
            tones_hz: &[],
            time_blocks: 30,
        };
        for truth in &made.modes {
            let near = |m: &&Mode| (m.frequency_hz / truth.frequency_hz - 1.0).abs() < 0.01;
            let own = found.iter().find(near).unwrap();
            let known: Vec<Mode> = found.iter().filter(|m| !near(m)).cloned().collect();
            let wide = Mode {
                damping_ratio: Some(0.015),
                damping_ratio_sd: Some(0.015),
                frequency_sd_hz: Some(0.006 * own.frequency_hz),
                ..own.clone()
            };
            let shown = shown_by_lines(&record, &known, vec![wide], &how);
            assert_eq!(shown.len(), 1, "{}", truth.frequency_hz);
            let off = (shown[0].damping_ratio.unwrap() - truth.damping_ratio).abs();
            assert!(off < 3.0 * shown[0].damping_ratio_sd.unwrap(), "{:?}", shown[0]);
        }
    }
}
