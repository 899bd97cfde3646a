//! Products of the spectra of all channels with all channels, summed over segments.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | F, P | `future`, `past` | spectra of segments | rows, channels a bin and segment |
//! | Σ F P* | `sums` | summed over segments | rows × channels a bin |
//!
//! Eight bins of one channel lie together; of each group of bins the segments, and of each segment the channels: four pairs of channels
//! are summed over all segments in registers, and each sum is read and written once for all of them. Only the pairs of given
//! rectangles are summed.

use pulp::{Arch, Simd, WithSimd};
use std::ops::Range;

/// Number of bins stored together: full registers on every processor, and one cache line.
pub(super) const WIDTH: usize = 8;

/// Bins of one channel, aligned because a register that crosses two cache lines needs two loads.
#[derive(Clone, Copy, Debug, Default)]
#[repr(C, align(64))]
pub(super) struct Bins {
    pub(super) re: [f64; WIDTH],
    pub(super) im: [f64; WIDTH],
}

/// Pairs of channels: each of the rows with each of the columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct Pairs {
    pub(super) rows: Range<usize>,
    pub(super) columns: Range<usize>,
}

impl Pairs {
    pub(super) fn count(&self) -> usize {
        self.rows.len() * self.columns.len()
    }
}

/// Spectra of a few segments.
pub(super) struct Segments {
    channels: usize,
    /// Largest number of segments, and number of segments stored.
    most: usize,
    held: usize,
    bins: Vec<Bins>,
}

impl Segments {
    pub(super) fn new(channels: usize, groups: usize, most: usize) -> Self {
        Segments {
            channels,
            most,
            held: 0,
            bins: vec![Bins::default(); channels * groups * most],
        }
    }

    /// Capacity in segments.
    pub(super) fn most(&self) -> usize {
        self.most
    }

    pub(super) fn is_full(&self) -> bool {
        self.held == self.most
    }

    pub(super) fn clear(&mut self) {
        self.held = 0;
    }

    /// Adds the next segment: the spectra of all channels, group by group; only the channels `of` are stored.
    pub(super) fn push(&mut self, spectra: &[Bins], of: Range<usize>) {
        let all = self.all(spectra);
        for (group, from) in self.next().zip(spectra.chunks_exact(all)) {
            group.copy_from_slice(&from[of.clone()]);
        }
        self.held += 1;
    }

    /// Number of channels in all groups of these spectra.
    fn all(&self, spectra: &[Bins]) -> usize {
        spectra.len() / (self.bins.len() / (self.most * self.channels))
    }

    /// Adds the sum of two consecutive segments. The shift by half the FFT length is a factor (-1)^bin; groups begin at even bins.
    pub(super) fn push_shifted_sum(&mut self, past: &[Bins], next: &[Bins], of: Range<usize>) {
        let all = self.all(past);
        let both = past.chunks_exact(all).zip(next.chunks_exact(all));
        for (group, (past, next)) in self.next().zip(both) {
            let both = past[of.clone()].iter().zip(&next[of.clone()]);
            for (sum, (past, next)) in group.iter_mut().zip(both) {
                shifted_sum(&mut sum.re, &past.re, &next.re);
                shifted_sum(&mut sum.im, &past.im, &next.im);
            }
        }
        self.held += 1;
    }

    /// Memory of the next segment, group by group.
    fn next(&mut self) -> impl Iterator<Item = &mut [Bins]> {
        let (l, at) = (self.channels, self.held * self.channels);
        self.bins
            .chunks_exact_mut(self.most * l)
            .map(move |group| &mut group[at..at + l])
    }

    fn groups(&self) -> impl Iterator<Item = &[Bins]> {
        let whole = self.most * self.channels;
        self.bins
            .chunks_exact(whole)
            .map(|g| &g[..self.held * self.channels])
    }
}

fn shifted_sum(sum: &mut [f64; WIDTH], past: &[f64; WIDTH], next: &[f64; WIDTH]) {
    let pairs = past.chunks_exact(2).zip(next.chunks_exact(2));
    for (pair, (past, next)) in sum.chunks_exact_mut(2).zip(pairs) {
        pair[0] = past[0] + next[0];
        pair[1] = past[1] - next[1];
    }
}

/// sums += Σ future × conj(past) over the segments, of the given pairs of stored channels: group after group, each rectangle row by row.
pub(super) fn add_products(sums: &mut [Bins], future: &Segments, past: &Segments, pairs: &[Pairs]) {
    Arch::new().dispatch(Products {
        sums,
        future,
        past,
        pairs,
    });
}

struct Products<'a> {
    sums: &'a mut [Bins],
    future: &'a Segments,
    past: &'a Segments,
    pairs: &'a [Pairs],
}

