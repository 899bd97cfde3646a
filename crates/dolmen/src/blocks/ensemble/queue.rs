//! Runs that wait for a lane, and those on their way.

use super::super::error::BlocksError;
use super::super::history::StackHistory;
use super::super::springs::{Attempt, Run, Settled, Springs, simulate_springs};
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;
use std::collections::VecDeque;

/// One of many runs: the arguments of [`simulate_springs`].
#[derive(Clone, Copy, Debug)]
pub struct StackRun<'a> {
    /// The stack; runs that share one share its settlement.
    pub stack: &'a Stack,
    /// The motion of its ground.
    pub motion: Option<&'a GroundMotion>,
    /// The options.
    pub options: &'a Springs,
}

/// Runs of one number of bodies that wait for a lane.
pub(super) struct Queue<'a, 'w> {
    pub(super) waiting: VecDeque<(usize, StackRun<'a>)>,
    /// Runs that start again with a shorter step.
    pub(super) again: Vec<Ride<'a>>,
    pub(super) settled: Option<(StackRun<'a>, Settled)>,
    pub(super) progress: &'w mut dyn FnMut(usize, f64) -> bool,
    pub(super) each: &'w mut dyn FnMut(usize, Result<StackHistory, BlocksError>),
}

/// A run on its way, with its index and the attempt it is at.
pub(super) struct Ride<'a> {
    pub(super) index: usize,
    given: StackRun<'a>,
    settled: Settled,
    attempt: Attempt,
    pub(super) run: Run<'a>,
}

impl<'a> Queue<'a, '_> {
    /// The next run that goes side by side with others; those that do not, and those that can't start, are done at once.
    /// `None` when there is none left.
    pub(super) fn next(&mut self) -> Option<Ride<'a>> {
        loop {
            if let Some(ride) = self.again.pop() {
                return Some(ride);
            }
            let (index, given) = self.waiting.pop_front()?;
            let StackRun {
                stack,
                motion,
                options,
            } = given;
            match self.start(index, given) {
                Ok(ride) if ride.run.assembly.only_dry_patches() => return Some(ride),
                Ok(_) => {
                    let mut progress = |time_s| (self.progress)(index, time_s);
                    let history = simulate_springs(stack, motion, options, &mut progress);
                    (self.each)(index, history);
                }
                Err(error) => (self.each)(index, Err(error)),
            }
        }
    }

    /// Hands the history of a run on, or has it start again with a shorter step.
    pub(super) fn end(&mut self, ride: Ride<'a>) {
        let StackRun {
            stack,
            motion,
            options,
        } = ride.given;
        let attempt = match ride.attempt.judge(ride.run.finish(), options) {
            Ok(history) => return (self.each)(ride.index, Ok(history)),
            Err(again) => again,
        };
        match Run::new(stack, &ride.settled, motion, options, attempt.h) {
            Ok(run) => self.again.push(Ride { attempt, run, ..ride }),
            Err(error) => (self.each)(ride.index, Err(error)),
        }
    }

    fn start(&mut self, index: usize, given: StackRun<'a>) -> Result<Ride<'a>, BlocksError> {
        let StackRun {
            stack,
            motion,
            options,
        } = given;
        let same = |(of, _): &&(StackRun<'_>, Settled)| {
            std::ptr::eq(of.stack, stack) && std::ptr::eq(of.options, options)
        };
        let settled = match self.settled.as_ref().filter(same) {
            Some((_, settled)) => settled.clone(),
            None => Settled::of(stack, options)?,
        };
        let attempt = Attempt::first(&settled);
        let run = Run::new(stack, &settled, motion, options, attempt.h)?;
        self.settled = Some((given, settled.clone()));
        Ok(Ride {
            index,
            given,
            settled,
            attempt,
            run,
        })
    }
}
