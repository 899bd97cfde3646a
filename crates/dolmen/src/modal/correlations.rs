//! Correlations of all channels with all channels, in one streaming pass of block FFTs over the record.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | R_k | `lag(k)` | E[y(t + k) ŷ(t)ᵀ], channels × reference channels |
//! | L | `segment` | samples a segment (streaming_sums.rs) |
//! | S | `starts` | number of start times t, the same for every lag |
//!
//! Correlations for any other window of the same record follow from these and its end samples ([`Ends`]): no product is summed twice.

use super::ModalError;
use super::products::Pairs;
use super::streaming_sums::StreamingSums;
use crate::numeric::inner;
use crate::signal::Record;
use pulp::{Arch, Simd, WithSimd};
use std::f64::consts::PI;

/// Shorter segments make the FFT inefficient.
const SEGMENT_LEAST: usize = 512;
/// Zero crossings of the anti-alias filter on each side: with Blackman's window its transition band is 0.83 to 1.17 of the new Nyquist
/// frequency, and its stop-band attenuation is 74 dB (Oppenheim & Schafer, Discrete-Time Signal Processing, table 7.2).
const CROSSINGS: usize = 16;

/// Share of the Nyquist frequency that is free of aliases after [`Correlations::decimated`].
pub(crate) const CLEAN_SHARE: f64 = 0.8;

/// R_0 … R_K of the record; for each block of time also the deviation from the mean of all blocks.
#[derive(Clone, Debug)]
pub(crate) struct Correlations {
    pub(crate) channels: usize,
    /// The channels ŷ; all of them in their order, or some in any order.
    pub(crate) columns: Vec<usize>,
    /// Time from one lag to the next, s.
    pub(crate) step_s: f64,
    /// R_k of the whole record: lag after lag, each row by row.
    pub(crate) mean: Vec<f64>,
    /// Share of block j in the mean times (R_k of block j - mean); their sum is zero. In 32 bits: only standard deviations use them.
    pub(crate) deviations: Vec<Vec<f32>>,
    /// The samples at the ends, which other windows include or omit; `None` after decimation.
    pub(crate) ends: Option<Ends>,
    /// As `mean`, but for the record followed by zeros; only after decimation and on request. Matrices of these correlations are never
    /// indefinite.
    pub(crate) padded: Option<Vec<f64>>,
}

/// First and last samples of the record, means removed, sample after sample, `lags` of them each.
#[derive(Clone, Debug)]
pub(crate) struct Ends {
    /// y(t), t = 0 … K - 1.
    pub(crate) head: Vec<f64>,
    /// y(S + t), t = 0 … K - 1.
    pub(crate) tail: Vec<f64>,
    /// Number of start times, S.
    pub(crate) starts: usize,
}

/// Number of lags at the rate of the record for `lags` lags after decimation by `factor`.
pub(crate) fn lags_before(lags: usize, factor: usize) -> usize {
    if factor > 1 {
        (lags + CROSSINGS) * factor
    } else {
        lags
    }
}

/// Deviations in 64 bits, for computation.
pub(crate) fn wide(lags: &[f32]) -> Vec<f64> {
    lags.iter().map(|x| f64::from(*x)).collect()
}

/// Division of a record for one pass.
pub(crate) struct Windows {
    /// Number of start times, the same for every lag.
    pub(crate) starts: usize,
    /// Samples of a segment.
    pub(crate) segment: usize,
}

impl Windows {
    pub(crate) fn segments(&self) -> usize {
        self.starts.div_ceil(self.segment)
    }
}

/// Windows of a record, if it is long enough for this number of lags and blocks of time.
pub(crate) fn windows(record: &Record, lags: usize, blocks: usize) -> Result<Windows, ModalError> {
    let n = record.length();
    let starts = n.saturating_sub(lags);
    let fast = lags.max(SEGMENT_LEAST).next_power_of_two();
    let segment = fast.min(starts / blocks.max(1)); // a short record has short blocks: FFTs of any length
    if segment < lags.max(1) {
        return Err(ModalError::TooShort {
            samples: n,
            lags,
            blocks,
            needed: (blocks + 1) * lags,
        });
    }
    Ok(Windows { starts, segment })
}

