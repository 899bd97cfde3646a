//! The simulation of a frame, with its input.

use super::beside::FrameBeside;
use super::{AllInBeds, AloneStorey, ColumnsInMotion, ColumnsOnBeds, FrameTogether, UnfollowedStorey};
use crate::motion::MotionAnswer;
use crate::tilt_left_out::TiltLeftOut;
use crate::undamped::Undamped;
use dolmen::assess::demand::DriftLimit;
use dolmen::dynamics::{FrameHistory, FrameOutcome, FrameRun, FrictionFrame};
use dolmen::signal::Component;
use dolmen_project::{FrameLean, Names};

/// A simulation of a frame in one direction, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameSimulation {
    /// The project file, as the user named it.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// A longer name of the variant, if the file gives one.
    pub variant_title: Option<Names>,
    /// The direction of the frame.
    pub direction: String,
    /// Directions that were not run because their stiffness is unknown.
    pub without_stiffness: Vec<String>,
    /// The combined response of both directions, stored in each of the two; `None` for one component.
    pub together: Option<FrameTogether>,
    /// The surveyed lean at the start of the run.
    pub lean: Option<FrameLean>,
    /// Lean in this direction, horizontal over vertical.
    pub tilt: f64,
    /// Names of the storeys, lowest first.
    pub storeys: Vec<String>,
    /// The frame.
    pub frame: FrictionFrame,
    /// The motion of its base.
    pub motion: MotionAnswer,
    /// The component of the motion that acts along the direction.
    pub component: Component,
    /// A note that the run has no viscous damping and friction; `None` if it has some.
    pub undamped: Option<Undamped>,
    /// The free-standing columns of the file: the frame's motion does not include their restoring moment; they may be simulated separately.
    pub columns: ColumnsInMotion,
    /// The run with all of its stiffness in the beds of its columns, of a frame of one storey whose file does not say how beds and joints share it.
    pub all_in_beds: Option<Box<AllInBeds>>,
    /// Storeys with columns and joints whose softening is not followed.
    pub unfollowed: Vec<UnfollowedStorey>,
    /// Weight of its static loads, N; it moves with the frame.
    pub carried_n: f64,
    /// The columns of storeys that only columns support; `None` for other storeys.
    pub columns_alone: Vec<Option<AloneStorey>>,
    /// Drift ratio of each storey under the forces of static loads at rest, which reduces the allowable drift; infinite if the storey
    /// cannot resist them.
    pub static_drifts: Vec<f64>,
    /// Whether the file has wind, or forces of static loads, that do not act in the run.
    pub loads_left_out: bool,
    /// A surveyed tilt that is not in the start of the run.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// Options of the run.
    pub options: FrameRun,
    /// Allowable drift of storeys; `None` where the file gives none.
    pub drift_limit: Option<DriftLimit>,
    /// The run compared with the measurement of a survey above the same ground.
    pub beside: Option<FrameBeside>,
    /// The history.
    pub history: FrameHistory,
}

impl FrameSimulation {
    /// The response of both directions together, stored once: in the run along y.
    pub fn together_once(&self) -> Option<&FrameTogether> {
        self.together.as_ref().filter(|_| self.component == Component::Y)
    }

    /// Largest acceleration of the ground along the direction, m/s².
    pub fn peak_acceleration_m_s2(&self) -> f64 {
        self.motion.motion.component_peak_m_s2(self.component)
    }

    /// The run of the frame with the force of its columns at any drift, on beds that give way, alone or beside joints; `None` without one. It counts
    /// in the verdict.
    pub fn on_beds(&self) -> Option<&ColumnsOnBeds> {
        match &self.columns {
            ColumnsInMotion::OnBeds(run) | ColumnsInMotion::BesideJoints(run) => Some(run),
            ColumnsInMotion::Absent
            | ColumnsInMotion::SeveralStoreys
            | ColumnsInMotion::JointsOfTheirOwn
            | ColumnsInMotion::SplitAssumed
            | ColumnsInMotion::BothComponents
            | ColumnsInMotion::Alone(_) => None,
        }
    }

    /// The storey, 0 the lowest, whose columns alone support it, lift off, and are not followed beyond.
    pub fn lifts_off_unfollowed(&self) -> Option<usize> {
        if self.on_beds().is_some() {
            return None;
        }
        let storeys = self.frame.frame().storeys();
        let drift_m = |storey: usize| {
            let own_m = self.history.drift_peaks[storey].value_m.abs();
            let both_m = self.together.as_ref().and_then(|both| both.storeys.get(storey));
            both_m.map_or(own_m, |both| both.drift_m.max(own_m))
        };
        let mut each = self.columns_alone.iter().enumerate();
        each.find_map(|(storey, alone)| {
            let beyond = drift_m(storey) / storeys[storey].height_m > alone.as_ref()?.uplift;
            beyond.then_some(storey)
        })
    }

    /// Whether a storey leaned beyond the validity of the model, or fell on its columns alone.
    pub fn falls(&self) -> bool {
        let rocks_over = self.on_beds().is_some_and(ColumnsOnBeds::falls);
        rocks_over || matches!(self.history.outcome, FrameOutcome::DriftLimit { .. })
    }

    /// End of the run, s, if it is before that of the motion and no storey leaned too far: there is no verdict.
    pub fn ended_before_the_motion_s(&self) -> Option<f64> {
        let end_s = self.options.duration_s?;
        let is_open = matches!(self.history.outcome, FrameOutcome::Finished);
        self.motion.cut_at_s(end_s).filter(|_| is_open)
    }

    /// Whether the run is complete.
    pub fn is_whole(&self) -> bool {
        !matches!(self.history.outcome, FrameOutcome::Stopped { .. })
            && self.on_beds().is_none_or(ColumnsOnBeds::is_followed)
            && self.ended_before_the_motion_s().is_none()
    }

    /// Force of the whole storey at every sample, N, for the plot against drift: spring, P-delta, friction and dashpots.
    ///
    /// ```text
    /// V_i = −Σ_{j≥i} m_j (Y_j'' + a_ground)
    /// ```
    pub fn storey_force_n(&self, storey: usize) -> Vec<f64> {
        let storeys = self.frame.frame().storeys();
        let mut force = vec![0.0; self.history.time_s.len()];
        for (level, part) in storeys.iter().enumerate().skip(storey) {
            for (force, acceleration) in force.iter_mut().zip(&self.history.acceleration_m_s2[level]) {
                *force -= part.mass_kg * acceleration;
            }
        }
        force
    }
}
