//! Lowers the sampling rate.

use super::filter::run;
use super::sections::{Prototype, Sections};
use super::{Processing, Record, SignalError};

/// Corner of the anti-alias filter over the new Nyquist frequency, as in `scipy.signal.decimate`.
pub(crate) const CORNER_OF_NYQUIST: f64 = 0.8;
/// Order and ripple of one pass of the anti-alias filter, as in `scipy.signal.decimate`.
const ORDER: usize = 8;
const RIPPLE_DB: f64 = 0.05;

/// The record at 1/`factor` of its sampling rate, without delay.
///
/// A zero-phase Chebyshev low-pass of order 8 with its corner at 0.8 of the new Nyquist frequency, then every `factor`-th sample, beginning
/// with the first.
///
/// # Errors
/// [`SignalError::Factor`] below 2 or if fewer than 2 samples would be left, [`SignalError::TooShortForFilter`].
///
/// # Limits
/// Up to 0.8 of the new Nyquist frequency the gain is between 0.988 and 1. At the new Nyquist frequency the gain is at most 0.0053, so aliases
/// below 0.8 of that frequency are at most 1e-4 (−80 dB) of the original, for factors of 2 to 20.
///
/// # Source
/// The filter is that of `scipy.signal.decimate`. Differs from it: the ends are extended as in [`low_pass`](super::low_pass).
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, decimate};
/// let record = Record::new(vec![Channel::named("x")], vec![vec![1.0; 6000]], 100.0)?;
/// let record = decimate(record, 5)?;
/// assert_eq!((record.length(), record.sampling_rate_hz()), (1200, 20.0));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn decimate(mut record: Record, factor: usize) -> Result<Record, SignalError> {
    let most = record.length().saturating_sub(1);
    if !(2..=most).contains(&factor) {
        return Err(SignalError::Factor {
            given: factor,
            most,
            length: record.length(),
        });
    }
    let corner = CORNER_OF_NYQUIST * 0.5 / factor as f64;
    let prototype = Prototype::Chebyshev { ripple_db: RIPPLE_DB };
    run(
        "anti-alias",
        Sections::low_pass(prototype, ORDER, corner),
        &mut record,
    )?;
    let length = record.length().div_ceil(factor);
    record.retain_samples(0, factor, length);
    record.note(Processing::Decimate { factor });
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    fn mixed(channels: usize) -> Record {
        let names = (0..channels).map(|c| Channel::named(format!("{c}"))).collect();
        let x: Vec<f64> = (0..2000)
            .map(f64::from)
            .map(|i| (0.37 * i).sin() + 0.5 * (1.1 * i + 0.3).cos() + 0.01 * i + (0.02 * i).sin())
            .collect();
        Record::new(names, vec![x; channels], 100.0).unwrap()
    }

    // numpy 2.4.6, scipy 1.17.1, x and p as in filter.rs:
    //   sosfiltfilt(cheby1(8, .05, .8/q, output='sos'), x, padlen=p)[::q][[0, 1, 100, -1]]
    #[test]
    fn agrees_with_sosfiltfilt_of_the_filter_of_decimate() {
        for (factor, scipy) in [
            (
                4,
                [
                    0.4724549539615343,
                    0.9824670967555352,
                    4.594729484174583,
                    20.233839046586482,
                ],
            ),
            (
                5,
                [
                    0.47154321548132716,
                    0.9907771959233334,
                    4.747286054542462,
                    20.61290333313939,
                ],
            ),
        ] {
            let decimated = decimate(mixed(3), factor).unwrap();
            assert_eq!(decimated.length(), 2000 / factor);
            assert_eq!(decimated.sampling_rate_hz(), 100.0 / factor as f64);
            for channel in 0..3 {
                let x = decimated.samples(channel);
                for (got, expected) in [x[0], x[1], x[100], x[x.len() - 1]].into_iter().zip(scipy) {
                    assert!(
                        (got - expected).abs() < 1e-9,
                        "factor {factor}: {got}, scipy {expected}"
                    );
                }
            }
        }
    }

    #[test]
    fn refuses_factors_that_leave_nothing_or_change_nothing() {
        for given in [0, 1, 2000, usize::MAX] {
            assert_eq!(
                decimate(mixed(1), given).unwrap_err().to_string(),
                format!(
                    "the decimation factor is {given}, but must be 2 to 1999 (at least 2 samples of 2000 must be left): \
                     leave decimation out, or lower the factor"
                )
            );
        }
        assert!(
            decimate(mixed(1), 500)
                .unwrap_err()
                .to_string()
                .contains("the anti-alias filter rings for")
        );
    }
}
