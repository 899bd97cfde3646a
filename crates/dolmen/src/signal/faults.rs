//! Faults of a channel: its samples are valid numbers, but do not measure the structure.

use super::Record;
use super::fault_runs::{BlockStrengths, FirstSteps, alike, drifts, faded, spikes, stuck};
use super::loose_sensors::{FastMotion, loose};
use crate::numeric::{largest_of, middle, sum_of};
use std::fmt;

/// A channel this much weaker than the median of the others (−60 dB) records the noise of the logger, not the structure. Our choice.
const FAINT: f64 = 1e-3;
/// Fewest samples in a row at the same extreme value. Our choice: two occur in coarsely digitised records.
const RUN_LEAST: usize = 3;
/// Number of samples in such runs that makes a channel clipped. Our choice.
const HELD_LEAST: usize = 10;
/// A clipped channel reaches its extreme this many times more often than the value next to it. For the crest of a digitised sine this ratio is
/// 1/(√2 - 1) = 2.4. Our choice.
const CROWDED: usize = 4;
/// Two channels are the same if their steps agree within this fraction of the largest step. Our choice: above the rounding of 32-bit numbers,
/// far below the noise of two sensors.
const SAME: f64 = 1e-6;

/// Why a channel should not be used without treatment. `Display` gives a sentence that says what to do.
#[derive(Clone, Debug, PartialEq)]
pub enum ChannelFault {
    /// Every sample is the same.
    Constant {
        /// Name of the channel.
        channel: String,
        /// The constant value.
        value: f64,
    },
    /// Far weaker than the other channels of its kind.
    Faint {
        /// Name of the channel.
        channel: String,
        /// Standard deviation of the channel.
        deviation: f64,
        /// Median standard deviation of the channels that measure the same quantity.
        typical: f64,
    },
    /// The channel repeats one value for a second or longer but moves at other times: a loose cable, or a logger that paused.
    Stuck {
        /// Name of the channel.
        channel: String,
        /// The value.
        value: f64,
        /// Start, s from the start of the record.
        from_s: f64,
        /// End, s.
        to_s: f64,
    },
    /// The strength of the channel, relative to the others of its kind, changed tenfold or more during the record.
    Faded {
        /// Name of the channel.
        channel: String,
        /// Largest over smallest strength, each relative to the median of its kind, –.
        factor: f64,
        /// Start of the weakest part, s from the start of the record.
        from_s: f64,
        /// End of the weakest part, s.
        to_s: f64,
    },
    /// The fast motion of the channel changes back and forth between two strengths, while that of the other channels of its kind does not: a loose
    /// sensor or cable.
    Loose {
        /// Name of the channel.
        channel: String,
        /// Strength of the stronger state over that of the weaker one, –.
        factor: f64,
        /// Share of the time in the stronger state, –.
        share: f64,
        /// Number of times that the stronger state begins.
        times: usize,
        /// Time at which it first begins, s from the start.
        first_s: f64,
    },
    /// The signal is almost that of another channel.
    Alike {
        /// Name of the first channel.
        channel: String,
        /// Name of the second channel.
        other: String,
        /// Correlation of their steps, -1 to 1.
        correlation: f64,
    },
    /// The least-squares line through the channel rises by far more than the channel moves.
    Drifts {
        /// Name of the channel.
        channel: String,
        /// Rise over the record, in standard deviations about the line.
        rise: f64,
    },
    /// Single samples far from their neighbours.
    Spikes {
        /// Name of the channel.
        channel: String,
        /// Number of spikes.
        count: usize,
        /// Time of the first one, s from the start.
        first_s: f64,
    },
    /// The channel stays at its exact largest or smallest value: the motion exceeded the range of the sensor or logger.
    Clipped {
        /// Name of the channel.
        channel: String,
        /// The constant value.
        value: f64,
        /// Samples at that value.
        samples: usize,
        /// Time of the first of them, s from the start.
        first_s: f64,
    },
    /// The signal is that of another channel, except for a factor and an offset.
    Duplicated {
        /// Name of the first channel.
        channel: String,
        /// Name of the second channel.
        other: String,
        /// Factor from the first to the second.
        factor: f64,
    },
}

