//! Towers of courses, square or round, solid or hollow.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | b_k | `width` | width of course k: b₀ + (b_n − b₀) k / (n − 1) | m |
//! | t | `thickness_m` | thickness of the wall of a hollow tower | m |
//! | m | `stones` | number of stones in a ring of a round hollow tower | – |

use super::dimension::{all_positive, refused};
use super::{Block, Placement, Solid, StackError};
use std::f64::consts::TAU;

/// Largest number of stones. Our choice, as for walls: a check then takes several seconds.
const STONES_MOST: u32 = 600;
/// Largest number of courses. Our choice.
const COURSES_MOST: u32 = 200;

/// Plan of a tower.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TowerPlan {
    /// A square with sides along x and y. If hollow, a course has four stones, each with one end against the next; every second course is
    /// mirrored.
    Square,
    /// A circle. If solid: drums. If hollow: rings of this number of stones with flat faces and outer corners on the circle; every second ring
    /// is rotated by half a stone.
    Round {
        /// Stones in a ring, 6 to 48.
        stones: u32,
    },
}

/// Factors of a tower.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TowerFactors {
    /// Its plan.
    pub plan: TowerPlan,
    /// Width or diameter of the lowest course, m.
    pub width_m: f64,
    /// Width of the top course, m; the courses between are set back in equal steps.
    pub top_width_m: f64,
    /// Courses, 1 to 200.
    pub courses: u32,
    /// Height of a course, m.
    pub course_height_m: f64,
    /// Thickness of the wall, m; `None`: solid, one stone in each course.
    pub thickness_m: Option<f64>,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A tower, lowest course first. Names of stones: "course 3", or "course 3 stone 2" if hollow, both from 1.
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range, a wall that leaves no cavity, a course set back beyond the wall below, or more than
/// 600 stones.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{TowerFactors, TowerPlan, tower};
/// let factors = TowerFactors {
///     plan: TowerPlan::Square, width_m: 2.0, top_width_m: 1.0, courses: 11, course_height_m: 0.5, thickness_m: None, density_kg_m3: 2600.0,
/// };
/// let made = tower(&factors)?;
/// assert_eq!((made.len(), made[5].name.as_str()), (11, "course 6"));
/// assert!((made[5].solid.volume_m3() - 1.5 * 1.5 * 0.5).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn tower(factors: &TowerFactors) -> Result<Vec<Block>, StackError> {
    check(factors)?;
    let mut blocks = Vec::new();
    for course in 0..factors.courses {
        let solids = match (factors.thickness_m, factors.plan) {
            (None, TowerPlan::Square) => {
                let width = factors.width(course);
                vec![Solid::cuboid(width, width, factors.course_height_m)?]
            }
            (None, TowerPlan::Round { .. }) => {
                vec![Solid::tapered_drum(
                    factors.width(course),
                    factors.width(course),
                    factors.course_height_m,
                )?]
            }
            (Some(thickness), TowerPlan::Square) => factors.pinwheel(course, thickness)?,
            (Some(thickness), TowerPlan::Round { stones }) => factors.ring(course, thickness, stones)?,
        };
        let is_one = solids.len() == 1;
        let lift = Placement {
            position_m: [0.0, 0.0, f64::from(course) * factors.course_height_m],
            ..Placement::default()
        };
        for (index, solid) in solids.into_iter().enumerate() {
            let name = match is_one {
                true => format!("course {}", course + 1),
                false => format!("course {} stone {}", course + 1, index + 1),
            };
            blocks.push(Block {
                name,
                solid: solid.placed(&lift),
                density_kg_m3: factors.density_kg_m3,
            });
        }
    }
    Ok(blocks)
}

impl TowerFactors {
    fn width(&self, course: u32) -> f64 {
        let up = f64::from(course) / f64::from(self.courses.max(2) - 1);
        self.width_m + (self.top_width_m - self.width_m) * up
    }

