//! Compares a given damper with the rule of Hwang, Min & Hong and with the optimum: place, tuning, and the cost of each.

use super::design::{Searched, searched};
use super::position_map::along_line;
use super::{Aim, DamperSite};
use super::{
    ColumnAsMass, DamperError, DesignEnd, DesignOptions, Detuned, Freedom, Goal, Judged, MapCell, MapTuning,
    Place, PlacedDamper, Plan, PositionMap, PositionMapOptions, RobustnessPoint, SingleMode, Tuning,
    TuningRule, cost_of, goal_cost, optimal_tuning, point_values, position_map, robustness,
};
use crate::structure::building::nearest_on_side;

/// Scope and resolution of a comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct ComparisonOptions {
    /// The target mode of the damper, from 0.
    pub mode: usize,
    /// Damping ratio of that mode.
    pub structure_damping_ratio: f64,
    /// Whether the load is a base acceleration. This selects the exact single-mode tunings in the table.
    pub base: bool,
    /// The quantity to minimise; [`Goal::LargestRms`] by default.
    pub goal: Goal,
    /// Number of map places along x and along y; 60 each by default (our choice).
    pub map_places: [usize; 2],
    /// Number of places along the line; 61 by default (our choice).
    pub line_places: usize,
    /// Largest detuning d in the robustness curves, as factors 1 ± d on frequency and damping; 0.2 by default (our choice).
    pub detuning: f64,
    /// Largest allowed standard deviation of the stroke of a designed damper, as a multiple of that of the given damper; no limit by default.
    pub stroke_most: Option<f64>,
    /// Relative frequency error d that a design must tolerate: the worst of f (1 − d), f, f (1 + d) is minimised; 0 by default.
    pub off_by: f64,
}

impl Default for ComparisonOptions {
    fn default() -> Self {
        ComparisonOptions {
            mode: 0,
            structure_damping_ratio: 0.0,
            base: false,
            goal: Goal::LargestRms,
            map_places: [60, 60],
            line_places: 61,
            detuning: 0.2,
            stroke_most: None,
            off_by: 0.0,
        }
    }
}

/// The damper in a row of the comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Choice {
    /// The damper as given.
    Given,
    /// The given tuning at the rule's place, farthest from the centre of the mode.
    Rule,
    /// The best tuning at the given place.
    TunedBest,
    /// The given tuning at the best place.
    PlacedBest,
    /// Place and tuning optimised together.
    Best,
}

impl Choice {
    /// Name of the choice in JSON.
    pub fn name(self) -> &'static str {
        match self {
            Choice::Given => "given",
            Choice::Rule => "rule",
            Choice::TunedBest => "tuned_best",
            Choice::PlacedBest => "placed_best",
            Choice::Best => "best",
        }
    }
}

/// One damper of the comparison and its effect.
#[derive(Clone, Debug, PartialEq)]
pub struct Compared {
    /// How the damper was chosen.
    pub choice: Choice,
    /// The damper.
    pub damper: PlacedDamper,
    /// Standard deviations from the assembled matrices.
    pub judged: Judged,
    /// The quantity of the goal at each point: standard deviation, or largest amplitude under a harmonic load.
    pub point_values: Vec<f64>,
    /// Value of the goal.
    pub cost: f64,
    /// The end of the search; `None` without a search.
    pub end: Option<DesignEnd>,
}

/// One row of the table of tunings, for one mode and the mass ratio of the given damper.
#[derive(Clone, Debug, PartialEq)]
pub struct TuningRow {
    /// The closed form; `None` for the exact optimum of the mode including its damping.
    pub rule: Option<TuningRule>,
    /// The quantity that the exact optimum minimises; `None` for a closed form.
    pub aim: Option<Aim>,
    /// Frequency and damping.
    pub tuning: Tuning,
    /// The damper at its given place with this tuning.
    pub damper: PlacedDamper,
    /// The quantity of the goal at each point with this damper.
    pub point_values: Vec<f64>,
    /// Value of the goal.
    pub cost: f64,
}

