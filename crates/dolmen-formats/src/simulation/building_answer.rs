//! What `dolmen simulate` found of a building, with what went in.

use super::MotionAnswer;
use crate::project::{BuiltDamper, Names};
use dolmen::dynamics::{BuildingHistory, VibratingBuilding};

/// A point of a floor that is watched.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedPoint {
    /// Its name.
    pub name: String,
    /// Its floor, from 1.
    pub floor: usize,
    /// Its place in plan, m.
    pub place_m: [f64; 2],
    /// Displacement along x and y at every step, m.
    pub displacement_m: [Vec<f64>; 2],
}

/// A simulation of a building, and its inputs.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingSimulation {
    /// The project file, as it was named.
    pub file: String,
    /// Name of the structure.
    pub name: Names,
    /// The variant of the file; `None` for the structure as given.
    pub variant: Option<String>,
    /// A longer name of the variant, if the file gives one.
    pub variant_title: Option<Names>,
    /// Names of the floors, lowest first.
    pub floors: Vec<String>,
    /// The building with its dampers.
    pub building: VibratingBuilding,
    /// The dampers.
    pub dampers: Vec<BuiltDamper>,
    /// The motion of the ground.
    pub motion: MotionAnswer,
    /// What happened.
    pub history: BuildingHistory,
    /// The same without the dampers; `None` if there are none.
    pub without_dampers: Option<Box<BuildingHistory>>,
    /// Points of the file.
    pub points: Vec<WatchedPoint>,
}

impl BuildingSimulation {
    /// Largest drift of all storeys at an edge over the height of the storey: the storey, from 1, and the ratio.
    pub fn drift_ratio(&self) -> (usize, f64) {
        let storeys = self.building.building().storeys();
        let each = self.history.peaks.storeys.iter().zip(storeys).enumerate();
        let ratios = each.map(|(i, (peak, storey))| {
            let drift = peak
                .edge_drift_x_m
                .value
                .abs()
                .max(peak.edge_drift_y_m.value.abs());
            (i + 1, drift / storey.height_m)
        });
        ratios.fold((0, 0.0), |most, own| if own.1 > most.1 { own } else { most })
    }
}
