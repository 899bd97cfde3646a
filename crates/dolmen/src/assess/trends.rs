//! Trends of a result with one input, all other inputs equal: rank correlation, compared with chance.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | n | `values` | values of the input in one unit, within which results are not independent |
//! | S | `concordant − discordant` | concordant minus discordant pairs, over all groups |
//! | τ | `tau` | S over the pairs whose inputs differ |
//! | a, b | `inputs`, `results` | how two values of the input compare, and the results at them, summed over the groups of the unit |

use super::AssessError;
use crate::numeric::normal_probability;

/// Probability by chance below which a trend in an expected direction is significant, and a trend in either direction. Our choice.
const EXPECTED_BELOW: f64 = 0.05;
const EITHER_BELOW: f64 = 0.025;
/// Largest number of values for which all orders are enumerated; more values, without ties, use Mahonian numbers.
const COUNTED_MOST: usize = 7;
/// Largest total number of pairs for which the distribution is enumerated; above it the normal approximation is as good. Our choice.
const PAIRS_MOST: usize = 20_000;

/// Direction of a result as an input increases.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// It increases too.
    Rising,
    /// It decreases.
    Falling,
}

/// A rank correlation over groups in which all other inputs are equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Pairs of points within a group whose inputs differ.
    pub pairs: usize,
    /// Independent units with such pairs.
    pub units: usize,
    /// Pairs in which the larger input has the larger result.
    pub concordant: usize,
    /// Pairs in which the larger input has the smaller result.
    pub discordant: usize,
    /// (concordant − discordant) / pairs, −1 to 1; 0 without pairs.
    pub tau: f64,
    /// Standard deviation that `tau` would have if the input had no effect, –.
    pub tau_by_chance: f64,
    /// Probability of an increase at least this large by chance, if the input has no effect.
    pub rises_by_chance: f64,
    /// Probability by chance of a decrease at least this large.
    pub falls_by_chance: f64,
}

impl Trend {
    /// Whether a trend in the expected direction is significant: without an effect, one at least this strong in this direction would
    /// occur in less than 5 % of studies.
    pub fn shows(&self, direction: Direction) -> bool {
        self.by_chance(direction) < EXPECTED_BELOW
    }

    /// Direction of a trend without prior expectation, if it is significant: without an effect, a trend at least this strong in either
    /// direction would occur in less than 5 % of studies.
    pub fn direction(&self) -> Option<Direction> {
        let ways = [Direction::Rising, Direction::Falling];
        ways.into_iter().find(|way| self.by_chance(*way) < EITHER_BELOW)
    }

    fn by_chance(&self, direction: Direction) -> f64 {
        match direction {
            Direction::Rising => self.rises_by_chance,
            Direction::Falling => self.falls_by_chance,
        }
    }
}

