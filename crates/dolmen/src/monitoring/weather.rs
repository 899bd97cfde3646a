//! Explanatory variables of a frequency other than changes: level, temperature, frost and season.

use super::regression::{Fit, restricted_likelihood};
use super::series::Series;
use std::f64::consts::TAU;

/// Fewest surveys below freezing for a frost coefficient, and fewest surveys with a temperature for a line. Our choice.
pub(super) const FROST_SURVEYS_LEAST: usize = 3;
const LINE_SURVEYS_LEAST: usize = 6;
/// Least range of temperatures for a fitted coefficient, °C, as in the comparison of two surveys.
const SPREAD_LEAST_C: f64 = 2.0;
/// Fewest surveys and years for a season. Our choice: two of each.
const SEASON_SURVEYS_LEAST: usize = 12;
const SEASON_YEARS_LEAST: f64 = 2.0;
pub(super) const YEAR_DAYS: f64 = 365.25;

/// The readings of one mode.
#[derive(Clone, Debug, Default, PartialEq)]
pub(super) struct ModeSeries {
    pub(super) series: Series,
    /// Index of the survey of each reading.
    pub(super) surveys: Vec<usize>,
    pub(super) days: Vec<f64>,
    /// Temperature of each reading, °C; NaN if unknown.
    pub(super) temperatures_c: Vec<f64>,
}

impl ModeSeries {
    pub(super) fn len(&self) -> usize {
        self.surveys.len()
    }

    /// The readings whose index `keep` accepts.
    pub(super) fn kept(&self, keep: impl Fn(usize) -> bool) -> ModeSeries {
        let which: Vec<usize> = (0..self.len()).filter(|i| keep(*i)).collect();
        let of = |values: &[f64]| which.iter().map(|i| values[*i]).collect();
        ModeSeries {
            series: Series {
                at: of(&self.series.at),
                readings: of(&self.series.readings),
                noise_sd: of(&self.series.noise_sd),
            },
            surveys: which.iter().map(|i| self.surveys[*i]).collect(),
            days: of(&self.days),
            temperatures_c: of(&self.temperatures_c),
        }
    }
}

/// Which weather effects a series can determine.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WeatherKnown {
    /// A temperature coefficient.
    Temperature,
    /// A temperature coefficient, and another one below freezing.
    TemperatureAndFrost,
    /// Temperatures are unknown: a yearly wave.
    Season,
    /// Temperatures are unknown, and the surveys fall at only two times of the year: the difference between these times.
    TwoSeasons(Wave),
    /// No weather effect, so that changes and weather cannot be separated.
    Nothing,
}

/// The component of a yearly wave that distinguishes two times of the year.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Wave {
    /// The cosine of the yearly wave.
    Cosine,
    /// The sine of the yearly wave.
    Sine,
}

/// Variance of the yearly wave over the surveys below which the wave cannot be separated from the level. All surveys are then within about two
/// weeks of one day of the year, or of two opposite days. Our choice.
pub(super) const WAVE_VARIANCE_LEAST: f64 = 0.05;

/// The components of a yearly wave that the days of a series separate from the level.
fn season(days: &[f64]) -> WeatherKnown {
    let turns = || days.iter().map(|day| (TAU * day / YEAR_DAYS).sin_cos());
    let count = days.len() as f64;
    let (sine, cosine) = turns().fold((0.0, 0.0), |(s, c), (sin, cos)| {
        (s + sin / count, c + cos / count)
    });
    let [mut of_sine, mut of_cosine, mut of_both] = [0.0; 3];
    for (sin, cos) in turns() {
        of_sine += (sin - sine).powi(2) / count;
        of_cosine += (cos - cosine).powi(2) / count;
        of_both += (sin - sine) * (cos - cosine) / count;
    }
    let (half, apart) = (0.5 * (of_sine + of_cosine), 0.5 * (of_cosine - of_sine));
    let [least, most] = [-1.0, 1.0].map(|sign| half + sign * apart.hypot(of_both));
    match (least >= WAVE_VARIANCE_LEAST, most >= WAVE_VARIANCE_LEAST) {
        (true, _) => WeatherKnown::Season,
        (false, true) if of_cosine >= of_sine => WeatherKnown::TwoSeasons(Wave::Cosine),
        (false, true) => WeatherKnown::TwoSeasons(Wave::Sine),
        (false, false) => WeatherKnown::Nothing,
    }
}

