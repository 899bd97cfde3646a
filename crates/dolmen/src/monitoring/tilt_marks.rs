//! Transfers the history of earlier marks to a tilt with a new mark.

use super::MonitoringError;
use super::tilt::{SlopeLimit, TiltReach, TiltSlope, TiltTrend};
use super::weather::YEAR_DAYS;
use crate::numeric::student_two_sided_quantile;

/// Number of last readings whose mean, moved along the slope, is the current tilt. Our choice: a year of quarterly readings.
const READINGS_MOST: usize = 4;
/// Number of standard deviations up to which the slope of the new mark agrees with that of the previous mark. Our choice.
const OTHER_FROM: f64 = 2.5;
/// Degrees of freedom that level, slope and yearly wave use in the readings of the previous mark.
const TAKEN: usize = 4;

impl TiltTrend {
    /// The slope for the forecast: its own if significant, or that of the previous mark; `None` if the sign or the unit is uncertain.
    pub fn forecast(&self) -> Option<&TiltSlope> {
        let own = self.slope.as_ref().filter(|_| self.is_beyond_chance());
        own.or(self.carried.as_ref())
            .filter(|_| !self.is_sign_in_question() && !self.is_unit_in_question())
    }
}

/// Slope of the previous mark, for each tilt that has a newer mark in the same direction and no significant slope of its own: a new mark does not
/// mean a new structure.
///
/// # Errors
/// [`MonitoringError::Numeric`].
pub(super) fn carry(trends: &mut [TiltTrend], limit: Option<SlopeLimit>) -> Result<(), MonitoringError> {
    for i in 0..trends.len() {
        let own = &trends[i];
        let last = |of: &TiltTrend| of.series.surveys.last().copied();
        let others = trends
            .iter()
            .filter(|of| of.series.direction == own.series.direction && of.series.datum != own.series.datum);
        let is_newest = others.clone().all(|of| last(of) < last(own));
        let before = others
            .filter(|of| of.is_beyond_chance())
            .max_by_key(|of| last(of));
        let Some(before) = before.filter(|_| is_newest && !own.is_beyond_chance()) else {
            continue;
        };
        let Some(slope) = before.slope else { continue };
        let is_other = own.slope.is_some_and(|own| {
            let apart = own.per_year - slope.per_year;
            apart.abs() > OTHER_FROM * own.sd_per_year.hypot(slope.sd_per_year)
        });
        if is_other {
            continue;
        }
        let carried = moved(own, (before, &slope), limit)?;
        trends[i].carried = Some(carried);
    }
    Ok(())
}

/// The slope of the previous mark, with the current tilt and the time to the limit of the new mark.
fn moved(
    own: &TiltTrend,
    (before, slope): (&TiltTrend, &TiltSlope),
    limit: Option<SlopeLimit>,
) -> Result<TiltSlope, MonitoringError> {
    let (days, ratios) = (&own.series.days, &own.series.ratios);
    let n = days.len();
    let from = n.saturating_sub(READINGS_MOST);
    // readings before a step of the new mark belong to another level
    let from = own.steps().map(|of| of.from).chain([from]).max().unwrap_or(from);
    let used: Vec<usize> = (from..n).collect();
    let years = |i: usize| (days[n - 1] - days[i]) / YEAR_DAYS;
    let mean = |of: &dyn Fn(usize) -> f64| used.iter().map(|i| of(*i)).sum::<f64>() / used.len() as f64;
    let now = mean(&|i| ratios[i] + slope.per_year * years(i));
    let lag = mean(&years);
    let of_slope = slope.sd_per_year.powi(2);
    let of_now = before.scatter.powi(2) / used.len() as f64 + lag * lag * of_slope;
    let degrees = before.series.days.len().saturating_sub(TAKEN).max(1) as f64;
    let quantile = student_two_sided_quantile(0.05, degrees)?;
    let reach = limit.map(|limit| {
        let size = limit.size.abs();
        let limit = size.copysign(slope.per_year);
        let left = limit - now;
        let is_ahead = now.abs() < size;
        // (left − slope T)² = q² Var(now + slope T), Fieller (1954) J. R. Stat. Soc. B 16(2):175-185
        let square = quantile * quantile;
        let [c, half_b, a] = [
            left * left - square * of_now,
            left * slope.per_year + square * lag * of_slope,
            slope.per_year.powi(2) - square * of_slope,
        ];
        let root = (half_b * half_b - a * c).max(0.0).sqrt();
        let ends = (a > 0.0).then(|| [(half_b - root) / a, (half_b + root) / a]);
        let [earliest, latest] = ends.unwrap_or([0.0, f64::INFINITY]);
        TiltReach {
            limit,
            years: is_ahead.then(|| left / slope.per_year),
            years_earliest: is_ahead.then_some(earliest.max(0.0)),
            years_latest: is_ahead.then_some(latest),
        }
    });
    Ok(TiltSlope { now, reach, ..*slope })
}
