//! Finds the part of a structure whose stiffness change explains the changes of the frequencies.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | r, σ | `relative`, `sd` | measured relative change of a frequency, and its standard deviation |
//! | ρ(s) | `changes_of` | relative change in the model, if the part has s times its stiffness |
//! | χ² | `chi_squared` | Σ ((r − ρ(s))/σ)² at the best s |

use crate::numeric::{chi_squared_above, chi_squared_quantile, maximum_between};

/// Range of the search for the stiffness of a part, relative to its earlier value. Our choice.
pub const FACTOR_SOUGHT: [f64; 2] = [0.02, 5.0];
/// Number of factors on the grid before the refinement.
const TRIED: usize = 33;
/// Bisections between the best factor and the end of an interval: to 1e-5 of their distance.
const BISECTIONS: usize = 20;
/// Smallest p-value at which a part explains the changes.
const EXPLAINS_FROM: f64 = 0.01;
/// Confidence of the intervals, and of the comparison between two parts.
const CONFIDENCE: f64 = 0.95;

/// Measured change of one frequency.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FrequencyChange {
    /// Later frequency over earlier frequency, minus 1.
    pub relative: f64,
    /// Standard deviation of the change.
    pub sd: f64,
}

/// Fit of one part to all changes.
#[derive(Clone, Debug, PartialEq)]
pub struct PartFit {
    /// Index of the part; `None` if all parts change together.
    pub part: Option<usize>,
    /// Later stiffness over earlier stiffness.
    pub factor: f64,
    /// 95 % interval of the factor, within 0.02 to 5.
    pub factor_interval: [f64; 2],
    /// Weighted sum of squared residuals.
    pub chi_squared: f64,
    /// Probability of a sum at least as large by chance.
    pub p_value: f64,
}

impl PartFit {
    /// Whether the residuals can be due to chance.
    pub fn explains(&self) -> bool {
        self.p_value >= EXPLAINS_FROM
    }
}

/// Fits of all parts to the measured changes.
#[derive(Clone, Debug, PartialEq)]
pub struct WhichPart {
    /// Fit of each part, the best first.
    pub parts: Vec<PartFit>,
    /// Fit with all parts changed together.
    pub alike: PartFit,
    /// Sum of squares for no change.
    pub unchanged: f64,
}

impl WhichPart {
    /// The parts that explain the changes as well as the best part, at 95 %; empty if the best part does not explain them.
    pub fn candidates(&self) -> &[PartFit] {
        let Some(best) = self.parts.first().filter(|best| best.explains()) else {
            return &[];
        };
        let within = self
            .parts
            .iter()
            .take_while(|of| of.chi_squared <= best.chi_squared + apart());
        &self.parts[..within.count()]
    }

    /// Whether a uniform change explains the measurements as well as the best part does.
    pub fn is_alike_possible(&self) -> bool {
        let best = self.parts.first().map_or(f64::INFINITY, |of| of.chi_squared);
        self.alike.explains() && self.alike.chi_squared <= best + apart()
    }
}

/// Difference of two sums of squares that is significant at 95 % with one free parameter.
fn apart() -> f64 {
    chi_squared_quantile(CONFIDENCE, 1.0).unwrap_or(3.841_458_820_694_124)
}