    /// Four stones around a square, each from one corner to the next stone.
    fn pinwheel(&self, course: u32, thickness: f64) -> Result<Vec<Solid>, StackError> {
        let (width, height) = (self.width(course), self.course_height_m);
        let along = 0.5 * (width - thickness);
        let mirror = if course.is_multiple_of(2) { 1.0 } else { -1.0 };
        let sides = [(0.0, -1.0), (1.0, 0.0), (0.0, 1.0), (-1.0, 0.0)];
        sides
            .into_iter()
            .map(|(x, y): (f64, f64)| {
                let (length, depth) = (width - thickness, thickness);
                let solid = match x == 0.0 {
                    true => Solid::cuboid(length, depth, height)?,
                    false => Solid::cuboid(depth, length, height)?,
                };
                // off the centre of its side by half a thickness: to the left seen from outside, and to the right in the next course
                let off = 0.5 * thickness * mirror;
                Ok(solid.placed(&Placement {
                    position_m: [x * along + y * off, y * along - x * off, 0.0],
                    ..Placement::default()
                }))
            })
            .collect()
    }

    /// Stones between radial joints, with flat faces.
    fn ring(&self, course: u32, thickness: f64, stones: u32) -> Result<Vec<Solid>, StackError> {
        let outer = 0.5 * self.width(course);
        let inner = outer - thickness;
        let turn = if course.is_multiple_of(2) { 0.0 } else { 0.5 };
        (0..stones)
            .map(|stone| {
                let ends = [0.0, 1.0].map(|end| TAU * (f64::from(stone) + turn + end) / f64::from(stones));
                let mut points = Vec::with_capacity(8);
                for z in [0.0, self.course_height_m] {
                    for (radius, angle) in [
                        (inner, ends[0]),
                        (inner, ends[1]),
                        (outer, ends[0]),
                        (outer, ends[1]),
                    ] {
                        points.push([radius * angle.cos(), radius * angle.sin(), z]);
                    }
                }
                Solid::convex(&points)
            })
            .collect()
    }

    fn stones(&self) -> u32 {
        self.courses
            * match (self.thickness_m, self.plan) {
                (None, _) => 1,
                (Some(_), TowerPlan::Square) => 4,
                (Some(_), TowerPlan::Round { stones }) => stones,
            }
    }
}

