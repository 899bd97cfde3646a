//! Natural frequencies of a stack on its joint springs.

use super::assembly::Assembly;
use super::beside::add_springs_beside;
use super::contact_points::ContactRule;
use super::error::BlocksError;
use super::lowest_modes::lowest;
use super::matrices::{OUTLINE_FROM, Part, closed_at_rest, contact_matrix, mass_matrix};
use super::rest::settle;
use crate::structure::stack::Stack;
use dolmen_linalg::generalized_symmetric_eigen;

/// One natural mode of a stack.
#[derive(Clone, Debug, PartialEq)]
pub struct StackMode {
    /// Natural frequency, Hz.
    pub frequency_hz: f64,
    /// Effective mass of the mode over the mass of the stack, for shaking along x, y and z; over all modes the sum is 1.
    pub effective_mass_ratio: [f64; 3],
    /// Kinetic energy of the centroids along x, y and z over that of the mode; the rest is rotation of the blocks.
    pub kinetic_energy_ratio: [f64; 3],
    /// Shape: displacement of the centroid (x, y, z) and rotation (x, y, z) of each block, m and rad. It is scaled so that the largest displacement
    /// (the first of several equal ones) is 1; in pure torsion, the largest rotation.
    pub shape: Vec<[f64; 6]>,
}

/// Smallest fraction of kinetic energy along an axis for a sway mode. Our choice: a rocking block has at least 0.5. If a solver mixes two equal
/// modes, each may have half of that. Torsion has none.
const SWAY_LEAST: f64 = 0.25;

/// Index of the first sway mode along an axis (0 is x, 1 is y); `None` if there is none.
///
/// It is the lowest mode with at least a quarter of its kinetic energy in motion along that axis. The effective mass is not used: a heavy base
/// hardly moves, and the first mode of a three-storey pagoda has only 0.27 of the mass.
///
/// # Limits
/// If torsion and sway are coupled, as in a stack with stones far off centre, a mode contains both. The lower mode is then returned.
///
/// # Example
/// ```
/// use dolmen::blocks::{ContactRule, first_sway, stack_modes};
/// use dolmen::structure::stack::JointMaterial;
/// let stack = dolmen::comparisons::p10(JointMaterial::default(), 9.81)?;
/// let modes = stack_modes(&stack, ContactRule::Four)?;
/// let first = first_sway(&modes, 1).ok_or("no modes")?;
/// assert!((modes[first].frequency_hz - 4.7043).abs() < 1e-3);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn first_sway(modes: &[StackMode], axis: usize) -> Option<usize> {
    let along = |mode: &StackMode| mode.kinetic_energy_ratio.get(axis).copied().unwrap_or(0.0);
    modes.iter().position(|mode| along(mode) >= SWAY_LEAST)
}

/// Ratio of the acceleration of the stone with the largest motion to the spectral acceleration of a mode: the largest Γ φ of the centroids along an
/// axis (0 is x, 1 is y).
///
/// ```text
/// Γ = Σ m φ / φᵀ M φ        Γ φ = 1 where all stones move equally, 1.5 at the top of a straight line
/// ```
pub fn sway_amplification(stack: &Stack, mode: &StackMode, axis: usize) -> f64 {
    let masses = stack.blocks().iter().map(|block| block.mass_kg());
    let along = |block: &[f64; 6]| block.get(axis).copied().unwrap_or(0.0);
    let (mut whole, mut momentum, mut most) = (0.0, 0.0, 0.0_f64);
    for (mass, block) in masses.zip(&mode.shape) {
        whole += mass;
        momentum += mass * along(block);
        most = most.max(along(block).abs());
    }
    let effective = mode.effective_mass_ratio.get(axis).copied().unwrap_or(0.0) * whole;
    // effective = (Σ m φ)²/φᵀ M φ
    effective / momentum.abs() * most
}

