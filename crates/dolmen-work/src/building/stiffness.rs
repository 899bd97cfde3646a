//! Stiffness of a building's storey in plan from the modes of a survey.

use super::plan_answer::{FromRecord, PlanAnswer, Written};
use crate::error::WorkError;
use crate::surveyed::WithoutStiffness;
use dolmen::modal::Modes;
use dolmen::structure::building::{
    EccentricityFrom, Floor, FloorModes, FloorPlace, PlanMode, PlanMotion, PlanSolution, PlanStorey, Storey,
    StoreyFall, StoreyStiffness, floor_modes, plan_bounds, plan_stiffness, storey_falls,
};
use dolmen_project::{BuildingPart, ModeKind, Quantity, Survey, SurveyMode};

/// Walls are along x and y if the ratio of the coupling stiffness to the stiffness along the axes is below this, the rounding of rotated walls.
/// Our choice.
const ALONG_AXES: f64 = 1e-9;
/// Share of the shapes above which the sensors contradict a rigid floor, so that no stiffness is computed. As for sensors that contradict
/// each other.
const UNEXPLAINED_MOST: f64 = 0.05;
/// Relative difference within which a frequency of the file is that of the record's mode. Our choice: rounding to two digits.
const ONE_MODE: f64 = 0.02;

/// Result of a survey of a building.
pub(crate) enum FromModes {
    /// Stiffness, or the undetermined quantities.
    Plan(Box<PlanAnswer>),
    /// Why no stiffness is computed.
    Without(WithoutStiffness),
}

/// Finds every stiffness that explains the modes of the survey; `None` if it states none and its records, if any, have none.
///
/// If the sensors of a record determine the motion of the floor, its shapes give the twists of the modes, and with them the centre of rigidity.
pub(crate) fn stiffness(
    part: &BuildingPart,
    survey: &Survey,
    found: Option<&Modes>,
) -> Result<Option<FromModes>, WorkError> {
    let without = |why| Ok(Some(FromModes::Without(why)));
    let stated = plan_modes(survey);
    let has_record = survey.records.is_some() || !survey.setups.is_empty();
    if stated.is_empty() && !has_record {
        return Ok(None);
    }
    let (floors, storeys) = part.floors_and_storeys(&mut Quantity::nominal)?;
    let ([floor], [below]) = (floors.as_slice(), storeys.as_slice()) else {
        let floors = floors.len();
        return without(WithoutStiffness::Floors { floors });
    };
    if !part.dampers.is_empty() {
        let dampers = part.dampers.iter().map(|damper| damper.name.clone()).collect();
        return without(WithoutStiffness::Dampers { dampers });
    }
    let place = FloorPlace {
        height_m: below.height_m,
        centre_m: floor.centre_m,
        gyration_m: floor.gyration_m,
    };
    let off_floor = found.map_or_else(Vec::new, |modes| off_floor(modes, floor, &place));
    let moving = found.and_then(|modes| floor_modes(modes, &place));
    let rigid = moving
        .as_ref()
        .filter(|of| of.unexplained() <= UNEXPLAINED_MOST && !of.modes.is_empty());
    let modes = match (stated.is_empty(), rigid, &moving) {
        (false, Some(rigid), _) => with_shapes_of(rigid, stated),
        (false, None, _) => stated,
        (true, Some(rigid), _) => rigid.plan_modes(),
        (true, None, Some(bent)) if !bent.modes.is_empty() => {
            let unexplained = bent.unexplained();
            return without(WithoutStiffness::FloorNotRigid { unexplained });
        }
        (true, None, _) => return without(WithoutStiffness::OnlyRecord),
    };
    let Some(written) = written(floor, below) else {
        return without(WithoutStiffness::WallsTurned);
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
        Err(why) => return without(WithoutStiffness::Plan(why)),
    };
    let load_factor = |one: &PlanSolution| load_factor(floor, below, one, part.gravity_m_s2);
    let load_factors = found
        .solutions
        .iter()
        .map(load_factor)
        .collect::<Result<_, _>>()?;
    let is_stated = found.eccentricity_from == EccentricityFrom::Stated;
    let twist_unused = is_stated && modes.iter().any(|mode| mode.twist.is_some());
    let three: Option<&[PlanMode; 3]> = modes.as_slice().try_into().ok();
    let bounds = three.filter(|_| is_stated).and_then(|three| {
        let three = three.map(|mode| PlanMode { shape: None, ..mode });
        plan_bounds(&storey, &three, reach_m(floor))
    });
    let from_record = rigid
        .filter(|_| modes.iter().any(|mode| mode.shape.is_some()) && !is_stated)
        .map(|rigid| FromRecord {
            sensors: rigid.sensors,
            modes_found: rigid.modes.len(),
            unexplained: rigid.unexplained(),
        });
    Ok(Some(FromModes::Plan(Box::new(PlanAnswer {
        modes,
        storey,
        outline: floor.outline.clone(),
        centre_of_mass_m: floor.centre_m,
        written,
        found,
        load_factors,
        twist_unused,
        bounds,
        off_floor,
        from_record,
        beside_file: None,
    }))))
}

