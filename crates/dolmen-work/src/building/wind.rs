//! A building in the wind of its file, in time: means, standard deviations and peaks, without its dampers and with them.

use super::StandingBuilding;
use super::simulation::BeyondRoom;
use crate::error::WorkError;
use crate::told::told_both;
use dolmen::damper::{AttachedDamper, DamperError, GustMotion, GustPeak, gust_motion};
use dolmen::dynamics::LinearSystem;
use dolmen::structure::Building;
use dolmen::structure::building::{Outline, PlanDirection};
use dolmen::structure::wind::{COHERENCE_DECAY, GustFace, GustStrip, Turbulence, TurbulenceSpectrum, Wind};
use dolmen_project::{BuildingPart, BuiltDamper, Pick, Project, WindGiven};

/// The ten minutes of the mean, s.
pub const WIND_DURATION_S: f64 = 600.0;

/// A building in the wind, blowing along x and along y.
#[derive(Clone, Debug, PartialEq)]
pub struct BuildingWind {
    /// The spectrum of its gusts.
    pub spectrum: TurbulenceSpectrum,
    /// How far off the middle of the breadth it acts, over the breadth, either side.
    pub eccentricity: f64,
    /// Largest peak acceleration of the top floor that is allowed, m/s².
    pub acceleration_limit_m_s2: Option<f64>,
    /// Largest drift of a storey that is allowed, over its height.
    pub drift_limit: Option<f64>,
    /// Along x, along y.
    pub along: [WindAlong; 2],
}

/// The wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct WindAlong {
    /// What meets each floor, lowest first.
    pub met: Vec<FloorMet>,
    /// Without dampers.
    pub without: WindMotion,
    /// With the dampers of the file, if it has any.
    pub with: Option<WindMotion>,
}

/// The wind that meets a floor.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FloorMet {
    /// Height of the middle of what the floor takes, m.
    pub height_m: f64,
    /// The wind there.
    pub wind: Turbulence,
    /// Breadth across the wind, m.
    pub breadth_m: f64,
    /// Mean force on the floor, N.
    pub mean_force_n: f64,
}

/// How the building moves in the wind from one side.
#[derive(Clone, Debug, PartialEq)]
pub struct WindMotion {
    /// Each floor, lowest first.
    pub floors: Vec<FloorInWind>,
    /// Shear along the wind in the walls of the lowest storey, N, the wind at the middle of the breadth.
    pub base_shear_n: GustPeak,
    /// Their torque about the vertical through the centre of all mass, N m, the worst of both eccentricities.
    pub base_torque_n_m: GustPeak,
    /// Stroke of each damper, m, then of the liquids of columns on springs: the worst of both eccentricities.
    pub strokes_m: Vec<GustPeak>,
    /// Frequencies of the integral.
    pub frequencies: usize,
}

/// A floor in the wind. Where nothing else is said, the wind acts at the middle of the breadth.
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
    /// With the dampers if there are any, else without.
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

    /// The largest peak acceleration of the top floor, m/s², and the wind it is under, 0 along x and 1 along y.
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
    /// With the dampers if there are any, else without.
    pub fn as_it_is(&self) -> &WindMotion {
        self.with.as_ref().unwrap_or(&self.without)
    }
}

/// Adds what the wind of the file does, if it gives one and the building stands.
pub(crate) fn add_wind(
    standing: &mut StandingBuilding,
    project: &Project,
    part: &BuildingPart,
    pick: Pick<'_>,
) -> Result<(), WorkError> {
    let Some(given) = project.loads.wind() else {
        return Ok(());
    };
    match in_wind(standing, part, given, pick) {
        Ok(wind) => standing.wind = Some(Box::new(wind)),
        Err(WorkError::Damper(why)) => standing.wind_refused = Some(told_both(&why)),
        Err(other) => return Err(other),
    }
    Ok(())
}

fn in_wind(
    standing: &StandingBuilding,
    part: &BuildingPart,
    given: &WindGiven,
    pick: Pick<'_>,
) -> Result<BuildingWind, WorkError> {
    let building = &standing.building;
    let wind = given.build(pick);
    let coefficient = pick(&given.force_coefficient);
    let acceleration_limit = given.in_time.acceleration_limit.as_ref();
    let structure = LinearSystem::new(
        building.mass_matrix(),
        building.damping_matrix(&part.damping(pick))?,
        building.stiffness_matrix(),
    )?;
    let spectrum = given.in_time.spectrum.unwrap_or(wind.own_spectrum());
    let blown = Blown {
        building,
        structure,
        dampers: standing.dampers.iter().map(BuiltDamper::attached).collect(),
        eccentricity: given.in_time.eccentricity,
    };
    let along = |axis: usize| blown.along(axis, face(building, &wind, (spectrum, coefficient), axis)?);
    Ok(BuildingWind {
        spectrum,
        eccentricity: given.in_time.eccentricity,
        acceleration_limit_m_s2: acceleration_limit.map(pick),
        drift_limit: given.in_time.drift_limit,
        along: [along(0)?, along(1)?],
    })
}

/// Least and most of an outline across the wind along x (0) or y (1), m.
fn extent_m(outline: Option<&Outline>, axis: usize) -> [f64; 2] {
    let corners = outline.iter().flat_map(|outline| outline.corners_m());
    let across = corners.map(|corner| corner[1 - axis]);
    across.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
        [least.min(at), most.max(at)]
    })
}

