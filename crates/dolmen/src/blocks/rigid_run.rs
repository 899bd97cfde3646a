//! State of a run of the rigid law: kicks, drifts and impacts.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | h, τ | `h`, `left_s` | step; its remaining part | s |
//! | κ | `kick_s` | duration of a kick, from the time of the velocities to the middle of the next drift | s |
//! | – | `lag_s` | time by which velocities lag behind positions | s |

use super::assembly::Assembly;
use super::bodies::RigidBody;
use super::forces::Forces;
use super::history::RigidEvidence;
use super::moving_ground::OwnGround;
use super::patch::{LANES, Motion};
use super::rigid_faces::{Face, MassAbove, velocity};
use super::rigid_point::{ForceTorque, Part, Point};
use super::rigid_rest::AtRest;
use super::rigid_solve::{Inertia, LOOSE_FROM_M_S, Momentum, SolvedBy, Solver};
use glam::DVec3;

/// Gap up to which a point counts as in contact, m. Our choice: far above rounding, far below visible gaps.
const TOUCHES_M: f64 = 1e-8;
/// Gap at which the time of an impact is found, m. Our choice.
pub(super) const FOUND_M: f64 = 1e-10;
/// Largest number of impacts located in one step; further ones are resolved at its end. Our choice.
const IMPACTS_MOST: usize = 30;
/// Closing velocity, over g h, from which an impact is located inside the step and has restitution. Our choice: slower impacts are an
/// effect of the step.
pub(super) const IMPACT_FROM: f64 = 0.5;
/// Velocity below which a stack is at rest, m/s: ten times the tolerance of a solution. Our choice: as an acceleration over a step, it is
/// 1e-5 g.
const AT_REST_M_S: f64 = 1e-7;
/// Largest number of times that closing points are added to a solution.
const ADDED_MOST: usize = 8;
/// Velocity along the plane from which a point slips, m/s. Our choice.
const SLIPS_FROM_M_S: f64 = 1e-7;
/// Shortest remainder of a step that is computed after an impact, as a fraction; allows for rounding. Our choice.
const SHORTEST_PART: f64 = 1e-9;
/// Gap error of points at the end of a drift that is accepted if further iterations do not reduce it, m: a tenth of a micrometre. Our
/// choice.
const OFF_WORST_M: f64 = 1e-7;
/// Largest number of halvings of a drift without a solution. Our choice.
const HALVINGS_MOST: usize = 6;
/// Depth above which new points are not pushed out, m. Our choice.
const HOLDS_FROM_M: f64 = 1e-9;

/// Energies of a step: work input, work of contacts, friction loss, J.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct StepEnergy {
    pub(super) input: f64,
    pub(super) contact: f64,
    pub(super) friction: f64,
}

/// State of a pair: the force on S about the origin of its plane, and its elastic bed.
#[derive(Clone, Debug, Default)]
pub(super) struct Memory {
    force: ForceTorque,
    bed: [f64; 3],
    plane_body: usize,
    slid: Vec<bool>,
    pub(super) known: bool,
}

/// Behaviour of open points in the rest of a step.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum OpenPoints {
    Nothing,
    Slowly,
    Hard,
}

/// Residual of the last attempt, m/s, if a step has no solution.
pub(super) type Unsolved = f64;

/// Acceleration of the ground at a time.
pub(super) type Ground<'a> = &'a dyn Fn(f64) -> DVec3;

pub(super) struct Run {
    pub(super) assembly: Assembly,
    pub(super) evidence: RigidEvidence,
    pub(super) h: f64,
    pub(super) solver: Solver,
    /// Pairs of bodies in the current solver.
    pub(super) touching: Vec<[usize; 2]>,
    pub(super) faces: Vec<Face>,
    pub(super) memory: Vec<Memory>,
    pub(super) inertia: Vec<Inertia>,
    /// Current solution, and the momentum without contact forces.
    pub(super) velocity: Vec<ForceTorque>,
    pub(super) momentum: Vec<ForceTorque>,
    /// Forces of dowels, clamps, side supports and static loads in a kick.
    held: Forces,
    pub(super) at_rest: Option<AtRest>,
    pub(super) lag_s: f64,
    /// Length of the drift for which velocities are solved.
    pub(super) drift_s: f64,
    /// Whether an impact is being resolved.
    pub(super) strikes: bool,
    pub(super) kick_s: f64,
    /// Acceleration of the frame and gravity together, m/s².
    pub(super) pull: DVec3,
    pub(super) shaking: DVec3,
    pub(super) acceleration: Vec<DVec3>,
    pub(super) forces: Forces,
    pub(super) counted: StepEnergy,
    pub(super) ground: OwnGround,
    /// Rate at which every velocity decays, 1/s.
    pub(super) drag_per_s: f64,
}

