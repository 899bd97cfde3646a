//! The search for stiffness: from roots and starts to ranked, judged solutions.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_i | `x` | ln k_i | |
//! | J = U S Vᵀ | `jacobian` | d(data over sd)/dx | |

use super::modal_fit::ModalFit;
use super::options::Weighting;
use super::range::range_of_root;
use super::starts::{linear_estimate, scattered_starts};
use super::{FrequencyRoots, SpringModel, Sprung, StiffnessSearch, notes};
use crate::numeric::{LeastSquaresFit, levenberg_marquardt};
use crate::structure::identification::check_modes;
use crate::structure::{
    Choice, MeasuredMode, StiffnessRange, StiffnessSolution, StiffnessSolutions, StructureError, Visibility,
};
use dolmen_linalg::{Matrix, svd};

/// Iterations from one start, most: from far starts about 30 suffice.
pub(super) const ITERATIONS_MOST: usize = 120;
/// Iterations that finish a solution to be listed: few are needed unless it lies in a long flat valley.
const ITERATIONS_LAST: usize = 500;
/// One start in this many is tried where shapes are given: they leave far fewer solutions than n!.
const STARTS_WITH_SHAPES: usize = 5;
/// Misfit that is rounding: the data are reproduced exactly.
pub(super) const EXACT: f64 = 1e-9;
/// Two solutions nearer than this in every ln k are one.
const SAME: f64 = 1e-5;
/// Batches of starts tried at most: while the number of solutions of as many frequencies as joints is odd, or while
/// none is found where shapes are given.
const BATCHES_MOST: usize = 5;
/// Most springs whose range is followed to the 2ⁿ corners of the box of frequencies.
const RANGED_PARTS_MOST: usize = 4;
/// Singular values below this share of the largest are 0.
const RANK_LEAST: f64 = 1e-8;
/// Difference of chi-squared below which two fits cannot be told apart: 95 % of one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_458_8;
/// Change of data that counts as seen if they carry no sd, relative: frequencies of the field scatter by half a per
/// cent. With sd the bound is one sd.
const SEEN_RELATIVE: f64 = 0.005;
/// One minimum.
pub(super) struct Found {
    x: Vec<f64>,
    pub(super) misfit: f64,
    jacobian: Matrix,
}

pub(super) struct Count {
    pub(super) starts: usize,
    pub(super) solutions: usize,
    /// Of these, as good as the best.
    pub(super) as_good: usize,
    /// Misfit of the best end of all, accepted or not.
    pub(super) nearest: Option<f64>,
    /// Whether the number of solutions shows that at least one is missing.
    pub(super) odd: bool,
    /// What following every solution gave, where that was done.
    pub(super) roots: Option<FrequencyRoots>,
}

pub(super) struct Search<'a, S> {
    pub(super) structure: &'a S,
    pub(super) modes: &'a [MeasuredMode],
    pub(super) options: &'a StiffnessSearch,
    model: SpringModel,
    pub(super) fit: ModalFit,
    pub(super) weighting: Weighting,
    /// Rank of the Jacobian at the first guess.
    pub(super) independent: usize,
}

