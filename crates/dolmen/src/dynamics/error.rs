//! Errors of simulations.

use crate::structure::StructureError;
use dolmen_linalg::LinalgError;

/// Why a simulation cannot start or continue. The end of a run is a status in its result.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum DynamicsError {
    /// A value out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Its name.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A value of one storey out of its range.
    #[error("storey {storey}: {argument} is {given}, but must be {allowed}")]
    Storey {
        /// The storey, 1 the lowest.
        storey: usize,
        /// The name of the value.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// An invalid building, or a place that is not on it.
    #[error(transparent)]
    Building(#[from] crate::structure::building::BuildingError),
    /// Columns whose curve of force against drift is not found.
    #[error(transparent)]
    Columns(#[from] crate::stability::StabilityError),
    /// A list of the wrong length.
    #[error("{argument} has {given} entries, but the frame has {needed} storeys: give one for each")]
    Count {
        /// The name of the list.
        argument: &'static str,
        /// Its length.
        given: usize,
        /// The number of storeys.
        needed: usize,
    },
    /// No state of stick and slip of the storeys satisfies Coulomb's law at an event.
    #[error(
        "at {at_s} s no state of sticking and slipping was found in {tried} tries: the friction of some storey is far below the others', or the numbers of the frame lie too far apart"
    )]
    NoState {
        /// Time of the event, s.
        at_s: f64,
        /// Number of tried states.
        tried: usize,
    },
    /// The peaks still change when the step of a run is halved.
    #[error(
        "halving the step to {step_s} s still changes the largest drift by {change}, more than {most}: shorten output_step_s, or look whether the friction of some storey is next to nothing"
    )]
    NotConverged {
        /// The shortest step tried, s.
        step_s: f64,
        /// Change relative to the largest drift.
        change: f64,
        /// The allowed range.
        most: f64,
    },
    /// Tenons with slack in a frame whose joints have friction in both directions.
    #[error(
        "{directions} of 2 directions have tenons with slack, but 0 may where joints rub in both directions at once: shake one direction at a time, or leave out the tenons or the friction of one"
    )]
    TenonsRubBothWays {
        /// Directions that have tenons.
        directions: usize,
    },
    /// Too many events at the same time.
    #[error(
        "{events} changes between sticking and slipping within 1e-9 s of {at_s} s: look at the friction forces, of which one may be next to nothing"
    )]
    TooManyEvents {
        /// Time of the events, s.
        at_s: f64,
        /// Number of changes.
        events: usize,
    },
    /// A frame that is to be released falls while its sliders stick.
    #[error(
        "the frame cannot be let go from {displacement_m} m: it falls as it stands, with every slider stuck; give it stiffness first"
    )]
    NoSwing {
        /// Displacement of the release, m.
        displacement_m: f64,
    },
    /// A released frame leaned too far.
    #[error(
        "let go from {displacement_m} m, storey {storey} of the frame leans beyond what small drifts can tell of, at {at_s} s: take a smaller displacement, or look whether it stands while its sliders slip"
    )]
    SwingFalls {
        /// Displacement of the release, m.
        displacement_m: f64,
        /// The storey, 1 the lowest.
        storey: usize,
        /// Time at which it leaned too far, s.
        at_s: f64,
    },
    /// A value of one joint or link of a chain out of its range.
    #[error("{part} {number}: {argument} is {given}, but must be {allowed}")]
    ChainPart {
        /// "joint", "link".
        part: &'static str,
        /// Its number, 1 the lowest.
        number: usize,
        /// The name of the value.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A list of the wrong length for a chain.
    #[error("{argument} has {given} entries, but the chain has {needed} links: give one for each")]
    ChainCount {
        /// The name of the list.
        argument: &'static str,
        /// Its length.
        given: usize,
        /// The number of links.
        needed: usize,
    },
    /// A joint opens at the edge of a bed of unknown width.
    #[error(
        "joint {joint} opens at the edge of its bed, but link {joint} has no bed_width_m: give it, or hold the joint"
    )]
    NoBedWidth {
        /// The joint, 1 the lowest.
        joint: usize,
    },
    /// No state of stick and slip of the joints satisfies Coulomb's law at an event.
    #[error(
        "at {at_s} s no state of sticking and turning joints was found in {tried} tries: the friction of some joint is far below the others', or the numbers of the chain lie too far apart"
    )]
    NoJointState {
        /// Time of the event, s.
        at_s: f64,
        /// Number of tried states.
        tried: usize,
    },
    /// Steps of a chain's motion became too short.
    #[error(
        "the motion of the chain cannot go on at {at_s} s: a step of {step_s} s was left; look for a dashpot or spring many decades above the others"
    )]
    StepTooShort {
        /// Time at which the steps became too short, s.
        at_s: f64,
        /// The remaining step, s.
        step_s: f64,
    },
    /// A matrix that is not valid for a structure.
    #[error("the {matrix} matrix must be {needed}")]
    Matrix {
        /// Name of the matrix.
        matrix: &'static str,
        /// The allowed range.
        needed: &'static str,
    },
    /// A list of the wrong length for a linear system.
    #[error("{argument} has {given} entries, but {needed} are needed")]
    Entries {
        /// The name of the list.
        argument: &'static str,
        /// Its length.
        given: usize,
        /// The required number.
        needed: usize,
    },
    /// An unbounded random response.
    #[error("{quantity} has no standard deviation: {why}")]
    Unbounded {
        /// The requested quantity.
        quantity: &'static str,
        /// The reason, and a remedy.
        why: &'static str,
    },
    /// A load is not filtered white noise, which Lyapunov's equation needs.
    #[error("a spectrum given as a table is no filtered white noise: use the integral over frequency")]
    NotRational,
    /// A random motion without a steady state.
    #[error("the motion does not settle: some mode has no damping; give each one some")]
    Unstable,
    /// An integral over frequency that needs too many intervals.
    #[error(
        "the integral over frequency needs more than {intervals} intervals: raise relative_tolerance or intervals_most, or give the modes more damping"
    )]
    Integral {
        /// Allowed number of intervals.
        intervals: usize,
    },
    /// The frame is refused.
    #[error(transparent)]
    Structure(#[from] StructureError),
    /// The wind is refused.
    #[error(transparent)]
    Wind(#[from] crate::structure::wind::WindError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl DynamicsError {
    /// Whether an iteration ended before it converged, in which case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Building(why) => why.did_not_converge(),
            Self::Structure(why) => why.did_not_converge(),
            Self::Columns(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::Argument { .. }
            | Self::Storey { .. }
            | Self::Count { .. }
            | Self::NoState { .. }
            | Self::TenonsRubBothWays { .. }
            | Self::TooManyEvents { .. }
            | Self::NoSwing { .. }
            | Self::SwingFalls { .. }
            | Self::ChainPart { .. }
            | Self::ChainCount { .. }
            | Self::NoBedWidth { .. }
            | Self::NoJointState { .. }
            | Self::StepTooShort { .. }
            | Self::Matrix { .. }
            | Self::Entries { .. }
            | Self::Unbounded { .. }
            | Self::NotRational
            | Self::Unstable
            | Self::Wind(_)
            | Self::Integral { .. } => false,
            Self::NotConverged { .. } => true,
        }
    }
}
