//! The survey whose measured tilt a chain takes.

use super::part::{ChainLean, ChainPart};
use crate::file_number::At;
use crate::reader::Reader;
use crate::survey::{Survey, as_surveyed};

/// Gives the chain the tilt of the survey that `as_surveyed` chooses. The plane of motion of a chain with one direction is unknown: it
/// leans by the combined tilt of all directions.
pub(crate) fn lean_chain(
    reader: &mut Reader,
    given: Option<&At<String>>,
    surveys: &[Survey],
    chain: &mut ChainPart,
) {
    chain.takes_no_tilt = given.is_some_and(|given| given.value == "none");
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
        each_rad: tilt_of_axes(survey).map(f64::atan),
    });
}

/// The tilt of a survey along x and along y; the combined tilt for both if a direction has another name.
pub fn tilt_of_axes(survey: &Survey) -> [f64; 2] {
    let named = survey
        .tilt
        .keys()
        .all(|direction| direction == "x" || direction == "y");
    let of = |direction: &str| survey.tilt.get(direction).map_or(0.0, |tilt| tilt.ratio);
    let together = survey
        .tilt
        .values()
        .map(|tilt| tilt.ratio * tilt.ratio)
        .sum::<f64>()
        .sqrt();
    match named {
        true => [of("x"), of("y")],
        false => [together; 2],
    }
}
