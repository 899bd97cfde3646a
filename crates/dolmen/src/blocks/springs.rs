//! Time integration with the springs law: explicit and symplectic, with a step that Dolmen chooses and reports.
//!
//! Stages of a step at time t: examine pairs again that have moved far → forces at the positions of t with the velocities of t − h/2 → velocities of
//! t + h/2 → positions of t + h.

use super::after_fall::AfterFall;
use super::assembly::Assembly;
use super::contact_points::ContactRule;
use super::error::{BlocksError, check_times};
use super::forces::Forces;
use super::history::{Outcome, StackHistory};
use super::matrices::longest_step;
use super::moving_ground::{MovingGround, OwnGround};
use super::observe::{Observer, whole_at_least};
use super::rest::settle;
use super::run_length::RunLength;
use super::set_back::assembly_that_crushes;
use crate::signal::GroundMotion;
use crate::structure::stack::Stack;
use glam::DVec3;

/// Fraction of the longest stable step: the linear bound does not include friction and impacts. Our choice, from the errors in docs/stack-engine.md.
const STEP_PART: f64 = 0.9;
/// Fraction of the longest stable step if a joint has a `normal_restitution`: at 0.9 an impact on damped springs lasts two steps, and the restitution
/// is up to a fifth too small. Our choice.
const FALLS_STEP_PART: f64 = 0.1;

/// Fraction of the longest stable step for loose stones: contacts come and go, and the step does not consider their dashpots. Our choice.
const LOOSE_STEP_PART: f64 = 0.3;

/// Energy created by contacts, over the input energy, above which a run is repeated with half the step. Our choice.
const MADE_MOST: f64 = 1e-3;
/// The same ratio above which a run is unusable. Our choice.
const MADE_UNUSABLE: f64 = 1e-2;
/// Largest number of halvings of the step. Our choice.
const HALVINGS_MOST: usize = 3;

/// An initial disturbance of one block: a rotation about a point, a shift, and velocities.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Start {
    /// The block.
    pub block: usize,
    /// A point on the axis of rotation, m, as drawn.
    pub pivot_m: [f64; 3],
    /// Rotation vector, rad.
    pub turn_rad: [f64; 3],
    /// Shift after the rotation, m.
    pub shift_m: [f64; 3],
    /// Velocity of its centroid, m/s.
    pub velocity_m_s: [f64; 3],
    /// Angular velocity, rad/s.
    pub spin_rad_s: [f64; 3],
}

impl Start {
    /// A disturbance without rotation and velocity; set the fields as needed.
    pub fn of(block: usize) -> Self {
        Start {
            block,
            pivot_m: [0.0; 3],
            turn_rad: [0.0; 3],
            shift_m: [0.0; 3],
            velocity_m_s: [0.0; 3],
            spin_rad_s: [0.0; 3],
        }
    }
}

/// Options of [`simulate_springs`].
#[derive(Clone, Debug, PartialEq)]
pub struct Springs {
    /// Contact points of a joint. Default 4 × 4.
    pub contact_rule: ContactRule,
    /// Time step, s. Default `None`: 0.9 of the longest stable step (0.1 if a joint has a `normal_restitution`), shortened so that samples fall on
    /// steps, and halved up to three times if contacts would create more than a thousandth of the input energy.
    pub time_step_s: Option<f64>,
    /// Duration of the run, s. Default `None`: the motion and `rest_s`, then until the stack is at rest or rocks with decreasing amplitude, for at
    /// most [`StackHistory::LONGER_MOST_S`].
    pub duration_s: Option<f64>,
    /// Time that is always simulated after the motion, s. Default 2.
    pub rest_s: f64,
    /// Time between samples of the history, s. If `time_step_s` does not divide it, the nearest whole number of steps is used. Default 0.01.
    pub output_step_s: f64,
    /// What happens after a stone has fallen. Default: the run stops.
    pub after_fall: AfterFall,
    /// Initial disturbances. Default none.
    pub starts: Vec<Start>,
    /// Whether to compute a run of more than 20 million steps or a million samples. Default: such a run is refused.
    pub however_long: bool,
}

impl Default for Springs {
    fn default() -> Self {
        Springs {
            contact_rule: ContactRule::Four,
            time_step_s: None,
            duration_s: None,
            rest_s: 2.0,
            output_step_s: 0.01,
            after_fall: AfterFall::Stop,
            starts: Vec::new(),
            however_long: false,
        }
    }
}

