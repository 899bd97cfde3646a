//! The largest moment that a bed without tension passes.

/// A rectangular bed as the moment on it meets it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct BedEdge {
    /// b, width in the plane of the moment, m.
    pub width_m: f64,
    /// w, width across it, m.
    pub depth_m: f64,
    /// f, compressive strength of the bed, Pa; `None`: it does not crush.
    pub strength_pa: Option<f64>,
}

impl BedEdge {
    /// The moment at which the resultant of the pressure can move no further, N m, under a normal force of N.
    ///
    /// ```text
    /// M = N (b/2 − N/(2 f w))        stress block f over N/(f w) at the edge;  f → ∞: N b/2
    /// ```
    ///
    /// 0 where the bed crushes under N alone, or N pulls.
    pub fn moment_n_m(&self, normal_n: f64) -> f64 {
        let crushed_m = self
            .strength_pa
            .map_or(0.0, |strength_pa| normal_n / (strength_pa * self.depth_m));
        (0.5 * normal_n * (self.width_m - crushed_m)).max(0.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_edge_moment_with_and_without_strength() {
        let hard = BedEdge {
            width_m: 0.65,
            depth_m: 0.65,
            strength_pa: None,
        };
        assert!((hard.moment_n_m(68.3e3) - 22_197.5).abs() < 1e-9);
        // N = f w b/4: a block of a quarter of the bed, the resultant at 3/8 b
        let soft = BedEdge {
            strength_pa: Some(4.0 * 68.3e3 / (0.65 * 0.65)),
            ..hard
        };
        assert!((soft.moment_n_m(68.3e3) - 68.3e3 * 0.65 * 0.375).abs() < 1e-9);
        // at N = f w b the whole bed crushes
        assert!(soft.moment_n_m(4.0 * 68.3e3).abs() < 1e-9);
        assert_eq!((soft.moment_n_m(5.0 * 68.3e3), hard.moment_n_m(-1.0)), (0.0, 0.0));
    }
}
