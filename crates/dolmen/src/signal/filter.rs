//! Zero-phase Butterworth filters.

use super::sections::{Prototype, Sections};
use super::{Processing, Record, SignalError};

/// Above it the gain at the corner is no more exact than a record is; nobody asks for it.
const ORDER_MOST: usize = 12;

/// The record with what lies above `corner_hz` taken out, nothing delayed.
///
/// A Butterworth filter of `order` (1 to 12; 4 is usual) runs forwards and backwards over each channel:
///
/// ```text
/// gain(f) = 1 / (1 + (tan(π f / f_s) / tan(π f_c / f_s))^(2 order))        1/2 at the corner
/// ```
///
/// # Errors
/// [`SignalError::Corner`] if the corner is not between 0 and the Nyquist frequency, [`SignalError::FilterOrder`],
/// [`SignalError::TooShortForFilter`] if the filter rings for longer than the record lasts.
///
/// # Limits
/// Both ends are continued by odd reflection for as long as the filter rings (to 1 %) and each pass starts from the
/// steady state; within that time of an end the result still depends on what was not measured.
///
/// # Source
/// Oppenheim & Schafer (2010) *Discrete-Time Signal Processing*, 3rd ed., sec. 7.2 (bilinear transform) and problem 5.67
/// (forwards and backwards); Gustafsson (1996) IEEE Trans. Signal Process. 44(4):988-992 on the ends. Agrees with
/// `scipy.signal.sosfiltfilt` given the same `padlen`. Differs from it: scipy continues the ends by 3 (2 sections + 1)
/// samples whatever the corner; here by as many as the filter rings.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, low_pass};
/// let slow: Vec<f64> = (0..2000).map(|i| (0.01 * i as f64).sin()).collect();
/// let shaken = slow.iter().enumerate().map(|(i, x)| x + (2.0 * i as f64).sin()).collect();
/// let record = low_pass(Record::new(vec![Channel::named("x")], vec![shaken], 100.0)?, 5.0, 4)?;
/// assert!((record.samples(0)[1000] - slow[1000]).abs() < 1e-4);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn low_pass(mut record: Record, corner_hz: f64, order: usize) -> Result<Record, SignalError> {
    let rate = record.sampling_rate_hz();
    check_corner("corner_hz", corner_hz, rate)?;
    check_order(order)?;
    let filter = Sections::low_pass(Prototype::Butterworth, order, corner_hz / rate);
    run("low-pass", filter, &mut record)?;
    record.note(Processing::LowPass { corner_hz, order });
    Ok(record)
}

/// The record with only what lies between `low_hz` and `high_hz`, nothing delayed.
///
/// A Butterworth filter of `order` (1 to 12; 4 is usual) on either side of the band runs forwards and backwards over each
/// channel. With w = tan(π f / f_s) and B = w_high - w_low:
///
/// ```text
/// gain(f) = 1 / (1 + ((w² - w_low w_high) / (B w))^(2 order))              1/2 at both corners
/// ```
///
/// # Errors
/// [`SignalError::Corner`] and [`SignalError::Band`] unless 0 < low < high < Nyquist, [`SignalError::FilterOrder`],
/// [`SignalError::TooShortForFilter`].
///
/// # Limits
/// As [`low_pass`]. The lower corner sets how long the ends are doubtful: 0.1 Hz of order 4 rings for 19 s.
///
/// # Source
/// As [`low_pass`].
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, band_pass};
/// let record = Record::new(vec![Channel::named("x")], vec![vec![9.81; 2000]], 100.0)?;
/// let record = band_pass(record, 0.5, 20.0, 4)?;
/// assert!(record.samples(0).iter().all(|x| x.abs() < 1e-9));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn band_pass(mut record: Record, low_hz: f64, high_hz: f64, order: usize) -> Result<Record, SignalError> {
    let rate = record.sampling_rate_hz();
    check_corner("low_hz", low_hz, rate)?;
    check_corner("high_hz", high_hz, rate)?;
    if low_hz >= high_hz {
        return Err(SignalError::Band { low_hz, high_hz });
    }
    check_order(order)?;
    let filter = Sections::band_pass(order, low_hz / rate, high_hz / rate);
    run("band-pass", filter, &mut record)?;
    record.note(Processing::BandPass {
        low_hz,
        high_hz,
        order,
    });
    Ok(record)
}

/// Runs the filter over each channel, unless it rings for longer than the record lasts.
pub(super) fn run(name: &'static str, mut filter: Sections, record: &mut Record) -> Result<(), SignalError> {
    if record.length() <= filter.ringing {
        return Err(SignalError::TooShortForFilter {
            filter: name,
            duration_s: record.duration_s(),
            ringing_s: filter.ringing as f64 / record.sampling_rate_hz(),
        });
    }
    for channel in 0..record.channels().len() {
        filter.forward_backward(record.samples_mut(channel));
    }
    Ok(())
}

fn check_corner(argument: &'static str, given: f64, rate: f64) -> Result<(), SignalError> {
    let nyquist_hz = 0.5 * rate;
    if given > 0.0 && given < nyquist_hz {
        return Ok(());
    }
    Err(SignalError::Corner {
        argument,
        given,
        nyquist_hz,
    })
}

fn check_order(given: usize) -> Result<(), SignalError> {
    if (1..=ORDER_MOST).contains(&given) {
        return Ok(());
    }
    Err(SignalError::FilterOrder {
        given,
        most: ORDER_MOST,
    })
}
