//! Decides whether a stack at rest is stable on its springs, from its stiffness reduced by P-delta.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | K | `contact_matrix` | stiffness of the contacts; all contacts in compression stick | N/m, N, N m |
//! | G | `add_weight` | geometric stiffness: change of the forces at rest as stones move and rotate | N/m, N, N m |
//! | f | – | force of a contact on the upper body S, in the axes of the ground | N |
//! | r_P, r_S | – | vectors from the centroid of each body to the contact | m |

use super::assembly::Assembly;
use super::error::BlocksError;
use super::matrices::{Closed, OUTLINE_FROM, Part, add_pressed_props, contact_matrix, mass_matrix};
use super::toppling::{NEUTRAL, Standing, TowerOutline, add_weights, factor_to_stand};
use crate::structure::stack::{Body, Stack};
use dolmen_linalg::{Matrix, cholesky, generalized_symmetric_eigen};

/// Refuses a stack whose position of rest is unstable.
///
/// ```text
/// K + G positive definite
/// G q = −d(force, torque):   S: θ_P × f,   (θ_S × r_S) × f + r_S × (θ_P × f)
///                            P: −θ_P × f,   −(u_S + θ_S × r_S − u_P) × f − r_P × (θ_P × f)
/// ```
///
/// # Errors
/// [`BlocksError::Topples`] or, on soil, [`BlocksError::TopplesOnSoil`], with the smallest factor on all springs for which the stack stands.
pub(super) fn check_standing(assembly: &Assembly, stack: &Stack) -> Result<(), BlocksError> {
    let mut standing = match assembly.bodies.len() > OUTLINE_FROM {
        true => TowerOutline::of(assembly).standing(),
        false => Standing::Singular,
    };
    if standing == Standing::Singular {
        standing = by_full_matrix(assembly)?;
    }
    match standing {
        Standing::Topples { factor, block } => {
            let block = stack.name(Body::Block(block)).to_owned();
            Err(match stack.soil() {
                Some(_) => BlocksError::TopplesOnSoil { factor, block },
                None => BlocksError::Topples { factor, block },
            })
        }
        Standing::Stands | Standing::Singular => Ok(()),
    }
}

/// The check with the full matrix, which also applies if a stone has no support.
fn by_full_matrix(assembly: &Assembly) -> Result<Standing, BlocksError> {
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
        return Ok(Standing::Stands);
    }
    let softest = generalized_symmetric_eigen(&with(1.0), &mass_matrix(assembly))?;
    let shape = softest.vectors.column(0);
    let moves = |block: usize| shape[6 * block].hypot(shape[6 * block + 1]);
    let block = (0..size / 6).max_by(|a, b| moves(*a).total_cmp(&moves(*b)));
    Ok(Standing::Topples {
        factor: factor_to_stand(stands),
        block: block.unwrap_or(0),
    })
}

/// G of all contacts, ties and side supports at rest, [6n × 6n]; symmetric, because every stone is in equilibrium.
fn weight_matrix(assembly: &Assembly) -> Matrix {
    let size = 6 * (assembly.bodies.len() - 1);
    let mut matrix = Matrix::zeros(size, size);
    add_weights(assembly, &mut matrix);
    Matrix::from_fn(size, size, |i, j| 0.5 * (matrix[(i, j)] + matrix[(j, i)]))
}

#[cfg(test)]
mod tests {
    use super::super::contact_points::ContactRule;
    use super::super::rest::settle;
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};
    use glam::DVec3;

    fn tower(sizes: &[[f64; 3]], normal_stiffness_pa_m: f64, shear_stiffness_pa_m: f64) -> Stack {
        leaning(sizes, [0.01, 0.02], normal_stiffness_pa_m, shear_stiffness_pa_m)
    }

    fn straight(sizes: &[[f64; 3]], normal_stiffness_pa_m: f64, shear_stiffness_pa_m: f64) -> Stack {
        leaning(sizes, [0.0; 2], normal_stiffness_pa_m, shear_stiffness_pa_m)
    }

    /// A pile in which each stone is shifted relative to the one below.
    fn leaning(
        sizes: &[[f64; 3]],
        by: [f64; 2],
        normal_stiffness_pa_m: f64,
        shear_stiffness_pa_m: f64,
    ) -> Stack {
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, [width, depth, height])| {
            let place = Placement {
                position_m: [by[0] * i as f64, by[1] * i as f64, z],
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
        // k b⁴/12 = m g H/2 about the axis along which the base is b wide: 0.4 × 0.8 × 4 m
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
    fn agrees_many_stones_that_topple_with_the_full_matrix() {
        // 48 stones on soft springs; an oblong stack, in which one direction is softer, and a square one
        for (width, depth) in [(1.0, 1.2), (1.0, 1.0)] {
            let sizes: Vec<[f64; 3]> = (0..48)
                .map(|i| [width - 0.004 * f64::from(i), depth - 0.004 * f64::from(i), 0.5])
                .collect();
            let stack = straight(&sizes, 3e7, 1.2e7);
            let mut assembly = Assembly::of(&stack, ContactRule::Four);
            let rested = settle(&mut assembly, &stack);
            let Standing::Topples { factor, block } = by_full_matrix(&assembly).unwrap() else {
                panic!("it stands")
            };
            let Err(BlocksError::Topples {
                factor: found,
                block: name,
            }) = rested
            else {
                panic!("{rested:?}")
            };
            assert!((found / factor - 1.0).abs() < 1e-7, "{found} {factor}");
            assert_eq!(name, format!("stone {block}"));
        }
    }

    #[test]
    fn holds_what_gravity_takes_is_the_slope_of_the_forces() {
        // numerical derivative of the forces about the rest position of a leaning stack, compared with K + G
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
