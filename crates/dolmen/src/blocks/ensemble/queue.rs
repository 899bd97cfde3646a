//! Queue of runs that wait for a lane; runs in a lane.

use super::super::error::BlocksError;
use super::super::history::StackHistory;
use super::super::springs::{Attempt, Run, SettledStack, Springs, simulate_springs};
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;
use std::collections::VecDeque;

/// One of many runs: the arguments of [`simulate_springs`].
#[derive(Clone, Copy, Debug)]
pub struct StackRun<'a> {
    /// The stack; runs of the same stack share its settlement.
    pub stack: &'a Stack,
    /// The motion of its ground.
    pub motion: Option<&'a GroundMotion>,
    /// The options.
    pub options: &'a Springs,
}

/// Runs with the same number of bodies that wait for a lane.
pub(super) struct Queue<'a, 'w> {
    pub(super) waiting: VecDeque<(usize, StackRun<'a>)>,
    /// Runs that start again with a shorter step.
    pub(super) again: Vec<LaneRun<'a>>,
    pub(super) settled: Option<(StackRun<'a>, SettledStack)>,
    pub(super) progress: &'w mut dyn FnMut(usize, f64) -> bool,
    pub(super) each: &'w mut dyn FnMut(usize, Result<StackHistory, BlocksError>),
}

/// A run in a lane, with its index and the number of the attempt.
pub(super) struct LaneRun<'a> {
    pub(super) index: usize,
    given: StackRun<'a>,
    settled: SettledStack,
    attempt: Attempt,
    pub(super) run: Run<'a>,
}

impl<'a> Queue<'a, '_> {
    /// The next run that can be computed side by side with others. Runs that cannot, or that fail to start, are
    /// completed immediately. `None` if no run is left.
    pub(super) fn next(&mut self) -> Option<LaneRun<'a>> {
        loop {
            if let Some(lane_run) = self.again.pop() {
                return Some(lane_run);
            }
            let (index, given) = self.waiting.pop_front()?;
            let StackRun {
                stack,
                motion,
                options,
            } = given;
            match self.start(index, given) {
                Ok(lane_run) if lane_run.run.assembly.runs_side_by_side() => return Some(lane_run),
                Ok(_) => {
                    let mut progress = |time_s| (self.progress)(index, time_s);
                    let history = simulate_springs(stack, motion, options, &mut progress);
                    (self.each)(index, history);
                }
                Err(error) => (self.each)(index, Err(error)),
            }
        }
    }

    /// Passes on the history of a run, or restarts it with a shorter step.
    pub(super) fn end(&mut self, lane_run: LaneRun<'a>) {
        let StackRun {
            stack,
            motion,
            options,
        } = lane_run.given;
        let attempt = match lane_run.attempt.judge(lane_run.run.finish(), options) {
            Ok(history) => return (self.each)(lane_run.index, Ok(history)),
            Err(again) => again,
        };
        match Run::new(stack, &lane_run.settled, motion, options, attempt.h) {
            Ok(run) => self.again.push(LaneRun {
                attempt,
                run,
                ..lane_run
            }),
            Err(error) => (self.each)(lane_run.index, Err(error)),
        }
    }

    fn start(&mut self, index: usize, given: StackRun<'a>) -> Result<LaneRun<'a>, BlocksError> {
        let StackRun {
            stack,
            motion,
            options,
        } = given;
        let same = |(of, _): &&(StackRun<'_>, SettledStack)| {
            std::ptr::eq(of.stack, stack) && std::ptr::eq(of.options, options)
        };
        let settled = match self.settled.as_ref().filter(same) {
            Some((_, settled)) => settled.clone(),
            None => SettledStack::of(stack, options)?,
        };
        let attempt = Attempt::first(&settled);
        let run = Run::new(stack, &settled, motion, options, attempt.h)?;
        self.settled = Some((given, settled.clone()));
        Ok(LaneRun {
            index,
            given,
            settled,
            attempt,
            run,
        })
    }
}
