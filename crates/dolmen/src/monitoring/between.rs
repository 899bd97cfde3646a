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
    /// all lasting changes.
    ///
    /// Tests: `holds_two_surveys_differ_by_chance_as_stated` of `tests/validation/watched_pairs.rs`.
    pub fn between(&self, from: usize, to: usize) -> Vec<HistoryEffect> {
        self.modes
            .iter()
            .filter_map(|mode| mode.between(from, to))
            .collect()
    }
}

impl WatchedMode {
    fn between(&self, from: usize, to: usize) -> Option<HistoryEffect> {
        let (of, weather) = (self.fitted.as_ref()?, self.weather.as_ref()?);
        let reading = |survey: usize| of.surveys.iter().position(|own| *own == survey);
        let (i, j) = (reading(from)?, reading(to)?);
        let fit = Fit::new(&of.series, &of.columns, of.disturbance)?;
        let mut step: Vec<f64> = of.columns.iter().map(|column| column[j] - column[i]).collect();
        step[of.of_weather..].fill(0.0);
        let explained: f64 = step.iter().zip(&fit.coefficients).map(|(x, beta)| x * beta).sum();
        let apart = (of.series.at[j] - of.series.at[i]).abs();
        let kept = of.disturbance.correlation.powf(apart);
        let variance = 2.0 * of.disturbance.sd.powi(2) * (1.0 - kept) + fit.form(&mut step);
        let [before, after] = [i, j].map(|k| 1.0 + of.series.readings[k]);
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
            reading_sds_hz: [i, j].map(|k| hz * of.series.noise_sd[k]),
        })
    }
}