/// The whole comparison.
#[derive(Clone, Debug, PartialEq)]
pub struct Comparison {
    /// Modal mass of the mode at the damper's place, kg.
    pub modal_mass_kg: f64,
    /// Mass of the damper over that modal mass.
    pub mass_ratio: f64,
    /// The quantity of the goal at each point without a damper.
    pub without: Vec<f64>,
    /// Value of the goal without a damper.
    pub cost_without: f64,
    /// The dampers in the order given, rule, tuned, placed, both.
    pub rows: Vec<Compared>,
    /// Closed forms and exact optima.
    pub tunings: Vec<TuningRow>,
    /// Places on the line through the given place across the damper's direction, with the given tuning; empty if the goal is a peak.
    pub line_given: Vec<MapCell>,
    /// The same places, each with its best tuning.
    pub line_best: Vec<MapCell>,
    /// Places in plan, each with its best tuning; without cells if the goal is a peak.
    pub map: PositionMap,
    /// Cost of the given damper and of the best damper with detuned frequency.
    pub off_frequency: [Vec<RobustnessPoint>; 2],
    /// Their cost with detuned damping.
    pub off_damping: [Vec<RobustnessPoint>; 2],
    /// Accuracy at the prepared frequencies, which maps, lines, tunings, robustness curves and searches use. This is the largest relative
    /// difference to the standard deviations from the assembled matrices, over the rows, the ends of the curves and places of the map. Results
    /// with 1e-3 or more are rough, because structure or damper has too little damping.
    pub apart: f64,
}

impl Comparison {
    /// The row of a choice.
    pub fn row(&self, choice: Choice) -> Option<&Compared> {
        self.rows.iter().find(|row| row.choice == choice)
    }
}

/// Range of frequency ratio and damping in which an optimum is a realistic damper. Our choice.
const SENSIBLE: std::ops::RangeInclusive<f64> = 0.2..=2.0;
const DAMPING_SENSIBLE: f64 = 1.0;
const DETUNINGS: usize = 21;
/// Number of places along each side of the floor that the rule considers.
const SIDE_PLACES: usize = 40;
/// Relative difference below which two costs count as equal.
const SAME: f64 = 1e-6;

/// Compares a given damper with the rule and with the optimum.
///
/// # Errors
/// [`DamperError::ModeStill`] if the mode does not move the damper; [`DamperError::MassRatio`] if the damper is heavier than the mode; otherwise
/// as in [`super::design()`].
pub fn compare(
    plan: &Plan,
    given: &PlacedDamper,
    options: &ComparisonOptions,
) -> Result<Comparison, DamperError> {
    let modal_mass_kg = plan.modal_mass_kg(options.mode, given)?;
    let mode = SingleMode {
        mass_ratio: given.mass_kg / modal_mass_kg,
        structure_damping_ratio: options.structure_damping_ratio,
    };
    super::tuning::check(mode.mass_ratio, mode.structure_damping_ratio)?;
    let random = match options.goal {
        Goal::LargestPeak => Goal::LargestRms, // maps and lines show standard deviations
        goal => goal,
    };
    let mut over =
        PositionMapOptions::over_site(plan, given.site, options.map_places[0], options.map_places[1])
            .unwrap_or(PositionMapOptions {
                x_m: Vec::new(),
                y_m: Vec::new(),
                tuning: MapTuning::Best,
                goal: random,
                weights: Vec::new(),
            });
    over.goal = random;
    let map = position_map(plan, given, &over)?;
    let here = along_line(plan, given, &[given.place_m], &over);
    over.tuning = MapTuning::Kept;
    let kept = position_map(plan, given, &over)?;
    let mapped = options.goal != Goal::LargestPeak;
    let line = if mapped {
        line(plan, given, options.line_places)
    } else {
        Vec::new()
    };
    let line_given = along_line(plan, given, &line, &over);
    over.tuning = MapTuning::Best;
    let line_best = along_line(plan, given, &line, &over);
    let rows = rows(plan, given, options, ([&kept, &map], here.first()))?;
    let best = rows.last().map_or(*given, |row| row.damper);
    let factors: Vec<f64> = (0..DETUNINGS)
        .map(|i| 1.0 + options.detuning * (2.0 * i as f64 / (DETUNINGS - 1) as f64 - 1.0))
        .collect();
    let apart = apart(plan, &rows, &map)?;
    let off = |damper: PlacedDamper, detuned| robustness(plan, &[damper], options.goal, detuned, &factors);
    Ok(Comparison {
        modal_mass_kg,
        mass_ratio: mode.mass_ratio,
        without: match options.goal {
            Goal::LargestPeak => point_values(plan, &[], options.goal)?,
            _ => plan.without().to_vec(),
        },
        cost_without: goal_cost(plan, &[], options.goal)?,
        tunings: tunings(plan, given, &mode, options)?,
        off_frequency: [off(*given, Detuned::Frequency)?, off(best, Detuned::Frequency)?],
        off_damping: [off(*given, Detuned::Damping)?, off(best, Detuned::Damping)?],
        apart,
        rows,
        line_given,
        line_best,
        map: match mapped {
            true => map,
            false => PositionMap {
                x_m: Vec::new(),
                y_m: Vec::new(),
                cells: Vec::new(),
            },
        },
    })
}

