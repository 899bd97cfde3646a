//! One storey in plan without its stiffness, its measured modes, and the errors of the search.

/// The main motion of a floor in a mode.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum PlanMotion {
    /// Along x.
    X,
    /// Along y.
    Y,
    /// Rotation.
    Torsion,
}

impl PlanMotion {
    /// All three, in the order of the coordinates u, v, θ.
    pub const ALL: [PlanMotion; 3] = [PlanMotion::X, PlanMotion::Y, PlanMotion::Torsion];

    /// Its place in [`PlanMotion::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }
}

/// How much a floor turns in a mode along x or y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// ρθ over the displacement of the centre of mass along the direction of the mode; θ counterclockwise.
    pub ratio: f64,
    /// Its standard deviation; 0 if it is not known.
    pub sd: f64,
}

/// One measured mode of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Its standard deviation, Hz; 0 if it is not known.
    pub frequency_sd_hz: f64,
    /// How the floor moves, if that was measured.
    pub motion: Option<PlanMotion>,
    /// Its twist, if that was measured.
    pub twist: Option<Twist>,
    /// u, v and ρθ of the centre of mass, with any common scale, if all of them were measured.
    pub shape: Option<[f64; 3]>,
}

/// The floor and its storey, without the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanStorey {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Radius of gyration about the centre of mass, m.
    pub gyration_m: f64,
    /// Reduction of the sway stiffness by the weight, m g/h, N/m; 0 without P-delta.
    pub weight_takes_n_m: f64,
    /// Given centre of rigidity from the centre of mass, m. Not used where twists determine it.
    pub eccentricity_m: [f64; 2],
}

/// Source of the eccentricity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum EccentricityFrom {
    /// It was given.
    Stated,
    /// From the twists of the modes along x and y.
    Twists,
}

/// Which of the modes, in ascending order, moves along x, along y and in rotation, with the twists of the first two.
#[derive(Clone, Copy)]
pub(super) struct Labelled {
    pub(super) mode_of: [usize; 3],
    pub(super) twist: [f64; 2],
}

/// Why the search for a stiffness fails.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanStiffnessError {
    /// A refused number.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Argument {
        /// Its name with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// What is allowed.
        allowed: &'static str,
    },
    /// No frequency, or more than a floor has.
    #[error("{given} modes were measured, but one floor has 3: along x, along y, torsion")]
    Modes {
        /// How many.
        given: usize,
    },
    /// Two modes with the same motion.
    #[error("two modes of motion {motion:?} were measured, but one floor has one of each")]
    Twice {
        /// The motion.
        motion: PlanMotion,
    },
    /// Two equal frequencies, with sway and twist coupled.
    #[error(
        "{frequency_hz} Hz was measured twice: sway and twist that couple have no shapes of their own at one frequency"
    )]
    Repeated {
        /// The frequency, Hz.
        frequency_hz: f64,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Structure(#[from] crate::structure::StructureError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
}

impl PlanStiffnessError {
    /// Whether an iteration ended before it converged, in which case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Structure(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::Argument { .. } | Self::Modes { .. } | Self::Twice { .. } | Self::Repeated { .. } => false,
        }
    }
}
