//! Steps of a log that no work explains: found in medians of a week, dated by the days.
//!
//! The search is that of [`super::changes`], for steps alone, beside a rate that changes steadily. So a curve, or a change of slope, is not taken
//! for steps. The date of each step is that of the largest likelihood of the days (the largest |t| of the joint regression) within 30 days.

use super::bends::DatedBreak;
use super::changes::STEP_DATES;
use super::critical::limit_of;
use super::daily::DailyReadings;
use super::logged_blocks::Blocks;
use super::logged_curve::{curve_column, last_statistic};
use super::regression::{Fit, restricted_likelihood};
use super::scan::{Candidate, ChangeForm, scan, strongest};
use super::series::Series;

/// Number of days of the medians in which steps are sought. Our choice: days show the noise of a disturbance, months smear a step.
const SEARCH_DAYS: f64 = 7.0;
/// Number of days of the medians that must show a step, too.
const CONFIRM_DAYS: f64 = 30.0;
/// Days on either side of a date found in medians among which the days decide.
const BESIDE_DAYS: f64 = 30.0;
/// Least distance of two steps: two medians. Our choice.
const APART_DAYS: f64 = 14.0;
/// Number of times that each date is sought again together with the others.
const ROUNDS: usize = 2;
/// Largest number of steps. Our choice.
const STEPS_MOST: usize = 6;
/// Smallest number of medians in excess of the number of explanatory variables. Our choice.
const SPARE_LEAST: usize = 8;

/// A change with the interval of its date.
#[derive(Clone, Copy)]
pub(super) struct LoggedBreak {
    pub(super) dated: DatedBreak,
    /// The last day before the interval.
    pub(super) after: f64,
    /// Its last day.
    pub(super) before: f64,
}

impl LoggedBreak {
    /// Whether it is a step.
    pub(super) fn is_step(&self) -> bool {
        self.dated.form == ChangeForm::Step
    }

    /// A step with this first day and this interval.
    pub(super) fn step(day: f64, [after, before]: [f64; 2]) -> Self {
        LoggedBreak {
            dated: DatedBreak {
                form: ChangeForm::Step,
                day,
            },
            after,
            before,
        }
    }
}

/// Days with the explanatory variables other than steps.
pub(super) struct StepSearch<'a> {
    pub(super) daily: &'a DailyReadings,
    pub(super) temperatures_c: &'a [f64],
    pub(super) works: &'a [[f64; 2]],
    /// Probability of a step by chance.
    pub(super) significance: f64,
}

impl StepSearch<'_> {
    /// Columns of medians, with these steps.
    fn columns(&self, blocks: &Blocks, steps: &[LoggedBreak]) -> Vec<Vec<f64>> {
        let last = self.daily.days.last().copied().unwrap_or(0.0);
        let (mut columns, _) = blocks.columns(last, self.works);
        columns.push(curve_column(&blocks.days, last));
        for of in steps {
            let column = of.dated.column(&blocks.days);
            if column.contains(&1.0) && column.contains(&0.0) && !columns.contains(&column) {
                columns.push(column);
            }
        }
        columns
    }

    fn blocks(&self, block_days: f64, steps: &[LoggedBreak]) -> Blocks {
        let splits: Vec<f64> = steps.iter().map(|of| of.dated.day).collect();
        Blocks::of(self.daily, self.temperatures_c, block_days, &splits)
    }

    /// The steps beside those that are known, all dated by the days.
    pub(super) fn steps(&self, known: Vec<LoggedBreak>) -> Vec<LoggedBreak> {
        let mut found = known;
        while found.len() < STEPS_MOST {
            let blocks = self.blocks(SEARCH_DAYS, &found);
            let columns = self.columns(&blocks, &found);
            let n = blocks.days.len();
            if n < columns.len() + SPARE_LEAST {
                break;
            }
            let series = blocks.series();
            let Some(best) = strongest(&series, &columns, None) else {
                break;
            };
            let correlation = best.without.correlation;
            let is_seen = best.change.statistic.abs() > limit_of(self.significance, n, correlation);
            if !is_seen || best.change.form != ChangeForm::Step {
                break;
            }
            let day = blocks.begins[best.change.from];
            if found.iter().any(|of| (of.dated.day - day).abs() < APART_DAYS) {
                break;
            }
            found.push(LoggedBreak::step(day, [blocks.days[best.change.from - 1], day]));
            for _ in 0..ROUNDS {
                for i in 0..found.len() {
                    found[i] = self.dated(&found, i).unwrap_or(found[i]);
                }
            }
            if !self.is_seen_in_months(&found) {
                found.pop();
                break;
            }
        }
        found.sort_by(|a, b| a.dated.day.total_cmp(&b.dated.day));
        found
    }

    /// Whether the last step is beyond chance in medians of a month, too, beside a rate that changes steadily and without one: a slow disturbance under
    /// noise shows itself there, and step and curve together can follow it.
    fn is_seen_in_months(&self, steps: &[LoggedBreak]) -> bool {
        let blocks = self.blocks(CONFIRM_DAYS, steps);
        let columns = self.columns(&blocks, steps);
        let series = blocks.series();
        let n = blocks.days.len();
        if n < columns.len() + SPARE_LEAST {
            return false;
        }
        let last = self.daily.days.last().copied().unwrap_or(0.0);
        let curve = curve_column(&blocks.days, last);
        let straight: Vec<Vec<f64>> = columns.iter().filter(|of| **of != curve).cloned().collect();
        [columns, straight].into_iter().all(|columns| {
            // estimated without the step: with it, the disturbance would be underestimated
            let without = restricted_likelihood(&series, &columns[..columns.len() - 1], None);
            let statistic = last_statistic(&series, &columns, without);
            statistic.zip(without).is_some_and(|(statistic, without)| {
                statistic.abs() > limit_of(self.significance, n, without.correlation)
            })
        })
    }

    /// Step `which` with its date by the days, and the interval of it: the dates whose −2 ln of the likelihood is within the limit of Eo & Morley.
    pub(super) fn dated(&self, steps: &[LoggedBreak], which: usize) -> Option<LoggedBreak> {
        let (own, mut others) = (steps[which], steps.to_vec());
        others.remove(which);
        let days = Blocks::of(self.daily, self.temperatures_c, 1.0, &[]);
        let columns = self.columns(&days, &others);
        let series: Series = days.series();
        let mut with = columns.clone();
        with.push(own.dated.column(&days.days));
        let disturbance = restricted_likelihood(&series, &with, None)?;
        let scanned = scan(&series, &columns, &Fit::new(&series, &columns, disturbance)?);
        let is_near = |of: &&Candidate| {
            of.form == ChangeForm::Step && (days.days[of.from] - own.dated.day).abs() <= BESIDE_DAYS
        };
        let near: Vec<&Candidate> = scanned.all.iter().filter(is_near).collect();
        let square = |of: &Candidate| of.statistic * of.statistic;
        let best = near.iter().max_by(|a, b| square(a).total_cmp(&square(b)))?;
        let likely = near.iter().filter(|of| square(of) >= square(best) - STEP_DATES);
        let (first, last) = likely.fold((best.from, best.from), |(low, high), of| {
            (low.min(of.from), high.max(of.from))
        });
        let interval = [days.days[first.saturating_sub(1)], days.days[last]];
        Some(LoggedBreak::step(days.days[best.from], interval))
    }
}
