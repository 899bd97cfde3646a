//! The record: channels × samples at one rate, with where each sensor stands and the history of processing.

use super::SignalError;

/// No instrument yields more in any unit, and the sum of squares of any record within it is finite. Chosen here.
const SAMPLE_MOST: f64 = 1e100;

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
    /// Zero-phase Butterworth high-pass, run forwards and backwards.
    HighPass {
        /// Corner, Hz, where the gain of both passes together is 1/2 (−6 dB).
        corner_hz: f64,
        /// Order of one pass.
        order: usize,
    },
    /// Scaled, and wavelets added, until a response spectrum was that of a target.
    Matched {
        /// The component: "x", "y", "z".
        component: &'static str,
        /// Damping ratio of the spectrum.
        damping_ratio: f64,
        /// Shortest period, s.
        period_least_s: f64,
        /// Longest period, s.
        period_most_s: f64,
    },
    /// All samples multiplied by one factor.
    Scaled {
        /// The factor.
        factor: f64,
    },
    /// Brought to zero at both ends by half a cosine.
    Tapered {
        /// Length of each taper, s.
        each_end_s: f64,
    },
    /// The horizontal components turned about the vertical.
    Rotated {
        /// From x towards y, rad.
        angle_rad: f64,
    },
    /// Anti-alias filtered, then each `factor`-th sample kept.
    Decimate {
        /// Samples before / samples after.
        factor: usize,
    },
    /// Samples of one channel multiplied by a factor, as what a count of its recorder is worth.
    ChannelScaled {
        /// The channel.
        channel: String,
        /// The factor.
        factor: f64,
    },
    /// A channel interpolated onto the times of the others.
    Interpolated {
        /// The channel.
        channel: String,
        /// Where its samples lay, steps after those of the others.
        offset_steps: f64,
    },
    /// A channel taken to a lower rate, anti-alias filtered.
    Resampled {
        /// The channel.
        channel: String,
        /// Its rate before, Hz.
        from_hz: f64,
        /// Its rate after, Hz.
        to_hz: f64,
    },
    /// Offsets between the times of channels that were left as they are.
    OffsetsLeft {
        /// The largest, steps.
        most_steps: f64,
    },
    /// Only the longest time kept that no lost samples interrupt, in any channel.
    LongestSpan {
        /// First sample kept, s from the first of the file.
        from_s: f64,
        /// Last sample kept, s.
        to_s: f64,
        /// Last sample of the file, s.
        whole_s: f64,
        /// What is lost, by time.
        gaps: Vec<LostSpan>,
    },
    /// Short runs of lost samples filled in by linear prediction.
    FilledGaps {
        /// Where, by time.
        gaps: Vec<LostSpan>,
        /// Samples filled in, of all channels in which they were lost.
        samples: usize,
        /// Their share of those channels.
        share: f64,
    },
    /// Only the time kept that all channels share.
    CommonTime {
        /// From the first sample of any channel to the first kept, s.
        before_s: f64,
        /// From the last kept to the last of any channel, s.
        after_s: f64,
    },
}

/// Samples that a record lost.
#[derive(Clone, Debug, PartialEq)]
pub struct LostSpan {
    /// The channel; `None`: all.
    pub channel: Option<String>,
    /// The last sample before, s from the first of the record.
    pub at_s: f64,
    /// Time lost, s.
    pub lost_s: f64,
}

impl LostSpan {
    /// How many are named where a record lost many: a list of hundreds would hide the rest.
    pub const NAMED_MOST: usize = 3;
}

impl std::fmt::Display for LostSpan {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        write!(f, "{:.3} s after {:.3} s", self.lost_s, self.at_s)?;
        self.channel
            .as_ref()
            .map_or(Ok(()), |channel| write!(f, " ({channel})"))
    }
}

/// The first gaps, and how many more there are.
fn first_gaps(gaps: &[LostSpan]) -> String {
    let shown = gaps.iter().take(LostSpan::NAMED_MOST).map(ToString::to_string);
    let shown: Vec<String> = shown.collect();
    match gaps.len().saturating_sub(LostSpan::NAMED_MOST) {
        0 => shown.join(", "),
        more => format!("{} and {more} more", shown.join(", ")),
    }
}

