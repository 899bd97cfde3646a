//! Stiffness, damping and mass matrices of an assembly in its current state, and its largest stable step.
//!
//! Degrees of freedom of each block: the displacement of its centroid [m] and its rotation [rad] about it, in the ground's axes.

use super::assembly::Assembly;
use super::block_skyline::{BlockSkyline, SIX};
use super::links::{Link, Prop};
use super::patch::{LANES, Patch};
use dolmen_linalg::Matrix;
use glam::{DMat3, DVec3};

/// Fraction of the friction limit from which a point counts as slipping: a slipping point reaches the whole limit except for
/// rounding.
const SLIPPING: f64 = 1.0 - 1e-9;
/// Gap up to which a joint as drawn is in contact, m: rounding of positions gives about 1e-16 m of either sign. Our choice.
const ROUNDING_M: f64 = 1e-12;
/// Number of steps of the power iteration: an accuracy of one per cent of the largest frequency is sufficient.
const POWER_STEPS: usize = 80;

/// Number of stones from which matrices are stored within their skyline. Our choice: below it a full matrix costs no more.
pub(super) const OUTLINE_FROM: usize = 40;

/// A matrix [6n × 6n] to which entries are added.
pub(super) trait Entries {
    fn add(&mut self, row: usize, column: usize, value: f64);
}

impl Entries for Matrix {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self[(row, column)] += value;
    }
}

impl Entries for BlockSkyline {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.block_mut(row / SIX, column / SIX)[row % SIX][column % SIX] += value;
    }
}

/// A zero matrix within the skyline of all contacts and ties.
pub(super) fn within_outline(assembly: &Assembly) -> BlockSkyline {
    let mut first: Vec<usize> = (0..assembly.bodies.len() - 1).collect();
    let patches = assembly
        .patches()
        .map(|patch| [patch.plane_body, patch.point_body]);
    let links = assembly.links().iter().map(|link| [link.lower, link.upper]);
    for [a, b] in patches.chain(links) {
        let (low, high) = (a.min(b), a.max(b));
        if low > 0 {
            first[high - 1] = first[high - 1].min(low - 1);
        }
    }
    BlockSkyline::within(first)
}

/// The property in the matrix: springs or dashpots.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    /// Springs of points in contact.
    Springs,
    /// Dashpots of the contacts.
    Dashpots,
}

/// The points taken as closed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Closed {
    /// All points in contact, sticking: as drawn.
    Touching,
    /// Contacts in compression; slipping ones have only normal springs.
    Pressed,
    /// Contacts in compression, all sticking.
    Stuck,
    /// Contacts deeper than this, m; slipping ones have only normal springs.
    Deeper(f64),
}

/// Fraction of the deepest contact below which a contact at rest only touches. Our choice: the balance of forces at rest misses 1e-7 of the weight.
const TOUCHES_ONLY: f64 = 1e-6;

/// The contacts that are closed in small motion about the position of rest.
///
/// A contact without pressure opens in one half of each cycle, and rounding decides whether it counts as in compression: upright joints between
/// stones that settle equally have depths of ±1e-17 m. They are left out, as side supports that only touch.
pub(super) fn closed_at_rest(assembly: &Assembly) -> Closed {
    let mut deepest = 0.0_f64;
    for patch in assembly.patches() {
        let motion = patch.motion(&assembly.bodies);
        for group in &patch.points {
            for lane in (0..LANES).filter(|&lane| group.area[lane] > 0.0) {
                deepest = deepest.max(-patch.place(group, lane, &motion).z);
            }
        }
    }
    Closed::Deeper(TOUCHES_ONLY * deepest)
}

/// Stiffness between two bodies, about a point fixed to both, in the axes of the ground: when the second moves by u and
/// rotates by θ relative to the first, the force and moment on it are −(F u + C θ) and −(Cᵀ u + T θ).
#[derive(Clone, Copy, Debug)]
struct Bond {
    force: DMat3,
    coupling: DMat3,
    torque: DMat3,
}

impl Bond {
    fn none() -> Self {
        Bond {
            force: DMat3::ZERO,
            coupling: DMat3::ZERO,
            torque: DMat3::ZERO,
        }
    }

