//! A damper of a building with every derived number.

use dolmen::damper::{AttachedDamper, DamperKind, TuningRule};
use dolmen::dynamics::TunedMass;
use dolmen::structure::building::PlanDirection;

/// The tuning of a damper.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TunedTo {
    /// The mode that it damps, from 1.
    pub mode: usize,
    /// Its mass over the modal mass of the mode.
    pub mass_ratio: f64,
}

/// A damper with every derived number.
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltDamper {
    /// Its name in the file; with a number where it has several masses.
    pub name: String,
    /// The floor, from 1.
    pub floor: usize,
    /// Place in plan, m.
    pub place_m: [f64; 2],
    /// Direction in which it moves.
    pub direction: PlanDirection,
    /// Its kind.
    pub kind: DamperKind,
    /// The motion of its base: a row over all coordinates of the building.
    pub row: Vec<f64>,
    /// Its tuning; `None` for a link.
    pub tuned_to: Option<TunedTo>,
    /// Closed form that gave both frequency and damping; `None` if the file gives one of them.
    pub tuning: Option<TuningRule>,
    /// Room each way, m, if given.
    pub room_m: Option<f64>,
    /// Available stroke of the liquid of a column on a spring, each way, m, if given.
    pub liquid_room_m: Option<f64>,
    /// Floor (0: the ground) and place of the other end of a link, m.
    pub to: Option<(usize, [f64; 2])>,
}

impl BuiltDamper {
    /// Its word in the file.
    pub fn word(&self) -> &'static str {
        match self.kind {
            DamperKind::TunedMass { .. } => "tmd",
            DamperKind::LiquidColumn { .. } => "tlcd",
            DamperKind::LiquidColumnMass { .. } => "tlcmd",
            DamperKind::Viscous { .. } => "link",
        }
    }

    /// Frequency, Hz, and damping ratio; `None` for a link.
    pub fn own(&self) -> Option<[f64; 2]> {
        match self.kind {
            DamperKind::TunedMass {
                frequency_hz,
                damping_ratio,
                ..
            }
            | DamperKind::LiquidColumn {
                frequency_hz,
                damping_ratio,
                ..
            }
            | DamperKind::LiquidColumnMass {
                frequency_hz,
                damping_ratio,
                ..
            } => Some([frequency_hz, damping_ratio]),
            DamperKind::Viscous { .. } => None,
        }
    }

    /// Coefficient of its dashpot, N s/m: 2 ζ m ω of a mass or a container on a spring; `None` for a liquid column, which has none.
    pub fn dashpot_n_s_m(&self) -> Option<f64> {
        match self.kind {
            DamperKind::TunedMass {
                frequency_hz,
                damping_ratio,
                ..
            }
            | DamperKind::LiquidColumnMass {
                frequency_hz,
                damping_ratio,
                ..
            } => Some(2.0 * damping_ratio * self.kind.mass_kg() * std::f64::consts::TAU * frequency_hz),
            DamperKind::Viscous { coefficient_n_s_m } => Some(coefficient_n_s_m),
            DamperKind::LiquidColumn { .. } => None,
        }
    }

    /// As a damper of the library.
    pub fn attached(&self) -> AttachedDamper {
        AttachedDamper {
            kind: self.kind,
            row: self.row.clone(),
        }
    }

    /// As a mass on a spring and a dashpot, if it is one.
    pub fn tuned_mass(&self) -> Option<TunedMass> {
        let DamperKind::TunedMass {
            mass_kg,
            frequency_hz,
            damping_ratio,
        } = self.kind
        else {
            return None;
        };
        Some(TunedMass {
            floor: self.floor,
            x_m: self.place_m[0],
            y_m: self.place_m[1],
            direction: self.direction,
            mass_kg,
            frequency_hz,
            damping_ratio,
        })
    }

    /// Whether any of its damping ratios is above 1.
    pub fn is_overdamped(&self) -> bool {
        let liquid = match self.kind {
            DamperKind::LiquidColumnMass {
                liquid_damping_ratio, ..
            } => liquid_damping_ratio,
            _ => 0.0,
        };
        self.own().is_some_and(|[_, ratio]| ratio.max(liquid) > 1.0)
    }

    /// Whether it has a stroke of liquid besides its own: a column on a spring.
    pub fn has_liquid_apart(&self) -> bool {
        matches!(self.kind, DamperKind::LiquidColumnMass { .. })
    }
}

/// A moving part of a damper.
#[derive(Clone, Debug, PartialEq)]
pub struct Stroke {
    /// The damper, or "NAME liquid" for the liquid of a column on a spring.
    pub name: String,
    /// Room each way, m, if given.
    pub room_m: Option<f64>,
}

/// All strokes of dampers in the order of their values: the dampers, then the liquids of columns on springs.
pub fn strokes_of(dampers: &[BuiltDamper]) -> Vec<Stroke> {
    let own = dampers.iter().map(|damper| Stroke {
        name: damper.name.clone(),
        room_m: damper.room_m,
    });
    let apart = dampers.iter().filter(|damper| damper.has_liquid_apart());
    let liquids = apart.map(|damper| Stroke {
        name: format!("{} liquid", damper.name),
        room_m: damper.liquid_room_m,
    });
    own.chain(liquids).collect()
}
