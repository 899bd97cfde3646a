//! Cuts a time span out of a record.

use super::{Processing, Record, SignalError};

/// The part of the record from `from_s` to `to_s`, seconds from its start.
///
/// Sample i is at time i / rate. The first sample kept is the nearest to `from_s`; the sample nearest to `to_s` is the
/// first one dropped. So two adjacent cuts neither share nor lose a sample. Time starts again at 0.
///
/// # Errors
/// [`SignalError::Cut`] if the part is not within the record or holds fewer than 2 samples.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, cut};
/// let record = Record::new(vec![Channel::named("x")], vec![vec![0.0; 1000]], 100.0)?;
/// assert_eq!(cut(record, 2.0, 5.0)?.length(), 300);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn cut(mut record: Record, from_s: f64, to_s: f64) -> Result<Record, SignalError> {
    let rate = record.sampling_rate_hz();
    let (start, end) = ((from_s * rate).round(), (to_s * rate).round());
    // the comparisons are false for NaN
    let within = start >= 0.0 && end <= record.length() as f64 && end - start >= 2.0;
    if !within {
        return Err(SignalError::Cut {
            from_s,
            to_s,
            least_s: 2.0 / rate,
            duration_s: record.duration_s(),
        });
    }
    let (start, end) = (start as usize, end as usize);
    record.retain_samples(start, 1, end - start);
    record.note(Processing::Cut { from_s, to_s });
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;
    use proptest::prelude::*;

    fn ramp(length: usize) -> Record {
        let channels = ["a", "b"].map(Channel::named).to_vec();
        let a: Vec<f64> = (0..length).map(|i| i as f64).collect();
        let b = a.iter().map(|x| -x).collect();
        Record::new(channels, vec![a, b], 10.0).unwrap()
    }

    #[test]
    fn exact_the_samples_of_that_time() {
        let part = cut(ramp(100), 0.3, 0.6).unwrap();
        assert_eq!(part.samples(0), [3.0, 4.0, 5.0]);
        assert_eq!(part.samples(1), [-3.0, -4.0, -5.0]);
        assert_eq!(
            part.history(),
            [Processing::Cut {
                from_s: 0.3,
                to_s: 0.6
            }]
        );
    }

    proptest! {
        #[test]
        fn holds_two_neighbours_make_the_whole(at_s in 0.3..9.7) {
            let (before, after) = (cut(ramp(100), 0.0, at_s).unwrap(), cut(ramp(100), at_s, 10.0).unwrap());
            let whole = ramp(100);
            for channel in 0..2 {
                let joined = [before.samples(channel), after.samples(channel)].concat();
                prop_assert_eq!(joined, whole.samples(channel));
            }
        }
    }

    #[test]
    fn refuses_a_cut_outside_the_record() {
        for (from_s, to_s) in [
            (-1.0, 5.0),
            (0.0, 10.2),
            (5.0, 5.1),
            (6.0, 5.0),
            (f64::NAN, 5.0),
            (0.0, f64::NAN),
        ] {
            let fault = cut(ramp(100), from_s, to_s).unwrap_err();
            assert_eq!(
                fault.to_string(),
                format!(
                    "the cut from {from_s} s to {to_s} s is refused: it must go forwards, hold at least 2 samples \
                     (0.2 s) and lie within the record, 0 to 10 s"
                )
            );
        }
    }
}
