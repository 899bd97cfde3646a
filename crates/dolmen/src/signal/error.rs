use crate::numeric::NumericError;

/// Why a record cannot be made or conditioned. Each variant carries the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
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
        /// Name of the channel with a different length.
        channel: String,
        /// Its number of samples.
        samples: usize,
        /// Number of samples of the first channel, for comparison.
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
    /// A sample is too large for a measurement: sums of squares would overflow.
    #[error(
        "channel \"{channel}\" holds {value} at sample {sample} (t = {time_s} s), but no sample may be above {most}: \
         an over-range mark of the logger? cut it away, or leave the channel out"
    )]
    TooLarge {
        /// Name of the channel.
        channel: String,
        /// Index of the sample, from 0.
        sample: usize,
        /// Its time from the start, s.
        time_s: f64,
        /// The value found.
        value: f64,
        /// The largest allowed.
        most: f64,
    },
    /// The number of channel descriptions differs from the number of series.
    #[error(
        "{channels} channels are described, but {series} series of samples are given: give one description to each"
    )]
    ChannelCount {
        /// Channels described.
        channels: usize,
        /// Series given.
        series: usize,
    },
    /// Two channels have one name.
    #[error(
        "channels {first} and {second} (counted from 1) are both named \"{name}\": give each its own name"
    )]
    SameName {
        /// The name.
        name: String,
        /// First channel of that name, counted from 1.
        first: usize,
        /// Second channel of that name, counted from 1.
        second: usize,
    },
    /// The options name a channel that the record does not have.
    #[error("there is no channel \"{given}\"; the record has {}", .names.join(", "))]
    UnknownChannel {
        /// The requested name.
        given: String,
        /// The names there are.
        names: Vec<String>,
    },
    /// All channels were to be left out.
    #[error("all {channels} channels were to be left out, but at least 1 must stay")]
    NothingLeft {
        /// Channels of the record.
        channels: usize,
    },
    /// One of several channels has no start time.
    #[error("channel \"{channel}\" does not say when it begins")]
    NoStart {
        /// The channel.
        channel: String,
    },
    /// Channels have no common time span.
    #[error(
        "channel \"{ends}\" ends {apart_s:.3} s before channel \"{begins}\" begins (ends that a filter needs counted): they have \
         no time in common; are the clocks right?"
    )]
    NoCommonTime {
        /// The channel that ends first.
        ends: String,
        /// The channel that begins last.
        begins: String,
        /// Time between that end and that beginning, s.
        apart_s: f64,
    },
    /// The part to keep is empty or not within the record.
    #[error(
        "the cut from {from_s} s to {to_s} s is refused: it must go forwards, hold at least 2 samples ({least_s} s) \
         and lie within the record, 0 to {duration_s} s"
    )]
    Cut {
        /// Requested start, s.
        from_s: f64,
        /// Requested end, s.
        to_s: f64,
        /// Two sampling intervals, s.
        least_s: f64,
        /// Duration of the record, s.
        duration_s: f64,
    },
    /// A corner frequency is not between zero and the Nyquist frequency.
    #[error(
        "{argument} is {given} Hz, but must lie above 0 and below the Nyquist frequency {nyquist_hz} Hz (half the \
         sampling rate): lower it, or leave the filter out"
    )]
    Corner {
        /// The argument.
        argument: &'static str,
        /// Its value, Hz.
        given: f64,
        /// Half the sampling rate, Hz.
        nyquist_hz: f64,
    },
    /// The lower corner of a band-pass is not below the upper.
    #[error(
        "low_hz is {low_hz} Hz and high_hz is {high_hz} Hz, but low_hz must be the lower one: exchange them"
    )]
    Band {
        /// Lower corner given, Hz.
        low_hz: f64,
        /// Upper corner given, Hz.
        high_hz: f64,
    },
    /// The order of a filter is out of range.
    #[error("order is {given}, but must be 1 to {most}: 4 is usual")]
    FilterOrder {
        /// The order given.
        given: usize,
        /// The highest allowed.
        most: usize,
    },
    /// The filter rings longer than the record lasts.
    #[error(
        "the record lasts {duration_s} s, but the {filter} filter rings for {ringing_s:.3} s at each end: take a \
         longer record, or a corner further from 0 Hz"
    )]
    TooShortForFilter {
        /// Which filter: "low-pass", "band-pass", "anti-alias".
        filter: &'static str,
        /// Duration of the record, s.
        duration_s: f64,
        /// Time until the filter has come to rest, s.
        ringing_s: f64,
    },
    /// The decimation factor is out of range.
    #[error(
        "the decimation factor is {given}, but must be 2 to {most} (at least 2 samples of {length} must be left): \
         leave decimation out, or lower the factor"
    )]
    Factor {
        /// The factor given.
        given: usize,
        /// The largest allowed.
        most: usize,
        /// Samples of the record.
        length: usize,
    },
    /// The segments of a spectrum are too short, or longer than the record.
    #[error("segment_length is {given}, but must be {least} to {most} samples, the length of the record")]
    SegmentLength {
        /// Requested number of samples.
        given: usize,
        /// Fewest samples for a spectrum.
        least: usize,
        /// Samples of the record.
        most: usize,
    },
    /// The time step of a ground motion is out of range.
    #[error("time_step_s is {given}, but must be {least} to {most}: is it in seconds?")]
    TimeStep {
        /// The value given, s.
        given: f64,
        /// The shortest allowed, s.
        least: f64,
        /// The longest allowed, s.
        most: f64,
    },
    /// Two motions have no common time step.
    #[error(
        "one motion has a step of {first_s} s and the other of {second_s} s, and no step divides both into {most} parts or fewer: \
         sample one of them anew, for example with a step of {first_s} s"
    )]
    NoCommonStep {
        /// The step of the first, s.
        first_s: f64,
        /// The step of the second, s.
        second_s: f64,
        /// Largest number of parts into which a step is divided.
        most: u32,
    },
    /// A number is out of its range.
    #[error("{argument} is {given}, but must be {allowed}")]
    Argument {
        /// The argument.
        argument: &'static str,
        /// Its value.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// A component without motion cannot be scaled to a peak.
    #[error(
        "the {component} component peaks at {peak_m_s2} m/s², so no factor scales it: name a component that moves"
    )]
    NoMotion {
        /// The component.
        component: &'static str,
        /// Its peak, m/s².
        peak_m_s2: f64,
    },
    /// A period is outside the range that the time step of the motion resolves.
    #[error(
        "a period of {given} s is refused: a motion with this time step tells of {least_s} to {most_s} s"
    )]
    Period {
        /// The period given, s.
        given: f64,
        /// The shortest allowed, s.
        least_s: f64,
        /// The longest allowed, s.
        most_s: f64,
    },
    /// A least-squares problem of a base line or a spectrum match has no solution.
    #[error("no base line or wavelets can be found: {why}; take a longer motion")]
    Match {
        /// Reason.
        why: String,
    },
    /// Too many records of a suite come from one earthquake, station or file.
    #[error(
        "no suite of {wanted} motions can be had of {usable} records: the limits on one earthquake, station and record leave \
         {most}; give more records, or ask for fewer motions"
    )]
    SuiteAlike {
        /// Motions wanted.
        wanted: usize,
        /// Records available.
        usable: usize,
        /// The most that may be in one suite.
        most: usize,
    },
    /// In every suite a factor is beyond its limits.
    #[error(
        "no suite of {wanted} motions can be had of {usable} records: a factor of every one lies beyond {least} to {most}; give \
         records of stronger or weaker shaking, or wider limits"
    )]
    SuiteFactors {
        /// Motions wanted.
        wanted: usize,
        /// Records available.
        usable: usize,
        /// Smallest factor allowed.
        least: f64,
        /// Largest factor allowed.
        most: f64,
    },
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
}
