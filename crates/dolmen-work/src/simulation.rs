//! What `dolmen simulate` found, of any kind.

use crate::building::{BuildingSimulation, WindSimulation};
use crate::chain::ChainSimulation;
use crate::frame::FrameSimulation;
use crate::judgement::{Evidence, Weight};
use crate::loads::Governing;
use crate::stack::{StackRuns, SupportsSimulation};
use dolmen::stability::stack::Standing;

/// A simulation of a structure of any kind, with what went in.
#[derive(Clone, Debug, PartialEq)]
pub enum Simulation {
    /// Of a chain.
    Chain(Box<ChainSimulation>),
    /// Of a frame in one direction.
    Frame(Box<FrameSimulation>),
    /// Of a stack, by one law of contact or both.
    Stack(Box<StackRuns>),
    /// Of a stack whose supports move slowly.
    Supports(Box<SupportsSimulation>),
    /// Of a building.
    Building(Box<BuildingSimulation>),
    /// Of a building in the wind of its file.
    Wind(Box<WindSimulation>),
}

impl Simulation {
    /// The variant of the file that was simulated; `None` for the structure as it is.
    pub fn variant(&self) -> Option<&str> {
        match self {
            Simulation::Chain(of) => of.variant.as_deref(),
            Simulation::Frame(of) => of.variant.as_deref(),
            Simulation::Stack(of) => of.deciding.variant.as_deref(),
            Simulation::Supports(of) => of.variant.as_deref(),
            Simulation::Building(of) => of.variant.as_deref(),
            Simulation::Wind(of) => of.variant.as_deref(),
        }
    }
}

/// What a structure is before it is shaken.
#[derive(Clone, Debug, PartialEq)]
pub struct WithoutShaking {
    /// The word.
    pub weight: Weight,
    /// What of wind and static loads decides it; `None` where its own weight does.
    pub governed_by: Option<Governing>,
}

/// What came of `dolmen simulate`.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulateAnswer {
    /// The project file, as it was named.
    pub file: String,
    /// Each run: of a frame one a direction.
    pub simulations: Vec<Simulation>,
    /// The variant of the file that was asked for; `None` for the structure as it is.
    pub variant: Option<String>,
    /// Why nothing was simulated of a stack that does not stand without any shaking.
    pub does_not_stand: Option<Standing>,
    /// What surveys say of the model of the structure as it is.
    pub evidence: Evidence,
    /// What a chain, frame or building is under its weight, the static loads and the wind of the file, where that is not "stable".
    pub without_shaking: Option<WithoutShaking>,
}
