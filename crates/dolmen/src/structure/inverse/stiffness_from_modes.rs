//! The search for stiffness: from roots and starts to ranked solutions.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_i | `x` | ln k_i | |
//! | J = U S Vᵀ | `jacobian` | d(data over sd)/dx | |

use super::modal_fit::ModalFit;
use super::options::Weighting;
use super::search::{Count, EXACT, ITERATIONS_MOST, Minimum, Search, rank, singular_values, tall};
use super::starts::{linear_estimate, scattered_starts};
use super::{FrequencyRoots, Sprung, StiffnessSearch, notes};
use crate::numeric::levenberg_marquardt;
use crate::structure::identification::check_modes;
use crate::structure::{
    Choice, MeasuredMode, StiffnessNote, StiffnessSolution, StiffnessSolutions, StructureError,
};
use dolmen_linalg::svd;

/// Largest number of iterations to refine a listed solution: few are needed except in a long flat valley.
const ITERATIONS_LAST: usize = 500;
/// With shapes only one start in this many is tried, because shapes leave far fewer solutions than n!.
const STARTS_WITH_SHAPES: usize = 5;
/// Two solutions are the same if every ln k agrees within this.
const SAME: f64 = 1e-5;
/// Largest number of batches of starts: more batches are tried as long as the number of solutions is odd (with as many frequencies as
/// joints), or as no solution is found (with shapes).
const BATCHES_MOST: usize = 5;
/// Largest number of springs for which the range is followed to the 2ⁿ corners of the box of frequencies.
const RANGED_PARTS_MOST: usize = 4;
/// Increase of chi-squared over the best fit at which another fit is dropped: 99.9 % for one degree of freedom.
const CHI_SQUARED_999: f64 = 10.827_566;
/// Two results near a double root are the same if every ln k agrees within this: the valley is flat there, and searches stop anywhere
/// along it.
const SAME_VALLEY: f64 = 0.1;
/// Relative standard deviation above which the second of two solutions may be within the scatter.
const SEPARATE_SD_MOST: f64 = 1.0;
/// Smallest value of the proportion over its largest: a joint that carries nothing still has a stiffness.
const PROPORTION_LEAST: f64 = 1e-3;

/// All stiffnesses found that explain the modes.
///
/// # Errors
/// As [`chain_stiffness`](crate::structure::chain_stiffness).
pub(crate) fn stiffness_from_modes<S: Sprung>(
    structure: &S,
    modes: &[MeasuredMode],
    options: &StiffnessSearch,
) -> Result<StiffnessSolutions, StructureError> {
    let model = structure.model()?;
    check_modes(modes, model.parts(), S::PARTS)?;
    options.check()?;
    let weighting = Weighting::of(modes);
    let mut search = Search {
        fit: ModalFit::new(structure, &model, modes, weighting.stand_in(options))?,
        structure,
        modes,
        options,
        model,
        weighting,
        independent: 0,
    };
    let n = search.model.parts();
    let prior = search.prior();
    search.independent = match search.fit.residuals(&prior) {
        Some(at) => rank(&singular_values(&at.jacobian)?),
        None => search.fit.data().min(n), // two modes coincide there
    };
    if search.independent < n {
        return search.nearest_to_the_prior(&prior);
    }
    let roots = if modes.len() == n {
        let frequencies: Vec<f64> = modes.iter().map(|mode| mode.frequency_hz).collect();
        structure.roots(&frequencies)?
    } else {
        None
    };
    search.many_starts(&prior, roots)
}

