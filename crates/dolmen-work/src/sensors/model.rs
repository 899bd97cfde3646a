//! Sites of sensors on a structure of each kind, and their motion in its modes.

use super::answer::{PlannedMode, SensorsOf};
use super::error::SensorsError;
use super::sites::{Axis, CandidatePlace, Side, Site, free_sides, sites};
use crate::error::WorkError;
use dolmen::blocks::{ContactRule, lowest_stack_modes};
use dolmen::stability::chain_limits;
use dolmen::structure::NaturalMode;
use dolmen_project::{
    BuildingPart, ChainAxis, ChainPart, FramePart, LoadsPart, Project, Quantity, StackPart, Structure,
};

/// Data for a plan.
pub(super) struct Model {
    pub(super) modes: Vec<PlannedMode>,
    pub(super) sites: Vec<Site>,
    /// The displacement of each channel of each site in each mode.
    pub(super) rows: Vec<Vec<Vec<f64>>>,
    pub(super) of: SensorsOf,
}

pub(super) fn model(project: &Project, wanted: usize, axes: usize) -> Result<Model, WorkError> {
    let (modes, candidates, of) = match &project.structure {
        Structure::Survey => return Err(SensorsError::NoModel.into()),
        Structure::Chain(part) => chain(part, &project.loads, wanted)?,
        Structure::Frame(part) => frame(part, wanted)?,
        Structure::Stack(part) => stack(part, wanted)?,
        Structure::Building(part) => building(part, wanted)?,
    };
    let moves = candidates.iter().map(|of| of.channels.len()).max();
    if let Some(moves) = moves.filter(|moves| axes > *moves) {
        return Err(SensorsError::AxesOfModel { given: axes, moves }.into());
    }
    let (sites, rows) = sites(candidates, axes);
    Ok(Model {
        modes,
        sites,
        rows,
        of,
    })
}

type PlacementData = (Vec<PlannedMode>, Vec<CandidatePlace>, SensorsOf);

fn planned(frequency_hz: Option<f64>, direction: Option<String>, along: Option<[f64; 3]>) -> PlannedMode {
    PlannedMode {
        frequency_hz,
        direction,
        along,
        seen_ratio: 0.0,
        most_alike: None,
    }
}

fn part_name(name: Option<&String>, index: usize) -> String {
    name.cloned().unwrap_or_else(|| (index + 1).to_string())
}

/// The tops of the links, in each direction of the chain; loads on it move with it.
fn chain(part: &ChainPart, loads: &LoadsPart, wanted: usize) -> Result<PlacementData, WorkError> {
    let given = |axis| part.stiffness_towards(axis, &mut Quantity::nominal);
    let of = match given(ChainAxis::Along) {
        Some(_) => SensorsOf::Given,
        None => SensorsOf::EqualJoints,
    };
    let mut all: Vec<DirectionMode> = Vec::new();
    for (direction, axis) in part.axes().iter().enumerate() {
        let chain = part.build_loaded(*axis, loads, &mut Quantity::nominal)?;
        let stiffness = match given(*axis) {
            Some(stiffness) => stiffness,
            None => vec![2.0 * chain_limits(&chain)?.equal_joints_n_m_rad; part.links.len()],
        };
        let modes = standing(chain.natural_modes(&stiffness)?)?
            .into_iter()
            .enumerate();
        all.extend(modes.map(|(order, mode)| DirectionMode {
            direction,
            order,
            mode,
            is_frequency_known: of == SensorsOf::Given,
        }));
    }
    keep_lowest(&mut all, wanted, of);
    let mut height = 0.0;
    let candidates = part.links.iter().enumerate().map(|(at, link)| {
        height += link.length.value;
        let channel = |(direction, axis): (usize, &ChainAxis)| {
            let axis = match part.has_two_axes() {
                true => Axis::Named(axis.name().to_owned()),
                false => Axis::InPlane,
            };
            (axis, along(&all, direction, at))
        };
        CandidatePlace {
            part: part_name(link.name.as_ref(), at),
            side: Side::Top,
            position_m: [0.0, 0.0, height],
            channels: part.axes().iter().enumerate().map(channel).collect(),
        }
    });
    let candidates: Vec<CandidatePlace> = candidates.collect();
    let modes = all.iter().map(|of| {
        let axis = part.axes().get(of.direction).filter(|_| part.has_two_axes());
        let known = of.is_frequency_known.then_some(of.mode.frequency_hz);
        planned(known, axis.map(|axis| axis.name().to_owned()), None)
    });
    Ok((modes.collect(), candidates, of))
}

