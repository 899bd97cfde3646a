//! Fewer independent data than springs: the fit that is nearest to an assumed proportion.

use super::Sprung;
use super::search::{Count, ITERATIONS_MOST, Minimum, Search};
use super::starts::scattered_starts;
use crate::numeric::{LeastSquaresFit, Residuals, levenberg_marquardt};
use crate::structure::{Choice, StiffnessSolutions, StructureError};
use dolmen_linalg::Matrix;

/// Decreasing weights of the prior relative to the data: the last is below the rounding of the data.
const PRIOR_WEIGHTS: [f64; 4] = [1.0, 1e-2, 1e-4, 1e-6];
/// Index of the first weight with almost no effect.
const LET_GO: usize = 2;

impl<S: Sprung> Search<'_, S> {
    /// The fit nearest to the prior in ln k; the common factor of the prior is free. If the search from the prior
    /// fails, the first fit from scattered starts.
    pub(super) fn nearest_to_the_prior(&self, prior: &[f64]) -> Result<StiffnessSolutions, StructureError> {
        let mut accepted: Vec<Minimum> = Vec::new();
        let mut nearest: Option<f64> = None;
        let mut tried = 0;
        for start in scattered_starts(prior, 0, self.options.starts) {
            tried += 1;
            // a strong prior would pull every start back to the end of the first search
            let weights = if tried == 1 {
                &PRIOR_WEIGHTS[..]
            } else {
                &PRIOR_WEIGHTS[LET_GO..]
            };
            let Some(found) = self.fit_near(prior, self.scaled(start), weights) else {
                continue;
            };
            nearest = Some(nearest.map_or(found.misfit, |least| least.min(found.misfit)));
            if found.misfit <= self.misfit_accepted() {
                accepted.push(found);
                break;
            }
        }
        let choice = if accepted.is_empty() {
            Choice::Impossible
        } else {
            Choice::Underdetermined
        };
        let count = Count {
            starts: tried,
            solutions: accepted.len(),
            as_good: accepted.len(),
            nearest,
            odd: false,
            roots: None,
        };
        self.answer(accepted, choice, count)
    }

    /// The fit reached by reducing the weight of the prior step by step.
    fn fit_near(&self, prior: &[f64], mut x: Vec<f64>, weights: &[f64]) -> Option<Minimum> {
        let n = prior.len();
        for &weight in weights {
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
            x = levenberg_marquardt(x, ITERATIONS_MOST, with_prior)?.x;
        }
        let at = self.fit.residuals(&x)?;
        Some(self.found(LeastSquaresFit { x, at }))
    }
}