/// Natural modes of a stack in contact, lowest first.
///
/// ```text
/// K φ = ω² M φ,   K = Σ Bᵀ diag(k_s, k_s, k_n) a B over the contact points closed at rest        [6n × 6n]
/// ```
///
/// # Errors
/// [`BlocksError`] if the stack does not come to rest or a decomposition fails.
///
/// Side supports that are springs in small motion are included ([`super::BesideInSmallMotion::is_spring`]).
///
/// # Limits
/// Small motion: joints that are pressed at rest stay closed. Upright joints without pressure are left out, unless they are bonded; they act in one
/// half of each cycle, so the true frequencies are higher. The reduction of the stiffness by gravity (P-delta) is
/// left out: 0.1 % of the first frequency of a ten-stone pagoda.
///
/// # Source
/// Kim, Koo & Hong (2018) Fig. 17 uses K_n 1e9, K_s 4e8 Pa/m, with corner contact.
pub fn stack_modes(stack: &Stack, contact_rule: ContactRule) -> Result<Vec<StackMode>, BlocksError> {
    let assembly = settled(stack, contact_rule)?;
    all_modes(stack, &assembly)
}

/// The lowest natural modes of a stack in contact, as by [`stack_modes`]. With more than 40 stones at least `count` modes, otherwise all.
///
/// ```text
/// A = Lᵀ (K + s M)⁻¹ L,  M = L Lᵀ;   its largest eigenvalues are 1/(ω² + s), by subspace iteration within the skyline of K
/// ```
///
/// # Errors
/// As for [`stack_modes`].
///
/// # Limits
/// As for [`stack_modes`]. Frequencies agree with it to 1e-9, shapes to 1e-6 of the largest displacement.
pub fn lowest_stack_modes(
    stack: &Stack,
    contact_rule: ContactRule,
    count: usize,
) -> Result<Vec<StackMode>, BlocksError> {
    let assembly = settled(stack, contact_rule)?;
    let size = 6 * stack.blocks().len();
    if assembly.bodies.len() <= OUTLINE_FROM || MANY * count > size {
        return all_modes(stack, &assembly);
    }
    match lowest(&assembly, count)? {
        Some(found) => Ok(found
            .iter()
            .map(|lowest| mode(stack, lowest.square, &lowest.shape))
            .collect()),
        None => all_modes(stack, &assembly),
    }
}

/// All modes are computed together if more than one in this number is requested. Our choice: the full matrix then costs no more.
const MANY: usize = 8;

fn settled(stack: &Stack, contact_rule: ContactRule) -> Result<Assembly, BlocksError> {
    let mut assembly = match stack.blocks().len() >= OUTLINE_FROM {
        true => Assembly::of_joints(stack, contact_rule),
        false => Assembly::of(stack, contact_rule),
    };
    settle(&mut assembly, stack)?;
    Ok(assembly)
}

fn all_modes(stack: &Stack, assembly: &Assembly) -> Result<Vec<StackMode>, BlocksError> {
    let mut stiffness = contact_matrix(assembly, Part::Springs, closed_at_rest(assembly));
    add_springs_beside(assembly, &mut stiffness);
    let eigen = generalized_symmetric_eigen(&stiffness, &mass_matrix(assembly))?;
    let values = eigen.values.iter().enumerate();
    Ok(values
        .map(|(at, value)| mode(stack, *value, eigen.vectors.column(at)))
        .collect())
}

/// Largest fraction of energy in displacements for pure torsion. Our choice: rounding.
const TORSION_MOST: f64 = 1e-12;

