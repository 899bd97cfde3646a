//! A stack with moving supports: the joints that open, the forces of the supports, and the movement at which it falls.

use super::loads::{Load, StackLoads};
use super::mechanism::{JointMotion, Mechanism, MovingJoint};
use super::moved_contacts::{BlockPose, Contact, Corner, Faces, faces_of};
use super::movement_programme::{BlockDeadLoad, Motion, Stage, Step, step};
use crate::stability::StabilityError;
use crate::structure::stack::{Solid, Stack};
use glam::DVec3;

/// Options of moving supports.
#[derive(Clone, Debug, PartialEq)]
pub struct SupportMovementOptions {
    /// Loads in addition to the weight, with constant direction. Default none.
    pub loads: StackLoads,
    /// Largest rotation of a stone, rad, and largest displacement over the size of the stack, in one step. Default 0.004, our choice: half of it
    /// changes the movement at collapse of an arch with t/R = 0.15 by less than 0.1 %.
    pub step: f64,
    /// Movement at which the analysis ends, over the size of the stack. Default 0.1, our choice: beyond any repair, and stones that come to touch
    /// anew are not seen.
    pub movement_most: f64,
    /// Largest number of steps, including rejected ones. Default 1000, our choice.
    pub steps_most: usize,
}

impl Default for SupportMovementOptions {
    fn default() -> Self {
        SupportMovementOptions {
            loads: StackLoads::default(),
            step: 0.004,
            movement_most: 0.1,
            steps_most: 1000,
        }
    }
}

/// Force of the ground on one block.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportReaction {
    /// The block.
    pub block: usize,
    /// Force of the ground on the block, N, z up.
    pub force_n: [f64; 3],
}

/// A stack at one stage of the movement.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedStack {
    /// Factor on the given movement.
    pub factor: f64,
    /// Its stones at this stage.
    pub solids: Vec<Solid>,
    /// Joints that have opened or slipped since the stack was drawn.
    pub mechanism: Option<Mechanism>,
    /// Force on each support, in the order of the blocks.
    pub reactions: Vec<SupportReaction>,
    /// Largest slip in a closed joint so far, m.
    pub slip_m: f64,
}

/// Stones that move on by themselves until they rest again, while the supports stand still: open joints close and others open.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SupportJump {
    /// Factor on the given movement at which it begins.
    pub factor: f64,
    /// Largest displacement of a stone, m.
    pub moved_m: f64,
    /// Largest rotation of a stone, rad.
    pub turned_rad: f64,
}

/// End of the analysis.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum MovementEnding {
    /// Beyond the last state, within less than one step, no joint forces balance the weight, and the stones find no other rest nearby.
    Falls {
        /// Factor on the given movement at which the stack falls.
        by_factor: f64,
    },
    /// The stack stood until the largest movement of the analysis.
    Stands,
    /// A step was not solved, the number of steps did not suffice, or the given movement is larger than the largest of the analysis: the result
    /// is unknown.
    NotFollowed,
}

/// Result of moving supports.
#[derive(Clone, Debug, PartialEq)]
pub struct MovedSupports {
    /// State after a very small movement, in which only the first joints have opened.
    pub small: MovedStack,
    /// State after the given movement; `None` if the stack falls before.
    pub given: Option<MovedStack>,
    /// The last state in which the stack stood.
    pub last: MovedStack,
    /// Jumps on the way there, in their order.
    pub jumps: Vec<SupportJump>,
    /// End of the analysis.
    pub ending: MovementEnding,
    /// Largest error of equilibrium in any step, over the weight.
    pub residual: f64,
    /// Number of steps tried.
    pub steps: usize,
}

impl MovedSupports {
    /// Slip in closed joints divided by the size of the stack: above this value, the movement at collapse depends on friction. Our choice.
    pub const SLIP_TELLS: f64 = 1e-3;
    /// Factor on the given movement below which a standing stack is marginal. Our choice, as for loads.
    pub const MARGINAL_BELOW: f64 = 1.5;
}

/// Movement of the first state, over the size of the stack. Our choice: joints open by about as much.
const SMALL: f64 = 1e-4;
/// Smallest step of the movement, over the size of the stack: a stack that needs a smaller step falls. Our choice: 0.02 mm per metre.
const STEP_LEAST: f64 = 2e-5;
/// Largest rotation of a stone, rad, and largest displacement over the size of the stack, in a jump: stones that move farther fall. Our choice: an
/// arch of 15 voussoirs jumps by 0.016 rad when a hinge changes its joint.
const JUMP_TURN: f64 = 0.1;
const JUMP_SHIFT: f64 = 0.05;
/// Gaps and slips below this fraction of the largest are not reported. Our choice, as in the limit analysis.
const NAMED_LEAST: f64 = 1e-3;
/// The same for this fraction of the movement, if it is larger. Our choice.
const NAMED_OF_MOVEMENT: f64 = 0.1;

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
                        path = Path { steps, ..before };
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

