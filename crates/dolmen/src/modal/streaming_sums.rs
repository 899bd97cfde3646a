//! Sums of products over the start times of whole segments, from the spectra of the segments, in one pass over a record.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L | `segment` | samples a segment; each FFT holds 2L |
//! | | `pairs` | pairs of channels whose products are summed in this pass |
//! | | `order` | the channels of the record in the order in which the pairs count them |
//! | | `groups` | groups of bins that lie together |

use super::products::{Bins, Pairs, Segments, WIDTH, add_products};
use crate::signal::Record;
use realfft::RealFftPlanner;
use std::ops::Range;

/// Number of segments whose spectra are multiplied together, so that one group of bins of 32 channels stays in the second-level cache.
/// Fewer if their spectra need more memory than this.
const SEGMENTS_AT_ONCE: usize = 16;
const SPECTRA_BYTES: usize = 1 << 24;

pub(super) struct StreamingSums<'a> {
    reader: Reader<'a>,
    inverse: std::sync::Arc<dyn realfft::ComplexToReal<f64>>,
    pairs: Vec<Pairs>,
    /// Channels of the pairs in the future, and in the past.
    stored: [Range<usize>; 2],
    lags: usize,
    segment: usize,
    /// Start of the segment whose spectra `kept` holds for the next step, if any.
    kept_from: Option<usize>,
    kept: Vec<Bins>,
    next: Vec<Bins>,
    ahead: Vec<Bins>,
    future: Segments,
    past: Segments,
    sums: Vec<Bins>,
}

impl<'a> StreamingSums<'a> {
    /// Sums of these pairs of channels, counted in this order.
    pub(super) fn new(
        record: &'a Record,
        (order, pairs): (Vec<usize>, Vec<Pairs>),
        lags: usize,
        segment: usize,
    ) -> Self {
        let mut planner = RealFftPlanner::new();
        let forward = planner.plan_fft_forward(2 * segment);
        let inverse = planner.plan_fft_inverse(2 * segment);
        let l = record.channels().len();
        let means = (0..l).map(|c| record.mean(c)).collect();
        let groups = (segment + 1).div_ceil(WIDTH);
        let spectra = vec![Bins::default(); l * groups];
        let bytes = l * groups * size_of::<Bins>();
        let at_once = (SPECTRA_BYTES / bytes).clamp(2, SEGMENTS_AT_ONCE);
        let scratch = forward.get_scratch_len().max(inverse.get_scratch_len());
        let stored @ [future, past] = &stored(&pairs);
        let count: usize = pairs.iter().map(Pairs::count).sum();
        StreamingSums {
            reader: Reader {
                record,
                means,
                order,
                time: forward.make_input_vec(),
                bins: forward.make_output_vec(),
                scratch: vec![Default::default(); scratch],
                forward,
            },
            inverse,
            lags,
            segment,
            kept_from: None,
            kept: spectra.clone(),
            next: spectra.clone(),
            ahead: spectra,
            future: Segments::new(future.len(), groups, at_once),
            past: Segments::new(past.len(), groups, at_once),
            sums: vec![Bins::default(); count * groups],
            stored: stored.clone(),
            pairs,
        }
    }

    /// Sums of other pairs, with the same channels in the past, in the same memory.
    pub(super) fn turned_to(mut self, pairs: Vec<Pairs>) -> Self {
        let stored = stored(&pairs);
        let groups = (self.segment + 1).div_ceil(WIDTH);
        if stored[0].len() != self.stored[0].len() {
            self.future = Segments::new(stored[0].len(), groups, self.past.most());
        }
        let count: usize = pairs.iter().map(Pairs::count).sum();
        self.sums.resize(count * groups, Bins::default());
        (self.pairs, self.stored) = (pairs, stored);
        self
    }

    /// The samples in `range`, means removed, sample after sample.
    pub(super) fn samples(&self, range: Range<usize>) -> Vec<f64> {
        let Reader { record, means, .. } = &self.reader;
        let sample = |t: usize| (0..means.len()).map(move |c| record.samples(c)[t] - means[c]);
        range.flat_map(sample).collect()
    }

