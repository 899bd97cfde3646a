//! The Fourier lines near a group of modes, projected on their shapes.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | y | `sums` | Fourier sums of the channels, line by line | channels × lines |
//! | Φ | `shapes` | initial shapes of the modes of a band | channels × m |
//! | N | `noise` | power of other motion in each channel | diagonal |
//! | z | `seen` | (Φ* N⁻¹ Φ)⁻¹ Φ* N⁻¹ y, or N^(-1/2) y if there are no more channels than modes | r × lines |

use super::band::Band;
use super::band_fit::{BandFit, Cell};
use super::band_motion::{CrossSpectrum, Oscillator, Recorded, root};
use super::hermitian::{backward, forward, lower, plus, times};
use crate::modal::indicators::assurance;
use crate::modal::modes::Mode;
use crate::signal::{Quantity, Record};
use dolmen_linalg::{Complex64, ComplexMatrix};
use realfft::RealFftPlanner;
use rustfft::FftPlanner;
use std::f64::consts::TAU;
use std::ops::Range;

/// Number of half-power widths of a band on each side.
const HALF_WIDTHS: f64 = 20.0;
/// Largest width of a band on each side, as a share of the frequency.
const REACH_MOST: f64 = 0.6;
/// Modes are fitted together if their distance is less than this multiple of the sum of their half-power widths.
const TOGETHER: f64 = 5.0;
const TOGETHER_MOST: usize = 3;
/// Width of a cell over its distance from the nearest pole: within a cell the spectrum is linear to a thousandth.
const CELL: f64 = 0.05;
/// Fewest lines within the half-power widths.
const LINES_LEAST: f64 = 4.0;
/// Lines removed on each side of a tone, and their share of its frequency.
const TONE_LINES: f64 = 3.0;
const TONE_SHARE: f64 = 2e-3;
/// Largest difference of a mode from the subspace result, in standard deviations of that result; a larger difference means another mode.
pub(super) const DEVIATIONS_MOST: f64 = 5.0;
/// Least MAC with the shape of the subspace method. Also the limit of similarity to another mode within the half-power band, above which the lines
/// cannot separate the two.
const ALIKE_LEAST: f64 = 0.95;
const COHERENCE_MOST: f64 = 0.95;
/// Ratio of the smallest standard deviation, from the information matrix, to its lower bound, above which a mode of the band cannot be separated
/// from the others.
const FLOORS_MOST: f64 = 3.5;

/// New values of a mode, each with the change due to every block of time.
pub(super) struct Fitted {
    pub(super) oscillator: Oscillator,
    frequency_changes_hz: Vec<f64>,
    damping_changes: Vec<f64>,
}

impl Fitted {
    pub(super) fn put(self, mode: &mut Mode) {
        let sd = |changes: &[f64]| changes.iter().map(|d| d * d).sum::<f64>().sqrt();
        mode.cycles *= self.oscillator.frequency_hz / mode.frequency_hz;
        mode.frequency_hz = self.oscillator.frequency_hz;
        mode.frequency_sd_hz = Some(sd(&self.frequency_changes_hz));
        mode.frequency_changes_hz = self.frequency_changes_hz;
        mode.damping_ratio = Some(self.oscillator.damping_ratio);
        mode.damping_ratio_sd = Some(sd(&self.damping_changes));
    }
}

/// Fourier lines of the record; its last few samples are left out for a fast transform.
pub(super) struct Lines {
    length: usize,
    pub(super) recorded: Recorded,
    /// Number of derivatives that convert each channel to the recorded quantity.
    raised: Vec<i32>,
    dt: f64,
}

impl Lines {
    pub(super) fn of(record: &Record) -> Self {
        let length = smooth_below(record.length());
        let dt = 1.0 / record.sampling_rate_hz();
        let order = |quantity: Quantity| match quantity {
            Quantity::Displacement => 0,
            Quantity::Velocity => 1,
            Quantity::Acceleration | Quantity::Unknown => 2,
        };
        let orders: Vec<i32> = record.channels().iter().map(|c| order(c.quantity)).collect();
        let derivatives = orders.iter().copied().max().unwrap_or(2);
        Lines {
            length,
            recorded: Recorded {
                derivatives,
                duration_s: length as f64 * dt,
            },
            raised: orders.iter().map(|own| derivatives - own).collect(),
            dt,
        }
    }

