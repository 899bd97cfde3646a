use crate::numeric::NumericError;
use crate::signal::{ChannelFault, SignalError};
use dolmen_linalg::LinalgError;

/// Why modes cannot be identified. Each variant contains the refused value.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ModalError {
    /// The requested model order needs more block rows than there are.
    #[error(
        "order_most is {given}, but {block_rows} block rows of {channels} channels allow at most {most}: raise \
         block_rows or lower order_most"
    )]
    Order {
        /// Requested order.
        given: usize,
        /// Block rows.
        block_rows: usize,
        /// Channels.
        channels: usize,
        /// Largest order allowed.
        most: usize,
    },
    /// The Hankel matrix has fewer significant singular values than the requested order.
    #[error(
        "order_most is {given}, but the correlations have rank {rank} to working precision: the record holds almost no \
         noise; lower order_most to {rank} or less"
    )]
    Rank {
        /// Requested order.
        given: usize,
        /// Singular values above rounding.
        rank: usize,
    },
    /// The past samples are almost linearly dependent, and decimation prevents their QR factorization.
    #[error(
        "decimation is {decimation}, but the record holds almost no noise: a past sample is nearly a combination of the \
         others, and their QR needs the samples as they are; set decimation to 1, lower block_rows, or take ssi_cov"
    )]
    Dependent {
        /// Requested decimation.
        decimation: usize,
    },
    /// More modes are requested than the model order can have.
    #[error(
        "modes_wanted is {given}, but a model of order {order_most} holds at most {most} modes: raise order_most or \
         ask for fewer"
    )]
    ModesWanted {
        /// Number of requested modes.
        given: usize,
        /// Largest model order.
        order_most: usize,
        /// Largest possible number of modes.
        most: usize,
    },
    /// Fewer modes were found than requested.
    #[error(
        "modes_wanted is {given}, but only {found} were found stable (at {} Hz): record for longer, place \
         sensors where the missing modes move, or ask for {found}",
        listed_hz(found_hz)
    )]
    ModesMissing {
        /// Number of requested modes.
        given: usize,
        /// Number of modes found.
        found: usize,
        /// Frequencies of these modes, Hz.
        found_hz: Vec<f64>,
    },
    /// No mode was found near a requested frequency.
    #[error(
        "no mode was found at {given_hz} Hz (± {within_hz:.3} Hz); the modes found lie at {} Hz: no other mode \
         is returned in its place",
        listed_hz(found_hz)
    )]
    NoModeAt {
        /// Requested frequency, Hz.
        given_hz: f64,
        /// Allowed distance of a mode, Hz.
        within_hz: f64,
        /// Frequencies found, Hz.
        found_hz: Vec<f64>,
    },
    /// The given block rows cover less than half a period of the lowest mode.
    #[error(
        "block_rows is {given}, but the lowest mode of interest ({frequency_hz:.3} Hz) needs at least {least} at \
         {sampling_rate_hz} samples a second: raise block_rows, decimate, or raise frequency_low_hz"
    )]
    BlockRows {
        /// Block rows given.
        given: usize,
        /// Least number.
        least: usize,
        /// Lowest frequency of interest, Hz.
        frequency_hz: f64,
        /// Sampling rate after decimation, Hz.
        sampling_rate_hz: f64,
    },
    /// The record is too short for the lags and blocks.
    #[error(
        "the record has {samples} samples, but correlations over {lags} lags in {blocks} blocks of time need {needed}: \
         record for longer, or lower block_rows"
    )]
    TooShort {
        /// Samples of each channel.
        samples: usize,
        /// Lags.
        lags: usize,
        /// Blocks of time.
        blocks: usize,
        /// Samples needed.
        needed: usize,
    },
    /// An option is out of its range.
    #[error("{option} is {given}, but must be {allowed}")]
    Option {
        /// Name of the option.
        option: &'static str,
        /// Value given.
        given: f64,
        /// The allowed range.
        allowed: &'static str,
    },
    /// No spectral peak is above the noise, so no setting can be chosen from the data.
    #[error(
        "no peak of the spectrum rises {prominence_db} dB above its surroundings between {low_hz} and {high_hz} Hz: \
         the record may hold noise alone; for a free decay after a pull or a blow set method = \"era\"; else give block_rows and the frequency range to try all the same"
    )]
    NoPeak {
        /// Requested prominence, dB.
        prominence_db: f64,
        /// Lowest frequency of the analysis, Hz.
        low_hz: f64,
        /// Highest frequency of the analysis, Hz.
        high_hz: f64,
    },
    /// The spectrum has peaks, but tests refuse all of them, so no setting can be chosen from the data.
    #[error(
        "the spectrum has peaks at {} Hz, but each is that of a machine, or is not there while the structure is quiet: identify a part of the record \
         in which the structure moves evenly, without machines and steps; else give block_rows and the frequency range to try all the same",
        listed_hz(at_hz)
    )]
    NoPeakLeft {
        /// Frequencies of the peaks, Hz.
        at_hz: Vec<f64>,
    },
    /// A channel is dead or has the same signal as another.
    #[error("{0}")]
    Channel(ChannelFault),
    /// The user requests a mode of a free decay, but no test refuses modes of free decays.
    #[error(
        "no test refuses a mode of a free decay (era), so that {given_hz} Hz cannot be accepted: leave it out"
    )]
    AcceptedOfDecay {
        /// The frequency, Hz.
        given_hz: f64,
    },
    /// Two frequencies picked by hand are one mode.
    #[error(
        "pick_hz {given_hz} is the mode at {found_hz:.4} Hz, which another pick names already: leave one of them out"
    )]
    PickedTwice {
        /// The later pick, Hz.
        given_hz: f64,
        /// The mode, Hz.
        found_hz: f64,
    },
    /// A given mode of a simulated record is out of range.
    #[error(
        "mode {mode} of the made record has frequency {frequency_hz} Hz and damping ratio {damping_ratio}, but must lie \
         between 0 and {nyquist_hz} Hz and between 0 and 1, with one finite shape component a channel"
    )]
    MadeMode {
        /// Index of the mode, from 0.
        mode: usize,
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Its damping ratio.
        damping_ratio: f64,
        /// Half the sampling rate, Hz.
        nyquist_hz: f64,
    },
    /// A mode for a comparison is invalid.
    #[error(
        "{what} of a mode to be compared is {given}, but must be positive and finite: correct the survey"
    )]
    Compared {
        /// The fault.
        what: &'static str,
        /// Its value.
        given: f64,
    },
    /// A decay is too short.
    #[error(
        "the decay has {samples} samples, but needs {least}: record it at a higher rate, or until it has died away"
    )]
    DecayTooShort {
        /// Samples of each channel.
        samples: usize,
        /// Samples needed.
        least: usize,
    },
    /// No part of a record decays like a mode.
    #[error(
        "nothing in the record decays as a mode does (model of order {order} from {samples} samples): cut it so that it begins when the \
         last force has ended, or strike harder"
    )]
    NoDecay {
        /// Order of the model.
        order: usize,
        /// Samples of each channel.
        samples: usize,
    },
    /// A force acts within a decay.
    #[error(
        "the swings grow at once at {} s from the first sample: a blow, or a release. A decay holds none: cut the record into parts that each begin \
         after one and end before the next",
        listed_s(times_s)
    )]
    SeveralBlows {
        /// Times of the forces, s from the first sample.
        times_s: Vec<f64>,
    },
    /// A channel of a decay is clipped.
    #[error(
        "channel \"{channel}\" is clipped until {until_s:.3} s from the first sample, and a clipped decay has another shape: leave the channel out, or \
         begin at {whole_from_s:.3} s"
    )]
    ClippedDecay {
        /// Its name.
        channel: String,
        /// Last sample at the limit, s from the first.
        until_s: f64,
        /// Start of the part without clipping, s from the first sample.
        whole_from_s: f64,
    },
    /// A decay has too few cycles.
    #[error(
        "the decay has {extrema} extrema of clear swings, but one value needs {needed}: strike harder, or lower extrema or the noise"
    )]
    FewSwings {
        /// Extrema found.
        extrema: usize,
        /// Extrema needed.
        needed: usize,
    },
    /// Too few setups.
    #[error("{given} setups are given, but putting setups together needs 2 or more")]
    Setups {
        /// Setups given.
        given: usize,
    },
    /// A setup has no sensor in common with earlier ones.
    #[error(
        "setup {setup} has no sensor in common with those before it: at least one must stay where it is (same name, or same place and \
         direction), better three"
    )]
    NoReference {
        /// Number of the setup, from 1.
        setup: usize,
    },
    /// No sensor is in every setup.
    #[error(
        "no sensor is in all {setups} setups, but setups identified as one need one that stays throughout, better three"
    )]
    NoCommonReference {
        /// Setups given.
        setups: usize,
    },
    /// A setup has another sampling rate.
    #[error(
        "setup {setup} has {given_hz} samples a second, the first {first_hz}: setups identified as one need one rate"
    )]
    SetupRate {
        /// Number of the setup, from 1.
        setup: usize,
        /// Its rate, Hz.
        given_hz: f64,
        /// Rate of the first record, Hz.
        first_hz: f64,
    },
    /// The method does not suit the inputs.
    #[error(
        "method is {method} and {inputs} of {channels} channels are inputs, but okid, and no other method, needs one input or more and one channel \
         that is none"
    )]
    Inputs {
        /// Name of the method.
        method: &'static str,
        /// Number of input channels.
        inputs: usize,
        /// Channels.
        channels: usize,
    },
    /// The inputs are too similar to distinguish their effects.
    #[error(
        "the inputs move as one: only {share:.3} of their motion is not shared, and what each of them does cannot be told apart: keep one of them"
    )]
    InputsAlike {
        /// Smallest over mean eigenvalue of their coherence matrix; the median over the lines.
        share: f64,
    },
    /// The inputs shake at one frequency only.
    #[error(
        "{:.1} % of the power of every input lies at one frequency, {frequency_hz:.3} Hz: a sine shows how the structure answers there, and no mode; sweep \
         the shaker slowly over the modes or drive it at random, or leave inputs out and use the time in which it rests",
        100.0 * share
    )]
    InputsSine {
        /// The frequency of the strongest input, Hz.
        frequency_hz: f64,
        /// Share of the power at that frequency, 0 to 1; the smallest over the inputs.
        share: f64,
    },
    /// No channel responds to the inputs.
    #[error(
        "at most {:.0} % of the motion at any mode follows the inputs, which is no more than chance: is the input channel connected, of this record, \
         and of the same clock? Without it leave inputs out, and the modes are those of structure and ground together",
        100.0 * share
    )]
    InputsUnrelated {
        /// The largest share, 0 to 1.
        share: f64,
    },
    /// No structure explains the response of the channels to the inputs.
    #[error(
        "how the channels follow the inputs is not how a structure follows its ground: the inputs may move only as the structure moves them, or a \
         channel may copy an input"
    )]
    NoObserver,
    /// A number is refused.
    #[error(transparent)]
    Numeric(#[from] NumericError),
    /// The record itself is refused.
    #[error(transparent)]
    Record(#[from] SignalError),
    /// A decomposition failed.
    #[error(transparent)]
    Linalg(#[from] LinalgError),
}

impl ModalError {
    /// Whether an iteration did not converge. In this case the input may be valid.
    pub fn did_not_converge(&self) -> bool {
        match self {
            Self::Linalg(why) => why.did_not_converge(),
            Self::Order { .. }
            | Self::Rank { .. }
            | Self::Dependent { .. }
            | Self::ModesWanted { .. }
            | Self::ModesMissing { .. }
            | Self::NoModeAt { .. }
            | Self::BlockRows { .. }
            | Self::TooShort { .. }
            | Self::Option { .. }
            | Self::NoPeak { .. }
            | Self::NoPeakLeft { .. }
            | Self::Channel(_)
            | Self::AcceptedOfDecay { .. }
            | Self::PickedTwice { .. }
            | Self::MadeMode { .. }
            | Self::Compared { .. }
            | Self::DecayTooShort { .. }
            | Self::NoDecay { .. }
            | Self::SeveralBlows { .. }
            | Self::ClippedDecay { .. }
            | Self::FewSwings { .. }
            | Self::Setups { .. }
            | Self::NoReference { .. }
            | Self::NoCommonReference { .. }
            | Self::SetupRate { .. }
            | Self::Inputs { .. }
            | Self::InputsAlike { .. }
            | Self::InputsSine { .. }
            | Self::InputsUnrelated { .. }
            | Self::NoObserver
            | Self::Numeric(_)
            | Self::Record(_) => false,
        }
    }
}

fn listed_hz(frequencies_hz: &[f64]) -> String {
    let all: Vec<String> = frequencies_hz.iter().map(|hz| format!("{hz:.3}")).collect();
    all.join(", ")
}

fn listed_s(times_s: &[f64]) -> String {
    let all: Vec<String> = times_s.iter().map(|t| format!("{t:.2}")).collect();
    all.join(", ")
}

pub(super) fn refused<T>(option: &'static str, given: f64, allowed: &'static str) -> Result<T, ModalError> {
    Err(ModalError::Option {
        option,
        given,
        allowed,
    })
}

/// Refuses the first option that is below its bound: (option, given, bound, allowed).
pub(super) fn at_least(all: &[(&'static str, usize, usize, &'static str)]) -> Result<(), ModalError> {
    match all.iter().find(|(_, given, bound, _)| given < bound) {
        Some((option, given, _, allowed)) => refused(option, *given as f64, allowed),
        None => Ok(()),
    }
}

/// The reference channels as a list, each valid and only once; empty: all.
pub(super) fn references_of(given: &[usize], channels: usize) -> Result<Vec<usize>, ModalError> {
    for (i, reference) in given.iter().enumerate() {
        if *reference >= channels || given[..i].contains(reference) {
            let allowed = "the index of a channel, counted from 0, each once";
            return refused("references", *reference as f64, allowed);
        }
    }
    Ok(match given {
        [] => (0..channels).collect(),
        some => some.to_vec(),
    })
}
