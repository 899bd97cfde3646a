//! What each channel measured in an earthquake.

use super::shaking::Shaking;
use crate::signal::{
    Component, GroundMotion, Quantity, Record, SpectralOrdinate, band_pass, cut, intensity_measures,
    peak_velocity_m_s, response_spectrum,
};

/// Low corners of the band of the peak velocity, Hz: the first whose filter fits the record; and the order.
const LOW_HZ: [f64; 4] = [0.1, 0.2, 0.5, 1.0];
const HIGH_OF_RATE: f64 = 0.4;
const ORDER: usize = 4;
/// Seconds before the arrival that the measures begin with.
const LEAD_S: f64 = 2.0;
/// Seconds before it from which the velocity is integrated: longer than the filter rings.
const RUN_UP_S: f64 = 30.0;
/// Periods of the response spectrum, s, and its damping ratio.
const PERIODS_S: [f64; 2] = [0.05, 4.0];
const PERIODS: usize = 80;
const DAMPING: f64 = 0.05;

/// What a channel measured in an earthquake; `None` for what its unit or the record does not give.
#[derive(Clone, Debug, PartialEq)]
pub struct StrongChannel {
    /// Its name.
    pub name: String,
    /// What it measures.
    pub quantity: Quantity,
    /// Largest distance from the mean before the arrival, in its unit.
    pub peak: f64,
    /// When that is, s from the first sample of the record.
    pub peak_at_s: f64,
    /// Root mean square before the arrival.
    pub noise: f64,
    /// Largest acceleration, m/s².
    pub peak_acceleration_m_s2: Option<f64>,
    /// Largest velocity within the band, m/s.
    pub peak_velocity_m_s: Option<f64>,
    /// Band of that velocity, Hz.
    pub velocity_band_hz: Option<[f64; 2]>,
    /// Arias intensity, m/s.
    pub arias_intensity_m_s: Option<f64>,
    /// Pseudo-acceleration at 5 % damping over periods: what an oscillator standing where the sensor stands would feel. Empty unless it measures
    /// acceleration.
    pub spectrum: Vec<SpectralOrdinate>,
}

/// What each channel measured.
pub(super) fn channels(record: &Record, shaking: &Shaking) -> Vec<StrongChannel> {
    let band = LOW_HZ.iter().find_map(|low_hz| {
        let high_hz = HIGH_OF_RATE * record.sampling_rate_hz();
        let passed = band_pass(record.clone(), *low_hz, high_hz, ORDER).ok()?;
        Some((passed, [*low_hz, high_hz]))
    });
    (0..record.channels().len())
        .map(|c| channel(record, band.as_ref(), c, shaking))
        .collect()
}

fn channel(
    record: &Record,
    band: Option<&(Record, [f64; 2])>,
    at: usize,
    shaking: &Shaking,
) -> StrongChannel {
    let rate_hz = record.sampling_rate_hz();
    let of = &record.channels()[at];
    let samples = record.samples(at);
    let arrival = ((shaking.arrival_s - 1.0).max(0.0) * rate_hz) as usize;
    let still = match arrival as f64 > rate_hz {
        true => &samples[..arrival],
        false => samples,
    };
    let mean = still.iter().sum::<f64>() / still.len() as f64;
    let noise = (still.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / still.len() as f64).sqrt();
    let [from, to] = [(shaking.arrival_s - LEAD_S).max(0.0), shaking.end_s]
        .map(|at_s| ((at_s * rate_hz) as usize).min(samples.len()));
    let each = samples[from..to].iter().map(|x| (x - mean).abs()).enumerate();
    let (largest, peak) = each.fold((0, 0.0), |most, one| if one.1 > most.1 { one } else { most });
    let is_acceleration = of.quantity == Quantity::Acceleration;
    let motion = |samples: &[f64], mean: f64| {
        let moved = samples.iter().map(|x| x - mean).collect();
        GroundMotion::new(of.name.clone(), 1.0 / rate_hz, vec![(Component::X, moved)]).ok()
    };
    let own = motion(&samples[from..to], mean).filter(|_| is_acceleration);
    let measures = own
        .as_ref()
        .and_then(|of| intensity_measures(of, Component::X).ok());
    let within = band.filter(|_| is_acceleration).and_then(|(passed, band_hz)| {
        let begins = from.saturating_sub((RUN_UP_S * rate_hz) as usize);
        let passed = motion(&passed.samples(at)[begins..to], 0.0)?;
        Some((peak_velocity_m_s(&passed, Component::X).ok()?, *band_hz))
    });
    let within = within.or((of.quantity == Quantity::Velocity).then_some((peak, [0.0, 0.5 * rate_hz])));
    let periods: Vec<f64> = (0..PERIODS)
        .map(|k| PERIODS_S[0] * (PERIODS_S[1] / PERIODS_S[0]).powf(k as f64 / (PERIODS - 1) as f64))
        .collect();
    let spectrum = own.and_then(|of| response_spectrum(&of, Component::X, &periods, DAMPING).ok());
    StrongChannel {
        name: of.name.clone(),
        quantity: of.quantity,
        peak,
        peak_at_s: (from + largest) as f64 / rate_hz,
        noise,
        peak_acceleration_m_s2: is_acceleration.then_some(peak),
        peak_velocity_m_s: within.map(|(peak, _)| peak),
        velocity_band_hz: within.map(|(_, band_hz)| band_hz),
        arias_intensity_m_s: measures.map(|of| of.arias_intensity_m_s),
        spectrum: spectrum.unwrap_or_default(),
    }
}

/// The part of a record, or none of it.
pub(super) fn part_of(record: &Record, [from_s, to_s]: [f64; 2]) -> Option<Record> {
    cut(record.clone(), from_s, to_s).ok()
}
