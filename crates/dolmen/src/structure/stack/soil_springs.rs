//! Springs that represent the soil under a stack.

/// Springs of the soil under a stack.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoilBelow {
    /// Moment over rotation that the springs under the bed have, the smaller value of both directions, N m/rad.
    pub rocking_stiffness_n_m_rad: f64,
    /// Stiffness per area of the joint on the ground that represents the soil, Pa/m.
    pub normal_stiffness_pa_m: f64,
    /// Stiffness along the joint, Pa/m.
    pub shear_stiffness_pa_m: f64,
}
