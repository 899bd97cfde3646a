//! Settlement: the stack at rest under its own weight, found by Newton steps instead of waiting.

use super::assembly::{Assembly, Forces};
use super::error::BlocksError;
use super::matrices::{Part, contact_matrix};
use crate::structure::stack::{Body, Stack};
use dolmen_linalg::{Matrix, solve};
use glam::DVec3;

/// Newton steps: contact closes or opens in a few.
const STEPS_MOST: usize = 60;
/// Force left, in parts of the stack's weight, at which it rests. Chosen here.
const LEFT_MOST: f64 = 1e-12;
/// Force left that is accepted when another step betters it no more: stiff joints turn the rounding of places into force.
/// Chosen here.
const LEFT_ROUNDING: f64 = 1e-7;

/// Moves the bodies of an assembly to where gravity and springs balance.
///
/// # Errors
/// [`BlocksError::NoRest`] if there is no such place near: the stack does not stand, or slides.
pub(super) fn settle(assembly: &mut Assembly, stack: &Stack) -> Result<(), BlocksError> {
    let count = assembly.bodies.len();
    let weight: f64 = assembly.bodies.iter().map(|body| body.mass).sum::<f64>() * assembly.gravity;
    let mut forces = Forces::default();
    let mut last = (f64::INFINITY, 1);
    let mut least = f64::INFINITY;
    for _ in 0..STEPS_MOST {
        assembly.forces(0.0, &mut forces);
        let mut rest = Vec::with_capacity(6 * (count - 1));
        last = (0.0, 1);
        for index in 1..count {
            let body = &assembly.bodies[index];
            let force = forces.force[index] - DVec3::Z * (body.mass * assembly.gravity);
            let torque = forces.torque[index];
            let left = force
                .abs()
                .max_element()
                .max(torque.abs().max_element() / body.radius)
                / weight;
            if left > last.0 || left.is_nan() {
                last = (left, index);
            }
            rest.extend(force.to_array());
            rest.extend(torque.to_array());
        }
        if last.0 < LEFT_MOST || (last.0 < LEFT_ROUNDING && last.0 > 0.5 * least) {
            return Ok(());
        }
        least = least.min(last.0);
        if !last.0.is_finite() || last.0 > 1e6 {
            break;
        }
        let stiffness = contact_matrix(assembly, Part::Springs);
        let Ok(step) = solve(&stiffness, &Matrix::from_column(&rest)) else {
            break; // a block that nothing holds any more
        };
        let step = step.column(0);
        for index in 1..count {
            let at = 6 * (index - 1);
            let body = &mut assembly.bodies[index];
            body.position += DVec3::new(step[at], step[at + 1], step[at + 2]);
            body.turn_by(DVec3::new(step[at + 3], step[at + 4], step[at + 5]));
        }
    }
    Err(BlocksError::NoRest {
        iterations: STEPS_MOST,
        residual: last.0,
        block: stack.name(Body::Block(last.1 - 1)).to_owned(),
    })
}
