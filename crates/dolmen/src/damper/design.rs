//! Optimal design of mass dampers: places, frequencies, damping and shares of the mass.
//!
//! The unknowns are x and y divided by the size of the floor, ln f, ln ζ, and ln of the mass shares. A place beyond the edge is replaced
//! by the nearest point on the floor.

use super::damper_slopes::{JudgedSlopes, MovedDampers, pieces_of};
use super::single_damper::DAMPING_MOST;
use super::{DamperError, Judged, PlacedDamper, Plan};
use crate::numeric::{Minimax, Piece, Worst, by_differences, maximum_between, minimax};

/// The quantity to minimise.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum Goal {
    /// The largest standard deviation of all points.
    #[default]
    LargestRms,
    /// The root mean square over all points of their standard deviations.
    MeanSquare,
    /// The largest amplitude of any point under a harmonic load of unit amplitude at any frequency, one load at a time.
    LargestPeak,
}

/// Region in which the search may move a damper.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Place {
    /// The damper keeps its place.
    Kept,
    /// Along x.
    AlongX,
    /// Along y.
    AlongY,
    /// Anywhere on its floor.
    #[default]
    Anywhere,
}

/// Whether the search may change a quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Default)]
pub enum Freedom {
    /// The quantity keeps its value.
    Kept,
    /// The quantity may change.
    #[default]
    Free,
}

/// Options of a design.
#[derive(Clone, Debug, PartialEq)]
pub struct DesignOptions {
    /// The quantity to minimise; default: the largest standard deviation.
    pub goal: Goal,
    /// Weight of each point, multiplied by its motion; empty means 1 each.
    pub weights: Vec<f64>,
    /// Region in which dampers may move; default: anywhere on their floor.
    pub place: Place,
    /// Whether the frequencies may change; default: free.
    pub frequency: Freedom,
    /// Whether the damping ratios may change; default: free.
    pub damping: Freedom,
    /// Whether the shares of the total mass may change; default: free, without effect on a single damper.
    pub mass_split: Freedom,
    /// Relative frequency error d that the design must tolerate: the worst of f (1 − d), f and f (1 + d) is minimised. Default 0; for
    /// standard deviations only.
    pub detuning_ratio: f64,
    /// Upper bound on the standard deviation of the stroke of a damper, m; none by default.
    pub stroke_rms_most_m: Option<f64>,
    /// Largest number of steps of one search; default 200 (our choice).
    pub iterations_most: usize,
}

impl Default for DesignOptions {
    fn default() -> Self {
        DesignOptions {
            goal: Goal::default(),
            weights: Vec::new(),
            place: Place::default(),
            frequency: Freedom::default(),
            damping: Freedom::default(),
            mass_split: Freedom::default(),
            detuning_ratio: 0.0,
            stroke_rms_most_m: None,
            iterations_most: 200,
        }
    }
}

/// The end of a search.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
#[cfg_attr(feature = "serde", serde(rename_all = "snake_case"))]
pub enum DesignEnd {
    /// An optimum: no step of 1e-6 in ln f, in ln ζ or in place over floor size improves the cost.
    Optimum,
    /// A limit: the damping or frequency reached the end of its allowed range, and beyond it the cost would fall further.
    Limit,
    /// No step improved the cost, but the last steps were longer than 1e-6: the result is the best design found.
    Stalled,
}

/// Designed dampers, with their effect and the evidence for it.
#[derive(Clone, Debug, PartialEq)]
pub struct Design {
    /// The dampers.
    pub dampers: Vec<PlacedDamper>,
    /// Value of the minimised cost.
    pub cost: f64,
    /// Standard deviations of points and strokes, from the assembled matrices.
    pub judged: Judged,
    /// The end of the search.
    pub end: DesignEnd,
    /// Number of steps of the search that found this design.
    pub iterations: usize,
    /// Length of the last step tried, in the logarithms of the unknowns and in fractions of the floor.
    pub last_step: f64,
}