    fn hz(&self, line: usize) -> f64 {
        line as f64 / self.recorded.duration_s
    }

    /// Transforms each whole channel in turn, and stores the lines of the bands.
    pub(super) fn fill(&self, record: &Record, bands: &mut [BandLines]) {
        let transform = RealFftPlanner::<f64>::new().plan_fft_forward(self.length);
        let mut input = transform.make_input_vec();
        let mut output = transform.make_output_vec();
        let mut scratch = transform.make_scratch_vec();
        let scale = (self.dt / self.length as f64).sqrt();
        for (c, raised) in self.raised.iter().enumerate() {
            let samples = &record.samples(c)[..self.length];
            let mean = samples.iter().sum::<f64>() / self.length as f64;
            for (x, y) in input.iter_mut().zip(samples) {
                *x = y - mean;
            }
            // the buffers have the required lengths
            let _ = transform.process_with_scratch(&mut input, &mut output, &mut scratch);
            for band in bands.iter_mut() {
                let raise = |line: usize| Complex64::new(0.0, TAU * self.hz(line)).powi(*raised) * scale;
                let kept = band.lines.clone().map(|line| output[line] * raise(line));
                band.sums.push(kept.collect());
                for (i, shape) in band.shapes.iter_mut().enumerate() {
                    shape[c] *= root(band.oscillators[i]).powi(*raised);
                }
            }
        }
    }
}

/// Largest even product of 2, 3 and 5 up to this length.
fn smooth_below(length: usize) -> usize {
    let smooth = |n: usize| {
        let mut left = n;
        for factor in [2, 3, 5] {
            while left.is_multiple_of(factor) {
                left /= factor;
            }
        }
        left == 1 && n.is_multiple_of(2)
    };
    (2..=length).rev().find(|n| smooth(*n)).unwrap_or(0)
}

pub(super) struct BandLines {
    pub(super) modes: Range<usize>,
    oscillators: Vec<Oscillator>,
    /// One shape for each mode.
    pub(super) shapes: Vec<Vec<Complex64>>,
    lines: Range<usize>,
    sums: Vec<Vec<Complex64>>,
    /// Transformation from the channels to the coordinates of the fit.   shape: r × channels
    along: ComplexMatrix,
    /// z of each line, one column each.   shape: r × lines
    seen: ComplexMatrix,
    pub(super) cells: Vec<Cell>,
    /// Cell of each line; `None` for a line near a tone.
    cell_of: Vec<Option<usize>>,
}

/// Groups close modes into bands; a band ends halfway to the next mode.
pub(super) fn bands_of(modes: &[Mode], range_hz: [f64; 2], lines: &Lines) -> Vec<BandLines> {
    let half_hz = |m: &Mode| m.damping_ratio.unwrap_or(0.0) * m.frequency_hz;
    let mut groups: Vec<Range<usize>> = (0..modes.len()).map(|i| i..i + 1).collect();
    loop {
        let apart = |g: usize| {
            let (a, b) = (&modes[groups[g].end - 1], &modes[groups[g + 1].start]);
            (b.frequency_hz - a.frequency_hz) / (half_hz(a) + half_hz(b))
        };
        let fits = |g: &usize| groups[*g].len() + groups[g + 1].len() <= TOGETHER_MOST;
        let nearest = (0..groups.len().saturating_sub(1))
            .filter(|g| fits(g) && apart(*g) < TOGETHER)
            .min_by(|a, b| apart(*a).total_cmp(&apart(*b)));
        let Some(g) = nearest else { break };
        groups[g].end = groups.remove(g + 1).end;
    }
    let each = groups.into_iter();
    each.map(|group| band_of(modes, group, range_hz, lines)).collect()
}

/// A mode and the nearest other one, if that is close.
pub(super) fn with_nearest(modes: &[Mode], which: usize) -> Range<usize> {
    let half_hz = |m: &Mode| m.damping_ratio.unwrap_or(0.0) * m.frequency_hz;
    let apart = |a: &usize| {
        let (a, b) = (&modes[*a], &modes[which]);
        (b.frequency_hz - a.frequency_hz).abs() / (half_hz(a) + half_hz(b))
    };
    let above = Some(which + 1).filter(|above| *above < modes.len());
    let beside = [which.checked_sub(1), above].into_iter().flatten();
    let nearest = beside.min_by(|a, b| apart(a).total_cmp(&apart(b)));
    match nearest.filter(|at| apart(at) < TOGETHER) {
        Some(at) => at.min(which)..at.max(which) + 1,
        None => which..which + 1,
    }
}

