//! Trends of a result with one input, all other inputs equal: rank correlation, compared with chance.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | n | `points.len()` | points of one group, in which all other inputs are equal |
//! | S | `concordant − discordant` | concordant minus discordant pairs, over all groups |
//! | τ | `tau` | S over the pairs whose inputs differ |
//! | t, u | | sizes of groups of equal inputs, and of equal results |

use super::AssessError;
use crate::numeric::normal_probability;

/// Probability by chance below which a trend in an expected direction is significant, and a trend in either direction. Our choice.
const EXPECTED_BELOW: f64 = 0.05;
const EITHER_BELOW: f64 = 0.025;
/// Largest group without ties for which all orders of the results are enumerated; larger ones use Mahonian numbers.
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

/// Kendall's rank correlation of a result with an input, within groups only: `groups` hold (input, result) for which all other inputs
/// are equal. A result may be infinite: it is larger than all finite ones, and equal to other infinite ones.
///
/// ```text
/// var S = (n(n−1)(2n+5) − Σ t(t−1)(2t+5) − Σ u(u−1)(2u+5))/18 + Σ t(t−1) Σ u(u−1)/(2n(n−1))
///         + Σ t(t−1)(t−2) Σ u(u−1)(u−2)/(9n(n−1)(n−2))                     summed over the groups
/// ```
/// Probabilities are counted exactly over all orders of the results in each group, if the groups have up to 7 points or no ties.
/// Otherwise S is taken as normal, reduced by ½ for continuity.
///
/// # Errors
/// [`AssessError::Trend`] for a value that is not a number.
///
/// # Limits
/// Equal results count as pairs without information, which brings `tau` closer to 0. With fewer than 4 points no trend can be
/// significant. Each input is tested separately: of twenty inputs without effect, one seems significant.
///
/// # Source
/// Kendall, M. G. (1970) Rank Correlation Methods, 4th ed., sec. 4.4; groups after Korn, E. L. (1984) Biometrika 71(2):383, the
/// stratified statistic.
///
/// # Example
/// ```
/// use dolmen::assess::{Direction, trend};
/// let group = vec![(3.0, 2.5), (5.0, 1.4), (7.0, 0.9)];
/// let found = trend(&[group.clone(), group])?;
/// assert_eq!((found.pairs, found.tau), (6, -1.0));
/// assert!((found.tau_by_chance * 6.0 - (2.0 * 11.0 / 3.0_f64).sqrt()).abs() < 1e-12);
/// assert!(found.shows(Direction::Falling));
/// # Ok::<(), dolmen::assess::AssessError>(())
/// ```
pub fn trend(groups: &[Vec<(f64, f64)>]) -> Result<Trend, AssessError> {
    let (mut pairs, mut concordant, mut discordant, mut variance) = (0, 0, 0, 0.0);
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
        variance += variance_of_chance(points);
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
    let [rises_by_chance, falls_by_chance] = match chances(groups, pairs) {
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
        concordant,
        discordant,
        tau,
        tau_by_chance,
        rises_by_chance,
        falls_by_chance,
    })
}

