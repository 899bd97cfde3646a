//! A probability counted from seeded samples, with its interval.

/// How often something happened among independent samples.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Probability {
    /// Samples in which it happened.
    pub count: usize,
    /// Samples drawn.
    pub samples: usize,
    /// count / samples.
    pub estimate: f64,
    /// Lower end of the Clopper–Pearson interval.
    pub lower: f64,
    /// Upper end of it.
    pub upper: f64,
    /// Confidence of the interval, 0.95 if nothing else is said.
    pub confidence: f64,
    /// Seed of the samples.
    pub seed: u64,
}
