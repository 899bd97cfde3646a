//! A regression that grows by one survey at a time and predicts the next one.

use super::regression::solve_lower;
use super::whitening::Disturbance;

/// Whitened surveys so far, and the state of the filter after them.
#[derive(Clone, Debug)]
pub(super) struct Online {
    disturbance: Disturbance,
    /// Prediction of each column by the filter; the last entry is that of the reading.
    predicted: Vec<f64>,
    variance: f64,
    at: Option<f64>,
    /// Products of the whitened columns and readings, (k + 1) × (k + 1), lower half.
    products: Vec<f64>,
}

/// A survey before it is accepted.
#[derive(Clone, Debug)]
pub(super) struct Reading<'a> {
    pub(super) at: f64,
    pub(super) noise_sd: f64,
    /// Values of the columns, followed by the reading.
    pub(super) row: &'a [f64],
}

#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Prediction {
    /// Reading minus prediction, over the standard deviation of this difference.
    pub(super) score: f64,
    pub(super) expected: f64,
    /// Standard deviation of reading minus prediction.
    pub(super) sd: f64,
}

impl Online {
    pub(super) fn new(columns: usize, disturbance: Disturbance) -> Self {
        let width = columns + 1;
        Online {
            disturbance,
            predicted: vec![0.0; width],
            variance: disturbance.sd * disturbance.sd,
            at: None,
            products: vec![0.0; width * width],
        }
    }

    /// Prediction and its variance at a time, before the reading there.
    fn moved_to(&self, at: f64) -> (Vec<f64>, f64) {
        let Some(before) = self.at else {
            return (self.predicted.clone(), self.variance);
        };
        let rho = self.disturbance.correlation.powf(at - before);
        let all = self.disturbance.sd * self.disturbance.sd;
        let predicted = self.predicted.iter().map(|a| rho * a).collect();
        (predicted, rho * rho * self.variance + all * (1.0 - rho * rho))
    }

    /// Prediction from the surveys so far; `None` if they do not determine the columns yet.
    pub(super) fn predict(&self, reading: &Reading<'_>) -> Option<Prediction> {
        let width = reading.row.len();
        let k = width - 1;
        let (predicted, variance) = self.moved_to(reading.at);
        let scale = 1.0 / (variance + reading.noise_sd.powi(2)).sqrt();
        let white: Vec<f64> = reading
            .row
            .iter()
            .zip(&predicted)
            .map(|(x, a)| scale * (x - a))
            .collect();
        let mut l = self.products.clone();
        for i in 0..width {
            for j in 0..=i {
                let known: f64 = (0..j).map(|c| l[i * width + c] * l[j * width + c]).sum();
                let left = self.products[i * width + j] - known;
                if i != j {
                    l[i * width + j] = left / l[j * width + j];
                } else if i < k {
                    if left <= 1e-6 * self.products[i * width + i] || left.is_nan() {
                        return None;
                    }
                    l[i * width + i] = left.sqrt();
                }
            }
        }
        let factor: Vec<f64> = (0..k * k).map(|c| l[(c / k) * width + c % k]).collect();
        let h = solve_lower(&factor, white[..k].to_vec());
        let explained: f64 = (0..k).map(|j| h[j] * l[k * width + j]).sum();
        let spread = (1.0 + h.iter().map(|x| x * x).sum::<f64>()).sqrt();
        let off = white[k] - explained;
        Some(Prediction {
            score: off / spread,
            expected: reading.row[k] - off / scale,
            sd: spread / scale,
        })
    }

    /// Adds a survey.
    pub(super) fn accept(&mut self, reading: &Reading<'_>) {
        let (predicted, variance) = self.moved_to(reading.at);
        let total = variance + reading.noise_sd.powi(2);
        let (gain, scale) = (variance / total, 1.0 / total.sqrt());
        let width = reading.row.len();
        let errors: Vec<f64> = reading.row.iter().zip(&predicted).map(|(x, a)| x - a).collect();
        for (i, of_row) in errors.iter().enumerate() {
            for (j, of_column) in errors[..=i].iter().enumerate() {
                self.products[i * width + j] += scale * scale * of_row * of_column;
            }
        }
        self.predicted = predicted.iter().zip(&errors).map(|(a, e)| a + gain * e).collect();
        self.variance = variance * (1.0 - gain);
        self.at = Some(reading.at);
    }
}

#[cfg(test)]
mod tests {
    use super::super::regression::Fit;
    use super::super::series::Series;
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn holds_squares_of_scores_add_up_to_what_the_regression_leaves() {
        // recursive residuals: their squares sum to rᵀ V⁻¹ r of the full fit (Brown, Durbin & Evans
        // 1975)
        let n = 30;
        let mut random = Random::new(8, 0);
        let of = Disturbance {
            sd: 0.6,
            correlation: 0.5,
        };
        let series = Series {
            at: (0..n).map(|i| f64::from(i) + 0.2 * f64::from(i % 2)).collect(),
            readings: (0..n).map(|_| random.normal()).collect(),
            noise_sd: (0..n).map(|i| 0.3 + 0.1 * f64::from(i % 3)).collect(),
        };
        let columns = vec![
            vec![1.0; n as usize],
            (0..n).map(|i| f64::from(i).cos()).collect(),
        ];
        let mut online = Online::new(2, of);
        let mut sum = 0.0;
        for (i, cosine) in columns[1].iter().enumerate() {
            let row = [1.0, *cosine, series.readings[i]];
            let reading = Reading {
                at: series.at[i],
                noise_sd: series.noise_sd[i],
                row: &row,
            };
            if let Some(predicted) = online.predict(&reading) {
                sum += predicted.score.powi(2);
            }
            online.accept(&reading);
        }
        let fit = Fit::new(&series, &columns, of).unwrap();
        let left = fit.minus_two_ln_likelihood - fit.whitening.ln_determinant;
        assert!((sum / left - 1.0).abs() < 1e-9, "{sum} {left}");
    }
}
