//! Natural frequencies of a project's model as one part loosens: a joint of a chain or stack, a storey of a frame or building.

use crate::chain::limits::link_names;
use crate::frame::simulate::storey_names;
use crate::part_limit::Part;
use crate::stack::check::with_gaps;
use crate::stack::frequencies::RULE;
use dolmen::assess::FACTOR_SOUGHT;
use dolmen::blocks::{BesideInSmallMotion, LooseningStack, StackMotion, beside_in_small_motion};
use dolmen::structure::Building;
use dolmen::structure::building::{BuildingMode, PDelta, Storey, StoreyStiffness};
use dolmen_project::{
    BuildingPart, ChainAxis, ChainPart, FramePart, Project, Quantity, StackPart, Structure,
};
use std::rc::Rc;

/// Largest number of parts tried. Our choice: each costs some hundred modal analyses, or some fifty for a stack or building.
const PARTS_MOST: usize = 20;
/// Largest number of stones in a stack whose parts are tried. Our choice: with more, all different, it takes longer than a minute.
const STONES_MOST: usize = 40;
/// Factors of a table, from the smallest to the largest. Our choice: 12 % apart, which gives frequencies to 1e-6.
const TABLED: usize = 51;
/// Relative difference below which two modes of one building have the same frequency, and shapes that can be mixed arbitrarily.
const REPEATED: f64 = 1e-6;

/// Natural frequencies, Hz, in each direction, for a factor on the stiffness of one part or of all.
type FrequenciesOf<'a> = Box<dyn Fn(Option<usize>, f64) -> Option<Vec<Vec<f64>>> + 'a>;

/// A model whose parts can loosen.
pub(crate) struct Loosening<'a> {
    /// Its direction; `None` for all together.
    pub(crate) direction: Option<String>,
    /// The parts, lowest first.
    pub(crate) parts: Vec<Part>,
    /// The directions of its frequencies; `None` for any except torsion.
    pub(crate) along: Vec<Option<String>>,
    /// The frequencies in each of them.
    pub(crate) frequencies_hz: FrequenciesOf<'a>,
}

/// The direction of a mode that twists the plan.
pub(crate) const TORSION: &str = "torsion";

/// The models of a project; empty if its stiffness is unknown, or if it has too many parts.
pub(crate) fn loosening(project: &Project) -> Vec<Loosening<'_>> {
    let models = match &project.structure {
        Structure::Chain(part) => chains(project, part),
        Structure::Frame(part) => frames(part),
        Structure::Building(part) => buildings(part),
        Structure::Stack(part) => stack(part).into_iter().collect(),
        Structure::Survey => Vec::new(),
    };
    models
        .into_iter()
        .filter(|model| model.parts.len() <= PARTS_MOST)
        .collect()
}

/// The stiffness with a factor on one part, or on all.
fn multiplied(stiffness: &[f64], part: Option<usize>, factor: f64) -> Vec<f64> {
    let of = |at: usize| match part.is_none_or(|part| part == at) {
        true => factor,
        false => 1.0,
    };
    stiffness.iter().enumerate().map(|(at, k)| of(at) * k).collect()
}

fn chains<'a>(project: &'a Project, part: &'a ChainPart) -> Vec<Loosening<'a>> {
    let each = part.axes().iter().filter_map(|axis| {
        let stiffness = part.stiffness_towards(*axis, &mut Quantity::nominal)?;
        let chain = part
            .build_loaded(*axis, &project.loads, &mut Quantity::nominal)
            .ok()?;
        let direction = part.has_two_axes().then(|| {
            let name = match axis {
                ChainAxis::Along => "x",
                ChainAxis::Across => "y",
            };
            name.to_owned()
        });
        Some(Loosening {
            along: vec![direction.clone()],
            direction,
            parts: link_names(part).into_iter().map(Part::JointBelow).collect(),
            frequencies_hz: Box::new(move |part, factor| {
                let modes = chain.natural_modes(&multiplied(&stiffness, part, factor)).ok()?;
                Some(vec![modes.iter().map(|mode| mode.frequency_hz).collect()])
            }),
        })
    });
    each.collect()
}

