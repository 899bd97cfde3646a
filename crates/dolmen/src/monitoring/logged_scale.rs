//! Days of a log that are on another scale: unit or range changed, sensor remounted the other way round.
//!
//! Three marks, each with a date:
//! - days scatter from one to the next by another factor, for four weeks or more;
//! - a step turns the sign of the readings, or multiplies them by the ratio of two units or ranges;
//! - season and temperature act the other way round.

use super::bends::DatedBreak;
use super::daily::DailyReadings;
use super::logged_blocks::{Blocks, usual_gap};
use super::regression::{Fit, restricted_likelihood};
use super::scan::ChangeForm;
use super::whitening::Disturbance;
use crate::numeric::middle_mean;

/// Number of differences between neighbouring days whose mean is compared with that of the whole log, and how many of the largest are left out: one
/// or two spikes. Our choice.
const PIECE: usize = 14;
const PIECE_WILD: usize = 4;
/// Fewest pieces of a log, and fewest neighbouring pieces on another scale. Our choice.
const PIECES_LEAST: usize = 8;
const PIECES_OTHER: usize = 2;
/// Ratio of scatters from which the scale is in question. Our choice: a windy winter may treble it.
const SCATTER_FROM: f64 = 5.0;
/// Number of days before and after a step whose medians are compared.
const BESIDE: usize = 14;
/// Sum over difference of the readings before and after a step below which only the sign changed, and part by which a ratio may differ from that of
/// two units or ranges: as for tilts.
const OPPOSITE: f64 = 0.1;
const ONE_UNIT: f64 = 0.05;
/// Least size of the readings before and after a step, in standard deviations of the step. Our choice.
const SURE_FROM: f64 = 6.0;
/// Ratios of units (%, mm/m, degrees for mm/m) and of gains of loggers.
const SCALES: [f64; 5] = [10.0, 16.0, 100.0, 1000.0, 1000.0 * std::f64::consts::PI / 180.0];
/// Days on either side of a date from which season and temperature act the other way round, and the distance of the dates tried first.
const TURNED_DAYS: f64 = 120.0;
const TURNED_STEP: usize = 14;
/// Least fall of −2 ln of the likelihood if season and temperature act the other way round. Our choice: chance gives less than 10.
const TURNED_FROM: f64 = 15.0;

/// Days on another scale.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedScale {
    /// The first day on another scale than those before.
    pub from: f64,
    /// What shows it.
    pub mark: ScaleMark,
}

/// What shows that the scale of a log changed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ScaleMark {
    /// Days scatter by this factor of the scatter before.
    Scatter(f64),
    /// The readings are this multiple of those before.
    Readings(f64),
    /// The readings have the other sign and the same size.
    OtherSign,
    /// Season and temperature act the other way round.
    Turned,
}

/// The first day of the days whose scatter from one day to the next differs most from that of the others, if by [`SCATTER_FROM`] or more: the
/// logarithms of the scatter of pieces split best, by least squares, into one run of pieces and all others.
pub(super) fn scattered(daily: &DailyReadings) -> Option<LoggedScale> {
    let gap = 2.0 * usual_gap(&daily.days);
    let pairs = daily.days.windows(2).zip(daily.values.windows(2));
    let moves: Vec<(f64, f64)> = pairs
        .filter(|(days, _)| days[1] - days[0] <= gap)
        .map(|(days, values)| (days[1], values[1] - values[0]))
        .collect();
    // without the motion of the structure
    let alone = moves.chunks(PIECE).flat_map(|piece| {
        let usual = middle_mean(piece.iter().map(|(_, by)| *by).collect());
        piece.iter().map(move |(day, by)| (*day, (by - usual).abs()))
    });
    let steps: Vec<(f64, f64)> = alone.collect();
    // readings with coarse steps are often equal: a calm fortnight is no other scale
    let positive = steps.iter().map(|(_, size)| *size).filter(|size| *size > 0.0);
    let finest = positive.fold(f64::INFINITY, f64::min);
    let scatter = |piece: &[(f64, f64)]| {
        let mut sizes: Vec<f64> = piece.iter().map(|(_, size)| *size).collect();
        sizes.sort_by(f64::total_cmp);
        let kept = &sizes[..sizes.len() - PIECE_WILD];
        (kept.iter().sum::<f64>() / kept.len() as f64).max(finest)
    };
    let each: Vec<f64> = steps
        .chunks_exact(PIECE)
        .map(|piece| scatter(piece).ln())
        .collect();
    let n = each.len();
    if n < PIECES_LEAST || !finest.is_finite() {
        return None;
    }
    let mut sums = vec![0.0];
    sums.extend(each.iter().scan(0.0, |sum, ln| {
        *sum += ln;
        Some(*sum)
    }));
    let contrast = |from: usize, to: usize| {
        let (run, rest) = ((to - from) as f64, (n - to + from) as f64);
        let own = sums[to] - sums[from];
        own / run - (sums[n] - own) / rest
    };
    let runs = (0..n).flat_map(|from| (from + PIECES_OTHER..=n).map(move |to| (from, to)));
    let split = |(from, to): (usize, usize)| {
        let run = (to - from) as f64;
        run * (n as f64 - run) * contrast(from, to).powi(2)
    };
    let runs = runs.filter(|(from, to)| n - (to - from) >= PIECES_OTHER);
    let (from, to) = runs.max_by(|a, b| split(*a).total_cmp(&split(*b)))?;
    let by = contrast(from, to);
    if by.abs() < SCATTER_FROM.ln() {
        return None;
    }
    let own = (sums[to] - sums[from]) / (to - from) as f64;
    // a run at the beginning is that before the change
    let (at, before, behind) = match from {
        0 => (to, own.exp(), (own - by).exp()),
        _ => (from, (own - by).exp(), own.exp()),
    };
    Some(LoggedScale {
        from: dated(&steps, at * PIECE, [before, behind]),
        mark: ScaleMark::Scatter(behind / before),
    })
}

