//! State of the search for stiffness: the problem, and the solutions found.

use super::modal_fit::ModalFit;
use super::options::Weighting;
use super::{FrequencyRoots, SpringModel, Sprung, StiffnessSearch};
use crate::numeric::LeastSquaresFit;
use crate::structure::{MeasuredMode, StructureError};
use dolmen_linalg::{Matrix, svd};

/// Largest number of iterations from one start: from far starts about 30 suffice.
pub(super) const ITERATIONS_MOST: usize = 120;
/// Misfit below which the data are reproduced exactly, except for rounding.
pub(super) const EXACT: f64 = 1e-9;
/// Singular values below this share of the largest are 0.
const RANK_LEAST: f64 = 1e-8;

pub(super) struct Minimum {
    pub(super) x: Vec<f64>,
    pub(super) misfit: f64,
    pub(super) jacobian: Matrix,
}

pub(super) struct Count {
    pub(super) starts: usize,
    pub(super) solutions: usize,
    /// Number of solutions as good as the best.
    pub(super) as_good: usize,
    /// Smallest misfit of all searches, accepted or not.
    pub(super) nearest: Option<f64>,
    /// Whether the number of solutions shows that at least one is missing.
    pub(super) odd: bool,
    /// Result of following all solutions, if that was done.
    pub(super) roots: Option<FrequencyRoots>,
}

pub(super) struct Search<'a, S> {
    pub(super) structure: &'a S,
    pub(super) modes: &'a [MeasuredMode],
    pub(super) options: &'a StiffnessSearch,
    pub(super) model: SpringModel,
    pub(super) fit: ModalFit,
    pub(super) weighting: Weighting,
    /// Rank of the Jacobian at the first guess.
    pub(super) independent: usize,
}

impl<S: Sprung> Search<'_, S> {
    pub(super) fn parts(&self) -> usize {
        self.model.parts()
    }

    pub(super) fn found(&self, fit: LeastSquaresFit) -> Minimum {
        let squares: f64 = fit.at.residual.iter().map(|r| r * r).sum();
        Minimum {
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

    /// The same proportions, with the common factor that fits the mean logarithm of the frequencies.
    ///
    /// Gravity reduces the stiffness by the same amount for any springs. So the factor is doubled until the structure
    /// is stable; then the secant method on the mean of ln ω² finds the factor (the slope in ln k is near 1).
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
}

/// The Jacobian with rows of zeros added until it has at least as many rows as columns, so that all right singular
/// vectors exist.
pub(super) fn tall(jacobian: &Matrix) -> Matrix {
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
