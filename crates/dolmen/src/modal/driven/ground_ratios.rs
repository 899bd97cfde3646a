//! Motion of channels over that of a measured ground far below the lowest mode, where a structure moves with its ground.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | H | `h1` | response of a channel to the ground | – |
//! | f₁ | `lowest_hz` | lowest frequency on the fixed ground | Hz |
//! | x | `x` | f²/(f₁² − f²) | – |
//! | g, c | `ratio`, `slope` | H → g (1 + c x) for f → 0; c is the participation of the lowest mode at the channel | – |

use super::responses::{FrequencyResponse, FrequencyResponses};
use crate::signal::{Channel, Quantity};

/// Highest frequency of the lines over the lowest mode. Higher modes then bend H by less than 1 % in frames of four storeys. Our choice.
const BELOW: f64 = 0.5;
/// First line that Hann's window keeps free of the mean.
const LINE_FIRST: usize = 2;
/// Least coherence of a line: noise of the ground channel makes H₁ smaller by this factor at most. Our choice.
const COHERENCE_LEAST: f64 = 0.8;
/// Fewest lines. Our choice.
const LINES_LEAST: usize = 5;
/// Largest standard deviation of a ratio over the ratio. Our choice.
const SD_MOST: f64 = 0.05;
/// A ratio within this factor of 1 is no fault: gains of sensors and noise explain it. Our choice.
const FACTOR_LEAST: f64 = 1.5;
/// A ratio above 1 also arises if wind moves the structure, and the structure its ground: 1 + stiffness of the soil over that of the structure. It
/// differs from channel to channel, as the slopes do. So the channels must agree within this factor, and their slopes must differ by more than the
/// second.
const AGREE_WITHIN: f64 = 1.1;
const SLOPES_APART: f64 = 1.2;
/// Least cosine between the directions of a channel and its ground, and largest cosine to the other inputs. Our choice.
const ALONG_LEAST: f64 = 0.95;
const ACROSS_MOST: f64 = 0.3;

/// Channels whose motion over that of the ground is not 1 far below the lowest mode: a reversed sensor or a wrong unit.
#[derive(Clone, Debug, PartialEq)]
pub struct OffGround {
    /// Name of the ground's channel.
    pub input: String,
    /// Names of the channels with this ratio.
    pub channels: Vec<String>,
    /// Whether all channels along the ground have it: then the ground's channel is probably wrong.
    pub is_input: bool,
    /// Mean ratio of their motion to that of the ground.
    pub ratio: f64,
    /// Lowest and highest frequency used, Hz.
    pub range_hz: [f64; 2],
}

struct Ratio {
    channel: String,
    ratio: f64,
    slope: f64,
    range_hz: [f64; 2],
}

impl Ratio {
    fn is_usual(&self) -> bool {
        self.ratio > 0.0 && self.ratio.ln().abs() <= FACTOR_LEAST.ln()
    }

    /// Whether wind on a structure that moves its ground may explain it.
    fn may_be_wind(&self) -> bool {
        self.ratio > FACTOR_LEAST
    }
}

/// Compares the responses far below the lowest mode with 1. `channels` are those of the record; only channels with a known quantity, equal to that
/// of the ground, and a direction along it count.
pub(super) fn off_ground(
    responses: &FrequencyResponses,
    (channels, inputs): (&[Channel], &[usize]),
    lowest_hz: f64,
) -> Vec<OffGround> {
    let each = inputs.iter().enumerate().filter_map(|(at, &input)| {
        let others = inputs.iter().filter(|other| **other != input);
        let others: Vec<&Channel> = others.map(|other| &channels[*other]).collect();
        let ground = &channels[input];
        let along = responses.outputs.iter().filter_map(|output| {
            let own = channels.iter().find(|channel| channel.name == output.channel)?;
            let sign = sign_along(own, ground, &others)?;
            ratio(responses, (output, at), lowest_hz, sign)
        });
        of_ground(&ground.name, along.collect())
    });
    each.collect()
}

