//! Why modes are kept out of a fit.

/// Share of a mode's squared components that must lie along the direction for the mode to be one of it. Our choice: a
/// mode at 45° has .5 in both.
pub(super) const SHARE_LEAST: f64 = 0.6;

/// Why a mode was kept out of the fit.
#[derive(Clone, Debug, PartialEq)]
pub enum LeftOut {
    /// It moves mostly in another direction.
    OtherDirection {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Share of its squared components along the direction.
        share: f64,
    },
    /// Sensors at one height move differently: the plan twists, or the structure is not rigid there.
    Twists {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Height at which they differ most, m.
        height_m: f64,
        /// Difference as a share of the shape's largest component along the direction.
        difference: f64,
    },
    /// Setups may not show one mode there, so that no mode from there on can be counted.
    Doubtful {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Modes above it, left out with it.
        above: usize,
    },
}

impl LeftOut {
    /// Share of a mode's squared components that must lie along the direction.
    pub const SHARE_LEAST: f64 = SHARE_LEAST;
}

impl std::fmt::Display for LeftOut {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            LeftOut::OtherDirection { frequency_hz, share } => write!(
                f,
                "The mode at {frequency_hz:.3} Hz is left out: only {:.0} % of its motion is in this direction, {:.0} % \
                 are needed.",
                100.0 * share,
                100.0 * SHARE_LEAST
            ),
            LeftOut::Twists {
                frequency_hz,
                height_m,
                difference,
            } => write!(
                f,
                "The mode at {frequency_hz:.3} Hz is left out: at {height_m:.2} m its sensors differ by {:.0} % of the \
                 largest, so it twists.",
                100.0 * difference
            ),
            LeftOut::Doubtful { frequency_hz, above } => write!(
                f,
                "The mode at {frequency_hz:.3} Hz is left out: the setups may not show one mode there. {above} above it are left out too, \
                 since a fit counts modes from the lowest."
            ),
        }
    }
}
