//! A frame on its free-standing columns alone, over time: rigid columns that rock under a rigid beam.

use super::together::Leaning;
use crate::error::WorkError;
use dolmen::dynamics::{
    ColumnHistory, ColumnOutcome, ColumnRun, Rocking, RockingBlock, RockingHistory, RockingOutcome,
    StoreyFriction, TimeFunction, rock_block, rock_on_beds,
};
use dolmen::stability::FreeColumns;
use dolmen_project::{FramePart, Quantity};

/// Result of a simulation for the free-standing columns of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnsInMotion {
    /// The frame has no such columns.
    Absent,
    /// The frame has such columns, but several storeys.
    SeveralStoreys,
    /// The frame has such columns on compliant beds beside joints and walls, and how they share its stiffness is assumed: its motion with all
    /// of it in the beds; `None` where joints rub or have slack, which such a motion does not have.
    BesideJoints(Option<Box<ColumnsOnBeds>>),
    /// The motion of the frame on such columns on compliant beds, which alone support it.
    OnBeds(Box<ColumnsOnBeds>),
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

/// A frame of one storey that moves on its columns alone, on compliant beds.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnsOnBeds {
    /// Number of columns.
    pub count: usize,
    /// Their height, m.
    pub height_m: f64,
    /// The options of the run.
    pub run: ColumnRun,
    /// The history.
    pub history: ColumnHistory,
}

impl ColumnsOnBeds {
    /// Whether they fell.
    pub fn falls(&self) -> bool {
        matches!(self.history.outcome, ColumnOutcome::Fell { .. })
    }

    /// Whether feet lifted off.
    pub fn lifts_off(&self) -> bool {
        self.history.uplift_s.is_some()
    }

    /// Whether the motion could be followed to its end.
    pub fn is_followed(&self) -> bool {
        self.history.outcome != ColumnOutcome::NotConverged
    }
}

/// The columns that alone support a frame of one storey, under a component of a motion; `None` for another frame.
pub(super) fn on_beds(
    leaning: &Leaning,
    ground: &TimeFunction,
    (duration_s, output_step_s): (f64, f64),
) -> Result<Option<ColumnsOnBeds>, WorkError> {
    let [Some(alone)] = leaning.alone.as_slice() else {
        return Ok(None);
    };
    rocking(&alone.columns, leaning, ground, (duration_s, output_step_s))
}

/// A frame of one storey on these columns alone; `None` for several storeys.
fn rocking(
    columns: &FreeColumns,
    leaning: &Leaning,
    ground: &TimeFunction,
    (duration_s, output_step_s): (f64, f64),
) -> Result<Option<ColumnsOnBeds>, WorkError> {
    let [storey] = leaning.frame.frame().storeys() else {
        return Ok(None);
    };
    let run = ColumnRun {
        damping_ratio: leaning.damping_ratio,
        tilt: leaning.tilt,
        output_step_s,
        ..ColumnRun::of(storey.mass_kg, duration_s)
    };
    Ok(Some(ColumnsOnBeds {
        count: columns.count(),
        height_m: storey.height_m,
        history: rock_on_beds(columns, ground, &run)?,
        run,
    }))
}

/// A frame of one storey whose beds and joints share its stiffness, with all of it in the beds; `None` where joints rub or have slack, and
/// where such columns do not stand.
fn all_in_beds(
    columns: &FreeColumns,
    leaning: &Leaning,
    ground: &TimeFunction,
    how: (f64, f64),
) -> Result<Option<ColumnsOnBeds>, WorkError> {
    let frame = &leaning.frame;
    let rubs = frame.friction().iter().any(|of| *of != StoreyFriction::None);
    let has_slack = frame.tenons().iter().any(Option::is_some);
    let ([stiffness_n_m], false) = (frame.stiffness_n_m(), rubs || has_slack) else {
        return Ok(None);
    };
    let columns = columns.on_beds_of(*stiffness_n_m);
    match columns.standing()? {
        Some(_) => rocking(&columns, leaning, ground, how),
        None => Ok(None),
    }
}

/// Simulates the frame on its columns alone, for the duration of the frame's own run; no run with two components.
pub(super) fn columns_in_motion(
    (part, direction): (&FramePart, &str),
    ground: Option<&TimeFunction>,
    (duration_s, output_step_s): (f64, f64),
) -> Result<ColumnsInMotion, WorkError> {
    let pick = &mut Quantity::nominal;
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
    let leaning = Leaning::of(part, direction, pick)?;
    let how = (duration_s, output_step_s);
    let run = leaning.as_ref().map(|leaning| on_beds(leaning, ground, how));
    if let Some(run) = run.transpose()?.flatten() {
        return Ok(ColumnsInMotion::OnBeds(Box::new(run)));
    }
    if columns.bed_stiffness.is_some() {
        let run = leaning.map(|leaning| {
            let [own] = leaning.frame.frame().storeys() else {
                return Ok(None);
            };
            all_in_beds(&columns.build(own, pick)?, &leaning, ground, how)
        });
        let run = run.transpose()?.flatten();
        return Ok(ColumnsInMotion::BesideJoints(run.map(Box::new)));
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
