//! Uncertainty of each stiffness of a solution, as determined by the data.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | J = U S Vᵀ | `jacobian` | d(data over sd)/d(ln k) | |

use super::Sprung;
use super::options::Weighting;
use super::range::range_of_root;
use super::search::{Minimum, Search, rank, tall};
use crate::structure::{Choice, StiffnessBounds, StiffnessRange, StructureError, Visibility};
use dolmen_linalg::{Matrix, svd};

/// Relative standard deviation above which a linear 95 % interval is meaningless, because it would extend below 0.
const LINEAR_SD_MOST: f64 = 0.5;
/// Relative change of a datum that counts as visible if the data have no standard deviations: measured frequencies scatter by half a per cent. With
/// standard deviations the bound is one standard deviation.
const SEEN_RELATIVE: f64 = 0.005;

#[derive(Default)]
pub(super) struct StiffnessUncertainty {
    /// Standard deviation of each ln k, if the modes have standard deviations.
    pub(super) relative_sd: Option<Vec<f64>>,
    /// Interval of each stiffness, if a linear interval would extend below 0.
    pub(super) bounds: Option<Vec<StiffnessBounds>>,
}

impl<S: Sprung> Search<'_, S> {
    /// A linear interval if the modes have standard deviations and the interval is narrow; otherwise the profile likelihood, with given or assumed
    /// standard deviations.
    pub(super) fn known(
        &self,
        found: &Minimum,
        choice: Choice,
    ) -> Result<StiffnessUncertainty, StructureError> {
        if self.independent < self.parts() || self.meets_another(found)? {
            return Ok(StiffnessUncertainty::default());
        }
        let unit = self.deviation_unit();
        let linear = |sd: &Vec<f64>| sd.iter().all(|sd| unit * sd <= LINEAR_SD_MOST);
        let relative_sd = self.relative_sd(found)?.filter(linear);
        Ok(match relative_sd {
            None => StiffnessUncertainty {
                relative_sd: None,
                bounds: Some(self.bounds(found)),
            },
            Some(sd) => StiffnessUncertainty {
                relative_sd: self.interval_stated(choice).then_some(sd),
                bounds: None,
            },
        })
    }

    /// One standard deviation of a datum in units of its residual. Without given or assumed ones, that of a frequency.
    pub(super) fn deviation_unit(&self) -> f64 {
        match self.weighting {
            Weighting::Relative => self.options.frequency_sd_assumed,
            _ => 1.0,
        }
    }

    /// Factor on every interval: a misfit above 1 widens them if there are more data than unknowns.
    pub(super) fn widened(&self, found: &Minimum) -> f64 {
        let data = self.fit.data();
        match data.saturating_sub(found.x.len()) {
            0 => 1.0,
            spare => (found.misfit * (data as f64 / spare as f64).sqrt()).max(1.0),
        }
    }

    /// Whether the modes have standard deviations and determine the stiffness.
    fn interval_stated(&self, choice: Choice) -> bool {
        matches!(self.weighting, Weighting::Given | Weighting::PartlyAssumed)
            && choice != Choice::Underdetermined
    }

    /// Springs whose stiffness can change by a factor e while every datum changes by less than the visible amount.
    pub(super) fn unseen_springs(&self, found: &Minimum) -> Vec<usize> {
        let j = &found.jacobian;
        let column = |i: usize| j.column(i).iter().map(|d| d * d).sum::<f64>().sqrt();
        (0..found.x.len())
            .filter(|&i| column(i) < self.seen_bound())
            .collect()
    }

    /// Change of the data that counts as visible, in units of the residuals.
    pub(super) fn seen_bound(&self) -> f64 {
        match self.weighting {
            Weighting::Relative => SEEN_RELATIVE,
            _ => 1.0,
        }
    }

    /// Range of the stiffnesses while every frequency varies within √3 of its standard deviation.
    pub(super) fn range(&self, root: &[f64]) -> Option<StiffnessRange> {
        let frequencies: Vec<f64> = self.modes.iter().map(|mode| mode.frequency_hz).collect();
        let half_width = self
            .modes
            .iter()
            .map(|mode| 3.0_f64.sqrt() * mode.frequency_sd_hz);
        let half_width: Vec<f64> = half_width.collect();
        let positive = frequencies.iter().zip(&half_width).all(|(f, h)| f > h);
        positive.then(|| range_of_root(&self.model, &frequencies, &half_width, root))
    }

    /// Standard deviations √diag J⁺ C J⁺ᵀ, with C the correlations of the data; without correlations this is (JᵀJ)⁻¹. The misfit widens them if there
    /// are more data than unknowns. `None` if the data do not determine the stiffness.
    pub(super) fn relative_sd(&self, found: &Minimum) -> Result<Option<Vec<f64>>, StructureError> {
        let n = found.x.len();
        let f = svd(&tall(&found.jacobian))?;
        if rank(&f.s) < n {
            return Ok(None);
        }
        let widened = self.widened(found);
        let c = self.fit.correlations();
        let inverse = Matrix::from_fn(n, c.rows(), |i, p| {
            (0..n).map(|j| f.v[(i, j)] / f.s[j] * f.u[(p, j)]).sum()
        });
        let spread = &inverse * &c;
        let variance = |i: usize| {
            (0..c.rows())
                .map(|p| spread[(i, p)] * inverse[(i, p)])
                .sum::<f64>()
        };
        Ok(Some(
            (0..n).map(|i| widened * variance(i).max(0.0).sqrt()).collect(),
        ))
    }

    pub(super) fn visibility(&self, found: &Minimum) -> Result<Visibility, StructureError> {
        let n = found.x.len();
        let f = svd(&tall(&found.jacobian))?;
        let bound = self.seen_bound();
        let share = |s: f64| s * s / (s * s + bound * bound);
        let seen = |i: usize| (0..n).map(|j| f.v[(i, j)].powi(2) * share(f.s[j])).sum::<f64>();
        Ok(Visibility {
            free_directions: n - rank(&f.s),
            seen: (0..n).map(seen).collect(),
            singular_values: f.s,
        })
    }
}
