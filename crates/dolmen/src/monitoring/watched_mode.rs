//! Results for one mode over the years.

use super::alarm::JudgedMode;
use super::fitted_mode::FittedMode;
use super::regression::Fit;
use super::scan::{ChangeForm, column};
use super::tracking::Track;
use super::weather::WeatherKnown;
use super::whitening::Disturbance;

/// Effect of weather on one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeatherEffect {
    /// The weather effects that the series determines.
    pub known: WeatherKnown,
    /// Relative change per °C, and its standard deviation.
    pub per_c: Option<(f64, f64)>,
    /// Additional relative increase per °C below freezing, and its standard deviation.
    pub frost_per_c: Option<(f64, f64)>,
    /// Correlation of temperature with time, if it is strong: weather and ageing cannot then be separated.
    pub with_time: Option<f64>,
    /// The remaining disturbance.
    pub disturbance: Disturbance,
}

/// A change of one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WatchedChange {
    /// Step or slope.
    pub form: ChangeForm,
    /// The first survey with the change.
    pub from: usize,
    /// The change occurred after this survey,
    pub after: usize,
    /// and not after this one: the interval contains the date with 95 % probability.
    pub before: usize,
    /// Relative change: size of a step, or accumulated change of a slope up to the last survey.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
    /// Relative change per year, for a slope.
    pub per_year: Option<f64>,
    /// Probability of a change this strong in any mode by chance.
    pub p_value: f64,
}

/// Difference of the last one or two surveys from the prediction by earlier surveys, weather, works and changes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LastOff {
    /// The first of these surveys.
    pub from: usize,
    /// Number of these surveys with the mode.
    pub surveys: usize,
    /// Relative change of the frequency.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// Effect of a work on a mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WorkEffect {
    /// Index of the work.
    pub work: usize,
    /// Relative change of the frequency.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// One mode through the years.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedMode {
    /// Its track through the surveys.
    pub track: Track,
    /// Effect of weather on the mode; `None` if too few surveys show the mode.
    pub weather: Option<WeatherEffect>,
    /// For each survey the frequency explained by weather, works and changes, Hz.
    pub explained_hz: Vec<Option<f64>>,
    /// Changes of the mode.
    pub changes: Vec<WatchedChange>,
    /// Difference of only the last one or two surveys: not yet a lasting change, and not explained by weather.
    pub last_off: Option<LastOff>,
    /// Effects of works.
    pub works: Vec<WorkEffect>,
    /// Smallest lasting step halfway through the years that would have been found with 80 % probability.
    pub seen_from_ratio: Option<f64>,
    /// Isolated surveys, which are left out of the search.
    pub outliers: Vec<usize>,
    /// Surveys that are left out of the search: at temperatures with too few other surveys, or with an unknown temperature at a time of the year
    /// with too few known ones.
    pub strange: Vec<usize>,
    /// Surveys without a temperature. They have the mean temperature of their time of the year, with the scatter of the weather effect as error.
    pub guessed: Vec<usize>,
    /// Each survey compared with earlier ones.
    pub judged: JudgedMode,
    /// The fit to its readings; `None` if too few surveys show the mode.
    pub(super) fitted: Option<FittedMode>,
}

/// A change of a frequency at a given date, significant or not.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ChangeThere {
    /// Relative change: size of a step, or accumulated change of a slope up to the last survey.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

impl WatchedMode {
    /// Change of the mode at a survey: the detected change, or otherwise a change of this form that is estimated together with all other effects.
    /// `None` if there are too few readings on one side.
    pub fn change_there(&self, form: ChangeForm, from: usize) -> Option<ChangeThere> {
        let own = self.changes.iter().find(|of| {
            let interval = of.after..=of.before;
            of.form == form && interval.contains(&from)
        });
        if let Some(WatchedChange { ratio, sd, .. }) = own.copied() {
            return Some(ChangeThere { ratio, sd });
        }
        let of = self.fitted.as_ref()?;
        let at = of.surveys.iter().position(|survey| *survey >= from)?;
        let n = of.surveys.len();
        if at < READINGS_LEAST || n - at < READINGS_LEAST || n < of.columns.len() + 3 {
            return None;
        }
        let mut columns = of.columns.clone();
        columns.push(column(&of.series.at, form, at));
        let fit = Fit::new(&of.series, &columns, of.disturbance)?;
        let lasts = match form {
            ChangeForm::Step => 1.0,
            ChangeForm::Slope => of.series.at[n - 1] - of.series.at[at],
        };
        let last = columns.len() - 1;
        Some(ChangeThere {
            ratio: fit.coefficients[last] * lasts,
            sd: fit.sd[last] * lasts,
        })
    }
}

/// Fewest readings on either side of a change for its size. Our choice.
const READINGS_LEAST: usize = 2;
