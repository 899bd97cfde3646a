//! Time history of a stack with slowly moving supports: it passes through equilibrium states until none exists, and then falls.

use super::contact_law::ContactLaw;
use super::error::BlocksError;
use super::frequencies::lowest_stack_modes;
use super::history::{Outcome, StackHistory};
use super::moving_ground::MovingGround;
use super::rigid::{RigidRunUnder, simulate_rigid_under};
use super::springs::simulate_springs_on;
use crate::structure::stack::Stack;
use glam::DVec3;

/// Speed and amount of the movement of supports.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowMovement {
    /// Factor on the movements of the stack at the end of the movement. Default 1.
    pub factor_most: f64,
    /// Duration of the whole movement, in multiples of the stack's own time ([`SlowGround::own_time_s`]). Default 300, our choice: a stack of
    /// several stones falls in about three own times, in which the ground completes a hundredth of the movement.
    pub own_times: f64,
}

impl Default for SlowMovement {
    fn default() -> Self {
        SlowMovement {
            factor_most: 1.0,
            own_times: 300.0,
        }
    }
}

/// Slow movement of supports for a stack, and its time scale.
#[derive(Clone, Debug, PartialEq)]
pub struct SlowGround {
    /// Motion of the ground.
    pub ground: MovingGround,
    /// T, s: the longer of √(h/g), with h the height of the stack, and the period of its lowest mode on the springs.
    pub own_time_s: f64,
}

impl SlowMovement {
    /// The movements of a stack, at a speed of `factor_most / (own_times T)`.
    ///
    /// # Errors
    /// [`BlocksError`] for options out of range, or for a stack without movements or without a position of rest on its springs.
    pub fn of(&self, stack: &Stack, law: &ContactLaw) -> Result<SlowGround, BlocksError> {
        let positive = (f64::MIN_POSITIVE, "a positive number");
        for (option, given, (least, allowed)) in [
            ("factor_most", self.factor_most, positive),
            // one own time each for the start and the end
            ("own_times", self.own_times, (2.0, "2 or more")),
            (
                "support_movements",
                stack.support_movements().len() as f64,
                (1.0, "one movement or more, with a length"),
            ),
        ] {
            if !(given >= least && given.is_finite()) {
                return Err(BlocksError::Option {
                    option,
                    given,
                    allowed,
                });
            }
        }
        let own_time_s = own_time_s(stack, law)?;
        Ok(SlowGround {
            ground: MovingGround {
                movements: stack.support_movements().to_vec(),
                factor_per_s: self.factor_most / (self.own_times * own_time_s),
                start_s: own_time_s,
                factor_most: self.factor_most,
            },
            own_time_s,
        })
    }
}

/// Factor and time at which a stack stopped following its supports.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct GaveWay {
    /// Factor on the movements.
    pub factor: f64,
    /// Time, s.
    pub at_s: f64,
}

/// A stack whose supports moved slowly.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedInTime {
    /// The movement.
    pub slow: SlowGround,
    /// The history of the run.
    pub history: StackHistory,
    /// The last time before the fall at which all stones moved with the ground; `None` if no stone fell.
    pub gave_way: Option<GaveWay>,
}

impl MovedInTime {
    /// Speed of the fastest stone, over that of the fastest support, above which stones no longer follow the ground. Our choice.
    pub const BY_ITSELF: f64 = 10.0;

    /// The factor on the movements when the first stone fell.
    pub fn fell_at(&self) -> Option<f64> {
        match self.history.outcome {
            Outcome::Fell { at_s, .. } => Some(self.slow.ground.factor_at(at_s)),
            _ => None,
        }
    }

    /// The factor at the end of the run.
    pub fn reached(&self) -> f64 {
        let end_s = self.history.time_s.last().copied().unwrap_or_default();
        self.slow.ground.factor_at(end_s)
    }
}

/// Moves the supports of a stack slowly, with either contact law. This is a second method, in addition to limit analysis, for the movement at
/// which the stack falls.
///
/// ```text
/// gave way    the last sample before the fall at which no stone was faster than ten times the fastest support
/// ```
///
/// # Errors
/// [`BlocksError`] of the law.
///
/// # Limits
/// Inertia has an effect once stones are near the end; a slower movement reduces it. With springs, hinges lie inside the edges.
pub fn move_supports(
    stack: &Stack,
    law: &ContactLaw,
    slow: &SlowGround,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<MovedInTime, BlocksError> {
    let ground = &slow.ground;
    let history = match law {
        ContactLaw::Springs(springs) => simulate_springs_on(stack, ground, springs, progress)?,
        ContactLaw::Rigid(rigid) => {
            let under = RigidRunUnder {
                moving: Some(ground),
                ..RigidRunUnder::default()
            };
            simulate_rigid_under(stack, under, rigid, progress)?
        }
    };
    Ok(MovedInTime {
        gave_way: gave_way(ground, &history),
        slow: slow.clone(),
        history,
    })
}

/// Time scale of the stack's own motion: that of a fall, or one period on its springs.
fn own_time_s(stack: &Stack, law: &ContactLaw) -> Result<f64, BlocksError> {
    let falls_s = (stack.height_m() / stack.gravity_m_s2()).sqrt();
    let swings_s = match law {
        ContactLaw::Springs(springs) => lowest_stack_modes(stack, springs.contact_rule, 1)?
            .first()
            .map_or(0.0, |mode| 1.0 / mode.frequency_hz),
        ContactLaw::Rigid(_) => 0.0,
    };
    Ok(falls_s.max(swings_s))
}

/// The last sample before a fall at which no stone was much faster than the ground.
fn gave_way(ground: &MovingGround, history: &StackHistory) -> Option<GaveWay> {
    let Outcome::Fell { at_s, .. } = history.outcome else {
        return None;
    };
    let most_m_s = MovedInTime::BY_ITSELF * ground.speed_m_s();
    let samples = history
        .time_s
        .iter()
        .take_while(|time_s| **time_s <= at_s)
        .count();
    let followed = |sample: &usize| fastest_m_s(history, *sample) <= most_m_s;
    let last = (1..samples).rev().find(followed).unwrap_or(0);
    let at_s = history.time_s[last];
    Some(GaveWay {
        factor: ground.factor_at(at_s),
        at_s,
    })
}

/// Speed of the stone with the largest motion since the last sample, m/s.
fn fastest_m_s(history: &StackHistory, sample: usize) -> f64 {
    let took_s = history.time_s[sample] - history.time_s[sample - 1];
    let ways = (0..history.blocks).map(|block| {
        let [from, to] = [sample - 1, sample].map(|at| DVec3::from(history.pose(at, block).centroid_m));
        from.distance(to)
    });
    ways.fold(0.0, f64::max) / took_s
}