/// Largest error of the standard deviations at the prepared frequencies.
fn apart(plan: &Plan, rows: &[Compared], map: &PositionMap) -> Result<f64, DamperError> {
    const CELLS: usize = 5;
    let mut most = 0.0_f64;
    for row in rows {
        most = most.max(row_apart(plan, row)?);
    }
    let mut trials: Vec<PlacedDamper> = Vec::new();
    for row in rows.iter().take(1).chain(rows.last()) {
        for factor in [0.8, 0.94, 1.06, 1.2] {
            trials.push(PlacedDamper {
                frequency_hz: factor * row.damper.frequency_hz,
                ..row.damper
            });
        }
    }
    let cells: Vec<&MapCell> = map.cells.iter().flatten().collect();
    let step = (cells.len() / CELLS).max(1);
    trials.extend(cells.iter().skip(step / 2).step_by(step).map(|cell| cell.damper));
    for damper in trials {
        most = most.max(rms_apart(&plan.exact(&[damper])?, &plan.judge(&[damper])?));
    }
    Ok(most)
}

/// Error of the standard deviations of a row at the prepared frequencies.
pub(super) fn row_apart(plan: &Plan, row: &Compared) -> Result<f64, DamperError> {
    Ok(rms_apart(&row.judged, &plan.judge(&[row.damper])?))
}

fn rms_apart(exact: &Judged, near: &Judged) -> f64 {
    let pairs = exact.point_rms.iter().zip(&near.point_rms);
    pairs.map(|(a, b)| (b / a - 1.0).abs()).fold(0.0, f64::max)
}

fn rows(
    plan: &Plan,
    given: &PlacedDamper,
    options: &ComparisonOptions,
    ([kept, best], here): ([&PositionMap; 2], Option<&MapCell>),
) -> Result<Vec<Compared>, DamperError> {
    let as_given = compared(plan, Choice::Given, given, options.goal)?;
    let stroke_most_m = stroke_most_m(&as_given, options);
    let designed = |choice, starts: &[PlacedDamper], place, tuning| -> Result<Compared, DamperError> {
        let how = DesignOptions {
            place,
            frequency: tuning,
            damping: tuning,
            ..design_options(options, stroke_most_m)
        };
        // among equally good places the place on the line is preferred, so it is tried first
        let starts = starts
            .iter()
            .flat_map(|start| [on_line(plan, given, start), *start]);
        let found = best_from(plan, starts, &how)?;
        Ok(Compared {
            end: Some(found.end),
            ..compared(plan, choice, &found.dampers[0], options.goal)?
        })
    };
    let near = |map: &PositionMap| best_near(map, given).map_or(*given, |cell| cell.damper);
    let here = here.map_or(*given, |cell| cell.damper);
    let tuned = designed(Choice::TunedBest, &[*given, here], Place::Kept, Freedom::Free)?;
    let placed = designed(Choice::PlacedBest, &[near(kept)], Place::Anywhere, Freedom::Kept)?;
    let starts = [tuned.damper, near(best)];
    let both = designed(Choice::Best, &starts, Place::Anywhere, Freedom::Free)?;
    let rule = rule_place(plan, given, options.mode);
    let rule = compared(plan, Choice::Rule, &rule, options.goal)?;
    Ok(vec![as_given, rule, tuned, placed, both])
}

