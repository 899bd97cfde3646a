/// Why a structure is invalid or its stiffness cannot be found. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum StructureError {
    /// A chain without links or a frame without storeys.
    #[error("the {kind} has no {parts}, but needs at least 1")]
    Empty {
        /// "chain", "frame".
        kind: &'static str,
        /// "links", "storeys".
        parts: &'static str,
    },
    /// A quantity that must be positive and finite is not.
    #[error("{part} {number}: {quantity} is {given}, but must be a positive number")]
    NotPositive {
        /// "link", "storey", "joint".
        part: &'static str,
        /// Its number, from 1 at the bottom.
        number: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// The centre of mass of a link is outside the link.
    #[error(
        "link {link}: centroid_m is {centroid_m}, but must lie between 0 and the link's length_m, {length_m}"
    )]
    Centroid {
        /// Number of the link, from 1 at the bottom.
        link: usize,
        /// The value given, m above the lower joint.
        centroid_m: f64,
        /// Length of the link, m.
        length_m: f64,
    },
    /// The number of values does not match the number of parts.
    #[error("{quantity} has {given} values, but the {kind} has {needed} {parts}")]
    Count {
        /// The counted quantity.
        quantity: &'static str,
        /// Given number.
        given: usize,
        /// "chain", "frame".
        kind: &'static str,
        /// Required number.
        needed: usize,
        /// "joints", "storeys".
        parts: &'static str,
    },
    /// The acceleration of gravity is not positive.
    #[error("gravity_m_s2 is {given}, but must be a positive number (9.81 on Earth)")]
    Gravity {
        /// The value given, m/s².
        given: f64,
    },
    /// A quantity that must be zero or positive and finite is not.
    #[error("{part} {number}: {quantity} is {given}, but must be 0 or a positive number")]
    Negative {
        /// "joint", "side support".
        part: &'static str,
        /// Its number, from 1 at the bottom.
        number: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// The part does not exist.
    #[error("{part} {given} was asked for, but they are numbered from 1 at the bottom to {most}")]
    Part {
        /// "link", "joint", "storey".
        part: &'static str,
        /// Number given.
        given: usize,
        /// Largest number.
        most: usize,
    },
    /// A height is not on the structure.
    #[error("{quantity} is {given}, but must lie on the structure: between 0 and its top at {top_m:.3} m")]
    Height {
        /// Name of the quantity.
        quantity: &'static str,
        /// The value given, m above the lowest joint.
        given: f64,
        /// Height of the top, m.
        top_m: f64,
    },
    /// A storey carries less than the storey above it.
    #[error(
        "storey {storey}: its axial force is {given} N, less than the {above} N of the storey above it, but a storey carries its \
         own level and all above: if these are the loads of the levels alone, sum them from the top first"
    )]
    AxialOrder {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Axial force of the storey, N.
        given: f64,
        /// Axial force of the storey above it, N.
        above: f64,
    },
    /// A tie does not connect two different levels of the frame.
    #[error(
        "tie {tie} joins levels {lower} and {upper}, but must join two different levels between 0 (ground) and {most}"
    )]
    Tie {
        /// Number of the tie, from 1.
        tie: usize,
        /// One level given.
        lower: usize,
        /// The other level given.
        upper: usize,
        /// Top level.
        most: usize,
    },
    /// No modes are given for the stiffness.
    #[error("no measured mode is given, but stiffness needs at least 1")]
    ModesMissing,
    /// More modes are given than the structure has.
    #[error(
        "{given} measured modes are given, but a structure of {most} {parts} has only {most}: give the lowest {most}"
    )]
    ModesMost {
        /// Given number.
        given: usize,
        /// Number in the structure.
        most: usize,
        /// "links", "storeys".
        parts: &'static str,
    },
    /// Measured frequencies are not in ascending order.
    #[error(
        "mode {mode}: frequency_hz is {given}, not above the {before} of the mode before it: give the modes in ascending \
         order, each once"
    )]
    FrequencyOrder {
        /// Number of the mode, from 1.
        mode: usize,
        /// Its frequency, Hz.
        given: f64,
        /// Frequency of the mode before it, Hz.
        before: f64,
    },
    /// An option of the search is out of range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A value of a measured mode is out of range.
    #[error("mode {mode}: {quantity} is {given}, but must be {allowed}")]
    Mode {
        /// Number of the mode, from 1.
        mode: usize,
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// The number of frequencies differs from the number of storeys.
    #[error(
        "frequencies_hz has {given} values, but the stiffness of {needed} storeys follows from {needed}: no more can \
         exist, and fewer leave a continuous family of solutions"
    )]
    Frequencies {
        /// Given number.
        given: usize,
        /// Required number.
        needed: usize,
    },
    /// Too many storeys to find every solution.
    #[error("the frame has {given} storeys, but every root can be found for at most {most}: give shapes")]
    Storeys {
        /// Given number.
        given: usize,
        /// Largest allowed number.
        most: usize,
    },
    /// The spring of a storey does not deform in a shape.
    #[error(
        "storey {storey} does not move in this shape ({extension} of {largest}): its stiffness cannot be seen; give \
         another mode, or more than one"
    )]
    Invisible {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Extension of the spring.
        extension: f64,
        /// Largest displacement of the shape.
        largest: f64,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
}

impl StructureError {
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Linalg(why) => why.did_not_converge(),
            Self::Empty { .. }
            | Self::NotPositive { .. }
            | Self::Centroid { .. }
            | Self::Count { .. }
            | Self::Gravity { .. }
            | Self::Negative { .. }
            | Self::Part { .. }
            | Self::Height { .. }
            | Self::AxialOrder { .. }
            | Self::Tie { .. }
            | Self::ModesMissing
            | Self::ModesMost { .. }
            | Self::FrequencyOrder { .. }
            | Self::Option { .. }
            | Self::Mode { .. }
            | Self::Frequencies { .. }
            | Self::Storeys { .. }
            | Self::Invisible { .. } => false,
        }
    }
}
