//! The change that best explains a series in addition to its regression: a step or the beginning of a slope, at any survey.
//!
//! ```text
//! t(c) = cᵀ V⁻¹ r / √(cᵀ V⁻¹ c − hᵀ (Xᵀ V⁻¹ X)⁻¹ h),   h = Xᵀ V⁻¹ c,   r = y − X β
//! ```
//! This equals the statistic of c in the joint regression on X and c. Sums from the end of the series give it for all dates at once.

use super::regression::{Fit, restricted_likelihood};
use super::series::Series;
use super::whitening::Disturbance;

/// Fewest surveys on each side of a step, and after the beginning of a slope. Our choice: changes with fewer surveys are left to the
/// alarm.
pub(super) const STEP_SURVEYS_LEAST: usize = 3;
pub(super) const SLOPE_SURVEYS_LEAST: usize = 6;
/// Least fraction of the information on a change that is independent of the known columns; with less, the change cannot be separated from
/// them. Our choice.
const OWN_LEAST: f64 = 2e-3;
/// Number of iterations that estimate the disturbance with the found change and search again. Our choice: the date rarely moves in the
/// second.
const ROUNDS: usize = 2;

/// The change of a frequency.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum ChangeForm {
    /// A sudden and lasting change.
    Step,
    /// A steady change that begins at its date.
    Slope,
}

/// A change that begins at one survey.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Candidate {
    pub(super) form: ChangeForm,
    /// For a step, the first survey after it; for a slope, the last survey before it.
    pub(super) from: usize,
    pub(super) statistic: f64,
    /// Size of a step, or change of a slope over one interval.
    pub(super) size: f64,
    pub(super) sd: f64,
}

/// All possible changes.
pub(super) struct Scan {
    pub(super) all: Vec<Candidate>,
    /// Steps with too few surveys: they explain a change that is not yet lasting and that would otherwise look like a drift.
    pub(super) late: Vec<Candidate>,
}

impl Scan {
    pub(super) fn strongest(&self) -> Option<Candidate> {
        strongest_of(&self.all)
    }

    pub(super) fn strongest_late(&self) -> Option<Candidate> {
        strongest_of(&self.late)
    }
}

fn strongest_of(all: &[Candidate]) -> Option<Candidate> {
    let all = all.iter().copied();
    all.reduce(|best, other| match other.statistic.abs() > best.statistic.abs() {
        true => other,
        false => best,
    })
}

/// The column of a change.
pub(super) fn column(at: &[f64], form: ChangeForm, from: usize) -> Vec<f64> {
    let surveys = at.iter().enumerate();
    surveys
        .map(|(i, t)| match form {
            ChangeForm::Step => f64::from(u8::from(i >= from)),
            ChangeForm::Slope => (t - at[from]).max(0.0),
        })
        .collect()
}

/// All possible changes in addition to `columns`, whose regression is `fit`.
pub(super) fn scan(series: &Series, columns: &[Vec<f64>], fit: &Fit) -> Scan {
    let (n, k, at) = (series.len(), columns.len(), &series.at);
    let inverse = |z: &[f64]| fit.whitening.adjoint(&fit.whitening.white(z));
    let of_residuals = inverse(&fit.residuals(series, columns));
    let of_columns: Vec<Vec<f64>> = columns.iter().map(|column| inverse(column)).collect();
    let (steps, slopes) = fit.whitening.energies(at);
    let (mut all, mut late) = (Vec::with_capacity(2 * n), Vec::new());
    // sums from survey i on of V⁻¹ times the columns, and of t times these; the last column is the residual
    let (mut sums, mut moments) = (vec![0.0; k + 1], vec![0.0; k + 1]);
    let mut with_columns = vec![0.0; k];
    for i in (0..n).rev() {
        for (c, inverted) in of_columns.iter().chain([&of_residuals]).enumerate() {
            sums[c] += inverted[i];
            moments[c] += at[i] * inverted[i];
        }
        let mut candidate = |form, energy: f64, product: &dyn Fn(usize) -> f64| {
            let with_residuals = product(k);
            for (c, with) in with_columns.iter_mut().enumerate() {
                *with = product(c);
            }
            let own = energy - fit.form(&mut with_columns);
            (own > OWN_LEAST * energy && own > 0.0).then(|| Candidate {
                form,
                from: i,
                statistic: with_residuals / own.sqrt(),
                size: with_residuals / own,
                sd: 1.0 / own.sqrt(),
            })
        };
        if i >= STEP_SURVEYS_LEAST {
            let step = candidate(ChangeForm::Step, steps[i], &|c| sums[c]);
            match i + STEP_SURVEYS_LEAST <= n {
                true => all.extend(step),
                false => late.extend(step),
            }
        }
        if i + SLOPE_SURVEYS_LEAST <= n {
            all.extend(candidate(ChangeForm::Slope, slopes[i], &|c| {
                moments[c] - at[i] * sums[c]
            }));
        }
    }
    Scan { all, late }
}

