//! Effect of temperature on a frequency: a known coefficient, or one fitted to earlier surveys.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | T_k, f_k | `t`, `f` | temperature and frequency of survey k | °C, Hz |
//! | x_k | `x` | T_k minus the mean temperature | °C |
//! | b | `slope` | change of the frequency with temperature | Hz/°C |
//! | s | `scatter_hz` | standard deviation of a survey about the line | Hz |

use crate::assess::AssessError;

/// Fewest surveys with a temperature for a fit: four leave two degrees of freedom.
pub const TEMPERATURE_SURVEYS_LEAST: usize = 4;
/// Least range of their temperatures, °C. Our choice: a smaller range does not show the effect of the seasons.
const SPREAD_LEAST_C: f64 = 2.0;

/// Known effect of temperature on the frequencies.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TemperatureEffect {
    /// The effect is unknown.
    Unknown,
    /// The same relative change per °C for every frequency.
    Coefficient {
        /// Relative change per °C.
        per_c: f64,
        /// Its standard deviation.
        sd_per_c: f64,
    },
    /// Fitted to the surveys before the later of the two compared ones.
    Fitted,
}

/// A frequency as a linear function of temperature, by least squares.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct FittedTemperature {
    /// Change per °C, relative to the frequency of the earlier compared survey.
    pub per_c: f64,
    /// Its standard deviation.
    pub sd_per_c: f64,
    /// Standard deviation of one survey about the line, Hz.
    pub scatter_hz: f64,
    /// Number of fitted surveys.
    pub surveys: usize,
    /// Lowest and highest temperature of these surveys, °C.
    pub range_c: [f64; 2],
}

/// One survey of the fit.
#[derive(Clone, Copy, Debug)]
pub(super) struct FitPoint {
    pub(super) temperature_c: f64,
    pub(super) frequency_hz: f64,
    pub(super) sd_hz: Option<f64>,
}

/// The fitted line, and its prediction for a later survey.
pub(super) struct Line {
    pub(super) fitted: FittedTemperature,
    /// Change that temperature explains, b ΔT, Hz.
    pub(super) explained_hz: f64,
    /// Variance of f' - f_first - b ΔT, Hz², if f' scatters about the line as the other surveys do. f_first belongs to the
    /// fitted surveys.
    pub(super) variance_hz2: f64,
    /// Mean square of the standard deviations that the surveys state, Hz²: part of the scatter about the line.
    pub(super) stated_hz2: f64,
    /// Degrees of freedom of the fit.
    pub(super) degrees_of_freedom: f64,
}