impl Run {
    pub(super) fn of(assembly: Assembly, h: f64) -> Self {
        let bodies = assembly.bodies.len();
        Run {
            evidence: RigidEvidence::default(),
            h,
            solver: Solver::default(),
            touching: vec![[usize::MAX; 2]],
            faces: Vec::new(),
            memory: vec![Memory::default(); assembly.pair_count()],
            inertia: Vec::new(),
            velocity: vec![[0.0; 6]; bodies],
            momentum: vec![[0.0; 6]; bodies],
            held: Forces::default(),
            at_rest: None,
            lag_s: 0.0,
            drift_s: h,
            strikes: false,
            kick_s: h,
            pull: DVec3::ZERO,
            shaking: DVec3::ZERO,
            acceleration: vec![DVec3::ZERO; bodies],
            forces: Forces::default(),
            counted: StepEnergy::default(),
            ground: OwnGround::default(),
            drag_per_s: 0.0,
            assembly,
        }
    }

    pub(super) fn lag_s(&self) -> f64 {
        self.lag_s
    }

    pub(super) fn acceleration(&self) -> &[DVec3] {
        &self.acceleration
    }

    pub(super) fn forces(&self) -> &Forces {
        &self.forces
    }

    /// Energies of the step: work input, work of contacts, friction loss, J.
    pub(super) fn take_counted(&mut self) -> [f64; 3] {
        let counted = std::mem::take(&mut self.counted);
        [counted.input, counted.contact, counted.friction]
    }

    /// Solves for the velocities of the next step.
    pub(super) fn begin(&mut self, time_s: f64, ground: Ground<'_>) -> Result<(), Unsolved> {
        self.assembly.look();
        self.ground.place(&mut self.assembly.bodies, time_s, self.h);
        if self.ground.is_empty() && self.rests(ground(time_s)) {
            return Ok(());
        }
        self.hold_overlaps();
        self.kick_on(time_s, self.h, ground)
    }

    /// Applies the velocities, with the impacts of the step.
    pub(super) fn finish(&mut self, time_s: f64, ground: Ground<'_>) -> Result<(), Unsolved> {
        if self.at_rest.as_ref().is_some_and(AtRest::held) {
            self.lag_s = 0.5 * self.h;
            return Ok(());
        }
        let (mut from_s, mut impacts) = (0.0, 0);
        loop {
            let drift_s = self.drift_s;
            if impacts < IMPACTS_MOST && self.meets(drift_s) == OpenPoints::Hard {
                let part_s = self.first_meeting(drift_s);
                self.strikes = true;
                self.strike(time_s + from_s, part_s, ground)?;
                self.strikes = false;
                impacts += 1;
                from_s += part_s;
            } else {
                while impacts == IMPACTS_MOST && self.add_meeting(drift_s, f64::INFINITY) {
                    self.solve()?;
                }
                self.commit();
                for body in self.assembly.bodies.iter_mut().skip(1) {
                    body.drift(drift_s);
                }
                self.lag_s = 0.5 * drift_s;
                from_s += drift_s;
            }
            if self.h - from_s <= SHORTEST_PART * self.h {
                return Ok(());
            }
            self.kick_on(time_s + from_s, self.h - from_s, ground)?;
        }
    }

    /// Solves for the velocities in the middle of a drift of `left_s`. Without a solution, the drift is halved until there is one.
    fn kick_on(&mut self, time_s: f64, left_s: f64, ground: Ground<'_>) -> Result<(), Unsolved> {
        self.drift_s = left_s;
        let mut kicked = self.kick(time_s, ground);
        for _ in 0..HALVINGS_MOST {
            if kicked.is_ok() {
                break;
            }
            self.drift_s *= 0.5;
            self.evidence.halvings += 1;
            kicked = self.kick(time_s, ground);
        }
        kicked
    }

