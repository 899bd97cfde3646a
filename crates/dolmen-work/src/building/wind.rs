//! A building in the wind of its file: means, standard deviations and peaks, with and without its dampers.

use super::StandingBuilding;
use super::wind_answer::{BuildingWind, FloorInWind, FloorMet, WIND_DURATION_S, WindAlong, WindMotion};
use super::wind_rows::{WindRows, largest, worst};
use crate::error::WorkError;
use crate::told::told_both;
use dolmen::assess::demand::DriftLimit;
use dolmen::damper::{AttachedDamper, DamperError, gust_motion};
use dolmen::dynamics::LinearSystem;
use dolmen::structure::Building;
use dolmen::structure::building::Outline;
use dolmen::structure::wind::{COHERENCE_DECAY, GustFace, GustStrip, TurbulenceSpectrum, Wind};
use dolmen_project::{BuildingPart, BuiltDamper, Pick, Project, WindGiven};

/// Adds the response to the wind of the file, if there is one and the building stands.
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
        Ok(mut wind) => {
            let drift = wind.largest_drift(&standing.building).map(|(.., drift)| drift);
            wind.drift_limit = wind_drift_limit(project, wind.drift_limit, drift);
            standing.wind = Some(Box::new(wind));
        }
        Err(WorkError::Damper(why)) => standing.wind_refused = Some(told_both(&why)),
        Err(other) => return Err(other),
    }
    Ok(())
}

/// The drift limit of a storey in the wind: that of the wind in the file, or otherwise the allowable drift of `[limits]`. The latter is
/// meant for earthquakes, so only a drift above it is a finding.
pub(crate) fn wind_drift_limit(project: &Project, of_wind: Option<f64>, drift: Option<f64>) -> Option<f64> {
    let allowed = project.drift_limit.as_ref().map(DriftLimit::ratio);
    let passed = allowed.filter(|allowed| drift.is_some_and(|drift| drift > *allowed));
    of_wind.or(passed)
}

fn in_wind(
    standing: &StandingBuilding,
    part: &BuildingPart,
    given: &WindGiven,
    pick: Pick<'_>,
) -> Result<BuildingWind, WorkError> {
    let acceleration_limit = given.in_time.acceleration_limit.as_ref();
    let blown = BuildingInWind::new((&standing.building, &standing.dampers), part, given, pick)?;
    let along = |axis: usize| blown.along(axis);
    Ok(BuildingWind {
        spectrum: blown.spectrum,
        eccentricity: blown.eccentricity,
        acceleration_limit_m_s2: acceleration_limit.map(pick),
        drift_limit: given.in_time.drift_limit,
        along: [along(0)?, along(1)?],
    })
}

/// Smallest and largest coordinates of an outline across the wind along x (0) or y (1), m.
fn extent_m(outline: Option<&Outline>, axis: usize) -> [f64; 2] {
    let corners = outline.iter().flat_map(|outline| outline.corners_m());
    let across = corners.map(|corner| corner[1 - axis]);
    across.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], at| {
        [least.min(at), most.max(at)]
    })
}

/// The wind on each floor, from half the storey below it and half the storey above it.
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

/// Load of a force on each floor along x (0) or y (1), at this fraction of the breadth from its middle.
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

pub(crate) struct BuildingInWind<'a> {
    building: &'a Building,
    pub(crate) structure: LinearSystem,
    pub(crate) dampers: Vec<AttachedDamper>,
    wind: Wind,
    spectrum: TurbulenceSpectrum,
    force_coefficient: f64,
    eccentricity: f64,
}

impl<'a> BuildingInWind<'a> {
    pub(crate) fn new(
        (building, dampers): (&'a Building, &[BuiltDamper]),
        part: &BuildingPart,
        given: &WindGiven,
        pick: Pick<'_>,
    ) -> Result<Self, WorkError> {
        let wind = given.build(pick);
        Ok(BuildingInWind {
            building,
            structure: LinearSystem::new(
                building.mass_matrix(),
                building.damping_matrix(&part.damping(pick))?,
                building.stiffness_matrix(),
            )?,
            dampers: dampers.iter().map(BuiltDamper::attached).collect(),
            spectrum: given.in_time.spectrum.unwrap_or(wind.own_spectrum()),
            wind,
            force_coefficient: pick(&given.force_coefficient),
            eccentricity: given.in_time.eccentricity,
        })
    }

    /// The wind on the floors along x, 0, or y, 1.
    pub(crate) fn face(&self, axis: usize) -> Result<GustFace, DamperError> {
        face(
            self.building,
            &self.wind,
            (self.spectrum, self.force_coefficient),
            axis,
        )
    }

    /// Loads of a force on each floor: at the middle of the breadth, then eccentric to either side.
    pub(crate) fn columns(&self, axis: usize) -> Vec<Vec<Vec<f64>>> {
        let offsets = match self.eccentricity > 0.0 {
            true => vec![0.0, self.eccentricity, -self.eccentricity],
            false => vec![0.0],
        };
        let each = offsets.iter();
        each.map(|offset| columns(self.building, axis, *offset)).collect()
    }

    fn along(&self, axis: usize) -> Result<WindAlong, WorkError> {
        let face = self.face(axis)?;
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
        let columns = self.columns(axis);
        let all = gust_motion(&self.structure, dampers, face, &columns, WIND_DURATION_S)?;
        let rows = WindRows::of(self.building, axis, &all)?;
        let middle = &all[0];
        let strokes = (0..middle.strokes.len()).map(|k| largest(all.iter().map(|of| of.strokes[k])));
        let floors = rows.floors.iter().map(|floor| FloorInWind {
            displacement_m: middle.of(&floor.displacement),
            drift_m: worst(&all, &floor.drift),
            acceleration_m_s2: middle.of(&floor.acceleration),
            across_m_s2: middle.of(&floor.across),
            rotation_rad_s2: middle.of(&floor.rotation),
            corner_m_s2: worst(&all, &floor.corner),
        });
        Ok(WindMotion {
            floors: floors.collect(),
            base_shear_n: middle.of(&rows.base_shear),
            base_torque_n_m: worst(&all, &rows.base_torque),
            strokes_m: strokes.collect(),
            frequencies: middle.frequencies,
        })
    }
}