/// A damper and its effect, from the assembled matrices; peaks are those of the prepared receptances.
pub(super) fn compared(
    plan: &Plan,
    choice: Choice,
    damper: &PlacedDamper,
    goal: Goal,
) -> Result<Compared, DamperError> {
    let judged = plan.exact(&[*damper])?;
    let (point_values, cost) = match goal {
        Goal::LargestPeak => (
            point_values(plan, &[*damper], goal)?,
            goal_cost(plan, &[*damper], goal)?,
        ),
        goal => (judged.point_rms.clone(), cost_of(&judged, goal)),
    };
    Ok(Compared {
        choice,
        damper: *damper,
        judged,
        point_values,
        cost,
        end: None,
    })
}

/// Upper bound on the standard deviation of the stroke of a designed damper, m.
pub(super) fn stroke_most_m(given: &Compared, options: &ComparisonOptions) -> Option<f64> {
    let stroke = given.judged.stroke_rms_m.first()?;
    options.stroke_most.map(|most| most * stroke)
}

/// Options of a design with place and tuning free.
pub(super) fn design_options(options: &ComparisonOptions, stroke_most_m: Option<f64>) -> DesignOptions {
    DesignOptions {
        goal: options.goal,
        stroke_rms_most_m: stroke_most_m,
        detuning_ratio: options.off_by,
        ..DesignOptions::default()
    }
}

/// The best design from several starts; of equally good ones the first.
pub(super) fn best_from(
    plan: &Plan,
    starts: impl Iterator<Item = PlacedDamper>,
    how: &DesignOptions,
) -> Result<Searched, DamperError> {
    let mut found: Option<Searched> = None;
    for start in starts {
        let next = searched(plan, &[start], how)?;
        let is_better = |found: &Searched| next.cost < found.cost * (1.0 - SAME);
        if found.as_ref().is_none_or(is_better) {
            found = Some(next);
        }
    }
    found.ok_or(DamperError::NoOptimum {
        what: "the damper's place",
        iterations: 0,
    })
}

/// Moves the damper along its direction onto the line through the given place: its modal motion is the same there.
fn on_line(plan: &Plan, given: &PlacedDamper, damper: &PlacedDamper) -> PlacedDamper {
    let site = &plan.problem().sites[given.site];
    let [cos, sin, _] = site.coefficients(site.reference_m, given.direction_degrees);
    let apart = [0, 1].map(|i| damper.place_m[i] - given.place_m[i]);
    let along = apart[0] * cos + apart[1] * sin;
    let place_m = [damper.place_m[0] - along * cos, damper.place_m[1] - along * sin];
    match site.nearest_m(place_m).1 > 0.0 {
        true => *damper,
        false => PlacedDamper { place_m, ..*damper },
    }
}

fn far(a: &PlacedDamper, b: &PlacedDamper) -> f64 {
    (a.place_m[0] - b.place_m[0]).hypot(a.place_m[1] - b.place_m[1])
}

/// The best place of a map; if several are equally good, the one nearest to the given damper.
fn best_near<'a>(map: &'a PositionMap, given: &PlacedDamper) -> Option<&'a MapCell> {
    let least = map.best()?.cost;
    let as_good = map
        .cells
        .iter()
        .flatten()
        .filter(|cell| cell.cost <= least * (1.0 + SAME));
    as_good.reduce(
        |best, next| match far(&next.damper, given) < far(&best.damper, given) {
            true => next,
            false => best,
        },
    )
}

/// The damper at the place with the largest modal motion along its direction, farthest from the centre of the mode; if several are equally far,
/// the nearest one.
fn rule_place(plan: &Plan, given: &PlacedDamper, mode: usize) -> PlacedDamper {
    let site: &DamperSite = &plan.problem().sites[given.site];
    let sides = site.corners_m.iter().zip(site.corners_m.iter().cycle().skip(1));
    let here = plan
        .modal_mass_kg(mode, given)
        .map_or(0.0, |mass| 1.0 / mass.sqrt());
    let mut best = (*given, here);
    for (a, b) in sides {
        let foot = nearest_on_side(*a, *b, given.place_m);
        let shares = (0..=SIDE_PLACES).map(|i| i as f64 / SIDE_PLACES as f64);
        let places = shares.map(|t| [0, 1].map(|i| a[i] + t * (b[i] - a[i])));
        for place_m in places.chain([foot]) {
            let damper = PlacedDamper { place_m, ..*given };
            let moves = plan
                .modal_mass_kg(mode, &damper)
                .map_or(0.0, |mass| 1.0 / mass.sqrt());
            let same = (moves / best.1 - 1.0).abs() < SAME;
            let nearer = far(&damper, given) < far(&best.0, given) * (1.0 - SAME);
            if (moves > best.1 && !same) || (same && nearer) {
                best = (damper, moves);
            }
        }
    }
    best.0
}