    /// Σ y(t + k) y(t)ᵀ over the start times of the given segments; `use_it` receives each pair of channels with its lags.
    pub(super) fn block(
        &mut self,
        segments: Range<usize>,
        starts: usize,
        use_it: impl FnMut([usize; 2], &mut [f64]),
    ) {
        let step = self.segment;
        let [rows, columns] = self.stored.clone();
        let within = |of: &Pairs| Pairs {
            rows: of.rows.start - rows.start..of.rows.end - rows.start,
            columns: of.columns.start - columns.start..of.columns.end - columns.start,
        };
        let pairs: Vec<Pairs> = self.pairs.iter().map(within).collect();
        self.sums.fill(Bins::default());
        let last = segments.end;
        for i in segments {
            let from = i * step;
            let whole = from + step <= starts;
            if self.kept_from != Some(from) || !whole {
                self.reader
                    .spectra(from..(from + step).min(starts), &mut self.kept);
            }
            self.reader.spectra(from + step..from + 2 * step, &mut self.next);
            if whole {
                self.future.push_shifted_sum(&self.kept, &self.next, rows.clone());
            } else {
                self.reader.spectra(from..from + 2 * step, &mut self.ahead);
                self.future.push(&self.ahead, rows.clone());
            }
            self.past.push(&self.kept, columns.clone());
            std::mem::swap(&mut self.kept, &mut self.next);
            self.kept_from = Some(from + step);
            if self.future.is_full() || i + 1 == last {
                add_products(&mut self.sums, &self.future, &self.past, &pairs);
                self.future.clear();
                self.past.clear();
            }
        }
        self.each_pair(use_it);
    }

    fn each_pair(&mut self, mut use_it: impl FnMut([usize; 2], &mut [f64])) {
        let Reader {
            bins,
            time,
            scratch,
            order,
            ..
        } = &mut self.reader;
        let all = self.pairs.iter().flat_map(|of| {
            let columns = || of.columns.clone();
            of.rows.clone().flat_map(move |a| columns().map(move |b| [a, b]))
        });
        let count = self.pairs.iter().map(Pairs::count).sum();
        let share = 1.0 / (2 * self.segment) as f64;
        for (pair, channels) in all.enumerate() {
            let groups = self.sums.chunks_exact(count);
            for (target, group) in bins.chunks_mut(WIDTH).zip(groups) {
                let sum = &group[pair];
                for ((z, re), im) in target.iter_mut().zip(&sum.re).zip(&sum.im) {
                    (z.re, z.im) = (*re, *im);
                }
            }
            bins[0].im = 0.0;
            bins[self.segment].im = 0.0;
            let _ = self.inverse.process_with_scratch(bins, time, scratch); // lengths are the plan's own
            let lags = &mut time[..=self.lags];
            lags.iter_mut().for_each(|t| *t *= share);
            use_it(channels.map(|c| order[c]), lags);
        }
    }
}

/// The channels between the first and the last of the rows, and of the columns.
fn stored(pairs: &[Pairs]) -> [Range<usize>; 2] {
    let hull = |of: fn(&Pairs) -> &Range<usize>| {
        let start = pairs.iter().map(|pairs| of(pairs).start).min().unwrap_or(0);
        start..pairs.iter().map(|pairs| of(pairs).end).max().unwrap_or(start)
    };
    [hull(|pairs| &pairs.rows), hull(|pairs| &pairs.columns)]
}

/// Makes spectra of the record.
struct Reader<'a> {
    record: &'a Record,
    means: Vec<f64>,
    order: Vec<usize>,
    forward: std::sync::Arc<dyn realfft::RealToComplex<f64>>,
    time: Vec<f64>,
    bins: Vec<realfft::num_complex::Complex<f64>>,
    scratch: Vec<realfft::num_complex::Complex<f64>>,
}

impl Reader<'_> {
    /// Spectra of the samples in `range`, means removed, padded with zeros to 2L: group after group of all channels.
    fn spectra(&mut self, range: Range<usize>, out: &mut [Bins]) {
        let l = self.means.len();
        let range = range.start.min(self.record.length())..range.end.min(self.record.length());
        for (at, c) in self.order.iter().enumerate() {
            let mean = self.means[*c];
            let (head, tail) = self.time.split_at_mut(range.len());
            for (t, y) in head.iter_mut().zip(&self.record.samples(*c)[range.clone()]) {
                *t = y - mean;
            }
            tail.fill(0.0);
            // the buffers have the required lengths
            let _ = self
                .forward
                .process_with_scratch(&mut self.time, &mut self.bins, &mut self.scratch);
            for (group, bins) in out.chunks_exact_mut(l).zip(self.bins.chunks(WIDTH)) {
                for ((re, im), z) in group[at].re.iter_mut().zip(&mut group[at].im).zip(bins) {
                    (*re, *im) = (z.re, z.im);
                }
            }
        }
    }
}
