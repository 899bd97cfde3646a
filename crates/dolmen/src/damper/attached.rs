//! Dampers on a structure, each on one row: the combination of degrees of freedom that it rides on.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | z₀ | row · x | motion of the place where the damper stands, along it |
//! | z, w | own degrees of freedom | motion of the mass; of the liquid in its column |
//! | k_o, c_o, m_o | `spring`, `dashpot`, `mass` | of a tuned mass |
//! | α | `length_ratio` | horizontal over total length of a liquid column |
//! | K(ω) | `stiffness` | force on the structure per z₀, eq. 7 of Hwang, Min & Hong |

use super::DamperError;
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// What stands there.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DamperKind {
    /// A mass on a spring and a dashpot.
    TunedMass {
        /// m, kg.
        mass_kg: f64,
        /// Own frequency √(k/m)/2π, Hz.
        frequency_hz: f64,
        /// c / (2 m ω) with its own ω.
        damping_ratio: f64,
    },
    /// Liquid in a U-shaped tube of one section, its head loss taken as linear.
    LiquidColumn {
        /// All of the liquid, kg.
        liquid_mass_kg: f64,
        /// α, horizontal length of the column over its total length; in (0, 1].
        length_ratio: f64,
        /// Own frequency √(2g/L)/2π, Hz.
        frequency_hz: f64,
        /// ζ of ẅ + 2ζω ẇ + ω² w = −α z̈₀.
        damping_ratio: f64,
    },
    /// The same tube, itself on a spring and a dashpot.
    LiquidColumnMass {
        /// The container without the liquid, kg.
        container_mass_kg: f64,
        /// All of the liquid, kg.
        liquid_mass_kg: f64,
        /// α of the column; in (0, 1].
        length_ratio: f64,
        /// √(k/(m_c + m_l))/2π of the container with the liquid at rest in it, Hz.
        frequency_hz: f64,
        /// c / (2 (m_c + m_l) ω) of the container.
        damping_ratio: f64,
        /// Own frequency of the liquid, Hz.
        liquid_frequency_hz: f64,
        /// Damping ratio of the liquid.
        liquid_damping_ratio: f64,
    },
    /// A dashpot between two places of the structure, or one and the ground: its row is the difference of their rows.
    Viscous {
        /// Force per velocity, N s/m.
        coefficient_n_s_m: f64,
    },
}

/// A damper and what it rides on.
#[derive(Clone, Debug, PartialEq)]
pub struct AttachedDamper {
    /// What it is.
    pub kind: DamperKind,
    /// z₀ = row · x, one value a degree of freedom of the structure.
    pub row: Vec<f64>,
}

impl AttachedDamper {
    /// One mass free to move along two rows: two springs and dashpots alike.
    pub fn two_directions(kind: DamperKind, rows: [Vec<f64>; 2]) -> [AttachedDamper; 2] {
        rows.map(|row| AttachedDamper { kind, row })
    }

    /// A dashpot from one place to another.
    pub fn link(coefficient_n_s_m: f64, from: &[f64], to: &[f64]) -> AttachedDamper {
        AttachedDamper {
            kind: DamperKind::Viscous { coefficient_n_s_m },
            row: from.iter().zip(to).map(|(a, b)| a - b).collect(),
        }
    }
}

impl DamperKind {
    /// All of its mass, kg.
    pub fn mass_kg(&self) -> f64 {
        match *self {
            DamperKind::TunedMass { mass_kg, .. } => mass_kg,
            DamperKind::LiquidColumn { liquid_mass_kg, .. } => liquid_mass_kg,
            DamperKind::LiquidColumnMass {
                container_mass_kg,
                liquid_mass_kg,
                ..
            } => container_mass_kg + liquid_mass_kg,
            DamperKind::Viscous { .. } => 0.0,
        }
    }

    /// Degrees of freedom of its own.
    pub fn degrees_of_freedom(&self) -> usize {
        match self {
            DamperKind::TunedMass { .. } | DamperKind::LiquidColumn { .. } => 1,
            DamperKind::LiquidColumnMass { .. } => 2,
            DamperKind::Viscous { .. } => 0,
        }
    }

    /// K(ω) / ω², kg: the mass that the place seems to carry; of a dashpot, which has none, see [`DamperKind::stiffness`].
    ///
    /// ```text
    /// tuned mass            (k_o + iωc_o) m_o / (k_o + iωc_o − ω² m_o)
    /// liquid column         m (1 + α² ω² / (ω_d² − ω² + 2iζω_d ω))
    /// liquid column mass    the first, with m_c + m_l (1 + …) of the second for m_o
    /// ```
    pub fn apparent_mass(&self, angular_frequency_rad_s: f64) -> Complex64 {
        let w = angular_frequency_rad_s;
        let link = |own: f64, zeta: f64| Complex64::new(own * own, 2.0 * zeta * own * w);
        let liquid = |mass: f64, alpha: f64, hz: f64, zeta: f64| {
            mass * (1.0 + alpha * alpha * w * w / (link(TAU * hz, zeta) - w * w))
        };
        match *self {
            DamperKind::TunedMass {
                mass_kg,
                frequency_hz,
                damping_ratio,
            } => {
                let link = link(TAU * frequency_hz, damping_ratio);
                mass_kg * link / (link - w * w)
            }
            DamperKind::LiquidColumn {
                liquid_mass_kg,
                length_ratio,
                frequency_hz,
                damping_ratio,
            } => liquid(liquid_mass_kg, length_ratio, frequency_hz, damping_ratio),
            DamperKind::LiquidColumnMass {
                container_mass_kg,
                liquid_mass_kg,
                length_ratio,
                frequency_hz,
                damping_ratio,
                liquid_frequency_hz,
                liquid_damping_ratio,
            } => {
                let link = self.mass_kg() * link(TAU * frequency_hz, damping_ratio);
                let column = liquid(
                    liquid_mass_kg,
                    length_ratio,
                    liquid_frequency_hz,
                    liquid_damping_ratio,
                );
                let carried = container_mass_kg + column;
                link * carried / (link - w * w * carried)
            }
            DamperKind::Viscous { .. } => Complex64::ZERO,
        }
    }