impl ChannelFault {
    /// The channel with the fault; the first of a pair.
    pub fn channel(&self) -> &str {
        match self {
            Self::Constant { channel, .. }
            | Self::Faint { channel, .. }
            | Self::Stuck { channel, .. }
            | Self::Faded { channel, .. }
            | Self::Loose { channel, .. }
            | Self::Alike { channel, .. }
            | Self::Drifts { channel, .. }
            | Self::Spikes { channel, .. }
            | Self::Clipped { channel, .. }
            | Self::Duplicated { channel, .. } => channel,
        }
    }

    pub(super) fn times_s_mut(&mut self) -> Vec<&mut f64> {
        match self {
            Self::Stuck { from_s, to_s, .. } | Self::Faded { from_s, to_s, .. } => vec![from_s, to_s],
            Self::Spikes { first_s, .. } | Self::Clipped { first_s, .. } | Self::Loose { first_s, .. } => {
                vec![first_s]
            }
            Self::Constant { .. }
            | Self::Faint { .. }
            | Self::Alike { .. }
            | Self::Drifts { .. }
            | Self::Duplicated { .. } => Vec::new(),
        }
    }
}

impl fmt::Display for ChannelFault {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Constant { channel, value } => write!(
                f,
                "channel \"{channel}\" is dead: every sample is {value} in SI units; leave it out, and look at its cable"
            ),
            Self::Faint {
                channel,
                deviation,
                typical,
            } => write!(
                f,
                "channel \"{channel}\" is dead or in another unit: its standard deviation is {deviation:.3e}, the \
                 median of its kind is {typical:.3e}; leave it out, or correct its unit"
            ),
            Self::Stuck {
                channel,
                value,
                from_s,
                to_s,
            } => write!(
                f,
                "channel \"{channel}\" stands at exactly {value} from {from_s:.2} to {to_s:.2} s while it moves at other times: a \
                 cable that came off, or a pause; cut the record there, or leave the channel out"
            ),
            Self::Faded {
                channel,
                factor,
                from_s,
                to_s,
            } => write!(
                f,
                "channel \"{channel}\" changes its strength against the others {factor:.0}-fold during the record, least from \
                 {from_s:.0} to {to_s:.0} s: a loose contact; cut the record there, or leave the channel out"
            ),
            Self::Loose {
                channel,
                factor,
                share,
                times,
                first_s,
            } => write!(
                f,
                "channel \"{channel}\": its fast motion grows {factor:.1}-fold and falls back, {times} times, in {:.0} % of the \
                 record together, first at {first_s:.0} s, and no other channel does so: a loose sensor or cable; look at it",
                100.0 * share
            ),
            Self::Alike {
                channel,
                other,
                correlation,
            } => write!(
                f,
                "channels \"{channel}\" and \"{other}\" are almost one signal (correlation of their steps {correlation:.6}): one \
                 cable on two inputs, or two sensors at one place"
            ),
            Self::Drifts { channel, rise } => write!(
                f,
                "channel \"{channel}\" drifts by {rise:.0} times its motion over the record, and low modes and dampings come out wrong: \
                 take the line off first"
            ),
            Self::Spikes {
                channel,
                count,
                first_s,
            } => write!(
                f,
                "channel \"{channel}\": {count} single sample{} out of {} neighbours by 25 times what is usual, the first at \
                 {first_s:.2} s: they add noise, and damping comes out wrong; look at the cable",
                if *count == 1 { " stands" } else { "s stand" },
                if *count == 1 { "its" } else { "their" },
            ),
            Self::Clipped {
                channel,
                value,
                samples,
                first_s,
            } => write!(
                f,
                "channel \"{channel}\" is clipped: {samples} samples stand at exactly {value}, first at {first_s} s; \
                 cut the record to a part within range, or leave the channel out"
            ),
            Self::Duplicated {
                channel,
                other,
                factor,
            } => write!(
                f,
                "channels \"{channel}\" and \"{other}\" hold the same signal (factor {factor:.6}): one cable on two \
                 inputs, or one column twice; leave one of them out"
            ),
        }
    }
}