/// Kendall's rank correlation of a result with an input, within groups only. A group holds (input, result) for which all other inputs are
/// equal. `units` are independent of each other, such as ground motions; the groups of one, such as the directions of a motion, are not:
/// chance orders them together. A result may be infinite: it is larger than all finite ones, and equal to other infinite ones.
///
/// ```text
/// S = Σ_u Σ_{i<j} a_ij b_ij,   a_ij = sgn(x_i − x_j),   b_ij = Σ_g sgn(y_gi − y_gj)        i, j: values of the input; g: groups of the unit u
/// var S = Σ_u A₁ B₁/(n(n−1)(n−2)) + A₂ B₂/(2n(n−1)),   A₂ = Σ_ij a_ij²,   A₁ = Σ_i (Σ_j a_ij)² − A₂,   B alike
/// ```
/// Probabilities are counted exactly over all orders of the values of the input in each unit, if it has up to 7 values, or one group without
/// ties. Otherwise S is taken as normal, reduced by ½ for continuity.
///
/// # Errors
/// [`AssessError::Trend`] for a value that is not a number.
///
/// # Limits
/// Equal results count as pairs without information, which brings `tau` closer to 0. With one unit of fewer than 4 values, or fewer than 5
/// units of 2, no trend can be significant. Each input is tested separately: of twenty inputs without effect, one seems significant.
///
/// # Source
/// Kendall, M. G. (1970) Rank Correlation Methods, 4th ed., sec. 4.4 and chapter 5; the variance of Daniels, H. E. (1944) Biometrika
/// 33(2):129; units after Korn, E. L. (1984) Biometrika 71(2):383, the stratified statistic.
///
/// # Example
/// ```
/// use dolmen::assess::{Direction, trend};
/// let group = vec![(3.0, 2.5), (5.0, 1.4), (7.0, 0.9)];
/// let found = trend(&[vec![group.clone()], vec![group.clone()]])?;
/// assert_eq!((found.pairs, found.units, found.tau), (6, 2, -1.0));
/// assert!((found.tau_by_chance * 6.0 - (2.0 * 11.0 / 3.0_f64).sqrt()).abs() < 1e-12);
/// assert!(found.shows(Direction::Falling));
/// // two directions of one motion say no more than one
/// let found = trend(&[vec![group.clone(), group]])?;
/// assert!((found.falls_by_chance - 1.0 / 6.0).abs() < 1e-12 && !found.shows(Direction::Falling));
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn trend(units: &[Vec<Vec<(f64, f64)>>]) -> Result<Trend, AssessError> {
    let (mut pairs, mut concordant, mut discordant, mut variance) = (0, 0, 0, 0.0);
    let mut independent = 0;
    let mut ordered = Vec::with_capacity(units.len());
    for groups in units {
        let before = pairs;
        for points in groups {
            for (i, &(x, y)) in points.iter().enumerate() {
                if x.is_nan() || y.is_nan() {
                    return Err(AssessError::Trend {
                        given: if x.is_nan() { x } else { y },
                    });
                }
                for &(other_x, other_y) in &points[..i] {
                    if x == other_x {
                        continue;
                    }
                    pairs += 1;
                    match ((x > other_x) == (y > other_y), y == other_y) {
                        (_, true) => {}
                        (true, false) => concordant += 1,
                        (false, false) => discordant += 1,
                    }
                }
            }
        }
        independent += usize::from(pairs > before);
        let unit = Unit::of(groups);
        variance += unit.variance();
        ordered.push(unit);
    }
    let whole = pairs as f64;
    let (tau, tau_by_chance) = if pairs == 0 {
        (0.0, 0.0)
    } else {
        (
            (concordant as f64 - discordant as f64) / whole,
            variance.sqrt() / whole,
        )
    };
    let s = concordant as i64 - discordant as i64;
    let [rises_by_chance, falls_by_chance] = match chances(&ordered, pairs) {
        Some(chance) => [at_least(&chance, s), at_least(&chance, -s)],
        None => {
            let over = variance.sqrt();
            let step = 1.0; // S of pairs with ties has steps of 1, without ties of 2: half of the larger
            let of = |s: f64| {
                if over > 0.0 {
                    normal_probability((step - s) / over)
                } else {
                    1.0
                }
            };
            [of(s as f64), of(-s as f64)]
        }
    };
    Ok(Trend {
        pairs,
        units: independent,
        concordant,
        discordant,
        tau,
        tau_by_chance,
        rises_by_chance,
        falls_by_chance,
    })
}

/// One unit: its values of the input, and how the results at each two of them compare.
struct Unit {
    /// a_ij, row by row.
    inputs: Vec<i64>,
    /// b_ij, row by row.
    results: Vec<i64>,
    /// n.
    values: usize,
    groups: usize,
}