/// Finds the dampers that minimise the goal, starting from the given dampers.
///
/// # Errors
/// [`DamperError`] if a given damper is out of its range, or the search fails.
///
/// # Limits
/// Finds a local optimum: if places are free, start from several designs, for example the best of a `position_map`. The tolerance of the
/// prepared [`Plan`] bounds the accuracy of the cost; `judged` is computed from the assembled matrices.
pub fn design(plan: &Plan, start: &[PlacedDamper], options: &DesignOptions) -> Result<Design, DamperError> {
    let found = searched(plan, start, options)?;
    Ok(Design {
        judged: plan.exact(&found.dampers)?,
        dampers: found.dampers,
        cost: found.cost,
        end: found.end,
        iterations: found.iterations,
        last_step: found.last_step,
    })
}

/// A design from the prepared frequencies alone.
pub(super) struct Searched {
    pub(super) dampers: Vec<PlacedDamper>,
    pub(super) cost: f64,
    pub(super) end: DesignEnd,
    iterations: usize,
    last_step: f64,
}

/// The search of [`design`], without the assembled matrices.
pub(super) fn searched(
    plan: &Plan,
    start: &[PlacedDamper],
    options: &DesignOptions,
) -> Result<Searched, DamperError> {
    plan.judge(start)?;
    let points = plan.problem().points.len();
    if !options.weights.is_empty() && options.weights.len() != points {
        return Err(DamperError::Argument {
            argument: "number of weights",
            given: options.weights.len() as f64,
            allowed: "one a point",
        });
    }
    if let Some(&given) = options.weights.iter().find(|w| !(**w > 0.0 && w.is_finite())) {
        return Err(DamperError::Argument {
            argument: "weights",
            given,
            allowed: "positive",
        });
    }
    if options.detuning_ratio != 0.0 {
        let fits = (0.0..0.5).contains(&options.detuning_ratio) && options.goal != Goal::LargestPeak;
        if !fits {
            return Err(DamperError::Argument {
                argument: "detuning_ratio",
                given: options.detuning_ratio,
                allowed: "between 0 and 0.5, and 0 where peaks are made small",
            });
        }
    }
    let mut search = Search {
        plan,
        start,
        options,
        weights: match options.weights.is_empty() {
            true => vec![1.0; points],
            false => options.weights.clone(),
        },
    };
    let none = DamperError::NoOptimum {
        what: "the dampers' tuning and place",
        iterations: 0,
    };
    let how = Minimax::steps(options.iterations_most);
    let mut least = minimax(search.unknowns(), &how, &mut search).ok_or(none)?;
    let mut dampers = search.dampers(&least.x);
    let mut at_limit = search.at_limit(&dampers);
    if options.place != Place::Kept {
        // at the edge of a floor only the tuning remains to be optimised
        let there = DesignOptions {
            place: Place::Kept,
            ..options.clone()
        };
        let mut search = Search {
            plan,
            start: &dampers,
            options: &there,
            weights: search.weights.clone(),
        };
        let at_edge = dampers.iter().all(|damper| {
            let site = &plan.problem().sites[damper.site];
            site.to_edge_m(damper.place_m) <= 1e-9 * search.size_m(damper)
        });
        let settled = minimax(search.unknowns(), &how, &mut search);
        if let Some(settled) = settled.filter(|settled| settled.worst <= least.worst) {
            let tuned = search.dampers(&settled.x);
            at_limit |= search.at_limit(&tuned);
            least.iterations += settled.iterations;
            if at_edge {
                least.last_step = settled.last_step;
            }
            dampers = tuned;
        }
    }
    let end = match (at_limit, least.last_step <= LAST_STEP_MOST) {
        (true, _) => DesignEnd::Limit,
        (false, true) => DesignEnd::Optimum,
        (false, false) => DesignEnd::Stalled,
    };
    Ok(Searched {
        end,
        cost: search.cost(&dampers).ok_or(DamperError::NoOptimum {
            what: "the dampers' tuning and place",
            iterations: least.iterations,
        })?,
        dampers,
        iterations: least.iterations,
        last_step: least.last_step,
    })
}

