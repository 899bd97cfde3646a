//! Products of whitened columns and readings with each other, for many disturbances in turn.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | n | `variances.len()` | surveys | - |
//! | w | `width` | columns and the readings | - |
//! | φ^Δt | `fades` | correlation of the disturbance after a gap between two surveys | - |

use super::series::Series;
use super::whitening::{Disturbance, Filter, Gains, Whitening};

/// Least independent fraction of the squared length of a column; with less, the column cannot be separated from the earlier ones.
const OWN_LEAST: f64 = 1e-9;

/// Products of the whitened columns and readings with each other, from one pass through the surveys.
pub(super) struct Gram {
    /// w × w, the readings last; the lower half is filled.
    products: Vec<f64>,
    width: usize,
    pub(super) ln_determinant: f64,
}

impl Gram {
    pub(super) fn new(series: &Series, columns: &[Vec<f64>], whitening: &Whitening) -> Self {
        let width = columns.len() + 1;
        let mut white: Vec<Vec<f64>> = columns.iter().map(|column| whitening.white(column)).collect();
        white.push(whitening.white(&series.readings));
        let mut products = vec![0.0; width * width];
        for (i, row) in white.iter().enumerate() {
            for (j, column) in white[..=i].iter().enumerate() {
                products[i * width + j] = row.iter().zip(column).map(|(a, b)| a * b).sum();
            }
        }
        Gram {
            products,
            width,
            ln_determinant: whitening.ln_determinant,
        }
    }

    /// Its Cholesky factor; the square of its last entry is the residual sum of squares.
    pub(super) fn factor(&self) -> Option<Vec<f64>> {
        let mut l = self.products.clone();
        factored(&self.products, &mut l, self.width)?;
        Some(l)
    }
}

/// The Cholesky factor of `products`; `None` if a column is a linear combination of earlier ones.
fn factored(products: &[f64], l: &mut [f64], m: usize) -> Option<()> {
    for i in 0..m {
        for j in 0..=i {
            let known: f64 = (0..j).map(|c| l[i * m + c] * l[j * m + c]).sum();
            let left = products[i * m + j] - known;
            if i == j {
                let is_readings = i + 1 == m;
                if !is_readings && (left <= OWN_LEAST * products[i * m + i] || left.is_nan()) {
                    return None;
                }
                l[i * m + i] = left.max(0.0).sqrt();
            } else {
                l[i * m + j] = left / l[j * m + j];
            }
        }
    }
    Some(())
}

/// A series with its columns, stored for a fast likelihood of many disturbances.
///
/// One pass whitens all columns and sums their products, and each power is computed once for all gaps of the same length. Each number
/// equals that of [`Gram`] to the last bit.
pub(super) struct Likelihood {
    width: usize,
    /// n × w, the readings last.
    rows: Vec<f64>,
    /// σ².
    variances: Vec<f64>,
    /// Lengths of the gaps, and for each survey the index of the gap after it.
    gaps: Vec<f64>,
    gap_after: Vec<usize>,
    /// φ^Δt for each length.
    fades: Vec<f64>,
    gains: Vec<Gains>,
    /// w × w, and its factor.
    products: Vec<f64>,
    factor: Vec<f64>,
}

impl Likelihood {
    pub(super) fn new(series: &Series, columns: &[Vec<f64>]) -> Self {
        let width = columns.len() + 1;
        let row = |i: usize| {
            let explained = columns.iter().map(move |column| column[i]);
            explained.chain([series.readings[i]])
        };
        let every: Vec<f64> = series.at.windows(2).map(|pair| pair[1] - pair[0]).collect();
        let mut gaps = every.clone();
        gaps.sort_by(f64::total_cmp);
        gaps.dedup();
        let place = |gap: &f64| gaps.partition_point(|other| other.total_cmp(gap).is_lt());
        Likelihood {
            width,
            rows: (0..series.len()).flat_map(row).collect(),
            variances: series.noise_sd.iter().map(|sd| sd * sd).collect(),
            gap_after: every.iter().map(place).collect(),
            fades: vec![0.0; gaps.len()],
            gaps,
            gains: Vec::with_capacity(series.len()),
            products: vec![0.0; width * width],
            factor: vec![0.0; width * width],
        }
    }