/// Motion of a stack under base motion, by springs between its stones.
///
/// `progress` receives the simulated time at intervals, and stops the run by returning false.
///
/// ```text
/// m (v̇ + a_g) = −m g ẑ + Σ F,   L̇ = Σ r × F          in the frame of the ground
/// v(t + h/2) = v(t − h/2) + h v̇(x(t)),   x(t + h) = x(t) + h v(t + h/2)
/// ```
///
/// # Errors
/// [`BlocksError`] for options out of range, a step longer than the stable one, a block that does not exist, and a stack that does not come to rest
/// under its own weight.
///
/// # Limits
/// Stones are rigid, and contact is between convex hulls. In a joint with a compressive strength, stones rotate about the middle of the strip that
/// crushes at rest, and its largest load is compared with what the bed bears. Impacts are found inside the step, and their errors are proportional to it; the numbers are
/// in docs/stack-engine.md. A stack that rocks far is chaotic: one run has little meaning, a set of runs has more.
///
/// # Source
/// Cundall, P. A. (1988) Int. J. Rock Mech. 25:107-116, the distinct element method with rigid blocks. Differs from the source: pressure acts on
/// Gauss–Lobatto points of each face instead of its corners, friction is limited to the disc, impacts are located, dashpots act only on the contacts.
///
/// # Example
/// ```
/// use dolmen::blocks::{Outcome, Springs, simulate_springs};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let stone = Block { name: "stone".into(), solid: Solid::cuboid(0.3, 0.2, 0.1)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![stone], JointMaterial::default(), 9.81)?;
/// let options = Springs { duration_s: Some(0.1), ..Springs::default() };
/// let history = simulate_springs(&stack, None, &options, &mut |_| true)?;
/// assert_eq!(history.outcome, Outcome::Stood);
/// assert!((history.settlement_m - 2600.0 * 9.81 * 0.1 / 1e9).abs() < 1e-15); // ρ g h / k_n
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn simulate_springs(
    stack: &Stack,
    motion: Option<&GroundMotion>,
    options: &Springs,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    run_settled(
        &SettledStack::of(stack, options)?,
        stack,
        motion,
        options,
        progress,
    )
}

/// As [`simulate_springs`], for a stack whose supports move.
pub(super) fn simulate_springs_on(
    stack: &Stack,
    ground: &MovingGround,
    options: &Springs,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    let mut settled = SettledStack::of(stack, options)?;
    settled.ground = OwnGround::under(&mut settled.assembly, stack, ground);
    settled.moves_for_s = ground.duration_s();
    run_settled(&settled, stack, None, options, progress)
}

/// As [`simulate_springs`] without a motion, with every velocity decaying at a rate, 1/s, until the stones are at rest; then they are released.
pub(super) fn simulate_springs_dragged(
    stack: &Stack,
    drag_per_s: f64,
    options: &Springs,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    let settled = SettledStack {
        drag_per_s,
        ..SettledStack::of(stack, options)?
    };
    run_settled(&settled, stack, None, options, progress)
}

fn run_settled(
    settled: &SettledStack,
    stack: &Stack,
    motion: Option<&GroundMotion>,
    options: &Springs,
    progress: &mut dyn FnMut(f64) -> bool,
) -> Result<StackHistory, BlocksError> {
    let mut attempt = Attempt::first(settled);
    loop {
        let mut run = Run::new(stack, settled, motion, options, attempt.h)?;
        let mut forces = Forces::default();
        while run.advance(&mut forces, progress) {}
        if run.release() {
            while run.advance(&mut forces, progress) {}
        }
        match attempt.judge(run.finish(), options) {
            Ok(history) => return Ok(history),
            Err(again) => attempt = again,
        }
    }
}

/// A stack at rest under its own weight, with the step of its run.
#[derive(Clone, Debug)]
pub(super) struct SettledStack {
    pub(super) assembly: Assembly,
    /// The initial step, s.
    h: f64,
    longest: f64,
    /// Moving ground, and the duration of its movement, s.
    ground: OwnGround,
    moves_for_s: f64,
    /// Rate at which every velocity decays, 1/s.
    drag_per_s: f64,
}

