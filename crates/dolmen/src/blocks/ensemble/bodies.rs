//! The step of [`RigidBody`] for several runs at once.

use super::super::bodies::{COSINE_SERIES, RigidBody, SERIES_MOST, SINE_SERIES, rotation_of};
use super::lanes::{Columns, Real, Turn, Vector};
use pulp::Simd;

/// Force on a body of several runs, and torque about its centroid.
#[derive(Clone, Copy, Debug)]
#[repr(C, align(64))]
pub(super) struct Load<S: Simd> {
    pub(super) force: Vector<S>,
    pub(super) torque: Vector<S>,
}

/// The same body of several runs.
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
    /// The same in every lane.
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

    /// Where it is.
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

    /// As [`RigidBody::step`]; `inertia` is gravity less the shaking. Returns the sum of its velocities before
    /// and after, and twice the mean power of the forces on it.
    #[inline(always)]
    pub(super) fn step<const DIAGONAL: bool>(
        &mut self,
        load: &Load<S>,
        inertia: Vector<S>,
        kick: Real<S>,
        h: Real<S>,
    ) -> (Vector<S>, Real<S>) {
        let all = |value: f64| Real::all(h.0, value);
        let (velocity, spin_before) = (self.velocity, self.spin);
        let acceleration = load.force * self.inverse_mass + inertia;
        self.velocity = self.velocity + acceleration * kick;
        self.momentum = self.momentum + load.torque * kick;
        let own = self.rotation.transposed_times(self.momentum);
        let (start, pull) = if DIAGONAL {
            let [x, y, z] = self.inverse_inertia.0;
            let times = Vector {
                x: x.x,
                y: y.y,
                z: z.z,
            };
            let start = own.by_parts(times);
            (start, own.cross(start).by_parts(times))
        } else {
            let start = self.inverse_inertia * own;
            (start, self.inverse_inertia * own.cross(start))
        };
        let spin = self.rotation * (start + pull * (all(0.5) * h));
        self.spin = spin;
        self.position = self.position + self.velocity * h;
        let turned = lanes_rotation_of(spin * h) * self.turn;
        self.turn = turned.times(all(1.5) - all(0.5) * turned.length_squared());
        self.rotation = self.turn.matrix();
        let (v, w) = (self.velocity.abs(), spin.abs());
        self.travel = self.travel + (v.x + v.y + v.z + self.radius * w.sum()) * h;
        let (velocity, spin) = (velocity + self.velocity, spin_before + spin);
        (velocity, load.force.dot(velocity) + load.torque.dot(spin))
    }
}

/// As [`rotation_of`].
#[inline(always)]
fn lanes_rotation_of<S: Simd>(vector: Vector<S>) -> Turn<S> {
    let simd = vector.x.0;
    let one = Real::all(simd, 1.0);
    let square = vector.dot(vector);
    let q = Real::all(simd, 0.25) * square;
    let ([s3, s5, s7], [c2, c4, c6]) = (SINE_SERIES, COSINE_SERIES);
    let (s3, s5, s7) = (Real::all(simd, s3), Real::all(simd, s5), Real::all(simd, s7));
    let (c2, c4, c6) = (Real::all(simd, c2), Real::all(simd, c4), Real::all(simd, c6));
    let sine = Real::all(simd, 0.5) * (one - q * s3 * (one - q * s5 * (one - q * s7)));
    let cosine = one - q * c2 * (one - q * c4 * (one - q * c6));
    let v = vector * sine;
    let mut turn = Turn([v.x, v.y, v.z, cosine]);
    if square.above(Real::all(simd, SERIES_MOST)).any() {
        far_turns(&mut turn, &vector);
    }
    turn
}

/// Turns of lanes that are too far for the series.
#[cold]
fn far_turns<S: Simd>(turn: &mut Turn<S>, vector: &Vector<S>) {
    for lane in 0..S::F64_LANES {
        turn.set(lane, rotation_of(vector.get(lane)));
    }
}