/// Finds all faults of the channels of a record, in the order of the channels. [`Record::new`] already refuses samples that are not numbers.
///
/// A channel has a fault if it
/// - is constant, or repeats one value for a second,
/// - is more than 60 dB weaker than the median of its kind, both in deviation and in steps (so drift alone neither hides nor imitates this
///   fault),
/// - stays at an exact extreme, changes its strength once or back and forth, or has many spikes, or
/// - equals another channel, exactly or almost, except for a factor.
///
/// # Limits
/// Inspect the record as measured, because filters smooth clipped crests. Strengths are compared only among three or more channels that measure
/// the same quantity, changes back and forth only among four or more, in a record of a minute or more.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Record, inspect};
/// let good: Vec<f64> = (0..500).map(|i| (0.3 * i as f64).sin() + (0.71 * i as f64).cos()).collect();
/// let record = Record::new(
///     vec![Channel::named("roof"), Channel::named("base")],
///     vec![good, vec![0.0; 500]],
///     100.0,
/// )?;
/// let faults = inspect(&record);
/// assert!(faults[0].to_string().starts_with("channel \"base\" is dead: every sample is 0 in SI"));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn inspect(record: &Record) -> Vec<ChannelFault> {
    let strengths: Vec<Strength> = (0..record.channels().len())
        .map(|c| Strength::of(record.samples(c)))
        .collect();
    let blocks: Vec<Option<BlockStrengths>> = (0..record.channels().len())
        .map(|c| BlockStrengths::of(record.samples(c)))
        .collect();
    let motions: Vec<Option<FastMotion>> = (0..record.channels().len())
        .map(|c| FastMotion::of(record.samples(c), record.sampling_rate_hz()))
        .collect();
    let steps: Vec<FirstSteps> = (0..record.channels().len())
        .map(|c| FirstSteps::of(record.samples(c)))
        .collect();
    let mut faults = Vec::new();
    for (c, channel) in record.channels().iter().enumerate() {
        let x = record.samples(c);
        let name = || channel.name.clone();
        if strengths[c].largest_step == 0.0 {
            faults.push(ChannelFault::Constant {
                channel: name(),
                value: x[0],
            });
            continue;
        }
        let kind: Vec<&Strength> = record
            .channels()
            .iter()
            .zip(&strengths)
            .filter(|(other, s)| other.quantity == channel.quantity && s.largest_step > 0.0)
            .map(|(_, s)| s)
            .collect();
        let typical = middle(kind.iter().map(|s| s.deviation).collect());
        let typical_step = middle(kind.iter().map(|s| s.step_deviation).collect());
        let own = &strengths[c];
        if kind.len() >= 3 && own.deviation < FAINT * typical && own.step_deviation < FAINT * typical_step {
            faults.push(ChannelFault::Faint {
                channel: name(),
                deviation: own.deviation,
                typical,
            });
        }
        let rate_hz = record.sampling_rate_hz();
        let stuck = stuck(x, rate_hz);
        let is_stuck = stuck.is_some();
        faults.extend(stuck.map(|[from, to]| ChannelFault::Stuck {
            channel: name(),
            value: x[from],
            from_s: from as f64 / rate_hz,
            to_s: to as f64 / rate_hz,
        }));
        faults.extend(drifts(x).map(|rise| ChannelFault::Drifts {
            channel: name(),
            rise,
        }));
        if let Some(spikes) = spikes(x) {
            faults.push(ChannelFault::Spikes {
                channel: name(),
                count: spikes.count,
                first_s: spikes.first as f64 / rate_hz,
            });
        }
        let same_kind = |other: usize| record.channels()[other].quantity == channel.quantity;
        let others: Vec<usize> = (0..record.channels().len())
            .filter(|other| *other != c && same_kind(*other) && strengths[*other].largest_step > 0.0)
            .collect();
        if let Some(loose) = loose(record, c, &others, &motions) {
            faults.push(ChannelFault::Loose {
                channel: name(),
                factor: loose.factor,
                share: loose.share,
                times: loose.times,
                first_s: loose.first as f64 / rate_hz,
            });
        }
        let others: Vec<&BlockStrengths> = others.iter().filter_map(|c| blocks[*c].as_ref()).collect();
        let own = blocks[c].as_ref().filter(|_| !is_stuck);
        if let Some(faded) = own.and_then(|own| faded(own, &others)) {
            faults.push(ChannelFault::Faded {
                channel: name(),
                factor: faded.factor,
                from_s: faded.from as f64 / rate_hz,
                to_s: faded.to as f64 / rate_hz,
            });
        }
        for sign in [1.0, -1.0] {
            if let Some(held) = held_at_extreme(x, sign) {
                faults.push(ChannelFault::Clipped {
                    channel: name(),
                    value: held.value,
                    samples: held.samples,
                    first_s: held.first as f64 / record.sampling_rate_hz(),
                });
            }
        }
        faults.extend(copy(record, c, &strengths, &steps));
    }
    faults
}

