//! Input and errors of the plan stiffness search: one storey in plan without its stiffness, and its measured modes.

/// Predominant motion of a floor in a mode.
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
    /// All motions, in the order of the coordinates u, v, θ.
    pub const ALL: [PlanMotion; 3] = [PlanMotion::X, PlanMotion::Y, PlanMotion::Torsion];

    /// Index in [`PlanMotion::ALL`].
    pub fn index(self) -> usize {
        self as usize
    }
}

/// Rotation of a floor in a mode along x or y.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Twist {
    /// ρθ divided by the displacement of the centre of mass along the direction of the mode; θ counterclockwise.
    pub ratio: f64,
    /// Standard deviation of the ratio; 0 if unknown.
    pub sd: f64,
}

/// One measured mode of the floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanMode {
    /// Frequency, Hz.
    pub frequency_hz: f64,
    /// Standard deviation of the frequency, Hz; 0 if unknown.
    pub frequency_sd_hz: f64,
    /// Predominant motion of the floor, if measured.
    pub motion: Option<PlanMotion>,
    /// Twist of the mode, if measured.
    pub twist: Option<Twist>,
    /// u, v and ρθ of the centre of mass, with any common scale, if all three were measured.
    pub shape: Option<[f64; 3]>,
}

/// Mass and geometry of a floor and its storey, without the stiffness.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PlanStorey {
    /// Mass, kg.
    pub mass_kg: f64,
    /// Radius of gyration about the centre of mass, m.
    pub gyration_m: f64,
    /// Reduction of the sway stiffness by P-delta, m g/h, N/m; 0 without P-delta.
    pub weight_takes_n_m: f64,
    /// Given position of the centre of rigidity relative to the centre of mass, m. Ignored if twists determine it.
    pub eccentricity_m: [f64; 2],
}

/// Source of the eccentricity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize), serde(rename_all = "snake_case"))]
pub enum EccentricityFrom {
    /// Given by the user.
    Stated,
    /// From the twists of the modes along x and y.
    Twists,
}

/// Indices of the modes, in ascending order, that move along x, along y and in rotation, with the twists of the first
/// two.
#[derive(Clone, Copy)]
pub(super) struct Labelled {
    pub(super) mode_of: [usize; 3],
    pub(super) twist: [f64; 2],
}

/// Error of the stiffness search.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum PlanStiffnessError {
    /// A number is out of its range.
    #[error("{quantity} is {given}, but must be {allowed}")]
    Argument {
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The given value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// No frequency is given, or more frequencies than a floor has modes.
    #[error("{given} modes were measured, but one floor has 3: along x, along y, torsion")]
    Modes {
        /// Number of frequencies.
        given: usize,
    },
    /// Two modes have the same motion.
    #[error("two modes of motion {motion:?} were measured, but one floor has one of each")]
    Twice {
        /// The motion.
        motion: PlanMotion,
    },
    /// Two frequencies are equal although sway and twist are coupled.
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
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Structure(why) => why.did_not_converge(),
            Self::Linalg(why) => why.did_not_converge(),
            Self::Argument { .. } | Self::Modes { .. } | Self::Twice { .. } | Self::Repeated { .. } => false,
        }
    }
}
