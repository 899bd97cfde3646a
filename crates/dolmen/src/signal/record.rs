//! A record: samples of all channels at one rate, with sensor positions and processing history.

use super::SignalError;
use super::processing::Processing;
use crate::numeric::sum_of;

/// Largest sample: no instrument gives more in any unit, and sums of squares below it stay finite. Our choice.
const SAMPLE_MOST: f64 = 1e100;

/// Measured quantity of a channel. Samples are in its SI unit (m/s², m/s, m), or in counts if the unit is unknown.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// m/s².
    Acceleration,
    /// m/s.
    Velocity,
    /// m.
    Displacement,
    /// The unit was not given: frequencies and mode shapes are meaningful, amplitudes are not.
    Unknown,
}

/// One channel: name, measured quantity, position and direction of its sensor.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name, unique in its record.
    pub name: String,
    /// Measured quantity.
    pub quantity: Quantity,
    /// Place of the sensor, m: x right, y away, z up. `None` if not given.
    pub position_m: Option<[f64; 3]>,
    /// Unit vector of the positive direction. `None` if not given.
    pub direction: Option<[f64; 3]>,
}

impl Channel {
    /// A channel with a name only.
    pub fn named(name: impl Into<String>) -> Self {
        Channel {
            name: name.into(),
            quantity: Quantity::Unknown,
            position_m: None,
            direction: None,
        }
    }
}

/// Channels × samples at one sampling rate, all finite.
#[derive(Clone, Debug, PartialEq)]
pub struct Record {
    channels: Vec<Channel>,
    samples: Vec<f64>, // channel after channel
    length: usize,
    sampling_rate_hz: f64,
    history: Vec<Processing>,
}

impl Record {
    /// Makes a record from one vector of samples for each channel.
    ///
    /// # Errors
    /// [`SignalError::Empty`], [`SignalError::Ragged`], [`SignalError::SameName`], [`SignalError::SamplingRate`],
    /// [`SignalError::NotFinite`], [`SignalError::TooLarge`].
    pub fn new(
        channels: Vec<Channel>,
        samples: Vec<Vec<f64>>,
        sampling_rate_hz: f64,
    ) -> Result<Self, SignalError> {
        let first = samples.first().map_or(0, Vec::len);
        if channels.len() != samples.len() {
            return Err(SignalError::ChannelCount {
                channels: channels.len(),
                series: samples.len(),
            });
        }
        if let Some((channel, odd)) = channels.iter().zip(&samples).find(|(_, s)| s.len() != first) {
            return Err(SignalError::Ragged {
                channel: channel.name.clone(),
                samples: odd.len(),
                first,
            });
        }
        Self::from_contiguous(channels, samples.concat(), sampling_rate_hz)
    }

    /// Makes a record from one vector that holds all samples of the first channel, then of the second, and so on.
    ///
    /// # Errors
    /// As [`Record::new`].
    pub fn from_contiguous(
        channels: Vec<Channel>,
        samples: Vec<f64>,
        sampling_rate_hz: f64,
    ) -> Result<Self, SignalError> {
        let length = samples.len().checked_div(channels.len()).unwrap_or(0);
        if length < 2 || length * channels.len() != samples.len() {
            return Err(SignalError::Empty {
                channels: channels.len(),
                samples: length,
            });
        }
        for (j, channel) in channels.iter().enumerate() {
            if let Some(i) = channels[..j].iter().position(|c| c.name == channel.name) {
                return Err(SignalError::SameName {
                    name: channel.name.clone(),
                    first: i + 1,
                    second: j + 1,
                });
            }
        }
        if !(sampling_rate_hz > 0.0 && sampling_rate_hz.is_finite()) {
            return Err(SignalError::SamplingRate {
                given: sampling_rate_hz,
            });
        }
        if let Some(at) = samples.iter().position(|x| x.is_nan() || x.abs() > SAMPLE_MOST) {
            let (channel, sample, value) = (channels[at / length].name.clone(), at % length, samples[at]);
            let time_s = sample as f64 / sampling_rate_hz;
            return Err(if value.is_finite() {
                SignalError::TooLarge {
                    channel,
                    sample,
                    time_s,
                    value,
                    most: SAMPLE_MOST,
                }
            } else {
                SignalError::NotFinite {
                    channel,
                    sample,
                    time_s,
                    value,
                }
            });
        }
        Ok(Record {
            channels,
            samples,
            length,
            sampling_rate_hz,
            history: Vec::new(),
        })
    }

    /// The channels, in order.
    pub fn channels(&self) -> &[Channel] {
        &self.channels
    }

    /// Samples of one channel, in time order.
    pub fn samples(&self, channel: usize) -> &[f64] {
        &self.samples[channel * self.length..(channel + 1) * self.length]
    }

