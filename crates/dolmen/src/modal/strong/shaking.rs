//! A strong motion in a record, with its times.

/// Classification of a strong motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShakingKind {
    /// An earthquake.
    Earthquake,
    /// An earthquake or other shaking; the record does not allow a decision.
    EarthquakeOrTraffic,
}

/// A strong motion in a record, s from its first sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaking {
    /// Classification of the motion.
    pub kind: ShakingKind,
    /// Time at which the motion exceeds the noise.
    pub arrival_s: f64,
    /// Time at which 5 % of the energy is reached.
    pub strong_from_s: f64,
    /// Time at which 95 % of the energy is reached.
    pub strong_to_s: f64,
    /// Time at which the motion falls to the noise, the next motion begins, or the record ends.
    pub end_s: f64,
    /// Whether the record continues after the motion.
    pub ends: bool,
    /// Largest level over that of the noise, for the channel with the smallest ratio.
    pub over_noise: f64,
    /// Largest growth of that level within two seconds.
    pub growth: f64,
}

impl Shaking {
    pub(super) fn shift(&mut self, by_s: f64) {
        let times = [
            &mut self.arrival_s,
            &mut self.strong_from_s,
            &mut self.strong_to_s,
            &mut self.end_s,
        ];
        times.into_iter().for_each(|at_s| *at_s += by_s);
    }
}
