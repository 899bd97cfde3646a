//! The possible range of each factor if all factors lie in a band, and the best factors if the modes determine them.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | x_j | | ln c_j | – |
//! | χ²(x) | `squares` | sum of squared residuals (computed − measured)/sd | |
//!
//! ```text
//! x_j is possible if  min over the other x in the band of χ²(x) ≤ χ²_least + 3.84 w²,   w² = max(1, χ²_least/(data − unknowns))
//! ```
//!
//! With one frequency the ends are exact: all other factors are then at one bound. If the best fit is a single point from every start, the search
//! for the ends goes outwards from it. Otherwise the farthest possible x_j is searched from outside inwards, each time from several starts, because
//! different factors may explain the same modes.

use super::alike::{alike, say_alike};
use super::bounds::crossing;
use super::model::{Datum, FactorModel, ModeOfFamily};
use super::result::FactorRange;
use super::sight::TWO_SIDED_95;
use crate::numeric::{BoundedFit, BoundedStop, Random, bounded_least_squares, chi_squared_quantile};
use dolmen_linalg::{Matrix, svd};
use rayon::prelude::*;

/// Increase of χ² above its minimum for 95 % and one degree of freedom.
const CHI_SQUARED_95: f64 = 3.841_458_820_694_124;
/// Probability of a smaller χ² by chance above which no factors in the band explain the modes: one in a thousand surveys exceeds it. Our choice.
const EXPLAINED: f64 = 0.999;
/// Number of random starts of the best fit, in addition to the common factor, and their seed. Our choice.
const STARTS: usize = 6;
const SEED: u64 = 1;
/// Number of test points between the outer bound and a possible factor. Our choice.
const SCAN: usize = 5;
/// Tolerance in ln c of ends that are searched from outside. Our choice: one per cent.
const END_WITHIN: f64 = 0.01;
/// Relative tolerance of ends that are searched from the best fit, and largest number of trials. Our choice.
const END_NEAR: f64 = 0.01;
const GUESSES: usize = 30;
/// Stopping criterion of the fit of the other factors while one is fixed. Our choice: far below the tolerance of the ends.
const PROFILE: BoundedStop = BoundedStop {
    evaluations_most: 30,
    enough: 0.0,
    decrease_least: 1e-3,
};
/// Largest standard deviation of ln c for which a best value is stated: a larger interval of the factor would include negative values.
const RELATIVE_SD_MOST: f64 = 0.5;
/// Largest component of a factor in undetermined combinations; above it the data do not determine the factor. Our choice.
const UNSEEN_MOST: f64 = 1e-6;
/// Difference in ln c below which two fits count as the same point. Our choice.
const ONE_POINT: f64 = 0.01;
/// Ratio to the largest singular value below which a singular value is rounding.
const RANK: f64 = 1e-10;
/// Largest ratio of the range to the linear 95 % interval for which a best value is stated; above it, other factors explain the modes as well. Our
/// choice.
const LINEAR_WITHIN: f64 = 2.0;

pub(super) struct Ranges {
    pub(super) best: Vec<f64>,
    pub(super) squares: f64,
    /// Whether the misfit of the best fit can be due to chance.
    pub(super) explains: bool,
    /// Best value and standard deviation of ln c of each determined factor.
    pub(super) determined: Vec<Option<[f64; 2]>>,
    /// Range of each factor; empty if no factors in the band explain the modes.
    pub(super) ranges: Vec<FactorRange>,
}

