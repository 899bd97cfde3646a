//! Two motions one after the other.

use super::acting::MotionAnswer;
use crate::error::WorkError;
use dolmen::signal::{Component, GroundMotion, motion_sequence};

/// Both motions as one, with the ground still between them for `still_s` or up to a sample more: how long, s, stands beside it.
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
        measured: None, // what was measured beside one of them is not beside both
    };
    Ok((answer, both.still_s))
}

/// Refuses two motions of other horizontal components for what moves in planes, each of which meets one component.
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
