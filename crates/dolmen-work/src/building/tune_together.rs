//! `dolmen tune` for all dampers of a building together.

use super::tune_answer::{TogetherAnswer, TogetherChoice, TogetherRow, TunePoint};
use super::tune_room::room_check;
use super::tuned::{self, TuneOptions, degrees, placed};
use crate::error::WorkError;
use dolmen::damper::{
    AttachedDamper, DamperKind, DamperProblem, DamperSite, DesignEnd, DesignOptions, Freedom, Goal, Judged,
    PlacedDamper, Plan, PlanOptions, TogetherOptions, cost_of, design, judge, tune_together,
};
use dolmen::structure::Building;
use dolmen::structure::building::PlanDirection;
use dolmen_project::{BuiltDamper, Project, Quantity};
use dolmen_records::Files;

/// Steps of the search for places of several dampers. Our choice: enough for four.
const ITERATIONS_MOST: usize = 60;

/// All dampers together; `None` if there is only one mass or column.
pub(crate) fn of_all(
    (project, variant): (&Project, Option<String>),
    (file, files): (&str, &dyn Files),
    options: &TuneOptions,
) -> Result<Option<TogetherAnswer>, WorkError> {
    let part = tuned::part_of(project)?;
    let vibrating = tuned::standing(part)?;
    let dampers = part.dampers(vibrating, &mut Quantity::nominal)?;
    if dampers.is_empty() || (dampers.len() == 1 && placed(&dampers[0], 0).is_some()) {
        return Ok(None);
    }
    let building = vibrating.building();
    let directions = distinct(&dampers);
    let floor = dampers[0].floor;
    let corners_m = building.floors()[floor - 1]
        .outline
        .as_ref()
        .map_or(Vec::new(), |outline| outline.corners_m().to_vec());
    let mut points: Vec<(TunePoint, f64)> = Vec::new();
    let mut rows = Vec::new();
    for point in tuned::points(part, floor, &corners_m) {
        for &direction in &directions {
            let [x, y] = point.place_m;
            rows.push(building.point_row(point.floor, x, y, PlanDirection::Degrees(direction))?);
            points.push((point.clone(), direction));
        }
    }
    let load = options.load;
    let loaded = options
        .load_direction_degrees
        .map_or(directions, |direction| vec![direction]);
    let mut acting = Vec::new();
    for direction in &loaded {
        let direction = PlanDirection::Degrees(*direction);
        acting.extend(tuned::random_loads((project, part), load, direction)?);
    }
    let all = TogetherProblem {
        building,
        dampers: &dampers,
        problem: DamperProblem {
            structure: tuned::structure(building, part)?,
            loads: acting,
            points: rows,
            sites: sites(building, &dampers),
            fixed: Vec::new(),
        },
        goal: match options.goal {
            Goal::LargestPeak => Goal::LargestRms,
            goal => goal,
        },
        options,
    };
    let rows = all.rows()?;
    let each: Vec<Vec<BuiltDamper>> = rows.iter().map(|row| row.dampers.clone()).collect();
    let room = room_check((project, part), files, &each)?;
    Ok(Some(TogetherAnswer {
        off_by: options.off_by,
        file: file.to_owned(),
        name: project.name.clone(),
        variant,
        load,
        load_directions_degrees: loaded,
        points,
        goal: all.goal,
        peaks_not_sought: options.goal == Goal::LargestPeak,
        stroke_most: options.stroke_most,
        rows,
        room,
    }))
}

/// Distinct directions of the dampers, degrees in [0, 180).
fn distinct(dampers: &[BuiltDamper]) -> Vec<f64> {
    let mut all: Vec<f64> = dampers
        .iter()
        .map(|damper| degrees(damper.direction).rem_euclid(180.0))
        .collect();
    all.sort_by(f64::total_cmp);
    all.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    all
}