impl<S: Sprung> Search<'_, S> {
    /// Logarithm of the first guess, scaled so that the frequencies fit best on average.
    fn prior(&self) -> Vec<f64> {
        let proportion = self.structure.proportion();
        let largest = proportion.iter().fold(0.0_f64, |most, &k| most.max(k));
        let share = |k: &f64| match largest > 0.0 {
            true => (k / largest).max(PROPORTION_LEAST),
            false => 1.0,
        };
        self.scaled(proportion.iter().map(|k| share(k).ln()).collect())
    }

    /// All solutions: followed from a known problem if possible, otherwise from many starts.
    fn many_starts(
        &self,
        prior: &[f64],
        roots: Option<FrequencyRoots>,
    ) -> Result<StiffnessSolutions, StructureError> {
        let only_frequencies = self.fit.data() == self.modes.len();
        let mut all: Vec<Minimum> = Vec::new();
        let mut tried = 0;
        if let Some(start) = linear_estimate(self.structure, &self.model, self.modes)? {
            tried += 1;
            self.descend(start, ITERATIONS_MOST, &mut all);
        }
        for root in roots.iter().flat_map(|roots| &roots.stiffness) {
            let start = root.iter().map(|k| k.ln()).collect();
            self.descend(start, ITERATIONS_MOST, &mut all);
        }
        let complete = roots.as_ref().is_some_and(|roots| roots.complete);
        // without a root, the frequencies may still be within their scatter of a double root
        let beside_roots = only_frequencies && complete && all.is_empty();
        if only_frequencies && complete && !beside_roots {
            tried += roots.as_ref().map_or(0, |roots| roots.solutions_complex);
        } else {
            let starts = match only_frequencies && !beside_roots {
                true => self.options.starts,
                false => self.options.starts / STARTS_WITH_SHAPES,
            };
            tried += self.descend_from_scattered(prior, starts, &mut all);
        }
        self.sort(&mut all);
        let mut nearest = all.first().map(|found| found.misfit);
        all.retain(|found| found.misfit <= self.misfit_accepted());
        let beyond = all.split_off(all.len().min(self.options.solutions_most));
        let mut finished = Vec::new();
        for found in all {
            self.descend(found.x, ITERATIONS_LAST, &mut finished);
        }
        self.sort(&mut finished);
        nearest = finished.first().map(|found| found.misfit).or(nearest);
        // without any standard deviation, exact solutions rank before approximate ones
        let none_given = matches!(self.weighting, Weighting::Relative | Weighting::Assumed);
        let exact = nearest.is_some_and(|misfit| misfit < EXACT) && none_given;
        finished.extend(beyond);
        if exact {
            finished.retain(|found| found.misfit < EXACT);
        }
        self.drop_the_excluded(&mut finished);
        self.drop_the_unfinished(&mut finished)?;
        if beside_roots {
            one_a_valley(&mut finished);
        }
        let choice = self.choose(&finished)?;
        if choice == Choice::Underdetermined {
            finished.truncate(1); // the others are points of the same family
        }
        let even = finished.len().is_multiple_of(2) || self.parts() == 1;
        let count = Count {
            starts: tried,
            solutions: finished.len(),
            as_good: finished.len(),
            nearest,
            odd: only_frequencies && !complete && exact && !even,
            roots: roots.filter(|_| only_frequencies),
        };
        self.answer(finished, choice, count)
    }

    /// Minima from scattered starts, and the number of starts.
    fn descend_from_scattered(&self, prior: &[f64], starts: usize, all: &mut Vec<Minimum>) -> usize {
        let only_frequencies = self.fit.data() == self.modes.len();
        let mut tried = 0;
        for batch in 0..BATCHES_MOST {
            for start in scattered_starts(prior, batch * starts, starts.max(1)) {
                tried += 1;
                self.descend(self.scaled(start), ITERATIONS_MOST, all);
            }
            let exact = all.iter().filter(|found| found.misfit < EXACT).count();
            let enough = match only_frequencies && self.parts() > 1 {
                true => exact.is_multiple_of(2) || exact > self.options.solutions_most,
                false => all.iter().any(|found| found.misfit <= self.misfit_accepted()),
            };
            if enough {
                break;
            }
        }
        tried
    }

    /// Adds the minimum reached from a start, unless it is known.
    fn descend(&self, start: Vec<f64>, iterations_most: usize, all: &mut Vec<Minimum>) {
        let end = levenberg_marquardt(start, iterations_most, |x| self.fit.residuals(x));
        let Some(found) = end.map(|end| self.found(end)) else {
            return;
        };
        let near = |other: &Minimum| other.x.iter().zip(&found.x).all(|(a, b)| (a - b).abs() < SAME);
        if !all.iter().any(near) {
            all.push(found);
        }
    }

    /// Sorts by misfit; exact solutions by their first stiffness.
    fn sort(&self, all: &mut [Minimum]) {
        let order = |a: &Minimum, b: &Minimum| rounded(a.misfit).total_cmp(&rounded(b.misfit));
        all.sort_by(|a, b| order(a, b).then(a.x[0].total_cmp(&b.x[0])));
    }

    fn choose(&self, all: &[Minimum]) -> Result<Choice, StructureError> {
        let Some(best) = all.first() else {
            return Ok(Choice::Impossible);
        };
        if self.meets_another(best)? {
            return Ok(Choice::Indistinguishable);
        }
        if rank(&singular_values(&best.jacobian)?) < best.x.len() {
            return Ok(Choice::Underdetermined);
        }
        Ok(match all.len() {
            1 => Choice::One,
            _ => Choice::Indistinguishable,
        })
    }

    /// With standard deviations, given or assumed, removes fits that are too much worse than the best.
    fn drop_the_excluded(&self, all: &mut Vec<Minimum>) {
        let Some(best) = all.first().map(|best| rounded(best.misfit)) else {
            return;
        };
        if self.weighting != Weighting::Relative {
            let data = self.fit.data() as f64;
            all.retain(|found| data * (found.misfit.powi(2) - best.powi(2)) <= CHI_SQUARED_999);
        }
    }

    /// Removes searches that stopped on a plateau (a practically rigid spring) or along a valley: a step would still reduce their sum of
    /// squares. Roots, which have a sum of zero, and the best solution are kept.
    fn drop_the_unfinished(&self, all: &mut Vec<Minimum>) -> Result<(), StructureError> {
        const FALLS_LEAST: f64 = 1e-4; // of the square of what counts as seen
        let mut kept = Vec::with_capacity(all.len());
        for found in all.drain(..) {
            let is_kept = kept.is_empty() || found.misfit < EXACT || {
                let falls = self.squares_along(&found)?;
                falls <= FALLS_LEAST * self.seen_bound().powi(2)
            };
            if is_kept {
                kept.push(found);
            }
        }
        *all = kept;
        Ok(())
    }

    /// Reduction of the sum of squares by a linear step: ‖U Uᵀ r‖², 0 at a minimum.
    fn squares_along(&self, found: &Minimum) -> Result<f64, StructureError> {
        let Some(at) = self.fit.residuals(&found.x) else {
            return Ok(f64::INFINITY);
        };
        let f = svd(&tall(&at.jacobian))?;
        let along = (0..rank(&f.s)).map(|j| {
            at.residual
                .iter()
                .zip(f.u.column(j))
                .map(|(r, u)| r * u)
                .sum::<f64>()
        });
        Ok(along.map(|part| part * part).sum())
    }

    /// Whether another solution coincides with this one, or is so near that the scatter of the frequencies can turn one into the other:
    /// there are as many frequencies as springs, but some combination of seen springs is undetermined.
    pub(super) fn meets_another(&self, found: &Minimum) -> Result<bool, StructureError> {
        let n = found.x.len();
        if n < 2 || self.modes.len() != n || self.fit.data() != n {
            return Ok(false);
        }
        let scatter = self.deviation_unit();
        let linear = |sd: &Vec<f64>| sd.iter().all(|sd| scatter * sd <= SEPARATE_SD_MOST);
        if self.relative_sd(found)?.as_ref().is_some_and(linear) {
            return Ok(false);
        }
        let weakest = svd(&tall(&found.jacobian))?.v;
        let unseen = self.unseen_springs(found);
        let share: f64 = unseen.iter().map(|&i| weakest[(i, n - 1)].powi(2)).sum();
        Ok(share < 0.5) // else it is one spring, too stiff to be seen
    }

    pub(super) fn answer(
        &self,
        mut all: Vec<Minimum>,
        choice: Choice,
        count: Count,
    ) -> Result<StiffnessSolutions, StructureError> {
        let visibility = all.first().map(|best| self.visibility(best)).transpose()?;
        let starts = count.starts;
        let mut notes = notes::of_solutions(self, &count, choice);
        if let Some(best) = all.first() {
            notes.extend(notes::of_free_directions(
                S::SPRING,
                &svd(&tall(&best.jacobian))?,
                choice,
            ));
        }
        all.truncate(self.options.solutions_most);
        let mut meets = false;
        for found in &all {
            meets |= choice != Choice::Underdetermined && self.meets_another(found)?;
        }
        if meets {
            notes.push(StiffnessNote::SolutionsMeet { spring: S::SPRING });
        }
        if let (Some(best), Some(visibility)) = (all.first(), &visibility) {
            notes.extend(notes::of_shapes(self, &best.x));
            notes.extend(notes::of_unseen(
                S::SPRING,
                visibility,
                &self.unseen_springs(best),
            ));
        }
        let ranged = count.roots.is_some()
            && self.weighting == Weighting::Given
            && self.parts() <= RANGED_PARTS_MOST
            && all.iter().all(|found| found.misfit < EXACT);
        let solutions = all.iter().map(|found| self.solution(found, choice, ranged));
        let solutions: Vec<StiffnessSolution> = solutions.collect::<Result<_, _>>()?;
        notes.extend(
            solutions
                .first()
                .and_then(|best| notes::of_wide_intervals(S::SPRING, best)),
        );
        notes.extend(notes::of_ranges(&solutions));
        let bounded = solutions
            .first()
            .is_some_and(|best| best.stiffness_bounds.is_some());
        let choice = match choice {
            Choice::One if bounded => Choice::Bounded,
            other => other,
        };
        Ok(StiffnessSolutions {
            solutions,
            choice,
            visibility,
            starts,
            notes,
        })
    }

    fn solution(
        &self,
        found: &Minimum,
        choice: Choice,
        ranged: bool,
    ) -> Result<StiffnessSolution, StructureError> {
        let stiffness: Vec<f64> = found.x.iter().map(|x| x.exp()).collect();
        let known = self.known(found, choice)?;
        let modes = self.structure.natural_modes_with(&stiffness)?;
        Ok(StiffnessSolution {
            stiffness_sd: known
                .relative_sd
                .map(|sd| sd.iter().zip(&stiffness).map(|(sd, k)| sd * k).collect()),
            stiffness_bounds: known.bounds,
            stiffness_range: if ranged { self.range(&stiffness) } else { None },
            stands: modes.first().is_some_and(|mode| mode.omega_squared > 0.0),
            stiffness,
            modes,
            misfit: found.misfit,
        })
    }
}

/// Misfit without rounding, so that exact solutions rank equally.
fn rounded(misfit: f64) -> f64 {
    if misfit < EXACT { 0.0 } else { misfit }
}

/// Keeps the best of the solutions in each flat valley.
fn one_a_valley(all: &mut Vec<Minimum>) {
    let mut kept: Vec<Minimum> = Vec::new();
    for found in all.drain(..) {
        let near = |other: &Minimum| {
            let pairs = other.x.iter().zip(&found.x);
            pairs.into_iter().all(|(a, b)| (a - b).abs() < SAME_VALLEY)
        };
        if !kept.iter().any(near) {
            kept.push(found);
        }
    }
    *all = kept;
}
