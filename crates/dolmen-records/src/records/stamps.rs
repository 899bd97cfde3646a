//! Time stamps: checks that their steps are equal, and determines the sampling rate.
//!
//! A stamp whose last digit is worth u differs by less than u from the true time, rounded or truncated. The steps are equal if a step Δ exists
//! such that every stamp i is within u, plus 1 % of a step for the clock, of t_0 + i Δ. Each stamp narrows the interval of possible Δ, and the
//! first stamp that makes it empty is refused. If u is more than a quarter of a step, rounding could hide a missing sample: then all steps must
//! be equal, which is the case if Δ is a multiple of u, or the user must give the rate.

use super::RecordError;
use crate::number::Number;

/// Largest clock error at a sample, as a fraction of a step. Our choice: the resulting error is far below the noise of a sensor.
const CLOCK_JITTER: f64 = 0.01;
/// Relative differences of a step from the even one between which a stamp scatters: a clock that runs faster differs by less, a missing sample or a
/// clock that jumped by more. Our choice.
const SCATTER: std::ops::Range<f64> = 0.02..0.3;
/// Coarsest resolution of stamps, as a fraction of a step, that shows a missing sample; coarser stamps need equal steps. Our choice.
const RESOLUTION_MOST: f64 = 0.25;
/// Largest relative difference between a given rate and that of the stamps: an error of 1e-4 in every frequency, far below the scatter.
const RATE_TOLERANCE: f64 = 1e-4;
/// The same for the mean of stamps that scatter. Our choice: more than the clocks of recorders err, less than one lost sample in fifty.
const MEAN_TOLERANCE: f64 = 0.01;
/// Relative tolerance for a given step to be a multiple of the resolution, so that its stamps are printed without rounding.
const MULTIPLE: f64 = 1e-6;
/// Generous bound of the relative rounding error of a mean of differences of doubles.
const ROUNDING: f64 = 1e-9;
/// Decimal digits of a double.
const DIGITS_MOST: i32 = 17;

/// Source of the sampling rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum RateSource {
    /// Given by the user; there are no time stamps.
    Given,
    /// From the time stamps. Of all possible rates, the one with the fewest digits, as a rate or as a step.
    Stamps,
    /// Given by the user; the time stamps agree.
    GivenAndStamps,
    /// Given by the user; the first and the last date of a column of dates agree.
    GivenAndDates,
}

/// State of reading the time stamps.
#[derive(Clone, Debug)]
pub(super) struct Stamps {
    /// Seconds in one unit of the column.
    unit_s: f64,
    given_hz: Option<f64>,
    first_s: f64,
    last_s: f64,
    last_step_s: f64,
    /// Whether all steps are equal within half the last digit.
    all_same: bool,
    count: usize,
    /// Largest number of significant digits and of decimals in any stamp: a program prints all stamps of a file in the same format.
    digits: i32,
    decimals: i32,
    /// Value of the last digit for stamps with `decade.0` ≤ |value| < `decade.1`, in the unit of the column.
    resolution: f64,
    decade: (f64, f64),
    decade_decimals: i32,
    /// Interval of the steps that agree with all stamps so far, s.
    step_least_s: f64,
    step_most_s: f64,
    /// The first stamp that scatters, if the rate is not given: the even step is known only after the last stamp.
    scatters: Option<Scatter>,
    /// Whether only the mean of the steps is compared with the given rate.
    is_in_the_mean: bool,
}

