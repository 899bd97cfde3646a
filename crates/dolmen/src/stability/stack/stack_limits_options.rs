//! Options of [`stack_limits`](super::stack_limits).

use super::StackLoads;

/// What the limits depend on besides the stack.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct StackLimits {
    /// What acts before any horizontal shaking. Default nothing.
    pub loads: StackLoads,
    /// Moment over rotation of the whole base on its soil, N m/rad, the same in all directions. Default `None`: rigid.
    pub soil_rocking_stiffness_n_m_rad: Option<f64>,
}
