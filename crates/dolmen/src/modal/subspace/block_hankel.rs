//! Products with a block Hankel matrix by FFT along its antidiagonals, without forming the matrix.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | R_k | `block(k)` | block on antidiagonal k - 1 | l × r |
//! | H | `BlockHankel` | block (i, j) is R_(i+j+1), i, j = 0 … br - 1 | l br × r br |
//! | R̂, X̂ | `bins`, `Transformed` | discrete Fourier transforms over k - 1, over the block rows of X | l × r, r × n per bin |
//! | P | `points` | points of each transform, at least 2 br - 1, so that the convolution does not wrap around | |

use super::hankel::side_by_side;
use crate::modal::correlations::{Correlations, Ends};
use dolmen_linalg::{LinalgError, Matrix, Operator};
use realfft::num_complex::Complex;
use realfft::{ComplexToReal, RealFftPlanner, RealToComplex};
use std::sync::Arc;

/// H, stored as the transforms of its blocks.
pub(crate) struct BlockHankel {
    /// Rows and columns of a block.
    size: [usize; 2],
    block_rows: usize,
    transform: Transform,
    /// For each bin, Re R̂ above Im R̂, 2l × r.
    bins: Vec<Matrix>,
}

impl BlockHankel {
    /// The matrix from the lags 1 … 2 br - 1 of l channels with the reference channels in these columns of each l × w lag.
    pub(crate) fn new(lags: &[f64], [l, width]: [usize; 2], references: &[usize], block_rows: usize) -> Self {
        let r = references.len();
        let transform = Transform::of(2 * block_rows - 1);
        let mut bins = vec![Matrix::zeros(2 * l, r); transform.bins()];
        let beside = side_by_side(lags, [l, width], references, block_rows);
        let mut buffers = transform.buffers();
        for j in 0..r {
            for i in 0..l {
                let along = (0..2 * block_rows - 1).map(|k| beside[(i, k * r + j)]);
                transform.forward(along, &mut buffers);
                for (bin, z) in bins.iter_mut().zip(&buffers.bins) {
                    bin[(i, j)] = z.re;
                    bin[(l + i, j)] = z.im;
                }
            }
        }
        BlockHankel {
            size: [l, r],
            block_rows,
            transform,
            bins,
        }
    }

    /// H X.
    pub(crate) fn times(&self, x: &Matrix) -> Matrix {
        self.times_transformed(&self.transformed(x))
    }

    /// H X, for an X transformed by [`transformed`](Self::transformed).
    ///
    /// ```text
    /// (H X)_i = Σ_j R_(i+j+1) X_j   ⇒   Ŷ = R̂ conj(X̂)
    /// ```
    pub(super) fn times_transformed(&self, x: &Transformed) -> Matrix {
        let (l, n) = (self.size[0], x.columns);
        let products: Vec<Matrix> = self.bins.iter().zip(&x.bins).map(|(a, b)| a * b).collect();
        let entry = |bin: &Matrix, i: usize, j: usize| {
            // Re and Im of R̂ are stacked vertically, those of X̂ side by side
            Complex {
                re: bin[(i, j)] + bin[(l + i, n + j)],
                im: bin[(l + i, j)] - bin[(i, n + j)],
            }
        };
        self.back(&products, [l, n], entry)
    }

    /// The transforms of X, r br × n, for use with many H.
    pub(super) fn transformed(&self, x: &Matrix) -> Transformed {
        let r = self.size[1];
        Transformed {
            columns: x.columns(),
            bins: self.blocks_transformed(x, r, [r, 2 * x.columns()], |bin, (i, j), z| {
                bin[(i, j)] = z.re;
                bin[(i, x.columns() + j)] = z.im;
            }),
        }
    }

    /// Hᵀ Y: Ẑ = R̂ᵀ conj(Ŷ).
    pub(crate) fn transposed_times(&self, y: &Matrix) -> Matrix {
        let ([l, r], n) = (self.size, y.columns());
        let stacked = self.blocks_transformed(y, l, [2 * l, 2 * n], |bin, (i, j), z| {
            bin[(i, j)] = z.re;
            bin[(l + i, j)] = z.im;
            bin[(i, n + j)] = -z.im;
            bin[(l + i, n + j)] = z.re;
        });
        let products: Vec<Matrix> = self
            .bins
            .iter()
            .zip(&stacked)
            .map(|(a, b)| a.transpose_times(b))
            .collect();
        self.back(&products, [r, n], |bin, i, j| Complex {
            re: bin[(i, j)],
            im: bin[(i, n + j)],
        })
    }

