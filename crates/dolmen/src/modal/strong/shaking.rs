//! A strong motion in a record, with its times.

/// Classification of a strong motion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ShakingKind {
    /// An earthquake.
    Earthquake,
    /// An earthquake, or what else shakes a structure: the record does not tell.
    EarthquakeOrTraffic,
}

/// A strong motion in a record, s from its first sample.
#[derive(Clone, Debug, PartialEq)]
pub struct Shaking {
    /// Classification of the motion.
    pub kind: ShakingKind,
    /// It rises out of the noise.
    pub arrival_s: f64,
    /// 5 % of its energy has come.
    pub strong_from_s: f64,
    /// 95 % of its energy has come.
    pub strong_to_s: f64,
    /// It has sunk into the noise again, the next one begins, or the record ends.
    pub end_s: f64,
    /// Whether the record continues after the motion.
    pub ends: bool,
    /// Its largest level over that of the noise, of the channel that moves least.
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