/// Largest last step of a search that ended at an optimum.
const LAST_STEP_MOST: f64 = 1e-6;

pub(super) struct Search<'a> {
    pub(super) plan: &'a Plan,
    pub(super) start: &'a [PlacedDamper],
    pub(super) options: &'a DesignOptions,
    pub(super) weights: Vec<f64>,
}

/// Largest factor between a damper's frequency and its start.
const FREQUENCY_FACTOR_MOST: f64 = 5.0;
/// Slope of the penalty on a stroke beyond its limit, in ln of the cost per ln of the stroke: steeper than any gain from the damper.
const STROKE_PRICE: f64 = 50.0;

impl Search<'_> {
    fn size_m(&self, damper: &PlacedDamper) -> f64 {
        let [x, y] = self.plan.problem().sites[damper.site].extent_m();
        (x[1] - x[0]).max(y[1] - y[0])
    }

    fn unknowns(&self) -> Vec<f64> {
        let mut x = Vec::new();
        for (k, damper) in self.start.iter().enumerate() {
            let place = damper.place_m.map(|at| at / self.size_m(damper));
            match self.options.place {
                Place::Kept => {}
                Place::AlongX => x.push(place[0]),
                Place::AlongY => x.push(place[1]),
                Place::Anywhere => x.extend(place),
            }
            if self.options.frequency == Freedom::Free {
                x.push(damper.frequency_hz.ln());
            }
            if self.options.damping == Freedom::Free {
                x.push(damper.damping_ratio.max(1.001 * self.plan.damping_least()).ln());
            }
            if self.options.mass_split == Freedom::Free && k + 1 < self.start.len() {
                x.push((damper.mass_kg / self.start[self.start.len() - 1].mass_kg).ln());
            }
        }
        x
    }

    fn dampers(&self, x: &[f64]) -> Vec<PlacedDamper> {
        let mut next = x.iter().copied();
        let mut take = || next.next().unwrap_or(f64::NAN);
        let whole: f64 = self.start.iter().map(|damper| damper.mass_kg).sum();
        let mut shares = Vec::new();
        let mut dampers = Vec::new();
        for (k, start) in self.start.iter().enumerate() {
            let mut damper = *start;
            let size = self.size_m(start);
            match self.options.place {
                Place::Kept => {}
                Place::AlongX => damper.place_m[0] = size * take(),
                Place::AlongY => damper.place_m[1] = size * take(),
                Place::Anywhere => damper.place_m = [size * take(), size * take()],
            }
            if self.options.place != Place::Kept {
                damper.place_m = self.plan.problem().sites[damper.site].nearest_m(damper.place_m).0;
            }
            if self.options.frequency == Freedom::Free {
                damper.frequency_hz = take()
                    .exp()
                    .clamp(self.limits(start)[0][0], self.limits(start)[0][1]);
            }
            if self.options.damping == Freedom::Free {
                damper.damping_ratio = take()
                    .exp()
                    .clamp(self.limits(start)[1][0], self.limits(start)[1][1]);
            }
            let shared = self.options.mass_split == Freedom::Free && k + 1 < self.start.len();
            shares.push(if shared { take().exp() } else { 1.0 });
            dampers.push(damper);
        }
        if self.options.mass_split == Freedom::Free && dampers.len() > 1 {
            let sum: f64 = shares.iter().sum();
            for (damper, share) in dampers.iter_mut().zip(&shares) {
                damper.mass_kg = whole * share / sum;
            }
        }
        dampers
    }

    /// Allowed frequencies, Hz, and damping ratios of a damper, from its start.
    fn limits(&self, start: &PlacedDamper) -> [[f64; 2]; 2] {
        let factor = FREQUENCY_FACTOR_MOST;
        let [low, high] = self.plan.tuning_range_hz();
        let high = if high.is_finite() { high } else { 0.0 };
        let low = if low > 0.0 { low } else { f64::INFINITY };
        [
            [
                (start.frequency_hz / factor).min(low),
                (start.frequency_hz * factor).max(high),
            ],
            [self.plan.damping_least().min(start.damping_ratio), DAMPING_MOST],
        ]
    }

    /// Whether the search moved a damper to a limit.
    fn at_limit(&self, dampers: &[PlacedDamper]) -> bool {
        dampers.iter().zip(self.start).any(|(damper, start)| {
            let [frequency, damping] = self.limits(start);
            let tuned = self.options.frequency == Freedom::Free && frequency.contains(&damper.frequency_hz);
            tuned || (self.options.damping == Freedom::Free && damping.contains(&damper.damping_ratio))
        })
    }

    /// ln of each function of which the search minimises the maximum: standard deviations, without and with the stroke penalty.
    fn values(&self, dampers: &[PlacedDamper]) -> Option<Vec<f64>> {
        let factors = self.detunings().into_iter();
        let judged = factors.map(|factor| self.plan.at_nodes(&detuned(dampers, factor)));
        self.values_of(&judged.collect::<Vec<_>>())
    }

    /// Frequency factors of the detuned designs.
    fn detunings(&self) -> Vec<f64> {
        match self.options.detuning_ratio {
            d if d > 0.0 => vec![1.0, 1.0 - d, 1.0 + d],
            _ => vec![1.0],
        }
    }

    /// The same functions, from the standard deviations at each detuning.
    fn values_of(&self, all_judged: &[Judged]) -> Option<Vec<f64>> {
        let mut all = Vec::new();
        for judged in all_judged {
            let weighted = judged
                .point_rms
                .iter()
                .zip(&self.weights)
                .map(|(rms, weight)| rms * weight);
            let values: Vec<f64> = match self.options.goal {
                Goal::MeanSquare => {
                    let squares: f64 = weighted.map(|value| value * value).sum();
                    vec![(squares / judged.point_rms.len() as f64).sqrt().ln()]
                }
                _ => weighted.map(f64::ln).collect(),
            };
            all.extend(self.priced(values, judged)?);
        }
        Some(all)
    }

    fn priced(&self, mut values: Vec<f64>, judged: &Judged) -> Option<Vec<f64>> {
        if let Some(limit) = self.options.stroke_rms_most_m {
            let count = values.len();
            for stroke in &judged.stroke_rms_m {
                let beyond = (stroke / limit).ln();
                values.extend(
                    (0..count)
                        .map(|i| values[i] + STROKE_PRICE * beyond)
                        .collect::<Vec<f64>>(),
                );
            }
        }
        values.iter().all(|value| value.is_finite()).then_some(values)
    }

    /// The cost without the stroke penalty.
    pub(super) fn cost(&self, dampers: &[PlacedDamper]) -> Option<f64> {
        if self.options.goal == Goal::LargestPeak {
            let peaks = self.peaks(dampers)?;
            return peaks
                .into_iter()
                .map(|peak| peak.value)
                .reduce(f64::max)
                .map(f64::exp);
        }
        let unpriced = DesignOptions {
            stroke_rms_most_m: None,
            ..self.options.clone()
        };
        let search = Search {
            options: &unpriced,
            weights: self.weights.clone(),
            ..*self
        };
        search.values(dampers)?.into_iter().reduce(f64::max).map(f64::exp)
    }

    /// ln of the weighted amplitude of one point under one load at one frequency.
    fn amplitude(&self, dampers: &[PlacedDamper], which: usize, omega: f64) -> Option<f64> {
        let loads = self.plan.problem().loads.len();
        let table = self.plan.table(omega, 1.0).ok()?;
        let response = self.plan.responses(&table, &self.plan.damper_rows(dampers))?[which];
        Some((self.weights[which / loads] * response.norm()).ln())
    }

    /// The amplitude at each local maximum of each response.
    pub(super) fn peaks(&self, dampers: &[PlacedDamper]) -> Option<Vec<Peak>> {
        let (points, loads) = (self.plan.problem().points.len(), self.plan.problem().loads.len());
        let tables = &self.plan.nodes;
        let damper_rows = self.plan.damper_rows(dampers);
        let all: Vec<Vec<f64>> = tables
            .iter()
            .map(|table| {
                Some(
                    self.plan
                        .responses(table, &damper_rows)?
                        .iter()
                        .map(|h| h.norm())
                        .collect(),
                )
            })
            .collect::<Option<_>>()?;
        let mut peaks: Vec<Peak> = Vec::new();
        for which in 0..points * loads {
            let size = |i: usize| all[i].get(which).copied().unwrap_or(0.0);
            for i in 1..tables.len() - 1 {
                if size(i) > size(i - 1) && size(i) >= size(i + 1) {
                    let at = |w: f64| self.amplitude(dampers, which, w).unwrap_or(f64::NEG_INFINITY);
                    let omega = maximum_between(&at, tables[i - 1].omega, tables[i + 1].omega);
                    peaks.push(Peak {
                        which,
                        omega,
                        value: at(omega),
                    });
                }
            }
            peaks.push(Peak {
                which,
                omega: tables[0].omega, // as good as static
                value: (self.weights[which / loads] * size(0)).ln(),
            });
        }
        Some(peaks)
    }
}

