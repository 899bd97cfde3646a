//! The contacts of loose stones if the file gives nothing about them.

use dolmen::structure::stack::JointMaterial;

/// Normal stiffness of the contacts of loose stones if the file gives none, Pa/m. Our choice: below that of solid granite under a face 0.1 m wide, E/a =
/// 4e11; the usual stiffness of beds is a hundredth of it, and stones would sink into each other at their small contacts.
const LOOSE_STIFFNESS_PA_M: f64 = 1e11;
/// Shear stiffness over normal stiffness, as of beds.
const LOOSE_SHEAR_PART: f64 = 0.4;

/// The contacts of loose stones if the file gives nothing.
pub(super) fn loose_material() -> JointMaterial {
    JointMaterial {
        normal_stiffness_pa_m: LOOSE_STIFFNESS_PA_M,
        shear_stiffness_pa_m: LOOSE_SHEAR_PART * LOOSE_STIFFNESS_PA_M,
        ..JointMaterial::default()
    }
}
