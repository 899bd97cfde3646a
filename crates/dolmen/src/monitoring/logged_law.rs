//! The time at which the law of a log reaches its limit: slope, growth of the slope, and season together.

use super::MonitoringError;
use super::logged_season::SeasonForm;
use super::regression::Fit;
use super::tilt::TiltReach;
use crate::numeric::{Bracketing, bracketed_root, student_two_sided_quantile};

/// Years within which the search looks for the limit; the step grows by this ratio. Our choice.
const YEARS_MOST: f64 = 1000.0;
const FIRST_STEP_YEARS: f64 = 0.05;
const STEP_GROWS: f64 = 1.1;
/// The same with a season, whose step must not pass over its peak. Our choice.
const SEASON_YEARS_MOST: f64 = 300.0;
const SEASON_STEP_YEARS: f64 = 0.02;

/// The extrapolated law of a fit whose first two columns are the level and the slope on the last day.
pub(super) struct Law<'a> {
    pub(super) fit: &'a Fit,
    /// Index of the column of the growth of the slope.
    pub(super) curve_at: Option<usize>,
    pub(super) season: Option<&'a SeasonForm>,
    /// The limit.
    pub(super) to: f64,
    /// The sign of the motion.
    pub(super) toward: f64,
}

impl Law<'_> {
    /// Writes the time, and the ends of its 95 % interval, into a reach that has a time by the slope alone.
    pub(super) fn set_years(&self, degrees: f64, reach: &mut TiltReach) -> Result<(), MonitoringError> {
        let Some(of_rate) = reach.years else {
            return Ok(());
        };
        let quantile = student_two_sided_quantile(0.05, degrees)?;
        let earliest = self.reached(quantile)?;
        reach.years = self.reached(0.0)?.or(Some(of_rate));
        reach.years_earliest = earliest.or(reach.years);
        reach.years_latest = Some(self.reached(-quantile)?.unwrap_or(f64::INFINITY));
        Ok(())
    }

    /// Years until the law, moved by so many of its standard deviations ahead, reaches the limit. The ends of the 95 % interval are the times at which
    /// the ends of the interval of the value reach it (the set of Fieller 1954 for a curve). `None` beyond the search.
    fn reached(&self, ahead: f64) -> Result<Option<f64>, MonitoringError> {
        let left = |years: f64| {
            let mut row = vec![0.0; self.fit.coefficients.len()];
            (row[0], row[1]) = (1.0, years);
            if let Some(at) = self.curve_at {
                row[at] = 0.5 * years * years;
            }
            if let Some(season) = self.season {
                season.add_to(years, &mut row);
            }
            let value: f64 = row
                .iter()
                .zip(&self.fit.coefficients)
                .map(|(x, beta)| x * beta)
                .sum();
            self.toward * (value - self.to) + ahead * self.fit.form(&mut row).sqrt()
        };
        if left(0.0) >= 0.0 {
            return Ok(Some(0.0));
        }
        let (most, mut step, grows) = match self.season {
            Some(_) => (SEASON_YEARS_MOST, SEASON_STEP_YEARS, 1.0),
            None => (YEARS_MOST, FIRST_STEP_YEARS, STEP_GROWS),
        };
        let mut from = 0.0;
        while from < most {
            let to = from + step;
            if left(to) >= 0.0 {
                return Ok(Some(bracketed_root(left, from, to, &Bracketing::default())?));
            }
            (from, step) = (to, grows * step);
        }
        Ok(None)
    }
}
