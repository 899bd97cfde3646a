//! Joins channels with different clocks, sampling rates or lengths into one record.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | f | `rate_hz` | common sampling rate, the lowest of all | Hz |
//! | h | `taps` | windowed sinc filter with its corner at f/2 | – |
//! | L | `HALF_LENGTH` | half the length of the filter | 1/f |

use super::{Channel, Processing, Record, SignalError};
use std::collections::BTreeMap;

/// Half length of the interpolation filter, in steps of the common rate. With [`SHAPE`] the gain is constant up to 0.8 of the Nyquist frequency
/// and zero from 1.2 of it, as for decimation.
const HALF_LENGTH: f64 = 18.0;
/// β of the Kaiser window for a stop band at −100 dB (Kaiser 1974, β = 0.1102 (A − 8.7)).
const SHAPE: f64 = 10.06;
/// Largest number of filter phases kept for reuse. Our choice: common ratios of sampling rates need fewer phases.
const PHASES_MOST: usize = 4096;
/// Fraction of a step to which phases are rounded.
const PHASE_STEPS: f64 = 1e9;

/// Options of [`join`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Join {
    /// Largest time offset between two channels that is ignored, in steps of the common rate, 0 to 0.5. Default 0.01, our choice: a phase
    /// error of 1.4° at 0.8 of the Nyquist frequency.
    pub offset_most: f64,
    /// Source of the start times. Default: each channel has its own start time.
    pub starts: Starts,
}

impl Default for Join {
    fn default() -> Self {
        Join {
            offset_most: 0.01,
            starts: Starts::Stated,
        }
    }
}

/// Source of the start times of the channels.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Starts {
    /// Each channel has a start time by a common clock; channels without a start time are refused.
    #[default]
    Stated,
    /// All channels begin at the same instant; their start times are ignored.
    Together,
}

/// One channel with its own sampling.
#[derive(Clone, Debug, PartialEq)]
pub struct Piece {
    /// Description of the channel.
    pub channel: Channel,
    /// Samples in SI units.
    pub samples: Vec<f64>,
    /// Sampling rate, Hz.
    pub sampling_rate_hz: f64,
    /// Time of the first sample, s by the common clock; `None` if unknown.
    pub begins_s: Option<f64>,
}

/// Result of [`join`]: channels at common times.
#[derive(Clone, Debug, PartialEq)]
pub struct Joined {
    /// The record with all channels, in order.
    pub record: Record,
    /// Time of the first sample, s by the common clock; `None` if not needed.
    pub begins_s: Option<f64>,
}

