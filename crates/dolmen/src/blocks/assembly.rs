//! The bodies of a stack, and all forces between them.
//!
//! A pair of bodies is examined again only after sufficient motion: for a pair with a patch, if S has shifted or rotated relative to
//! P; for a pair without a patch, if the motion of both bodies together has reached its *slack*, the distance to their first
//! possible contact.

use super::bodies::{RigidBody, bodies_of, ends_of, index_of};
use super::contact_points::ContactRule;
use super::contact_tolerances::ContactTolerances;
use super::dead_load::DeadLoad;
use super::faces::{patch_along, patch_of_joint};
use super::forces::Forces;
use super::history::PeakBearing;
use super::hulls::{Hull, Side, separation};
use super::links::{Link, Prop};
use super::outline::{JointLoad, Outline, take_over};
use super::patch::{Law, Motion, Patch, Stored, Wrench};
use super::rigid_point::ForceTorque;
use crate::structure::stack::{Joint, JointMaterial, Stack};
use std::collections::BTreeMap;

/// Distance by which other faces must be farther apart than the current ones to replace them, over the radius of the smaller body.
/// It prevents alternation between equal faces. Our choice.
const FACE_FAVOUR: f64 = 0.002;

#[derive(Clone, Debug)]
struct Pair {
    first: usize,
    second: usize,
    material: JointMaterial,
    contact: Option<(Patch, Outline)>,
    /// Radius of the smaller body, m.
    size: f64,
    /// Motion of both bodies together before they can touch, m; infinite with a patch.
    slack: f64,
    /// The largest load relative to the strength so far.
    bearing: Option<PeakBearing>,
}

/// All bodies, contacts, ties and supports.
#[derive(Clone, Debug)]
pub(super) struct Assembly {
    pub(super) bodies: Vec<RigidBody>,
    pub(super) gravity: f64,
    hulls: Vec<Option<Hull>>,
    pairs: Vec<Pair>,
    /// Pairs with a patch, ascending.
    active: Vec<usize>,
    links: Vec<Link>,
    props: Vec<Prop>,
    dead_loads: Vec<DeadLoad>,
    rule: ContactRule,
    watchfulness: ContactTolerances,
    /// Smallest slack of all pairs at the last examination, m.
    slack: f64,
    /// Active pairs that have shifted or rotated too far.
    stale: Vec<usize>,
    /// Pairs updated by the last examination.
    looked: Vec<usize>,
    /// Elastic energy lost when patches are computed again, J.
    clip_loss: f64,
    /// Whether every pair of bodies is examined, or only pairs that touch as drawn.
    watches_all: bool,
    /// Stones with their own ground body, in the order of these ground bodies, which follow all stones in the list of bodies.
    on_own_ground: Vec<usize>,
    /// Time of the forces, s.
    pub(super) clock_s: f64,
}

impl Assembly {
    /// The stack as drawn.
    pub(super) fn of(stack: &Stack, rule: ContactRule) -> Self {
        let count = stack.blocks().len();
        let all = (1..=count).flat_map(|second| (0..second).map(move |first| (first, second)));
        Assembly::with_pairs(stack, rule, all, true)
    }

    /// The stack as drawn with its initial contacts only: for small motion.
    pub(super) fn of_joints(stack: &Stack, rule: ContactRule) -> Self {
        let mut ends: Vec<(usize, usize)> = stack.joints().iter().map(ends_of).collect();
        ends.sort_by_key(|&(first, second)| (second, first));
        ends.dedup();
        Assembly::with_pairs(stack, rule, ends.into_iter(), false)
    }

    /// Extends the examination to all pairs of stones, as drawn, if it was limited to those in contact.
    pub(super) fn watch_all(&mut self, stack: &Stack) {
        if !self.watches_all {
            *self = Assembly::of(stack, self.rule);
        }
    }