/// Finds the part of `parts` that explains the changed frequencies of a structure. It assumes that the stiffness of one part changed and no mass did.
///
/// `changes_of` gives the relative changes of the same frequencies if one part, or all parts together, has this multiple of its stiffness; `None` if
/// the structure cannot have it. The result is `None` for fewer than two frequencies or parts, or for an invalid standard deviation.
///
/// # Limits
/// The result is the **one** part that explains the changes, if the model is right. Two parts that changed together, a lost mass or the weather can
/// look like a third part, or like none. The standard deviations are assumed to be exact and independent.
///
/// # Example
/// ```
/// use dolmen::assess::{FrequencyChange, which_part};
/// // f² = Σ w k: the first frequency depends on both parts, the second only on the second part
/// let weights = [[0.5, 0.5], [0.0, 1.0]];
/// let model = |part: Option<usize>, factor: f64| {
///     let of = |w: [f64; 2]| {
///         let k = [0, 1].map(|at| if part.is_none_or(|of| of == at) { factor } else { 1.0 });
///         (w[0] * k[0] + w[1] * k[1]).sqrt() - 1.0
///     };
///     Some(weights.map(of).to_vec())
/// };
/// let measured = [f64::sqrt(0.9) - 1.0, 0.0].map(|relative| FrequencyChange { relative, sd: 0.002 });
/// let found = which_part(&measured, 2, model).unwrap();
/// let candidates = found.candidates();
/// assert_eq!((candidates.len(), candidates[0].part), (1, Some(0)));
/// assert!((candidates[0].factor - 0.8).abs() < 1e-6);
/// ```
pub fn which_part(
    changes: &[FrequencyChange],
    parts: usize,
    changes_of: impl Fn(Option<usize>, f64) -> Option<Vec<f64>>,
) -> Option<WhichPart> {
    let are_known = changes
        .iter()
        .all(|of| of.sd > 0.0 && of.sd.is_finite() && of.relative.is_finite());
    if changes.len() < 2 || parts < 2 || !are_known {
        return None;
    }
    let left = |model: &[f64]| -> f64 {
        let pairs = changes.iter().zip(model);
        pairs
            .map(|(of, model)| ((of.relative - model) / of.sd).powi(2))
            .sum()
    };
    let fit = |part: Option<usize>| -> Option<PartFit> {
        let of = |factor: f64| changes_of(part, factor).map_or(f64::INFINITY, |model| left(&model));
        fitted(part, changes.len(), &of)
    };
    let mut all: Vec<PartFit> = (0..parts).filter_map(|part| fit(Some(part))).collect();
    all.sort_by(|a, b| a.chi_squared.total_cmp(&b.chi_squared));
    (!all.is_empty()).then_some(())?;
    Some(WhichPart {
        parts: all,
        alike: fit(None)?,
        unchanged: left(&vec![0.0; changes.len()]),
    })
}