/// Joins all channels into one record at the lowest of their rates, over their common time span.
///
/// ```text
/// y(t_k) = Σ_n h(t_k − t_n) x(t_n)     t_k: steps of the first channel of the lowest rate;  h: Kaiser-windowed sinc
/// ```
///
/// A channel at that rate whose samples are within [`Join::offset_most`] of these times is shifted by whole samples; its values do not change.
/// Other channels are interpolated as signals without content above the Nyquist frequency. The filter extends 18 steps to both sides and needs
/// samples there, so the ends are cut off. The processing history lists rates, offsets and cuts.
///
/// # Errors
/// [`SignalError::NoStart`], [`SignalError::NoCommonTime`], [`SignalError::Argument`]; and the errors of [`Record::new`].
///
/// # Limits
/// The gain is constant within 1e-5 up to 0.8 of the common Nyquist frequency; above 1.2 of it the gain is below 1e-5 (measured, in the tests).
/// Clock drift is not detected: start times and rates are taken as exact.
///
/// # Example
/// ```
/// use dolmen::signal::{Channel, Join, Piece, join};
/// let piece = |name: &str, begins_s| Piece {
///     channel: Channel::named(name),
///     samples: (0..100).map(f64::from).collect(),
///     sampling_rate_hz: 10.0,
///     begins_s: Some(begins_s),
/// };
/// let record = join(vec![piece("a", 0.0), piece("b", 2.0)], &Join::default())?.record;
/// assert_eq!((record.length(), record.samples(0)[0], record.samples(1)[0]), (80, 20.0, 0.0));
/// # Ok::<(), dolmen::signal::SignalError>(())
/// ```
pub fn join(pieces: Vec<Piece>, options: &Join) -> Result<Joined, SignalError> {
    check(&pieces, options)?;
    let slowest = pieces
        .iter()
        .map(|p| p.sampling_rate_hz)
        .fold(f64::INFINITY, f64::min);
    let begins = |p: &Piece| match options.starts {
        Starts::Together => 0.0,
        Starts::Stated => p.begins_s.unwrap_or(0.0),
    };
    let same = |p: &Piece| same_rate(p, slowest, options.offset_most);
    let Some(guide) = pieces.iter().find(|p| same(p)) else {
        return Err(SignalError::Empty {
            channels: 0,
            samples: 0,
        });
    };
    let rate_hz = guide.sampling_rate_hz;
    let origin_s = begins(guide);
    let first_known = guide.begins_s.filter(|_| options.starts == Starts::Stated);
    let plans: Vec<Plan> = pieces
        .iter()
        .map(|p| Plan::of(p, begins(p) - origin_s, rate_hz, same(p), options.offset_most))
        .collect();
    // in steps of the common rate from the first sample of the reference channel
    let first = plans.iter().map(|plan| plan.first).max().unwrap_or(0);
    let last = plans.iter().map(|plan| plan.last).min().unwrap_or(-1);
    if last <= first {
        let latest = plans.iter().position(|plan| plan.first == first).unwrap_or(0);
        let earliest = plans.iter().position(|plan| plan.last == last).unwrap_or(0);
        return Err(SignalError::NoCommonTime {
            ends: pieces[earliest].channel.name.clone(),
            begins: pieces[latest].channel.name.clone(),
            apart_s: (first as f64 - last as f64) / rate_hz,
        });
    }
    let length = (last - first + 1) as usize;
    let steps = history(&pieces, &plans, (first, length), rate_hz);
    let mut channels = Vec::with_capacity(pieces.len());
    let mut samples = Vec::with_capacity(pieces.len());
    for (piece, plan) in pieces.into_iter().zip(&plans) {
        samples.push(plan.samples(&piece.samples, first, length));
        channels.push(piece.channel);
    }
    let mut record = Record::new(channels, samples, rate_hz)?;
    steps.into_iter().for_each(|step| record.note(step));
    let begins_s = first_known.map(|_| origin_s + first as f64 / rate_hz);
    Ok(Joined { record, begins_s })
}

fn check(pieces: &[Piece], options: &Join) -> Result<(), SignalError> {
    if !(0.0..=0.5).contains(&options.offset_most) {
        return Err(SignalError::Argument {
            argument: "offset_most",
            given: options.offset_most,
            allowed: "0 to 0.5 steps",
        });
    }
    for piece in pieces {
        if !(piece.sampling_rate_hz > 0.0 && piece.sampling_rate_hz.is_finite()) {
            return Err(SignalError::SamplingRate {
                given: piece.sampling_rate_hz,
            });
        }
        // a value that is not finite would affect all samples within the filter length
        if let Some(sample) = piece.samples.iter().position(|x| !x.is_finite()) {
            return Err(SignalError::NotFinite {
                channel: piece.channel.name.clone(),
                sample,
                time_s: sample as f64 / piece.sampling_rate_hz,
                value: piece.samples[sample],
            });
        }
        let known = piece.begins_s.is_some_and(f64::is_finite) || options.starts == Starts::Together;
        if !known && pieces.len() > 1 {
            return Err(SignalError::NoStart {
                channel: piece.channel.name.clone(),
            });
        }
    }
    Ok(())
}

/// Whether all samples are within `offset_most` of the steps at this rate.
fn same_rate(piece: &Piece, rate_hz: f64, offset_most: f64) -> bool {
    (piece.sampling_rate_hz / rate_hz - 1.0).abs() * piece.samples.len() as f64 <= offset_most
}

struct Plan {
    /// First and last step of the common times within the channel.
    first: i64,
    last: i64,
    /// Samples of the channel per common step, and position of its first sample in steps.
    ratio: f64,
    at: f64,
    /// Whether the samples are used without interpolation.
    whole: bool,
}

impl Plan {
    fn of(piece: &Piece, later_s: f64, rate_hz: f64, same: bool, offset_most: f64) -> Self {
        let at = later_s * rate_hz;
        let count = piece.samples.len() as f64;
        if same && (at - at.round()).abs() <= offset_most {
            let first = at.round() as i64;
            return Plan {
                first,
                last: first.saturating_add(count as i64 - 1),
                ratio: 1.0,
                at,
                whole: true,
            };
        }
        let ratio = if same {
            1.0
        } else {
            piece.sampling_rate_hz / rate_hz
        };
        Plan {
            first: (at + HALF_LENGTH).ceil() as i64,
            last: (at + (count - 1.0) / ratio - HALF_LENGTH).floor() as i64,
            ratio,
            at,
            whole: false,
        }
    }