impl Unit {
    fn of(groups: &[Vec<(f64, f64)>]) -> Unit {
        // a value that a group has more than once stands there as often
        let repeated =
            |points: &[(f64, f64)], i: usize| points[..i].iter().filter(|p| p.0 == points[i].0).count();
        let keys = groups.iter().flat_map(|points| {
            let each = points.iter().enumerate();
            each.map(|(i, point)| (point.0, repeated(points, i)))
        });
        let mut keys: Vec<(f64, usize)> = keys.collect();
        keys.sort_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        keys.dedup();
        let n = keys.len();
        let sign = |a: f64, b: f64| i64::from(a > b) - i64::from(a < b);
        let inputs = (0..n * n)
            .map(|at| sign(keys[at / n].0, keys[at % n].0))
            .collect();
        let mut results = vec![0; n * n];
        for points in groups {
            let place = |i: usize| {
                keys.iter()
                    .position(|key| *key == (points[i].0, repeated(points, i)))
            };
            let placed: Vec<(usize, f64)> = (0..points.len())
                .filter_map(|i| Some((place(i)?, points[i].1)))
                .collect();
            for &(i, y) in &placed {
                for &(j, other) in &placed {
                    results[i * n + j] += sign(y, other);
                }
            }
        }
        Unit {
            inputs,
            results,
            values: n,
            groups: groups.len(),
        }
    }

    /// Variance of S over all orders.
    fn variance(&self) -> f64 {
        let n = self.values as f64;
        let of_rows = |all: &[i64]| -> [f64; 2] {
            let square = all.iter().map(|x| (x * x) as f64).sum::<f64>();
            let rows = all
                .chunks(self.values.max(1))
                .map(|row| row.iter().sum::<i64>() as f64);
            [rows.map(|sum| sum * sum).sum::<f64>() - square, square]
        };
        let ([a1, a2], [b1, b2]) = (of_rows(&self.inputs), of_rows(&self.results));
        match self.values {
            0 | 1 => 0.0,
            2 => a2 * b2 / (2.0 * n * (n - 1.0)),
            _ => (a1 * b1 / (n * (n - 1.0) * (n - 2.0)) + a2 * b2 / (2.0 * n * (n - 1.0))).max(0.0),
        }
    }

    /// Largest |S| of any order.
    fn most(&self) -> usize {
        let n = self.values;
        let above = (0..n).flat_map(|i| (i + 1..n).map(move |j| (i, j)));
        above
            .map(|(i, j)| self.results[i * n + j].unsigned_abs() as usize)
            .sum()
    }

    /// Probability of each S from −most to most; `None` if there are too many orders to count.
    fn chance(&self) -> Option<Vec<f64>> {
        let (n, most) = (self.values, self.most());
        let mut chance = vec![0.0; 2 * most + 1];
        if n <= COUNTED_MOST {
            let mut dealt: Vec<usize> = (0..n).collect();
            let mut orders = 0.0;
            each_order(&mut dealt, 0, &mut |dealt| {
                let mut s = 0;
                for i in 0..n {
                    for j in 0..i {
                        s += self.inputs[dealt[i] * n + dealt[j]] * self.results[i * n + j];
                    }
                }
                chance[(s + most as i64) as usize] += 1.0;
                orders += 1.0;
            });
            chance.iter_mut().for_each(|chance| *chance /= orders);
            return Some(chance);
        }
        let has_ties = |all: &[i64]| all.iter().filter(|sign| **sign == 0).count() > n;
        if self.groups > 1 || has_ties(&self.inputs) || has_ties(&self.results) {
            return None;
        }
        // inversions of n results: one more result adds 0 to n − 1 of them, all equally likely
        let mut inversions = vec![1.0];
        for k in 2..=n {
            let mut next = vec![0.0; inversions.len() + k - 1];
            for (i, chance) in inversions.iter().enumerate() {
                for next in &mut next[i..i + k] {
                    *next += chance / k as f64;
                }
            }
            inversions = next;
        }
        for (d, of) in inversions.into_iter().enumerate() {
            chance[2 * (most - d)] = of;
        }
        Some(chance)
    }
}

/// Probability of each S of all units; `None` if there are too many to count.
fn chances(units: &[Unit], pairs: usize) -> Option<Vec<f64>> {
    if pairs > PAIRS_MOST {
        return None;
    }
    let mut all = vec![1.0];
    for unit in units {
        let own = unit.chance()?;
        let mut sum = vec![0.0; all.len() + own.len() - 1];
        for (i, a) in all.iter().enumerate() {
            for (sum, b) in sum[i..].iter_mut().zip(&own) {
                *sum += a * b;
            }
        }
        all = sum;
    }
    Some(all)
}