/// Correlations for lags 0 to `lags` in `blocks` consecutive blocks of time.
///
/// ```text
/// R_k = 1/S Σ y(t + k) y(t)ᵀ,  t = 0 … S - 1,  S = samples - lags      shape: channels × channels
/// ```
/// Each lag sums over the same start times, so that all lags weigh the record equally. The mean of each channel is removed while reading;
/// the record is not copied.
#[cfg(test)]
pub(crate) fn correlate(record: &Record, lags: usize, blocks: usize) -> Result<Correlations, ModalError> {
    let all: Vec<usize> = (0..record.channels().len()).collect();
    correlate_decimated(record, (lags, blocks), (1, false), &all)
}

/// Correlations with the channels of `columns` after a low-pass filter and decimation by `factor`, for `lags` at the new rate, with `padded` on request.
///
/// ```text
/// R'_k = Σ h_m R_(factor k - m),   h_m = sinc(m / factor) / factor × Blackman's window
/// ```
/// h is the autocorrelation of the filter. It is zero at every multiple of `factor` except 0, so white sensor noise stays white and
/// affects only R_0. Each block of time is filtered when its sum is complete, so only one block is stored at the old rate.
pub(crate) fn correlate_decimated(
    record: &Record,
    (lags, blocks): (usize, usize),
    (factor, is_padded): (usize, bool),
    columns: &[usize],
) -> Result<Correlations, ModalError> {
    let (l, low_pass) = (record.channels().len(), &LowPass::new(factor));
    let factor = low_pass.factor;
    let columns: Vec<usize> = match columns.len() < l {
        true => columns.to_vec(),
        false => (0..l).collect(),
    };
    let before = lags_before(lags, factor);
    let windows = windows(record, before, blocks)?;
    let (starts, segment) = (windows.starts, windows.segment);
    let mut pass = StreamingSums::new(record, pairs_with(&columns, l, factor > 1), before, segment);
    let segments = windows.segments();
    let mut of_pairs = vec![0.0; (before + 1) * l * l];
    let mut mean = vec![0.0; (lags + 1) * l * columns.len()];
    // the first block replaces the mean until that is known, so that 32 bits store only differences
    let mut first: Vec<f64> = Vec::new();
    let mut parts: Vec<(f64, Vec<f32>)> = Vec::with_capacity(blocks);
    for j in 0..blocks {
        let range = j * segments / blocks..(j + 1) * segments / blocks;
        let count = ((range.end * segment).min(starts) - range.start * segment) as f64;
        pass.block(range, starts, |[a, b], of_pair| {
            let at = (a * l + b) * (before + 1);
            of_pairs[at..=at + before].copy_from_slice(of_pair);
        });
        let sum = low_pass.lowered(&of_pairs, (l, &columns), [before, lags]);
        if first.is_empty() {
            first = sum.iter().map(|s| s / count).collect();
        }
        let part = sum.iter().zip(&first).map(|(s, f)| (s - count * f) as f32);
        parts.push((count, part.collect()));
        mean.iter_mut().zip(&sum).for_each(|(m, s)| *m += s);
    }
    mean.iter_mut().for_each(|m| *m /= starts as f64);
    first.iter_mut().zip(&mean).for_each(|(f, m)| *f = m - *f);
    let deviation = |(count, mut part): (f64, Vec<f32>)| {
        for (d, late) in part.iter_mut().zip(&first) {
            *d = ((f64::from(*d) - count * late) / starts as f64) as f32;
        }
        part
    };
    let deviations = parts.into_iter().map(deviation).collect();
    let ends = |count: usize| Ends {
        head: pass.samples(0..count),
        tail: pass.samples(starts..starts + count),
        starts,
    };
    let padded = (factor > 1 && is_padded).then(|| {
        ends(before).products(l, before, &mut of_pairs);
        let more = low_pass.lowered(&of_pairs, (l, &columns), [before, lags]);
        mean.iter().zip(more).map(|(m, more)| m + more).collect()
    });
    Ok(Correlations {
        channels: l,
        columns,
        step_s: factor as f64 / record.sampling_rate_hz(),
        deviations,
        ends: (factor == 1).then(|| ends(lags)),
        padded,
        mean,
    })
}

/// The channels, those of `columns` first, and the pairs to sum; with the filter also the columns after all channels, for its negative lags.
fn pairs_with(columns: &[usize], l: usize, is_filtered: bool) -> (Vec<usize>, Vec<Pairs>) {
    let n = columns.len();
    let others = (0..l).filter(|c| !columns.contains(c));
    let order = columns.iter().copied().chain(others).collect();
    let mut pairs = vec![Pairs {
        rows: 0..l,
        columns: 0..n,
    }];
    if is_filtered && n < l {
        pairs.push(Pairs {
            rows: 0..n,
            columns: n..l,
        });
    }
    (order, pairs)
}