/// The band of a group of modes, which ends halfway to the next mode.
pub(super) fn band_of(modes: &[Mode], group: Range<usize>, range_hz: [f64; 2], lines: &Lines) -> BandLines {
    let half_hz = |m: &Mode| m.damping_ratio.unwrap_or(0.0) * m.frequency_hz;
    let reach_hz = |m: &Mode| (HALF_WIDTHS * half_hz(m)).min(REACH_MOST * m.frequency_hz);
    let middle = |a: usize, b: usize| 0.5 * (modes[a].frequency_hz + modes[b].frequency_hz);
    let own = &modes[group.clone()];
    let low = own
        .iter()
        .map(|m| m.frequency_hz - reach_hz(m))
        .fold(f64::INFINITY, f64::min);
    let high = own
        .iter()
        .map(|m| m.frequency_hz + reach_hz(m))
        .fold(0.0, f64::max);
    let low = low.max(range_hz[0]).max(if group.start > 0 {
        middle(group.start - 1, group.start)
    } else {
        0.0
    });
    let high = high.min(range_hz[1]).min(if group.end < modes.len() {
        middle(group.end - 1, group.end)
    } else {
        f64::INFINITY
    });
    let duration_s = lines.recorded.duration_s;
    let last = ((high * duration_s) as usize).min(lines.length / 2 - 1);
    let first = ((low * duration_s).ceil() as usize).max(1);
    BandLines {
        oscillators: own
            .iter()
            .map(|m| Oscillator {
                frequency_hz: m.frequency_hz,
                damping_ratio: m.damping_ratio.unwrap_or(0.0),
            })
            .collect(),
        shapes: own.iter().map(|m| m.shape.clone()).collect(),
        modes: group,
        lines: first..last.max(first),
        sums: Vec::new(),
        along: ComplexMatrix::default(),
        seen: ComplexMatrix::default(),
        cells: Vec::new(),
        cell_of: Vec::new(),
    }
}

impl BandLines {
    /// Chooses the coordinates in which the noise of the channels has the least effect, in three iterations.
    pub(super) fn look_along_shapes(&mut self) {
        const ROUNDS: usize = 3;
        const LEAST: f64 = 1e-6; // of a channel's power: its noise is not known better
        let (n, m, count) = (self.sums.len(), self.shapes.len(), self.lines.len());
        let power = |y: &Vec<Complex64>| y.iter().map(Complex64::norm_sqr).sum::<f64>() / count.max(1) as f64;
        let whole: Vec<f64> = self
            .sums
            .iter()
            .map(power)
            .map(|p| p.max(f64::MIN_POSITIVE))
            .collect();
        let mut noise = whole.clone();
        if n <= m {
            self.along = ComplexMatrix::from_fn(n, n, |i, j| {
                if i == j {
                    noise[i].sqrt().recip().into()
                } else {
                    Complex64::default()
                }
            });
        } else {
            let shapes = ComplexMatrix::from_fn(n, m, |c, i| self.shapes[i][c]);
            for _ in 0..ROUNDS {
                let weighed = ComplexMatrix::from_fn(m, n, |i, c| shapes[(c, i)].conj() / noise[c]);
                let Some(lower) = lower(&times(&weighed, &shapes)) else {
                    self.along = ComplexMatrix::default();
                    return;
                };
                let half = forward(&lower, &weighed);
                self.along = backward(&lower, &half);
                let hat = times(&shapes, &self.along);
                for c in 0..n {
                    let left = (0..count).map(|k| {
                        let back: Complex64 = (0..n).map(|d| hat[(c, d)] * self.sums[d][k]).sum();
                        (self.sums[c][k] - back).norm_sqr()
                    });
                    let share = (1.0 - hat[(c, c)].re).max(0.05);
                    noise[c] = (left.sum::<f64>() / (count.max(1) as f64 * share)).max(LEAST * whole[c]);
                }
            }
        }
        let r = self.along.rows();
        self.seen = ComplexMatrix::from_fn(r, count, |i, k| {
            (0..n).map(|c| self.along[(i, c)] * self.sums[c][k]).sum()
        });
        self.sums = Vec::new();
    }