fn frames(part: &FramePart) -> Vec<Loosening<'_>> {
    let each = part.directions.iter().filter_map(|direction| {
        let stiffness = part.stiffness_n_m(&direction.name, &mut Quantity::nominal)?;
        let frame = part.build(&mut Quantity::nominal).ok()?;
        Some(Loosening {
            direction: Some(direction.name.clone()),
            along: vec![Some(direction.name.clone())],
            parts: storey_names(part).into_iter().map(Part::Storey).collect(),
            frequencies_hz: Box::new(move |part, factor| {
                let modes = frame.natural_modes(&multiplied(&stiffness, part, factor)).ok()?;
                Some(vec![modes.iter().map(|mode| mode.frequency_hz).collect()])
            }),
        })
    });
    each.collect()
}

/// The directions in which buildings and stacks are measured.
fn plan_directions() -> [String; 3] {
    ["x", "y", TORSION].map(str::to_owned)
}

/// A building along x, along y and in torsion, each by its own modes: the factor of a storey acts in all directions.
fn buildings(part: &BuildingPart) -> Vec<Loosening<'_>> {
    let Ok((floors, storeys)) = part.floors_and_storeys(&mut Quantity::nominal) else {
        return Vec::new();
    };
    let p_delta = match part.p_delta {
        true => PDelta::Weights {
            gravity_m_s2: part.gravity_m_s2,
        },
        false => PDelta::LeftOut,
    };
    let names = part.floor_names();
    if names.len() > PARTS_MOST {
        return Vec::new();
    }
    let frequencies_hz = |of: Option<usize>, factor: f64| {
        let loosened = storeys
            .iter()
            .enumerate()
            .map(|(at, storey)| match of.is_none_or(|of| of == at) {
                true => loosened(storey, factor),
                false => storey.clone(),
            });
        let building = Building::new(floors.clone(), loosened.collect(), p_delta).ok()?;
        Some(by_direction(&building.modes().ok()?.modes))
    };
    let Some(table) = Table::of(names.len(), frequencies_hz) else {
        return Vec::new();
    };
    let table = Rc::new(table);
    let each = plan_directions().into_iter().enumerate().map(|(at, direction)| {
        let table = Rc::clone(&table);
        Loosening {
            direction: Some(direction.clone()),
            along: vec![Some(direction)],
            parts: names.iter().cloned().map(Part::BelowFloor).collect(),
            frequencies_hz: Box::new(move |part, factor| {
                let own = table.frequencies_hz(part, factor)?;
                Some(vec![own.get(at)?.clone()])
            }),
        }
    });
    each.collect()
}

fn loosened(storey: &Storey, factor: f64) -> Storey {
    const ORIGIN_M: [f64; 2] = [0.0; 2];
    let matrix = storey.stiffness.matrix_about(ORIGIN_M);
    Storey {
        stiffness: StoreyStiffness::about_point(matrix.map(|row| row.map(|k| factor * k)), ORIGIN_M),
        ..storey.clone()
    }
}

/// Frequencies, Hz, of the modes that move most along x, along y and in torsion. Modes with the same frequency share their directions,
/// whatever combination of them was found.
fn by_direction(modes: &[BuildingMode]) -> Vec<Vec<f64>> {
    let mut along = vec![Vec::new(); 3];
    for same in modes.chunk_by(|a, b| b.frequency_hz <= a.frequency_hz * (1.0 + REPEATED)) {
        let mut left = [0, 1, 2].map(|at| same.iter().map(|mode| mode.energy_shares[at]).sum::<f64>());
        for mode in same {
            let most = (0..3).max_by(|a, b| left[*a].total_cmp(&left[*b])).unwrap_or(0);
            left[most] -= 1.0;
            along[most].push(mode.frequency_hz);
        }
    }
    along
}

