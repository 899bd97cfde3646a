//! Springs that stand for the soil under a stack.

/// What the soil under a stack gives way to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SoilBelow {
    /// Moment over rotation of the base, the less of its two directions, N m/rad.
    pub rocking_stiffness_n_m_rad: f64,
    /// Springs per area of the joint on the ground that stand for it, Pa/m.
    pub normal_stiffness_pa_m: f64,
    /// The same along the joint, Pa/m.
    pub shear_stiffness_pa_m: f64,
}