impl SettledStack {
    /// # Errors
    /// As [`simulate_springs`], except those of initial disturbances.
    pub(super) fn of(stack: &Stack, options: &Springs) -> Result<Self, BlocksError> {
        let rest_s = options.rest_s;
        check_times(
            options.time_step_s,
            options.duration_s,
            options.output_step_s,
            rest_s,
        )?;
        let mut assembly = assembly_that_crushes(stack, options.contact_rule)?;
        match stack.loose_material() {
            None => settle(&mut assembly, stack)?,
            Some(_) => assembly.look(),
        }
        assembly.forget_loads();
        let longest = longest_step(&assembly);
        if let Some(given) = options.time_step_s.filter(|given| *given > longest) {
            return Err(BlocksError::StepTooLarge { given, most: longest });
        }
        let mut materials = stack
            .joints()
            .iter()
            .map(|joint| &joint.material)
            .chain(stack.loose_material());
        let bounces = materials.any(|material| material.normal_restitution > 0.0);
        let part = match stack.loose_material() {
            _ if bounces => FALLS_STEP_PART,
            Some(_) => LOOSE_STEP_PART,
            None => STEP_PART,
        };
        // a whole number of steps per sample
        let h = options.time_step_s.unwrap_or(
            options.output_step_s / whole_at_least(options.output_step_s / (part * longest)) as f64,
        );
        Ok(SettledStack {
            assembly,
            h,
            longest,
            ground: OwnGround::default(),
            moves_for_s: 0.0,
            drag_per_s: 0.0,
        })
    }
}

/// A run with one step size; the step is halved until contacts create no energy.
#[derive(Clone, Copy, Debug)]
pub(super) struct Attempt {
    pub(super) h: f64,
    halvings: usize,
}

impl Attempt {
    pub(super) fn first(settled: &SettledStack) -> Self {
        Attempt {
            h: settled.h,
            halvings: 0,
        }
    }

    /// The history if it is usable or if no shorter step would improve it; otherwise the next attempt.
    pub(super) fn judge(self, mut history: StackHistory, options: &Springs) -> Result<StackHistory, Attempt> {
        let made = history.energy_made_ratio();
        let last = self.halvings == HALVINGS_MOST || options.time_step_s.is_some();
        if made > MADE_UNUSABLE && last {
            let at_s = history.time_s.last().copied().unwrap_or_default();
            history.outcome = Outcome::Diverged { at_s };
        }
        if made <= MADE_MOST || last || matches!(history.outcome, Outcome::Stopped { .. }) {
            return Ok(history);
        }
        Err(Attempt {
            h: 0.5 * self.h,
            halvings: self.halvings + 1,
        })
    }
}

/// A run from rest with one step size.
pub(super) struct Run<'a> {
    pub(super) assembly: Assembly,
    pub(super) observer: Observer,
    pub(super) motion: Option<&'a GroundMotion>,
    after_fall: AfterFall,
    /// The step, and the longest stable step, s.
    pub(super) h: f64,
    longest: f64,
    /// Number of completed steps and of all steps.
    pub(super) step: usize,
    pub(super) length: RunLength,
    acceleration: Vec<DVec3>,
    ground: OwnGround,
    drag_per_s: f64,
}

impl<'a> Run<'a> {
    /// # Errors
    /// [`BlocksError`] for a disturbance of a block that does not exist.
    pub(super) fn new(
        stack: &Stack,
        settled: &SettledStack,
        motion: Option<&'a GroundMotion>,
        options: &Springs,
        h: f64,
    ) -> Result<Self, BlocksError> {
        let mut assembly = settled.assembly.clone();
        let shaken_s = motion.map_or(settled.moves_for_s, GroundMotion::duration_s);
        let length = RunLength::of(
            options.duration_s,
            [shaken_s, options.rest_s],
            [h, options.output_step_s],
            options.however_long,
        )?;
        let observer = Observer::new(stack, &assembly, options.output_step_s, h);
        for start in &options.starts {
            push(&mut assembly, start)?;
        }
        Ok(Run {
            acceleration: vec![DVec3::ZERO; assembly.bodies.len()],
            assembly,
            observer,
            motion,
            after_fall: options.after_fall,
            h,
            longest: settled.longest,
            ground: settled.ground.clone(),
            drag_per_s: settled.drag_per_s,
            step: 0,
            length,
        })
    }

    pub(super) fn time_s(&self) -> f64 {
        self.step as f64 * self.h
    }

    /// Acceleration of the ground at the current step, m/s².
    pub(super) fn shaking(&self) -> DVec3 {
        self.motion.map_or(DVec3::ZERO, |motion| {
            DVec3::from(motion.acceleration_at_m_s2(self.time_s()))
        })
    }

    /// Length of the kick from the current velocities: those of t − h/2, or at the start those of 0.
    pub(super) fn kick(&self) -> f64 {
        if self.step == 0 { 0.5 * self.h } else { self.h }
    }

    /// Passes the forces of the current step to the observer if it requests them. Returns false if the run is over.
    pub(super) fn look(&mut self, forces: &Forces, progress: &mut dyn FnMut(f64) -> bool) -> bool {
        if !self.observer.wants(self.step) {
            return true;
        }
        self.observer.see(&self.assembly.bodies);
        self.look_as_seen(forces, progress)
    }

