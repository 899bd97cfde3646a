//! The check of a building: storeys, modes, dampers, the spectrum of its site.

use super::accidental::{AccidentalTorsion, accidental_torsion};
use super::site_spectrum::spectrum_of;
use super::{BuildingAnswer, BuildingSpectral, DampedSpectral, MINOR_RATIO, StandingBuilding};
use crate::error::WorkError;
use crate::told::told;
use dolmen::damper::{
    AttachedDamper, DampedSpectralAnalysis, DisplacedBuilding, damped_modes, damped_spectral_analysis,
};
use dolmen::dynamics::{
    DirectionalCombination, ModalCombination, SpectralAnalysis, VibratingBuilding, spectral_analysis,
};
use dolmen::structure::Building;
use dolmen::structure::building::{PDelta, PlanDirection, StoreyFall, storey_falls};
use dolmen_project::{BuildingPart, BuiltDamper, Pick, Project};

/// Checks a building, with the value of each input that `pick` chooses.
pub(crate) fn check(
    project: &Project,
    part: &BuildingPart,
    pick: Pick<'_>,
) -> Result<BuildingAnswer, WorkError> {
    let (floors, storeys) = part.floors_and_storeys(pick)?;
    let falls = storey_falls(&floors, &storeys, part.gravity_m_s2)?;
    let elastic = Building::new(floors, storeys, PDelta::LeftOut)?;
    let stands = StoreyFall::first(&falls).is_some_and(|first| first.load_factor > 1.0);
    let stands = match stands {
        true => Some(Box::new(standing(project, part, &part.vibrating(pick)?, pick)?)),
        false => None,
    };
    Ok(BuildingAnswer {
        floors: part.floor_names(),
        elastic,
        falls,
        stands,
    })
}

/// The building as it vibrates, without the wind.
pub(super) fn standing(
    project: &Project,
    part: &BuildingPart,
    vibrating: &VibratingBuilding,
    pick: Pick<'_>,
) -> Result<StandingBuilding, WorkError> {
    let dampers = part.dampers(vibrating, pick)?;
    let attached: Vec<AttachedDamper> = dampers.iter().map(BuiltDamper::attached).collect();
    let damped_modes = match dampers.is_empty() {
        true => Vec::new(),
        false => damped_modes(vibrating, &attached)?,
    };
    let mut spectral_refused = None;
    let mut spectral = None;
    let (mut damped, mut damped_refused) = (None, None);
    let mut accidental = AccidentalTorsion::NotAsked;
    // the section on the demand states why a site is refused
    if let Some(site) = project.site.as_ref().and_then(|site| site.demand().ok()) {
        let read = spectrum_of(&site);
        match spectral_analysis(vibrating, &read) {
            Ok(analysis) => {
                spectral = Some(by_spectrum(part, vibrating.building(), &analysis, pick)?);
            }
            Err(why) => spectral_refused = Some(told(&why)),
        }
        if !dampers.is_empty() {
            match damped_spectral_analysis(vibrating, &attached, &read) {
                Ok(analysis) => damped = Some(with_dampers(part, vibrating.building(), &analysis, pick)?),
                Err(why) => damped_refused = Some(told(&why)),
            }
        }
        if damped.is_some() || (dampers.is_empty() && spectral.is_some()) {
            let of = DisplacedBuilding {
                vibrating,
                damping: &part.damping(pick),
                dampers: &attached,
            };
            let asked = (&site, project.drift_limit.as_ref());
            accidental = accidental_torsion(&of, asked, part.accidental_eccentricity);
        }
    }
    Ok(StandingBuilding {
        building: vibrating.building().clone(),
        modes: vibrating.modes().clone(),
        damping_ratios: vibrating.damping_ratios().to_vec(),
        dampers,
        damped_modes,
        spectral,
        spectral_refused,
        damped,
        damped_refused,
        accidental,
        wind: None,
        wind_refused: None,
    })
}

fn with_dampers(
    part: &BuildingPart,
    building: &Building,
    analysis: &DampedSpectralAnalysis,
    pick: Pick<'_>,
) -> Result<DampedSpectral, WorkError> {
    let both = |row: &[f64]| analysis.largest(row, DirectionalCombination::Srss);
    let [shear_x, shear_y, torque] = building.base_rows();
    let LargestOfRow {
        displacement_m,
        edge_drift_m,
        centre_drift_m,
        points_m,
    } = moved(part, building, &both, pick)?;
    Ok(DampedSpectral {
        modes: analysis.modes.clone(),
        base_shear_n: [both(&shear_x), both(&shear_y)],
        base_torque_n_m: both(&torque),
        displacement_m,
        edge_drift_m,
        centre_drift_m,
        points_m,
        strokes_m: analysis.largest_strokes_m(DirectionalCombination::Srss),
    })
}