    /// A 3 × 3 stiffness without arm.
    fn at_point(force: DMat3) -> Self {
        Bond {
            force,
            ..Bond::none()
        }
    }

    /// Adds springs along the axes at `place`, relative to the point.
    fn add(&mut self, place: DVec3, springs: DVec3) {
        // displacement of the place: u + θ × r = u − [r] θ; moment: r × f = [r] f
        let across = cross_matrix(place);
        let force = DMat3::from_diagonal(springs);
        let coupling = force * -across;
        self.force += force;
        self.coupling += coupling;
        self.torque += across * coupling;
    }

    /// The stiffness in rotated axes.
    fn turned(&self, axes: &DMat3) -> Self {
        let turn = |matrix: DMat3| *axes * matrix * axes.transpose();
        Bond {
            force: turn(self.force),
            coupling: turn(self.coupling),
            torque: turn(self.torque),
        }
    }

    /// Adds the stiffness to K between two bodies, each with the vector from its centroid to the point.
    fn add_to(&self, matrix: &mut impl Entries, ends: [(usize, DVec3); 2]) {
        for (a, (body_a, arm_a)) in ends.iter().enumerate() {
            for (b, (body_b, arm_b)) in ends.iter().enumerate() {
                if *body_a == 0 || *body_b == 0 {
                    continue;
                }
                let sign = if a == b { 1.0 } else { -1.0 };
                let (arm_a, arm_b) = (cross_matrix(*arm_a), cross_matrix(*arm_b));
                let by_turn = self.coupling - self.force * arm_b;
                let blocks = [
                    [self.force, by_turn],
                    [
                        arm_a * self.force + self.coupling.transpose(),
                        arm_a * by_turn + self.torque - self.coupling.transpose() * arm_b,
                    ],
                ];
                for (i, row) in blocks.iter().enumerate() {
                    for (j, block) in row.iter().enumerate() {
                        let (row, column) = (6 * (body_a - 1) + 3 * i, 6 * (body_b - 1) + 3 * j);
                        for (n, entries) in block.to_cols_array_2d().iter().enumerate() {
                            for (m, entry) in entries.iter().enumerate() {
                                matrix.add(row + m, column + n, sign * entry);
                            }
                        }
                    }
                }
            }
        }
    }
}

/// [v]: [v] w = v × w.
fn cross_matrix(v: DVec3) -> DMat3 {
    DMat3::from_cols(
        DVec3::new(0.0, v.z, -v.y),
        DVec3::new(-v.z, 0.0, v.x),
        DVec3::new(v.y, -v.x, 0.0),
    )
}

/// A connection between two bodies: a contact, a dowel or a clamp.
struct Connection {
    /// Indices of the bodies, 0 the ground, each with the vector from its centroid to the point.
    ends: [(usize, DVec3); 2],
    bond: Bond,
}

/// Stiffness or damping of all contacts, [6n × 6n].
pub(super) fn contact_matrix(assembly: &Assembly, part: Part, closed: Closed) -> Matrix {
    let size = 6 * (assembly.bodies.len() - 1);
    let mut matrix = Matrix::zeros(size, size);
    add_contacts(assembly, part, closed, &mut matrix);
    matrix
}

/// Adds the stiffness or damping of all contacts.
pub(super) fn add_contacts(assembly: &Assembly, part: Part, closed: Closed, matrix: &mut impl Entries) {
    for patch in assembly.patches() {
        let between = across_patch(assembly, patch, part, closed);
        between.bond.add_to(matrix, between.ends);
    }
    if part == Part::Springs {
        for link in assembly.links().iter().filter(|link| !link.broken) {
            let between = across_link(assembly, link);
            between.bond.add_to(matrix, between.ends);
        }
    }
}

#[derive(Clone, Debug)]
pub(super) struct SpringsBetween {
    /// Indices of the bodies, 0 the ground.
    pub(super) bodies: [usize; 2],
    /// Whether they belong to a dowel, a clamp or a side support.
    pub(super) is_link: bool,
    /// Stiffness of both bodies, [12 × 12]; the rows of the ground are 0.
    pub(super) stiffness: Matrix,
}