/// A mode of a chain or frame in one of its directions.
struct DirectionMode {
    /// Number of the direction, from 0.
    direction: usize,
    /// Number of the mode in it, from 0.
    order: usize,
    mode: NaturalMode,
    is_frequency_known: bool,
}

/// Keeps the lowest modes; without known frequencies the first mode of every direction comes before the second of any.
fn keep_lowest(all: &mut Vec<DirectionMode>, wanted: usize, of: SensorsOf) {
    match of {
        SensorsOf::Given => all.sort_by(|a, b| a.mode.frequency_hz.total_cmp(&b.mode.frequency_hz)),
        SensorsOf::EqualJoints | SensorsOf::EqualStoreys => all.sort_by_key(|of| (of.order, of.direction)),
    }
    all.truncate(wanted);
}

/// The displacement at a level along a direction in each mode.
fn along(all: &[DirectionMode], direction: usize, at: usize) -> Vec<f64> {
    let each = all.iter().map(|of| match of.direction == direction {
        true => of.mode.displacement[at],
        false => 0.0,
    });
    each.collect()
}

/// The levels, along each direction.
fn frame(part: &FramePart, wanted: usize) -> Result<PlacementData, WorkError> {
    let frame = part.build(&mut Quantity::nominal)?;
    let mut of = SensorsOf::Given;
    let mut all: Vec<DirectionMode> = Vec::new();
    for (number, direction) in part.directions.iter().enumerate() {
        let given = part.stiffness_n_m(&direction.name, &mut Quantity::nominal);
        let is_frequency_known = given.is_some();
        let stiffness = given.unwrap_or_else(|| {
            of = SensorsOf::EqualStoreys;
            let least = frame.geometric_n_m().into_iter().fold(0.0, f64::max);
            vec![EQUAL_STOREYS * least; part.storeys.len()]
        });
        let modes = standing(frame.natural_modes(&stiffness)?)?
            .into_iter()
            .enumerate();
        all.extend(modes.map(|(order, mode)| DirectionMode {
            direction: number,
            order,
            mode,
            is_frequency_known,
        }));
    }
    keep_lowest(&mut all, wanted, of);
    let mut height = 0.0;
    let candidates = part.storeys.iter().enumerate().map(|(at, storey)| {
        height += storey.height.value;
        let channel = |(number, name): (usize, String)| (Axis::Named(name), along(&all, number, at));
        let names = part.directions.iter().map(|direction| direction.name.clone());
        CandidatePlace {
            part: part_name(storey.name.as_ref(), at),
            side: Side::Top,
            position_m: [0.0, 0.0, height],
            channels: names.enumerate().map(channel).collect(),
        }
    });
    let candidates: Vec<CandidatePlace> = candidates.collect();
    let modes = all.iter().map(|of| {
        let direction = part.directions[of.direction].name.clone();
        let known = of.is_frequency_known.then_some(of.mode.frequency_hz);
        planned(known, Some(direction), None)
    });
    Ok((modes.collect(), candidates, of))
}

/// Assumed stiffness of storeys with unknown stiffness, relative to the largest reduction by the weight: so large that the shape does not
/// depend on it.
const EQUAL_STOREYS: f64 = 20.0;

