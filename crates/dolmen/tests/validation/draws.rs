//! Seeded draws of the laws tested here: the same on every machine.

use dolmen::structure::{Chain, Inertia, Link};

/// A 64-bit linear congruential sequence (Knuth's MMIX constants), upper bits taken: enough to scatter test cases.
pub(crate) struct Draws(u64);

impl Draws {
    pub(crate) fn new(seed: u64) -> Self {
        Draws(seed.wrapping_mul(0x9E37_79B9_7F4A_7C15) | 1)
    }

    /// Uniform in [0, 1).
    pub(crate) fn unit(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 11) as f64 / (1u64 << 53) as f64
    }

    pub(crate) fn between(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * self.unit()
    }

    /// Standard normal (Box & Muller 1958).
    pub(crate) fn normal(&mut self) -> f64 {
        let radius = (-2.0 * (1.0 - self.unit()).ln()).sqrt();
        radius * (std::f64::consts::TAU * self.unit()).cos()
    }

    /// A chain of n links with masses over two decades.
    pub(crate) fn chain(&mut self, n: usize) -> Chain {
        let links = (0..n)
            .map(|_| {
                let length_m = self.between(0.2, 4.0);
                Link {
                    mass_kg: 50.0 * 100_f64.powf(self.unit()),
                    length_m,
                    centroid_m: length_m * self.between(0.05, 0.95),
                    inertia: Inertia::ThinRod,
                    bed_width_m: Some(self.between(0.2, 1.0)),
                }
            })
            .collect();
        Chain::new(links, 9.81).unwrap()
    }
}
