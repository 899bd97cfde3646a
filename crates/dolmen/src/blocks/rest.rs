//! Settlement: the position of rest of a stack under its own weight, by Newton steps instead of a simulation.

use super::assembly::Assembly;
use super::block_skyline::SIX;
use super::error::BlocksError;
use super::forces::Forces;
use super::matrices::{
    Closed, OUTLINE_FROM, Part, add_contacts, contact_matrix, longest_step, within_outline,
};
use super::standing::check_standing;
use crate::structure::stack::{Body, Stack};
use dolmen_linalg::{Matrix, solve};
use glam::DVec3;

/// Largest number of Newton steps: contacts close or open in a few steps.
const NEWTON_STEPS: usize = 25;
/// Residual force at rest, over the weight of the stack. Our choice.
const LEFT_MOST: f64 = 1e-12;
/// Residual force that is accepted if another step does not reduce it. Our choice: in stiff joints, rounding of positions causes
/// forces.
const LEFT_ROUNDING: f64 = 1e-7;
/// Rounds of damped steps followed by Newton steps, because many loose stones open and close alternately.
const ROUNDS: usize = 12;
/// Halved Newton steps in every other round: with whole steps, contacts could close in one step and open in the next without end.
const HALF_STEPS: usize = 15;
/// Damped steps per round, and the fraction of the velocity that each removes. Our choice.
const DAMPED_STEPS: usize = 400;
const DAMPED_PART: f64 = 0.1;

struct Unbalanced {
    /// Force and torque of each block, N and N m.
    forces: Vec<f64>,
    /// The largest residual, over the weight of the stack.
    largest: f64,
    /// The block with the largest residual.
    block: usize,
}