pub(super) fn springs_of_prop(assembly: &Assembly, prop: &Prop) -> SpringsBetween {
    let mut stiffness = Matrix::zeros(12, 12);
    let body = &assembly.bodies[prop.body];
    let arm = body.now(prop.drawn) - body.position;
    // the block is body 2 of two, the ground is 0
    stiff_along(prop).add_to(&mut stiffness, [(0, DVec3::ZERO), (2, arm)]);
    SpringsBetween {
        bodies: [0, prop.body],
        is_link: true,
        stiffness,
    }
}

/// The springs of each contact: their sum is [`contact_matrix`].
pub(super) fn springs_between(assembly: &Assembly, closed: Closed) -> Vec<SpringsBetween> {
    let patches = assembly
        .patches()
        .map(|patch| (across_patch(assembly, patch, Part::Springs, closed), false));
    let links = assembly.links().iter().filter(|link| !link.broken);
    let links = links.map(|link| (across_link(assembly, link), true));
    let alone = patches.chain(links).map(|(between, is_link)| {
        let bodies = between.ends.map(|(body, _)| body);
        // the two bodies are 1 and 2, the ground is 0
        let mut ends = between.ends;
        for (own, (body, _)) in ends.iter_mut().enumerate() {
            *body = (own + 1) * usize::from(*body > 0);
        }
        let mut stiffness = Matrix::zeros(12, 12);
        between.bond.add_to(&mut stiffness, ends);
        SpringsBetween {
            bodies,
            is_link,
            stiffness,
        }
    });
    alone.collect()
}

fn across_patch(assembly: &Assembly, patch: &Patch, part: Part, closed: Closed) -> Connection {
    let bodies = &assembly.bodies;
    let motion = patch.motion(bodies);
    let (normal, shear) = match part {
        Part::Springs => (patch.law.normal_stiffness, patch.law.shear_stiffness),
        Part::Dashpots => (patch.law.normal_damping, patch.law.shear_damping),
    };
    let mut bond = Bond::none();
    for group in &patch.points {
        for lane in 0..LANES {
            let at = patch.place(group, lane, &motion);
            let bonded = group.bond[lane] > 0.0;
            let open = match closed {
                Closed::Touching => at.z > ROUNDING_M,
                Closed::Pressed | Closed::Stuck => at.z >= 0.0,
                Closed::Deeper(least_m) => at.z >= -least_m,
            };
            if group.area[lane] <= 0.0 || (open && !bonded) {
                continue;
            }
            let stretch = (at.x - group.anchor_x[lane]).hypot(at.y - group.anchor_y[lane]);
            let limit = group.friction[lane] * patch.law.normal_stiffness * -at.z;
            let slips = matches!(closed, Closed::Pressed | Closed::Deeper(_))
                && !bonded
                && patch.law.shear_stiffness * stretch > SLIPPING * limit;
            let shear = if slips { 0.0 } else { shear };
            bond.add(at, DVec3::new(shear, shear, normal) * group.area[lane]);
        }
    }
    let end = |body: usize| (body, motion.origin - bodies[body].position);
    Connection {
        ends: [end(patch.plane_body), end(patch.point_body)],
        bond: bond.turned(&motion.to_ground),
    }
}

fn across_link(assembly: &Assembly, link: &Link) -> Connection {
    let bodies = &assembly.bodies;
    let axis = bodies[link.lower].rotation * link.axis;
    let outer = DMat3::from_cols(axis * axis.x, axis * axis.y, axis * axis.z);
    let across = DMat3::IDENTITY - outer;
    let end = |body: usize| (body, bodies[body].now(link.drawn) - bodies[body].position);
    Connection {
        ends: [end(link.lower), end(link.upper)],
        bond: Bond::at_point(outer * link.axial_stiffness + across * link.shear_stiffness),
    }
}

/// Adds all side supports as if they were in contact, for the stable step.
pub(super) fn add_props(assembly: &Assembly, matrix: &mut Matrix) {
    for prop in assembly.props() {
        add_prop(assembly, prop, matrix);
    }
}

pub(super) fn add_prop(assembly: &Assembly, prop: &Prop, matrix: &mut impl Entries) {
    let body = &assembly.bodies[prop.body];
    let arm = body.now(prop.drawn) - body.position;
    stiff_along(prop).add_to(matrix, [(0, DVec3::ZERO), (prop.body, arm)]);
}

