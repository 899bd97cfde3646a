//! Interface between the stiffness search and a structure.

use super::{FrequencyRoots, SpringModel};
use crate::structure::{NaturalMode, Proportion, Spring, StiffnessNote, StructureError};

/// A structure of springs to be found, with its words.
pub(crate) trait Sprung {
    /// "links", "storeys".
    const PARTS: &'static str;
    /// Kind of element with the stiffness.
    const SPRING: Spring;

    fn model(&self) -> Result<SpringModel, StructureError>;

    /// Displacement at a height per unit of each coordinate.
    fn sensor(&self, height_m: f64) -> Result<Vec<f64>, StructureError>;

    /// A first guess of the stiffnesses, up to a factor.
    fn proportion(&self) -> Vec<f64>;

    /// What [`Sprung::proportion`] is in proportion to.
    fn proportion_to(&self) -> Proportion;

    fn natural_modes_with(&self, stiffness: &[f64]) -> Result<Vec<NaturalMode>, StructureError>;

    /// Every stiffness with exactly these frequencies, one a part; `None` where that would take too long.
    fn roots(&self, frequencies_hz: &[f64]) -> Result<Option<FrequencyRoots>, StructureError>;

    /// Assumptions of the model.
    fn assumptions(&self) -> Vec<StiffnessNote>;
}
