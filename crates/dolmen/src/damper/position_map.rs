//! Map of the effect of a damper over the positions on its floor.

use super::single_damper::{DAMPING_MOST, SingleDamper, SingleDamperSearch};
use super::{ColumnAsMass, DamperError, Goal, PlacedDamper, Plan, TuningRule};
use crate::numeric::{Minimax, minimax};
use rayon::prelude::*;

/// Tuning of the damper at each position.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MapTuning {
    /// The given tuning, at every position.
    Kept,
    /// Tuned by a closed form to one mode, with the mass ratio at each position.
    Rule {
        /// The closed form.
        rule: TuningRule,
        /// Index of the mode, from 0.
        mode: usize,
        /// Damping ratio of the mode, for the closed forms that use it.
        structure_damping_ratio: f64,
    },
    /// The optimum tuning at each position.
    Best,
}

/// Positions and tuning of a map.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionMapOptions {
    /// x of the positions, m.
    pub x_m: Vec<f64>,
    /// y of the positions, m.
    pub y_m: Vec<f64>,
    /// Tuning of the damper at each position.
    pub tuning: MapTuning,
    /// The quantity to minimise; [`Goal::LargestRms`] or [`Goal::MeanSquare`].
    pub goal: Goal,
    /// Weight of each point, multiplied by its motion; empty means 1 each.
    pub weights: Vec<f64>,
}

/// The result at one position.
#[derive(Clone, Debug, PartialEq)]
pub struct MapCell {
    /// The damper at this position, with its tuning.
    pub damper: PlacedDamper,
    /// Standard deviation of each point.
    pub point_rms: Vec<f64>,
    /// Weighted value of the goal.
    pub cost: f64,
    /// Whether the search ended at a limit of frequency or damping, so that a better tuning may exist beyond it.
    pub at_limit: bool,
}

/// The results at all positions, in rows of equal y, from the smallest y.
#[derive(Clone, Debug, PartialEq)]
pub struct PositionMap {
    /// x of the columns, m.
    pub x_m: Vec<f64>,
    /// y of the rows, m.
    pub y_m: Vec<f64>,
    /// x varies fastest. `None` outside the floor, or where the mode of the tuning does not move.
    pub cells: Vec<Option<MapCell>>,
}

impl PositionMap {
    /// The cell with the smallest cost.
    pub fn best(&self) -> Option<&MapCell> {
        let cells = self.cells.iter().flatten();
        cells.reduce(|best, cell| if cell.cost < best.cost { cell } else { best })
    }
}

impl PositionMapOptions {
    /// Position of a cell of the map.
    fn place(&self, cell: usize) -> [f64; 2] {
        let columns = self.x_m.len();
        [self.x_m[cell % columns], self.y_m[cell / columns]]
    }

    /// Positions at the centres of `columns` × `rows` equal cells of the bounding box of a site.
    pub fn over_site(plan: &Plan, site: usize, columns: usize, rows: usize) -> Option<Self> {
        let extent = plan.problem().sites.get(site)?.extent_m();
        let middles = |[low, high]: [f64; 2], count: usize| -> Vec<f64> {
            (0..count)
                .map(|i| low + (high - low) * (i as f64 + 0.5) / count as f64)
                .collect()
        };
        Some(PositionMapOptions {
            x_m: middles(extent[0], columns),
            y_m: middles(extent[1], rows),
            tuning: MapTuning::Best,
            goal: Goal::LargestRms,
            weights: Vec::new(),
        })
    }
}

