//! Movements of the ground under single stones of a stack.

/// Movement of the ground below one block: an abutment that yields, a footing that settles.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SupportMovement {
    /// The block, which stands on the ground.
    pub block: usize,
    /// Displacement of the ground below it, m, z up.
    pub movement_m: [f64; 3],
}

impl SupportMovement {
    /// Length of the displacement, m.
    pub fn length_m(&self) -> f64 {
        self.movement_m.iter().map(|part| part * part).sum::<f64>().sqrt()
    }
}
