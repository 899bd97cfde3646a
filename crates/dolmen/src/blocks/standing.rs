//! Whether a stack at rest stands on its springs, or topples: its stiffness with what gravity takes from it (P-delta).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | K | `contact_matrix` | stiffness of the contacts, all that are pressed stuck | N/m, N, N m |
//! | G | `add_weight` | what the forces at rest add as stones move and turn | N/m, N, N m |
//! | f | `force` | force of a contact on the upper end S, in the ground's axes | N |
//! | r_P, r_S | `arm` | from each body's centroid to the contact | m |

use super::assembly::Assembly;
use super::block_skyline::BlockSkyline;
use super::error::BlocksError;
use super::matrices::{
    Closed, Entries, OUTLINE_FROM, Part, add_contacts, add_pressed_props, contact_matrix, mass_matrix,
    within_outline,
};
use super::patch::LANES;
use crate::structure::stack::{Body, Stack};
use dolmen_linalg::{Matrix, cholesky, generalized_symmetric_eigen};
use glam::DVec3;

/// Part of the stiffness added to itself, against rounding: a stone that nothing holds counts as neutral. Chosen here.
const NEUTRAL: f64 = 1e-12;
/// Halvings of the interval in which the factor lies, and its upper end.
const HALVINGS: usize = 40;
const FACTOR_MOST: f64 = 1e6;

/// Refuses a stack at rest that any touch would topple.
///
/// ```text
/// K + G positive definite
/// G q = −d(force, torque):   S: θ_P × f,   (θ_S × r_S) × f + r_S × (θ_P × f)
///                            P: −θ_P × f,   −(u_S + θ_S × r_S − u_P) × f − r_P × (θ_P × f)
/// ```
///
/// # Errors
/// [`BlocksError::Topples`] with the factor on all springs from which it would stand.
pub(super) fn check_standing(assembly: &Assembly, stack: &Stack) -> Result<(), BlocksError> {
    if assembly.bodies.len() > OUTLINE_FROM && stands_within_outline(assembly) {
        return Ok(());
    }
    let mut springs = contact_matrix(assembly, Part::Springs, Closed::Stuck);
    add_pressed_props(assembly, &mut springs);
    let size = springs.rows();
    for i in 0..size {
        springs[(i, i)] += f64::MIN_POSITIVE + NEUTRAL * springs[(i, i)];
    }
    let weight = weight_matrix(assembly);
    let with = |factor: f64| Matrix::from_fn(size, size, |i, j| factor * springs[(i, j)] + weight[(i, j)]);
    let stands = |factor: f64| cholesky(&with(factor)).is_ok();
    if stands(1.0) {
        return Ok(());
    }
    let softest = generalized_symmetric_eigen(&with(1.0), &mass_matrix(assembly))?;
    let shape = softest.vectors.column(0);
    let moves = |block: usize| shape[6 * block].hypot(shape[6 * block + 1]);
    let block = (0..size / 6).max_by(|a, b| moves(*a).total_cmp(&moves(*b)));
    let (mut topples, mut standing) = (1.0_f64, FACTOR_MOST);
    for _ in 0..HALVINGS {
        let middle = (topples * standing).sqrt();
        match stands(middle) {
            true => standing = middle,
            false => topples = middle,
        }
    }
    Err(BlocksError::Topples {
        factor: standing,
        block: stack.name(Body::Block(block.unwrap_or(0))).to_owned(),
    })
}

/// The same within the outline of the matrix: whether K + G is positive definite.
fn stands_within_outline(assembly: &Assembly) -> bool {
    let mut matrix = within_outline(assembly);
    add_contacts(assembly, Part::Springs, Closed::Stuck, &mut matrix);
    add_pressed_props(assembly, &mut matrix);
    matrix.stiffen(NEUTRAL);
    add_weights(assembly, &mut Symmetrised(&mut matrix));
    matrix.factor() && matrix.is_positive_definite()
}

/// Adds half of an entry on either side of the diagonal.
struct Symmetrised<'a>(&'a mut BlockSkyline);

impl Entries for Symmetrised<'_> {
    fn add(&mut self, row: usize, column: usize, value: f64) {
        self.0.add(row, column, 0.5 * value);
        self.0.add(column, row, 0.5 * value);
    }
}

