//! Whose measured tilt a chain takes over.

use super::part::{ChainLean, ChainPart};
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};

/// Gives the chain the tilt of the survey that `as_surveyed` chooses. The plane in which a chain moves is not said: it leans in it by the tilts of
/// all directions together.
pub(crate) fn lean_chain(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &[Survey],
    chain: &mut ChainPart,
) {
    let Some(survey) = as_surveyed(reader, given, surveys) else {
        return;
    };
    let tilts = survey.tilt.values();
    let ratio = tilts.map(|tilt| tilt.ratio * tilt.ratio).sum::<f64>().sqrt();
    let written = survey
        .tilt
        .iter()
        .map(|(direction, tilt)| format!("{direction} {}", tilt.written));
    chain.lean = Some(ChainLean {
        survey: survey.name.clone(),
        written: written.collect::<Vec<_>>().join(", "),
        lean_rad: ratio.atan(),
    });
}
