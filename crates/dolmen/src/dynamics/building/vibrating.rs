//! A building with modal damping and tuned masses.

use crate::dynamics::DynamicsError;
use crate::structure::Building;
use crate::structure::building::{BuildingDamping, BuildingModes, PlanDirection};
use std::f64::consts::TAU;

/// Largest damping ratio of a tuned mass. Our choice: far above every tuning.
const RATIO_MOST: f64 = 10.0;

/// A mass on a spring and a dashpot at a point of a floor, free to move along one direction.
#[derive(Clone, Debug, PartialEq)]
pub struct TunedMass {
    /// The floor, from 1 at the bottom.
    pub floor: usize,
    /// Position in plan along x, m.
    pub x_m: f64,
    /// Position in plan along y, m.
    pub y_m: f64,
    /// Direction of its motion.
    pub direction: PlanDirection,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Natural frequency of the mass on its spring, Hz.
    pub frequency_hz: f64,
    /// Damping ratio c/(2 m ω), with ω the natural frequency of the mass on its spring.
    pub damping_ratio: f64,
}

#[derive(Clone, Debug, PartialEq)]
pub(super) struct Oscillator {
    /// Displacement of its position along its direction in each mode, 1/√kg.
    pub(super) row: Vec<f64>,
    pub(super) unit: [f64; 2],
    pub(super) mass: f64,
    pub(super) stiffness: f64,
    pub(super) damping: f64,
}

/// A building with its modes, their damping and its tuned masses.
#[derive(Clone, Debug, PartialEq)]
pub struct VibratingBuilding {
    building: Building,
    modes: BuildingModes,
    damping_ratios: Vec<f64>,
    tuned_masses: Vec<TunedMass>,
    oscillators: Vec<Oscillator>,
}

impl VibratingBuilding {
    /// Builds a damped building with its tuned masses.
    ///
    /// [`DynamicsError::Building`] for invalid damping or a position off the floor; [`DynamicsError::Argument`] for a mass, frequency or
    /// damping ratio out of its range.
    pub fn new(
        building: Building,
        damping: &BuildingDamping,
        tuned_masses: Vec<TunedMass>,
    ) -> Result<Self, DynamicsError> {
        let modes = building.modes()?;
        let damping_ratios = modes.damping_ratios(damping)?;
        let alone = VibratingBuilding {
            building,
            modes,
            damping_ratios,
            tuned_masses: Vec::new(),
            oscillators: Vec::new(),
        };
        alone.with_tuned_masses(tuned_masses)
    }

    /// The same building with its tuned masses replaced.
    ///
    /// # Errors
    /// As [`VibratingBuilding::new`].
    pub fn with_tuned_masses(self, tuned_masses: Vec<TunedMass>) -> Result<Self, DynamicsError> {
        let (building, modes) = (&self.building, &self.modes);
        let mut oscillators = Vec::with_capacity(tuned_masses.len());
        for tuned in &tuned_masses {
            let row = building.point_row(tuned.floor, tuned.x_m, tuned.y_m, tuned.direction)?;
            for (argument, given) in [("mass_kg", tuned.mass_kg), ("frequency_hz", tuned.frequency_hz)] {
                if !(given > 0.0 && given.is_finite()) {
                    return Err(DynamicsError::Argument {
                        argument,
                        given,
                        allowed: "a positive number",
                    });
                }
            }
            if !(0.0..=RATIO_MOST).contains(&tuned.damping_ratio) {
                return Err(DynamicsError::Argument {
                    argument: "damping_ratio",
                    given: tuned.damping_ratio,
                    allowed: "0 to 10: is it in percent?",
                });
            }
            let omega = TAU * tuned.frequency_hz;
            let each = modes.modes.iter().map(|mode| -> f64 {
                let base = 3 * (tuned.floor - 1);
                (base..base + 3).map(|i| row[i] * mode.shape[i]).sum()
            });
            oscillators.push(Oscillator {
                row: each.collect(),
                unit: tuned.direction.unit(),
                mass: tuned.mass_kg,
                stiffness: tuned.mass_kg * omega * omega,
                damping: 2.0 * tuned.damping_ratio * tuned.mass_kg * omega,
            });
        }
        Ok(VibratingBuilding {
            tuned_masses,
            oscillators,
            ..self
        })
    }

    /// The building.
    pub fn building(&self) -> &Building {
        &self.building
    }

    /// Modes of the building without the tuned masses.
    pub fn modes(&self) -> &BuildingModes {
        &self.modes
    }

    /// Damping ratios of these modes.
    pub fn damping_ratios(&self) -> &[f64] {
        &self.damping_ratios
    }

    /// The tuned masses.
    pub fn tuned_masses(&self) -> &[TunedMass] {
        &self.tuned_masses
    }

    pub(super) fn oscillators(&self) -> &[Oscillator] {
        &self.oscillators
    }
}
