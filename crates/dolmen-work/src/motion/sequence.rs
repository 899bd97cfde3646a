//! Two motions one after the other.

use super::acting::MotionAnswer;
use crate::error::WorkError;
use dolmen::signal::{Component, GroundMotion, motion_sequence};

/// Both motions as one with still ground between them, and its duration, s: at least `still_s`, rounded up to a sample.
///
/// # Errors
/// Motions whose steps have no common one.
pub(crate) fn in_sequence(
    first: MotionAnswer,
    still_s: f64,
    second: MotionAnswer,
) -> Result<(MotionAnswer, f64), WorkError> {
    let both = motion_sequence(&first.motion, still_s, &second.motion)?;
    let answer = MotionAnswer {
        motion: both.motion,
        files: [first.files, second.files].concat(),
        peaks_read_m_s2: [first.peaks_read_m_s2, second.peaks_read_m_s2].concat(),
        turned_rad: first.turned_rad,
        taken_off: first.taken_off,
        measured: None, // a measured response to one motion does not apply to both
    };
    Ok((answer, both.still_s))
}

/// Refuses two motions with different horizontal components for structures that move in planes, each with one component.
///
/// # Errors
/// [`WorkError::ThenComponents`].
pub(crate) fn refuse_other_components(first: &GroundMotion, second: &GroundMotion) -> Result<(), WorkError> {
    let horizontal = [Component::X, Component::Y];
    match horizontal
        .iter()
        .all(|component| first.has(*component) == second.has(*component))
    {
        true => Ok(()),
        false => Err(WorkError::ThenComponents {
            first: first.name().to_owned(),
            second: second.name().to_owned(),
        }),
    }
}