impl Ends {
    /// Sums of products over the start times, divided for the mean of `lags` lags, one channel pair after the other.
    fn products(&self, l: usize, lags: usize, of_pairs: &mut [f64]) {
        let share = 1.0 / self.starts as f64;
        let tail = |c: usize| -> Vec<f64> { self.tail[c..].iter().step_by(l).copied().collect() };
        let tails: Vec<Vec<f64>> = (0..l).map(tail).collect();
        for (pair, sums) in of_pairs.chunks_exact_mut(lags + 1).enumerate() {
            let (late, early) = (&tails[pair / l], &tails[pair % l]);
            for (k, sum) in sums.iter_mut().enumerate() {
                *sum = share * inner(&late[k..], &early[..early.len() - k]);
            }
        }
    }
}

/// Number of channel pairs filtered together: two or more vector registers on every processor.
const PAIRS: usize = 16;

struct LowPass {
    factor: usize,
    /// h from -reach to reach, with sum 1.
    weights: Vec<f64>,
}

impl LowPass {
    /// A factor of 0 or 1 has no effect.
    fn new(factor: usize) -> Self {
        if factor <= 1 {
            return LowPass {
                factor: 1,
                weights: vec![1.0],
            };
        }
        let reach = CROSSINGS * factor;
        let h: Vec<f64> = (0..=reach).map(|m| filter(m, factor, reach)).collect();
        let gain = h[0] + 2.0 * h[1..].iter().sum::<f64>();
        LowPass {
            factor,
            weights: (0..=2 * reach).map(|m| h[m.abs_diff(reach)] / gain).collect(),
        }
    }

    /// Converts lags 0 to `before`, one channel pair after the other, to lags 0 to `lags` at the new rate, one lag after the other.
    fn lowered(
        &self,
        of_pairs: &[f64],
        (l, columns): (usize, &[usize]),
        [before, lags]: [usize; 2],
    ) -> Vec<f64> {
        let (reach, n) = (self.weights.len() / 2, columns.len());
        let mut out = vec![0.0; (lags + 1) * l * n];
        let mut along = vec![[0.0; PAIRS]; reach + before + 1];
        for from in (0..l * n).step_by(PAIRS) {
            let pairs = from..(from + PAIRS).min(l * n);
            for pair in pairs.clone() {
                let of = |a: usize, b: usize| &of_pairs[(a * l + b) * (before + 1)..][..before + 1];
                let (a, b) = (pair / n, columns[pair % n]);
                let turned = of(b, a); // R_-k = R_kᵀ
                let late = turned[1..=reach.min(before)].iter().rev().chain(of(a, b));
                for (along, r) in along.iter_mut().zip(late) {
                    along[pair - from] = *r;
                }
            }
            let columns = out.chunks_exact_mut(l * n).map(|lag| &mut lag[pairs.clone()]);
            Arch::new().dispatch(Filtered {
                along: &along,
                weights: &self.weights,
                factor: self.factor,
                columns,
            });
        }
        out
    }
}

/// The filtered columns; each starts at its own lag.
struct Filtered<'a, C> {
    along: &'a [[f64; PAIRS]],
    weights: &'a [f64],
    factor: usize,
    columns: C,
}

impl<'a, C: Iterator<Item = &'a mut [f64]>> WithSimd for Filtered<'_, C> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, _: S) {
        for (k, column) in self.columns.enumerate() {
            let mut sum = [0.0; PAIRS];
            for (weight, along) in self.weights.iter().zip(&self.along[k * self.factor..]) {
                for (sum, r) in sum.iter_mut().zip(along) {
                    *sum += weight * r;
                }
            }
            for (x, sum) in column.iter_mut().zip(sum) {
                *x = sum;
            }
        }
    }
}

impl Correlations {
    /// R_k, row by row.
    pub(crate) fn lag(&self, k: usize) -> &[f64] {
        let size = self.channels * self.columns.len();
        &self.mean[k * size..(k + 1) * size]
    }

    /// Places of channels among the columns.
    pub(crate) fn places(&self, channels: &[usize]) -> Vec<usize> {
        let place = |c: &usize| self.columns.iter().position(|column| column == c);
        channels.iter().filter_map(place).collect()
    }

