//! A side support of a chain in a project file, and that of the library that it builds.

use super::axis::ChainAxis;
use crate::quantity::{Pick, Quantity};
use dolmen::structure::SideSupport;

/// A spring against the ground at the side of a chain.
#[derive(Clone, Debug, PartialEq)]
pub struct ChainSupportPart {
    /// Height above the lowest joint, m.
    pub height: Quantity,
    /// Stiffness once met, N/m.
    pub stiffness: Quantity,
    /// Free travel to each side, m; 0 if not given.
    pub gap: Option<Quantity>,
    /// The direction in which it holds the chain, from the file; `None`: that of motion.
    pub axis: Option<ChainAxis>,
}

impl ChainSupportPart {
    /// The numbers of the support, each with the value that `pick` chooses.
    pub fn build(&self, pick: Pick<'_>) -> SideSupport {
        SideSupport {
            height_m: pick(&self.height),
            stiffness_n_m: pick(&self.stiffness),
            gap_m: self.gap.as_ref().map_or(0.0, pick),
        }
    }

    pub(super) fn inputs(&self) -> impl Iterator<Item = &Quantity> {
        [&self.height, &self.stiffness].into_iter().chain(&self.gap)
    }
}
