//! Reduction of the stiffness of a stack by gravity, and the stones that topple, with matrices within their skyline.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | K | `springs` | stiffness of the contacts; all contacts in compression stick | N/m, N, N m |
//! | G | `add_weights` | geometric stiffness: change of the forces at rest as stones move and rotate | N/m, N, N m |
//! | M | `add_mass` | masses and inertias | kg, kg m² |
//! | s | `shift` | (rad/s)² added to all eigenvalues | 1/s² |
//! | f | `force` | force of a contact on the upper end S, in the ground's axes | N |
//! | r_P, r_S | `arm` | vector from each body's centroid to the contact | m |

use super::assembly::Assembly;
use super::block_skyline::{BlockSkyline, SIX};
use super::matrices::{Closed, Entries, Part, add_contacts, add_mass, add_pressed_props, within_outline};
use super::patch::LANES;
use glam::DVec3;

/// Relative increase of the stiffness against rounding, so that a stone without support counts as neutral. Our choice.
pub(super) const NEUTRAL: f64 = 1e-12;
/// Number of halvings of the interval of the factor, and its upper end.
const HALVINGS: usize = 40;
const FACTOR_MOST: f64 = 1e6;
/// Smallest trial shift, (rad/s)², and factor to the next. Our choice.
const SHIFT_LEAST: f64 = 1e-6;
const SHIFT_GROWS: f64 = 16.0;
const SHIFTS_MOST: usize = 40;
/// Number of halvings of the interval of the shift: to 0.3 %.
const SHIFT_HALVINGS: usize = 10;
/// Number of inverse iterations. Our choice: at such a shift, each iteration reduces all but the softest modes to a
/// hundredth.
const ROUNDS: usize = 12;

/// For a stack that is unstable on its springs: the smallest factor on all springs at which it is stable.
pub(super) fn factor_to_stand(stands: impl Fn(f64) -> bool) -> f64 {
    let (mut topples, mut standing) = (1.0_f64, FACTOR_MOST);
    for _ in 0..HALVINGS {
        let middle = (topples * standing).sqrt();
        match stands(middle) {
            true => standing = middle,
            false => topples = middle,
        }
    }
    standing
}

/// Stability of a stack on its springs.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum Standing {
    /// K + G is positive definite.
    Stands,
    /// It is unstable: the factor on K at which it would be stable, and the block with the largest lateral motion in the
    /// softest mode.
    Topples { factor: f64, block: usize },
    /// The matrix has no factors within its skyline.
    Singular,
}

/// Stiffness of many stones, stored only for pairs in contact.
pub(super) struct TowerOutline<'a> {
    assembly: &'a Assembly,
    springs: BlockSkyline,
}

impl<'a> TowerOutline<'a> {
    pub(super) fn of(assembly: &'a Assembly) -> Self {
        let mut springs = within_outline(assembly);
        add_contacts(assembly, Part::Springs, Closed::Stuck, &mut springs);
        add_pressed_props(assembly, &mut springs);
        springs.stiffen(NEUTRAL);
        TowerOutline { assembly, springs }
    }

    pub(super) fn standing(&self) -> Standing {
        match self.factors(1.0, 0.0) {
            Some(factors) if factors.is_positive_definite() => return Standing::Stands,
            Some(_) => {}
            None => return Standing::Singular,
        }
        match self.softest_block() {
            Some(block) => Standing::Topples {
                factor: factor_to_stand(|factor| self.positive_definite(factor, 0.0).is_some()),
                block,
            },
            None => Standing::Singular,
        }
    }

    /// The factors of K + G/`factor` + s M; `None` if it is singular.
    fn factors(&self, factor: f64, shift: f64) -> Option<BlockSkyline> {
        let mut matrix = self.springs.clone();
        let share = 0.5 / factor;
        add_weights(
            self.assembly,
            &mut Symmetrised {
                matrix: &mut matrix,
                share,
            },
        );
        if shift > 0.0 {
            add_mass(self.assembly, shift, &mut matrix);
        }
        matrix.factor().then_some(matrix)
    }

    fn positive_definite(&self, factor: f64, shift: f64) -> Option<BlockSkyline> {
        let factors = self.factors(factor, shift)?;
        factors.is_positive_definite().then_some(factors)
    }