impl std::fmt::Display for Processing {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Processing::Read { format, unit } if unit.is_empty() => {
                write!(f, "read from {format}, unit not given")
            }
            Processing::Read { format, unit } => write!(f, "read from {format}, unit {unit}"),
            Processing::LeftOut { channels } => write!(f, "left out {}", channels.join(", ")),
            Processing::Cut { from_s, to_s } => write!(f, "cut to {from_s} s … {to_s} s"),
            Processing::Detrend { degree: 0 } => write!(f, "mean removed"),
            Processing::Detrend { degree: 1 } => write!(f, "straight line removed"),
            Processing::Detrend { degree } => write!(f, "polynomial of degree {degree} removed"),
            Processing::LowPass { corner_hz, order } => {
                write!(
                    f,
                    "low-pass {corner_hz} Hz, Butterworth of order {order}, zero phase"
                )
            }
            Processing::BandPass {
                low_hz,
                high_hz,
                order,
            } => {
                write!(
                    f,
                    "band-pass {low_hz} to {high_hz} Hz, Butterworth of order {order}, zero phase"
                )
            }
            Processing::HighPass { corner_hz, order } => {
                write!(
                    f,
                    "high-pass {corner_hz} Hz, Butterworth of order {order}, zero phase"
                )
            }
            Processing::Matched {
                component,
                damping_ratio,
                period_least_s,
                period_most_s,
            } => write!(
                f,
                "{component} matched to a spectrum by wavelets, {period_least_s} to {period_most_s} s, damping {} %",
                100.0 * damping_ratio
            ),
            Processing::Decimate { factor } => write!(f, "decimated by {factor}"),
            Processing::ChannelScaled { channel, factor } => write!(f, "{channel} scaled by {factor}"),
            Processing::Interpolated {
                channel,
                offset_steps,
            } => write!(
                f,
                "{channel} interpolated: its samples lay {offset_steps:+.4} of a step beside the times of the others"
            ),
            Processing::Resampled {
                channel,
                from_hz,
                to_hz,
            } => write!(
                f,
                "{channel} resampled from {from_hz} Hz to {to_hz} Hz, anti-alias filtered"
            ),
            Processing::OffsetsLeft { most_steps } => write!(
                f,
                "times of the channels differ by up to {most_steps:.4} of a step, left so"
            ),
            Processing::LongestSpan {
                from_s,
                to_s,
                whole_s,
                gaps,
            } => {
                write!(
                    f,
                    "samples are lost: {}; only the longest whole span is used, {from_s:.3} to {to_s:.3} s: {:.3} of {whole_s:.3} s",
                    first_gaps(gaps),
                    to_s - from_s
                )
            }
            Processing::FilledGaps { gaps, samples, share } => write!(
                f,
                "lost samples filled in by linear prediction: {samples} ({:.3} %), {}",
                100.0 * share,
                first_gaps(gaps)
            ),
            Processing::CommonTime { before_s, after_s } => write!(
                f,
                "cut to the time that all channels share: {before_s:.3} s before it and {after_s:.3} s after it are gone"
            ),
            Processing::Scaled { factor } => write!(f, "scaled by {factor}"),
            Processing::Tapered { each_end_s } => {
                write!(f, "tapered by half a cosine, {each_end_s} s at each end")
            }
            Processing::Rotated { angle_rad } => {
                write!(f, "turned by {:.6}° from x towards y", angle_rad.to_degrees())
            }
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
    /// A record from one vector of samples a channel.
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

    /// Writes a step into the history. Readers begin it with [`Processing::Read`]; what conditions a record in this
    /// crate writes its own step.
    pub fn note(&mut self, step: Processing) {
        self.history.push(step);
    }

    /// Samples of one channel, to be changed in place.
    pub(super) fn samples_mut(&mut self, channel: usize) -> &mut [f64] {
        &mut self.samples[channel * self.length..(channel + 1) * self.length]
    }

    /// Keeps the channels for which `keep` is true, moving samples within the memory held.
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

    /// Keeps samples `start`, `start + step`, … of each channel, `length` of them, moving them within the memory held.
    pub(super) fn retain_samples(&mut self, start: usize, step: usize, length: usize) {
        let mut kept = 0; // never overtakes `from`: what is read has not been written over
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
