//! Surveys without a temperature in a series with temperatures.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | w | `effect` | effect of weather on a reading: β (T − T₀) + γ max(0, T_k − T) | - |
//! | n | `near` | surveys with a temperature at the same time of the year | - |

use super::regression::{Fit, restricted_likelihood};
use super::weather::{ModeSeries, YEAR_DAYS, columns, earned, explaining};

/// Largest difference in days for the same time of the year, and smallest number of known temperatures in it. Our choice.
const SAME_TIME_DAYS: f64 = 45.0;
const NEAR_LEAST: usize = 3;
/// Duration of one weather situation, days: surveys within it have the same error. Our choice.
const WEATHER_DAYS: f64 = 7.0;

/// The series in which surveys without a temperature have the mean temperature of the same time of the year, over all years. Their error includes
/// the scatter of the weather effect at that time of the year.
///
/// ```text
/// T̂ = mean of T within 45 days of the time of the year,   σ² → σ² + m s²
/// s² = mean over the known surveys of (w − mean of the other w at their time of the year)²,   m: such surveys within 7 days
/// ```
/// A survey at a time of the year with fewer than three known temperatures keeps none. `levels` are columns of works for the surveys with a
/// temperature.
pub(super) fn filled(series: &ModeSeries, levels: &[Vec<f64>], frost_below_c: f64) -> ModeSeries {
    let known = with_temperature(series);
    if known.len() == series.len() {
        return series.clone();
    }
    let middle_c = known.temperatures_c.iter().sum::<f64>() / known.len() as f64;
    let at = (middle_c, frost_below_c);
    let weather = earned(&known, levels, at);
    let mut all = columns(&known, weather, at);
    let width = all.len();
    all.extend(levels.iter().cloned());
    let fit = restricted_likelihood(&known.series, &all, None)
        .and_then(|disturbance| Fit::new(&known.series, &all, disturbance));
    let Some(fit) = fit else {
        return series.clone();
    };
    let effect = |temperature_c: f64| -> f64 {
        let row = explaining(weather, (0.0, temperature_c), at);
        (1..width).map(|c| row[c] * fit.coefficients[c]).sum()
    };
    let effects: Vec<f64> = known.temperatures_c.iter().map(|t| effect(*t)).collect();
    let near = |day: f64, but: Option<usize>| -> Vec<usize> {
        let all = (0..known.len()).filter(|j| Some(*j) != but);
        all.filter(|j| apart(known.days[*j], day) <= SAME_TIME_DAYS)
            .collect()
    };
    let mean = |which: &[usize], of: &[f64]| which.iter().map(|j| of[*j]).sum::<f64>() / which.len() as f64;
    let off = (0..known.len()).filter_map(|i| {
        let others = near(known.days[i], Some(i));
        (others.len() >= NEAR_LEAST).then(|| (effects[i] - mean(&others, &effects)).powi(2))
    });
    let off: Vec<f64> = off.collect();
    let variance = off.iter().sum::<f64>() / off.len().max(1) as f64;
    let without: Vec<f64> = (0..series.len())
        .filter(|i| series.temperatures_c[*i].is_nan())
        .map(|i| series.days[i])
        .collect();
    let mut out = series.clone();
    for i in (0..series.len()).filter(|i| series.temperatures_c[*i].is_nan()) {
        let of_time = near(series.days[i], None);
        if of_time.len() < NEAR_LEAST || off.is_empty() {
            continue;
        }
        let temperature_c = mean(&of_time, &known.temperatures_c);
        // with frost the effect is nonlinear: its mean is not the effect of the mean temperature
        let bent = mean(&of_time, &effects) - effect(temperature_c);
        let together = without
            .iter()
            .filter(|day| (*day - series.days[i]).abs() <= WEATHER_DAYS);
        let noise_sd = series.series.noise_sd[i];
        out.temperatures_c[i] = temperature_c;
        out.series.noise_sd[i] =
            (noise_sd * noise_sd + together.count() as f64 * (variance + bent * bent)).sqrt();
    }
    out
}

/// The surveys with a known temperature.
pub(super) fn with_temperature(series: &ModeSeries) -> ModeSeries {
    series.kept(|i| series.temperatures_c[i].is_finite())
}

/// Difference of two days in the time of the year.
fn apart(a: f64, b: f64) -> f64 {
    let turned = (a - b).rem_euclid(YEAR_DAYS);
    turned.min(YEAR_DAYS - turned)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::monitoring::series::Series;

    /// Ten years of surveys in spring, summer and autumn, −0.15 % per °C, without noise; the surveys `without` have no temperature.
    fn series(without: &[usize]) -> ModeSeries {
        let days: Vec<f64> = (0..30)
            .map(|i| YEAR_DAYS * (f64::from(i / 3) + 0.25 * f64::from(1 + i % 3)))
            .collect();
        let temperatures_c: Vec<f64> = (0..30)
            .map(|i| [10.0, 25.0, 12.0][i % 3] + [0.0, 2.0, -2.0, 1.0, -1.0][(7 * i + i / 3) % 5])
            .collect();
        ModeSeries {
            surveys: (0..30).collect(),
            series: Series {
                at: (0..30).map(f64::from).collect(),
                readings: temperatures_c.iter().map(|t| -1.5e-3 * (t - 15.0)).collect(),
                noise_sd: vec![1e-3; 30],
            },
            temperatures_c: (0..30)
                .map(|i| match without.contains(&i) {
                    true => f64::NAN,
                    false => temperatures_c[i],
                })
                .collect(),
            days,
        }
    }

    #[test]
    fn exact_a_survey_without_a_temperature_has_that_of_its_season() {
        let found = filled(&series(&[28]), &[], 0.0);
        // the nine summers with a temperature, by hand
        let summers: Vec<f64> = (0..9)
            .map(|year| series(&[]).temperatures_c[3 * year + 1])
            .collect();
        let mean = summers.iter().sum::<f64>() / 9.0;
        assert!((found.temperatures_c[28] - mean).abs() < 1e-12);
        // residual weather effect at one time of the year: 1.5e-3 times a standard deviation of √2 °C; the difference to the mean of the others is
        // 9/8 to 10/9 times as large
        let own = (found.series.noise_sd[28].powi(2) - 1e-6).sqrt();
        let expected = 1.5e-3 * 2f64.sqrt() * 1.11;
        assert!((own / expected - 1.0).abs() < 0.08, "{own} {expected}");
        // the other surveys do not change
        assert_eq!(found.series.noise_sd[27], 1e-3);
    }

    #[test]
    fn holds_a_season_that_nobody_knows_is_not_guessed() {
        let mut one = series(&[28]);
        one.days[28] = YEAR_DAYS * 9.99; // winter
        assert!(filled(&one, &[], 0.0).temperatures_c[28].is_nan());
    }
}
