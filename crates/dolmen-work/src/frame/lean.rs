//! A frame that leans as surveyed, at rest.

use super::columns::{StoreyColumns, alone_storeys};
use crate::error::WorkError;
use dolmen::assess::demand::DRIFT_RATIO_MOST;
use dolmen::stability::frame_lean_at_rest;
use dolmen::structure::Frame;
use dolmen_project::{DirectionPart, FramePart, Pick};

/// A direction of a frame that leans as surveyed.
#[derive(Clone, Debug, PartialEq)]
pub struct DirectionLean {
    /// The measured tilt, horizontal over vertical.
    pub tilt: f64,
    /// Lean of each storey at rest under its weight, lowest first: the larger of sticking and slipping joints.
    pub at_rest: Vec<f64>,
    /// Lean at which each storey has fallen: the limit of small drifts, or the fall of its free-standing columns. Where columns alone support
    /// it, the lean at rest in proportion to the tilt that overturns them.
    pub most: Vec<f64>,
}

impl DirectionLean {
    /// The lean in a direction; `None` if it has no tilt, is unknown, or falls upright.
    pub(super) fn of(
        part: &FramePart,
        frame: &Frame,
        direction: &DirectionPart,
        columns: &[StoreyColumns],
        pick: Pick<'_>,
    ) -> Result<Option<Self>, WorkError> {
        let tilt = part.tilt(&direction.name);
        let at_rest = leaning(part, frame, direction, pick)?.filter(|_| tilt != 0.0);
        let falls = |storey: usize| {
            let own = columns.iter().find(|own| own.storey == storey + 1)?;
            Some(own.standing.map_or(0.0, |standing| standing.falls.drift_m) / own.height_m)
        };
        let alone = alone_storeys(part, &direction.name, pick)?;
        let most = |(storey, lean): (usize, &f64)| match &alone[storey] {
            Some(alone) => lean.abs() * alone.overturns / tilt.abs(),
            None => falls(storey).map_or(DRIFT_RATIO_MOST, |falls| falls.min(DRIFT_RATIO_MOST)),
        };
        Ok(at_rest.map(|at_rest| DirectionLean {
            tilt,
            most: at_rest.iter().enumerate().map(most).collect(),
            at_rest,
        }))
    }

    /// The storey nearest to its fall, 0 the lowest, and its lean over the limit.
    pub fn worst(&self) -> (usize, f64) {
        let shares = self
            .at_rest
            .iter()
            .zip(&self.most)
            .map(|(lean, most)| lean.abs() / most);
        let worst = shares.enumerate().max_by(|a, b| a.1.total_cmp(&b.1));
        worst.unwrap_or((0, 0.0))
    }
}

/// Lean of each storey at rest in a direction, the larger of sticking and slipping joints, and by the force of the columns over drift where
/// they alone support it; `None` if it has no tilt, is unknown, or falls. Columns that the tilt overturns lean to their fall.
pub(super) fn leaning(
    part: &FramePart,
    frame: &Frame,
    direction: &DirectionPart,
    pick: Pick<'_>,
) -> Result<Option<Vec<f64>>, WorkError> {
    let tilt = part.tilt(&direction.name);
    let known = part.stiffness_n_m(&direction.name, pick);
    let Some(stuck) = known.filter(|_| tilt != 0.0) else {
        return Ok(None);
    };
    let Some(mut leans) = frame_lean_at_rest(frame, &stuck, tilt)? else {
        return Ok(None);
    };
    if let Some(slipping) = part.slipping_stiffness_n_m(&direction.name, pick) {
        for (lean, slipped) in leans
            .iter_mut()
            .zip(frame_lean_at_rest(frame, &slipping, tilt)?.into_iter().flatten())
        {
            if slipped.abs() > lean.abs() {
                *lean = slipped;
            }
        }
    }
    let alone = alone_storeys(part, &direction.name, pick)?;
    for ((lean, alone), storey) in leans.iter_mut().zip(alone).zip(frame.storeys()) {
        if let Some(alone) = alone {
            let balance = alone.balance(tilt, storey.height_m)?;
            let size = balance.map_or(alone.falls, |drift| drift) + tilt.abs();
            *lean = size.copysign(tilt);
        }
    }
    Ok(Some(leans))
}
