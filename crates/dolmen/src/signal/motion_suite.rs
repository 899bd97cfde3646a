//! Chooses a suite of ground motions and their factors so that the mean spectrum follows a demand.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r_i(T) | `ratios` | spectrum of record i over the demand |
//! | k_i | `own` | factor that scales record i to the demand, by the mean of the logarithm |
//! | m(T) | `mean` | mean of k_i r_i(T) over the suite |
//! | c | `common` | common factor on the suite |

use super::SignalError;

/// Rules for the choice of a suite.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SuiteRule {
    /// Number of motions in the suite, 1 or more. Default 7.
    pub count: usize,
    /// Smallest and largest factor of a record. Default 0.25 and 4, our choice.
    pub factors: [f64; 2],
    /// Smallest allowed ratio of mean spectrum to demand at any period. Default 0.9, our choice.
    pub least_share: f64,
    /// Largest number of motions from one earthquake, and from one station, if the files name them. Default 2, our choice.
    pub alike_most: usize,
}

impl Default for SuiteRule {
    fn default() -> Self {
        SuiteRule {
            count: 7,
            factors: [0.25, 4.0],
            least_share: 0.9,
            alike_most: 2,
        }
    }
}

/// A record that can be chosen.
#[derive(Clone, Debug, PartialEq)]
pub struct SuiteCandidate {
    /// Its spectrum over the demand at each period, all positive. Shape: periods.
    pub ratios: Vec<f64>,
    /// The earthquake, if known.
    pub event: Option<String>,
    /// The station, if known.
    pub station: Option<String>,
    /// The file, or the record to which two directions belong. Only one candidate with the same key may be chosen.
    pub record: String,
}

/// A chosen suite.
#[derive(Clone, Debug, PartialEq)]
pub struct MotionSuite {
    /// Indices of the chosen candidates, ascending.
    pub members: Vec<usize>,
    /// Factor of each chosen candidate.
    pub factors: Vec<f64>,
    /// Mean of the scaled spectra over the demand. Shape: periods.
    pub mean: Vec<f64>,
    /// Root mean square of `mean` − 1.
    pub misfit: f64,
}

/// Largest number of passes over all possible exchanges in a search.
const PASSES_MOST: usize = 100;
/// Number of records from which a search starts. Our choice.
const BEGINNINGS_MOST: usize = 40;
/// A smaller gain does not count as an improvement.
const GAIN_LEAST: f64 = 1e-12;

/// Chooses the records and factors whose mean spectrum follows the demand best.
///
/// ```text
/// k_i = exp(−mean over T of ln r_i)        m(T) = mean over the suite of k_i r_i(T)
/// c = max(1/mean over T of m, least share/min over T of m)        factor of record i: c k_i, within its limits
/// wanted: the suite with the least root mean square of c m(T) − 1
/// ```
/// Each record keeps the shape of its spectrum; its own factor scales the spectrum to the demand. The common factor then makes the mean over the
/// periods equal to the demand, or larger if a period would fall below the least share. The search exchanges one record for another as long as this
/// improves the suite, and starts from many records. The result is a good suite, but not proved to be the best. The method is our own.
///
/// # Errors
/// [`SignalError::SuiteFactors`] and [`SignalError::SuiteAlike`] if no suite keeps within the limits; [`SignalError::Argument`] for a rule out of
/// range or ratios that are not positive.
///
/// # Limits
/// In 400 sets of eight simulated records, the search always finds the best of all 56 suites of three: see the tests.
///
/// # Example
/// ```
/// use dolmen::signal::{SuiteCandidate, SuiteRule, motion_suite};
/// let of = |ratios: [f64; 2], record: &str| SuiteCandidate {
///     ratios: ratios.to_vec(), event: None, station: None, record: record.to_owned(),
/// };
/// let pool = [of([2.0, 0.5], "a"), of([0.5, 2.0], "b"), of([3.0, 0.3], "c")];
/// let suite = motion_suite(&pool, &SuiteRule { count: 2, ..SuiteRule::default() })?;
/// assert_eq!(suite.members, [0, 1]); // each other's complement
/// assert!(suite.misfit < 1e-12 && (suite.factors[0] - 0.8).abs() < 1e-12);
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn motion_suite(candidates: &[SuiteCandidate], rule: &SuiteRule) -> Result<MotionSuite, SignalError> {
    let pool = Pool::new(candidates, rule)?;
    let mut beginnings: Vec<usize> = (0..candidates.len()).collect();
    beginnings.sort_by(|a, b| pool.alone(*a).total_cmp(&pool.alone(*b)));
    let mut best: Option<(SuiteMisfit, Vec<usize>)> = None;
    let mut longest = 0;
    for &first in beginnings.iter().take(BEGINNINGS_MOST) {
        let grown = pool.grown(first);
        longest = longest.max(grown.len());
        if grown.len() < rule.count {
            continue;
        }
        let (worth, members) = pool.exchanged(grown);
        let is_better = best
            .as_ref()
            .is_none_or(|(before, _)| worth.is_better_than(before));
        if is_better {
            best = Some((worth, members));
        }
    }
    match best {
        Some((worth, mut members)) if worth.beyond == 0.0 => {
            members.sort_unstable();
            Ok(pool.suite(members))
        }
        Some(_) => Err(SignalError::SuiteFactors {
            wanted: rule.count,
            usable: candidates.len(),
            least: rule.factors[0],
            most: rule.factors[1],
        }),
        None => Err(SignalError::SuiteAlike {
            wanted: rule.count,
            usable: candidates.len(),
            most: longest,
        }),
    }
}