/// The floors with dampers; one without an outline is only the point of its centre.
fn sites(building: &Building, dampers: &[BuiltDamper]) -> Vec<DamperSite> {
    let mut floors: Vec<usize> = dampers
        .iter()
        .flat_map(|damper| [Some(damper.floor), damper.to.map(|to| to.0)])
        .flatten()
        .filter(|floor| *floor > 0)
        .collect();
    floors.sort_unstable();
    floors.dedup();
    let each = floors.into_iter().map(|floor| {
        tuned::site(building, floor).unwrap_or_else(|_| {
            let centre_m = building.floors()[floor - 1].centre_m;
            DamperSite {
                first_degree_of_freedom: 3 * (floor - 1),
                reference_m: centre_m,
                corners_m: vec![centre_m; 3],
            }
        })
    });
    each.collect()
}

struct TogetherProblem<'a> {
    building: &'a Building,
    dampers: &'a [BuiltDamper],
    problem: DamperProblem,
    goal: Goal,
    options: &'a TuneOptions,
}

impl TogetherProblem<'_> {
    fn rows(&self) -> Result<Vec<TogetherRow>, WorkError> {
        let mut rows = vec![
            self.judged(TogetherChoice::Without, &[])?,
            self.judged(TogetherChoice::Given, self.dampers)?,
        ];
        if self.dampers.len() > 1 {
            for damper in self.dampers {
                let only = TogetherChoice::Only(damper.name.clone());
                rows.push(self.judged(only, std::slice::from_ref(damper))?);
            }
        }
        if self.dampers.len() > 2 {
            for (k, damper) in self.dampers.iter().enumerate() {
                let mut others = self.dampers.to_vec();
                others.remove(k);
                rows.push(self.judged(TogetherChoice::AllBut(damper.name.clone()), &others)?);
            }
        }
        let strokes: Vec<f64> = match (self.options.stroke_most, rows.get(1)) {
            (Some(most), Some(given)) => given.stroke_rms_m.iter().map(|stroke| most * stroke).collect(),
            _ => Vec::new(),
        };
        let tuned = self.tuned(&strokes)?;
        let movable = tuned.dampers.iter().any(|damper| self.placed(damper).is_some());
        let has_outlines = self.dampers.iter().all(|damper| {
            placed(damper, 0).is_none() || self.building.floors()[damper.floor - 1].outline.is_some()
        });
        let start = tuned.clone();
        rows.push(tuned);
        if movable && has_outlines {
            let best = self.best(&start, &strokes, Freedom::Kept)?;
            rows.push(best.clone());
            let masses = start
                .dampers
                .iter()
                .filter(|damper| self.placed(damper).is_some());
            if self.options.share_mass && masses.count() > 1 {
                // the wider search starts at the row above, so that it cannot end worse
                rows.push(self.best(&best, &strokes, Freedom::Free)?);
            }
        }
        Ok(rows)
    }

    fn row(
        &self,
        choice: TogetherChoice,
        dampers: Vec<BuiltDamper>,
        judged: Judged,
        end: Option<DesignEnd>,
    ) -> TogetherRow {
        TogetherRow {
            choice,
            dampers,
            cost: cost_of(&judged, self.goal),
            point_rms: judged.point_rms,
            stroke_rms_m: judged.stroke_rms_m,
            end,
        }
    }

    fn judged(&self, choice: TogetherChoice, dampers: &[BuiltDamper]) -> Result<TogetherRow, WorkError> {
        let attached: Vec<AttachedDamper> = dampers.iter().map(BuiltDamper::attached).collect();
        let problem = &self.problem;
        let judged = judge(&problem.structure, &problem.loads, &problem.points, &attached)?;
        Ok(self.row(choice, dampers.to_vec(), judged, None))
    }

    /// A mass or a column on its site.
    fn placed(&self, damper: &BuiltDamper) -> Option<PlacedDamper> {
        let first = 3 * (damper.floor - 1);
        let mut sites = self.problem.sites.iter();
        let site = sites.position(|site| site.first_degree_of_freedom == first)?;
        placed(damper, site)
    }

    /// Masses that resonate at the frequencies of the dampers, to choose the frequencies of a plan.
    fn expected(&self, damper: &BuiltDamper) -> Vec<PlacedDamper> {
        if let Some(placed) = self.placed(damper) {
            return vec![placed];
        }
        let DamperKind::LiquidColumnMass {
            frequency_hz,
            damping_ratio,
            liquid_frequency_hz,
            liquid_damping_ratio,
            ..
        } = damper.kind
        else {
            return Vec::new();
        };
        let first = 3 * (damper.floor - 1);
        let mut sites = self.problem.sites.iter();
        let site = sites.position(|site| site.first_degree_of_freedom == first);
        let each = [
            (frequency_hz, damping_ratio),
            (liquid_frequency_hz, liquid_damping_ratio),
        ];
        each.into_iter()
            .filter_map(|(frequency_hz, damping_ratio)| {
                Some(PlacedDamper {
                    site: site?,
                    place_m: damper.place_m,
                    direction_degrees: degrees(damper.direction),
                    mass_kg: damper.kind.mass_kg(),
                    frequency_hz,
                    damping_ratio,
                    length_ratio: 1.0,
                })
            })
            .collect()
    }

    fn tuned(&self, stroke_rms_most_m: &[f64]) -> Result<TogetherRow, WorkError> {
        let expected: Vec<PlacedDamper> = self
            .dampers
            .iter()
            .flat_map(|damper| self.expected(damper))
            .collect();
        let plan = Plan::new(self.problem.clone(), &expected, &PlanOptions::default())?;
        let attached: Vec<AttachedDamper> = self.dampers.iter().map(BuiltDamper::attached).collect();
        let how = TogetherOptions {
            goal: self.goal,
            stroke_rms_most_m: stroke_rms_most_m.to_vec(),
            ..TogetherOptions::default()
        };
        let found = tune_together(&plan, &attached, &how)?;
        let dampers = self
            .dampers
            .iter()
            .zip(found.dampers)
            .map(|(damper, tuned)| BuiltDamper {
                kind: tuned.kind,
                tuning: None,
                ..damper.clone()
            });
        Ok(self.row(
            TogetherChoice::TunedBest,
            dampers.collect(),
            found.judged,
            Some(found.end),
        ))
    }

    /// Masses and columns with places and tunings optimised, the others as tuned before.
    fn best(
        &self,
        start: &TogetherRow,
        strokes: &[f64],
        mass_split: Freedom,
    ) -> Result<TogetherRow, WorkError> {
        let fixed = start
            .dampers
            .iter()
            .filter(|damper| self.placed(damper).is_none());
        let problem = DamperProblem {
            fixed: fixed.map(BuiltDamper::attached).collect(),
            ..self.problem.clone()
        };
        let movable: Vec<PlacedDamper> = start
            .dampers
            .iter()
            .filter_map(|damper| self.placed(damper))
            .collect();
        let plan = Plan::new(problem, &movable, &PlanOptions::default())?;
        let how = DesignOptions {
            goal: self.goal,
            mass_split,
            stroke_rms_most_m: strokes.iter().copied().reduce(f64::min),
            iterations_most: ITERATIONS_MOST,
            ..DesignOptions::default()
        };
        let found = design(&plan, &movable, &how)?;
        let mut next = found.dampers.iter();
        let mut dampers = Vec::with_capacity(start.dampers.len());
        for damper in &start.dampers {
            dampers.push(match self.placed(damper).and_then(|_| next.next()) {
                None => damper.clone(),
                Some(moved) => {
                    let attached = moved.attached(&self.problem.sites, self.building.coordinates())?;
                    BuiltDamper {
                        place_m: moved.place_m,
                        kind: attached.kind,
                        row: attached.row,
                        ..damper.clone()
                    }
                }
            });
        }
        let choice = match mass_split {
            Freedom::Kept => TogetherChoice::Best,
            Freedom::Free => TogetherChoice::BestShared,
        };
        let row = TogetherRow {
            end: Some(found.end),
            ..self.judged(choice.clone(), &dampers)?
        };
        // a search that ends worse than it began, for example because the start is at the bound of strokes, has found nothing
        Ok(match row.cost <= start.cost {
            true => row,
            false => TogetherRow {
                choice,
                ..start.clone()
            },
        })
    }
}
