//! Settlement: the stack at rest under its own weight, found by Newton steps instead of waiting.

use super::assembly::{Assembly, Forces};
use super::error::BlocksError;
use super::matrices::{Closed, Part, contact_matrix, longest_step};
use super::standing::check_standing;
use crate::structure::stack::{Body, Stack};
use dolmen_linalg::{Matrix, solve};
use glam::DVec3;

/// Newton steps: contact closes or opens in a few.
const NEWTON_STEPS: usize = 25;
/// Force left, in parts of the stack's weight, at which it rests. Chosen here.
const LEFT_MOST: f64 = 1e-12;
/// Force left that is accepted when another step betters it no more: stiff joints turn the rounding of places into force.
/// Chosen here.
const LEFT_ROUNDING: f64 = 1e-7;
/// Rounds of damped steps and Newton steps after them: many loose stones take turns to open and close.
const ROUNDS: usize = 12;
/// Damped steps a round, and the part of the velocity that each takes. Chosen here.
const DAMPED_STEPS: usize = 400;
const DAMPED_PART: f64 = 0.1;

/// Forces left on the blocks.
struct Left {
    /// Force and torque of each block, N and N m.
    forces: Vec<f64>,
    /// The largest, in parts of the stack's weight.
    largest: f64,
    /// On which block.
    block: usize,
}

fn left(assembly: &mut Assembly, forces: &mut Forces) -> Left {
    assembly.forces(0.0, forces);
    let weight: f64 = assembly.bodies.iter().map(|body| body.mass).sum::<f64>() * assembly.gravity;
    let mut left = Left {
        forces: Vec::with_capacity(6 * assembly.bodies.len()),
        largest: 0.0,
        block: 0,
    };
    for (index, body) in assembly.bodies.iter().enumerate().skip(1) {
        let force = forces.force[index] - DVec3::Z * (body.mass * assembly.gravity);
        let torque = forces.torque[index];
        let part = force
            .abs()
            .max_element()
            .max(torque.abs().max_element() / body.radius)
            / weight;
        if part > left.largest || part.is_nan() {
            (left.largest, left.block) = (part, index - 1);
        }
        left.forces.extend(force.to_array());
        left.forces.extend(torque.to_array());
    }
    left
}

/// Moves the bodies of an assembly to where gravity and springs balance.
///
/// # Errors
/// [`BlocksError::NoRest`] if there is no such place near: the stack does not stand, or slides;
/// [`BlocksError::Topples`] if there is one from which any touch would topple it.
pub(super) fn settle(assembly: &mut Assembly, stack: &Stack) -> Result<(), BlocksError> {
    let mut forces = Forces::default();
    let mut closed = Closed::Touching;
    let mut iterations = 0;
    for round in 0..ROUNDS {
        if round > 0 {
            let h = 0.5 * longest_step(assembly);
            relax(assembly, &mut forces, h);
        }
        let mut least = f64::INFINITY;
        for _ in 0..NEWTON_STEPS {
            let left = left(assembly, &mut forces);
            if left.largest < LEFT_MOST || (left.largest < LEFT_ROUNDING && left.largest > 0.5 * least) {
                return check_standing(assembly, stack);
            }
            if !left.largest.is_finite() || left.largest > 1e3 {
                break; // it flies apart
            }
            least = least.min(left.largest);
            iterations += 1;
            let mut stiffness = contact_matrix(assembly, Part::Springs, closed);
            closed = Closed::Pressed;
            // a stone that nothing holds sideways keeps its place
            for i in 0..stiffness.rows() {
                stiffness[(i, i)] += f64::MIN_POSITIVE + 1e-9 * stiffness[(i, i)];
            }
            let Ok(step) = solve(&stiffness, &Matrix::from_column(&left.forces)) else {
                break;
            };
            let step = step.column(0);
            for (body, step) in assembly.bodies.iter_mut().skip(1).zip(step.chunks_exact(6)) {
                body.position += DVec3::new(step[0], step[1], step[2]);
                body.turn_by(DVec3::new(step[3], step[4], step[5]));
            }
        }
    }
    let left = left(assembly, &mut forces);
    Err(BlocksError::NoRest {
        iterations,
        residual: left.largest,
        block: stack.name(Body::Block(left.block)).to_owned(),
    })
}

/// Steps under gravity in which much of the motion is taken away.
fn relax(assembly: &mut Assembly, forces: &mut Forces, h: f64) {
    let gravity = DVec3::new(0.0, 0.0, -assembly.gravity);
    for _ in 0..DAMPED_STEPS {
        assembly.look();
        assembly.forces(h, forces);
        for (index, body) in assembly.bodies.iter_mut().enumerate().skip(1) {
            body.velocity *= 1.0 - DAMPED_PART;
            body.momentum *= 1.0 - DAMPED_PART;
            let acceleration = forces.force[index] * body.inverse_mass + gravity;
            body.step(acceleration, forces.torque[index], h, h);
        }
    }
    for body in assembly.bodies.iter_mut().skip(1) {
        body.velocity = DVec3::ZERO;
        body.momentum = DVec3::ZERO;
        body.spin = DVec3::ZERO;
    }
}
