//! The check of a building.

use super::accidental::AccidentalTorsion;
use super::simulation::{Against, BeyondRoom};
use super::wind_answer::BuildingWind;
use dolmen::damper::DampedMode;
use dolmen::dynamics::{LeastFavourable, SpectralMode};
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingModes, StoreyFall};
use dolmen_project::{BuiltDamper, StoreyStiffnessPart};
use dolmen_words::message::Both;

/// Smallest share of the mass along x and along y in the modes shown. Our choice: as codes require.
const MASS_SHOWN: f64 = 0.9;
/// Fewest and most modes shown. Our choice: sway in both directions and torsion; one page.
const MODES_SHOWN: [usize; 2] = [3, 12];

/// A building and its check.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingAnswer {
    /// Names of the floors, lowest first.
    pub floors: Vec<String>,
    /// The building without P-delta.
    pub elastic: Building,
    /// The fall of each storey and its factor on the weight, lowest first.
    pub falls: Vec<StoreyFall>,
    /// Results for a building that stands.
    pub stands: Option<Box<StandingBuilding>>,
}

/// A building that stands.
#[derive(Clone, Debug, PartialEq)]
pub struct StandingBuilding {
    /// With P-delta, if the file includes it.
    pub building: Building,
    /// Its modes without dampers.
    pub modes: BuildingModes,
    /// Damping ratio of each.
    pub damping_ratios: Vec<f64>,
    /// Dampers of the file, with all numbers computed.
    pub dampers: Vec<BuiltDamper>,
    /// Modes of building and dampers together, as a survey measures them; empty without dampers.
    pub damped_modes: Vec<DampedMode>,
    /// Response to the spectrum of its site, without dampers; `None` without a site.
    pub spectral: Option<BuildingSpectral>,
    /// Why there is no response although there is a site.
    pub spectral_refused: Option<String>,
    /// Response to that spectrum with the dampers; `None` without dampers or site.
    pub damped: Option<DampedSpectral>,
    /// Why there is no response although there are dampers and a site.
    pub damped_refused: Option<String>,
    /// Accidental torsion in the response that is compared with the limits.
    pub accidental: AccidentalTorsion,
    /// Response to the wind of the file; `None` without a wind.
    pub wind: Option<Box<BuildingWind>>,
    /// Why there is no response although there is a wind.
    pub wind_refused: Option<Both>,
}

/// Largest responses of a building with its dampers to the spectrum of the site: complex modes by CQC, shaking along x and y by the square root
/// of the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub struct DampedSpectral {
    /// The complex modes in the spectrum.
    pub modes: Vec<SpectralMode>,
    /// Shear in the walls of the lowest storey along x and y, N.
    pub base_shear_n: [f64; 2],
    /// Their torque about the vertical through the centre of all mass, N·m.
    pub base_torque_n_m: f64,
    /// Displacement of the centre of mass of each floor along x and y, m.
    pub displacement_m: Vec<[f64; 2]>,
    /// Largest drift of each storey at an edge of its floor along x and y, m; `None` without an outline.
    pub edge_drift_m: Vec<Option<[f64; 2]>>,
    /// The same at the centre of mass of the floor above.
    pub centre_drift_m: Vec<[f64; 2]>,
    /// Displacement of the points of the file along x and y, m.
    pub points_m: Vec<(String, [f64; 2])>,
    /// Largest stroke of each damper, m, then of the liquids of columns on springs.
    pub strokes_m: Vec<f64>,
}

impl StandingBuilding {
    /// Drift of each storey along x and y that is compared with its limit, m: at the edges of its floor, or at the centre of mass without an
    /// outline; with the dampers if there are any; the largest with and without accidental torsion. `None` without a response.
    pub fn judged_drift_m(&self) -> Option<Vec<[f64; 2]>> {
        let (edges, centres) = match (&self.damped, &self.spectral) {
            (Some(damped), _) => (&damped.edge_drift_m, &damped.centre_drift_m),
            (None, Some(alone)) if self.dampers.is_empty() => (&alone.edge_drift_m, &alone.centre_drift_m),
            _ => return None,
        };
        let each = edges.iter().zip(centres).enumerate();
        let drift = each.map(|(i, (edge, centre))| {
            let cases = self.accidental.included().into_iter().flat_map(|of| &of.cases);
            cases.fold(edge.unwrap_or(*centre), |[x, y], case| {
                let [own_x, own_y] = case.edge_drift_m[i];
                [x.max(own_x), y.max(own_y)]
            })
        });
        Some(drift.collect())
    }

    /// Stroke of each damper that is compared with its room, m: the largest with and without accidental torsion; empty without dampers or site.
    pub fn judged_strokes_m(&self) -> Vec<f64> {
        let Some(damped) = &self.damped else {
            return Vec::new();
        };
        let each = damped.strokes_m.iter().enumerate();
        let stroke = each.map(|(i, own)| {
            let cases = self.accidental.included().into_iter().flat_map(|of| &of.cases);
            cases.fold(*own, |most, case| most.max(case.strokes_m[i]))
        });
        stroke.collect()
    }

    /// Dampers whose stroke under the spectrum exceeds their room.
    pub fn beyond_room(&self) -> Vec<BeyondRoom> {
        BeyondRoom::of(&self.dampers, self.judged_strokes_m().into_iter())
    }