    /// Shapes of the modes of any band in these coordinates.   shape: r × modes
    fn shapes_here(&self, of: &[Vec<Complex64>]) -> ComplexMatrix {
        ComplexMatrix::from_fn(self.along.rows(), of.len(), |i, j| {
            of[j]
                .iter()
                .enumerate()
                .map(|(c, x)| self.along[(i, c)] * x)
                .sum()
        })
    }

    /// Groups the lines into cells, without lines near tones.
    pub(super) fn gather(&mut self, lines: &Lines, tones_hz: &[f64]) {
        let r = self.seen.rows();
        let line_hz = lines.hz(1);
        let beside_tone = |hz: f64| {
            let near = |tone: &f64| (hz - tone).abs() <= (TONE_LINES * line_hz).max(TONE_SHARE * tone);
            tones_hz.iter().any(near)
        };
        let width_hz = |hz: f64| {
            let from = |o: &Oscillator| (hz - o.frequency_hz).hypot(o.damping_ratio * o.frequency_hz);
            CELL * self.oscillators.iter().map(from).fold(f64::INFINITY, f64::min)
        };
        let mut end_hz = f64::NEG_INFINITY;
        let (mut cells, mut cell_of): (Vec<Cell>, Vec<Option<usize>>) = (Vec::new(), Vec::new());
        for (k, line) in self.lines.clone().enumerate() {
            let hz = lines.hz(line);
            if r == 0 || beside_tone(hz) {
                cell_of.push(None);
                continue;
            }
            if hz >= end_hz {
                end_hz = hz + width_hz(hz);
                cells.push(Cell {
                    frequency_hz: 0.0,
                    lines: 0.0,
                    product: ComplexMatrix::zeros(r, r),
                    others: ComplexMatrix::zeros(r, r),
                });
            }
            let Some(cell) = cells.last_mut() else { continue };
            cell.lines += 1.0;
            cell.frequency_hz += hz;
            let z = self.seen.column(k);
            for j in 0..r {
                for i in 0..r {
                    cell.product[(i, j)] += z[i] * z[j].conj();
                }
            }
            cell_of.push(Some(cells.len() - 1));
        }
        for cell in &mut cells {
            let share = 1.0 / cell.lines;
            cell.frequency_hz *= share;
            cell.product.as_mut_slice().iter_mut().for_each(|x| *x *= share);
        }
        self.cells = cells;
        self.cell_of = cell_of;
    }

    /// Start of the search; `None` if there are too few lines or the shapes are similar.
    pub(super) fn start(&self, lines: &Lines) -> Option<Band> {
        let (r, m) = (self.along.rows(), self.shapes.len());
        let duration_s = lines.recorded.duration_s;
        let few = |o: &Oscillator| 2.0 * o.damping_ratio * o.frequency_hz * duration_s < LINES_LEAST;
        let numbers = 2 * m + 2 * m * (r.max(1) - 1) + m * m + r * r;
        let count = self.cell_of.iter().flatten().count();
        if r == 0 || self.oscillators.iter().any(few) || count < 4 * numbers {
            return None;
        }
        let shapes = self.shapes_here(&self.shapes);
        let force = |i: usize| {
            let own = self.oscillators[i];
            let spectrum = CrossSpectrum::new(own, own, lines.recorded);
            let column = shapes.column(i);
            let norm: f64 = column.iter().map(Complex64::norm_sqr).sum();
            let near =
                |c: &&Cell| (c.frequency_hz - own.frequency_hz).abs() < own.damping_ratio * own.frequency_hz;
            let [mut moved, mut expected] = [0.0; 2];
            for cell in self.cells.iter().filter(near) {
                let along: Complex64 = (0..r)
                    .flat_map(|a| (0..r).map(move |b| (a, b)))
                    .map(|(a, b)| column[a].conj() * cell.product[(a, b)] * column[b])
                    .sum();
                moved += cell.lines * along.re / (norm * norm);
                expected += cell.lines * spectrum.at(cell.frequency_hz).re;
            }
            (moved / expected).max(f64::MIN_POSITIVE)
        };
        let forces = ComplexMatrix::from_fn(m, m, |i, j| {
            if i == j {
                force(i).into()
            } else {
                Complex64::default()
            }
        });
        let quiet = |a: usize| {
            let mut power: Vec<f64> = self.cells.iter().map(|c| c.product[(a, a)].re).collect();
            power.sort_by(f64::total_cmp);
            0.5 * power[power.len() / 5]
        };
        let noise = ComplexMatrix::from_fn(r, r, |i, j| {
            if i == j {
                quiet(i).into()
            } else {
                Complex64::default()
            }
        });
        Some(Band {
            oscillators: self.oscillators.clone(),
            shapes,
            forces,
            noise,
            range_hz: self.range_hz(),
            rise: 0.0,
            independent: false,
            tilt: None,
        })
    }

