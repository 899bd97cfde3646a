//! A damper of a project file placed on its building: masses, frequencies and damping ratios as numbers.

use super::built_damper::{BuiltDamper, TunedTo};
use super::damper::{
    DamperBody, DamperFault, DamperFrequency, DamperMass, DamperPart, HostBuilding, MassPart, MovingPart,
};
use crate::quantity::Pick;
use crate::wrong::StillMode;
use dolmen::damper::{AttachedDamper, ColumnAsMass, DamperKind, TuningRule};
use dolmen::structure::building::{BuildingMode, PlanDirection};
use std::f64::consts::TAU;

/// Values that several masses take from their damper, where they have none of their own.
struct WholeDamper {
    place_m: [f64; 2],
    mass_kg: f64,
    frequency_hz: f64,
    damping_ratio: f64,
    mode: usize,
    /// Frequency of its mode.
    mode_hz: f64,
    /// The rule for frequency and damping.
    rule: Option<TuningRule>,
    /// Available stroke of the damper and of its liquid, m.
    rooms_m: [Option<f64>; 2],
}

/// A mode where a damper stands.
struct AtMode {
    modal_mass_kg: f64,
    frequency_hz: f64,
    damping_ratio: f64,
}

impl MovingPart {
    /// α of a column; 1 of a mass on a spring.
    fn length_ratio(&self, pick: Pick<'_>) -> f64 {
        match self {
            MovingPart::Column { length_ratio } => pick(length_ratio),
            MovingPart::Masses(_) | MovingPart::ColumnMass { .. } => 1.0,
        }
    }
}

impl MovingPart {
    /// The damper with a single moving mass of this mass, kg, frequency, Hz, and damping ratio.
    fn as_one(
        &self,
        [mass_kg, frequency_hz, damping_ratio]: [f64; 3],
        liquid_frequency_hz: f64,
        pick: Pick<'_>,
    ) -> DamperKind {
        match self {
            MovingPart::Masses(_) => DamperKind::TunedMass {
                mass_kg,
                frequency_hz,
                damping_ratio,
            },
            MovingPart::Column { length_ratio } => DamperKind::LiquidColumn {
                liquid_mass_kg: mass_kg,
                length_ratio: pick(length_ratio),
                frequency_hz,
                damping_ratio,
            },
            MovingPart::ColumnMass {
                length_ratio,
                liquid_share,
                liquid_damping_ratio,
                ..
            } => {
                let liquid = pick(liquid_share) * mass_kg;
                DamperKind::LiquidColumnMass {
                    container_mass_kg: mass_kg - liquid,
                    liquid_mass_kg: liquid,
                    length_ratio: pick(length_ratio),
                    frequency_hz,
                    damping_ratio,
                    liquid_frequency_hz,
                    liquid_damping_ratio: pick(liquid_damping_ratio),
                }
            }
        }
    }
}

impl DamperPart {
    pub(super) fn build(
        &self,
        host: &HostBuilding<'_>,
        pick: Pick<'_>,
    ) -> Result<Vec<BuiltDamper>, DamperFault> {
        let place_m = [pick(&self.place[0]), pick(&self.place[1])];
        let rooms_m = [&self.stroke, &self.liquid_stroke].map(|room| room.as_ref().map(&mut *pick));
        let built = |name, place_m, row, kind| self.built(name, place_m, (row, kind), rooms_m);
        let row = self.row(host, self.floor, place_m)?;
        let (moving, mass, mode, frequency, damping_ratio, tuning) = match &self.body {
            DamperBody::Link {
                coefficient,
                to_floor,
                to_place,
            } => {
                let to_place_m = to_place
                    .as_ref()
                    .map_or(place_m, |to| [pick(&to[0]), pick(&to[1])]);
                let to = (*to_floor, to_place_m);
                let AttachedDamper { kind, row } = self.link(host, pick(coefficient), &row, to)?;
                return Ok(vec![BuiltDamper {
                    to: Some(to),
                    ..built(self.name.clone(), place_m, row, kind)
                }]);
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
        let at = self.at_mode(host, mode, place_m, &row)?;
        let [mass_kg, mass_ratio] = self.mass(mass, (mode, &at), host, pick)?;
        let length_ratio = moving.length_ratio(pick);
        let tuned = tuning
            .map(|rule| ColumnAsMass::new(mass_ratio, length_ratio).rule(rule, at.damping_ratio))
            .transpose()?;
        let by_rule = matches!(frequency, DamperFrequency::Tuned) && damping_ratio.is_none();
        let gravity = host.gravity_m_s2;
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
            MovingPart::Masses(parts) if !parts.is_empty() => {
                let whole = WholeDamper {
                    place_m,
                    mass_kg,
                    frequency_hz,
                    damping_ratio,
                    mode,
                    mode_hz: at.frequency_hz,
                    rule: tuning.filter(|_| by_rule),
                    rooms_m,
                };
                self.several(parts, &whole, host, pick)?
            }
            one => {
                let tuned = [mass_kg, frequency_hz, damping_ratio];
                vec![whole(one.as_one(tuned, liquid_hz, pick))]
            }
        })
    }

