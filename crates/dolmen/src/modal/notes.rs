//! Notes on the modes, as sentences.

use super::noted::{LateClock, ShapeQuantity, Tone, ToneOnMode, frequencies, list};
use super::subspace::HANKEL_ROWS_MOST;
use super::{FromClipping, InSpells, Kurtosis, RefusedPeak, Wander};
use crate::signal::ChannelFault;

/// A note on the modes.
#[derive(Clone, Debug, PartialEq)]
pub enum Note {
    /// A faint or clipped channel that is used anyway.
    Channel(ChannelFault),
    /// A loose channel that was left out.
    LeftOut(ChannelFault),
    /// The block rows are fewer than recommended, to limit the size of the matrices.
    BlockRowsBounded {
        /// Recommended number.
        wished: usize,
        /// Number used.
        taken: usize,
    },
    /// The record is too short for the requested blocks of time.
    FewBlocks {
        /// Number used.
        time_blocks: usize,
    },
    /// Peaks that are too narrow for a structure or too steady for random forces. They affect neither block rows nor decimation, and are not modes.
    Tones {
        /// The peaks.
        tones: Vec<Tone>,
    },
    /// Peaks that are narrower than a mode with the least damping, or steadier than modes, but no test finds a machine.
    Narrow {
        /// The peaks.
        peaks: Vec<Tone>,
        /// The least damping ratio of a mode.
        damping_ratio_least: f64,
    },
    /// Sines at the frequencies of modes: the damping ratios and shapes of these modes are wrong.
    TonesOnModes {
        /// The sines.
        tones: Vec<ToneOnMode>,
    },
    /// Modes whose motion is too steady for random forces.
    Harmonics {
        /// Kurtosis of each.
        steady: Vec<Kurtosis>,
        /// Whether these modes were removed.
        removed: bool,
    },
    /// Modes whose amplitude and phase vary in a way that is impossible under random forces.
    Wandering {
        /// The variation of each.
        machines: Vec<Wander>,
        /// Whether these modes were removed.
        removed: bool,
    },
    /// Modes left out because they exceed their surroundings only in some periods, for example while somebody walks, and not in quiet times.
    InSpells {
        /// The modes.
        modes: Vec<InSpells>,
    },
    /// Modes left out because they lie at multiples of one frequency and are steadier than modes: steps, a bell, an engine.
    Comb {
        /// The frequency, Hz.
        fundamental_hz: f64,
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Modes left out because the clipping of a channel creates them.
    Clipping {
        /// The modes.
        modes: Vec<FromClipping>,
    },
    /// Peaks without a damping ratio: neighbouring modes cut them off, or their decay is too short.
    NoDamping {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Modes damped less than those of most structures.
    LightModes {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Modes whose half-power bands overlap.
    ClosePairs {
        /// Frequencies of the two modes of each pair, Hz.
        pairs: Vec<[f64; 2]>,
    },
    /// The record was decimated earlier: no modes are identified above the cutoff of its filter.
    FilteredAbove {
        /// Highest requested frequency, Hz.
        asked_hz: f64,
        /// Highest frequency below the cutoff, Hz.
        passed_hz: f64,
    },
    /// Clusters of poles that mix several modes: left out.
    Blends {
        /// Frequency, Hz, and damping ratio of each cluster.
        blends: Vec<[f64; 2]>,
    },
    /// Modes in a valley of the spectrum between two peaks, each of two modes in one: left out.
    InValleys {
        /// Frequency, Hz, and damping ratio of each.
        blends: Vec<[f64; 2]>,
    },
    /// Modes whose band of the spectrum could not be fitted: they keep the result of the subspace method.
    NotFitted {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Modes without a stable pole, or with poles that scatter: the lines of the spectrum fit the model of a mode there.
    FromPeaks {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Modes where two singular values of the spectrum have peaks: each may be two modes.
    HiddenPairs {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Peaks of the spectrum that are not modes.
    PeaksWithoutMode {
        /// The peaks, each with the reason of its refusal.
        peaks: Vec<RefusedPeak>,
    },
    /// Refused modes that the user requested.
    Accepted {
        /// The modes, each with the reason of its refusal.
        modes: Vec<RefusedPeak>,
    },
    /// Requested modes that were found anyway.
    AcceptedAlready {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// No mode, peak or cluster of poles is near a requested frequency.
    NothingToAccept {
        /// The frequency, Hz.
        asked_hz: f64,
        /// Allowed distance, Hz.
        within_hz: f64,
        /// The nearest mode or peak below and above, if any, Hz.
        nearest_hz: Vec<f64>,
    },
    /// Modes that were found but not picked by hand.
    NotPicked {
        /// Frequencies of these modes, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Channels measure different quantities; the shapes are given in one quantity.
    OneQuantity {
        /// The quantity of the shapes.
        quantity: ShapeQuantity,
    },
    /// Channels with a phase of 90° relative to the others at every frequency: they measure another quantity and are left
    /// out of the shapes.
    QuarterTurn {
        /// Names of these channels.
        channels: Vec<String>,
        /// The frequencies, Hz.
        frequency_hz: Vec<f64>,
    },
    /// Two halves of the channels with a phase of 90° between them at every frequency: it is unknown which half measures another quantity,
    /// and none is left out.
    EitherTurned {
        /// The half that the shapes take for the different one.
        channels: Vec<String>,
        /// The other half.
        others: Vec<String>,
        /// The frequencies, Hz.
        frequency_hz: Vec<f64>,
    },
    /// A channel without motion in any mode.
    StandsStill {
        /// Name of the channel.
        channel: String,
        /// Its largest component over the largest component of the mode, –.
        share: f64,
    },
    /// A channel with a phase that is impossible in a mode shape: its clock may have a delay.
    PhaseOff {
        /// Name of the channel.
        channel: String,
        /// Angle from the real axis, 0 to 90°, and the frequency of the mode, Hz.
        degrees_at_hz: Vec<[f64; 2]>,
    },
    /// Channels whose clock drifts relative to most others: they are left out of the shapes.
    ClockDrift {
        /// Each channel with the error of its clock and the standard deviation of this error, 1e-6.
        drifting: Vec<(String, [f64; 2])>,
        /// The channels with the other clock, if they are not more: then it is unknown which clock is wrong. Otherwise empty.
        others: Vec<String>,
        /// Largest rotation of a phase over the record, degrees.
        turn_degrees: f64,
        /// Frequency of the mode with this rotation, Hz.
        frequency_hz: f64,
        /// Sampling rate assumed for all channels, Hz.
        sampling_rate_hz: f64,
    },
    /// Channels whose clock has a constant delay, positive or negative: they are left out of the shapes.
    LateClocks {
        /// Each channel with its delay.
        late: Vec<LateClock>,
    },
    /// As many channels have a constant delay as have none, and it is unknown which: the modes are found with the delay taken off.
    EitherLate {
        /// Each channel of one half with its delay relative to the other half.
        late: Vec<LateClock>,
        /// The other half, early by that delay if it is the wrong one.
        others: Vec<String>,
    },
    /// A mode with so few cycles in the record that its damping ratio is inaccurate.
    FewCycles {
        /// Its frequency, Hz.
        frequency_hz: f64,
        /// Lower bound of the relative standard deviation of its damping ratio, for a long record.
        damping_floor: f64,
    },
}

impl std::fmt::Display for Note {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Note::Channel(fault) => write!(f, "{fault} (it was used all the same)"),
            Note::LeftOut(fault) => write!(f, "{fault} (it was left out of the modes)"),
            Note::BlockRowsBounded { wished, taken } => write!(
                f,
                "{taken} block rows instead of {wished}, to keep the Hankel matrix below {HANKEL_ROWS_MOST} rows: modes \
                 that lie close together are told apart less well"
            ),
            Note::FewBlocks { time_blocks } => write!(
                f,
                "the record is short: standard deviations come from {time_blocks} blocks of time, and are themselves known \
                 to ± {:.0} %",
                100.0 / (2.0 * (*time_blocks as f64 - 1.0)).sqrt()
            ),
            Note::Tones { tones } => {
                let all: Vec<String> = tones.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "the spectrum has lines of one phase for the whole record, or too steady for random forces, at {}: machines",
                    all.join(", ")
                )
            }
            Note::Narrow {
                peaks,
                damping_ratio_least,
            } => {
                let all: Vec<String> = peaks.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "the spectrum has peaks narrower than a mode damped by {:.2} %, or steadier than modes are, at {}: machines that run for a part of the time, or modes damped \
                     less than that",
                    100.0 * damping_ratio_least,
                    all.join(", ")
                )
            }
            Note::TonesOnModes { tones } => {
                let all: Vec<String> = tones.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "machines run on modes, at {}: their sines keep one phase for the whole record or half of it; the damping ratio of such a mode comes \
                     out too low (none is given where by more than its interval), and its shape is the machine's too: measure while the machine rests",
                    all.join(", ")
                )
            }
            Note::Harmonics { steady, removed } => {
                let all: Vec<String> = steady
                    .iter()
                    .map(|k| format!("{:.3} Hz ({k})", k.frequency_hz))
                    .collect();
                let what = if *removed {
                    "left out"
                } else {
                    "not to be trusted as modes"
                };
                write!(
                    f,
                    "the motion at {} is too steady for random forces (3 is random, 1.5 a sine): machines, {what}",
                    all.join(", ")
                )
            }
            Note::Wandering { machines, removed } => {
                let all: Vec<String> = machines.iter().map(ToString::to_string).collect();
                let what = if *removed {
                    "left out"
                } else {
                    "not to be trusted as modes"
                };
                write!(
                    f,
                    "the motion at {} wanders as under no random forces, which change its strength and its phase alike: machines whose speed or \
                     strength wanders, {what}",
                    all.join(", ")
                )
            }
            Note::Comb { frequency_hz, .. } => {
                write!(
                    f,
                    "left out, since they are steadier than modes and lie at multiples of one frequency: "
                )?;
                list(f, frequency_hz)?;
                write!(f, " Hz: steps that never pause, a bell or an engine")
            }
            Note::Clipping { modes } => {
                let all: Vec<String> = modes.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "left out, since the clipping of a channel makes them, and no other channel shows them: {}",
                    all.join(", ")
                )
            }
            Note::InSpells { modes } => {
                let all: Vec<String> = modes.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "left out, since nothing stands there while the structure is quiet: {}: footsteps, other blows that follow each other, or \
                     a machine that ran for a while",
                    all.join(", ")
                )
            }
            Note::NoDamping { frequency_hz } => {
                write!(f, "no damping ratio is given for the peaks at ")?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz: another mode cuts their sides, they decay too fast to fit, or what \
                     decays has another frequency than the peak; the subspace methods tell close modes apart"
                )
            }
            Note::LightModes { frequency_hz } => {
                write!(f, "the modes at ")?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz are damped less than 0.2 %: few structures but steel and single stones are, and a machine whose speed wanders looks the same"
                )
            }
            Note::ClosePairs { pairs } => {
                let all: Vec<String> = pairs.iter().map(|[a, b]| format!("{a:.3} and {b:.3}")).collect();
                write!(
                    f,
                    "the modes at {} Hz lie closer than their bandwidths: the plane of their two shapes is known better than \
                     each shape in it",
                    all.join("; ")
                )
            }
            Note::FilteredAbove { asked_hz, passed_hz } => write!(
                f,
                "modes are sought up to {passed_hz:.3} Hz, not to frequency_high_hz = {asked_hz:.3} Hz: above it the filter cuts with which the \
                 record was brought to its rate"
            ),
            Note::InValleys { blends } => {
                let at = frequencies(blends);
                write!(f, "two modes in one, in a valley of the spectrum: {at} Hz")
            }
            Note::Blends { blends } => {
                let all: Vec<String> = blends
                    .iter()
                    .map(|[hz, zeta]| format!("{hz:.3} Hz (damping {:.1} %)", 100.0 * zeta))
                    .collect();
                write!(
                    f,
                    "left out, since low orders alone show it and it is damped far above the modes: {}: several modes that this record does not \
                     tell apart; a longer record or more sensors may",
                    all.join(", ")
                )
            }
            Note::FromPeaks { frequency_hz } => {
                write!(f, "no stable pole shows the modes at ")?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz: a mode was fitted to the lines of the spectrum there, and fits; the shape of one that was only a peak has no deviation"
                )
            }
            Note::NotFitted { frequency_hz } => {
                write!(f, "the modes at ")?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz are those of ssi-cov, not fitted further: the spectrum about them is not that of these modes alone under even forces (another \
                     mode, a machine, a stiffness that follows the motion), or has too few lines"
                )
            }
            Note::HiddenPairs { frequency_hz } => {
                write!(f, "two singular values of the spectrum rise at ")?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz, where one mode was found: it may be two that lie close, and then its frequency, damping and shape are of both; \
                     ssi-cov and ssi-data tell close modes apart"
                )
            }
            Note::PeaksWithoutMode { peaks } => {
                let all: Vec<String> = peaks.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "the spectrum has peaks that are no modes, each with what refused it: {}",
                    all.join("; ")
                )
            }
            Note::Accepted { modes } => {
                let all: Vec<String> = modes.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "accepted by the user, not found; each with what refused it: {}",
                    all.join("; ")
                )
            }
            Note::AcceptedAlready { frequency_hz } => {
                write!(f, "the modes at ")?;
                list(f, frequency_hz)?;
                write!(f, " Hz were found anyway: they need no acceptance")
            }
            Note::NothingToAccept {
                asked_hz,
                within_hz,
                nearest_hz,
            } => {
                write!(
                    f,
                    "nothing can be accepted at {asked_hz:.3} ± {within_hz:.3} Hz: no mode, no peak of the spectrum and no group of poles stands there"
                )?;
                if nearest_hz.is_empty() {
                    return Ok(());
                }
                write!(f, "; the nearest are at ")?;
                list(f, nearest_hz)?;
                write!(f, " Hz")
            }
            Note::NotPicked { frequency_hz } => {
                write!(f, "modes that were found and not picked: ")?;
                list(f, frequency_hz)?;
                write!(f, " Hz")
            }
            Note::OneQuantity { quantity } => write!(
                f,
                "the channels measure different quantities: every shape is given as {quantity}, brought there at its mode's own frequency"
            ),
            Note::StandsStill { channel, share } => write!(
                f,
                "\"{channel}\" moves by less than {:.1} % of the largest in every mode: it stands on firm ground, is not connected, or is in another \
                 unit than the others (g read as gal is 981 times too small, m/s² as mm/s² 1000 times, g as m/s² 9.81 times)",
                (100.0 * share).max(0.1)
            ),
            Note::PhaseOff {
                channel,
                degrees_at_hz,
            } => {
                write!(f, "the phase of \"{channel}\" is off a shape's 0 or 180° by ")?;
                for (i, [degrees, frequency_hz]) in degrees_at_hz.iter().enumerate() {
                    let comma = if i > 0 { ", " } else { "" };
                    write!(f, "{comma}{degrees:.0}° at {frequency_hz:.3} Hz")?;
                }
                write!(
                    f,
                    ": its clock or filter differs from the others', and its sign is not known in any mode; or modes lie close together"
                )
            }
            Note::ClockDrift {
                drifting,
                others,
                turn_degrees,
                frequency_hz,
                sampling_rate_hz,
            } => {
                let each: Vec<String> = drifting
                    .iter()
                    .map(|(channel, [ppm, sd])| {
                        let rate_hz = sampling_rate_hz * (1.0 + 1e-6 * ppm);
                        format!("\"{channel}\" {ppm:+.1} ± {sd:.1} ppm ({rate_hz:.5} Hz)")
                    })
                    .collect();
                write!(
                    f,
                    "clocks run apart: {} against the other channels, standard deviations beside, which turns the phase at {frequency_hz:.3} Hz \
                     by {turn_degrees:.0}° along the record; frequencies and damping stay, and these channels are left out of the shapes",
                    each.join(", ")
                )?;
                if others.is_empty() {
                    return Ok(());
                }
                write!(f, "; or \"{}\" as much the other way", others.join("\", \""))
            }
            Note::LateClocks { late } => {
                let each: Vec<String> = late.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "clocks are late (- is early): {}, against the other channels, standard deviations beside: their phases grow with the \
                     frequency of the mode as a delay's do; frequencies and damping stay, and these channels are left out of the shapes",
                    each.join("; ")
                )
            }
            Note::EitherLate { late, others } => {
                let each: Vec<String> = late.iter().map(ToString::to_string).collect();
                write!(
                    f,
                    "either clocks are late (- is early): {}, or those of \"{}\" are early by as much: as many channels agree with one as \
                     with the other, so the phases cannot tell which; the shapes are found with the delay taken off",
                    each.join("; "),
                    others.join("\", \"")
                )
            }
            Note::QuarterTurn {
                channels,
                frequency_hz,
            } => {
                write!(
                    f,
                    "the channels \"{}\" are a quarter turn off the others at ",
                    channels.join("\", \"")
                )?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz: they measure another quantity than the others (velocity beside acceleration), and are left out of the shapes"
                )
            }
            Note::EitherTurned {
                channels,
                others,
                frequency_hz,
            } => {
                write!(
                    f,
                    "\"{}\" and \"{}\" are a quarter turn apart at ",
                    channels.join("\", \""),
                    others.join("\", \"")
                )?;
                list(f, frequency_hz)?;
                write!(
                    f,
                    " Hz: one half measures another quantity (velocity beside acceleration), and the phases cannot tell which; none is left \
                     out, and the shapes take the first for the different half"
                )
            }
            Note::FewCycles {
                frequency_hz,
                damping_floor,
            } => write!(
                f,
                "the mode at {frequency_hz:.3} Hz was seen for so few cycles that its damping ratio cannot be known better \
                 than ± {:.0} %",
                100.0 * damping_floor
            ),
        }
    }
}
