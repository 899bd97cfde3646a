//! What `dolmen simulate` found, of any kind.

pub use crate::at_rest::SPEED_AT_REST_M_S;
use crate::building::{BuildingSimulation, WindSimulation};
use crate::chain::ChainSimulation;
use crate::frame::FrameSimulation;
use crate::judgement::{Evidence, Weight};
use crate::loads::Governing;
use crate::stack::{StackRuns, SupportsSimulation};
use dolmen::stability::stack::Standing;
use dolmen_project::ModelDamage;

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

    /// Whether the structure fell.
    pub fn falls(&self) -> bool {
        match self {
            Simulation::Chain(of) => of.falls(),
            Simulation::Frame(of) => of.falls(),
            Simulation::Stack(of) => of.each().any(|run| run.falls()),
            Simulation::Building(of) => of.falls(),
            Simulation::Supports(_) | Simulation::Wind(_) => false,
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

/// What came before the second of two motions.
#[derive(Clone, Debug, PartialEq)]
pub struct AfterFirst {
    /// Name of the first motion.
    pub first_motion: String,
    /// Name of the second.
    pub second_motion: String,
    /// The first motion alone.
    pub first: SimulateAnswer,
    /// How the second came to act, or why it did not.
    pub second: Second,
}

/// Whether the second of two motions acted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Second {
    /// It did: the simulations are of both motions as one.
    Acted {
        /// How long the ground stood still between them, s.
        still_s: f64,
        /// Largest speed of any part shortly before it began, m/s.
        speed_m_s: f64,
        /// When it began, s.
        from_s: f64,
    },
    /// The structure fell in the first: the simulations are of that one alone.
    FellBefore,
    /// The first has no verdict: the simulations are of that one alone.
    NoVerdictBefore,
}

impl Second {
    /// Whether the structure was at rest before it acted; `None` where it did not act.
    pub fn began_at_rest(&self) -> Option<bool> {
        match self {
            Second::Acted { speed_m_s, .. } => Some(*speed_m_s <= SPEED_AT_REST_M_S),
            Second::FellBefore | Second::NoVerdictBefore => None,
        }
    }
}

/// What came of `dolmen simulate`.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulateAnswer {
    /// The project file, as the user named it.
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
    /// Whether the measured tilt of the structure as it is is beyond its limit before any shaking.
    pub tilt_beyond_limit: bool,
    /// What came before, where the motion was the second of two.
    pub after: Option<Box<AfterFirst>>,
    /// Damage of inspections that the model has.
    pub damage: Vec<ModelDamage>,
}
