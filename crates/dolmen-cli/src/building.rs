//! The check of a building: storeys, modes, dampers, the spectrum of its site.

use anyhow::Result;
use dolmen::assess::demand::SiteDemand;
use dolmen::dynamics::{DirectionalCombination, ModalCombination, SpectralAnalysis, spectral_analysis};
use dolmen::structure::Building;
use dolmen::structure::building::{PDelta, PlanDirection, StoreyFall, storey_falls};
use dolmen_formats::building::{BuildingAnswer, BuildingSpectral, StandingBuilding};
use dolmen_formats::project::{BuildingPart, Pick, Project};

/// What is known of a building, each input with the value that `pick` chooses.
pub(crate) fn check(project: &Project, part: &BuildingPart, pick: Pick<'_>) -> Result<BuildingAnswer> {
    let (floors, storeys) = part.floors_and_storeys(pick)?;
    let falls = storey_falls(&floors, &storeys, part.gravity_m_s2)?;
    let elastic = Building::new(floors, storeys, PDelta::LeftOut)?;
    let stands = StoreyFall::first(&falls).is_some_and(|first| first.load_factor > 1.0);
    let stands = match stands {
        true => Some(Box::new(standing(project, part, pick)?)),
        false => None,
    };
    Ok(BuildingAnswer {
        floors: part.floor_names(),
        elastic,
        falls,
        stands,
    })
}

fn standing(project: &Project, part: &BuildingPart, pick: Pick<'_>) -> Result<StandingBuilding> {
    let building = part.build(pick)?;
    let vibrating = part.vibrating(building, &[], pick)?;
    let dampers = part.dampers(vibrating.building(), vibrating.modes(), pick)?;
    let spectral = match &project.site {
        None => None,
        // what the spectrum refuses is said with the demand of the site
        Some(site) => site.demand().ok().and_then(|site| {
            let read = |period_s: f64, damping_ratio: f64| -> Result<[f64; 2]> {
                Ok([spectral_acceleration(&site, period_s, damping_ratio)?; 2])
            };
            spectral_analysis(&vibrating, read).ok()
        }),
    };
    let spectral = match spectral {
        None => None,
        Some(analysis) => Some(by_spectrum(part, vibrating.building(), &analysis, pick)?),
    };
    Ok(StandingBuilding {
        building: vibrating.building().clone(),
        modes: vibrating.modes().clone(),
        damping_ratios: vibrating.damping_ratios().to_vec(),
        dampers,
        spectral,
    })
}

/// At the damping of the mode.
fn spectral_acceleration(site: &SiteDemand, period_s: f64, damping_ratio: f64) -> Result<f64> {
    Ok(site.spectrum.acceleration_m_s2(period_s, damping_ratio)?)
}

fn by_spectrum(
    part: &BuildingPart,
    building: &Building,
    analysis: &SpectralAnalysis,
    pick: Pick<'_>,
) -> Result<BuildingSpectral> {
    let both = |row: &[f64]| analysis.largest(row, ModalCombination::Cqc, DirectionalCombination::Srss);
    let [shear_x, shear_y, torque] = building.base_rows();
    let base_shear_n = [
        ModalCombination::AbsoluteSum,
        ModalCombination::Srss,
        ModalCombination::Cqc,
    ]
    .map(|modal| {
        [
            analysis.largest(&shear_x, modal, DirectionalCombination::XAlone),
            analysis.largest(&shear_y, modal, DirectionalCombination::YAlone),
        ]
    });
    let (mut displacement_m, mut edge_drift_m) = (Vec::new(), Vec::new());
    for i in 0..building.floors().len() {
        let centre = |axis: usize| {
            let mut row = vec![0.0; building.coordinates()];
            row[3 * i + axis] = 1.0;
            both(&row)
        };
        displacement_m.push([centre(0), centre(1)]);
        let [front, back, left, right] = building.edge_drift_rows(i + 1)?;
        edge_drift_m.push([both(&front).max(both(&back)), both(&left).max(both(&right))]);
    }
    let mut points_m = Vec::new();
    for point in &part.points {
        let (x, y) = (pick(&point.place[0]), pick(&point.place[1]));
        let along =
            |direction| -> Result<f64> { Ok(both(&building.point_row(point.floor, x, y, direction)?)) };
        points_m.push((
            point.name.clone(),
            [along(PlanDirection::X)?, along(PlanDirection::Y)?],
        ));
    }
    Ok(BuildingSpectral {
        modes: analysis.modes.clone(),
        base_shear_n,
        base_torque_n_m: both(&torque),
        displacement_m,
        edge_drift_m,
        points_m,
    })
}
