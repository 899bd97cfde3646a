//! The yearly wave of a log as it is read: its season, and what temperature does to it over a year.
//!
//! ```text
//! s(t) = m + c cos ωt + d sin ωt,   (m, c, d): least squares of β_s x_s(t), x_s the columns of season and temperature
//! ```

use super::regression::Fit;
use super::series::Series;
use super::weather::YEAR_DAYS;
use super::whitening::Disturbance;
use std::f64::consts::TAU;
use std::ops::Range;

/// Size of a wave, in its standard deviations, from which a forecast counts it: chance exceeds it with 1 % (Rayleigh, e^(−3²/2)). Our choice.
const SEEN_FROM: f64 = 3.0;

/// The yearly wave of a log about its trend.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LoggedSeason {
    /// Its mean.
    pub mean: f64,
    /// Its cosine, of 2π times the day over that of a year.
    pub cosine: f64,
    /// Its sine.
    pub sine: f64,
}

impl LoggedSeason {
    /// Its value on a day from 1970-01-01.
    pub fn at(&self, day: f64) -> f64 {
        let turn = TAU * day / YEAR_DAYS;
        self.mean + self.cosine * turn.cos() + self.sine * turn.sin()
    }
}

/// A wave as linear forms of the coefficients of a fit.
pub(super) struct SeasonForm {
    /// Coefficients of mean, cosine and sine for each column of season and temperature, and the index of the first of these columns.
    of_columns: Vec<[f64; 3]>,
    first: usize,
    /// The day from which years count.
    last: f64,
    pub(super) season: LoggedSeason,
}

impl SeasonForm {
    /// From the columns of season and temperature of a fit; `None` if the days determine no whole wave, or if it may be chance.
    pub(super) fn of(
        fit: &Fit,
        columns: &[Vec<f64>],
        seasonal: Range<usize>,
        days: &[f64],
        last: f64,
    ) -> Option<Self> {
        let turns: Vec<f64> = days.iter().map(|day| TAU * day / YEAR_DAYS).collect();
        let basis = [
            vec![1.0; days.len()],
            turns.iter().map(|turn| turn.cos()).collect(),
            turns.iter().map(|turn| turn.sin()).collect(),
        ];
        let white = Disturbance {
            sd: 1.0,
            correlation: 0.0,
        };
        let first = seasonal.start;
        let of_columns: Option<Vec<[f64; 3]>> = columns
            .get(seasonal)?
            .iter()
            .map(|column| {
                let series = Series {
                    at: (0..days.len()).map(|i| i as f64).collect(),
                    readings: column.clone(),
                    noise_sd: vec![0.0; days.len()],
                };
                Fit::new(&series, &basis, white)?.coefficients.try_into().ok()
            })
            .collect();
        let of_columns = of_columns?;
        let row = |part: usize| {
            let mut row = vec![0.0; fit.coefficients.len()];
            let own = row.iter_mut().skip(first).zip(&of_columns);
            own.for_each(|(to, of)| *to = of[part]);
            row
        };
        let size = |part: usize| -> f64 {
            let both = row(part).into_iter().zip(&fit.coefficients);
            both.map(|(x, beta)| x * beta).sum()
        };
        let season = LoggedSeason {
            mean: size(0),
            cosine: size(1),
            sine: size(2),
        };
        let variance = 0.5 * (fit.form(&mut row(1)) + fit.form(&mut row(2)));
        let is_seen = season.cosine.hypot(season.sine) > SEEN_FROM * variance.sqrt();
        is_seen.then_some(SeasonForm {
            of_columns,
            first,
            last,
            season,
        })
    }

