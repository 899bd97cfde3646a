use crate::assess::AssessError;
use crate::blocks::BlocksError;
use crate::damper::DamperError;
use crate::dynamics::DynamicsError;
use crate::signal::SignalError;
use crate::stability::StabilityError;
use crate::structure::StructureError;
use crate::structure::stack::{SliceError, StackError};

/// Reason why a case could not be computed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ValidationError {
    /// A structure of a source was refused.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// A stack of a source was refused.
    #[error(transparent)]
    Stack(#[from] StackError),
    /// A scan could not be cut.
    #[error(transparent)]
    Slice(#[from] SliceError),
    /// A building of a source was refused.
    #[error(transparent)]
    Building(#[from] crate::structure::building::BuildingError),
    /// The stiffness in plan was not found.
    #[error(transparent)]
    Plan(#[from] crate::structure::building::PlanStiffnessError),
    /// Stability could not be assessed.
    #[error(transparent)]
    Stability(#[from] StabilityError),
    /// A wind was refused.
    #[error(transparent)]
    Wind(#[from] crate::structure::wind::WindError),
    /// The frequencies of a stack could not be computed.
    #[error(transparent)]
    Blocks(#[from] BlocksError),
    /// A motion in time could not be computed.
    #[error(transparent)]
    Dynamics(#[from] DynamicsError),
    /// A motion was refused.
    #[error(transparent)]
    Signal(#[from] SignalError),
    /// Modes could not be identified.
    #[error(transparent)]
    Modal(#[from] crate::modal::ModalError),
    /// A history could not be analysed.
    #[error(transparent)]
    Monitoring(#[from] crate::monitoring::MonitoringError),
    /// A damper was refused.
    #[error(transparent)]
    Damper(#[from] DamperError),
    /// An assessment failed.
    #[error(transparent)]
    Assess(#[from] AssessError),
}

impl ValidationError {
    /// Whether an iteration ended before it converged: the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Structure(why) => why.did_not_converge(),
            Self::Building(why) => why.did_not_converge(),
            Self::Plan(why) => why.did_not_converge(),
            Self::Stability(why) => why.did_not_converge(),
            Self::Blocks(why) => why.did_not_converge(),
            Self::Dynamics(why) => why.did_not_converge(),
            Self::Modal(why) => why.did_not_converge(),
            Self::Damper(why) => why.did_not_converge(),
            Self::Assess(why) => why.did_not_converge(),
            Self::Stack(_) | Self::Slice(_) | Self::Wind(_) | Self::Signal(_) | Self::Monitoring(_) => false,
        }
    }
}