/// A stack in all directions together: the factor of a bed acts on its springs along and across.
fn stack(part: &StackPart) -> Option<Loosening<'_>> {
    let stack = with_gaps(part.build(&mut Quantity::nominal).ok()?).ok()?;
    let beside = beside_in_small_motion(&stack, RULE).ok()?;
    // a joint that acts in one sense only has no small oscillations
    if stack.blocks().len() > STONES_MOST || beside.contains(&BesideInSmallMotion::OneWay) {
        return None;
    }
    let loosening = LooseningStack::new(&stack, RULE, PARTS_MOST).ok()?;
    let mut beds: Vec<(String, Vec<usize>)> = Vec::new();
    for (group, joints) in loosening.joints().iter().enumerate() {
        let mut above: Vec<&str> = Vec::new();
        for joint in joints {
            let name = stack.blocks()[stack.joints()[*joint].upper].name.as_str();
            if !above.contains(&name) {
                above.push(name);
            }
        }
        let name = above.join(", ");
        match beds.iter_mut().find(|(own, _)| *own == name) {
            Some((_, groups)) => groups.push(group),
            None => beds.push((name, vec![group])),
        }
    }
    if beds.len() > PARTS_MOST {
        return None;
    }
    let groups = loosening.joints().len();
    let table = Table::of(beds.len(), |of, factor| {
        let mut factors = vec![1.0; groups];
        for (at, (_, own)) in beds.iter().enumerate() {
            if of.is_none_or(|of| of == at) {
                own.iter().for_each(|group| factors[*group] = factor);
            }
        }
        let motions = [StackMotion::X, StackMotion::Y, StackMotion::Torsion].into_iter();
        motions
            .map(|motion| loosening.frequencies_hz(motion, &factors))
            .collect()
    })?;
    Some(Loosening {
        direction: None,
        along: plan_directions().into_iter().map(Some).collect(),
        parts: beds.into_iter().map(|(name, _)| Part::JointBelow(name)).collect(),
        frequencies_hz: Box::new(move |part, factor| table.frequencies_hz(part, factor)),
    })
}

/// Frequencies at factors evenly spaced in their logarithm, for interpolation.
struct Table {
    given: Vec<Vec<f64>>,
    /// For each part, and for all together last: the frequencies at each factor.
    parts: Vec<Vec<Option<Vec<Vec<f64>>>>>,
}

impl Table {
    fn of(
        parts: usize,
        frequencies_hz: impl Fn(Option<usize>, f64) -> Option<Vec<Vec<f64>>>,
    ) -> Option<Self> {
        let [low, high] = FACTOR_SOUGHT;
        let factor = |at: usize| low * (high / low).powf(at as f64 / (TABLED - 1) as f64);
        let of = |part| (0..TABLED).map(|at| frequencies_hz(part, factor(at))).collect();
        Some(Table {
            given: frequencies_hz(None, 1.0)?,
            parts: (0..parts).map(Some).chain([None]).map(of).collect(),
        })
    }

    /// Cubic interpolation through the four neighbouring factors.
    fn frequencies_hz(&self, part: Option<usize>, factor: f64) -> Option<Vec<Vec<f64>>> {
        if factor == 1.0 {
            return Some(self.given.clone());
        }
        let rows = self.parts.get(part.unwrap_or(self.parts.len() - 1))?;
        let [low, high] = FACTOR_SOUGHT;
        let place = (factor / low).ln() / (high / low).ln() * (TABLED - 1) as f64;
        let first = (place.floor() - 1.0).clamp(0.0, (TABLED - 4) as f64) as usize;
        let x = place - first as f64;
        let weights = [
            -(x - 1.0) * (x - 2.0) * (x - 3.0) / 6.0,
            x * (x - 2.0) * (x - 3.0) / 2.0,
            -x * (x - 1.0) * (x - 3.0) / 2.0,
            x * (x - 1.0) * (x - 2.0) / 6.0,
        ];
        let around: Vec<&Vec<Vec<f64>>> = rows[first..first + 4]
            .iter()
            .map(Option::as_ref)
            .collect::<Option<_>>()?;
        let along = (0..self.given.len()).map(|direction| {
            let modes = around.iter().map(|all| all[direction].len()).min().unwrap_or(0);
            let at = |mode: usize| -> f64 {
                let pairs = weights.iter().zip(&around);
                pairs.map(|(weight, all)| weight * all[direction][mode]).sum()
            };
            (0..modes).map(at).collect()
        });
        Some(along.collect())
    }
}
