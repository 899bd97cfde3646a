//! Ground that moves slowly under single stones: how far it is at a time, and the bodies that stand for it.
//!
//! Each stone whose support moves stands on a half-space of its own. It has no mass, and nothing that presses on it changes its movement.

use super::assembly::Assembly;
use super::bodies::RigidBody;
use crate::structure::stack::{Stack, SupportMovement};
use glam::DVec3;
use std::f64::consts::PI;

/// Supports that move: from rest to a constant speed r, and in the same way to rest again.
///
/// ```text
/// factor(t) = r (t − (t₀/π) sin(π t/t₀))/2      up to t₀
///           = r (t − t₀/2)                      after it
///           = factor_most − factor(D − t)       in the last t₀,   D = factor_most/r + t₀
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MovingGround {
    /// Each movement at a factor of 1.
    pub movements: Vec<SupportMovement>,
    /// Factor on the movements that is added each second at full speed, 1/s.
    pub factor_per_s: f64,
    /// Time from rest to full speed, and back, s; at most as long as the whole takes at full speed.
    pub start_s: f64,
    /// Factor at which the ground stands still again.
    pub factor_most: f64,
}

impl MovingGround {
    /// The factor on the movements at a time.
    pub fn factor_at(&self, time_s: f64) -> f64 {
        let left_s = self.duration_s() - time_s;
        match left_s < self.start_s {
            true => self.factor_most - self.way_since_rest(left_s),
            false => self.way_since_rest(time_s),
        }
    }

    fn way_since_rest(&self, time_s: f64) -> f64 {
        let (t, start_s) = (time_s.max(0.0), self.start_s);
        let factor = match t < start_s {
            true => 0.5 * (t - start_s / PI * (PI * t / start_s).sin()),
            false => t - 0.5 * start_s,
        };
        self.factor_per_s * factor
    }

    /// Until it stands still again, s.
    pub fn duration_s(&self) -> f64 {
        self.start_s + self.factor_most / self.factor_per_s
    }

    /// Speed of the support that moves fastest, m/s.
    pub fn speed_m_s(&self) -> f64 {
        self.factor_per_s * self.longest_m()
    }

    /// Length of the longest movement at a factor of 1, m.
    pub fn longest_m(&self) -> f64 {
        let each = self.movements.iter().map(SupportMovement::length_m);
        each.fold(0.0, f64::max)
    }

    /// What the ground under each stone moves by at a factor of 1: stone, m.
    fn under_stones(&self, stack: &Stack) -> Vec<(usize, DVec3)> {
        let mut under: Vec<(usize, DVec3)> = Vec::new();
        for movement in &self.movements {
            let by = DVec3::from(movement.movement_m);
            match under.iter_mut().find(|(block, _)| *block == movement.block) {
                Some((_, sum)) => *sum += by,
                None if movement.block < stack.blocks().len() => under.push((movement.block, by)),
                None => {}
            }
        }
        under
    }
}

/// The bodies of ground that moves, in an assembly.
#[derive(Clone, Debug, Default)]
pub(super) struct OwnGround {
    movement: Option<MovingGround>,
    /// Each body with its displacement at a factor of 1, m.
    bodies: Vec<(usize, DVec3)>,
}

impl OwnGround {
    /// Puts the stones of an assembly at rest on ground of their own.
    pub(super) fn under(assembly: &mut Assembly, stack: &Stack, movement: &MovingGround) -> Self {
        let under = movement.under_stones(stack);
        let each = under.iter();
        OwnGround {
            bodies: each
                .map(|(block, by)| (assembly.put_on_own_ground(block + 1), *by))
                .collect(),
            movement: Some(movement.clone()),
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.bodies.is_empty()
    }

    /// Puts the ground where it is at a time, with the velocity that it has over the next `h` s.
    pub(super) fn place(&self, bodies: &mut [RigidBody], time_s: f64, h: f64) {
        let Some(movement) = &self.movement else { return };
        let factor = movement.factor_at(time_s);
        let per_s = (movement.factor_at(time_s + h) - factor) / h;
        for (body, by) in &self.bodies {
            let body = &mut bodies[*body];
            let to = *by * factor;
            body.travel += to.distance(body.position);
            body.position = to;
            body.velocity = *by * per_s;
        }
    }
}