    /// Adds the wave so many years after the last day to a row of the regression.
    pub(super) fn add_to(&self, years: f64, row: &mut [f64]) {
        let turn = TAU * (self.last / YEAR_DAYS + years);
        let to = row.iter_mut().skip(self.first);
        for (to, [mean, cosine, sine]) in to.zip(&self.of_columns) {
            *to += mean + cosine * turn.cos() + sine * turn.sin();
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::daily::DailyReadings;
    use super::super::logged::{LoggedOptions, LoggedSeries, LoggedTrend, logged_trend};
    use super::super::tilt::SlopeLimit;
    use super::*;
    use crate::numeric::Random;

    const FIRST: f64 = 18_600.0;

    /// Four years of daily readings: 5.5 + 0.1 a year + a wave, with a standard deviation of 0.02.
    fn made(wave: impl Fn(f64) -> f64, per_c: f64, seed: u64) -> LoggedTrend {
        let mut random = Random::new(5, seed);
        let mut made = LoggedSeries::default();
        for i in 0..1461 {
            let day = FIRST + f64::from(i);
            let celsius = 12.0 - 10.0 * (TAU * day / YEAR_DAYS).cos();
            let of_air = per_c * (celsius - 12.0);
            made.daily.days.push(day);
            made.daily
                .values
                .push(trend(day) + wave(day) + of_air + 0.02 * random.normal());
            if per_c != 0.0 {
                made.temperatures_c.push(celsius + random.normal());
            }
        }
        let all = made.daily.values.len();
        made.daily = DailyReadings {
            readings: all,
            ..made.daily
        };
        let options = LoggedOptions {
            limit: Some(SlopeLimit {
                size: 6.72,
                is_one_sided: false,
            }),
            ..LoggedOptions::default()
        };
        logged_trend(&made, &options).unwrap()
    }

    fn trend(day: f64) -> f64 {
        5.5 + 0.1 * (day - FIRST) / YEAR_DAYS
    }

    /// The first day after the log on which trend and wave reach 6.72, by trying each day.
    fn first_day(wave: impl Fn(f64) -> f64) -> f64 {
        let days = (0..9000).map(|i| FIRST + 1460.0 + f64::from(i));
        days.into_iter()
            .find(|day| trend(*day) + wave(*day) >= 6.72)
            .unwrap()
    }

    #[test]
    fn exact_the_peak_of_the_season_reaches_the_limit_years_before_the_mean_of_the_year() {
        let wave = |day: f64| 0.5 * (TAU * day / YEAR_DAYS - 1.7).sin();
        let found = made(wave, 0.0, 1);
        let reach = found.slope.unwrap().reach.unwrap();
        let day = |years: f64| FIRST + 1460.0 + YEAR_DAYS * years;
        let by_mean = (6.72 - trend(FIRST + 1460.0)) / 0.1;
        let by_peak = first_day(wave);
        assert!(by_mean > 8.0 && by_peak < day(4.1), "{by_mean} {by_peak}");
        assert!(
            (day(reach.years.unwrap()) - by_peak).abs() < 20.0,
            "{reach:?} {by_peak}"
        );
        assert!(
            day(reach.years_earliest.unwrap()) < by_peak && by_peak < day(reach.years_latest.unwrap()),
            "{reach:?} {by_peak}"
        );
        let yearly = found.yearly.unwrap();
        assert!((yearly.at(by_peak) - wave(by_peak)).abs() < 0.01, "{yearly:?}");
    }

    #[test]
    fn exact_what_temperature_does_over_a_year_counts_with_the_season() {
        // half of the wave comes with the temperature of the air
        let air = |day: f64| -0.3 * (TAU * day / YEAR_DAYS).cos();
        let own = |day: f64| -0.2 * (TAU * day / YEAR_DAYS).cos();
        let found = made(own, 0.03, 2);
        let reach = found.slope.unwrap().reach.unwrap();
        let truth = first_day(|day| air(day) + own(day));
        let by_mean = (6.72 - trend(FIRST + 1460.0)) / 0.1;
        let day = FIRST + 1460.0 + YEAR_DAYS * reach.years.unwrap();
        assert!((day - truth).abs() < 30.0 && by_mean > 8.0, "{reach:?} {truth}");
    }

    #[test]
    fn holds_a_log_without_a_season_is_forecast_by_its_slope_alone() {
        let mut counted = 0;
        for seed in 0..20 {
            let found = made(|_| 0.0, 0.0, 100 + seed);
            counted += usize::from(found.yearly.is_some());
            let slope = found.slope.unwrap();
            let reach = slope.reach.unwrap();
            if found.yearly.is_none() {
                let straight = (reach.limit - slope.now) / slope.per_year;
                assert!((reach.years.unwrap() - straight).abs() < 1e-9, "{reach:?}");
            }
        }
        assert!(counted <= 2, "{counted}"); // 1 % meant
    }
}