    /// A dashpot between its place and another one, with the floor of the other, 0 for the ground.
    fn link(
        &self,
        host: &HostBuilding<'_>,
        coefficient: f64,
        row: &[f64],
        (to_floor, to_place_m): (usize, [f64; 2]),
    ) -> Result<AttachedDamper, DamperFault> {
        let other = match to_floor {
            0 => vec![0.0; row.len()],
            floor => self.row(host, floor, to_place_m)?,
        };
        Ok(AttachedDamper::link(coefficient, row, &other))
    }

    fn built(
        &self,
        name: String,
        place_m: [f64; 2],
        (row, kind): (Vec<f64>, DamperKind),
        [room_m, liquid_room_m]: [Option<f64>; 2],
    ) -> BuiltDamper {
        BuiltDamper {
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
        }
    }

    /// Its mass, kg, and its ratio to the modal mass.
    fn mass(
        &self,
        mass: &DamperMass,
        (mode, at): (usize, &AtMode),
        host: &HostBuilding<'_>,
        pick: Pick<'_>,
    ) -> Result<[f64; 2], DamperFault> {
        let [mass_kg, mass_ratio] = match mass {
            DamperMass::Mass(mass) => [pick(mass), pick(mass) / at.modal_mass_kg],
            DamperMass::Ratio(ratio) => [pick(ratio) * at.modal_mass_kg, pick(ratio)],
        };
        if mass_ratio > 1.0 {
            return Err(DamperFault::Heavy {
                name: self.name.clone(),
                mass_ratio,
                mode,
                modal_mass_kg: at.modal_mass_kg,
            });
        }
        let building_kg = host.vibrating.building().mass_kg();
        if mass_kg > building_kg {
            return Err(DamperFault::HeavierThanAll {
                name: self.name.clone(),
                mass_kg,
                building_kg,
                mode,
            });
        }
        Ok([mass_kg, mass_ratio])
    }

    /// A damper for each of several masses.
    fn several(
        &self,
        parts: &[MassPart],
        whole: &WholeDamper,
        host: &HostBuilding<'_>,
        pick: Pick<'_>,
    ) -> Result<Vec<BuiltDamper>, DamperFault> {
        let mut all = Vec::with_capacity(parts.len());
        for (i, part) in parts.iter().enumerate() {
            let share = pick(&part.share);
            let own_hz = match &part.frequency {
                None => whole.frequency_hz,
                Some(DamperFrequency::Frequency(frequency)) => pick(frequency),
                Some(DamperFrequency::Ratio(ratio)) => pick(ratio) * whole.mode_hz,
                Some(_) => whole.frequency_hz,
            };
            let own_ratio = part
                .damping_ratio
                .as_ref()
                .map_or(whole.damping_ratio, &mut *pick);
            let kind = DamperKind::TunedMass {
                mass_kg: share * whole.mass_kg,
                frequency_hz: own_hz,
                damping_ratio: own_ratio,
            };
            let own_place = part
                .place
                .as_ref()
                .map_or(whole.place_m, |place| [pick(&place[0]), pick(&place[1])]);
            let row = self.row(host, self.floor, own_place)?;
            let own = self.at_mode(host, whole.mode, own_place, &row)?;
            all.push(BuiltDamper {
                tuned_to: Some(TunedTo {
                    mode: whole.mode,
                    mass_ratio: share * whole.mass_kg / own.modal_mass_kg,
                }),
                tuning: whole
                    .rule
                    .filter(|_| part.frequency.is_none() && part.damping_ratio.is_none()),
                ..self.built(
                    format!("{}-{}", self.name, i + 1),
                    own_place,
                    (row, kind),
                    whole.rooms_m,
                )
            });
        }
        Ok(all)
    }

    fn row(
        &self,
        host: &HostBuilding<'_>,
        floor: usize,
        [x_m, y_m]: [f64; 2],
    ) -> Result<Vec<f64>, DamperFault> {
        let row = host
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
        host: &HostBuilding<'_>,
        number: usize,
        place_m: [f64; 2],
        row: &[f64],
    ) -> Result<AtMode, DamperFault> {
        /// Least motion of a mode at a place over its largest, below which it counts as zero. Our choice.
        const STILL: f64 = 1e-6;
        /// Relative difference below which modes have the same frequency.
        const ONE_FREQUENCY: f64 = 1e-6;
        let name = self.name.clone();
        let (building, modes) = (host.vibrating.building(), host.vibrating.modes());
        let Some((index, mode)) = number.checked_sub(1).and_then(|j| Some((j, modes.modes.get(j)?))) else {
            return Err(DamperFault::Mode {
                name,
                mode: number,
                most: modes.modes.len(),
            });
        };
        // modes of one frequency all move, in the combination that moves the place most
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
            damping_ratio: host.vibrating.damping_ratios().get(index).copied().unwrap_or(0.0),
        })
    }
}
