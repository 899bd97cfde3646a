//! Trends of a result with an input, all else equal: rank correlation, with what chance alone would give.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | n | `points.len()` | points of one group, in which everything but the input is equal |
//! | S | `concordant − discordant` | pairs that rise together less pairs that do not, over all groups |
//! | τ | `tau` | S over the pairs whose inputs differ |
//! | t, u | | sizes of groups of equal inputs, and of equal results |

use super::AssessError;

/// How often one of two random values of a normal variable is further from 0 than this many standard deviations on one side:
/// 5 of 100.
const ONE_SIDED_5_PERCENT: f64 = 1.6448536269514722;

/// Which way a result goes as an input grows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Direction {
    /// It grows too.
    Rising,
    /// It falls.
    Falling,
}

/// A rank correlation over groups in which everything else is equal.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Trend {
    /// Pairs of points of one group whose inputs differ.
    pub pairs: usize,
    /// Pairs in which the larger input has the larger result.
    pub concordant: usize,
    /// Pairs in which it has the smaller one.
    pub discordant: usize,
    /// (concordant − discordant) / pairs, −1 to 1; 0 without pairs.
    pub tau: f64,
    /// Standard deviation that `tau` would have if the input had no effect, –.
    pub tau_by_chance: f64,
}

impl Trend {
    /// Whether a trend this way is seen beyond chance: a trend this strong this way would come of no effect at all in less than 5
    /// of 100 studies.
    pub fn shows(&self, direction: Direction) -> bool {
        let signed = match direction {
            Direction::Rising => self.tau,
            Direction::Falling => -self.tau,
        };
        self.tau_by_chance > 0.0 && signed > ONE_SIDED_5_PERCENT * self.tau_by_chance
    }
}

/// Kendall's rank correlation of a result with an input, counted within groups only: `groups` hold (input, result) where all other
/// inputs are equal. A result may be infinite: it is larger than all others, and equal to other infinite ones.
///
/// ```text
/// var S = (n(n−1)(2n+5) − Σ t(t−1)(2t+5) − Σ u(u−1)(2u+5))/18 + Σ t(t−1) Σ u(u−1)/(2n(n−1))
///         + Σ t(t−1)(t−2) Σ u(u−1)(u−2)/(9n(n−1)(n−2))                     summed over the groups
/// ```
///
/// # Errors
/// [`AssessError::Trend`] for a value that is not a number.
///
/// # Limits
/// Equal results count as pairs that show nothing: they bring `tau` nearer to 0. With less than 4 points in all no trend can show.
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
    Ok(Trend {
        pairs,
        concordant,
        discordant,
        tau,
        tau_by_chance,
    })
}

/// Variance of S of one group if results are dealt to inputs by chance.
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

/// How many values are equal, value by value.
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

    /// All ways to deal the results, each as likely: the variance of S is the mean of S².
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

    // scipy 1.15 kendalltau: statistic (tau-b) of untied data equals tau; n = 8
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
        assert!(found.shows(Direction::Rising) && !found.shows(Direction::Falling));
        assert!(trend(&[vec![(1.0, f64::NAN)]]).is_err());
        assert_eq!(trend(&[]).unwrap().tau, 0.0);
    }
}