/// What meets the floors: each takes half the storey below it and half the storey above it.
pub(crate) fn face(
    building: &Building,
    wind: &Wind,
    (spectrum, force_coefficient): (TurbulenceSpectrum, f64),
    axis: usize,
) -> Result<GustFace, DamperError> {
    let heights = building.floor_heights_m();
    let storeys = building.storeys();
    let each = building.floors().iter().enumerate();
    let strips = each.map(|(i, floor)| {
        let [least, most] = extent_m(floor.outline.as_ref(), axis);
        let bottom_m = heights[i] - 0.5 * storeys[i].height_m;
        let top_m = heights[i] + storeys.get(i + 1).map_or(0.0, |above| 0.5 * above.height_m);
        Ok(GustStrip {
            bottom_m,
            top_m,
            breadth_m: most - least,
            force_coefficient,
            wind: wind.turbulence_at(0.5 * (bottom_m + top_m))?,
        })
    });
    Ok(GustFace {
        strips: strips.collect::<Result<_, DamperError>>()?,
        air_density_kg_m3: wind.air_density_kg_m3().unwrap_or(f64::NAN),
        spectrum,
        coherence_decay: COHERENCE_DECAY,
    })
}

/// What a force on each floor along x (0) or y (1) does, acting off the middle of the breadth by this part of it.
pub(crate) fn columns(building: &Building, axis: usize, eccentricity: f64) -> Vec<Vec<f64>> {
    let each = building.floors().iter().enumerate();
    let column = |(i, floor): (usize, &dolmen::structure::building::Floor)| {
        let [least, most] = extent_m(floor.outline.as_ref(), axis);
        let at = 0.5 * (least + most) + eccentricity * (most - least);
        let arm = at - floor.centre_m[1 - axis];
        let mut column = vec![0.0; building.coordinates()];
        column[3 * i + axis] = 1.0;
        // u − (y − y_c) θ and v + (x − x_c) θ
        column[3 * i + 2] = if axis == 0 { -arm } else { arm };
        column
    };
    each.map(column).collect()
}

struct Blown<'a> {
    building: &'a Building,
    structure: LinearSystem,
    dampers: Vec<AttachedDamper>,
    eccentricity: f64,
}

impl Blown<'_> {
    fn along(&self, axis: usize, face: GustFace) -> Result<WindAlong, WorkError> {
        let forces = face.mean_forces_n();
        let met = face
            .strips
            .iter()
            .zip(forces)
            .map(|(strip, mean_force_n)| FloorMet {
                height_m: 0.5 * (strip.bottom_m + strip.top_m),
                wind: strip.wind,
                breadth_m: strip.breadth_m,
                mean_force_n,
            });
        Ok(WindAlong {
            met: met.collect(),
            without: self.motion(axis, &face, &[])?,
            with: match self.dampers.is_empty() {
                true => None,
                false => Some(self.motion(axis, &face, &self.dampers)?),
            },
        })
    }

    fn motion(
        &self,
        axis: usize,
        face: &GustFace,
        dampers: &[AttachedDamper],
    ) -> Result<WindMotion, WorkError> {
        let offsets = match self.eccentricity > 0.0 {
            true => vec![0.0, self.eccentricity, -self.eccentricity],
            false => vec![0.0],
        };
        let columns: Vec<Vec<Vec<f64>>> = offsets
            .iter()
            .map(|offset| columns(self.building, axis, *offset))
            .collect();
        let all = gust_motion(&self.structure, dampers, face, &columns, WIND_DURATION_S)?;
        let middle = &all[0];
        let [shear_x, shear_y, torque] = self.building.base_rows();
        let shear = if axis == 0 { shear_x } else { shear_y };
        let strokes = (0..middle.strokes.len()).map(|k| worst(all.iter().map(|of| of.strokes[k])));
        let floors = (0..self.building.floors().len()).map(|i| self.floor(i, axis, &all));
        Ok(WindMotion {
            floors: floors.collect::<Result<_, WorkError>>()?,
            base_shear_n: middle.displacement(&shear),
            base_torque_n_m: worst(all.iter().map(|of| of.displacement(&torque))),
            strokes_m: strokes.collect(),
            frequencies: middle.frequencies,
        })
    }

    fn floor(&self, i: usize, axis: usize, all: &[GustMotion]) -> Result<FloorInWind, WorkError> {
        let (building, middle) = (self.building, &all[0]);
        let unit = |k: usize| {
            let mut row = vec![0.0; building.coordinates()];
            row[3 * i + k] = 1.0;
            row
        };
        let edges = building.edge_drift_rows(i + 1)?.into_iter().flatten();
        let edges: Vec<Vec<f64>> = edges.skip(2 * axis).take(2).collect();
        let corners = building.floors()[i].outline.iter().flat_map(Outline::corners_m);
        let mut corner_rows = Vec::new();
        for [x_m, y_m] in corners {
            let row = |direction| building.point_row(i + 1, *x_m, *y_m, direction);
            corner_rows.push([row(PlanDirection::X)?, row(PlanDirection::Y)?]);
        }
        Ok(FloorInWind {
            displacement_m: middle.displacement(&unit(axis)),
            drift_m: worst(
                edges
                    .iter()
                    .flat_map(|row| all.iter().map(|of| of.displacement(row))),
            ),
            acceleration_m_s2: middle.acceleration(&unit(axis)),
            across_m_s2: middle.acceleration(&unit(1 - axis)),
            rotation_rad_s2: middle.acceleration(&unit(2)),
            corner_m_s2: worst(
                corner_rows
                    .iter()
                    .flat_map(|[x, y]| all.iter().map(|of| of.largest_acceleration([x, y]))),
            ),
        })
    }
}

/// That with the largest peak.
fn worst(all: impl Iterator<Item = GustPeak>) -> GustPeak {
    all.max_by(|a, b| a.peak().total_cmp(&b.peak()))
        .unwrap_or_default()
}
