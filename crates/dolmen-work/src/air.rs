//! The air temperature at a survey, from a log.

use dolmen_records::Log;

const HOUR_S: f64 = 3600.0;
const DAY_S: f64 = 86_400.0;
/// Plausible temperatures, °C.
pub(crate) const BELIEVED_C: std::ops::RangeInclusive<f64> = -60.0..=60.0;

/// The temperature from a given time on, s from 1970, °C to a tenth: the mean over a record of the given length, otherwise the nearest
/// reading within an hour, or the mean of the day if the time is unknown. `None` without a plausible reading.
pub(crate) fn air_temperature_c(log: &Log, from_s: f64, duration_s: Option<f64>) -> Option<f64> {
    let read = match duration_s {
        Some(duration_s) => log.around(from_s, from_s + duration_s, HOUR_S),
        None => log.around(from_s, from_s + DAY_S, 0.0),
    };
    read.map(|celsius| (10.0 * celsius).round() / 10.0)
        .filter(|celsius| BELIEVED_C.contains(celsius))
}