/// Visits every order of the remaining entries.
fn each_order(order: &mut Vec<usize>, placed: usize, visit: &mut dyn FnMut(&[usize])) {
    if placed + 1 >= order.len() {
        visit(order);
        return;
    }
    for i in placed..order.len() {
        order.swap(placed, i);
        each_order(order, placed + 1, visit);
        order.swap(placed, i);
    }
}

/// Probability of `s` or more, from probabilities for −most to most.
fn at_least(chance: &[f64], s: i64) -> f64 {
    let most = (chance.len() / 2) as i64;
    chance.iter().skip((s + most).max(0) as usize).sum()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// All assignments of the results are equally likely: the variance of S is the mean of S².
    fn by_all_permutations(points: &[(f64, f64)]) -> f64 {
        fn permute(rest: Vec<f64>, done: Vec<f64>, all: &mut Vec<Vec<f64>>) {
            if rest.is_empty() {
                all.push(done);
                return;
            }
            for i in 0..rest.len() {
                let (mut rest, mut done) = (rest.clone(), done.clone());
                done.push(rest.remove(i));
                permute(rest, done, all);
            }
        }
        let mut all = Vec::new();
        permute(points.iter().map(|p| p.1).collect(), Vec::new(), &mut all);
        let squares = all.iter().map(|results| {
            let dealt: Vec<(f64, f64)> = points.iter().zip(results).map(|(p, r)| (p.0, *r)).collect();
            let found = trend(&[vec![dealt]]).unwrap();
            (found.concordant as f64 - found.discordant as f64).powi(2)
        });
        squares.sum::<f64>() / all.len() as f64
    }

    #[test]
    fn exact_variance_of_chance_is_that_of_all_permutations() {
        let inf = f64::INFINITY;
        for points in [
            vec![(1.0, 2.0), (2.0, 4.0), (3.0, 1.0), (4.0, 3.0)],
            vec![(1.0, 2.0), (1.0, 4.0), (3.0, 1.0), (4.0, 4.0), (4.0, 2.0)],
            vec![
                (1.0, inf),
                (2.0, inf),
                (3.0, 1.0),
                (3.0, inf),
                (5.0, 2.0),
                (6.0, 2.0),
            ],
            vec![(1.0, 5.0), (2.0, 4.0)],
            vec![(1.0, 5.0), (1.0, 4.0), (1.0, 1.0)],
        ] {
            let exact = by_all_permutations(&points);
            let found = Unit::of(std::slice::from_ref(&points)).variance();
            assert!(
                (found - exact).abs() < 1e-12 * exact.max(1.0),
                "{points:?}: {found} {exact}"
            );
        }
    }

    #[test]
    fn exact_chances_of_few_points() {
        let way = |points: &[(f64, f64)]| {
            trend(&[
                vec![points.to_vec()],
                vec![points.to_vec()],
                vec![points.to_vec()],
            ])
            .unwrap()
        };
        // three groups of two, all rising: 1 of 8
        let found = way(&[(1.0, 1.0), (2.0, 2.0)]);
        assert!(
            (found.rises_by_chance - 0.125).abs() < 1e-15 && found.falls_by_chance == 1.0,
            "{found:?}"
        );
        assert!(!found.shows(Direction::Rising) && found.direction().is_none());
        // three groups of three, all falling: 1 of 6³
        let found = way(&[(1.0, 3.0), (2.0, 2.0), (3.0, 1.0)]);
        assert!((found.falls_by_chance - 1.0 / 216.0).abs() < 1e-15);
        assert_eq!(found.direction(), Some(Direction::Falling));
        // (1, ∞, ∞) twice: the 1 comes first by chance in 1 of 3
        let inf = f64::INFINITY;
        let group = vec![(1.0, 1.0), (2.0, inf), (3.0, inf)];
        let found = trend(&[vec![group.clone()], vec![group]]).unwrap();
        assert!((found.rises_by_chance - 1.0 / 9.0).abs() < 1e-15, "{found:?}");
        // eight points without ties: scipy 1.17.1, kendalltau([0..7], [3, 1, 4, 2, 8, 6, 5, 7], method="exact", alternative="greater")
        let points: Vec<(f64, f64)> = [3.0, 1.0, 4.0, 2.0, 8.0, 6.0, 5.0, 7.0]
            .into_iter()
            .enumerate()
            .map(|(i, y)| (i as f64, y))
            .collect();
        let found = trend(&[vec![points]]).unwrap();
        assert!(
            (found.rises_by_chance - 0.05434027777777778).abs() < 1e-12,
            "{found:?}"
        );
    }

    /// Groups of one unit are ordered together: copies of a group change neither τ nor its chance, and two of three units that agree are
    /// the sign test of three, whatever the number of groups in each.
    #[test]
    fn exact_groups_of_one_unit_are_no_further_units() {
        let group = [3.0, 1.0, 2.0, 4.0].map(|y| (y, 0.3 * y * y - y)).to_vec();
        let one = trend(&[vec![group.clone()]]).unwrap();
        let many = trend(&[vec![group; 10]]).unwrap();
        assert_eq!((many.pairs, many.units), (10 * one.pairs, 1));
        for of in [
            |of: &Trend| of.tau,
            |of: &Trend| of.tau_by_chance,
            |of: &Trend| of.rises_by_chance,
        ] {
            assert!((of(&many) - of(&one)).abs() < 1e-12, "{many:?} {one:?}");
        }
        let unit = |rises: bool| vec![vec![(10.0, 1.0), (11.0, if rises { 1.1 } else { 0.9 })]; 10];
        let found = trend(&[unit(true), unit(true), unit(false)]).unwrap();
        assert_eq!((found.pairs, found.units), (30, 3));
        assert!((found.tau - 1.0 / 3.0).abs() < 1e-15 && (found.rises_by_chance - 0.5).abs() < 1e-15);
        assert!(!found.shows(Direction::Rising));
    }

    /// Groups that are not alike, one with a gap: the variance is the mean of S² over all orders of the input.
    #[test]
    fn exact_variance_of_several_groups_is_that_of_all_orders() {
        let groups = vec![
            vec![(1.0, 2.0), (2.0, 4.0), (3.0, 1.0), (4.0, 3.0)],
            vec![(1.0, 2.0), (2.0, 2.0), (4.0, 5.0)],
            vec![(1.0, 7.0), (2.0, 1.0), (3.0, f64::INFINITY), (4.0, f64::INFINITY)],
        ];
        let mut order = vec![1.0, 2.0, 3.0, 4.0];
        let (mut squares, mut orders) = (0.0, 0.0);
        let mut dealt = vec![0, 1, 2, 3];
        each_order(&mut dealt, 0, &mut |dealt| {
            order = dealt.iter().map(|i| *i as f64 + 1.0).collect();
            let moved =
                |points: &Vec<(f64, f64)>| points.iter().map(|p| (order[p.0 as usize - 1], p.1)).collect();
            let found = trend(&[groups.iter().map(moved).collect()]).unwrap();
            squares += (found.concordant as f64 - found.discordant as f64).powi(2);
            orders += 1.0;
        });
        let found = Unit::of(&groups).variance();
        assert!(
            (found - squares / orders).abs() < 1e-12 * found,
            "{found} {}",
            squares / orders
        );
    }

    // scipy 1.15 kendalltau: the statistic (tau-b) of untied data equals tau; n = 8.
    #[test]
    fn agrees_with_counting_by_hand_and_refuses_nan() {
        let points: Vec<(f64, f64)> = [3, 1, 4, 2, 8, 6, 5, 7]
            .iter()
            .zip(1..)
            .map(|(y, x)| (f64::from(x), f64::from(*y)))
            .collect();
        let found = trend(&[vec![points]]).unwrap();
        assert_eq!((found.pairs, found.concordant, found.discordant), (28, 21, 7));
        assert_eq!(found.tau, 0.5);
        // 5.4 of 100: a normal approximation without continuity correction would find a trend
        assert!(!found.shows(Direction::Rising) && !found.shows(Direction::Falling));
        assert!(trend(&[vec![vec![(1.0, f64::NAN)]]]).is_err());
        assert_eq!(trend(&[]).unwrap().tau, 0.0);
    }
}
