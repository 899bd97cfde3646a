//! Correlations of all channels with all channels, in one streaming pass of block FFTs over the record.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | R_k | `lag(k)` | E[y(t + k) y(t)ᵀ], channels × channels |
//! | L | `segment` | samples a segment (streaming_sums.rs) |
//! | S | `starts` | number of start times t, the same for every lag |
//!
//! Any other window of the same record follows from these by displacement ([`Ends`]): no product is summed twice.

use super::ModalError;
use super::streaming_sums::StreamingSums;
use crate::signal::Record;
use std::f64::consts::PI;

/// Segments shorter than this waste the FFT on its overhead.
const SEGMENT_LEAST: usize = 512;
/// Zero crossings of the anti-alias filter on each side: with Blackman's window its transition is 0.83 to 1.17 of
/// the new Nyquist frequency, and 74 dB are stopped (Oppenheim & Schafer, Discrete-Time Signal Processing, table 7.2).
const CROSSINGS: usize = 16;

/// Share of the Nyquist frequency that is free of aliases after [`Correlations::decimated`].
pub(crate) const CLEAN_SHARE: f64 = 0.8;

/// R_0 … R_K, and the same of each time block less the mean of all blocks.
#[derive(Clone, Debug)]
pub(crate) struct Correlations {
    pub(crate) channels: usize,
    /// Largest lag K.
    pub(crate) lags: usize,
    /// Time from one lag to the next, s.
    pub(crate) step_s: f64,
    /// R_k of the whole record: lag after lag, each row by row.
    pub(crate) mean: Vec<f64>,
    /// Share of block j in the mean times (R_k of block j - mean): they sum to zero.
    pub(crate) deviations: Vec<Vec<f64>>,
    /// The samples that windows other than this one gain or lose; `None` after decimation.
    pub(crate) ends: Option<Ends>,
    /// After decimation: the same as `mean` of the record with zeros behind it. Matrices of these are never indefinite.
    pub(crate) padded: Option<Vec<f64>>,
}

/// First and last samples of the record, means removed, sample after sample, `lags` of them each.
#[derive(Clone, Debug)]
pub(crate) struct Ends {
    /// y(t), t = 0 … K - 1.
    pub(crate) head: Vec<f64>,
    /// y(S + t), t = 0 … K - 1.
    pub(crate) tail: Vec<f64>,
    /// Start times S.
    pub(crate) starts: usize,
}

/// Lags needed at the rate of the record to have `lags` of them after decimation by `factor`.
pub(crate) fn lags_before(lags: usize, factor: usize) -> usize {
    if factor > 1 {
        (lags + CROSSINGS) * factor
    } else {
        lags
    }
}

/// How a record is cut for one pass over it.
pub(crate) struct Windows {
    /// Start times, the same for every lag.
    pub(crate) starts: usize,
    /// Samples a segment.
    pub(crate) segment: usize,
}

impl Windows {
    pub(crate) fn segments(&self) -> usize {
        self.starts.div_ceil(self.segment)
    }
}

/// Of a record long enough for so many lags in so many blocks of time.
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
/// Each lag sums over the same start times, so that all lags weigh the record alike. The mean of each channel is
/// removed while reading; the record is not copied.
pub(crate) fn correlate(record: &Record, lags: usize, blocks: usize) -> Result<Correlations, ModalError> {
    let l = record.channels().len();
    let windows = windows(record, lags, blocks)?;
    let (starts, segment) = (windows.starts, windows.segment);
    let mut pass = StreamingSums::new(record, 0..l, lags, segment);
    let segments = windows.segments();
    let mut sums: Vec<(usize, Vec<f64>)> = Vec::with_capacity(blocks);
    for j in 0..blocks {
        let range = j * segments / blocks..(j + 1) * segments / blocks;
        let count = (range.end * segment).min(starts) - range.start * segment;
        let mut sum = vec![0.0; (lags + 1) * l * l];
        pass.block(range, starts, |[a, b], of_pair| {
            for (of_lag, t) in sum.chunks_exact_mut(l * l).zip(of_pair) {
                of_lag[a * l + b] = *t;
            }
        });
        sums.push((count, sum));
    }
    let size = (lags + 1) * l * l;
    let mut mean = vec![0.0; size];
    for (_, sum) in &sums {
        for (m, s) in mean.iter_mut().zip(sum) {
            *m += s;
        }
    }
    mean.iter_mut().for_each(|m| *m /= starts as f64);
    let deviations = sums
        .into_iter()
        .map(|(count, mut sum)| {
            for (s, m) in sum.iter_mut().zip(&mean) {
                *s = (*s - count as f64 * m) / starts as f64;
            }
            sum
        })
        .collect();
    Ok(Correlations {
        channels: l,
        lags,
        step_s: 1.0 / record.sampling_rate_hz(),
        mean,
        deviations,
        ends: Some(Ends {
            head: pass.samples(0..lags),
            tail: pass.samples(starts..starts + lags),
            starts,
        }),
        padded: None,
    })
}

