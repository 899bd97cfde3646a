//! The building: floors on storeys, checked once.

use super::error::BuildingError;
use super::floors::{Floor, Storey, check_floor, positive};
use super::stability::{StoreyFall, storey_falls};

/// Whether the weight reduces the stiffness (P-delta).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PDelta {
    /// No P-delta.
    LeftOut,
    /// P-delta from the weight of all floors above; each weight acts at its centre of mass.
    Weights {
        /// Acceleration of gravity, m/s².
        gravity_m_s2: f64,
    },
}

/// A building of rigid floors on storeys, lowest first. Construction checks that it is valid and stable.
///
/// Three coordinates for each floor, u, v, θ of its centre of mass, floors from the bottom.
///
/// ```
/// use dolmen::structure::building::{Building, Floor, Outline, PDelta, Storey, StoreyStiffness};
/// // one floor, 10 × 8 m, its walls stiffer on the left
/// let outline = Outline::rectangle([0.0, 0.0], 10.0, 8.0)?;
/// let stiffness = StoreyStiffness::about_point(
///     [[5.208, 0.0, 0.0], [0.0, 3.6456, -5.4684], [0.0, -5.4684, 174.468]], [0.0, 0.0]);
/// let storey = Storey { height_m: 3.0, stiffness };
/// let building = Building::new(vec![Floor::uniform(1.0, outline)], vec![storey], PDelta::LeftOut)?;
/// let modes = building.modes()?;
/// assert!((modes.modes[0].omega_rad_s - 1.847).abs() < 1e-3);
/// let centre = modes.modes[0].centres[0].unwrap();
/// assert!((centre.x_m + 23.38).abs() < 0.01);
/// # Ok::<(), dolmen::structure::building::BuildingError>(())
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Building {
    floors: Vec<Floor>,
    storeys: Vec<Storey>,
    p_delta: PDelta,
}

impl Building {
    /// Makes a building from floors and the storey below each, lowest first.
    ///
    /// # Errors
    /// [`BuildingError::Empty`], [`BuildingError::Count`], [`BuildingError::Value`] for a mass, gyration or height that is
    /// not positive or a stiffness that is negative; [`BuildingError::Element`]; [`BuildingError::Asymmetric`];
    /// [`BuildingError::Sways`] and [`BuildingError::Twists`] for a storey without stiffness against sway or twist;
    /// [`BuildingError::Outside`] if a centre of mass is outside the bounding box of its floor; [`BuildingError::Falls`]
    /// if P-delta exceeds the stiffness of a storey.
    pub fn new(floors: Vec<Floor>, storeys: Vec<Storey>, p_delta: PDelta) -> Result<Self, BuildingError> {
        if floors.is_empty() {
            return Err(BuildingError::Empty);
        }
        if floors.len() != storeys.len() {
            return Err(BuildingError::Count {
                storeys: storeys.len(),
                floors: floors.len(),
            });
        }
        for (i, (floor, storey)) in floors.iter().zip(&storeys).enumerate() {
            check_floor(floor, i + 1)?;
            positive("storey", i + 1, "height_m", storey.height_m)?;
            storey.stiffness.check(i + 1)?;
        }
        if let PDelta::Weights { gravity_m_s2 } = p_delta {
            if !(gravity_m_s2 > 0.0 && gravity_m_s2.is_finite()) {
                return Err(BuildingError::Argument {
                    argument: "gravity_m_s2",
                    given: gravity_m_s2,
                    allowed: "a positive number (9.81 on Earth)",
                });
            }
            let falls = storey_falls(&floors, &storeys, gravity_m_s2)?;
            if let Some(first) = StoreyFall::first(&falls)
                && first.load_factor <= 1.0
            {
                return Err(BuildingError::Falls {
                    storey: first.storey,
                    motion: first.motion().name(),
                    load_factor: first.load_factor,
                });
            }
        }
        Ok(Building {
            floors,
            storeys,
            p_delta,
        })
    }

    /// The floors, lowest first.
    pub fn floors(&self) -> &[Floor] {
        &self.floors
    }

    /// The storeys, lowest first.
    pub fn storeys(&self) -> &[Storey] {
        &self.storeys
    }

    /// Whether the weight reduces the stiffness (P-delta).
    pub fn p_delta(&self) -> PDelta {
        self.p_delta
    }

    /// Number of coordinates: three for each floor.
    pub fn coordinates(&self) -> usize {
        3 * self.floors.len()
    }

    /// Height of each floor above the ground, m.
    pub fn floor_heights_m(&self) -> Vec<f64> {
        let heights = self.storeys.iter().scan(0.0, |above, storey| {
            *above += storey.height_m;
            Some(*above)
        });
        heights.collect()
    }

    /// Total mass, kg.
    pub fn mass_kg(&self) -> f64 {
        self.floors.iter().map(|floor| floor.mass_kg).sum()
    }

    /// Centre of the total mass in plan, m.
    pub fn centre_of_mass_m(&self) -> [f64; 2] {
        let total = self.mass_kg();
        let first = self.floors[0].centre_m;
        [0, 1].map(|axis| {
            let moment = self
                .floors
                .iter()
                .map(|floor| floor.mass_kg * (floor.centre_m[axis] - first[axis]));
            first[axis] + moment.sum::<f64>() / total
        })
    }
}
