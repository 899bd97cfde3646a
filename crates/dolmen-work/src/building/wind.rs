//! A building in the wind of its file, in time: means, standard deviations and peaks, without its dampers and with them.

use super::StandingBuilding;
use super::wind_answer::{BuildingWind, FloorInWind, FloorMet, WIND_DURATION_S, WindAlong, WindMotion};
use crate::error::WorkError;
use crate::told::told_both;
use dolmen::damper::{AttachedDamper, DamperError, GustMotion, GustPeak, gust_motion};
use dolmen::dynamics::LinearSystem;
use dolmen::structure::Building;
use dolmen::structure::building::{Outline, PlanDirection};
use dolmen::structure::wind::{COHERENCE_DECAY, GustFace, GustStrip, TurbulenceSpectrum, Wind};
use dolmen_project::{BuildingPart, BuiltDamper, Pick, Project, WindGiven};

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
