//! Dampers of a building in a project file, every number worked out.

use super::built_damper::{BuiltDamper, TunedTo};
use crate::quantity::{Pick, Quantity};
use crate::wrong::StillMode;
use dolmen::damper::{AttachedDamper, ColumnAsMass, DamperError, DamperKind, TuningRule};
use dolmen::dynamics::VibratingBuilding;
use dolmen::structure::building::{BuildingError, BuildingMode, PlanDirection};
use dolmen_words::message::Both;
use std::f64::consts::TAU;

/// The mass of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperMass {
    /// kg.
    Mass(Quantity),
    /// Over the modal mass of its mode.
    Ratio(Quantity),
}

/// The frequency of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperFrequency {
    /// Hz.
    Frequency(Quantity),
    /// Over that of its mode.
    Ratio(Quantity),
    /// Of a liquid column by its total length L, m: √(2g/L)/2π.
    Length(Quantity),
    /// By the tuning.
    Tuned,
}

/// One of several masses that make up a damper.
#[derive(Clone, Debug, PartialEq)]
pub struct MassPart {
    /// Its part of the mass.
    pub share: Quantity,
    /// Place, m; `None`: that of the damper.
    pub place: Option<Box<[Quantity; 2]>>,
    /// Frequency; `None`: that of the damper.
    pub frequency: Option<DamperFrequency>,
    /// Damping ratio; `None`: that of the damper.
    pub damping_ratio: Option<Quantity>,
}

/// What moves.
#[allow(
    clippy::large_enum_variant,
    reason = "a file has a few dampers: a box would save nothing"
)]
#[derive(Clone, Debug, PartialEq)]
pub enum MovingPart {
    /// Masses on springs and dashpots; none listed: one.
    Masses(Vec<MassPart>),
    /// A liquid column.
    Column {
        /// α, horizontal over total length.
        length_ratio: Quantity,
    },
    /// A liquid column on a spring and a dashpot.
    ColumnMass {
        /// α of the column.
        length_ratio: Quantity,
        /// The liquid's part of the mass.
        liquid_share: Quantity,
        /// Frequency of the liquid.
        liquid_frequency: DamperFrequency,
        /// Damping ratio of the liquid.
        liquid_damping_ratio: Quantity,
    },
}

/// What a damper is.
#[allow(
    clippy::large_enum_variant,
    reason = "a file has a few dampers: a box would save nothing"
)]
#[derive(Clone, Debug, PartialEq)]
pub enum DamperBody {
    /// Something that moves on the floor.
    Moving {
        /// What.
        moving: Box<MovingPart>,
        /// Mass, all of it.
        mass: DamperMass,
        /// The mode that it is for, from 1.
        mode: usize,
        /// Frequency.
        frequency: DamperFrequency,
        /// Damping ratio; `None`: by the tuning.
        damping_ratio: Option<Quantity>,
        /// Closed form, if named.
        tuning: Option<TuningRule>,
    },
    /// A dashpot to another floor or the ground.
    Link {
        /// N s/m.
        coefficient: Quantity,
        /// Floor of its other end; 0 for the ground.
        to_floor: usize,
        /// Place of its other end, m; `None`: under its own.
        to_place: Option<Box<[Quantity; 2]>>,
    },
}

/// A damper as the file gives it.
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
    /// What it is.
    pub body: DamperBody,
    /// Room that it has to move, each way, m.
    pub stroke: Option<Quantity>,
    /// Room of the liquid of a column on a spring, each way, m.
    pub liquid_stroke: Option<Quantity>,
}

/// Why a damper cannot be.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperFault {
    /// Its mode does not move there.
    Still {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// What the mode does there.
        why: Both,
    },
    /// There is no such mode.
    Mode {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// How many there are.
        most: usize,
    },
    /// It weighs more than what it damps.
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
    /// Its tuning cannot be.
    Tuning(DamperError),
    /// It weighs more than the building.
    HeavierThanAll {
        /// The damper.
        name: String,
        /// Its mass, kg.
        mass_kg: f64,
        /// The building's, kg.
        building_kg: f64,
        /// Its mode.
        mode: usize,
    },
    /// The building refuses it.
    Place {
        /// The damper.
        name: String,
        /// Why.
        why: BuildingError,
    },
}

