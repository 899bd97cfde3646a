//! Tolerances for watching contacts.

/// Shift of a face on its bed after which the patch is clipped again, over the radius of the smaller body. Our choice: the rocking
/// edge has the same accuracy.
const CLIP_AGAIN: f64 = 5e-4;

/// Tolerances for watching contacts.
#[derive(Clone, Copy, Debug)]
pub(super) struct ContactTolerances {
    /// Shift of a face on its bed after which the patch is clipped again, over the radius of the smaller body.
    pub(super) clip_again: f64,
    /// Gap at which two bodies get a patch, over the radius of the smaller body; larger than the undetected motion.
    pub(super) near: f64,
    /// Gap at which they lose it again, over the radius of the smaller body.
    pub(super) far: f64,
}

impl Default for ContactTolerances {
    /// Tolerances of the springs law. Our choice.
    fn default() -> Self {
        ContactTolerances {
            clip_again: CLIP_AGAIN,
            near: 2e-3,
            far: 2e-2,
        }
    }
}