/// A stamp that scatters about even steps.
#[derive(Clone, Copy, Debug)]
struct Scatter {
    line: usize,
    stamp_s: f64,
    step_s: f64,
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
            scatters: None,
            is_in_the_mean: false,
        }
    }

    /// Compares only the mean of the steps with the given rate, if that is so.
    pub(super) fn in_the_mean(self, is_so: bool) -> Self {
        Stamps {
            is_in_the_mean: is_so,
            ..self
        }
    }

    /// Reads the next stamp; refuses it if no constant step agrees with all stamps.
    pub(super) fn push(&mut self, printed: Number, line: usize) -> Result<(), RecordError> {
        self.look_at_digits(printed);
        let stamp_s = printed.value * self.unit_s;
        let i = self.count as f64;
        self.count += 1;
        if self.count == 1 {
            (self.first_s, self.last_s) = (stamp_s, stamp_s);
            return Ok(());
        }
        if self.scatters.is_some() || self.is_in_the_mean {
            self.last_s = stamp_s;
            return Ok(());
        }
        let elapsed = stamp_s - self.first_s;
        let step_s = stamp_s - self.last_s;
        let resolution_s = self.unit_s * self.resolution;
        let allowed = resolution_s + CLOCK_JITTER * elapsed.abs() / i;
        let (least, most) = ((elapsed - allowed) / i, (elapsed + allowed) / i);
        // false if a value is NaN
        let agrees = most >= self.step_least_s && least <= self.step_most_s && most > 0.0;
        if !agrees {
            self.count -= 1; // do not count the refused stamp: it may be the first after a gap
            if self.count == 1 && stamp_s <= self.first_s {
                return Err(RecordError::StampsStand {
                    line,
                    stamp: stamp_s,
                    before: self.first_s,
                });
            }
            let even_step_s = self.given_hz.map_or(self.step_s(), |hz| 1.0 / hz);
            if SCATTER.contains(&(step_s / even_step_s - 1.0).abs()) {
                if self.given_hz.is_none() {
                    self.scatters = Some(Scatter {
                        line,
                        stamp_s,
                        step_s,
                    });
                    self.count += 1;
                    self.last_s = stamp_s;
                    return Ok(());
                }
                return Err(RecordError::Jitter {
                    line,
                    stamp_s,
                    step_s,
                    even_step_s,
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

    /// The first stamp that scatters, with the mean step of all stamps, if the rate is not given.
    pub(super) fn scattered(&self) -> Option<RecordError> {
        self.scatters.map(|of| RecordError::Jitter {
            line: of.line,
            stamp_s: of.stamp_s,
            step_s: of.step_s,
            even_step_s: (self.last_s - self.first_s) / (self.count - 1) as f64,
        })
    }

    /// Time of the first stamp, s.
    pub(super) fn first_s(&self) -> f64 {
        self.first_s
    }

    /// Whether stamps of this resolution can show a missing sample only if all other steps are equal.
    fn must_be_same(&self, resolution_s: f64) -> bool {
        let step_s = self
            .given_hz
            .map_or(0.5 * (self.step_least_s + self.step_most_s), |rate| 1.0 / rate);
        let steps = step_s / resolution_s;
        let coarse = steps * RESOLUTION_MOST < 1.0;
        coarse && (self.given_hz.is_none() || (steps - steps.round()).abs() < MULTIPLE * steps)
    }

    /// Sampling rate, Hz, after the last stamp.
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
            Some(given) if self.is_in_the_mean => {
                let mean_hz = (self.count - 1) as f64 / (self.last_s - self.first_s);
                match (mean_hz / given - 1.0).abs() <= MEAN_TOLERANCE {
                    true => Ok(given),
                    false => Err(RecordError::RateDisagrees {
                        given,
                        stamps_hz: mean_hz,
                    }),
                }
            }
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

    /// Middle of the interval of possible steps so far, s; its upper end if it has no lower end yet.
    pub(super) fn step_s(&self) -> f64 {
        if self.count < 2 {
            f64::NAN
        } else if self.is_in_the_mean {
            (self.last_s - self.first_s) / (self.count - 1) as f64
        } else if self.step_least_s > 0.0 {
            0.5 * (self.step_least_s + self.step_most_s)
        } else {
            self.step_most_s
        }
    }

    /// Determines the value of the last printed digit of this stamp: with a fixed number of digits, larger numbers have fewer decimals. The
    /// computation is skipped if the value cannot have changed.
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

/// Number of digits before the decimal point; negative for zeros after it.
fn leading(value: f64) -> i32 {
    if value == 0.0 {
        0
    } else {
        value.abs().log10().floor() as i32 + 1
    }
}

/// The rate between `least` and `most` with the fewest digits, as a rate or as a step.
fn simplest_rate(least: f64, most: f64) -> f64 {
    let middle = 0.5 * (least + most);
    let rounded = |x: f64, digits: usize| format!("{x:.*e}", digits - 1).parse::<f64>().unwrap_or(x);
    (1..DIGITS_MOST as usize)
        .flat_map(|digits| [rounded(middle, digits), 1.0 / rounded(1.0 / middle, digits)])
        .find(|rate| (least..=most).contains(rate))
        .unwrap_or(middle)
}
