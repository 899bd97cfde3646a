/// Why a record cannot be made or conditioned. Each variant carries the value that was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[non_exhaustive]
pub enum SignalError {
    /// No channel, or channels without a sample.
    #[error("the record has {channels} channels of {samples} samples, but must have at least 1 of 2")]
    Empty {
        /// Channels given.
        channels: usize,
        /// Samples a channel.
        samples: usize,
    },
    /// The channels are not equally long.
    #[error(
        "channel \"{channel}\" has {samples} samples, but the first has {first}: all channels of one record share \
         their time stamps"
    )]
    Ragged {
        /// Name of the odd channel.
        channel: String,
        /// Its number of samples.
        samples: usize,
        /// That of the first channel.
        first: usize,
    },
    /// The sampling rate is not a positive number.
    #[error("sampling_rate_hz is {given}, but must be a positive number")]
    SamplingRate {
        /// The value given, Hz.
        given: f64,
    },
    /// A sample is NaN or infinite.
    #[error(
        "channel \"{channel}\" holds {value} at sample {sample} (t = {time_s} s): cut the record before or after it, \
         or leave the channel out"
    )]
    NotFinite {
        /// Name of the channel.
        channel: String,
        /// Index of the sample, from 0.
        sample: usize,
        /// Its time from the start, s.
        time_s: f64,
        /// The value found.
        value: f64,
    },
}
