//! Time stamps: whether they are even, and the sampling rate that they give.
//!
//! A stamp whose last digit is worth u lies within u of the true time (rounded or truncated). Stamps are even if there is a step
//! Δ with every stamp i within u, and 1 % of a step for the clock, of t_0 + i Δ. Each stamp narrows the interval of possible Δ;
//! the first that leaves it empty is refused. Where u is more than a quarter of a step, rounding could hide a missing sample:
//! then all steps must be equal, as they are if Δ is a multiple of u, or the rate must be given.

use super::RecordError;
use crate::number::Number;

/// Share of a step by which the clock may be off at a sample: the error that this makes is far below the noise of a sensor. Chosen here.
const CLOCK_JITTER: f64 = 0.01;
/// Stamps coarser than this share of a step cannot show a missing sample, unless all steps are equal. Chosen here.
const RESOLUTION_MOST: f64 = 0.25;
/// Relative difference allowed between a given rate and that of the stamps: an error of 1e-4 in every frequency, well below any scatter.
const RATE_TOLERANCE: f64 = 1e-4;
/// Relative distance up to which a given step counts as a multiple of the resolution: its stamps are then printed without rounding.
const MULTIPLE: f64 = 1e-6;
/// Relative rounding error of a mean of differences of doubles, generous.
const ROUNDING: f64 = 1e-9;
/// Decimal digits of a double.
const DIGITS_MOST: i32 = 17;

/// Source of the sampling rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateSource {
    /// Given, without time stamps.
    Given,
    /// From the time stamps: of the rates that they allow, the one that has the fewest digits, as a rate or as a step.
    Stamps,
    /// Given, and the time stamps agree.
    GivenAndStamps,
    /// Given, and the first and the last of a column of dates agree.
    GivenAndDates,
}

/// The time stamps so far.
#[derive(Clone, Debug)]
pub(super) struct Stamps {
    /// Seconds in one unit of the column.
    unit_s: f64,
    given_hz: Option<f64>,
    first_s: f64,
    last_s: f64,
    last_step_s: f64,
    /// Whether all steps are equal, to half the last digit.
    all_same: bool,
    count: usize,
    /// Most significant digits and most decimals of any stamp: a program prints all stamps of a file in one format.
    digits: i32,
    decimals: i32,
    /// Value of the last digit for stamps with `decade.0` ≤ |value| < `decade.1`, in the unit of the column.
    resolution: f64,
    decade: (f64, f64),
    decade_decimals: i32,
    /// The interval of steps that agree with all stamps, s.
    step_least_s: f64,
    step_most_s: f64,
}

impl Stamps {
    pub(super) fn new(unit_s: f64, given_hz: Option<f64>) -> Self {
        Stamps {
            unit_s,
            given_hz,
            last_step_s: f64::NAN,
            all_same: true,
            first_s: 0.0,
            last_s: 0.0,
            count: 0,
            digits: 0,
            decimals: -DIGITS_MOST,
            resolution: f64::NAN,
            decade: (0.0, 0.0),
            decade_decimals: -DIGITS_MOST,
            step_least_s: 0.0,
            step_most_s: f64::INFINITY,
        }
    }

    /// Takes the next stamp, and refuses it if no constant step fits all stamps.
    pub(super) fn push(&mut self, printed: Number, line: usize) -> Result<(), RecordError> {
        self.look_at_digits(printed);
        let stamp_s = printed.value * self.unit_s;
        let i = self.count as f64;
        self.count += 1;
        if self.count == 1 {
            (self.first_s, self.last_s) = (stamp_s, stamp_s);
            return Ok(());
        }
        let elapsed = stamp_s - self.first_s;
        let step_s = stamp_s - self.last_s;
        let resolution_s = self.unit_s * self.resolution;
        let allowed = resolution_s + CLOCK_JITTER * elapsed.abs() / i;
        let (least, most) = ((elapsed - allowed) / i, (elapsed + allowed) / i);
        // false for NaN
        let agrees = most >= self.step_least_s && least <= self.step_most_s && most > 0.0;
        if !agrees {
            self.count -= 1; // not counted: it may be the first after a gap
            if self.count == 1 && stamp_s <= self.first_s {
                return Err(RecordError::StampsStand {
                    line,
                    stamp: stamp_s,
                    before: self.first_s,
                });
            }
            let expected_step_s = self.step_s();
            return Err(RecordError::Uneven {
                line,
                stamp_s,
                step_s,
                expected_step_s,
                expected_s: self.first_s + i * expected_step_s,
            });
        }
        let same = (step_s - self.last_step_s).abs() < 0.5 * resolution_s;
        if self.count > 2 && !same && self.must_be_same(resolution_s) {
            self.count -= 1;
            return Err(RecordError::CoarseStamps {
                line,
                step_s,
                step_before_s: self.last_step_s,
                resolution_s,
            });
        }
        self.step_least_s = self.step_least_s.max(least);
        self.step_most_s = self.step_most_s.min(most);
        self.all_same &= same || self.count == 2;
        (self.last_s, self.last_step_s) = (stamp_s, step_s);
        Ok(())
    }