    /// The correlations of all channels with all channels, with the channels in another order, each times its sign.
    pub(crate) fn arranged(&self, order: &[usize], signs: &[f64]) -> Correlations {
        let l = self.channels;
        let places: Vec<(f64, usize)> = (0..l * l)
            .map(|at| (at / l, at % l))
            .map(|(i, j)| (signs[i] * signs[j], order[i] * l + order[j]))
            .collect();
        let pairs = |lags: &Vec<f64>| -> Vec<f64> {
            let of_lag =
                |lag: &[f64]| -> Vec<f64> { places.iter().map(|(sign, at)| sign * lag[*at]).collect() };
            lags.chunks_exact(l * l).flat_map(of_lag).collect()
        };
        let deviations = self.deviations.iter().map(|lags| {
            let of_lag = |lag: &[f32]| -> Vec<f32> {
                places.iter().map(|(sign, at)| *sign as f32 * lag[*at]).collect()
            };
            lags.chunks_exact(l * l).flat_map(of_lag).collect()
        });
        let samples = |all: &Vec<f64>| -> Vec<f64> {
            let of_sample = |y: &[f64]| -> Vec<f64> { (0..l).map(|i| signs[i] * y[order[i]]).collect() };
            all.chunks_exact(l).flat_map(of_sample).collect()
        };
        Correlations {
            mean: pairs(&self.mean),
            deviations: deviations.collect(),
            ends: self.ends.as_ref().map(|ends| Ends {
                head: samples(&ends.head),
                tail: samples(&ends.tail),
                starts: ends.starts,
            }),
            padded: self.padded.as_ref().map(pairs),
            columns: self.columns.clone(),
            ..*self
        }
    }
}

