//! Where each factor can lie if all lie in a band, and the factors themselves where the modes determine them.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_j | | ln c_j | – |
//! | χ²(x) | `squares` | squares of (computed − measured)/sd | |
//!
//! ```text
//! x_j is possible if  min over the other x in the band of χ²(x) ≤ χ²_least + 3.84 w²,   w² = max(1, χ²_least/(data − unknowns))
//! ```
//!
//! One frequency decides by itself: the ends lie where all others are at one bound. Of several, the possible x_j farthest out is sought from outside
//! inwards, each time from several starts, since different choices may explain the same modes.

use super::model::FactorModel;
use super::result::FactorRange;
use super::sight::TWO_SIDED_95;
use crate::numeric::{BoundedFit, BoundedStop, Random, bounded_least_squares, chi_squared_quantile};
use dolmen_linalg::{Matrix, svd};

/// χ² of one factor beyond the least, 95 % of one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_458_820_694_124;
/// χ² that chance exceeds in one of a thousand surveys: beyond that nothing in the band explains the modes. Chosen here.
const EXPLAINED: f64 = 0.999;
/// Starts of the best fit beside that at the common factor, and their seed. Chosen here.
const STARTS: usize = 6;
const SEED: u64 = 1;
/// Points between the outermost bound and a possible factor at which it is asked whether a factor is possible. Chosen here.
const SCAN: usize = 5;
/// Ends are found to this in ln c, and to this part of the deviation where that is smaller. Chosen here: half a per cent.
const END_WITHIN: f64 = 0.005;
const END_WITHIN_SD: f64 = 0.05;
/// Deviation of ln c above which no best value is stated: its interval would reach below 0.
const RELATIVE_SD_MOST: f64 = 0.5;
/// Part of a factor in combinations that the data do not see, from which they do not determine it. Chosen here.
const UNSEEN_MOST: f64 = 1e-6;
/// Singular values below this part of the largest are rounding.
const RANK: f64 = 1e-10;
/// Factor on the linear interval of 95 % within which the range must lie for a best value to be stated: else another choice explains the modes as well. Chosen here.
const LINEAR_WITHIN: f64 = 2.0;

/// The band, and what was found in it.
pub(super) struct Ranges {
    pub(super) best: Vec<f64>,
    pub(super) squares: f64,
    /// Whether the best explains the modes within what chance allows.
    pub(super) explains: bool,
    /// Best value and deviation of ln c of each factor that is determined.
    pub(super) determined: Vec<Option<[f64; 2]>>,
    /// Of each factor; empty if nothing in the band explains the modes.
    pub(super) ranges: Vec<FactorRange>,
}

/// The ranges of all factors whose ln lies within `half_band` of `centre`; `None` if the modes have no frequencies there.
pub(super) fn ranges(model: &FactorModel, centre: f64, half_band: f64) -> Option<Ranges> {
    let n = model.unknowns;
    let mut search = Search {
        model,
        lower: vec![centre - half_band; n],
        upper: vec![centre + half_band; n],
        allowed: 0.0,
        possible: Vec::new(),
    };
    let best = search.best(centre)?;
    let spare = model.data_count().saturating_sub(n);
    let excess = match spare {
        0 => 1.0,
        spare => (best.squares / spare as f64).max(1.0),
    };
    let most = chi_squared_quantile(EXPLAINED, model.data_count() as f64).ok()?;
    let explains = best.squares <= most;
    search.allowed = best.squares + CHI_SQUARED_95 * excess;
    search.possible.push(best.x.clone());
    let linear = linear(&best, n, excess.sqrt());
    let ranges: Vec<FactorRange> = match explains {
        true => (0..n).map(|j| search.range(j, linear[j])).collect(),
        false => Vec::new(),
    };
    let determined = ranges.iter().zip(&linear).zip(&best.x).map(|((range, sd), x)| {
        let sd = sd.filter(|sd| *sd <= RELATIVE_SD_MOST)?;
        let most = LINEAR_WITHIN * TWO_SIDED_95 * sd + END_WITHIN;
        let is_near = x - range.lower.ln() <= most && range.upper.ln() - x <= most;
        let is_inside = !range.is_lower_of_band && !range.is_upper_of_band;
        (is_near && is_inside).then_some([x.exp(), sd])
    });
    let mut determined: Vec<Option<[f64; 2]>> = determined.collect();
    determined.resize(n, None);
    Some(Ranges {
        squares: best.squares,
        best: best.x,
        explains,
        determined,
        ranges,
    })
}

/// Deviation of each ln c that the data determine near the best fit.
fn linear(best: &BoundedFit, n: usize, widened: f64) -> Vec<Option<f64>> {
    let j = &best.at.jacobian;
    let rows = j.rows().max(n);
    let tall = Matrix::from_fn(rows, n, |i, g| if i < j.rows() { j[(i, g)] } else { 0.0 });
    let Ok(f) = svd(&tall) else {
        return vec![None; n];
    };
    let least = RANK * f.s.first().copied().unwrap_or(0.0);
    let of = |g: usize| {
        let (mut variance, mut unseen) = (0.0, 0.0);
        for (k, s) in f.s.iter().enumerate() {
            let part = f.v[(g, k)].powi(2);
            match *s > least {
                true => variance += part / (s * s),
                false => unseen += part,
            }
        }
        (unseen < UNSEEN_MOST).then_some(widened * variance.sqrt())
    };
    (0..n).map(of).collect()
}

