//! Stiffness of a building's storey in plan from the modes of a survey.

use super::plan_answer::{PlanAnswer, Written};
use crate::error::WorkError;
use crate::surveyed::WithoutStiffness;
use dolmen::structure::building::{
    EccentricityFrom, Floor, PlanMode, PlanMotion, PlanSolution, PlanStorey, Storey, StoreyFall,
    StoreyStiffness, plan_stiffness, storey_falls,
};
use dolmen_project::{BuildingPart, ModeKind, Quantity, Survey};

/// A stiffness between x and y, over that along them, below which walls stand along x and y: rounding of turned ones. Our choice.
const ALONG_AXES: f64 = 1e-9;

/// What a survey of a building leads to.
pub(crate) enum FromModes {
    /// Stiffness, or what stays free of it.
    Plan(Box<PlanAnswer>),
    /// Why no stiffness is sought.
    Without(WithoutStiffness),
}

/// Every stiffness that explains the modes of the survey; `None` if it states none.
pub(crate) fn stiffness(part: &BuildingPart, survey: &Survey) -> Result<Option<FromModes>, WorkError> {
    let modes = plan_modes(survey);
    if modes.is_empty() {
        let has_record = survey.records.is_some() || !survey.setups.is_empty();
        return Ok(has_record.then_some(FromModes::Without(WithoutStiffness::OnlyRecord)));
    }
    let (floors, storeys) = part.floors_and_storeys(&mut Quantity::nominal)?;
    let ([floor], [below]) = (floors.as_slice(), storeys.as_slice()) else {
        let floors = floors.len();
        return Ok(Some(FromModes::Without(WithoutStiffness::Floors { floors })));
    };
    let Some(written) = written(floor, below) else {
        return Ok(Some(FromModes::Without(WithoutStiffness::WallsTurned)));
    };
    let storey = PlanStorey {
        mass_kg: floor.mass_kg,
        gyration_m: floor.gyration_m,
        weight_takes_n_m: match part.p_delta {
            true => floor.mass_kg * part.gravity_m_s2 / below.height_m,
            false => 0.0,
        },
        eccentricity_m: written.eccentricity_m,
    };
    let found = match plan_stiffness(&storey, &modes) {
        Ok(found) => found,
        Err(why) => return Ok(Some(FromModes::Without(WithoutStiffness::Plan(why)))),
    };
    let load_factor = |one: &PlanSolution| load_factor(floor, below, one, part.gravity_m_s2);
    let load_factors = found
        .solutions
        .iter()
        .map(load_factor)
        .collect::<Result<_, _>>()?;
    let twist_unused =
        found.eccentricity_from == EccentricityFrom::Stated && modes.iter().any(|mode| mode.twist.is_some());
    Ok(Some(FromModes::Plan(Box::new(PlanAnswer {
        modes,
        storey,
        outline: floor.outline.clone(),
        centre_of_mass_m: floor.centre_m,
        written,
        found,
        load_factors,
        twist_unused,
    }))))
}

/// All modes that a survey states, ascending. Modes of kind torsion turn in whatever direction they stand, and so do those of
/// direction "torsion"; what a direction of another name says of the motion is not known.
fn plan_modes(survey: &Survey) -> Vec<PlanMode> {
    let each = survey.modes.iter().flat_map(|(direction, modes)| {
        modes.iter().map(move |mode| PlanMode {
            frequency_hz: mode.frequency.value,
            frequency_sd_hz: mode.frequency.standard_deviation(),
            motion: match (mode.kind, direction.as_str()) {
                (ModeKind::Torsion, _) | (_, "torsion") => Some(PlanMotion::Torsion),
                (ModeKind::Translation, "x") => Some(PlanMotion::X),
                (ModeKind::Translation, "y") => Some(PlanMotion::Y),
                (ModeKind::Translation, _) => None,
            },
            twist: mode.twist,
        })
    });
    let mut modes: Vec<PlanMode> = each.collect();
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    modes
}

/// The stiffness of the file about its centre of rigidity; `None` where x and y couple there.
fn written(floor: &Floor, below: &Storey) -> Option<Written> {
    let centre = below.stiffness.centre_of_rigidity_m()?;
    let k = below.stiffness.matrix_about(centre);
    let couples = k[0][1].abs() > ALONG_AXES * k[0][0].max(k[1][1]);
    // a centre of rigidity on that of mass to rounding is on it
    let from_mass = |axis: usize| {
        let e = centre[axis] - floor.centre_m[axis];
        if e.abs() <= ALONG_AXES * floor.gyration_m {
            0.0
        } else {
            e
        }
    };
    (!couples).then(|| Written {
        stiffness: [k[0][0], k[1][1], k[2][2]],
        eccentricity_m: [from_mass(0), from_mass(1)],
    })
}

fn load_factor(
    floor: &Floor,
    below: &Storey,
    one: &PlanSolution,
    gravity_m_s2: f64,
) -> Result<f64, WorkError> {
    let [k_x, k_y, k_theta] = one.stiffness;
    let centre = [0, 1].map(|axis| floor.centre_m[axis] + one.eccentricity_m[axis]);
    let storey = Storey {
        height_m: below.height_m,
        stiffness: StoreyStiffness::at_centre(k_x, k_y, k_theta, centre),
    };
    let falls = storey_falls(std::slice::from_ref(floor), &[storey], gravity_m_s2)?;
    Ok(StoreyFall::first(&falls).map_or(f64::NAN, |first| first.load_factor))
}
