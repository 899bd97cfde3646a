//! Channels with their own clocks and sampling rates, compared with the original sines.

use super::{Case, ValidationError};
use crate::signal::{Channel, Join, Piece, SignalError, join};
use std::f64::consts::TAU;

const SOURCE: &str = "Closed form";
const NOTE: &str = "Published is the sine at that time; its amplitude is 1. The filter is flat to 0.8 of the Nyquist frequency, \
                    50 Hz.";

/// Largest value in the middle second of the second of two channels, joined at 100 Hz, and that of the sine
/// itself.
fn largest(frequency_hz: f64, begins_s: f64, rate_hz: f64) -> Result<[f64; 2], SignalError> {
    let sine = |t: f64| (TAU * frequency_hz * t).sin();
    let piece = |name: &str, begins_s: f64, rate_hz: f64| Piece {
        channel: Channel::named(name),
        samples: (0..(5.0 * rate_hz) as usize)
            .map(|i| sine(begins_s + i as f64 / rate_hz))
            .collect(),
        sampling_rate_hz: rate_hz,
        begins_s: Some(begins_s),
    };
    let joined = join(
        vec![piece("a", 0.0, 100.0), piece("b", begins_s, rate_hz)],
        &Join::default(),
    )?;
    let middle = joined.record.length() / 2;
    let largest = |channel: usize| {
        let part = &joined.record.samples(channel)[middle - 50..middle + 50];
        part.iter().fold(0.0f64, |most, x| most.max(x.abs()))
    };
    Ok([largest(1), largest(0)])
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    const RIPPLE: f64 = 1e-5; // of the filter, as stated in its documentation
    let case = |what: &str, published: f64, computed: f64, note| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit: "",
        published,
        computed,
        tolerance: RIPPLE,
        corrected: None,
        note,
    };
    let [late, its_own] = largest(39.0, 0.3737, 100.0)?;
    let [slower, same] = largest(39.0, 0.0, 250.0)?;
    let [folded, _] = largest(62.0, 0.0, 250.0)?;
    Ok(vec![
        case(
            "two stations, one 0.37 of a step late: 39 Hz, largest sample",
            its_own,
            late,
            NOTE,
        ),
        case(
            "one station at 250 Hz, one at 100 Hz: 39 Hz, largest sample",
            same,
            slower,
            NOTE,
        ),
        case(
            "one station at 250 Hz, one at 100 Hz: what is left of 62 Hz",
            0.0,
            folded,
            "It would be seen as 38 Hz.",
        ),
    ])
}