fn check(factors: &TowerFactors) -> Result<(), StackError> {
    let thickness = factors.thickness_m.map(|given| ("thickness_m", given));
    all_positive(&[
        ("width_m", factors.width_m),
        ("top_width_m", factors.top_width_m),
        ("course_height_m", factors.course_height_m),
        ("density_kg_m3", factors.density_kg_m3),
    ])?;
    all_positive(thickness.as_slice())?;
    if factors.top_width_m > factors.width_m {
        return Err(refused("top_width_m", factors.top_width_m, "at most width"));
    }
    if !(1..=COURSES_MOST).contains(&factors.courses) {
        return Err(refused("courses", f64::from(factors.courses), "1 to 200"));
    }
    if let TowerPlan::Round { stones } = factors.plan
        && !(6..=48).contains(&stones)
    {
        return Err(refused("stones", f64::from(stones), "6 to 48"));
    }
    if factors.stones() > STONES_MOST {
        return Err(refused(
            "courses",
            f64::from(factors.courses),
            "so few that the tower has at most 600 stones",
        ));
    }
    if let Some(given) = factors.thickness_m {
        if given > 0.4 * factors.top_width_m {
            return Err(refused(
                "thickness_m",
                given,
                "at most 0.4 of the width at the top: leave it out for a solid tower",
            ));
        }
        let set_back = 0.5 * (factors.width(0) - factors.width(1));
        if set_back > 0.5 * given {
            return Err(refused(
                "top_width_m",
                factors.top_width_m,
                "so wide that each course is set back by at most half the thickness of the wall",
            ));
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{Body, JointMaterial, Stack};
    use super::*;

    const USUAL: TowerFactors = TowerFactors {
        plan: TowerPlan::Square,
        width_m: 2.0,
        top_width_m: 1.6,
        courses: 9,
        course_height_m: 0.4,
        thickness_m: Some(0.4),
        density_kg_m3: 2600.0,
    };

    #[test]
    fn exact_stones_fill_the_wall_break_joint_and_close_the_ring() {
        for (plan, of_course) in [(TowerPlan::Square, 4), (TowerPlan::Round { stones: 12 }, 12)] {
            let factors = TowerFactors { plan, ..USUAL };
            let made = tower(&factors).unwrap();
            assert_eq!(made.len(), 9 * of_course);
            let volume: f64 = made.iter().map(|block| block.solid.volume_m3()).sum();
            let known: f64 = (0..9)
                .map(|course| {
                    let outer = 2.0 - 0.05 * f64::from(course);
                    let inner = outer - 0.8;
                    let of_square = match plan {
                        TowerPlan::Square => 1.0,
                        TowerPlan::Round { .. } => 12.0 / 8.0 * (TAU / 12.0).sin(),
                    };
                    of_square * (outer * outer - inner * inner) * 0.4
                })
                .sum();
            assert!((volume / known - 1.0).abs() < 1e-9, "{plan:?}: {volume} {known}");
            let stack = Stack::new(made, JointMaterial::default(), 9.81).unwrap();
            // each stone touches both neighbours in its course and lies on at least two stones, and no two of these joints are above each other
            let joints = stack.joints();
            let upright = joints.iter().filter(|joint| joint.axes[2][2].abs() < 0.1).count();
            assert_eq!(upright, 9 * of_course, "{plan:?}");
            for block in of_course..9 * of_course {
                let below = joints.iter().filter(|joint| {
                    joint.upper == block && joint.axes[2][2] > 0.9 && joint.lower != Body::Ground
                });
                assert!(below.count() >= 2, "{plan:?} {block}");
            }
        }
    }

    #[test]
    fn exact_solid_courses_are_set_back_alike() {
        for plan in [TowerPlan::Square, TowerPlan::Round { stones: 12 }] {
            let factors = TowerFactors {
                plan,
                thickness_m: None,
                ..USUAL
            };
            let made = tower(&factors).unwrap();
            let area = match plan {
                TowerPlan::Square => 1.0,
                TowerPlan::Round { .. } => TAU / 8.0,
            };
            for (course, block) in made.iter().enumerate() {
                let width = 2.0 - 0.05 * course as f64;
                let known = area * width * width * 0.4;
                assert!(
                    (block.solid.volume_m3() / known - 1.0).abs() < 1e-9,
                    "{plan:?} {course}"
                );
            }
            assert!(Stack::new(made, JointMaterial::default(), 9.81).is_ok());
        }
    }

    #[test]
    fn refuses_what_cannot_be_laid() {
        for (factors, said) in [
            (
                TowerFactors {
                    thickness_m: Some(0.7),
                    ..USUAL
                },
                "thickness_m",
            ),
            (
                TowerFactors {
                    top_width_m: 2.1,
                    ..USUAL
                },
                "top_width_m",
            ),
            (
                TowerFactors {
                    courses: 2,
                    top_width_m: 1.2,
                    ..USUAL
                },
                "set back",
            ),
            (
                TowerFactors {
                    courses: 151,
                    ..USUAL
                },
                "600 stones",
            ),
            (
                TowerFactors {
                    plan: TowerPlan::Round { stones: 5 },
                    ..USUAL
                },
                "6 to 48",
            ),
            (
                TowerFactors {
                    width_m: f64::NAN,
                    ..USUAL
                },
                "width_m",
            ),
        ] {
            let fault = tower(&factors).unwrap_err().to_string();
            assert!(fault.contains(said), "{said}: {fault}");
        }
    }
}