/// Every stiffness found that explains the modes.
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
    pub(super) fn parts(&self) -> usize {
        self.model.parts()
    }

    pub(super) fn found(&self, fit: LeastSquaresFit) -> Found {
        let squares: f64 = fit.at.residual.iter().map(|r| r * r).sum();
        Found {
            misfit: (squares / self.fit.data() as f64).sqrt(),
            x: fit.x,
            jacobian: fit.at.jacobian,
        }
    }

    pub(super) fn misfit_accepted(&self) -> f64 {
        match self.weighting {
            Weighting::Relative => self.options.difference_most,
            _ => self.options.misfit_most,
        }
    }

    /// Logarithm of the first guess, scaled so that the frequencies fit best on average.
    fn prior(&self) -> Vec<f64> {
        let proportion = self.structure.proportion();
        self.scaled(proportion.iter().map(|k| k.max(f64::MIN_POSITIVE).ln()).collect())
    }

    /// All solutions: followed from a solved case where that is possible, else from many starts.
    fn many_starts(
        &self,
        prior: &[f64],
        roots: Option<FrequencyRoots>,
    ) -> Result<StiffnessSolutions, StructureError> {
        let only_frequencies = self.fit.data() == self.modes.len();
        let mut all: Vec<Found> = Vec::new();
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
        let settled =
            only_frequencies && complete && (!all.is_empty() || self.weighting == Weighting::Relative);
        if settled {
            tried += roots.as_ref().map_or(0, |roots| roots.solutions_complex);
        } else {
            tried += self.descend_from_scattered(prior, only_frequencies, &mut all);
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
        let exact = nearest.is_some_and(|misfit| misfit < EXACT) && self.weighting == Weighting::Relative;
        finished.extend(beyond);
        if exact {
            finished.retain(|found| found.misfit < EXACT);
        }
        let choice = self.choose(&finished)?;
        if choice == Choice::Underdetermined {
            finished.truncate(1); // the others are points of the same family
        }
        let even = finished.len().is_multiple_of(2) || self.parts() == 1;
        let count = Count {
            starts: tried,
            solutions: finished.len(),
            as_good: self.as_good(&finished),
            nearest,
            odd: only_frequencies && !complete && exact && !even,
            roots: roots.filter(|_| only_frequencies),
        };
        self.answer(finished, choice, count)
    }

    /// Minima from a scatter of starts; how many starts were tried.
    fn descend_from_scattered(&self, prior: &[f64], only_frequencies: bool, all: &mut Vec<Found>) -> usize {
        let starts = if only_frequencies {
            self.options.starts
        } else {
            self.options.starts / STARTS_WITH_SHAPES
        };
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

    /// Adds the minimum that a start leads to, unless it is there already.
    fn descend(&self, start: Vec<f64>, iterations_most: usize, all: &mut Vec<Found>) {
        let end = levenberg_marquardt(start, iterations_most, |x| self.fit.residuals(x));
        let Some(found) = end.map(|end| self.found(end)) else {
            return;
        };
        let near = |other: &Found| other.x.iter().zip(&found.x).all(|(a, b)| (a - b).abs() < SAME);
        if !all.iter().any(near) {
            all.push(found);
        }
    }

    /// Best misfit first, exact ones by their first stiffness.
    fn sort(&self, all: &mut [Found]) {
        let order = |a: &Found, b: &Found| rounded(a.misfit).total_cmp(&rounded(b.misfit));
        all.sort_by(|a, b| order(a, b).then(a.x[0].total_cmp(&b.x[0])));
    }

    fn choose(&self, all: &[Found]) -> Result<Choice, StructureError> {
        let Some(best) = all.first() else {
            return Ok(Choice::Impossible);
        };
        let n = best.x.len();
        if rank(&singular_values(&best.jacobian)?) < n {
            return Ok(Choice::Underdetermined);
        }
        Ok(if self.as_good(all) > 1 {
            Choice::Indistinguishable
        } else {
            Choice::One
        })
    }

    fn as_good(&self, all: &[Found]) -> usize {
        let best = all.first();
        best.map_or(0, |best| {
            all.iter().filter(|found| self.as_good_as(found, best)).count()
        })
    }

    /// Whether the data cannot tell a fit from the best one. Without standard deviations the misfit of the best fit
    /// says how uncertain the data are, if there are data to spare; if not, any accepted fit may be the true one.
    fn as_good_as(&self, found: &Found, best: &Found) -> bool {
        let data = self.fit.data() as f64;
        let spare = data - found.x.len() as f64;
        let worse = rounded(found.misfit).powi(2) - rounded(best.misfit).powi(2);
        match self.weighting {
            Weighting::Relative if spare > 0.0 => {
                worse <= CHI_SQUARED_95 / spare * rounded(best.misfit).powi(2)
            }
            Weighting::Relative => true,
            _ => data * worse <= CHI_SQUARED_95,
        }
    }

    /// The same proportions with the common factor that fits the frequencies' logarithms on average.
    ///
    /// Gravity takes its share whatever the springs are, so the factor is found by doubling until the structure stands,
    /// then by the secant of the mean of ln ω² (its slope in ln k is near 1).
    pub(super) fn scaled(&self, mut x: Vec<f64>) -> Vec<f64> {
        const DOUBLINGS_MOST: usize = 200;
        const CORRECTIONS: usize = 4;
        let shift = |x: &mut Vec<f64>, by: f64| x.iter_mut().for_each(|x| *x += by);
        let stands = |x: &[f64]| self.fit.omega_squared(x).is_some_and(|values| values[0] > 0.0);
        for _ in 0..DOUBLINGS_MOST {
            if stands(&x) {
                break;
            }
            shift(&mut x, std::f64::consts::LN_2);
        }
        for _ in 0..CORRECTIONS {
            let Some(by) = self.fit.mean_log_frequency_short(&x) else {
                break;
            };
            let mut trial = x.clone();
            shift(&mut trial, by);
            if !stands(&trial) {
                break;
            }
            x = trial;
        }
        x
    }

    pub(super) fn answer(
        &self,
        mut all: Vec<Found>,
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
        if let (Some(best), true) = (all.first(), self.interval_stated(choice)) {
            let relative_sd = self.relative_sd(best)?;
            notes.extend(relative_sd.and_then(|sd| notes::of_wide_intervals(S::SPRING, &sd)));
        }
        if let Some(visibility) = &visibility {
            notes.extend(notes::of_unseen(S::SPRING, visibility));
        }
        all.truncate(self.options.solutions_most);
        let ranged = count.roots.is_some()
            && self.weighting == Weighting::Given
            && self.parts() <= RANGED_PARTS_MOST
            && all.iter().all(|found| found.misfit < EXACT);
        let solutions = all.iter().map(|found| self.solution(found, choice, ranged));
        Ok(StiffnessSolutions {
            solutions: solutions.collect::<Result<_, _>>()?,
            choice,
            visibility,
            starts,
            notes,
        })
    }

    /// Whether the modes carry standard deviations and determine the stiffness.
    fn interval_stated(&self, choice: Choice) -> bool {
        self.weighting != Weighting::Relative && choice != Choice::Underdetermined
    }

    fn solution(
        &self,
        found: &Found,
        choice: Choice,
        ranged: bool,
    ) -> Result<StiffnessSolution, StructureError> {
        let stiffness: Vec<f64> = found.x.iter().map(|x| x.exp()).collect();
        let relative_sd = match self.interval_stated(choice) {
            true => self.relative_sd(found)?,
            false => None,
        };
        let modes = self.structure.natural_modes_with(&stiffness)?;
        Ok(StiffnessSolution {
            stiffness_sd: relative_sd.map(|sd| sd.iter().zip(&stiffness).map(|(sd, k)| sd * k).collect()),
            stiffness_range: if ranged { self.range(&stiffness) } else { None },
            stands: modes.first().is_some_and(|mode| mode.omega_squared > 0.0),
            stiffness,
            modes,
            misfit: found.misfit,
        })
    }

    /// While every frequency moves by √3 of its standard deviation.
    fn range(&self, root: &[f64]) -> Option<StiffnessRange> {
        let frequencies: Vec<f64> = self.modes.iter().map(|mode| mode.frequency_hz).collect();
        let half_width = self
            .modes
            .iter()
            .map(|mode| 3.0_f64.sqrt() * mode.frequency_sd_hz);
        let half_width: Vec<f64> = half_width.collect();
        let positive = frequencies.iter().zip(&half_width).all(|(f, h)| f > h);
        positive.then(|| range_of_root(&self.model, &frequencies, &half_width, root))
    }

    /// √diag (JᵀJ)⁻¹, widened by the misfit where there are data to spare; `None` if not determined.
    fn relative_sd(&self, found: &Found) -> Result<Option<Vec<f64>>, StructureError> {
        let n = found.x.len();
        let f = svd(&tall(&found.jacobian))?;
        if rank(&f.s) < n {
            return Ok(None);
        }
        let data = self.fit.data();
        let spare = data - n;
        let widened = match spare {
            0 => 1.0,
            _ => (found.misfit * (data as f64 / spare as f64).sqrt()).max(1.0),
        };
        let variance = |i: usize| (0..n).map(|j| (f.v[(i, j)] / f.s[j]).powi(2)).sum::<f64>();
        Ok(Some((0..n).map(|i| widened * variance(i).sqrt()).collect()))
    }

    fn visibility(&self, found: &Found) -> Result<Visibility, StructureError> {
        let n = found.x.len();
        let f = svd(&tall(&found.jacobian))?;
        let bound = match self.weighting {
            Weighting::Relative => SEEN_RELATIVE,
            _ => 1.0,
        };
        let share = |s: f64| s * s / (s * s + bound * bound);
        let seen = |i: usize| (0..n).map(|j| f.v[(i, j)].powi(2) * share(f.s[j])).sum::<f64>();
        Ok(Visibility {
            free_directions: n - rank(&f.s),
            seen: (0..n).map(seen).collect(),
            singular_values: f.s,
        })
    }
}

/// Misfit with rounding taken away, so that exact solutions rank as equal.
fn rounded(misfit: f64) -> f64 {
    if misfit < EXACT { 0.0 } else { misfit }
}

/// The Jacobian with rows of zeros added until it is at least square: all right singular vectors then exist.
fn tall(jacobian: &Matrix) -> Matrix {
    let (m, n) = (jacobian.rows(), jacobian.columns());
    Matrix::from_fn(m.max(n), n, |i, j| if i < m { jacobian[(i, j)] } else { 0.0 })
}

pub(super) fn singular_values(jacobian: &Matrix) -> Result<Vec<f64>, StructureError> {
    Ok(svd(&tall(jacobian))?.s)
}

pub(super) fn rank(singular_values: &[f64]) -> usize {
    let least = RANK_LEAST * singular_values.first().copied().unwrap_or(0.0);
    singular_values.iter().filter(|&&s| s > least).count()
}