#[derive(Clone, Copy, PartialEq)]
enum StepOutcome {
    /// Stones moved by this fraction of the largest step.
    Taken {
        share: f64,
    },
    /// The stones would move too far, or no forces are in equilibrium.
    Falls,
    NotSolved,
}

/// End of a jump.
enum JumpEnd {
    /// The stones found another rest.
    Rests(SupportJump),
    /// They moved too far, or no forces are in equilibrium.
    Falls,
    NotSolved,
}

/// A stack during the movement.
#[derive(Clone)]
struct Path<'a> {
    stack: &'a Stack,
    faces: Vec<Faces>,
    dead: Vec<BlockDeadLoad>,
    /// The given movement under each block, m.
    unit: Vec<DVec3>,
    size: f64,
    step: f64,
    weight: f64,
    factor: f64,
    moved: Vec<BlockPose>,
    contacts: Vec<Contact>,
    reactions: Vec<DVec3>,
    /// Largest displacement of a stone in the last step, m.
    last_m: f64,
    /// Largest slip of a closed corner so far, m.
    slip_m: f64,
    residual: f64,
    steps: usize,
}

impl<'a> Path<'a> {
    fn of(stack: &'a Stack, options: &SupportMovementOptions) -> Result<Self, StabilityError> {
        for (option, given) in [("step", options.step), ("movement_most", options.movement_most)] {
            if !(given > 0.0 && given <= 1.0) {
                return Err(StabilityError::Option {
                    option,
                    given,
                    allowed: "above 0 and at most 1",
                });
            }
        }
        let loads = options.loads.on_blocks(stack)?;
        let mut unit = vec![DVec3::ZERO; loads.len()];
        for movement in stack.support_movements() {
            unit[movement.block] += DVec3::from(movement.movement_m);
        }
        let bounds = stack.blocks().iter().map(|block| block.solid.bounds_m());
        let all = bounds.fold([DVec3::INFINITY, DVec3::NEG_INFINITY], |all, [low, high]| {
            [all[0].min(low.into()), all[1].max(high.into())]
        });
        let mut path = Path {
            stack,
            faces: faces_of(stack),
            dead: loads.iter().map(dead).collect(),
            unit,
            size: (all[1] - all[0]).max_element(),
            step: options.step,
            weight: loads.iter().map(|load| load.mass).sum::<f64>() * stack.gravity_m_s2(),
            factor: 0.0,
            moved: loads
                .iter()
                .map(|load| BlockPose::at_rest(load.centroid()))
                .collect(),
            contacts: Vec::new(),
            reactions: Vec::new(),
            last_m: 0.0,
            slip_m: 0.0,
            residual: 0.0,
            steps: 0,
        };
        path.contacts = path.contacts_of(&path.moved, 0.0);
        Ok(path)
    }

    fn contacts_of(&self, moved: &[BlockPose], factor: f64) -> Vec<Contact> {
        let each = self.faces.iter().filter_map(|faces| {
            let below = match faces.lower {
                Some(lower) => moved[lower],
                None => BlockPose::ground(self.unit[faces.upper] * factor),
            };
            faces.contact(&below, &moved[faces.upper])
        });
        each.collect()
    }

    /// Loads on the stones in their current positions; a static load moves with its stone.
    fn dead_now(&self) -> Vec<BlockDeadLoad> {
        let mut dead = self.dead.clone();
        for load in self.stack.static_loads() {
            let moved = &self.moved[load.block];
            let arm = DVec3::from(load.position_m) - moved.centre;
            dead[load.block].moment += (moved.rotation * arm - arm).cross(load.force_n.into());
        }
        dead
    }

    /// Tries a step to this factor.
    fn try_step(&mut self, factor: f64) -> StepOutcome {
        self.steps += 1;
        match self.solved(factor) {
            Ok(Some((found, share))) if share <= 1.0 => {
                self.take(found, factor, 1.0);
                StepOutcome::Taken { share }
            }
            Ok(_) => StepOutcome::Falls,
            Err(_) => StepOutcome::NotSolved,
        }
    }

    /// The step to this factor, and the largest motion in it over the largest allowed; `None` if no forces are in equilibrium.
    fn solved(&self, factor: f64) -> Result<Option<(Step, f64)>, StabilityError> {
        let ground: Vec<DVec3> = self.unit.iter().map(|u| *u * (factor - self.factor)).collect();
        let dead = self.dead_now();
        let found = step(&Stage {
            moved: &self.moved,
            contacts: &self.contacts,
            dead: &dead,
            ground: &ground,
            length: self.size,
            weight: self.weight,
        })?;
        let far = |motion: &Motion| motion.turn.length().max(motion.shift.length() / self.size);
        let share = |found: &Step| found.motions.iter().map(far).fold(0.0, f64::max) / self.step;
        Ok(found.map(|found| {
            let share = share(&found);
            (found, share)
        }))
    }

