/// Why a structure cannot exist or its stiffness cannot be found. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
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
        /// Which one, from 1 at the bottom.
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
        /// Which link, from 1 at the bottom.
        link: usize,
        /// The value given, m above the lower joint.
        centroid_m: f64,
        /// The link's length, m.
        length_m: f64,
    },
    /// As many values are needed as there are parts.
    #[error("{quantity} has {given} values, but the {kind} has {needed} {parts}")]
    Count {
        /// What was counted.
        quantity: &'static str,
        /// How many were given.
        given: usize,
        /// "chain", "frame".
        kind: &'static str,
        /// How many are needed.
        needed: usize,
        /// "joints", "storeys".
        parts: &'static str,
    },
}
