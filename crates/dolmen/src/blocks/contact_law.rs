//! The two contact laws for one stack; each checks the other.

use super::contact_points::ContactRule;
use super::error::BlocksError;
use super::history::StackHistory;
use super::rigid::{Rigid, simulate_rigid};
use super::springs::{Springs, simulate_springs};
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;

/// Contact law between stones, with its options.
#[derive(Clone, Debug, PartialEq)]
pub enum ContactLaw {
    /// Springs, dashpots and friction.
    Springs(Springs),
    /// Stones that neither deform nor overlap.
    Rigid(Rigid),
}

impl ContactLaw {
    /// Name of the law in files and on the command line.
    pub fn name(&self) -> &'static str {
        match self {
            ContactLaw::Springs(_) => "springs",
            ContactLaw::Rigid(_) => "rigid",
        }
    }

    /// Contact points of a joint.
    pub fn contact_rule(&self) -> ContactRule {
        match self {
            ContactLaw::Springs(springs) => springs.contact_rule,
            ContactLaw::Rigid(rigid) => rigid.contact_rule,
        }
    }

    /// Time between samples of the history, s.
    pub fn output_step_s(&self) -> f64 {
        match self {
            ContactLaw::Springs(springs) => springs.output_step_s,
            ContactLaw::Rigid(rigid) => rigid.output_step_s,
        }
    }

    /// Duration of a run under a motion of duration `shaken_s`, s.
    pub fn run_length_s(&self, shaken_s: f64) -> f64 {
        let (duration_s, rest_s) = match self {
            ContactLaw::Springs(springs) => (springs.duration_s, springs.rest_s),
            ContactLaw::Rigid(rigid) => (rigid.duration_s, rigid.rest_s),
        };
        duration_s.unwrap_or(shaken_s + rest_s)
    }
}

/// Motion of a stack under base motion by either law: [`simulate_springs`] or [`simulate_rigid`].
///
/// # Errors
/// As these functions.
pub fn simulate_stack(
    stack: &Stack,
    motion: Option<&GroundMotion>,
    law: &ContactLaw,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    match law {
        ContactLaw::Springs(springs) => simulate_springs(stack, motion, springs, progress),
        ContactLaw::Rigid(rigid) => simulate_rigid(stack, motion, rigid, progress),
    }
}
