//! Zero-phase Butterworth filters.

use super::sections::{Prototype, Sections};
use super::{Processing, Record, SignalError};

/// Highest order. At higher orders the gain at the corner loses accuracy.
const ORDER_MOST: usize = 12;

/// Low-pass filter without delay: removes frequencies above `corner_hz`.
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
/// Both ends are extended by odd reflection over the ringing time of the filter (decay to 1 %), and each pass starts from the steady state.
/// Nearer to an end than this time, the result depends on the extension.
///
/// # Source
/// Oppenheim & Schafer (2010) *Discrete-Time Signal Processing*, 3rd ed., sec. 7.2 (bilinear transform) and problem 5.67 (forwards and
/// backwards); Gustafsson (1996) IEEE Trans. Signal Process. 44(4):988-992 on the ends. Agrees with `scipy.signal.sosfiltfilt` for the same
/// `padlen`. Differs from it: scipy always extends the ends by 3 (2 sections + 1) samples; here the extension is the ringing time.
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

/// Band-pass filter without delay: keeps frequencies between `low_hz` and `high_hz`.
///
/// A Butterworth filter of `order` (1 to 12; 4 is usual) at each side of the band runs forwards and backwards over each channel. With w =
/// tan(π f / f_s) and B = w_high - w_low:
///
/// ```text
/// gain(f) = 1 / (1 + ((w² - w_low w_high) / (B w))^(2 order))              1/2 at both corners
/// ```
///
/// # Errors
/// [`SignalError::Corner`] and [`SignalError::Band`] unless 0 < low < high < Nyquist, [`SignalError::FilterOrder`],
/// [`SignalError::TooShortForFilter`] if the filter rings for longer than the record.
///
/// # Limits
/// As [`low_pass`]. The lower corner determines the ringing time: a filter of order 4 with its corner at 0.1 Hz rings for 19 s.
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