fn of_ground(input: &str, all: Vec<Ratio>) -> Option<OffGround> {
    let off: Vec<&Ratio> = all.iter().filter(|of| !of.is_usual()).collect();
    let (first, count) = (*off.first()?, off.len() as f64);
    let mean = off.iter().map(|of| of.ratio).sum::<f64>() / count;
    let agree = off
        .iter()
        .all(|of| (of.ratio / mean).max(mean / of.ratio) <= AGREE_WITHIN && of.ratio * mean > 0.0);
    let largest = |of: fn(&Ratio) -> f64| off.iter().map(|each| of(each)).fold(f64::MIN, f64::max);
    let slopes_differ = largest(|of| of.slope) > -SLOPES_APART * largest(|of| -of.slope);
    let is_input = off.len() == all.len();
    let is_told = match (is_input, off.iter().any(|of| of.may_be_wind())) {
        (true, false) => agree,
        (true, true) => agree && slopes_differ,
        // one channel, with the sign of others or a smaller ratio, against two or more that move with the ground
        (false, is_larger) => off.len() == 1 && all.len() >= 3 && !is_larger,
    };
    is_told.then(|| OffGround {
        input: input.to_owned(),
        channels: off.iter().map(|of| of.channel.clone()).collect(),
        is_input,
        ratio: mean,
        range_hz: first.range_hz,
    })
}

/// 1 or −1 if the channel measures the same quantity as the ground along the same line, and no other input does; `None` otherwise.
fn sign_along(channel: &Channel, ground: &Channel, others: &[&Channel]) -> Option<f64> {
    let cosine = |other: &Channel| -> Option<f64> {
        let (a, b) = (channel.direction?, other.direction?);
        Some(a.iter().zip(b).map(|(a, b)| a * b).sum())
    };
    let is_same = channel.quantity == ground.quantity && channel.quantity != Quantity::Unknown;
    let along = cosine(ground).filter(|along| is_same && along.abs() >= ALONG_LEAST)?;
    let is_across = |other: &&Channel| cosine(other).is_some_and(|along| along.abs() <= ACROSS_MOST);
    others.iter().all(is_across).then_some(along.signum())
}

/// Weighted least squares of Re H over the lines below the lowest mode; `None` if they do not determine it.
///
/// ```text
/// Re H(f) = g + g c x,   var H = (1 − γ²) |H|² / (2 γ² n)      n: segments
/// ```
///
/// # Source
/// Bendat & Piersol (2010) Random Data, 4th ed., section 9.2, for the variance of H₁.
fn ratio(
    responses: &FrequencyResponses,
    (output, input): (&FrequencyResponse, usize),
    lowest_hz: f64,
    sign: f64,
) -> Option<Ratio> {
    let h1 = output.h1.get(input)?;
    let lines = responses.frequency_hz.iter().enumerate().skip(LINE_FIRST);
    let lines = lines.take_while(|(_, hz)| **hz <= BELOW * lowest_hz);
    let used: Vec<usize> = lines
        .map(|(line, _)| line)
        .filter(|&line| output.coherence[line] >= COHERENCE_LEAST)
        .collect();
    let (from, to) = (*used.first()?, *used.last()?);
    let x = |line: usize| {
        let square = (responses.frequency_hz[line] / lowest_hz).powi(2);
        square / (1.0 - square)
    };
    let weight = |line: usize| {
        let coherence = output.coherence[line].min(1.0 - 1e-6);
        let variance = (1.0 - coherence) / (2.0 * coherence * responses.segments as f64);
        1.0 / (variance * h1[line].norm_sqr()).max(f64::MIN_POSITIVE)
    };
    let [mut s, mut sx, mut sxx, mut sy, mut sxy] = [0.0; 5];
    for &line in &used {
        let (x, y, w) = (x(line), sign * h1[line].re, weight(line));
        s += w;
        sx += w * x;
        sxx += w * x * x;
        sy += w * y;
        sxy += w * x * y;
    }
    let determinant = s * sxx - sx * sx;
    let (ratio, rise) = (
        (sxx * sy - sx * sxy) / determinant,
        (s * sxy - sx * sy) / determinant,
    );
    let misfit: f64 = used
        .iter()
        .map(|&line| weight(line) * (sign * h1[line].re - ratio - rise * x(line)).powi(2))
        .sum();
    let freedom = used.len() as f64 - 2.0;
    let sd = (sxx / determinant * (misfit / freedom).max(1.0)).sqrt();
    let is_known = used.len() >= LINES_LEAST && sd <= SD_MOST * ratio.abs();
    is_known.then(|| Ratio {
        channel: output.channel.clone(),
        ratio,
        slope: rise / ratio,
        range_hz: [from, to].map(|line| responses.frequency_hz[line]),
    })
}