/// The largest value of a row for floors, storeys and points.
pub(super) struct LargestOfRow {
    displacement_m: Vec<[f64; 2]>,
    pub(super) edge_drift_m: Vec<Option<[f64; 2]>>,
    pub(super) centre_drift_m: Vec<[f64; 2]>,
    points_m: Vec<(String, [f64; 2])>,
}

/// The stroke of each damper under the spectrum of the site, m; `None` without a site, or if its spectrum does not apply to these dampers.
pub(crate) fn site_strokes_m(
    project: &Project,
    alone: &VibratingBuilding,
    dampers: &[BuiltDamper],
) -> Option<Vec<f64>> {
    let site = project.site.as_ref()?.demand().ok()?;
    let attached: Vec<AttachedDamper> = dampers.iter().map(BuiltDamper::attached).collect();
    let analysis = damped_spectral_analysis(alone, &attached, spectrum_of(&site)).ok()?;
    Some(analysis.largest_strokes_m(DirectionalCombination::Srss))
}

fn by_spectrum(
    part: &BuildingPart,
    building: &Building,
    analysis: &SpectralAnalysis,
    pick: Pick<'_>,
) -> Result<BuildingSpectral, WorkError> {
    let both = |row: &[f64]| analysis.largest(row, ModalCombination::Cqc, DirectionalCombination::Srss);
    let [shear_x, shear_y, torque] = building.base_rows();
    let base_shear_n = [
        ModalCombination::AbsoluteSum,
        ModalCombination::Srss,
        ModalCombination::Cqc,
    ]
    .map(|modal| {
        [
            analysis.largest(&shear_x, modal, DirectionalCombination::Srss),
            analysis.largest(&shear_y, modal, DirectionalCombination::Srss),
        ]
    });
    let LargestOfRow {
        displacement_m,
        edge_drift_m,
        centre_drift_m,
        points_m,
    } = moved(part, building, &both, pick)?;
    Ok(BuildingSpectral {
        modes: analysis.modes.clone(),
        base_shear_n,
        base_torque_n_m: both(&torque),
        least_favourable: [
            analysis.least_favourable(&shear_x, MINOR_RATIO)?,
            analysis.least_favourable(&shear_y, MINOR_RATIO)?,
        ],
        displacement_m,
        edge_drift_m,
        centre_drift_m,
        points_m,
    })
}

pub(super) fn moved(
    part: &BuildingPart,
    building: &Building,
    both: &dyn Fn(&[f64]) -> f64,
    pick: Pick<'_>,
) -> Result<LargestOfRow, WorkError> {
    let (mut displacement_m, mut edge_drift_m, mut centre_drift_m) = (Vec::new(), Vec::new(), Vec::new());
    for i in 0..building.floors().len() {
        let centre = |axis: usize| {
            let mut row = vec![0.0; building.coordinates()];
            row[3 * i + axis] = 1.0;
            both(&row)
        };
        displacement_m.push([centre(0), centre(1)]);
        centre_drift_m.push([0, 1].map(|axis| both(&centre_drift_row(building, i, axis))));
        let rows = building.edge_drift_rows(i + 1)?;
        edge_drift_m.push(rows.map(|[front, back, left, right]| {
            [both(&front).max(both(&back)), both(&left).max(both(&right))]
        }));
    }
    let mut points_m = Vec::new();
    for point in &part.points {
        let (x, y) = (pick(&point.place[0]), pick(&point.place[1]));
        let along = |direction| -> Result<f64, WorkError> {
            Ok(both(&building.point_row(point.floor, x, y, direction)?))
        };
        points_m.push((
            point.name.clone(),
            [along(PlanDirection::X)?, along(PlanDirection::Y)?],
        ));
    }
    Ok(LargestOfRow {
        displacement_m,
        edge_drift_m,
        centre_drift_m,
        points_m,
    })
}

/// The drift of a storey at the centre of mass of the floor above it, along x (0) or y (1).
fn centre_drift_row(building: &Building, floor: usize, axis: usize) -> Vec<f64> {
    let mut row = vec![0.0; building.coordinates()];
    row[3 * floor + axis] = 1.0;
    if let Some(below) = floor.checked_sub(1) {
        // u − (y − y_c) θ and v + (x − x_c) θ of the floor below
        let [at, centre] = [floor, below].map(|of| building.floors()[of].centre_m);
        let arm = at[1 - axis] - centre[1 - axis];
        row[3 * below + axis] = -1.0;
        row[3 * below + 2] = if axis == 0 { arm } else { -arm };
    }
    row
}
