//! Stiffness of a frame from measured modes.

use crate::error::WorkError;
use crate::stiffness::MeasuredDirection;
use crate::surveyed::StiffnessAnswer;
use dolmen::stability::frame_stability;
use dolmen::structure::{Convention, Frame, FrameStiffness, frame_stiffness};
use dolmen_project::{FramePart, Pick};

/// Every stiffness that explains the modes, one answer for each convention; for a single storey, only that of the file.
pub(crate) fn stiffness(
    part: &FramePart,
    measured: &MeasuredDirection<'_>,
    pick: Pick<'_>,
) -> Result<Vec<StiffnessAnswer>, WorkError> {
    let built = part.build(pick)?;
    let mut answers = Vec::new();
    // with one storey both conventions are the same spring
    let is_one = built.storeys().len() == 1;
    let conventions = [Convention::Drift, Convention::Grounded];
    for convention in conventions
        .into_iter()
        .filter(|of| !is_one || *of == part.convention)
    {
        let frame = Frame::new(built.storeys().to_vec(), convention)?;
        let found = frame_stiffness(&frame, measured.modes, &FrameStiffness::default())?;
        let load_factor = |k: &[f64]| Ok(frame_stability(&frame, k)?.load_factor);
        answers.push(measured.answer(Some(convention), found, load_factor)?);
    }
    Ok(answers)
}