    /// Transforms each entry of the blocks over the block rows; gives one matrix per bin.
    fn blocks_transformed(
        &self,
        x: &Matrix,
        size: usize,
        [rows, columns]: [usize; 2],
        put: impl Fn(&mut Matrix, (usize, usize), Complex<f64>),
    ) -> Vec<Matrix> {
        let mut bins = vec![Matrix::zeros(rows, columns); self.transform.bins()];
        let mut buffers = self.transform.buffers();
        for j in 0..x.columns() {
            for i in 0..size {
                let along = x.column(j)[i..].iter().step_by(size).copied();
                self.transform.forward(along, &mut buffers);
                for (bin, z) in bins.iter_mut().zip(&buffers.bins) {
                    put(bin, (i, j), *z);
                }
            }
        }
        bins
    }

    /// The first br blocks, size rows × n, from their transforms in `entry`.
    fn back(
        &self,
        products: &[Matrix],
        [size, n]: [usize; 2],
        entry: impl Fn(&Matrix, usize, usize) -> Complex<f64>,
    ) -> Matrix {
        let mut out = Matrix::zeros(size * self.block_rows, n);
        let mut buffers = self.transform.buffers();
        for j in 0..n {
            for i in 0..size {
                for (z, bin) in buffers.bins.iter_mut().zip(products) {
                    *z = entry(bin, i, j);
                }
                self.transform.back(&mut buffers);
                let target = out.column_mut(j)[i..].iter_mut().step_by(size);
                for (y, t) in target.zip(&buffers.time) {
                    *y = *t;
                }
            }
        }
        out
    }
}

/// X̂: for each bin Re and Im side by side, r × 2n.
pub(super) struct Transformed {
    columns: usize,
    bins: Vec<Matrix>,
}

/// Y⁺ Y⁻ᵀ / S of [`future_past`](super::hankel::future_past) as an operator: the Hankel matrix of its lags plus the differences at the
/// edges of the windows.
///
/// ```text
/// G(a, b) = R_(a-b) + 1/S Σ_u [y(S + a - u) ŷ(S + b - u)ᵀ - y(a - u) ŷ(b - u)ᵀ],   u = 1 … b
/// ```
/// The differences are products of two thin matrices, (l br) × (br - 1) and (r br) × (br - 1).
pub(crate) struct FuturePast {
    hankel: BlockHankel,
    /// Pairs of thin matrices A, B; the operator includes Σ A Bᵀ.
    thin: Vec<[Matrix; 2]>,
}

impl FuturePast {
    pub(crate) fn new(r: &Correlations, references: &[usize], block_rows: usize) -> Self {
        let all: Vec<usize> = (0..r.channels).collect();
        let thin = |ends: &Ends| {
            let share = 1.0 / ends.starts as f64;
            [(&ends.tail, share), (&ends.head, -share)].map(|(samples, share)| {
                [
                    shifted(samples, r.channels, &all, (block_rows, &|i| block_rows + i)).scaled(share),
                    shifted(
                        samples,
                        r.channels,
                        references,
                        (block_rows, &|j| block_rows - 1 - j),
                    ),
                ]
            })
        };
        FuturePast {
            hankel: BlockHankel::new(
                &r.mean,
                [r.channels, r.columns.len()],
                &r.places(references),
                block_rows,
            ),
            thin: r.ends.iter().flat_map(thin).collect(),
        }
    }
}

/// Block row i, column u - 1: the samples at `at(i)` - u of the chosen channels, with zeros before the first sample.
fn shifted(
    samples: &[f64],
    l: usize,
    chosen: &[usize],
    (block_rows, at): (usize, &dyn Fn(usize) -> usize),
) -> Matrix {
    let n = chosen.len();
    Matrix::from_fn(n * block_rows, block_rows - 1, |row, column| {
        let sample = at(row / n).checked_sub(column + 1);
        sample.map_or(0.0, |t| samples[t * l + chosen[row % n]])
    })
}

impl Operator for FuturePast {
    fn shape(&self) -> [usize; 2] {
        self.hankel.size.map(|size| size * self.hankel.block_rows)
    }
    fn times(&self, x: Matrix) -> Result<Matrix, LinalgError> {
        let mut y = self.hankel.times(&x);
        for [a, b] in &self.thin {
            y = &y + &(a * &b.transpose_times(&x));
        }
        Ok(y)
    }
    fn transpose_times(&self, y: Matrix) -> Result<Matrix, LinalgError> {
        let mut x = self.hankel.transposed_times(&y);
        for [a, b] in &self.thin {
            x = &x + &(b * &a.transpose_times(&y));
        }
        Ok(x)
    }
}

struct Transform {
    forward: Arc<dyn RealToComplex<f64>>,
    inverse: Arc<dyn ComplexToReal<f64>>,
}

