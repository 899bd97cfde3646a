//! Errors of the damper design.

use crate::dynamics::DynamicsError;
use crate::structure::wind::WindError;
use dolmen_linalg::LinalgError;

/// Why a damper cannot be designed. Each variant contains the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DamperError {
    /// The mass ratio is outside the allowed range.
    #[error(
        "mass_ratio is {given}, but must lie in (0, {most}]: it is the damper's mass over the modal mass of the tuned mode, with the mode shape scaled to 1 where the damper stands"
    )]
    MassRatio {
        /// The given value, dimensionless.
        given: f64,
        /// The largest allowed value.
        most: f64,
    },
    /// A value is out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Name of the argument.
        argument: &'static str,
        /// The given value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// The length of a row does not fit the structure.
    #[error("damper {damper}: its row has {given} values, but the structure needs {needed} finite ones")]
    Row {
        /// Number of the damper, from 1.
        damper: usize,
        /// Number of given values.
        given: usize,
        /// Degrees of freedom of the structure.
        needed: usize,
    },
    /// A damper is on a floor that the problem does not list.
    #[error("damper {damper} is tied to a floor that is not among the sites: list it there")]
    NoSite {
        /// Number of the damper, from 1.
        damper: usize,
    },
    /// A damper is at a place that does not move.
    #[error("damper {damper}: every value of its row is 0, so that nothing moves it")]
    Unmoved {
        /// Number of the damper, from 1.
        damper: usize,
    },
    /// A damper is outside its floor.
    #[error(
        "the damper at x = {x_m} m, y = {y_m} m stands {beyond_m:.3} m outside its floor: move it inside the outline"
    )]
    OutsideFloor {
        /// x in plan, m.
        x_m: f64,
        /// y in plan, m.
        y_m: f64,
        /// Distance from the edge of the floor, m.
        beyond_m: f64,
    },
    /// A damper is tuned to a mode that does not move its place.
    #[error(
        "mode {mode} does not move the damper at x = {x_m} m, y = {y_m} m in direction {direction_degrees}°: {only}; turn the damper, move it, or tune it to another mode"
    )]
    ModeStill {
        /// Number of the mode, from 1.
        mode: usize,
        /// x in plan, m.
        x_m: f64,
        /// y in plan, m.
        y_m: f64,
        /// Direction of the damper, degrees.
        direction_degrees: f64,
        /// The reason.
        only: &'static str,
    },
    /// No points are given whose motion is to be reduced.
    #[error("no points are given: name at least one place whose motion is to be made small")]
    NoPoints,
    /// A point does not move under the loads.
    #[error("point {point} does not move under the loads: leave it out, or let a load act on it")]
    Still {
        /// Number of the point, from 1.
        point: usize,
    },
    /// The tolerance needs more frequencies than allowed.
    #[error(
        "the integral over frequency needs more than {intervals} intervals: raise relative_tolerance, or give the modes more damping"
    )]
    TooManyFrequencies {
        /// Largest allowed number of intervals.
        intervals: usize,
    },
    /// A map is requested for a goal that is a peak.
    #[error("places are mapped by standard deviations: take the largest or the mean square as the goal")]
    NoMap,
    /// A search did not find an optimum.
    #[error("no optimum of {what} was found in {iterations} steps: start from another tuning")]
    NoOptimum {
        /// The minimised quantity.
        what: &'static str,
        /// Number of steps.
        iterations: usize,
    },
    /// The wind is out of its range.
    #[error(transparent)]
    Wind(#[from] WindError),
    /// The structure or its loads are not valid.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl DamperError {
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Dynamics(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::MassRatio { .. }
            | Self::Argument { .. }
            | Self::Row { .. }
            | Self::NoSite { .. }
            | Self::Unmoved { .. }
            | Self::OutsideFloor { .. }
            | Self::ModeStill { .. }
            | Self::NoPoints
            | Self::Still { .. }
            | Self::TooManyFrequencies { .. }
            | Self::NoMap
            | Self::Wind(_)
            | Self::NoOptimum { .. } => false,
        }
    }
}