/// The ranges of all factors whose ln lies within `half_band` of `centre`; `None` if a mode has no frequency there.
pub(super) fn ranges(model: &FactorModel, centre: f64, half_band: f64) -> Option<Ranges> {
    let n = model.unknowns;
    let mut search = Search {
        model,
        lower: vec![centre - half_band; n],
        upper: vec![centre + half_band; n],
        allowed: 0.0,
        one_point: None,
        squares: 0.0,
    };
    let mut minima = search.minima(centre);
    let at = (0..minima.len()).min_by(|&a, &b| minima[a].squares.total_cmp(&minima[b].squares))?;
    let best = minima.swap_remove(at);
    let spare = model.data_count().saturating_sub(n);
    let excess = match spare {
        0 => 1.0,
        spare => (best.squares / spare as f64).max(1.0),
    };
    let most = chi_squared_quantile(EXPLAINED, model.data_count() as f64).ok()?;
    let explains = best.squares <= most;
    search.allowed = best.squares + CHI_SQUARED_95 * excess;
    minima.retain(|one| one.squares <= search.allowed);
    let is_far = |one: &BoundedFit| one.x.iter().zip(&best.x).any(|(a, b)| (a - b).abs() > ONE_POINT);
    let is_one_point = model.data_count() >= n && !minima.iter().any(is_far);
    search.one_point = is_one_point.then(|| best.x.clone());
    search.squares = best.squares;
    let mut possible: Vec<Vec<f64>> = minima.into_iter().map(|one| one.x).collect();
    possible.push(best.x.clone());
    let linear = linear(&best, n, excess.sqrt());
    let mut ranges: Vec<FactorRange> = match explains {
        true => (0..n)
            .into_par_iter()
            .map(|j| search.range(j, linear[j], possible.clone()))
            .collect(),
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
    say_alike(&alike(model, centre), &mut determined, &mut ranges);
    Some(Ranges {
        squares: best.squares,
        best: best.x,
        explains,
        determined,
        ranges,
    })
}

/// Standard deviation of each ln c that the data determine near the best fit.
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
    /// Sum of squares up to which factors are possible.
    allowed: f64,
    /// The best fit, if all starts lead to it.
    one_point: Option<Vec<f64>>,
    /// The smallest sum of squares.
    squares: f64,
}

/// One side of the range of a factor.
struct Side {
    j: usize,
    /// −1 down, 1 up.
    sign: f64,
}

