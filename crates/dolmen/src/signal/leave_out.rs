//! Removes channels from a record.

use super::{Processing, Record, SignalError};

/// Returns the record without the named channels.
///
/// # Errors
/// [`SignalError::UnknownChannel`] if the record has no channel of that name, [`SignalError::NothingLeft`] if no channel
/// would remain.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, leave_out};
/// let record = Record::new(
///     vec![Channel::named("roof x"), Channel::named("dead")],
///     vec![vec![0.1, 0.3], vec![0.0, 0.0]],
///     100.0,
/// )?;
/// let record = leave_out(record, &["dead"])?;
/// assert_eq!(record.channels().len(), 1);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn leave_out(mut record: Record, names: &[&str]) -> Result<Record, SignalError> {
    if let Some(unknown) = names
        .iter()
        .find(|n| record.channels().iter().all(|c| c.name != **n))
    {
        return Err(SignalError::UnknownChannel {
            given: (*unknown).to_string(),
            names: record.channels().iter().map(|c| c.name.clone()).collect(),
        });
    }
    if names.is_empty() {
        return Ok(record);
    }
    let stays = |name: &str| !names.contains(&name);
    if !record.channels().iter().any(|c| stays(&c.name)) {
        return Err(SignalError::NothingLeft {
            channels: record.channels().len(),
        });
    }
    let gone = record.channels().iter().filter(|c| !stays(&c.name));
    let step = Processing::LeftOut {
        channels: gone.map(|c| c.name.clone()).collect(),
    };
    record.retain_channels(|c| stays(&c.name));
    record.note(step);
    Ok(record)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::Channel;

    fn record() -> Record {
        let channels = ["a", "b", "c"].map(Channel::named).to_vec();
        Record::new(
            channels,
            vec![vec![1.0, 2.0], vec![3.0, 4.0], vec![5.0, 6.0]],
            1.0,
        )
        .unwrap()
    }

    #[test]
    fn exact_the_others_stay_as_they_were() {
        let left = leave_out(record(), &["b"]).unwrap();
        assert_eq!(left.channels(), ["a", "c"].map(Channel::named));
        assert_eq!(
            (left.samples(0), left.samples(1)),
            (&[1.0, 2.0][..], &[5.0, 6.0][..])
        );
        assert_eq!(
            left.history(),
            [Processing::LeftOut {
                channels: vec!["b".into()]
            }]
        );
    }

    #[test]
    fn refuses_a_channel_that_is_not_there_and_lists_those_that_are() {
        let fault = leave_out(record(), &["a", "d"]).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "there is no channel \"d\"; the record has a, b, c"
        );
    }

    #[test]
    fn refuses_to_leave_out_everything() {
        let fault = leave_out(record(), &["a", "b", "c"]).unwrap_err();
        assert_eq!(
            fault.to_string(),
            "all 3 channels were to be left out, but at least 1 must stay"
        );
    }
}