    /// As [`Self::look`], at a step that the observer requests and whose joints it has already observed.
    pub(super) fn look_as_seen(&mut self, forces: &Forces, progress: &mut dyn FnMut(f64) -> bool) -> bool {
        let (shaking, time_s) = (self.shaking(), self.time_s());
        let inertia = DVec3::new(0.0, 0.0, -self.assembly.gravity) - shaking;
        if self.observer.samples(self.step) {
            for (index, body) in self.assembly.bodies.iter().enumerate().skip(1) {
                self.acceleration[index] = forces.force[index] * body.inverse_mass + inertia;
            }
        }
        let times = [time_s, self.kick()];
        self.observer
            .look(&self.assembly, &self.acceleration, forces, shaking, times);
        if self.observer.ended(self.after_fall) {
            return false;
        }
        if !progress(time_s) {
            self.observer.stop(time_s);
            return false;
        }
        true
    }

    /// Advances by one step. Returns false if the run is over.
    fn advance(&mut self, forces: &mut Forces, progress: &mut dyn FnMut(f64) -> bool) -> bool {
        let h = self.h;
        self.assembly.look();
        self.assembly.clock_s = self.time_s();
        self.assembly.forces(h, forces);
        if !self.look(forces, progress) {
            return false;
        }
        let (shaking, kick) = (self.shaking(), self.kick());
        let inertia = DVec3::new(0.0, 0.0, -self.assembly.gravity) - shaking;
        let (mut input, mut contact) = (0.0, 0.0);
        let stones = self.assembly.stones();
        for (index, body) in self
            .assembly
            .bodies
            .iter_mut()
            .enumerate()
            .take(stones.end)
            .skip(1)
        {
            let (velocity, spin) = (body.velocity, body.spin);
            let force = forces.force[index] - velocity * (self.drag_per_s * body.mass);
            let torque = forces.torque[index] - body.momentum * self.drag_per_s;
            body.step(force * body.inverse_mass + inertia, torque, kick, h);
            let (velocity, spin) = (velocity + body.velocity, spin + body.spin);
            input -= body.mass * shaking.dot(velocity);
            contact += force.dot(velocity) + torque.dot(spin);
        }
        if !self.ground.is_empty() {
            let time_s = self.time_s();
            let before: Vec<DVec3> = self.assembly.bodies[stones.end..]
                .iter()
                .map(|of| of.velocity)
                .collect();
            self.ground.place(&mut self.assembly.bodies, time_s, h);
            let own = self
                .assembly
                .bodies
                .iter_mut()
                .zip(&forces.force)
                .skip(stones.end);
            for ((body, force), before) in own.zip(before) {
                let work = force.dot(before + body.velocity);
                (input, contact) = (input - work, contact + work);
                body.drift(h);
            }
        }
        let work = [0.5 * kick * input, 0.5 * kick * contact, forces.friction_loss];
        self.observer.count(work);
        self.step += 1;
        !self.is_over()
    }

    /// Ends the decay of velocities if the stones are at rest; the run then lasts the same length again.
    fn release(&mut self) -> bool {
        let releases = self.drag_per_s > 0.0 && self.observer.is_at_rest(&self.assembly);
        if releases {
            self.drag_per_s = 0.0;
            self.length = self.length.again_from(self.step);
        }
        releases
    }

    pub(super) fn is_over(&mut self) -> bool {
        self.length.is_over(self.step, &mut self.observer, &self.assembly)
    }

    pub(super) fn finish(self) -> StackHistory {
        self.observer.finish(&self.assembly, [self.h, self.longest])
    }
}

pub(super) fn push(assembly: &mut Assembly, start: &Start) -> Result<(), BlocksError> {
    let last = assembly.bodies.len() - 2;
    if start.block > last {
        return Err(BlocksError::Stack(crate::structure::stack::StackError::NoBlock {
            given: start.block,
            last,
        }));
    }
    let body = &mut assembly.bodies[start.block + 1];
    let pivot = DVec3::from(start.pivot_m);
    let turn = glam::DQuat::from_scaled_axis(start.turn_rad.into());
    body.position = pivot + turn * (body.position - pivot) + DVec3::from(start.shift_m);
    body.turn_by(start.turn_rad.into());
    body.velocity = start.velocity_m_s.into();
    body.set_spin(start.spin_rad_s.into());
    body.travel = f64::INFINITY; // forces an examination of every pair with this body
    Ok(())
}
