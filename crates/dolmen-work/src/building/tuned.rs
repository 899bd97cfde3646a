//! A building as a structure for dampers.

use super::tune_answer::{TuneLoad, TunePoint};
use super::wind::{columns, face};
use crate::error::WorkError;
use dolmen::damper::{DamperError, DamperKind, DamperSite, Goal, PlacedDamper};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum, VibratingBuilding};
use dolmen::structure::building::{Building, PlanDirection};
use dolmen_project::{BuildingPart, BuiltDamper, Project, Quantity, Structure};
use std::f64::consts::TAU;

/// Density of the load, two-sided, unit² s/rad; only ratios are shown.
const DENSITY: f64 = 1.0;
/// Damping of the soil and of the second filter, and ratio of its frequency to the soil's: Clough & Penzien (1975), sec. 28-4.
const GROUND_DAMPING_RATIO: f64 = 0.6;
const FILTER_PART: f64 = 0.1;

/// The floors that `dolmen tune` compares for each damper. The designs stay on the floor of the file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum TuneFloors {
    /// None: only the floor of the file is searched.
    #[default]
    Own,
    /// All floors.
    All,
    /// The floors from one to another, both included, from 1, and that of the file.
    Range {
        /// The lowest.
        from: usize,
        /// The highest.
        to: usize,
    },
}

/// Options of `dolmen tune`.
#[derive(Clone, Debug, PartialEq)]
pub struct TuneOptions {
    /// Name of the damper; by default all dampers.
    pub damper: Option<String>,
    /// Name of the variant; by default the file as it is, or all its variants if the file itself has no dampers.
    pub variant: Option<String>,
    /// The random load.
    pub load: TuneLoad,
    /// Direction of the load, degrees from x counter-clockwise; by default that of the damper.
    pub load_direction_degrees: Option<f64>,
    /// The quantity to minimise.
    pub goal: Goal,
    /// Places of the map along each side of the floor.
    pub map: usize,
    /// Upper bound on the standard deviation of the stroke of designed dampers, relative to that of the damper in the file.
    pub stroke_most: Option<f64>,
    /// Relative error of the frequency that designs tolerate, 0.1 for 10 %.
    pub off_by: f64,
    /// With several dampers: whether to redistribute the sum of their masses.
    pub share_mass: bool,
    /// The floors to compare for each damper.
    pub floors: TuneFloors,
}

impl Default for TuneOptions {
    /// Options for a report: a white-noise force along the damper, a coarse map.
    fn default() -> Self {
        TuneOptions {
            damper: None,
            variant: None,
            load: TuneLoad::Force,
            load_direction_degrees: None,
            goal: Goal::LargestRms,
            map: 24,
            stroke_most: None,
            off_by: 0.0,
            share_mass: false,
            floors: TuneFloors::Own,
        }
    }
}

/// The building of a project.
pub(crate) fn part_of(project: &Project) -> Result<&BuildingPart, WorkError> {
    match &project.structure {
        Structure::Building(part) => Ok(part),
        Structure::Chain(_) | Structure::Frame(_) | Structure::Stack(_) | Structure::Survey => {
            Err(WorkError::TuneOfOther)
        }
    }
}

/// The building as written, which must stand.
pub(crate) fn standing(part: &BuildingPart) -> Result<&VibratingBuilding, WorkError> {
    let Some(building) = part.as_written() else {
        return Err(WorkError::BuildingFallsItself);
    };
    Ok(building)
}

/// A damper whose place can be optimised: a mass or a liquid column.
pub(crate) fn placed(damper: &BuiltDamper, site: usize) -> Option<PlacedDamper> {
    let length_ratio = match damper.kind {
        DamperKind::TunedMass { .. } => 1.0,
        DamperKind::LiquidColumn { length_ratio, .. } => length_ratio,
        DamperKind::LiquidColumnMass { .. } | DamperKind::Viscous { .. } => return None,
    };
    let [frequency_hz, damping_ratio] = damper.own()?;
    Some(PlacedDamper {
        site,
        place_m: damper.place_m,
        direction_degrees: degrees(damper.direction),
        mass_kg: damper.kind.mass_kg(),
        frequency_hz,
        damping_ratio,
        length_ratio,
    })
}

/// A direction in degrees from x, counter-clockwise.
pub(crate) fn degrees(direction: PlanDirection) -> f64 {
    match direction {
        PlanDirection::X => 0.0,
        PlanDirection::Y => 90.0,
        PlanDirection::Degrees(degrees) => degrees,
    }
}

/// The building with its damping, as the structure without dampers.
pub(crate) fn structure(building: &Building, part: &BuildingPart) -> Result<LinearSystem, WorkError> {
    Ok(LinearSystem::new(
        building.mass_matrix(),
        building.damping_matrix(&part.damping(&mut Quantity::nominal))?,
        building.stiffness_matrix(),
    )?)
}