impl Correlations {
    /// R_k, row by row.
    pub(crate) fn lag(&self, k: usize) -> &[f64] {
        let size = self.channels * self.channels;
        &self.mean[k * size..(k + 1) * size]
    }

    /// Of the channels in another order, each times its sign.
    pub(crate) fn arranged(&self, order: &[usize], signs: &[f64]) -> Correlations {
        let l = self.channels;
        let pairs = |lags: &Vec<f64>| -> Vec<f64> {
            let of_lag = |lag: &[f64]| -> Vec<f64> {
                let places = (0..l * l).map(|at| (at / l, at % l));
                places
                    .map(|(i, j)| signs[i] * signs[j] * lag[order[i] * l + order[j]])
                    .collect()
            };
            lags.chunks_exact(l * l).flat_map(of_lag).collect()
        };
        let samples = |all: &Vec<f64>| -> Vec<f64> {
            let of_sample = |y: &[f64]| -> Vec<f64> { (0..l).map(|i| signs[i] * y[order[i]]).collect() };
            all.chunks_exact(l).flat_map(of_sample).collect()
        };
        Correlations {
            mean: pairs(&self.mean),
            deviations: self.deviations.iter().map(pairs).collect(),
            ends: self.ends.as_ref().map(|ends| Ends {
                head: samples(&ends.head),
                tail: samples(&ends.tail),
                starts: ends.starts,
            }),
            padded: self.padded.as_ref().map(pairs),
            ..*self
        }
    }

    /// Lags of the record with zeros behind it: start times up to the last that has an end, over the same S.
    fn padded(&self) -> Option<Vec<f64>> {
        let (l, ends) = (self.channels, self.ends.as_ref()?);
        let share = 1.0 / ends.starts as f64;
        let tail: Vec<&[f64]> = ends.tail.chunks_exact(l).collect();
        let mut padded = self.mean.clone();
        for (k, sum) in padded.chunks_exact_mut(l * l).enumerate() {
            for (late, early) in tail.iter().skip(k).zip(&tail) {
                for (row, a) in sum.chunks_exact_mut(l).zip(*late) {
                    for (x, b) in row.iter_mut().zip(*early) {
                        *x += share * a * b;
                    }
                }
            }
        }
        Some(padded)
    }

    /// Correlations of the record after a low-pass filter and decimation by `factor`, from those before it.
    ///
    /// ```text
    /// R'_k = Σ h_m R_(factor k - m),   h_m = sinc(m / factor) / factor × Blackman's window
    /// ```
    /// h is the correlation of the filter's own response. It is zero at every multiple of `factor` but 0: white
    /// sensor noise stays white, in R_0 alone.
    pub(crate) fn decimated(self, factor: usize) -> Correlations {
        if factor <= 1 {
            return self;
        }
        let reach = CROSSINGS * factor;
        let lags = (self.lags / factor).saturating_sub(CROSSINGS);
        let h: Vec<f64> = (0..=reach).map(|m| filter(m, factor, reach)).collect();
        let gain = h[0] + 2.0 * h[1..].iter().sum::<f64>();
        let reduce = |r: &[f64]| {
            let l = self.channels;
            let mut out = vec![0.0; (lags + 1) * l * l];
            for (k, target) in out.chunks_exact_mut(l * l).enumerate() {
                for m in 0..=2 * reach {
                    let weight = h[m.abs_diff(reach)] / gain;
                    let at = (k * factor + m) as isize - reach as isize;
                    let from = &r[at.unsigned_abs() * l * l..(at.unsigned_abs() + 1) * l * l];
                    if at >= 0 {
                        for (t, x) in target.iter_mut().zip(from) {
                            *t += weight * x;
                        }
                    } else {
                        for (i, t) in target.iter_mut().enumerate() {
                            *t += weight * from[(i % l) * l + i / l]; // R_-k = R_kᵀ
                        }
                    }
                }
            }
            out
        };
        Correlations {
            channels: self.channels,
            lags,
            step_s: self.step_s * factor as f64,
            mean: reduce(&self.mean),
            deviations: self.deviations.iter().map(|d| reduce(d)).collect(),
            ends: None,
            padded: self.padded().map(|padded| reduce(&padded)),
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
        for at in 0..r.mean.len() {
            let sum: f64 = r.deviations.iter().map(|d| d[at]).sum();
            assert!(sum.abs() < 1e-13);
        }
    }

    #[test]
    fn holds_decimation_keeps_a_slow_motion_and_white_noise_white() {
        let (n, factor, frequency_hz) = (20_000, 5, 0.3);
        let wave = (0..n)
            .map(|t| (2.0 * PI * frequency_hz * t as f64 / 10.0).sin())
            .collect();
        let record = Record::from_contiguous(vec![Channel::named("wave")], wave, 10.0).unwrap();
        let slow = correlate(&record, lags_before(8, factor), 4)
            .unwrap()
            .decimated(factor);
        assert_eq!(slow.lags, 8);
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