/// The day of a change of scatter, by the likelihood of exponential sizes around the index `about`.
fn dated(steps: &[(f64, f64)], about: usize, [before, behind]: [f64; 2]) -> f64 {
    let around = about.saturating_sub(2 * PIECE)..(about + 2 * PIECE).min(steps.len());
    let cost = |at: usize| -> f64 {
        let part = |scale: f64| move |(_, size): &(f64, f64)| size / scale + scale.ln();
        let left = steps[around.start..at].iter().map(part(before));
        left.chain(steps[at..around.end].iter().map(part(behind))).sum()
    };
    let best = around.clone().min_by(|a, b| cost(*a).total_cmp(&cost(*b)));
    steps[best.unwrap_or(about).min(steps.len() - 1)].0
}

/// The step that begins on this day, if it turns the sign of the readings or multiplies them by a ratio of [`SCALES`]. `zero`: the value if the sensor
/// reads 0. `sd`: standard deviation of the step.
pub(super) fn stepped(daily: &DailyReadings, zero: f64, day: f64, sd: f64) -> Option<LoggedScale> {
    let at = daily.days.partition_point(|own| *own < day);
    let level = |of: &[f64]| middle_mean(of.iter().map(|value| value - zero).collect());
    let before = level(daily.values.get(at.checked_sub(BESIDE)?..at)?);
    let behind = level(daily.values.get(at..at + BESIDE)?);
    let size = (behind - before).abs();
    // a reading near 0 has no ratio
    if before.abs().min(behind.abs()) <= SURE_FROM * sd {
        return None;
    }
    let ratio = behind / before;
    let both = SCALES.into_iter().flat_map(|of| [of, 1.0 / of]);
    let mut near = both
        .flat_map(|of| [of, -of])
        .filter(|of| (ratio / of - 1.0).abs() <= ONE_UNIT);
    let mark = match (behind + before).abs() <= OPPOSITE * size {
        true => Some(ScaleMark::OtherSign),
        false => near.next().map(ScaleMark::Readings),
    };
    Some(LoggedScale {
        from: day,
        mark: mark?,
    })
}

/// A log in which season and temperature may act the other way round from some date on.
pub(super) struct Turning<'a> {
    pub(super) daily: &'a DailyReadings,
    pub(super) temperatures_c: &'a [f64],
    pub(super) works: &'a [[f64; 2]],
    /// Its steps and changes of slope.
    pub(super) breaks: Vec<DatedBreak>,
}

impl Turning<'_> {
    /// The date from which season and temperature act the other way round, beside a level and a slope of their own before and after it.
    pub(super) fn turned(&self) -> Option<LoggedScale> {
        let (first, last) = (*self.daily.days.first()?, *self.daily.days.last()?);
        let weeks = Blocks::of(self.daily, self.temperatures_c, 7.0, &[]);
        let ends = [first + TURNED_DAYS, last - TURNED_DAYS];
        let (ratio, about) = self.least(&weeks, ends, TURNED_STEP / 7)?;
        if ratio >= 1.0 {
            return None;
        }
        let series = weeks.series();
        let criterion = |is_turned| {
            let columns = self.columns(&weeks, about, is_turned);
            let fit = Fit::new(&series, &columns, restricted_likelihood(&series, &columns, None)?)?;
            Some(fit.minus_two_ln_likelihood)
        };
        if criterion(false)? - criterion(true)? < TURNED_FROM {
            return None;
        }
        let days = Blocks::of(self.daily, self.temperatures_c, 1.0, &[]);
        let near = 2.0 * TURNED_STEP as f64;
        let (_, from) = self.least(&days, [about - near, about + near], 1)?;
        Some(LoggedScale {
            from,
            mark: ScaleMark::Turned,
        })
    }

    /// The date in a range at which the squares of the residuals with a turn are least beside those without it: their ratio and the date.
    fn least(&self, blocks: &Blocks, range: [f64; 2], step: usize) -> Option<(f64, f64)> {
        let alone = Disturbance {
            sd: 1.0,
            correlation: 0.0,
        };
        let series = blocks.series();
        let dates = blocks.begins.iter().step_by(step).copied();
        let near = dates.filter(|day| *day >= range[0] && *day <= range[1]);
        let ratios = near.filter_map(|day| {
            let rest = |is_turned| {
                let fit = Fit::new(&series, &self.columns(blocks, day, is_turned), alone)?;
                Some(fit.minus_two_ln_likelihood)
            };
            Some((rest(true)? / rest(false)?, day))
        });
        ratios.min_by(|a, b| a.0.total_cmp(&b.0))
    }

    /// Columns with a step and a change of slope on a day; those of season and temperature turn their sign there.
    fn columns(&self, blocks: &Blocks, day: f64, is_turned: bool) -> Vec<Vec<f64>> {
        let last = blocks.days.last().copied().unwrap_or(0.0);
        let (mut columns, shifted) = blocks.columns(last, self.works);
        let response = 2..columns.len() - shifted.len();
        if is_turned {
            for column in &mut columns[response] {
                let both = column.iter_mut().zip(&blocks.begins);
                both.filter(|(_, own)| **own >= day)
                    .for_each(|(value, _)| *value = -*value);
            }
        }
        let own = [ChangeForm::Step, ChangeForm::Slope].map(|form| DatedBreak { form, day });
        for of in own.iter().chain(&self.breaks) {
            let column = of.column(&blocks.days);
            if column.first() != column.last() && !columns.contains(&column) {
                columns.push(column);
            }
        }
        columns
    }
}