/// A mode from its ω² and its shape with φᵀ M φ = 1.
fn mode(stack: &Stack, value: f64, column: &[f64]) -> StackMode {
    let masses: Vec<f64> = stack.blocks().iter().map(|block| block.mass_kg()).collect();
    let whole: f64 = masses.iter().sum();
    let effective_mass_ratio = std::array::from_fn(|axis| {
        let of = |(block, mass): (&[f64], &f64)| mass * block[axis];
        let momentum: f64 = column.chunks_exact(6).zip(&masses).map(of).sum();
        momentum * momentum / whole
    });
    let kinetic_energy_ratio: [f64; 3] = std::array::from_fn(|axis| {
        let of = |(block, mass): (&[f64], &f64)| mass * block[axis] * block[axis];
        column.chunks_exact(6).zip(&masses).map(of).sum()
    });
    let moves = kinetic_energy_ratio.iter().sum::<f64>() > TORSION_MOST;
    let parts = if moves { 0..3 } else { 3..6 };
    // the first of several equal ones, so that rounding does not determine the sign
    let largest = column
        .chunks(6)
        .flat_map(|block| &block[parts.clone()])
        .fold(0.0_f64, |most, &v| match v.abs() > most.abs() * (1.0 + 1e-6) {
            true => v,
            false => most,
        });
    let scale = if largest == 0.0 { 1.0 } else { 1.0 / largest };
    let blocks = column.chunks_exact(6);
    StackMode {
        frequency_hz: value.max(0.0).sqrt() / std::f64::consts::TAU,
        effective_mass_ratio,
        kinetic_energy_ratio,
        shape: blocks
            .map(|block| std::array::from_fn(|i| block[i] * scale))
            .collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    fn tower(sizes: &[[f64; 3]]) -> Stack {
        let mut z = 0.0;
        let blocks = sizes.iter().enumerate().map(|(i, [width, depth, height])| {
            let place = Placement {
                position_m: [0.0, 0.0, z],
                ..Placement::default()
            };
            z += height;
            Block {
                name: format!("stone {i}"),
                solid: Solid::cuboid(*width, *depth, *height).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        });
        Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap()
    }

    #[test]
    fn exact_effective_masses_of_all_modes_are_the_whole_mass() {
        let modes = stack_modes(
            &tower(&[[1.0, 2.0, 1.5], [0.8, 1.5, 1.0], [0.5, 0.9, 0.8]]),
            ContactRule::Four,
        )
        .unwrap();
        for axis in 0..3 {
            let sum: f64 = modes.iter().map(|mode| mode.effective_mass_ratio[axis]).sum();
            assert!((sum - 1.0).abs() < 1e-9, "{axis}: {sum}");
        }
    }

    #[test]
    fn holds_the_first_sway_of_an_oblong_stack_is_lower_across_it() {
        let modes = stack_modes(
            &tower(&[[1.0, 2.0, 1.5], [0.8, 1.5, 1.0], [0.5, 0.9, 0.8]]),
            ContactRule::Four,
        )
        .unwrap();
        let [x, y] = [0, 1].map(|axis| first_sway(&modes, axis).unwrap());
        assert_eq!(x, 0);
        assert!(y > 0 && modes[y].frequency_hz > modes[x].frequency_hz);
        assert!(modes[y].effective_mass_ratio[1] > 0.4 && modes[y].effective_mass_ratio[0] < 1e-9);
        let energy: f64 = modes[y].kinetic_energy_ratio.iter().sum();
        assert!(energy > 0.5 && energy < 1.0, "{energy}");
        // rotated by a right angle, the directions are exchanged
        let modes = stack_modes(
            &tower(&[[2.0, 1.0, 1.5], [1.5, 0.8, 1.0], [0.9, 0.5, 0.8]]),
            ContactRule::Four,
        )
        .unwrap();
        assert_eq!(first_sway(&modes, 1), Some(0));
        assert_eq!(first_sway(&[], 0), None);
    }

    #[test]
    fn agrees_lowest_modes_with_those_of_the_full_matrix() {
        // not square, so that no two modes are equal
        let sizes: Vec<[f64; 3]> = (0..70)
            .map(|i| [3.0 - 0.02 * f64::from(i), 2.6 - 0.015 * f64::from(i), 0.3])
            .collect();
        let stack = tower(&sizes);
        let all = stack_modes(&stack, ContactRule::Four).unwrap();
        let lowest = lowest_stack_modes(&stack, ContactRule::Four, 24).unwrap();
        assert_eq!((all.len(), lowest.len()), (420, 24));
        for (full, found) in all.iter().zip(&lowest) {
            assert!(
                (found.frequency_hz / full.frequency_hz - 1.0).abs() < 1e-9,
                "{} {}",
                found.frequency_hz,
                full.frequency_hz
            );
            for axis in 0..3 {
                let [a, b] = [full, found].map(|mode| mode.effective_mass_ratio[axis]);
                assert!((a - b).abs() < 1e-7, "{a} {b}");
            }
            for (a, b) in full.shape.as_flattened().iter().zip(found.shape.as_flattened()) {
                assert!((a - b).abs() < 1e-6, "{a} {b}");
            }
        }
    }

    #[test]
    fn exact_signs_of_shapes_do_not_hang_on_rounding() {
        // two equal stones side by side: every frequency is double
        let placed = |name: &str, x| Block {
            name: name.to_owned(),
            solid: Solid::cuboid(1.0, 1.5, 2.0).unwrap().placed(&Placement {
                position_m: [x, 0.0, 0.0],
                ..Placement::default()
            }),
            density_kg_m3: 2600.0,
        };
        let stack = Stack::new(
            vec![placed("left", -2.0), placed("right", 2.0)],
            JointMaterial::default(),
            9.81,
        )
        .unwrap();
        let modes = stack_modes(&stack, ContactRule::Four).unwrap();
        assert_eq!(modes.len(), 12);
        for mode in &modes {
            let moves = mode.kinetic_energy_ratio.iter().sum::<f64>() > 1e-9;
            let parts = mode.shape.iter().flat_map(|block| match moves {
                true => &block[..3],
                false => &block[3..],
            });
            let first = parts.into_iter().find(|part| part.abs() > 1.0 - 1e-5).unwrap();
            assert!((first - 1.0).abs() < 1e-5, "{:?}", mode.shape);
        }
    }

    #[test]
    fn holds_a_heavy_base_does_not_hide_the_first_sway() {
        let slender = [[4.0, 4.0, 1.0], [0.5, 0.5, 1.0], [0.5, 0.5, 1.0]];
        let modes = stack_modes(&tower(&slender), ContactRule::Four).unwrap();
        let first = first_sway(&modes, 0).unwrap();
        assert!(first < 2 && modes[first].frequency_hz < 1.001 * modes[0].frequency_hz);
        assert!(modes[first].effective_mass_ratio[0] < 0.1);
    }

    /// Upright joints carry nothing at rest: without a tolerance, rounding decides which of them are closed, and frequencies differ by 8 %. What is
    /// left: rounding decides which of two equal faces is the plane of their contact, and these differ by the settlement, 1e-4 of the height.
    #[test]
    fn holds_frequencies_of_a_wall_do_not_hang_on_order_and_turn() {
        let frequencies = |order: &[usize], yaw_rad: f64| -> Vec<f64> {
            let (sin, cos) = yaw_rad.sin_cos();
            let blocks = order.iter().map(|&stone| {
                // three courses, the second with half stones at its ends: no stone tilts
                let x = [-0.6, 0.0, 0.6, -0.75, -0.3, 0.3, 0.75, -0.6, 0.0, 0.6][stone];
                let length = if matches!(stone, 3 | 6) { 0.3 } else { 0.6 };
                let z = [0.0, 0.0, 0.0, 0.3, 0.3, 0.3, 0.3, 0.6, 0.6, 0.6][stone];
                Block {
                    name: format!("stone {stone}"),
                    solid: Solid::cuboid(length, 0.25, 0.3).unwrap().placed(&Placement {
                        position_m: [x * cos, x * sin, z],
                        yaw_rad,
                        ..Placement::default()
                    }),
                    density_kg_m3: 2600.0,
                }
            });
            let stack = Stack::new(blocks.collect(), JointMaterial::default(), 9.81).unwrap();
            let modes = stack_modes(&stack, ContactRule::Four).unwrap();
            modes[..12].iter().map(|mode| mode.frequency_hz).collect()
        };
        let known = frequencies(&[0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 0.0);
        for (order, yaw_rad) in [
            ([7, 3, 5, 0, 9, 6, 2, 1, 8, 4], 0.0),
            ([4, 6, 8, 1, 0, 7, 9, 5, 3, 2], 0.0),
            ([0, 1, 2, 3, 4, 5, 6, 7, 8, 9], 0.6),
            ([2, 9, 0, 7, 3, 6, 1, 8, 4, 5], 2.1),
        ] {
            for (found, known) in frequencies(&order, yaw_rad).iter().zip(&known) {
                assert!(
                    (found / known - 1.0).abs() < 1e-4,
                    "{order:?} {yaw_rad}: {found} {known}"
                );
            }
        }
    }
}