/// The dampers with their frequencies multiplied by a factor.
fn detuned(dampers: &[PlacedDamper], factor: f64) -> Vec<PlacedDamper> {
    let each = dampers.iter().map(|damper| PlacedDamper {
        frequency_hz: factor * damper.frequency_hz,
        ..*damper
    });
    each.collect()
}

pub(super) struct Peak {
    pub(super) which: usize,
    omega: f64,
    pub(super) value: f64,
}

/// Peaks this far below the highest one, in ln, do not determine the optimum.
const PEAKS_WITHIN: f64 = 1.0;

impl Worst for Search<'_> {
    fn worst(&mut self, x: &[f64]) -> Option<f64> {
        let dampers = self.dampers(x);
        let values = match self.options.goal {
            Goal::LargestPeak => {
                let highest = self
                    .peaks(&dampers)?
                    .into_iter()
                    .map(|peak| peak.value)
                    .reduce(f64::max)?;
                match self.options.stroke_rms_most_m {
                    Some(_) => self.priced(vec![highest], &self.plan.at_nodes(&dampers))?,
                    None => vec![highest],
                }
            }
            _ => self.values(&dampers)?,
        };
        values.into_iter().reduce(f64::max)
    }

    fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>> {
        let dampers = self.dampers(x);
        if self.options.goal == Goal::LargestPeak {
            let peaks = self.peaks(&dampers)?;
            let highest = peaks.iter().map(|peak| peak.value).reduce(f64::max)?;
            let mut pieces: Vec<Piece> = Vec::new();
            for peak in peaks.iter().filter(|peak| peak.value > highest - PEAKS_WITHIN) {
                pieces.push(by_differences(x, |x| {
                    self.amplitude(&self.dampers(x), peak.which, peak.omega)
                })?);
            }
            if let Some(limit) = self.options.stroke_rms_most_m {
                for k in 0..self.start.len() {
                    let base = pieces.clone();
                    let beyond = by_differences(x, |x| {
                        Some((self.plan.at_nodes(&self.dampers(x)).stroke_rms_m[k] / limit).ln())
                    })?;
                    pieces.extend(base.into_iter().map(|mut piece| {
                        piece.value += STROKE_PRICE * beyond.value;
                        for (slope, of) in piece.slope.iter_mut().zip(&beyond.slope) {
                            *slope += STROKE_PRICE * of;
                        }
                        piece
                    }));
                }
            }
            return Some(pieces);
        }
        let of_factor = |factor: f64| {
            let rows = |x: &[f64]| self.plan.damper_rows(&detuned(&self.dampers(x), factor));
            let moved = MovedDampers::of_each(x, rows);
            self.plan.slopes_at_nodes(None, &rows(x), &moved)
        };
        let found: Option<Vec<JudgedSlopes>> = self.detunings().into_iter().map(of_factor).collect();
        pieces_of(&found?, |judged| self.values_of(judged))
    }
}
