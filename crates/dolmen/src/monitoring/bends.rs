//! Regression of a series with steps and changes of slope; its level and slope are those at the last reading.

use super::changes::Changes;
use super::regression::{Fit, restricted_likelihood};
use super::scan::ChangeForm;
use super::series::Series;
use super::weather::YEAR_DAYS;
use super::whitening::Disturbance;

/// A change of a series, by indices of its readings.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Break {
    pub(super) form: ChangeForm,
    pub(super) from: usize,
    pub(super) after: usize,
    pub(super) before: usize,
}

impl Break {
    /// The changes of a search by time, including a step of the last readings.
    pub(super) fn of(found: &Changes) -> Vec<Self> {
        let lasting = found.found.iter().map(|of| {
            let is_step = of.change.form == ChangeForm::Step;
            Break {
                form: of.change.form,
                from: of.change.from,
                after: of.earliest.saturating_sub(usize::from(is_step)),
                before: of.latest,
            }
        });
        let late = found.late.iter().map(|of| Break {
            form: ChangeForm::Step,
            from: of.from,
            after: of.from.saturating_sub(1),
            before: of.from,
        });
        let mut all: Vec<Self> = lasting.chain(late).collect();
        all.sort_by_key(|of| of.from);
        all
    }

    /// The change with its date as a day.
    pub(super) fn dated(&self, days: &[f64]) -> DatedBreak {
        DatedBreak {
            form: self.form,
            day: days[self.from],
        }
    }
}

/// A change that begins on a given day.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct DatedBreak {
    pub(super) form: ChangeForm,
    /// The first day after a step; the day on which a slope begins.
    pub(super) day: f64,
}

impl DatedBreak {
    /// Its column, which is 0 after the change, because level and slope of the regression are those at the last reading.
    pub(super) fn column(&self, days: &[f64]) -> Vec<f64> {
        days.iter().map(|day| self.value(*day)).collect()
    }

    /// Value of the column on one day.
    pub(super) fn value(&self, day: f64) -> f64 {
        match self.form {
            ChangeForm::Step => f64::from(u8::from(day < self.day)),
            ChangeForm::Slope => ((day - self.day) / YEAR_DAYS).min(0.0),
        }
    }
}

/// Refines the dates of changes of slope between the readings of the search. The derivative with respect to a date is a step, whose coefficient gives
/// the correction of the date. Each date stays within its interval.
///
/// # Source
/// Muggeo (2003) Statistics in Medicine 22:3055-3071.
pub(super) fn refined(
    readings: &Series,
    known: &[Vec<f64>],
    days: &[f64],
    breaks: &[(DatedBreak, [f64; 2])],
) -> Vec<DatedBreak> {
    const ROUNDS: usize = 5;
    let mut dated: Vec<DatedBreak> = breaks.iter().map(|(of, _)| *of).collect();
    let columns_of = |dated: &[DatedBreak]| {
        let mut columns = known.to_vec();
        columns.extend(dated.iter().map(|of| of.column(days)));
        columns
    };
    let Some(disturbance) = restricted_likelihood(readings, &columns_of(&dated), None) else {
        return dated;
    };
    for _ in 0..ROUNDS {
        let mut columns = columns_of(&dated);
        let bends: Vec<usize> = (0..dated.len())
            .filter(|i| dated[*i].form == ChangeForm::Slope)
            .collect();
        for i in &bends {
            let step = DatedBreak {
                form: ChangeForm::Step,
                ..dated[*i]
            };
            columns.push(step.column(days));
        }
        let Some(fit) = Fit::new(readings, &columns, disturbance) else {
            return dated;
        };
        for (at, i) in bends.into_iter().enumerate() {
            let (bend, step) = (
                fit.coefficients[known.len() + i],
                fit.coefficients[known.len() + dated.len() + at],
            );
            let [from, to] = breaks[i].1;
            let moved = dated[i].day - step / bend * YEAR_DAYS;
            if moved.is_finite() {
                dated[i].day = moved.clamp(from, to);
            }
        }
    }
    dated
}

/// The regression on columns, the last of which are those of the breaks. The standard deviations include the uncertainty of the dates of changes of
/// slope: a date is a regular parameter, and its column is a step at the date.
///
/// # Source
/// Muggeo (2003) Statistics in Medicine 22:3055-3071.
pub(super) fn bent_fit(
    readings: &Series,
    columns: &[Vec<f64>],
    days: &[f64],
    breaks: &[DatedBreak],
) -> Option<BentFit> {
    let disturbance = restricted_likelihood(readings, columns, None)?;
    let fit = Fit::new(readings, columns, disturbance)?;
    let mut with_dates = columns.to_vec();
    for of in breaks.iter().filter(|of| of.form == ChangeForm::Slope) {
        let step = DatedBreak {
            form: ChangeForm::Step,
            ..*of
        };
        let column = step.column(days);
        if !with_dates.contains(&column) {
            with_dates.push(column);
        }
    }
    let n = readings.len();
    let is_dated = with_dates.len() > columns.len() && n >= with_dates.len() + 2;
    let dated = is_dated
        .then(|| Fit::new(readings, &with_dates, disturbance))
        .flatten();
    let Some(mut dated) = dated else {
        let degrees = (n - columns.len()) as f64;
        return Some(BentFit {
            fit,
            disturbance,
            degrees,
        });
    };
    for (c, own) in dated.coefficients.iter_mut().enumerate() {
        *own = fit.coefficients.get(c).copied().unwrap_or(0.0);
    }
    Some(BentFit {
        fit: dated,
        disturbance,
        degrees: (n - with_dates.len()) as f64,
    })
}

pub(super) struct BentFit {
    pub(super) fit: Fit,
    pub(super) disturbance: Disturbance,
    pub(super) degrees: f64,
}