    /// Whether all stones still move rigidly with the ground.
    fn rests(&mut self, shaking: DVec3) -> bool {
        let still = |body: &RigidBody| body.velocity == DVec3::ZERO && body.spin == DVec3::ZERO;
        if !self.assembly.bodies.iter().all(still) || self.assembly.holds() {
            self.at_rest = None;
            return false;
        }
        if self.at_rest.is_none() {
            self.see_faces(self.h, 0.0);
            self.at_rest = AtRest::of(&self.assembly, &self.faces);
        }
        let pull = DVec3::new(0.0, 0.0, self.assembly.gravity) + shaking;
        let rests = self.at_rest.as_mut().is_some_and(|at_rest| at_rest.holds(pull));
        if let Some(at_rest) = self.at_rest.as_ref().filter(|_| !rests) {
            for (pair, plane_body, force) in at_rest.carried(pull) {
                self.memory[pair] = Memory {
                    force,
                    plane_body,
                    known: true,
                    ..Memory::default()
                };
            }
        }
        if rests {
            self.evidence.steps_at_rest += 1;
            self.forces.clear(self.assembly.bodies.len());
            self.acceleration.fill(DVec3::ZERO);
        }
        rests
    }

    /// Evaluates the current faces for a drift of `h` s.
    pub(super) fn see_faces(&mut self, h: f64, same_time_s: f64) {
        let mut ahead: Vec<RigidBody> = self.assembly.bodies.clone();
        let moves = |body: &RigidBody| body.velocity != DVec3::ZERO || body.spin != DVec3::ZERO;
        for body in ahead.iter_mut().skip(1) {
            body.drift(h);
        }
        self.faces.clear();
        let mut motions: Vec<(usize, Motion)> = Vec::new();
        let bodies = &self.assembly.bodies;
        let above = MassAbove::of(bodies);
        for (pair, patch, _, _) in self.assembly.contacts() {
            let motion = patch.motion(bodies);
            motions.push((pair, motion));
            let moving = moves(&bodies[patch.plane_body]) || moves(&bodies[patch.point_body]);
            let then = moving.then(|| patch.motion(&ahead));
            let mut face = Face::of((pair, patch), bodies, &motion, then.as_ref(), [h, self.h], &above);
            for point in &mut face.points {
                self.evidence.penetration_most_m = self.evidence.penetration_most_m.max(-point.gap);
                let closing = -velocity(&face.ahead, point.x, point.y)[2];
                if point.gap <= TOUCHES_M.max(closing * same_time_s) {
                    point.part = Part::Near;
                }
            }
            self.faces.push(face);
        }
        for (pair, motion) in &motions {
            self.assembly.note_drift(*pair, motion);
        }
        let touching = self.faces.iter().map(|face| [face.plane_body, face.point_body]);
        let touching: Vec<[usize; 2]> = touching.collect();
        if touching != self.touching {
            self.solver = Solver::of(self.assembly.bodies.len(), &touching);
            self.touching = touching;
        }
    }

    /// Solves for the velocities in the middle of the drift, including contacts that close slowly during it.
    fn kick(&mut self, time_s: f64, ground: Ground<'_>) -> Result<(), Unsolved> {
        let h = self.drift_s;
        self.see_faces(h, 0.0);
        self.kick_over(time_s, self.lag_s + 0.5 * h, 0.5 * h, ground)?;
        let slow = IMPACT_FROM * self.assembly.gravity * self.h;
        for _ in 0..ADDED_MOST {
            if !self.add_meeting(h, slow) {
                break;
            }
            self.solve()?;
        }
        self.note_forces();
        Ok(())
    }

    /// Solves for the velocities at the end of a kick, with the current faces; the bodies are rotated forward by `ahead_s`.
    pub(super) fn kick_over(
        &mut self,
        time_s: f64,
        kick_s: f64,
        ahead_s: f64,
        ground: Ground<'_>,
    ) -> Result<(), Unsolved> {
        self.kick_s = kick_s;
        self.shaking = ground(time_s - self.lag_s + 0.5 * kick_s);
        self.pull = DVec3::new(0.0, 0.0, -self.assembly.gravity) - self.shaking;
        self.inertia.clear();
        let kept = 1.0 / (1.0 + self.drag_per_s * kick_s); // drag at the velocities of the end of the kick
        for (index, body) in self.assembly.bodies.iter().enumerate() {
            self.inertia.push(Inertia {
                mass: body.mass,
                turning: body.inertia_after(ahead_s),
                radius: body.radius,
            });
            let free = (body.velocity + self.pull * kick_s) * body.mass * kept;
            self.momentum[index] = six(free, body.momentum * kept);
            self.velocity[index] = six(body.velocity + self.acceleration[index] * kick_s, body.spin);
        }
        self.hold_ground();
        if self.assembly.holds() {
            self.held.clear(self.assembly.bodies.len());
            self.assembly.push_held(self.h, &mut self.held);
            let pushes = self.held.force.iter().zip(&self.held.torque);
            for (momentum, (force, torque)) in self.momentum.iter_mut().zip(pushes) {
                let given = six(*force * kick_s, *torque * kick_s);
                momentum
                    .iter_mut()
                    .zip(given)
                    .for_each(|(has, given)| *has += given);
            }
        }
        self.momentum[0] = [0.0; 6];
        self.velocity[0] = [0.0; 6];
        for face in &mut self.faces {
            let memory = &mut self.memory[face.pair];
            if memory.known && memory.plane_body == face.plane_body {
                let mut bed = memory.bed.map(|pressure| pressure * kick_s);
                face.hold(&memory.force.map(|force| force * kick_s), &mut bed);
                memory.bed = bed.map(|impulse| impulse / kick_s);
                if memory.slid.len() == face.points.len() {
                    for (point, slid) in face.points.iter_mut().zip(&memory.slid) {
                        point.slid = *slid;
                    }
                }
            }
            face.rigid_offsets();
        }
        self.solve()
    }

