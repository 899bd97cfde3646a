//! How long a run is: one that ends while stones move has no verdict, so that it goes on for a while.

use super::assembly::Assembly;
use super::history::StackHistory;
use super::observe::{Observer, whole_at_least};

/// Time between looks at whether a run may end, s. Chosen here: swings that matter take several times as long.
const AGAIN_S: f64 = 0.1;

/// How long a run is, in steps.
#[derive(Clone, Copy, Debug)]
pub(super) struct RunLength {
    /// After which it is judged next.
    due: usize,
    least: usize,
    most: usize,
    again: usize,
    h: f64,
}

impl RunLength {
    /// `given_s`; or the shaking, the time to rest, and as much more, up to [`StackHistory::LONGER_MOST_S`], as the stack needs.
    pub(super) fn of(given_s: Option<f64>, [shaken_s, rest_s]: [f64; 2], h: f64) -> Self {
        let least = whole_at_least(given_s.unwrap_or(shaken_s + rest_s) / h);
        let longer = match given_s {
            Some(_) => 0,
            None => whole_at_least(StackHistory::LONGER_MOST_S / h),
        };
        RunLength {
            due: whole_at_least(shaken_s / h).min(least),
            least,
            most: least + longer,
            again: whole_at_least(AGAIN_S / h),
            h,
        }
    }

    /// The steps after which it is to be judged next.
    pub(super) fn due(&self) -> usize {
        self.due
    }

    /// Whether the run is over after so many steps; one that is not goes on.
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