    /// −2 ln of the restricted likelihood, except for a constant: Σ ln F + ln |Xᵀ V⁻¹ X| + rᵀ V⁻¹ r. `None` if a column is a linear
    /// combination of the others.
    pub(super) fn criterion(&mut self, of: Disturbance) -> Option<f64> {
        for (fade, gap) in self.fades.iter_mut().zip(&self.gaps) {
            *fade = of.correlation.powf(*gap);
        }
        let mut filter = Filter::new(of);
        let mut ln_determinant = 0.0;
        self.gains.clear();
        for (i, variance) in self.variances.iter().enumerate() {
            let fade = self.gap_after.get(i).map(|gap| self.fades[*gap]);
            let (gains, total) = filter.step(*variance, fade);
            self.gains.push(gains);
            ln_determinant += total.ln();
        }
        match self.width {
            2 => self.whiten::<2>(),
            3 => self.whiten::<3>(),
            4 => self.whiten::<4>(),
            5 => self.whiten::<5>(),
            6 => self.whiten::<6>(),
            7 => self.whiten::<7>(),
            8 => self.whiten::<8>(),
            _ => self.whiten_wide(),
        }
        self.factor.copy_from_slice(&self.products);
        factored(&self.products, &mut self.factor, self.width)?;
        let (l, m, k) = (&self.factor, self.width, self.width - 1);
        let of_columns: f64 = (0..k).map(|i| 2.0 * l[i * m + i].ln()).sum();
        Some(ln_determinant + of_columns + l[k * m + k] * l[k * m + k])
    }

    /// Sums the products of `W` whitened columns.
    fn whiten<const W: usize>(&mut self) {
        let mut products = [[0.0; W]; W];
        let mut predicted = [0.0; W];
        for (row, gains) in self.rows.as_chunks::<W>().0.iter().zip(&self.gains) {
            let mut white = [0.0; W];
            for c in 0..W {
                white[c] = gains.scale * (row[c] - predicted[c]);
                predicted[c] = gains.keeps * predicted[c] + gains.learns * row[c];
            }
            for (sums, by) in products.iter_mut().zip(white) {
                for (sum, with) in sums.iter_mut().zip(white) {
                    *sum += by * with;
                }
            }
        }
        self.products.copy_from_slice(products.as_flattened());
    }

    /// The same for more columns.
    fn whiten_wide(&mut self) {
        let width = self.width;
        let (mut white, mut predicted) = (vec![0.0; width], vec![0.0; width]);
        self.products.fill(0.0);
        for (row, gains) in self.rows.chunks_exact(width).zip(&self.gains) {
            for ((z, white), predicted) in row.iter().zip(&mut white).zip(&mut predicted) {
                *white = gains.scale * (z - *predicted);
                *predicted = gains.keeps * *predicted + gains.learns * z;
            }
            for (sums, by) in self.products.chunks_exact_mut(width).zip(&white) {
                for (sum, with) in sums.iter_mut().zip(&white) {
                    *sum += by * with;
                }
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn agrees_to_the_bit_with_columns_whitened_one_by_one() {
        let mut random = Random::new(2, 0);
        let n = 30;
        let at: Vec<f64> = (0..n).map(|i| f64::from(i) + 0.25 * f64::from(i % 3)).collect();
        for width in 1..=11 {
            let mut drawn = || -> Vec<f64> { (0..n).map(|_| random.normal()).collect() };
            let columns: Vec<Vec<f64>> = (1..width).map(|_| drawn()).collect();
            let series = Series {
                readings: drawn(),
                noise_sd: drawn().iter().map(|sd| sd.abs()).collect(),
                at: at.clone(),
            };
            let mut likelihood = Likelihood::new(&series, &columns);
            for correlation in [0.0, 0.4, 0.95] {
                let of = Disturbance { sd: 0.7, correlation };
                let whitening = Whitening::new(&series.at, &series.noise_sd, of);
                let gram = Gram::new(&series, &columns, &whitening);
                let l = gram.factor().unwrap();
                let k = columns.len();
                let of_columns: f64 = (0..k).map(|i| 2.0 * l[i * width + i].ln()).sum();
                let exact = gram.ln_determinant + of_columns + l[k * width + k] * l[k * width + k];
                assert_eq!(likelihood.criterion(of), Some(exact), "{width} {correlation}");
            }
        }
    }
}