    fn with_pairs(
        stack: &Stack,
        rule: ContactRule,
        each: impl Iterator<Item = (usize, usize)>,
        watches_all: bool,
    ) -> Self {
        let bodies = bodies_of(stack);
        let hulls: Vec<Option<Hull>> = std::iter::once(None)
            .chain(stack.blocks().iter().map(|block| Some(Hull::of(&block.solid))))
            .collect();
        let mut joints: BTreeMap<(usize, usize), &Joint> = BTreeMap::new();
        let mut below: Vec<Option<&Joint>> = vec![None; bodies.len()];
        for joint in stack.joints() {
            joints.entry(ends_of(joint)).or_insert(joint);
            below[joint.upper + 1].get_or_insert(joint);
        }
        let mut pairs = Vec::new();
        for (first, second) in each {
            let of_pair = joints.get(&(first, second)).copied();
            let material = of_pair.or(below[second]).map(|joint| joint.material);
            let mut material = material.or(stack.loose_material().copied()).unwrap_or_default();
            if of_pair.is_none() {
                (material.cohesion_pa, material.tension_pa) = (0.0, 0.0); // stones that meet by accident have no bond
            }
            let contact = of_pair.and_then(|joint| {
                let side = |index: usize| side(&hulls, &bodies, index);
                patch_of_joint(joint, side(index_of(joint.lower)), side(joint.upper + 1), rule)
            });
            let (a, b) = (bodies[first].radius, bodies[second].radius);
            pairs.push(Pair {
                first,
                second,
                material,
                size: if first == 0 { b } else { a.min(b) },
                slack: if contact.is_some() { f64::INFINITY } else { 0.0 },
                contact,
                bearing: None,
            });
        }
        let mut assembly = Assembly {
            links: stack.ties().iter().map(Link::of).collect(),
            props: stack.side_supports().iter().map(Prop::of).collect(),
            dead_loads: stack.static_loads().iter().map(DeadLoad::of).collect(),
            bodies,
            gravity: stack.gravity_m_s2(),
            hulls,
            pairs,
            active: Vec::new(),
            rule,
            watchfulness: ContactTolerances::default(),
            slack: 0.0,
            stale: Vec::new(),
            looked: Vec::new(),
            clip_loss: 0.0,
            watches_all,
            on_own_ground: Vec::new(),
            clock_s: 0.0,
        };
        assembly.list_active();
        assembly
    }

    /// Gives a stone that rests on the ground a ground body of its own, which can move; returns that body.
    ///
    /// This ground body touches no other stone, and this stone does not touch the common ground.
    pub(super) fn put_on_own_ground(&mut self, stone: usize) -> usize {
        let own = self.bodies.len();
        self.bodies.push(RigidBody::ground());
        self.hulls.push(None);
        self.on_own_ground.push(stone);
        let on_ground = self.pair_of(0, stone);
        for other in 0..own {
            let pair = match on_ground.filter(|_| other == stone) {
                Some(index) => {
                    let of_ground = &mut self.pairs[index];
                    let mut contact = of_ground.contact.take();
                    if let Some((patch, _)) = &mut contact {
                        patch.plane_body = own;
                    }
                    let slack = std::mem::replace(&mut of_ground.slack, f64::INFINITY);
                    // the ground comes first, as for all stones
                    Pair {
                        first: own,
                        second: stone,
                        contact,
                        slack,
                        ..of_ground.clone()
                    }
                }
                None => Pair {
                    first: other,
                    second: own,
                    material: JointMaterial::default(),
                    contact: None,
                    size: 0.0,
                    slack: f64::INFINITY,
                    bearing: None,
                },
            };
            self.pairs.push(pair);
        }
        self.list_active();
        own
    }

    /// The bodies that are stones.
    pub(super) fn stones(&self) -> std::ops::Range<usize> {
        1..self.bodies.len() - self.on_own_ground.len()
    }

    /// The ground body of a stone: its own, or the common ground.
    pub(super) fn ground_under(&self, stone: usize) -> usize {
        let own = self.on_own_ground.iter().position(|on| *on == stone);
        own.map_or(0, |place| self.bodies.len() - self.on_own_ground.len() + place)
    }

    fn list_active(&mut self) {
        let active = (0..self.pairs.len()).filter(|&pair| self.pairs[pair].contact.is_some());
        self.active = active.collect();
    }

    pub(super) fn patches(&self) -> impl Iterator<Item = &Patch> {
        let contacts = self
            .active
            .iter()
            .filter_map(|&pair| self.pairs[pair].contact.as_ref());
        contacts.map(|(patch, _)| patch)
    }

