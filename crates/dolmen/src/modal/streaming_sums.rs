//! One streaming pass over a record: sums of products over the start times of whole segments, from their spectra.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | L | `segment` | samples a segment; each FFT holds 2L |
//! | | `rows` | channels whose products with all channels are summed in this pass |
//! | | `groups` | groups of bins that lie together |

use super::products::{Bins, Segments, WIDTH, add_products};
use crate::signal::Record;
use realfft::RealFftPlanner;
use std::ops::Range;

/// Segments whose spectra are multiplied in one go: their part of one group of bins, of 32 channels, stays in the second cache. Fewer where
/// their spectra would take more memory than this.
const SEGMENTS_AT_ONCE: usize = 16;
const SPECTRA_BYTES: usize = 1 << 24;

pub(super) struct StreamingSums<'a> {
    reader: Reader<'a>,
    inverse: std::sync::Arc<dyn realfft::ComplexToReal<f64>>,
    rows: Range<usize>,
    lags: usize,
    segment: usize,
    /// Start of the segment whose spectra are stored in `kept` for the next step, if there is one.
    kept_from: Option<usize>,
    kept: Vec<Bins>,
    next: Vec<Bins>,
    ahead: Vec<Bins>,
    future: Segments,
    past: Segments,
    sums: Vec<Bins>,
}

impl<'a> StreamingSums<'a> {
    /// Sums of these channels with all channels.
    pub(super) fn new(record: &'a Record, rows: Range<usize>, lags: usize, segment: usize) -> Self {
        let mut planner = RealFftPlanner::new();
        let forward = planner.plan_fft_forward(2 * segment);
        let inverse = planner.plan_fft_inverse(2 * segment);
        let l = record.channels().len();
        let means = (0..l)
            .map(|c| record.samples(c).iter().sum::<f64>() / record.length() as f64)
            .collect();
        let groups = (segment + 1).div_ceil(WIDTH);
        let spectra = vec![Bins::default(); l * groups];
        let bytes = l * groups * size_of::<Bins>();
        let at_once = (SPECTRA_BYTES / bytes).clamp(2, SEGMENTS_AT_ONCE);
        let scratch = forward.get_scratch_len().max(inverse.get_scratch_len());
        StreamingSums {
            reader: Reader {
                record,
                means,
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
            future: Segments::new(rows.len(), groups, at_once),
            past: Segments::new(l, groups, at_once),
            sums: vec![Bins::default(); rows.len() * l * groups],
            rows,
        }
    }

    /// Sums of other rows, in the same memory.
    pub(super) fn turned_to(mut self, rows: Range<usize>) -> Self {
        if rows.len() != self.rows.len() {
            let groups = (self.segment + 1).div_ceil(WIDTH);
            self.future = Segments::new(rows.len(), groups, self.past.most());
            self.sums
                .resize(rows.len() * self.reader.means.len() * groups, Bins::default());
        }
        self.rows = rows;
        self
    }

    /// The samples in `range`, means removed, sample after sample.
    pub(super) fn samples(&self, range: Range<usize>) -> Vec<f64> {
        let Reader { record, means, .. } = &self.reader;
        let sample = |t: usize| (0..means.len()).map(move |c| record.samples(c)[t] - means[c]);
        range.flat_map(sample).collect()
    }

    /// Σ y(t + k) y(t)ᵀ over the start times of the given segments: each pair of channels and its lags go to `use_it`.
    pub(super) fn block(
        &mut self,
        segments: Range<usize>,
        starts: usize,
        use_it: impl FnMut([usize; 2], &mut [f64]),
    ) {
        let (step, rows) = (self.segment, self.rows.clone());
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
            self.past.push(&self.kept, 0..self.reader.means.len());
            std::mem::swap(&mut self.kept, &mut self.next);
            self.kept_from = Some(from + step);
            if self.future.is_full() || i + 1 == last {
                add_products(&mut self.sums, &self.future, &self.past);
                self.future.clear();
                self.past.clear();
            }
        }
        self.each_pair(use_it);
    }

    fn each_pair(&mut self, mut use_it: impl FnMut([usize; 2], &mut [f64])) {
        let l = self.reader.means.len();
        let Reader {
            bins, time, scratch, ..
        } = &mut self.reader;
        let pairs = self.rows.len() * l;
        let share = 1.0 / (2 * self.segment) as f64;
        for pair in 0..pairs {
            let groups = self.sums.chunks_exact(pairs);
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
            use_it([self.rows.start + pair / l, pair % l], lags);
        }
    }
}

/// Makes spectra of the record.
struct Reader<'a> {
    record: &'a Record,
    means: Vec<f64>,
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
        for (c, mean) in self.means.iter().enumerate() {
            let (head, tail) = self.time.split_at_mut(range.len());
            for (t, y) in head.iter_mut().zip(&self.record.samples(c)[range.clone()]) {
                *t = y - mean;
            }
            tail.fill(0.0);
            // the buffers come from the plan itself: their lengths fit, so this cannot fail
            let _ = self
                .forward
                .process_with_scratch(&mut self.time, &mut self.bins, &mut self.scratch);
            for (group, bins) in out.chunks_exact_mut(l).zip(self.bins.chunks(WIDTH)) {
                for ((re, im), z) in group[c].re.iter_mut().zip(&mut group[c].im).zip(bins) {
                    (*re, *im) = (z.re, z.im);
                }
            }
        }
    }
}
