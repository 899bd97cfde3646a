//! Dampers attached to a structure. The row of a damper is the combination of degrees of freedom along which it acts.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | z₀ | row · x | motion of the damper's place, in the direction of the damper |
//! | z, w | degrees of freedom of the damper | motion of the mass; of the liquid in its column |
//! | k_o, c_o, m_o | `spring`, `dashpot`, `mass` | of a tuned mass |
//! | α | `length_ratio` | horizontal over total length of a liquid column |
//! | K(ω) | `stiffness` | force on the structure per z₀, eq. 7 of Hwang, Min & Hong |

use super::DamperError;
use dolmen_linalg::Complex64;
use std::f64::consts::TAU;

/// The type of a damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum DamperKind {
    /// A mass on a spring and a dashpot.
    TunedMass {
        /// m, kg.
        mass_kg: f64,
        /// Frequency √(k/m)/2π of the damper alone, Hz.
        frequency_hz: f64,
        /// Damping ratio c/(2 m ω), with ω of the damper alone.
        damping_ratio: f64,
    },
    /// Liquid in a U-shaped tube of constant cross-section, with a linearised head loss.
    LiquidColumn {
        /// Mass of the whole liquid, kg.
        liquid_mass_kg: f64,
        /// α, horizontal length of the column over its total length; in (0, 1].
        length_ratio: f64,
        /// Frequency √(2g/L)/2π of the liquid alone, Hz.
        frequency_hz: f64,
        /// ζ of ẅ + 2ζω ẇ + ω² w = −α z̈₀.
        damping_ratio: f64,
    },
    /// A liquid column as above, mounted on a spring and a dashpot.
    LiquidColumnMass {
        /// Mass of the container without the liquid, kg.
        container_mass_kg: f64,
        /// Mass of the whole liquid, kg.
        liquid_mass_kg: f64,
        /// α of the column; in (0, 1].
        length_ratio: f64,
        /// Frequency √(k/(m_c + m_l))/2π of the container with the liquid at rest in it, Hz.
        frequency_hz: f64,
        /// Damping ratio c/(2 (m_c + m_l) ω) of the container.
        damping_ratio: f64,
        /// Frequency of the liquid alone, Hz.
        liquid_frequency_hz: f64,
        /// Damping ratio of the liquid.
        liquid_damping_ratio: f64,
    },
    /// A dashpot between two places of the structure, or between a place and the ground: its row is the difference of the two rows.
    Viscous {
        /// Force per velocity, N s/m.
        coefficient_n_s_m: f64,
    },
}

/// A damper and the row along which it acts.
#[derive(Clone, Debug, PartialEq)]
pub struct AttachedDamper {
    /// Type and properties.
    pub kind: DamperKind,
    /// Row with z₀ = row · x; one value for each degree of freedom of the structure.
    pub row: Vec<f64>,
}

impl AttachedDamper {
    /// One mass that moves freely along two rows, on two equal springs and dashpots.
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
    /// Total mass, kg.
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

    /// Number of degrees of freedom of the damper itself.
    pub fn degrees_of_freedom(&self) -> usize {
        match self {
            DamperKind::TunedMass { .. } | DamperKind::LiquidColumn { .. } => 1,
            DamperKind::LiquidColumnMass { .. } => 2,
            DamperKind::Viscous { .. } => 0,
        }
    }

    /// Apparent mass K(ω)/ω², kg, that the damper adds at its place. A dashpot has none: see [`DamperKind::stiffness`].
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

    /// Dynamic stiffness K(ω), N/m: force on the structure per unit displacement of the damper's place.
    pub fn stiffness(&self, angular_frequency_rad_s: f64) -> Complex64 {
        let w = angular_frequency_rad_s;
        match *self {
            DamperKind::Viscous { coefficient_n_s_m } => Complex64::new(0.0, -w * coefficient_n_s_m),
            _ => w * w * self.apparent_mass(w),
        }
    }

    /// Stroke per absolute acceleration of the damper's place, with reversed sign, s²: z − z₀ of a mass, w of a liquid column; 0 for a dashpot,
    /// which moves with its ends.
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

    /// Frequencies of the damper alone, Hz: of the mass, then of the liquid. A dashpot has none.
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
