//! Bounds of a capacity where no curve can be fitted.

/// The result of observations that allow no curve.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FragilityBound {
    /// No motion reached the state. At the intensity that the most reached up to, its probability is below a bound.
    NoneReached {
        /// The intensity.
        intensity: f64,
        /// Motions that went up to it.
        motions: usize,
        /// With 95 % confidence the probability there is at most this.
        probability_most: f64,
    },
    /// Every motion reached it, at every intensity.
    AllReached {
        /// The least intensity.
        intensity: f64,
        /// Motions at it.
        motions: usize,
        /// With 95 % confidence the probability there is at least this.
        probability_least: f64,
    },
    /// The intensity alone tells survivors from others: the curve is steeper than they can tell, and begins between these two.
    Separated {
        /// The largest intensity that some survived.
        survived: f64,
        /// The least at which some reached the state.
        reached: f64,
    },
    /// The likelihood has no maximum, because brackets overlap too widely or there is too little other data: only an interval of the
    /// median capacity.
    Middle {
        /// Half of the capacities at least lie above; 0 if that is known of none.
        above: f64,
        /// Half of them at least lie at or below; infinite if that is unknown.
        at_most: f64,
    },
}

/// 1 − 0.95: complement of the confidence level of a bound.
pub(super) const LEFT_OUT: f64 = 0.05;

impl FragilityBound {
    /// The bound if only `different` of the observations are of different motions.
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
