//! Errors of a building: invalid input, or an unstable building.

/// Why a floor, a storey or a building is refused. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildingError {
    /// There are no floors.
    #[error("the building has no floors, but needs at least 1")]
    Empty,
    /// The numbers of storeys and floors differ.
    #[error("{storeys} storeys and {floors} floors are given: each floor stands on one storey, lowest first")]
    Count {
        /// Storeys given.
        storeys: usize,
        /// Floors given.
        floors: usize,
    },
    /// A value of a floor or storey is out of its range.
    #[error("{part} {number}: {quantity} is {given}, but must be {allowed}")]
    Value {
        /// "floor", "storey", "mode".
        part: &'static str,
        /// Number of the part, from 1 at the bottom.
        number: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A value of a wall or column is out of its range.
    #[error("storey {storey}, element {element}: {quantity} is {given}, but must be {allowed}")]
    Element {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Number of the element, from 1.
        element: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A stiffness matrix is not symmetric.
    #[error(
        "storey {storey}: its stiffness matrix has {upper} in row {row}, column {column}, but {lower} across its diagonal: \
         springs give equal numbers there"
    )]
    Asymmetric {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Row, from 1.
        row: usize,
        /// Column, from 1.
        column: usize,
        /// Entry at this place.
        upper: f64,
        /// Opposite entry across the diagonal.
        lower: f64,
    },
    /// A storey has no stiffness against sway in some direction.
    #[error(
        "storey {storey} does not resist sway toward {direction_degrees:.1} degrees from x: its stiffness there is \
         {stiffness_n_m} N/m; give a wall or column that does"
    )]
    Sways {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// That direction, degrees from x.
        direction_degrees: f64,
        /// Stiffness in that direction, N/m.
        stiffness_n_m: f64,
    },
    /// A storey has no stiffness against twist.
    #[error(
        "storey {storey} does not resist twisting: about its centre of rigidity ({x_m:.3}, {y_m:.3}) m its stiffness is \
         {stiffness_n_m_rad} N·m/rad; its walls all point at that place, or the matrix is not that of springs"
    )]
    Twists {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Centre of rigidity, x, m.
        x_m: f64,
        /// Centre of rigidity, y, m.
        y_m: f64,
        /// Stiffness against rotation about the centre of rigidity, N·m/rad.
        stiffness_n_m_rad: f64,
    },
    /// P-delta exceeds the stiffness of a storey.
    #[error(
        "the building falls: storey {storey} {motion} under {load_factor:.4} of the weight above it (P-delta); it needs \
         stiffer walls there, a lower weight or a lower storey"
    )]
    Falls {
        /// The storey that fails first, from 1 at the bottom.
        storey: usize,
        /// "sways", "twists".
        motion: &'static str,
        /// Factor on the weight at which it fails.
        load_factor: f64,
    },
    /// An outline is not the plan of a floor.
    #[error("the outline {why}: give its corners in order, each once")]
    Outline {
        /// Reason.
        why: String,
    },
    /// A point is outside a floor.
    #[error(
        "the point ({x_m}, {y_m}) m lies {beyond_m:.3} m outside the outline of floor {floor}: give a point on the floor"
    )]
    Outside {
        /// Number of the floor, from 1 at the bottom.
        floor: usize,
        /// x of the point, m.
        x_m: f64,
        /// y of the point, m.
        y_m: f64,
        /// Distance from the floor, m.
        beyond_m: f64,
    },
    /// A part does not exist.
    #[error("{part} {given} was asked for, but they are numbered from 1 to {most}")]
    Part {
        /// "floor", "mode".
        part: &'static str,
        /// The given number.
        given: usize,
        /// Largest number.
        most: usize,
    },
    /// An argument is out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Name of the argument.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Damping adds energy to a mode.
    #[error("mode {mode} at {frequency_hz:.4} Hz would have a damping ratio of {damping_ratio:.5}: {why}")]
    Damping {
        /// Number of the mode, from 1.
        mode: usize,
        /// Frequency of the mode, Hz.
        frequency_hz: f64,
        /// Damping ratio of the mode.
        damping_ratio: f64,
        /// Reason and remedy.
        why: &'static str,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
}

impl BuildingError {
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Linalg(why) => why.did_not_converge(),
            Self::Empty
            | Self::Count { .. }
            | Self::Value { .. }
            | Self::Element { .. }
            | Self::Asymmetric { .. }
            | Self::Sways { .. }
            | Self::Twists { .. }
            | Self::Falls { .. }
            | Self::Outline { .. }
            | Self::Outside { .. }
            | Self::Part { .. }
            | Self::Argument { .. }
            | Self::Damping { .. } => false,
        }
    }
}