/// Largest number of steps of one search. The search starts from the tuning of a neighbour, which is close.
const ITERATIONS_MOST: usize = 60;
/// Steps in ln f and ln ζ at which a search ends; the relative error of the cost is then far smaller.
const STEP_LEAST: f64 = 1e-5;
/// If the tuning of a neighbour is better by this fraction, it is at another local minimum.
const BETTER: f64 = 1e-5;
/// Number of positions at which the search covers all local minima.
const COARSE: usize = 12;
/// Number of positions that follow each other in one search.
const PART: usize = 16;
/// Two positions act alike if their lever arms differ by no more than this part of the floor's longer side.
const SAME_ARM: f64 = 1e-12;
/// Damping ratios of that search grid; its frequencies are equally spaced in ln f between the limits.
const GRID_DAMPING: [f64; 6] = [0.011, 0.035, 0.08, 0.16, 0.35, 1.0];
/// Spacing of the frequencies in ln f, less than the width of a local minimum.
const GRID_STEP: f64 = 0.06;
/// Largest number of local minima refined at one position, from the lowest of the grid.
const VALLEYS_MOST: usize = 5;
/// A second local minimum of a neighbour is refined if its cost at this position is within this factor of the first result.
const PROMISING: f64 = 1.01;
/// Distance of the start of a search from the limits, in ln f: at a limit the cost has no slope.
const WITHIN: f64 = 0.02;
/// Largest number of passes in which better minima spread to neighbours.
const SWEEPS_MOST: usize = 4;

/// Effect of a damper at each position, with the tuning that the options require.
///
/// # Errors
/// [`DamperError`] if the damper is outside its range, or if the goal is a peak, which maps do not support.
///
/// # Limits
/// Finds the best tuning within [`Plan::tuning_range_hz`]. Positions with the same lever arm, which differ only along the damper's direction, act
/// alike and are searched once. At 12 lever arms the search evaluates a grid of frequencies, 6 % apart, and 6 damping ratios, and refines the
/// lowest local minima. At every other one it starts from the minima of the nearest of these and of the previous one, and again from the tuning of
/// a neighbour if that is better. The tolerance of the tuning is 1e-4.
///
/// Tested by `damper_designs`.
pub fn position_map(
    plan: &Plan,
    damper: &PlacedDamper,
    options: &PositionMapOptions,
) -> Result<PositionMap, DamperError> {
    plan.judge(std::slice::from_ref(damper))?;
    if options.goal == Goal::LargestPeak {
        return Err(DamperError::NoMap);
    }
    let points = plan.problem().points.len();
    let weights = match options.weights.is_empty() {
        true => vec![1.0; points],
        false => options.weights.clone(),
    };
    if weights.len() != points || weights.iter().any(|w| w.is_nan() || *w <= 0.0) {
        return Err(DamperError::Argument {
            argument: "number of positive weights",
            given: weights.iter().filter(|w| **w > 0.0).count() as f64,
            allowed: "one a point",
        });
    }
    let looked = SearchData {
        plan,
        given: *damper,
        options,
        weights,
    };
    let (places, arms) = looked.distinct_places();
    let found = looked.along(&places);
    let cells = arms.iter().enumerate().map(|(at, arm)| {
        let mut cell = found[(*arm)?].clone()?;
        cell.damper.place_m = options.place(at);
        Some(cell)
    });
    Ok(PositionMap {
        x_m: options.x_m.clone(),
        y_m: options.y_m.clone(),
        cells: cells.collect(),
    })
}

/// Effect of a damper at positions in order along a line, with the tuning that the options require. Positions where the mode of the tuning does
/// not move are left out.
pub(super) fn along_line(
    plan: &Plan,
    damper: &PlacedDamper,
    places_m: &[[f64; 2]],
    options: &PositionMapOptions,
) -> Vec<MapCell> {
    let looked = SearchData {
        plan,
        given: *damper,
        options,
        weights: match options.weights.is_empty() {
            true => vec![1.0; plan.problem().points.len()],
            false => options.weights.clone(),
        },
    };
    looked.along(places_m).into_iter().flatten().collect()
}

struct SearchData<'a> {
    plan: &'a Plan,
    given: PlacedDamper,
    options: &'a PositionMapOptions,
    weights: Vec<f64>,
}

/// Result of a search from which the next one starts: ln f, ln ζ and the curvature.
struct WarmStart {
    x: Vec<f64>,
    curvature: Option<Vec<Vec<f64>>>,
}

