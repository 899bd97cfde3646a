//! What is known of one mode through the years.

use super::alarm::JudgedMode;
use super::scan::ChangeForm;
use super::tracking::Track;
use super::weather::WeatherKnown;
use super::whitening::Disturbance;

/// What the weather does to one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WeatherEffect {
    /// What is known of it.
    pub known: WeatherKnown,
    /// Relative change per °C, and its standard deviation.
    pub per_c: Option<(f64, f64)>,
    /// Relative rise per °C below freezing, beside that, and its standard deviation.
    pub frost_per_c: Option<(f64, f64)>,
    /// Correlation of temperature with time, where it is strong: weather and ageing are not told apart.
    pub with_time: Option<f64>,
    /// The disturbance that is left.
    pub disturbance: Disturbance,
}

/// A change of one mode.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WatchedChange {
    /// Step or slope.
    pub form: ChangeForm,
    /// The first survey that shows it.
    pub from: usize,
    /// The change came after this survey,
    pub after: usize,
    /// and not after this one: the interval holds the date with 95 % probability.
    pub before: usize,
    /// Relative change: of a step, or of a slope up to the last survey.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
    /// Relative change a year, of a slope.
    pub per_year: Option<f64>,
    /// Probability of so strong a change in any mode by chance.
    pub p_value: f64,
}

/// How far the last one or two surveys lie off what those before them, weather, works and changes explain.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LastOff {
    /// The first of them.
    pub from: usize,
    /// How many of them show the mode.
    pub surveys: usize,
    /// Relative change of the frequency.
    pub ratio: f64,
    /// Its standard deviation.
    pub sd: f64,
}

/// What a work did to a mode.
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
    /// Where it was found.
    pub track: Track,
    /// What the weather does to it; `None` where too few surveys show it.
    pub weather: Option<WeatherEffect>,
    /// For each survey the frequency that weather, works and changes explain, Hz.
    pub explained_hz: Vec<Option<f64>>,
    /// What changed.
    pub changes: Vec<WatchedChange>,
    /// What the last one or two surveys alone show: no lasting change yet, and no weather.
    pub last_off: Option<LastOff>,
    /// What works did.
    pub works: Vec<WorkEffect>,
    /// Least lasting step halfway through the years that would have been seen with 80 % probability.
    pub seen_from_ratio: Option<f64>,
    /// Surveys that stand alone: left out of the search.
    pub outliers: Vec<usize>,
    /// Surveys at temperatures that too few others had, or at an unknown one at a time of the year of which too few are known: left out of the search.
    pub strange: Vec<usize>,
    /// Surveys without a temperature that take part with that of their time of the year, and with the scatter of its weather as their error.
    pub guessed: Vec<usize>,
    /// Each survey against those before it.
    pub judged: JudgedMode,
}