/// Places on the line through the damper across its direction, from one edge of the floor to the other.
fn line(plan: &Plan, given: &PlacedDamper, places: usize) -> Vec<[f64; 2]> {
    let site = &plan.problem().sites[given.site];
    let [cos, sin, _] = site.coefficients(site.reference_m, given.direction_degrees);
    let across = match sin >= 0.0 {
        true => [sin, -cos],
        false => [-sin, cos],
    };
    let [x, y] = site.extent_m();
    let reach = (x[1] - x[0]).hypot(y[1] - y[0]);
    // fine steps in both directions; only the contiguous part on the floor is kept
    const WALK: i32 = 4000;
    let at = |s: f64| [0, 1].map(|i| given.place_m[i] + s * across[i]);
    let on = |s: f64| site.nearest_m(at(s)).1 < 1e-9 * reach;
    let walk = |sign: f64| {
        let steps = (1..=WALK).map(|i| sign * reach * f64::from(i) / f64::from(WALK));
        let mut inside = steps.take_while(|s| on(*s)).last().unwrap_or(0.0);
        let mut outside = inside + sign * reach / f64::from(WALK);
        for _ in 0..60 {
            let middle = 0.5 * (inside + outside);
            if on(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    };
    let (low, high) = (walk(-1.0), walk(1.0));
    (0..places)
        .map(|i| at(low + (high - low) * i as f64 / (places.max(2) - 1) as f64))
        .map(|place_m| site.nearest_m(place_m).0)
        .collect()
}

fn tunings(
    plan: &Plan,
    given: &PlacedDamper,
    mode: &SingleMode,
    options: &ComparisonOptions,
) -> Result<Vec<TuningRow>, DamperError> {
    let own = plan.mode_frequency_hz(options.mode).unwrap_or(f64::NAN);
    let column = ColumnAsMass::new(mode.mass_ratio, given.length_ratio);
    let row = |rule, aim, tuning: Tuning| -> Result<TuningRow, DamperError> {
        let damper = PlacedDamper {
            frequency_hz: tuning.frequency_ratio * own,
            damping_ratio: tuning.damping_ratio,
            ..*given
        };
        Ok(TuningRow {
            rule,
            aim,
            tuning,
            damper,
            point_values: point_values(plan, &[damper], options.goal)?,
            cost: goal_cost(plan, &[damper], options.goal)?,
        })
    };
    let mut rows = Vec::new();
    for rule in TuningRule::ALL {
        let tuning = column.rule(rule, mode.structure_damping_ratio)?;
        rows.push(row(Some(rule), None, tuning)?);
    }
    let aims = match options.base {
        false => [Aim::ForceRandom, Aim::ForceHarmonic],
        true => [Aim::BaseRandom, Aim::BaseHarmonic],
    };
    for aim in aims {
        let heavier = SingleMode {
            mass_ratio: column.mass_ratio,
            structure_damping_ratio: column.frequency_factor * mode.structure_damping_ratio,
        };
        // without an optimum, or if it degenerates to a pure dashpot, there is no tuning and the row is left out
        let found = optimal_tuning(&heavier, aim).ok().map(|found| found.tuning);
        let is_damper = |tuning: &Tuning| {
            SENSIBLE.contains(&tuning.frequency_ratio) && tuning.damping_ratio <= DAMPING_SENSIBLE
        };
        if let Some(tuning) = found.filter(is_damper) {
            rows.push(row(None, Some(aim), column.of_mode(tuning))?);
        }
    }
    Ok(rows)
}
