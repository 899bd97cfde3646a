/// Why the pressure of a wind is unknown. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WindError {
    /// A quantity that must be positive and finite is not.
    #[error("{quantity} is {given}, but must be a positive number")]
    NotPositive {
        /// Name of the quantity with its unit.
        quantity: &'static str,
        /// The value given.
        given: f64,
    },
    /// The code's profile of the mean wind ends below the top of the body.
    #[error("the top is at {given} m, but the profile of the code holds up to {most_m} m")]
    Height {
        /// Height of the top, m.
        given: f64,
        /// End of the profile, m.
        most_m: f64,
    },
    /// The code asks whether the wind makes the body vibrate, but the natural frequency is unknown.
    #[error(
        "the code asks for the lowest natural frequency, which is not known: the stiffness of the joints is not given"
    )]
    FrequencyUnknown,
    /// Resonance matters, but the damping is unknown.
    #[error(
        "the lowest natural frequency is {frequency_hz:.3} Hz, so that resonance counts, and the damping ratio is not given"
    )]
    DampingUnknown {
        /// Lowest natural frequency, Hz.
        frequency_hz: f64,
    },
    /// Turbulence is defined for a mean wind, but the wind is given as a gust or a pressure.
    #[error(
        "the wind is a gust or a pressure, but its turbulence goes with the mean of ten minutes by a code"
    )]
    NotAMean,
}

/// Refuses a value that is not a positive, finite number.
pub(super) fn positive(quantity: &'static str, given: f64) -> Result<(), WindError> {
    match given > 0.0 && given.is_finite() {
        true => Ok(()),
        false => Err(WindError::NotPositive { quantity, given }),
    }
}
