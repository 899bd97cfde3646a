//! Results of `dolmen simulate`, for any kind of structure.

pub use crate::at_rest::SPEED_AT_REST_M_S;
use crate::building::{BuildingSimulation, WindSimulation};
use crate::chain::ChainSimulation;
use crate::frame::FrameSimulation;
use crate::judgement::{Basis, Evidence, Weight};
use crate::loads::Governing;
use crate::stack::{SettledSimulation, StackRuns, SupportsSimulation};
use crate::tilt_left_out::TiltLeftOut;
use dolmen::stability::stack::Standing;
use dolmen_project::ModelDamage;

/// A simulation of a structure of any kind, with its input.
#[derive(Clone, Debug, PartialEq)]
pub enum Simulation {
    /// A chain.
    Chain(Box<ChainSimulation>),
    /// A frame in one direction.
    Frame(Box<FrameSimulation>),
    /// A stack, by one law of contact or both.
    Stack(Box<StackRuns>),
    /// A stack whose supports move slowly.
    Supports(Box<SupportsSimulation>),
    /// Loose stones that settle.
    Settled(Box<SettledSimulation>),
    /// A building.
    Building(Box<BuildingSimulation>),
    /// A building in the wind of its file.
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
            Simulation::Settled(of) => of.variant.as_deref(),
            Simulation::Building(of) => of.variant.as_deref(),
            Simulation::Wind(of) => of.variant.as_deref(),
        }
    }

    /// The run of a frame; `None` of another structure.
    pub fn frame(&self) -> Option<&FrameSimulation> {
        match self {
            Simulation::Frame(of) => Some(of),
            Simulation::Chain(_)
            | Simulation::Stack(_)
            | Simulation::Supports(_)
            | Simulation::Settled(_)
            | Simulation::Building(_)
            | Simulation::Wind(_) => None,
        }
    }

    /// Whether a chain or frame moved without damping and friction.
    pub fn is_undamped(&self) -> bool {
        match self {
            Simulation::Chain(of) => of.undamped.is_some(),
            Simulation::Frame(of) => of.undamped.is_some(),
            Simulation::Stack(_)
            | Simulation::Supports(_)
            | Simulation::Settled(_)
            | Simulation::Building(_)
            | Simulation::Wind(_) => false,
        }
    }

    /// Whether the structure fell.
    pub fn falls(&self) -> bool {
        match self {
            Simulation::Chain(of) => of.falls(),
            Simulation::Frame(of) => of.falls(),
            Simulation::Stack(of) => of.each().any(|run| run.falls()),
            Simulation::Building(of) => of.falls(),
            Simulation::Supports(_) | Simulation::Settled(_) | Simulation::Wind(_) => false,
        }
    }
}

/// State of a structure before shaking.
#[derive(Clone, Debug, PartialEq)]
pub struct WithoutShaking {
    /// The word.
    pub weight: Weight,
    /// The wind or static loads that govern; `None` if its own weight does.
    pub governed_by: Option<Governing>,
}

/// The first of two motions.
#[derive(Clone, Debug, PartialEq)]
pub struct AfterFirst {
    /// Name of the first motion.
    pub first_motion: String,
    /// Name of the second.
    pub second_motion: String,
    /// The first motion alone.
    pub first: SimulateAnswer,
    /// Whether and how the second acted.
    pub second: Second,
}

/// Whether the second of two motions acted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Second {
    /// It did: the simulations are of both motions as one.
    Acted {
        /// Duration of still ground between them, s.
        still_s: f64,
        /// Largest speed of any part shortly before it began, m/s.
        speed_m_s: f64,
        /// Its start, s.
        from_s: f64,
    },
    /// The structure fell in the first: the simulations are of that one alone.
    FellBefore,
    /// The first has no verdict: the simulations are of that one alone.
    NoVerdictBefore,
}

impl Second {
    /// Whether the structure was at rest before the second acted; `None` if it did not act.
    pub fn began_at_rest(&self) -> Option<bool> {
        match self {
            Second::Acted { speed_m_s, .. } => Some(*speed_m_s <= SPEED_AT_REST_M_S),
            Second::FellBefore | Second::NoVerdictBefore => None,
        }
    }
}

/// Results of `dolmen simulate`.
#[derive(Clone, Debug, PartialEq)]
pub struct SimulateAnswer {
    /// The project file, as the user named it.
    pub file: String,
    /// The runs; for a frame one for each direction.
    pub simulations: Vec<Simulation>,
    /// The requested variant of the file; `None` for the structure as it is.
    pub variant: Option<String>,
    /// Why a stack that is unstable without shaking was not simulated.
    pub does_not_stand: Option<Standing>,
    /// Evidence of surveys for the model of the structure as it is.
    pub evidence: Evidence,
    /// State of a chain, frame or building under its weight, the static loads and the wind of the file, if it is not "stable".
    pub without_shaking: Option<WithoutShaking>,
    /// Whether the measured tilt of the structure as it is exceeds its limit before any shaking.
    pub tilt_beyond_limit: bool,
    /// A measured tilt that the runs leave out.
    pub tilt_left_out: Option<TiltLeftOut>,
    /// The share of the allowable drift that a measured tilt outside the model leaves; `None` if nothing is outside.
    pub drift_left: Option<f64>,
    /// The first motion, where the motion was the second of two.
    pub after: Option<Box<AfterFirst>>,
    /// Inspected damage in the model.
    pub damage: Vec<ModelDamage>,
    /// Assumed inputs, and omissions of the model; `None` if a check in the same answer has them.
    pub basis: Option<Basis>,
}