    /// The current patches, each with the index of its pair, its outline, and the shift, m, and sine of the inclination at which it
    /// is examined again.
    pub(super) fn contacts(&self) -> impl Iterator<Item = (usize, &Patch, &Outline, [f64; 2])> {
        self.active.iter().filter_map(|&index| {
            let pair = &self.pairs[index];
            let (patch, outline) = pair.contact.as_ref()?;
            Some((
                index,
                patch,
                outline,
                [self.watchfulness.clip_again * pair.size, outline.lean_most],
            ))
        })
    }

    /// The patch between two bodies and its outline, if they are in contact; the lower index comes first.
    pub(super) fn contact_of(&self, first: usize, second: usize) -> Option<&(Patch, Outline)> {
        self.pairs[self.pair_of(first, second)?].contact.as_ref()
    }

    /// Index of a pair of bodies; `None` if there is no such pair.
    fn pair_of(&self, first: usize, second: usize) -> Option<usize> {
        let (first, second) = (first.min(second), first.max(second));
        // pairs are ordered by their second body, from 1 on, then by their first
        let index = second * second.checked_sub(1)? / 2 + first;
        let pair = self.pairs.get(index)?;
        debug_assert_eq!(
            (pair.first.min(pair.second), pair.first.max(pair.second)),
            (first, second)
        );
        Some(index)
    }

    /// The patch of a pair.
    pub(super) fn patch_mut(&mut self, pair: usize) -> Option<&mut Patch> {
        self.pairs[pair].contact.as_mut().map(|(patch, _)| patch)
    }

    /// Whether only dry patches that do not crush act between the bodies.
    pub(super) fn runs_side_by_side(&self) -> bool {
        let is_plain = |patch: &Patch| !patch.law.bonds() && !patch.law.strength.crushes();
        !self.holds() && self.patches().all(is_plain)
    }

    /// Least motion of two bodies together before they can touch, m.
    pub(super) fn slack(&self) -> f64 {
        self.slack
    }

    /// Marks a pair for the next examination, in ascending order.
    pub(super) fn set_stale(&mut self, pair: usize) {
        self.stale.push(pair);
    }

    /// Number of pairs, with a patch or without.
    pub(super) fn pair_count(&self) -> usize {
        self.pairs.len()
    }

    /// Sets other tolerances than those of the springs law.
    pub(super) fn watch(&mut self, watchfulness: ContactTolerances) {
        self.watchfulness = watchfulness;
    }

    pub(super) fn looked(&self) -> &[usize] {
        &self.looked
    }

    /// Removes the springs from all contacts, for the rigid law.
    pub(super) fn without_springs(&mut self) {
        for pair in &mut self.pairs {
            (
                pair.material.normal_stiffness_pa_m,
                pair.material.shear_stiffness_pa_m,
            ) = (0.0, 0.0);
            if let Some((patch, _)) = &mut pair.contact {
                (patch.law.normal_stiffness, patch.law.shear_stiffness) = (0.0, 0.0);
            }
        }
    }

    /// Marks a pair whose patch has shifted or rotated too far, for the next examination.
    pub(super) fn note_drift(&mut self, pair: usize, motion: &Motion) {
        let size = self.pairs[pair].size;
        if let Some((_, outline)) = &self.pairs[pair].contact
            && outline.has_drifted(motion, self.watchfulness.clip_again * size)
        {
            self.stale.push(pair);
        }
    }

    pub(super) fn links(&self) -> &[Link] {
        &self.links
    }

    pub(super) fn props(&self) -> &[Prop] {
        &self.props
    }

    pub(super) fn dead_loads(&self) -> &[DeadLoad] {
        &self.dead_loads
    }