/// The modes stated in the file, with the twists and shapes from the record for those along x and y, if it has both.
fn with_shapes_of(rigid: &FloorModes, stated: Vec<PlanMode>) -> Vec<PlanMode> {
    let with_shape = |mode: PlanMode| {
        let along = mode.motion.filter(|motion| *motion != PlanMotion::Torsion);
        let own = along.zip(rigid.nearest(mode.frequency_hz, ONE_MODE));
        match own {
            Some((motion, own)) if mode.twist.is_none() => PlanMode {
                twist: own.twist.get(motion.index()).copied(),
                shape: Some(own.shape),
                ..mode
            },
            _ => mode,
        }
    };
    let filled: Vec<PlanMode> = stated.iter().copied().map(with_shape).collect();
    let is_sway = |mode: &&PlanMode| matches!(mode.motion, Some(PlanMotion::X | PlanMotion::Y));
    match filled.iter().filter(is_sway).all(|mode| mode.twist.is_some()) {
        true => filled,
        false => stated,
    }
}

/// Sensors within half a metre of the height of a floor, but outside its sides by more than that.
fn off_floor(modes: &Modes, floor: &Floor, place: &FloorPlace) -> Vec<String> {
    const NEAR_M: f64 = 0.5;
    let Some(reach_m) = reach_m(floor) else {
        return Vec::new();
    };
    let is_off = |position_m: [f64; 3]| {
        (position_m[2] - place.height_m).abs() <= NEAR_M
            && (0..2).any(|axis| {
                let [least, most] = reach_m[axis];
                let at = position_m[axis] - floor.centre_m[axis];
                at < least - NEAR_M || at > most + NEAR_M
            })
    };
    let off = modes
        .channels
        .iter()
        .filter(|channel| channel.position_m.is_some_and(is_off));
    off.map(|channel| channel.name.clone()).collect()
}

/// Possible positions of the centre of rigidity, from the centre of mass, m; `None` without an outline.
fn reach_m(floor: &Floor) -> Option<[[f64; 2]; 2]> {
    let corners = floor.outline.as_ref()?.corners_m();
    Some([0, 1].map(|axis| {
        let from_mass = corners.iter().map(|corner| corner[axis] - floor.centre_m[axis]);
        from_mass.fold([f64::INFINITY, f64::NEG_INFINITY], |[least, most], e| {
            [least.min(e), most.max(e)]
        })
    }))
}

/// All modes that a survey states, ascending. Modes of kind torsion are rotations whatever their direction, and so are those of direction
/// "torsion"; a direction with another name does not determine the motion.
fn plan_modes(survey: &Survey) -> Vec<PlanMode> {
    let each = survey.modes.iter().flat_map(|(direction, modes)| {
        modes.iter().map(move |mode| {
            let motion = motion(mode, direction);
            PlanMode {
                frequency_hz: mode.frequency.value,
                frequency_sd_hz: mode.frequency.standard_deviation(),
                motion,
                twist: mode.twist,
                shape: shape(mode, motion),
            }
        })
    });
    let mut modes: Vec<PlanMode> = each.collect();
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    modes
}

fn motion(mode: &SurveyMode, direction: &str) -> Option<PlanMotion> {
    match (mode.kind, direction) {
        (ModeKind::Torsion, _) | (_, "torsion") => Some(PlanMotion::Torsion),
        (ModeKind::Translation, "x") => Some(PlanMotion::X),
        (ModeKind::Translation, "y") => Some(PlanMotion::Y),
        (ModeKind::Translation, _) => None,
    }
}

/// u, v, ρθ relative to the displacement along the direction of the mode.
fn shape(mode: &SurveyMode, motion: Option<PlanMotion>) -> Option<[f64; 3]> {
    let (twist, sideways) = (mode.twist?.ratio, mode.sideways?);
    match motion? {
        PlanMotion::X => Some([1.0, sideways, twist]),
        PlanMotion::Y => Some([sideways, 1.0, twist]),
        PlanMotion::Torsion => None,
    }
}

/// The stiffness of the file about its centre of rigidity; `None` if x and y are coupled there.
fn written(floor: &Floor, below: &Storey) -> Option<Written> {
    let centre = below.stiffness.centre_of_rigidity_m()?;
    let k = below.stiffness.matrix_about(centre);
    let couples = k[0][1].abs() > ALONG_AXES * k[0][0].max(k[1][1]);
    // a centre of rigidity that equals the centre of mass within rounding is taken as equal
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
