//! Slow movement of the ground under single stones: its displacement over time, and the bodies that represent it.
//!
//! Each stone with a moving support stands on its own half-space. This half-space has a prescribed movement, which contact forces do not
//! change.

use super::assembly::Assembly;
use super::bodies::RigidBody;
use crate::structure::stack::{Stack, SupportMovement};
use glam::DVec3;
use std::f64::consts::PI;

/// Movement of supports: from rest to a constant speed r, and symmetrically back to rest.
///
/// ```text
/// factor(t) = r (t − (t₀/π) sin(π t/t₀))/2      up to t₀
///           = r (t − t₀/2)                      after it
///           = factor_most − factor(D − t)       in the last t₀,   D = factor_most/r + t₀
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct MovingGround {
    /// Each movement, for a factor of 1.
    pub movements: Vec<SupportMovement>,
    /// Increase of the factor per second at full speed, r, 1/s.
    pub factor_per_s: f64,
    /// Time t₀ from rest to full speed, and back to rest, s; at most the duration of the whole movement at full speed.
    pub start_s: f64,
    /// Factor at which the ground comes to rest again.
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

    /// Time until the ground is at rest again, s.
    pub fn duration_s(&self) -> f64 {
        self.start_s + self.factor_most / self.factor_per_s
    }

    /// Largest speed of any support, m/s.
    pub fn speed_m_s(&self) -> f64 {
        self.factor_per_s * self.longest_m()
    }

    /// Length of the longest movement at a factor of 1, m.
    pub fn longest_m(&self) -> f64 {
        let each = self.movements.iter().map(SupportMovement::length_m);
        each.fold(0.0, f64::max)
    }

    /// Displacement of the ground under each stone at a factor of 1: index of the stone, displacement in m.
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

/// The moving ground bodies of an assembly.
#[derive(Clone, Debug, Default)]
pub(super) struct OwnGround {
    movement: Option<MovingGround>,
    /// Index of each body, and its displacement at a factor of 1, m.
    bodies: Vec<(usize, DVec3)>,
}

impl OwnGround {
    /// Adds a ground body under each stone of an assembly whose support moves.
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

    /// Sets the position of the ground at a time, and its mean velocity over the next `h` s.
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