    /// All forces except gravity and inertia at the bodies' present positions, over a step of `h` seconds (0: at rest).
    pub(super) fn forces(&mut self, h: f64, forces: &mut Forces) {
        forces.clear(self.bodies.len());
        let mut friction_loss = 0.0;
        for &pair in &self.active {
            let of = &mut self.pairs[pair];
            let Some((patch, outline)) = &mut of.contact else {
                continue;
            };
            let motion = patch.motion(&self.bodies);
            if outline.has_drifted(&motion, self.watchfulness.clip_again * of.size) {
                self.stale.push(pair);
            }
            let twist = patch.twist(&self.bodies, &motion);
            let Wrench {
                force,
                torque,
                friction_loss: rubbed,
            } = patch.wrench(&motion, &twist, h);
            friction_loss += rubbed;
            if outline.bed.is_some() {
                let now = JointLoad::of(force.z, [torque.x, torque.y], self.clock_s);
                outline.see_load(patch, &self.bodies, now, &mut of.bearing);
            }
            let (force, torque) = (motion.to_ground * force, motion.to_ground * torque);
            let (p, s) = (patch.plane_body, patch.point_body);
            forces.force[s] += force;
            forces.torque[s] += torque + (motion.origin - self.bodies[s].position).cross(force);
            forces.force[p] -= force;
            forces.torque[p] -= torque + (motion.origin - self.bodies[p].position).cross(force);
        }
        forces.friction_loss = friction_loss;
        self.push_held(h, forces);
    }

    /// The load of a pair, if its edges crush: the force and torque on S about the origin of its plane, in the axes of the plane.
    pub(super) fn see_load(&mut self, pair: usize, force: &ForceTorque) {
        let Pair { contact, bearing, .. } = &mut self.pairs[pair];
        if let Some((patch, outline)) = contact {
            let now = JointLoad::of(force[2], [force[3], force[4]], self.clock_s);
            outline.see_load(patch, &self.bodies, now, bearing);
        }
    }

    /// The largest load of a pair of bodies relative to its strength so far.
    pub(super) fn bearing_of(&self, first: usize, second: usize) -> Option<PeakBearing> {
        self.pairs[self.pair_of(first, second)?].bearing
    }

    /// The current patches, each with the index of its pair, its outline and the compressive strength of the joint, Pa.
    pub(super) fn contacts_mut(
        &mut self,
    ) -> impl Iterator<Item = (usize, &mut Patch, &mut Outline, Option<f64>)> {
        let pairs = self.pairs.iter_mut().enumerate();
        pairs.filter_map(|(index, pair)| {
            let (patch, outline) = pair.contact.as_mut()?;
            Some((index, patch, outline, pair.material.compressive_strength_pa))
        })
    }

    /// Forgets the loads so far.
    pub(super) fn forget_loads(&mut self) {
        self.pairs.iter_mut().for_each(|pair| pair.bearing = None);
    }

    /// Adds the forces of dowels, clamps, side supports and static loads at the bodies' present positions.
    pub(super) fn push_held(&mut self, h: f64, forces: &mut Forces) {
        for link in &mut self.links {
            forces.friction_loss += link.pull(&self.bodies, forces);
        }
        for prop in &self.props {
            prop.push(&self.bodies, forces, h);
        }
        for load in &self.dead_loads {
            load.push(&self.bodies, forces);
        }
    }

    /// Whether anything other than gravity, contacts and the ground acts on a body.
    pub(super) fn holds(&self) -> bool {
        !(self.links.is_empty() && self.props.is_empty() && self.dead_loads.is_empty())
    }

    /// Energy in all springs, with the potential energy of static loads, J.
    pub(super) fn stored(&self) -> f64 {
        let patches = self
            .patches()
            .map(|patch| patch.stored(&patch.motion(&self.bodies)).sum());
        let links = self.links.iter().map(|link| link.stored(&self.bodies));
        let props = self.props.iter().map(|prop| prop.stored(&self.bodies));
        let loads = self.dead_loads.iter().map(|load| load.stored(&self.bodies));
        patches.sum::<f64>() + links.sum::<f64>() + props.sum::<f64>() + loads.sum::<f64>()
    }

    /// Energy that repeated clipping has removed from the springs so far, J; negative for added energy.
    pub(super) fn clip_loss(&self) -> f64 {
        self.clip_loss
    }