impl Search<'_> {
    fn fit(&self, start: &[f64], held: Option<(usize, f64)>, stop: &BoundedStop) -> Option<BoundedFit> {
        let (mut lower, mut upper) = (self.lower.clone(), self.upper.clone());
        if let Some((j, at)) = held {
            (lower[j], upper[j]) = (at, at);
        }
        bounded_least_squares(start, [&lower, &upper], stop, |x| self.model.residuals(x))
    }

    /// Local minima of χ² in the band from several starts.
    fn minima(&self, centre: f64) -> Vec<BoundedFit> {
        let stop = BoundedStop {
            evaluations_most: 200,
            enough: 1e-20,
            decrease_least: 1e-14,
        };
        let n = self.lower.len();
        let mut random = Random::new(SEED, 0);
        let mut starts = vec![vec![centre; n]];
        // within the middle half of the band
        let width = 0.5 * (self.upper[0] - self.lower[0]);
        for _ in 0..STARTS * usize::from(n > 1) {
            starts.push(
                (0..n)
                    .map(|_| centre + width * (random.uniform() - 0.5))
                    .collect(),
            );
        }
        let each = starts.par_iter().map(|start| self.fit(start, None, &stop));
        let each: Vec<Option<BoundedFit>> = each.collect();
        each.into_iter().flatten().collect()
    }

    fn range(&self, j: usize, sd: Option<f64>, mut possible: Vec<Vec<f64>>) -> FactorRange {
        let mut end = |sign| {
            let side = Side { j, sign };
            let bound = self.bound_of_each_frequency(&side);
            match &self.one_point {
                _ if self.is_one_frequency() => bound,
                Some(best) => self.end_from(best, &side, bound, sd),
                None => self.end_from_outside(&side, bound, &mut possible),
            }
        };
        let (lower, upper) = (end(-1.0), end(1.0));
        FactorRange {
            lower: lower.exp(),
            upper: upper.exp(),
            is_lower_of_band: lower <= self.lower[j],
            is_upper_of_band: upper >= self.upper[j],
        }
    }

    /// The end of the range on one side, searched outwards from the best fit. √(χ² − χ²_least) grows about linearly with the distance, so the next
    /// trial is where this line reaches the limit, with some distance from known ends.
    fn end_from(&self, best: &[f64], side: &Side, bound: f64, sd: Option<f64>) -> f64 {
        let from = best[side.j];
        let far = (bound - from).abs();
        let height = (self.allowed - self.squares).sqrt();
        let linear = sd.map_or(far, |sd| (TWO_SIDED_95 * sd).min(far));
        // outermost possible and innermost impossible value of the factor, each with √(χ² − χ²_least)
        let (mut inside, mut outside) = ([0.0, 0.0], None::<[f64; 2]>);
        let (mut way, mut last) = (linear, best.to_vec());
        for _ in 0..GUESSES {
            let at = from + side.sign * way;
            let gone = (last[side.j] - from).abs();
            let stretch = if gone > 0.0 { way / gone } else { 0.0 };
            let start: Vec<f64> = best
                .iter()
                .zip(&last)
                .map(|(best, last)| best + stretch * (last - best))
                .collect();
            let rise = match self.fit(&start, Some((side.j, at)), &PROFILE) {
                Some(found) => {
                    last.clone_from(&found.x);
                    (found.squares - self.squares).max(0.0).sqrt()
                }
                None => f64::INFINITY,
            };
            match rise <= height {
                true => inside = [way, rise],
                false => outside = Some([way, rise]),
            }
            if way >= far && rise <= height {
                return bound;
            }
            let is_near = (rise - height).abs() < END_NEAR * height;
            if is_near || outside.is_some_and(|outside| outside[0] - inside[0] < 1e-9) {
                break;
            }
            way = match outside {
                None => (way * (height / rise.max(0.1 * height)).clamp(1.1, 4.0)).min(far),
                Some(outside) => {
                    let part = (height - inside[1]) / (outside[1] - inside[1]);
                    let part = if part.is_finite() {
                        part.clamp(0.1, 0.9)
                    } else {
                        0.5
                    };
                    inside[0] + part * (outside[0] - inside[0])
                }
            };
        }
        from + side.sign * way
    }

    /// The farthest possible x_j on one side, searched from outside inwards.
    fn end_from_outside(&self, side: &Side, bound: f64, possible: &mut Vec<Vec<f64>>) -> f64 {
        if self.is_possible(side, bound, possible) {
            return bound;
        }
        let farther = |a: f64, b: f64| if side.sign * a > side.sign * b { a } else { b };
        let mut inside = possible
            .iter()
            .fold(-side.sign * f64::INFINITY, |far, x| farther(x[side.j], far));
        let mut outside = bound;
        for step in 1..SCAN {
            let at = bound + (inside - bound) * step as f64 / SCAN as f64;
            if self.is_possible(side, at, possible) {
                inside = at;
                break;
            }
            outside = at;
        }
        while (outside - inside).abs() > END_WITHIN {
            let middle = 0.5 * (outside + inside);
            match self.is_possible(side, middle, possible) {
                true => inside = middle,
                false => outside = middle,
            }
        }
        inside
    }

    fn is_one_frequency(&self) -> bool {
        let is_of_order = |datum: &Datum| matches!(datum.which, ModeOfFamily::Order(_));
        matches!(self.model.data.as_slice(), [datum] if datum.shape.is_none() && is_of_order(datum))
    }

    /// Outer bound of x_j on one side: each frequency taken alone is possible for some values of the other factors.
    fn bound_of_each_frequency(&self, side: &Side) -> f64 {
        // if this joint is soft, the other joints must be stiff
        let (edge, others) = match side.sign < 0.0 {
            true => (self.lower[side.j], &self.upper),
            false => (self.upper[side.j], &self.lower),
        };
        let band = [self.lower[side.j], self.upper[side.j]];
        let mut bound = edge;
        for datum in &self.model.data {
            // only frequencies of a fixed order increase with every factor
            let ModeOfFamily::Order(order) = datum.which else {
                continue;
            };
            let off = side.sign * self.allowed.sqrt() * datum.relative_sd;
            let family = &self.model.families[datum.family];
            let square = |factors: &[f64]| family.square_of(factors, order);
            if let Some(x) = crossing(square, datum, side.j, others, band, off) {
                bound = match side.sign < 0.0 {
                    true => bound.max(x),
                    false => bound.min(x),
                };
            }
        }
        bound
    }

    /// Whether some values of the other factors in the band explain the modes with x_j fixed.
    fn is_possible(&self, side: &Side, at: f64, possible: &mut Vec<Vec<f64>>) -> bool {
        let stop = BoundedStop {
            enough: self.allowed,
            ..PROFILE
        };
        let j = side.j;
        let nearest = possible
            .iter()
            .min_by(|a, b| (a[j] - at).abs().total_cmp(&(b[j] - at).abs()));
        // if this joint is soft, start with stiff other joints
        let others = match side.sign < 0.0 {
            true => &self.upper,
            false => &self.lower,
        };
        let starts: Vec<Vec<f64>> = nearest.into_iter().chain([others]).cloned().collect();
        for start in starts {
            if let Some(found) = self.fit(&start, Some((j, at)), &stop)
                && found.squares <= self.allowed
            {
                possible.push(found.x);
                return true;
            }
        }
        false
    }
}
