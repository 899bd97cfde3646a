//! Weight or mass of a part.

use super::quantity::{Pick, Quantity};

/// Weight or mass of a part: the file gives one of the two.
#[derive(Clone, Debug, PartialEq)]
pub enum Heaviness {
    /// Mass, kg.
    Mass(Quantity),
    /// Weight, N: divided by the project's gravity.
    Weight(Quantity),
}

impl Heaviness {
    /// The number in the file.
    pub fn quantity(&self) -> &Quantity {
        match self {
            Heaviness::Mass(quantity) | Heaviness::Weight(quantity) => quantity,
        }
    }

    /// Mass, kg, with the value that `pick` chooses.
    pub fn mass_kg(&self, gravity_m_s2: f64, pick: Pick<'_>) -> f64 {
        match self {
            Heaviness::Mass(mass) => pick(mass),
            Heaviness::Weight(weight) => pick(weight) / gravity_m_s2,
        }
    }
}