/// Cost of a suite: first the excess of its factors over their limits, then its misfit.
#[derive(Clone, Copy, Debug, PartialEq)]
struct SuiteMisfit {
    beyond: f64,
    misfit: f64,
}

impl SuiteMisfit {
    fn is_better_than(&self, other: &SuiteMisfit) -> bool {
        match self.beyond == other.beyond {
            true => self.misfit < other.misfit - GAIN_LEAST,
            false => self.beyond < other.beyond,
        }
    }
}

struct Pool<'a> {
    candidates: &'a [SuiteCandidate],
    rule: &'a SuiteRule,
    own: Vec<f64>,
    /// k_i r_i(T) of each record.
    scaled: Vec<Vec<f64>>,
}

impl<'a> Pool<'a> {
    fn new(candidates: &'a [SuiteCandidate], rule: &'a SuiteRule) -> Result<Self, SignalError> {
        let [least, most] = rule.factors;
        let argument = |argument, given, allowed| SignalError::Argument {
            argument,
            given,
            allowed,
        };
        if rule.count == 0 {
            return Err(argument("count", 0.0, "at least 1"));
        }
        if !(least > 0.0 && least <= most && most.is_finite()) {
            return Err(argument("factors", least, "ascending"));
        }
        if !(rule.least_share > 0.0 && rule.least_share <= 1.0) {
            return Err(argument("least_share", rule.least_share, "above 0 and at most 1"));
        }
        let periods = candidates.first().map_or(0, |one| one.ratios.len());
        for candidate in candidates {
            let wrong = candidate
                .ratios
                .iter()
                .find(|ratio| !(**ratio > 0.0 && ratio.is_finite()));
            if let Some(&given) = wrong {
                return Err(argument("ratios", given, "positive"));
            }
            if candidate.ratios.len() != periods || periods == 0 {
                let given = candidate.ratios.len() as f64;
                return Err(argument("ratios", given, "a positive number at every period"));
            }
        }
        let own: Vec<f64> = candidates
            .iter()
            .map(|one| (-mean(one.ratios.iter().map(|ratio| ratio.ln()))).exp())
            .collect();
        let scaled = candidates.iter().zip(&own);
        let scaled = scaled.map(|(one, k)| one.ratios.iter().map(|ratio| ratio * k).collect());
        Ok(Pool {
            candidates,
            rule,
            scaled: scaled.collect(),
            own,
        })
    }

    fn alone(&self, at: usize) -> f64 {
        mean(self.scaled[at].iter().map(|ratio| ratio.ln().powi(2)))
    }

    /// Whether a record may join the given members.
    fn joins(&self, members: &[usize], at: usize) -> bool {
        let joining = &self.candidates[at];
        let count = |is_alike: &dyn Fn(&SuiteCandidate) -> bool| {
            members
                .iter()
                .filter(|member| is_alike(&self.candidates[**member]))
                .count()
        };
        let most = self.rule.alike_most;
        !members.contains(&at)
            && count(&|other| other.record == joining.record) == 0
            && (joining.event.is_none() || count(&|other| other.event == joining.event) < most)
            && (joining.station.is_none() || count(&|other| other.station == joining.station) < most)
    }

