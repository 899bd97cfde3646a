//! Tuned mass dampers of a building in a project file, every number worked out.

use super::quantity::{Pick, Quantity};
use dolmen::dynamics::TunedMass;
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingError, BuildingModes, PlanDirection};

/// The mass of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperMass {
    /// kg.
    Mass(Quantity),
    /// Over the modal mass of its mode.
    Ratio(Quantity),
}

/// A closed form of tuning.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tuning {
    /// Den Hartog (1934): f = 1/(1 + μ), ζ = √(3μ/(8(1 + μ))).
    DenHartog,
    /// Warburton (1982), white force: f = √(1 + μ/2)/(1 + μ), ζ = √(μ(1 + 3μ/4)/(4(1 + μ)(1 + μ/2))).
    WarburtonForce,
    /// Warburton (1982), white base acceleration: f = √(1 − μ/2)/(1 + μ), ζ = √(μ(1 − μ/4)/(4(1 + μ)(1 − μ/2))).
    WarburtonBase,
}

impl Tuning {
    /// Frequency over that of the structure, and damping ratio on the damper's own frequency.
    pub fn of(self, mass_ratio: f64) -> [f64; 2] {
        let mu = mass_ratio;
        match self {
            Tuning::DenHartog => [1.0 / (1.0 + mu), (3.0 * mu / (8.0 * (1.0 + mu))).sqrt()],
            Tuning::WarburtonForce => [
                (1.0 + 0.5 * mu).sqrt() / (1.0 + mu),
                (mu * (1.0 + 0.75 * mu) / (4.0 * (1.0 + mu) * (1.0 + 0.5 * mu))).sqrt(),
            ],
            Tuning::WarburtonBase => [
                (1.0 - 0.5 * mu).sqrt() / (1.0 + mu),
                (mu * (1.0 - 0.25 * mu) / (4.0 * (1.0 + mu) * (1.0 - 0.5 * mu))).sqrt(),
            ],
        }
    }

    /// The word in the file.
    pub fn word(self) -> &'static str {
        match self {
            Tuning::DenHartog => "den_hartog",
            Tuning::WarburtonForce => "warburton_force",
            Tuning::WarburtonBase => "warburton_base",
        }
    }
}

/// The frequency of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperFrequency {
    /// Hz.
    Frequency(Quantity),
    /// Over that of its mode.
    Ratio(Quantity),
    /// By the tuning.
    Tuned,
}

/// A tuned mass damper as the file gives it.
#[derive(Clone, Debug, PartialEq)]
pub struct DamperPart {
    /// The table's name.
    pub name: String,
    /// Floor, from 1.
    pub floor: usize,
    /// Place, m.
    pub place: Box<[Quantity; 2]>,
    /// Direction.
    pub direction: PlanDirection,
    /// Mass.
    pub mass: DamperMass,
    /// The mode that it is for, from 1.
    pub mode: usize,
    /// Frequency.
    pub frequency: DamperFrequency,
    /// Damping ratio; `None`: by the tuning.
    pub damping_ratio: Option<Quantity>,
    /// Closed form, if named.
    pub tuning: Option<Tuning>,
}

/// Why a damper cannot be.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum DamperFault {
    /// Its mode does not move there.
    #[error(
        "damper.{name}: mode {mode} does not move at its place along its direction ({why}): no mass ratio can be taken of it; place or \
         turn the damper, or name another mode"
    )]
    Still {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// What the mode does there.
        why: String,
    },
    /// There is no such mode.
    #[error("damper.{name}: mode = {mode}, but the building has {most} modes")]
    Mode {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// How many there are.
        most: usize,
    },
    /// It weighs more than what it damps.
    #[error(
        "damper.{name}: its mass ratio is {mass_ratio:.4}, more than 1: it would be heavier than the modal mass of mode {mode}, which is \
         {modal_mass_kg:.0} kg at its place; is the unit of its mass right?"
    )]
    Heavy {
        /// The damper.
        name: String,
        /// Its mass ratio.
        mass_ratio: f64,
        /// Its mode.
        mode: usize,
        /// Modal mass there, kg.
        modal_mass_kg: f64,
    },
    /// The building refuses it.
    #[error("damper.{name}: {why}")]
    Place {
        /// The damper.
        name: String,
        /// Why.
        why: BuildingError,
    },
}

