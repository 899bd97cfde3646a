//! Duration of a run. A run that ends while stones move has no verdict, so it is extended for some time.

use super::assembly::Assembly;
use super::error::BlocksError;
use super::history::StackHistory;
use super::observe::{Observer, whole_at_least};

/// Time between tests whether a run may end, s. Our choice: relevant periods are several times longer.
const AGAIN_S: f64 = 0.1;

/// Largest number of steps without confirmation by the user. Our choice: with 20 stones they take about ten minutes.
const STEPS_MOST: f64 = 2e7;
/// Largest number of history samples of such a run. Our choice: with 20 stones they take a few gigabytes.
const SAMPLES_MOST: f64 = 1e6;

/// Longest accepted time between samples of any run, s; a shorter run may have only its first sample.
const SAMPLED_AT_LEAST_S: f64 = 1.0;

/// Duration of a run, in steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct RunLength {
    /// The step of the next test.
    due: usize,
    least: usize,
    most: usize,
    again: usize,
    h: f64,
}

impl RunLength {
    /// Uses `given_s`, or the shaking, the time to rest, and up to [`StackHistory::LONGER_MOST_S`] more if the stack needs it.
    ///
    /// # Errors
    /// [`BlocksError`] if the time between samples exceeds the run, or if the run needs more than [`STEPS_MOST`] steps of `h` or
    /// [`SAMPLES_MOST`] samples and `however_long` is false.
    pub(super) fn of(
        given_s: Option<f64>,
        [shaken_s, rest_s]: [f64; 2],
        [h, output_step_s]: [f64; 2],
        however_long: bool,
    ) -> Result<Self, BlocksError> {
        let whole_s = given_s.unwrap_or(shaken_s + rest_s);
        if output_step_s > whole_s.max(SAMPLED_AT_LEAST_S) {
            return Err(BlocksError::Option {
                option: "output_step_s",
                given: output_step_s,
                allowed: "no longer than the run, or 1 s",
            });
        }
        let works = [
            (format!("steps of {h:.3e} s"), whole_s / h, STEPS_MOST),
            (
                "samples of the history".to_owned(),
                whole_s / output_step_s,
                SAMPLES_MOST,
            ),
        ];
        for (what, count, most) in works {
            // a number of steps beyond any counter is refused anyway
            if count > most && !(however_long && count < u32::MAX.into()) {
                return Err(BlocksError::TooLong { what, count, most });
            }
        }
        let least = whole_at_least(given_s.unwrap_or(shaken_s + rest_s) / h);
        let longer = match given_s {
            Some(_) => 0,
            None => whole_at_least(StackHistory::LONGER_MOST_S / h),
        };
        Ok(RunLength {
            due: whole_at_least(shaken_s / h).min(least),
            least,
            most: least + longer,
            again: whole_at_least(AGAIN_S / h),
            h,
        })
    }

    /// The same length again, from a step on.
    pub(super) fn again_from(self, step: usize) -> Self {
        RunLength {
            due: step + self.least,
            least: step + self.least,
            most: step + self.most,
            ..self
        }
    }

    pub(super) fn due(&self) -> usize {
        self.due
    }

    /// Whether the run is over after this number of steps; otherwise it continues.
    pub(super) fn is_over(&mut self, step: usize, observer: &mut Observer, assembly: &Assembly) -> bool {
        if step <= self.due {
            return false;
        }
        let may_end = observer.may_end(assembly, step as f64 * self.h);
        if self.due >= self.most || (self.due >= self.least && may_end) {
            return true;
        }
        let next = self.due + self.again;
        self.due = match self.due < self.least {
            true => next.min(self.least),
            false => next.min(self.most),
        };
        false
    }
}