/// Whether temperatures can explain a series: nearly all are known, and their range is sufficient.
pub(super) fn has_temperature(series: &ModeSeries) -> bool {
    let known = series.temperatures_c.iter().copied().filter(|t| t.is_finite());
    let count = known.clone().count();
    let (low, high) = known.fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), t| {
        (l.min(t), h.max(t))
    });
    count >= LINE_SURVEYS_LEAST && 5 * count >= 4 * series.len() && high - low >= SPREAD_LEAST_C
}

/// Explanatory variables of one survey: the level first, then the weather.
pub(super) fn explaining(
    known: WeatherKnown,
    (day, temperature_c): (f64, f64),
    (middle_c, frost_below_c): (f64, f64),
) -> Vec<f64> {
    // in units of ten degrees, so that the coefficients have the magnitude of the readings
    let warmth = 0.1 * (temperature_c - middle_c);
    let turn = TAU * day / YEAR_DAYS;
    match known {
        WeatherKnown::Temperature => vec![1.0, warmth],
        WeatherKnown::TemperatureAndFrost => {
            vec![1.0, warmth, 0.1 * (frost_below_c - temperature_c).max(0.0)]
        }
        WeatherKnown::Season => vec![1.0, turn.cos(), turn.sin()],
        WeatherKnown::TwoSeasons(Wave::Cosine) => vec![1.0, turn.cos()],
        WeatherKnown::TwoSeasons(Wave::Sine) => vec![1.0, turn.sin()],
        WeatherKnown::Nothing => vec![1.0],
    }
}

/// Explanatory variables of all surveys, column by column.
pub(super) fn columns(series: &ModeSeries, known: WeatherKnown, at: (f64, f64)) -> Vec<Vec<f64>> {
    let rows: Vec<Vec<f64>> = (0..series.len())
        .map(|i| explaining(known, (series.days[i], series.temperatures_c[i]), at))
        .collect();
    let width = rows.first().map_or(0, Vec::len);
    (0..width)
        .map(|c| rows.iter().map(|row| row[c]).collect())
        .collect()
}

/// Whether there are enough surveys below freezing to fit a frost coefficient.
pub(super) fn knows_frost(series: &ModeSeries, frost_below_c: f64) -> bool {
    let frost = series.temperatures_c.iter().filter(|t| **t < frost_below_c);
    frost.count() >= FROST_SURVEYS_LEAST
}

/// The weather effects that a series supports; frost only if the Bayesian information criterion favours it.
pub(super) fn earned(series: &ModeSeries, extra: &[Vec<f64>], at: (f64, f64)) -> WeatherKnown {
    let frost_below_c = at.1;
    if has_temperature(series) {
        let colder = series
            .temperatures_c
            .iter()
            .filter(|t| **t < frost_below_c)
            .count();
        let warmer = series.len() - colder;
        if colder < FROST_SURVEYS_LEAST || warmer < LINE_SURVEYS_LEAST {
            return WeatherKnown::Temperature;
        }
        let criterion = |known| {
            let mut all = columns(series, known, at);
            all.extend(extra.iter().cloned());
            let disturbance = restricted_likelihood(&series.series, &all, None)?;
            let fit = Fit::new(&series.series, &all, disturbance)?;
            Some(fit.minus_two_ln_likelihood + all.len() as f64 * (series.len() as f64).ln())
        };
        let both = (
            criterion(WeatherKnown::Temperature),
            criterion(WeatherKnown::TemperatureAndFrost),
        );
        return match both {
            (Some(line), Some(frost)) if frost < line => WeatherKnown::TemperatureAndFrost,
            _ => WeatherKnown::Temperature,
        };
    }
    let span = series
        .days
        .last()
        .zip(series.days.first())
        .map_or(0.0, |(b, a)| b - a);
    match series.len() >= SEASON_SURVEYS_LEAST && span >= SEASON_YEARS_LEAST * YEAR_DAYS {
        true => season(&series.days),
        false => WeatherKnown::Nothing,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_season_is_sought_where_surveys_lie_round_the_year() {
        let of = |months: &[f64]| {
            let days: Vec<f64> = (0..24)
                .map(|i| {
                    YEAR_DAYS * (f64::from(i) + months[i as usize % months.len()] / 12.0) + f64::from(i % 5)
                })
                .collect();
            season(&days)
        };
        assert_eq!(of(&[0.0, 3.0, 6.0, 9.0]), WeatherKnown::Season);
        // May of every year; May and November; January and July
        assert_eq!(of(&[4.3]), WeatherKnown::Nothing);
        assert_eq!(of(&[3.0, 9.0]), WeatherKnown::TwoSeasons(Wave::Sine));
        assert_eq!(of(&[0.0, 6.0]), WeatherKnown::TwoSeasons(Wave::Cosine));
    }
}