    /// Ratios of the response with dampers to that without, under the spectrum of the site, each along x and y: base shear, top, largest drift
    /// of a storey at its edges, points. Leaves out a quantity whose value without dampers is below a thousandth of the largest of its kind.
    /// Empty without dampers or site.
    pub fn against_without(&self) -> Vec<Against> {
        const HARDLY: f64 = 1e-3;
        let (Some(without), Some(with)) = (&self.spectral, &self.damped) else {
            return Vec::new();
        };
        let most = |drifts: &[Option<[f64; 2]>]| {
            let each = drifts.iter().zip(self.building.storeys());
            each.filter_map(|(drift, storey)| drift.map(|drift| drift.map(|m| m / storey.height_m)))
                .fold([0.0_f64; 2], |[x, y], [own_x, own_y]| {
                    [x.max(own_x), y.max(own_y)]
                })
        };
        let top = |moved: &[[f64; 2]]| moved.last().copied().unwrap_or_default();
        let [.., shear_n] = without.base_shear_n;
        let mut kinds = vec![
            (
                ["the base shear", "밑면 전단력"].map(str::to_owned),
                with.base_shear_n,
                shear_n,
            ),
            (
                ["the top", "최상층"].map(str::to_owned),
                top(&with.displacement_m),
                top(&without.displacement_m),
            ),
            (
                ["the largest drift at an edge", "최대 단부 층간변위"].map(str::to_owned),
                most(&with.edge_drift_m),
                most(&without.edge_drift_m),
            ),
        ];
        let points = with.points_m.iter().zip(&without.points_m);
        kinds.extend(points.map(|((name, with), (_, without))| {
            ([format!("point {name}"), format!("지점 {name}")], *with, *without)
        }));
        let mut all = Vec::new();
        // an arm of less than a millimetre gives no meaningful torque
        if without.base_torque_n_m > HARDLY * shear_n[0].max(shear_n[1]) {
            all.push(Against {
                what: ["the base torque", "밑면 비틀림 모멘트"].map(str::to_owned),
                ratio: with.base_torque_n_m / without.base_torque_n_m,
            });
        }
        for ([english, korean], with, without) in kinds {
            let largest = without[0].max(without[1]);
            for (axis, name) in ["x", "y"].into_iter().enumerate() {
                if without[axis] > HARDLY * largest {
                    all.push(Against {
                        what: [format!("{english} along {name}"), format!("{korean} {name} 방향")],
                        ratio: with[axis] / without[axis],
                    });
                }
            }
        }
        all
    }
}

/// Ratio of the weaker horizontal component to the stronger: 0.5 to 0.85 in Menun & Der Kiureghian (1998); the largest is used.
pub const MINOR_RATIO: f64 = 0.85;

/// Largest responses to the spectrum of the site, modes combined by CQC, shaking along x and y by the square root of the sum of squares.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingSpectral {
    /// The modes in the spectrum.
    pub modes: Vec<SpectralMode>,
    /// Shear in the walls of the lowest storey along x and y, N: modes by absolute sum, SRSS, CQC.
    pub base_shear_n: [[f64; 2]; 3],
    /// Their torque about the vertical through the centre of all mass, N·m.
    pub base_torque_n_m: f64,
    /// The base shear along x and y in the least favourable direction of shaking, with the weaker component [`MINOR_RATIO`] times the stronger.
    pub least_favourable: [LeastFavourable; 2],
    /// Displacement of the centre of mass of each floor along x and y, m.
    pub displacement_m: Vec<[f64; 2]>,
    /// Largest drift of each storey at an edge of its floor along x and y, m; `None` without an outline.
    pub edge_drift_m: Vec<Option<[f64; 2]>>,
    /// The same at the centre of mass of the floor above.
    pub centre_drift_m: Vec<[f64; 2]>,
    /// Displacement of the points of the file along x and y, m.
    pub points_m: Vec<(String, [f64; 2])>,
}

impl BuildingAnswer {
    /// Smallest factor on the weight at which a storey falls.
    pub fn load_factor(&self) -> f64 {
        StoreyFall::first(&self.falls).map_or(f64::NAN, |first| first.load_factor)
    }
}

impl StandingBuilding {
    /// Number of modes shown, from the lowest.
    pub fn shown(&self) -> usize {
        let mut sums = [0.0; 2];
        let modes = &self.modes;
        let enough = modes.modes.iter().position(|mode| {
            (0..2).for_each(|axis| sums[axis] += mode.effective_mass[axis] / modes.total_mass[axis]);
            sums.iter().all(|sum| *sum >= MASS_SHOWN)
        });
        let wanted = enough.map_or(modes.modes.len(), |last| last + 1);
        wanted
            .clamp(MODES_SHOWN[0], MODES_SHOWN[1])
            .min(modes.modes.len())
    }
}

/// The form in which the stiffness of a storey is given.
pub fn stiffness_word(part: &StoreyStiffnessPart) -> &'static str {
    match part {
        StoreyStiffnessPart::Walls(_) => "walls",
        StoreyStiffnessPart::Whole { .. } => "whole",
        StoreyStiffnessPart::Matrix { .. } => "matrix",
    }
}