/// G of all contacts, ties and side supports at rest, [6n × 6n]. Symmetric, as every stone is in balance.
fn weight_matrix(assembly: &Assembly) -> Matrix {
    let size = 6 * (assembly.bodies.len() - 1);
    let mut matrix = Matrix::zeros(size, size);
    add_weights(assembly, &mut matrix);
    Matrix::from_fn(size, size, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]))
}

/// Adds G, not yet symmetric.
fn add_weights(assembly: &Assembly, matrix: &mut impl Entries) {
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

/// Adds to G what one force does.
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

#[cfg(test)]
mod tests {
    use super::super::contact_points::ContactRule;
    use super::super::rest::settle;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    fn tower(sizes: &[[f64; 3]], normal_stiffness_pa_m: f64, shear_stiffness_pa_m: f64) -> Stack {
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, [width, depth, height])| {
            let place = Placement {
                position_m: [0.01 * i as f64, 0.02 * i as f64, z],
                ..Placement::default()
            };
            z += height;
            Block {
                name: format!("stone {i}"),
                solid: Solid::cuboid(*width, *depth, *height).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        let material = JointMaterial {
            normal_stiffness_pa_m,
            shear_stiffness_pa_m,
            ..JointMaterial::default()
        };
        Stack::new(blocks.collect(), material, 9.81).unwrap()
    }

    #[test]
    fn exact_softest_bed_on_which_a_column_stands() {
        // k b⁴/12 = m g H/2 about the axis along which it is b wide: .4 × .8 × 4 m
        let least = 2600.0 * 0.4 * 0.8 * 4.0 * 9.81 * 2.0 / (0.8 * 0.4_f64.powi(3) / 12.0);
        for (part, stands) in [(0.999, false), (1.001, true)] {
            let stack = tower(&[[0.4, 0.8, 4.0]], part * least, 4e8);
            let mut assembly = Assembly::of(&stack, ContactRule::Four);
            let rested = settle(&mut assembly, &stack);
            assert_eq!(rested.is_ok(), stands, "{part}: {rested:?}");
            if let Err(BlocksError::Topples { factor, block }) = rested {
                assert!((factor * part - 1.0).abs() < 1e-6, "{factor}");
                assert_eq!(block, "stone 0");
            }
        }
    }

    #[test]
    fn holds_what_gravity_takes_is_the_slope_of_the_forces() {
        // differences of the forces about a leaning stack's rest, against K + G
        let stack = tower(&[[1.0, 0.9, 0.5], [0.8, 0.7, 0.6], [0.5, 0.6, 0.9]], 2e7, 8e6);
        let mut assembly = Assembly::of(&stack, ContactRule::Four);
        settle(&mut assembly, &stack).unwrap();
        let springs = contact_matrix(&assembly, Part::Springs, Closed::Stuck);
        let weight = weight_matrix(&assembly);
        let forces_at = |freedom: usize, by: f64| {
            let mut moved = assembly.clone();
            let body = &mut moved.bodies[freedom / 6 + 1];
            match freedom % 6 {
                axis @ 0..3 => body.position += DVec3::AXES[axis] * by,
                axis => body.turn_by(DVec3::AXES[axis - 3] * by),
            }
            let mut forces = super::super::forces::Forces::default();
            moved.forces(0.0, &mut forces);
            let each = (1..moved.bodies.len()).flat_map(|index| {
                let of = [forces.force[index], forces.torque[index]];
                of.into_iter().flat_map(|vector| vector.to_array())
            });
            each.collect::<Vec<f64>>()
        };
        let step = 1e-6;
        let mut taken = 0.0_f64;
        for freedom in 0..18 {
            let (ahead, behind) = (forces_at(freedom, step), forces_at(freedom, -step));
            for row in 0..18 {
                let slope = (behind[row] - ahead[row]) / (2.0 * step);
                let known = springs[(row, freedom)] + weight[(row, freedom)];
                assert!(
                    (slope - known).abs() < 20.0,
                    "{row} {freedom}: {slope} against {known}"
                );
                taken = taken.max(weight[(row, freedom)].abs());
            }
        }
        assert!(taken > 1e4); // N m: the weights times their heights
    }
}
