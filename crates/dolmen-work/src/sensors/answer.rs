//! What `dolmen sensors` answers.

use super::sites::Site;
use dolmen_project::Project;
use std::sync::Arc;

/// A mode that the sensors shall see.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedMode {
    /// Frequency of the model, Hz; `None` where only the shape is known.
    pub frequency_hz: Option<f64>,
    /// The direction of a frame; `None` of others.
    pub direction: Option<String>,
    /// The parts of its kinetic energy in motion along x, y and z, what is left turns; `None` of a mode in a plane.
    pub along: Option<[f64; 3]>,
    /// The largest displacement at a channel over that at any site.
    pub seen_ratio: f64,
    /// The mode most like it at the sensors, from 0, and how alike (MAC).
    pub most_alike: Option<(usize, f64)>,
}

/// Below this share of its largest motion a mode is hardly seen: a channel at the right place would have five times the signal. Chosen here.
const SEEN_LEAST: f64 = 0.2;
/// From this MAC two shapes count as one (Pastor, Binda & Harčarik 2012): at these sensors the modes cannot be told apart.
const ALIKE_FROM: f64 = 0.9;

impl PlannedMode {
    /// Whether the sensors stand where it hardly moves.
    pub fn is_hardly_seen(&self) -> bool {
        self.seen_ratio < SEEN_LEAST
    }

    /// The mode that it is taken for at these sensors.
    pub fn taken_for(&self) -> Option<(usize, f64)> {
        self.most_alike
            .filter(|(_, alike)| *alike >= ALIKE_FROM && !self.is_hardly_seen())
    }
}

/// A sensor where it shall stand.
#[derive(Clone, Debug, PartialEq)]
pub struct PlannedSensor {
    /// Where.
    pub site: Site,
    /// The setup in which it stands there, from 0; `None`: it stays.
    pub setup: Option<usize>,
}

/// What the shapes of the modes rest on.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum SensorsOf {
    /// Stiffness that the file gives.
    Given,
    /// Joints of equal stiffness, twice what stability needs: the file gives none.
    EqualJoints,
    /// Storeys of equal stiffness in some direction: the file gives none.
    EqualStoreys,
}

/// Where sensors stand best.
#[derive(Clone, Debug)]
pub struct SensorsAnswer {
    /// The project file.
    pub file: String,
    /// The project.
    pub project: Arc<Project>,
    /// The modes that they shall see, lowest first.
    pub modes: Vec<PlannedMode>,
    /// Sites that were looked at.
    pub sites: usize,
    /// Axes of each sensor.
    pub axes: usize,
    /// No sensor is higher than this above the ground, m.
    pub up_to_m: Option<f64>,
    /// Setups.
    pub setups: usize,
    /// The sensors: of one setup the one that says most first; of several those that stay, then setup by setup.
    pub sensors: Vec<PlannedSensor>,
    /// What the shapes rest on.
    pub of: SensorsOf,
    /// How alike each two modes are at all sensors (MAC).
    pub likeness: Vec<Vec<f64>>,
    /// Dampers of the structure: the shapes are those without them.
    pub without_dampers: Vec<String>,
}
