//! Fits a yearly wave in addition to a level and a slope. The readings need not cover the whole year.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | ω t | `turn` | time of the year, as an angle |
//! | α | `angle` | time of the year at which a column has its maximum |
//! | v | `variance` | mean square of a column after its fit by level, slope and works is subtracted |

use super::weather::{WAVE_VARIANCE_LEAST, YEAR_DAYS};
use std::f64::consts::TAU;

/// Regression columns of a yearly wave that the days can distinguish from the columns `beside`. There are two columns if the readings cover the year,
/// one if they fall at two times of the year, and none for a single time of the year.
///
/// ```text
/// cos(ω t − α) − m        α: principal axes of (cos ω t, sin ω t) minus their fit by the other columns,   v(α) ≥ 0.05
/// m = 1/year ∫ cos(ω t − α) dt over the last year, the integrand constant around each reading
/// ```
/// If v is small, the data do not determine the amplitude, and so neither the level nor the slope: ten readings from the first days of February would
/// agree with any level in the rest of the year. Each column has the mean 0 over the last year. So the level of the regression at the last reading is
/// the mean of that year: of the whole year if the readings cover it, otherwise of the season with readings.
pub(super) fn yearly_wave(days: &[f64], beside: &[Vec<f64>]) -> Vec<Vec<f64>> {
    let turns: Vec<f64> = days.iter().map(|day| TAU * day / YEAR_DAYS).collect();
    let [cosine, sine] = left(
        beside,
        [
            turns.iter().map(|turn| turn.cos()).collect(),
            turns.iter().map(|turn| turn.sin()).collect(),
        ],
    );
    let mean = |a: &[f64], b: &[f64]| dot(a, b) / days.len() as f64;
    let (of_cosine, of_sine, of_both) = (mean(&cosine, &cosine), mean(&sine, &sine), mean(&cosine, &sine));
    let (half, apart) = (0.5 * (of_cosine + of_sine), 0.5 * (of_cosine - of_sine));
    let angle = 0.5 * of_both.atan2(apart);
    let axes = [
        (half + apart.hypot(of_both), angle),
        (half - apart.hypot(of_both), angle + 0.25 * TAU),
    ];
    let known = axes
        .into_iter()
        .filter(|(variance, _)| *variance >= WAVE_VARIANCE_LEAST);
    known
        .map(|(_, angle)| {
            let wave: Vec<f64> = turns.iter().map(|turn| (turn - angle).cos()).collect();
            let middle = of_last_year(days, &wave);
            wave.iter().map(|value| value - middle).collect()
        })
        .collect()
}

/// Amplitude of the wave from the coefficients of its one or two columns; `None` without columns.
pub(super) fn amplitude(coefficients: &[f64]) -> Option<f64> {
    coefficients.iter().copied().reduce(f64::hypot).map(f64::abs)
}

/// Mean over the year that ends with the last day; each value represents the time that is nearest to its reading.
fn of_last_year(days: &[f64], values: &[f64]) -> f64 {
    let Some(last) = days.last().copied() else {
        return 0.0;
    };
    let first = last - YEAR_DAYS;
    let mut until = last;
    let mut sum = 0.0;
    for (i, value) in values.iter().enumerate().rev() {
        let from = match i {
            0 => first,
            _ => (0.5 * (days[i - 1] + days[i])).max(first),
        };
        sum += value * (until - from).max(0.0);
        until = from.min(until);
    }
    sum / YEAR_DAYS
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

/// Residuals of two columns after their fit by other columns is subtracted: modified Gram-Schmidt.
fn left(columns: &[Vec<f64>], mut of: [Vec<f64>; 2]) -> [Vec<f64>; 2] {
    let take = |from: &mut Vec<f64>, unit: &[f64]| {
        let along = dot(from, unit);
        from.iter_mut().zip(unit).for_each(|(x, u)| *x -= along * u);
    };
    let mut units: Vec<Vec<f64>> = Vec::new();
    for column in columns {
        let mut own = column.clone();
        let all = dot(&own, &own);
        units.iter().for_each(|unit| take(&mut own, unit));
        let rest = dot(&own, &own);
        if rest > 1e-12 * all {
            own.iter_mut().for_each(|x| *x /= rest.sqrt());
            units.push(own);
        }
    }
    for column in &mut of {
        units.iter().for_each(|unit| take(column, unit));
    }
    of
}

#[cfg(test)]
mod tests {
    use super::*;

    fn beside(days: &[f64]) -> Vec<Vec<f64>> {
        let years = days.iter().map(|day| day / YEAR_DAYS - 15.0).collect();
        vec![vec![1.0; days.len()], years]
    }

    fn columns(days: &[f64]) -> Vec<Vec<f64>> {
        yearly_wave(days, &beside(days))
    }

    /// Readings over `years` years, at these fractions of each year.
    fn at(years: u32, parts: &[f64]) -> Vec<f64> {
        let of = |year| parts.iter().map(move |part| YEAR_DAYS * (f64::from(year) + part));
        (10..10 + years).flat_map(of).collect()
    }

    #[test]
    fn holds_a_wave_is_fitted_where_the_readings_tell_it() {
        let monthly: Vec<f64> = (0..12).map(|i| f64::from(i) / 12.0).collect();
        assert_eq!(columns(&at(4, &monthly)).len(), 2);
        assert_eq!(columns(&at(4, &[0.1, 0.4, 0.6, 0.9])).len(), 2);
        assert_eq!(columns(&at(8, &[0.2, 0.7])).len(), 1);
        assert_eq!(columns(&at(8, &[0.2, 0.4])).len(), 1);
        // five days around one date; the date advances by a month in twelve years
        let jitter = |i: u32| f64::from(i % 5) * 2.5 - 5.0;
        let yearly: Vec<f64> = (0..12).map(|i| YEAR_DAYS * f64::from(i) + jitter(i)).collect();
        assert!(columns(&yearly).is_empty());
        let creeping: Vec<f64> = (0..12)
            .map(|i| YEAR_DAYS * f64::from(i) + 2.5 * f64::from(i))
            .collect();
        assert!(columns(&creeping).is_empty());
    }

    #[test]
    fn exact_a_column_has_no_mean_over_the_last_year() {
        // over a whole year the mean is that of a cosine, 0
        let monthly: Vec<f64> = (0..12).map(|i| f64::from(i) / 12.0).collect();
        for column in columns(&at(4, &monthly)) {
            assert!((column.iter().sum::<f64>()).abs() < 1e-9, "{column:?}");
        }
        // two times of the year, 1/4 apart: the later reading represents 1/8 + 3/8 of the year, and so does the earlier one
        let [column] = columns(&at(8, &[0.2, 0.45])).try_into().unwrap();
        let [.., before, last] = column.as_slice() else {
            panic!("{column:?}")
        };
        assert!(
            (before + last).abs() < 1e-9 && (before - last).abs() > 1.0,
            "{column:?}"
        );
    }

    #[test]
    fn exact_what_columns_leave_is_across_them() {
        let days = at(5, &[0.1, 0.35, 0.5, 0.8]);
        let beside = beside(&days);
        let wave = |phase: f64| {
            days.iter()
                .map(|day| (TAU * day / YEAR_DAYS + phase).cos())
                .collect()
        };
        for rest in left(&beside, [wave(0.0), wave(1.0)]) {
            for column in &beside {
                assert!(dot(&rest, column).abs() < 1e-9);
            }
        }
    }
}
