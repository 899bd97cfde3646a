//! The difference between two surveys of a history.
//!
//! ```text
//! f_j − f_i = weather + change + e_j − e_i,   Var(e_j − e_i) = σ_i² + σ_j² + 2 s² (1 − φ^|t_j − t_i|)
//! ```

use super::regression::Fit;
use super::watch::Watched;
use super::watched_mode::WatchedMode;
use crate::assess::HistoryEffect;

impl Watched {
    /// For each fitted mode in both surveys: the effect of weather on the difference of its frequencies, and the scatter of this
    /// difference. The weather coefficient, its standard deviation and the scatter come from all surveys, and were estimated together with
    /// all lasting changes. An isolated survey, which the fit leaves out, has the weather of the fit.
    ///
    /// Tests: `holds_two_surveys_differ_by_chance_as_stated` of `tests/validation/watched_pairs.rs`.
    pub fn between(&self, from: usize, to: usize) -> Vec<HistoryEffect> {
        self.modes
            .iter()
            .filter_map(|mode| mode.between(from, to))
            .collect()
    }

    /// Frequencies in both surveys, Hz, of the fitted modes without an effect in [`Watched::between`]: the weather of one of the two
    /// surveys is not known.
    pub fn undecided_between(&self, from: usize, to: usize) -> Vec<[f64; 2]> {
        self.modes
            .iter()
            .filter_map(|mode| mode.undecided_between(from, to))
            .collect()
    }

    /// Whether the weather of a survey is known in every fitted mode that it shows, so that it can be compared with others.
    pub fn is_weather_known(&self, survey: usize) -> bool {
        let fitted = self.modes.iter().filter_map(|mode| mode.fitted.as_ref());
        let mut readings = fitted.filter_map(|of| of.reading(survey));
        readings.all(|of| of.weather.is_some())
    }
}

impl WatchedMode {
    fn undecided_between(&self, from: usize, to: usize) -> Option<[f64; 2]> {
        let of = self.fitted.as_ref()?;
        let both = [of.reading(from)?, of.reading(to)?];
        let is_undecided = both.iter().any(|of| of.weather.is_none());
        is_undecided.then(|| both.map(|of| self.track.frequency_hz * (1.0 + of.reading)))
    }

    fn between(&self, from: usize, to: usize) -> Option<HistoryEffect> {
        let (of, weather) = (self.fitted.as_ref()?, self.weather.as_ref()?);
        let both = [of.reading(from)?, of.reading(to)?];
        let [Some(row_from), Some(row_to)] = [&both[0].weather, &both[1].weather] else {
            return None;
        };
        let fit = Fit::new(&of.series, &of.columns, of.disturbance)?;
        let mut step: Vec<f64> = row_to.iter().zip(row_from).map(|(to, from)| to - from).collect();
        step.resize(of.columns.len(), 0.0);
        let explained: f64 = step.iter().zip(&fit.coefficients).map(|(x, beta)| x * beta).sum();
        let apart = (both[1].at - both[0].at).abs();
        let kept = of.disturbance.correlation.powf(apart);
        let variance = 2.0 * of.disturbance.sd.powi(2) * (1.0 - kept) + fit.form(&mut step);
        let [before, after] = [0, 1].map(|k| 1.0 + both[k].reading);
        let hz = self.track.frequency_hz;
        Some(HistoryEffect {
            from_hz: hz * before,
            to_hz: hz * after,
            surveys: of.surveys.len(),
            explained: explained / before,
            knows_temperature: weather.per_c.is_some(),
            per_c: weather.per_c,
            disturbance_sd: of.disturbance.sd,
            scatter_sd: variance.sqrt() / before,
            degrees_of_freedom: of.surveys.len().saturating_sub(of.columns.len()).max(1) as f64,
            reading_sds_hz: [0, 1].map(|k| hz * both[k].noise_sd),
        })
    }
}
