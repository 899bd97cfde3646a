//! Side supports of a moving chain: no force within their gap, a spring beyond it.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | c | `lever_m` | displacement of the support's position per rotation of each link | m |
//! | u | `beside_m` | Σ c_i sin θ_i minus that of the lean: displacement from the stress-free position | m |
//! | s, g | `stiffness_n_m`, `gap_m` | stiffness, free travel to each side | N/m, m |
//! | F | `force_n` | s (u − g) beyond g, s (u + g) beyond −g, 0 between | N |

use super::chain_rotations::ChainRotations;
use crate::structure::{Chain, SideSupport, StructureError};

/// State of a side support during a step.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum PropState {
    /// No contact: the place is within the gap.
    Free,
    /// Contact at a displacement of this sign.
    Touching(f64),
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Prop {
    pub(super) lever_m: Vec<f64>,
    pub(super) stiffness_n_m: f64,
    pub(super) gap_m: f64,
    /// u of the lean alone, m.
    pub(super) leaning_m: f64,
}

impl Prop {
    pub(super) fn of(chain: &Chain, support: &SideSupport) -> Result<Self, StructureError> {
        Ok(Prop {
            lever_m: chain.lever_m_rad(support.height_m)?,
            stiffness_n_m: support.stiffness_n_m,
            gap_m: support.gap_m,
            leaning_m: 0.0,
        })
    }

    /// The supports of a chain that leans as a whole; gaps are measured from the leaning position.
    pub(super) fn leaning(&mut self, lean_rad: f64, rotations: ChainRotations) {
        self.leaning_m = 0.0;
        self.leaning_m = self.beside_m(&vec![lean_rad; self.lever_m.len()], rotations);
    }

    pub(super) fn beside_m(&self, theta: &[f64], rotations: ChainRotations) -> f64 {
        let each = self.lever_m.iter().zip(theta);
        let sum: f64 = match rotations {
            ChainRotations::Large => each.map(|(c, theta)| c * theta.sin()).sum(),
            ChainRotations::Small => each.map(|(c, theta)| c * theta).sum(),
        };
        sum - self.leaning_m
    }

    /// State for the current displacement; without a gap there is always contact.
    pub(super) fn state(&self, beside_m: f64) -> PropState {
        match self.gap_m == 0.0 || beside_m.abs() > self.gap_m {
            true => PropState::Touching(if beside_m < 0.0 { -1.0 } else { 1.0 }),
            false => PropState::Free,
        }
    }

    /// Compression of the support, m, with the sign of the displacement.
    fn pressed_m(&self, beside_m: f64) -> f64 {
        (beside_m.abs() - self.gap_m).max(0.0).copysign(beside_m)
    }

    pub(super) fn force_n(&self, beside_m: f64) -> f64 {
        self.stiffness_n_m * self.pressed_m(beside_m)
    }

    pub(super) fn energy_j(&self, beside_m: f64) -> f64 {
        0.5 * self.stiffness_n_m * self.pressed_m(beside_m).powi(2)
    }
}