struct Buffers {
    time: Vec<f64>,
    bins: Vec<Complex<f64>>,
    scratch: Vec<Complex<f64>>,
}

impl Transform {
    /// The smallest even number of points from `least` on with prime factors 2, 3 and 5 only.
    fn of(least: usize) -> Self {
        let fast = |n: &usize| {
            let mut left = *n;
            for factor in [2, 3, 5] {
                while left.is_multiple_of(factor) {
                    left /= factor;
                }
            }
            left == 1
        };
        let points = (least.next_multiple_of(2)..)
            .step_by(2)
            .find(fast)
            .unwrap_or(least);
        let mut planner = RealFftPlanner::new();
        Transform {
            forward: planner.plan_fft_forward(points),
            inverse: planner.plan_fft_inverse(points),
        }
    }

    fn bins(&self) -> usize {
        self.forward.complex_len()
    }

    fn buffers(&self) -> Buffers {
        let scratch = self.forward.get_scratch_len().max(self.inverse.get_scratch_len());
        Buffers {
            time: self.forward.make_input_vec(),
            bins: self.forward.make_output_vec(),
            scratch: vec![Complex::default(); scratch],
        }
    }

    fn forward(&self, values: impl Iterator<Item = f64>, buffers: &mut Buffers) {
        buffers.time.fill(0.0);
        for (t, x) in buffers.time.iter_mut().zip(values) {
            *t = x;
        }
        let Buffers { time, bins, scratch } = buffers;
        let _ = self.forward.process_with_scratch(time, bins, scratch); // lengths are the plan's own
    }

    fn back(&self, buffers: &mut Buffers) {
        let Buffers { time, bins, scratch } = buffers;
        // the first and the last are real except for rounding, and the plan requires zero imaginary parts
        let last = bins.len() - 1;
        (bins[0].im, bins[last].im) = (0.0, 0.0);
        let _ = self.inverse.process_with_scratch(bins, time, scratch); // lengths are the plan's own
        let share = 1.0 / time.len() as f64;
        time.iter_mut().for_each(|t| *t *= share);
    }
}

#[cfg(test)]
mod tests {
    use super::super::hankel::future_past;
    use super::*;
    use crate::modal::correlations::{correlate, wide};
    use crate::numeric::Random;
    use crate::signal::{Channel, Record};

    fn record(l: usize) -> Record {
        let mut random = Random::new(11, l as u64);
        let samples = (0..l * 900).map(|_| random.normal()).collect();
        let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
        Record::from_contiguous(names, samples, 10.0).unwrap()
    }

    #[test]
    fn exact_products_of_the_matrix_that_displacement_forms() {
        for (l, references, br) in [(3, vec![2, 0], 5), (2, vec![0, 1], 8), (1, vec![0], 2)] {
            let r = correlate(&record(l), 2 * br - 1, 3).unwrap();
            let dense = future_past(&r, &references, br);
            let operator = FuturePast::new(&r, &references, br);
            assert_eq!(operator.shape(), [dense.rows(), dense.columns()]);
            let mut random = Random::new(3, br as u64);
            let mut made = |rows| Matrix::from_fn(rows, 4, |_, _| random.normal());
            let (x, y) = (made(dense.columns()), made(dense.rows()));
            let near = |a: &Matrix, b: &Matrix| {
                let pairs = a.as_slice().iter().zip(b.as_slice());
                pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max) < 1e-13
            };
            assert!(near(&operator.times(x.clone()).unwrap(), &(&dense * &x)));
            let transposed = operator.transpose_times(y.clone()).unwrap();
            assert!(near(&transposed, &dense.transpose_times(&y)));
        }
    }

    #[test]
    fn exact_hankel_matrix_of_a_block_of_time() {
        let br = 6;
        let r = correlate(&record(3), 2 * br - 1, 4).unwrap();
        let (references, lags) = ([1, 2], &wide(&r.deviations[2]));
        let beside = side_by_side(lags, [3, 3], &references, br);
        let dense = Matrix::from_fn(3 * br, 2 * br, |i, j| beside[(i % 3, i / 3 * 2 + j)]);
        let hankel = BlockHankel::new(lags, [3, 3], &references, br);
        let x = Matrix::from_fn(2 * br, 3, |i, j| (i as f64 * 0.7 + j as f64).cos());
        let found = hankel.times_transformed(&hankel.transformed(&x));
        let exact = &dense * &x;
        for (a, b) in found.as_slice().iter().zip(exact.as_slice()) {
            assert!((a - b).abs() < 1e-15, "{a} {b}");
        }
    }
}
