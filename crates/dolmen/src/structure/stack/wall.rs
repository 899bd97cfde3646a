//! Walls of squared stones in running bond.

use super::{Block, Placement, Solid, StackError};

/// Most stones. Chosen here: a check of so many takes some seconds.
const STONES_MOST: f64 = 600.0;
/// A last stone shorter than this part of a stone joins the one before it. Chosen here: masons do not lay slivers.
const SLIVER: f64 = 0.25;

/// What makes a wall.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallFactors {
    /// Length, along x, m.
    pub length_m: f64,
    /// Thickness, along y, m: one stone.
    pub thickness_m: f64,
    /// Courses, 1 to 100.
    pub courses: u32,
    /// Height of a course, m.
    pub course_height_m: f64,
    /// Length of a whole stone, m.
    pub stone_length_m: f64,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A wall in running bond, lowest course first: every second course begins with half a stone.
///
/// Names are "course 2 stone 3", both from 1, stones from the left. What is left at the right end is one shorter stone, or makes
/// the last one longer where it is less than a quarter.
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range, or more than 600 stones.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{WallFactors, wall};
/// let made = wall(&WallFactors {
///     length_m: 2.0, thickness_m: 0.4, courses: 2, course_height_m: 0.25, stone_length_m: 0.5, density_kg_m3: 2600.0,
/// })?;
/// assert_eq!(made.len(), 4 + 5);
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn wall(factors: &WallFactors) -> Result<Vec<Block>, StackError> {
    check(factors)?;
    let mut blocks = Vec::new();
    for course in 0..factors.courses {
        let ends = ends(factors, course % 2 == 1);
        for (index, pair) in ends.windows(2).enumerate() {
            let [start, end] = [pair[0], pair[1]];
            let place = Placement {
                position_m: [
                    0.5 * (start + end - factors.length_m),
                    0.0,
                    f64::from(course) * factors.course_height_m,
                ],
                ..Placement::default()
            };
            let solid = Solid::cuboid(end - start, factors.thickness_m, factors.course_height_m)?;
            blocks.push(Block {
                name: format!("course {} stone {}", course + 1, index + 1),
                solid: solid.placed(&place),
                density_kg_m3: factors.density_kg_m3,
            });
        }
    }
    Ok(blocks)
}

/// Where the stones of a course begin and end, from its left end.
fn ends(factors: &WallFactors, half_first: bool) -> Vec<f64> {
    let (length, stone) = (factors.length_m, factors.stone_length_m);
    let first = if half_first { 0.5 * stone } else { stone };
    let mut ends = vec![0.0];
    let mut next = first;
    while next < length - SLIVER * stone {
        ends.push(next);
        next = first + ends.len() as f64 * stone - stone;
    }
    ends.push(length);
    ends
}

fn check(factors: &WallFactors) -> Result<(), StackError> {
    let refuse = |quantity, given, allowed| {
        Err(StackError::Dimension {
            quantity,
            given,
            allowed,
        })
    };
    for (quantity, given) in [
        ("length_m", factors.length_m),
        ("thickness_m", factors.thickness_m),
        ("course_height_m", factors.course_height_m),
        ("stone_length_m", factors.stone_length_m),
        ("density_kg_m3", factors.density_kg_m3),
    ] {
        if !(given > 0.0 && given.is_finite()) {
            return refuse(quantity, given, "a positive number");
        }
    }
    if !(1..=100).contains(&factors.courses) {
        return refuse("courses", f64::from(factors.courses), "1 to 100");
    }
    let stones = f64::from(factors.courses) * (factors.length_m / factors.stone_length_m + 1.0);
    if stones > STONES_MOST {
        let allowed = "long enough for at most 600 stones in the wall";
        return refuse("stone_length_m", factors.stone_length_m, allowed);
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Stack};
    use super::*;

    #[test]
    fn exact_stones_fill_the_wall_and_break_joint() {
        for (length_m, stone_length_m) in [(2.0, 0.5), (2.2, 0.5), (2.05, 0.5), (0.3, 0.5)] {
            let factors = WallFactors {
                length_m,
                thickness_m: 0.4,
                courses: 4,
                course_height_m: 0.25,
                stone_length_m,
                density_kg_m3: 2600.0,
            };
            let blocks = wall(&factors).unwrap();
            let volume: f64 = blocks.iter().map(|block| block.solid.volume_m3()).sum();
            assert!((volume - length_m * 0.4).abs() < 1e-12, "{length_m}: {volume}");
            let least = blocks.iter().map(|block| {
                let [low, high] = block.solid.bounds_m();
                high[0] - low[0]
            });
            assert!(
                least.fold(f64::INFINITY, f64::min) > 0.25 * stone_length_m - 1e-9,
                "{length_m}"
            );
            let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
            assert!((stack.height_m() - 1.0).abs() < 1e-12);
        }
    }

    #[test]
    fn refuses_a_wall_of_too_many_stones() {
        let factors = WallFactors {
            length_m: 100.0,
            thickness_m: 0.4,
            courses: 20,
            course_height_m: 0.25,
            stone_length_m: 0.5,
            density_kg_m3: 2600.0,
        };
        let fault = wall(&factors).unwrap_err().to_string();
        assert!(fault.contains("600 stones"), "{fault}");
    }
}
