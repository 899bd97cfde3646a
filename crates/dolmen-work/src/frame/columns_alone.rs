//! A frame on its free-standing columns alone, over time: rigid columns that rock under a rigid beam.

use crate::error::WorkError;
use dolmen::dynamics::{Rocking, RockingBlock, RockingHistory, RockingOutcome, TimeFunction, rock_block};
use dolmen_project::{FramePart, Pick};

/// Result of a simulation for the free-standing columns of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnsInMotion {
    /// The frame has no such columns.
    Absent,
    /// The frame has such columns, but several storeys.
    SeveralStoreys,
    /// The frame has such columns, but their beds are compliant: rigid columns would stand too long.
    OnBeds,
    /// The frame has such columns, but the ground moves along x and y: rolling on a corner or around the edge is not
    /// modelled.
    BothComponents,
    /// The motion of the frame on these columns alone.
    Alone(Box<ColumnsAlone>),
}

/// A frame of one storey that moves on its columns alone.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnsAlone {
    /// Number of columns.
    pub count: usize,
    /// b, width of foot and head, m.
    pub width_m: f64,
    /// h, their height, m.
    pub height_m: f64,
    /// The equivalent rocking block with the same equation: α, p̂ and r are those of the frame.
    pub rocks_like: RockingBlock,
    /// The history.
    pub history: RockingHistory,
}

impl ColumnsAlone {
    /// Acceleration of the ground at which feet lift off, m/s²: g tan α.
    pub fn uplift_m_s2(&self) -> f64 {
        self.rocks_like.gravity_m_s2 * self.rocks_like.slenderness_rad.tan()
    }

    /// Drift of the heads at a rotation, m: h sin θ + b (1 − cos θ).
    pub fn drift_m(&self, rotation_rad: f64) -> f64 {
        let size = self.height_m * rotation_rad.abs().sin() + self.width_m * (1.0 - rotation_rad.cos());
        size.copysign(rotation_rad)
    }

    /// Whether they fell.
    pub fn falls(&self) -> bool {
        matches!(self.history.outcome, RockingOutcome::Fell { .. })
    }
}

/// Simulates the frame on its columns alone, for the duration of the frame's own run; no run with two components.
pub(super) fn columns_in_motion(
    part: &FramePart,
    ground: Option<&TimeFunction>,
    duration_s: f64,
    output_step_s: f64,
    pick: Pick<'_>,
) -> Result<ColumnsInMotion, WorkError> {
    if part.storeys.iter().all(|storey| storey.columns.is_none()) {
        return Ok(ColumnsInMotion::Absent);
    }
    let Some(ground) = ground else {
        return Ok(ColumnsInMotion::BothComponents);
    };
    let [storey] = part.storeys.as_slice() else {
        return Ok(ColumnsInMotion::SeveralStoreys);
    };
    let Some(columns) = &storey.columns else {
        return Ok(ColumnsInMotion::Absent);
    };
    if columns.bed_stiffness.is_some() {
        return Ok(ColumnsInMotion::OnBeds);
    }
    let (width_m, height_m) = (pick(columns.foot.width()), pick(&storey.height));
    // the file does not give the weight of the columns; as in the check, all mass is in the beam
    let rocks_like = RockingBlock::frame_on_columns(width_m, height_m, f64::INFINITY, part.gravity_m_s2)?;
    let options = Rocking {
        duration_s: Some(duration_s),
        output_step_s,
        ..Rocking::default()
    };
    Ok(ColumnsInMotion::Alone(Box::new(ColumnsAlone {
        count: columns.count,
        width_m,
        height_m,
        history: rock_block(&rocks_like, ground, &TimeFunction::Zero, &options)?,
        rocks_like,
    })))
}
