//! Two posts and a lintel.

use super::dimension::{all_positive, refused};
use super::{Block, Placement, Solid, StackError};

/// Factors of a trilithon.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TrilithonFactors {
    /// Clear span between the posts, along x, m.
    pub span_m: f64,
    /// Width of a post, along x, m.
    pub post_width_m: f64,
    /// Height of the posts, m.
    pub post_height_m: f64,
    /// Depth of posts and lintel, along y, m.
    pub depth_m: f64,
    /// Height of the lintel, m.
    pub lintel_height_m: f64,
    /// Overhang of the lintel beyond the outer faces of the posts, m; negative if it ends on the posts.
    pub overhang_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// "post 1" on the left, "post 2" and "lintel"; the middle of the span is at x = 0.
///
/// ```text
/// sways along x at a/g = b / h: both posts turn about their feet, and carry the lintel, level, on the corners that rise
/// ```
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{TrilithonFactors, trilithon};
/// let made = trilithon(&TrilithonFactors {
///     span_m: 1.2, post_width_m: 0.8, post_height_m: 3.0, depth_m: 0.8, lintel_height_m: 0.7, overhang_m: 0.1, density_kg_m3: 2600.0,
/// })?;
/// assert_eq!(made[2].solid.bounds_m(), [[-1.5, -0.4, 3.0], [1.5, 0.4, 3.7]]);
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn trilithon(factors: &TrilithonFactors) -> Result<Vec<Block>, StackError> {
    check(factors)?;
    let (span, width, depth) = (factors.span_m, factors.post_width_m, factors.depth_m);
    let block = |name: &str, solid: Solid, position_m: [f64; 3]| Block {
        name: name.to_owned(),
        solid: solid.placed(&Placement {
            position_m,
            ..Placement::default()
        }),
        density_kg_m3: factors.density_kg_m3,
    };
    let post = |name: &str, side: f64| -> Result<Block, StackError> {
        let solid = Solid::cuboid(width, depth, factors.post_height_m)?;
        Ok(block(name, solid, [side * 0.5 * (span + width), 0.0, 0.0]))
    };
    let length = span + 2.0 * (width + factors.overhang_m);
    let lintel = Solid::cuboid(length, depth, factors.lintel_height_m)?;
    Ok(vec![
        post("post 1", -1.0)?,
        post("post 2", 1.0)?,
        block("lintel", lintel, [0.0, 0.0, factors.post_height_m]),
    ])
}

fn check(factors: &TrilithonFactors) -> Result<(), StackError> {
    all_positive(&[
        ("span_m", factors.span_m),
        ("post_width_m", factors.post_width_m),
        ("post_height_m", factors.post_height_m),
        ("depth_m", factors.depth_m),
        ("lintel_height_m", factors.lintel_height_m),
        ("density_kg_m3", factors.density_kg_m3),
    ])?;
    let overhang = factors.overhang_m;
    if !(overhang > -0.9 * factors.post_width_m && overhang < factors.span_m + factors.post_width_m) {
        let allowed = "more than -0.9 post_width, so that the lintel reaches the posts, and less than span + post_width";
        return Err(refused("overhang_m", overhang, allowed));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Stack};
    use super::*;

    const USUAL: TrilithonFactors = TrilithonFactors {
        span_m: 1.2,
        post_width_m: 0.8,
        post_height_m: 3.0,
        depth_m: 0.8,
        lintel_height_m: 0.7,
        overhang_m: 0.1,
        density_kg_m3: 2600.0,
    };

    #[test]
    fn exact_the_lintel_lies_on_both_posts() {
        for (overhang_m, on_each_m) in [(0.1, 0.8), (0.0, 0.8), (-0.2, 0.6)] {
            let made = trilithon(&TrilithonFactors { overhang_m, ..USUAL }).unwrap();
            let stack = Stack::new(made, JointMaterial::default(), 9.81).unwrap();
            let areas: Vec<f64> = stack
                .joints()
                .iter()
                .map(|joint| joint.patch.moments().area_m2)
                .collect();
            assert_eq!(areas.len(), 4);
            assert!(
                areas[2..]
                    .iter()
                    .all(|area| (area - on_each_m * 0.8).abs() < 1e-12),
                "{areas:?}"
            );
        }
    }

    #[test]
    fn refuses_a_lintel_that_misses_its_posts_and_sizes_of_nothing() {
        for overhang_m in [-0.8, 2.1, f64::NAN] {
            let fault = trilithon(&TrilithonFactors { overhang_m, ..USUAL })
                .unwrap_err()
                .to_string();
            assert!(fault.contains("overhang_m"), "{fault}");
        }
        let fault = trilithon(&TrilithonFactors { span_m: 0.0, ..USUAL })
            .unwrap_err()
            .to_string();
        assert!(fault.contains("span_m"), "{fault}");
    }
}