/// A building as a damper needs it.
pub(super) struct Around<'a> {
    pub(super) vibrating: &'a VibratingBuilding,
    pub(super) gravity_m_s2: f64,
}

/// A mode where a damper stands.
struct AtMode {
    modal_mass_kg: f64,
    frequency_hz: f64,
    damping_ratio: f64,
}

impl DamperFrequency {
    fn input(&self) -> Option<&Quantity> {
        match self {
            DamperFrequency::Frequency(given)
            | DamperFrequency::Ratio(given)
            | DamperFrequency::Length(given) => Some(given),
            DamperFrequency::Tuned => None,
        }
    }
}

impl DamperPart {
    pub(super) fn inputs<'a>(&'a self, all: &mut Vec<&'a Quantity>) {
        all.extend(self.place.iter());
        all.extend(self.stroke.iter().chain(&self.liquid_stroke));
        match &self.body {
            DamperBody::Link {
                coefficient,
                to_place,
                ..
            } => {
                all.push(coefficient);
                all.extend(to_place.iter().flat_map(|place| place.iter()));
            }
            DamperBody::Moving {
                moving,
                mass,
                frequency,
                damping_ratio,
                ..
            } => {
                match mass {
                    DamperMass::Mass(given) | DamperMass::Ratio(given) => all.push(given),
                }
                all.extend(frequency.input());
                all.extend(damping_ratio);
                match &**moving {
                    MovingPart::Masses(parts) => {
                        for part in parts {
                            all.push(&part.share);
                            all.extend(part.place.iter().flat_map(|place| place.iter()));
                            all.extend(part.frequency.as_ref().and_then(DamperFrequency::input));
                            all.extend(&part.damping_ratio);
                        }
                    }
                    MovingPart::Column { length_ratio } => all.push(length_ratio),
                    MovingPart::ColumnMass {
                        length_ratio,
                        liquid_share,
                        liquid_frequency,
                        liquid_damping_ratio,
                    } => {
                        all.extend([length_ratio, liquid_share, liquid_damping_ratio]);
                        all.extend(liquid_frequency.input());
                    }
                }
            }
        }
    }

    pub(super) fn build(&self, around: &Around<'_>, pick: Pick<'_>) -> Result<Vec<BuiltDamper>, DamperFault> {
        let place_m = [pick(&self.place[0]), pick(&self.place[1])];
        let room_m = self.stroke.as_ref().map(&mut *pick);
        let liquid_room_m = self.liquid_stroke.as_ref().map(&mut *pick);
        let built = |name: String, place_m: [f64; 2], row: Vec<f64>, kind| BuiltDamper {
            name,
            floor: self.floor,
            place_m,
            direction: self.direction,
            kind,
            row,
            tuned_to: None,
            tuning: None,
            room_m,
            liquid_room_m,
            to: None,
        };
        let row = self.row(around, self.floor, place_m)?;
        let (moving, mass, mode, frequency, damping_ratio, tuning) = match &self.body {
            DamperBody::Link {
                coefficient,
                to_floor,
                to_place,
            } => {
                let to_place_m = to_place
                    .as_ref()
                    .map_or(place_m, |to| [pick(&to[0]), pick(&to[1])]);
                let other = match to_floor {
                    0 => vec![0.0; row.len()],
                    floor => self.row(around, *floor, to_place_m)?,
                };
                let AttachedDamper { kind, row } = AttachedDamper::link(pick(coefficient), &row, &other);
                let mut link = built(self.name.clone(), place_m, row, kind);
                link.to = Some((*to_floor, to_place_m));
                return Ok(vec![link]);
            }
            DamperBody::Moving {
                moving,
                mass,
                mode,
                frequency,
                damping_ratio,
                tuning,
            } => (moving, mass, *mode, frequency, damping_ratio, *tuning),
        };
        let at = self.at_mode(around, mode, place_m, &row)?;
        let (mass_kg, mass_ratio) = match mass {
            DamperMass::Mass(mass) => (pick(mass), pick(mass) / at.modal_mass_kg),
            DamperMass::Ratio(ratio) => (pick(ratio) * at.modal_mass_kg, pick(ratio)),
        };
        if mass_ratio > 1.0 {
            return Err(DamperFault::Heavy {
                name: self.name.clone(),
                mass_ratio,
                mode,
                modal_mass_kg: at.modal_mass_kg,
            });
        }
        let building_kg = around.vibrating.building().mass_kg();
        if mass_kg > building_kg {
            return Err(DamperFault::HeavierThanAll {
                name: self.name.clone(),
                mass_kg,
                building_kg,
                mode,
            });
        }
        let length_ratio = match &**moving {
            MovingPart::Column { length_ratio } => pick(length_ratio),
            MovingPart::Masses(_) | MovingPart::ColumnMass { .. } => 1.0,
        };
        let tuned = match tuning {
            Some(rule) => {
                let column = ColumnAsMass::new(mass_ratio, length_ratio);
                Some(column.rule(rule, at.damping_ratio)?)
            }
            None => None,
        };
        let by_rule = matches!(frequency, DamperFrequency::Tuned) && damping_ratio.is_none();
        let gravity = around.gravity_m_s2;
        let mut hz = |of: &DamperFrequency| match of {
            DamperFrequency::Frequency(frequency) => pick(frequency),
            DamperFrequency::Ratio(ratio) => pick(ratio) * at.frequency_hz,
            DamperFrequency::Length(length) => (2.0 * gravity / pick(length)).sqrt() / TAU,
            DamperFrequency::Tuned => tuned.map_or(f64::NAN, |t| t.frequency_ratio * at.frequency_hz),
        };
        let frequency_hz = hz(frequency);
        let liquid_hz = match &**moving {
            MovingPart::ColumnMass { liquid_frequency, .. } => hz(liquid_frequency),
            _ => f64::NAN,
        };
        let damping_ratio = match (damping_ratio, tuned) {
            (Some(ratio), _) => pick(ratio),
            (None, Some(tuned)) => tuned.damping_ratio,
            (None, None) => f64::NAN,
        };
        let whole = |kind| BuiltDamper {
            tuned_to: Some(TunedTo { mode, mass_ratio }),
            tuning: tuning.filter(|_| by_rule),
            ..built(self.name.clone(), place_m, row.clone(), kind)
        };
        Ok(match &**moving {
            MovingPart::Masses(parts) if parts.is_empty() => vec![whole(DamperKind::TunedMass {
                mass_kg,
                frequency_hz,
                damping_ratio,
            })],
            MovingPart::Masses(parts) => {
                let mut all = Vec::with_capacity(parts.len());
                for (i, part) in parts.iter().enumerate() {
                    let share = pick(&part.share);
                    let own_hz = match &part.frequency {
                        None => frequency_hz,
                        Some(DamperFrequency::Frequency(frequency)) => pick(frequency),
                        Some(DamperFrequency::Ratio(ratio)) => pick(ratio) * at.frequency_hz,
                        Some(_) => frequency_hz,
                    };
                    let own_ratio = part.damping_ratio.as_ref().map_or(damping_ratio, &mut *pick);
                    let kind = DamperKind::TunedMass {
                        mass_kg: share * mass_kg,
                        frequency_hz: own_hz,
                        damping_ratio: own_ratio,
                    };
                    let own_place = part
                        .place
                        .as_ref()
                        .map_or(place_m, |place| [pick(&place[0]), pick(&place[1])]);
                    let row = self.row(around, self.floor, own_place)?;
                    let own = self.at_mode(around, mode, own_place, &row)?;
                    all.push(BuiltDamper {
                        tuned_to: Some(TunedTo {
                            mode,
                            mass_ratio: share * mass_kg / own.modal_mass_kg,
                        }),
                        tuning: tuning
                            .filter(|_| by_rule && part.frequency.is_none() && part.damping_ratio.is_none()),
                        ..built(format!("{}-{}", self.name, i + 1), own_place, row, kind)
                    });
                }
                all
            }
            MovingPart::Column { .. } => vec![whole(DamperKind::LiquidColumn {
                liquid_mass_kg: mass_kg,
                length_ratio,
                frequency_hz,
                damping_ratio,
            })],
            MovingPart::ColumnMass {
                length_ratio,
                liquid_share,
                liquid_damping_ratio,
                ..
            } => {
                let liquid = pick(liquid_share) * mass_kg;
                vec![whole(DamperKind::LiquidColumnMass {
                    container_mass_kg: mass_kg - liquid,
                    liquid_mass_kg: liquid,
                    length_ratio: pick(length_ratio),
                    frequency_hz,
                    damping_ratio,
                    liquid_frequency_hz: liquid_hz,
                    liquid_damping_ratio: pick(liquid_damping_ratio),
                })]
            }
        })
    }

    fn row(&self, around: &Around<'_>, floor: usize, [x_m, y_m]: [f64; 2]) -> Result<Vec<f64>, DamperFault> {
        let row = around
            .vibrating
            .building()
            .point_row(floor, x_m, y_m, self.direction);
        row.map_err(|why| DamperFault::Place {
            name: self.name.clone(),
            why,
        })
    }

    fn at_mode(
        &self,
        around: &Around<'_>,
        number: usize,
        place_m: [f64; 2],
        row: &[f64],
    ) -> Result<AtMode, DamperFault> {
        /// A mode that moves less than this part of its largest is still there. Our choice.
        const STILL: f64 = 1e-6;
        /// Modes whose frequencies are this near, relatively, are one.
        const ONE_FREQUENCY: f64 = 1e-6;
        let name = self.name.clone();
        let (building, modes) = (around.vibrating.building(), around.vibrating.modes());
        let Some((index, mode)) = number.checked_sub(1).and_then(|j| Some((j, modes.modes.get(j)?))) else {
            return Err(DamperFault::Mode {
                name,
                mode: number,
                most: modes.modes.len(),
            });
        };
        // of modes of one frequency all move, in the proportion that moves the place most
        let near = |other: &&BuildingMode| (other.omega_rad_s / mode.omega_rad_s - 1.0).abs() < ONE_FREQUENCY;
        let together: Vec<&BuildingMode> = modes.modes.iter().filter(near).collect();
        let moved_by = |row: &[f64]| -> f64 {
            let each = together.iter();
            each.map(|mode| row.iter().zip(&mode.shape).map(|(r, phi)| r * phi).sum::<f64>())
                .fold(0.0, f64::hypot)
        };
        let along = moved_by(row);
        let base = 3 * (self.floor - 1);
        let moves = |direction| {
            let row = building
                .point_row(self.floor, place_m[0], place_m[1], direction)
                .unwrap_or_default();
            moved_by(&row)
        };
        let (u, v) = (moves(PlanDirection::X), moves(PlanDirection::Y));
        let gyration = building
            .floors()
            .get(self.floor - 1)
            .map_or(0.0, |floor| floor.gyration_m);
        let size = u.hypot(v).max(gyration * mode.shape[base + 2].abs());
        if along.abs() <= STILL * size || size == 0.0 {
            let why = if u.abs().max(v.abs()) <= STILL * size {
                StillMode::TurnsAboutIt
            } else if v.abs() <= STILL * u.abs() {
                StillMode::OnlyInX
            } else if u.abs() <= STILL * v.abs() {
                StillMode::OnlyInY
            } else {
                StillMode::Across
            };
            return Err(DamperFault::Still {
                name,
                mode: number,
                why: why.into(),
            });
        }
        Ok(AtMode {
            modal_mass_kg: 1.0 / (along * along),
            frequency_hz: mode.frequency_hz,
            damping_ratio: around
                .vibrating
                .damping_ratios()
                .get(index)
                .copied()
                .unwrap_or(0.0),
        })
    }
}
