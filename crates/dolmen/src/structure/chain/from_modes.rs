//! Stiffness of a chain's joints from measured modes: every solution found, its uncertainty, and what the sensors
//! do not see.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_i | `x` | ln k_i | |
//! | M_i | `necessary` | Σ_{j≥i} G_j, the exact limit of joint i with the others rigid | N m/rad |
//! | J = U S Vᵀ | `jacobian` | d(data over sd)/dx | |

use super::Chain;
use super::modal_fit::{ModalFit, StandIn};
use super::notes;
use super::starts::{linear_estimate, scattered_starts};
use crate::numeric::{LeastSquaresFit, Residuals, levenberg_marquardt};
use crate::structure::identification::check_modes;
use crate::structure::{
    Choice, MeasuredMode, StiffnessSolution, StiffnessSolutions, StructureError, Visibility,
};
use dolmen_linalg::{Matrix, svd};

/// How stiffness is sought.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChainStiffness {
    /// Starting points scattered over the stiffnesses. Default 1000, our choice: with five frequencies of the flagpole
    /// of Choi (2021) it finds what 10,000 find for stiffness in proportion to M_i and for equal joints.
    pub starts: usize,
    /// Most solutions listed; how many more were found is noted. Default 64, our choice.
    pub solutions_most: usize,
    /// Largest misfit of a solution where the modes carry standard deviations, in those. Default 2, our choice.
    pub misfit_most: f64,
    /// Largest misfit where they carry none, relative. Default 0.01, our choice: frequencies of monuments repeat to
    /// about that between seasons.
    pub difference_most: f64,
    /// Relative standard deviation taken for a frequency without one when other data have theirs. Default 0.005, our
    /// choice.
    pub frequency_sd_assumed: f64,
    /// Standard deviation taken for a shape point without one when other data have theirs, relative to the largest
    /// displacement of the mode. Default 0.02, our choice.
    pub shape_sd_assumed: f64,
}

impl Default for ChainStiffness {
    fn default() -> Self {
        ChainStiffness {
            starts: 1000,
            solutions_most: 64,
            misfit_most: 2.0,
            difference_most: 0.01,
            frequency_sd_assumed: 0.005,
            shape_sd_assumed: 0.02,
        }
    }
}

/// Iterations from one start, most: from far starts about 30 suffice.
const ITERATIONS_MOST: usize = 120;
/// Misfit that is rounding: the data are reproduced exactly.
pub(super) const EXACT: f64 = 1e-9;
/// Two solutions nearer than this in every ln k are one.
const SAME: f64 = 1e-5;
/// Batches of `starts` tried at most while the number of solutions of as many frequencies as joints is odd.
const BATCHES_MOST: usize = 4;
/// Singular values below this share of the largest are 0.
const RANK_LEAST: f64 = 1e-8;
/// Difference of chi-squared below which two fits cannot be told apart: 95 % of one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_458_8;
/// Change of data that counts as seen if they carry no sd, relative: frequencies of the field scatter by half a per
/// cent. With sd the bound is one sd.
const SEEN_RELATIVE: f64 = 0.005;
/// Weights of the prior as it is let go, in units of the data's: the last is below rounding of what the data say.
const PRIOR_WEIGHTS: [f64; 4] = [1.0, 1e-2, 1e-4, 1e-5];