    pub(super) fn solve(&mut self) -> Result<(), Unsolved> {
        self.faces.iter_mut().for_each(Face::weigh);
        let (inertia, free) = (&self.inertia, &self.momentum);
        let of = Momentum { inertia, free };
        // closing velocities that an impact leaves below its threshold are resolved by the next drift
        let worst_m_s = match self.strikes {
            true => IMPACT_FROM * self.assembly.gravity * self.h,
            false => OFF_WORST_M / self.drift_s,
        };
        let solved = self
            .solver
            .solve(of, &mut self.faces, &mut self.velocity, worst_m_s);
        self.evidence.solutions += 1;
        self.evidence.newton_steps += solved.newton_steps;
        self.evidence.interior_solutions += usize::from(solved.method == SolvedBy::InteriorPoint);
        self.evidence.softer_solutions += usize::from(solved.method == SolvedBy::SofterWeights);
        if !solved.converged {
            return Err(solved.residual_m_s);
        }
        self.evidence.loose_solutions += usize::from(solved.residual_m_s > LOOSE_FROM_M_S);
        self.evidence.residual_most_m_s = self.evidence.residual_most_m_s.max(solved.residual_m_s);
        Ok(())
    }

    /// Stores accelerations and forces of the last kick for observers.
    pub(super) fn note_forces(&mut self) {
        let per_kick = 1.0 / self.kick_s;
        self.forces.clear(self.assembly.bodies.len());
        let stones = self.assembly.stones();
        for index in stones.end..self.assembly.bodies.len() {
            self.forces.force[index] = self.push_on_ground(index) * per_kick;
        }
        for (index, body) in self.assembly.bodies.iter().enumerate().take(stones.end).skip(1) {
            let (v, w) = halves(&self.velocity[index]);
            self.acceleration[index] = (v - body.velocity) * per_kick;
            self.forces.force[index] = (self.acceleration[index] - self.pull) * body.mass;
            self.forces.torque[index] = (self.inertia[index].turning * w - body.momentum) * per_kick;
        }
    }

    /// Behaviour of open points in a drift of `left_s` at the solved velocities.
    fn meets(&self, left_s: f64) -> OpenPoints {
        let slow = IMPACT_FROM * self.assembly.gravity * self.h;
        let mut meets = OpenPoints::Nothing;
        for face in &self.faces {
            let twist = self.twist(face);
            for point in face.points.iter().filter(|point| point.part == Part::Away) {
                if let Some(speed) = closing(&face.ahead, &twist, point, left_s) {
                    if speed > slow {
                        return OpenPoints::Hard;
                    }
                    meets = OpenPoints::Slowly;
                }
            }
        }
        meets
    }

    /// Activates open points that would close in a drift of `left_s` at no more than `most` m/s. Returns whether there were any.
    fn add_meeting(&mut self, left_s: f64, most: f64) -> bool {
        let mut any = false;
        for index in 0..self.faces.len() {
            let twist = self.twist(&self.faces[index]);
            let face = &mut self.faces[index];
            let (ahead, mut added) = (face.ahead, false);
            for point in face.points.iter_mut().filter(|point| point.part == Part::Away) {
                if closing(&ahead, &twist, point, left_s).is_some_and(|speed| speed <= most) {
                    point.part = Part::Near;
                    added = true;
                }
            }
            any |= added;
        }
        any
    }

    fn twist(&self, face: &Face) -> ForceTorque {
        face.twist_of(&self.velocity)
    }

    /// The bodies after a drift of `part_s` at the solved velocities.
    pub(super) fn drifted(&self, part_s: f64) -> Vec<RigidBody> {
        let mut bodies = self.assembly.bodies.clone();
        for (body, velocity) in bodies.iter_mut().zip(&self.velocity).skip(1) {
            (body.velocity, body.spin) = halves(velocity);
            body.drift(part_s);
        }
        bodies
    }

