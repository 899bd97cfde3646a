//! The readings of a mode with the explanatory columns, those in the fit and those beside it.

use super::series::Series;
use super::weather::{ModeSeries, WeatherKnown, explaining};
use super::whitening::Disturbance;

/// The readings of a mode with the explanatory columns.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FittedMode {
    pub(super) series: Series,
    /// Columns of level and weather, then of works and changes.
    pub(super) columns: Vec<Vec<f64>>,
    /// Number of the columns for level and weather.
    pub(super) of_weather: usize,
    pub(super) disturbance: Disturbance,
    /// Index of each reading's survey.
    pub(super) surveys: Vec<usize>,
    /// Readings that the fit leaves out.
    pub(super) beside: Vec<FittedReading>,
}

/// One reading of a mode.
#[derive(Clone, Debug, PartialEq)]
pub(super) struct FittedReading {
    pub(super) survey: usize,
    /// Time, in the unit of the series.
    pub(super) at: f64,
    /// Relative to the median frequency.
    pub(super) reading: f64,
    pub(super) noise_sd: f64,
    /// Level and weather; `None` where the fit has no information on the weather of this survey.
    pub(super) weather: Option<Vec<f64>>,
}

impl FittedReading {
    /// A reading that the fit leaves out: isolated (with its weather), or at a temperature that the fit does not cover.
    pub(super) fn beside(
        series: &ModeSeries,
        i: usize,
        weather: Option<(WeatherKnown, (f64, f64))>,
    ) -> FittedReading {
        FittedReading {
            survey: series.surveys[i],
            at: series.series.at[i],
            reading: series.series.readings[i],
            noise_sd: series.series.noise_sd[i],
            weather: weather
                .map(|(known, at)| explaining(known, (series.days[i], series.temperatures_c[i]), at))
                .filter(|row| row.iter().all(|x| x.is_finite())),
        }
    }
}

impl FittedMode {
    /// The reading of a survey, in the fit or beside it.
    pub(super) fn reading(&self, survey: usize) -> Option<FittedReading> {
        let own = self.surveys.iter().position(|own| *own == survey);
        let in_fit = own.map(|i| FittedReading {
            survey,
            at: self.series.at[i],
            reading: self.series.readings[i],
            noise_sd: self.series.noise_sd[i],
            weather: Some(
                self.columns[..self.of_weather]
                    .iter()
                    .map(|column| column[i])
                    .collect(),
            ),
        });
        in_fit.or_else(|| self.beside.iter().find(|of| of.survey == survey).cloned())
    }
}
