//! A frame on its free-standing columns over time: rigid columns that rock under a rigid beam, alone or beside joints and walls.

use super::softening::{BedsFrom, Softening};
use super::together::Leaning;
use crate::error::WorkError;
use dolmen::assess::demand::DRIFT_RATIO_MOST;
use dolmen::dynamics::{
    ColumnHistory, ColumnOutcome, ColumnRun, Rocking, RockingBlock, RockingHistory, RockingOutcome,
    TimeFunction, rock_block, rock_on_beds,
};
use dolmen::stability::ColumnsBesideJoints;
use dolmen_project::{ColumnsPart, FramePart, Quantity, StoreyPart};

/// Result of a simulation for the free-standing columns of a frame.
#[derive(Clone, Debug, PartialEq)]
pub enum ColumnsInMotion {
    /// The frame has no such columns.
    Absent,
    /// The frame has such columns, but several storeys.
    SeveralStoreys,
    /// The frame has such columns beside joints that rub or have slack.
    JointsOfTheirOwn,
    /// The frame has such columns beside joints and walls, under x and y together or on beds that would be stiffer than the storey: all that is
    /// known of its softening is the motion with all of the stiffness in the beds.
    SplitAssumed,
    /// The motion of the frame with the force of its columns on the beds given, and joints and walls beside them.
    BesideJoints(Box<ColumnsOnBeds>),
    /// The motion of the frame on such columns on compliant beds, which alone support it.
    OnBeds(Box<ColumnsOnBeds>),
    /// Such columns alone support the frame, but the ground moves along x and y: rolling on a corner or around the edge is not
    /// modelled.
    BothComponents,
    /// The motion of the frame on these columns alone.
    Alone(Box<ColumnsAlone>),
}

/// The frame on its columns, over time.
pub(super) struct MovedColumns {
    pub(super) columns: ColumnsInMotion,
    /// With all of the stiffness in the beds, where the file does not say how beds and joints share it.
    pub(super) all_in_beds: Option<Box<AllInBeds>>,
}

/// A frame of one storey that moves with all of its stiffness in the beds of its columns.
#[derive(Clone, Debug, PartialEq)]
pub struct AllInBeds {
    /// Its motion.
    pub run: ColumnsOnBeds,
    /// Why this is assumed.
    pub beds: BedsFrom,
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

/// A frame of one storey that moves on its columns, on compliant beds, alone or beside joints.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnsOnBeds {
    /// Number of columns.
    pub count: usize,
    /// Their height, m.
    pub height_m: f64,
    /// k_b, stiffness of their beds at small drift, N/m; that of the joints is in the options.
    pub beds_n_m: f64,
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

/// The columns of a frame of one storey, alone or beside joints on the beds that the file gives, under a component of a motion; `None` for another
/// frame.
pub(super) fn on_beds(
    leaning: &Leaning,
    ground: &TimeFunction,
    how: (f64, f64),
) -> Result<Option<ColumnsOnBeds>, WorkError> {
    match &leaning.held {
        Some(held) => rocking(held, leaning, ground, how),
        None => Ok(None),
    }
}

/// A frame of one storey on these columns and joints; `None` for several storeys.
fn rocking(
    held: &ColumnsBesideJoints,
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
        joints_n_m: held.joints_n_m,
        // small drifts limit joints, not columns
        drift_most_m: match held.joints_n_m == 0.0 {
            true => f64::INFINITY,
            false => DRIFT_RATIO_MOST * storey.height_m,
        },
        ..ColumnRun::of(storey.mass_kg, duration_s)
    };
    Ok(Some(ColumnsOnBeds {
        count: held.columns.count(),
        height_m: storey.height_m,
        beds_n_m: held.columns.bed_stiffness_n_m().unwrap_or(f64::INFINITY),
        history: rock_on_beds(&held.columns, ground, &run)?,
        run,
    }))
}

/// Simulates the frame on its columns, for the duration of the frame's own run. Under two components (`in_plan`) each direction moves under its own.
pub(super) fn columns_in_motion(
    (part, direction): (&FramePart, &str),
    (ground, in_plan): (&TimeFunction, bool),
    how: (f64, f64),
) -> Result<MovedColumns, WorkError> {
    let pick = &mut Quantity::nominal;
    let only = |columns| {
        Ok(MovedColumns {
            columns,
            all_in_beds: None,
        })
    };
    if part.storeys.iter().all(|storey| storey.columns.is_none()) {
        return only(ColumnsInMotion::Absent);
    }
    let [storey] = part.storeys.as_slice() else {
        return only(ColumnsInMotion::SeveralStoreys);
    };
    let (Some(columns), Some(leaning)) = (&storey.columns, Leaning::of(part, direction, pick)?) else {
        return only(ColumnsInMotion::Absent);
    };
    let is_alone = leaning.alone.iter().any(Option::is_some);
    if is_alone && in_plan {
        return only(ColumnsInMotion::BothComponents);
    }
    if let Some(run) = on_beds(&leaning, ground, how)? {
        let run = Box::new(run);
        return only(match is_alone {
            true => ColumnsInMotion::OnBeds(run),
            false => ColumnsInMotion::BesideJoints(run),
        });
    }
    let all_in_beds = match &leaning.assumed {
        Some(Softening { held, beds }) if held.falls(f64::INFINITY)?.is_some() => {
            rocking(held, &leaning, ground, how)?.map(|run| Box::new(AllInBeds { run, beds: *beds }))
        }
        _ => None,
    };
    let rubs = all_in_beds.is_none();
    let columns = match (columns.bed_stiffness.is_some() || in_plan, rubs) {
        (true, true) => ColumnsInMotion::JointsOfTheirOwn,
        (true, false) => ColumnsInMotion::SplitAssumed,
        (false, _) => {
            let run = on_rigid_stones((part, storey, columns), ground, how)?;
            ColumnsInMotion::Alone(Box::new(run))
        }
    };
    Ok(MovedColumns { columns, all_in_beds })
}

/// The frame on its columns alone, on rigid stones. The file does not give the weight of the columns; as in the check, all mass is in the beam.
fn on_rigid_stones(
    (part, storey, columns): (&FramePart, &StoreyPart, &ColumnsPart),
    ground: &TimeFunction,
    (duration_s, output_step_s): (f64, f64),
) -> Result<ColumnsAlone, WorkError> {
    let (width_m, height_m) = (columns.foot.width().value, storey.height.value);
    let rocks_like = RockingBlock::frame_on_columns(width_m, height_m, f64::INFINITY, part.gravity_m_s2)?;
    let options = Rocking {
        duration_s: Some(duration_s),
        output_step_s,
        ..Rocking::default()
    };
    Ok(ColumnsAlone {
        count: columns.count,
        width_m,
        height_m,
        history: rock_block(&rocks_like, ground, &TimeFunction::Zero, &options)?,
        rocks_like,
    })
}