struct Search<'a> {
    model: &'a FactorModel,
    lower: Vec<f64>,
    upper: Vec<f64>,
    /// Sum of squares up to which a choice is possible.
    allowed: f64,
    /// Choices known to be possible.
    possible: Vec<Vec<f64>>,
}

impl Search<'_> {
    fn fit(&self, start: &[f64], held: Option<(usize, f64)>, stop: &BoundedStop) -> Option<BoundedFit> {
        let (mut lower, mut upper) = (self.lower.clone(), self.upper.clone());
        if let Some((j, at)) = held {
            (lower[j], upper[j]) = (at, at);
        }
        bounded_least_squares(start, [&lower, &upper], stop, |x| self.model.residuals(x))
    }

    /// The choice in the band that explains the modes best, from several starts.
    fn best(&self, centre: f64) -> Option<BoundedFit> {
        let stop = BoundedStop {
            evaluations_most: 200,
            enough: 1e-20,
            decrease_least: 1e-14,
        };
        let n = self.lower.len();
        let mut best: Option<BoundedFit> = self.fit(&vec![centre; n], None, &stop);
        if n == 1 {
            return best;
        }
        let mut random = Random::new(SEED, 0);
        for _ in 0..STARTS {
            // in the middle half of the band
            let width = 0.5 * (self.upper[0] - self.lower[0]);
            let start: Vec<f64> = (0..n)
                .map(|_| centre + width * (random.uniform() - 0.5))
                .collect();
            if let Some(found) = self.fit(&start, None, &stop)
                && best.as_ref().is_none_or(|best| found.squares < best.squares)
            {
                best = Some(found);
            }
        }
        best
    }

    fn range(&mut self, j: usize, sd: Option<f64>) -> FactorRange {
        let within = sd
            .map_or(END_WITHIN, |sd| END_WITHIN.min(END_WITHIN_SD * sd))
            .max(1e-9);
        let [lower, upper] = [-1.0, 1.0].map(|side| self.end(j, side, within));
        FactorRange {
            lower: lower.exp(),
            upper: upper.exp(),
            is_lower_of_band: lower <= self.lower[j],
            is_upper_of_band: upper >= self.upper[j],
        }
    }

    /// The farthest possible x_j on a side.
    fn end(&mut self, j: usize, side: f64, within: f64) -> f64 {
        let edge = match side < 0.0 {
            true => self.lower[j],
            false => self.upper[j],
        };
        let outermost = |possible: &[Vec<f64>]| {
            let each = possible.iter().map(|x| x[j]);
            each.fold(
                -side * f64::INFINITY,
                |far, x| if side * x > side * far { x } else { far },
            )
        };
        let bound = self.bound_of_each_frequency(j, side, edge);
        if self.is_one_frequency() {
            return bound;
        }
        if self.is_possible(j, bound) {
            return bound;
        }
        let mut inside = outermost(&self.possible);
        let mut outside = bound;
        for step in 1..SCAN {
            let at = bound + (inside - bound) * step as f64 / SCAN as f64;
            if (at - inside).abs() < within {
                break;
            }
            if self.is_possible(j, at) {
                inside = at;
                break;
            }
            outside = at;
        }
        while (outside - inside).abs() > within {
            let middle = 0.5 * (outside + inside);
            match self.is_possible(j, middle) {
                true => inside = middle,
                false => outside = middle,
            }
        }
        inside
    }

    fn is_one_frequency(&self) -> bool {
        matches!(self.model.data.as_slice(), [datum] if datum.shape.is_none())
    }

    /// The farthest x_j on a side at which each frequency by itself is possible for some choice of the others: none is farther out.
    fn bound_of_each_frequency(&self, j: usize, side: f64, edge: f64) -> f64 {
        // to be soft, the others must be stiff
        let others = match side < 0.0 {
            true => &self.upper,
            false => &self.lower,
        };
        let mut bound = edge;
        for datum in &self.model.data {
            let off = side * self.allowed.sqrt() * datum.relative_sd;
            let crossing = self
                .model
                .crossing(datum, j, others, [self.lower[j], self.upper[j]], off);
            if let Some(x) = crossing {
                bound = match side < 0.0 {
                    true => bound.max(x),
                    false => bound.min(x),
                };
            }
        }
        bound
    }

    /// Whether some choice of the others explains the modes with x_j held.
    fn is_possible(&mut self, j: usize, at: f64) -> bool {
        let stop = BoundedStop {
            evaluations_most: 60,
            enough: self.allowed,
            decrease_least: 1e-3,
        };
        let nearest = self
            .possible
            .iter()
            .min_by(|a, b| (a[j] - at).abs().total_cmp(&(b[j] - at).abs()));
        let starts = [
            nearest.cloned(),
            Some(self.lower.clone()),
            Some(self.upper.clone()),
        ];
        for start in starts.into_iter().flatten() {
            if let Some(found) = self.fit(&start, Some((j, at)), &stop)
                && found.squares <= self.allowed
            {
                self.possible.push(found.x);
                return true;
            }
        }
        false
    }
}
