//! Walls of squared stones in running bond, of one leaf or several, with openings.

use super::dimension::{all_positive, refused};
use super::{Block, Placement, Solid, StackError};

/// Largest number of stones. Our choice: a check then takes several seconds.
const STONES_MOST: f64 = 600.0;
/// A stone shorter than this fraction of a whole one is joined to its neighbour. Our choice: masons do not lay slivers.
const SLIVER: f64 = 0.25;
/// Least width of the core between leaves, m: if faces are nearer than half of it they may touch, and friction between them is not reliable. Our
/// choice.
const CORE_LEAST_M: f64 = 0.01;
/// Length of zero with rounding, relative to a stone.
const NOTHING: f64 = 1e-9;

/// Factors of a wall.
#[derive(Clone, Debug, PartialEq)]
pub struct WallFactors {
    /// Length, along x, m.
    pub length_m: f64,
    /// Thickness of all leaves together, along y, m.
    pub thickness_m: f64,
    /// Courses, 1 to 100.
    pub courses: u32,
    /// Height of a course, m.
    pub course_height_m: f64,
    /// Length of a whole stone, m.
    pub stone_length_m: f64,
    /// Number of parallel leaves, 1 to 3, of equal thickness; only through stones and lintels connect them.
    pub leaves: u32,
    /// Width of the core between two leaves, m; its filling is left out. No effect with one leaf.
    pub core_m: f64,
    /// Every n-th course consists of through stones, as thick as the wall; `None` for none.
    pub through_every: Option<u32>,
    /// Doors and windows.
    pub openings: Vec<WallOpening>,
    /// Density, kg/m³.
    pub density_kg_m3: f64,
}

/// A door or window through all leaves, below a lintel of one course if there is a course above.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct WallOpening {
    /// Distance from the left end of the wall to the left side of the opening, m.
    pub from_m: f64,
    /// Width, m.
    pub width_m: f64,
    /// Lowest course of the opening, from 1.
    pub first_course: u32,
    /// Number of courses.
    pub courses: u32,
    /// Bearing of the lintel on either side, m.
    pub bearing_m: f64,
}

impl WallOpening {
    /// The part of a course, counted from 0, that the opening or its lintel occupies.
    fn takes(&self, course: u32) -> Option<CourseSpan> {
        let above = self.first_course - 1 + self.courses;
        let [from, to] = [self.from_m, self.from_m + self.width_m];
        if (self.first_course - 1..above).contains(&course) {
            return Some(CourseSpan {
                from,
                to,
                is_lintel: false,
            });
        }
        (course == above).then_some(CourseSpan {
            from: from - self.bearing_m,
            to: to + self.bearing_m,
            is_lintel: true,
        })
    }
}

/// A part of a course without its own stones, from the left end of the wall, m.
#[derive(Clone, Copy)]
struct CourseSpan {
    from: f64,
    to: f64,
    is_lintel: bool,
}

/// A wall in running bond, lowest course first. Every second course begins with half a stone, as does every second leaf.
///
/// Names are "course 2 stone 3", both from 1, stones from the left. With several leaves they are "course 2 leaf 1 stone 3" and "course 3 through
/// stone 2", where the first leaf has the smallest y. "lintel 1" belongs to the first opening. The remainder at an end or beside an opening is one
/// shorter stone, or lengthens the last one if it is less than a quarter.
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range, an opening outside the wall or with a lintel without bearing, openings that touch, or
/// more than 600 stones.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{WallFactors, wall};
/// let made = wall(&WallFactors {
///     length_m: 2.0, thickness_m: 0.4, courses: 2, course_height_m: 0.25, stone_length_m: 0.5, leaves: 1, through_every: None,
///     core_m: 0.0,
///     openings: vec![], density_kg_m3: 2600.0,
/// })?;
/// assert_eq!(made.len(), 4 + 5);
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
pub fn wall(factors: &WallFactors) -> Result<Vec<Block>, StackError> {
    check(factors)?;
    let mut blocks = Vec::new();
    for course in 0..factors.courses {
        let taken = taken(factors, course)?;
        let goes_through = factors
            .through_every
            .is_some_and(|every| (course + 1).is_multiple_of(every));
        let leaves = if goes_through { 1 } else { factors.leaves };
        for leaf in 0..leaves {
            let stones = stones(factors, (course + leaf) % 2 == 1, &taken);
            for (index, ends) in stones.into_iter().enumerate() {
                let stone = index + 1;
                let name = match (factors.leaves, goes_through) {
                    (1, _) => format!("course {} stone {stone}", course + 1),
                    (_, true) => format!("course {} through stone {stone}", course + 1),
                    (_, false) => format!("course {} leaf {} stone {stone}", course + 1, leaf + 1),
                };
                blocks.push(stone_at(factors, name, ends, [course, leaf, leaves])?);
            }
        }
        for (number, opening) in factors.openings.iter().enumerate() {
            if let Some(lintel) = opening.takes(course).filter(|taken| taken.is_lintel) {
                let name = format!("lintel {}", number + 1);
                blocks.push(stone_at(factors, name, [lintel.from, lintel.to], [course, 0, 1])?);
            }
        }
    }
    if blocks.len() as f64 > STONES_MOST {
        return Err(too_many(factors));
    }
    Ok(blocks)
}

