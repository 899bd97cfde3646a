//! The record: channels × samples at one rate, with where each sensor stands and the history of processing.

use super::SignalError;

/// What a channel measures. Samples are in SI units of it (m/s², m/s, m), or in counts if the unit is not known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Quantity {
    /// m/s².
    Acceleration,
    /// m/s.
    Velocity,
    /// m.
    Displacement,
    /// The unit was not given: amplitudes mean nothing, frequencies and shapes do.
    Unknown,
}

/// One channel: its name, what it measures, and where and which way its sensor stands.
#[derive(Clone, Debug, PartialEq)]
pub struct Channel {
    /// Name, unique in its record.
    pub name: String,
    /// What is measured.
    pub quantity: Quantity,
    /// Place of the sensor, m: x right, y away, z up. `None` if not given.
    pub position_m: Option<[f64; 3]>,
    /// Unit vector of the positive direction. `None` if not given.
    pub direction: Option<[f64; 3]>,
}

impl Channel {
    /// A channel of which only the name is known.
    pub fn named(name: impl Into<String>) -> Self {
        Channel {
            name: name.into(),
            quantity: Quantity::Unknown,
            position_m: None,
            direction: None,
        }
    }
}

/// One thing that was done to a record, in order: its history.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum Processing {
    /// Read from bytes.
    Read {
        /// "csv", "npy".
        format: String,
        /// Unit of the numbers in the file, "" if not given.
        unit: String,
    },
    /// Channels left out, by name.
    LeftOut {
        /// Their names.
        channels: Vec<String>,
    },
    /// Only a part of the time kept.
    Cut {
        /// From, s.
        from_s: f64,
        /// To, s.
        to_s: f64,
    },
    /// A least-squares polynomial removed from each channel.
    Detrend {
        /// 0 mean, 1 straight line.
        degree: usize,
    },
    /// Zero-phase Butterworth low-pass, run forwards and backwards.
    LowPass {
        /// Corner, Hz, where the gain of both passes together is 1/2 (−6 dB).
        corner_hz: f64,
        /// Order of one pass.
        order: usize,
    },
    /// Zero-phase Butterworth band-pass, run forwards and backwards.
    BandPass {
        /// Lower corner, Hz.
        low_hz: f64,
        /// Upper corner, Hz.
        high_hz: f64,
        /// Order of one pass.
        order: usize,
    },
    /// Anti-alias filtered, then each `factor`-th sample kept.
    Decimate {
        /// Samples before / samples after.
        factor: usize,
    },
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
    /// A record from one vector of samples a channel.
    ///
    /// # Errors
    /// [`SignalError::Empty`], [`SignalError::Ragged`], [`SignalError::SamplingRate`], [`SignalError::NotFinite`].
    pub fn new(
        channels: Vec<Channel>,
        samples: Vec<Vec<f64>>,
        sampling_rate_hz: f64,
    ) -> Result<Self, SignalError> {
        let first = samples.first().map_or(0, Vec::len);
        if let Some((channel, odd)) = channels.iter().zip(&samples).find(|(_, s)| s.len() != first) {
            return Err(SignalError::Ragged {
                channel: channel.name.clone(),
                samples: odd.len(),
                first,
            });
        }
        Self::from_contiguous(channels, samples.concat(), sampling_rate_hz)
    }

    /// A record from all samples of the first channel, then all of the second, and so on. Takes the memory over.
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
        if !(sampling_rate_hz > 0.0 && sampling_rate_hz.is_finite()) {
            return Err(SignalError::SamplingRate {
                given: sampling_rate_hz,
            });
        }
        if let Some(at) = samples.iter().position(|x| !x.is_finite()) {
            let sample = at % length;
            return Err(SignalError::NotFinite {
                channel: channels[at / length].name.clone(),
                sample,
                time_s: sample as f64 / sampling_rate_hz,
                value: samples[at],
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

    /// Number of samples a channel.
    pub fn length(&self) -> usize {
        self.length
    }

    /// Samples a second, Hz.
    pub fn sampling_rate_hz(&self) -> f64 {
        self.sampling_rate_hz
    }

    /// Duration, s: samples / rate.
    pub fn duration_s(&self) -> f64 {
        self.length as f64 / self.sampling_rate_hz
    }

    /// What was done to it since it was measured, oldest first.
    pub fn history(&self) -> &[Processing] {
        &self.history
    }
}