    /// Lowest and highest cell, Hz.
    fn range_hz(&self) -> [f64; 2] {
        let at = |cell: Option<&Cell>| cell.map_or(0.0, |cell| cell.frequency_hz);
        [at(self.cells.first()), at(self.cells.last())]
    }

    /// Shapes of the fitted modes at the channels.   shape: channels × modes
    pub(super) fn shapes_found(&self, fit: &BandFit) -> ComplexMatrix {
        let (n, m, r) = (self.along.columns(), self.shapes.len(), self.along.rows());
        ComplexMatrix::from_fn(n, m, |c, j| {
            let here = fit.band.shapes.column(j);
            if n <= m {
                here[c] / self.along[(c, c)]
            } else {
                (0..r).map(|i| self.shapes[i][c] * here[i]).sum()
            }
        })
    }

    /// Adds the contribution of the modes of other bands to each cell.
    pub(super) fn see_others<'a>(&mut self, others: impl Iterator<Item = &'a (BandFit, ComplexMatrix)>) {
        let r = self.along.rows();
        for cell in &mut self.cells {
            cell.others = ComplexMatrix::zeros(r, r);
        }
        for (fit, shapes) in others {
            let spectra = fit.spectra();
            let across = times(&self.along, shapes);
            for cell in &mut self.cells {
                let motion = fit.motion(&spectra, &across, cell.frequency_hz);
                cell.others = plus(&cell.others, &motion);
            }
        }
    }

    /// The fitted modes of the band, and their changes by each block of time.
    pub(super) fn answers(&self, fit: &BandFit, time_blocks: usize) -> Option<Vec<Fitted>> {
        let (r, m, count) = (self.along.rows(), self.shapes.len(), self.lines.len());
        let spectra = fit.spectra();
        let length = (count.max(4 * time_blocks)).next_power_of_two();
        // the lines, unweighted and weighted for each parameter
        let mut series = vec![vec![Complex64::default(); length]; (1 + 2 * m) * r];
        let mut influence: (usize, Vec<ComplexMatrix>) = (usize::MAX, Vec::new());
        for (k, cell) in self.cell_of.iter().enumerate() {
            let Some(cell) = *cell else { continue };
            if influence.0 != cell {
                let Cell {
                    frequency_hz, others, ..
                } = &self.cells[cell];
                influence = (cell, fit.influence(&spectra, *frequency_hz, others)?);
            }
            let z = self.seen.column(k);
            for i in 0..r {
                series[i][k] = z[i];
                for (t, weight) in influence.1.iter().enumerate() {
                    series[(1 + t) * r + i][k] = (0..r).map(|j| weight[(i, j)] * z[j]).sum();
                }
            }
        }
        let back = FftPlanner::<f64>::new().plan_fft_inverse(length);
        series.iter_mut().for_each(|s| back.process(s));
        let (own, weighed) = series.split_at(r);
        let of = |t: usize| -> Vec<f64> {
            let mut sums = vec![0.0; time_blocks];
            for (x, y) in own.iter().zip(&weighed[t * r..(t + 1) * r]) {
                for (n, (x, y)) in x.iter().zip(y).enumerate() {
                    sums[n * time_blocks / length] += (x.conj() * y).re / length as f64;
                }
            }
            let blocks = time_blocks as f64;
            let mean = sums.iter().sum::<f64>() / blocks;
            let unbiased = (blocks / (blocks - 1.0)).sqrt();
            sums.iter().map(|s| unbiased * (s - mean)).collect()
        };
        // the scatter of blocks hardly longer than the decay of the mode is too small: the variance is at least that of the information matrix
        let known = |changes: Vec<f64>, variance: f64| -> Vec<f64> {
            let scatter = changes.iter().map(|d| d * d).sum::<f64>();
            let by = (variance / scatter.max(f64::MIN_POSITIVE)).sqrt().max(1.0);
            changes.into_iter().map(|d| by * d).collect()
        };
        let each = fit.band.oscillators.iter().zip(fit.variances()).enumerate();
        let answers = each.map(|(i, (oscillator, [of_f, of_zeta]))| Fitted {
            oscillator: *oscillator,
            frequency_changes_hz: known(of(2 * i), of_f),
            damping_changes: known(of(2 * i + 1), of_zeta),
        });
        Some(answers.collect())
    }

    /// Whether each mode is still near its initial value, with a standard deviation that is plausible for the length of the record.
    pub(super) fn are_the_same(&self, fit: &BandFit, modes: &[Mode]) -> bool {
        (0..self.shapes.len()).all(|i| self.is_the_same(fit, modes, i))
    }

    /// The same for mode `i` of the band alone.
    pub(super) fn is_the_same(&self, fit: &BandFit, modes: &[Mode], i: usize) -> bool {
        let mode = &modes[self.modes.start + i];
        let found = &fit.band.oscillators[i];
        let variances = fit.variances()[i];
        let far = |by: f64, sd: Option<f64>| sd.is_none_or(|sd| by.abs() > DEVIATIONS_MOST * sd);
        let as_found = Mode {
            frequency_hz: found.frequency_hz,
            damping_ratio: Some(found.damping_ratio),
            ..mode.clone()
        };
        let floors = [
            as_found.frequency_floor_hz(),
            as_found.damping_floor() * found.damping_ratio,
        ];
        let known = |(variance, floor): (&f64, f64)| variance.sqrt() < FLOORS_MOST * floor;
        fit.band.coherence() <= COHERENCE_MOST
            && assurance(self.shapes_found(fit).column(i), &self.shapes[i]) >= ALIKE_LEAST
            && variances.iter().zip(floors).all(known)
            && !far(found.frequency_hz - mode.frequency_hz, mode.frequency_sd_hz)
            && !far(
                found.damping_ratio - mode.damping_ratio.unwrap_or(0.0),
                mode.damping_ratio_sd,
            )
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    #[test]
    fn exact_lines_of_a_displacement_are_brought_to_the_acceleration_beside_it() {
        // a sine with 30 whole cycles, and its second derivative
        let turn = TAU * 30.0 / 3000.0;
        let wave = |t: usize| (turn * t as f64).sin();
        let omega = 100.0 * turn;
        let samples = vec![
            (0..3000).map(wave).collect(),
            (0..3000).map(|t| -omega * omega * wave(t)).collect(),
        ];
        let mut channels = vec![Channel::named("d"), Channel::named("a")];
        channels[0].quantity = Quantity::Displacement;
        channels[1].quantity = Quantity::Acceleration;
        let record = Record::new(channels, samples, 100.0).unwrap();
        let lines = Lines::of(&record);
        assert_eq!(lines.raised, [2, 0]);
        let mut bands = [BandLines {
            modes: 0..1,
            oscillators: vec![Oscillator {
                frequency_hz: 1.0,
                damping_ratio: 0.01,
            }],
            shapes: vec![vec![Complex64::new(1.0, 0.0); 2]],
            lines: 30..31,
            sums: Vec::new(),
            along: ComplexMatrix::default(),
            seen: ComplexMatrix::default(),
            cells: Vec::new(),
            cell_of: Vec::new(),
        }];
        lines.fill(&record, &mut bands);
        let [of_displacement, of_acceleration] = [bands[0].sums[0][0], bands[0].sums[1][0]];
        assert!(
            (of_displacement / of_acceleration - 1.0).norm() < 1e-9,
            "{of_displacement} {of_acceleration}"
        );
        let raised = bands[0].shapes[0][0] / bands[0].shapes[0][1];
        assert!((raised / root(bands[0].oscillators[0]).powi(2) - 1.0).norm() < 1e-12);
    }
}
