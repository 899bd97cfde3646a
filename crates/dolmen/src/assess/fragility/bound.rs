//! Bounds of a capacity for observations that allow no curve.

/// The result of observations that allow no curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FragilityBound {
    /// No motion reached the state. A bound holds for its probability at one intensity.
    NoneReached {
        /// The intensity, up to which most motions went.
        intensity: f64,
        /// Number of motions that went up to it.
        motions: usize,
        /// Upper bound of the probability at this intensity, with 95 % confidence.
        probability_most: f64,
    },
    /// Every motion reached the state, at every intensity.
    AllReached {
        /// The smallest intensity.
        intensity: f64,
        /// Number of motions at this intensity.
        motions: usize,
        /// Lower bound of the probability at this intensity, with 95 % confidence.
        probability_least: f64,
    },
    /// The intensity alone separates survivors from failures: the data cannot show how steep the curve is, only the interval where
    /// it begins.
    Separated {
        /// The largest intensity at which a motion was survived.
        survived: f64,
        /// The smallest intensity at which the state was reached.
        reached: f64,
    },
    /// The likelihood has no maximum, because the brackets overlap too much or there are too few other data. Only an interval of the
    /// median capacity is known.
    Middle {
        /// At least half of the capacities are above this; 0 if unknown.
        above: f64,
        /// At least half of the capacities are at or below this; infinite if unknown.
        at_most: f64,
    },
}

/// 1 − 0.95: complement of the confidence level of a bound.
pub(super) const LEFT_OUT: f64 = 0.05;

impl FragilityBound {
    /// The bound if the observations come from only `different` different motions.
    pub(super) fn of_motions(self, different: usize) -> Self {
        let tail = |motions: usize| LEFT_OUT.powf(1.0 / motions as f64);
        match self {
            FragilityBound::NoneReached {
                intensity, motions, ..
            } if different < motions => FragilityBound::NoneReached {
                intensity,
                motions: different,
                probability_most: 1.0 - tail(different),
            },
            FragilityBound::AllReached {
                intensity, motions, ..
            } if different < motions => FragilityBound::AllReached {
                intensity,
                motions: different,
                probability_least: tail(different),
            },
            other => other,
        }
    }
}