    /// The first stamp, s.
    pub(super) fn first_s(&self) -> f64 {
        self.first_s
    }

    /// Whether stamps of this resolution show a missing sample only if all other steps are equal.
    fn must_be_same(&self, resolution_s: f64) -> bool {
        let step_s = self
            .given_hz
            .map_or(0.5 * (self.step_least_s + self.step_most_s), |rate| 1.0 / rate);
        let steps = step_s / resolution_s;
        let coarse = steps * RESOLUTION_MOST < 1.0;
        coarse && (self.given_hz.is_none() || (steps - steps.round()).abs() < MULTIPLE * steps)
    }

    /// The rate, Hz, after the last stamp.
    pub(super) fn rate_hz(&self) -> Result<f64, RecordError> {
        let (least_hz, most_hz) = (
            1.0 / self.step_most_s,
            1.0 / self.step_least_s.max(f64::MIN_POSITIVE),
        );
        match self.given_hz {
            None if self.all_same => {
                let mean_hz = (self.count - 1) as f64 / (self.last_s - self.first_s);
                Ok(simplest_rate(
                    mean_hz * (1.0 - ROUNDING),
                    mean_hz * (1.0 + ROUNDING),
                ))
            }
            None => Ok(simplest_rate(least_hz, most_hz)),
            Some(given) => {
                let tolerance = RATE_TOLERANCE * given;
                if given >= least_hz - tolerance && given <= most_hz + tolerance {
                    Ok(given)
                } else {
                    Err(RecordError::RateDisagrees {
                        given,
                        stamps_hz: 1.0 / self.step_s(),
                    })
                }
            }
        }
    }

    /// Middle of the interval of steps that fit so far, s; its upper end while it has no lower one.
    pub(super) fn step_s(&self) -> f64 {
        if self.count < 2 {
            f64::NAN
        } else if self.step_least_s > 0.0 {
            0.5 * (self.step_least_s + self.step_most_s)
        } else {
            self.step_most_s
        }
    }

    /// Determines the value of the last printed digit of this stamp: with a fixed number of digits, larger numbers have fewer decimals. Computes
    /// it only where it can change.
    fn look_at_digits(&mut self, printed: Number) {
        let size = printed.value.abs();
        if printed.decimals <= self.decade_decimals && (self.decade.0..self.decade.1).contains(&size) {
            return;
        }
        let leading = leading(size);
        self.decade = (10f64.powi(leading - 1), 10f64.powi(leading));
        self.decade_decimals = printed.decimals;
        self.decimals = self.decimals.max(printed.decimals);
        self.digits = self.digits.max(leading + printed.decimals).min(DIGITS_MOST);
        self.resolution = 10f64.powi((-self.decimals).max(leading - self.digits));
    }
}

/// Digits before the decimal sign; less than 0 for zeros after it.
fn leading(value: f64) -> i32 {
    if value == 0.0 {
        0
    } else {
        value.abs().log10().floor() as i32 + 1
    }
}

/// Of the rates from `least` to `most`, the one with the fewest digits, in the rate or in the step.
fn simplest_rate(least: f64, most: f64) -> f64 {
    let middle = 0.5 * (least + most);
    let rounded = |x: f64, digits: usize| format!("{x:.*e}", digits - 1).parse::<f64>().unwrap_or(x);
    (1..DIGITS_MOST as usize)
        .flat_map(|digits| [rounded(middle, digits), 1.0 / rounded(1.0 / middle, digits)])
        .find(|rate| (least..=most).contains(rate))
        .unwrap_or(middle)
}
