//! Interval of a stiffness from the profile of the misfit, for cases without a linear interval.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_i | `at` | fixed value of ln k_i | |
//! | χ²(x) | | squares of (computed − measured)/sd | |
//! | d | `way` | x_i minus its best value | |

use super::Sprung;
use super::search::{ITERATIONS_MOST, Minimum, Search};
use crate::numeric::{Residuals, levenberg_marquardt};
use crate::structure::StiffnessBounds;
use dolmen_linalg::Matrix;

/// Increase of chi-squared over the best fit at the end of an interval: 95 % for one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_459;
/// First step of ln k from the best value, and growth factor of the steps.
const STEP_FIRST: f64 = 0.25;
const STEP_GROWTH: f64 = 1.5;
/// Largest distances in ln k. A stiffness that may be 10,000 times larger has no upper bound; one that may be e⁴⁰ times smaller, if the fit is
/// practically rigid, has no lower bound.
const WAY_MOST: [f64; 2] = [40.0, 9.210_340_371_976_184];
/// A spring e¹⁴ times stiffer than the softest is practically rigid: beyond that, precision is lost and no bound can be found.
const RIGID: f64 = 14.0;
/// Accuracy of the bounds in ln k: a third of a per cent.
const END_WITHIN: f64 = 0.003;

impl<S: Sprung> Search<'_, S> {
    /// Both ends of the 95 % interval of every stiffness from its profile: with this stiffness fixed, the others are fitted again, and the interval
    /// ends where χ² exceeds the minimum by 3.84.
    ///
    /// ```text
    /// min over the other x of χ²(x_i, x) = χ²_best + 3.84 (widened²)
    /// ```
    ///
    /// A frequency with a given standard deviation counts by its difference in Hz: for a large standard deviation, a logarithm would make the lower
    /// bound too high. Data with common blocks of time are taken as independent here.
    pub(super) fn bounds(&self, best: &Minimum) -> Vec<StiffnessBounds> {
        let deviation = self.deviation_unit() * self.widened(best);
        let allowed = self.squares(best) + CHI_SQUARED_95 * deviation.powi(2);
        (0..best.x.len())
            .map(|i| StiffnessBounds {
                lower: self.end(best, i, -1.0, allowed),
                upper: self.end(best, i, 1.0, allowed),
            })
            .collect()
    }

    fn squares(&self, found: &Minimum) -> f64 {
        match self.fit.residuals_as_stated(&found.x) {
            Some(at) => at.residual.iter().map(|r| r * r).sum(),
            None => found.misfit.powi(2) * self.fit.data() as f64,
        }
    }

    /// One end of the interval of stiffness `i`; `None` if it has no end on that side.
    fn end(&self, best: &Minimum, i: usize, side: f64, allowed: f64) -> Option<f64> {
        let softest = best.x.iter().copied().fold(f64::INFINITY, f64::min);
        if side > 0.0 && best.x[i] - softest > RIGID {
            return None;
        }
        let way_most = WAY_MOST[usize::from(side > 0.0)];
        let mut inside = best.x.clone();
        let (mut way, mut step) = (0.0, STEP_FIRST);
        let mut outside = loop {
            if way >= way_most {
                return None;
            }
            let next: f64 = way + step;
            match self.held(&inside, i, best.x[i] + side * next, allowed) {
                Some(x) => {
                    inside = x;
                    way = next;
                    step *= STEP_GROWTH;
                }
                None => break next,
            }
        };
        while outside - way > END_WITHIN {
            let middle = 0.5 * (way + outside);
            match self.held(&inside, i, best.x[i] + side * middle, allowed) {
                Some(x) => {
                    inside = x;
                    way = middle;
                }
                None => outside = middle,
            }
        }
        Some((best.x[i] + side * way).exp())
    }

    /// The fit of the other stiffnesses with x_i fixed; `None` if its χ² exceeds `allowed` or the structure is unstable.
    fn held(&self, start: &[f64], i: usize, at: f64, allowed: f64) -> Option<Vec<f64>> {
        let whole = |others: &[f64]| {
            let mut x = others.to_vec();
            x.insert(i, at);
            x
        };
        let mut others = start.to_vec();
        others.remove(i);
        let end = levenberg_marquardt(others, ITERATIONS_MOST, |others| {
            let all = self.fit.residuals_as_stated(&whole(others))?;
            let column = |j: usize| if j < i { j } else { j + 1 };
            Some(Residuals {
                jacobian: Matrix::from_fn(all.residual.len(), others.len(), |p, j| {
                    all.jacobian[(p, column(j))]
                }),
                residual: all.residual,
            })
        })?;
        let squares: f64 = end.at.residual.iter().map(|r| r * r).sum();
        (squares <= allowed).then(|| whole(&end.x))
    }
}
