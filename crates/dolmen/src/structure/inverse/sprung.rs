//! Interface between the stiffness search and a structure.

use super::{FrequencyRoots, SpringModel};
use crate::structure::{NaturalMode, Proportion, Spring, StiffnessNote, StructureError};

/// A structure with unknown springs, and its terms.
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

    /// The quantity to which [`Sprung::proportion`] is proportional.
    fn proportion_to(&self) -> Proportion;

    fn natural_modes_with(&self, stiffness: &[f64]) -> Result<Vec<NaturalMode>, StructureError>;

    /// All stiffnesses with exactly these frequencies, one for each part; `None` if this takes too long.
    fn roots(&self, frequencies_hz: &[f64]) -> Result<Option<FrequencyRoots>, StructureError>;

    fn assumptions(&self) -> Vec<StiffnessNote>;
}
