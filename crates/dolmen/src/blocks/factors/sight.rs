//! Sensitivity of each mode to the joints, and the number of combinations of factors that all modes determine.

use super::model::{Datum, FactorModel, product};
use super::result::CommonFactor;
use crate::numeric::{BoundedStop, Residuals, bounded_least_squares};
use dolmen_linalg::{LinalgError, Matrix, svd};

/// Range of the common factor in the search: e^±18, a factor of 7e7. Our choice: far beyond any stone joint.
const COMMON_MOST: f64 = 18.0;
/// Half-width of a two-sided 95 % interval, in standard deviations.
pub(super) const TWO_SIDED_95: f64 = 1.959_963_984_540_054;

impl FactorModel {
    /// The fraction of the strain energy of each measured mode in the springs of each factor: c_g φᵀ K_g φ / λ; `None` if a mode has no frequency.
    pub(super) fn energy_shares(&self, factors: &[f64]) -> Option<Vec<Vec<f64>>> {
        let modes = self.modes(factors)?;
        let of = |datum: &Datum| {
            let modes = modes[datum.family].as_ref()?;
            let order = self.order(datum, modes)?;
            let mode = modes.vectors.column(order);
            let square = modes.values.get(order).filter(|square| **square > 0.0)?;
            let groups = self.families[datum.family].groups.iter().zip(factors);
            let share = groups.map(|(group, factor)| factor * product(mode, &group.times(mode)) / square);
            Some(share.collect())
        };
        self.data.iter().map(of).collect()
    }

    /// The common factor that fits the data best; `None` if the modes have no frequencies.
    pub(super) fn common(&self) -> Option<CommonFactor> {
        let at = |x: &[f64]| {
            let all = self.residuals(&vec![x[0]; self.unknowns])?;
            let rows = all.residual.len();
            let jacobian = Matrix::from_fn(rows, 1, |i, _| {
                (0..self.unknowns).map(|g| all.jacobian[(i, g)]).sum()
            });
            Some(Residuals {
                residual: all.residual,
                jacobian,
            })
        };
        let stop = BoundedStop {
            evaluations_most: 100,
            enough: 0.0,
            decrease_least: 0.0,
        };
        let fit = bounded_least_squares(&[0.0], [&[-COMMON_MOST], &[COMMON_MOST]], &stop, at)?;
        let data = self.data_count() as f64;
        let information = product(fit.at.jacobian.column(0), fit.at.jacobian.column(0));
        let widened = match data > 1.0 {
            true => (fit.squares / (data - 1.0)).sqrt().max(1.0),
            false => 1.0,
        };
        Some(CommonFactor {
            factor: fit.x[0].exp(),
            relative_sd: widened / information.sqrt(),
            misfit: (fit.squares / data).sqrt(),
        })
    }

    /// Singular values of the derivatives at x, descending, one for each datum.
    pub(super) fn singular_values(&self, x: &[f64]) -> Result<Vec<f64>, LinalgError> {
        let Some(at) = self.residuals(x) else {
            return Ok(Vec::new());
        };
        let most = self.data_count().min(self.unknowns);
        Ok(svd(&at.jacobian)?.s.into_iter().take(most).collect())
    }
}

/// Number of combinations of factors whose 95 % interval is narrower than the band, which extends by `half_band` in ln c to each side.
pub(super) fn fixed_combinations(singular_values: &[f64], half_band: f64) -> usize {
    let is_fixed = |s: &&f64| TWO_SIDED_95 / **s < half_band;
    singular_values.iter().filter(is_fixed).count()
}
