//! Sums of products of the future with the past, and of the past with itself, which both subspace methods decompose.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | y, ŷ | | all channels, the reference channels | l, r |
//! | br | `block_rows` | block rows, and block columns | |
//! | S | `starts` | window: samples 0 … S - 1 | |
//! | G(a, b) | `sum` | 1/S Σ y(t + a) ŷ(t + b)ᵀ, t = 0 … S - 1 | l × r |
//! | Y⁺, Y⁻ | | blocks y(t + br + i), ŷ(t + br - 1 - j), i, j = 0 … br - 1 | l br, r br |

use crate::modal::correlations::{Correlations, Ends};
use dolmen_linalg::Matrix;

/// Largest number of rows of a Hankel matrix; more rows take many seconds.
pub(crate) const HANKEL_ROWS_MOST: usize = 2400;

/// Y⁺ Y⁻ᵀ / S: block (i, j) is G(br + i, br - 1 - j), or R_(i+j+1) if the end samples are unknown.
///
/// ```text
/// G(a + 1, b + 1) = G(a, b) + [y(S + a) ŷ(S + b)ᵀ - y(a) ŷ(b)ᵀ] / S,   G(k, 0) = R_k
/// ```
/// No product is summed twice, and no matrix with one column per sample is formed.
pub(super) fn future_past(r: &Correlations, references: &[usize], block_rows: usize) -> Matrix {
    let (l, n) = (r.channels, references.len());
    let all: Vec<usize> = (0..l).collect();
    let mut out = Matrix::zeros(l * block_rows, n * block_rows);
    for lag in 1..2 * block_rows {
        let first = block_rows.saturating_sub(lag);
        let last = (block_rows - 1).min(2 * block_rows - 1 - lag);
        displaced(
            r,
            &r.mean,
            (&all, references),
            lag,
            first..last + 1,
            &mut |a, b, sum| {
                put(&mut out, (a - block_rows) * l, (block_rows - 1 - b) * n, l, sum);
            },
        );
    }
    out
}

/// Lower triangle of Y⁻ Y⁻ᵀ / S: block (j, i), j ≥ i, is G(br - 1 - j, br - 1 - i). After decimation it is the matrix of the
/// record followed by zeros, which is never indefinite. It only weights the past and does not change any pole.
pub(super) fn past_past(r: &Correlations, references: &[usize], block_rows: usize) -> Matrix {
    let n = references.len();
    let mut out = Matrix::zeros(n * block_rows, n * block_rows);
    for lag in 0..block_rows {
        // G(b + lag, b), transposed: the earlier sample is lower in Y⁻
        let sums = r.padded.as_ref().unwrap_or(&r.mean);
        displaced(
            r,
            sums,
            (references, references),
            lag,
            0..block_rows - lag,
            &mut |a, b, sum| {
                let (row, column) = ((block_rows - 1 - b) * n, (block_rows - 1 - a) * n);
                for (i, x) in sum.chunks_exact(n).enumerate() {
                    out.column_mut(column + i)[row..row + n].copy_from_slice(x);
                }
            },
        );
    }
    out
}

/// Calls `use_it(a, b, G(a, b))` for a = b + lag and each b in `wanted`; sums are row by row.
fn displaced(
    r: &Correlations,
    sums: &[f64],
    (rows, columns): (&[usize], &[usize]),
    lag: usize,
    wanted: std::ops::Range<usize>,
    use_it: &mut dyn FnMut(usize, usize, &[f64]),
) {
    let (l, width) = (r.channels, r.columns.len());
    let from = &sums[lag * l * width..(lag + 1) * l * width];
    let places = r.places(columns);
    let mut sum: Vec<f64> = rows
        .iter()
        .flat_map(|i| places.iter().map(move |j| from[i * width + j]))
        .collect();
    for b in 0..wanted.end {
        if b > 0
            && let Some(ends) = &r.ends
        {
            shift(&mut sum, ends, (rows, columns), (b - 1 + lag, b - 1), l);
        }
        if b >= wanted.start {
            use_it(b + lag, b, &sum);
        }
    }
}

/// G(a, b) → G(a + 1, b + 1).
fn shift(
    sum: &mut [f64],
    ends: &Ends,
    (rows, columns): (&[usize], &[usize]),
    (a, b): (usize, usize),
    l: usize,
) {
    let share = 1.0 / ends.starts as f64;
    for (target, i) in sum.chunks_exact_mut(columns.len()).zip(rows) {
        let (gained, lost) = (share * ends.tail[a * l + i], share * ends.head[a * l + i]);
        for (x, j) in target.iter_mut().zip(columns) {
            *x += gained * ends.tail[b * l + j] - lost * ends.head[b * l + j];
        }
    }
}

fn put(out: &mut Matrix, row: usize, column: usize, rows: usize, sum: &[f64]) {
    let columns = sum.len() / rows;
    for j in 0..columns {
        let target = &mut out.column_mut(column + j)[row..row + rows];
        for (x, i) in target.iter_mut().zip(0..rows) {
            *x = sum[i * columns + j];
        }
    }
}

/// Lags 1 … 2 br - 1 of the reference channels, which stand in these columns of each l × w lag, side by side, so that block row i of their
/// Hankel matrix is the columns from i r on.   shape: l × r (2 br - 1)
pub(super) fn side_by_side(
    lags: &[f64],
    [l, width]: [usize; 2],
    places: &[usize],
    block_rows: usize,
) -> Matrix {
    let n = places.len();
    Matrix::from_fn(l, n * (2 * block_rows - 1), |i, column| {
        lags[(column / n + 1) * l * width + i * width + places[column % n]]
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::modal::correlations::correlate;
    use crate::numeric::Random;
    use crate::signal::{Channel, Record};

    #[test]
    fn exact_sums_over_the_windows_of_the_stacked_samples() {
        let (l, length, br) = (3, 1200, 5);
        let references = [2, 0];
        let mut random = Random::new(3, 0);
        let samples: Vec<Vec<f64>> = (0..l)
            .map(|_| {
                (0..length)
                    .map(|t| random.normal() + (t as f64 * 0.3).sin())
                    .collect()
            })
            .collect();
        let names = (0..l).map(|c| Channel::named(format!("{c}"))).collect();
        let record = Record::new(names, samples, 10.0).unwrap();
        let r = correlate(&record, 2 * br - 1, 2).unwrap();
        let y: Vec<Vec<f64>> = (0..l)
            .map(|c| {
                let y = record.samples(c);
                let mean = y.iter().sum::<f64>() / y.len() as f64;
                y.iter().map(|y| y - mean).collect()
            })
            .collect();
        let starts = length - 2 * br + 1;
        let product = |a: usize, i: usize, b: usize, j: usize| -> f64 {
            (0..starts).map(|t| y[i][t + a] * y[j][t + b]).sum::<f64>() / starts as f64
        };
        let (cross, past) = (future_past(&r, &references, br), past_past(&r, &references, br));
        let n = references.len();
        for row in 0..l * br {
            for column in 0..n * br {
                let (b, j) = (br - 1 - column / n, references[column % n]);
                let exact = product(br + row / l, row % l, b, j);
                assert!((cross[(row, column)] - exact).abs() < 1e-13);
            }
        }
        for row in 0..n * br {
            for column in 0..=row {
                let at = |k: usize| (br - 1 - k / n, references[k % n]);
                let ((a, i), (b, j)) = (at(row), at(column));
                assert!((past[(row, column)] - product(a, i, b, j)).abs() < 1e-13);
            }
        }
    }
}