    fn samples(&self, x: &[f64], first: i64, length: usize) -> Vec<f64> {
        if self.whole {
            let from = (first - self.first) as usize;
            return x[from..from + length].to_vec();
        }
        let mut kept: BTreeMap<i64, Vec<f64>> = BTreeMap::new();
        let reach = (HALF_LENGTH * self.ratio).floor() as usize;
        let value = |k: usize| {
            let centre = ((first + k as i64) as f64 - self.at) * self.ratio; // in samples of the channel
            let whole = centre.floor();
            let phase = ((centre - whole) * PHASE_STEPS).round() as i64;
            if kept.len() > PHASES_MOST {
                kept.clear();
            }
            let taps = kept
                .entry(phase)
                .or_insert_with(|| taps(phase as f64 / PHASE_STEPS, reach, self.ratio));
            let begin = (whole as usize).saturating_sub(reach);
            let pairs = taps.iter().zip(&x[begin..]);
            pairs.map(|(h, x)| h * x).sum()
        };
        (0..length).map(value).collect()
    }
}

/// Weights of `reach` + 1 samples on each side of the centre; their sum is 1.
fn taps(phase: f64, reach: usize, ratio: f64) -> Vec<f64> {
    let weight = |n: usize| {
        let steps = (n as f64 - reach as f64 - phase) / ratio;
        let inside = 1.0 - (steps / HALF_LENGTH).powi(2);
        if inside <= 0.0 {
            return 0.0;
        }
        let angle = std::f64::consts::PI * steps;
        let sinc = if angle == 0.0 { 1.0 } else { angle.sin() / angle };
        sinc * bessel_i0(SHAPE * inside.sqrt())
    };
    let weights: Vec<f64> = (0..2 * reach + 2).map(weight).collect();
    let sum: f64 = weights.iter().sum();
    weights.into_iter().map(|w| w / sum).collect()
}

/// Modified Bessel function of the first kind, order 0, by its power series.
fn bessel_i0(x: f64) -> f64 {
    let quarter = x * x / 4.0;
    let (mut term, mut sum, mut k) = (1.0, 1.0, 1.0);
    while term > f64::EPSILON * sum {
        term *= quarter / (k * k);
        sum += term;
        k += 1.0;
    }
    sum
}

