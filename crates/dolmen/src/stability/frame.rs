//! Stability of a frame: P-delta against storey stiffness.

use super::Verdict;

/// One storey of a frame with known stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct StoreyStability {
    /// k_i, N/m.
    pub stiffness_n_m: f64,
    /// N_i / l_i, what P-delta takes from it, N/m.
    pub geometric_n_m: f64,
    /// Least k_i at which the frame stands, the other storeys as they are; `None` if it falls whatever k_i is.
    pub stiffness_least_n_m: Option<f64>,
    /// k_i / k_i,min.
    pub margin: Option<f64>,
}

/// A frame with known storey stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameStability {
    /// Lowest storey first.
    pub storeys: Vec<StoreyStability>,
    /// λ, smallest factor on the axial forces that makes K singular; infinite without axial force.
    pub load_factor: f64,
    /// stable, marginal, unstable.
    pub verdict: Verdict,
}
