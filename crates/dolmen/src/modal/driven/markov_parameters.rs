//! Markov parameters: sampled responses of a structure to a unit of each input and of each innovation.
//!
//! | symbol | code | meaning | shape |
//! |:--|:--|:--|:--|
//! | A_i, C_k | `recursion`, `direct` | coefficients of the observer, y_t = Σ A_i y_{t-i} + Σ C_k [u; e]_{t-k} | l × l, l × q |
//! | h_k | `MarkovParameters` | response k samples after a unit input or innovation | l × q, q = m + l |

use super::observer::Observer;
use dolmen_linalg::Matrix;

/// h_0, h_1, …, one after the other, each row by row.
pub(super) struct MarkovParameters {
    pub(super) rows: usize,
    pub(super) columns: usize,
    values: Vec<f64>,
}

impl MarkovParameters {
    pub(super) fn at(&self, step: usize) -> &[f64] {
        let size = self.rows * self.columns;
        &self.values[step * size..(step + 1) * size]
    }

    pub(super) fn largest(&self, step: usize) -> f64 {
        self.at(step).iter().fold(0.0, |most, h| h.abs().max(most))
    }

    /// Multiplies each h by a square matrix from the right.
    pub(super) fn weighted(mut self, weights: &Matrix) -> MarkovParameters {
        let mut row = vec![0.0; self.columns];
        for of in self.values.chunks_exact_mut(self.columns) {
            for (j, sum) in row.iter_mut().enumerate() {
                *sum = of.iter().zip(weights.column(j)).map(|(h, w)| h * w).sum();
            }
            of.copy_from_slice(&row);
        }
        self
    }
}

impl Observer {
    fn sources(&self) -> usize {
        self.inputs + self.outputs
    }

    /// Entry of A_i at row r, column c.
    fn recursion(&self, of: &Matrix, lag: usize, r: usize, c: usize) -> f64 {
        of[((lag - 1) * self.outputs + c, r)]
    }

    /// C_k; `unit` is the immediate effect of an innovation.
    fn direct(&self, of: &Matrix, step: usize, unit: f64) -> Vec<f64> {
        let (l, m, q) = (self.outputs, self.inputs, self.sources());
        let mut direct = vec![0.0; l * q];
        for r in 0..l {
            if step <= self.lags {
                for c in 0..m {
                    direct[r * q + c] = of[(self.lags * l + step * m + c, r)];
                }
            }
            if step == 0 {
                direct[r * q + m + r] = unit;
            }
        }
        direct
    }

    /// Adds A_i h to a sum.
    fn add_past(&self, of: &Matrix, lag: usize, h: &[f64], sum: &mut [f64]) {
        let q = self.sources();
        for (r, sum) in sum.chunks_exact_mut(q).enumerate() {
            for (c, h) in h.chunks_exact(q).enumerate() {
                let a = self.recursion(of, lag, r, c);
                for (sum, h) in sum.iter_mut().zip(h) {
                    *sum += a * h;
                }
            }
        }
    }

    /// ```text
    /// h_k = C_k + Σ_{i ≤ min(k, p)} A_i h_{k-i}
    /// ```
    pub(super) fn markov_parameters(&self, steps: usize) -> MarkovParameters {
        let (l, q) = (self.outputs, self.sources());
        let mut markov = MarkovParameters {
            rows: l,
            columns: q,
            values: Vec::with_capacity(steps * l * q),
        };
        for k in 0..steps {
            let mut h = self.direct(&self.coefficients, k, 1.0);
            for lag in 1..=k.min(self.lags) {
                self.add_past(&self.coefficients, lag, markov.at(k - lag), &mut h);
            }
            markov.values.extend(h);
        }
        markov
    }

    /// First-order change of the Markov parameters with the coefficients:
    ///
    /// ```text
    /// dh_k = dC_k + Σ (dA_i h_{k-i} + A_i dh_{k-i})
    /// ```
    pub(super) fn change(&self, markov: &MarkovParameters, steps: usize, moved: &Matrix) -> MarkovParameters {
        let (l, q) = (self.outputs, self.sources());
        let mut change = MarkovParameters {
            rows: l,
            columns: q,
            values: Vec::with_capacity(steps * l * q),
        };
        for k in 0..steps {
            let mut dh = self.direct(moved, k, 0.0);
            for lag in 1..=k.min(self.lags) {
                self.add_past(moved, lag, markov.at(k - lag), &mut dh);
                self.add_past(&self.coefficients, lag, change.at(k - lag), &mut dh);
            }
            change.values.extend(dh);
        }
        change
    }
}