/// A floor as a site for dampers.
pub(crate) fn site(building: &Building, floor: usize) -> Result<DamperSite, WorkError> {
    let own = &building.floors()[floor - 1];
    let Some(outline) = &own.outline else {
        return Err(WorkError::FloorWithoutOutline { floor });
    };
    Ok(DamperSite {
        first_degree_of_freedom: 3 * (floor - 1),
        reference_m: own.centre_m,
        corners_m: outline.corners_m().to_vec(),
    })
}

/// The load along a direction; for the wind of the file several independent forces.
pub(crate) fn random_loads(
    (project, part): (&Project, &BuildingPart),
    load: TuneLoad,
    direction: PlanDirection,
) -> Result<Vec<RandomLoad>, WorkError> {
    let vibrating = standing(part)?;
    if load == TuneLoad::Gusts {
        return gusts(project, vibrating, direction);
    }
    let column = vibrating.building().ground_column(direction);
    Ok(vec![RandomLoad {
        input: match load.is_base() {
            true => RandomInput::Base(column),
            false => RandomInput::Force(column),
        },
        spectrum: spectrum(load),
    }])
}

/// Fraction of the variance of the forces on the floors below which a pattern is left out.
const SHAPE_LEAST: f64 = 2e-3;
/// Smallest share of the mass in a mode along the wind for its frequency to be that of the patterns. Our choice.
const MODE_LEAST: f64 = 0.05;

/// The wind of the file along x or along y, whichever is nearer: the forces on the floors, as patterns that are independent at the
/// frequency of the lowest mode in that direction.
fn gusts(
    project: &Project,
    vibrating: &VibratingBuilding,
    direction: PlanDirection,
) -> Result<Vec<RandomLoad>, WorkError> {
    let Some(given) = project.loads.wind() else {
        return Err(WorkError::TuneWithoutWind);
    };
    let building = vibrating.building();
    let [cos, sin] = direction.unit();
    let axis = usize::from(sin.abs() > cos.abs());
    let wind = given.build(&mut Quantity::nominal);
    let spectrum = given.in_time.spectrum.unwrap_or(wind.own_spectrum());
    let face = face(building, &wind, (spectrum, given.force_coefficient.value), axis)?;
    let modes = vibrating.modes();
    let along = modes
        .modes
        .iter()
        .find(|mode| mode.effective_mass[axis] > MODE_LEAST * modes.total_mass[axis]);
    let frequency_hz = along
        .or(modes.modes.first())
        .map_or(1.0, |mode| mode.frequency_hz);
    let columns = columns(building, axis, 0.0);
    let shapes = face
        .independent_shapes(frequency_hz, SHAPE_LEAST)
        .map_err(DamperError::from)?;
    let each = shapes.into_iter().map(|shape| {
        let mut force = vec![0.0; building.coordinates()];
        for (part, column) in shape.iter().zip(&columns) {
            force.iter_mut().zip(column).for_each(|(sum, a)| *sum += part * a);
        }
        RandomLoad {
            input: RandomInput::Force(force),
            spectrum: Spectrum::Gusts {
                face: Box::new(face.clone()),
                shape,
            },
        }
    });
    Ok(each.collect())
}

/// The points of the file, or the corners of a floor.
pub(crate) fn points(part: &BuildingPart, floor: usize, corners_m: &[[f64; 2]]) -> Vec<TunePoint> {
    if part.points.is_empty() {
        let corners = corners_m.iter();
        return corners
            .map(|corner| TunePoint {
                name: format!("({}, {})", corner[0], corner[1]),
                floor,
                place_m: *corner,
            })
            .collect();
    }
    let each = part.points.iter();
    each.map(|point| TunePoint {
        name: point.name.clone(),
        floor: point.floor,
        place_m: [point.place[0].value, point.place[1].value],
    })
    .collect()
}

fn spectrum(load: TuneLoad) -> Spectrum {
    match load {
        // the wind of the file has its own spectra
        TuneLoad::Force | TuneLoad::Base | TuneLoad::Gusts => Spectrum::White { density: DENSITY },
        TuneLoad::Wind { corner_hz } => Spectrum::LowPass {
            density: DENSITY,
            corner_rad_s: TAU * corner_hz,
        },
        TuneLoad::Ground { ground_hz } => Spectrum::CloughPenzien {
            density: DENSITY,
            ground_rad_s: TAU * ground_hz,
            ground_damping_ratio: GROUND_DAMPING_RATIO,
            filter_rad_s: FILTER_PART * TAU * ground_hz,
            filter_damping_ratio: GROUND_DAMPING_RATIO,
        },
    }
}
