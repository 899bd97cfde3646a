//! Time step of [`RigidBody`] for several runs at once, one run per lane.

use super::super::bodies::{COSINE_SERIES, RigidBody, SERIES_MOST, SINE_SERIES, rotation_of};
use super::lanes::{Columns, Real, Turn, Vector};
use pulp::Simd;

/// Force on a body and torque about its centroid, in each lane.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Load<S: Simd> {
    pub(super) force: Vector<S>,
    pub(super) torque: Vector<S>,
}

/// State of the same body in each lane.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct BodyLanes<S: Simd> {
    pub(super) mass: Real<S>,
    inverse_mass: Real<S>,
    inverse_inertia: Columns<S>,
    radius: Real<S>,
    pub(super) position: Vector<S>,
    turn: Turn<S>,
    pub(super) rotation: Columns<S>,
    pub(super) velocity: Vector<S>,
    momentum: Vector<S>,
    pub(super) spin: Vector<S>,
    pub(super) travel: Real<S>,
}

impl<S: Simd> BodyLanes<S> {
    /// Copies one body into every lane.
    pub(super) fn all(simd: S, body: &RigidBody) -> Self {
        BodyLanes {
            mass: Real::all(simd, body.mass),
            inverse_mass: Real::all(simd, body.inverse_mass),
            inverse_inertia: Columns::all(simd, body.inverse_inertia),
            radius: Real::all(simd, body.radius),
            position: Vector::all(simd, body.position),
            turn: Turn::all(simd, body.turn),
            rotation: Columns::all(simd, body.rotation),
            velocity: Vector::all(simd, body.velocity),
            momentum: Vector::all(simd, body.momentum),
            spin: Vector::all(simd, body.spin),
            travel: Real::all(simd, body.travel),
        }
    }

    pub(super) fn load(&mut self, lane: usize, body: &RigidBody) {
        self.mass.set(lane, body.mass);
        self.inverse_mass.set(lane, body.inverse_mass);
        self.inverse_inertia.set(lane, body.inverse_inertia);
        self.radius.set(lane, body.radius);
        self.position.set(lane, body.position);
        self.turn.set(lane, body.turn);
        self.rotation.set(lane, body.rotation);
        self.velocity.set(lane, body.velocity);
        self.momentum.set(lane, body.momentum);
        self.spin.set(lane, body.spin);
        self.travel.set(lane, body.travel);
    }

    /// Writes the position in a lane to its body.
    pub(super) fn unload_place(&self, lane: usize, body: &mut RigidBody) {
        body.position = self.position.get(lane);
        body.rotation = self.rotation.get(lane);
    }

    pub(super) fn unload(&self, lane: usize, body: &mut RigidBody) {
        self.unload_place(lane, body);
        body.turn = self.turn.get(lane);
        body.velocity = self.velocity.get(lane);
        body.momentum = self.momentum.get(lane);
        body.spin = self.spin.get(lane);
        body.travel = self.travel.get(lane);
    }
}

/// Time step of all bodies, two at a time.
#[inline(always)]
pub(super) fn step_all<S: Simd, const DIAGONAL: bool>(
    bodies: &mut [BodyLanes<S>],
    loads: &[Load<S>],
    ground: [Vector<S>; 2],
    steps: [Real<S>; 2],
    sums: &mut [Real<S>; 2],
) {
    let (pairs, last) = bodies.as_chunks_mut::<2>();
    let (loads, last_load) = loads.as_chunks::<2>();
    for (bodies, loads) in pairs.iter_mut().zip(loads) {
        step_bodies::<S, 2, DIAGONAL>(bodies, loads, ground, steps, sums);
    }
    let last = last.iter_mut().map(std::array::from_mut);
    for (body, load) in last.zip(last_load.iter().map(std::array::from_ref)) {
        step_bodies::<S, 1, DIAGONAL>(body, load, ground, steps, sums);
    }
}