    /// The block with the largest lateral motion in the mode of the smallest eigenvalue of K + G with respect to M.
    ///
    /// ```text
    /// with −s just below that eigenvalue, so that K + G + s M is still positive definite:   (K + G + s M) x ← M x
    /// ```
    fn softest_block(&self) -> Option<usize> {
        let mut shift = SHIFT_LEAST;
        let mut found = None;
        for _ in 0..SHIFTS_MOST {
            found = self.positive_definite(1.0, shift);
            if found.is_some() {
                break;
            }
            shift *= SHIFT_GROWS;
        }
        let mut factors = found?;
        let (mut below, mut above) = (shift / SHIFT_GROWS, shift);
        for _ in 0..SHIFT_HALVINGS {
            let middle = (below * above).sqrt();
            match self.positive_definite(1.0, middle) {
                Some(nearer) => (above, factors) = (middle, nearer),
                None => below = middle,
            }
        }
        let blocks = self.assembly.bodies.len() - 1;
        // an unsymmetric start vector, so that no symmetry of the stack hides its softest mode
        let mut x: Vec<[f64; SIX]> = (0..blocks)
            .map(|block| std::array::from_fn(|i| 1.0 + 0.618 * (((SIX * block + i).pow(2)) as f64).sin()))
            .collect();
        for _ in 0..ROUNDS {
            self.times_mass(&mut x);
            factors.solve(&mut x);
            let most = x
                .iter()
                .flatten()
                .fold(0.0_f64, |most, value| most.max(value.abs()));
            if !(most > 0.0 && most.is_finite()) {
                return None;
            }
            x.iter_mut().flatten().for_each(|value| *value /= most);
        }
        let moves = |block: &usize| x[*block][0].hypot(x[*block][1]);
        (0..blocks).max_by(|a, b| moves(a).total_cmp(&moves(b)))
    }

    /// M x.
    fn times_mass(&self, x: &mut [[f64; SIX]]) {
        for (six, body) in x.iter_mut().zip(self.assembly.bodies.iter().skip(1)) {
            let turn = DVec3::new(six[3], six[4], six[5]);
            let turned = body.rotation * (body.inertia * (body.rotation.transpose() * turn));
            let [x, y, z] = [0, 1, 2].map(|axis| body.mass * six[axis]);
            *six = [x, y, z, turned.x, turned.y, turned.z];
        }
    }
}

/// Adds `share` times each entry on both sides of the diagonal.
struct Symmetrised<'a> {
    matrix: &'a mut BlockSkyline,
    share: f64,
}

impl Entries for Symmetrised<'_> {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.matrix.add(row, column, self.share * value);
        self.matrix.add(column, row, self.share * value);
    }
}

/// Adds G without symmetrising it.
pub(super) fn add_weights(assembly: &Assembly, matrix: &mut impl Entries) {
    let bodies = &assembly.bodies;
    for patch in assembly.patches() {
        let motion = patch.motion(bodies);
        for group in &patch.points {
            for lane in (0..LANES).filter(|&lane| group.area[lane] > 0.0) {
                let at = patch.place(group, lane, &motion);
                let force = motion.to_ground * patch.force_at_rest(group, lane, at);
                let place = motion.origin + motion.to_ground * at;
                let end = |body: usize| (body, place - bodies[body].position);
                add_weight(matrix, end(patch.plane_body), end(patch.point_body), force);
            }
        }
    }
    for link in assembly.links().iter().filter(|link| !link.broken) {
        let (force, place) = link.force(bodies);
        let end = |body: usize| (body, place - bodies[body].position);
        add_weight(matrix, end(link.lower), end(link.upper), force);
    }
    for prop in assembly.props() {
        let body = &bodies[prop.body];
        let arm = body.now(prop.drawn) - body.position;
        let force = prop.direction * (-prop.stiffness * prop.depth(body));
        add_weight(matrix, (0, DVec3::ZERO), (prop.body, arm), force);
    }
    for load in assembly.dead_loads() {
        let body = &bodies[load.body];
        let arm = body.now(load.drawn) - body.position;
        add_weight(matrix, (0, DVec3::ZERO), (load.body, arm), load.force);
    }
}

/// Adds the geometric stiffness of one force to G.
fn add_weight(matrix: &mut impl Entries, plane: (usize, DVec3), point: (usize, DVec3), force: DVec3) {
    let ((p, arm_p), (s, arm_s)) = (plane, point);
    for (moved, of_point) in [(p, false), (s, true)] {
        if moved == 0 {
            continue;
        }
        for freedom in 0..6 {
            let axis = DVec3::AXES[freedom % 3];
            let (shift, turn) = match freedom < 3 {
                true => (axis, DVec3::ZERO),
                false => (DVec3::ZERO, axis),
            };
            let [mut turned, mut arm_turned, mut apart] = [DVec3::ZERO; 3];
            if of_point {
                arm_turned = turn.cross(arm_s);
                apart = shift + arm_turned;
            } else {
                turned = turn.cross(force);
                apart -= shift;
            }
            let of_s = [turned, arm_turned.cross(force) + arm_s.cross(turned)];
            let of_p = [-turned, -apart.cross(force) - arm_p.cross(turned)];
            for (body, [push, torque]) in [(p, of_p), (s, of_s)] {
                if body == 0 {
                    continue;
                }
                for i in 0..3 {
                    let (row, column) = (6 * (body - 1) + i, 6 * (moved - 1) + freedom);
                    matrix.add(row, column, -push[i]);
                    matrix.add(row + 3, column, -torque[i]);
                }
            }
        }
    }
}
