/// Why a structure cannot exist or its stiffness cannot be found. Each variant carries the value that was refused.
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
    /// A link's centre of mass lies outside it.
    #[error(
        "link {link}: centroid_m is {centroid_m}, but must lie between 0 and the link's length_m, {length_m}"
    )]
    Centroid {
        /// Number of the link, from 1 at the bottom.
        link: usize,
        /// The value given, m above the lower joint.
        centroid_m: f64,
        /// The link's length, m.
        length_m: f64,
    },
    /// As many values are needed as there are parts.
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
    /// There is no such part.
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
        "storey {storey}: axial_n is {given}, less than the {above} of the storey above it, but a storey carries its \
         own level and all above: if these are the loads of the levels alone, sum them from the top first"
    )]
    AxialOrder {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Its axial force, N.
        given: f64,
        /// Axial force of the storey above it, N.
        above: f64,
    },
    /// A tie does not join two different levels of the frame.
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
    /// Stiffness was asked of no modes.
    #[error("no measured mode is given, but stiffness needs at least 1")]
    ModesMissing,
    /// More modes than the structure has.
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
    /// Measured frequencies do not ascend.
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
    /// An option of the search is refused.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Its name.
        option: &'static str,
        /// The value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A number of a measured mode is refused.
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
    /// Not as many frequencies as storeys.
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
    /// Too many storeys for every root to be found.
    #[error("the frame has {given} storeys, but every root can be found for at most {most}: give shapes")]
    Storeys {
        /// Present number.
        given: usize,
        /// Most allowed.
        most: usize,
    },
    /// A storey's spring does not move in a shape.
    #[error(
        "storey {storey} does not move in this shape ({extension} of {largest}): its stiffness cannot be seen; give \
         another mode, or more than one"
    )]
    Invisible {
        /// Number of the storey, from 1 at the bottom.
        storey: usize,
        /// Extension of its spring.
        extension: f64,
        /// Largest displacement of the shape.
        largest: f64,
    },
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] dolmen_linalg::LinalgError),
}

impl StructureError {
    /// Whether an iteration ended before it converged: the input may be valid.
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