/// The first earlier channel that this one repeats or resembles.
fn copy(record: &Record, c: usize, strengths: &[Strength], steps: &[FirstSteps]) -> Option<ChannelFault> {
    let x = record.samples(c);
    record.channels()[..c]
        .iter()
        .enumerate()
        .find_map(|(other, earlier)| {
            let (channel, name) = (earlier.name.clone(), record.channels()[c].name.clone());
            if let Some(factor) = same_but_for_factor(record.samples(other), x, strengths[other].largest_at) {
                return Some(ChannelFault::Duplicated {
                    channel,
                    other: name,
                    factor,
                });
            }
            alike(&steps[other], &steps[c]).map(|correlation| ChannelFault::Alike {
                channel,
                other: name,
                correlation,
            })
        })
}

/// Steps of a channel that are held together, in the first cache.
const STEPS_AT_ONCE: usize = 512;

/// Strength of a channel.
struct Strength {
    /// Standard deviation.
    deviation: f64,
    /// Root mean square of the steps from sample to sample.
    step_deviation: f64,
    /// Largest step, and the sample it starts from.
    largest_step: f64,
    largest_at: usize,
}

impl Strength {
    fn of(x: &[f64]) -> Self {
        let n = x.len() as f64;
        let mean = sum_of(x, |v| v) / n;
        let square = sum_of(x, |v| (v - mean) * (v - mean));
        let (mut step_square, mut largest_step, mut largest_at) = (0.0, 0.0, 0);
        let mut steps = [0.0; STEPS_AT_ONCE];
        for (k, (from, to)) in x
            .chunks(STEPS_AT_ONCE)
            .zip(x[1..].chunks(STEPS_AT_ONCE))
            .enumerate()
        {
            let steps = &mut steps[..to.len()];
            for ((step, a), b) in steps.iter_mut().zip(from).zip(to) {
                *step = (b - a).abs();
            }
            step_square += sum_of(steps, |step| step * step);
            let largest = largest_of(steps, |step| step);
            if largest > largest_step {
                let at = steps.iter().position(|step| *step == largest).unwrap_or(0);
                (largest_step, largest_at) = (largest, k * STEPS_AT_ONCE + at);
            }
        }
        Strength {
            deviation: (square / n).sqrt(),
            step_deviation: (step_square / (n - 1.0)).sqrt(),
            largest_step,
            largest_at,
        }
    }
}

struct ClippedRun {
    value: f64,
    samples: usize,
    first: usize,
}

/// The samples at the largest value (`sign` 1) or smallest value (`sign` -1), if the channel appears to be clipped there.
fn held_at_extreme(x: &[f64], sign: f64) -> Option<ClippedRun> {
    let extreme = largest_of(x, |v| sign * v);
    let count = |value: f64| x.iter().filter(|v| sign * **v == value).count();
    let samples = count(extreme);
    if samples < HELD_LEAST {
        return None;
    }
    let below = x.iter().map(|v| sign * v).filter(|v| *v < extreme);
    if samples < CROWDED * count(below.fold(f64::NEG_INFINITY, f64::max)) {
        return None;
    }
    let in_runs: usize = x
        .chunk_by(|a, b| (sign * a == extreme) == (sign * b == extreme))
        .filter(|run| sign * run[0] == extreme && run.len() >= RUN_LEAST)
        .map(<[f64]>::len)
        .sum();
    let first = x.iter().position(|v| sign * v == extreme)?;
    (in_runs >= HELD_LEAST).then_some(ClippedRun {
        value: x[first],
        samples,
        first,
    })
}

