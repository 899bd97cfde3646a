//! The check of a frame.

use super::columns::columns;
use super::lean::DirectionLean;
use super::tenons::tenons;
use crate::error::WorkError;
use crate::state::DirectionCheck;
use dolmen::assess::check_frame;
use dolmen::stability::frame_stability;
use dolmen_project::{FramePart, Pick};

/// Checks a frame in each direction, with the value of each input that `pick` chooses.
pub(crate) fn check(part: &FramePart, pick: Pick<'_>) -> Result<Vec<DirectionCheck>, WorkError> {
    let frame = part.build(pick)?;
    let mut checks = Vec::new();
    for direction in &part.directions {
        let stiffness = part.stiffness_n_m(&direction.name, pick);
        let check = check_frame(&frame, stiffness.as_deref())?;
        let slipping = match part.slipping_stiffness_n_m(&direction.name, pick) {
            Some(slipping) => Some(check_frame(&frame, Some(&slipping))?),
            None => None,
        };
        let columns = columns(part, &frame, stiffness.as_deref(), pick)?;
        checks.push(DirectionCheck {
            direction: direction.name.clone(),
            lean: DirectionLean::of(part, &frame, direction, &columns, pick)?,
            tenons: tenons(part, &frame, (&direction.name, stiffness.as_deref()), pick)?,
            columns,
            check,
            slipping,
        });
    }
    Ok(checks)
}

/// The smallest load factor of all directions; `None` unless the stiffness is known in every one.
pub(crate) fn load_factor(part: &FramePart, pick: Pick<'_>) -> Result<Option<f64>, WorkError> {
    let frame = part.build(pick)?;
    let mut least: Option<f64> = None;
    for direction in &part.directions {
        let Some(stiffness) = part.stiffness_n_m(&direction.name, pick) else {
            return Ok(None); // an unknown direction does not count as standing
        };
        let factor = frame_stability(&frame, &stiffness)?.load_factor;
        least = Some(least.map_or(factor, |other| other.min(factor)));
    }
    Ok(least)
}

/// The smaller of the load factor `stuck` and that of the frame with slipping joints.
pub(crate) fn least_load_factor(part: &FramePart, stuck: f64, pick: Pick<'_>) -> Result<f64, WorkError> {
    let frame = part.build(pick)?;
    let mut least = stuck;
    for direction in &part.directions {
        if let Some(slipping) = part.slipping_stiffness_n_m(&direction.name, pick) {
            least = least.min(frame_stability(&frame, &slipping)?.load_factor);
        }
    }
    Ok(least)
}