/// The strongest change in addition to `columns`, with the disturbance that is estimated together with it.
pub(super) struct Strongest {
    pub(super) change: Candidate,
    /// The strongest step with too few surveys, with the same disturbance.
    pub(super) late: Option<Candidate>,
    pub(super) disturbance: Disturbance,
    /// The disturbance estimated without the change.
    pub(super) without: Disturbance,
}

/// Searches for the strongest change in iterations: the disturbance is estimated without the change, the change is found, and both are
/// repeated with the change in the regression. Without it, a step would look like a slowly decaying disturbance.
pub(super) fn strongest(
    series: &Series,
    columns: &[Vec<f64>],
    start: Option<Disturbance>,
) -> Option<Strongest> {
    let without = restricted_likelihood(series, columns, start)?;
    let mut disturbance = without;
    let mut change = scan(series, columns, &Fit::new(series, columns, disturbance)?).strongest()?;
    let mut round = 0;
    loop {
        let mut with = columns.to_vec();
        with.push(column(&series.at, change.form, change.from));
        disturbance = restricted_likelihood(series, &with, Some(disturbance))?;
        let scanned = scan(series, columns, &Fit::new(series, columns, disturbance)?);
        let found = scanned.strongest()?;
        round += 1;
        let is_same = (found.form, found.from) == (change.form, change.from);
        change = found;
        if is_same || round == ROUNDS {
            return Some(Strongest {
                change,
                late: scanned.strongest_late(),
                disturbance,
                without,
            });
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::numeric::Random;

    #[test]
    fn agrees_with_the_regression_on_each_change() {
        let n = 24;
        let mut random = Random::new(5, 0);
        let series = Series {
            at: (0..n).map(|i| f64::from(i) + 0.3 * f64::from(i % 3)).collect(),
            readings: (0..n).map(|_| random.normal()).collect(),
            noise_sd: (0..n).map(|i| 0.2 + 0.1 * f64::from(i % 4)).collect(),
        };
        let columns = vec![
            vec![1.0; n as usize],
            (0..n).map(|i| f64::from(i).sin()).collect::<Vec<f64>>(),
        ];
        let disturbance = Disturbance {
            sd: 0.7,
            correlation: 0.5,
        };
        let fit = Fit::new(&series, &columns, disturbance).unwrap();
        let found = scan(&series, &columns, &fit);
        assert_eq!(found.all.len(), (24 - 5) + (24 - 5));
        for change in &found.all {
            let mut with = columns.clone();
            with.push(column(&series.at, change.form, change.from));
            let joint = Fit::new(&series, &with, disturbance).unwrap();
            let (size, sd) = (joint.coefficients[2], joint.sd[2]);
            assert!(
                (change.size - size).abs() < 1e-9 * (1.0 + size.abs()),
                "{change:?} {size}"
            );
            assert!((change.sd / sd - 1.0).abs() < 1e-8, "{change:?} {sd}");
        }
    }
}