    /// K(ω), N/m: force on the structure per motion of the place.
    pub fn stiffness(&self, angular_frequency_rad_s: f64) -> Complex64 {
        let w = angular_frequency_rad_s;
        match *self {
            DamperKind::Viscous { coefficient_n_s_m } => Complex64::new(0.0, -w * coefficient_n_s_m),
            _ => w * w * self.apparent_mass(w),
        }
    }

    /// What the damper moves from its place, over the absolute acceleration of the place with its sign turned: z − z₀ of a mass, w of a
    /// liquid column, s²; 0 of a dashpot, which moves as its ends do.
    ///
    /// ```text
    /// tuned mass            1 / (ω_d² − ω² + 2iζω_d ω)
    /// liquid column         α / (ω_d² − ω² + 2iζω_d ω)
    /// liquid column mass    m_a / ((m_c + m_l)(ω_d² + 2iζω_d ω))
    /// ```
    pub(super) fn stroke_per_acceleration(&self, w: f64) -> Complex64 {
        let link = |hz: f64, zeta: f64| {
            let own = TAU * hz;
            Complex64::new(own * own, 2.0 * zeta * own * w)
        };
        match *self {
            DamperKind::TunedMass {
                frequency_hz,
                damping_ratio,
                ..
            } => 1.0 / (link(frequency_hz, damping_ratio) - w * w),
            DamperKind::LiquidColumn {
                length_ratio,
                frequency_hz,
                damping_ratio,
                ..
            } => length_ratio / (link(frequency_hz, damping_ratio) - w * w),
            DamperKind::LiquidColumnMass {
                frequency_hz,
                damping_ratio,
                ..
            } => self.apparent_mass(w) / (self.mass_kg() * link(frequency_hz, damping_ratio)),
            DamperKind::Viscous { .. } => Complex64::ZERO,
        }
    }

    /// Own frequencies, Hz: of the mass, then of the liquid; none of a dashpot.
    pub(super) fn own_frequencies_hz(&self) -> Vec<f64> {
        match *self {
            DamperKind::LiquidColumnMass {
                frequency_hz,
                liquid_frequency_hz,
                ..
            } => vec![frequency_hz, liquid_frequency_hz],
            DamperKind::TunedMass { frequency_hz, .. } | DamperKind::LiquidColumn { frequency_hz, .. } => {
                vec![frequency_hz]
            }
            DamperKind::Viscous { .. } => Vec::new(),
        }
    }

    pub(super) fn check(&self) -> Result<(), DamperError> {
        let positive = |argument, given: f64| in_range(argument, given, given > 0.0, "positive");
        let ratio = |argument, given: f64| in_range(argument, given, given >= 0.0, "0 or more");
        let part = |argument, given: f64| in_range(argument, given, given > 0.0 && given <= 1.0, "in (0, 1]");
        match *self {
            DamperKind::TunedMass {
                mass_kg,
                frequency_hz,
                damping_ratio,
            } => {
                positive("mass_kg", mass_kg)?;
                positive("frequency_hz", frequency_hz)?;
                ratio("damping_ratio", damping_ratio)
            }
            DamperKind::LiquidColumn {
                liquid_mass_kg,
                length_ratio,
                frequency_hz,
                damping_ratio,
            } => {
                positive("liquid_mass_kg", liquid_mass_kg)?;
                part("length_ratio", length_ratio)?;
                positive("frequency_hz", frequency_hz)?;
                ratio("damping_ratio", damping_ratio)
            }
            DamperKind::LiquidColumnMass {
                container_mass_kg,
                liquid_mass_kg,
                length_ratio,
                frequency_hz,
                damping_ratio,
                liquid_frequency_hz,
                liquid_damping_ratio,
            } => {
                positive("container_mass_kg", container_mass_kg)?;
                positive("liquid_mass_kg", liquid_mass_kg)?;
                part("length_ratio", length_ratio)?;
                positive("frequency_hz", frequency_hz)?;
                ratio("damping_ratio", damping_ratio)?;
                positive("liquid_frequency_hz", liquid_frequency_hz)?;
                ratio("liquid_damping_ratio", liquid_damping_ratio)
            }
            DamperKind::Viscous { coefficient_n_s_m } => ratio("coefficient_n_s_m", coefficient_n_s_m),
        }
    }
}

fn in_range(
    argument: &'static str,
    given: f64,
    fits: bool,
    allowed: &'static str,
) -> Result<(), DamperError> {
    if fits && given.is_finite() {
        return Ok(());
    }
    Err(DamperError::Argument {
        argument,
        given,
        allowed,
    })
}