/// A damper with every number that follows.
#[derive(Clone, Debug, PartialEq)]
pub struct BuiltDamper {
    /// Its name in the file.
    pub name: String,
    /// The mode that it is for, from 1.
    pub mode: usize,
    /// Its mass over the modal mass of the mode.
    pub mass_ratio: f64,
    /// Closed form, if named.
    pub tuning: Option<Tuning>,
    /// The damper.
    pub tuned: TunedMass,
}

impl DamperPart {
    pub(super) fn build(
        &self,
        building: &Building,
        modes: &BuildingModes,
        pick: Pick<'_>,
    ) -> Result<BuiltDamper, DamperFault> {
        /// A mode that moves less than this part of its largest is still there. Our choice.
        const STILL: f64 = 1e-6;
        let name = self.name.clone();
        let (x_m, y_m) = (pick(&self.place[0]), pick(&self.place[1]));
        let row = building
            .point_row(self.floor, x_m, y_m, self.direction)
            .map_err(|why| DamperFault::Place {
                name: name.clone(),
                why,
            })?;
        let Some(mode) = self.mode.checked_sub(1).and_then(|j| modes.modes.get(j)) else {
            return Err(DamperFault::Mode {
                name,
                mode: self.mode,
                most: modes.modes.len(),
            });
        };
        let along: f64 = row.iter().zip(&mode.shape).map(|(r, phi)| r * phi).sum();
        let base = 3 * (self.floor - 1);
        let moves = |direction| {
            let row = building
                .point_row(self.floor, x_m, y_m, direction)
                .unwrap_or_default();
            row.iter().zip(&mode.shape).map(|(r, phi)| r * phi).sum::<f64>()
        };
        let (u, v) = (moves(PlanDirection::X), moves(PlanDirection::Y));
        let gyration = building
            .floors()
            .get(self.floor - 1)
            .map_or(0.0, |floor| floor.gyration_m);
        let size = u.hypot(v).max(gyration * mode.shape[base + 2].abs());
        if along.abs() <= STILL * size || size == 0.0 {
            let why = if u.abs().max(v.abs()) <= STILL * size {
                "it turns about that place"
            } else if v.abs() <= STILL * u.abs() {
                "it moves only in x here"
            } else if u.abs() <= STILL * v.abs() {
                "it moves only in y here"
            } else {
                "it moves across that direction"
            };
            return Err(DamperFault::Still {
                name,
                mode: self.mode,
                why: why.to_owned(),
            });
        }
        let modal_mass_kg = 1.0 / (along * along);
        let (mass_kg, mass_ratio) = match &self.mass {
            DamperMass::Mass(mass) => (pick(mass), pick(mass) / modal_mass_kg),
            DamperMass::Ratio(ratio) => (pick(ratio) * modal_mass_kg, pick(ratio)),
        };
        if mass_ratio > 1.0 {
            return Err(DamperFault::Heavy {
                name,
                mass_ratio,
                mode: self.mode,
                modal_mass_kg,
            });
        }
        let tuned = self.tuning.map(|tuning| tuning.of(mass_ratio));
        let frequency_hz = match &self.frequency {
            DamperFrequency::Frequency(frequency) => pick(frequency),
            DamperFrequency::Ratio(ratio) => pick(ratio) * mode.frequency_hz,
            DamperFrequency::Tuned => tuned.map_or(f64::NAN, |[f, _]| f * mode.frequency_hz),
        };
        let damping_ratio = match (&self.damping_ratio, tuned) {
            (Some(ratio), _) => pick(ratio),
            (None, Some([_, zeta])) => zeta,
            (None, None) => f64::NAN,
        };
        Ok(BuiltDamper {
            name,
            mode: self.mode,
            mass_ratio,
            tuning: self.tuning,
            tuned: TunedMass {
                floor: self.floor,
                x_m,
                y_m,
                direction: self.direction,
                mass_kg,
                frequency_hz,
                damping_ratio,
            },
        })
    }
}
