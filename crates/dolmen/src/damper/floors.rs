//! Effect of a damper on each floor of a building, with the best place and tuning there.

use super::comparison::{best_from, compared, design_options, row_apart, stroke_most_m};
use super::position_map::along_line;
use super::{
    Choice, Compared, Comparison, ComparisonOptions, DamperError, DamperSite, DesignEnd, Goal, MapTuning,
    PlacedDamper, Plan, PlanOptions, PositionMapOptions, goal_cost,
};

/// A floor on which the damper may stand.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorSite {
    /// Number of the floor, from 1.
    pub floor: usize,
    /// The floor in plan.
    pub site: DamperSite,
}

/// The best damper on one floor.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorDesign {
    /// Number of the floor, from 1.
    pub floor: usize,
    /// Modal mass of the target mode at the damper, kg; `None` if the mode does not move it.
    pub modal_mass_kg: Option<f64>,
    /// The damper, placed and tuned best on this floor; its site is 0, that of the floor alone.
    pub damper: PlacedDamper,
    /// Value of the goal, from the prepared frequencies, or from the assembled matrices where `effect` is given.
    pub cost: f64,
    /// The end of the search.
    pub end: DesignEnd,
    /// The effect from the assembled matrices, for the file's floor and the best few.
    pub effect: Option<Compared>,
}

/// The floors compared.
#[derive(Clone, Debug, PartialEq)]
pub struct FloorComparison {
    /// The floors, in the order given.
    pub floors: Vec<FloorDesign>,
    /// Largest relative difference between the prepared frequencies and the assembled matrices, over the floors judged by both. Floors whose
    /// goals differ by less than this cannot be told apart.
    pub apart: f64,
}

impl FloorComparison {
    /// The floor with the smallest goal; of equal ones the first.
    pub fn best(&self) -> Option<&FloorDesign> {
        let floors = self.floors.iter();
        floors.reduce(|best, next| if next.cost < best.cost { next } else { best })
    }
}

/// Number of floors, beside the given one, that are judged from the assembled matrices. Our choice.
const EXACT: usize = 3;
/// Number of places across the floor from which the search chooses its start.
const PLACES: usize = 16;

/// Places and tunes a damper on each of several floors; its mass, direction and kind stay. `own` is the comparison on the given floor, from
/// `plan`, and gives its best design.
///
/// Each floor has its own prepared frequencies on the modes of `plan`. At 16 places across the floor the tuning is searched over all local
/// minima; from the best of them, and from the best damper of the given floor, place and tuning are optimised together.
///
/// # Errors
/// As in [`compare`](super::compare()).
///
/// # Limits
/// The points and the loads stay those of `plan`. The goals of floors without `effect` have the tolerance of a [`Plan`].
pub fn compare_floors(
    plan: &Plan,
    (given_floor, own): (usize, &Comparison),
    floors: &[FloorSite],
    options: &ComparisonOptions,
) -> Result<FloorComparison, DamperError> {
    let (Some(given), Some(best)) = (own.row(Choice::Given), own.row(Choice::Best)) else {
        return Err(DamperError::NoOptimum {
            what: "the damper's place",
            iterations: 0,
        });
    };
    let how = design_options(options, stroke_most_m(given, options));
    let mut designs = Vec::with_capacity(floors.len());
    let mut plans = Vec::with_capacity(floors.len());
    for of in floors {
        let start = on_floor(&best.damper, &of.site);
        let there = plan.on_site(of.site.clone(), &[start], &PlanOptions::default())?;
        let (damper, cost, end) = match of.floor == given_floor {
            true => (best.damper, best.cost, best.end.unwrap_or(DesignEnd::Stalled)),
            false => {
                let starts = [Some(start), best_place(&there, &start, options.goal)];
                let found = best_from(&there, starts.into_iter().flatten(), &how)?;
                let damper = found.dampers[0];
                (damper, goal_cost(&there, &[damper], options.goal)?, found.end)
            }
        };
        designs.push(FloorDesign {
            floor: of.floor,
            modal_mass_kg: there.modal_mass_kg(options.mode, &damper).ok(),
            damper,
            cost,
            end,
            effect: (of.floor == given_floor).then(|| best.clone()),
        });
        plans.push(there);
    }
    let mut order: Vec<usize> = (0..designs.len())
        .filter(|&i| designs[i].effect.is_none())
        .collect();
    order.sort_by(|a, b| designs[*a].cost.total_cmp(&designs[*b].cost));
    let mut apart = 0.0_f64;
    for i in order.into_iter().take(EXACT) {
        let design = &mut designs[i];
        let effect = compared(&plans[i], Choice::Best, &design.damper, options.goal)?;
        apart = apart.max(row_apart(&plans[i], &effect)?);
        design.cost = effect.cost;
        design.effect = Some(Compared {
            end: Some(design.end),
            ..effect
        });
    }
    Ok(FloorComparison {
        floors: designs,
        apart,
    })
}

/// A damper at the nearest place of another floor.
fn on_floor(damper: &PlacedDamper, site: &DamperSite) -> PlacedDamper {
    PlacedDamper {
        site: 0,
        place_m: site.nearest_m(damper.place_m).0,
        ..*damper
    }
}

/// The best of several places across the floor, each tuned best.
fn best_place(plan: &Plan, damper: &PlacedDamper, goal: Goal) -> Option<PlacedDamper> {
    let mut over = PositionMapOptions::over_site(plan, damper.site, PLACES, PLACES)?;
    over.tuning = MapTuning::Best;
    over.goal = match goal {
        Goal::LargestPeak => Goal::LargestRms,
        goal => goal,
    };
    let site = &plan.problem().sites[damper.site];
    let arm = |place_m: &[f64; 2]| site.coefficients(*place_m, damper.direction_degrees)[2];
    let grid = over.y_m.iter().flat_map(|y| over.x_m.iter().map(|x| [*x, *y]));
    let mut places: Vec<[f64; 2]> = grid.filter(|place| site.nearest_m(*place).1 <= 0.0).collect();
    places.sort_by(|a, b| arm(a).total_cmp(&arm(b)));
    let step = places.len().div_ceil(PLACES).max(1);
    let places: Vec<[f64; 2]> = places.into_iter().skip(step / 2).step_by(step).collect();
    let cells = along_line(plan, damper, &places, &over).into_iter();
    let best = cells.reduce(|best, next| if next.cost < best.cost { next } else { best });
    best.map(|cell| cell.damper)
}
