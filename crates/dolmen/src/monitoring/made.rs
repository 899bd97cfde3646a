//! Simulated histories with known truth.

use super::history::{History, HistorySurvey};
use crate::modal::{ObservedMode, ObservedPoint};
use crate::numeric::Random;
use crate::signal::Channel;
use std::f64::consts::TAU;

/// Description of a simulated history: modes that depend on temperature, with reading noise and a disturbance.
#[derive(Clone, Debug, PartialEq)]
pub struct MadeHistory {
    /// Number of surveys.
    pub surveys: usize,
    /// Days between two surveys.
    pub interval_days: f64,
    /// Frequencies at the mean temperature, Hz.
    pub frequencies_hz: Vec<f64>,
    /// Relative change per °C.
    pub per_c: f64,
    /// Relative standard deviation of the readings, which is also the stated one.
    pub noise: f64,
    /// Standard deviation of the disturbance.
    pub disturbance: f64,
    /// Correlation of the disturbance between successive surveys.
    pub correlation: f64,
    /// Half the difference of summer and winter, °C.
    pub seasons_c: f64,
    /// Warming, °C per year.
    pub warming_c: f64,
    /// A step of all modes: its first survey, and the frequency ratio.
    pub step: Option<(usize, f64)>,
    /// Seed.
    pub seed: u64,
}

impl Default for MadeHistory {
    fn default() -> Self {
        MadeHistory {
            surveys: 60,
            interval_days: 30.0,
            frequencies_hz: vec![2.1, 3.4, 6.8],
            per_c: -0.001,
            noise: 0.0012,
            disturbance: 0.001,
            correlation: 0.3,
            seasons_c: 12.0,
            warming_c: 0.0,
            step: None,
            seed: 1,
        }
    }
}

/// Simulated mode shapes: those of a cantilever column with four sensors.
fn shape(mode: usize, random: &mut Random) -> Vec<ObservedPoint> {
    let points = (1..=4).map(|place| {
        let turn = (2 * mode + 1) as f64 * 0.25 * TAU * f64::from(place) / 4.0;
        let name = format!("a{place}");
        ObservedPoint::real(Channel::named(name), turn.sin() + 0.03 * random.normal())
    });
    points.collect()
}

/// Simulates the history.
pub fn made_history(of: &MadeHistory) -> History {
    let mut random = Random::new(of.seed, 0);
    let all = of.disturbance;
    let mut states: Vec<f64> = of.frequencies_hz.iter().map(|_| all * random.normal()).collect();
    let mut surveys = Vec::with_capacity(of.surveys);
    for i in 0..of.surveys {
        let day = 30.0 + of.interval_days * i as f64;
        let season = -of.seasons_c * (TAU * day / 365.25).cos();
        let off_c = season + 3.0 * random.normal() + of.warming_c * day / 365.25;
        let mut modes = Vec::new();
        for (mode, frequency_hz) in of.frequencies_hz.iter().enumerate() {
            if i > 0 {
                let fresh = all * (1.0 - of.correlation * of.correlation).sqrt();
                states[mode] = of.correlation * states[mode] + fresh * random.normal();
            }
            let step = of
                .step
                .filter(|(from, _)| i >= *from)
                .map_or(0.0, |(_, ratio)| ratio);
            let off = of.per_c * off_c + states[mode] + of.noise * random.normal();
            modes.push(ObservedMode {
                frequency_hz: frequency_hz * (1.0 + step) * (1.0 + off),
                frequency_sd_hz: Some(of.noise * frequency_hz),
                damping_ratio: None,
                damping_ratio_sd: None,
                degrees_of_freedom: f64::INFINITY,
                direction: None,
                accepted: false,
                shape: shape(mode, &mut random),
            });
        }
        surveys.push(HistorySurvey {
            name: format!("{i}"),
            day,
            temperature_c: Some(12.0 + off_c),
            modes,
            tilts: Vec::new(),
        });
    }
    History {
        surveys,
        works: Vec::new(),
    }
}
