//! Terms in the notes on stiffness: the kind of spring, the misfit, and the thoroughness of the search.

use std::fmt;

/// Kind of element whose stiffness is identified.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Spring {
    /// The rotational spring of a joint of a chain.
    Joint,
    /// The lateral spring of a storey of a frame.
    Storey,
}

impl fmt::Display for Spring {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Spring::Joint => "joint",
            Spring::Storey => "storey",
        })
    }
}

/// Assumed proportion between stiffnesses that the data do not determine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Proportion {
    /// The weight moment above each joint of a chain.
    WeightMoment,
    /// The mass moment above each storey over its height: a nearly straight first shape.
    MassMomentOverHeight,
    /// The mass above each storey.
    MassAbove,
}

impl fmt::Display for Proportion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Proportion::WeightMoment => "the weight moment above each joint",
            Proportion::MassMomentOverHeight => {
                "the mass moment above each storey over its height (a nearly straight first shape)"
            }
            Proportion::MassAbove => "the mass above each storey",
        })
    }
}

/// Misfit of a set of stiffnesses, root mean square.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Misfit {
    /// Relative to the data, which have no standard deviation.
    Relative(f64),
    /// In standard deviations of the data.
    Deviations(f64),
}

impl fmt::Display for Misfit {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Misfit::Relative(share) => write!(f, "{:.2} % (root mean square)", 100.0 * share),
            Misfit::Deviations(count) => write!(f, "{count:.1} standard deviations (root mean square)"),
        }
    }
}

/// Thoroughness of the search for solutions.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Thoroughness {
    /// All complex solutions were followed: these exact frequencies have no other solution.
    All {
        /// Number of complex solutions.
        solutions_complex: usize,
    },
    /// Searched from starting points: there may be more.
    Searched {
        /// Starting points tried.
        starts: usize,
    },
}

impl fmt::Display for Thoroughness {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Thoroughness::All { solutions_complex } => write!(
                f,
                "all {solutions_complex} solutions in complex numbers were followed, so for exactly these frequencies \
                 there is no other"
            ),
            Thoroughness::Searched { starts } => {
                write!(
                    f,
                    "found from {}; there may be more",
                    counted(*starts, "start", "starts")
                )
            }
        }
    }
}

/// A value that belongs to one spring.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct OfSpring {
    /// The joint or storey, from 1, lowest first.
    pub number: usize,
    /// Value in the note.
    pub value: f64,
}

/// "1 start", "5 starts".
pub(super) fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}
