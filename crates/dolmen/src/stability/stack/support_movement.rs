//! A stack with moving supports: the joints that open, the forces of the supports, and the movement at which it falls.

use super::moved_supports::{MovedStack, MovedSupports, MovementEnding, SupportMovementOptions};
use super::movement_path::{JumpEnd, Path, StepOutcome};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;

/// Movement of the first state, over the size of the stack. Our choice: joints open by about as much.
const SMALL: f64 = 1e-4;
/// Smallest step of the movement, over the size of the stack: a stack that needs a smaller step falls. Our choice: 0.02 mm per metre.
const STEP_LEAST: f64 = 2e-5;

/// Follows a stack while the ground under some of its stones moves, from its drawn shape until no joint forces balance its weight.
///
/// ```text
/// each step   for a small part of the given movement, the motion of all stones without penetration that loses most potential energy
/// then        the stones move by finite rotations; joints are found again where faces still overlap; the next step
/// jumps       if stones move too far even in the smallest step: they move on in parts of it, with the ground nearly at rest, until they rest again
/// falls       if they find no rest nearby, or if the weight is not balanced
/// ```
///
/// # Errors
/// [`StabilityError`] for options out of their range, a stack without such movements, or a programme that was not solved.
///
/// # Limits
/// The movement is slow; the speed that stones gain in a jump is left out. Stone is rigid and infinitely strong; bond, ties and side supports
/// are left out. Only joints as drawn are included: new contacts of stones are not detected. Sliding follows Coulomb's law to the first order of
/// the step. Of equally loaded joints, the first one to slide is arbitrary. Until joints have opened, the positions of cracks are not determined.
///
/// # Source
/// Ochsendorf (2006) for arches on spreading supports; Portioli & Cascini (2017) for the step.
pub fn follow_support_movement(
    stack: &Stack,
    options: &SupportMovementOptions,
) -> Result<MovedSupports, StabilityError> {
    let mut path = Path::of(stack, options)?;
    let size = path.size;
    let largest = path.unit.iter().map(|u| u.length()).fold(0.0, f64::max);
    if largest <= 0.0 {
        return Err(StabilityError::Option {
            option: "support_movements",
            given: largest,
            allowed: "one movement or more, with a length",
        });
    }
    let [small, least] = [SMALL, STEP_LEAST].map(|share| share * size / largest);
    let most = options.movement_most * size / largest;
    let mut ahead = small;
    let (mut first, mut given): (Option<MovedStack>, Option<MovedStack>) = (None, None);
    let mut falls_by: Option<f64> = None;
    let mut before: Option<(Path<'_>, f64)> = None;
    let mut ending = MovementEnding::NotFollowed;
    let mut jumps = Vec::new();
    while path.steps < options.steps_most {
        let mut to = path.factor + ahead;
        if given.is_none() && path.factor < 1.0 && to > 1.0 - 0.5 * least {
            to = 1.0;
        }
        let path_factor = path.factor;
        let from = path.clone();
        match path.try_step(to) {
            StepOutcome::Taken { share } => {
                before = Some((from, to - path_factor));
                if first.is_none() {
                    first = Some(path.state());
                }
                let grows = falls_by.is_none() && share < 0.5;
                ahead *= if grows { 1.5 } else { 1.0 };
            }
            not_taken => {
                falls_by = Some(falls_by.map_or(to, |by| by.min(to)));
                ahead = 0.5 * (to - path.factor);
                if ahead < least {
                    // only the next step shows whether a state stands: go back and approach in smaller steps
                    if let Some((before, taken)) = before.take().filter(|(_, taken)| *taken > least) {
                        let steps = path.steps;
                        path = before;
                        path.steps = steps;
                        ahead = (0.25 * taken).max(0.5 * least);
                        given = given.filter(|state| state.factor <= path.factor);
                        falls_by = Some(to);
                        continue;
                    }
                    let mut beyond = path.clone();
                    let jumped = match not_taken {
                        StepOutcome::Falls => beyond.jump(to, options.steps_most),
                        _ => JumpEnd::NotSolved,
                    };
                    path.steps = beyond.steps;
                    match jumped {
                        JumpEnd::Rests(jump) => {
                            jumps.push(jump);
                            (path, ahead, falls_by, before) = (beyond, least, None, None);
                        }
                        JumpEnd::Falls => {
                            ending = MovementEnding::Falls { by_factor: to };
                            break;
                        }
                        JumpEnd::NotSolved => break,
                    }
                }
            }
        }
        if given.is_none() && path.factor == 1.0 {
            given = Some(path.state());
        }
        if path.factor >= most {
            if given.is_some() {
                ending = MovementEnding::Stands;
            }
            break;
        }
        // the failure may be due to too large a step
        if falls_by.is_some_and(|by| path.factor >= by * (1.0 - 1e-12)) {
            falls_by = None;
        }
    }
    let last = path.state();
    Ok(MovedSupports {
        small: first.unwrap_or_else(|| last.clone()),
        given,
        last,
        jumps,
        ending,
        residual: path.residual,
        steps: path.steps,
    })
}

#[cfg(test)]
mod tests {
    use super::super::MovedSupports;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, SupportMovement};

    fn block(name: &str, size: [f64; 3], position_m: [f64; 3]) -> Block {
        let place = Placement {
            position_m,
            ..Placement::default()
        };
        Block {
            name: name.into(),
            solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
            density_kg_m3: 2600.0,
        }
    }

    /// Two pillars 0.4 m wide with a lintel, on joints with these friction coefficients; the right pillar moves.
    fn lintel(frictions: [f64; 2], movement_m: [f64; 3]) -> MovedSupports {
        let blocks = vec![
            block("left", [0.4, 0.4, 1.0], [-0.8, 0.0, 0.0]),
            block("right", [0.4, 0.4, 1.0], [0.8, 0.0, 0.0]),
            block("lintel", [2.0, 0.4, 0.3], [0.0, 0.0, 1.0]),
        ];
        let mut stack = Stack::new(blocks, JointMaterial::with_friction(2.0), 9.81).unwrap();
        for (joint, friction) in [(2, frictions[0]), (3, frictions[1])] {
            let material = JointMaterial::with_friction(friction);
            stack = stack.with_material(joint, material).unwrap();
        }
        let movement = SupportMovement { block: 1, movement_m };
        let stack = stack.with_support_movement(movement).unwrap();
        // it falls at a sixth of its size
        let options = SupportMovementOptions {
            movement_most: 0.5,
            ..SupportMovementOptions::default()
        };
        follow_support_movement(&stack, &options).unwrap()
    }

    #[test]
    fn exact_a_stone_goes_with_its_ground() {
        let stack = Stack::new(
            vec![block("stone", [0.4, 0.4, 2.0], [0.0; 3])],
            JointMaterial::default(),
            9.81,
        );
        let movement = SupportMovement {
            block: 0,
            movement_m: [0.01, -0.02, -0.03],
        };
        let stack = stack.unwrap().with_support_movement(movement).unwrap();
        let found = follow_support_movement(&stack, &SupportMovementOptions::default()).unwrap();
        assert_eq!(found.ending, MovementEnding::Stands);
        let given = found.given.unwrap();
        let [x, y, z] = given.solids[0].centroid_m();
        assert!((x - 0.01).abs() < 1e-9 && (y + 0.02).abs() < 1e-9 && (z - 0.97).abs() < 1e-9);
        let [along, across, up] = given.reactions[0].force_n;
        let weight = 0.32 * 2600.0 * 9.81;
        assert!(along.abs() + across.abs() < 1e-6 * weight && (up / weight - 1.0).abs() < 1e-8);
        assert!(given.mechanism.is_none() && given.slip_m < 1e-9);
    }

    #[test]
    fn exact_a_lintel_falls_when_it_has_slid_off_the_smoother_pillar() {
        for (frictions, name) in [([0.2, 0.6], "left"), ([0.6, 0.2], "right")] {
            let found = lintel(frictions, [0.1, 0.0, 0.0]);
            let fell_at = 0.1 * found.last.factor;
            assert!(matches!(found.ending, MovementEnding::Falls { .. }));
            assert!((fell_at - 0.4).abs() < 1e-3, "{name}: {fell_at}");
            assert!(
                (found.last.slip_m - fell_at).abs() < 1e-3,
                "{name}: {}",
                found.last.slip_m
            );
            // the joint with less friction slides at the friction of its load: 0.375 to 0.625 of the lintel, depending on its position
            let drags = [0.375, 0.625].map(|share| 0.2 * share * 0.24 * 2600.0 * 9.81);
            let [left, right] = [0, 1].map(|at| found.small.reactions[at].force_n[0]);
            assert!((left + right).abs() < 1e-6 * drags[0], "{left} {right}");
            assert!(
                right > drags[0] - 1e-3 && right < drags[1] + 1e-3,
                "{right} {drags:?}"
            );
        }
    }

    #[test]
    fn exact_a_lintel_turns_with_a_pillar_that_settles() {
        let found = lintel([0.6, 0.6], [0.0, 0.0, -0.02]);
        // it rotates about the inner edge of the left pillar and lies on the outer edge of the right one, 0.6 and 1 m from its middle
        let mechanism = found.small.mechanism.unwrap();
        let places: Vec<f64> = mechanism
            .joints
            .iter()
            .filter_map(|joint| Some(joint.closed_at_m?[0]))
            .collect();
        assert_eq!(places.len(), 2, "{mechanism:?}");
        assert!(
            (places[0] + 0.6).abs() < 1e-6 && (places[1] - 1.0).abs() < 1e-6,
            "{places:?}"
        );
        for (at, share) in [(0, 1.0 / 1.6), (1, 0.6 / 1.6)] {
            let weight = (0.24 * share + 0.16) * 2600.0 * 9.81;
            let up = found.small.reactions[at].force_n[2];
            assert!((up / weight - 1.0).abs() < 1e-6, "{up} {weight}");
        }
        assert!(found.given.is_some());
    }

    #[test]
    fn refuses_options_out_of_range_and_no_movement() {
        let blocks = vec![block("stone", [0.4, 0.4, 2.0], [0.0; 3])];
        let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
        let options = SupportMovementOptions::default();
        let fault = follow_support_movement(&stack, &options).unwrap_err().to_string();
        assert!(fault.starts_with("support_movements is 0"), "{fault}");
        let options = SupportMovementOptions { step: 0.0, ..options };
        assert!(follow_support_movement(&stack, &options).is_err());
    }
}