fn fitted(part: Option<usize>, frequencies: usize, left: &impl Fn(f64) -> f64) -> Option<PartFit> {
    let [low, high] = FACTOR_SOUGHT;
    let ratio = (high / low).powf(1.0 / (TRIED - 1) as f64);
    let tried: Vec<[f64; 2]> = (0..TRIED)
        .map(|at| low * ratio.powi(at as i32))
        .map(|factor| [factor, left(factor)])
        .collect();
    let [near, of_near] = tried.into_iter().min_by(|a, b| a[1].total_cmp(&b[1]))?;
    if !of_near.is_finite() {
        return None;
    }
    let refined = maximum_between(
        &|factor| -left(factor),
        (near / ratio).max(low),
        (near * ratio).min(high),
    );
    let of_refined = left(refined);
    let (factor, chi_squared) = match of_refined <= of_near {
        true => (refined, of_refined),
        false => (near, of_near),
    };
    let bound = |end: f64| {
        let is_within = |factor: f64| left(factor) <= chi_squared + apart();
        if is_within(end) {
            return end;
        }
        let (mut inside, mut outside) = (factor, end);
        for _ in 0..BISECTIONS {
            let middle = (inside * outside).sqrt();
            if is_within(middle) {
                inside = middle;
            } else {
                outside = middle;
            }
        }
        inside
    };
    Some(PartFit {
        part,
        factor,
        factor_interval: [bound(low), bound(high)],
        chi_squared,
        p_value: chi_squared_above(chi_squared, (frequencies - 1) as f64).ok()?,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    /// Relative frequency changes of a shear frame with three storeys of equal mass, by Jacobi's eigenvalue method.
    fn frame(k: [f64; 3]) -> Vec<f64> {
        let mut a = [
            [k[0] + k[1], -k[1], 0.0],
            [-k[1], k[1] + k[2], -k[2]],
            [0.0, -k[2], k[2]],
        ];
        for _ in 0..50 {
            for (p, q) in [(0, 1), (0, 2), (1, 2)] {
                let angle = 0.5 * f64::atan2(2.0 * a[p][q], a[q][q] - a[p][p]);
                let (s, c) = angle.sin_cos();
                for row in &mut a {
                    (row[p], row[q]) = (c * row[p] - s * row[q], s * row[p] + c * row[q]);
                }
                let (first, second) = (a[p], a[q]);
                for i in 0..3 {
                    a[p][i] = c * first[i] - s * second[i];
                    a[q][i] = s * first[i] + c * second[i];
                }
            }
        }
        let mut all: Vec<f64> = (0..3).map(|i| a[i][i].sqrt()).collect();
        all.sort_by(f64::total_cmp);
        all
    }

    const GIVEN: [f64; 3] = [3.0, 2.0, 1.5];

    fn changes_of(part: Option<usize>, factor: f64) -> Option<Vec<f64>> {
        let mut k = GIVEN;
        for (at, k) in k.iter_mut().enumerate() {
            *k *= if part.is_none_or(|of| of == at) {
                factor
            } else {
                1.0
            };
        }
        let pairs = frame(k).into_iter().zip(frame(GIVEN));
        Some(pairs.map(|(after, before)| after / before - 1.0).collect())
    }

    fn drawn(part: Option<usize>, factor: f64, sd: f64, random: &mut Random) -> Vec<FrequencyChange> {
        let model = changes_of(part, factor).unwrap().into_iter();
        model
            .map(|of| FrequencyChange {
                relative: of + sd * random.normal(),
                sd,
            })
            .collect()
    }

    #[test]
    fn exact_the_storey_that_loosened_and_by_how_much() {
        for (part, factor) in [(0, 0.7), (1, 0.85), (2, 0.6), (1, 1.3)] {
            let exact: Vec<FrequencyChange> = changes_of(Some(part), factor)
                .unwrap()
                .into_iter()
                .map(|relative| FrequencyChange { relative, sd: 0.002 })
                .collect();
            let found = which_part(&exact, 3, changes_of).unwrap();
            let best = &found.candidates()[0];
            assert_eq!((found.candidates().len(), best.part), (1, Some(part)));
            assert!((best.factor / factor - 1.0).abs() < 1e-6, "{best:?}");
            assert!(best.chi_squared < 1e-8 && !found.is_alike_possible());
            let [low, high] = best.factor_interval;
            assert!(low < factor && factor < high && high - low < 0.1);
        }
    }

    #[test]
    fn holds_the_interval_and_the_candidates_hold_the_truth_in_95_of_100() {
        let mut random = Random::new(11, 0);
        let (mut inside, mut named, mut told) = (0, 0, 0);
        const RUNS: usize = 200;
        for run in 0..RUNS {
            let part = run % 3;
            let found = which_part(&drawn(Some(part), 0.85, 0.004, &mut random), 3, changes_of).unwrap();
            let candidates = found.candidates();
            named += usize::from(candidates.iter().any(|of| of.part == Some(part)));
            told += usize::from(candidates.len() == 1);
            let own = found.parts.iter().find(|of| of.part == Some(part)).unwrap();
            let [low, high] = own.factor_interval;
            inside += usize::from(low <= 0.85 && 0.85 <= high);
        }
        // binomial distribution: 95 % minus three standard deviations
        assert!(inside >= 181 && named >= 181, "{inside} {named} {told}");
        assert!(told > RUNS / 2, "{told}");
    }

    #[test]
    fn holds_what_is_alike_everywhere_and_what_no_part_explains_are_called_so() {
        let mut random = Random::new(12, 0);
        let alike = which_part(&drawn(None, 0.9, 0.002, &mut random), 3, changes_of).unwrap();
        assert!(
            alike.is_alike_possible() && alike.candidates().is_empty(),
            "{alike:?}"
        );
        let odd = [-0.05, 0.05, -0.05].map(|relative| FrequencyChange { relative, sd: 0.002 });
        let odd = which_part(&odd, 3, changes_of).unwrap();
        assert!(odd.candidates().is_empty() && !odd.is_alike_possible());
        // one frequency cannot distinguish the parts
        assert_eq!(
            which_part(&drawn(None, 0.9, 0.002, &mut random)[..1], 3, changes_of),
            None
        );
    }
}
