//! Shape of a log in the course of the years: steps, changes of slope, and a rate that changes steadily.

use super::bends::Break;
use super::changes::{Changes, Seeking, changes};
use super::daily::DailyReadings;
use super::logged_blocks::Blocks;
use super::logged_curve::{by_chance, curve_column, last_statistic};
use super::logged_faults::LoggedJump;
use super::logged_steps::{LoggedBreak, StepSearch};
use super::series::Series;

/// Number of days of the medians in which the shape is found.
pub(super) const SHAPE_DAYS: f64 = 30.0;
/// Smallest number of medians in excess of the number of explanatory variables. Our choice.
pub(super) const SPARE_LEAST: usize = 8;
/// Fraction of the significance level that is used for changes of slope and for a change of the rate, because a false change would create a trend.
/// Our choice, so that false trends remain as rare as stated.
const OF_BENDS: f64 = 0.2;
/// The same for steps in medians of a week. Our choice.
const OF_STEPS: f64 = 0.1;
/// Largest correlation of neighbouring months, with the shape in the regression, at which the shape counts. Our choice.
const BENT_BELOW: f64 = 0.7;
/// The same for a steady change of the rate. Our choice, so that random walks show no more trends than without it.
const CURVED_BELOW: f64 = 0.38;
/// Number of simulated logs for a change near the limit of chance, as for frequencies.
const REPLICATES: usize = 999;
/// Least ratio of a change of the rate to its standard deviation. Our choice, as for jumps: fainter ones can follow a slow disturbance under noise, and
/// would make false trends.
const CURVE_FROM: f64 = 6.0;

/// The shape of a log.
pub(super) struct Shape {
    /// Whether its rate changes steadily.
    pub(super) is_curved: bool,
    /// Its steps and changes of slope.
    pub(super) breaks: Vec<LoggedBreak>,
}

impl Shape {
    /// The first days after its steps.
    pub(super) fn steps(&self) -> Vec<f64> {
        let steps = self.breaks.iter().filter(|of| of.is_step());
        steps.map(|of| of.dated.day).collect()
    }
}

/// A log in which a shape is sought.
pub(super) struct Shaped<'a> {
    pub(super) daily: &'a DailyReadings,
    pub(super) temperatures_c: &'a [f64],
    pub(super) jump: Option<LoggedJump>,
    pub(super) works: &'a [[f64; 2]],
    pub(super) significance: f64,
}

/// The jump, and the significant steps, changes of slope and steady change of the rate besides it, in medians of 30 days. Steps and changes of
/// slope are those of the criterion for frequencies. A steady change of the rate counts if series without it show one as strong with a probability
/// below the limit, and if it explains the medians better than the changes of slope do (criterion of Schwarz 1978).
pub(super) fn shape(of: &Shaped<'_>) -> Shape {
    let search = StepSearch {
        daily: of.daily,
        temperatures_c: of.temperatures_c,
        works: of.works,
        significance: OF_STEPS * of.significance,
    };
    let jump = of
        .jump
        .map(|jump| LoggedBreak::step(jump.before, [jump.after, jump.before]));
    let breaks = search.steps(jump.into_iter().collect());
    let splits: Vec<f64> = breaks.iter().map(|of| of.dated.day).collect();
    let blocks = Blocks::of(of.daily, of.temperatures_c, SHAPE_DAYS, &splits);
    let last = of.daily.days.last().copied().unwrap_or(0.0);
    let (mut columns, _) = blocks.columns(last, of.works);
    columns.extend(breaks.iter().map(|of| of.dated.column(&blocks.days)));
    let mut shape = Shape {
        is_curved: false,
        breaks,
    };
    if blocks.days.len() < columns.len() + SPARE_LEAST {
        return shape;
    }
    let seeking = Seeking {
        significance: OF_BENDS * of.significance,
        modes: 1,
        replicates: REPLICATES,
        seed: 1,
    };
    let series = blocks.series();
    // a series that still drifts randomly cannot be distinguished from chance by any number of changes of slope
    let is_calm = |found: &Changes, below: f64| found.disturbance.correlation < below;
    let straight = changes(&series, &columns, &seeking).filter(|found| is_calm(found, BENT_BELOW));
    columns.push(curve_column(&blocks.days, last));
    let curved = curved(&series, &columns, &seeking).filter(|found| is_calm(found, CURVED_BELOW));
    let found = match (straight, curved) {
        (Some(straight), Some(curved)) => {
            shape.is_curved = criterion(&curved, series.len()) < criterion(&straight, series.len());
            Some(if shape.is_curved { curved } else { straight })
        }
        (straight, curved) => {
            shape.is_curved = curved.is_some();
            curved.or(straight)
        }
    };
    for of in found.iter().flat_map(Break::of) {
        let own = LoggedBreak {
            // a step begins with the first day of its month
            dated: of.dated(&blocks.begins),
            after: blocks.days[of.after],
            before: blocks.days[of.before],
        };
        let mut steps: Vec<LoggedBreak> = shape.breaks.iter().filter(|of| of.is_step()).copied().collect();
        steps.push(own);
        let by_days = search.dated(&steps, steps.len() - 1);
        shape.breaks.push(match own.is_step() {
            true => by_days.unwrap_or(own),
            false => own,
        });
    }
    shape.breaks.sort_by(|a, b| a.dated.day.total_cmp(&b.dated.day));
    shape
}

/// The changes beside a steady change of the rate, whose column is the last; `None` if this may be chance.
fn curved(series: &Series, columns: &[Vec<f64>], seeking: &Seeking) -> Option<Changes> {
    let alone = last_statistic(series, columns, None)?;
    if alone.abs() < CURVE_FROM {
        return None;
    }
    let found = changes(series, columns, seeking)?;
    let mut beside = found.columns.clone();
    let curve = beside.remove(columns.len() - 1);
    beside.push(curve);
    let statistic = last_statistic(series, &beside, Some(found.disturbance))?;
    let p = by_chance(series, &beside, statistic, seeking.seed)?;
    (p < seeking.significance).then_some(found)
}

/// −2 ln of the likelihood, plus ln n for each coefficient and each date.
fn criterion(found: &Changes, n: usize) -> f64 {
    let dates = found.found.len() + usize::from(found.late.is_some());
    found.fit.minus_two_ln_likelihood + (found.columns.len() + dates) as f64 * (n as f64).ln()
}
