//! Dampers of a building in a project file, with numbers for every value.

use crate::quantity::Quantity;
use dolmen::damper::{DamperError, TuningRule};
use dolmen::dynamics::VibratingBuilding;
use dolmen::structure::building::{BuildingError, PlanDirection};
use dolmen_words::message::Both;

/// The mass of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperMass {
    /// Mass, kg.
    Mass(Quantity),
    /// Ratio to the modal mass of its mode.
    Ratio(Quantity),
}

/// The frequency of a damper.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperFrequency {
    /// Frequency, Hz.
    Frequency(Quantity),
    /// Ratio to the frequency of its mode.
    Ratio(Quantity),
    /// Frequency of a liquid column with total length L, m: √(2g/L)/2π.
    Length(Quantity),
    /// From the tuning.
    Tuned,
}

/// One of several masses that make up a damper.
#[derive(Clone, Debug, PartialEq)]
pub struct MassPart {
    /// Its fraction of the mass.
    pub share: Quantity,
    /// Place, m; `None`: the place of the damper.
    pub place: Option<Box<[Quantity; 2]>>,
    /// Frequency; `None`: the frequency of the damper.
    pub frequency: Option<DamperFrequency>,
    /// Damping ratio; `None`: the damping ratio of the damper.
    pub damping_ratio: Option<Quantity>,
}

/// The moving mass of a damper.
#[allow(
    clippy::large_enum_variant,
    reason = "a file has a few dampers: a box would save nothing"
)]
#[derive(Clone, Debug, PartialEq)]
pub enum MovingPart {
    /// Masses on springs and dashpots; empty list: one mass.
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
        /// Fraction of the mass that is liquid.
        liquid_share: Quantity,
        /// Frequency of the liquid.
        liquid_frequency: DamperFrequency,
        /// Damping ratio of the liquid.
        liquid_damping_ratio: Quantity,
    },
}

/// The kind of a damper with its numbers.
#[allow(
    clippy::large_enum_variant,
    reason = "a file has a few dampers: a box would save nothing"
)]
#[derive(Clone, Debug, PartialEq)]
pub enum DamperBody {
    /// A mass that moves on the floor.
    Moving {
        /// The moving mass.
        moving: Box<MovingPart>,
        /// Total mass.
        mass: DamperMass,
        /// The mode that it damps, from 1.
        mode: usize,
        /// Frequency.
        frequency: DamperFrequency,
        /// Damping ratio; `None`: from the tuning.
        damping_ratio: Option<Quantity>,
        /// Closed form, if named.
        tuning: Option<TuningRule>,
    },
    /// A dashpot to another floor or the ground.
    Link {
        /// Coefficient, N s/m.
        coefficient: Quantity,
        /// Floor of its other end; 0 for the ground.
        to_floor: usize,
        /// Place of its other end, m; `None`: vertically below or above its own place.
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
    /// Its kind with its numbers.
    pub body: DamperBody,
    /// Available stroke, each way, m.
    pub stroke: Option<Quantity>,
    /// Available stroke of the liquid of a column on a spring, each way, m.
    pub liquid_stroke: Option<Quantity>,
}

/// Reason why a damper is impossible.
#[derive(Clone, Debug, PartialEq)]
pub enum DamperFault {
    /// Its mode does not move at its place.
    Still {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// The motion of the mode at its place.
        why: Both,
    },
    /// There is no such mode.
    Mode {
        /// The damper.
        name: String,
        /// Its mode.
        mode: usize,
        /// Number of modes.
        most: usize,
    },
    /// It is heavier than the modal mass of its mode.
    Heavy {
        /// The damper.
        name: String,
        /// Its mass ratio.
        mass_ratio: f64,
        /// Its mode.
        mode: usize,
        /// Modal mass at the place of the damper, kg.
        modal_mass_kg: f64,
    },
    /// Its tuning is impossible.
    Tuning(DamperError),
    /// It is heavier than the building.
    HeavierThanAll {
        /// The damper.
        name: String,
        /// Its mass, kg.
        mass_kg: f64,
        /// Mass of the building, kg.
        building_kg: f64,
        /// Its mode.
        mode: usize,
    },
    /// The building rejects its place.
    Place {
        /// The damper.
        name: String,
        /// Reason.
        why: BuildingError,
    },
}

/// The building in the form that a damper needs.
pub(super) struct HostBuilding<'a> {
    pub(super) vibrating: &'a VibratingBuilding,
    pub(super) gravity_m_s2: f64,
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
}