    /// Moves by a part of a step: contact without penetration is convex, so that any part of it is allowed.
    fn take(&mut self, found: Step, factor: f64, part: f64) {
        let moved = self.moved.iter().zip(&found.motions);
        self.moved = moved
            .map(|(moved, motion)| moved.on(motion.shift * part, motion.turn * part))
            .collect();
        self.factor = match part < 1.0 {
            true => self.factor + part * (factor - self.factor),
            false => factor,
        };
        self.contacts = self.contacts_of(&self.moved, self.factor);
        self.reactions = found.reactions;
        let shifts = found.motions.iter().map(|motion| motion.shift.length());
        self.last_m = part * shifts.fold(0.0, f64::max);
        self.slip_m = self.slip_m.max(self.slip_now_m());
        self.residual = self.residual.max(found.missed);
    }

    /// Follows the stones while they move on although the ground hardly does, in parts of the step to this factor.
    fn jump(&mut self, to: f64, steps_most: usize) -> JumpEnd {
        let (before, factor) = (self.moved.clone(), self.factor);
        while self.steps < steps_most {
            self.steps += 1;
            let (found, share) = match self.solved(to) {
                Ok(Some(found)) => found,
                Ok(None) => return JumpEnd::Falls,
                Err(_) => return JumpEnd::NotSolved,
            };
            self.take(found, to, (1.0 / share).min(1.0));
            let each = || before.iter().zip(&self.moved);
            let moved = each().map(|(old, new)| new.shift.distance(old.shift));
            let turned = each().map(|(old, new)| new.turned_from(old));
            let jump = SupportJump {
                factor,
                moved_m: moved.fold(0.0, f64::max),
                turned_rad: turned.fold(0.0, f64::max),
            };
            if jump.moved_m > JUMP_SHIFT * self.size || jump.turned_rad > JUMP_TURN {
                return JumpEnd::Falls;
            }
            if share <= 1.0 {
                return JumpEnd::Rests(jump);
            }
        }
        JumpEnd::NotSolved
    }

    fn state(&self) -> MovedStack {
        let blocks = self.stack.blocks().iter().zip(&self.moved);
        let reactions = self.stack.on_ground().into_iter().filter_map(|block| {
            let force_n = self.reactions.get(block)?.to_array();
            Some(SupportReaction { block, force_n })
        });
        MovedStack {
            factor: self.factor,
            solids: blocks
                .map(|(block, moved)| {
                    let shift = moved.now() - moved.rotation * moved.centre;
                    block.solid.moved(moved.rotation, shift)
                })
                .collect(),
            mechanism: self.mechanism(),
            reactions: reactions.collect(),
            slip_m: self.slip_m,
        }
    }

    /// Gap below which a corner is closed, m.
    fn closed_below(&self) -> f64 {
        let corners = self.contacts.iter().flat_map(|contact| &contact.corners);
        let far = self.unit.iter().map(|u| u.length()).fold(0.0, f64::max) * self.factor;
        let most = corners
            .map(|corner| corner.gap.max(corner.slip))
            .fold(0.0, f64::max);
        NAMED_LEAST * most.max(NAMED_OF_MOVEMENT * far)
    }

    /// Closed corners of a contact: the nearest one and those about as near; none if even the nearest gap is more than the slip of the last step
    /// can explain.
    fn closed<'c>(&self, contact: &'c Contact) -> Vec<&'c Corner> {
        let least = self.closed_below();
        let nearest = contact.corners.iter().map(|corner| corner.gap);
        let nearest = nearest.fold(f64::INFINITY, f64::min);
        let lifted = least.max(2.0 * contact.friction * self.last_m);
        let within = |corner: &&Corner| nearest <= lifted && corner.gap <= nearest + least;
        contact.corners.iter().filter(within).collect()
    }

    /// Largest slip of the closed corners of all contacts.
    fn slip_now_m(&self) -> f64 {
        let closed = self.contacts.iter().flat_map(|contact| self.closed(contact));
        closed.map(|corner| corner.slip).fold(0.0, f64::max)
    }

    /// Joints that are open or have slipped.
    fn mechanism(&self) -> Option<Mechanism> {
        let least = self.closed_below();
        let named = |contact: &Contact| {
            let closed = self.closed(contact);
            let motion = match (
                closed.len() < contact.corners.len(),
                closed.iter().any(|corner| corner.slip > least),
            ) {
                (false, false) => return None,
                (true, false) => JointMotion::Opens,
                (false, true) => JointMotion::Slides,
                (true, true) => JointMotion::OpensAndSlides,
            };
            let middle = closed.iter().map(|corner| corner.upper).sum::<DVec3>() / closed.len() as f64;
            Some(MovingJoint {
                joint: contact.joint,
                motion,
                closed_at_m: (!closed.is_empty()).then(|| middle.into()),
            })
        };
        let joints: Vec<MovingJoint> = self.contacts.iter().filter_map(named).collect();
        (!joints.is_empty()).then_some(Mechanism { joints })
    }
}

/// Dead load of a block, with constant direction: force at its centroid and moment about it.
fn dead(load: &Load) -> BlockDeadLoad {
    BlockDeadLoad {
        force: load.force,
        moment: load.moment - load.centroid().cross(load.force),
    }
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