impl WithSimd for Products<'_> {
    type Output = ();

    #[inline(always)]
    fn with_simd<S: Simd>(self, simd: S) {
        let size = [self.future.channels, self.past.channels];
        let both = self.future.groups().zip(self.past.groups());
        let count = self.pairs.iter().map(Pairs::count).sum();
        for (mut sums, both) in self.sums.chunks_exact_mut(count).zip(both) {
            for Pairs { rows, columns } in self.pairs {
                let width = columns.len();
                let (own, rest) = sums.split_at_mut(rows.len() * width);
                for a in rows.clone().step_by(2) {
                    for b in columns.clone().step_by(2) {
                        let from = (a - rows.start) * width + b - columns.start;
                        let own = (&mut own[from..], width);
                        match (rows.end - a, columns.end - b) {
                            (1, 1) => tile::<S, 1, 1>(simd, own, both, [a, b], size),
                            (1, _) => tile::<S, 1, 2>(simd, own, both, [a, b], size),
                            (_, 1) => tile::<S, 2, 1>(simd, own, both, [a, b], size),
                            _ => tile::<S, 2, 2>(simd, own, both, [a, b], size),
                        }
                    }
                }
                sums = rest;
            }
        }
    }
}

/// Pairs of A channels, starting at `a`, with B channels, starting at `b`; their sums begin at the first of `sums`, rows `width` apart.
#[inline(always)]
fn tile<S: Simd, const A: usize, const B: usize>(
    simd: S,
    (sums, width): (&mut [Bins], usize),
    (future, past): (&[Bins], &[Bins]),
    [a, b]: [usize; 2],
    [rows, l]: [usize; 2],
) {
    for v in 0..WIDTH / S::F64_LANES {
        let part = |x: &Bins| [S::as_simd_f64s(&x.re).0[v], S::as_simd_f64s(&x.im).0[v]];
        let mut tile = [[[simd.splat_f64s(0.0); 2]; B]; A];
        for (f, p) in future.chunks_exact(rows).zip(past.chunks_exact(l)) {
            let (Some(f), Some(p)) = (f[a..].first_chunk::<A>(), p[b..].first_chunk::<B>()) else {
                continue;
            };
            let p = p.each_ref().map(part);
            for (row, [fr, fi]) in tile.iter_mut().zip(f.each_ref().map(part)) {
                let less_fr = simd.neg_f64s(fr);
                for ([re, im], [pr, pi]) in row.iter_mut().zip(p) {
                    *re = simd.mul_add_e_f64s(fr, pr, simd.mul_add_e_f64s(fi, pi, *re));
                    *im = simd.mul_add_e_f64s(fi, pr, simd.mul_add_e_f64s(less_fr, pi, *im));
                }
            }
        }
        for (i, row) in tile.into_iter().enumerate() {
            let at = i * width;
            for (sum, [re, im]) in sums[at..at + B].iter_mut().zip(row) {
                for (x, more) in [(&mut sum.re, re), (&mut sum.im, im)] {
                    let x = &mut S::as_mut_simd_f64s(x).0[v];
                    *x = simd.add_f64s(*x, more);
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;
    use dolmen_linalg::Complex64;

    #[test]
    fn exact_sums_of_products_of_odd_and_even_channels_by_hand() {
        for (l, groups, segments) in [(1, 1, 1), (3, 2, 5), (4, 1, 3)] {
            let mut random = Random::new(5, l as u64);
            let mut made = || -> Vec<Vec<Bins>> {
                let mut bins = || Bins {
                    re: [(); WIDTH].map(|()| random.normal()),
                    im: [(); WIDTH].map(|()| random.normal()),
                };
                (0..segments)
                    .map(|_| (0..l * groups).map(|_| bins()).collect())
                    .collect()
            };
            let (future, past) = (made(), made());
            let held = |all: &[Vec<Bins>], of: Range<usize>| {
                let mut held = Segments::new(of.len(), groups, segments + 1);
                all.iter().for_each(|one| held.push(one, of.clone()));
                held
            };
            let first = l / 3; // of three channels the last two are rows
            let rows = l - first;
            // two rectangles: all rows with the first channels, and the last row with the others
            let half = l.div_ceil(2);
            let pairs = [
                Pairs {
                    rows: 0..rows,
                    columns: 0..half,
                },
                Pairs {
                    rows: rows - 1..rows,
                    columns: half..l,
                },
            ];
            let of_pairs: Vec<[usize; 2]> = (pairs.iter())
                .flat_map(|of| of.rows.clone().map(move |a| (a, of.columns.clone())))
                .flat_map(|(a, columns)| columns.map(move |b| [first + a, b]))
                .collect();
            let mut sums = vec![Bins::default(); of_pairs.len() * groups];
            // twice: sums are added to
            for _ in 0..2 {
                add_products(&mut sums, &held(&future, first..l), &held(&past, 0..l), &pairs);
            }
            let z = |x: &Bins, k: usize| Complex64::new(x.re[k], x.im[k]);
            for (at, sum) in sums.iter().enumerate() {
                let (g, [a, b]) = (at / of_pairs.len(), of_pairs[at % of_pairs.len()]);
                for k in 0..WIDTH {
                    let pairs = future.iter().zip(&past);
                    let exact: Complex64 = pairs
                        .map(|(f, p)| 2.0 * z(&f[g * l + a], k) * z(&p[g * l + b], k).conj())
                        .sum();
                    assert!((z(sum, k) - exact).norm() < 1e-13, "{at} {k}");
                }
            }
        }
    }
}