/// Joint stiffnesses that explain measured modes.
///
/// ```text
/// min over ln k of Σ ((ln f_j(k) − ln f_j)/sd)² + Σ ((a_j c(z_p)ᵀ φ_j(k) − u_pj)/sd)²       a_j free
/// cov(ln k) = (JᵀJ)⁻¹        J: data × joints, exact derivatives
/// ```
///
/// Damped Gauss–Newton from many starts: the solution of the linear equations K(k) φ = ω² M φ where a mode's points
/// give its whole shape, stiffnesses in proportion to M_i, and a low-discrepancy scatter.
///
/// Frequencies alone have many solutions. As many frequencies as joints are n polynomials of degrees 1 to n in k: at
/// most n! solutions (Bézout), and every real one stands, since K is then positive definite. Complex ones come in
/// pairs, so the number of real ones is even for two joints or more; while it is odd, the search goes on. On the
/// flagpole of Choi (2021) five frequencies leave 4 solutions if stiffness goes with M_i, 40 if the joints are equal,
/// and up to all 5! = 120 if the upper joints are the stiffer ones.
///
/// With fewer data than joints, the solution given is the one whose stiffnesses are nearest to a common multiple of
/// M_i (least squares of ln k); `choice` is [`Choice::Underdetermined`] and the notes say what stays free.
///
/// # Input
/// * `modes` -- the **lowest** modes of one direction, ascending, none left out between them. Displacements are those
///   of points at heights above the lowest joint.
///
/// # Errors
/// [`StructureError::ModesMissing`], [`StructureError::ModesMost`] for more modes than links,
/// [`StructureError::FrequencyOrder`], [`StructureError::Mode`], [`StructureError::Height`] for a sensor above the
/// top.
///
/// # Limits
/// "Every solution" is every solution found: many starts are no proof. Standard deviations are linear: above some 30 %
/// of k they are only an order of magnitude. Small rotations, rigid links, a known mass.
///
/// # Source
/// The future work announced by Choi (2021), sec. 5; damped Gauss–Newton with variable projection (Golub & Pereyra
/// 1973 SIAM J. Numer. Anal. 10:413-432) and exact derivatives of simple modes (Fox & Kapoor 1968 AIAA J. 6:2426-2429).
///
/// # Example
/// ```
/// use dolmen::structure::{Chain, ChainStiffness, Choice, Inertia, Link, MeasuredMode, chain_stiffness};
/// let link = Link {
///     mass_kg: 1000.0,
///     length_m: 3.0,
///     centroid_m: 1.5,
///     inertia: Inertia::ThinRod,
///     bed_width_m: None,
/// };
/// let chain = Chain::new(vec![link], 9.81)?;
/// let measured = MeasuredMode {
///     frequency_hz: 2.0,
///     frequency_sd_hz: 0.02,
///     shape: vec![],
/// };
/// let found = chain_stiffness(&chain, &[measured], &ChainStiffness::default())?;
/// let k = (std::f64::consts::TAU * 2.0).powi(2) * 3000.0 + 1000.0 * 9.81 * 1.5; // ω² I + m g l
/// assert_eq!(found.choice, Choice::One);
/// assert!((found.solutions[0].stiffness[0] / k - 1.0).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::StructureError>(())
/// ```
pub fn chain_stiffness(
    chain: &Chain,
    modes: &[MeasuredMode],
    options: &ChainStiffness,
) -> Result<StiffnessSolutions, StructureError> {
    check_modes(modes, chain.links().len(), "links")?;
    let weighting = Weighting::of(modes);
    let fit = ModalFit::new(chain, modes, weighting.stand_in(options))?;
    let mut search = Search {
        chain,
        modes,
        options,
        fit,
        weighting,
        independent: 0,
    };
    let prior = search.prior();
    if let Some(at) = search.fit.residuals(&prior) {
        search.independent = rank(&singular_values(&at.jacobian)?);
    }
    if search.independent < chain.links().len() {
        search.nearest_to_the_prior(&prior)
    } else {
        search.many_starts(&prior)
    }
}

/// Whether the data are weighted by standard deviations.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Weighting {
    /// None has one: relative differences.
    Relative,
    /// All have.
    Given,
    /// Some have; the others get an assumed one.
    PartlyAssumed,
}

impl Weighting {
    fn of(modes: &[MeasuredMode]) -> Self {
        let all = modes.iter().flat_map(|mode| {
            let points = mode.shape.iter().map(|point| point.displacement_sd);
            points.chain([mode.frequency_sd_hz])
        });
        let (given, count) = all.fold((0, 0), |(given, count), sd| {
            (given + usize::from(sd > 0.0), count + 1)
        });
        match given {
            0 => Weighting::Relative,
            given if given == count => Weighting::Given,
            _ => Weighting::PartlyAssumed,
        }
    }

    fn stand_in(self, options: &ChainStiffness) -> StandIn {
        match self {
            Weighting::Relative => StandIn {
                frequency: 1.0,
                shape: 1.0,
            },
            _ => StandIn {
                frequency: options.frequency_sd_assumed,
                shape: options.shape_sd_assumed,
            },
        }
    }
}

