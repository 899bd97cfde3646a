//! Isolated surveys of a mode: a single wrong reading is not a lasting change, and must neither hide nor cause one.

use super::regression::{Fit, restricted_likelihood};
use super::weather::{ModeSeries, WeatherKnown, columns, has_temperature};
use crate::numeric::middle;

/// Number of standard deviations from its neighbours beyond which a reading is isolated. Our choice: by chance one in 500 million.
const ALONE: f64 = 6.0;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;
/// Fewest readings for a comparison with neighbours.
const READINGS_LEAST: usize = 8;

/// Indices of the readings that differ by more than six standard deviations from the two readings before and the two after them,
/// after the effect of weather is removed. The last two readings are left to the alarm.
pub(super) fn outliers(series: &ModeSeries) -> Vec<usize> {
    let n = series.len();
    if n < READINGS_LEAST {
        return Vec::new();
    }
    let with_temperature = series.kept(|i| series.temperatures_c[i].is_finite());
    let readings = if has_temperature(series) && with_temperature.len() == n {
        let known: f64 = series.temperatures_c.iter().sum::<f64>() / n as f64;
        let columns = columns(series, WeatherKnown::Temperature, (known, 0.0));
        restricted_likelihood(&series.series, &columns, None)
            .and_then(|disturbance| Fit::new(&series.series, &columns, disturbance))
            .map_or_else(
                || series.series.readings.clone(),
                |fit| fit.residuals(&series.series, &columns),
            )
    } else {
        series.series.readings.clone()
    };
    let off: Vec<[f64; 4]> = (2..n - 2)
        .map(|i| {
            let mut near = [readings[i - 2], readings[i - 1], readings[i + 1], readings[i + 2]];
            near.sort_by(f64::total_cmp);
            near.map(|other| readings[i] - other)
        })
        .collect();
    let of_median = off.iter().map(|off| 0.5 * (off[1] + off[2]).abs());
    let spread = OF_MEDIAN * middle(of_median.collect());
    let found = off.iter().enumerate();
    found
        .filter(|(i, off)| {
            let limit = ALONE * spread.max(series.series.noise_sd[i + 2]);
            // next to a step, a reading is far from two neighbours but not from all of them
            off.iter().all(|off| *off > limit) || off.iter().all(|off| *off < -limit)
        })
        .map(|(i, _)| i + 2)
        .collect()
}
