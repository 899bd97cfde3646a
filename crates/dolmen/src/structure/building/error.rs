//! Errors of a building: invalid input, or a building that falls.

/// Why a floor, a storey or a building is refused. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum BuildingError {
    /// No floors.
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
    /// A refused number of a floor or storey.
    #[error("{part} {number}: {quantity} is {given}, but must be {allowed}")]
    Value {
        /// "floor", "storey", "mode".
        part: &'static str,
        /// Its number, from 1 at the bottom.
        number: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A refused number of a wall or column.
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
    /// A stiffness matrix that is not symmetric.
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
        /// The number there.
        upper: f64,
        /// The opposite number across the diagonal.
        lower: f64,
    },
    /// A storey without stiffness against sway in some direction.
    #[error(
        "storey {storey} does not resist sway toward {direction_degrees:.1} degrees from x: its stiffness there is \
         {stiffness_n_m} N/m; give a wall or column that does"
    )]
    Sways {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// The direction, degrees from x.
        direction_degrees: f64,
        /// Stiffness in it, N/m.
        stiffness_n_m: f64,
    },
    /// A storey without stiffness against twisting.
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
        /// Stiffness against rotation about it, N·m/rad.
        stiffness_n_m_rad: f64,
    },
    /// P-delta exceeds the stiffness of a storey.
    #[error(
        "the building falls: storey {storey} {motion} under {load_factor:.4} of the weight above it (P-delta); it needs \
         stiffer walls there, a lower weight or a lower storey"
    )]
    Falls {
        /// The storey that falls first, from 1 at the bottom.
        storey: usize,
        /// "sways", "twists".
        motion: &'static str,
        /// Factor on the weight at which it falls.
        load_factor: f64,
    },
    /// An outline that is not the plan of a floor.
    #[error("the outline {why}: give its corners in order, each once")]
    Outline {
        /// The fault.
        why: String,
    },
    /// A point outside a floor.
    #[error(
        "the point ({x_m}, {y_m}) m lies {beyond_m:.3} m outside the outline of floor {floor}: give a point on the floor"
    )]
    Outside {
        /// Number of the floor, from 1 at the bottom.
        floor: usize,
        /// The point, m.
        x_m: f64,
        /// The point, m.
        y_m: f64,
        /// Distance outside, m.
        beyond_m: f64,
    },
    /// A part that does not exist.
    #[error("{part} {given} was asked for, but they are numbered from 1 to {most}")]
    Part {
        /// "floor", "mode".
        part: &'static str,
        /// The given number.
        given: usize,
        /// Largest number.
        most: usize,
    },
    /// A refused argument.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// Its name.
        argument: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// Damping that adds energy to a mode.
    #[error("mode {mode} at {frequency_hz:.4} Hz would have a damping ratio of {damping_ratio:.5}: {why}")]
    Damping {
        /// Number of the mode, from 1.
        mode: usize,
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Its damping ratio.
        damping_ratio: f64,
        /// The reason and the remedy.
        why: &'static str,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
}

impl BuildingError {
    /// Whether the error is an iteration that did not converge: the input may be valid.
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