/// A stone between two ends, in its course and leaf; `leaves` is the number of leaves.
fn stone_at(
    factors: &WallFactors,
    name: String,
    [start, end]: [f64; 2],
    [course, leaf, leaves]: [u32; 3],
) -> Result<Block, StackError> {
    let gaps = f64::from(leaves - 1);
    let thickness_m = (factors.thickness_m - gaps * factors.core_m) / f64::from(leaves);
    let place = Placement {
        position_m: [
            0.5 * (start + end - factors.length_m),
            f64::from(leaf) * (thickness_m + factors.core_m) + 0.5 * (thickness_m - factors.thickness_m),
            f64::from(course) * factors.course_height_m,
        ],
        ..Placement::default()
    };
    let solid = Solid::cuboid(end - start, thickness_m, factors.course_height_m)?;
    Ok(Block {
        name,
        solid: solid.placed(&place),
        density_kg_m3: factors.density_kg_m3,
    })
}

/// Spans of a course that openings and lintels occupy, from the left.
fn taken(factors: &WallFactors, course: u32) -> Result<Vec<CourseSpan>, StackError> {
    let mut all: Vec<CourseSpan> = factors
        .openings
        .iter()
        .filter_map(|of| of.takes(course))
        .collect();
    all.sort_by(|a, b| a.from.total_cmp(&b.from));
    match all.windows(2).find(|pair| pair[1].from < pair[0].to) {
        Some(pair) => Err(refused(
            "openings",
            pair[1].from,
            "apart, with their lintels, in every course",
        )),
        None => Ok(all),
    }
}

/// Ends of the stones of a course outside the spans of openings and lintels.
fn stones(factors: &WallFactors, half_first: bool, taken: &[CourseSpan]) -> Vec<[f64; 2]> {
    let (length, stone) = (factors.length_m, factors.stone_length_m);
    let first = if half_first { 0.5 * stone } else { stone };
    let mut stones = Vec::new();
    let mut from = 0.0;
    let ends = taken.iter().map(|of| [of.from, of.to]).chain([[length, length]]);
    for [to, next] in ends {
        if to - from > NOTHING * stone {
            let joints = (0..).map(|number| first + f64::from(number) * stone);
            let within = joints
                .skip_while(|joint| *joint < from + SLIVER * stone)
                .take_while(|joint| *joint < to - SLIVER * stone);
            let mut start = from;
            for joint in within {
                stones.push([start, joint]);
                start = joint;
            }
            stones.push([start, to]);
        }
        from = next;
    }
    stones
}

fn too_many(factors: &WallFactors) -> StackError {
    let allowed = "long enough for at most 600 stones in the wall";
    refused("stone_length_m", factors.stone_length_m, allowed)
}

fn check(factors: &WallFactors) -> Result<(), StackError> {
    all_positive(&[
        ("length_m", factors.length_m),
        ("thickness_m", factors.thickness_m),
        ("course_height_m", factors.course_height_m),
        ("stone_length_m", factors.stone_length_m),
        ("density_kg_m3", factors.density_kg_m3),
    ])?;
    if !(1..=100).contains(&factors.courses) {
        return Err(refused("courses", f64::from(factors.courses), "1 to 100"));
    }
    if !(1..=3).contains(&factors.leaves) {
        return Err(refused("leaves", f64::from(factors.leaves), "1 to 3"));
    }
    if factors.leaves > 1 {
        let [least, most] = [
            CORE_LEAST_M,
            0.5 * factors.thickness_m / f64::from(factors.leaves - 1),
        ];
        if !(least..=most).contains(&factors.core_m) {
            let allowed =
                "0.01 m, so that the leaves do not bear on each other, to half the thickness of the wall";
            return Err(refused("core_m", factors.core_m, allowed));
        }
    }
    if factors.through_every == Some(0) {
        return Err(refused("through_every", 0.0, "1 or more"));
    }
    for opening in &factors.openings {
        check_opening(factors, opening)?;
    }
    let stones = f64::from(factors.courses) * (factors.length_m / factors.stone_length_m - 1.0);
    if stones > STONES_MOST {
        return Err(too_many(factors));
    }
    Ok(())
}

