//! The answer of `dolmen sensors`.

use super::sites::Site;
use dolmen_project::Project;
use std::sync::Arc;

/// A mode to be measured.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedMode {
    /// Frequency of the model, Hz; `None` where only the shape is known.
    pub frequency_hz: Option<f64>,
    /// The direction of a frame, or of a chain with two; `None` for other kinds.
    pub direction: Option<String>,
    /// Shares of its kinetic energy in motion along x, y and z; the rest is rotation. `None` for a mode in a plane.
    pub along: Option<[f64; 3]>,
    /// The largest displacement at a channel, relative to that at any site.
    pub seen_ratio: f64,
    /// The most similar mode at the sensors, from 0, and its MAC.
    pub most_alike: Option<(usize, f64)>,
}

/// Share of its largest motion below which a mode is hardly measured: a channel at the right place would have five times the signal. Chosen
/// here.
const SEEN_LEAST: f64 = 0.2;
/// MAC above which two shapes are the same (Pastor, Binda & Harčarik 2012): these sensors cannot distinguish the modes.
const ALIKE_FROM: f64 = 0.9;

impl PlannedMode {
    /// Whether the mode hardly moves at the sensors.
    pub fn is_hardly_seen(&self) -> bool {
        self.seen_ratio < SEEN_LEAST
    }

    /// The mode with the same shape at these sensors.
    pub fn taken_for(&self) -> Option<(usize, f64)> {
        self.most_alike
            .filter(|(_, alike)| *alike >= ALIKE_FROM && !self.is_hardly_seen())
    }
}

/// A planned sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedSensor {
    /// Its site.
    pub site: Site,
    /// Its setup, from 0; `None` for a reference sensor, which stays.
    pub setup: Option<usize>,
}

/// The stiffness behind the shapes of the modes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorsOf {
    /// Stiffness that the file gives.
    Given,
    /// Joints of equal stiffness, twice what stability needs, because the file gives none.
    EqualJoints,
    /// Storeys of equal stiffness in some direction, because the file gives none.
    EqualStoreys,
}

/// The best places of sensors.
#[derive(Clone, Debug)]
pub struct SensorsAnswer {
    /// The project file.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The modes to be measured, lowest first.
    pub modes: Vec<PlannedMode>,
    /// Number of candidate sites.
    pub sites: usize,
    /// Number of axes of each sensor.
    pub axes: usize,
    /// No sensor is higher than this above the ground, m.
    pub up_to_m: Option<f64>,
    /// Number of setups.
    pub setups: usize,
    /// The sensors: for one setup the most informative first; for several the reference sensors, then setup by setup.
    pub sensors: Vec<PlannedSensor>,
    /// The stiffness behind the shapes.
    pub of: SensorsOf,
    /// MAC of each pair of modes at all sensors.
    pub likeness: Vec<Vec<f64>>,
    /// Dampers of the structure, which the mode shapes do not include.
    pub without_dampers: Vec<String>,
}
