//! Lowering the sampling rate.

use super::filter::run;
use super::sections::{Prototype, Sections};
use super::{Processing, Record, SignalError};

/// Corner of the anti-alias filter over the new Nyquist frequency (as `scipy.signal.decimate` has it).
const CORNER_OF_NYQUIST: f64 = 0.8;
/// Order and ripple of one pass of the anti-alias filter, as `scipy.signal.decimate` has them.
const ORDER: usize = 8;
const RIPPLE_DB: f64 = 0.05;

/// The record at 1/`factor` of its sampling rate, nothing delayed.
///
/// A zero-phase Chebyshev low-pass of order 8 with its corner at 0.8 of the new Nyquist frequency, then each
/// `factor`-th sample, beginning with the first.
///
/// # Errors
/// [`SignalError::Factor`] below 2 or if fewer than 2 samples would be left, [`SignalError::TooShortForFilter`].
///
/// # Limits
/// Up to 0.8 of the new Nyquist frequency the gain is between 0.988 and 1; at the new Nyquist frequency it is 0.0053 or
/// less, so what folds back below 0.8 of it is at most 1e-4 (−80 dB) of what it was, for factors of 2 to 20.
///
/// # Source
/// The filter is that of `scipy.signal.decimate`. Differs from it: the ends are continued as in [`low_pass`](super::low_pass).
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