    /// Mean of the records with their own factors, and the common factor.
    fn mean_and_common(&self, members: &[usize]) -> (Vec<f64>, f64) {
        let periods = self.scaled[members[0]].len();
        let at = |period: usize| mean(members.iter().map(|member| self.scaled[*member][period]));
        let means: Vec<f64> = (0..periods).map(at).collect();
        let lowest = means.iter().copied().fold(f64::INFINITY, f64::min);
        let common = (1.0 / mean(means.iter().copied())).max(self.rule.least_share / lowest);
        (means, common)
    }

    fn worth(&self, members: &[usize]) -> SuiteMisfit {
        let (means, common) = self.mean_and_common(members);
        let [least, most] = self.rule.factors;
        let beyond = members.iter().map(|member| {
            let factor = common * self.own[*member];
            // rounding must not exclude a factor at its limit
            let over = (factor / most).max(least / factor);
            if over > 1.0 + 1e-9 { over.ln() } else { 0.0 }
        });
        SuiteMisfit {
            beyond: beyond.sum(),
            misfit: mean(means.iter().map(|m| (common * m - 1.0).powi(2))).sqrt(),
        }
    }

    /// The record that improves the suite most, if the new suite is better than `before`.
    fn best_joining(
        &self,
        members: &mut Vec<usize>,
        not: Option<usize>,
        before: Option<SuiteMisfit>,
    ) -> Option<(SuiteMisfit, usize)> {
        let (mut best, mut best_worth) = (None, before);
        for at in 0..self.candidates.len() {
            if Some(at) == not || !self.joins(members, at) {
                continue;
            }
            members.push(at);
            let worth = self.worth(members);
            members.pop();
            if best_worth.is_none_or(|before| worth.is_better_than(&before)) {
                (best, best_worth) = (Some((worth, at)), Some(worth));
            }
        }
        best
    }

    /// A suite that starts with one record and adds the best record each time; it stays shorter than wanted if no record may join.
    fn grown(&self, first: usize) -> Vec<usize> {
        let mut members = vec![first];
        while members.len() < self.rule.count {
            let best = self.best_joining(&mut members, None, None);
            match best {
                Some((_, at)) => members.push(at),
                None => break,
            }
        }
        members
    }

    /// Exchanges records one by one, the best exchange first, until no exchange improves the suite.
    fn exchanged(&self, mut members: Vec<usize>) -> (SuiteMisfit, Vec<usize>) {
        let mut worth = self.worth(&members);
        for _ in 0..PASSES_MOST {
            let mut best: Option<(SuiteMisfit, usize, usize)> = None;
            for place in 0..members.len() {
                let leaving = members.swap_remove(place);
                let before = best.map_or(worth, |(before, ..)| before);
                if let Some((new, at)) = self.best_joining(&mut members, Some(leaving), Some(before)) {
                    best = Some((new, leaving, at));
                }
                members.push(leaving);
                let last = members.len() - 1;
                members.swap(place, last);
            }
            let Some((new, leaving, at)) = best else { break };
            for member in &mut members {
                if *member == leaving {
                    *member = at;
                }
            }
            worth = new;
        }
        (worth, members)
    }

    fn suite(&self, members: Vec<usize>) -> MotionSuite {
        let (means, common) = self.mean_and_common(&members);
        MotionSuite {
            factors: members.iter().map(|member| common * self.own[*member]).collect(),
            misfit: self.worth(&members).misfit,
            mean: means.iter().map(|m| common * m).collect(),
            members,
        }
    }
}

fn mean(values: impl ExactSizeIterator<Item = f64>) -> f64 {
    let count = values.len() as f64;
    values.sum::<f64>() / count
}

#[cfg(test)]
mod tests {
    use super::*;

    struct Draw(u64);

    impl Draw {
        fn next(&mut self) -> f64 {
            self.0 = self
                .0
                .wrapping_mul(6364136223846793005)
                .wrapping_add(1442695040888963407);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }
    }