/// b / a if the steps of `b` are those of `a` times one factor, taken from the largest step of `a`.
fn same_but_for_factor(a: &[f64], b: &[f64], largest_at: usize) -> Option<f64> {
    let step = |x: &[f64], i: usize| x[i + 1] - x[i];
    let factor = step(b, largest_at) / step(a, largest_at);
    let bound = SAME * step(b, largest_at).abs();
    // false if the factor is not a number (constant channel) or if `b` has no step there
    let same = bound > 0.0 && (0..a.len() - 1).all(|i| (step(b, i) - factor * step(a, i)).abs() <= bound);
    same.then_some(factor)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::signal::{Channel, cut};
    use proptest::prelude::*;

    /// Sum of sines, different for each seed.
    fn shaken(seed: usize) -> Vec<f64> {
        let pitch = 0.31 + 0.017 * seed as f64;
        (0..4000)
            .map(|i| {
                (pitch * i as f64).sin() + (2.3 * pitch * i as f64 + 1.0).cos() + (0.01 * i as f64).sin()
            })
            .collect()
    }

    fn record(channels: Vec<Vec<f64>>) -> Record {
        let names = (1..=channels.len())
            .map(|c| Channel::named(format!("ch{c}")))
            .collect();
        Record::new(names, channels, 100.0).unwrap()
    }

    fn sentences(channels: Vec<Vec<f64>>) -> Vec<String> {
        inspect(&record(channels))
            .iter()
            .map(ToString::to_string)
            .collect()
    }

    #[test]
    fn holds_sound_channels_have_no_fault() {
        assert_eq!(sentences((0..4).map(shaken).collect()), [""; 0]);
        // neither a coarse digitiser nor a slow drift is clipping
        let coarse = |scale: f64| shaken(1).iter().map(|x| (scale * x).round()).collect();
        let drift = (0..4000)
            .map(|i| (300.0 * (0.001 * f64::from(i)).sin()).round())
            .collect();
        assert_eq!(
            sentences(vec![coarse(1.2), coarse(5.0), coarse(40.0), drift]),
            [""; 0]
        );
    }

    #[test]
    fn refuses_a_dead_channel() {
        assert_eq!(
            sentences(vec![shaken(0), vec![-0.25; 4000], shaken(2)]),
            [
                "channel \"ch2\" is dead: every sample is -0.25 in SI units; leave it out, and look at its cable"
            ]
        );
    }

    #[test]
    fn refuses_a_faint_channel() {
        let faint = shaken(1).iter().map(|x| 5e-4 * x).collect();
        assert_eq!(
            sentences(vec![shaken(0), faint, shaken(2)]),
            [
                "channel \"ch2\" is dead or in another unit: its standard deviation is 6.129e-4, the median of its kind is \
              1.226e0; leave it out, or correct its unit"
            ]
        );
    }

    #[test]
    fn refuses_a_clipped_channel() {
        let clipped = shaken(1).iter().map(|x| x.clamp(-9.0, 1.5)).collect::<Vec<_>>();
        let found = sentences(vec![shaken(0), clipped.clone(), shaken(2)]);
        let samples = clipped.iter().filter(|x| **x == 1.5).count();
        let first = clipped.iter().position(|x| *x == 1.5).unwrap() as f64 / 100.0;
        assert_eq!(
            found,
            [format!(
                "channel \"ch2\" is clipped: {samples} samples stand at exactly 1.5, first at {first} s; cut the record to a \
                 part within range, or leave the channel out"
            )]
        );
        // the part that the fault proposes has no fault
        let part = cut(record(vec![shaken(0), clipped]), 0.0, first).unwrap();
        assert_eq!(inspect(&part), []);
    }

    #[test]
    fn refuses_a_duplicated_channel() {
        let copy = shaken(0).iter().map(|x| 0.1 - 2.0 * x).collect();
        assert_eq!(
            sentences(vec![shaken(0), shaken(1), copy]),
            [
                "channels \"ch1\" and \"ch3\" hold the same signal (factor -2.000000): one cable on two inputs, or one column \
              twice; leave one of them out"
            ]
        );
    }

    proptest! {
        #[test]
        fn holds_a_copy_is_found_whatever_its_factor(exponent in -6.0..6.0, negative: bool, offset in -10.0..10.0) {
            let factor = 10f64.powf(exponent) * if negative { -1.0 } else { 1.0 };
            let copy = shaken(3).iter().map(|x| factor * (x + offset)).collect();
            let found = inspect(&record(vec![shaken(3), copy]));
            prop_assert!(
                matches!(found[..], [ChannelFault::Duplicated { factor: f, .. }] if (f / factor - 1.0).abs() < 1e-9),
                "{found:?}"
            );
        }
    }
}
