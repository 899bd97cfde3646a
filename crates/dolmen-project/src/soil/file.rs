//! The keys of the soil.

use crate::file_number::{At, QuantityRaw};
use schemars::JsonSchema;

/// The soil below the lowest joint.
#[derive(Debug, serde::Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub(crate) struct HalfSpaceRaw {
    /// Shear modulus: density times the square of the shear wave velocity.
    #[schemars(required)]
    pub(in crate::soil) shear_modulus: Option<At<QuantityRaw>>,
    /// Poisson's ratio, 0 to 0.5.
    #[schemars(required)]
    pub(in crate::soil) poisson_ratio: Option<At<QuantityRaw>>,
    /// Diameter of a round footing.
    pub(in crate::soil) diameter: Option<At<QuantityRaw>>,
    /// Side of a rectangular footing in the direction of motion.
    pub(in crate::soil) along: Option<At<QuantityRaw>>,
    /// Side of a rectangular footing across the direction of motion.
    pub(in crate::soil) across: Option<At<QuantityRaw>>,
}
