//! Peak values of each channel in an earthquake.

use super::losses::{AtLeast, Losses};
use super::part::Part;
use super::shaking::Shaking;
use crate::signal::{
    Component, GroundMotion, Quantity, Record, SpectralOrdinate, band_pass, intensity_measures,
    peak_velocity_m_s, response_spectrum,
};

/// Possible lower corners of the velocity band, Hz; the first whose filter fits the record is used. Then the order of the filter.
const LOW_HZ: [f64; 4] = [0.1, 0.2, 0.5, 1.0];
const HIGH_OF_RATE: f64 = 0.4;
const ORDER: usize = 4;
/// Time before the arrival at which the measures start, s.
const LEAD_S: f64 = 2.0;
/// Time before the arrival at which the integration to velocity starts, s: longer than the transient of the filter.
const RUN_UP_S: f64 = 30.0;
/// Share of its largest value in the record above which a clipped channel is at the end of its range in an earthquake.
const NEAR_RANGE: f64 = 0.9;
/// Periods of the response spectrum, s, and its damping ratio.
const PERIODS_S: [f64; 2] = [0.05, 4.0];
const PERIODS: usize = 80;
const DAMPING: f64 = 0.05;

/// Peak values of a channel in an earthquake; `None` if its unit or the record does not give them.
#[derive(Clone, Debug, PartialEq)]
pub struct StrongChannel {
    /// Name of the channel.
    pub name: String,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Largest distance from the mean of this part, in the unit of the channel.
    pub peak: f64,
    /// Time of the peak, s from the first sample of the record.
    pub peak_at_s: f64,
    /// Why the peak and the following measures may be too small; `None` if the channel contains the whole earthquake.
    pub at_least: Option<AtLeast>,
    /// Root mean square in the quiet part before the earthquake, or otherwise after it.
    pub noise: f64,
    /// Largest acceleration, m/s².
    pub peak_acceleration_m_s2: Option<f64>,
    /// Largest velocity within the band, m/s.
    pub peak_velocity_m_s: Option<f64>,
    /// Frequency band of that velocity, Hz.
    pub velocity_band_hz: Option<[f64; 2]>,
    /// Arias intensity, m/s.
    pub arias_intensity_m_s: Option<f64>,
    /// Pseudo-acceleration of an oscillator at the place of the sensor, with 5 % damping, over periods. Empty unless the sensor measures
    /// acceleration.
    pub spectrum: Vec<SpectralOrdinate>,
}

pub(super) struct Strength<'a> {
    record: &'a Record,
    shakings: &'a [Shaking],
    quiet: &'a [Part],
    losses: &'a Losses,
    /// The record filtered to the band of the peak velocity, and this band, Hz.
    band: Option<(Record, [f64; 2])>,
}

impl<'a> Strength<'a> {
    pub(super) fn of(
        record: &'a Record,
        shakings: &'a [Shaking],
        quiet: &'a [Part],
        losses: &'a Losses,
    ) -> Self {
        let band = LOW_HZ.iter().find_map(|low_hz| {
            let high_hz = HIGH_OF_RATE * record.sampling_rate_hz();
            let passed = band_pass(record.clone(), *low_hz, high_hz, ORDER).ok()?;
            Some((passed, [*low_hz, high_hz]))
        });
        Strength {
            record,
            shakings,
            quiet,
            losses,
            band,
        }
    }

    /// Peak values of each channel in one of the earthquakes.
    pub(super) fn channels(&self, event: usize) -> Vec<StrongChannel> {
        let each = (0..self.record.channels().len()).map(|at| StrongChannel {
            at_least: self.at_least(event, at),
            ..channel(self, event, at)
        });
        each.collect()
    }

    /// Samples of a quiet part next to an earthquake, preferably before it; the whole channel if both parts are shorter than a second.
    fn still(&self, event: usize, at: usize) -> &[f64] {
        let rate_hz = self.record.sampling_rate_hz();
        let samples = self.record.samples(at);
        let beside = self.quiet.iter().skip(event).take(2);
        let long = beside
            .map(|part| part.span_s)
            .find(|[from_s, to_s]| to_s - from_s > 1.0);
        let [from, to] = long
            .unwrap_or([0.0, self.record.duration_s()])
            .map(|at_s| ((at_s * rate_hz) as usize).min(samples.len()));
        &samples[from..to]
    }

    fn span(&self, event: usize) -> [usize; 2] {
        let shaking = &self.shakings[event];
        let rate_hz = self.record.sampling_rate_hz();
        [(shaking.arrival_s - LEAD_S).max(0.0), shaking.end_s]
            .map(|at_s| ((at_s * rate_hz) as usize).min(self.record.length()))
    }

    /// Largest distance of a channel from its mean in an earthquake.
    fn largest(&self, event: usize, at: usize) -> f64 {
        let still = self.still(event, at);
        let mean = still.iter().sum::<f64>() / still.len() as f64;
        let [from, to] = self.span(event);
        let each = self.record.samples(at)[from..to].iter().map(|x| (x - mean).abs());
        each.fold(0.0, f64::max)
    }

    /// Why the true peak of a channel may have been larger.
    fn at_least(&self, event: usize, at: usize) -> Option<AtLeast> {
        let shaking = &self.shakings[event];
        let name = &self.record.channels()[at].name;
        let near = |other: usize| self.largest(event, at) >= NEAR_RANGE * self.largest(other, at);
        if self.losses.clipped.contains(name) && (0..self.shakings.len()).all(near) {
            return Some(AtLeast::Clipped);
        }
        if self.losses.is_lost([shaking.arrival_s - LEAD_S, shaking.end_s]) {
            return Some(AtLeast::Lost);
        }
        let begins_in_it = shaking.arrival_s <= 0.0;
        let ends_in_it = !shaking.ends;
        (begins_in_it || ends_in_it).then_some(AtLeast::Edge)
    }
}

fn channel(of_record: &Strength<'_>, event: usize, at: usize) -> StrongChannel {
    let Strength { record, band, .. } = of_record;
    let rate_hz = record.sampling_rate_hz();
    let of = &record.channels()[at];
    let samples = record.samples(at);
    let still = of_record.still(event, at);
    let mean = still.iter().sum::<f64>() / still.len() as f64;
    let noise = (still.iter().map(|x| (x - mean).powi(2)).sum::<f64>() / still.len() as f64).sqrt();
    let [from, to] = of_record.span(event);
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
    let within = band
        .as_ref()
        .filter(|_| is_acceleration)
        .and_then(|(passed, band_hz)| {
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
        at_least: None,
        noise,
        peak_acceleration_m_s2: is_acceleration.then_some(peak),
        peak_velocity_m_s: within.map(|(peak, _)| peak),
        velocity_band_hz: within.map(|(_, band_hz)| band_hz),
        arias_intensity_m_s: measures.map(|of| of.arias_intensity_m_s),
        spectrum: spectrum.unwrap_or_default(),
    }
}