    /// Mean of the samples of one channel.
    pub fn mean(&self, channel: usize) -> f64 {
        sum_of(self.samples(channel), |x| x) / self.length as f64
    }

    /// Mean square of the samples of one channel about their mean.
    pub fn mean_square(&self, channel: usize) -> f64 {
        let mean = self.mean(channel);
        sum_of(self.samples(channel), |x| (x - mean) * (x - mean)) / self.length as f64
    }

    /// Number of samples a channel.
    pub fn length(&self) -> usize {
        self.length
    }

    /// Sampling rate, Hz.
    pub fn sampling_rate_hz(&self) -> f64 {
        self.sampling_rate_hz
    }

    /// Duration, s: samples / rate.
    pub fn duration_s(&self) -> f64 {
        self.length as f64 / self.sampling_rate_hz
    }

    /// Processing history since the measurement, oldest step first.
    pub fn history(&self) -> &[Processing] {
        &self.history
    }

    /// Adds a step to the history. A reader adds [`Processing::Read`] first; functions of this crate that condition a record add their own
    /// step.
    pub fn note(&mut self, step: Processing) {
        self.history.push(step);
    }

    /// Samples of one channel, to be changed in place.
    pub(super) fn samples_mut(&mut self, channel: usize) -> &mut [f64] {
        &mut self.samples[channel * self.length..(channel + 1) * self.length]
    }

    /// Keeps the channels for which `keep` is true, without new memory.
    pub(super) fn retain_channels(&mut self, keep: impl Fn(&Channel) -> bool) {
        let mut kept = 0;
        for channel in 0..self.channels.len() {
            if keep(&self.channels[channel]) {
                let from = channel * self.length;
                self.samples
                    .copy_within(from..from + self.length, kept * self.length);
                kept += 1;
            }
        }
        self.channels.retain(keep);
        self.samples.truncate(kept * self.length);
        self.samples.shrink_to_fit();
    }

    /// Keeps `length` samples `start`, `start + step`, … of each channel, without new memory.
    pub(super) fn retain_samples(&mut self, start: usize, step: usize, length: usize) {
        let mut kept = 0; // never ahead of `from`: samples are read before they are overwritten
        for channel in 0..self.channels.len() {
            let from = channel * self.length + start;
            for i in 0..length {
                self.samples[kept] = self.samples[from + i * step];
                kept += 1;
            }
        }
        self.samples.truncate(kept);
        self.samples.shrink_to_fit();
        self.length = length;
        self.sampling_rate_hz /= step as f64;
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn named(names: &[&str]) -> Vec<Channel> {
        names.iter().map(|&n| Channel::named(n)).collect()
    }

    #[test]
    fn refuses_a_sample_that_is_not_a_number_and_says_where() {
        let fault = Record::new(
            named(&["a", "b"]),
            vec![vec![0.0; 4], vec![0.0, 1.0, f64::NAN, 2.0]],
            10.0,
        );
        assert_eq!(
            fault.unwrap_err().to_string(),
            "channel \"b\" holds NaN at sample 2 (t = 0.2 s): cut the record before or after it, or leave the \
             channel out"
        );
    }

    #[test]
    fn refuses_a_sample_no_instrument_yields() {
        let fault = Record::new(named(&["a"]), vec![vec![0.0, -1e300]], 10.0).unwrap_err();
        assert!(
            fault.to_string().starts_with("channel \"a\" holds -1")
                && fault.to_string().contains("over-range"),
            "{fault}"
        );
    }

    #[test]
    fn refuses_channels_that_do_not_match() {
        let message = |channels: &[&str], samples: Vec<Vec<f64>>| {
            Record::new(named(channels), samples, 10.0)
                .unwrap_err()
                .to_string()
        };
        assert_eq!(
            message(&["a", "b"], vec![vec![0.0; 4], vec![0.0; 3]]),
            "channel \"b\" has 3 samples, but the first has 4: all channels of one record share their time stamps"
        );
        assert_eq!(
            message(&["a", "b", "a"], vec![vec![0.0; 4]; 3]),
            "channels 1 and 3 (counted from 1) are both named \"a\": give each its own name"
        );
        assert_eq!(
            message(&["a", "b"], vec![vec![0.0; 4]; 3]),
            "2 channels are described, but 3 series of samples are given: give one description to each"
        );
        assert_eq!(
            message(&[], vec![]),
            "the record has 0 channels of 0 samples, but must have at least 1 of 2"
        );
    }

    #[test]
    fn refuses_a_sampling_rate_that_is_not_positive() {
        for given in [0.0, -1.0, f64::NAN, f64::INFINITY] {
            let fault = Record::new(named(&["a"]), vec![vec![0.0; 4]], given).unwrap_err();
            assert_eq!(
                fault.to_string(),
                format!("sampling_rate_hz is {given}, but must be a positive number")
            );
        }
    }
}