fn history(pieces: &[Piece], plans: &[Plan], (first, length): (i64, usize), rate_hz: f64) -> Vec<Processing> {
    let mut steps = Vec::new();
    for (piece, plan) in pieces.iter().zip(plans).filter(|(_, plan)| !plan.whole) {
        let channel = piece.channel.name.clone();
        let offset = plan.at - plan.at.round();
        steps.push(if plan.ratio == 1.0 {
            Processing::Interpolated {
                channel,
                offset_steps: offset,
            }
        } else {
            Processing::Resampled {
                channel,
                from_hz: piece.sampling_rate_hz,
                to_hz: rate_hz,
            }
        });
    }
    let left = plans.iter().filter(|plan| plan.whole);
    let largest = left
        .map(|plan| (plan.at - plan.at.round()).abs())
        .fold(0.0, f64::max);
    if largest > 0.0 {
        steps.push(Processing::OffsetsLeft { most_steps: largest });
    }
    let earliest = plans.iter().map(|plan| plan.at).fold(f64::INFINITY, f64::min);
    let ends = pieces
        .iter()
        .zip(plans)
        .map(|(piece, plan)| plan.at + (piece.samples.len() as f64 - 1.0) / plan.ratio);
    let latest = ends.fold(f64::NEG_INFINITY, f64::max);
    let before_s = (first as f64 - earliest) / rate_hz;
    let after_s = (latest - (first as f64 + (length as f64 - 1.0))) / rate_hz;
    if before_s.max(after_s) > 0.5 / rate_hz {
        steps.push(Processing::CommonTime { before_s, after_s });
    }
    steps
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::PI;

    fn sine(name: &str, frequency_hz: f64, begins_s: f64, rate_hz: f64, length: usize) -> Piece {
        let at = |i: usize| (2.0 * PI * frequency_hz * (begins_s + i as f64 / rate_hz) + 0.3).sin();
        Piece {
            channel: Channel::named(name),
            samples: (0..length).map(at).collect(),
            sampling_rate_hz: rate_hz,
            begins_s: Some(begins_s),
        }
    }

    fn joined(pieces: Vec<Piece>) -> Record {
        join(pieces, &Join::default()).unwrap().record
    }

    /// Largest difference between channel 1 and the exact sine in channel 0.
    fn apart(record: &Record) -> f64 {
        let pairs = record.samples(0).iter().zip(record.samples(1));
        pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
    }

    #[test]
    fn exact_parts_of_a_step_to_eight_tenths_of_nyquist() {
        for (begins_s, frequency_hz) in [(0.1234, 1.0), (-0.5071, 17.0), (0.005, 40.0), (3.0071, 39.0)] {
            let record = joined(vec![
                sine("a", frequency_hz, 0.0, 100.0, 900),
                sine("b", frequency_hz, begins_s, 100.0, 700),
            ]);
            assert!(apart(&record) < 1e-5, "{frequency_hz} Hz: {}", apart(&record));
            assert!(record.length() > 500 && record.sampling_rate_hz() == 100.0);
        }
    }

    #[test]
    fn exact_other_rates_and_nothing_folds_down() {
        // all are below 0.8 of 50 Hz; the number of phases is 2 for 250 Hz over 100 Hz, 25 for 128 Hz, and the number of samples for 100.01 Hz
        for rate_hz in [128.0, 250.0, 1000.0, 100.01] {
            let length = (8.0 * rate_hz) as usize;
            let record = joined(vec![
                sine("a", 40.0, 0.0, 100.0, 800),
                sine("b", 40.0, 0.0017, rate_hz, length),
            ]);
            assert!(apart(&record) < 1e-5, "{rate_hz}: {}", apart(&record));
            assert!(matches!(record.history()[0], Processing::Resampled { .. }));
        }
        // 62 Hz would alias to 38 Hz
        let mut above = sine("b", 62.0, 0.0, 250.0, 2000);
        let record = joined(vec![sine("a", 0.0, 0.0, 100.0, 800), above.clone()]);
        let most = record.samples(1).iter().fold(0.0, |m: f64, x| m.max(x.abs()));
        assert!(most < 1e-5, "{most}");
        above.samples.iter_mut().for_each(|x| *x = 2.5);
        let record = joined(vec![sine("a", 0.0, 0.0, 100.0, 800), above]);
        assert!(record.samples(1).iter().all(|x| (x - 2.5).abs() < 1e-13));
    }

    #[test]
    fn exact_small_offsets_are_left_and_said() {
        let a = sine("a", 3.0, 0.0, 100.0, 500);
        let b = sine("b", 3.0, 1.00005, 100.0, 500); // 0.005 of a step late
        let record = joined(vec![a.clone(), b.clone()]);
        assert_eq!(record.samples(0), &a.samples[100..]);
        assert_eq!(record.samples(1), &b.samples[..400]);
        let said: Vec<String> = record.history().iter().map(ToString::to_string).collect();
        assert_eq!(
            said,
            [
                "times of the channels differ by up to 0.0050 of a step, left so",
                "cut to the time that all channels share: 1.000 s before it and 1.000 s after it are gone"
            ]
        );
    }

    #[test]
    fn refuses_no_common_time_and_no_start() {
        let said = |pieces, options: &Join| join(pieces, options).unwrap_err().to_string();
        let pair = || vec![sine("a", 3.0, 0.0, 100.0, 500), sine("b", 3.0, 9.0, 100.0, 500)];
        assert_eq!(
            said(pair(), &Join::default()),
            "channel \"a\" ends 4.010 s before channel \"b\" begins (ends that a filter needs counted): they have no time in \
             common; are the clocks right?"
        );
        let mut pieces = pair();
        pieces[1].begins_s = None;
        assert_eq!(
            said(pieces.clone(), &Join::default()),
            "channel \"b\" does not say when it begins"
        );
        let together = Join {
            starts: Starts::Together,
            ..Default::default()
        };
        assert_eq!(join(pieces, &together).unwrap().record.length(), 500);
        let wide = Join {
            offset_most: 0.6,
            ..Default::default()
        };
        assert_eq!(
            said(pair(), &wide),
            "offset_most is 0.6, but must be 0 to 0.5 steps"
        );
        let mut pieces = pair();
        pieces[0].samples[7] = f64::NAN;
        assert!(said(pieces, &Join::default()).contains("holds NaN at sample 7"));
    }
}
