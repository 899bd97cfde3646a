//! Why a peak of the spectrum is not accepted as a mode.

/// The test that refused a peak, with the value found and the limit.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// No model order has a pole at the peak.
    NoPole,
    /// The poles are outside the frequency range of the analysis.
    OutOfRange {
        /// Lowest frequency, Hz.
        low_hz: f64,
        /// Highest frequency, Hz.
        high_hz: f64,
    },
    /// The damping ratio of the poles is too small or too large.
    Damping {
        /// Median damping ratio of the poles.
        damping_ratio: f64,
        /// Least allowed damping ratio.
        least: f64,
        /// Largest allowed damping ratio.
        most: f64,
    },
    /// The shapes of the poles are too complex.
    Complex {
        /// Median modal phase collinearity of the poles.
        phase_collinearity: f64,
        /// Least allowed collinearity.
        least: f64,
    },
    /// The standard deviation of the frequency is too large for the length of the record.
    Scattered {
        /// Standard deviation divided by its lower bound.
        over_floor: f64,
        /// Largest allowed ratio.
        most: f64,
    },
    /// Too few model orders have the pole.
    FewOrders {
        /// Number of orders with the pole.
        orders: usize,
        /// Required number.
        wanted: usize,
    },
    /// The peak is part of another mode, which the model splits in two.
    SplitsOff,
    /// The peak merges several modes: its damping ratio is far above the others.
    Blend {
        /// Damping ratio.
        damping_ratio: f64,
    },
    /// A machine causes the peak.
    Machine,
    /// The peak is narrower, or its amplitude steadier, than that of a mode with this damping ratio.
    Narrow {
        /// Least damping ratio of a mode.
        least: f64,
    },
    /// The peak disappears while the structure is quiet.
    InSpells,
    /// The clipping of a channel creates the mode.
    Clipping,
}

/// A mode that the user requested although no test found it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accepted {
    /// The frequency that the user requested, Hz.
    pub asked_hz: f64,
    /// The test that refused the peak; `None` if the method takes the peaks themselves as modes.
    pub refusal: Option<Refusal>,
}

/// A peak of the first singular value that is not a mode, and the reason.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefusedPeak {
    /// Frequency of the peak, Hz.
    pub frequency_hz: f64,
    /// The test that refused the peak; `None` if the method takes the peaks themselves as modes.
    pub refusal: Option<Refusal>,
}

impl std::fmt::Display for RefusedPeak {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3} Hz", self.frequency_hz)?;
        match self.refusal {
            None => Ok(()),
            Some(Refusal::NoPole) => write!(f, " (no model has a pole there)"),
            Some(Refusal::OutOfRange { low_hz, high_hz }) => {
                write!(f, " (outside of the range, {low_hz:.3} to {high_hz:.3} Hz)")
            }
            Some(Refusal::Damping {
                damping_ratio,
                least,
                most,
            }) => write!(
                f,
                " (damping ratio {:.3} %, allowed {:.3} to {:.0} %)",
                100.0 * damping_ratio,
                100.0 * least,
                100.0 * most
            ),
            Some(Refusal::Complex {
                phase_collinearity,
                least,
            }) => {
                write!(
                    f,
                    " (phase collinearity {phase_collinearity:.2}, at least {least:.2})"
                )
            }
            Some(Refusal::Scattered { over_floor, most }) => write!(
                f,
                " (standard deviation {over_floor:.1} times its floor, at most {most:.1})"
            ),
            Some(Refusal::FewOrders { orders, wanted }) => {
                write!(f, " ({orders} model orders show it, at least {wanted})")
            }
            Some(Refusal::SplitsOff) => write!(f, " (part of another mode)"),
            Some(Refusal::Blend { damping_ratio }) => {
                write!(
                    f,
                    " (several modes in one, damping ratio {:.1} %)",
                    100.0 * damping_ratio
                )
            }
            Some(Refusal::Machine) => write!(f, " (a machine)"),
            Some(Refusal::Narrow { least }) => write!(
                f,
                " (narrower or steadier than a mode with a damping ratio of {:.3} %)",
                100.0 * least
            ),
            Some(Refusal::Clipping) => write!(f, " (the clipping of a channel makes it)"),
            Some(Refusal::InSpells) => write!(f, " (nothing stands there while the structure is quiet)"),
        }
    }
}