/// The free sides of the stones.
fn stack(part: &StackPart, wanted: usize) -> Result<PlacementData, WorkError> {
    let stack = part.build(&mut Quantity::nominal)?;
    let mut all = lowest_stack_modes(&stack, ContactRule::Four, wanted)?;
    all.truncate(wanted);
    let candidates = free_sides(&stack).into_iter().map(|(number, side, position_m)| {
        let block = &stack.blocks()[number];
        let centre = block.solid.centroid_m();
        let arm: [f64; 3] = std::array::from_fn(|i| position_m[i] - centre[i]);
        let along = |axis: usize| {
            let moved = |shape: &[f64; 6]| {
                let (j, k) = ((axis + 1) % 3, (axis + 2) % 3);
                shape[axis] + shape[3 + j] * arm[k] - shape[3 + k] * arm[j]
            };
            all.iter()
                .map(|mode| moved(&mode.shape[number]))
                .collect::<Vec<f64>>()
        };
        CandidatePlace {
            part: block.name.clone(),
            side,
            position_m,
            channels: vec![(Axis::X, along(0)), (Axis::Y, along(1)), (Axis::Z, along(2))],
        }
    });
    let candidates: Vec<CandidatePlace> = candidates.collect();
    let modes = all
        .iter()
        .map(|mode| planned(Some(mode.frequency_hz), None, Some(mode.kinetic_energy_ratio)));
    Ok((modes.collect(), candidates, SensorsOf::Given))
}

/// The corners of the floors; for floors without an outline, their centres and two places a radius of gyration away.
fn building(part: &BuildingPart, wanted: usize) -> Result<PlacementData, WorkError> {
    let Some(vibrating) = part.as_written() else {
        return Err(SensorsError::Falls.into());
    };
    let building = vibrating.building();
    let found = building.modes()?;
    let all: Vec<_> = found.modes.iter().take(wanted).collect();
    let (floors, _) = part.floors_and_storeys(&mut Quantity::nominal)?;
    let heights = part
        .floors
        .iter()
        .flat_map(|floor| std::iter::repeat_n(floor.height.value, floor.count));
    let mut height = 0.0;
    let mut candidates = Vec::new();
    for (at, ((floor, name), storey_m)) in floors.iter().zip(part.floor_names()).zip(heights).enumerate() {
        height += storey_m;
        let [x, y] = floor.centre_m;
        let places: Vec<(Side, [f64; 2])> = match &floor.outline {
            Some(outline) => {
                let corners = outline.corners_m().iter().enumerate();
                corners
                    .map(|(number, corner)| (Side::Corner(number), *corner))
                    .collect()
            }
            None => vec![
                (Side::Top, [x, y]),
                (Side::Right, [x + floor.gyration_m, y]),
                (Side::Back, [x, y + floor.gyration_m]),
            ],
        };
        for (side, place) in places {
            let along = |axis: usize| {
                let arm = if axis == 0 { y - place[1] } else { place[0] - x };
                let moved = |shape: &[f64]| shape[3 * at + axis] + shape[3 * at + 2] * arm;
                all.iter().map(|mode| moved(&mode.shape)).collect::<Vec<f64>>()
            };
            candidates.push(CandidatePlace {
                part: name.clone(),
                side,
                position_m: [place[0], place[1], height],
                channels: vec![(Axis::X, along(0)), (Axis::Y, along(1))],
            });
        }
    }
    let modes = all.iter().map(|mode| {
        let [x, y, _] = mode.energy_shares;
        planned(Some(mode.frequency_hz), None, Some([x, y, 0.0]))
    });
    Ok((modes.collect(), candidates, SensorsOf::Given))
}

/// The modes; an error if the structure falls in one.
fn standing(modes: Vec<NaturalMode>) -> Result<Vec<NaturalMode>, WorkError> {
    match modes.iter().all(|mode| mode.omega_squared > 0.0) {
        true => Ok(modes),
        false => Err(SensorsError::Falls.into()),
    }
}