    fn pool(draw: &mut Draw, count: usize) -> Vec<SuiteCandidate> {
        let one = |draw: &mut Draw, number: usize| {
            let (size, slope, wave, phase) = (
                4.0 * draw.next() - 2.0,
                2.0 * draw.next() - 1.0,
                draw.next(),
                6.3 * draw.next(),
            );
            let ratio = |k: usize| {
                let x = k as f64 / 11.0 - 0.5;
                (size + 2.0 * slope * x + wave * (9.0 * x + phase).sin()).exp()
            };
            SuiteCandidate {
                ratios: (0..12).map(ratio).collect(),
                event: Some(format!("event {}", number / 3)),
                station: None,
                record: number.to_string(),
            }
        };
        (0..count).map(|number| one(draw, number)).collect()
    }

    /// The smallest misfit over all suites of three, computed independently from sums instead of means.
    fn best_of_all(pool: &[SuiteCandidate], rule: &SuiteRule) -> Option<([usize; 3], f64)> {
        let own: Vec<f64> = pool
            .iter()
            .map(|one| {
                one.ratios
                    .iter()
                    .product::<f64>()
                    .powf(-1.0 / one.ratios.len() as f64)
            })
            .collect();
        let mut best: Option<([usize; 3], f64)> = None;
        for a in 0..pool.len() {
            for b in a + 1..pool.len() {
                for c in b + 1..pool.len() {
                    if pool[a].event == pool[b].event && pool[b].event == pool[c].event {
                        continue;
                    }
                    let sums: Vec<f64> = (0..12)
                        .map(|k| {
                            [a, b, c]
                                .iter()
                                .map(|i| own[*i] * pool[*i].ratios[k])
                                .sum::<f64>()
                        })
                        .collect();
                    let least = sums.iter().copied().fold(f64::MAX, f64::min);
                    let common = f64::max(36.0 / sums.iter().sum::<f64>(), 3.0 * rule.least_share / least);
                    let fits = [a, b, c]
                        .iter()
                        .all(|i| (rule.factors[0]..=rule.factors[1]).contains(&(common * own[*i])));
                    let square = sums
                        .iter()
                        .map(|sum| (common * sum / 3.0 - 1.0).powi(2))
                        .sum::<f64>();
                    let misfit = (square / 12.0).sqrt();
                    if fits && best.is_none_or(|(_, before)| misfit < before) {
                        best = Some(([a, b, c], misfit));
                    }
                }
            }
        }
        best
    }

    #[test]
    fn agrees_with_all_suites_of_three_of_eight() {
        let rule = SuiteRule {
            count: 3,
            ..SuiteRule::default()
        };
        let mut draw = Draw(7);
        let (mut found, mut refused) = (0, 0);
        for _ in 0..400 {
            let pool = pool(&mut draw, 8);
            match (best_of_all(&pool, &rule), motion_suite(&pool, &rule)) {
                (Some((members, misfit)), Ok(suite)) => {
                    assert_eq!(suite.members, members);
                    assert!((suite.misfit - misfit).abs() < 1e-12);
                    let lowest = suite.mean.iter().copied().fold(f64::MAX, f64::min);
                    assert!(lowest > 0.9 - 1e-12);
                    found += 1;
                }
                (None, Err(SignalError::SuiteFactors { .. })) => refused += 1,
                (all, searched) => panic!("{all:?} {searched:?}"),
            }
        }
        assert!(found > 300 && refused > 5, "{found} {refused}");
    }

    #[test]
    fn refuses_more_than_there_are_and_more_of_one_earthquake() {
        let mut pool = pool(&mut Draw(3), 6);
        for one in &mut pool {
            one.ratios.fill(1.0);
        }
        let rule = |count| SuiteRule {
            count,
            ..SuiteRule::default()
        };
        assert_eq!(motion_suite(&pool, &rule(4)).unwrap().members.len(), 4);
        let refused = motion_suite(&pool, &rule(5)).unwrap_err();
        let said = "no suite of 5 motions can be had of 6 records: the limits on one earthquake, station and record leave 4";
        assert!(refused.to_string().starts_with(said), "{refused}");
        for one in &mut pool {
            one.ratios.fill(10.0);
        }
        let refused = motion_suite(&pool, &rule(4)).unwrap_err().to_string();
        assert!(
            refused.contains("a factor of every one lies beyond 0.25 to 4"),
            "{refused}"
        );
        pool[2].ratios[1] = f64::NAN;
        assert!(matches!(
            motion_suite(&pool, &rule(4)),
            Err(SignalError::Argument { .. })
        ));
    }
}