#[cfg(test)]
mod tests {
    use super::super::made::MadeOnGround;
    use super::*;
    use crate::modal::{Identify, Method, ModalAnalysis, identify};
    use crate::signal::Record;

    fn channels() -> Vec<Channel> {
        let channel = |name: &str| Channel {
            quantity: Quantity::Acceleration,
            direction: Some([1.0, 0.0, 0.0]),
            ..Channel::named(name)
        };
        ["ground", "floor", "roof"].map(channel).to_vec()
    }

    /// The closed form of the frame, with the ground's channel times `gain`.
    fn exact(gain: f64) -> FrequencyResponses {
        let frequency_hz: Vec<f64> = (0..60).map(|line| 0.05 * f64::from(line)).collect();
        let output = |at: usize, name: &str| FrequencyResponse {
            channel: name.into(),
            h1: vec![
                frequency_hz
                    .iter()
                    .map(|hz| MadeOnGround::response(*hz)[at] / gain)
                    .collect(),
            ],
            coherence: vec![0.99; 60],
        };
        FrequencyResponses {
            outputs: vec![output(0, "floor"), output(1, "roof")],
            segments: 20,
            frequency_hz,
        }
    }

    #[test]
    fn exact_a_reversed_ground_and_a_wrong_unit_show_below_the_lowest_mode() {
        let lowest_hz = MadeOnGround::held_hz()[0];
        let of = |gain: f64, channels: &[Channel]| off_ground(&exact(gain), (channels, &[0]), lowest_hz);
        assert_eq!(of(1.0, &channels()), []);
        assert_eq!(of(1.3, &channels()), []);
        for gain in [-1.0, 100.0, 0.01, 9.80665, -0.1] {
            let [found] = &of(gain, &channels())[..] else {
                panic!("{gain}")
            };
            assert!((found.ratio * gain - 1.0).abs() < 0.01, "{gain} {found:?}");
            assert!(found.is_input && found.channels == ["floor", "roof"]);
            assert!(found.range_hz[0] > 0.0 && found.range_hz[1] < 0.5 * lowest_hz);
        }
        // a ground sensor that points the other way, as its direction says; one across; one without a unit
        let mut other = channels();
        other[0].direction = Some([-1.0, 0.0, 0.0]);
        assert_eq!(of(-1.0, &other), []);
        other[0].direction = Some([0.0, 1.0, 0.0]);
        assert_eq!(of(-1.0, &other), []);
        other = channels();
        other[0].quantity = Quantity::Unknown;
        assert_eq!(of(-1.0, &other), []);
    }

    fn identified(made: MadeOnGround, gain: f64) -> ModalAnalysis {
        let record = made.make().unwrap();
        let samples = (0..3).map(|c| {
            let gain = if c == 0 { gain } else { 1.0 };
            record.samples(c).iter().map(|y| gain * y).collect()
        });
        let record = Record::new(record.channels().to_vec(), samples.collect(), 100.0).unwrap();
        let options = Identify {
            method: Method::Okid,
            inputs: vec![0],
            ..Identify::default()
        };
        identify(&record, &options).unwrap()
    }

    #[test]
    fn holds_a_reversed_ground_is_found_and_wind_that_moves_the_ground_is_no_fault() {
        let quake = MadeOnGround {
            seed: 0,
            duration_s: 150.0,
            waves_kn: 60.0,
            quake_s: Some(30.0),
            wind_kn: 0.3,
            noise: 0.01,
        };
        let ambient = MadeOnGround {
            duration_s: 300.0,
            waves_kn: 2.0,
            quake_s: None,
            wind_kn: 0.5,
            ..quake
        };
        for made in [quake, ambient] {
            let found = identified(made, 1.0).driven.unwrap();
            assert_eq!(found.off_ground, []);
        }
        // a ground on a spring hardly moves below its modes: no other motion may hide that
        let calm = MadeOnGround {
            quake_s: None,
            wind_kn: 0.0,
            noise: 0.001,
            ..quake
        };
        let found = identified(calm, -1.0).driven.unwrap();
        let [off] = &found.off_ground[..] else {
            panic!("{:?}", found.off_ground)
        };
        assert!(off.is_input && (off.ratio + 1.0).abs() < 0.1, "{off:?}");
    }
}
