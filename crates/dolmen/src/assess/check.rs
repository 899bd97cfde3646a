//! The whole check of one structure: everything that needs no time history.

use super::CentroidEffect;
use crate::stability::{ChainLimits, ChainStability};
use crate::structure::NaturalMode;

/// All that can be said of a chain at once.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainCheck {
    /// From weights and lengths alone.
    pub limits: ChainLimits,
    /// With the joints' stiffness; `None` if it is not known.
    pub stability: Option<ChainStability>,
    /// Natural modes with the joints' stiffness; empty if it is not known.
    pub modes: Vec<NaturalMode>,
    /// What lowering each centroid does.
    pub centroids: Vec<CentroidEffect>,
}
