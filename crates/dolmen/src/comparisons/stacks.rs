//! Two fixed stacks for the comparison of programs: square blocks of granite, each centred on the one below.

use super::ValidationError;
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

/// Granite.
const DENSITY_KG_M3: f64 = 2600.0;

/// Width and height of the blocks of P10, bottom up, m: base, body and eave alternate.
const P10_M: [[f64; 2]; 10] = [
    [2.4, 0.5],
    [2.6, 0.25],
    [1.9, 0.9],
    [2.1, 0.25],
    [1.1, 1.1],
    [1.9, 0.5],
    [1.0, 0.45],
    [1.65, 0.45],
    [0.85, 0.40],
    [1.4, 0.40],
];

/// P10: a pagoda of three storeys on two bases, 10 square blocks of 2600 kg/m³, 5.2 m high, named "block 1" from the bottom.
///
/// Made for comparisons; no real pagoda has these dimensions.
///
/// # Errors
/// [`ValidationError::Stack`] if material or gravity is out of its range.
///
/// # Example
/// ```
/// use dolmen::structure::stack::JointMaterial;
/// let stack = dolmen::comparisons::p10(JointMaterial::with_friction(0.6), 9.80665)?;
/// assert_eq!(stack.joints().len(), 10);
/// assert!((stack.height_m() - 5.2).abs() < 1e-12);
/// # Ok::<(), dolmen::comparisons::ValidationError>(())
/// ```
pub fn p10(material: JointMaterial, gravity_m_s2: f64) -> Result<Stack, ValidationError> {
    square_blocks(&P10_M, material, gravity_m_s2)
}

/// P20: a pagoda of seven storeys on two bases, 20 square blocks of 2600 kg/m³, 8.165 m high, named "block 1" from the
/// bottom. Each storey is smaller than the one below by 8.5 % of the first storey.
///
/// Made for comparisons; no real pagoda has these dimensions.
///
/// # Errors
/// [`ValidationError::Stack`] if material or gravity is out of its range.
pub fn p20(material: JointMaterial, gravity_m_s2: f64) -> Result<Stack, ValidationError> {
    let mut sizes_m = vec![[2.8, 0.45], [3.0, 0.25], [2.3, 0.9], [2.5, 0.25]];
    for storey in 0..7 {
        let f = 1.0 - 0.085 * f64::from(storey);
        let body_height = if storey == 0 { 1.0 } else { 0.5 * f };
        sizes_m.extend([[1.25 * f, body_height], [2.1 * f, 0.5 * f]]);
    }
    sizes_m.extend([[0.5, 0.3], [0.4, 0.3]]);
    square_blocks(&sizes_m, material, gravity_m_s2)
}

fn square_blocks(
    sizes_m: &[[f64; 2]],
    material: JointMaterial,
    gravity_m_s2: f64,
) -> Result<Stack, ValidationError> {
    let mut blocks = Vec::with_capacity(sizes_m.len());
    let mut z = 0.0;
    for (i, &[width_m, height_m]) in sizes_m.iter().enumerate() {
        let place = Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        blocks.push(Block {
            name: format!("block {}", i + 1),
            solid: Solid::cuboid(width_m, width_m, height_m)?.placed(&place),
            density_kg_m3: DENSITY_KG_M3,
        });
        z += height_m;
    }
    Ok(Stack::new(blocks, material, gravity_m_s2)?)
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Smallest ratio of half width of the contact to height of the centroid above it, over the joints.
    fn least_slenderness(stack: &Stack) -> f64 {
        let blocks = stack.blocks();
        let threshold = |joint: usize| {
            let above = &blocks[joint..];
            let mass: f64 = above.iter().map(Block::mass_kg).sum();
            let moment: f64 = above.iter().map(|b| b.mass_kg() * b.solid.centroid_m()[2]).sum();
            let width = |i: usize| blocks[i].solid.bounds_m()[1][0];
            let half = if joint == 0 {
                width(0)
            } else {
                width(joint).min(width(joint - 1))
            };
            half / (moment / mass - blocks[joint].solid.bounds_m()[0][2])
        };
        (0..blocks.len()).map(threshold).fold(f64::INFINITY, f64::min)
    }

    #[test]
    fn published_static_threshold_of_p10() {
        let stack = p10(JointMaterial::with_friction(0.6), 9.80665).unwrap();
        assert!((least_slenderness(&stack) - 0.324).abs() < 5e-4);
        assert!(
            stack
                .joints()
                .iter()
                .all(|joint| joint.axes[2] == [0.0, 0.0, 1.0])
        );
    }

    #[test]
    fn exact_height_and_names_of_p20() {
        let stack = p20(JointMaterial::default(), 9.80665).unwrap();
        assert!((stack.height_m() - 8.165).abs() < 1e-12);
        assert_eq!((stack.blocks().len(), stack.joints().len()), (20, 20));
        assert_eq!(stack.blocks()[19].name, "block 20");
        // third storey: f = 0.83, body 1.0375 m wide
        assert!((stack.blocks()[8].solid.bounds_m()[1][0] - 0.51875).abs() < 1e-12);
    }
}