/// Fits a line to `points`. The first point is the survey that is compared with one at the temperature `to_c`.
///
/// ```text
/// b = Σ x_k f_k / Σ x_k²,   s² = Σ e_k² / (n - 2),   e_k = f_k - mean f - b x_k
/// f_first + b ΔT = Σ c_k f_k,  c_k = [k = first] + ΔT x_k / Σ x²
/// var(f' - f_first - b ΔT) = s² (1 + Σ c_k²),   ν = n - 2
/// ```
///
/// # Errors
/// [`AssessError::TemperatureFit`] with fewer than four surveys, or temperatures less than 2 °C apart.
pub(super) fn line(points: &[FitPoint], to_c: f64) -> Result<Line, AssessError> {
    let n = points.len() as f64;
    let ends = points.iter().map(|p| p.temperature_c);
    let range_c = [
        ends.clone().fold(f64::INFINITY, f64::min),
        ends.fold(f64::NEG_INFINITY, f64::max),
    ];
    if points.len() < TEMPERATURE_SURVEYS_LEAST || range_c[1] - range_c[0] < SPREAD_LEAST_C {
        return Err(AssessError::TemperatureFit {
            surveys: points.len(),
            least: TEMPERATURE_SURVEYS_LEAST,
            spread_c: if points.is_empty() {
                0.0
            } else {
                range_c[1] - range_c[0]
            },
            spread_least_c: SPREAD_LEAST_C,
        });
    }
    let mean = |of: fn(&FitPoint) -> f64| points.iter().map(of).sum::<f64>() / n;
    let (mean_c, mean_hz) = (mean(|p| p.temperature_c), mean(|p| p.frequency_hz));
    let x: Vec<f64> = points.iter().map(|p| p.temperature_c - mean_c).collect();
    let sum_xx: f64 = x.iter().map(|x| x * x).sum();
    let slope = x.iter().zip(points).map(|(x, p)| x * p.frequency_hz).sum::<f64>() / sum_xx;
    let left = x
        .iter()
        .zip(points)
        .map(|(x, p)| p.frequency_hz - mean_hz - slope * x);
    let variance = left.map(|e| e * e).sum::<f64>() / (n - 2.0);
    let stated = points.iter().map(|p| p.sd_hz.unwrap_or(0.0).powi(2)).sum::<f64>() / n;
    let (first, step_c) = (points[0], to_c - points[0].temperature_c);
    let weights = x
        .iter()
        .enumerate()
        .map(|(k, x)| f64::from(u8::from(k == 0)) + step_c * x / sum_xx);
    Ok(Line {
        explained_hz: slope * step_c,
        variance_hz2: variance * (1.0 + weights.map(|c| c * c).sum::<f64>()),
        stated_hz2: stated,
        degrees_of_freedom: n - 2.0,
        fitted: FittedTemperature {
            per_c: slope / first.frequency_hz,
            sd_per_c: (variance / sum_xx).sqrt() / first.frequency_hz,
            scatter_hz: variance.sqrt(),
            surveys: points.len(),
            range_c,
        },
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn agrees_with_scipy_linregress() {
        // scipy 1.17.1: linregress([18, 5, -3, 27, 11], [2.01, 2.06, 2.11, 1.99, 2.03]): slope, stderr
        let points: Vec<FitPoint> = [
            (18.0, 2.01),
            (5.0, 2.06),
            (-3.0, 2.11),
            (27.0, 1.99),
            (11.0, 2.03),
        ]
        .map(|(temperature_c, frequency_hz)| FitPoint {
            temperature_c,
            frequency_hz,
            sd_hz: Some(1e-4),
        })
        .to_vec();
        let found = line(&points, 18.0).unwrap();
        assert!(
            (found.fitted.per_c * 2.01 / SLOPE - 1.0).abs() < 1e-12,
            "{:e}",
            found.fitted.per_c * 2.01
        );
        assert!((found.fitted.sd_per_c * 2.01 / STDERR - 1.0).abs() < 1e-12);
        // equal temperatures: nothing is explained, and the variance is the sum for two surveys
        assert_eq!(found.explained_hz, 0.0);
        assert!((found.variance_hz2 / found.fitted.scatter_hz.powi(2) - 2.0).abs() < 1e-12);
    }

    const SLOPE: f64 = -0.003942451420029894;
    const STDERR: f64 = 0.0005475789808280832;

    #[test]
    fn exact_weights_of_a_step_beyond_the_middle() {
        // f = 2 - .001 T + e, e = (1, -1, -1, 1) h: e has no mean and no slope; s² = 4 h²/2
        let h = 0.004;
        let points: Vec<FitPoint> = [(0.0, h), (10.0, -h), (20.0, -h), (30.0, h)]
            .map(|(temperature_c, e)| FitPoint {
                temperature_c,
                frequency_hz: 2.0 - 0.001 * temperature_c + e,
                sd_hz: Some(0.003),
            })
            .to_vec();
        let found = line(&points, 30.0).unwrap();
        assert!(
            (found.explained_hz + 0.03).abs() < 1e-15 && (found.fitted.per_c + 0.001 / 2.004).abs() < 1e-15
        );
        assert!((found.fitted.scatter_hz / h - 2.0_f64.sqrt()).abs() < 1e-12);
        // c = [1, 0, 0, 0] + 30 (-15, -5, 5, 15)/500 = [.1, -.3, .3, .9]: Σ c² = 1
        assert!(
            (found.variance_hz2 / (2.0 * h * h) - 2.0).abs() < 1e-12,
            "{}",
            found.variance_hz2
        );
        assert!((found.stated_hz2 / 9e-6 - 1.0).abs() < 1e-12);
    }

    #[test]
    fn refuses_too_few_surveys_and_one_season() {
        let point = |temperature_c| FitPoint {
            temperature_c,
            frequency_hz: 2.0,
            sd_hz: None,
        };
        let message = |t: &[f64]| {
            let points: Vec<FitPoint> = t.iter().map(|t| point(*t)).collect();
            line(&points, 20.0)
                .err()
                .map(|why| why.to_string())
                .unwrap_or_default()
        };
        assert!(message(&[1.0, 9.0, 20.0]).starts_with("3 surveys with a temperature, 19 °C apart"));
        assert!(message(&[9.0, 9.5, 10.0, 10.0]).starts_with("4 surveys with a temperature, 1 °C apart"));
    }
}
