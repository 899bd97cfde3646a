//! Why a stack cannot be simulated.

use crate::structure::stack::StackError;
use dolmen_linalg::LinalgError;

/// Why a simulation cannot start. The end of a simulation is a status in its result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BlocksError {
    /// An option is out of its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// The requested step is longer than the springs allow.
    #[error(
        "time_step_s is {given:.3e}, but the stiffest joint allows at most {most:.3e}: lower it, leave it out, or lower the joints' stiffness"
    )]
    StepTooLarge {
        /// The step given, s.
        given: f64,
        /// The largest stable step, s.
        most: f64,
    },
    /// The stack does not come to rest under its own weight.
    #[error(
        "the stack finds no equilibrium under its own weight: after {iterations} iterations forces of {residual:.2e} of the weight are left, largest at '{block}'"
    )]
    NoRest {
        /// Number of Newton iterations.
        iterations: usize,
        /// Largest residual force, relative to the stack's weight.
        residual: f64,
        /// The block on which it acts.
        block: String,
    },
    /// The stack is unstable at rest: its springs are too soft for its weight.
    #[error(
        "at rest the stack topples on its springs under its weight and static loads, '{block}' farthest: normal_stiffness and shear_stiffness of all joints together must be at least {factor:.3} times what they are. Raise them, or calibrate them with a measured frequency"
    )]
    Topples {
        /// Smallest factor on the springs of all joints at which the stack stands; above 1.
        factor: f64,
        /// The block that moves farthest in the unstable mode.
        block: String,
    },
    /// The stack topples on the springs of its joints and its soil.
    #[error(
        "at rest the stack topples on its soil under its weight and static loads, '{block}' farthest: soil and joints together must be at least {factor:.3} times as stiff. Check the shear modulus of the soil, and loads and their heights"
    )]
    TopplesOnSoil {
        /// Smallest factor on the springs of all joints, with the soil, at which the stack stands; above 1.
        factor: f64,
        /// The block that moves farthest in the unstable mode.
        block: String,
    },
    /// The sliding model cannot describe the stack.
    #[error("'{block}' cannot be followed by the sliding model: {reason}. Use the springs or the rigid law")]
    NotAPile {
        /// The block.
        block: String,
        /// The missing feature of the model.
        reason: &'static str,
    },
    /// The sliding model found no accelerations.
    #[error(
        "the sliding model finds no accelerations at {at_s} s: the blocks' masses or friction coefficients lie too far apart; use the rigid law"
    )]
    NoSliding {
        /// Time, s.
        at_s: f64,
    },
    /// A property that only the springs law can model.
    #[error(
        "{what} has {quantity} {given:.4e}, but the rigid law, whose stones only press, rub and part, allows 0: set it to 0 or take it out, or simulate with the springs law"
    )]
    SpringsOnly {
        /// The joint, dowel, clamp or side support with this property, and its place.
        what: String,
        /// The quantity, with its unit.
        quantity: &'static str,
        /// Value of the quantity.
        given: f64,
    },
    /// The run needs more work than is allowed without confirmation.
    #[error("the run needs {count:.3e} {what}, but at most {most:.0e} are computed unless asked for")]
    TooLong {
        /// "steps of 1.000e-9 s" or "samples of the history".
        what: String,
        /// Number of steps or samples.
        count: f64,
        /// Largest allowed number.
        most: f64,
    },
    /// The stack is refused.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl BlocksError {
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Linalg(why) => why.did_not_converge(),
            Self::NoRest { .. } => true,
            Self::Option { .. }
            | Self::StepTooLarge { .. }
            | Self::Topples { .. }
            | Self::TopplesOnSoil { .. }
            | Self::NotAPile { .. }
            | Self::NoSliding { .. }
            | Self::SpringsOnly { .. }
            | Self::TooLong { .. }
            | Self::Stack(_) => false,
        }
    }
}

/// Checks the times used by both laws.
pub(super) fn check_times(
    time_step_s: Option<f64>,
    duration_s: Option<f64>,
    output_step_s: f64,
    rest_s: f64,
) -> Result<(), BlocksError> {
    let refuse = |option, given, allowed| {
        Err(BlocksError::Option {
            option,
            given,
            allowed,
        })
    };
    for (option, given) in [
        ("time_step_s", time_step_s),
        ("duration_s", duration_s),
        ("output_step_s", Some(output_step_s)),
    ] {
        if let Some(given) = given.filter(|given| !(*given > 0.0 && given.is_finite())) {
            return refuse(option, given, "a positive number");
        }
    }
    if !(rest_s >= 0.0 && rest_s.is_finite()) {
        return refuse("rest_s", rest_s, "0 or a positive number");
    }
    Ok(())
}