fn filter(m: usize, factor: usize, reach: usize) -> f64 {
    if m == 0 {
        return 1.0;
    }
    if m.is_multiple_of(factor) {
        return 0.0;
    }
    let x = PI * m as f64 / factor as f64;
    let turn = PI * m as f64 / reach as f64;
    let blackman = 0.42 + 0.5 * turn.cos() + 0.08 * (2.0 * turn).cos();
    x.sin() / x * blackman
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use crate::signal::Channel;

    fn noise(channels: usize, length: usize) -> Record {
        let mut random = Random::new(7, 0);
        let samples = (0..channels * length).map(|_| random.normal()).collect();
        let names = (0..channels).map(|c| Channel::named(format!("{c}"))).collect();
        Record::from_contiguous(names, samples, 10.0).unwrap()
    }

    #[test]
    fn exact_sums_of_products_lag_by_lag() {
        let record = noise(3, 3001);
        let (lags, blocks) = (37, 4);
        let r = correlate(&record, lags, blocks).unwrap();
        let starts = record.length() - lags;
        let centred: Vec<Vec<f64>> = (0..3)
            .map(|c| {
                let y = record.samples(c);
                let mean = y.iter().sum::<f64>() / y.len() as f64;
                y.iter().map(|y| y - mean).collect()
            })
            .collect();
        for k in [0, 1, 20, lags] {
            for (a, b) in [(0, 0), (0, 2), (2, 1)] {
                let sum: f64 = (0..starts).map(|t| centred[a][t + k] * centred[b][t]).sum();
                let found = r.lag(k)[a * 3 + b];
                assert!((found - sum / starts as f64).abs() < 1e-13, "lag {k}: {found}");
            }
        }
        // six segments of 512 samples in four blocks
        let deviation = |k: usize, [from, to]: [usize; 2]| {
            let product = |t: usize| centred[2][t + k] * centred[1][t];
            let whole: f64 = (0..starts).map(product).sum();
            let own: f64 = (from..to).map(product).sum();
            (own - (to - from) as f64 * whole / starts as f64) / starts as f64
        };
        let segments = starts.div_ceil(512);
        for (j, found) in r.deviations.iter().enumerate() {
            let span = [j, j + 1].map(|j| (j * segments / blocks * 512).min(starts));
            for k in [0, 1, 20, lags] {
                let (found, exact) = (f64::from(found[k * 9 + 7]), deviation(k, span));
                assert!((found - exact).abs() < 1e-9, "{j} {k}: {found} {exact}"); // of 32 bits
            }
        }
        for at in 0..r.mean.len() {
            let sum: f64 = r.deviations.iter().map(|d| f64::from(d[at])).sum();
            assert!(sum.abs() < 1e-8);
        }
    }

    #[test]
    fn exact_filter_of_all_lags_of_more_pairs_than_are_filtered_at_once() {
        let (l, factor, lags) = (5, 3, 8);
        let record = noise(l, 3001);
        let before = lags_before(lags, factor);
        let (r, found) = (
            correlate(&record, before, 4).unwrap(),
            correlate_decimated(&record, (lags, 4), (factor, true), &[0, 1, 2, 3, 4]).unwrap(),
        );
        assert!((found.step_s - 0.3).abs() < 1e-15 && found.ends.is_none());
        let reach = (CROSSINGS * factor) as isize;
        let h = |m: isize| filter(m.unsigned_abs(), factor, CROSSINGS * factor);
        let gain: f64 = (-reach..=reach).map(h).sum();
        let filtered = |at: &dyn Fn(usize, usize, usize) -> f64, [k, a, b]: [usize; 3]| -> f64 {
            let term = |m: isize| match (k * factor) as isize - m {
                late if late >= 0 => h(m) * at(late as usize, a, b),
                early => h(m) * at(early.unsigned_abs(), b, a),
            };
            (-reach..=reach).map(term).sum::<f64>() / gain
        };
        let starts = record.length() - before;
        let means: Vec<f64> = (0..l)
            .map(|c| record.samples(c).iter().sum::<f64>() / 3001.0)
            .collect();
        let padded = |k: usize, a: usize, b: usize| {
            let product =
                |t: usize| (record.samples(a)[t + k] - means[a]) * (record.samples(b)[t] - means[b]);
            (0..3001 - k).map(product).sum::<f64>() / starts as f64
        };
        for [k, a, b] in [[0, 0, 0], [0, 4, 1], [1, 1, 4], [8, 3, 2], [8, 4, 4]] {
            let at = (k * l + a) * l + b;
            let exact = filtered(&|k, a, b| r.lag(k)[a * l + b], [k, a, b]);
            assert!(
                (found.mean[at] - exact).abs() < 1e-14,
                "{k}: {} {exact}",
                found.mean[at]
            );
            let exact = filtered(&padded, [k, a, b]);
            let with_zeros = found.padded.as_ref().unwrap()[at];
            assert!((with_zeros - exact).abs() < 1e-13, "{k}: {with_zeros} {exact}");
        }
    }

    #[test]
    fn exact_columns_of_some_channels_are_those_of_all() {
        let (l, lags) = (5, 8);
        let record = noise(l, 3001);
        for factor in [1, 3] {
            let of =
                |columns: &[usize]| correlate_decimated(&record, (lags, 4), (factor, true), columns).unwrap();
            let (all, some) = (of(&[0, 1, 2, 3, 4]), of(&[3, 1]));
            assert_eq!((some.places(&[1, 3]), some.places(&[3])), (vec![1, 0], vec![0]));
            let near = |part: &[f64], whole: &[f64]| {
                let mut each = part.chunks_exact(2).zip(whole.chunks_exact(l));
                each.all(|(part, whole)| {
                    (part[0] - whole[3]).abs() < 1e-14 && (part[1] - whole[1]).abs() < 1e-14
                })
            };
            assert!(near(&some.mean, &all.mean));
            assert_eq!((some.mean.len(), some.lag(1).len()), ((lags + 1) * l * 2, l * 2));
            for (some, all) in some.deviations.iter().zip(&all.deviations) {
                assert!(near(&wide(some), &wide(all)));
            }
            if let (Some(some), Some(all)) = (&some.padded, &all.padded) {
                assert!(near(some, all));
            }
        }
    }

    #[test]
    fn holds_decimation_keeps_a_slow_motion_and_white_noise_white() {
        let (n, factor, frequency_hz) = (20_000, 5, 0.3);
        let wave = (0..n)
            .map(|t| (2.0 * PI * frequency_hz * t as f64 / 10.0).sin())
            .collect();
        let record = Record::from_contiguous(vec![Channel::named("wave")], wave, 10.0).unwrap();
        let slow = correlate_decimated(&record, (8, 4), (factor, false), &[0]).unwrap();
        assert_eq!(slow.mean.len(), 9);
        for k in 0..=8 {
            let exact = 0.5 * (2.0 * PI * frequency_hz * k as f64 * slow.step_s).cos();
            assert!(
                (slow.lag(k)[0] - exact).abs() < 1e-3,
                "lag {k}: {} {exact}",
                slow.lag(k)[0]
            );
        }
    }
}
