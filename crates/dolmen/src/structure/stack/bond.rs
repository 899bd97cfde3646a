//! Bond of courses or rings.

/// How the stones of one course, or ring, lie on those of the course below.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Bond {
    /// Every second course is shifted by half a stone.
    Running,
    /// Joints above each other: straight joints run through all courses.
    Straight,
}

impl Bond {
    /// Shift of a course, in stones.
    pub(super) fn shift(self, course: u32) -> f64 {
        match self {
            Bond::Running if !course.is_multiple_of(2) => 0.5,
            Bond::Running | Bond::Straight => 0.0,
        }
    }
}