fn unbalanced(assembly: &mut Assembly, forces: &mut Forces) -> Unbalanced {
    assembly.forces(0.0, forces);
    let weight: f64 = assembly.bodies.iter().map(|body| body.mass).sum::<f64>() * assembly.gravity;
    let mut left = Unbalanced {
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

/// Moves the bodies of an assembly to the equilibrium of gravity and springs.
///
/// # Errors
/// [`BlocksError::NoRest`] if there is no position of rest nearby: the stack does not stand, or slides; [`BlocksError::Topples`]
/// if the position of rest is unstable.
pub(super) fn settle(assembly: &mut Assembly, stack: &Stack) -> Result<(), BlocksError> {
    let mut forces = Forces::default();
    let mut closed = Closed::Touching;
    let mut iterations = 0;
    let drawn = assembly.clone();
    for round in 0..ROUNDS {
        if round > 0 {
            assembly.watch_all(stack);
            let h = 0.5 * longest_step(assembly);
            relax(assembly, &mut forces, h);
        }
        let mut least = f64::INFINITY;
        for number in 0..NEWTON_STEPS {
            let left = unbalanced(assembly, &mut forces);
            if left.largest < LEFT_MOST || (left.largest < LEFT_ROUNDING && left.largest > 0.5 * least) {
                return check_standing(assembly, stack);
            }
            if !left.largest.is_finite() || left.largest > 1e3 {
                *assembly = drawn.clone(); // it diverges: damped steps from the positions as drawn
                break;
            }
            least = least.min(left.largest);
            iterations += 1;
            let step = newton_step(assembly, closed, &left.forces);
            closed = Closed::Pressed;
            let Some(step) = step else {
                break;
            };
            let share = match !round.is_multiple_of(2) && number < HALF_STEPS {
                true => 0.5,
                false => 1.0,
            };
            for (body, step) in assembly.bodies.iter_mut().skip(1).zip(step.chunks_exact(6)) {
                body.position += share * DVec3::new(step[0], step[1], step[2]);
                body.turn_by(share * DVec3::new(step[3], step[4], step[5]));
            }
        }
    }
    let left = unbalanced(assembly, &mut forces);
    Err(BlocksError::NoRest {
        iterations,
        residual: left.largest,
        block: stack.name(Body::Block(left.block)).to_owned(),
    })
}

/// Displacements and rotations that balance these forces; `None` if a stone has no support.
fn newton_step(assembly: &Assembly, closed: Closed, forces: &[f64]) -> Option<Vec<f64>> {
    // a stone without lateral support keeps its position
    const HELD: f64 = 1e-9;
    if assembly.bodies.len() > OUTLINE_FROM {
        let mut stiffness = within_outline(assembly);
        add_contacts(assembly, Part::Springs, closed, &mut stiffness);
        stiffness.stiffen(HELD);
        stiffness.factor().then_some(())?;
        let mut right: Vec<[f64; SIX]> = forces.as_chunks().0.to_vec();
        stiffness.solve(&mut right);
        return Some(right.into_flattened());
    }
    let mut stiffness = contact_matrix(assembly, Part::Springs, closed);
    for i in 0..stiffness.rows() {
        stiffness[(i, i)] += f64::MIN_POSITIVE + HELD * stiffness[(i, i)];
    }
    let step = solve(&stiffness, &Matrix::from_column(forces)).ok()?;
    Some(step.column(0).to_vec())
}

/// Time steps under gravity with strong damping of the motion.
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

#[cfg(test)]
mod tests {
    use super::super::contact_points::ContactRule;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    /// Stones centred on each other, with their width and height in cm.
    fn tower(sizes_cm: &[[u32; 2]]) -> Stack {
        let mut z = 0.0;
        let blocks = sizes_cm.iter().enumerate().map(|(i, size_cm)| {
            let [width, height] = size_cm.map(|cm| f64::from(cm) / 100.0);
            let place = Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            };
            z += height;
            Block {
                name: format!("stone {i}"),
                solid: Solid::cuboid(width, width, height).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap()
    }

    /// Settlement of the highest stone, m: for each joint, the weight above over its stiffness.
    fn settlement_m(sizes_cm: &[[u32; 2]]) -> f64 {
        let weight = |[width, height]: &[u32; 2]| {
            let (b, h) = (f64::from(*width) / 100.0, f64::from(*height) / 100.0);
            2600.0 * 9.81 * b * b * h
        };
        let mut sum = 0.0;
        for joint in 0..sizes_cm.len() {
            let above: f64 = sizes_cm[joint..].iter().map(weight).sum();
            let own = sizes_cm[joint][0];
            let b = f64::from(
                joint
                    .checked_sub(1)
                    .map_or(own, |below| own.min(sizes_cm[below][0])),
            ) / 100.0;
            sum += above / (1e9 * b * b);
        }
        sum
    }

    #[test]
    fn exact_settlement_of_towers_whose_heights_do_not_round() {
        let mut towers: Vec<Vec<[u32; 2]>> = Vec::new();
        for plinth in [15, 25, 30, 31, 33, 35] {
            for shaft in [90, 100, 120, 150, 160, 170] {
                for cap in [10, 20, 25, 30, 33, 40] {
                    towers.push(vec![[120, plinth], [50, shaft], [60, cap]]);
                }
            }
        }
        // eight stones with heights up to a metre
        for seed in 0..60 {
            let stone = |i: u32| [150 - 7 * i, 15 + (seed * 37 + i * 29 + i * i * seed) % 85];
            towers.push((0..8).map(stone).collect());
        }
        for sizes_cm in &towers {
            let stack = tower(sizes_cm);
            let mut assembly = Assembly::of(&stack, ContactRule::Four);
            settle(&mut assembly, &stack).unwrap_or_else(|why| panic!("{sizes_cm:?}: {why}"));
            let highest = assembly.bodies.last().unwrap();
            let settled = highest.drawn.z - highest.position.z;
            let exact = settlement_m(sizes_cm);
            assert!(
                (settled / exact - 1.0).abs() < 1e-8,
                "{sizes_cm:?}: {settled} against {exact}"
            );
        }
    }
}
