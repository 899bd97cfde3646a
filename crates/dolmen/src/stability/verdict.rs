//! Verdicts on stability.

/// Whether a structure stands under its own weight.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Verdict {
    /// The load factor is at least [`Verdict::MARGINAL_BELOW`].
    Stable,
    /// It stands, but with a load factor below [`Verdict::MARGINAL_BELOW`].
    Marginal,
    /// It falls: load factor ≤ 1, or stiffness matrix that is not positive definite.
    Unstable,
    /// A necessary input is unknown.
    Unknown,
}

impl Verdict {
    /// Load factor below which "stable" becomes "marginal". Our choice: the relative error of a stiffness is twice that of the frequencies,
    /// and stone joints lose stiffness as they open.
    pub const MARGINAL_BELOW: f64 = 1.5;

    /// The verdict on a load factor λ (factor on gravity at which the structure falls). An infinite λ, without any gravity load, gives
    /// unknown.
    pub fn of_load_factor(load_factor: f64) -> Self {
        if load_factor.is_nan() || load_factor == f64::INFINITY {
            Verdict::Unknown
        } else if load_factor <= 1.0 {
            Verdict::Unstable
        } else if load_factor < Self::MARGINAL_BELOW {
            Verdict::Marginal
        } else {
            Verdict::Stable
        }
    }

    /// The word, in English: stable, marginal, unstable, unknown.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Stable => "stable",
            Verdict::Marginal => "marginal",
            Verdict::Unstable => "unstable",
            Verdict::Unknown => "unknown",
        }
    }
}
