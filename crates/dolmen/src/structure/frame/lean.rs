//! Lateral forces from the weight of a leaning frame.

use super::storeys::Frame;

impl Frame {
    /// Horizontal forces at the levels, N, with the moments of the axial forces in storeys that lean by `tilt`, horizontal over vertical.
    ///
    /// ```text
    /// F = Bᵀ N τ:  F_i = (N_i − N_{i+1}) τ                                 n levels
    /// ```
    pub fn lean_forces_n(&self, tilt: f64) -> Vec<f64> {
        let storeys = self.storeys();
        let above = |i: usize| storeys.get(i + 1).map_or(0.0, |above| above.axial_n);
        let each = storeys.iter().enumerate();
        each.map(|(i, storey)| (storey.axial_n - above(i)) * tilt)
            .collect()
    }
}