/// As [`RigidBody::step`]; `ground` contains gravity and shaking. Adds to the sums, for each body, twice the mean
/// power of the shaking and of the forces.
///
/// The N bodies are processed stage by stage: while one body waits for its operands, the processor continues with
/// another.
#[inline(always)]
fn step_bodies<S: Simd, const N: usize, const DIAGONAL: bool>(
    bodies: &mut [BodyLanes<S>; N],
    loads: &[Load<S>; N],
    [gravity, shaking]: [Vector<S>; 2],
    [kick, h]: [Real<S>; 2],
    [input, contact]: &mut [Real<S>; 2],
) {
    let all = |value: f64| Real::all(h.0, value);
    let inertia = gravity - shaking;
    let half_h = all(0.5) * h;
    let (mut own, mut start, mut pull, mut spin) = ([inertia; N], [inertia; N], [inertia; N], [inertia; N]);
    let mut before = [[inertia; 2]; N];
    for k in 0..N {
        before[k] = [bodies[k].velocity, bodies[k].spin];
        let acceleration = loads[k].force * bodies[k].inverse_mass + inertia;
        bodies[k].velocity = bodies[k].velocity + acceleration * kick;
        bodies[k].momentum = bodies[k].momentum + loads[k].torque * kick;
    }
    for k in 0..N {
        own[k] = bodies[k].rotation.transposed_times(bodies[k].momentum);
    }
    for k in 0..N {
        if DIAGONAL {
            let [x, y, z] = bodies[k].inverse_inertia.0;
            let times = Vector {
                x: x.x,
                y: y.y,
                z: z.z,
            };
            start[k] = own[k].by_parts(times);
            pull[k] = own[k].cross(start[k]).by_parts(times);
        } else {
            start[k] = bodies[k].inverse_inertia * own[k];
            pull[k] = bodies[k].inverse_inertia * own[k].cross(start[k]);
        }
    }
    for k in 0..N {
        spin[k] = bodies[k].rotation * (start[k] + pull[k] * half_h);
        bodies[k].spin = spin[k];
        bodies[k].position = bodies[k].position + bodies[k].velocity * h;
    }
    let turns = rotations_of(spin, h);
    for k in 0..N {
        bodies[k].turn = turns[k] * bodies[k].turn;
    }
    for body in bodies.iter_mut() {
        let turn = body.turn;
        body.turn = turn.times(all(1.5) - all(0.5) * turn.length_squared());
    }
    for body in bodies.iter_mut() {
        body.rotation = body.turn.matrix();
    }
    for (k, body) in bodies.iter_mut().enumerate() {
        let (v, w) = (body.velocity.abs(), body.spin.abs());
        body.travel = body.travel + (v.x + v.y + v.z + body.radius * w.sum()) * h;
        let (velocity, spin) = (before[k][0] + body.velocity, before[k][1] + body.spin);
        *input = *input - body.mass * shaking.dot(velocity);
        *contact = *contact + (loads[k].force.dot(velocity) + loads[k].torque.dot(spin));
    }
}

/// As [`rotation_of`], for the vectors times `h`.
#[inline(always)]
fn rotations_of<S: Simd, const N: usize>(spins: [Vector<S>; N], h: Real<S>) -> [Turn<S>; N] {
    let all = |value: f64| Real::all(h.0, value);
    let (zero, one) = (all(0.0), all(1.0));
    let ([s3, s5, s7], [c2, c4, c6]) = (SINE_SERIES.map(all), COSINE_SERIES.map(all));
    let mut turns = [Turn([zero; 4]); N];
    let mut squares = [zero; N];
    for k in 0..N {
        let vector = spins[k] * h;
        squares[k] = vector.dot(vector);
    }
    for k in 0..N {
        let q = all(0.25) * squares[k];
        let sine = all(0.5) * (one - q * s3 * (one - q * s5 * (one - q * s7)));
        let cosine = one - q * c2 * (one - q * c4 * (one - q * c6));
        let v = spins[k] * h * sine;
        turns[k] = Turn([v.x, v.y, v.z, cosine]);
    }
    for k in 0..N {
        if squares[k].above(all(SERIES_MOST)).any() {
            far_turns(&mut turns[k], &(spins[k] * h));
        }
    }
    turns
}

/// Rotation in lanes whose angle is too large for the series.
#[cold]
fn far_turns<S: Simd>(turn: &mut Turn<S>, vector: &Vector<S>) {
    for lane in 0..S::F64_LANES {
        turn.set(lane, rotation_of(vector.get(lane)));
    }
}
