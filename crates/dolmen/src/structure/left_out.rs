//! Reasons to leave modes out of a fit.

/// Least share of a mode's squared components along a direction for the mode to belong to it. Our choice: a mode at
/// 45° has 0.5 in both.
pub(super) const SHARE_LEAST: f64 = 0.6;

/// Reason to leave a mode out of the fit.
#[derive(Clone, Debug, PartialEq)]
pub enum LeftOut {
    /// The mode moves mostly in another direction.
    OtherDirection {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Share of the squared components along the direction.
        share: f64,
    },
    /// Sensors at one height move differently: the structure twists, or is not rigid there.
    Twists {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Height at which they differ most, m.
        height_m: f64,
        /// Difference as a share of the shape's largest component along the direction.
        difference: f64,
    },
    /// The setups may lack a mode here, so the order of this mode and of all modes above it is unknown.
    Doubtful {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Number of modes above it, which are left out too.
        above: usize,
    },
    /// Its motion is a turn about the vertical axis through the origin, and without it the direction has as many modes as the model.
    Turns {
        /// Its frequency, Hz.
        frequency_hz: f64,
    },
    /// The model has fewer modes in the direction.
    Beyond {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Number of modes of the model.
        modes: usize,
    },
}

impl LeftOut {
    /// Least share of a mode's squared components along a direction for the mode to belong to it.
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
            LeftOut::Turns { frequency_hz } => write!(
                f,
                "The mode at {frequency_hz:.3} Hz is left out: its motion is a turn about the vertical axis through the origin, which is torsion."
            ),
            LeftOut::Beyond { frequency_hz, modes } => write!(
                f,
                "The mode at {frequency_hz:.3} Hz is left out: the model has {modes} modes in this direction."
            ),
        }
    }
}
