//! Why a damper cannot be designed.

use crate::dynamics::DynamicsError;
use crate::structure::wind::WindError;
use dolmen_linalg::LinalgError;

/// Why a damper cannot be designed. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DamperError {
    /// The mass ratio lies outside the range in which dampers are designed.
    #[error(
        "mass_ratio is {given}, but must lie in (0, {most}]: it is the damper's mass over the modal mass of the tuned mode, with the mode shape scaled to 1 where the damper stands"
    )]
    MassRatio {
        /// The value given, dimensionless.
        given: f64,
        /// The largest value that is allowed.
        most: f64,
    },
    /// A value out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Its name.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// A row that does not fit the structure.
    #[error("damper {damper}: its row has {given} values, but the structure needs {needed} finite ones")]
    Row {
        /// The damper, from 1.
        damper: usize,
        /// Values given.
        given: usize,
        /// Degrees of freedom of the structure.
        needed: usize,
    },
    /// A damper tied to a floor that the problem does not list.
    #[error("damper {damper} is tied to a floor that is not among the sites: list it there")]
    NoSite {
        /// Which damper, from 1.
        damper: usize,
    },
    /// A damper at a place that does not move.
    #[error("damper {damper}: every value of its row is 0, so that nothing moves it")]
    Unmoved {
        /// Which damper, from 1.
        damper: usize,
    },
    /// A damper beyond the edge of its floor.
    #[error(
        "the damper at x = {x_m} m, y = {y_m} m stands {beyond_m:.3} m outside its floor: move it inside the outline"
    )]
    OutsideFloor {
        /// x in plan, m.
        x_m: f64,
        /// y in plan, m.
        y_m: f64,
        /// How far outside, m.
        beyond_m: f64,
    },
    /// A damper tuned to a mode that does not move it.
    #[error(
        "mode {mode} does not move the damper at x = {x_m} m, y = {y_m} m in direction {direction_degrees}°: {only}; turn the damper, move it, or tune it to another mode"
    )]
    ModeStill {
        /// The mode, from 1.
        mode: usize,
        /// x in plan, m.
        x_m: f64,
        /// y in plan, m.
        y_m: f64,
        /// The damper's direction, degrees.
        direction_degrees: f64,
        /// Why.
        only: &'static str,
    },
    /// No points whose motion is to be reduced.
    #[error("no points are given: name at least one place whose motion is to be made small")]
    NoPoints,
    /// A point that does not move under the loads.
    #[error("point {point} does not move under the loads: leave it out, or let a load act on it")]
    Still {
        /// Which point, from 1.
        point: usize,
    },
    /// More frequencies than allowed are needed for the tolerance.
    #[error(
        "the integral over frequency needs more than {intervals} intervals: raise relative_tolerance, or give the modes more damping"
    )]
    TooManyFrequencies {
        /// Intervals allowed.
        intervals: usize,
    },
    /// A map for a goal that is a peak.
    #[error("places are mapped by standard deviations: take the largest or the mean square as the goal")]
    NoMap,
    /// A search did not find an optimum.
    #[error("no optimum of {what} was found in {iterations} steps: start from another tuning")]
    NoOptimum {
        /// The quantity to be minimised.
        what: &'static str,
        /// Steps that were made.
        iterations: usize,
    },
    /// The wind is out of its range.
    #[error(transparent)]
    Wind(#[from] WindError),
    /// The structure or its loads are refused.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl DamperError {
    /// Whether an iteration ended before it converged, in which case the input may be valid.
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
