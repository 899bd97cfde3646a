use crate::numeric::NumericError;
use crate::structure::StructureError;
use dolmen_linalg::LinalgError;

/// Why stability cannot be assessed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StabilityError {
    /// The stiffnesses do not fit the structure.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
    /// A root was not found.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// An option or load out of its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Its name.
        option: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Vertical acceleration that cancels the weight.
    #[error(
        "vertical_acceleration_m_s2 is {given}, but must be above −{gravity_m_s2}: at and below that nothing has weight \
         and no joint holds"
    )]
    VerticalAcceleration {
        /// The value given, m/s², positive up.
        given: f64,
        /// Gravity of the stack, m/s².
        gravity_m_s2: f64,
    },
    /// A direction of zero length.
    #[error("{quantity} is {given:?}, but must be two finite numbers, not both 0")]
    Direction {
        /// Name of the direction.
        quantity: &'static str,
        /// The value given.
        given: [f64; 2],
    },
    /// A block that does not exist.
    #[error("{quantity} name block {given}, but the stack has {count}, from 0")]
    Block {
        /// Name of the quantity that refers to the block.
        quantity: &'static str,
        /// The index given.
        given: usize,
        /// Number of blocks.
        count: usize,
    },
    /// The pressure in a joint was not found.
    #[error("the pressure in a joint was not found to better than {residual:e} in {iterations} steps")]
    Pressure {
        /// Largest relative error of the force and the moments.
        residual: f64,
        /// Number of steps.
        iterations: usize,
    },
    /// The conic programme of a limit analysis was not solved.
    #[error("the conic programme of the limit analysis was not solved: {reason}")]
    ConicProgramme {
        /// Status of the solver.
        reason: String,
    },
    /// The structure is not statically determinate.
    #[error(
        "the forces in the joints do not follow from equilibrium alone: a block rests on several joints, or stands beside          another; give a stack in which each block rests on one"
    )]
    Indeterminate,
}

impl StabilityError {
    /// Whether an iteration ended before it converged, in which case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Structure(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::Numeric(_) | Self::Pressure { .. } | Self::ConicProgramme { .. } => true,
            Self::Option { .. }
            | Self::VerticalAcceleration { .. }
            | Self::Direction { .. }
            | Self::Block { .. }
            | Self::Indeterminate => false,
        }
    }
}