/// Runs the filter over each channel; refuses a filter that rings longer than the record.
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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;
    use std::f64::consts::TAU;

    const RATE_HZ: f64 = 100.0;

    fn record(x: Vec<f64>) -> Record {
        Record::new(vec![Channel::named("x")], vec![x], RATE_HZ).unwrap()
    }

    fn mixed() -> Record {
        let x = (0..2000).map(f64::from);
        record(
            x.map(|i| (0.37 * i).sin() + 0.5 * (1.1 * i + 0.3).cos() + 0.01 * i + (0.02 * i).sin())
                .collect(),
        )
    }

    // numpy 2.4.6, scipy 1.17.1:
    //   i = np.arange(2000); x = np.sin(.37*i) + .5*np.cos(1.1*i+.3) + .01*i + np.sin(.02*i)
    //   sos = butter(4, 8., fs=100, output='sos')                       and so on for each line
    //   r = max(abs(np.roots(s[3:])).max() for s in sos); p = ceil(log(.01)/log(r))
    //   sosfiltfilt(sos, x, padlen=p)[[0, 1, 2, 700, 1998, 1999]]
    const AT: [usize; 6] = [0, 1, 2, 700, 1998, 1999];

    fn agree(filtered: &Record, scipy: [f64; 6]) {
        for (at, expected) in AT.into_iter().zip(scipy) {
            let got = filtered.samples(0)[at];
            assert!(
                (got - expected).abs() < 1e-10,
                "sample {at}: {got}, scipy {expected}"
            );
        }
    }

    #[test]
    #[rustfmt::skip]
    fn agrees_with_sosfiltfilt_low_pass() {
        for (corner_hz, order, scipy) in [
            (8.0, 4, [0.47633324688530715, 0.672032298411085, 0.8415074534451059, 8.901253580176627, 20.407674773486736, 20.26347041913999]),
            (3.0, 5, [0.4766127009610394, 0.44811616697192247, 0.4204103692406534, 7.991669734040029, 20.343712594461138, 20.26873784117884]),
            (3.0, 1, [0.4776884693328654, 0.49126242341085075, 0.5066439260716912, 8.170070110478378, 20.344165850218193, 20.268639769515858]),
        ] {
            agree(&low_pass(mixed(), corner_hz, order).unwrap(), scipy);
        }
    }

    #[test]
    #[rustfmt::skip]
    fn agrees_with_sosfiltfilt_band_pass() {
        for (low_hz, high_hz, order, scipy) in [
            (0.5, 20.0, 4, [0.0007287474305157637, -0.19014809770672794, -0.18045550988751485, 0.6763690892831584, -0.2826039832420926, 0.00013625801125793924]),
            (2.0, 4.0, 3, [0.0001805790625416595, -0.0384528536044971, -0.07580308683153934, 0.006928084548946301, 0.07727433979864476, -0.00012457321423871293]),
            (0.5, 40.0, 1, [-0.003490811769437052, -0.03052640150778252, -0.1544770822383534, 0.8697239212484311, -0.11195202773498622, 0.0005903310299957554]), // two real poles
        ] {
            agree(&band_pass(mixed(), low_hz, high_hz, order).unwrap(), scipy);
        }
    }

    /// Amplitude and quadrature part of a filtered sine of this frequency, in the middle of 100 s.
    fn gain(filter: impl Fn(Record) -> Record, frequency_hz: f64) -> (f64, f64) {
        let sine = |i: usize| (TAU * frequency_hz * i as f64 / RATE_HZ).sin();
        let filtered = filter(record((0..10_000).map(sine).collect()));
        let middle = 2500..7500; // whole periods of every multiple of 0.02 Hz
        let (mut along, mut across) = (0.0, 0.0);
        for i in middle.clone() {
            let angle = TAU * frequency_hz * i as f64 / RATE_HZ;
            along += filtered.samples(0)[i] * angle.sin();
            across += filtered.samples(0)[i] * angle.cos();
        }
        (
            2.0 * along / middle.len() as f64,
            2.0 * across / middle.len() as f64,
        )
    }

    #[test]
    fn exact_gain_without_delay() {
        let warp = |frequency_hz: f64| (std::f64::consts::PI * frequency_hz / RATE_HZ).tan();
        for frequency_hz in [0.3, 1.0, 2.0, 5.0, 8.0, 12.0, 20.0] {
            let w = warp(frequency_hz);
            let low = 1.0 / (1.0 + (w / warp(8.0)).powi(8));
            let (along, across) = gain(|r| low_pass(r, 8.0, 4).unwrap(), frequency_hz);
            assert!(
                (along - low).abs() < 1e-8 && across.abs() < 1e-8,
                "low-pass at {frequency_hz} Hz: {along}, {low}"
            );

            let (w1, w2) = (warp(1.0), warp(8.0));
            let band = 1.0 / (1.0 + ((w * w - w1 * w2) / ((w2 - w1) * w)).powi(8));
            let (along, across) = gain(|r| band_pass(r, 1.0, 8.0, 4).unwrap(), frequency_hz);
            assert!(
                (along - band).abs() < 1e-8 && across.abs() < 1e-8,
                "band-pass at {frequency_hz} Hz: {along}, {band}"
            );
        }
    }

    #[test]
    fn holds_time_reversed_is_the_same_reversed() {
        let reversed = |r: &Record| record(r.samples(0).iter().rev().copied().collect());
        let forwards = band_pass(mixed(), 2.0, 4.0, 4).unwrap();
        let backwards = band_pass(reversed(&mixed()), 2.0, 4.0, 4).unwrap();
        let middle = |r: &Record| r.samples(0)[500..1500].to_vec();
        for (a, b) in middle(&forwards).into_iter().zip(middle(&reversed(&backwards))) {
            assert!((a - b).abs() < 1e-6, "{a} {b}"); // the ends are started differently
        }
    }

    #[test]
    fn refuses_corners_that_cannot_be() {
        let message = |result: Result<Record, SignalError>| result.unwrap_err().to_string();
        assert_eq!(
            message(low_pass(mixed(), 50.0, 4)),
            "corner_hz is 50 Hz, but must lie above 0 and below the Nyquist frequency 50 Hz (half the sampling rate): lower \
             it, or leave the filter out"
        );
        assert!(message(low_pass(mixed(), f64::NAN, 4)).starts_with("corner_hz is NaN Hz"));
        assert!(message(band_pass(mixed(), 0.0, 20.0, 4)).starts_with("low_hz is 0 Hz"));
        assert!(message(band_pass(mixed(), 1.0, 60.0, 4)).starts_with("high_hz is 60 Hz"));
        assert_eq!(
            message(band_pass(mixed(), 20.0, 0.5, 4)),
            "low_hz is 20 Hz and high_hz is 0.5 Hz, but low_hz must be the lower one: exchange them"
        );
        assert_eq!(
            message(low_pass(mixed(), 5.0, 0)),
            "order is 0, but must be 1 to 12: 4 is usual"
        );
        assert_eq!(
            message(band_pass(mixed(), 1.0, 5.0, 13)),
            "order is 13, but must be 1 to 12: 4 is usual"
        );
    }

    #[test]
    fn refuses_a_record_shorter_than_the_filter_rings() {
        let fault = band_pass(record(vec![0.0; 1000]), 0.1, 20.0, 4).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "the record lasts 10 s, but the band-pass filter rings for 19.280 s at each end: take a longer record, or a \
             corner further from 0 Hz"
        );
    }
}
