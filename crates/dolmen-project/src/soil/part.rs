//! The soil of a project file, and that of the library that it builds.

use crate::quantity::{Pick, Quantity};
use dolmen::structure::stack::{Stack, StackError};
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

/// The soil below a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct SoilBelowPart {
    /// Shear modulus, Pa.
    pub shear_modulus: Quantity,
    /// Poisson's ratio.
    pub poisson_ratio: Quantity,
    /// The footing; `None` for the bed of the lowest block.
    pub footing: Option<FootingPart>,
}

impl FootingPart {
    /// The sides or the diameter of the footing.
    pub(super) fn sides(&self) -> &[Quantity] {
        match self {
            FootingPart::Circle(diameter) => std::slice::from_ref(diameter),
            FootingPart::Rectangle(sides) => sides,
        }
    }

    fn build(&self, pick: Pick<'_>) -> Footing {
        match self {
            FootingPart::Circle(diameter) => Footing::Circle {
                diameter_m: pick(diameter),
            },
            FootingPart::Rectangle([along, across]) => Footing::Rectangle {
                along_m: pick(along),
                across_m: pick(across),
            },
        }
    }
}

impl SoilBelowPart {
    /// The stack on this soil, each number with the value that `pick` chooses.
    ///
    /// # Errors
    /// [`StackError`] for a stack with several blocks on the ground, and for values out of their range.
    pub fn below(&self, stack: Stack, pick: Pick<'_>) -> Result<Stack, StackError> {
        let half_space = [pick(&self.shear_modulus), pick(&self.poisson_ratio)];
        let footing = self.footing.as_ref().map(|footing| footing.build(pick));
        stack.on_half_space(half_space, footing)
    }

    /// The numbers of the soil.
    pub(crate) fn inputs(&self) -> Vec<&Quantity> {
        let footing = self.footing.iter().flat_map(FootingPart::sides);
        [&self.shear_modulus, &self.poisson_ratio]
            .into_iter()
            .chain(footing)
            .collect()
    }
}

impl SoilPart {
    /// The numbers of the soil, each with the value that `pick` chooses.
    pub fn build(&self, pick: Pick<'_>) -> Soil {
        Soil {
            shear_modulus_pa: pick(&self.shear_modulus),
            poisson_ratio: pick(&self.poisson_ratio),
            footing: self.footing.build(pick),
        }
    }

    /// The numbers of the soil.
    pub(crate) fn inputs(&self) -> Vec<&Quantity> {
        let footing = self.footing.sides();
        [&self.shear_modulus, &self.poisson_ratio]
            .into_iter()
            .chain(footing)
            .collect()
    }
}
