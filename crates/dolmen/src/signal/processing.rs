//! Processing steps applied to a record since the measurement.

/// One processing step.
#[derive(Clone, Debug, PartialEq)]
pub enum Processing {
    /// Read from a file.
    Read {
        /// Format of the file: "csv", "npy".
        format: String,
        /// Unit of the numbers in the file; "" if not given.
        unit: String,
    },
    /// Channels removed.
    LeftOut {
        /// Names of the channels.
        channels: Vec<String>,
    },
    /// Only a time span kept.
    Cut {
        /// Start of the kept part, s.
        from_s: f64,
        /// End of the kept part, s.
        to_s: f64,
    },
    /// A least-squares polynomial removed from each channel.
    Detrend {
        /// Degree of the polynomial: 0 for the mean, 1 for a straight line.
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
    /// Scaled, and wavelets added, to match a target response spectrum.
    Matched {
        /// The matched component: "x", "y", "z".
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
    /// Tapered to zero at both ends by half a cosine.
    Tapered {
        /// Length of each taper, s.
        each_end_s: f64,
    },
    /// Horizontal components rotated about the vertical axis.
    Rotated {
        /// Angle from x towards y, rad.
        angle_rad: f64,
    },
    /// Horizontal channels of known direction rotated so that x points in a given direction.
    Oriented {
        /// Direction of x, degrees from north towards east.
        x_azimuth_deg: f64,
    },
    /// Anti-alias filtered and decimated.
    Decimate {
        /// Number of samples before, divided by the number after.
        factor: usize,
    },
    /// Samples of one channel multiplied by a factor, for example the value of one count.
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
        /// Time offset of its samples from those of the other channels, in steps.
        offset_steps: f64,
    },
    /// One channel resampled at a lower rate, with an anti-alias filter.
    Resampled {
        /// The channel.
        channel: String,
        /// Rate before, Hz.
        from_hz: f64,
        /// Rate after, Hz.
        to_hz: f64,
    },
    /// Time offsets between channels, ignored as small.
    OffsetsLeft {
        /// The largest offset, in steps.
        most_steps: f64,
    },
    /// Only the longest span without lost samples in any channel was kept.
    LongestSpan {
        /// First kept sample, s after the first sample of the file.
        from_s: f64,
        /// Last kept sample, s after the first sample of the file.
        to_s: f64,
        /// Last sample of the file, s after the first.
        whole_s: f64,
        /// The lost samples, by time.
        gaps: Vec<LostSpan>,
    },
    /// Lost samples replaced by the mean of their channel, so that the samples before and after keep their times.
    Bridged {
        /// The lost samples, by time.
        gaps: Vec<LostSpan>,
    },
    /// Short runs of lost samples filled in by linear prediction.
    FilledGaps {
        /// The filled runs, by time.
        gaps: Vec<LostSpan>,
        /// Number of filled samples in all channels.
        samples: usize,
        /// Fraction of the samples in those channels.
        share: f64,
    },
    /// Only the time span common to all channels kept.
    CommonTime {
        /// Time from the first sample of any channel to the first kept sample, s.
        before_s: f64,
        /// Time from the last kept sample to the last sample of any channel, s.
        after_s: f64,
    },
}

/// A run of lost samples.
#[derive(Clone, Debug, PartialEq)]
pub struct LostSpan {
    /// The channel; `None` for all channels.
    pub channel: Option<String>,
    /// Time of the last sample before the gap, s after the first sample of the record.
    pub at_s: f64,
    /// Time lost, s.
    pub lost_s: f64,
}

impl LostSpan {
    /// Largest number of gaps listed in a note, so that hundreds of gaps do not hide other information.
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

/// The first gaps as text, and the number of gaps not listed.
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
            Processing::Bridged { gaps } => {
                write!(
                    f,
                    "samples are lost: {}; the mean of the channel stands there, and what lies on either side is used each by itself",
                    first_gaps(gaps)
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
            Processing::Oriented { x_azimuth_deg } => {
                write!(f, "turned so that x points {x_azimuth_deg}° from north")
            }
            Processing::Rotated { angle_rad } => {
                write!(f, "turned by {:.6}° from x towards y", angle_rad.to_degrees())
            }
        }
    }
}
