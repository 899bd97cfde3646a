//! What refuses a peak of the spectrum that is no mode.

/// The test that refused a peak, with what was found and what was wanted.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Refusal {
    /// No model of any order has a pole there.
    NoPole,
    /// The poles lie outside of the range looked at, Hz.
    OutOfRange {
        /// Lowest frequency, Hz.
        low_hz: f64,
        /// Highest frequency, Hz.
        high_hz: f64,
    },
    /// The poles are damped too little or too much.
    Damping {
        /// Damping ratio in the middle of them.
        damping_ratio: f64,
        /// Least allowed.
        least: f64,
        /// Most allowed.
        most: f64,
    },
    /// Their shapes are not real enough.
    Complex {
        /// Modal phase collinearity in the middle of them.
        phase_collinearity: f64,
        /// Least allowed.
        least: f64,
    },
    /// Their frequencies are known too badly for so long a record.
    Scattered {
        /// Standard deviation over its floor.
        over_floor: f64,
        /// Most allowed.
        most: f64,
    },
    /// Too few model orders show it.
    FewOrders {
        /// That do.
        orders: usize,
        /// Wanted.
        wanted: usize,
    },
    /// It is another mode's, split in two.
    SplitsOff,
    /// Several modes in one, damped far above the others.
    Blend {
        /// Damping ratio.
        damping_ratio: f64,
    },
    /// A machine makes it.
    Machine,
    /// Narrower, or steadier, than a mode of this damping ratio.
    Narrow {
        /// The least damping ratio of a mode.
        least: f64,
    },
    /// Nothing stands there while the structure is quiet.
    InSpells,
}

/// Why a mode is one that no test found.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Accepted {
    /// The frequency that the user insists on, Hz.
    pub asked_hz: f64,
    /// The test that refused what stands there; `None` where the modes are the peaks themselves.
    pub refusal: Option<Refusal>,
}

/// A peak of the first singular value that is no mode, and why.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct RefusedPeak {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// What refused it; `None` where the modes are the peaks themselves.
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
            Some(Refusal::InSpells) => write!(f, " (nothing stands there while the structure is quiet)"),
        }
    }
}
