//! Joint test of all modes of a survey: Hotelling's T² of their scores.

use super::MonitoringError;
use super::alarm::JudgedMode;
use crate::numeric::fisher_quantile;
use dolmen_linalg::{Matrix, solve};

/// Probability that a survey without change lies beyond the limit: one in 365.
const BEYOND: f64 = 1.0 / 365.0;
/// Earlier surveys needed per mode for T²; with ten surveys of one mode, a χ² limit would give one alarm in four
/// surveys.
const SURVEYS_FOR_EACH: usize = 4;

/// T² of one survey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SurveyTSquared {
    /// Index of the survey.
    pub survey: usize,
    /// Its number of modes.
    pub modes: usize,
    /// T².
    pub value: f64,
    /// The limit that a survey without change exceeds once in 365.
    pub limit: f64,
}

/// T² of each survey with two or more judged modes, relative to earlier surveys in which the same modes were judged.
///
/// ```text
/// T² = (u − ū)ᵀ S⁻¹ (u − ū),   limit p (n + 1)(n − 1)/(n (n − p)) F(p, n − p)        u: p × 1, n surveys before
/// ```
///
/// # Source
/// Hotelling (1947); Montgomery (2009) *Introduction to statistical quality control*, 6th ed., eq. 11.25.
pub(super) fn t_squared(
    modes: &[JudgedMode],
    surveys: usize,
) -> Result<Vec<SurveyTSquared>, MonitoringError> {
    let m = modes.len();
    let mut scores: Vec<Vec<Option<f64>>> = vec![vec![None; m]; surveys];
    for (c, mode) in modes.iter().enumerate() {
        for judged in &mode.judged {
            scores[judged.survey][c] = judged.score.ok();
        }
    }
    // for each pair of modes: number of surveys with both, sums, and products
    let mut count = vec![0_usize; m * m];
    let mut sums = vec![0.0; m * m];
    let mut products = vec![0.0; m * m];
    let mut out = Vec::new();
    for (survey, row) in scores.iter().enumerate() {
        let present: Vec<usize> = (0..m).filter(|c| row[*c].is_some()).collect();
        let p = present.len();
        let pairs = present
            .iter()
            .flat_map(|a| present.iter().map(move |b| a * m + b));
        let n = pairs.map(|ab| count[ab]).min().unwrap_or(0);
        if p >= 2 && n > SURVEYS_FOR_EACH * p {
            let mean = |a: usize, b: usize| sums[a * m + b] / count[a * m + b] as f64;
            let covariance = Matrix::from_fn(p, p, |i, j| {
                let (a, b) = (present[i], present[j]);
                let of = count[a * m + b] as f64;
                (products[a * m + b] - of * mean(a, b) * mean(b, a)) / (of - 1.0)
            });
            let off: Vec<f64> = present
                .iter()
                .map(|a| row[*a].unwrap_or(0.0) - mean(*a, *a))
                .collect();
            if let Ok(solved) = solve(&covariance, &Matrix::from_column(&off)) {
                let value = off.iter().zip(solved.column(0)).map(|(a, b)| a * b).sum();
                let (pf, nf) = (p as f64, n as f64);
                let scale = pf * (nf + 1.0) * (nf - 1.0) / (nf * (nf - pf));
                let limit = scale * fisher_quantile(BEYOND, pf, nf - pf)?;
                out.push(SurveyTSquared {
                    survey,
                    modes: p,
                    value,
                    limit,
                });
                if value > limit {
                    continue; // surveys outside the limit are not used for training
                }
            }
        }
        for a in &present {
            for b in &present {
                let (u, v) = (row[*a].unwrap_or(0.0), row[*b].unwrap_or(0.0));
                count[a * m + b] += 1;
                sums[a * m + b] += u;
                products[a * m + b] += u * v;
            }
        }
    }
    Ok(out)
}
