//! Why a stack cannot be built.

use super::part::StackPart;
use crate::quantity::Quantity;
use dolmen::structure::stack::StackError;

/// Why a stack cannot be built, and where in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum StackFault {
    /// A stone, or its position.
    Part {
        /// Path in the file: `blocks[2]`.
        path: String,
        /// The error of the library.
        why: Box<StackError>,
    },
    /// One block stands on another by the file, but the two do not touch.
    Apart {
        /// Path in the file: `blocks[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// The block below.
        lower: String,
        /// The allowed distance, m.
        allowed_m: f64,
    },
    /// The stones are loose: until they have settled, there are no joints.
    Loose,
    /// One joint is given twice.
    Twice {
        /// Path in the file: `contacts[2]`.
        path: String,
        /// The upper block.
        upper: String,
        /// The block below.
        lower: String,
        /// The contact that gave it first, from 1.
        first: usize,
    },
}

impl StackFault {
    pub(super) fn part(path: String, why: StackError) -> Self {
        let why = Box::new(why);
        StackFault::Part { path, why }
    }

    /// Where in the file.
    pub fn path(&self) -> &str {
        match self {
            StackFault::Part { path, .. }
            | StackFault::Apart { path, .. }
            | StackFault::Twice { path, .. } => path,
            StackFault::Loose => "loose",
        }
    }
}

impl StackPart {
    /// The tilt of a block that overlaps another or the ground.
    pub(crate) fn tilt_that_overlaps(&self, why: &StackFault) -> Option<&Quantity> {
        let StackFault::Part { why, .. } = why else {
            return None;
        };
        let StackError::Overlap { first, second, .. } = why.as_ref() else {
            return None;
        };
        let mut both = self
            .blocks
            .iter()
            .filter(|block| [first, second].contains(&&block.name));
        both.find_map(|block| block.tilt.iter().flatten().find(|tilt| tilt.value != 0.0))
    }
}