impl WarmStart {
    fn of(damper: &PlacedDamper) -> Self {
        WarmStart {
            x: vec![damper.frequency_hz.ln(), damper.damping_ratio.ln()],
            curvature: None,
        }
    }
}

impl SearchData<'_> {
    /// Frequency range of the grid, Hz: that of the plan, or around the given frequency if no mode is excited.
    fn range_hz(&self) -> [f64; 2] {
        match self.plan.tuning_range_hz() {
            [low, high] if low > 0.0 && high.is_finite() => [low, high],
            _ => [0.5 * self.given.frequency_hz, 2.0 * self.given.frequency_hz],
        }
    }

    fn mean(&self) -> bool {
        self.options.goal == Goal::MeanSquare
    }

    /// The positions of a map on the floor that differ in their effect, and for each cell the index of its position among them; `None` outside
    /// the floor. The effect depends on a position only through its lever arm, the factor of θ in its motion, in whose order the positions stand.
    fn distinct_places(&self) -> (Vec<[f64; 2]>, Vec<Option<usize>>) {
        let site = &self.plan.problem().sites[self.given.site];
        let arm = |place_m: [f64; 2]| site.coefficients(place_m, self.given.direction_degrees)[2];
        let cells = self.options.x_m.len() * self.options.y_m.len();
        let mut inside: Vec<(f64, usize)> = (0..cells)
            .filter(|&cell| site.nearest_m(self.options.place(cell)).1 <= 0.0)
            .map(|cell| (arm(self.options.place(cell)), cell))
            .collect();
        inside.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let [x, y] = site.extent_m();
        let apart_m = SAME_ARM * (x[1] - x[0]).max(y[1] - y[0]);
        let (mut places, mut arms) = (Vec::new(), vec![None; cells]);
        let mut last = f64::NEG_INFINITY;
        for (arm, cell) in inside {
            if arm - last > apart_m {
                places.push(self.options.place(cell));
                last = arm;
            }
            arms[cell] = Some(places.len() - 1);
        }
        (places, arms)
    }

    /// The damper at positions that stand in the order of their lever arms; `None` where the mode of the tuning does not move.
    fn along(&self, places: &[[f64; 2]]) -> Vec<Option<MapCell>> {
        let single = |place_m: [f64; 2]| {
            SingleDamper::new(
                self.plan,
                &PlacedDamper {
                    place_m,
                    ..self.given
                },
            )
        };
        if self.options.tuning != MapTuning::Best {
            let each = places.par_iter();
            return each
                .map(|&place_m| self.tuned(&single(place_m), place_m, &mut None))
                .collect();
        }
        let coarse = self.coarse(places);
        let mut cells: Vec<Option<MapCell>> = vec![None; places.len()];
        // each part is computed alone, so that the result does not depend on the number of threads
        let parts = cells.par_chunks_mut(PART).enumerate();
        parts.for_each(|(part, cells)| {
            let mut before = None;
            for (i, cell) in cells.iter_mut().enumerate() {
                let at = PART * part + i;
                let near = coarse.iter().min_by_key(|(other, _)| other.abs_diff(at));
                let starts = near.map_or(&[][..], |(_, valleys)| valleys);
                *cell = self.followed(&single(places[at]), places[at], starts, &mut before);
            }
        });
        self.spread(&mut cells);
        cells
    }

    /// Tunings at a few of the positions, with all local minima.
    fn coarse(&self, places: &[[f64; 2]]) -> Vec<(usize, Vec<PlacedDamper>)> {
        let step = places.len().div_ceil(COARSE).max(1);
        let few: Vec<usize> = (step / 2..places.len()).step_by(step).collect();
        let each = few.into_par_iter().map(|at| {
            let place_m = places[at];
            let there = PlacedDamper {
                place_m,
                ..self.given
            };
            let valleys = self.valleys(&SingleDamper::new(self.plan, &there), place_m);
            (at, valleys.iter().map(|cell| cell.damper).collect())
        });
        each.collect()
    }

    /// Local minima at a position: the lowest points of a grid of frequency and damping, each refined.
    fn valleys(&self, single: &SingleDamper, place_m: [f64; 2]) -> Vec<MapCell> {
        let [low, high] = self.range_hz().map(f64::ln);
        let frequencies = ((high - low) / GRID_STEP).ceil() as usize + 1;
        let least = self.plan.damping_least();
        let at = |i: usize, j: usize| {
            let part = i as f64 / (frequencies - 1) as f64;
            PlacedDamper {
                place_m,
                frequency_hz: (low + WITHIN + part * (high - low - 2.0 * WITHIN)).exp(),
                damping_ratio: GRID_DAMPING[j].max(1.02 * least),
                ..self.given
            }
        };
        let dampings = GRID_DAMPING.len();
        let costs: Vec<f64> = (0..frequencies * dampings)
            .map(|k| self.cost_of(single, &at(k / dampings, k % dampings)))
            .collect();
        let is_valley = |k: &usize| {
            let (i, j) = (k / dampings, k % dampings);
            let rows = i.saturating_sub(1)..=(i + 1).min(frequencies - 1);
            let mut around = rows.flat_map(|i| {
                let columns = j.saturating_sub(1)..=(j + 1).min(dampings - 1);
                columns.map(move |j| i * dampings + j)
            });
            around.all(|other| costs[*k] <= costs[other])
        };
        let mut lowest: Vec<usize> = (0..costs.len()).filter(is_valley).collect();
        lowest.sort_by(|a, b| costs[*a].total_cmp(&costs[*b]));
        lowest.truncate(VALLEYS_MOST);
        let down = lowest.into_iter().filter_map(|k| {
            let start = at(k / dampings, k % dampings);
            self.tuned(single, place_m, &mut Some(WarmStart::of(&start)))
        });
        down.collect()
    }

    fn cost_of(&self, single: &SingleDamper, damper: &PlacedDamper) -> f64 {
        self.cell(single, *damper).cost
    }

    /// The damper tuned at a position, from the most promising tunings of other positions.
    fn followed(
        &self,
        single: &SingleDamper,
        place_m: [f64; 2],
        starts: &[PlacedDamper],
        before: &mut Option<WarmStart>,
    ) -> Option<MapCell> {
        let mut all: Vec<(f64, WarmStart)> = starts
            .iter()
            .map(WarmStart::of)
            .chain(before.take())
            .map(|start| {
                let damper = PlacedDamper {
                    frequency_hz: start.x[0].exp(),
                    damping_ratio: start.x[1].exp(),
                    ..self.given
                };
                (self.cost_of(single, &damper), start)
            })
            .collect();
        all.sort_by(|(a, _), (b, _)| a.total_cmp(b));
        let mut best: Option<MapCell> = None;
        for (cost, start) in all.into_iter().take(2) {
            if best.as_ref().is_some_and(|best| cost > PROMISING * best.cost) {
                break;
            }
            let mut ended = Some(start);
            let found = self.tuned(single, place_m, &mut ended);
            if let Some(found) = found.filter(|found| best.as_ref().is_none_or(|best| found.cost < best.cost))
            {
                best = Some(found);
                *before = ended;
            }
        }
        best
    }

    /// The damper tuned at a position from one start.
    fn tuned(
        &self,
        single: &SingleDamper,
        place_m: [f64; 2],
        before: &mut Option<WarmStart>,
    ) -> Option<MapCell> {
        let mut damper = PlacedDamper {
            place_m,
            ..self.given
        };
        match self.options.tuning {
            MapTuning::Kept => {}
            MapTuning::Rule {
                rule,
                mode,
                structure_damping_ratio,
            } => {
                let ratio = damper.mass_kg / self.plan.modal_mass_kg(mode, &damper).ok()?;
                let column = ColumnAsMass::new(ratio, damper.length_ratio);
                let tuning = column.rule(rule, structure_damping_ratio).ok()?;
                damper.frequency_hz = tuning.frequency_ratio * self.plan.mode_frequency_hz(mode)?;
                damper.damping_ratio = tuning.damping_ratio;
            }
            MapTuning::Best => {
                let mut start = vec![damper.frequency_hz.ln(), damper.damping_ratio.ln()];
                let mut options = Minimax {
                    step_least: STEP_LEAST,
                    ..Minimax::steps(ITERATIONS_MOST)
                };
                if let Some(WarmStart { x, curvature }) = before.take() {
                    (start, options.curvature) = (x, curvature);
                }
                let least = (1.02 * self.plan.damping_least()).ln();
                start[1] = start[1].max(least);
                let range_hz = self.range_hz();
                let [low, high] = range_hz.map(f64::ln);
                start[0] = start[0].clamp(low + WITHIN, high - WITHIN);
                let limits = (range_hz, self.plan.damping_least());
                let mut search = SingleDamperSearch::new(single, &self.weights, self.mean(), limits);
                let found = minimax(start, &options, &mut search)?;
                [damper.frequency_hz, damper.damping_ratio] = search.within(&found.x);
                *before = Some(WarmStart {
                    x: vec![damper.frequency_hz.ln(), damper.damping_ratio.ln()],
                    curvature: Some(found.curvature),
                });
            }
        }
        Some(self.cell(single, damper))
    }

    fn cell(&self, single: &SingleDamper, damper: PlacedDamper) -> MapCell {
        let values = single.judge(damper.frequency_hz, damper.damping_ratio);
        let point_rms: Vec<f64> = values.iter().map(|value| value.ln_rms.exp()).collect();
        let weighted = point_rms
            .iter()
            .zip(&self.weights)
            .map(|(rms, weight)| rms * weight);
        let cost = match self.mean() {
            true => (weighted.map(|value| value * value).sum::<f64>() / point_rms.len() as f64).sqrt(),
            false => weighted.fold(0.0, f64::max),
        };
        let [low, high] = self.range_hz();
        let ends = [
            (damper.frequency_hz, [low, high]),
            (damper.damping_ratio, [self.plan.damping_least(), DAMPING_MOST]),
        ];
        let at_end =
            |(value, ends): &(f64, [f64; 2])| ends.iter().any(|end| (value / end - 1.0).abs() < 1e-9);
        MapCell {
            at_limit: self.options.tuning == MapTuning::Best && ends.iter().any(at_end),
            damper,
            point_rms,
            cost,
        }
    }

    /// Repeats the search where the tuning of a neighbour gives a lower cost: there the first search ended in another local minimum.
    fn spread(&self, cells: &mut [Option<MapCell>]) {
        for _ in 0..SWEEPS_MOST {
            let mut changed = false;
            for at in (0..cells.len()).rev() {
                let Some(own) = cells[at].clone() else { continue };
                let neighbours = [at.checked_sub(1), Some(at + 1)];
                let single = SingleDamper::new(self.plan, &own.damper);
                let others = neighbours.into_iter().flatten();
                let others = others.filter_map(|k| cells.get(k).and_then(Option::as_ref));
                let borrowed = others.map(|other| {
                    let damper = PlacedDamper {
                        place_m: own.damper.place_m,
                        ..other.damper
                    };
                    self.cell(&single, damper)
                });
                let best = borrowed.reduce(|best, next| if next.cost < best.cost { next } else { best });
                let Some(best) = best.filter(|best| best.cost < own.cost * (1.0 - BETTER)) else {
                    continue;
                };
                let mut before = Some(WarmStart::of(&best.damper));
                let found = self.tuned(&single, own.damper.place_m, &mut before);
                if let Some(found) = found.filter(|found| found.cost < own.cost) {
                    cells[at] = Some(found);
                    changed = true;
                }
            }
            if !changed {
                break;
            }
        }
    }
}
