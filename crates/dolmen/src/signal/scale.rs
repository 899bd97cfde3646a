//! Multiplies channels by calibration factors, such as the value of one count of the recorder.

use super::{Processing, Record, SignalError};

/// Multiplies each channel by its own factor.
///
/// # Errors
/// [`SignalError::ChannelCount`]; [`SignalError::Argument`] for a factor that is 0 or not finite; [`SignalError::TooLarge`] for a
/// product that is too large.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, scale};
/// let record = Record::new(vec![Channel::named("a")], vec![vec![1.0, -2.0]], 100.0)?;
/// assert_eq!(scale(record, &[0.5])?.samples(0), [0.5, -1.0]);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn scale(record: Record, factors: &[f64]) -> Result<Record, SignalError> {
    if factors.len() != record.channels().len() {
        return Err(SignalError::ChannelCount {
            channels: record.channels().len(),
            series: factors.len(),
        });
    }
    if let Some(given) = factors.iter().find(|f| **f == 0.0 || !f.is_finite()) {
        return Err(SignalError::Argument {
            argument: "scale",
            given: *given,
            allowed: "a finite number other than 0",
        });
    }
    let scaled = |(j, factor): (usize, &f64)| record.samples(j).iter().map(|x| x * factor).collect();
    let samples = factors.iter().enumerate().map(scaled).collect();
    let mut out = Record::new(record.channels().to_vec(), samples, record.sampling_rate_hz())?;
    record.history().iter().for_each(|step| out.note(step.clone()));
    if let [first, rest @ ..] = factors
        && rest.iter().all(|f| f == first)
    {
        if *first != 1.0 {
            out.note(Processing::Scaled { factor: *first });
        }
    } else {
        for (channel, &factor) in record.channels().iter().zip(factors) {
            out.note(Processing::ChannelScaled {
                channel: channel.name.clone(),
                factor,
            });
        }
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    #[test]
    fn exact_each_channel_by_its_own_factor_and_refuses_none() {
        let channels = ["a", "b"].map(Channel::named).to_vec();
        let record = Record::new(channels, vec![vec![1.0, 2.0], vec![3.0, 4.0]], 10.0).unwrap();
        let scaled = scale(record.clone(), &[2.0, -1.0]).unwrap();
        assert_eq!(
            (scaled.samples(0), scaled.samples(1)),
            (&[2.0, 4.0][..], &[-3.0, -4.0][..])
        );
        assert_eq!(scaled.history()[1].to_string(), "b scaled by -1");
        let said = |factors: &[f64]| scale(record.clone(), factors).unwrap_err().to_string();
        assert_eq!(
            said(&[1.0, 0.0]),
            "scale is 0, but must be a finite number other than 0"
        );
        assert!(said(&[1.0]).starts_with("2 channels are described, but 1"));
        assert!(said(&[1.0, 1e120]).contains("no sample may be above"));
    }
}