fn check_opening(factors: &WallFactors, opening: &WallOpening) -> Result<(), StackError> {
    all_positive(&[
        ("openings.width_m", opening.width_m),
        ("openings.bearing_m", opening.bearing_m),
    ])?;
    let above = opening
        .first_course
        .saturating_add(opening.courses)
        .saturating_sub(1);
    if opening.first_course == 0 || opening.courses == 0 || above > factors.courses {
        let allowed = "within the courses of the wall";
        return Err(refused("openings.courses", f64::from(opening.courses), allowed));
    }
    let [low, high] = [
        opening.from_m - opening.bearing_m,
        opening.from_m + opening.width_m + opening.bearing_m,
    ];
    let slack = NOTHING * factors.stone_length_m;
    if !(low >= -slack && high <= factors.length_m + slack) {
        let allowed = "so far from both ends of the wall that its lintel has its bearing";
        return Err(refused("openings.from_m", opening.from_m, allowed));
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Stack};
    use super::*;

    fn usual() -> WallFactors {
        WallFactors {
            length_m: 2.0,
            thickness_m: 0.4,
            courses: 4,
            course_height_m: 0.25,
            stone_length_m: 0.5,
            leaves: 1,
            core_m: 0.04,
            through_every: None,
            openings: vec![],
            density_kg_m3: 2600.0,
        }
    }

    fn volume_m3(blocks: &[Block]) -> f64 {
        blocks.iter().map(|block| block.solid.volume_m3()).sum()
    }

    #[test]
    fn exact_stones_fill_the_wall_and_break_joint() {
        for (length_m, stone_length_m) in [(2.0, 0.5), (2.2, 0.5), (2.05, 0.5), (0.3, 0.5)] {
            let factors = WallFactors {
                length_m,
                stone_length_m,
                ..usual()
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
            courses: 20,
            ..usual()
        };
        let fault = wall(&factors).unwrap_err().to_string();
        assert!(fault.contains("600 stones"), "{fault}");
    }

    #[test]
    fn exact_leaves_and_openings_leave_nothing_out() {
        let opening = WallOpening {
            from_m: 1.3,
            width_m: 0.9,
            first_course: 1,
            courses: 2,
            bearing_m: 0.2,
        };
        for (leaves, through_every) in [(1, None), (2, None), (2, Some(3)), (3, Some(2)), (3, Some(1))] {
            let factors = WallFactors {
                length_m: 4.0,
                courses: 5,
                leaves,
                through_every,
                openings: vec![opening],
                ..usual()
            };
            let blocks = wall(&factors).unwrap();
            let lintel = blocks.iter().find(|block| block.name == "lintel 1").unwrap();
            let [low, high] = lintel.solid.bounds_m();
            for (found, known) in low.into_iter().chain(high).zip([-0.9, -0.2, 0.5, 0.4, 0.2, 0.75]) {
                assert!((found - known).abs() < 1e-12, "{low:?} {high:?}");
            }
            let whole = 0.4 * (4.0 * 1.25 - 0.9 * 0.5);
            // the core in the courses without through stones, except for the lintel in the third course
            let goes_through = |course: u32| through_every.is_some_and(|every| course.is_multiple_of(every));
            let cored = (1..=5)
                .filter(|&course| !goes_through(course))
                .map(|course| match course {
                    1 | 2 => 4.0 - 0.9,
                    3 => 4.0 - 1.3,
                    _ => 4.0,
                });
            let core = 0.04 * f64::from(leaves - 1) * 0.25 * cored.sum::<f64>();
            assert!((volume_m3(&blocks) - whole + core).abs() < 1e-12);
            let stack = Stack::new(blocks, JointMaterial::default(), 9.81).unwrap();
            assert!((stack.height_m() - 1.25).abs() < 1e-12);
        }
    }

    #[test]
    fn refuses_leaves_that_bear_on_each_other() {
        for core_m in [0.0, 0.005, 0.21, f64::NAN] {
            let fault = wall(&WallFactors {
                leaves: 2,
                core_m,
                ..usual()
            })
            .unwrap_err();
            assert!(fault.to_string().contains("core_m"), "{fault}");
        }
    }

    #[test]
    fn refuses_openings_that_leave_the_wall_or_meet() {
        let opening = |from_m: f64, first_course: u32, courses: u32| WallOpening {
            from_m,
            width_m: 0.5,
            first_course,
            courses,
            bearing_m: 0.2,
        };
        let said = |openings: Vec<WallOpening>| {
            let made = wall(&WallFactors { openings, ..usual() });
            made.err().map(|why| why.to_string()).unwrap_or_default()
        };
        assert!(said(vec![opening(0.1, 1, 2)]).contains("lintel has its bearing"));
        assert!(said(vec![opening(1.4, 1, 2)]).contains("lintel has its bearing"));
        assert!(said(vec![opening(0.5, 3, 3)]).contains("within the courses"));
        assert!(said(vec![opening(0.5, 0, 1)]).contains("within the courses"));
        assert!(said(vec![opening(0.2, 1, 2), opening(1.0, 2, 1)]).contains("apart"));
        assert_eq!(said(vec![opening(0.2, 1, 1), opening(1.2, 1, 1)]), "");
        // an opening up to the top of the wall needs no lintel
        assert_eq!(said(vec![opening(0.5, 3, 2)]), "");
    }
}