fn stiff_along(prop: &Prop) -> Bond {
    let d = prop.direction;
    Bond::at_point(DMat3::from_cols(d * d.x, d * d.y, d * d.z) * prop.stiffness)
}

/// Adds the side supports in compression.
pub(super) fn add_pressed_props(assembly: &Assembly, matrix: &mut impl Entries) {
    for prop in assembly.props() {
        if prop.depth(&assembly.bodies[prop.body]) > 0.0 {
            add_prop(assembly, prop, matrix);
        }
    }
}

/// Mass and inertia about the present axes, [6n × 6n].
pub(super) fn mass_matrix(assembly: &Assembly) -> Matrix {
    let size = 6 * (assembly.bodies.len() - 1);
    let mut matrix = Matrix::zeros(size, size);
    add_mass(assembly, 1.0, &mut matrix);
    matrix
}

pub(super) fn add_mass(assembly: &Assembly, times: f64, matrix: &mut impl Entries) {
    for (block, body) in assembly.bodies.iter().skip(1).enumerate() {
        let inertia = (body.rotation * body.inertia * body.rotation.transpose()).to_cols_array_2d();
        for i in 0..3 {
            matrix.add(6 * block + i, 6 * block + i, times * body.mass);
            for (j, column) in inertia.iter().enumerate() {
                matrix.add(6 * block + 3 + i, 6 * block + 3 + j, times * column[i]);
            }
        }
    }
}

/// The longest step at which the leapfrog with these springs and dashpots is stable, s.
///
/// ```text
/// ω²: largest eigenvalue of M⁻¹K,   c: largest of M⁻¹C:   ω² h² + 2 c h ≤ 4
/// ```
///
/// The springs include contact on any one face of any block, as after a fall.
pub(super) fn longest_step(assembly: &Assembly) -> f64 {
    let mut springs = contact_matrix(assembly, Part::Springs, Closed::Touching);
    add_props(assembly, &mut springs);
    // a block between two others has contacts on both sides
    let square = largest(assembly, &springs).max(2.0 * assembly.stiffest());
    let damping = largest(
        assembly,
        &contact_matrix(assembly, Part::Dashpots, Closed::Touching),
    );
    ((damping * damping + 4.0 * square).sqrt() - damping) / square
}

/// The longest step at which the leapfrog is stable with dowels, clamps and side supports only, s; infinite without any.
pub(super) fn longest_step_of_held(assembly: &Assembly) -> f64 {
    let size = 6 * (assembly.bodies.len() - 1);
    let mut springs = Matrix::zeros(size, size);
    for link in assembly.links() {
        let between = across_link(assembly, link);
        between.bond.add_to(&mut springs, between.ends);
    }
    add_props(assembly, &mut springs);
    2.0 / largest(assembly, &springs).sqrt()
}

/// Largest eigenvalue of M⁻¹A, by power iteration, increased by one per cent for the error of the iteration.
fn largest(assembly: &Assembly, matrix: &Matrix) -> f64 {
    let size = matrix.rows();
    // an unsymmetric start vector, so that no symmetry of the stack hides its largest mode
    let mut x: Vec<f64> = (0..size).map(|i| 1.0 + 0.618 * ((i * i) as f64).sin()).collect();
    let mut value = 0.0;
    for _ in 0..POWER_STEPS {
        let mut y = matrix.times(&x);
        for (block, body) in assembly.bodies.iter().skip(1).enumerate() {
            let at = 6 * block;
            for entry in &mut y[at..at + 3] {
                *entry *= body.inverse_mass;
            }
            let inverse = body.rotation * body.inverse_inertia * body.rotation.transpose();
            let turned = inverse * DVec3::new(y[at + 3], y[at + 4], y[at + 5]);
            y[at + 3..at + 6].copy_from_slice(&turned.to_array());
        }
        let norm = y.iter().map(|v| v * v).sum::<f64>().sqrt();
        let before = x.iter().map(|v| v * v).sum::<f64>().sqrt();
        if norm == 0.0 {
            return 0.0;
        }
        value = norm / before;
        x = y.iter().map(|v| v / norm).collect();
    }
    1.01 * value
}
