//! Leaves failed sensors out of a record, so that they do not spoil the others.

use crate::error::WorkError;
use crate::identify;
use crate::progress::Progress;
use crate::record;
use crate::sensor_alarms::SensorFault;
use crate::surveyed::SurveyAnswer;
use dolmen::modal::ModalError;
use dolmen::signal::ChannelFault;
use dolmen_project::{ChannelSource, Column, RecordSource, Survey};
use dolmen_records::Files;

/// Leaves out unusable channels, and one of two with the same signal, if others remain; returns their names.
pub(crate) fn without(why: &WorkError, source: &mut RecordSource) -> Option<Vec<String>> {
    let fault = match why {
        WorkError::Within { cause, .. } => return without(cause, source),
        WorkError::Modal(why) => match why.as_ref() {
            ModalError::Channel(fault) => fault,
            _ => return None,
        },
        _ => return None,
    };
    let named = match fault {
        ChannelFault::Duplicated { channel, other, .. } => vec![channel.clone(), other.clone()],
        fault => vec![SensorFault::of(fault).0],
    };
    let used = source.channels.iter_mut().filter(|channel| !channel.leave_out);
    let (failed, rest): (Vec<_>, Vec<_>) = used.partition(|channel| named.contains(&record::name(channel)));
    if failed.len() != named.len() || rest.is_empty() {
        return None;
    }
    failed.into_iter().for_each(|channel| channel.leave_out = true);
    Some(named)
}

/// Modes of a survey's records without failed sensors, and the names of those. Their faults stay in the list of faults.
///
/// # Errors
/// If records cannot be read, or contain no modes.
pub(crate) fn found_without(
    survey: &Survey,
    files: &dyn Files,
    progress: &dyn Progress,
) -> Result<(SurveyAnswer, Vec<String>), WorkError> {
    let (mut survey, mut left_out, mut faults) = (survey.clone(), Vec::new(), None);
    loop {
        let why = match identify::found_in(&survey, files, progress) {
            Ok(mut answer) => {
                if let (Some(record), Some(faults)) = (&mut answer.records, faults) {
                    record.faults = faults;
                }
                return Ok((answer, left_out));
            }
            Err(why) => why,
        };
        let Some(source) = &mut survey.records else {
            return Err(why);
        };
        let whole = source.clone();
        if source.channels.is_empty() {
            source.channels = channels(&whole, files)?;
        }
        let Some(failed) = without(&why, source) else {
            return Err(why);
        };
        left_out.extend(failed);
        if faults.is_none() {
            faults = Some(record::record(&whole, files)?.faults);
        }
    }
}

/// The channels of a record in the form of a project.
fn channels(source: &RecordSource, files: &dyn Files) -> Result<Vec<ChannelSource>, WorkError> {
    let read = record::record(source, files)?;
    let each = read.record.channels().iter().map(|channel| ChannelSource {
        column: Column::Name(channel.name.clone()),
        name: None,
        position_m: channel.position_m,
        direction: channel.direction,
        scale: None,
        leave_out: false,
    });
    Ok(each.collect())
}