/// One minimum.
struct Found {
    x: Vec<f64>,
    misfit: f64,
    jacobian: Matrix,
}

pub(super) struct Count {
    pub(super) starts: usize,
    pub(super) solutions: usize,
}

pub(super) struct Search<'a> {
    pub(super) chain: &'a Chain,
    pub(super) modes: &'a [MeasuredMode],
    pub(super) options: &'a ChainStiffness,
    pub(super) fit: ModalFit,
    pub(super) weighting: Weighting,
    /// Rank of the Jacobian where stiffness is in proportion to M_i.
    pub(super) independent: usize,
}

impl Search<'_> {
    fn found(&self, fit: LeastSquaresFit) -> Found {
        let squares: f64 = fit.at.residual.iter().map(|r| r * r).sum();
        Found {
            misfit: (squares / self.fit.data() as f64).sqrt(),
            x: fit.x,
            jacobian: fit.at.jacobian,
        }
    }

    fn misfit_accepted(&self) -> f64 {
        match self.weighting {
            Weighting::Relative => self.options.difference_most,
            _ => self.options.misfit_most,
        }
    }

    /// ln M_i, scaled so that the frequencies fit best on average.
    fn prior(&self) -> Vec<f64> {
        self.scaled(
            self.chain
                .necessary_n_m_rad()
                .iter()
                .map(|m| m.max(f64::MIN_POSITIVE).ln())
                .collect(),
        )
    }

    fn many_starts(&self, prior: &[f64]) -> Result<StiffnessSolutions, StructureError> {
        let n = self.chain.links().len();
        let only_frequencies = n > 1 && self.fit.data() == self.modes.len();
        let mut all: Vec<Found> = Vec::new();
        let mut tried = 0;
        if let Some(start) = linear_estimate(self.chain, self.modes)? {
            tried += 1;
            self.descend(start, &mut all);
        }
        for batch in 0..BATCHES_MOST {
            for start in scattered_starts(prior, batch * self.options.starts, self.options.starts) {
                tried += 1;
                self.descend(self.scaled(start), &mut all);
            }
            let exact = all.iter().filter(|found| found.misfit < EXACT).count();
            if !only_frequencies || exact.is_multiple_of(2) || exact > self.options.solutions_most {
                break;
            }
        }
        all.sort_by(|a, b| {
            rounded(a.misfit)
                .total_cmp(&rounded(b.misfit))
                .then(a.x[0].total_cmp(&b.x[0]))
        });
        let nearest = all.first().map(|found| found.misfit);
        let exact = nearest.is_some_and(|misfit| misfit < EXACT) && self.weighting == Weighting::Relative;
        let most = if exact { EXACT } else { self.misfit_accepted() };
        all.retain(|found| found.misfit <= most);

        let data = self.fit.data() as f64;
        let equally_good = |found: &Found, best: &Found| match self.weighting {
            Weighting::Relative => rounded(found.misfit) <= rounded(best.misfit),
            _ => data * (found.misfit.powi(2) - best.misfit.powi(2)) <= CHI_SQUARED_95,
        };
        let full_rank =
            |found: &Found| Ok::<bool, StructureError>(rank(&singular_values(&found.jacobian)?) == n);
        let choice = match all.first() {
            None => Choice::Impossible,
            Some(best) if !full_rank(best)? => Choice::Underdetermined,
            Some(best) if all.iter().filter(|found| equally_good(found, best)).count() > 1 => {
                Choice::Indistinguishable
            }
            Some(_) => Choice::One,
        };
        self.answer(all, choice, tried, nearest)
    }

    /// Adds the minimum that a start leads to, unless it is there already.
    fn descend(&self, start: Vec<f64>, all: &mut Vec<Found>) {
        let end = levenberg_marquardt(start, ITERATIONS_MOST, |x| self.fit.residuals(x));
        let Some(found) = end.map(|end| self.found(end)) else {
            return;
        };
        let near = |other: &Found| other.x.iter().zip(&found.x).all(|(a, b)| (a - b).abs() < SAME);
        if !all.iter().any(near) {
            all.push(found);
        }
    }

    /// Fewer independent data than joints: of all that fit, the one nearest to the prior in ln k, its common factor free.
    fn nearest_to_the_prior(&self, prior: &[f64]) -> Result<StiffnessSolutions, StructureError> {
        let n = self.chain.links().len();
        let mut x = prior.to_vec();
        let mut end = None;
        for weight in PRIOR_WEIGHTS {
            let with_prior = |x: &[f64]| {
                let at = self.fit.residuals(x)?;
                let off: Vec<f64> = x.iter().zip(prior).map(|(x, p)| x - p).collect();
                let mean = off.iter().sum::<f64>() / n as f64;
                let m = at.residual.len();
                let mut residual = at.residual;
                residual.extend(off.iter().map(|d| weight * (d - mean)));
                let jacobian = Matrix::from_fn(m + n, n, |i, j| match i.checked_sub(m) {
                    None => at.jacobian[(i, j)],
                    Some(row) => weight * (f64::from(u8::from(row == j)) - 1.0 / n as f64),
                });
                Some(Residuals { residual, jacobian })
            };
            if let Some(fit) = levenberg_marquardt(x.clone(), ITERATIONS_MOST, with_prior) {
                x = fit.x;
            }
            end = self.fit.residuals(&x);
        }
        let found = end.map(|at| self.found(LeastSquaresFit { x, at }));
        let nearest = found.as_ref().map(|found| found.misfit);
        let accepted: Vec<Found> = found
            .into_iter()
            .filter(|found| found.misfit <= self.misfit_accepted())
            .collect();
        let choice = if accepted.is_empty() {
            Choice::Impossible
        } else {
            Choice::Underdetermined
        };
        self.answer(accepted, choice, 1, nearest)
    }

    /// The same proportions with the common factor that fits the frequencies' logarithms on average.
    ///
    /// Gravity takes its share whatever the springs are, so the factor is found by doubling until the chain stands,
    /// then by the secant of the mean of ln ω² (its slope in ln k is near 1).
    fn scaled(&self, mut x: Vec<f64>) -> Vec<f64> {
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

    fn answer(
        &self,
        mut all: Vec<Found>,
        choice: Choice,
        starts: usize,
        nearest: Option<f64>,
    ) -> Result<StiffnessSolutions, StructureError> {
        let visibility = all.first().map(|best| self.visibility(best)).transpose()?;
        let count = Count {
            starts,
            solutions: all.len(),
        };
        let mut notes = notes::of_solutions(self, count, choice, nearest);
        if let Some(best) = all.first() {
            notes.extend(notes::of_free_directions(&svd(&tall(&best.jacobian))?, choice));
        }
        if let Some(visibility) = &visibility {
            notes.extend(notes::of_unseen_joints(visibility));
        }
        all.truncate(self.options.solutions_most);
        let solutions = all.iter().map(|found| self.solution(found, choice));
        Ok(StiffnessSolutions {
            solutions: solutions.collect::<Result<_, _>>()?,
            choice,
            visibility,
            starts,
            notes,
        })
    }

    fn solution(&self, found: &Found, choice: Choice) -> Result<StiffnessSolution, StructureError> {
        let stiffness: Vec<f64> = found.x.iter().map(|x| x.exp()).collect();
        let relative_sd = match (self.weighting, choice) {
            (Weighting::Relative, _) | (_, Choice::Underdetermined) => None,
            _ => self.relative_sd(found)?,
        };
        let modes = self.chain.natural_modes(&stiffness)?;
        Ok(StiffnessSolution {
            stiffness_sd: relative_sd.map(|sd| sd.iter().zip(&stiffness).map(|(sd, k)| sd * k).collect()),
            stiffness_range: None,
            stands: modes.first().is_some_and(|mode| mode.omega_squared > 0.0),
            stiffness,
            modes,
            misfit: found.misfit,
        })
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

fn singular_values(jacobian: &Matrix) -> Result<Vec<f64>, StructureError> {
    Ok(svd(&tall(jacobian))?.s)
}

pub(super) fn rank(singular_values: &[f64]) -> usize {
    let least = RANK_LEAST * singular_values.first().copied().unwrap_or(0.0);
    singular_values.iter().filter(|&&s| s > least).count()
}
