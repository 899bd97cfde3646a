//! The response of a building to the wind of the file.

use super::simulation::BeyondRoom;
use dolmen::damper::GustPeak;
use dolmen::structure::Building;
use dolmen::structure::wind::{Turbulence, TurbulenceSpectrum};
use dolmen_project::BuiltDamper;

/// Duration of the mean wind, s.
pub const WIND_DURATION_S: f64 = 600.0;

/// A building in the wind, blowing along x and along y.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingWind {
    /// The spectrum of its gusts.
    pub spectrum: TurbulenceSpectrum,
    /// Distance of the force from the middle of the breadth, relative to the breadth, to either side.
    pub eccentricity: f64,
    /// Largest allowed peak acceleration of the top floor, m/s².
    pub acceleration_limit_m_s2: Option<f64>,
    /// Largest allowed drift ratio of a storey.
    pub drift_limit: Option<f64>,
    /// Along x, along y.
    pub along: [WindAlong; 2],
}

/// The wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct WindAlong {
    /// The wind on each floor, lowest first.
    pub met: Vec<FloorMet>,
    /// Without dampers.
    pub without: WindMotion,
    /// With the dampers of the file, if it has any.
    pub with: Option<WindMotion>,
}

/// The wind on a floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorMet {
    /// Height of the middle of the floor's part of the face, m.
    pub height_m: f64,
    /// The wind there.
    pub wind: Turbulence,
    /// Breadth across the wind, m.
    pub breadth_m: f64,
    /// Mean force on the floor, N.
    pub mean_force_n: f64,
}

/// The motion of the building in the wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct WindMotion {
    /// Each floor, lowest first.
    pub floors: Vec<FloorInWind>,
    /// Shear along the wind in the walls of the lowest storey, N, with the wind at the middle of the breadth.
    pub base_shear_n: GustPeak,
    /// Their torque about the vertical through the centre of all mass, N m, the worst of both eccentricities.
    pub base_torque_n_m: GustPeak,
    /// Stroke of each damper, m, then of the liquids of columns on springs: the worst of both eccentricities.
    pub strokes_m: Vec<GustPeak>,
    /// Number of frequencies of the integral.
    pub frequencies: usize,
}

/// A floor in the wind. Unless a field says otherwise, the wind acts at the middle of the breadth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorInWind {
    /// Displacement of its centre of mass along the wind, m.
    pub displacement_m: GustPeak,
    /// Drift along the wind of the storey below it, m, at the worse edge, the worst of both eccentricities.
    pub drift_m: GustPeak,
    /// Acceleration of its centre of mass along the wind, m/s².
    pub acceleration_m_s2: GustPeak,
    /// The same across the wind.
    pub across_m_s2: GustPeak,
    /// Acceleration of its rotation, rad/s².
    pub rotation_rad_s2: GustPeak,
    /// Acceleration at its worst corner in the worst direction, m/s², the worst of both eccentricities.
    pub corner_m_s2: GustPeak,
}

impl BuildingWind {
    /// With the dampers if there are any, otherwise without.
    pub fn motions(&self) -> [&WindMotion; 2] {
        self.along.each_ref().map(WindAlong::as_it_is)
    }

    /// The same with its dampers left out.
    pub fn without_dampers(&self) -> Self {
        let along = |of: &WindAlong| WindAlong {
            with: None,
            ..of.clone()
        };
        BuildingWind {
            along: self.along.each_ref().map(along),
            ..self.clone()
        }
    }

    /// The largest peak acceleration of the top floor, m/s², and its wind, 0 along x and 1 along y.
    pub fn top_acceleration(&self) -> Option<(usize, GustPeak)> {
        let each = self.motions().into_iter().enumerate();
        let tops = each.filter_map(|(axis, motion)| Some((axis, motion.floors.last()?.corner_m_s2)));
        tops.max_by(|a, b| a.1.peak().total_cmp(&b.1.peak()))
    }

    /// The largest peak drift of a storey over its height: the wind, the storey from 0, the ratio.
    pub fn largest_drift(&self, building: &Building) -> Option<(usize, usize, f64)> {
        let each = self.motions().into_iter().enumerate();
        let ratios = each.flat_map(|(axis, motion)| {
            let storeys = motion.floors.iter().zip(building.storeys()).enumerate();
            storeys.map(move |(i, (floor, storey))| (axis, i, floor.drift_m.peak() / storey.height_m))
        });
        ratios.max_by(|a, b| a.2.total_cmp(&b.2))
    }

    /// The largest peak of each stroke, m.
    pub fn strokes_m(&self) -> Vec<f64> {
        let [x, y] = self.motions();
        let pairs = x.strokes_m.iter().zip(&y.strokes_m);
        pairs.map(|(x, y)| x.peak().max(y.peak())).collect()
    }

    /// Dampers that need more room in this wind than they have.
    pub fn beyond_room(&self, dampers: &[BuiltDamper]) -> Vec<BeyondRoom> {
        BeyondRoom::of(dampers, self.strokes_m().into_iter())
    }
}

impl WindAlong {
    /// Breadth across the wind, the mean over the floors, m.
    pub fn breadth_m(&self) -> f64 {
        let sum: f64 = self.met.iter().map(|met| met.breadth_m).sum();
        sum / self.met.len() as f64
    }

    /// With the dampers if there are any, otherwise without.
    pub fn as_it_is(&self) -> &WindMotion {
        self.with.as_ref().unwrap_or(&self.without)
    }
}
