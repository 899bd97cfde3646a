//! The soil of a project file, and that of the science it builds.

use crate::quantity::{Pick, Quantity};
use dolmen::structure::{Footing, Soil};

/// The plan of a footing.
#[derive(Clone, Debug, PartialEq)]
pub enum FootingPart {
    /// A circle by its diameter, m.
    Circle(Quantity),
    /// A rectangle by its sides along and across the motion, m.
    Rectangle([Quantity; 2]),
}

/// The soil below the lowest joint, and the footing on it.
#[derive(Clone, Debug, PartialEq)]
pub struct SoilPart {
    /// Shear modulus, Pa.
    pub shear_modulus: Quantity,
    /// Poisson's ratio.
    pub poisson_ratio: Quantity,
    /// The footing.
    pub footing: FootingPart,
}

impl SoilPart {
    /// Its numbers, each with the value that `pick` chooses.
    pub fn build(&self, pick: Pick<'_>) -> Soil {
        Soil {
            shear_modulus_pa: pick(&self.shear_modulus),
            poisson_ratio: pick(&self.poisson_ratio),
            footing: match &self.footing {
                FootingPart::Circle(diameter) => Footing::Circle {
                    diameter_m: pick(diameter),
                },
                FootingPart::Rectangle([along, across]) => Footing::Rectangle {
                    along_m: pick(along),
                    across_m: pick(across),
                },
            },
        }
    }

    /// Its numbers.
    pub(super) fn inputs(&self) -> Vec<&Quantity> {
        let footing = match &self.footing {
            FootingPart::Circle(diameter) => std::slice::from_ref(diameter),
            FootingPart::Rectangle(sides) => sides,
        };
        [&self.shear_modulus, &self.poisson_ratio]
            .into_iter()
            .chain(footing)
            .collect()
    }
}