    /// Examines again the pairs that have moved too far. Call it every step.
    pub(super) fn look(&mut self) {
        let mut changed = false;
        self.looked.clear();
        let stale = std::mem::take(&mut self.stale);
        for &pair in &stale {
            changed |= self.look_at(pair);
        }
        self.stale = stale;
        self.stale.clear();
        let farthest = self.bodies.iter().map(|body| body.travel).fold(0.0, f64::max);
        if 2.0 * farthest >= self.slack {
            let mut least = f64::INFINITY;
            for pair in 0..self.pairs.len() {
                let Pair { first, second, .. } = self.pairs[pair];
                self.pairs[pair].slack -= self.bodies[first].travel + self.bodies[second].travel;
                if self.pairs[pair].slack <= 0.0 {
                    changed |= self.look_at(pair);
                }
                least = least.min(self.pairs[pair].slack);
            }
            for body in &mut self.bodies {
                body.travel = 0.0;
            }
            self.slack = least;
        } else if changed {
            self.slack = 0.0; // a pair that lost its patch needs a new slack from the next step on
        }
        if changed {
            self.list_active();
        }
    }

    /// Updates the patch of a pair; true if a patch was created or removed.
    fn look_at(&mut self, index: usize) -> bool {
        self.looked.push(index);
        let pair = &mut self.pairs[index];
        let first = side(&self.hulls, &self.bodies, pair.first);
        let second = side(&self.hulls, &self.bodies, pair.second);
        let size = pair.size;
        if let Some((patch, outline)) = &mut pair.contact {
            let motion = patch.motion(&self.bodies);
            let before = patch.stored(&motion);
            if outline.lean(&motion) < outline.lean_most && !outline.of_edges() {
                outline.clip(patch, &motion, self.rule);
                self.clip_loss += before.sum() - patch.stored(&motion).sum();
                if !patch.points.is_empty() {
                    return false;
                }
            }
            let best = separation(first, second);
            if best.distance > self.watchfulness.far * size {
                pair.contact = None;
                self.clip_loss += before.sum();
                pair.slack = best.distance - self.watchfulness.near * size;
                return true;
            }
            if outline.still_serves(&best, first, second, FACE_FAVOUR * size) {
                outline.clip(patch, &motion, self.rule);
                self.clip_loss += before.sum() - patch.stored(&motion).sum();
            } else if let Some((mut next, mut edge)) = patch_along(first, second, &best, patch.law.dry()) {
                let old_motion = motion;
                let motion = next.motion(&self.bodies);
                edge.clip(&mut next, &motion, self.rule);
                take_over(&mut next, &motion, patch, &old_motion);
                next.hold_at_most(&motion, before); // other faces must not store more energy than these did
                self.clip_loss += before.sum() - next.stored(&motion).sum();
                pair.contact = Some((next, edge));
            }
            return false;
        }
        let best = separation(first, second);
        let near = self.watchfulness.near;
        if best.distance > near * size {
            pair.slack = best.distance - 0.5 * near * size;
            return false;
        }
        let area = second.hull.map_or(size * size, Hull::largest_face);
        let inverse_mass = first.body.inverse_mass + second.body.inverse_mass;
        let law = Law::of(&pair.material, area, inverse_mass).dry();
        if let Some((mut patch, mut outline)) = patch_along(first, second, &best, law) {
            let motion = patch.motion(&self.bodies);
            outline.clip(&mut patch, &motion, self.rule);
            patch.unstretch(&motion);
            // an overlap that was drawn or undetected does not push the bodies apart
            patch.hold_at_most(&motion, Stored::default());
            pair.contact = Some((patch, outline));
            pair.slack = f64::INFINITY;
            return true;
        }
        false
    }

    /// Largest stiffness of any possible contact of a block, over its mass: N/m/kg.
    pub(super) fn stiffest(&self) -> f64 {
        let of_pair = |pair: &Pair| {
            let k = pair
                .material
                .normal_stiffness_pa_m
                .max(pair.material.shear_stiffness_pa_m);
            let of_body = |index: usize| {
                let area = self.hulls[index].as_ref().map_or(0.0, Hull::largest_face);
                k * area * self.bodies[index].inverse_mass
            };
            of_body(pair.first).max(of_body(pair.second))
        };
        self.pairs.iter().map(of_pair).fold(0.0, f64::max)
    }
}

fn side<'a>(hulls: &'a [Option<Hull>], bodies: &'a [RigidBody], index: usize) -> Side<'a> {
    Side {
        index,
        hull: hulls[index].as_ref(),
        body: &bodies[index],
    }
}