/// Probability of each S from −pairs to pairs if results are assigned at random within each group; `None` if there are too many to
/// enumerate.
fn chances(groups: &[Vec<(f64, f64)>], pairs: usize) -> Option<Vec<f64>> {
    if pairs > PAIRS_MOST {
        return None;
    }
    let mut all = vec![1.0];
    for points in groups {
        let own = chance_of_group(points)?;
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

/// As [`chances`], for one group over its own pairs, including pairs with equal inputs.
fn chance_of_group(points: &[(f64, f64)]) -> Option<Vec<f64>> {
    let n = points.len();
    let pairs = n * n.saturating_sub(1) / 2;
    let mut chance = vec![0.0; 2 * pairs + 1];
    if n <= COUNTED_MOST {
        let results: Vec<f64> = points.iter().map(|p| p.1).collect();
        let mut dealt: Vec<usize> = (0..n).collect();
        let mut orders = 0.0;
        each_order(&mut dealt, 0, &mut |dealt| {
            let mut s = 0_i64;
            for i in 0..n {
                for j in 0..i {
                    let (x, y) = (points[i].0 - points[j].0, (results[dealt[i]], results[dealt[j]]));
                    let sign = |above: bool, below: bool| i64::from(above) - i64::from(below);
                    s += sign(x > 0.0, x < 0.0) * sign(y.0 > y.1, y.0 < y.1);
                }
            }
            chance[(s + pairs as i64) as usize] += 1.0;
            orders += 1.0;
        });
        chance.iter_mut().for_each(|chance| *chance /= orders);
        return Some(chance);
    }
    let has_ties = |values: Vec<f64>| ties(values.into_iter()).iter().any(|size| *size > 1.0);
    if has_ties(points.iter().map(|p| p.0).collect()) || has_ties(points.iter().map(|p| p.1).collect()) {
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
        chance[2 * (pairs - d)] = of;
    }
    Some(chance)
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

/// Variance of S of one group if results are assigned at random.
fn variance_of_chance(points: &[(f64, f64)]) -> f64 {
    let n = points.len() as f64;
    if points.len() < 2 {
        return 0.0;
    }
    let t = ties(points.iter().map(|p| p.0));
    let u = ties(points.iter().map(|p| p.1));
    let sum = |sizes: &[f64], of: fn(f64) -> f64| sizes.iter().map(|&s| of(s)).sum::<f64>();
    let [of_18, of_2, of_9] = [
        |s: f64| s * (s - 1.0) * (2.0 * s + 5.0),
        |s: f64| s * (s - 1.0),
        |s: f64| s * (s - 1.0) * (s - 2.0),
    ];
    let mut variance = (of_18(n) - sum(&t, of_18) - sum(&u, of_18)) / 18.0;
    variance += sum(&t, of_2) * sum(&u, of_2) / (2.0 * of_2(n));
    if points.len() > 2 {
        variance += sum(&t, of_9) * sum(&u, of_9) / (9.0 * of_9(n));
    }
    variance.max(0.0)
}

/// Number of equal values, for each value.
fn ties(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values
        .chunk_by(|a, b| a == b)
        .map(|equal| equal.len() as f64)
        .collect()
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
            let found = trend(&[dealt]).unwrap();
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
            let found = variance_of_chance(&points);
            assert!(
                (found - exact).abs() < 1e-12 * exact.max(1.0),
                "{points:?}: {found} {exact}"
            );
        }
    }

    #[test]
    fn exact_chances_of_few_points() {
        let way =
            |points: &[(f64, f64)]| trend(&[points.to_vec(), points.to_vec(), points.to_vec()]).unwrap();
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
        let found = trend(&[group.clone(), group]).unwrap();
        assert!((found.rises_by_chance - 1.0 / 9.0).abs() < 1e-15, "{found:?}");
        // eight points without ties: scipy 1.17.1, kendalltau([0..7], [3, 1, 4, 2, 8, 6, 5, 7], method="exact", alternative="greater")
        let points: Vec<(f64, f64)> = [3.0, 1.0, 4.0, 2.0, 8.0, 6.0, 5.0, 7.0]
            .into_iter()
            .enumerate()
            .map(|(i, y)| (i as f64, y))
            .collect();
        let found = trend(&[points]).unwrap();
        assert!(
            (found.rises_by_chance - 0.05434027777777778).abs() < 1e-12,
            "{found:?}"
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
        let found = trend(&[points]).unwrap();
        assert_eq!((found.pairs, found.concordant, found.discordant), (28, 21, 7));
        assert_eq!(found.tau, 0.5);
        // 5.4 of 100: a normal approximation without continuity correction would find a trend
        assert!(!found.shows(Direction::Rising) && !found.shows(Direction::Falling));
        assert!(trend(&[vec![(1.0, f64::NAN)]]).is_err());
        assert_eq!(trend(&[]).unwrap().tau, 0.0);
    }
}
