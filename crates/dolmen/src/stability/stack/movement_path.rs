//! The stones of a stack while its supports move: one step, a jump, and the state at a stage.

use super::loads::Load;
use super::mechanism::{JointMotion, Mechanism, MovingJoint};
use super::moved_contacts::{BlockPose, Contact, Corner, Faces, faces_of};
use super::moved_supports::{MovedStack, SupportJump, SupportMovementOptions, SupportReaction};
use super::movement_programme::{BlockDeadLoad, Motion, Stage, Step, step};
use crate::stability::StabilityError;
use crate::structure::stack::Stack;
use glam::DVec3;

/// Largest rotation of a stone, rad, and largest displacement over the size of the stack, in a jump: stones that move farther fall. Our choice: an
/// arch of 15 voussoirs jumps by 0.016 rad when a hinge changes its joint.
const JUMP_TURN: f64 = 0.1;
const JUMP_SHIFT: f64 = 0.05;
/// Gaps and slips below this fraction of the largest are not reported. Our choice, as in the limit analysis.
const NAMED_LEAST: f64 = 1e-3;
/// The same for this fraction of the movement, if it is larger. Our choice.
const NAMED_OF_MOVEMENT: f64 = 0.1;

#[derive(Clone, Copy, PartialEq)]
pub(super) enum StepOutcome {
    /// Stones moved by this fraction of the largest step.
    Taken {
        share: f64,
    },
    /// The stones would move too far, or no forces are in equilibrium.
    Falls,
    NotSolved,
}

/// End of a jump.
pub(super) enum JumpEnd {
    /// The stones found another rest.
    Rests(SupportJump),
    /// They moved too far, or no forces are in equilibrium.
    Falls,
    NotSolved,
}

/// A stack during the movement.
#[derive(Clone)]
pub(super) struct Path<'a> {
    stack: &'a Stack,
    faces: Vec<Faces>,
    dead: Vec<BlockDeadLoad>,
    /// The given movement under each block, m.
    pub(super) unit: Vec<DVec3>,
    pub(super) size: f64,
    step: f64,
    weight: f64,
    pub(super) factor: f64,
    moved: Vec<BlockPose>,
    contacts: Vec<Contact>,
    reactions: Vec<DVec3>,
    /// Largest displacement of a stone in the last step, m.
    last_m: f64,
    /// Largest slip of a closed corner so far, m.
    slip_m: f64,
    pub(super) residual: f64,
    pub(super) steps: usize,
}

impl<'a> Path<'a> {
    pub(super) fn of(stack: &'a Stack, options: &SupportMovementOptions) -> Result<Self, StabilityError> {
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
    pub(super) fn try_step(&mut self, factor: f64) -> StepOutcome {
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
    pub(super) fn jump(&mut self, to: f64, steps_most: usize) -> JumpEnd {
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

    pub(super) fn state(&self) -> MovedStack {
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
