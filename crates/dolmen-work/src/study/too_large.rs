//! Studies that would take too long, or whose results exceed the memory.

use super::error::StudyError;
use crate::error::WorkError;
use dolmen_project::StudyPart;

/// Largest number of scans of a study: the results of more do not fit into memory. Our choice.
const SCANS_MOST: usize = 10_000_000;
/// Largest number of points in the maps of all cases of a study. Our choice: at a millisecond a point they take half an hour on one core.
const POINTS_MOST: usize = 1_000_000;

/// Refuses a study with too many scans or points of maps; `motions` is the number of its motions.
pub(super) fn refuse_too_large(study: &StudyPart, motions: usize) -> Result<(), WorkError> {
    let cases = study.combinations().saturating_mul(study.samples.unwrap_or(1));
    let scans = cases
        .saturating_mul(motions.max(1))
        .saturating_mul(study.turns_rad.len());
    if scans > SCANS_MOST {
        let most = SCANS_MOST;
        return Err(StudyError::StudyTooLarge { scans, most }.into());
    }
    let Some(part) = &study.harmonic else {
        return Ok(());
    };
    let sides = [part.frequencies_hz.len(), part.accelerations_m_s2.len()];
    match sides.into_iter().fold(cases, usize::saturating_mul) {
        points if points > POINTS_MOST => {
            let most = POINTS_MOST;
            Err(StudyError::MapsTooLarge { points, most }.into())
        }
        _ => Ok(()),
    }
}
