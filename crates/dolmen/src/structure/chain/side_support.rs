//! A spring at the side of a chain: posts that support a flagpole with play (Choi 2021, Fig. 6c).

use crate::structure::StructureError;

/// A lateral spring between the chain and the ground, with a gap.
///
/// # Limits
/// Matrices, modes and stability are linear. They include the spring **only if the gap is 0** (contact both ways). A spring with a
/// gap is left out, which is conservative until the chain has leaned that far. A time history includes the spring with its gap.
///
/// # Source
/// Differs from Choi (2021), who leaves out the posts because their support was found to be loose.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SideSupport {
    /// Height above the lowest joint, m.
    pub height_m: f64,
    /// Lateral stiffness in contact, N/m.
    pub stiffness_n_m: f64,
    /// Free travel before contact, to each side, m.
    pub gap_m: f64,
}

impl SideSupport {
    /// Whether linear analysis includes the spring: only without a gap.
    pub fn acts_linearly(&self) -> bool {
        self.gap_m == 0.0
    }

    pub(super) fn check(&self, number: usize, top_m: f64) -> Result<(), StructureError> {
        let SideSupport {
            height_m,
            stiffness_n_m,
            gap_m,
        } = *self;
        if !(height_m > 0.0 && height_m <= top_m) {
            return Err(StructureError::Height {
                quantity: "height_m of the side support",
                given: height_m,
                top_m,
            });
        }
        if !(stiffness_n_m > 0.0 && stiffness_n_m.is_finite()) {
            return Err(StructureError::NotPositive {
                part: "side support",
                number,
                quantity: "stiffness_n_m",
                given: stiffness_n_m,
            });
        }
        if !(gap_m >= 0.0 && gap_m.is_finite()) {
            return Err(StructureError::Negative {
                part: "side support",
                number,
                quantity: "gap_m",
                given: gap_m,
            });
        }
        Ok(())
    }
}