    /// Sets the bodies to the solved velocities, and adds the energies.
    pub(super) fn commit(&mut self) {
        let small = |v: &ForceTorque| v.iter().all(|value| value.abs() < AT_REST_M_S);
        let rests = self.velocity.iter().all(small);
        let stones = self.assembly.stones();
        for index in stones.end..self.assembly.bodies.len() {
            let work = self
                .push_on_ground(index)
                .dot(self.assembly.bodies[index].velocity);
            self.counted.contact += work;
            self.counted.input -= work;
        }
        for (index, body) in self
            .assembly
            .bodies
            .iter_mut()
            .enumerate()
            .take(stones.end)
            .skip(1)
        {
            let (v, w) = match rests {
                true => (DVec3::ZERO, DVec3::ZERO),
                false => halves(&self.velocity[index]),
            };
            let momentum = self.inertia[index].turning * w;
            let impulse = (v - body.velocity) * body.mass - self.pull * body.mass * self.kick_s;
            let torque = momentum - body.momentum;
            self.counted.contact += 0.5 * (impulse.dot(body.velocity + v) + torque.dot(body.spin + w));
            self.counted.input -= 0.5 * self.kick_s * body.mass * self.shaking.dot(body.velocity + v);
            (body.velocity, body.spin, body.momentum) = (v, w, momentum);
        }
        for index in 0..self.faces.len() {
            let twist = self.twist(&self.faces[index]);
            let face = &self.faces[index];
            if self.kick_s > 0.0 {
                let memory = &mut self.memory[face.pair];
                memory.force = face.wrench().map(|impulse| impulse / self.kick_s);
                memory.plane_body = face.plane_body;
                memory.known = true;
                memory.slid.clear();
                memory.slid.extend(face.points.iter().map(|point| {
                    let u = velocity(&twist, point.x, point.y);
                    point.slips && u[0].hypot(u[1]) > SLIPS_FROM_M_S
                }));
            }
            let Some(patch) = self.assembly.patch_mut(face.pair) else {
                continue;
            };
            let (still, moving) = (patch.law.friction_static, patch.law.friction_kinetic);
            for point in &face.points {
                if point.index >= LANES * patch.points.len() {
                    continue;
                }
                let (group, lane) = (&mut patch.points[point.index / LANES], point.index % LANES);
                let u = velocity(&twist, point.x, point.y);
                self.counted.friction -= point.impulse[0] * u[0] + point.impulse[1] * u[1];
                let slips = point.slips && u[0].hypot(u[1]) > SLIPS_FROM_M_S;
                group.friction[lane] = if slips { moving } else { still };
                // a held overlap shrinks as the point opens; all at once it would be pushed out
                group.held[lane] = (group.held[lane] - point.gap.max(0.0)).max(0.0);
            }
        }
    }

    /// Prevents new points that penetrate as drawn or undetected from being pushed out.
    fn hold_overlaps(&mut self) {
        let looked = self.assembly.looked().to_vec();
        for pair in looked {
            let bodies = std::mem::take(&mut self.assembly.bodies);
            if let Some(patch) = self.assembly.patch_mut(pair) {
                let motion = patch.motion(&bodies);
                for at in 0..LANES * patch.points.len() {
                    let (group, lane) = (at / LANES, at % LANES);
                    let gap = patch.place(&patch.points[group], lane, &motion).z;
                    if gap < -HOLDS_FROM_M {
                        patch.points[group].held[lane] -= gap;
                    }
                }
            }
            self.assembly.bodies = bodies;
        }
    }
}

/// Closing velocity of an open point that would close in a drift of `left_s`, m/s.
fn closing(ahead: &ForceTorque, twist: &ForceTorque, point: &Point, left_s: f64) -> Option<f64> {
    let now = velocity(twist, point.x, point.y)[2];
    let gap = point.gap_ahead + left_s * (now - velocity(ahead, point.x, point.y)[2]);
    (gap < -FOUND_M).then_some(-now)
}

pub(super) fn six(linear: DVec3, turning: DVec3) -> ForceTorque {
    [linear.x, linear.y, linear.z, turning.x, turning.y, turning.z]
}

pub(super) fn halves(six: &ForceTorque) -> (DVec3, DVec3) {
    (
        DVec3::new(six[0], six[1], six[2]),
        DVec3::new(six[3], six[4], six[5]),
    )
}
