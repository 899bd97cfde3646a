//! The survey whose measured tilt a frame takes.

use super::part::{FrameLean, FramePart};
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};

/// Gives the frame the tilt of the survey that `as_surveyed` chooses.
pub(crate) fn lean_frame(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &[Survey],
    frame: &mut FramePart,
) {
    frame.takes_no_tilt = given.is_some_and(|given| given.value == "none");
    let Some(survey) = as_surveyed(reader, given, surveys) else {
        return;
    };
    let together = survey.tilt_together();
    let place = |of: &str| {
        let mut own = frame.directions.iter();
        own.position(|own| own.name == of || own.along.is_some_and(|along| along.name() == of))
    };
    let mut tilts = vec![0.0; frame.directions.len()];
    for (direction, tilt) in &survey.tilt {
        match place(direction) {
            Some(place) => tilts[place] = tilt.ratio,
            None => {
                tilts = vec![together; frame.directions.len()];
                break;
            }
        }
    }
    let written = survey
        .tilt
        .iter()
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written));
    frame.lean = Some(FrameLean {
        survey: survey.name.clone(),
        written: written.collect::<Vec<_>>().join(", "),
        tilts,
        together,
    });
}
