//! Tests the change of one number between two surveys: its size, its probability by chance, and the smallest change that
//! would be detected.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | t | `statistic` | difference over its standard deviation |
//! | ν | `degrees_of_freedom` | degrees of freedom of the standard deviation of the difference |
//! | p, p_H | `p`, `p_holm` | probability of such a difference by chance, alone and among all tests |

use crate::assess::AssessError;
use crate::numeric::{student_detectable, student_two_sided, student_two_sided_quantile};

/// Result of the test of one difference.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Evidence {
    /// Standard deviation of the relative difference.
    pub sd: f64,
    /// Half width of the 95 % interval of the relative difference.
    pub half_width_95: f64,
    /// Its degrees of freedom (Welch and Satterthwaite); infinite if both standard deviations are known exactly.
    pub degrees_of_freedom: f64,
    /// Difference over its standard deviation, t.
    pub statistic: f64,
    /// Two-sided probability of such a difference, or a larger one, if nothing changed.
    pub p: f64,
    /// `p`, adjusted for all differences that are tested together (Holm): the probability that chance alone gives at least
    /// one such difference.
    pub p_holm: f64,
    /// Whether `p_holm` is at most the required significance.
    pub significant: bool,
    /// Smallest relative change, up or down, that the test would find significant with the required power, for any values of
    /// the other differences.
    pub detectable: f64,
}

/// The difference of a number between two surveys.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Difference {
    /// (after - expected) / before, without the effect of temperature.
    pub relative: f64,
    /// Result of the test; `None` if a standard deviation is unknown.
    pub evidence: Option<Evidence>,
}

/// A difference with its variance, before it is tested together with others.
#[derive(Clone, Copy, Debug)]
pub(super) struct Raw {
    pub(super) relative: f64,
    /// Standard deviation of `relative`, and its degrees of freedom; `None` if not known.
    pub(super) spread: Option<(f64, f64)>,
}

/// Tests several differences together.
///
/// ```text
/// p = P(|t_ν| ≥ |r|/sd);   in ascending order p_H(k) = max_{j ≤ k} min(1, (m - j + 1) p(j)),  m tests
/// detectable = δ sd,  P(|T_ν(δ)| > t_{α/m, ν}) = power, T noncentral    found by Holm's procedure whatever the other tests give
/// ```
///
/// # Source
/// Holm (1979) Scand. J. Stat. 6:65-70.
pub(super) fn tested(all: &[Raw], significance: f64, power: f64) -> Result<Vec<Difference>, AssessError> {
    let tests = all.iter().filter(|raw| testable(raw)).count();
    let mut found: Vec<Difference> = Vec::with_capacity(all.len());
    for raw in all {
        let evidence = match raw.spread.filter(|_| testable(raw)) {
            None => None,
            Some((sd, degrees_of_freedom)) => {
                let statistic = raw.relative / sd;
                Some(Evidence {
                    sd,
                    half_width_95: sd * student_two_sided_quantile(0.05, degrees_of_freedom)?,
                    degrees_of_freedom,
                    statistic,
                    p: student_two_sided(statistic, degrees_of_freedom)?,
                    p_holm: 1.0,
                    significant: false,
                    detectable: sd
                        * student_detectable(
                            significance / tests as f64,
                            power,
                            degrees_of_freedom.max(1.0),
                        )?,
                })
            }
        };
        found.push(Difference {
            relative: raw.relative,
            evidence,
        });
    }
    let mut ordered: Vec<&mut Evidence> = found.iter_mut().filter_map(|d| d.evidence.as_mut()).collect();
    ordered.sort_by(|a, b| a.p.total_cmp(&b.p));
    let mut largest = 0.0_f64;
    for (before, evidence) in ordered.into_iter().enumerate() {
        largest = largest.max(((tests - before) as f64 * evidence.p).min(1.0));
        evidence.p_holm = largest;
        evidence.significant = largest <= significance;
    }
    Ok(found)
}

fn testable(raw: &Raw) -> bool {
    raw.spread.is_some_and(|(sd, _)| sd > 0.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::welch;

    fn raw(relative: f64, sd: f64, nu: f64) -> Raw {
        Raw {
            relative,
            spread: Some((sd, nu)),
        }
    }

    #[test]
    fn exact_holm_by_hand() {
        // p of 1.96, 2.5758, 3.2905, 0.6745 deviations: .05, .01, .001, .5
        let all = [
            1.959963984540054,
            2.575829303548901,
            3.290526731491926,
            0.674489750196082,
        ]
        .map(|z| raw(0.01 * z, 0.01, f64::INFINITY));
        let found = tested(&all, 0.05, 0.8).unwrap();
        let p: Vec<f64> = found
            .iter()
            .map(|d| d.evidence.as_ref().unwrap().p_holm)
            .collect();
        for (p, exact) in p.iter().zip([0.1, 0.03, 0.004, 0.5]) {
            assert!((p - exact).abs() < 1e-12, "{p} {exact}");
        }
        let significant: Vec<bool> = found
            .iter()
            .map(|d| d.evidence.as_ref().unwrap().significant)
            .collect();
        assert_eq!(significant, [false, true, true, false]);
        // smallest detectable change: (z of .05/4 two-sided + z of .8) deviations
        let least = found[0].evidence.as_ref().unwrap().detectable;
        assert!(
            (least / 0.01 - (2.497705474412373 + 0.841621233572914)).abs() < 1e-9,
            "{least}"
        );
    }

    #[test]
    fn holds_a_larger_p_never_gets_a_smaller_corrected_one() {
        let found = tested(&[raw(2.0, 1.0, 9.0), raw(2.1, 1.0, 9.0)], 0.05, 0.8).unwrap();
        let [a, b] = [0, 1].map(|i| found[i].evidence.as_ref().unwrap().p_holm);
        assert!(
            a >= b && b == 2.0 * found[1].evidence.as_ref().unwrap().p,
            "{a} {b}"
        );
    }

    #[test]
    fn exact_welch_of_two_equal_samples_adds_their_degrees() {
        assert_eq!(welch(&[(2.0, 29.0), (2.0, 29.0)]), (4.0, 58.0));
        assert_eq!(
            welch(&[(2.0, f64::INFINITY), (1.0, f64::INFINITY)]).1,
            f64::INFINITY
        );
    }

    #[test]
    fn holds_what_has_no_deviation_is_not_tested_and_costs_the_others_nothing() {
        let bare = Raw {
            relative: 0.5,
            spread: None,
        };
        let found = tested(&[bare, raw(0.02, 0.01, f64::INFINITY)], 0.05, 0.8).unwrap();
        assert!(found[0].evidence.is_none());
        let evidence = found[1].evidence.as_ref().unwrap();
        assert_eq!(evidence.p, evidence.p_holm);
    }
}
